//! A close-up as SVG, its sheets beside each other.

use super::{CloseUp, Ink, Piece, Point};
use crate::report::escape::line;
use crate::report::svg;
use std::fmt::Write;

/// The most sheets in a row, the room of the title and of a caption.
const ACROSS: usize = 3;
const HEAD: f64 = 30.0;
const CAPTION: f64 = 26.0;

/// The figure as a file of its own.
pub fn svg(close_up: &CloseUp) -> String {
    let [wide, high] = close_up.sheets.first().map_or([280.0, 0.0], |sheet| sheet.size);
    let high = high + CAPTION;
    let across = close_up.sheets.len().clamp(1, ACROSS);
    let rows = close_up.sheets.len().div_ceil(ACROSS);
    // The note is as wide as its letters.
    let width = (wide * across as f64).max(5.4 * close_up.note.chars().count() as f64 + 20.0);
    let height = HEAD + high * rows as f64 + CAPTION;
    let mut out = svg::file(&svg::begin([width, height], 0, &close_up.title));
    text(&mut out, [width / 2.0, 18.0], &close_up.title, Ink::Black, "font-size=\"14\" ");
    for (number, sheet) in close_up.sheets.iter().enumerate() {
        let (column, row) = ((number % ACROSS) as f64, (number / ACROSS) as f64);
        let left = (width - wide * across as f64) / 2.0 + column * wide;
        line!(out, "<g transform=\"translate({left:.1} {:.1})\">", HEAD + row * high);
        sheet.pieces.iter().for_each(|piece| draw(&mut out, piece));
        text(&mut out, [sheet.size[0] / 2.0, sheet.size[1] + 10.0], &sheet.caption, Ink::Black, "");
        line!(out, "</g>");
    }
    text(&mut out, [width / 2.0, height - 12.0], &close_up.note, Ink::Viewer, "font-size=\"11\" ");
    line!(out, "</svg>");
    out
}

fn draw(out: &mut String, piece: &Piece) {
    match piece {
        Piece::Line { from, to, ink, dashed } => stroke(out, *from, *to, *ink, if *dashed { "4 3" } else { "" }, 1.2),
        Piece::Arrow { from, to, ink } => {
            stroke(out, *from, *to, *ink, "", 2.0);
            line!(out, "<polygon points=\"{}\" fill=\"#{}\"/>", svg::points(&tip(*from, *to), 2), ink.hex());
        }
        Piece::Path { points, ink, is_area } => {
            let points = svg::points(points, 2);
            let (element, fill) = if *is_area { ("polygon", "#f6f8fb") } else { ("polyline", "none") };
            line!(out, "<{element} points=\"{points}\" fill=\"{fill}\" stroke=\"#{}\"/>", ink.hex());
        }
        Piece::Dot { at: [x, y], radius, ink, filled } => {
            let fill = if *filled { ink.hex() } else { "ffffff" };
            line!(
                out,
                "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"{radius:.2}\" fill=\"#{fill}\" stroke=\"#{}\" stroke-width=\"1.4\"/>",
                ink.hex()
            );
        }
        Piece::Text { at, text: words, ink } => text(out, *at, words, *ink, ""),
    }
}

fn stroke(out: &mut String, [x1, y1]: Point, [x2, y2]: Point, ink: Ink, dashes: &str, width: f64) {
    let dashes = if dashes.is_empty() { String::new() } else { format!(" stroke-dasharray=\"{dashes}\"") };
    line!(
        out,
        "<line x1=\"{x1:.2}\" y1=\"{y1:.2}\" x2=\"{x2:.2}\" y2=\"{y2:.2}\" stroke=\"#{}\" stroke-width=\"{width}\"{dashes}/>",
        ink.hex()
    );
}

/// The corners of an arrow's tip: its point, and the two beside its line.
fn tip(from: Point, to: Point) -> [Point; 3] {
    let along = [to[0] - from[0], to[1] - from[1]];
    let length = libm::hypot(along[0], along[1]).max(f64::MIN_POSITIVE);
    let [x, y] = along.map(|part| part / length);
    let beside = |side: f64| [to[0] - 9.0 * x - side * 3.5 * y, to[1] - 9.0 * y + side * 3.5 * x];
    [to, beside(1.0), beside(-1.0)]
}

fn text(out: &mut String, at: Point, words: &str, ink: Ink, more: &str) {
    *out += &svg::label(at, &format!("{more}fill=\"#{}\"", ink.hex()), 3, words);
}
