//! Formulas in HTML, their values linked with the steps that computed them.

use super::super::Task;
use super::super::equation::Equation;
use crate::log::Value;
use crate::log::formula::{Formula, Operator, Unary};
use crate::report::decided::Relation;
use crate::report::expression::{Expression, Leaf};
use crate::report::notation::{self, Notation, Numbers, written};
use crate::report::tag::tag;
use crate::report::{Style, digits, escape};

/// The equation of an event: where links to its value lead.
pub(super) fn equation(task: &Task, event: usize) -> Option<String> {
    let equation = Equation::of(task, event)?;
    let middle = [equation.formula.as_ref(), equation.substituted.as_ref()];
    let part = |part: &Expression| format!("<span>= {}</span>", written::<Formulas>(task.numbers(), part));
    let tag = tag(task.log, task.tree, event).map(|tag| (task.language.texts().solution.section)(&tag));
    let tag = tag.map_or_else(String::new, |tag| format!(" ({tag})"));
    let title = escape::xml(&format!("{}{tag}", equation.name.key()));
    let marker = escape::xml(&digits::marker(task.language, task.log, task.tree, event));
    Some(format!(
        "<p class=\"eq\" id=\"e{event}\"><span title=\"{title}\">{}</span>{}<span>= <b>{}</b>{marker}</span></p>",
        symbol(equation.name.symbol()),
        middle.into_iter().flatten().map(part).collect::<String>(),
        Formulas::value(task.numbers(), &equation.result)
    ))
}

/// Formulas as elements of a page.
pub(super) struct Formulas;

impl Notation for Formulas {
    /// Lines don't break it, and its minus sign is that of formulas.
    fn value(numbers: Numbers, value: &Value) -> String {
        let text = escape::xml(&numbers.value(value).replace('-', "−"));
        match value {
            Value::Number(_) => text,
            Value::Triple(_) => format!("<span class=\"n\">{text}</span>"),
        }
    }

    fn symbol(symbol: &str) -> String {
        self::symbol(symbol)
    }

    fn linked(text: String, event: Option<usize>) -> String {
        match event {
            Some(event) => format!("<a href=\"#e{event}\">{text}</a>"),
            None => text,
        }
    }

    fn base(style: Style, expression: &Expression, text: String) -> String {
        let is_product = matches!(expression, Formula::Leaf(Leaf::Symbol(name)) if name.contains(['·', '−']));
        let is_one = !is_product && !expression.has_power_of_ten(style) && !expression.begins_negative();
        if is_one { text } else { Self::grouped(&text) }
    }

    fn unary(unary: Unary, inner: &str) -> String {
        match unary {
            Unary::Negated => format!("−{inner}"),
            Unary::Root => format!("√<span class=\"root\">{inner}</span>"),
            Unary::Squared => format!("{inner}<sup>2</sup>"),
            Unary::Positive => format!("{inner}<sup>+</sup>"),
            Unary::Degrees => format!("{inner}°"),
            Unary::Length => format!("|{inner}|"),
            Unary::Floor => format!("⌊{inner}⌋"),
            Unary::OverLights => format!("Σ<sub>i</sub> ({inner})"),
            Unary::Over(several) => format!("{} ({inner})", symbol(several.word())),
            Unary::Grouped | Unary::Function(_) | Unary::ExtremeComponent(_) => Self::grouped(inner),
        }
    }

    fn binary(operator: Operator, left: &str, right: &str) -> String {
        match operator {
            Operator::Over => format!(
                "<span class=\"frac\"><span>{left}</span><span class=\"over\">/</span><span>{right}</span></span>"
            ),
            Operator::Power => format!("{left}<sup>{right}</sup>"),
            _ => format!("{left} {} {right}", notation::infix(operator)),
        }
    }

    fn relation(relation: Relation) -> String {
        escape::xml(relation.sign())
    }
}

/// A symbol such as `T2_A`, `|D|`, `cosφ_1`.
fn symbol(name: &str) -> String {
    if let Some(inner) = name.strip_prefix('|').and_then(|rest| rest.strip_suffix('|')) {
        return format!("|{}|", symbol(inner));
    }
    if let Some((left, right)) = name.split_once('·') {
        return format!("{} · {}", symbol(left), symbol(right));
    }
    // The source text has L_2oc and T_2A.
    if let Some((first, rest)) = name.split_at_checked(1).filter(|(_, rest)| rest.starts_with('2')) {
        return format!("<i>{first}</i><sub>{}</sub>", escape::xml(&rest.replace('_', "")));
    }
    match name.split_once('_') {
        Some((name, index)) => format!("<i>{}</i><sub>{}</sub>", escape::xml(name), escape::xml(index)),
        None => format!("<i>{}</i>", escape::xml(name)),
    }
}
