//! Objects and lights that are of another kind in the other scene: then their tests compute other quantities, and decide otherwise.

use super::align::{Alignment, Spot, Thing};
use super::changed::Changed;
use crate::log::{Decision, Step, What};
use crate::report::side_by_side::Run;
use crate::report::words;
use std::collections::BTreeMap;

/// The nodes of A whose object or light is of another kind in B.
pub(super) struct Kinds {
    /// By the node, what changed.
    nodes: BTreeMap<usize, Changed>,
    /// The same by the number of an object.
    objects: BTreeMap<u32, Changed>,
}

impl Kinds {
    /// Those of two aligned logs.
    pub fn of(a: Run, b: Run, alignment: &Alignment) -> Kinds {
        let pairs = alignment.nodes.iter().enumerate().filter_map(|(ours, theirs)| Some((ours, (*theirs)?)));
        let changed = pairs.filter_map(|(ours, theirs)| {
            let (input, kind_a) = kind(a, ours)?;
            let (_, kind_b) = kind(b, theirs)?;
            (kind_a != kind_b).then(|| (ours, Changed { input, a: kind_a.to_owned(), b: kind_b.to_owned() }))
        });
        let nodes: BTreeMap<usize, Changed> = changed.collect();
        let object = |(node, changed): (&usize, &Changed)| match a.tree.nodes()[*node].step {
            Some(Step::Test { object, .. }) => Some((object, changed.clone())),
            _ => None,
        };
        let objects = nodes.iter().filter_map(object).collect();
        Kinds { nodes, objects }
    }

    /// What changed, in the order of A.
    pub fn changed(self) -> impl Iterator<Item = Changed> {
        self.nodes.into_values()
    }

    /// Whether the object or light of this node of A is of another kind.
    pub fn has(&self, node: usize) -> bool {
        self.nodes.contains_key(&node)
    }

    /// The change by which this differs, which stands in a node of A: it is of the test, or says what the ray met there.
    pub fn cause_of(&self, a: Run, b: Run, home: usize, spot: Spot) -> Option<&Changed> {
        let differs = match spot {
            Spot::OnlyA(Thing::Node(_)) | Spot::OnlyB(Thing::Node(_)) => false,
            Spot::OnlyA(_) | Spot::OnlyB(_) => true,
            Spot::Both(Thing::Event(ours), _) => matches!(a.log.events[ours].what, What::Mark(_)),
            Spot::Both(..) => false,
        };
        if !differs {
            return None;
        }
        let met = || {
            let (run, thing) = match spot {
                Spot::OnlyA(thing) => (a, thing),
                Spot::OnlyB(thing) => (b, thing),
                Spot::Both(..) => return None,
            };
            let (Thing::Event(event) | Thing::Input(event, _)) = thing else { return None };
            self.objects.get(&met_before(run, event)?)
        };
        self.nodes.get(&home).or_else(met)
    }
}

/// The object that the ray of an event met before it, if the event stands in the ray's own node.
fn met_before(run: Run, event: usize) -> Option<u32> {
    let node = run.tree.owner(event);
    let is_ray = matches!(run.tree.nodes()[node].step, Some(Step::Ray { .. }));
    let mut own = run.tree.own_events_before(node, event).rev().filter(|_| is_ray);
    own.find_map(|at| match run.log.events[at].what {
        What::Mark(Decision::Nearest { object }) => Some(object),
        _ => None,
    })
}

/// What the light or the object of a node is, told by its inputs.
pub(super) fn kind(run: Run, node: usize) -> Option<(String, &'static str)> {
    const OBJECTS: &[(&str, &str)] = &[
        ("plane.", "plane"),
        ("sphere.", "sphere"),
        ("ellipsoid.", "ellipsoid"),
        ("triangle.", "triangle"),
        ("polygon.", "polygon"),
        ("box.", "box"),
        ("cylinder.", "cylinder"),
        ("cone.", "cone"),
        ("disk.", "disk"),
    ];
    // An area light's edges come before its point does.
    const LIGHTS: &[(&str, &str)] = &[
        ("light.travel", "directional"),
        ("light.edge_u", "rectangle or disk"),
        ("light.radius", "sphere"),
        ("light.position", "point"),
    ];
    let header = &run.log.header;
    let (place, kinds) = match run.tree.nodes()[node].step? {
        Step::Light { light, .. } => (format!("lights.{}", words::plain(header.light(light))), LIGHTS),
        Step::Test { object, triangle: None } => (format!("objects.{}", words::plain(header.object(object))), OBJECTS),
        _ => return None,
    };
    let keys = || run.tree.own_events(node).flat_map(|event| run.log.given(event).iter().map(|(name, _)| name.key()));
    kinds.iter().find(|(start, _)| keys().any(|key| key.starts_with(start))).map(|(_, kind)| (place, *kind))
}
