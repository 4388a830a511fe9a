//! All vectors of a hit in one plane, with the points that its rays come from and go to, as in figure 15 of the source text.
//!
//! The plane holds the normal, so that the surface is a line across it, and of such planes it is the one that shows most of the other
//! vectors. A vector outside of it is drawn shorter than it is; one inside has its length and its angles.

use super::hit::unit;
use super::sheet::{Ink, Point};
use crate::log::{Decision, Log, Name, RayKind, Step, Tree, Value};
use crate::report::segments::nearest;
use glam::DVec3;

/// The vectors of a hit in a plane: x to the right, y along the normal, both in units of the vectors' length.
#[derive(Clone, Debug, PartialEq)]
pub struct OnePlane {
    /// The ray that hits.
    pub ray: usize,
    /// The name of the point, such as `P₁`.
    pub point: String,
    /// The object that is hit.
    pub object: Option<u32>,
    /// The shape of the surface there.
    pub bend: Bend,
    /// The vectors, each from the point.
    pub arrows: Vec<Arrow>,
    /// The points before and after it, such as `P₀` and `P₂`, in the direction in which they lie.
    pub ways: Vec<Arrow>,
}

/// A vector, or the way to a point.
#[derive(Clone, Debug, PartialEq)]
pub struct Arrow {
    /// Its symbol, or the name of the point.
    pub symbol: String,
    /// Where it ends; it begins at the origin.
    pub tip: Point,
    /// Its colour.
    pub ink: Ink,
}

/// To which side a surface bends away from its tangent plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bend {
    /// It is flat.
    Flat,
    /// Away from the normal, as a sphere does from outside.
    Away,
    /// Toward the normal, as a sphere does from inside.
    Toward,
}

/// The most lights with arrows, unless one is chosen.
const MOST_LIGHTS: usize = 3;

/// The vectors of the hit that a node is about, as far as the events up to the last of these tell them: inside the node of a light those of
/// this light alone. `None` where nothing is hit, or the log doesn't have the normal.
pub fn one_plane(log: &Log, tree: &Tree, node: usize, last: usize) -> Option<OnePlane> {
    let is_traced = |node: &usize| tree.ray(*node).is_some_and(|kind| !matches!(kind, RayKind::Shadow { .. }));
    let ray = tree.around(node).find(is_traced)?;
    let known = Known { log, tree, last };
    let (name, normal) = known.vector(ray, Name::HitNormalPlane)?;
    let mut vectors =
        Vectors { normal: unit(normal)?, arrows: vec![("N".to_owned(), normal, Ink::Black)], ways: vec![] };
    let level = level(tree, ray);
    let incident = known.vector(ray, Name::RayDirection).and_then(|(_, incident)| unit(incident));
    if let Some(incident) = incident {
        vectors.ways.push((point(level), -incident, Ink::Viewer));
    }
    let shade = tree.children(ray).find(|child| matches!(tree.nodes()[*child].step, Some(Step::Shade { .. })));
    if let Some((_, view)) = shade.and_then(|shade| known.vector(shade, Name::ViewDirection)) {
        vectors.arrows.push(("V".to_owned(), view, Ink::Viewer));
    }
    for (name, symbol, kind, ink) in [
        (Name::ReflectDirection, "R", RayKind::Reflected, Ink::Reflected),
        (Name::RefractDirection, "T", RayKind::Transmitted, Ink::Transmitted),
    ] {
        let Some((_, vector)) = known.vector(ray, name) else { continue };
        vectors.arrows.push((symbol.to_owned(), vector, ink));
        let goes_on = |child: &usize| tree.ray(*child) == Some(kind) && known.vector(*child, Name::HitPoint).is_some();
        if tree.children(ray).any(|child| goes_on(&child)) {
            vectors.ways.push((point(level + 2), vector, ink));
        }
    }
    known.lights(&mut vectors, shade, node);
    let object = nearest(log, tree, ray);
    Some(OnePlane { ray, point: point(level + 1), object, bend: bend(name), ..vectors.in_plane(ray, incident) })
}

/// What is known of a log so far.
struct Known<'l> {
    log: &'l Log,
    tree: &'l Tree,
    last: usize,
}

impl Known<'_> {
    /// The last vector of this key that a node itself noted or was given, with its name.
    fn vector(&self, node: usize, name: Name) -> Option<(Name, DVec3)> {
        let Known { log, tree, last } = *self;
        let events = tree.own_events_before(node, last.saturating_add(1));
        let values = events
            .rev()
            .flat_map(|event| log.events[event].noted().into_iter().chain(log.given(event).iter().rev().copied()));
        let triple = |(found, value): (Name, Value)| Some((found, DVec3::from(value.triple()?)));
        let mut found = values.filter(|(found, _)| found.is(name)).filter_map(triple);
        found.next().filter(|(_, vector)| vector.is_finite())
    }

    /// Whether something opaque is known to be before a light.
    fn is_blocked(&self, light: usize) -> bool {
        let Known { log, tree, last } = *self;
        let rays = tree.children(light).filter(|child| tree.ray(*child).is_some());
        let mut events = rays.flat_map(|ray| tree.own_events_before(ray, last.saturating_add(1)));
        events.any(|event| matches!(log.events[event].decision(), Some(Decision::Occluded { .. })))
    }

    /// Adds the arrows of lights: L, the vector halfway to V, and L mirrored. Of the points of an area light the first stands for all.
    fn lights(&self, vectors: &mut Vectors, shade: Option<usize>, node: usize) {
        let tree = self.tree;
        let light_of = |node: usize| match tree.nodes()[node].step {
            Some(Step::Light { light, split }) => Some((light, split)),
            _ => None,
        };
        let Some(shade) = shade else { return };
        let all = || tree.children(shade).filter_map(|child| Some((child, light_of(child)?)));
        let chosen = tree.around(node).take_while(|around| *around != shade).find(|around| light_of(*around).is_some());
        let shown: Vec<_> = match chosen {
            Some(chosen) => all().filter(|(child, _)| *child == chosen).collect(),
            None => all().filter(|(_, (_, split))| *split <= 1).take(MOST_LIGHTS).collect(),
        };
        // One light needs no number, if it is the only one there is.
        let is_only = all().all(|(_, (light, _))| light == 0);
        for (child, (light, _)) in shown {
            let number = if is_only { String::new() } else { subscript(light + 1) };
            let is_reached = !self.is_blocked(child);
            for (name, symbol, ink) in [
                (Name::LightDirection, "L", if is_reached { Ink::Light } else { Ink::Blocked }),
                (Name::HalfDirection, "H", Ink::Half),
                (Name::TransmitDirection, "H′", Ink::Half),
                (Name::MirrorDirection, "R_L", Ink::Reflected),
            ] {
                if let Some((_, vector)) = self.vector(child, name) {
                    vectors.arrows.push((format!("{symbol}{number}"), vector, ink));
                }
            }
        }
    }
}

/// Vectors in space with their symbols.
struct Vectors {
    normal: DVec3,
    arrows: Vec<(String, DVec3, Ink)>,
    ways: Vec<(String, DVec3, Ink)>,
}

impl Vectors {
    /// The vectors as the plane shows them.
    fn in_plane(&self, ray: usize, incident: Option<DVec3>) -> OnePlane {
        let right = self.right(incident);
        let flat = |(symbol, vector, ink): &(String, DVec3, Ink)| Arrow {
            symbol: symbol.clone(),
            tip: [vector.dot(right), vector.dot(self.normal)],
            ink: *ink,
        };
        let [arrows, ways] = [&self.arrows, &self.ways].map(|vectors| vectors.iter().map(flat).collect());
        OnePlane { ray, point: String::new(), object: None, bend: Bend::Flat, arrows, ways }
    }

    /// The direction along the surface in which the vectors reach farthest: the larger axis of their scatter there. The ray comes from the
    /// left; one along the normal leaves that to the other vectors.
    fn right(&self, incident: Option<DVec3>) -> DVec3 {
        let (one, other) = self.normal.any_orthonormal_pair();
        let (mut ones, mut both, mut others) = (0.0, 0.0, 0.0);
        for (_, vector, _) in self.arrows.iter().chain(&self.ways) {
            let [x, y] = [vector.dot(one), vector.dot(other)];
            (ones, both, others) = (ones + x * x, both + x * y, others + y * y);
        }
        let turn = 0.5 * libm::atan2(2.0 * both, ones - others);
        let right = one * libm::cos(turn) + other * libm::sin(turn);
        let along = |vector: DVec3| Some(vector.dot(right)).filter(|along| along.abs() > 1e-9);
        let way = incident.and_then(along);
        if way.or_else(|| self.arrows.iter().find_map(|(_, vector, _)| along(*vector))).is_some_and(|way| way < 0.0) {
            -right
        } else {
            right
        }
    }
}

/// The level of a ray in the tree, from 0.
fn level(tree: &Tree, ray: usize) -> u32 {
    match tree.nodes()[ray].step {
        Some(Step::Ray { depth, .. }) => depth,
        _ => 0,
    }
}

/// The name of a point by its number along the path: the eye has 0.
fn point(number: u32) -> String {
    format!("P{}", subscript(number))
}

/// A number as an index: `₁₂`.
fn subscript(number: u32) -> String {
    let index = |digit: char| digit.to_digit(10).and_then(|digit| char::from_u32('₀' as u32 + digit));
    number.to_string().chars().filter_map(index).collect()
}

/// The shape of a surface, by the formula of its normal.
fn bend(normal: Name) -> Bend {
    let form = normal.form();
    let is_round = ["sphere", "on_sphere", "ellipsoid", "cylinder", "cone"].into_iter().find_map(|round| {
        let rest = form.strip_prefix(round)?;
        (rest.is_empty() || rest == "_back").then_some(rest.is_empty())
    });
    is_round.map_or(Bend::Flat, |from_outside| if from_outside { Bend::Away } else { Bend::Toward })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn indices() {
        assert_eq!([0, 7, 10, 294].map(subscript), ["₀", "₇", "₁₀", "₂₉₄"]);
    }

    #[test]
    fn surfaces_bend_as_their_normals_say() {
        let names = [Name::HitNormalSphere, Name::HitNormalOnSphereBack, Name::HitNormalPlane, Name::HitNormalConeBack];
        assert_eq!(names.map(bend), [Bend::Away, Bend::Toward, Bend::Flat, Bend::Toward]);
    }

    fn vectors(vectors: &[[f64; 3]]) -> Vectors {
        let named = |vector: &[f64; 3]| (String::new(), DVec3::from(*vector), Ink::Black);
        Vectors { normal: DVec3::Y, arrows: vectors.iter().map(named).collect(), ways: Vec::new() }
    }

    #[track_caller]
    fn is_right(vectors: &Vectors, incident: Option<[f64; 3]>, expected: [f64; 3]) {
        let right = vectors.right(incident.map(DVec3::from));
        assert!((right - DVec3::from(expected)).length() < 1e-12, "{right}");
    }

    #[test]
    fn the_plane_shows_most_of_the_vectors() {
        let side = 0.5_f64.sqrt();
        // All in the plane of x and y, or of x = z.
        is_right(&vectors(&[[0.6, 0.8, 0.0]]), None, [1.0, 0.0, 0.0]);
        is_right(&vectors(&[[side, 0.0, side], [-0.1, 0.5, -0.1]]), None, [side, 0.0, side]);
        // The ray comes from the left.
        is_right(&vectors(&[[0.6, 0.8, 0.0]]), Some([-0.6, -0.8, 0.0]), [-1.0, 0.0, 0.0]);
        // Of two at right angles the one that reaches farther along the surface.
        is_right(&vectors(&[[0.3, 0.9, 0.0], [0.0, 0.5, -0.8]]), Some([0.0, -0.5, 0.8]), [0.0, 0.0, 1.0]);
    }

    #[test]
    fn vectors_along_the_normal_have_some_plane() {
        let right = vectors(&[[0.0, 1.0, 0.0]]).right(Some(-DVec3::Y));
        assert!((right.length() - 1.0).abs() < 1e-12 && right.y.abs() < 1e-12);
    }
}
