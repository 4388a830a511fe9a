//! A close-up of one hit, as figures of the source text show it: its vectors in the planes in which they lie (figures 10 to 13), the
//! zones of a blurred bounce (figure 22), the points of an area light with the weights of their shadow rays (section 1.5).
//!
//! Everything comes from the log: what a figure needs and the log lacks isn't drawn. A close-up is a table and some sheets; one file a
//! view, one file a format.

mod hit;
mod labels;
mod light;
mod one_plane;
mod sheet;
mod svg;
mod table;
mod tikz;
mod vectors;
mod zones;

pub use light::light;
pub use one_plane::{Arrow, Bend, OnePlane, one_plane};
pub use sheet::{Ink, Piece, Point, Sheet};
pub use svg::svg;
pub use table::text;
pub use tikz::latex;
pub use vectors::vectors;
pub use zones::zones;

use super::Style;
use super::language::Language;
use crate::log::{Log, Tree};
use thiserror::Error;

/// What a close-up is made of.
#[derive(Clone, Copy)]
pub struct Subject<'a> {
    /// The log.
    pub log: &'a Log,
    /// Its tree.
    pub tree: &'a Tree,
    /// The ray whose hit is shown, by its path (`C R`); without it the first ray whose hit has what the view shows.
    pub path: Option<&'a str>,
    /// The language of the texts.
    pub language: Language,
    /// How numbers are shown.
    pub style: Style,
}

/// A close-up of a hit.
#[derive(Clone, Debug, PartialEq)]
pub struct CloseUp {
    /// What it shows, and of what.
    pub title: String,
    /// How the figure is to be read.
    pub note: String,
    /// The heads of the table.
    pub columns: Vec<String>,
    /// Its rows.
    pub rows: Vec<Vec<String>>,
    /// The figures.
    pub sheets: Vec<Sheet>,
}

/// Why there is nothing to be shown.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum CloseUpError {
    /// No ray has this path.
    #[error("expected the path of a ray in the log ({known}), found `{path}`")]
    NoRay {
        /// The path.
        path: String,
        /// Some that there are.
        known: String,
    },
    /// The ray, or every ray, lacks it.
    #[error("expected {expected}, found none on {rays}")]
    Nothing {
        /// What the view shows.
        expected: &'static str,
        /// Where it was looked for.
        rays: String,
    },
}

impl Subject<'_> {
    /// The first of the rays in question that has what a view shows.
    fn first<T>(&self, expected: &'static str, of: impl Fn(usize) -> Option<T>) -> Result<(usize, T), CloseUpError> {
        let rays = hit::rays(self.tree);
        let Some(path) = self.path else {
            let found = rays.into_iter().find_map(|ray| of(ray).map(|found| (ray, found)));
            return found.ok_or_else(|| CloseUpError::Nothing { expected, rays: "any ray".to_owned() });
        };
        let Some(ray) = rays.iter().copied().find(|ray| self.tree.path(*ray) == path) else {
            let known: Vec<_> = rays.iter().take(MOST_KNOWN).map(|ray| self.tree.path(*ray)).collect();
            return Err(CloseUpError::NoRay { path: path.to_owned(), known: known.join(", ") });
        };
        let found = of(ray).ok_or_else(|| CloseUpError::Nothing { expected, rays: format!("the ray {path}") })?;
        Ok((ray, found))
    }
}

/// How many paths an error names.
const MOST_KNOWN: usize = 12;
