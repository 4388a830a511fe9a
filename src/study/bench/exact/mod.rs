//! Pictures that can be computed without sampling: objects of one colour each before a background, of which a pixel shows as much as
//! they cover of it; and diffuse surfaces in the light of a disk.

mod area;
mod kinks;
mod penumbra;
mod quadrature;
mod shadow;

pub use area::{of_ellipse, of_polygon};
pub use penumbra::Penumbra;
pub use quadrature::Estimate;

use crate::geometry::Shape;
use crate::sampling::ellipse::Ellipse;
use crate::sampling::outline::Outline;
use crate::scene::{Color, Material, Object, Scene};
use crate::trace::in_range;
use area::edges;

/// What a pixel of a scene is, exactly up to rounding.
#[derive(Clone, Debug, PartialEq)]
pub struct Exact {
    background: Color,
    resolution: [u32; 2],
    figures: Vec<Figure>,
}

/// An object in the picture.
#[derive(Clone, Debug, PartialEq)]
struct Figure {
    shape: Drawn,
    color: Color,
    outline: Outline,
}

#[derive(Clone, Debug, PartialEq)]
enum Drawn {
    Ellipse(Ellipse),
    Polygon(Vec<[f64; 2]>),
}

/// Why a scene's picture can't be computed so.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NotExact {
    /// A sample of the pixel decides more than its place.
    #[error("its camera has a lens or moving objects before it")]
    Camera,
    /// The shape's outline isn't one that is computed.
    #[error("object `{0}` isn't a polygon, triangle, disk, sphere or ellipsoid that lies wholly in front of the eye")]
    Shape(String),
    /// The colour isn't the same everywhere.
    #[error("object `{0}` hasn't one colour: a light, a pattern or a bounce changes it from place to place")]
    Color(String),
    /// Which of the two is seen would have to be known.
    #[error("objects `{0}` and `{1}` overlap in the picture")]
    Overlap(String, String),
    /// The light isn't one whose visible part is computed.
    #[error("its only light isn't a disk without profile and attenuation")]
    Lights,
    /// A surface shows more of the disk's light than its diffuse part.
    #[error(
        "object `{0}` isn't two-sided, opaque and diffuse only: a bounce, a highlight or a pattern changes what it shows"
    )]
    Diffuse(String),
    /// The shape's shadow isn't one that is computed.
    #[error(
        "object `{0}` isn't a plane, box, sphere, disk, triangle or convex polygon at rest without normals of its own"
    )]
    Occluder(String),
    /// A part of the shape is before the light, another behind it.
    #[error("object `{0}` may reach through the plane of the light")]
    BesideLight(String),
}

/// The picture of a scene without sampling, and its error if it is more than roundings, in the unit of its colours.
///
/// # Errors
/// [`NotExact`] where there is none, with the reason.
pub fn picture(scene: &Scene) -> Result<(Vec<Color>, Option<f64>), NotExact> {
    match Exact::of(scene) {
        Ok(exact) => Ok((exact.picture(), None)),
        Err(why) => {
            let Estimate { value, error } = penumbra(scene, why)?.picture();
            Ok((value, Some(error)))
        }
    }
}

/// Whether a scene has a picture without sampling.
pub fn is_possible(scene: &Scene) -> bool {
    Exact::of(scene).is_ok() || Penumbra::of(scene).is_ok()
}

/// The penumbra of a scene that has no exact areas. What is wrong with it is reported only where it has a disk for a light.
fn penumbra(scene: &Scene, why: NotExact) -> Result<Penumbra<'_>, NotExact> {
    Penumbra::of(scene).map_err(|other| if other == NotExact::Lights { why } else { other })
}

impl Exact {
    /// The exact picture of a scene.
    ///
    /// # Errors
    /// [`NotExact`] where there is none, with the reason.
    pub fn of(scene: &Scene) -> Result<Exact, NotExact> {
        if scene.camera.lens.is_some() || scene.camera.shutter.is_some() {
            return Err(NotExact::Camera);
        }
        let figures = scene.objects.iter().map(|object| figure(scene, object)).collect::<Result<Vec<_>, _>>()?;
        let named = || figures.iter().zip(&scene.objects);
        for (k, (one, object)) in named().enumerate() {
            if let Some((_, other)) = named().skip(k + 1).find(|(other, _)| one.outline.overlaps(&other.outline)) {
                return Err(NotExact::Overlap(object.name.to_string(), other.name.to_string()));
            }
        }
        Ok(Exact { background: scene.background, resolution: scene.camera.resolution, figures })
    }

    /// The picture, row by row.
    pub fn picture(&self) -> Vec<Color> {
        let [width, height] = self.resolution;
        (0..height).flat_map(|row| (0..width).map(move |column| self.pixel([column, row]))).collect()
    }

    /// The mean over a pixel.
    pub fn pixel(&self, pixel: [u32; 2]) -> Color {
        let place @ [left, top] = pixel.map(f64::from);
        let is_near = |figure: &&Figure| figure.outline.reaches_into([left, top, left + 1.0, top + 1.0]);
        let difference = |figure: &Figure| {
            let covered = match &figure.shape {
                Drawn::Ellipse(ellipse) => of_ellipse(ellipse, place),
                Drawn::Polygon(corners) => of_polygon(corners, place),
            };
            (figure.color - self.background) * covered
        };
        self.background + self.figures.iter().filter(is_near).map(difference).sum::<Color>()
    }
}

fn figure(scene: &Scene, object: &Object) -> Result<Figure, NotExact> {
    let color =
        color(scene, &scene.materials[object.material]).ok_or_else(|| NotExact::Color(object.name.to_string()))?;
    let (shape, outline) = drawn(scene, object).ok_or_else(|| NotExact::Shape(object.name.to_string()))?;
    Ok(Figure { shape, color, outline })
}

/// The colour of a surface that has one wherever it is seen.
fn color(scene: &Scene, material: &Material) -> Option<Color> {
    let is_lit = scene.lights.iter().any(|light| light.color != Color::ZERO)
        && (material.uses_light_in_front() || material.uses_light_behind());
    let bounces = material.reflects() && scene.tracing.goes_deeper(0);
    let is_plain = material.pattern.is_none() && !is_lit && !bounces;
    is_plain.then(|| in_range(material.weights.local * in_range(scene.ambient * material.ambient)))
}

fn drawn(scene: &Scene, object: &Object) -> Option<(Drawn, Outline)> {
    let camera = &scene.camera;
    let places =
        object.shape.corners()?.into_iter().map(|corner| camera.place_of(corner)).collect::<Option<Vec<_>>>()?;
    if let Some(round) = object.shape.round() {
        let is_seen_from_both_sides = !object.one_sided || !matches!(object.shape, Shape::Disk(_));
        let ellipse = Ellipse::seen(camera, &round).filter(|_| is_seen_from_both_sides)?;
        return Some((Drawn::Ellipse(ellipse), Outline::around(ellipse.corners())));
    }
    let is_flat = match &object.shape {
        Shape::Triangle(_) => true,
        Shape::Polygon(polygon) => polygon.is_plane() && !crosses_itself(&places),
        _ => false,
    };
    (is_flat && !object.one_sided).then(|| (Drawn::Polygon(places.clone()), Outline::around(places)))
}

/// Whether two edges that aren't neighbours have a point in common.
fn crosses_itself(corners: &[[f64; 2]]) -> bool {
    let turn =
        |[x, y]: [f64; 2], [b_x, b_y]: [f64; 2], [c_x, c_y]: [f64; 2]| (b_x - x) * (c_y - y) - (b_y - y) * (c_x - x);
    let parts = |[a, b]: [[f64; 2]; 2], c, d| turn(a, b, c) * turn(a, b, d) <= 0.0;
    let edges: Vec<_> = edges(corners).collect();
    let count = edges.len();
    let is_apart = |one: usize, other: usize| other > one + 1 && !(one == 0 && other == count - 1);
    let meet = |one: usize, other: usize| {
        let ([a, b], [c, d]) = (edges[one], edges[other]);
        is_apart(one, other) && parts([a, b], c, d) && parts([c, d], a, b)
    };
    (0..count).any(|one| (0..count).any(|other| meet(one, other)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bow_tie_crosses_itself() {
        assert!(crosses_itself(&[[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]]));
        assert!(!crosses_itself(&[[0.0, 0.0], [4.0, 0.0], [1.0, 1.0], [0.0, 4.0]]));
        assert!(!crosses_itself(&[[0.0, 0.0], [4.0, 0.0], [1.0, 1.0]]));
    }
}
