//! A list, over everything else.

use super::text::{shown, width_of};
use super::{clear, inner, put, put_all};
use crate::tui::list::{Kind, listing};
use crate::tui::model::Model;
use crate::tui::theme::{Role, Theme};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Modifier, Style};
use ratatui::text::{Line, Span};

/// What the keys do in a list.
const USUAL: &str = "j k select, Enter goes there, Esc closes";

/// Draws a list with its selected entry in view.
pub(super) fn draw(model: &Model, kind: Kind, selected: usize, theme: &Theme, buffer: &mut Buffer) {
    let listing = listing(model, kind);
    let texts: Vec<String> = listing.entries.iter().map(|entry| shown(&entry.text, theme)).collect();
    let widest = texts.iter().map(|text| width_of(text)).max().unwrap_or(0).max(width_of(listing.nothing));
    let widest = widest.max(width_of(&listing.title)).max(width_of(kind.hints().first().unwrap_or(&USUAL))) + 6;
    let area = middle(buffer.area, widest, texts.len().max(1) + 2);
    clear(area, buffer);
    let faint = theme.style(Role::Faint);
    let rule = theme.glyphs.horizontal.repeat(usize::from(area.width));
    let bottom = Rect { y: area.bottom().saturating_sub(1), height: 1, ..area };
    put(buffer, area, Line::styled(rule.clone(), faint));
    put(buffer, inner(area, 0), Line::styled(format!(" {} ", shown(&listing.title, theme)), theme.style(Role::Title)));
    put(buffer, bottom, Line::styled(rule, faint));
    let room = usize::from(inner(bottom, 0).width).saturating_sub(2);
    let has_targets = !kind.hints().is_empty() || listing.entries.iter().any(|entry| entry.target.is_some());
    let usual = if has_targets && room >= width_of(USUAL) { USUAL } else { "Esc closes" };
    let hint = kind.hints().iter().find(|hint| width_of(hint) <= room).unwrap_or(&usual);
    let hint = format!(" {hint} ");
    put(buffer, inner(bottom, 0), Line::styled(hint, faint));
    let body = inner(area, 1);
    let height = usize::from(body.height);
    if texts.is_empty() {
        return put(buffer, body, Line::styled(listing.nothing, faint));
    }
    let top = selected.saturating_sub(height / 2).min(texts.len().saturating_sub(height));
    let lines = texts.into_iter().zip(&listing.entries).enumerate().skip(top).map(|(number, (text, entry))| {
        let mark = if number == selected { theme.glyphs.current } else { " " };
        Line::from(vec![
            Span::styled(format!("{mark} "), theme.style(Role::Current)),
            Span::styled(text, theme.style(entry.role)),
        ])
    });
    put_all(buffer, body, lines);
    if has_targets {
        let row = body.y.saturating_add((selected - top) as u16);
        let place = Rect { y: row, height: 1, ..body }.intersection(body).intersection(buffer.area);
        buffer.set_style(place, Style::new().add_modifier(Modifier::REVERSED));
    }
}

/// An area of this many columns and rows in the middle of the screen, as far as it has room.
fn middle(screen: Rect, columns: usize, rows: usize) -> Rect {
    let width = screen.width.min(columns.min(usize::from(u16::MAX)) as u16);
    let height = screen.height.min(rows.min(usize::from(u16::MAX)) as u16);
    Rect { x: (screen.width - width) / 2, y: (screen.height - height) / 2, width, height }
}
