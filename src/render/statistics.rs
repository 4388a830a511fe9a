//! How many rays a picture took. Counting is a probe like any other, so that a picture which isn't counted pays nothing.

use super::losses::{Losses, Lost};
use crate::log::{Decision, Name, RayKind, SkipReason, Step, Value};
use crate::probe::{Probe, Quantity, Saving};
use serde::Serialize;
use std::collections::BTreeMap;
use std::fmt;

/// Counts rays, hits and what was skipped.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Counter {
    rays: ByKind,
    hits: ByKind,
    by_depth: Vec<u64>,
    skipped: [u64; SkipReason::ALL.len()],
    /// Rays that weren't traced, by rule.
    skipped_rays: [u64; SkipReason::ALL.len()],
    beyond_limit: u64,
    shared: u64,
    unsearched: u64,
    rejected: u64,
    primitive_tests: u64,
    bounds_tests: u64,
    fallbacks: u64,
    samples: u64,
    losses: Losses,
    /// The nodes that the computation is inside.
    open: Vec<Open>,
}

/// What a node is to the counter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Open {
    Ray(RayKind),
    Zone,
    Other,
}

/// A number for each kind of ray.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct ByKind {
    /// Rays from the eye.
    pub camera: u64,
    /// Mirrored rays.
    pub reflected: u64,
    /// Refracted rays.
    pub transmitted: u64,
    /// Rays to lights.
    pub shadow: u64,
}

/// The statistics of a picture, as `render --stats json` prints them.
#[derive(Clone, Debug, Serialize)]
pub struct Statistics {
    /// Rays of each kind.
    pub rays: Rays,
    /// Rays that met an object; of shadow rays those fully blocked.
    pub hits: ByKind,
    /// Rays but shadow rays, by their level in the ray tree.
    pub by_depth: Vec<u64>,
    /// Work left out, by rule.
    pub skipped: BTreeMap<&'static str, u64>,
    /// Rays that weren't traced, by rule and by `depth_limit` and `shared`: at most where it wasn't asked whether there
    /// would have been one. What they would have spawned isn't counted.
    pub saved: BTreeMap<&'static str, u64>,
    /// Shadow rays that nothing can block, which are counted here and searched only because they are counted.
    pub free_shadow_rays: u64,
    /// What cutoffs lost at most, if there were any.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lost: Option<Lost>,
    /// Directions of blurred bounces on the wrong side of a surface.
    pub rejected: u64,
    /// Intersection tests.
    pub tests: Tests,
    /// Decisions that needed more than f64.
    pub fallbacks: u64,
    /// Samples of all pixels.
    pub samples: u64,
    /// Pixels that the format couldn't hold without clipping.
    pub clipped_pixels: u64,
    /// Seconds of each stage.
    pub seconds: Seconds,
    /// The most memory that the program held.
    pub peak_bytes: u64,
}

/// Rays of each kind, and all of them.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Rays {
    #[serde(flatten)]
    by_kind: ByKind,
    total: u64,
}

/// Intersection tests.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Tests {
    /// With bounding volumes.
    pub bounds: u64,
    /// With shapes.
    pub primitives: u64,
}

/// Seconds of each stage.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Seconds {
    /// Reading the scene.
    pub load: f64,
    /// Making it ready.
    pub build: f64,
    /// Tracing.
    pub render: f64,
}

impl Counter {
    /// Adds what another counter counted.
    pub fn add(&mut self, other: &Counter) {
        self.rays.add(&other.rays);
        self.hits.add(&other.hits);
        if self.by_depth.len() < other.by_depth.len() {
            self.by_depth.resize(other.by_depth.len(), 0);
        }
        for (ours, theirs) in self.by_depth.iter_mut().zip(&other.by_depth) {
            *ours += theirs;
        }
        for (ours, theirs) in self.skipped.iter_mut().zip(&other.skipped) {
            *ours += theirs;
        }
        for (ours, theirs) in self.skipped_rays.iter_mut().zip(&other.skipped_rays) {
            *ours += theirs;
        }
        self.beyond_limit += other.beyond_limit;
        self.shared += other.shared;
        self.unsearched += other.unsearched;
        self.losses.add(&other.losses);
        self.rejected += other.rejected;
        self.primitive_tests += other.primitive_tests;
        self.bounds_tests += other.bounds_tests;
        self.fallbacks += other.fallbacks;
        self.samples += other.samples;
    }

    /// The statistics, with what the counter can't know. `share` is the most that a sample counts for over all pixels, see
    /// [`Sampling::largest_share`](crate::scene::Sampling::largest_share).
    pub fn statistics_of(&self, share: f64, clipped_pixels: u64, seconds: Seconds, peak_bytes: u64) -> Statistics {
        Statistics { lost: self.losses.lost(share), ..self.statistics(clipped_pixels, seconds, peak_bytes) }
    }

    /// The statistics of a picture of one ray a pixel.
    pub fn statistics(&self, clipped_pixels: u64, seconds: Seconds, peak_bytes: u64) -> Statistics {
        let skipped = SkipReason::ALL.iter().map(|why| (why.word(), self.skipped[*why as usize]));
        let saved = SkipReason::ALL.iter().map(|why| (why.word(), self.skipped_rays[*why as usize]));
        Statistics {
            rays: Rays { by_kind: self.rays, total: self.rays.total() },
            hits: self.hits,
            by_depth: self.by_depth.clone(),
            skipped: skipped.collect(),
            saved: saved.chain([("depth_limit", self.beyond_limit), ("shared", self.shared)]).collect(),
            free_shadow_rays: self.unsearched,
            lost: self.losses.lost(1.0),
            rejected: self.rejected,
            tests: Tests { bounds: self.bounds_tests, primitives: self.primitive_tests },
            fallbacks: self.fallbacks,
            samples: self.samples,
            clipped_pixels,
            seconds,
            peak_bytes,
        }
    }

    /// Rays of all kinds.
    pub fn rays(&self) -> u64 {
        self.rays.total()
    }

    /// Tests of shapes.
    pub fn primitive_tests(&self) -> u64 {
        self.primitive_tests
    }

    /// Tests of boxes.
    pub fn bounds_tests(&self) -> u64 {
        self.bounds_tests
    }

    /// Rays from the eye.
    pub fn samples(&self) -> u64 {
        self.samples
    }

    fn ray_here(&self) -> Option<RayKind> {
        self.open.iter().rev().find_map(|open| match open {
            Open::Ray(kind) => Some(*kind),
            _ => None,
        })
    }
}

impl Probe for Counter {
    const USES_SIMD: bool = true;

    fn given<Q: Quantity>(&mut self, name: Name, value: Q) {
        if name == Name::CutoffLoss
            && let Value::Triple(bound) = value.value()
        {
            self.losses.give(bound.into());
        }
    }

    fn bounds_tested(&mut self, count: u64) {
        self.bounds_tests += count;
    }

    fn fallback(&mut self) {
        self.fallbacks += 1;
    }

    fn rays_saved(&mut self, why: Saving, rays: u64) {
        *match why {
            Saving::Skipped(rule) => &mut self.skipped_rays[rule as usize],
            Saving::DepthLimit => &mut self.beyond_limit,
            Saving::Shared => &mut self.shared,
            Saving::Search => &mut self.unsearched,
        } += rays;
    }

    fn enter(&mut self, step: Step) {
        let open = match step {
            Step::Ray { kind, depth, .. } => {
                *self.rays.of(kind) += 1;
                if !matches!(kind, RayKind::Shadow { .. }) {
                    let level = depth as usize;
                    if self.by_depth.len() <= level {
                        self.by_depth.resize(level + 1, 0);
                    }
                    self.by_depth[level] += 1;
                }
                self.samples += u64::from(kind == RayKind::Camera);
                Open::Ray(kind)
            }
            Step::Test { .. } => {
                self.primitive_tests += 1;
                Open::Other
            }
            Step::Zone { .. } => Open::Zone,
            _ => Open::Other,
        };
        if let Open::Ray(RayKind::Camera) | Open::Zone = open {
            self.losses.enter(step);
        }
        self.open.push(open);
    }

    fn leave(&mut self) {
        if let Some(Open::Ray(RayKind::Camera) | Open::Zone) = self.open.pop() {
            self.losses.leave();
        }
    }

    fn mark(&mut self, decision: Decision) {
        match decision {
            Decision::Nearest { .. } | Decision::Occluded { .. } => {
                if let Some(kind) = self.ray_here() {
                    *self.hits.of(kind) += 1;
                }
            }
            Decision::Rejected { .. } => self.rejected += 1,
            Decision::Skipped { why, .. } => {
                self.skipped[why as usize] += 1;
                if why == SkipReason::Cutoff {
                    self.losses.cut_off();
                }
            }
            _ => {}
        }
    }
}

impl ByKind {
    fn of(&mut self, kind: RayKind) -> &mut u64 {
        match kind {
            RayKind::Camera => &mut self.camera,
            RayKind::Reflected => &mut self.reflected,
            RayKind::Transmitted => &mut self.transmitted,
            RayKind::Shadow { .. } => &mut self.shadow,
        }
    }

    fn add(&mut self, other: &ByKind) {
        self.camera += other.camera;
        self.reflected += other.reflected;
        self.transmitted += other.transmitted;
        self.shadow += other.shadow;
    }

    fn total(&self) -> u64 {
        self.camera + self.reflected + self.transmitted + self.shadow
    }
}

impl fmt::Display for Statistics {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let rows = [
            ("camera", self.rays.by_kind.camera, self.hits.camera),
            ("reflected", self.rays.by_kind.reflected, self.hits.reflected),
            ("transmitted", self.rays.by_kind.transmitted, self.hits.transmitted),
            ("shadow", self.rays.by_kind.shadow, self.hits.shadow),
        ];
        writeln!(f, "{:<12}{:>14}{:>14}", "", "rays", "hits")?;
        for (kind, rays, hits) in rows {
            writeln!(f, "{kind:<12}{rays:>14}{hits:>14}")?;
        }
        writeln!(f, "{:<12}{:>14}", "total", self.rays.total)?;
        for (why, count) in self.skipped.iter().filter(|(_, count)| **count > 0) {
            let rays = self.saved.get(why).copied().unwrap_or(0);
            writeln!(f, "skipped {why}: {count} ({rays} rays)")?;
        }
        let saved = |why| self.saved.get(why).copied().unwrap_or(0);
        for (what, rays) in [
            ("rays beyond the depth limit", saved("depth_limit")),
            ("rays shared by pixels", saved("shared")),
            ("shadow rays that nothing could block", self.free_shadow_rays),
        ] {
            if rays > 0 {
                writeln!(f, "{what}: {rays}")?;
            }
        }
        if let Some(lost) = &self.lost {
            writeln!(f, "{lost}")?;
        }
        if self.rejected > 0 {
            writeln!(f, "rejected directions: {}", self.rejected)?;
        }
        writeln!(f, "tests: {} of shapes, {} of bounds", self.tests.primitives, self.tests.bounds)?;
        writeln!(f, "clipped pixels: {}", self.clipped_pixels)?;
        let Seconds { load, build, render } = self.seconds;
        write!(f, "seconds: load {load:.3}, build {build:.3}, render {render:.3}")
    }
}
