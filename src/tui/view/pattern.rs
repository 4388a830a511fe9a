//! The samples of a pixel as a picture: where they lie in its square, and how the square was cut.

use super::{only_ascii, put, shown, title_rule};
use crate::log::{Decision, Name, Step};
use crate::tui::model::Model;
use crate::tui::theme::{Role, Theme};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Color;
use ratatui::symbols::Marker;
use ratatui::text::Span;
use ratatui::widgets::Widget;
use ratatui::widgets::canvas::{Canvas, Line, Points, Rectangle};

/// The most rows of the picture: more dots than that can't be distinguished.
const MOST_ROWS: u16 = 14;

/// What the computation keeps at least.
const ROWS_OF_COMPUTATION: u16 = 6;

/// The most samples that are drawn.
const MOST_SAMPLES: usize = 1 << 13;

/// What of a pane is left to the computation, and what goes to the picture; nothing where there are no samples to show.
pub(super) fn split(model: &Model, area: Rect) -> (Rect, Rect) {
    let rows = (area.height / 2).min(MOST_ROWS + 1);
    let is_about_samples = matches!(model.tree.nodes()[model.cursor].step, None | Some(Step::Sample { .. }));
    let fits = rows >= 4 && area.height - rows >= ROWS_OF_COMPUTATION && area.width >= 2 * rows + 4;
    if !is_about_samples || !fits || samples(model).next().is_none() {
        return (area, Rect::default());
    }
    let above = Rect { height: area.height - rows, ..area };
    (above, Rect { y: above.bottom(), height: rows, ..area })
}

/// Draws the picture with a title above it.
pub(super) fn draw(model: &Model, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    if area.height < 2 {
        return;
    }
    let places: Vec<_> = samples(model).take(MOST_SAMPLES).collect();
    let current = places.iter().find(|(node, _)| *node == model.cursor).map(|(_, place)| *place);
    let name = (model.texts().panes.samples)(places.len());
    title_rule(&shown(&name, theme), theme, area, buffer);
    // A character is twice as high as it is wide.
    let height = area.height - 1;
    let square = Rect { x: area.x + 2, y: area.y + 1, width: (2 * height).min(area.width - 2), height };
    let [faint, points, marked] = [Role::Faint, Role::Camera, Role::Current].map(|role| color(theme, role));
    let coordinates: Vec<_> = places.iter().map(|(_, place)| upward(*place)).collect();
    let cuts: Vec<_> = cuts(model).collect();
    Canvas::default()
        .marker(if theme.is_ascii() { Marker::Dot } else { Marker::Braille })
        .x_bounds([0.0, 1.0])
        .y_bounds([0.0, 1.0])
        .paint(|canvas| {
            canvas.draw(&Rectangle { x: 0.0, y: 0.0, width: 1.0, height: 1.0, color: faint });
            for [left, top, side] in &cuts {
                let (middle_x, middle_y) = (left + side / 2.0, 1.0 - top - side / 2.0);
                canvas.draw(&Line { x1: *left, y1: middle_y, x2: left + side, y2: middle_y, color: faint });
                canvas.draw(&Line { x1: middle_x, y1: 1.0 - top, x2: middle_x, y2: 1.0 - top - side, color: faint });
            }
            canvas.layer();
            canvas.draw(&Points { coords: &coordinates, color: points });
        })
        .render(square, buffer);
    if theme.is_ascii() {
        only_ascii(square, buffer);
    }
    if let Some([x, y]) = current {
        let cell = |part: f64, cells: u16| (part * f64::from(cells)).min(f64::from(cells.saturating_sub(1))) as u16;
        let place =
            Rect { x: square.x + cell(x, square.width), y: square.y + cell(y, square.height), width: 1, height: 1 };
        put(buffer, place, Span::styled(if theme.is_ascii() { "x" } else { "×" }, marked).into());
    }
}

fn color(theme: &Theme, role: Role) -> Color {
    theme.style(role).fg.unwrap_or(Color::Reset)
}

/// Rows count down, the canvas counts up.
fn upward([x, y]: [f64; 2]) -> (f64, f64) {
    (x, 1.0 - y)
}

/// The sample nodes of a pixel with their places in its square.
fn samples(model: &Model) -> impl Iterator<Item = (usize, [f64; 2])> + '_ {
    let is_sample = |node: &usize| matches!(model.tree.nodes()[*node].step, Some(Step::Sample { .. }));
    model.tree.children(0).filter(is_sample).filter_map(|node| Some((node, place(model, node)?)))
}

/// The place of a sample: it is among the first that its node has.
fn place(model: &Model, node: usize) -> Option<[f64; 2]> {
    const FIRST: usize = 6;
    let number = |wanted: Name| {
        model.tree.own_events(node).take(FIRST).find_map(|event| {
            let event = &model.log.events[event];
            let given = model.log.events.given(event).iter().find(|(name, _)| *name == wanted).map(|(_, value)| *value);
            let noted = event.noted().filter(|(name, _)| *name == wanted).map(|(_, value)| value);
            given.or(noted)?.number()
        })
    };
    Some([number(Name::SampleX)?, number(Name::SampleY)?])
}

/// The cells that were cut in four: left, top and side.
fn cuts(model: &Model) -> impl Iterator<Item = [f64; 3]> + '_ {
    let decisions = model.tree.own_events(0).take(4 * MOST_SAMPLES).map(|event| model.log.events[event].decision());
    decisions.filter_map(|decision| match decision? {
        Decision::Subdivided { cell, .. } => Some(cell),
        _ => None,
    })
}
