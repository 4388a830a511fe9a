//! A worked example of somebody's own, written as a table, and checked by the rules of the book: each number from those before it, by
//! hand.

use super::follow::{Listed, Place, Values};
use super::{DIGITS, Verdict, agreement, exact, middle, place_of};
use crate::files::suggest;
use crate::log::words::words;
use crate::log::{Name, Value};
use crate::probe::Printed;
use crate::record::{self, Arithmetic};
use crate::scene::Scene;
use std::borrow::Cow;

/// The largest table that is read.
pub const MAX_TABLE_BYTES: u64 = 1 << 20;

/// The largest number in one: its square is finite.
pub const MAX_PRINTED: f64 = 1e100;

/// What a printed value may be.
const VALUES: &str = "expected a number such as 6.377 or a triple such as \"(14.139, 9.376, 8.847)\"";

/// The most rows of one.
pub const MAX_ROWS: usize = 4096;

/// A table of quantities and the values that are printed for them.
#[derive(Clone, Debug, PartialEq)]
pub struct Worked {
    rows: Vec<Stated>,
}

/// A row of such a table.
#[derive(Clone, Debug, PartialEq)]
struct Stated {
    line: u64,
    key: &'static str,
    /// The path of the ray, where the table says it.
    path: Option<String>,
    /// Which of the rows with the same key (and path), from 0.
    nth: usize,
    text: String,
    /// Nothing where nothing is printed.
    components: Vec<f64>,
}

/// What is wrong with a table.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum TableError {
    /// It can't be read as a table.
    #[error("{0}")]
    Csv(String),
    /// There is nothing in it to check.
    #[error("expected at least one row with a printed value below the heads `quantity,printed`")]
    Empty,
    /// A line can't be used.
    #[error("line {line}: {what}")]
    Line {
        /// Which one.
        line: u64,
        /// Why.
        what: String,
    },
}

/// What is wrong with a line.
fn wrong(line: u64, what: String) -> TableError {
    TableError::Line { line, what }
}

words! {
    /// In which order the rows of a name go through its occurrences.
    pub Order {
        /// As the book has them: of each name first what the book prints, the mirrored ray's shading before the first surface's.
        Book = "book",
        /// As the walk comes to them.
        Walk = "walk",
    }
}

/// A table with what its rows should be.
#[derive(Clone, Debug, PartialEq)]
pub struct Checked {
    /// The order that fits the rows better.
    pub order: Order,
    /// The rows.
    pub rows: Vec<CheckedRow>,
}

/// A row with what it should be.
#[derive(Clone, Debug, PartialEq)]
pub struct CheckedRow {
    /// The line of the file.
    pub line: u64,
    /// The key of the quantity.
    pub quantity: &'static str,
    /// The path of the ray that it belongs to.
    pub path: String,
    /// What is printed, as it is in the table.
    pub text: String,
    /// Its numbers.
    pub printed: Vec<f64>,
    /// From the listed values before it, and by hand from all others.
    pub recomputed: Vec<f64>,
    /// By hand from the start.
    pub strict: Vec<f64>,
    /// In f64.
    pub exact: Vec<f64>,
    /// Whether it follows.
    pub verdict: Verdict,
}

impl Worked {
    /// Reads a table: comma-separated values with the heads `quantity` and `printed`, and if need be `path`.
    ///
    /// # Errors
    /// [`TableError`] for what is no such table.
    pub fn parse(text: &[u8]) -> Result<Worked, TableError> {
        // What spreadsheets put before UTF-8.
        let text = text.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(text);
        let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(text);
        let heads = reader.headers().map_err(unreadable)?.clone();
        let column = |name: &str| heads.iter().position(|head| head.eq_ignore_ascii_case(name));
        let (Some(quantity), Some(printed)) = (column("quantity"), column("printed")) else {
            let found: Vec<_> = heads.iter().map(|head| format!("`{head}`")).collect();
            let found = found.join(", ");
            return Err(wrong(1, format!("expected the columns `quantity` and `printed`, found {found}")));
        };
        let path = column("path");
        let mut rows: Vec<Stated> = Vec::new();
        for record in reader.records() {
            let record = record.map_err(unreadable)?;
            let line = record.position().map_or(0, csv::Position::line);
            if rows.len() == MAX_ROWS {
                return Err(wrong(line, format!("expected at most {MAX_ROWS} rows")));
            }
            let path = path.and_then(|column| record.get(column)).filter(|path| !path.is_empty()).map(str::to_owned);
            let key = key(record.get(quantity).unwrap_or_default(), line)?;
            let text = record.get(printed).unwrap_or_default().to_owned();
            let components = components(&text).ok_or_else(|| wrong(line, format!("`{text}` is no value, {VALUES}")))?;
            let nth = rows.iter().filter(|row| row.key == key && row.path == path).count();
            rows.push(Stated { line, key, path, nth, text, components });
        }
        if rows.iter().all(|row| row.components.is_empty()) { Err(TableError::Empty) } else { Ok(Worked { rows }) }
    }

    /// Checks the table on the scene of the example.
    ///
    /// # Errors
    /// [`TableError`] where a row fits nothing in the walk.
    pub fn check(&self, scene: &Scene) -> Result<Checked, TableError> {
        let pixel = middle(scene);
        let strict = Values::of(&record::pixel(scene, pixel, Arithmetic::Decimal(DIGITS)));
        let exact = exact(scene, pixel);
        let in_order = |order| self.checked(scene, order, &strict, &exact);
        let (book, walk) = (in_order(Order::Book)?, in_order(Order::Walk)?);
        Ok(if walk.departures().count() < book.departures().count() { walk } else { book })
    }

    fn checked(&self, scene: &Scene, order: Order, strict: &Values, exact: &Values) -> Result<Checked, TableError> {
        let places = self.rows.iter().map(|row| row.place(order, strict)).collect::<Result<Vec<_>, _>>()?;
        let components = |row: &Stated| (!row.components.is_empty()).then(|| row.components.clone());
        let listed: Listed =
            places.iter().zip(&self.rows).filter_map(|(place, row)| Some((place.clone(), components(row)?))).collect();
        let recomputed = Values::following(scene, middle(scene), &listed);
        let row = |(row, place): (&Stated, Place)| {
            let of = |values: &Values| values.components(&place, row.components.len());
            let recomputed = of(&recomputed);
            let verdict = if recomputed.is_empty() {
                NOT_REACHED
            } else if row.components == recomputed {
                agreement(&row.text)
            } else {
                DEPARTS
            };
            let (strict, exact) = (of(strict), of(exact));
            let (text, printed) = (row.text.clone(), row.components.clone());
            CheckedRow {
                line: row.line,
                quantity: place.key,
                path: place.path,
                text,
                printed,
                recomputed,
                strict,
                exact,
                verdict,
            }
        };
        let rows = self.rows.iter().zip(places).filter(|(row, _)| !row.components.is_empty());
        Ok(Checked { order, rows: rows.map(row).collect() })
    }
}

/// A value before it led the walk another way.
const NOT_REACHED: Verdict =
    Verdict::Departs { why: "with the values before it the walk goes another way and doesn't come to this one" };

const DEPARTS: Verdict = Verdict::Departs { why: "the rules give another number from those before it" };

impl Checked {
    /// The rows that don't follow from those before them.
    pub fn departures(&self) -> impl Iterator<Item = &CheckedRow> {
        self.rows.iter().filter(|row| matches!(row.verdict, Verdict::Departs { .. }))
    }
}

impl Stated {
    /// Where the row's quantity is in the walk.
    fn place(&self, order: Order, values: &Values) -> Result<Place, TableError> {
        let is_meant =
            |place: &&Place| place.key == self.key && self.path.as_ref().is_none_or(|path| *path == place.path);
        let mut places: Vec<Place> = values.places().filter(is_meant).cloned().collect();
        if order == Order::Book {
            let rank = |place: &Place| Printed::all().iter().position(|printed| place_of(printed) == *place);
            places.sort_by_key(|place| rank(place).unwrap_or(usize::MAX));
        }
        let Some(place) = places.get(self.nth) else {
            let ray = self.path.as_ref().map(|path| format!(" on the ray `{path}`")).unwrap_or_default();
            let (count, key, number) = (places.len(), self.key, self.nth + 1);
            let what = format!("the walk has {count} of `{key}`{ray}, and this row is number {number}");
            return Err(wrong(self.line, what));
        };
        match (values.at(place), self.components.len()) {
            (_, 0) | (Some(Value::Number(_)), 1) | (Some(Value::Triple(_)), 3) => Ok(place.clone()),
            (Some(Value::Triple(_)), 1) if is_intensity(self.key) => Ok(place.clone()),
            (value, _) => {
                let expected = if let Some(Value::Number(_)) = value { "a number" } else { "a triple" };
                Err(wrong(self.line, format!("`{}` is {expected}, found {}", self.key, self.text)))
            }
        }
    }
}

/// Whether a quantity is a colour, of which red alone may be printed.
fn is_intensity(key: &str) -> bool {
    key == "shade.local" || key.starts_with("combine.")
}

fn unreadable(error: csv::Error) -> TableError {
    TableError::Csv(error.to_string())
}

fn key(found: &str, line: u64) -> Result<&'static str, TableError> {
    Name::all().map(Name::key).find(|key| *key == found).ok_or_else(|| {
        let meant = suggest(found, Name::all().map(Name::key));
        let hint = meant.map(|meant| format!(", did you mean `{meant}`?")).unwrap_or_default();
        wrong(line, format!("unknown quantity `{found}`{hint}"))
    })
}

/// One number or three; nothing for an empty text, and `None` for anything else.
fn components(text: &str) -> Option<Vec<f64>> {
    if text.is_empty() {
        return Some(Vec::new());
    }
    let inner = text.strip_prefix('(').map_or(Some(text), |rest| rest.strip_suffix(')'))?;
    let number = |part: &str| {
        // The sign of books.
        let part: Cow<str> = part.trim().replace('−', "-").into();
        part.parse::<f64>().ok().filter(|x| x.abs() <= MAX_PRINTED)
    };
    let numbers: Vec<f64> = inner.split(',').map(number).collect::<Option<_>>()?;
    matches!(numbers.len(), 1 | 3).then_some(numbers)
}
