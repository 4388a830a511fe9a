//! The comparison of two logs for people.

use super::summary::{Pixel, Summary};
use super::{Changed, Comparison, Difference, Entry, First, Format, HeaderDifference, Side, Statement, Why};
use super::{header_differences, telling_apart};
use crate::files::escape::shortened;
use crate::log::Header;
use crate::log::table::aligned;
use crate::report::language::Language;
use crate::report::number::size;
use crate::report::words;
use std::cmp::Ordering;
use std::collections::BTreeSet;

/// Writes a comparison piece by piece: what the logs are, then each pixel, then the summary.
#[derive(Clone, Debug)]
pub struct Text {
    /// To how many decimals values were rounded before they were compared; without it they are shown with as many as tell them
    /// apart.
    digits: Option<u32>,
    /// Whether to leave the tables out.
    is_brief: bool,
    /// Whether a difference was shown already.
    has_first: bool,
    /// The headers of both logs, once they are known.
    of: Option<Box<[Header; 2]>>,
    /// Whether the logs are of different arithmetics, so that the same operands give different values.
    is_rounded_otherwise: bool,
    /// What the headers say differently of the scene and its tracing: the fields, or only the digest.
    headers: Vec<&'static str>,
    /// The inputs of the scene that were reported already.
    told: BTreeSet<String>,
    /// How many pixels only A had so far, and only B.
    alone: [u64; 2],
}

/// The most pixels of one log alone that are named; the summary counts all of them.
const MOST_ALONE: u64 = 8;

/// The columns of a table: where, which quantity, its symbol, A, B, the absolute and the relative difference, the cause.
type Row = [String; 8];

impl Format for Text {
    fn begin(&mut self, a: &Header, b: &Header, differences: &[HeaderDifference]) -> String {
        *self = self.clone().between(a, b);
        let mut out = String::new();
        for (letter, header) in [("A", a), ("B", b)] {
            let scene = words::plain(&header.scene.name);
            let subject = words::subject_in_frame(Language::English, header);
            out += &format!("{letter}: {scene} · {subject} · {}\n", words::arithmetic(header));
        }
        for HeaderDifference { field, a, b } in differences {
            // The beginning of a digest tells it from others.
            let [a, b] = [a, b].map(|said| if *field == "scene.digest" { shortened(said, 20) } else { said.clone() });
            out += &format!("note: {field}: {a} against {b}\n");
        }
        out
    }

    fn pixel(&mut self, pixel: Pixel, found: &Comparison) -> String {
        let mut out = String::new();
        if let (Some(first), false) = (&found.first, self.has_first) {
            self.has_first = true;
            out += &self.first(pixel, first);
        }
        out += &self.changed(&found.changed);
        if self.is_brief || found.differences.is_empty() {
            return out;
        }
        let of_pixel = called(pixel).map_or(String::new(), |pixel| format!(" of {pixel}"));
        out += &format!("\nDifferences{of_pixel}\n");
        let heads = ["where", "quantity", "symbol", "A", "B", "difference", "relative", "from"].map(str::to_owned);
        let rows = found.differences.iter().map(|difference| {
            let [place, quantity, symbol, a, b, absolute, relative] = self.cells(&difference.entry);
            [place, quantity, symbol, a, b, absolute, relative, self.cause(difference)]
        });
        let rows: Vec<_> = [heads].into_iter().chain(rows).collect();
        out += &table(rows);
        if found.way.len() > 1 {
            out += &format!("\nThe way to the colour{of_pixel}, along the largest effect of an operand\n");
            let rows = found.way.iter().map(|entry| {
                let [place, quantity, symbol, a, b, absolute, relative] = self.cells(entry);
                [place, quantity, symbol, a, b, absolute, relative, String::new()]
            });
            out += &table(without_middle(rows.collect()));
        }
        out
    }

    fn alone(&mut self, pixel: Pixel, side: Side) -> String {
        if self.is_brief {
            return String::new();
        }
        let count = &mut self.alone[side as usize];
        *count += 1;
        let letter = side.letter();
        match (*count).cmp(&(MOST_ALONE + 1)) {
            Ordering::Less => format!("Only in {letter}: {}\n", called(pixel).unwrap_or_else(|| "a ray".to_owned())),
            Ordering::Equal => format!("Only in {letter}: further pixels, counted below\n"),
            Ordering::Greater => String::new(),
        }
    }

    fn end(&self, summary: &Summary) -> String {
        if summary.is_same() {
            let pixels = if summary.pixels > 1 { format!(" in {} pixels", summary.pixels) } else { String::new() };
            return format!("\nThe same: {} values compared{pixels}, none differs\n", summary.values);
        }
        let mut out = String::from("\nSummary\n");
        if summary.pixels + summary.pixels_only_in_a + summary.pixels_only_in_b > 1 {
            out += &format!(
                "  pixels: {} compared, {} differ; {} only in A, {} only in B\n",
                summary.pixels, summary.differing_pixels, summary.pixels_only_in_a, summary.pixels_only_in_b
            );
        }
        out += &format!("  values: {} compared, {} differ\n", summary.values, summary.differing_values);
        out += &format!(
            "  decisions that differ: {}; steps only in A: {}, only in B: {}\n",
            summary.decisions, summary.only_in_a, summary.only_in_b
        );
        let largest = [
            ("largest difference", &summary.largest, 5),
            ("largest relative difference", &summary.largest_relative, 6),
        ];
        for (called, largest, column) in largest {
            let Some((pixel, entry)) = largest else { continue };
            let pixel = self::called(*pixel).filter(|_| summary.pixels > 1);
            let place = [pixel.unwrap_or_default(), place(entry)].into_iter().filter(|part| !part.is_empty());
            let place = place.collect::<Vec<_>>().join(", ");
            let size = &self.cells(entry)[column];
            out += &format!("  {called}: {size} ({}{})\n", label(entry), in_place(&place));
        }
        out
    }
}

impl Text {
    /// Begins a comparison. Values are shown with `digits` decimals, or with as many as tell them apart; a brief comparison has no
    /// tables.
    pub fn new(digits: Option<u32>, is_brief: bool) -> Text {
        Text {
            digits,
            is_brief,
            has_first: false,
            of: None,
            is_rounded_otherwise: false,
            headers: Vec::new(),
            told: BTreeSet::new(),
            alone: [0; 2],
        }
    }

    /// The same between these logs.
    pub fn between(self, a: &Header, b: &Header) -> Text {
        // What is traced, by what and in which arithmetic, is no change of the scene.
        const NONE: [&str; 5] = ["subject", "version", "scene.name", "arithmetic", "shard"];
        let differing = header_differences(a, b).into_iter().map(|said| said.field);
        let mut headers: Vec<_> = differing.filter(|field| !NONE.contains(field)).collect();
        // The digest covers the others.
        if headers.len() > 1 {
            headers.retain(|field| *field != "scene.digest");
        }
        let of = Some(Box::new([a.clone(), b.clone()]));
        Text { of, is_rounded_otherwise: a.arithmetic != b.arithmetic, headers, ..self }
    }

    /// The inputs of the scene that differ, each in the first pixel that has it.
    fn changed(&mut self, changed: &[Changed]) -> String {
        let mut lines = String::new();
        for made in changed {
            if self.told.insert(made.input.clone()) {
                lines += &format!("  {}\n", change(made));
            }
        }
        if lines.is_empty() { lines } else { format!("\nChanged in the scene\n{lines}") }
    }

    fn first(&self, pixel: Pixel, first: &First) -> String {
        let Some(entry) = first.way.first() else { return String::new() };
        let place = [called(pixel).unwrap_or_default(), place(entry)].into_iter().filter(|part| !part.is_empty());
        let place = place.collect::<Vec<_>>().join(", ");
        let lines: String = self.explanation(first).iter().map(|line| format!("  {line}\n")).collect();
        format!("\nFirst divergence{}: {}\n{lines}", in_place(&place), label(entry))
    }

    /// A difference in full, a line each: what both logs have, where it comes from, how both compute it, the way back.
    pub fn explanation(&self, First { computations, way, why, kind }: &First) -> Vec<String> {
        let (Some(first), Some(origin)) = (way.first(), way.last()) else { return Vec::new() };
        let [_, _, symbol, a, b, ..] = self.cells(first);
        let because = kind.as_ref().map_or_else(|| self.reason(*why), change);
        let from = if way.len() > 1 { format!("from {}", label_from(origin, first)) } else { because.clone() };
        let mut lines = match &first.what {
            Statement::Value { .. } if symbol.is_empty() => vec![format!("{a} against {b}: {from}")],
            Statement::Value { .. } => vec![format!("{symbol}: {a} against {b}: {from}")],
            Statement::Decision { a, b } => vec![format!("A: {a}"), format!("B: {b}"), from],
            Statement::Only { side, .. } => vec![format!("only in {}: {from}", side.letter())],
        };
        if let Some([a, b]) = computations {
            lines.extend([format!("A: {a}"), format!("B: {b}")]);
        }
        if way.len() > 1 {
            let steps: Vec<_> = way.iter().map(|step| label_from(step, first)).collect();
            lines.push(format!("traced back: {} ({because})", steps.join(" ← ")));
        }
        lines
    }

    fn cells(&self, entry: &Entry) -> [String; 7] {
        let [quantity, symbol, a, b, absolute, relative] = match &entry.what {
            Statement::Value { name, a, b, distance, .. } => {
                let style = telling_apart(a, b, self.digits);
                let symbol = name.map_or("", |name| name.symbol()).to_owned();
                let styles = self.of.as_ref().map_or([style; 2], |of| of.each_ref().map(|header| style.within(header)));
                let [a, b] =
                    [(a, styles[0]), (b, styles[1])].map(|(value, style)| Language::English.value(value, style));
                [label(entry), symbol, a, b, size(distance.absolute), size(distance.relative)]
            }
            Statement::Decision { a, b } => ["decision", "", a, b, "", ""].map(str::to_owned),
            Statement::Only { side, what, values } => {
                let what = if *values > 1 { format!("{what} ({values} values)") } else { what.clone() };
                let [a, b] = match side {
                    Side::A => [what, "–".to_owned()],
                    Side::B => ["–".to_owned(), what],
                };
                [format!("only in {}", side.letter()), String::new(), a, b, String::new(), String::new()]
            }
        };
        [place(entry), quantity, symbol, a, b, absolute, relative]
    }

    /// The cause of a difference: the operands that it comes from, and where that comes from in the end.
    fn cause(&self, difference: &Difference) -> String {
        let Difference { entry, why, from, origin, kind, .. } = difference;
        let direct: Vec<String> = match why {
            Why::Operands => {
                // Those that come near the largest.
                let largest = from.first().map_or(0.0, |(_, effect)| *effect);
                let large = from.iter().filter(|(_, effect)| *effect * 2.0 >= largest);
                let symbols: Vec<_> = large.map(|(operand, _)| symbol(operand)).collect();
                let more = symbols.len().saturating_sub(MOST_OPERANDS);
                let named = symbols.into_iter().take(MOST_OPERANDS);
                named.chain((more > 0).then(|| format!("{more} more"))).collect()
            }
            // What the change of the scene did on the way says no more than the change.
            Why::Before | Why::OtherKind if kind.is_some() => Vec::new(),
            Why::Before => from.iter().take(1).map(|(before, _)| label_from(before, entry)).collect(),
            _ => vec![self.reason(*why)],
        };
        let direct = direct.join(", ");
        let origin = match kind {
            Some(kind) => Some(change(kind)),
            None => origin.as_ref().map(|origin| label_from(origin, entry)),
        };
        match origin.filter(|origin| *origin != direct) {
            Some(origin) if direct.is_empty() => origin,
            Some(origin) => format!("{direct} ← {origin}"),
            None => direct,
        }
    }

    fn reason(&self, why: Why) -> String {
        if why == Why::First && !self.headers.is_empty() {
            return format!("the headers differ in {}, nothing before it in the logs", self.headers.join(", "));
        }
        let reason = match why {
            Why::Operands => "its operands",
            Why::Itself if self.is_rounded_otherwise => "its own rounding",
            Why::Itself => "itself, no operand explains it",
            Why::OtherFormula => "another formula",
            Why::Input => "an input",
            Why::Before => "what was before",
            Why::First => "nothing before it differs",
            Why::OtherKind => "it is of another kind",
            Why::NoSuchObject => "the other scene has no such object",
            Why::NotNeeded => "not needed there (`trace --tests all` logs every test)",
        };
        reason.to_owned()
    }
}

impl Side {
    /// The letter of the log.
    pub fn letter(self) -> char {
        match self {
            Side::A => 'A',
            Side::B => 'B',
        }
    }
}

/// The path of the ray and the node: `C R, test sphere`.
fn place(entry: &Entry) -> String {
    let parts = [&entry.path, &entry.node].into_iter().filter(|part| !part.is_empty());
    parts.cloned().collect::<Vec<_>>().join(", ")
}

/// A change of the scene: `objects.ball: sphere → box`.
fn change(Changed { input, a, b }: &Changed) -> String {
    format!("{input}: {a} → {b}")
}

fn in_place(place: &str) -> String {
    if place.is_empty() { String::new() } else { format!(" in {place}") }
}

fn called(pixel: Pixel) -> Option<String> {
    pixel.map(|[x, y]| format!("pixel {x},{y}"))
}

/// What an entry is about, in a few words.
fn label(entry: &Entry) -> String {
    match &entry.what {
        Statement::Value { name: Some(name), .. } => name.key().to_owned(),
        Statement::Value { name: None, .. } if entry.node.is_empty() && entry.path.is_empty() => "result".to_owned(),
        Statement::Value { name: None, .. } => "what passes".to_owned(),
        Statement::Decision { a, b } => format!("“{a}” against “{b}”"),
        Statement::Only { side, what, .. } => format!("{what}, only in {}", side.letter()),
    }
}

/// The same with its ray.
pub(super) fn label_with_path(entry: &Entry) -> String {
    if entry.path.is_empty() { label(entry) } else { format!("{} ({})", label(entry), entry.path) }
}

/// The same with its ray, if that is another one than that of `of`.
fn label_from(entry: &Entry, of: &Entry) -> String {
    let elsewhere = Some(&entry.path).filter(|path| **path != of.path && !path.is_empty());
    elsewhere.map_or_else(|| label(entry), |path| format!("{} ({path})", label(entry)))
}

fn symbol(entry: &Entry) -> String {
    match &entry.what {
        Statement::Value { name: Some(name), .. } => name.symbol().to_owned(),
        _ => label(entry),
    }
}

/// Long ways without their middle.
fn without_middle(mut rows: Vec<Row>) -> Vec<Row> {
    const ENDS: usize = 20;
    let left_out = rows.len().saturating_sub(2 * ENDS);
    if left_out > 1 {
        let mut row = Row::default();
        row[0] = format!("… {left_out} more …");
        rows.splice(ENDS..ENDS + left_out, [row]);
    }
    rows
}

/// The most operands of a value that are named.
const MOST_OPERANDS: usize = 200;

fn table(rows: Vec<Row>) -> String {
    aligned(rows, |_| false).iter().map(|line| format!("  {line}\n")).collect()
}
