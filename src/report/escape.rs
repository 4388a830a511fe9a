//! Text in the formats of views, so that a name from a scene file is shown there and does nothing.
//!
//! Each function takes plain text and gives what represents it in one format. What can't be seen is escaped first (`\u{1b}`).

use super::number::unraised;
use crate::files::escape::escape_hidden;

/// In running text of Markdown (CommonMark: a backslash before any punctuation stands for it alone).
pub fn markdown(text: &str) -> String {
    with_backslashes(text, r"\`*_[]<>|#~$&!")
}

/// In a quoted label of Graphviz, where backslashes and entities are read.
pub fn dot(text: &str) -> String {
    escape_hidden(text).replace('\\', r"\\").replace('"', "\\\"").replace('&', "&amp;")
}

/// In a quoted label of Mermaid, which knows characters by their number.
pub fn mermaid(text: &str) -> String {
    replaced(text, |c| (c.is_ascii_punctuation() && !",.-()/%:".contains(c)).then(|| format!("#{};", u32::from(c))))
}

/// In text and attributes of XML and HTML.
pub fn xml(text: &str) -> String {
    xml_of_visible(&escape_hidden(text))
}

/// The same of a text, or a piece of one, that has been made visible: what is beside it decides whether a joiner is.
pub fn xml_of_visible(text: &str) -> String {
    each_replaced(text, |c| match c {
        '&' => Some("&amp;".to_owned()),
        '<' => Some("&lt;".to_owned()),
        '>' => Some("&gt;".to_owned()),
        '"' => Some("&quot;".to_owned()),
        '\'' => Some("&#39;".to_owned()),
        // Unicode leaves these undefined, and XML has no way to write them, nor control characters.
        '\u{fffe}' | '\u{ffff}' => Some("\u{fffd}".to_owned()),
        _ if c.is_control() && !"\t\n\r".contains(c) => Some(String::new()),
        _ => None,
    })
}

/// In running text of LaTeX: what its standard fonts have; other characters by their number.
pub fn latex(text: &str) -> String {
    const ACCENTED: &str = "áéíóúàèìòùâêîôûäëïöüÁÉÍÓÚÀÈÌÒÙÂÊÎÔÛÄËÏÖÜñÑãõÃÕåÅçÇæÆøØœŒß¿¡";
    replaced(text, |c| match c {
        '\\' => Some(r"\textbackslash{}".to_owned()),
        '{' | '}' | '$' | '&' | '#' | '%' | '_' => Some(format!("\\{c}")),
        '^' => Some(r"\textasciicircum{}".to_owned()),
        '~' => Some(r"\textasciitilde{}".to_owned()),
        '<' => Some(r"\textless{}".to_owned()),
        '>' => Some(r"\textgreater{}".to_owned()),
        '|' => Some(r"\textbar{}".to_owned()),
        // Between quotes and hyphens there are ligatures.
        '"' => Some(r"{\char34}".to_owned()),
        '`' => Some("{`}".to_owned()),
        '\'' => Some("{'}".to_owned()),
        '-' => Some("{-}".to_owned()),
        '·' => Some(r"\textperiodcentered{}".to_owned()),
        '−' => Some("$-$".to_owned()),
        '×' => Some(r"$\times$".to_owned()),
        '…' => Some(r"\dots{}".to_owned()),
        '′' => Some("$'$".to_owned()),
        '°' => Some(r"$^\circ$".to_owned()),
        'ⁿ' => Some("$^n$".to_owned()),
        _ if unraised(c).is_some() => unraised(c).map(|c| format!("\\textsuperscript{{{c}}}")),
        _ if tex_letter(c).is_some() => tex_letter(c).map(|command| format!("$\\{command}$")),
        _ if c.is_ascii() || ACCENTED.contains(c) => None,
        _ => Some(format!("[U+{:04X}]", u32::from(c))),
    })
}

/// The command of TeX for a letter that occurs in symbols.
pub(super) fn tex_letter(c: char) -> Option<&'static str> {
    const LETTERS: &[(char, &str)] = &[
        ('η', "eta"),
        ('φ', "varphi"),
        ('ρ', "rho"),
        ('ν', "nu"),
        ('ξ', "xi"),
        ('σ', "sigma"),
        ('τ', "tau"),
        ('π', "pi"),
        ('κ', "kappa"),
        ('θ', "theta"),
        ('γ', "gamma"),
        ('ε', "varepsilon"),
        ('ω', "omega"),
        ('Δ', "Delta"),
        ('Ω', "Omega"),
        ('ℓ', "ell"),
    ];
    LETTERS.iter().find(|(letter, _)| *letter == c).map(|(_, command)| *command)
}

fn with_backslashes(text: &str, special: &str) -> String {
    replaced(text, |c| special.contains(c).then(|| format!("\\{c}")))
}

fn replaced(text: &str, replacement: impl Fn(char) -> Option<String>) -> String {
    each_replaced(&escape_hidden(text), replacement)
}

fn each_replaced(text: &str, replacement: impl Fn(char) -> Option<String>) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match replacement(c) {
            Some(replacement) => escaped.push_str(&replacement),
            None => escaped.push(c),
        }
    }
    escaped
}

/// A line of text that ends there; writing to a `String` can't fail.
macro_rules! line {
    ($out:expr) => { { let _ = writeln!($out); } };
    ($out:expr, $($text:tt)*) => { { let _ = writeln!($out, $($text)*); } };
}
pub(super) use line;

/// Some tests of other modules write this name: it has something of everything that a format reads.
#[cfg(test)]
pub(super) const NASTY: &str =
    "</script><b a=\"x\" '>&amp; \\end{document} $x_1^2$ `c` [l](u) | #1 %\u{1b}[2J\u{202e} 球 é";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markup_becomes_text() {
        assert_eq!(markdown("a*b_[c](d)|`e` <f> $1 #"), r"a\*b\_\[c\](d)\|\`e\` \<f\> \$1 \#");
        assert_eq!(dot("a\"b\\n&lt;"), "a\\\"b\\\\n&amp;lt;");
        assert_eq!(mermaid("a\"b#1;<c>"), "a#34;b#35;1#59;#60;c#62;");
        assert_eq!(xml("<a href='\"'>&"), "&lt;a href=&#39;&quot;&#39;&gt;&amp;");
        assert_eq!(latex("50%_{a}\\b"), r"50\%\_\{a\}\textbackslash{}b");
    }

    #[test]
    fn what_cannot_be_seen_is_reported() {
        for escape in [markdown, dot, mermaid, xml, latex] {
            let escaped = escape(NASTY);
            assert_eq!(crate::files::escape::hidden(&escaped).next(), None, "{escaped}");
        }
        assert_eq!(latex("球 é"), "[U+7403] é");
        assert_eq!(xml("\u{ffff}"), "\u{fffd}");
    }
}
