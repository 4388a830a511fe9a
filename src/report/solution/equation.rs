//! A computed value as a chain of expressions, before any format.

use super::Task;
use crate::log::formula;
use crate::log::formula::Operator;
use crate::log::{Name, Value, What};
use crate::report::expression::{self, Expression};
use crate::report::{computation, provenance};

/// `symbol = formula = numbers put in = result`.
pub(super) struct Equation {
    pub name: Name,
    pub formula: Option<Expression>,
    pub substituted: Option<Expression>,
    pub result: Value,
}

impl Equation {
    /// The computation of the value that an event notes.
    pub(super) fn of(task: &Task, event: usize) -> Option<Equation> {
        let What::Note { name, value } = task.log.events[event].what else { return None };
        let parsed = formula::of(name);
        let formula = parsed.filter(|_| computation::formula_of(name).is_some()).map(Expression::symbolic);
        let links = provenance::operands(task.log, task.tree, event);
        let substituted = parsed
            .and_then(|formula| expression::substituted(task.log, task.tree, event, formula, task.style, &links))
            // A value that is only passed on is shown once.
            .filter(|put_in| !matches!(put_in, Expression::Value(same, _) if same.same_bits(&value)))
            .filter(|put_in| !matches!(put_in, Expression::Number(x) if value == Value::Number(*x)));
        Some(Equation { name, formula, substituted, result: value })
    }
}

/// The terms of a sum, with the sign before each but the first.
pub(super) fn terms(expression: &Expression) -> Vec<(Option<Operator>, &Expression)> {
    match expression {
        Expression::Binary(operator @ (Operator::Plus | Operator::Minus), left, right) => {
            let mut terms = terms(left);
            let mut last = if *operator == Operator::Plus { self::terms(right) } else { vec![(None, &**right)] };
            last[0].0 = Some(*operator);
            terms.append(&mut last);
            terms
        }
        other => vec![(None, other)],
    }
}
