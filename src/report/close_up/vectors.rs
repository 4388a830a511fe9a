//! The vectors at a hit, each in a plane in which it lies, so that the angles of the figure are those of the log (Ramos, figures 10 to 13).
//!
//! The arriving ray d, the normal N, V, R and T lie in the plane of incidence; N, L and the mirrored L in that of a light; L, V and the vector
//! halfway between them, H or H′, in a third one.

use super::hit::{lights, number, shade, unit, vector};
use super::sheet::{Ink, Piece, Plane, Point, Sheet, arc, arrow};
use super::{CloseUp, CloseUpError, Subject};
use crate::log::Name;
use crate::report::words;
use glam::DVec3;

/// The size of a sheet and the length of its unit vectors.
const SIZE: [f64; 2] = [280.0, 260.0];
const UNIT: f64 = 92.0;

/// Where the hit is.
const ORIGIN: Point = [SIZE[0] / 2.0, SIZE[1] / 2.0];

/// The radius of the arcs of angles.
const ARC: f64 = 34.0;

/// The most lights with sheets of their own.
const MOST_LIGHTS: usize = 4;

/// The vectors at the hit of a ray.
///
/// # Errors
/// No ray with the path, or no hit.
pub fn vectors(subject: &Subject) -> Result<CloseUp, CloseUpError> {
    let Subject { log, tree, language, .. } = *subject;
    let texts = &language.texts().close_up;
    let (ray, normal) = subject.first("a hit with its normal", |ray| vector(log, tree, ray, Name::HitNormalPlane))?;
    let mut made = Made { subject, sheets: Vec::new(), rows: Vec::new() };
    if let Some(incident) = vector(log, tree, ray, Name::RayDirection) {
        made.incidence(ray, normal, incident);
    }
    let shade = shade(tree, ray);
    let view = shade.and_then(|shade| vector(log, tree, shade, Name::ViewDirection));
    let points = shade.map(|shade| lights(tree, shade)).unwrap_or_default();
    // Of the points of an area light the first stands for all.
    for (node, light, _) in points.into_iter().filter(|(_, _, split)| *split <= 1).take(MOST_LIGHTS) {
        let name = words::plain(log.header.light(light));
        let Some(toward) = vector(log, tree, node, Name::LightDirection) else { continue };
        made.light(node, normal, toward, &name);
        if let Some(view) = view {
            made.halfway(node, normal, [toward, view], &name);
        }
    }
    Ok(CloseUp {
        title: (texts.vectors)(&tree.path(ray)),
        note: texts.vectors_note.to_owned(),
        columns: texts.vector_columns.map(str::to_owned).to_vec(),
        rows: made.rows,
        sheets: made.sheets,
    })
}

struct Made<'a> {
    subject: &'a Subject<'a>,
    sheets: Vec<Sheet>,
    rows: Vec<Vec<String>>,
}

impl Made<'_> {
    /// Figures 5, 10 and 11: the ray, what is reflected and what is transmitted.
    fn incidence(&mut self, ray: usize, normal: DVec3, incident: DVec3) {
        let Subject { log, tree, language, .. } = *self.subject;
        let texts = &language.texts().close_up;
        let Some(plane) = plane(normal, incident) else { return };
        let mut pieces = surface(&plane);
        // The ray ends where the vector to the viewer does, on the same line.
        let back = -incident;
        pieces.push(Piece::Arrow { from: plane.place(back), to: plane.place(back * 0.62), ink: Ink::Viewer });
        pieces.push(Piece::Text { at: plane.place(back * 1.14), text: "d".to_owned(), ink: Ink::Viewer });
        pieces.push(Piece::Arrow { from: plane.origin, to: plane.place(back * 0.6), ink: Ink::Viewer });
        let aside = plane.place(back * 0.6);
        pieces.push(Piece::Text { at: [aside[0] - 11.0, aside[1] + 9.0], text: "V".to_owned(), ink: Ink::Viewer });
        arrow(&mut pieces, &plane, normal, "N", Ink::Black);
        self.angle(&mut pieces, &plane, [("N", normal), ("V", back)], None);
        if let Some(reflected) = vector(log, tree, ray, Name::ReflectDirection) {
            arrow(&mut pieces, &plane, reflected, "R", Ink::Reflected);
            self.angle(&mut pieces, &plane, [("N", normal), ("R", reflected)], None);
        }
        let eta = number(log, tree, ray, Name::RefractEta);
        let transmitted = vector(log, tree, ray, Name::RefractDirection);
        if let Some(transmitted) = transmitted {
            arrow(&mut pieces, &plane, transmitted, "T", Ink::Transmitted);
            let down = plane.place(-normal);
            pieces.push(Piece::Line { from: plane.origin, to: down, ink: Ink::Gray, dashed: true });
            self.angle(&mut pieces, &plane, [("−N", -normal), ("T", transmitted)], None);
        }
        let eta = eta.map(|eta| format!("η = {}", self.subject.language.number(eta, self.subject.style)));
        let total = (eta.is_some() && transmitted.is_none()).then(|| texts.total_reflection.to_owned());
        let caption = [Some(texts.plane_of_incidence.to_owned()), eta, total];
        self.add(caption.into_iter().flatten().collect::<Vec<_>>().join(", "), pieces);
    }

    /// Figure 10: a light as the surface sees it, and its mirrored direction if that was computed.
    fn light(&mut self, node: usize, normal: DVec3, toward: DVec3, name: &str) {
        let Subject { log, tree, language, .. } = *self.subject;
        let Some(plane) = plane(normal, -toward) else { return };
        let mut pieces = surface(&plane);
        arrow(&mut pieces, &plane, normal, "N", Ink::Black);
        arrow(&mut pieces, &plane, toward, "L", Ink::Light);
        self.angle(&mut pieces, &plane, [("N", normal), ("L", toward)], Some(name));
        if let Some(mirrored) = vector(log, tree, node, Name::MirrorDirection) {
            arrow(&mut pieces, &plane, mirrored, "R_L", Ink::Reflected);
            self.angle(&mut pieces, &plane, [("N", normal), ("R_L", mirrored)], Some(name));
        }
        self.add((language.texts().close_up.plane_of_light)(name), pieces);
    }

    /// Figures 12 and 13: the vector halfway between L and V, on the viewer's side or on the other.
    fn halfway(&mut self, node: usize, normal: DVec3, [toward, view]: [DVec3; 2], name: &str) {
        let Subject { log, tree, language, .. } = *self.subject;
        let half = vector(log, tree, node, Name::HalfDirection);
        let transmitted = vector(log, tree, node, Name::TransmitDirection);
        let Some((symbol, half)) = half.map(|half| ("H", half)).or(transmitted.map(|half| ("H′", half))) else {
            return;
        };
        // The surface cuts this plane at right angles to the normal's part in it.
        let across = toward.cross(view);
        let in_plane = if across == DVec3::ZERO {
            half * half.dot(normal).signum()
        } else {
            normal - across * (normal.dot(across) / across.dot(across))
        };
        let Some(plane) = plane(in_plane, if across == DVec3::ZERO { half } else { -view }) else { return };
        let mut pieces = surface(&plane);
        arrow(&mut pieces, &plane, toward, "L", Ink::Light);
        arrow(&mut pieces, &plane, view, "V", Ink::Viewer);
        arrow(&mut pieces, &plane, half, symbol, Ink::Half);
        self.angle(&mut pieces, &plane, [("L", toward), (symbol, half)], Some(name));
        if symbol == Name::HalfDirection.symbol() {
            self.angle(&mut pieces, &plane, [("H", half), ("V", view)], Some(name));
        } else {
            let down = plane.place(-half);
            pieces.push(Piece::Line { from: plane.origin, to: down, ink: Ink::Gray, dashed: true });
            self.angle(&mut pieces, &plane, [("−H′", -half), ("V", view)], Some(name));
        }
        let mut caption = (language.texts().close_up.plane_of_view)(name);
        if let Some(eta) = number(log, tree, node, Name::TransmitEta) {
            caption = format!("{caption}, η = {}", language.number(eta, self.subject.style));
        }
        self.add(caption, pieces);
    }

    /// The angle between two vectors: an arc, and a row of the table, with the light that it is for.
    fn angle(
        &mut self,
        pieces: &mut Vec<Piece>,
        plane: &Plane,
        [(a, one), (b, other)]: [(&str, DVec3); 2],
        light: Option<&str>,
    ) {
        let Subject { language, style, .. } = *self.subject;
        let degrees = angle_of(one, other).to_degrees();
        let shown = format!("{}°", language.marked(format!("{degrees:.1}")));
        arc(pieces, plane, [one, other], ARC, shown.clone());
        let light = light.unwrap_or_default().to_owned();
        self.rows.push(vec![format!("{a}, {b}"), language.number(one.dot(other), style), shown, light]);
    }

    fn add(&mut self, caption: String, pieces: Vec<Piece>) {
        self.sheets.push(Sheet::new(caption, SIZE, ORIGIN, pieces));
    }
}

/// The angle between two vectors of any length, which the arc cosine of their product loses where they are nearly parallel.
fn angle_of(a: DVec3, b: DVec3) -> f64 {
    libm::atan2(a.cross(b).length(), a.dot(b))
}

/// The plane with this vector upward, and that one running to the right, or straight down.
fn plane(up: DVec3, along: DVec3) -> Option<Plane> {
    let up = unit(up)?;
    let right = unit(along - up * along.dot(up)).unwrap_or_else(|| up.any_orthonormal_vector());
    Some(Plane { origin: ORIGIN, right, up, unit: UNIT })
}

/// The surface, where it cuts the plane.
fn surface(plane: &Plane) -> Vec<Piece> {
    let [from, to] = [-plane.right, plane.right].map(|end| plane.place(end * 1.2));
    vec![Piece::Line { from, to, ink: Ink::Gray, dashed: false }]
}
