//! Which inputs of the scene two logs have differently, as the scene calls them: `lights.F.position`.

use super::align::{Alignment, Item, Spot, computed};
use super::kinds::{Kinds, kind};
use super::tolerance::Tolerance;
use super::{Changed, telling_apart};
use crate::log::{Header, Name, RayKind, Step};
use crate::report::language::Language;
use crate::report::segments::nearest;
use crate::report::side_by_side::Run;
use crate::report::words;
use std::collections::{BTreeMap, HashMap, HashSet};

/// The inputs that the scenes of two aligned logs have differently, each once, in the order of A.
pub(super) fn changed(a: Run, b: Run, alignment: &Alignment, tolerance: &Tolerance) -> Vec<Changed> {
    let mut found = names(a, b);
    found.extend(parts(a, b));
    found.extend(Kinds::of(a, b, alignment).changed());
    let mut met = Met::new();
    for spot in &alignment.spots {
        let Spot::Both(ours @ Item::Input(at, number), theirs @ Item::Input(there, other)) = *spot else { continue };
        let ((name, value_a), (_, value_b)) = (a.log.given(at)[number], b.log.given(there)[other]);
        let is_handed_on = computed(a, ours).is_some() || computed(b, theirs).is_some();
        // A square says the same as its root once more.
        if is_handed_on || name.key().ends_with("_squared") || !tolerance.tells_apart(&value_a, &value_b) {
            continue;
        }
        let style = telling_apart(&value_a, &value_b, tolerance.digits);
        let [a_says, b_says] = [value_a, value_b].map(|value| Language::English.value(&value, style));
        found.push(Changed { input: input(a, at, name, &mut met), a: a_says, b: b_says });
    }
    let mut seen = HashSet::new();
    found.retain(|changed| seen.insert(changed.input.clone()));
    found
}

/// How it is said that an object, a light or a part of one isn't in a scene, or is, where nothing more is known.
const ABSENT: &str = "absent";
const PRESENT: &str = "present";

/// A list of the names that a scene has itself. There may be a million of them, so no copy is made.
fn own_names<'r>(run: Run<'r>, list: List) -> impl Iterator<Item = &'r str> {
    let header = &run.log.header;
    let elsewhere: HashSet<&str> = header.only_elsewhere.iter().map(String::as_str).collect();
    list(header).iter().map(String::as_str).filter(move |name| !elsewhere.contains(name))
}

/// A list of names in a header.
type List = fn(&Header) -> &[String];

/// The lists of names in a header.
const LISTS: [(&str, List); 2] = [("objects", |header| &header.objects), ("lights", |header| &header.lights)];

/// Objects and lights that only one of the scenes has.
fn names(a: Run, b: Run) -> Vec<Changed> {
    let only = |run: Run, other: Run| -> Vec<(String, String)> {
        let mut missing = Vec::new();
        for (kind, list) in LISTS {
            if own_names(run, list).eq(own_names(other, list)) {
                continue;
            }
            let theirs: HashSet<&str> = own_names(other, list).collect();
            let names = own_names(run, list).filter(|name| !theirs.contains(name));
            missing.extend(names.map(|name| format!("{kind}.{}", words::plain(name))));
        }
        if missing.is_empty() {
            return Vec::new();
        }
        let kinds: HashMap<_, _> = (0..run.tree.nodes().len()).filter_map(|node| kind(run, node)).collect();
        let kind = |place: String| {
            let kind = kinds.get(&place).map_or(PRESENT, |kind| *kind).to_owned();
            (place, kind)
        };
        missing.into_iter().map(kind).collect()
    };
    let absent = || ABSENT.to_owned();
    let removed = only(a, b).into_iter().map(|(input, a)| Changed { input, a, b: absent() });
    let added = only(b, a).into_iter().map(|(input, b)| Changed { input, a: absent(), b });
    removed.chain(added).collect()
}

/// Motions and patterns that an object has in one of the scenes only, if both logs meet it.
fn parts(a: Run, b: Run) -> Vec<Changed> {
    let mut found = Vec::new();
    let (moves_a, moves_b) = (moving(a), moving(b));
    let (pattern_a, pattern_b) = (patterned(a), patterned(b));
    for (part, ours, theirs) in [("motion", moves_a, moves_b), ("material.pattern", pattern_a, pattern_b)] {
        for (object, has) in ours {
            let Some(other) = theirs.get(&object).filter(|other| **other != has) else { continue };
            let [a, b] = [has, *other].map(|has| if has { PRESENT } else { ABSENT }.to_owned());
            found.push(Changed { input: format!("objects.{object}.{part}"), a, b });
        }
    }
    found
}

/// Of each object that is tested, whether it moves.
fn moving(run: Run) -> BTreeMap<String, bool> {
    let nodes = run.tree.nodes();
    let mut moving = BTreeMap::new();
    for node in nodes {
        if let Some(Step::Test { object, .. }) = node.step {
            let is_moving = matches!(nodes[node.parent].step, Some(Step::Motion { .. }));
            *moving.entry(words::plain(run.log.header.object(object))).or_insert(false) |= is_moving;
        }
    }
    moving
}

/// Of each object that is shaded, whether its material has a pattern.
fn patterned(run: Run) -> BTreeMap<String, bool> {
    let mut patterned = BTreeMap::new();
    for (node, shade) in run.tree.nodes().iter().enumerate() {
        if let Some(Step::Shade { object }) = shade.step {
            let mut given = run.tree.own_events(node).flat_map(|event| run.log.given(event).iter());
            let has = given.any(|(name, _)| name.key().starts_with("pattern."));
            *patterned.entry(words::plain(run.log.header.object(object))).or_insert(false) |= has;
        }
    }
    patterned
}

/// By the nodes that were asked for it, what the ray around each met.
type Met = HashMap<usize, Option<u32>>;

/// What a node, or the nearest one around it that says so, met.
fn met_around(run: Run, node: usize, known: &mut Met) -> Option<u32> {
    let (mut at, mut asked) = (node, Vec::new());
    let met = loop {
        if let Some(met) = known.get(&at) {
            break *met;
        }
        asked.push(at);
        let met = nearest(run.log, run.tree, at);
        if met.is_some() || at == 0 {
            break met;
        }
        at = run.tree.nodes()[at].parent;
    };
    known.extend(asked.into_iter().map(|node| (node, met)));
    met
}

/// What a scene calls the input that an event carries.
fn input(run: Run, event: usize, name: Name, met: &mut Met) -> String {
    let (nodes, header) = (run.tree.nodes(), &run.log.header);
    let node = run.tree.owner(event);
    let (kind, key) = name.key().split_once('.').unwrap_or(("", name.key()));
    let object = |object: u32| format!("objects.{}", words::plain(header.object(object)));
    // What a ray met, as its weighted sum and its bounces have the weights of it.
    let mut nearest = || met_around(run, node, met).map_or_else(String::new, |met| format!("{}.", object(met)));
    match (nodes[node].step, kind) {
        (_, "weight") => format!("{}material.weights.{key}", nearest()),
        (_, "material" | "pattern") => format!("{}{}", nearest(), name.key()),
        (_, "light") if name == Name::AmbientLight => "ambient".to_owned(),
        (Some(Step::Light { light, .. }), "light") => {
            let key = if name == Name::LightTravel { "direction" } else { key };
            format!("lights.{}.{key}", words::plain(header.light(light)))
        }
        (Some(Step::Test { object: tested, .. } | Step::Motion { object: tested }), _) => {
            format!("{}.{key}", object(tested))
        }
        (Some(Step::Ray { kind: RayKind::Camera, .. }), "ray") if name == Name::RayOrigin => {
            "camera.position".to_owned()
        }
        (Some(Step::Ray { kind: RayKind::Camera, .. }), "ray") if name == Name::RayVector => {
            "camera.direction".to_owned()
        }
        _ => name.key().to_owned(),
    }
}
