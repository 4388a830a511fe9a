//! Random ellipsoids, cylinders and cones, each with an independent look at what is inside, and rays toward them.

// Each test file compiles this for itself and uses a part of it.
#![allow(dead_code)]

use glam::{DVec2, DVec3};
use proptest::prelude::*;
use proptest::test_runner::{RngAlgorithm, TestCaseError, TestRng, TestRunner};
use raywalk::geometry::shape::{Cone, Cylinder, Ellipsoid};
use raywalk::geometry::{Crossing, Intersect, Ray, Shape, Surface, Target};
use raywalk::probe::Silent;
use std::cell::Cell;

pub fn first(shape: &Shape, ray: &Ray) -> Option<Crossing> {
    shape.first_crossing(Target::two_sided(0), ray, &mut Silent)
}

pub fn all(shape: &Shape, ray: &Ray) -> Vec<Crossing> {
    let mut found = Vec::new();
    shape.all_crossings(Target::two_sided(0), ray, &mut found, &mut Silent);
    found
}

pub fn surface(shape: &Shape, ray: &Ray, crossing: Crossing) -> Surface {
    shape.surface(ray, crossing, &mut Silent)
}

/// A random solid with what an independent look at it says.
#[derive(Clone, Debug)]
pub struct Solid {
    pub shape: Shape,
    /// The greatest coordinate that occurs in it.
    pub scale: f64,
    pub center: DVec3,
    pub size: f64,
    pub form: Form,
}

#[derive(Clone, Debug)]
pub enum Form {
    Ellipsoid {
        axes: [DVec3; 3],
        radii: [f64; 3],
    },
    /// Ends, radii, whether it has caps.
    Round {
        ends: [DVec3; 2],
        radii: [f64; 2],
        caps: bool,
    },
}

impl Solid {
    /// How deep a point lies inside, to first order; negative outside.
    pub fn depth(&self, point: DVec3) -> f64 {
        match &self.form {
            Form::Ellipsoid { axes, radii } => {
                let p = point - self.center;
                let scaled = [0, 1, 2].map(|i| axes[i].dot(p) / radii[i]);
                let value = scaled.iter().map(|x| x * x).sum::<f64>() - 1.0;
                let gradient: DVec3 = (0..3).map(|i| axes[i] * (scaled[i] / radii[i])).sum();
                -value / (2.0 * gradient.length())
            }
            Form::Round { ends, radii, .. } => {
                let axis = ends[1] - ends[0];
                let along = (point - ends[0]).dot(axis) / axis.length();
                let rise = radii[1] - radii[0];
                let distance = (point - ends[0]).cross(axis).length() / axis.length();
                let lateral = radii[0] + rise / axis.length() * along - distance;
                let lateral = lateral * axis.length() / DVec2::new(axis.length(), rise).length();
                lateral.min(along).min(axis.length() - along)
            }
        }
    }

    pub fn is_open(&self) -> bool {
        matches!(self.form, Form::Round { caps: false, .. })
    }

    /// A point of the surface (of the lateral one), from two numbers in −1 … 1 and a direction.
    pub fn point(&self, [height, _]: [f64; 2], around: DVec3) -> DVec3 {
        match &self.form {
            Form::Ellipsoid { axes, radii } => {
                self.center
                    + axes[0] * (radii[0] * around.x)
                    + axes[1] * (radii[1] * around.y)
                    + axes[2] * (radii[2] * around.z)
            }
            Form::Round { ends, radii, .. } => {
                let part = height * 0.5 + 0.5;
                let axis = unit(ends[1] - ends[0]);
                let across = around - axis * around.dot(axis);
                let radius = radii[0] + (radii[1] - radii[0]) * part;
                ends[0] + (ends[1] - ends[0]) * part + unit(across) * radius
            }
        }
    }
}

pub fn unit(vector: DVec3) -> DVec3 {
    vector / vector.length()
}

/// 10 to the power x.
pub fn ten_to(x: f64) -> f64 {
    libm::pow(10.0, x)
}

pub fn triple() -> impl Strategy<Value = DVec3> {
    [-1.0..1.0, -1.0..1.0, -1.0..1.0].prop_map(DVec3::from)
}

pub fn direction() -> impl Strategy<Value = DVec3> {
    triple().prop_filter("a direction", |vector| vector.length() > 0.1).prop_map(unit)
}

/// A place: mostly near, sometimes up to 1e4 sizes away from the origin of space.
pub fn place() -> impl Strategy<Value = DVec3> {
    (triple(), 0.0..4.0).prop_map(|(vector, far)| vector * ten_to(far))
}

pub fn ellipsoid() -> impl Strategy<Value = Solid> {
    (place(), [-1.5..1.5, -1.5..1.5, -1.5..1.5], -1.5..1.5, direction(), direction())
        .prop_filter("a frame", |(_, _, _, x, y)| x.cross(*y).length() > 0.1)
        .prop_map(|(place, radii, size, x, y)| {
            let radii = radii.map(|radius: f64| ten_to(radius + size));
            let z = unit(x.cross(y));
            let axes = [x, z.cross(x), z];
            let rotation = [0, 1, 2].map(|i| [axes[0][i], axes[1][i], axes[2][i]]);
            let size = radii[0].max(radii[1]).max(radii[2]);
            let center = place * size;
            let shape = Shape::Ellipsoid(Box::new(Ellipsoid::new(center, radii.into(), Some(rotation))));
            Solid { shape, scale: center.length() + size, center, size, form: Form::Ellipsoid { axes, radii } }
        })
}

pub fn round() -> impl Strategy<Value = Solid> {
    let radii = prop_oneof![
        (-1.5..1.5).prop_map(|a: f64| [a, a].map(ten_to)),
        [-1.5..1.5, -1.5..1.5].prop_map(|radii: [f64; 2]| radii.map(ten_to)),
        (-1.5..1.5).prop_map(|a: f64| [ten_to(a), 0.0]),
        (-1.5..1.5).prop_map(|a: f64| [0.0, ten_to(a)]),
    ];
    (place(), direction(), radii, -1.5..1.5, -1.5..1.5, any::<bool>(), any::<bool>()).prop_map(
        |(place, axis, radii, length, size, caps, as_cone)| {
            let (radii, length) = (radii.map(|radius| radius * ten_to(size)), ten_to(length + size));
            let size = length.max(radii[0]).max(radii[1]);
            let base = place * size;
            let ends = [base, base + axis * length];
            let shape = if radii[0] == radii[1] && !as_cone {
                Shape::Cylinder(Box::new(Cylinder::new(ends[0], ends[1], radii[0], caps, false)))
            } else {
                Shape::Cone(Box::new(Cone::new((ends[0], radii[0]), (ends[1], radii[1]), caps, false)))
            };
            let center = (ends[0] + ends[1]) * 0.5;
            Solid { shape, scale: center.length() + 2.0 * size, center, size, form: Form::Round { ends, radii, caps } }
        },
    )
}

pub fn solid() -> impl Strategy<Value = Solid> {
    prop_oneof![ellipsoid(), round()]
}

/// A solid and a ray toward a point near its surface, from inside, from close by or from afar.
pub fn aimed() -> impl Strategy<Value = (Solid, Ray)> {
    let origin = (direction(), -1.0..3.0).prop_map(|(direction, far)| direction * ten_to(far));
    (solid(), origin, [-1.0..1.0, -1.0..1.0], direction(), triple(), -2.0..0.5).prop_map(
        |(solid, origin, place, around, aside, wide)| {
            let target = solid.point(place, around) + aside * (solid.size * ten_to(wide));
            let origin = solid.center + origin * solid.size;
            let ray = Ray::new(origin, unit(target - origin));
            (solid, ray)
        },
    )
}

/// The magnitude of the numbers that a hit is computed from.
pub fn scale(solid: &Solid, ray: &Ray) -> f64 {
    solid.scale + (ray.origin - solid.center).length()
}

/// Runs a property; its result tells the outcome, and each of `outcomes` must have occurred in one of 25 cases.
#[track_caller]
pub fn holds<S: Strategy>(
    strategy: S,
    outcomes: &[&str],
    property: impl Fn(S::Value) -> Result<&'static str, TestCaseError>,
) {
    const CASES: u32 = 4000;
    let counts: Vec<_> = outcomes.iter().map(|_| Cell::new(0)).collect();
    let config = ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(CASES) };
    let result =
        TestRunner::new_with_rng(config, TestRng::deterministic_rng(RngAlgorithm::ChaCha)).run(&strategy, |case| {
            let outcome = property(case)?;
            let index = outcomes.iter().position(|known| *known == outcome).expect("one of the outcomes");
            counts[index].set(counts[index].get() + 1);
            Ok(())
        });
    if let Err(error) = result {
        panic!("{error}");
    }
    for (outcome, count) in outcomes.iter().zip(&counts) {
        assert!(count.get() * 25 > CASES, "{outcome}: {} of {CASES}", count.get());
    }
}
