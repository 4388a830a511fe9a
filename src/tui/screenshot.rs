//! A frame as a picture: a self-contained SVG of monospace text.

use super::dump::rows;
use super::theme::{Background, of_index};
use crate::report::escape::xml_of_visible;
use ratatui::buffer::{Buffer, Cell};
use ratatui::style::{Color, Modifier, Style};
use std::fmt::Write;

/// What a picture of the viewer is written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// A picture.
    Svg,
    /// The text alone.
    Text,
}

impl Form {
    /// The endings of their names.
    pub const ENDINGS: [&'static str; 2] = [".svg", ".txt"];

    /// The form that a file's name asks for.
    pub fn of_name(name: &str) -> Option<Form> {
        let lower = name.to_ascii_lowercase();
        let ending = Form::ENDINGS.iter().position(|ending| lower.ends_with(ending))?;
        Some([Form::Svg, Form::Text][ending])
    }
}

/// The size of a cell, and of the letters in it, in the units of the picture.
const CELL: (f64, f64) = (8.4, 18.0);
const LETTERS: f64 = 14.0;
const MARGIN: f64 = 8.0;

/// The colours of the terminal itself: behind the text, and that of the text.
fn own_colors(background: Background) -> [&'static str; 2] {
    match background {
        Background::Dark => ["#16181d", "#d8dee9"],
        Background::Light => ["#ffffff", "#24292f"],
    }
}

/// The frame as SVG, on this background.
pub fn svg(buffer: &Buffer, background: Background) -> String {
    let own = own_colors(background);
    let (width, height) = (f64::from(buffer.area.width), f64::from(buffer.area.height));
    let (width, height) = (width * CELL.0 + 2.0 * MARGIN, height * CELL.1 + 2.0 * MARGIN);
    let mut svg = String::new();
    let _ = writeln!(
        svg,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width:.1} {height:.1}\" width=\"{width:.1}\" \
         height=\"{height:.1}\" font-family=\"ui-monospace, 'DejaVu Sans Mono', Menlo, Consolas, monospace\" \
         font-size=\"{LETTERS}\" xml:space=\"preserve\">"
    );
    let _ = writeln!(svg, "<rect width=\"100%\" height=\"100%\" rx=\"6\" fill=\"{}\"/>", own[0]);
    for (number, row) in rows(buffer).enumerate() {
        let mut column = 0;
        for run in row.chunk_by(|a, b| a.style() == b.style()) {
            draw_run(&mut svg, run, [column, number], own);
            column += run.len();
        }
    }
    svg.push_str("</svg>\n");
    svg
}

fn draw_run(svg: &mut String, run: &[Cell], [column, row]: [usize; 2], own: [&str; 2]) {
    let look = Look::of(run[0].style(), own);
    let (x, y) = (MARGIN + column as f64 * CELL.0, MARGIN + row as f64 * CELL.1);
    if let Some(fill) = &look.background {
        let width = run.len() as f64 * CELL.0;
        let _ = writeln!(
            svg,
            "<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"{width:.1}\" height=\"{}\" fill=\"{fill}\" shape-rendering=\"crispEdges\"/>",
            CELL.1
        );
    }
    if let Some(upper) = half_block(run) {
        let y = if upper { y } else { y + CELL.1 / 2.0 };
        let (width, height) = (run.len() as f64 * CELL.0, CELL.1 / 2.0);
        let fill = &look.foreground;
        let _ = writeln!(
            svg,
            "<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"{width:.1}\" height=\"{height:.1}\" fill=\"{fill}\" \
             shape-rendering=\"crispEdges\"/>"
        );
        return;
    }
    let dots: String = run.iter().enumerate().map(|(at, cell)| dots(cell, x + at as f64 * CELL.0, y)).collect();
    if !dots.is_empty() {
        let _ = writeln!(svg, "<path fill=\"{}\"{} d=\"{dots}\"/>", look.foreground, look.attributes);
    }
    // Text begins and ends at letters: what is blank at its ends only moves it.
    let is_blank =
        |cell: &Cell| braille(cell).is_some() || (!cell.symbol().is_empty() && cell.symbol().trim().is_empty());
    let Some(first) = run.iter().position(|cell| !is_blank(cell)) else { return };
    let last = run.iter().rposition(|cell| !is_blank(cell)).unwrap_or(first);
    let cells = &run[first..=last];
    let letter = |cell: &Cell| if braille(cell).is_some() { " ".to_owned() } else { xml_of_visible(cell.symbol()) };
    let text: String = cells.iter().map(letter).collect();
    let (x, y) = (x + first as f64 * CELL.0, y + 0.76 * CELL.1);
    let length = cells.len() as f64 * CELL.0;
    let _ = writeln!(
        svg,
        "<text x=\"{x:.1}\" y=\"{y:.1}\" textLength=\"{length:.1}\" lengthAdjust=\"spacingAndGlyphs\" \
         fill=\"{}\"{}>{text}</text>",
        look.foreground, look.attributes
    );
}

/// Which dots of a Braille pattern are set, a bit each in the order of Unicode; `None` of other symbols.
fn braille(cell: &Cell) -> Option<u32> {
    let mut characters = cell.symbol().chars();
    match (characters.next(), characters.next()) {
        (Some(dots @ '\u{2800}'..='\u{28ff}'), None) => Some(dots as u32 - 0x2800),
        _ => None,
    }
}

/// The dots of a cell with this corner, as squares of a path: fonts have Braille patterns of many widths, or none.
fn dots(cell: &Cell, x: f64, y: f64) -> String {
    /// Column and row of each bit.
    const PLACES: [[u8; 2]; 8] = [[0, 0], [0, 1], [0, 2], [1, 0], [1, 1], [1, 2], [0, 3], [1, 3]];
    /// The side of a dot.
    const SIDE: f64 = 1.6;
    let pattern = braille(cell).unwrap_or_default();
    let set = PLACES.into_iter().enumerate().filter(|(bit, _)| pattern >> bit & 1 == 1);
    let square = |(_, [column, row]): (usize, [u8; 2])| {
        let middle = [x + (f64::from(column) + 0.5) * CELL.0 / 2.0, y + (f64::from(row) + 0.5) * CELL.1 / 4.0];
        let [left, top] = middle.map(|middle| middle - SIDE / 2.0);
        format!("M{left:.1} {top:.1}h{SIDE}v{SIDE}h-{SIDE}z")
    };
    set.map(square).collect()
}

/// Whether all cells are upper half blocks, or else lower ones: letters of a font would leave seams between them.
fn half_block(run: &[Cell]) -> Option<bool> {
    let all = |symbol: &str| run.iter().all(|cell| cell.symbol() == symbol);
    if all("▀") { Some(true) } else { all("▄").then_some(false) }
}

/// How a run of cells is drawn.
struct Look {
    foreground: String,
    background: Option<String>,
    attributes: String,
}

impl Look {
    fn of(style: Style, [ground, ink]: [&str; 2]) -> Look {
        let has = |modifier| style.add_modifier.contains(modifier);
        let mut foreground = style.fg.and_then(hex);
        let mut background = style.bg.and_then(hex);
        if has(Modifier::REVERSED) {
            let light = foreground.take().unwrap_or_else(|| ink.to_owned());
            foreground = Some(background.take().unwrap_or_else(|| ground.to_owned()));
            background = Some(light);
        }
        let mut attributes = String::new();
        for (modifier, attribute) in [
            (Modifier::BOLD, " font-weight=\"bold\""),
            (Modifier::DIM, " opacity=\"0.6\""),
            (Modifier::ITALIC, " font-style=\"italic\""),
            (Modifier::UNDERLINED, " text-decoration=\"underline\""),
        ] {
            attributes.push_str(if has(modifier) { attribute } else { "" });
        }
        Look { foreground: foreground.unwrap_or_else(|| ink.to_owned()), background, attributes }
    }
}

/// A colour as XML has it; `None` for the terminal's own.
fn hex(color: Color) -> Option<String> {
    let [r, g, b] = match color {
        Color::Rgb(r, g, b) => [r, g, b],
        Color::Indexed(index) => of_index(index),
        Color::Red => of_index(1),
        Color::Green => of_index(2),
        Color::Yellow => of_index(3),
        Color::Blue => of_index(4),
        Color::Magenta => of_index(5),
        _ => return None,
    };
    Some(format!("#{r:02x}{g:02x}{b:02x}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use ratatui::layout::Rect;
    use ratatui::style::Stylize;

    fn picture(text: &str) -> String {
        let mut buffer = Buffer::empty(Rect::new(0, 0, 20, 1));
        buffer.set_span(0, 0, &text.fg(Color::Indexed(74)).bold(), 20);
        svg(&buffer, Background::Dark)
    }

    #[test]
    fn text_is_escaped_and_coloured() {
        let svg = picture("a<b & \"c\"");
        assert!(svg.contains("fill=\"#5fafd7\" font-weight=\"bold\">a&lt;b &amp; &quot;c&quot;</text>"), "{svg}");
    }

    #[test]
    fn reversed_text_has_a_background() {
        let mut buffer = Buffer::empty(Rect::new(0, 0, 4, 1));
        buffer.set_span(0, 0, &"x".reversed(), 4);
        let svg = svg(&buffer, Background::Dark);
        assert!(svg.contains(&format!("height=\"18\" fill=\"{}\"", own_colors(Background::Dark)[1])), "{svg}");
        assert!(svg.contains(&format!("fill=\"{}\">x</text>", own_colors(Background::Dark)[0])), "{svg}");
    }

    #[test]
    fn braille_patterns_are_dots() {
        let svg = picture("a\u{2801}\u{2880}b");
        assert!(svg.contains(">a  b</text>"), "{svg}");
        // The first dot of a cell, and the last one of the next.
        let middles = [(1.25, 0.125), (2.75, 0.875)].map(|(column, row)| [column * CELL.0, row * CELL.1]);
        let [first, last] = middles.map(|[x, y]| format!("M{:.1} {:.1}h", MARGIN + x - 0.8, MARGIN + y - 0.8));
        assert!(svg.contains(&first) && svg.contains(&last) && svg.matches("h-1.6z").count() == 2, "{svg}");
    }

    #[test]
    fn wide_letters_have_their_width() {
        let svg = picture("a 漢字 क्‍ष b");
        let length = 11.0 * CELL.0;
        assert!(svg.contains(&format!("textLength=\"{length:.1}\"")) && svg.contains(">a 漢字 क्‍ष b</text>"), "{svg}");
    }

    #[test]
    fn blank_frames_have_no_text() {
        assert!(!picture("").contains("<text"));
        assert!(svg(&Buffer::empty(Rect::default()), Background::Dark).ends_with("</svg>\n"));
    }
}
