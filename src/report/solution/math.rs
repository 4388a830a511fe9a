//! Formulas in the notation of TeX, as LaTeX and Markdown take them.

use super::Task;
use super::equation::{Equation, terms};
use crate::log::Value;
use crate::log::formula::{Formula, Operator, QUANTILE, Several, Unary};
use crate::report::decided::Relation;
use crate::report::expression::{Expression, Leaf};
use crate::report::language::Language;
use crate::report::notation::{Notation, Numbers, written};
use crate::report::{Style, digits, escape, number};

/// The most characters of a formula on a line.
const LINE: usize = 80;

/// The lines of the equations of some events, for an environment that aligns them.
/// What is wider than a line even alone goes through `fitted`.
pub(super) fn aligned(task: &Task, events: &[usize], fitted: fn(String) -> String) -> Vec<String> {
    let mut all = Vec::new();
    for event in events {
        let Some(equation) = Equation::of(task, *event) else { continue };
        let mut lines = lines(task, &equation, fitted);
        let marker = digits::marker(task.language, task.log, task.tree, *event);
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
    let result = Tex::value(task.numbers(), &equation.result);
    let middle = [equation.formula.as_ref(), equation.substituted.as_ref()];
    let parts: Vec<&Expression> = middle.into_iter().flatten().collect();
    let width = |expression: &Expression| self::width(task, expression) + 3;
    let whole: usize = parts.iter().map(|part| width(part)).sum::<usize>() + 16;
    if whole <= LINE {
        let parts = parts.iter().map(|part| written::<Tex>(task.numbers(), part)).chain([result]);
        return vec![format!("{symbol} &= {}", parts.collect::<Vec<_>>().join(" = "))];
    }
    let mut lines: Vec<String> = Vec::new();
    for part in parts {
        if width(part) <= LINE {
            lines.push(format!("&= {}", written::<Tex>(task.numbers(), part)));
            continue;
        }
        for (sign, term) in terms(part) {
            let text = written::<Tex>(task.numbers(), term);
            let text = if sign.is_some() && term.begins_negative() { Tex::grouped(&text) } else { text };
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

/// The notation of TeX.
pub(super) struct Tex;

impl Notation for Tex {
    const TWO_PI: &str = "2\\pi ";
    const ELIDED: &str = "\\dots";

    fn separator(language: Language) -> String {
        format!("{}\\; ", language.texts().separator.trim_end())
    }

    /// With the language's decimal mark; TeX would put a space behind a comma.
    fn value(numbers: Numbers, value: &Value) -> String {
        let number = |x: f64| {
            let text = numbers.language.number(x, numbers.style).replace(',', "{,}");
            match text.split_once("·10") {
                Some((mantissa, power)) => format!("{mantissa}\\cdot 10^{{{}}}", number::lowered(power)),
                None => text,
            }
        };
        match value {
            Value::Number(x) => number(*x),
            Value::Triple(xyz) => format!("({})", xyz.map(number).join(&Self::separator(numbers.language))),
        }
    }

    fn symbol(symbol: &str) -> String {
        self::symbol(symbol)
    }

    fn grouped(inner: &str) -> String {
        format!("\\left({inner}\\right)")
    }

    fn base(_style: Style, expression: &Expression, text: String) -> String {
        let is_one = match expression {
            Formula::Leaf(Leaf::Symbol(symbol)) => symbol.chars().all(|c| c.is_alphanumeric() || c == '_'),
            Formula::Leaf(Leaf::Value(Value::Number(x), _) | Leaf::Precise(x, ..)) => {
                *x >= 0.0 && !text.contains("10^")
            }
            Formula::Leaf(Leaf::Value(Value::Triple(_), _)) | Formula::Number(_) => true,
            Formula::Unary(unary, _) => matches!(unary, Unary::Length | Unary::Grouped),
            _ => false,
        };
        if is_one { format!("{{{text}}}") } else { Self::grouped(&text) }
    }

    fn unary(unary: Unary, inner: &str) -> String {
        match unary {
            Unary::Negated => format!("-{inner}"),
            Unary::Root => format!("\\sqrt{{{inner}}}"),
            Unary::Squared => format!("{inner}^2"),
            Unary::Positive => format!("{inner}^+"),
            Unary::Degrees => format!("{inner}^{{\\circ}}"),
            Unary::Length => format!("\\left|{inner}\\right|"),
            Unary::Floor => format!("\\left\\lfloor {inner}\\right\\rfloor"),
            Unary::OverLights => format!("\\sum_i {inner}"),
            Unary::Over(several) => format!("{} {}", sign(several), Self::grouped(inner)),
            Unary::Grouped | Unary::Function(_) | Unary::ExtremeComponent(_) => Self::grouped(inner),
        }
    }

    fn function(name: &str) -> String {
        match name {
            "cos" | "sin" | "tan" | "exp" | "ln" | "min" | "max" => format!("\\{name}"),
            "asin" | "acos" | "atan" => format!("\\arc{}", &name[1..]),
            QUANTILE => format!("\\operatorname{{{name}}}"),
            _ => format!("\\mathrm{{{name}}}"),
        }
    }

    fn binary(operator: Operator, left: &str, right: &str) -> String {
        let infix = match operator {
            Operator::Over => return format!("\\frac{{{left}}}{{{right}}}"),
            Operator::Power => return format!("{left}^{{{right}}}"),
            Operator::Plus => "+",
            Operator::Minus => "-",
            Operator::Times => "\\cdot",
            Operator::Channelwise => "\\circ",
            Operator::Cross => "\\times",
            Operator::ComponentsOver => "\\oslash",
            Operator::Extreme(_) | Operator::Quantile => ",",
        };
        format!("{left} {infix} {right}")
    }

    fn relation(relation: Relation) -> String {
        match relation {
            Relation::AtMost => "\\le".to_owned(),
            Relation::AtLeast => "\\ge".to_owned(),
            other => other.sign().to_owned(),
        }
    }

    fn within_text(formula: String) -> String {
        format!("${formula}$")
    }
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
    let number = |x: f64, style| task.language.number(x, style).chars().count();
    match expression {
        Formula::Number(x) => number(*x, task.style),
        Formula::Leaf(leaf) => match leaf {
            Leaf::Symbol(symbol) => symbol.split(['_', '·']).map(|part| part.chars().count().min(4)).sum(),
            Leaf::Value(value, _) => task.language.value(value, task.style).chars().count(),
            Leaf::Precise(x, digits, _) => number(*x, task.style.at_least(*digits)),
            Leaf::Elided => 1,
        },
        Formula::Triple(parts) => parts.iter().map(of).sum::<usize>() + 6,
        Formula::Unary(unary, inner) => {
            let signs = match unary {
                Unary::Negated | Unary::Root | Unary::Squared | Unary::Degrees | Unary::Positive => 1,
                Unary::Length | Unary::Floor | Unary::Grouped => 2,
                Unary::OverLights => 3,
                Unary::Over(_) | Unary::Function(_) | Unary::ExtremeComponent(_) => 5,
            };
            of(inner) + signs
        }
        Formula::Binary(operator, left, right) => match operator {
            Operator::Over => of(left).max(of(right)),
            Operator::Power => of(left) + of(right),
            Operator::Extreme(_) => of(left) + of(right) + 7,
            Operator::Quantile => of(left) + of(right) + 11,
            _ => of(left) + of(right) + 3,
        },
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
