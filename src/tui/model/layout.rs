//! Where the panes lie, by the size of the terminal.

use ratatui::layout::Rect;

/// A pane, in the order of `Tab`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pane {
    /// The picture.
    Picture,
    /// The ray tree.
    Tree,
    /// The computation of the selected node.
    Computation,
    /// The algorithm as the source text writes it.
    Code,
    /// The scene with the rays in it.
    Schematic,
}

impl Pane {
    /// All panes.
    pub const ALL: [Pane; 5] = [Pane::Picture, Pane::Tree, Pane::Computation, Pane::Code, Pane::Schematic];
}

/// What decides where the panes lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Arrangement {
    /// Columns and rows of the terminal.
    pub size: (u16, u16),
    /// The pane that the keys move in.
    pub focus: Pane,
    /// The pane that is beside the tree where there is room for two.
    pub side: Pane,
    /// Whether only the pane with the focus is shown.
    pub is_alone: bool,
    /// How many columns the tree is wider than usual.
    pub shift: i16,
    /// Whether there is a picture.
    pub has_picture: bool,
}

/// The places on the screen. A pane that isn't shown has no area.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Layout {
    areas: [Rect; Pane::ALL.len()],
    /// The columns between panes that are side by side.
    pub dividers: [Rect; 2],
    /// The bottom line.
    pub status: Rect,
    /// Whether the terminal is too small to show anything.
    pub is_too_small: bool,
}

const SMALLEST: (u16, u16) = (20, 6);
const WIDE: u16 = 80;
const TALL: u16 = 20;
/// From this size on all panes are shown at once.
const LARGE: (u16, u16) = (140, 34);
/// From this size on the picture is below the tree, if there is one.
const MIDDLING: (u16, u16) = (100, 28);
/// The fewest columns of a pane that is beside another.
const NARROWEST: u16 = 20;

impl Layout {
    /// All panes when the terminal is large; the tree, the picture and another pane when it is of moderate size; else the tree
    /// and another pane side by side when it is wide, one above the other when it is tall; else one at a time.
    pub fn of(arrangement: &Arrangement) -> Layout {
        let (width, height) = arrangement.size;
        if width < SMALLEST.0 || height < SMALLEST.1 {
            return Layout { is_too_small: true, ..Layout::default() };
        }
        let panes = Rect::new(0, 0, width, height - 1);
        let mut layout = Layout { status: Rect::new(0, height - 1, width, 1), ..Layout::default() };
        if arrangement.is_alone {
            layout.put(arrangement.focus, panes);
        } else if width >= LARGE.0 && height >= LARGE.1 {
            layout.all(arrangement, panes);
        } else if width >= MIDDLING.0 && height >= MIDDLING.1 && arrangement.has_picture {
            layout.with_picture(arrangement, panes);
        } else if width >= WIDE {
            layout.side_by_side(arrangement, panes);
        } else if height >= TALL {
            layout.stacked(arrangement, panes);
        } else {
            layout.put(arrangement.focus, panes);
        }
        layout
    }

    /// Where a pane lies, with its title above.
    pub fn area(&self, pane: Pane) -> Rect {
        self.areas[pane as usize]
    }

    /// How many rows of the tree are shown below its title; those of the pane with the focus where the tree isn't shown.
    pub fn page(&self, focus: Pane) -> usize {
        let tree = self.area(Pane::Tree);
        let shown = if tree.is_empty() { self.area(focus) } else { tree };
        usize::from(shown.height).saturating_sub(1)
    }

    /// The place below the title of a pane.
    pub fn body(pane: Rect) -> Rect {
        Rect { y: pane.y + u16::from(pane.height > 0), height: pane.height.saturating_sub(1), ..pane }
    }

    /// Where in its pane the picture itself lies: below the title, and above the row that says what the cursor is on.
    pub fn dots(pane: Rect) -> Rect {
        let body = Layout::body(pane);
        Rect { height: body.height.saturating_sub(u16::from(body.height > 3)), ..body }
    }

    fn put(&mut self, pane: Pane, area: Rect) {
        self.areas[pane as usize] = area;
    }

    fn side_by_side(&mut self, arrangement: &Arrangement, panes: Rect) {
        let usual = (panes.width * 2 / 5).clamp(36, 76);
        let (tree, divider, side) = columns(panes, shifted(usual, arrangement.shift, panes.width));
        self.dividers[0] = divider;
        self.put(Pane::Tree, tree);
        self.put(arrangement.side, side);
    }

    /// The tree above the picture, and another pane beside them.
    fn with_picture(&mut self, arrangement: &Arrangement, panes: Rect) {
        let side = if arrangement.side == Pane::Picture { Pane::Computation } else { arrangement.side };
        self.side_by_side(&Arrangement { side, ..*arrangement }, panes);
        let left = self.area(Pane::Tree);
        let (tree, picture) = rows(left, left.height * 3 / 5);
        self.put(Pane::Tree, tree);
        self.put(Pane::Picture, picture);
    }

    fn stacked(&mut self, arrangement: &Arrangement, panes: Rect) {
        let (tree, side) = rows(panes, panes.height * 2 / 5);
        self.put(Pane::Tree, tree);
        self.put(arrangement.side, side);
    }

    /// The picture above the schematic, the tree, and the computation above the code.
    fn all(&mut self, arrangement: &Arrangement, panes: Rect) {
        let left_width = (panes.width * 3 / 10).clamp(NARROWEST, 90);
        let (left, divider, rest) = columns(panes, left_width);
        self.dividers[0] = divider;
        let tree_width = shifted((rest.width * 2 / 5).clamp(36, 76), arrangement.shift, rest.width);
        let (tree, divider, right) = columns(rest, tree_width);
        self.dividers[1] = divider;
        self.put(Pane::Tree, tree);
        if arrangement.has_picture {
            let (picture, schematic) = rows(left, left.height / 2);
            self.put(Pane::Picture, picture);
            self.put(Pane::Schematic, schematic);
        } else {
            self.put(Pane::Schematic, left);
        }
        let (computation, code) = rows(right, right.height * 3 / 5);
        self.put(Pane::Computation, computation);
        self.put(Pane::Code, code);
    }
}

/// A width that was changed by hand, so that both sides keep room.
fn shifted(width: u16, shift: i16, whole: u16) -> u16 {
    width.saturating_add_signed(shift).clamp(NARROWEST, whole - NARROWEST - 1)
}

/// An area cut into a left part of this width, a divider and the rest.
fn columns(area: Rect, width: u16) -> (Rect, Rect, Rect) {
    let left = Rect { width, ..area };
    let divider = Rect { x: left.right(), width: 1, ..area };
    (left, divider, Rect { x: divider.right(), width: area.width - width - 1, ..area })
}

/// An area cut into an upper part of this height and the rest.
fn rows(area: Rect, height: u16) -> (Rect, Rect) {
    let above = Rect { height, ..area };
    (above, Rect { y: above.bottom(), height: area.height - height, ..area })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn arrangement(size: (u16, u16)) -> Arrangement {
        Arrangement { size, focus: Pane::Tree, side: Pane::Computation, is_alone: false, shift: 0, has_picture: true }
    }

    #[test]
    fn every_area_lies_on_the_screen_and_none_on_another() {
        for (width, height) in
            (0..340).step_by(7).flat_map(|width| (0..120).step_by(3).map(move |height| (width, height)))
        {
            for (number, focus) in Pane::ALL.into_iter().cycle().take(10).enumerate() {
                let shown = Arrangement {
                    focus,
                    side: if focus == Pane::Tree { Pane::Computation } else { focus },
                    is_alone: number % 4 == 3,
                    shift: [0, -300, 300][number % 3],
                    has_picture: number % 2 == 0 || focus == Pane::Picture,
                    ..arrangement((width, height))
                };
                let layout = Layout::of(&shown);
                let screen = Rect::new(0, 0, width, height);
                let panes = Pane::ALL.map(|pane| layout.area(pane));
                let all: Vec<_> = panes.into_iter().chain(layout.dividers).chain([layout.status]).collect();
                for (at, area) in all.iter().enumerate() {
                    assert!(area.is_empty() || screen.intersection(*area) == *area, "{shown:?}: {layout:?}");
                    let covers = |other: &Rect| !area.intersection(*other).is_empty();
                    assert!(!all[at + 1..].iter().any(covers), "{shown:?}: {layout:?}");
                }
                assert_eq!(layout.area(focus).is_empty(), layout.is_too_small, "{shown:?}: {layout:?}");
            }
        }
    }

    #[track_caller]
    fn shows(size: (u16, u16), expected: &[Pane]) {
        let layout = Layout::of(&arrangement(size));
        let shown: Vec<_> = Pane::ALL.into_iter().filter(|pane| !layout.area(*pane).is_empty()).collect();
        assert_eq!(shown, expected, "{layout:?}");
    }

    #[test]
    fn panes_by_size() {
        use Pane::{Computation, Picture, Tree};
        shows((200, 60), &Pane::ALL);
        shows((140, 33), &[Picture, Tree, Computation]);
        shows((140, 27), &[Tree, Computation]);
        shows((80, 24), &[Tree, Computation]);
        shows((80, 6), &[Tree, Computation]);
        shows((40, 24), &[Tree, Computation]);
        shows((40, 12), &[Tree]);
        shows((19, 5), &[]);
    }
}
