//! The equations of worked solutions in the notation of plain text: from TeX, as LaTeX and Markdown have it, and from HTML.

// Each test file compiles this for itself and uses a part of it.
#![allow(dead_code)]

/// The numbers put in and the result of every equation that has both.
pub fn of_tex(text: &str) -> Vec<(String, String)> {
    let mut equations: Vec<String> = Vec::new();
    for line in text.lines().map(|line| line.trim_end_matches("\\\\").trim()) {
        let line = line.split("\\quad\\text{").next().unwrap_or(line);
        match line.split_once('=') {
            // A line that begins with the sign goes on with the equation before it.
            Some((symbol, _)) if symbol.trim() == "&" => append(&mut equations, line.trim_start_matches('&')),
            Some((symbol, _))
                if !symbol.contains("\\text") && !line.contains('$') && !line.starts_with(['#', '|', '%']) =>
            {
                equations.push(line.replacen("&=", "=", 1));
            }
            _ if line.starts_with("&\\quad {}") => append(&mut equations, line.trim_start_matches("&\\quad {}")),
            _ => {}
        }
    }
    equations.iter().filter_map(|equation| numbers(equation.split(" = ").map(plain).collect())).collect()
}

fn append(equations: &mut [String], line: &str) {
    if let Some(last) = equations.last_mut() {
        *last = format!("{last} {}", line.trim());
    }
}

/// The last two parts of an equation, if there are no symbols in them.
fn numbers(parts: Vec<String>) -> Option<(String, String)> {
    let [.., _, line, result] = parts.as_slice() else { return None };
    let words = ["min", "max", "cos", "sin", "tan", "exp", "expm1", "ln1p", "ceil"];
    let is_number = |text: &String| {
        let mut rest = text.clone();
        words.iter().rev().for_each(|word| rest = rest.replace(&format!("{word}("), "("));
        !rest.chars().any(|c| c.is_alphabetic() && c != 'π') && !rest.contains('…')
    };
    (is_number(line) && is_number(result)).then(|| (line.clone(), result.clone()))
}

/// A part of an equation of TeX.
fn plain(tex: &str) -> String {
    let text = tex.replace("{,}", ",").replace("\\;", "").replace("\\left", "").replace("\\right", "");
    let text = text.replace(" - ", " − ").replace("\\fitted", "");
    Tex { rest: &text }.until(None)
}

struct Tex<'t> {
    rest: &'t str,
}

impl Tex<'_> {
    /// The text up to a closing brace, or to the end.
    fn until(&mut self, close: Option<char>) -> String {
        let mut out = String::new();
        while let Some(c) = self.rest.chars().next() {
            self.rest = &self.rest[c.len_utf8()..];
            match c {
                _ if Some(c) == close => return out,
                // Braces group their contents.
                '{' => {
                    let inner = self.until(Some('}'));
                    out += &format!("({inner})");
                }
                '^' => out += &self.raised(out.ends_with("10")),
                '\\' => out += &self.command(),
                c => out.push(c),
            }
        }
        out
    }

    /// An exponent; of a power of ten in small digits.
    fn raised(&mut self, is_of_ten: bool) -> String {
        if let Some(rest) = self.rest.strip_prefix('2') {
            self.rest = rest;
            return "²".to_owned();
        }
        let inner = self.group();
        let small = |c: char| match c {
            '-' => '⁻',
            c => c.to_digit(10).map_or(c, |digit| ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'][digit as usize]),
        };
        match inner.as_str() {
            "°" => inner,
            _ if is_of_ten && inner.chars().all(|c| c.is_ascii_digit() || c == '-') => {
                inner.chars().map(small).collect()
            }
            _ => format!("^({inner})"),
        }
    }

    fn group(&mut self) -> String {
        self.rest = self.rest.trim_start();
        match self.rest.strip_prefix('{') {
            Some(rest) => {
                self.rest = rest;
                self.until(Some('}'))
            }
            None => String::new(),
        }
    }

    fn command(&mut self) -> String {
        let end = self.rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest;
        match word {
            "frac" => {
                let (over, under) = (self.group(), self.group());
                format!("(({over})/({under}))")
            }
            "sqrt" => format!("√({})", self.group()),
            "mathrm" => self.group(),
            "cdot" => "·".to_owned(),
            "circ" => {
                let is_degree = self.rest.starts_with('}');
                if is_degree { "°" } else { "∘" }.to_owned()
            }
            "times" => "×".to_owned(),
            "oslash" => "⊘".to_owned(),
            "lfloor" => "⌊".to_owned(),
            "rfloor" => "⌋".to_owned(),
            "pi" => "π".to_owned(),
            "dots" => "…".to_owned(),
            word => word.to_owned(),
        }
    }
}

/// The same of a page.
pub fn of_html(page: &str) -> Vec<(String, String)> {
    let equations = page.split("<p class=\"eq\"").skip(1).filter_map(|rest| rest.split("</p>").next());
    let parts = |equation: &str| {
        let (_, equation) = equation.split_once('>')?;
        let equation = equation.replace("<sup>2</sup>", "²").replace("<sup>+</sup>", "⁺");
        // A remark in parentheses behind the result isn't a part of it.
        let equation = equation.split("</b>").next().unwrap_or_default();
        numbers(Html { rest: equation }.until(None).split("= ").map(str::to_owned).collect())
    };
    equations.filter_map(parts).collect()
}

struct Html<'t> {
    rest: &'t str,
}

impl Html<'_> {
    /// The text up to a closing tag, or to the end.
    fn until(&mut self, close: Option<&str>) -> String {
        let mut out = String::new();
        while let Some(c) = self.rest.chars().next() {
            if let Some(rest) = close.and_then(|close| self.rest.strip_prefix(close)) {
                self.rest = rest;
                return out;
            }
            let Some((tag, rest)) = self.rest.strip_prefix('<').and_then(|rest| rest.split_once('>')) else {
                out.push(c);
                self.rest = &self.rest[c.len_utf8()..];
                continue;
            };
            self.rest = rest;
            match tag {
                "span class=\"frac\"" => out += &format!("({})", self.until(Some("</span>"))),
                "span class=\"over\"" => out += &self.until(Some("</span>")),
                // A triple that isn't broken, and a part of the chain.
                "span class=\"n\"" => out += &self.until(Some("</span>")),
                "span" if self.rest.starts_with("= ") => out += &self.until(Some("</span>")),
                "sup" => out += &format!("^({})", self.until(Some("</sup>"))),
                _ if tag.starts_with("span title") => out += &self.until(Some("</span>")),
                _ if tag.starts_with("span") => out += &format!("({})", self.until(Some("</span>"))),
                "i" => out += &format!("x{}", self.until(Some("</i>"))),
                _ => {}
            }
        }
        out
    }
}
