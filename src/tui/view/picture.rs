//! The picture, two dots to a character: half blocks, or shades where there are no colours.

use super::{over_picture, put, title};
use crate::log::{Decision, RayKind, Value, What};
use crate::report::words;
use crate::tui::model::layout::Layout;
use crate::tui::model::picture::{Layer, PictureView, Shows, triple};
use crate::tui::model::{Model, Pane};
use crate::tui::text::{shown, width_of};
use crate::tui::theme::{Background, Palette, Theme, of_index};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Color, Modifier, Style};
use ratatui::text::Line;

pub(super) fn draw(model: &Model, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let Some(view) = model.picture.as_ref().filter(|_| !area.is_empty()) else { return };
    let range = view.image.range(view.layer);
    title(model, Pane::Picture, name(model, view, range, theme), &remark(view), theme, area, buffer);
    let body = Layout::body(area);
    let dots = Layout::dots(area);
    let triples = view.shows_named().and_then(|_| view.image.range_of_triples());
    let brush = Brush { view, range, triples, theme, screen: [dots.width.into(), 2 * u32::from(dots.height)] };
    for place in dots.intersection(buffer.area).positions() {
        let cell = brush.cell([u32::from(place.x - dots.x), 2 * u32::from(place.y - dots.y)]);
        if let (Some((symbol, style)), Some(target)) = (cell, buffer.cell_mut(place)) {
            target.set_symbol(symbol).set_style(style);
        }
    }
    let ground = |[column, row]: [u16; 2]| brush.ground([column.into(), 2 * u32::from(row)]);
    over_picture::draw(model, view, theme, dots, &ground, buffer);
    draw_bar(model, &brush, area, buffer);
    let below = Rect { y: dots.bottom(), height: body.height - dots.height, ..body };
    put(buffer, below, Line::raw(shown(&under_cursor(model, view, usize::from(below.width)), theme)));
}

/// The columns of the colour bar: fewer beside the key of a quantity, so that a small screen has room for both ends.
fn columns_of_bar(view: &PictureView) -> u16 {
    if view.layer == Layer::Named { 6 } else { 12 }
}

/// The colour bar in the rule above a picture in false colours, where the name leaves blanks for it.
fn draw_bar(model: &Model, brush: &Brush, area: Rect, buffer: &mut Buffer) {
    if brush.range.is_none() {
        return;
    }
    let name = name(model, brush.view, brush.range, brush.theme);
    let Some(before) = name.split(&bar(brush.view)).next().filter(|before| before.len() < name.len()) else { return };
    let start = area.x.saturating_add(3 + width_of(before) as u16);
    let columns = columns_of_bar(brush.view);
    for column in 0..columns {
        let color = false_color(f64::from(column) / f64::from(columns - 1));
        let place = Rect { x: start.saturating_add(column), width: 1, height: 1, ..area }.intersection(area);
        let symbol = if brush.has_shades() { brush.shade(luminance(color)) } else { "█" };
        let style = Style::reset().fg(brush.terminal_color(color));
        for position in place.intersection(buffer.area).positions() {
            if let Some(cell) = buffer.cell_mut(position) {
                cell.set_symbol(symbol).set_style(style);
            }
        }
    }
}

/// The blanks that the colour bar takes.
fn bar(view: &PictureView) -> String {
    " ".repeat(usize::from(columns_of_bar(view)))
}

fn name(model: &Model, view: &PictureView, range: Option<[f64; 2]>, theme: &Theme) -> String {
    let figure = |value| model.language.marked(figure(value));
    let mut name = view.title(model.language).to_owned();
    if let Some([least, greatest]) = range {
        name += &format!(" {} {} {}", figure(least), bar(view), figure(greatest));
    }
    if let (Some(shows), texts) = (view.shows_named(), &model.texts().panes.picture) {
        if view.image.lacks_named() {
            name += &format!(": {}", if view.is_finished { texts.no_pixel_has_it } else { "…" });
        } else if let (Shows::Triples, Some(ends)) = (shows, view.image.range_of_triples()) {
            name += &format!(" {}", (texts.axes)(&ends.map(figure)));
        }
    }
    let has_light = view.layer == Layer::Colors || view.shows_named() == Some(Shows::Light);
    if view.stops() != 0.0 && has_light {
        let (texts, stops) = (&model.texts().panes.picture, stops(model, view.stops()));
        name += " ";
        name += &if view.fitting == 0 { (texts.exposure)(&stops) } else { (texts.fitting)(&stops) };
    }
    shown(&name, theme)
}

/// Stops of exposure with their sign.
fn stops(model: &Model, stops: f64) -> String {
    model.language.marked(format!("{stops:+.1}"))
}

/// A figure of a layer: a count, or a number with three digits.
fn figure(value: f64) -> String {
    let size = value.abs();
    if value.fract() == 0.0 && size < 1e9 {
        format!("{value}")
    } else if (0.01..1000.0).contains(&size) {
        let decimals = if size < 1.0 { 3 } else { 2 - libm::log10(size) as usize };
        format!("{value:.decimals$}")
    } else {
        format!("{value:.1e}")
    }
}

fn remark(view: &PictureView) -> String {
    let (done, all) = (view.image.done(), view.image.dots.len());
    let zoom = if view.zoom == 0 { String::new() } else { format!("x{}", 1_u32 << view.zoom) };
    if done == all || view.is_finished { zoom } else { format!("{} %", 100 * done / all.max(1)) }
}

/// What is known of the cursor's pixel, as much as fits.
fn under_cursor(model: &Model, view: &PictureView, room: usize) -> String {
    let [x, y] = view.cursor;
    let place = format!("{x},{y}");
    // The colour is what a quiz asks for, and what a growing tree comes to in the end.
    let is_to_come = model.facts.value(0).is_some_and(|event| !model.guide.is_known(event));
    let is_told = model.understanding.quiz.is_none() && !is_to_come;
    let Some(dot) = view.image.at(view.cursor).filter(|_| is_told) else { return place };
    let texts = &model.texts().panes.picture;
    let named = object(model).map_or_else(|| place.clone(), |object| format!("{place} {object}"));
    let shown_value = match view.shows_named() {
        Some(_) => Some(dot.named.map_or_else(|| texts.none.to_owned(), |value| model.value(&value))),
        None => view.layer.of(dot).map(|value| model.language.marked(figure(value))),
    };
    let value = shown_value.map_or(String::new(), |value| format!("  {} {value}", view.title(model.language)));
    let fitting = match view.layer {
        Layer::Colors if view.fitting != 0 => {
            format!("  {}", (texts.fitting)(&stops(model, f64::from(view.fitting) / 2.0)))
        }
        _ => String::new(),
    };
    // The tree has the colour with all of its samples already, and in `printed` that of the book.
    let color = traced(model, view.cursor).unwrap_or(dot.color);
    let linear = model.color(color);
    let levels = (texts.levels)((view.image.levels)(color, 0.0));
    let depth = dot.depth.map(|depth| format!("  {}", (texts.depth)(&model.value(&Value::Number(depth)))));
    let rays = if dot.is_rough { String::new() } else { format!("  {}", (texts.rays)(dot.rays)) };
    let counts = format!("{}{rays}", depth.unwrap_or_default());
    let texts = [
        format!("{named}{value}  {linear}  {levels}{fitting}{counts}"),
        format!("{named}{value}  {linear}  {levels}{fitting}"),
        format!("{named}{value}  {linear}{fitting}"),
        format!("{named}{value}  {linear}"),
        format!("{place}{value}  {linear}"),
        format!("{named}{value}"),
        format!("{place}{value}"),
    ];
    texts.into_iter().find(|text| width_of(text) <= room).unwrap_or(place)
}

/// The colour of a pixel in the log that is shown.
fn traced(model: &Model, pixel: [u32; 2]) -> Option<[f64; 3]> {
    let event = model.facts.value(0).filter(|_| model.pixel() == Some(pixel))?;
    match model.log.events[event].what {
        What::Result { color } => Some(color),
        _ => None,
    }
}

/// The object that the cursor's pixel shows, or that it is the background: what its camera ray hits, as far as one may know.
fn object(model: &Model) -> Option<String> {
    let tree = &model.tree;
    let camera = (0..tree.nodes().len()).find(|node| tree.ray(*node) == Some(RayKind::Camera))?;
    let event = model.facts.outcome(camera).filter(|event| model.guide.is_known(*event))?;
    match model.log.events[event].decision()? {
        Decision::Nearest { object } => Some(words::plain(model.log.header.object(object))),
        Decision::Background => Some(model.texts().panes.outcomes.background.to_owned()),
        _ => None,
    }
}

/// What draws the cells.
struct Brush<'v> {
    view: &'v PictureView,
    range: Option<[f64; 2]>,
    /// That of triples.
    triples: Option<[f64; 2]>,
    theme: &'v Theme,
    /// Dots on the screen.
    screen: [u32; 2],
}

impl Brush<'_> {
    /// The character with this dot of the screen above and the next one below; `None` outside the picture.
    fn cell(&self, [column, row]: [u32; 2]) -> Option<(&'static str, Style)> {
        let pixels = [row, row + 1].map(|row| self.view.pixel_under(self.screen, [column, row]));
        if pixels == [None, None] {
            return None;
        }
        let [above, below] = [row, row + 1].map(|row| self.color(self.view.area_under(self.screen, [column, row])?));
        if self.has_cursor([column, row]) {
            return Some(self.cursor(above.or(below)));
        }
        if self.has_shades() {
            let light = luminance(above.or(below).unwrap_or_default()) * 0.5
                + luminance(below.or(above).unwrap_or_default()) * 0.5;
            return Some((self.shade(light), Style::reset()));
        }
        let colored = |color: Option<[u8; 3]>| color.map_or(Color::Reset, |color| self.terminal_color(color));
        Some(match (above, below) {
            (None, None) => (" ", Style::reset()),
            (None, below) => ("▄", Style::reset().fg(colored(below))),
            (above, below) => ("▀", Style::reset().fg(colored(above)).bg(colored(below))),
        })
    }

    /// The colour of a cell as one, and whether it is bright; `None` outside the picture.
    fn ground(&self, [column, row]: [u32; 2]) -> Option<(Color, bool)> {
        let is_inside = |row: &u32| self.view.pixel_under(self.screen, [column, *row]).is_some();
        let of_dot = |row: u32| self.view.area_under(self.screen, [column, row]).and_then(|area| self.color(area));
        // What isn't there yet is black.
        let dots = [row, row + 1].into_iter().filter(is_inside);
        let colors: Vec<[u8; 3]> = dots.map(|row| of_dot(row).unwrap_or_default()).collect();
        let count = u32::try_from(colors.len()).ok().filter(|count| *count > 0)?;
        let mean = std::array::from_fn(|channel| {
            (colors.iter().map(|color| u32::from(color[channel])).sum::<u32>() / count) as u8
        });
        let behind = if self.has_shades() { Color::Reset } else { self.terminal_color(mean) };
        Some((behind, luminance(mean) > 0.5))
    }

    /// Whether there are no colours to draw with.
    fn has_shades(&self) -> bool {
        self.theme.has_few_colors() || self.theme.is_ascii()
    }

    /// Whether the cursor's pixel is seen here: its middle lies in the cell.
    fn has_cursor(&self, [column, row]: [u32; 2]) -> bool {
        let (scale, start) = self.view.window(self.screen);
        let at = [0, 1].map(|axis| ((f64::from(self.view.cursor[axis]) + 0.5 - start[axis]) / scale) as u32);
        at[0] == column && (at[1] == row || at[1] == row + 1)
    }

    fn cursor(&self, color: Option<[u8; 3]>) -> (&'static str, Style) {
        let symbol = if self.theme.is_ascii() { "X" } else { "╳" };
        if self.theme.has_few_colors() {
            return (symbol, Style::reset().add_modifier(Modifier::REVERSED | Modifier::BOLD));
        }
        let ground = color.unwrap_or_default();
        let ink = if luminance(ground) > 0.5 { [0; 3] } else { [255; 3] };
        let style = Style::reset().fg(self.terminal_color(ink)).bg(self.terminal_color(ground));
        (symbol, style.add_modifier(Modifier::BOLD))
    }

    /// What an area of the picture looks like in this layer: the mean of its pixels.
    fn color(&self, area: [[f64; 2]; 2]) -> Option<[u8; 3]> {
        let view = self.view;
        if view.layer == Layer::Colors {
            return Some((view.image.levels)(view.image.mean(area, |dot| Some(dot.color))?, view.stops()));
        }
        let part = |value: f64, [least, greatest]: [f64; 2]| {
            if greatest > least { (value - least) / (greatest - least) } else { 0.0 }
        };
        match view.shows_named() {
            Some(Shows::Light) => {
                return Some((view.image.levels)(view.image.mean(area, |dot| triple(dot.named))?, view.stops()));
            }
            Some(Shows::Triples) => {
                let (mean, range) = (view.image.mean(area, |dot| triple(dot.named))?, self.triples?);
                return Some(mean.map(|x| (part(x, range) * 255.0).round() as u8));
            }
            Some(Shows::Numbers) | None => {}
        }
        let [value] = view.image.mean(area, |dot| view.layer.of(dot).map(|value| [value]))?;
        let part = part(value, self.range?);
        Some(false_color(match self.view.layer {
            // Errors differ by powers of ten: eight of them are shown.
            Layer::Error => 1.0 + libm::log10(part) / 8.0,
            // Cosines and lengths are of every size.
            Layer::Named => part,
            // The root distinguishes small values, which most pixels have.
            _ => part.sqrt(),
        }))
    }

    fn shade(&self, light: f64) -> &'static str {
        const ASCII: [&str; 10] = [" ", ".", ":", "-", "=", "+", "*", "#", "%", "@"];
        const BLOCKS: [&str; 5] = [" ", "░", "▒", "▓", "█"];
        // The denser the sign, the more of it is ink.
        let light = if self.theme.background == Background::Light { 1.0 - light } else { light };
        let of =
            |shades: &'static [&'static str]| shades[((light * shades.len() as f64) as usize).min(shades.len() - 1)];
        if self.theme.is_ascii() { of(&ASCII) } else { of(&BLOCKS) }
    }

    fn terminal_color(&self, [r, g, b]: [u8; 3]) -> Color {
        match self.theme.palette {
            Palette::True => Color::Rgb(r, g, b),
            Palette::Indexed => Color::Indexed(indexed([r, g, b])),
            Palette::Sixteen | Palette::None => Color::Reset,
        }
    }
}

/// Lightness from 0 to 1 as eyes have it (Rec. 709, on the values as they are shown).
fn luminance([r, g, b]: [u8; 3]) -> f64 {
    (0.2126 * f64::from(r) + 0.7152 * f64::from(g) + 0.0722 * f64::from(b)) / 255.0
}

/// The nearest of the 256 colours that terminals have: of the cube of 6 × 6 × 6, or of the greys.
fn indexed(color: [u8; 3]) -> u8 {
    let distance = |other: [u8; 3]| -> u32 { (0..3).map(|at| u32::from(color[at].abs_diff(other[at])).pow(2)).sum() };
    // The first sixteen look different in every terminal.
    (16..=255).min_by_key(|index| distance(of_index(*index))).unwrap_or_default()
}

/// A colour for a number from 0 to 1 whose lightness grows evenly, so that it reads in grey and for colour-blind eyes too: the
/// colour map *cividis* (Nuñez, Anderton and Renslow, 2018), at eight places.
fn false_color(part: f64) -> [u8; 3] {
    const SCALE: [[u8; 3]; 8] = [
        [0, 32, 76],
        [0, 48, 111],
        [60, 77, 110],
        [91, 107, 114],
        [122, 132, 120],
        [158, 157, 115],
        [202, 186, 93],
        [255, 234, 70],
    ];
    let place = part.clamp(0.0, 1.0) * (SCALE.len() - 1) as f64;
    let below = (place as usize).min(SCALE.len() - 2);
    let rest = place - below as f64;
    std::array::from_fn(|channel| {
        let [from, to] = [SCALE[below][channel], SCALE[below + 1][channel]].map(f64::from);
        (from + (to - from) * rest + 0.5) as u8
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_of_the_cube_and_greys_are_their_own() {
        assert_eq!(indexed([0, 0, 0]), 16);
        assert_eq!(indexed([255, 255, 255]), 231);
        assert_eq!(indexed([95, 175, 255]), 16 + 36 + 6 * 3 + 5);
        assert_eq!(indexed([128, 128, 128]), 244);
        assert_eq!(indexed([8, 8, 8]), 232);
    }

    #[test]
    fn figures_have_three_digits() {
        let shown = [0.0, 12.0, 12.004, 1.0 / 3.0, 6.619e-3, 123.456, 19.649, 1234.5, 9.999].map(figure);
        assert_eq!(shown, ["0", "12", "12.0", "0.333", "6.6e-3", "123", "19.6", "1.2e3", "10.00"]);
    }

    #[test]
    fn false_colours_grow_lighter() {
        let lights: Vec<f64> = (0..=100).map(|part| luminance(false_color(f64::from(part) / 100.0))).collect();
        assert!(lights.windows(2).all(|pair| pair[0] <= pair[1] + 0.004), "{lights:?}");
        assert_eq!(false_color(1.0), [255, 234, 70]);
    }
}
