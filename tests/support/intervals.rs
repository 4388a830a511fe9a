//! A line of numbers as a formula: every number stands for all that are rounded to it, and the line is evaluated on these intervals.

// Each test file compiles this for itself and uses a part of it.
#![allow(dead_code)]

/// Whether the numbers that a line may stand for give one that the result may stand for.
pub fn agrees(line: &str, result: &str, mark: char, rounding: f64) -> Result<bool, String> {
    let (line, result) = (read(line, mark)?, read(result, mark)?);
    match (line, result) {
        (Part::Number(a), Part::Number(b)) => Ok(a.meets(b, rounding)),
        (Part::Triple(a), Part::Triple(b)) => Ok((0..3).all(|k| a[k].meets(b[k], rounding))),
        // A scale that stands for a colour: a term that is absent.
        (Part::Number(a), Part::Triple(b)) => Ok(b.iter().all(|b| a.meets(*b, rounding))),
        (line, result) => Err(format!("{line:?} is no {result:?}")),
    }
}

/// A function and how its call begins.
type Named = (&'static str, fn(f64) -> f64);

/// All numbers between two.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    pub low: f64,
    pub high: f64,
}

#[derive(Clone, Copy, Debug)]
pub enum Part {
    Number(Interval),
    Triple([Interval; 3]),
}

const ALL: Interval = Interval { low: f64::NEG_INFINITY, high: f64::INFINITY };

impl Interval {
    fn around(x: f64, margin: f64) -> Interval {
        Interval { low: x - margin, high: x + margin }
    }

    /// The least interval around some numbers, a little wider; everything where one is no number.
    fn of(numbers: &[f64]) -> Interval {
        if numbers.iter().any(|x| x.is_nan()) {
            return ALL;
        }
        let low = numbers.iter().copied().fold(f64::INFINITY, f64::min);
        let high = numbers.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        Interval { low: low - low.abs() * 1e-12, high: high + high.abs() * 1e-12 }
    }

    fn map(self, f: impl Fn(f64) -> f64) -> Interval {
        Interval::of(&[f(self.low), f(self.high)])
    }

    fn with(self, other: Interval, f: impl Fn(f64, f64) -> f64) -> Interval {
        let Interval { low: a, high: b } = self;
        let Interval { low: c, high: d } = other;
        Interval::of(&[f(a, c), f(a, d), f(b, c), f(b, d)])
    }

    fn holds_zero(self) -> bool {
        self.low <= 0.0 && self.high >= 0.0
    }

    fn meets(self, other: Interval, rounding: f64) -> bool {
        // Single precision rounds once more.
        let margin = rounding + 1e-6 * (other.low.abs() + other.high.abs());
        self.low <= other.high + margin && self.high >= other.low - margin
    }
}

pub fn read(text: &str, mark: char) -> Result<Part, String> {
    let mut reader = Reader { rest: text, mark };
    let part = reader.sum()?;
    if reader.peek().is_empty() { Ok(part) } else { Err(format!("`{}` is left of `{text}`", reader.rest)) }
}

struct Reader<'t> {
    rest: &'t str,
    mark: char,
}

impl Reader<'_> {
    fn peek(&mut self) -> &str {
        self.rest = self.rest.trim_start();
        self.rest
    }

    fn eat(&mut self, token: &str) -> bool {
        self.peek();
        match self.rest.strip_prefix(token) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    fn need(&mut self, token: &str) -> Result<(), String> {
        if self.eat(token) { Ok(()) } else { Err(format!("`{token}` is missing before `{}`", self.rest)) }
    }

    fn sum(&mut self) -> Result<Part, String> {
        let mut left = self.product()?;
        loop {
            let f: fn(f64, f64) -> f64 = if self.eat("+") {
                |a, b| a + b
            } else if self.eat("−") {
                |a, b| a - b
            } else {
                return Ok(left);
            };
            left = zip(left, self.product()?, |a, b| a.with(b, f))?;
        }
    }

    fn product(&mut self) -> Result<Part, String> {
        let mut left = self.power()?;
        loop {
            if self.eat("·") {
                left = match (left, self.power()?) {
                    (Part::Triple(a), Part::Triple(b)) => Part::Number(dot(a, b)),
                    (a, b) => zip(a, b, |a, b| a.with(b, |a, b| a * b))?,
                };
            } else if self.eat("∘") {
                left = zip(left, self.power()?, |a, b| a.with(b, |a, b| a * b))?;
            } else if self.eat("×") {
                let (Part::Triple(a), Part::Triple(b)) = (left, self.power()?) else {
                    return Err("a cross product of numbers".to_owned());
                };
                let times = |a: Interval, b: Interval| a.with(b, |a, b| a * b);
                let minor = |i: usize, j: usize| times(a[i], b[j]).with(times(b[i], a[j]), |a, b| a - b);
                left = Part::Triple([minor(1, 2), minor(2, 0), minor(0, 1)]);
            } else if self.eat("/") {
                left = zip(left, self.power()?, over)?;
            } else if self.eat("⊘") {
                left = zip(left, self.power()?, |a, b| if b.holds_zero() { ALL } else { over(a, b) })?;
            } else {
                return Ok(left);
            }
        }
    }

    fn power(&mut self) -> Result<Part, String> {
        let base = self.prefix()?;
        if !self.eat("^") {
            return Ok(base);
        }
        let exponent = self.power()?;
        // Cosines lie between 0 and 1, to which they are rounded; a quotient may lie above 1 by more.
        zip(base, exponent, |a, b| {
            let most = if a.high <= 1.001 { 1.0 } else { f64::INFINITY };
            let a = a.map(|x| x.clamp(0.0, most));
            a.with(b, |a, b| libm::pow(a.clamp(0.0, most), b))
        })
    }

    fn prefix(&mut self) -> Result<Part, String> {
        // A hyphen before a digit belongs to the number.
        let is_negated =
            self.peek().strip_prefix('-').is_some_and(|rest| !rest.starts_with(|c: char| c.is_ascii_digit()));
        if (is_negated && self.eat("-")) || self.eat("−") {
            return Ok(each(self.power()?, |x| x.map(|x| -x)));
        }
        if self.eat("√") {
            let inner = self.postfix()?;
            return Ok(each(inner, |x| x.map(|x| x.max(0.0).sqrt())));
        }
        self.postfix()
    }

    fn postfix(&mut self) -> Result<Part, String> {
        let mut inner = self.atom()?;
        loop {
            if self.eat("²") {
                inner = each(inner, |x| {
                    let squares = x.map(|x| x * x);
                    if x.holds_zero() { Interval { low: 0.0, ..squares } } else { squares }
                });
            } else if self.eat("°") {
                inner = each(inner, |x| x.map(f64::to_radians));
            } else {
                return Ok(inner);
            }
        }
    }

    fn atom(&mut self) -> Result<Part, String> {
        let separator = if self.mark == ',' { ";" } else { "," };
        for (word, is_min) in [("min(", true), ("max(", false)] {
            if self.eat(word) {
                return self.extreme(is_min, separator);
            }
        }
        let waves: [Named; 2] = [("cos(", libm::cos), ("sin(", libm::sin)];
        for (word, f) in waves {
            if self.eat(word) {
                let inner = self.sum()?;
                self.need(")")?;
                // By no more than the angle, and by no more than 1.
                return Ok(each(inner, |x| {
                    let (middle, width) = ((x.low + x.high) / 2.0, (x.high - x.low) / 2.0);
                    Interval::around(f(middle), width.min(2.0))
                }));
            }
        }
        let rising: [Named; 5] = [
            ("tan(", libm::tan),
            ("expm1(", libm::expm1),
            ("exp(", libm::exp),
            ("ln1p(", libm::log1p),
            ("ceil(", libm::ceil),
        ];
        for (word, f) in rising {
            if self.eat(word) {
                let inner = self.sum()?;
                self.need(")")?;
                return Ok(each(inner, |x| x.map(|x| if word == "ln1p(" { f(x.max(-1.0)) } else { f(x) })));
            }
        }
        if self.eat("(") {
            let first = self.sum()?;
            if self.eat(separator) {
                let second = self.sum()?;
                self.need(separator)?;
                let third = self.sum()?;
                self.need(")")?;
                let (Part::Number(x), Part::Number(y), Part::Number(z)) = (first, second, third) else {
                    return Err("a triple of triples".to_owned());
                };
                return Ok(Part::Triple([x, y, z]));
            }
            self.need(")")?;
            return Ok(first);
        }
        for (open, close) in [("|", "|"), ("⌊", "⌋")] {
            if self.eat(open) {
                let inner = self.sum()?;
                self.need(close)?;
                return Ok(match (open, inner) {
                    ("|", Part::Triple(v)) => {
                        let squares = dot(v, v);
                        Part::Number(squares.map(|x| x.max(0.0).sqrt()))
                    }
                    ("|", number) => number,
                    (_, inner) => each(inner, |x| x.map(f64::floor)),
                });
            }
        }
        self.number().map(Part::Number)
    }

    fn extreme(&mut self, is_min: bool, separator: &str) -> Result<Part, String> {
        let extreme = |a: f64, b: f64| if is_min { a.min(b) } else { a.max(b) };
        let of = |a: Interval, b: Interval| Interval { low: extreme(a.low, b.low), high: extreme(a.high, b.high) };
        let first = self.sum()?;
        if self.eat(separator) {
            let second = self.sum()?;
            self.need(")")?;
            return zip(first, second, of);
        }
        self.need(")")?;
        match first {
            Part::Triple([x, y, z]) => Ok(Part::Number(of(of(x, y), z))),
            Part::Number(_) => Err("the extreme of one number".to_owned()),
        }
    }

    /// A number with half a unit in its last place to either side; a whole one stands for itself.
    fn number(&mut self) -> Result<Interval, String> {
        self.peek();
        let text = self.rest;
        let is_part = |c: char| c.is_ascii_digit() || c == self.mark;
        let sign = usize::from(text.starts_with('-'));
        let end = text[sign..].find(|c: char| !is_part(c)).map_or(text.len(), |end| end + sign);
        let digits = text[..end].replace(self.mark, ".");
        let mantissa: f64 = digits.parse().map_err(|_| format!("no number at `{text}`"))?;
        let decimals = digits.split_once('.').map_or(0, |(_, decimals)| decimals.len());
        self.rest = &text[end..];
        // A power of ten is a factor of its own: that it belongs to the number before it only parentheses can say.
        if digits == "10" && self.rest.starts_with(is_raised) {
            let end = self.rest.find(|c: char| !is_raised(c)).unwrap_or(self.rest.len());
            let raised: String = self.rest[..end].chars().map(lowered).collect();
            let exponent: i32 = raised.parse().map_err(|_| format!("no power of ten at `{text}`"))?;
            self.rest = &self.rest[end..];
            return Ok(Interval::around(libm::exp10(f64::from(exponent)), 0.0));
        }
        if self.rest.starts_with('π') {
            self.rest = &self.rest['π'.len_utf8()..];
            return Ok(Interval::around(mantissa * std::f64::consts::PI, 0.0));
        }
        // A whole number stands for itself.
        let unit = if decimals == 0 { 0.0 } else { libm::exp10(-(decimals as f64)) };
        Ok(Interval::around(mantissa, 0.5001 * unit))
    }
}

fn is_raised(c: char) -> bool {
    "⁰¹²³⁴⁵⁶⁷⁸⁹⁻".contains(c)
}

fn lowered(c: char) -> char {
    "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|raised| raised == c).map_or('-', |digit| char::from(b"0123456789"[digit]))
}

fn over(a: Interval, b: Interval) -> Interval {
    if b.holds_zero() { ALL } else { a.with(b, |a, b| a / b) }
}

fn dot(a: [Interval; 3], b: [Interval; 3]) -> Interval {
    let times = |k: usize| a[k].with(b[k], |a, b| a * b);
    times(0).with(times(1), |a, b| a + b).with(times(2), |a, b| a + b)
}

fn each(part: Part, f: impl Fn(Interval) -> Interval) -> Part {
    match part {
        Part::Number(x) => Part::Number(f(x)),
        Part::Triple(xyz) => Part::Triple(xyz.map(f)),
    }
}

/// Component by component; a number goes with each of a triple's.
fn zip(a: Part, b: Part, f: impl Fn(Interval, Interval) -> Interval) -> Result<Part, String> {
    Ok(match (a, b) {
        (Part::Number(a), Part::Number(b)) => Part::Number(f(a, b)),
        (Part::Triple(a), Part::Triple(b)) => Part::Triple([0, 1, 2].map(|k| f(a[k], b[k]))),
        (Part::Triple(a), Part::Number(b)) => Part::Triple(a.map(|a| f(a, b))),
        (Part::Number(a), Part::Triple(b)) => Part::Triple(b.map(|b| f(a, b))),
    })
}
