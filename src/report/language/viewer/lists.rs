//! The lists that lie over the panes: their titles, their columns, and what keys do in them.

use super::super::OfName;

/// The texts of lists.
pub struct Lists {
    /// What keys do in them.
    pub hints: Hints,
    /// Where runs stop.
    pub breakpoints: List<&'static str, 2>,
    /// A breakpoint that is on.
    pub on: &'static str,
    /// One that is off.
    pub off: &'static str,
    /// Where they stopped.
    pub stops: List<&'static str, 4>,
    /// The bookmarks.
    pub bookmarks: List<&'static str, 3>,
    /// A bookmark in a pixel of a region, and what is there.
    pub in_pixel: fn([u32; 2], &str) -> String,
    /// A bookmark that leads nowhere.
    pub not_in_this_log: &'static str,
    /// What a value is made of.
    pub operands: List<OfName, 3>,
    /// An input of a node.
    pub given_in: OfName,
    /// What takes a value.
    pub uses: List<OfName, 2>,
    /// A step by its number.
    pub step: fn(usize) -> String,
    /// Why a pixel has its colour.
    pub account: Account,
    /// The values of a node in several arithmetics.
    pub arithmetics: Arithmetics,
    /// Why a list can't be shown yet.
    pub to_come: ToCome,
}

/// The texts of a list, with a title and so many columns.
pub struct List<Title, const COLUMNS: usize> {
    /// What it is of.
    pub title: Title,
    /// What stands in its columns.
    pub columns: [&'static str; COLUMNS],
    /// What is said where it has no entries.
    pub nothing: &'static str,
}

/// What keys do in lists, from the longest way to say it to the shortest.
pub struct Hints {
    /// In a list of places.
    pub usual: [&'static str; 2],
    /// And where lines are cut.
    pub cut: [&'static str; 2],
    /// Where besides no line leads anywhere.
    pub cut_plain: &'static str,
    /// Where nothing else fits.
    pub closes: &'static str,
    /// In that of breakpoints.
    pub breakpoints: [&'static str; 4],
}

/// The texts of why a pixel has its colour.
pub struct Account {
    /// Its title with the colour, its columns.
    pub list: List<OfName, 9>,
    /// Its title where the log ends before the colour.
    pub so_far: OfName,
    /// Behind the title, the class of the path of the selected ray.
    pub here: OfName,
    /// The ways of figure 14 as [`cases`](crate::report::path_class::cases) has them, with its words in the language.
    pub cases: fn(&str) -> &str,
    /// So many smaller contributions in one.
    pub smaller: fn(usize) -> String,
    /// The heading of so many paths that bring nothing.
    pub brings_nothing: fn(usize) -> String,
}

/// The texts of the values of a node in several arithmetics.
pub struct Arithmetics {
    /// Its title with the node, its columns: by hand, f32, the digits, f64.
    pub list: List<OfName, 5>,
    /// What stands in place of a value.
    pub not_reached: &'static str,
    /// What stands in place of the number of digits.
    pub decided_otherwise: &'static str,
    /// The three arithmetics in a sentence.
    pub names: [&'static str; 3],
    /// An arithmetic doesn't reach the node.
    pub never_reached: OfName,
    /// It decides otherwise in it.
    pub other_decisions: OfName,
}

/// Why a list can't be shown yet while the tree grows.
pub struct ToCome {
    /// The colour isn't known.
    pub color: &'static str,
    /// The node isn't complete.
    pub node: &'static str,
    /// What takes a value comes after it.
    pub uses: &'static str,
}
