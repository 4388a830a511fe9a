//! What a figure is made of, before any format.

use crate::report::ray_group::RayGroup;
use glam::DVec3;

/// A place on a sheet: from the left and from the top, in hundredths of an inch or so.
pub type Point = [f64; 2];

/// A figure.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheet {
    /// The text below it.
    pub caption: String,
    /// How wide and high it is, without the caption.
    pub size: [f64; 2],
    /// What is drawn, in this order.
    pub pieces: Vec<Piece>,
}

/// A part of a figure.
#[derive(Clone, Debug, PartialEq)]
pub enum Piece {
    /// A line.
    Line {
        /// Where it begins.
        from: Point,
        /// Where it ends.
        to: Point,
        /// Its colour.
        ink: Ink,
        /// Whether it is dashed.
        dashed: bool,
    },
    /// A vector: a line with a tip at its end.
    Arrow {
        /// Where it begins.
        from: Point,
        /// Where its tip is.
        to: Point,
        /// Its colour.
        ink: Ink,
    },
    /// A line of several parts; closed and filled faintly if it is an area.
    Path {
        /// Its corners.
        points: Vec<Point>,
        /// Its colour.
        ink: Ink,
        /// Whether it is an area.
        is_area: bool,
    },
    /// A point.
    Dot {
        /// Its middle.
        at: Point,
        /// Its radius.
        radius: f64,
        /// Its colour.
        ink: Ink,
        /// Whether it is filled.
        filled: bool,
    },
    /// A text, by its middle.
    Text {
        /// The middle.
        at: Point,
        /// The text.
        text: String,
        /// Its colour.
        ink: Ink,
    },
}

/// What a part is for, which decides its colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ink {
    /// Text and the normal.
    Black,
    /// Lines and areas behind the vectors: axes, edges, the way onward.
    Gray,
    /// The arriving ray and the way back to the viewer.
    Viewer,
    /// What is reflected.
    Reflected,
    /// What is transmitted.
    Transmitted,
    /// A light.
    Light,
    /// A vector halfway between two others.
    Half,
    /// What is blocked or rejected.
    Blocked,
}

impl Ink {
    /// Every one.
    pub const ALL: [Ink; 8] =
        [Ink::Black, Ink::Gray, Ink::Viewer, Ink::Reflected, Ink::Transmitted, Ink::Light, Ink::Half, Ink::Blocked];

    /// Its name in LaTeX, and its colour as six hexadecimal digits: those of the rays in the other figures.
    fn look(self) -> (&'static str, &'static str) {
        match self {
            Ink::Black => ("plain", "1b1f27"),
            Ink::Gray => ("behind", "aab2bf"),
            Ink::Viewer => ("viewer", RayGroup::Camera.hex()),
            Ink::Reflected => ("reflected", RayGroup::Reflected.hex()),
            Ink::Transmitted => ("transmitted", RayGroup::Transmitted.hex()),
            Ink::Light => ("light", RayGroup::Shadow.hex()),
            Ink::Half => ("halfway", "8a3fb0"),
            Ink::Blocked => ("blocked", RayGroup::Blocked.hex()),
        }
    }

    pub(super) fn name(self) -> &'static str {
        self.look().0
    }

    pub(super) fn hex(self) -> &'static str {
        self.look().1
    }
}

/// A plane of space on a sheet: the origin of the vectors, two perpendicular unit directions, and the length of a unit vector.
pub(super) struct Plane {
    pub origin: Point,
    pub right: DVec3,
    pub up: DVec3,
    pub unit: f64,
}

impl Plane {
    /// The place of a vector's end.
    pub(super) fn place(&self, vector: DVec3) -> Point {
        [self.origin[0] + self.unit * vector.dot(self.right), self.origin[1] - self.unit * vector.dot(self.up)]
    }
}

/// A vector from the origin, and its name beyond its tip.
pub(super) fn arrow(pieces: &mut Vec<Piece>, plane: &Plane, vector: DVec3, name: &str, ink: Ink) {
    pieces.push(Piece::Arrow { from: plane.origin, to: plane.place(vector), ink });
    pieces.push(Piece::Text { at: plane.place(vector * (1.0 + NAME / plane.unit)), text: name.to_owned(), ink });
}

/// How far beyond the tip its name is.
const NAME: f64 = 13.0;

/// The angle between two vectors from the origin, the shorter way round, as an arc with its size on it.
pub(super) fn arc(pieces: &mut Vec<Piece>, plane: &Plane, [a, b]: [DVec3; 2], radius: f64, text: String) {
    let angle = |vector: DVec3| libm::atan2(vector.dot(plane.up), vector.dot(plane.right));
    let from = angle(a);
    let turn = std::f64::consts::TAU;
    let mut by = (angle(b) - from) % turn;
    if by.abs() > turn / 2.0 {
        by -= turn * by.signum();
    }
    let at = |part: f64, radius: f64| {
        let angle = from + by * part;
        [plane.origin[0] + radius * libm::cos(angle), plane.origin[1] - radius * libm::sin(angle)]
    };
    let points = (0..=STEPS).map(|step| at(f64::from(step) / f64::from(STEPS), radius)).collect();
    pieces.push(Piece::Path { points, ink: Ink::Gray, is_area: false });
    pieces.push(Piece::Text { at: at(0.5, radius + 17.0), text, ink: Ink::Black });
}

/// The parts of an arc.
const STEPS: u32 = 16;
