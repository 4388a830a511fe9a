//! Objects and lights that are of another kind in the other scene: then their tests compute other quantities, and decide otherwise.

use super::Changed;
use super::align::{Alignment, Item, Spot};
use crate::log::{Decision, Step, What};
use crate::report::side_by_side::Run;
use crate::report::words;
use std::collections::{BTreeMap, HashMap};

/// The nodes of A whose object or light is of another kind in B.
pub(super) struct Kinds {
    /// By the node, what changed.
    nodes: BTreeMap<usize, Changed>,
    /// The same by the number of an object.
    objects: BTreeMap<u32, Changed>,
    /// What the rays of A and of B meet, if any object changed.
    met: [Met; 2],
}

/// By the nodes of rays, the events that say what a ray hits, and what that is.
type Met = HashMap<usize, Vec<(usize, u32)>>;

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
        let objects: BTreeMap<_, _> = nodes.iter().filter_map(object).collect();
        let met = if objects.is_empty() { Default::default() } else { [met(a), met(b)] };
        Kinds { nodes, objects, met }
    }

    /// What changed, in the order of A.
    pub fn changed(self) -> impl Iterator<Item = Changed> {
        self.nodes.into_values()
    }

    /// Whether the object or light of this node of A is of another kind.
    pub fn has(&self, node: usize) -> bool {
        self.nodes.contains_key(&node)
    }

    /// The change by which this differs, which is in a node of A: it is of the test, or says what the ray met there.
    pub fn cause_of(&self, a: Run, b: Run, home: usize, spot: Spot) -> Option<&Changed> {
        let differs = match spot {
            Spot::OnlyA(Item::Node(_)) | Spot::OnlyB(Item::Node(_)) => false,
            Spot::OnlyA(_) | Spot::OnlyB(_) => true,
            Spot::Both(Item::Event(ours), _) => matches!(a.log.events[ours].what, What::Mark(_)),
            Spot::Both(..) => false,
        };
        if !differs {
            return None;
        }
        let met = || {
            let (run, met, item) = match spot {
                Spot::OnlyA(item) => (a, &self.met[0], item),
                Spot::OnlyB(item) => (b, &self.met[1], item),
                Spot::Both(..) => return None,
            };
            let (Item::Event(event) | Item::Input(event, _)) = item else { return None };
            self.objects.get(&met_before(met, run.tree.owner(event), event)?)
        };
        self.nodes.get(&home).or_else(met)
    }
}

fn met(run: Run) -> Met {
    let mut met = Met::new();
    for (event, what) in run.log.events.iter().map(|event| &event.what).enumerate() {
        if let What::Mark(Decision::Nearest { object }) = *what {
            let node = run.tree.owner(event);
            if matches!(run.tree.nodes()[node].step, Some(Step::Ray { .. })) {
                met.entry(node).or_default().push((event, object));
            }
        }
    }
    met
}

/// The object that the ray of a node met before an event.
fn met_before(met: &Met, node: usize, event: usize) -> Option<u32> {
    let met = met.get(&node)?;
    let before = met.partition_point(|(at, _)| *at < event);
    met[..before].last().map(|(_, object)| *object)
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
