//! Formulas in the notation of TeX, as LaTeX and Markdown take them.

use super::Task;
use super::equation::{Equation, terms};
use crate::log::Value;
use crate::log::formula::{Function, Operator, QUANTILE, Several};
use crate::report::decided::{self, Comparison, Relation};
use crate::report::expression::Expression;
use crate::report::{computation, digits, escape, number};
use std::f64::consts::TAU;

/// The most characters of a formula on a line.
const LINE: usize = 80;

/// The lines of the equations of some events, for an environment that aligns them.
/// What is wider than a line even alone goes through `fitted`.
pub(super) fn aligned(task: &Task, events: &[usize], fitted: fn(String) -> String) -> Vec<String> {
    let mut all = Vec::new();
    for event in events {
        let Some(equation) = Equation::of(task, *event) else { continue };
        let mut lines = lines(task, &equation, fitted);
        let marker = digits::marker_in(task.language, &task.log.events[*event]);
        if let Some(last) = lines.last_mut().filter(|_| !marker.is_empty()) {
            last.push_str(&format!("\\quad\\text{{{}}}", escape::latex(&marker)));
        }
        all.append(&mut lines);
    }
    all
}

/// The lines of an equation; from the second on they begin with what is under the first equals sign.
fn lines(task: &Task, equation: &Equation, fitted: fn(String) -> String) -> Vec<String> {
    let symbol = symbol(equation.name.symbol());
    let result = value(task, &equation.result);
    let middle = [equation.formula.as_ref(), equation.substituted.as_ref()];
    let parts: Vec<&Expression> = middle.into_iter().flatten().collect();
    let width = |expression: &Expression| self::width(task, expression) + 3;
    let whole: usize = parts.iter().map(|part| width(part)).sum::<usize>() + 16;
    if whole <= LINE {
        let parts = parts.iter().map(|part| tex(task, part)).chain([result]);
        return vec![format!("{symbol} &= {}", parts.collect::<Vec<_>>().join(" = "))];
    }
    let mut lines: Vec<String> = Vec::new();
    for part in parts {
        if width(part) <= LINE {
            lines.push(format!("&= {}", tex(task, part)));
            continue;
        }
        for (sign, term) in terms(part) {
            let text = if sign.is_some() { operand(task, term) } else { tex(task, term) };
            let text = if width(term) > LINE { fitted(text) } else { text };
            lines.push(match sign {
                None => format!("&= {text}"),
                Some(Operator::Minus) => format!("&\\quad {{}} - {text}"),
                Some(_) => format!("&\\quad {{}} + {text}"),
            });
        }
    }
    lines.push(format!("&= {result}"));
    lines[0] = format!("{symbol} {}", lines[0]);
    lines
}

/// `symbol = value`.
pub(super) fn assignment(task: &Task, symbol: &str, value: &Value) -> String {
    format!("{} = {}", self::symbol(symbol), self::value(task, value))
}

/// An expression.
pub(super) fn tex(task: &Task, expression: &Expression) -> String {
    let of = |inner: &Expression| tex(task, inner);
    match expression {
        Expression::Number(TAU) => "2\\pi ".to_owned(),
        Expression::Number(x) => value(task, &Value::Number(*x)),
        Expression::Symbol(symbol) => self::symbol(symbol),
        Expression::Value(there, _) => value(task, there),
        Expression::Precise(x, digits, _) => value(&task.shown_in(task.style.at_least(*digits)), &Value::Number(*x)),
        Expression::Negated(inner) => format!("-{}", operand(task, inner)),
        Expression::Root(inner) => format!("\\sqrt{{{}}}", of(inner.ungrouped())),
        Expression::Squared(inner) => format!("{}^2", base(task, inner)),
        Expression::Positive(inner) => format!("{}^+", base(task, inner)),
        Expression::Length(inner) => format!("\\left|{}\\right|", of(inner)),
        Expression::Floor(inner) => format!("\\left\\lfloor {}\\right\\rfloor", of(inner)),
        Expression::Grouped(inner) => format!("\\left({}\\right)", of(inner)),
        Expression::OverLights(inner) => format!("\\sum_i {}", of(inner)),
        Expression::Over(several, inner) => format!("{} \\left({}\\right)", sign(*several), of(inner)),
        Expression::Degrees(inner) => format!("{}^{{\\circ}}", base(task, inner)),
        Expression::Function(function, inner) => format!("{}\\left({}\\right)", command(*function), of(inner)),
        Expression::Triple(parts) => {
            let mark = task.language.texts().separator.trim_end();
            format!("\\left({}\\right)", parts.each_ref().map(of).join(&format!("{mark}\\; ")))
        }
        Expression::Elided => "\\dots".to_owned(),
        Expression::Extreme(extreme, first, second) => {
            let mark = task.language.texts().separator.trim_end();
            format!("\\{}\\left({}{mark}\\; {}\\right)", computation::word(*extreme), of(first), of(second))
        }
        Expression::Quantile(probability, freedom) => {
            let mark = task.language.texts().separator.trim_end();
            format!("\\operatorname{{{QUANTILE}}}\\left({}{mark}\\; {}\\right)", of(probability), of(freedom))
        }
        Expression::ExtremeComponent(extreme, inner) => {
            format!("\\{}\\left({}\\right)", computation::word(*extreme), of(inner))
        }
        Expression::Binary(Operator::Over, left, right) => {
            format!("\\frac{{{}}}{{{}}}", of(left.ungrouped()), of(right.ungrouped()))
        }
        Expression::Binary(Operator::Power, left, right) => {
            format!("{}^{{{}}}", base(task, left), of(right.ungrouped()))
        }
        Expression::Binary(operator, left, right) => {
            format!("{} {} {}", of(left), infix(*operator), operand(task, right))
        }
    }
}

/// The comparisons of a decision, each between dollar signs; nothing where there are none.
pub(super) fn compared(task: &Task, event: usize) -> String {
    let sign = |relation: Relation| match relation {
        Relation::AtMost => "\\le".to_owned(),
        Relation::AtLeast => "\\ge".to_owned(),
        other => other.sign().to_owned(),
    };
    let line = |comparison: &Comparison| {
        let task = &task.shown_in(comparison.style);
        let text = |expression: &Expression| tex(task, expression);
        let sides = |[left, right]: [String; 2]| format!("${left} {} {right}$", sign(comparison.relation));
        let symbols = comparison.symbolic.each_ref().map(text);
        format!("{}: {}", sides(symbols), sides(comparison.numbers(&text))) + &doubled(task, comparison)
    };
    let found = decided::comparisons(task.log, task.tree, event, task.style);
    let lines: Vec<_> = found.iter().map(line).collect();
    if lines.is_empty() { String::new() } else { format!(" ({})", lines.join("; ")) }
}

fn doubled(task: &Task, comparison: &Comparison) -> String {
    if comparison.is_doubled { format!(" ({})", task.language.texts().twice_the_digits) } else { String::new() }
}

fn sign(several: Several) -> &'static str {
    match several {
        Several::Samples => "\\sum_s",
        Several::Cells => "\\sum_c",
        Several::Surfaces => "\\prod",
        Several::StandardError => "\\operatorname{se}_s",
        Several::Freedom => "\\operatorname{df}_s",
    }
}

fn command(function: Function) -> &'static str {
    match function {
        Function::Cos => "\\cos",
        Function::Sin => "\\sin",
        Function::Tan => "\\tan",
        Function::Exp => "\\exp",
        Function::ExpM1 => "\\mathrm{expm1}",
        Function::Ln1p => "\\mathrm{ln1p}",
        Function::Ceil => "\\mathrm{ceil}",
    }
}

fn infix(operator: Operator) -> &'static str {
    match operator {
        Operator::Plus => "+",
        Operator::Minus => "-",
        Operator::Channelwise => "\\circ",
        Operator::Cross => "\\times",
        Operator::ComponentsOver => "\\oslash",
        Operator::Times | Operator::Over | Operator::Power => "\\cdot",
    }
}

/// What follows an operator.
fn operand(task: &Task, expression: &Expression) -> String {
    let text = tex(task, expression);
    if expression.begins_negative() { format!("\\left({text}\\right)") } else { text }
}

/// What a power is of.
fn base(task: &Task, expression: &Expression) -> String {
    let text = tex(task, expression);
    let is_one = match expression {
        Expression::Symbol(symbol) => symbol.chars().all(|c| c.is_alphanumeric() || c == '_'),
        Expression::Value(Value::Number(x), _) | Expression::Precise(x, ..) => *x >= 0.0 && !text.contains("10^"),
        Expression::Number(_) | Expression::Length(_) | Expression::Grouped(_) => true,
        Expression::Value(Value::Triple(_), _) => true,
        _ => false,
    };
    if is_one { format!("{{{text}}}") } else { format!("\\left({text}\\right)") }
}

/// A number or triple with the language's decimal mark; TeX would put a space behind a comma.
pub(super) fn value(task: &Task, value: &Value) -> String {
    let number = |x: f64| {
        let text = task.language.number(x, task.style).replace(',', "{,}");
        match text.split_once("·10") {
            Some((mantissa, power)) => format!("{mantissa}\\cdot 10^{{{}}}", number::lowered(power)),
            None => text,
        }
    };
    match value {
        Value::Number(x) => number(*x),
        Value::Triple(xyz) => {
            let mark = task.language.texts().separator.trim_end();
            format!("({})", xyz.map(number).join(&format!("{mark}\\; ")))
        }
    }
}

/// A symbol such as `T2_A`, `|D|`, `cosφ_1`, `−N·H′`.
pub(super) fn symbol(symbol: &str) -> String {
    if let Some(inner) = symbol.strip_prefix('|').and_then(|rest| rest.strip_suffix('|')) {
        return format!("\\left|{}\\right|", self::symbol(inner));
    }
    if let Some(inner) = symbol.strip_prefix('−') {
        return format!("-{}", self::symbol(inner));
    }
    if let Some((left, right)) = symbol.split_once('·') {
        return format!("{} \\cdot {}", self::symbol(left), self::symbol(right));
    }
    for function in ["cos", "sin"] {
        if let Some(angle) = symbol.strip_prefix(function).filter(|angle| !angle.is_empty()) {
            return format!("\\{function} {}", self::symbol(angle));
        }
    }
    // The source text has L_2oc and T_2A.
    if let Some((first, rest)) = symbol.split_at_checked(1).filter(|(_, rest)| rest.starts_with('2')) {
        return format!("{first}_{{{}}}", rest.replace('_', ""));
    }
    match symbol.split_once('_') {
        Some((name, index)) => format!("{}_{{{}}}", letters(name), letters(index)),
        None => letters(symbol),
    }
}

/// Letters of a name; several stand upright.
fn letters(name: &str) -> String {
    let plain: String = name.chars().filter(|c| c.is_ascii_alphabetic()).collect();
    let is_word = plain.len() > 1 && plain.len() == name.chars().count();
    if is_word && plain.chars().any(|c| c.is_ascii_lowercase()) {
        return format!("\\mathrm{{{name}}}");
    }
    name.chars().map(letter).collect::<String>().trim_end().to_owned()
}

fn letter(c: char) -> String {
    match (c, escape::tex_letter(c)) {
        // A command ends where no letter follows.
        (_, Some(command)) => format!("\\{command} "),
        ('′', _) => "'".to_owned(),
        ('²', _) => "^2".to_owned(),
        ('ⁿ', _) => "^n".to_owned(),
        _ if c.is_ascii_alphanumeric() => c.to_string(),
        _ => format!("\\mathrm{{{}}}", escape::latex(&c.to_string())),
    }
}

/// About how many characters wide an expression is.
fn width(task: &Task, expression: &Expression) -> usize {
    let of = |inner: &Expression| width(task, inner);
    match expression {
        Expression::Number(x) => task.language.number(*x, task.style).chars().count(),
        Expression::Symbol(symbol) => symbol.split(['_', '·']).map(|part| part.chars().count().min(4)).sum(),
        Expression::Value(value, _) => task.language.value(value, task.style).chars().count(),
        Expression::Precise(x, digits, _) => task.language.number(*x, task.style.at_least(*digits)).chars().count(),
        Expression::Negated(inner)
        | Expression::Root(inner)
        | Expression::Squared(inner)
        | Expression::Degrees(inner)
        | Expression::Positive(inner) => of(inner) + 1,
        Expression::Over(_, inner) | Expression::Function(_, inner) => of(inner) + 5,
        Expression::Triple(parts) => parts.iter().map(of).sum::<usize>() + 6,
        Expression::Elided => 1,
        Expression::Length(inner) | Expression::Floor(inner) | Expression::Grouped(inner) => of(inner) + 2,
        Expression::OverLights(inner) => of(inner) + 3,
        Expression::Extreme(_, first, second) => of(first) + of(second) + 7,
        Expression::Quantile(probability, freedom) => of(probability) + of(freedom) + 11,
        Expression::ExtremeComponent(_, inner) => of(inner) + 5,
        Expression::Binary(Operator::Over, left, right) => of(left).max(of(right)),
        Expression::Binary(Operator::Power, left, right) => of(left) + of(right),
        Expression::Binary(_, left, right) => of(left) + of(right) + 3,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::log::Name;

    #[test]
    fn every_symbol_has_letters_of_tex() {
        for name in Name::all() {
            let text = symbol(name.symbol());
            assert!(text.is_ascii(), "{}: {text}", name.symbol());
            assert!(!text.contains("U+"), "{}: {text}", name.symbol());
            let [open, close] = ['{', '}'].map(|brace| text.matches(brace).count());
            assert_eq!(open, close, "{text}");
        }
    }

    #[test]
    fn symbols_as_on_paper() {
        for (plain, expected) in [
            ("T2_A", "T_{2A}"),
            ("L2oc", "L_{2oc}"),
            ("|D|", "\\left|D\\right|"),
            ("cosφ_1", "\\cos \\varphi_{1}"),
            ("−N·H′", "-N \\cdot H'"),
            ("I_local", "I_{\\mathrm{local}}"),
            ("r²", "r^2"),
        ] {
            assert_eq!(symbol(plain), expected);
        }
    }
}
