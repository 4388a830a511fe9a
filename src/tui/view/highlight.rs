//! Marks what a search has found in what is on the screen.

use crate::tui::model::Model;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Modifier, Style};

/// Underlines the matches in an area that has been drawn.
pub(super) fn draw(model: &Model, area: Rect, buffer: &mut Buffer) {
    let Some(search) = &model.guide.search else { return };
    let area = area.intersection(buffer.area);
    for y in area.rows().map(|row| row.y) {
        let letters: Vec<_> = (area.left()..area.right()).map(|x| buffer[(x, y)].symbol()).collect();
        for place in search.pattern.places(&letters) {
            let found = Rect { x: area.x + place.start as u16, y, width: place.len() as u16, height: 1 };
            buffer.set_style(found, Style::new().add_modifier(Modifier::UNDERLINED | Modifier::BOLD));
        }
    }
}
