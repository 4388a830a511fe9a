//! What catches the values of quantities at paths as they pass, without a log.
//!
//! A value belongs to the ray in whose node it is noted or given; that of a light also to the light's shadow ray, whether one is traced or not. Of
//! several in one ray that of the test counts that found the nearest hit, or else the first. Of several rays, those of other samples or the others
//! of a split, all count alike: the mean. So do all values of the pixel that are in no ray and no sample.

use super::planes::{Place, Resolved};
use crate::log::plane::PathStep;
use crate::log::{Decision, Name, RayKind, Step, Value};
use crate::probe::Quantity;
use crate::sampling::mean::Sum;
use crate::scene::Color;

/// Catches the values of a pixel.
pub(super) struct Catcher<'p> {
    wanted: &'p Resolved,
    sample: u32,
    path: Vec<PathStep>,
    open: Vec<Open>,
    rays: Vec<OpenRay>,
    /// The values of which some are in the rays that are open, by their numbers.
    caught: Vec<Caught>,
    /// The inputs of the next event.
    given: Vec<(u16, Value)>,
}

/// What an open node is.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Open {
    Ray,
    /// The ray to a light, whose node has its step of the path.
    Shadow,
    Light,
    Sample,
    /// A test, by its number among those of its ray.
    Test(usize),
    /// A test of a moving object, or the way back from it.
    Motion(u32),
    Other,
}

/// A ray whose end isn't known yet.
#[derive(Default)]
struct OpenRay {
    tests: Vec<Test>,
    /// The object that it hits first, or that blocks it.
    nearest: Option<u32>,
}

struct Test {
    object: u32,
    triangle: Option<u32>,
    is_hit: bool,
    /// How far along the ray.
    distance: f64,
}

/// The values of one quantity.
#[derive(Default)]
struct Caught {
    /// In the rays at its path that are open.
    found: Vec<(Value, Option<Open>)>,
    /// Which of them counts, where that is known already.
    chosen: Option<Value>,
    sum: Option<Sum>,
    count: u32,
}

impl<'p> Catcher<'p> {
    /// Before a pixel.
    pub fn new(wanted: &'p Resolved) -> Catcher<'p> {
        let caught = wanted.values.iter().map(|_| Caught::default()).collect();
        let (path, open, rays, given) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        Catcher { wanted, sample: 0, path, open, rays, caught, given }
    }

    /// An input of the next event.
    pub fn given<Q: Quantity>(&mut self, name: Name, value: Q) {
        let values = self.wanted.values_of(name);
        self.given.extend(values.iter().map(|at| (*at, value.value())));
        self.learn_distance(name, value);
    }

    /// A value.
    pub fn note<Q: Quantity>(&mut self, name: Name, value: Q) {
        self.take_given();
        let wanted = self.wanted;
        wanted.values_of(name).iter().for_each(|at| self.catch(*at, value.value()));
        self.learn_distance(name, value);
    }

    /// A decision.
    pub fn mark(&mut self, decision: Decision) {
        self.take_given();
        let Some(ray) = self.rays.last_mut() else { return };
        match (decision, self.open.last()) {
            (Decision::Hit, Some(Open::Test(test))) => ray.tests[*test].is_hit = true,
            (Decision::Nearest { object } | Decision::Occluded { object }, _) => _ = ray.nearest.get_or_insert(object),
            _ => {}
        }
    }

    /// A node begins.
    pub fn enter(&mut self, step: Step) {
        let open = match step {
            Step::Sample { number } => {
                self.settle();
                self.sample = number;
                Open::Sample
            }
            Step::Ray { kind, split, .. } => {
                self.rays.push(OpenRay::default());
                if self.open.last() == Some(&Open::Light) {
                    Open::Shadow
                } else {
                    self.path.push(PathStep { kind, split });
                    Open::Ray
                }
            }
            Step::Light { light, split } => {
                self.path.push(PathStep { kind: RayKind::Shadow { light }, split });
                Open::Light
            }
            Step::Test { object, triangle } => match self.rays.last_mut() {
                Some(ray) => {
                    ray.tests.push(Test { object, triangle, is_hit: false, distance: f64::INFINITY });
                    Open::Test(ray.tests.len() - 1)
                }
                None => Open::Other,
            },
            Step::Motion { object } => Open::Motion(object),
            Step::Pixel(_) | Step::Shade { .. } | Step::Zone { .. } | Step::Combine => Open::Other,
        };
        self.open.push(open);
        self.take_given();
    }

    /// The latest node ends.
    pub fn leave(&mut self) {
        match self.open.pop() {
            Some(Open::Ray) => {
                self.leave_ray();
                self.settle();
                self.path.pop();
            }
            Some(Open::Shadow) => self.leave_ray(),
            Some(Open::Light) => {
                self.settle();
                self.path.pop();
            }
            Some(Open::Sample) => {
                self.settle();
                self.sample = 0;
            }
            _ => {}
        }
    }

    /// Puts the numbers of the pixel in their places: of a value that no ray has, what isn't a number.
    pub fn finish(mut self, numbers: &mut [f64]) {
        self.take_given();
        self.settle();
        for (Place { of: value, at }, caught) in self.wanted.values.iter().zip(&self.caught) {
            let mean = caught.sum.map(|sum| sum.over(f64::from(caught.count)).to_array()).unwrap_or([f64::NAN; 3]);
            match value.component {
                Some(component) => numbers[*at] = mean[component as usize],
                None if value.is_triple() => numbers[*at..*at + 3].copy_from_slice(&mean),
                None => numbers[*at] = mean[0],
            }
        }
    }

    /// The inputs of an event belong to its node.
    fn take_given(&mut self) {
        if !self.given.is_empty() {
            let mut given = std::mem::take(&mut self.given);
            given.drain(..).for_each(|(at, value)| self.catch(at, value));
            self.given = given;
        }
    }

    /// Keeps a value that is noted in the open node, if that is at the path.
    fn catch(&mut self, at: u16, value: Value) {
        let at = usize::from(at);
        let wanted = &self.wanted.values[at].of.path;
        // What is said of a light is said in the node of the ray that arrives, too.
        let is_of_light =
            self.open.iter().rev().find(|open| !matches!(open, Open::Other | Open::Test(_) | Open::Motion(_)));
        let around = self.path.len().saturating_sub(usize::from(is_of_light == Some(&Open::Light)));
        if wanted.matches(self.sample, &self.path) || wanted.matches(self.sample, &self.path[..around]) {
            let in_test = self.open.iter().rev().find(|open| matches!(open, Open::Test(_) | Open::Motion(_)));
            self.caught[at].found.push((value, in_test.copied()));
        }
    }

    /// A ray is complete: which of the values in its tests counts is known.
    fn leave_ray(&mut self) {
        let Some(ray) = self.rays.pop() else { return };
        let winner = ray.winner();
        for (wanted, caught) in self.wanted.values.iter().zip(&mut self.caught) {
            if wanted.of.path.steps.len() != self.path.len() || caught.found.is_empty() {
                continue;
            }
            let of_test = |open: Option<Open>| caught.found.iter().find(|(_, test)| *test == open && open.is_some());
            let of_winner = of_test(winner.map(Open::Test)).or_else(|| of_test(ray.nearest.map(Open::Motion)));
            caught.chosen = caught.chosen.or(of_winner.map(|(value, _)| *value));
            // The numbers of tests mean nothing in another ray.
            caught.found.iter_mut().for_each(|(_, test)| *test = None);
        }
    }

    /// The rays with the open path are complete: what was found there counts once.
    fn settle(&mut self) {
        for (wanted, caught) in self.wanted.values.iter().zip(&mut self.caught) {
            if wanted.of.path.steps.len() != self.path.len() {
                continue;
            }
            // Of what belongs to no ray and no sample, such as the cells of adaptive sampling, each value counts.
            let is_outside = self.path.is_empty() && self.sample == 0;
            let count = if is_outside { caught.found.len() } else { 1 };
            let found = std::mem::take(&mut caught.found);
            let values = caught.chosen.take().into_iter().chain(found.into_iter().map(|(value, _)| value));
            for value in values.take(count) {
                let color = match value {
                    Value::Number(number) => Color::splat(number),
                    Value::Triple(triple) => triple.into(),
                };
                caught.sum.get_or_insert(Sum::ZERO).add(color);
                caught.count += 1;
            }
        }
    }

    /// Of several triangles of a mesh the nearest one is the hit.
    #[inline]
    fn learn_distance<Q: Quantity>(&mut self, name: Name, value: Q) {
        if let (Some(Open::Test(test)), Some(ray)) = (self.open.last(), self.rays.last_mut())
            && ray.tests[*test].triangle.is_some()
            && name.is(Name::TriangleT)
            && let Value::Number(distance) = value.value()
        {
            ray.tests[*test].distance = distance;
        }
    }
}

impl OpenRay {
    /// The test that found the nearest object.
    fn winner(&self) -> Option<usize> {
        let nearest = self.nearest?;
        let found = (0..)
            .zip(&self.tests)
            .filter(|(_, test)| test.object == nearest && (test.triangle.is_none() || test.is_hit));
        found
            .min_by(|(_, a), (_, b)| a.distance.total_cmp(&b.distance).then(a.triangle.cmp(&b.triangle)))
            .map(|(at, _)| at)
    }
}
