//! Logs: read in every way, written and read again, looked at in every view, compared with themselves.

use super::is_short;
use raywalk::log::file::{Ending, PixelReader, read, to_json, to_ndjson};
use raywalk::log::{Events, Log, Tree};
use raywalk::report::diff::{self, Format, Json, Numbering, Rows, Summary, Text, Tolerance};
use raywalk::report::language::Language;
use raywalk::report::ray_tree::{self, Figure};
use raywalk::report::schematic::Stage;
use raywalk::report::side_by_side::Run;
use raywalk::report::solution::{self, Task};
use raywalk::report::{Style, contributions, lines, outline, provenance, segments, text};
use raywalk::tui::{self, Options, Palette, Theme};

/// A log as lines or as a document.
pub fn log(bytes: &[u8]) {
    let found = match read(bytes) {
        Ok(found) => found,
        Err(error) => return is_short(&error.to_string(), 1000),
    };
    is_short(&found.ending.warning().unwrap_or_default(), 1000);
    let log = found.log;
    comes_pixel_by_pixel(bytes, &log.events, &found.ending);
    is_written_as_it_is(&log);
    is_seen(&log);
    is_walked_through(&log, bytes.len());
    differs_in_nothing_from_itself(log);
}

/// A log that is read a pixel at a time has the same events.
fn comes_pixel_by_pixel(bytes: &[u8], events: &Events, ending: &Ending) {
    let mut reader = PixelReader::open(bytes).expect("it was read as a whole");
    let mut left = events.iter();
    while let Some(pixel) = reader.next_pixel().expect("it was read as a whole") {
        for event in &pixel.events {
            // Those that open a pixel aren't passed on.
            assert!(left.any(|other| events.says_as(other, &pixel.events, event)), "{event:?}");
        }
    }
    assert_eq!(reader.ending(), Some(ending));
}

fn is_written_as_it_is(log: &Log) {
    let lines = to_ndjson(log).expect("there is memory");
    let again = read(&lines).expect("what was written can be read");
    assert_eq!(again.ending, Ending::Complete, "{}", String::from_utf8_lossy(&lines));
    assert_eq!(&again.log, log);
    let document = to_json(log).expect("there is memory");
    let again = read(&document);
    let again = again.unwrap_or_else(|error| panic!("{error}\n{}", String::from_utf8_lossy(&document)));
    assert_eq!(again.ending, Ending::Complete, "{}", String::from_utf8_lossy(&document));
    assert_eq!(&again.log, log);
}

fn is_seen(log: &Log) {
    let tree = Tree::of(&log.events);
    let style = Style::default();
    for language in [Language::English, Language::Spanish] {
        is_text(&text::text(language, log, style));
    }
    is_text(&outline::outline(log, style));
    let drawn = lines::rays(log);
    is_text(&lines::obj(&log.header, &drawn));
    is_text(&lines::ply(&log.header, &drawn));
    let rays = ray_tree::branches(log, &tree, 0);
    let calls = ray_tree::calls(log, &tree, rays.clone());
    for branches in [&rays, &calls] {
        let figure = Figure { log, branches, language: Language::English, style };
        for write in [ray_tree::dot, ray_tree::svg, ray_tree::svg_of, ray_tree::mermaid, ray_tree::tikz] {
            is_text(&write(&figure));
        }
    }
    let stage = Stage { wireframes: &[], upright: 1 };
    for write in [solution::markdown, solution::latex, solution::html] {
        is_text(&write(&Task { log, tree: &tree, stage, language: Language::Spanish, style }));
    }
    contributions::account(log, &tree, 0);
    segments::segments(log, &tree, 0, 100);
    for event in 0..log.events.len() {
        provenance::operands(log, &tree, event);
    }
}

/// The viewer, after keys that open its panes and go through the log: which ones, the length of the file says, since each
/// takes longer than all other views together.
fn is_walked_through(log: &Log, length: usize) {
    const KEYS: [&str; 8] =
        ["", "nnnnlljjj<Space>nNp", "GGkkkhhg", "/a<Enter>nnn", "?", "<Tab>jj<Enter>", "tttvvvccc", "bbbnnn"];
    let theme = Theme::new(Palette::None, false);
    let options = Options {
        theme,
        start: None,
        warning: None,
        controls: Default::default(),
        note: None,
        numbers: Style::default(),
        language: Language::default(),
    };
    let picture = tui::picture(log.clone(), &options, None, KEYS[length % KEYS.len()], (80, 24));
    assert!(picture.contains("</svg>"));
}

/// Names of a log may hold nothing that drives a terminal, and no view may add it.
fn is_text(text: &str) {
    let odd = text.chars().find(|c| c.is_control() && !matches!(c, '\n' | '\t'));
    assert_eq!(odd, None);
}

fn differs_in_nothing_from_itself(log: Log) {
    assert!(diff::header_differences(&log.header, &log.header).is_empty());
    let mut other = log.clone();
    Numbering::unify(&log.header, &mut other.header).apply(&mut other.events);
    let (tree, other_tree) = (Tree::of(&log.events), Tree::of(&other.events));
    let (a, b) = (Run { log: &log, tree: &tree }, Run { log: &other, tree: &other_tree });
    for tolerance in [Tolerance::default(), Tolerance { digits: Some(3), ..Tolerance::default() }] {
        let found = diff::compare(a, b, &tolerance);
        assert!(found.differences.is_empty(), "{:?}", found.differences);
        let mut summary = Summary::default();
        summary.add(None, &found);
        assert!(summary.is_same());
        assert_eq!(Text::new(None, false).pixel(None, &found), "");
        Json::new(false).pixel(None, &found);
        let rows = Rows::of(a, b, tolerance);
        rows.rows().iter().take(50).for_each(|row| drop(rows.cells(row)));
    }
}
