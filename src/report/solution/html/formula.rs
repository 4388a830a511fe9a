//! Formulas in HTML, their values linked with the steps that computed them.

use super::super::Task;
use super::super::equation::Equation;
use crate::log::Value;
use crate::log::formula::{Formula, Operator, Unary};
use crate::report::decided::Relation;
use crate::report::expression::{Expression, Leaf};
use crate::report::language::Language;
use crate::report::notation::{self, Notation, written};
use crate::report::tag::tag;
use crate::report::{Style, digits, escape};

/// The equation of an event: where links to its value lead.
pub(super) fn equation(task: &Task, event: usize) -> Option<String> {
    let equation = Equation::of(task, event)?;
    let middle = [equation.formula.as_ref(), equation.substituted.as_ref()];
    let middle = middle.into_iter().flatten().map(|part| format!("<span>= {}</span>", written(&Html::of(task), part)));
    let tag = tag(task.log, task.tree, event).map(|tag| (task.language.texts().solution.section)(&tag));
    let tag = tag.map_or_else(String::new, |tag| format!(" ({tag})"));
    let title = escape::xml(&format!("{}{tag}", equation.name.key()));
    let marker = escape::xml(&digits::marker(task.language, &task.log.events[event]));
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

/// A number or triple.
pub(super) fn value(task: &Task, value: &Value) -> String {
    Html::of(task).value(value, task.style)
}

/// The comparisons of a decision; nothing where there are none.
pub(super) fn compared(task: &Task, event: usize) -> String {
    let language = task.language;
    let notation = |style| Html { language, style };
    let lines = notation::comparisons(task.log, task.tree, event, (language, task.style), notation);
    lines.map_or(String::new(), |lines| format!(" ({lines})"))
}

/// Formulas as elements of a page.
struct Html {
    language: Language,
    style: Style,
}

impl Html {
    fn of(task: &Task) -> Html {
        Html { language: task.language, style: task.style }
    }
}

impl Notation for Html {
    fn style(&self) -> Style {
        self.style
    }

    fn separator(&self) -> String {
        self.language.texts().separator.to_owned()
    }

    /// Lines don't break it, and its minus sign is that of formulas.
    fn value(&self, value: &Value, style: Style) -> String {
        let text = escape::xml(&self.language.value(value, style).replace('-', "−"));
        match value {
            Value::Number(_) => text,
            Value::Triple(_) => format!("<span class=\"n\">{text}</span>"),
        }
    }

    fn symbol(&self, symbol: &str) -> String {
        self::symbol(symbol)
    }

    fn linked(&self, text: String, event: Option<usize>) -> String {
        linked(&text, event)
    }

    fn base(&self, expression: &Expression, text: String) -> String {
        let is_product = matches!(expression, Formula::Leaf(Leaf::Symbol(name)) if name.contains(['·', '−']));
        let is_one = !is_product && !expression.has_power_of_ten(self.style) && !expression.begins_negative();
        if is_one { text } else { self.grouped(&text) }
    }

    fn unary(&self, unary: Unary, inner: &str) -> String {
        match unary {
            Unary::Negated => format!("−{inner}"),
            Unary::Root => format!("√<span class=\"root\">{inner}</span>"),
            Unary::Squared => format!("{inner}<sup>2</sup>"),
            Unary::Positive => format!("{inner}<sup>+</sup>"),
            Unary::Degrees => format!("{inner}°"),
            Unary::Length => format!("|{inner}|"),
            Unary::Floor => format!("⌊{inner}⌋"),
            Unary::OverLights => format!("Σ<sub>i</sub> ({inner})"),
            Unary::Over(several) => format!("{} ({inner})", symbol(several.sign())),
            Unary::Grouped | Unary::Function(_) | Unary::ExtremeComponent(_) => self.grouped(inner),
        }
    }

    fn binary(&self, operator: Operator, left: &str, right: &str) -> String {
        match operator {
            Operator::Over => format!(
                "<span class=\"frac\"><span>{left}</span><span class=\"over\">/</span><span>{right}</span></span>"
            ),
            Operator::Power => format!("{left}<sup>{right}</sup>"),
            _ => format!("{left} {} {right}", notation::infix(operator)),
        }
    }

    fn relation(&self, relation: Relation) -> String {
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
