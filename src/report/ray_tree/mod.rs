//! The ray tree of a pixel as a graphic (Ramos, figures 3, 7, 8 and 9): one file a format.
//!
//! The root is the eye, a node is what a ray hits, and a line is the ray: C from the eye, R reflected, T transmitted, S to a light.
//! A shadow ray that doesn't reach its light is marked. The wider a line, the more of the pixel's intensity comes along it.

mod calls;
mod dot;
mod layout;
mod mermaid;
mod svg;
mod tikz;

pub use calls::calls;
pub use dot::dot;
pub use mermaid::mermaid;
pub use svg::{svg, svg_of};
pub use tikz::tikz;

use super::contributions;
use super::language::Language;
use super::ray_group::RayGroup;
use super::{Style, words};
use crate::files::escape::shortened;
use crate::log::{Decision, Log, RayKind, Term, Tree, Value};
use std::collections::{BTreeMap, HashMap};

/// A ray with all that it leads to.
#[derive(Clone, Debug, PartialEq)]
pub struct Branch {
    /// Its node in the log.
    pub node: usize,
    /// Its way from the eye, such as `C R`.
    pub path: String,
    /// What is beside its line: the end of the path, such as `R` or `S1`.
    pub label: String,
    /// What it is for.
    pub kind: RayKind,
    /// What it hits.
    pub end: End,
    /// The call that traces it, in a tree of calls.
    pub call: Option<String>,
    /// The part of the pixel's intensity that comes along it, the three channels taken together.
    pub share: f64,
    /// What it adds to the pixel.
    pub color: [f64; 3],
    /// The rays that set out where it ends, in the order of the computation.
    pub children: Vec<Branch>,
}

/// What a ray hits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// An object.
    Object(u32),
    /// Nothing.
    Background,
    /// A light.
    Light(u32),
    /// An opaque object on the way to a light.
    Blocked {
        /// The light.
        light: u32,
        /// The object.
        object: u32,
    },
    /// It isn't traced: it would lie too deep in the tree.
    TooDeep,
    /// The log doesn't say.
    Unknown,
}

impl Branch {
    /// Whether its light is kept off.
    pub fn is_blocked(&self) -> bool {
        matches!(self.end, End::Blocked { .. })
    }

    fn group(&self) -> RayGroup {
        RayGroup::of(self.kind, self.is_blocked())
    }

    /// How wide its line is, in hundredths of the widest.
    fn width(&self) -> f64 {
        self.share.clamp(0.0, 1.0)
    }
}

/// The rays from the eye, in a region those of the pixel around `node`, each with all that it leads to.
pub fn branches(log: &Log, tree: &Tree, node: usize) -> Vec<Branch> {
    let pixel = contributions::pixel_around(tree, node);
    let account = contributions::account(log, tree, pixel);
    // What comes along each ray, from the last one on: all that comes along a ray comes along the one before it.
    let mut below: BTreeMap<usize, Brought> = BTreeMap::new();
    for contribution in account.contributions.iter().filter(|contribution| contribution.way.node != 0) {
        add(&mut below, contribution.way.node, (contribution.color, contribution.share));
    }
    let mut all = HashMap::new();
    while let Some((ray, brought)) = below.pop_last() {
        all.insert(ray, brought);
        if let Some(around) = tree.step_before(ray) {
            add(&mut below, around, brought);
        }
    }
    let below = all;
    rays_below(tree, pixel).into_iter().map(|ray| branch(log, tree, ray, &below)).collect()
}

/// A colour and its part of the pixel's.
type Brought = ([f64; 3], f64);

fn add(below: &mut BTreeMap<usize, Brought>, ray: usize, (more, part): Brought) {
    let (color, share) = below.entry(ray).or_default();
    *color = [0, 1, 2].map(|channel| color[channel] + more[channel]);
    *share += part;
}

/// How many rays there are.
pub fn count(branches: &[Branch]) -> usize {
    branches.iter().map(|branch| 1 + count(&branch.children)).sum()
}

fn branch(log: &Log, tree: &Tree, node: usize, below: &HashMap<usize, Brought>) -> Branch {
    let path = tree.shown_path(node);
    let kind = tree.ray(node).unwrap_or(RayKind::Camera);
    // A sample's number belongs to its ray from the eye.
    let label = if kind == RayKind::Camera { path.clone() } else { path.rsplit(' ').next().unwrap_or("").to_owned() };
    let (color, share) = below.get(&node).copied().unwrap_or_default();
    let children = rays_below(tree, node).into_iter().map(|ray| branch(log, tree, ray, below)).collect();
    Branch { node, path, label, kind, end: end(log, tree, node, kind), call: None, share, color, children }
}

/// The rays inside a node that lie in no other ray there.
fn rays_below(tree: &Tree, node: usize) -> Vec<usize> {
    let mut found = Vec::new();
    let mut open: Vec<usize> = tree.children(node).collect();
    open.reverse();
    while let Some(at) = open.pop() {
        if tree.ray(at).is_some() {
            found.push(at);
            continue;
        }
        let from = open.len();
        open.extend(tree.children(at));
        open[from..].reverse();
    }
    found
}

fn end(log: &Log, tree: &Tree, node: usize, kind: RayKind) -> End {
    let decisions = tree.own_events(node).filter_map(|event| log.events[event].decision());
    let met = decisions.filter_map(|decision| match (decision, kind) {
        (Decision::Nearest { object }, _) => Some(End::Object(object)),
        (Decision::Background, _) => Some(End::Background),
        (Decision::Occluded { object }, RayKind::Shadow { light }) => Some(End::Blocked { light, object }),
        _ => None,
    });
    let without = if let RayKind::Shadow { light } = kind { End::Light(light) } else { End::Unknown };
    met.fold(without, |_, end| end)
}

/// What all formats need: the log's names, in a language.
pub struct Figure<'a> {
    /// The log.
    pub log: &'a Log,
    /// The rays from the eye.
    pub branches: &'a [Branch],
    /// The language of the figure.
    pub language: Language,
    /// How numbers are shown.
    pub style: Style,
}

impl<'a> Figure<'a> {
    /// The most characters of a name in a figure.
    const LONGEST: usize = 20;

    /// What is at the end of a ray.
    fn end(&self, branch: &Branch) -> String {
        let header = &self.log.header;
        let name = |name: &str| shortened(&words::plain(name), Self::LONGEST);
        if let Some(call) = &branch.call {
            return call.clone();
        }
        match branch.end {
            End::Object(object) => name(header.object(object)),
            End::Background => self.language.texts().figure.background.to_owned(),
            End::Light(light) | End::Blocked { light, .. } => name(header.light(light)),
            End::TooDeep | End::Unknown => "?".to_owned(),
        }
    }

    /// What is to be said of a ray beside the figure: its path, what it is for, what it adds.
    fn description(&self, branch: &Branch) -> String {
        let texts = self.language.texts();
        let kind = words::ray_kind(self.language, &self.log.header, branch.kind);
        let title = (texts.ray)(&branch.path, &kind);
        let more = match branch.end {
            End::Blocked { object, .. } => (texts.figure.blocked)(&words::plain(self.log.header.object(object))),
            End::TooDeep => {
                let what = if branch.kind == RayKind::Transmitted { Term::Transmitted } else { Term::Reflected };
                (texts.depth_limit)(self.language.term(what))
            }
            _ => {
                let color = self.language.value(&Value::Triple(branch.color), self.style);
                (texts.figure.adds)(&self.language.percent(branch.share), &color)
            }
        };
        format!("{title}: {more}")
    }

    /// The figure's title: what it is, and of what.
    fn title(&self) -> String {
        let texts = self.language.texts();
        let subject = words::subject(self.language, &self.log.header);
        let is_of_calls = self.branches.iter().any(|branch| branch.call.is_some());
        let title = if is_of_calls { texts.figure.call_tree } else { texts.figure.ray_tree };
        format!("{title}: {}, {subject}", words::plain(&self.log.header.scene.name))
    }
}

/// The letter of a kind of rays, with the number of the light.
pub(super) fn short(kind: RayKind) -> String {
    match kind {
        RayKind::Shadow { light } => format!("S{}", light + 1),
        _ => kind.letter().to_owned(),
    }
}
