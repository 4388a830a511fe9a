//! What the schematic shows, and the rays that are drawn in it and over the picture.

use super::Model;
use super::drawing::Projection;
use crate::log::{RayKind, Step};
use crate::report::segments::{Segment, around, reach, segment};
use std::ops::Range;

/// How the schematic is looked at.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SchematicView {
    /// The side from which it is seen; until somebody chooses one, that from which the rays spread most.
    pub side: Option<Projection>,
    /// What it shows.
    pub shown: Shown,
    /// Whether shadow rays are drawn, beside the one that is walked through.
    pub has_shadows: bool,
    /// Whether the rays are drawn over the picture, too.
    pub is_over_picture: bool,
    /// How often it is enlarged twofold.
    pub magnification: u32,
}

/// What the schematic shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shown {
    /// The rays from the eye to the selected node, and those below it.
    #[default]
    Branch,
    /// All rays of the pixel, or of the sample.
    Pixel,
    /// The vectors at the hit of the selected node.
    Vectors,
}

impl Shown {
    /// All of them, in the order in which they follow each other.
    pub const ALL: [Shown; 3] = [Shown::Branch, Shown::Pixel, Shown::Vectors];

    /// What they are called in commands.
    pub const WORDS: [&'static str; 3] = ["branch", "pixel", "vectors"];

    /// The next one.
    pub fn next(self) -> Shown {
        Shown::ALL[(self as usize + 1) % Shown::ALL.len()]
    }
}

/// The rays that are drawn.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// As far as they are known.
    pub rays: Vec<Segment>,
    /// In whole: those that are to come have their room already, so that nothing jumps.
    pub whole: Vec<Segment>,
    /// The current one.
    pub current: Option<Segment>,
    /// How long a ray to infinity is drawn.
    pub far: f64,
}

/// The most rays that are drawn: more can't be distinguished.
const MOST_RAYS: usize = 400;

/// The most nodes that are looked through for rays, so that it is quick for any log.
const MOST_NODES: usize = 1 << 16;

impl Model {
    /// The rays to be drawn.
    pub fn drawn(&self) -> Drawn {
        // Of a ray that is on its way, in the tree that grows or in a quiz, its end is to come.
        let last = self.told().unwrap_or(usize::MAX);
        let known = |node: usize| segment(&self.log, &self.tree, node, last);
        let current = self.tree.around(self.cursor).find_map(known);
        let whole = self.rays_of(if self.schematic.shown == Shown::Pixel { self.whole() } else { self.branch() });
        let rays = match last {
            usize::MAX => whole.clone(),
            _ => whole.iter().filter_map(|ray| known(ray.node)).collect(),
        };
        let far = far(&whole);
        Drawn { rays, whole, current, far }
    }

    /// The side from which the schematic is seen.
    pub fn side(&self) -> Projection {
        let side = self.schematic.side.filter(|side| *side != Projection::Camera || self.drawing.is_some());
        side.unwrap_or_else(|| {
            // That of the whole pixel, so that it stays while one steps through it.
            let rays = self.rays_of(self.whole());
            let far = far(&rays);
            let points: Vec<_> = rays.iter().flat_map(|ray| [ray.from, ray.end(far)]).collect();
            Projection::widest(&points)
        })
    }

    /// The rays among some nodes that are to be drawn.
    fn rays_of(&self, nodes: impl Iterator<Item = usize>) -> Vec<Segment> {
        let is_chosen = self.chosen();
        let is_shown = |node: &usize| match self.tree.ray(*node) {
            Some(RayKind::Shadow { .. }) => self.schematic.has_shadows || is_chosen(*node),
            ray => ray.is_some(),
        };
        let rays = nodes.filter(is_shown).filter_map(|node| segment(&self.log, &self.tree, node, usize::MAX));
        rays.take(MOST_RAYS).collect()
    }

    /// Whether a shadow ray belongs to what is selected: it is around the current step, or goes to the light there.
    fn chosen(&self) -> impl Fn(usize) -> bool + '_ {
        let is_light = |node: &usize| matches!(self.tree.nodes()[*node].step, Some(Step::Light { .. }));
        let light = self.tree.around(self.cursor).take_while(|node| !self.is_traced(*node)).find(is_light);
        let inside = light.map_or(0..0, |light| light..self.tree.nodes()[light].subtree_end);
        move |node| inside.contains(&node) || self.inside(node).contains(&self.cursor)
    }

    /// The nodes of the sample that the selected node is in, or else of the whole pixel.
    fn whole(&self) -> Box<dyn Iterator<Item = usize> + '_> {
        Box::new(self.inside(self.first_node()))
    }

    /// The rays on the way to the current one, and the nodes inside that.
    fn branch(&self) -> Box<dyn Iterator<Item = usize> + '_> {
        let tree = &self.tree;
        let mut rays: Vec<usize> = tree.around(self.cursor).filter(|node| tree.ray(*node).is_some()).collect();
        if rays.is_empty() {
            return self.whole();
        }
        rays.reverse();
        let inside = rays.last().map_or(0..0, |ray| self.inside(*ray));
        // Of a very long way its last part is drawn.
        let beyond = rays.len().saturating_sub(MOST_RAYS / 2);
        rays.pop();
        Box::new(rays.into_iter().skip(beyond).chain(inside))
    }

    fn inside(&self, node: usize) -> Range<usize> {
        node..self.tree.nodes()[node].subtree_end.min(node + MOST_NODES)
    }

    fn is_traced(&self, node: usize) -> bool {
        self.tree.ray(node).is_some_and(|kind| !matches!(kind, RayKind::Shadow { .. }))
    }

    fn first_node(&self) -> usize {
        let is_whole =
            |node: &usize| matches!(self.tree.nodes()[*node].step, None | Some(Step::Sample { .. } | Step::Pixel(_)));
        self.tree.around(self.cursor).find(is_whole).unwrap_or(0)
    }
}

/// How far the rays with an end reach. Rays that hit nothing say nothing of a scale: any will do that numbers of this size can tell apart.
fn far(rays: &[Segment]) -> f64 {
    let ends = || rays.iter().flat_map(|ray| [Some(ray.from), ray.length.map(|_| ray.end(0.0))]).flatten();
    let far = reach(&around(ends()));
    if far > 0.0 { far } else { ends().flatten().fold(1.0, |most: f64, number| most.max(number.abs())) }
}
