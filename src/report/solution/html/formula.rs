//! Formulas in HTML, their values linked with the steps that computed them.

use super::super::Task;
use super::super::equation::Equation;
use crate::log::Value;
use crate::log::formula::{Operator, QUANTILE};
use crate::report::decided::{self, Comparison, Relation};
use crate::report::expression::Expression;
use crate::report::tag::tag;
use crate::report::{computation, digits, escape};
use std::f64::consts::TAU;

/// The equation of an event: where links to its value lead.
pub(super) fn equation(task: &Task, event: usize) -> Option<String> {
    let equation = Equation::of(task, event)?;
    let middle = [equation.formula.as_ref(), equation.substituted.as_ref()];
    let middle = middle.into_iter().flatten().map(|part| format!("<span>= {}</span>", html(task, part)));
    let tag = tag(task.log, task.tree, event).map(|tag| (task.language.texts().solution.section)(&tag));
    let tag = tag.map_or_else(String::new, |tag| format!(" ({tag})"));
    let title = escape::xml(&format!("{}{tag}", equation.name.key()));
    let marker = escape::xml(&digits::marker_in(task.language, &task.log.events[event]));
    Some(format!(
        "<p class=\"eq\" id=\"e{event}\"><span title=\"{title}\">{}</span>{}<span>= <b>{}</b>{marker}</span></p>",
        symbol(equation.name.symbol()),
        middle.collect::<String>(),
        value(task, &equation.result)
    ))
}

/// `symbol = value`, linked with the event that computed the value.
pub(super) fn assignment(task: &Task, name: &str, there: &Value, source: Option<usize>) -> String {
    format!("<span class=\"eq\">{} = {}</span>", symbol(name), linked(&value(task, there), source))
}

/// A value's text, linked.
pub(super) fn linked(text: &str, source: Option<usize>) -> String {
    source.map_or(text.to_owned(), |event| format!("<a href=\"#e{event}\">{text}</a>"))
}

/// A number or triple, which lines don't break, with the minus sign of formulas.
pub(super) fn value(task: &Task, value: &Value) -> String {
    let text = escape::xml(&task.language.value(value, task.style).replace('-', "−"));
    match value {
        Value::Number(_) => text,
        Value::Triple(_) => format!("<span class=\"n\">{text}</span>"),
    }
}

/// The comparisons of a decision; nothing where there are none.
pub(super) fn compared(task: &Task, event: usize) -> String {
    let sign = |relation: Relation| escape::xml(relation.sign());
    let found = decided::comparisons(task.log, task.tree, event, task.style);
    let line = |comparison: &Comparison| {
        let task = &task.shown_in(comparison.style);
        decided::written(task.language, comparison, &|expression| html(task, expression), sign)
    };
    let lines: Vec<_> = found.iter().map(line).collect();
    if lines.is_empty() { String::new() } else { format!(" ({})", lines.join("; ")) }
}

fn html(task: &Task, expression: &Expression) -> String {
    let of = |inner: &Expression| html(task, inner);
    match expression {
        Expression::Number(TAU) => "2π".to_owned(),
        Expression::Number(x) => value(task, &Value::Number(*x)),
        Expression::Symbol(name) => symbol(name),
        Expression::Value(there, source) => linked(&value(task, there), *source),
        Expression::Precise(x, digits, source) => {
            linked(&value(&task.shown_in(task.style.at_least(*digits)), &Value::Number(*x)), *source)
        }
        Expression::Negated(inner) => format!("−{}", operand(task, inner)),
        Expression::Root(inner) => format!("√<span class=\"root\">{}</span>", of(inner.ungrouped())),
        Expression::Squared(inner) => format!("{}<sup>2</sup>", base(task, inner)),
        Expression::Positive(inner) => format!("{}<sup>+</sup>", base(task, inner)),
        Expression::Length(inner) => format!("|{}|", of(inner)),
        Expression::Floor(inner) => format!("⌊{}⌋", of(inner)),
        Expression::Grouped(inner) => format!("({})", of(inner)),
        Expression::OverLights(inner) => format!("Σ<sub>i</sub> ({})", of(inner)),
        Expression::Over(several, inner) => format!("{} ({})", symbol(several.sign()), of(inner)),
        Expression::Degrees(inner) => format!("{}°", base(task, inner)),
        Expression::Function(function, inner) => format!("{}({})", function.word(), of(inner)),
        Expression::Triple(parts) => format!("({})", parts.each_ref().map(of).join(&format!("{} ", separator(task)))),
        Expression::Elided => "…".to_owned(),
        Expression::Extreme(extreme, first, second) => {
            format!("{}({}{} {})", computation::word(*extreme), of(first), separator(task), of(second))
        }
        Expression::Quantile(probability, freedom) => {
            format!("{QUANTILE}({}{} {})", of(probability), separator(task), of(freedom))
        }
        Expression::ExtremeComponent(extreme, inner) => format!("{}({})", computation::word(*extreme), of(inner)),
        Expression::Binary(Operator::Over, left, right) => format!(
            "<span class=\"frac\"><span>{}</span><span class=\"over\">/</span><span>{}</span></span>",
            of(left.ungrouped()),
            of(right.ungrouped())
        ),
        Expression::Binary(Operator::Power, left, right) => {
            format!("{}<sup>{}</sup>", base(task, left), of(right.ungrouped()))
        }
        Expression::Binary(operator, left, right) => {
            let infix = computation::infix(*operator).trim();
            format!("{} {infix} {}", of(left), operand(task, right))
        }
    }
}

/// The separator of the numbers of a triple.
fn separator(task: &Task) -> char {
    if task.language.texts().decimal_mark == ',' { ';' } else { ',' }
}

/// What follows an operator.
fn operand(task: &Task, expression: &Expression) -> String {
    let text = html(task, expression);
    if expression.begins_negative() { format!("({text})") } else { text }
}

/// What a power is of.
fn base(task: &Task, expression: &Expression) -> String {
    match expression {
        Expression::Symbol(name) if name.contains(['·', '−']) => format!("({})", symbol(name)),
        _ if expression.has_power_of_ten(task.style) => format!("({})", html(task, expression)),
        _ => operand(task, expression),
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
