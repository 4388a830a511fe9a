//! A list, over everything else.

use super::table::{Table, cut};
use super::{clear, draw_frame, inner, put, put_all};
use crate::tui::keys;
use crate::tui::listing::listing;
use crate::tui::model::Model;
use crate::tui::model::list::{Entry, Kind, Listing};
use crate::tui::text::{shown, width_of};
use crate::tui::theme::{Palette, Role, Theme};
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use ratatui::style::{Modifier, Style};
use ratatui::text::{Line, Span};

/// Draws a list with its selected entry in view, from the column `shift` on.
pub(super) fn draw(model: &Model, kind: Kind, (selected, shift): (usize, usize), theme: &Theme, buffer: &mut Buffer) {
    let listing = listing(model, kind);
    let table = Table::of(&listing, theme);
    let place = Place::of(&listing, &table, &longest_hint(model, kind), buffer.area);
    clear(place.area, buffer);
    let last_shift = place.last_shift(&table);
    let has_targets = kind == Kind::Breakpoints || listing.entries.iter().any(Entry::leads);
    let hint = hint(model, (kind, &listing), &place, has_targets, last_shift > 0);
    draw_frame(&listing.title, &hint, theme, place.area, buffer);
    let (head, body) = (place.head, place.body);
    let faint = theme.style(Role::Faint);
    if table.rows.is_empty() {
        let nothing = cut(&shown(listing.nothing, theme), 0, usize::from(body.width), theme);
        return put(buffer, body, Line::styled(nothing, faint));
    }
    let shift = shift.min(last_shift);
    let fixed = place.fixed(&table);
    let seen = |text: &str, fixed: usize| {
        let (stays, scrolls) = text.split_at(text.char_indices().nth(fixed).map_or(text.len(), |(at, _)| at));
        let room = place.room().saturating_sub(width_of(stays));
        // What isn't in a column ends at its own end.
        let shift = if fixed == 0 { shift.min(width_of(text).saturating_sub(room)) } else { shift };
        format!("{stays}{}", cut(scrolls, shift, room, theme))
    };
    put(buffer, head, Line::styled(format!("  {}", seen(&table.head, fixed)), faint));
    let top = place.top(selected, &table);
    let lines = table.rows.iter().zip(&listing.entries).enumerate().skip(top).map(|(number, (text, entry))| {
        let mark = if number == selected { theme.glyphs.current } else { " " };
        let text = seen(text, if entry.has_cells() { fixed } else { 0 });
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

/// The entry at a place on the screen.
pub(in crate::tui) fn entry_at(
    model: &Model,
    (listing, kind): (&Listing, Kind),
    selected: usize,
    at: Position,
) -> Option<usize> {
    let table = Table::of(listing, &Theme::new(Palette::None, model.is_ascii));
    let place = Place::of(listing, &table, &longest_hint(model, kind), Rect::new(0, 0, model.size.0, model.size.1));
    let row = place.body.contains(at).then(|| place.top(selected, &table) + usize::from(at.y - place.body.y))?;
    Some(row).filter(|row| *row < table.rows.len())
}

/// The longest that is said about keys.
fn longest_hint(model: &Model, kind: Kind) -> String {
    let hints = &model.texts().lists.hints;
    keys::hint(&model.guide.bindings, kind.hints(hints).first().unwrap_or(&hints.usual[0]))
}

/// What to say about keys.
fn hint(model: &Model, (kind, listing): (Kind, &Listing), place: &Place, has_targets: bool, is_cut: bool) -> String {
    let hints = &model.texts().lists.hints;
    let room = usize::from(inner(place.area, 0).width).saturating_sub(2);
    let usual: &[&str] = match (has_targets, is_cut) {
        (true, true) => &[hints.cut[0], hints.cut[1], hints.usual[1]],
        (true, false) => &hints.usual,
        (false, true) => &[hints.cut_plain],
        (false, false) => &[],
    };
    // Nothing can be deleted where there is nothing.
    let has_own = kind != Kind::Bookmarks || !listing.entries.is_empty();
    let own = Some(kind.hints(hints)).filter(|_| has_own).unwrap_or_default();
    let ways = own.iter().chain(usual).map(|hint| keys::hint(&model.guide.bindings, hint));
    ways.into_iter().find(|hint| width_of(hint) <= room).unwrap_or_else(|| hints.closes.to_owned())
}

/// The last column from which on a list can be seen.
pub(in crate::tui) fn last_shift(model: &Model, listing: &Listing, kind: Kind) -> usize {
    // Text is widest in ASCII.
    let table = Table::of(listing, &Theme::new(Palette::None, true));
    Place::of(listing, &table, &longest_hint(model, kind), Rect::new(0, 0, model.size.0, model.size.1))
        .last_shift(&table)
}

/// Where a list lies: in the middle of the screen, as large as it need be.
struct Place {
    area: Rect,
    /// The titles of its columns, which don't scroll.
    head: Rect,
    body: Rect,
}

impl Place {
    /// The place of a list on a screen; `hint` is the longest that is said about keys.
    fn of(listing: &Listing, table: &Table, hint: &str, screen: Rect) -> Place {
        let has_head = !table.head.is_empty() && !table.rows.is_empty();
        let said = [listing.nothing, &listing.title, hint].map(width_of).into_iter().max().unwrap_or(0);
        let area = middle(screen, table.width().max(said) + 6, table.rows.len().max(1) + 2 + usize::from(has_head));
        let whole = inner(area, 1);
        // A row is worth more than its titles.
        let head_height = u16::from(has_head && usize::from(whole.height) > table.rows.len().min(2));
        let head = Rect { height: head_height, ..whole };
        Place { area, head, body: Rect { y: whole.y + head_height, height: whole.height - head_height, ..whole } }
    }

    /// The first entry that is seen: the selected one is in the middle, if it can be.
    fn top(&self, selected: usize, table: &Table) -> usize {
        let height = usize::from(self.body.height);
        selected.saturating_sub(height / 2).min(table.rows.len().saturating_sub(height))
    }

    /// The columns that a line has, behind the mark of the selected one.
    fn room(&self) -> usize {
        usize::from(self.body.width).saturating_sub(2)
    }

    /// How many columns stay where they are, if the others have room enough beside them.
    fn fixed(&self, table: &Table) -> usize {
        if table.fixed > self.room() / 2 { 0 } else { table.fixed }
    }

    fn last_shift(&self, table: &Table) -> usize {
        table.width().saturating_sub(self.room())
    }
}

/// An area of this many columns and rows in the middle of the screen, as far as it has room.
fn middle(screen: Rect, columns: usize, rows: usize) -> Rect {
    let width = screen.width.min(columns.min(usize::from(u16::MAX)) as u16);
    let height = screen.height.min(rows.min(usize::from(u16::MAX)) as u16);
    Rect { x: (screen.width - width) / 2, y: (screen.height - height) / 2, width, height }
}
