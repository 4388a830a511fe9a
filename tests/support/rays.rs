//! Rays at shapes, for the property tests.

// Each test file compiles this for itself and uses a part of it.
#![allow(dead_code)]

use glam::DVec3;
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use raywalk::geometry::{Crossing, Intersect, Ray, Shape, Surface, Target};
use raywalk::probe::Silent;
use std::cell::Cell;

pub const CASES: u32 = 2000;

/// What a unit vector may differ from length 1, and a point from its surface, in units of the numbers that it is made of.
pub const FEW_ULPS: f64 = 4.0 * f64::EPSILON;

pub fn meet(shape: &Shape, ray: &Ray) -> Option<(Crossing, Surface)> {
    let crossing = shape.first_crossing(Target::two_sided(0), ray, &mut Silent)?;
    Some((crossing, shape.surface(ray, crossing, &mut Silent)))
}

pub fn ray_through(origin: DVec3, target: DVec3) -> Ray {
    let way = target - origin;
    Ray::new(origin, way / way.length())
}

/// Runs a property that says whether the ray hit; both outcomes must occur often.
pub fn property<S: Strategy>(strategy: S, hits: impl Fn(S::Value) -> bool) {
    let (hit, missed) = (Cell::new(0), Cell::new(0));
    let config = Config { cases: CASES, failure_persistence: None, ..Config::default() };
    let mut runner = TestRunner::new_with_rng(config, TestRng::deterministic_rng(RngAlgorithm::ChaCha));
    let result = runner.run(&strategy, |value| {
        let outcome = if hits(value) { &hit } else { &missed };
        outcome.set(outcome.get() + 1);
        Ok(())
    });
    result.unwrap_or_else(|failure| panic!("{failure}"));
    let (hit, missed) = (hit.get(), missed.get());
    assert!(hit > CASES / 10 && missed > CASES / 10, "{hit} hits and {missed} misses");
}

pub fn point() -> impl Strategy<Value = DVec3> {
    prop::array::uniform3(-10.0..10.0_f64).prop_map(DVec3::from)
}

/// From 10⁻⁶ to 10⁶.
pub fn scale() -> impl Strategy<Value = f64> {
    (-20..=20_i32).prop_map(|power| if power < 0 { 1.0 / f64::from(1 << -power) } else { f64::from(1 << power) })
}
