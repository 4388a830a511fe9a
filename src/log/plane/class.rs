//! Classes of light paths (Heckbert, "Adaptive radiosity textures for bidirectional ray tracing", 1990), and patterns of them.
//!
//! A path from the light L to the eye E is scattered diffusely, D, or like a mirror or lens, S, at the first surface, and like a mirror or lens at
//! every further one; A is the ambient light that a surface sends out, B the background. So the classes are `LDE`, `LSE`, `LDSE`, …, `AE`, `ASE`,
//! …, `BE`, `BSE`, …. A pattern is a regular expression over these letters.

use std::fmt;
use std::str::FromStr;

/// Where the light of a path comes from, and how the first surface scatters it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Emitter {
    /// A light.
    Light {
        /// Its number.
        light: u32,
        /// Whether the surface scatters it diffusely; else like a blurred mirror or lens.
        is_diffuse: bool,
    },
    /// Ambient light.
    Ambient,
    /// The background, which is scattered by no surface.
    Background,
}

/// A pattern of classes such as `LDSE`, `L(D|S)E`, `L.S*E`, `BS¹²E`.
#[derive(Clone, Debug)]
pub struct Class {
    text: String,
    pattern: Pattern,
}

/// What is wrong with a pattern.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "`{}` is no class of paths, expected such as LDSE, L(D|S)E or LDS*E: L a light, A ambient light or B the background, D or S the first surface, S each further one, E the eye",
    crate::files::escape::escape_hidden(.0)
)]
pub struct ClassError(pub String);

#[derive(Clone, Debug)]
enum Pattern {
    Letter(u8),
    Any,
    Sequence(Vec<Pattern>),
    Either(Vec<Pattern>),
    /// So often at least, and at most.
    Repeated(Box<Pattern>, usize, Option<usize>),
}

const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];

/// A class with this beginning and so many bounces: `LDSE`; many are written as a power, `BS¹²E`.
pub fn class_word(beginning: &str, bounces: usize) -> String {
    const FEW: usize = 3;
    if bounces <= FEW {
        return format!("{beginning}{}E", "S".repeat(bounces));
    }
    let digits = bounces.to_string();
    let raised = digits.bytes().map(|digit| RAISED[usize::from(digit - b'0')]);
    format!("{beginning}S{}E", raised.collect::<String>())
}

impl Emitter {
    /// The letters of the light and of the first surface.
    pub fn letters(self) -> &'static str {
        match self {
            Emitter::Light { is_diffuse: true, .. } => "LD",
            Emitter::Light { is_diffuse: false, .. } => "LS",
            Emitter::Ambient => "A",
            Emitter::Background => "B",
        }
    }
}

impl Class {
    /// As it was written.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Whether paths are meant that begin with these letters and bounce so often.
    pub fn matches(&self, beginning: &str, bounces: usize) -> bool {
        let mut word = beginning.as_bytes().to_vec();
        word.resize(beginning.len() + bounces, b'S');
        word.push(b'E');
        self.pattern.ends(&word, &[0]).contains(&word.len())
    }
}

impl PartialEq for Class {
    fn eq(&self, other: &Class) -> bool {
        self.text == other.text
    }
}

impl Eq for Class {}

impl fmt::Display for Class {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl FromStr for Class {
    type Err = ClassError;

    fn from_str(text: &str) -> Result<Class, ClassError> {
        const LONGEST: usize = 100;
        let wrong = || ClassError(text.to_owned());
        let mut rest: Vec<char> = text.chars().collect();
        if rest.is_empty() || rest.len() > LONGEST {
            return Err(wrong());
        }
        rest.reverse();
        let pattern = either(&mut rest).filter(|_| rest.is_empty()).ok_or_else(wrong)?;
        Ok(Class { text: text.to_owned(), pattern })
    }
}

/// Alternatives, up to the end or a closing bracket; the characters are taken from the end of the list.
fn either(rest: &mut Vec<char>) -> Option<Pattern> {
    let mut ways = vec![sequence(rest)?];
    while rest.last() == Some(&'|') {
        rest.pop();
        ways.push(sequence(rest)?);
    }
    Some(Pattern::Either(ways))
}

fn sequence(rest: &mut Vec<char>) -> Option<Pattern> {
    let mut parts = Vec::new();
    while let Some(next) = rest.last().copied().filter(|next| !matches!(next, '|' | ')')) {
        rest.pop();
        let part = match next {
            'L' | 'A' | 'B' | 'D' | 'S' | 'E' => Pattern::Letter(next as u8),
            '.' => Pattern::Any,
            '(' => {
                let inside = either(rest)?;
                rest.pop().filter(|end| *end == ')')?;
                inside
            }
            _ => return None,
        };
        parts.push(repeated(part, rest)?);
    }
    (!parts.is_empty()).then_some(Pattern::Sequence(parts))
}

fn repeated(part: Pattern, rest: &mut Vec<char>) -> Option<Pattern> {
    const MOST: usize = 1000;
    let digit = |c: char| RAISED.iter().position(|raised| *raised == c);
    let (least, most) = match rest.last().copied() {
        Some('*') => (0, None),
        Some('+') => (1, None),
        Some('?') => (0, Some(1)),
        Some(first) if digit(first).is_some() => {
            let mut count = 0;
            while let Some(next) = rest.last().copied().and_then(digit) {
                count = count * 10 + next;
                if count > MOST {
                    return None;
                }
                rest.pop();
            }
            return Some(Pattern::Repeated(Box::new(part), count, Some(count)));
        }
        _ => return Some(part),
    };
    rest.pop();
    Some(Pattern::Repeated(Box::new(part), least, most))
}

impl Pattern {
    /// Where it can end that begins at one of these places, in ascending order. All of them go on together, so that a pattern takes no more steps
    /// than there are letters, however it is nested.
    fn ends(&self, word: &[u8], starts: &[usize]) -> Vec<usize> {
        let behind = |is_it: &dyn Fn(u8) -> bool| {
            let found = starts.iter().filter(|start| word.get(**start).is_some_and(|letter| is_it(*letter)));
            found.map(|start| start + 1).collect()
        };
        match self {
            Pattern::Letter(letter) => behind(&|found| found == *letter),
            Pattern::Any => behind(&|_| true),
            Pattern::Sequence(parts) => parts.iter().fold(starts.to_vec(), |starts, part| part.ends(word, &starts)),
            Pattern::Either(ways) => united(ways.iter().flat_map(|way| way.ends(word, starts)).collect()),
            Pattern::Repeated(part, least, most) => {
                let mut now = starts.to_vec();
                for _ in 0..*least {
                    let next = part.ends(word, &now);
                    // Nothing is left, or once more makes no difference.
                    if next == now {
                        break;
                    }
                    now = next;
                }
                let mut found = now.clone();
                // Once more as often as it may be, until nothing new is reached.
                for _ in *least..most.unwrap_or(least + word.len() + 1) {
                    now = part.ends(word, &now);
                    now.retain(|end| !found.contains(end));
                    if now.is_empty() {
                        break;
                    }
                    found.extend(&now);
                }
                united(found)
            }
        }
    }
}

fn united(mut ends: Vec<usize>) -> Vec<usize> {
    ends.sort_unstable();
    ends.dedup();
    ends
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[track_caller]
    fn matched(pattern: &str, expected: &[&str]) {
        let class: Class = pattern.parse().unwrap();
        let all = (0..13).flat_map(|bounces| ["LD", "LS", "A", "B"].map(|beginning| (beginning, bounces)));
        let found: Vec<_> = all.filter(|(beginning, bounces)| class.matches(beginning, *bounces)).collect();
        let found: Vec<_> = found.into_iter().map(|(beginning, bounces)| class_word(beginning, bounces)).collect();
        assert_eq!(found, expected, "{pattern}");
    }

    #[test]
    fn patterns() {
        matched("LDE", &["LDE"]);
        matched("L(D|S)E", &["LDE", "LSE"]);
        matched("LDS?E", &["LDE", "LDSE"]);
        matched("BS¹²E", &["BS¹²E"]);
        matched("LDDE", &[]);
        matched("(AS)+E", &["ASE"]);
        matched("(S*)*", &[]);
        matched("L(D|S)(S?)³E", &["LDE", "LSE", "LDSE", "LSSE", "LDSSE", "LSSSE", "LDSSSE", "LSSSSE"]);
    }

    /// They would take 10¹² steps one by one.
    #[test]
    fn nested_powers_end() {
        let class: Class = "LD((((S?)¹⁰⁰⁰)¹⁰⁰⁰)¹⁰⁰⁰)¹⁰⁰⁰E".parse().unwrap();
        assert!(class.matches("LD", 250) && !class.matches("LS", 250));
        let class: Class = "LD((((S*)+)*S¹⁰⁰⁰)¹⁰⁰⁰)¹⁰⁰⁰E".parse().unwrap();
        assert!(!class.matches("LD", 250));
    }

    #[test]
    fn what_is_no_pattern() {
        for text in [
            "",
            "lde",
            "L(DE",
            "LD)E",
            "*E",
            "L||E",
            "LD E",
            "LS⁹⁹⁹⁹E",
            "()",
            "L{2}E",
            &"S".repeat(101),
            &"(".repeat(90),
        ] {
            assert!(text.parse::<Class>().is_err(), "{text}");
        }
    }
}
