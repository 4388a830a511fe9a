//! A close-up as a document for pdflatex, with TikZ.

use super::{CloseUp, Ink, Piece, Point};
use crate::report::escape::{self, line};
use std::fmt::Write;

/// Units of a sheet in a centimetre.
const UNITS: f64 = 40.0;

/// The figures with their table, as a document of its own.
pub fn latex(close_up: &CloseUp) -> String {
    let mut out = String::new();
    out.push_str("\\documentclass[11pt]{article}\n\\usepackage[utf8]{inputenc}\n\\usepackage[T1]{fontenc}\n");
    out.push_str("\\usepackage{amsmath,longtable,tikz}\n\\usepackage[a4paper,margin=2cm]{geometry}\n");
    for ink in Ink::ALL {
        line!(out, "\\definecolor{{{}}}{{HTML}}{{{}}}", ink.name(), ink.hex().to_uppercase());
    }
    line!(out, "\\begin{{document}}\n\\section*{{{}}}", words(&close_up.title));
    for sheet in &close_up.sheets {
        line!(out, "\\begin{{minipage}}{{{:.2}cm}}\\centering", sheet.size[0] / UNITS);
        line!(out, "\\begin{{tikzpicture}}[every node/.style={{font=\\small, inner sep=1pt}}]");
        sheet.pieces.iter().for_each(|piece| draw(&mut out, piece));
        line!(out, "\\end{{tikzpicture}}\\\\{}", words(&sheet.caption));
        line!(out, "\\end{{minipage}}");
    }
    line!(out, "\n\\medskip\\noindent {}\n", words(&close_up.note));
    line!(out, "\\begin{{longtable}}{{{}}}", "l".repeat(close_up.columns.len()));
    let row = |cells: &[String]| cells.iter().map(|cell| words(cell)).collect::<Vec<_>>().join(" & ");
    line!(out, "{} \\\\\\hline", row(&close_up.columns));
    for cells in &close_up.rows {
        line!(out, "{} \\\\", row(cells));
    }
    line!(out, "\\end{{longtable}}\n\\end{{document}}");
    out
}

fn draw(out: &mut String, piece: &Piece) {
    match piece {
        Piece::Line { from, to, ink, dashed } => {
            let dashed = if *dashed { ", dashed" } else { "" };
            line!(out, "\\draw[{}{dashed}] {} -- {};", ink.name(), at(*from), at(*to));
        }
        Piece::Arrow { from, to, ink } => {
            line!(out, "\\draw[->, thick, {}] {} -- {};", ink.name(), at(*from), at(*to));
        }
        Piece::Path { points, ink, is_area } => {
            let points: Vec<_> = points.iter().map(|place| at(*place)).collect();
            let close = if *is_area { " -- cycle" } else { "" };
            line!(out, "\\draw[{}] {}{close};", ink.name(), points.join(" -- "));
        }
        Piece::Dot { at: place, radius, ink, filled } => {
            let fill = if *filled { ink.name() } else { "white" };
            line!(out, "\\filldraw[draw={}, fill={fill}] {} circle ({:.3}cm);", ink.name(), at(*place), radius / UNITS);
        }
        Piece::Text { at: place, text, ink } => {
            line!(out, "\\node[text={}] at {} {{{}}};", ink.name(), at(*place), words(text));
        }
    }
}

/// A text of a close-up: an angle as a whole, and the power of a cosine, are mathematics.
fn words(text: &str) -> String {
    let is_number = |text: &&str| !text.is_empty() && text.chars().all(|c| c.is_ascii_digit() || ".,".contains(c));
    match text.strip_suffix('°').filter(is_number) {
        // A decimal comma would have a space behind it.
        Some(degrees) => format!("${}^\\circ$", degrees.replace(',', "{,}")),
        None => escape::latex(text).replace("cos$^n$", "$\\cos^n$"),
    }
}

fn at([x, y]: Point) -> String {
    format!("({:.3},{:.3})", x / UNITS, -y / UNITS)
}
