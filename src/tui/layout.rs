//! Where the panes lie, by the size of the terminal.

use super::model::Pane;
use ratatui::layout::Rect;

/// The places on the screen. A pane that isn't shown has no area.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    /// The rows of the tree, with its title above.
    pub tree: Rect,
    /// The computation, with its title above.
    pub computation: Rect,
    /// The column between panes that stand side by side.
    pub divider: Option<Rect>,
    /// The message.
    pub message: Rect,
    /// The bottom line.
    pub status: Rect,
    /// Whether the terminal is too small to show anything.
    pub is_too_small: bool,
}

const SMALLEST: (u16, u16) = (20, 6);
const WIDE: u16 = 80;
const TALL: u16 = 20;

impl Layout {
    /// The layout of a terminal of this many columns and rows: side by side when wide, one above the other when tall,
    /// else one at a time.
    pub fn of((width, height): (u16, u16), focus: Pane, has_message: bool) -> Layout {
        let nothing = Rect::default();
        if width < SMALLEST.0 || height < SMALLEST.1 {
            return Layout {
                tree: nothing,
                computation: nothing,
                divider: None,
                message: nothing,
                status: nothing,
                is_too_small: true,
            };
        }
        let message_rows = u16::from(has_message);
        let panes = Rect::new(0, 0, width, height - 1 - message_rows);
        let (tree, computation, divider) = match () {
            _ if width >= WIDE => side_by_side(panes),
            _ if height >= TALL => stacked(panes),
            _ if focus == Pane::Tree => (panes, nothing, None),
            _ => (nothing, panes, None),
        };
        Layout {
            tree,
            computation,
            divider,
            message: Rect::new(0, panes.bottom(), width, message_rows),
            status: Rect::new(0, height - 1, width, 1),
            is_too_small: false,
        }
    }

    /// How many rows of the tree are shown below its title; those of the computation where the tree isn't shown.
    pub fn page(&self) -> usize {
        usize::from(self.tree.height.max(if self.tree.is_empty() { self.computation.height } else { 0 }))
            .saturating_sub(1)
    }

    /// The place below the title of a pane.
    pub fn body(pane: Rect) -> Rect {
        Rect { y: pane.y + u16::from(pane.height > 0), height: pane.height.saturating_sub(1), ..pane }
    }
}

fn side_by_side(panes: Rect) -> (Rect, Rect, Option<Rect>) {
    let tree_width = (panes.width * 2 / 5).clamp(36, 76);
    let tree = Rect { width: tree_width, ..panes };
    let divider = Rect { x: tree_width, width: 1, ..panes };
    let computation = Rect { x: tree_width + 1, width: panes.width - tree_width - 1, ..panes };
    (tree, computation, Some(divider))
}

fn stacked(panes: Rect) -> (Rect, Rect, Option<Rect>) {
    let tree_height = panes.height * 2 / 5;
    let tree = Rect { height: tree_height, ..panes };
    let computation = Rect { y: tree_height, height: panes.height - tree_height, ..panes };
    (tree, computation, None)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_area_lies_on_the_screen() {
        for width in (0..340).step_by(3) {
            for height in 0..120 {
                for (focus, has_message) in [(Pane::Tree, true), (Pane::Tree, false), (Pane::Computation, true)] {
                    let layout = Layout::of((width, height), focus, has_message);
                    let screen = Rect::new(0, 0, width, height);
                    for area in [layout.tree, layout.computation, layout.message, layout.status] {
                        assert!(area.is_empty() || screen.intersection(area) == area, "{width}x{height}: {layout:?}");
                    }
                    let has_pane = !layout.tree.is_empty() || !layout.computation.is_empty();
                    assert_eq!(has_pane, !layout.is_too_small, "{width}x{height}: {layout:?}");
                }
            }
        }
    }

    #[track_caller]
    fn shows(size: (u16, u16), tree: bool, computation: bool) {
        let layout = Layout::of(size, Pane::Tree, false);
        assert_eq!((!layout.tree.is_empty(), !layout.computation.is_empty()), (tree, computation), "{layout:?}");
    }

    #[test]
    fn panes_by_size() {
        shows((80, 24), true, true);
        shows((80, 6), true, true);
        shows((40, 24), true, true);
        shows((40, 12), true, false);
        shows((19, 5), false, false);
    }
}
