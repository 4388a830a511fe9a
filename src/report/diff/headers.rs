//! What two logs say about themselves, and how the same object gets the same number in both.

use crate::log::event::field::Id;
use crate::log::{Event, Header, Subject};
use crate::report::language::Language;
use crate::report::words;
use serde::Serialize;
use std::collections::{HashMap, HashSet};

/// Something that the headers of two logs say differently.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct HeaderDifference {
    /// What it is about, as the header calls it: `arithmetic`, `tracing.max_depth`.
    pub field: &'static str,
    /// What A says.
    pub a: String,
    /// What B says.
    pub b: String,
}

/// A field of a header, and what a header says in it.
type Field = (&'static str, fn(&Header) -> String);

const FIELDS: [Field; 22] = [
    ("subject", subject),
    ("version", |header| words::plain(&header.version)),
    ("scene.name", |header| words::plain(&header.scene.name)),
    ("scene.digest", |header| words::plain(&header.scene.digest)),
    ("arithmetic", |header| words::plain(&header.arithmetic)),
    ("tracing.algorithm", |header| words::plain(&header.tracing.algorithm)),
    ("tracing.max_depth", |header| header.tracing.max_depth.to_string()),
    ("tracing.specular", |header| words::plain(&header.tracing.specular)),
    ("tracing.formulas", |header| words::plain(header.tracing.formulas.as_deref().unwrap_or("robust"))),
    ("tracing.sphere_method", |header| words::plain(&header.tracing.sphere_method)),
    ("tracing.reflected_scale", |header| words::plain(header.tracing.reflected_scale.as_deref().unwrap_or("weight"))),
    ("tracing.round_products", |header| header.tracing.round_products.to_string()),
    ("tracing.cutoff", |header| header.tracing.cutoff.to_string()),
    ("tracing.two_sided", |header| header.tracing.two_sided.to_string()),
    ("tracing.skip", |header| words::plain(header.tracing.skip.as_deref().unwrap_or("all"))),
    ("tracing.tests", |header| words::plain(header.tracing.tests.as_deref().unwrap_or("visited"))),
    ("sampling", |header| words::sampling(Language::English, header).unwrap_or_else(|| "none".to_owned())),
    ("seed", |header| header.seed.to_string()),
    ("frame", |header| words::frame(Language::English, header).unwrap_or_else(|| "none".to_owned())),
    ("shard", |header| header.shard.map_or("none".to_owned(), |shard| shard.to_string())),
    ("objects", |header| words::plain(&header.objects.join(", "))),
    ("lights", |header| words::plain(&header.lights.join(", "))),
];

/// What the headers say differently, in the order of a header.
pub fn header_differences(a: &Header, b: &Header) -> Vec<HeaderDifference> {
    // A million names that are the same needn't be said.
    let is_same = |field: &str| match field {
        "objects" => a.objects == b.objects,
        "lights" => a.lights == b.lights,
        _ => false,
    };
    let said = FIELDS.iter().filter(|(field, _)| !is_same(field)).map(|(field, say)| HeaderDifference {
        field,
        a: say(a),
        b: say(b),
    });
    // Another program may not know the scene's digest.
    let is_told = |said: &HeaderDifference| said.field != "scene.digest" || (!said.a.is_empty() && !said.b.is_empty());
    said.filter(|said| said.a != said.b && is_told(said)).collect()
}

fn subject(header: &Header) -> String {
    match header.subject {
        // As many digits as tell them apart.
        Subject::Ray(ray) => format!("ray {}", ray.map(|x| x.to_string()).join(",")),
        _ => words::subject(Language::English, header),
    }
}

/// The names of one list that another one hasn't.
fn only_in<'a>(names: &'a [String], others: &'a [String]) -> impl Iterator<Item = String> + use<'a> {
    let others: HashSet<&str> = others.iter().map(String::as_str).collect();
    names.iter().filter(move |name| !others.contains(name.as_str())).cloned()
}

/// How the numbers of B's objects and lights become those of A, by their names; those that only B has follow A's.
#[derive(Clone, Debug)]
pub struct Numbering {
    objects: Vec<u32>,
    lights: Vec<u32>,
    is_same: bool,
}

impl Numbering {
    /// The numbering that makes `b` agree with `a`; `b` gets the names in their new order.
    pub fn unify(a: &Header, b: &mut Header) -> Numbering {
        let is_same = a.objects == b.objects && a.lights == b.lights;
        if is_same {
            return Numbering { objects: Vec::new(), lights: Vec::new(), is_same };
        }
        b.only_elsewhere = only_in(&a.objects, &b.objects).chain(only_in(&a.lights, &b.lights)).collect();
        let objects = renumbered(&a.objects, &mut b.objects);
        let lights = renumbered(&a.lights, &mut b.lights);
        Numbering { objects, lights, is_same }
    }

    /// Gives the events of B the numbers.
    pub fn apply(&self, events: &mut [Event]) {
        if self.is_same {
            return;
        }
        let number = |numbers: &[u32], old: u32| numbers.get(old as usize).copied().unwrap_or(old);
        for event in events {
            event.what.each_id(&mut |id| match id {
                Id::Object(object) => *object = number(&self.objects, *object),
                Id::Light(light) => *light = number(&self.lights, *light),
            });
        }
    }
}

/// The numbers that these names get beside those that are there; the names become all of them.
fn renumbered(there: &[String], names: &mut Vec<String>) -> Vec<u32> {
    let mut all = there.to_vec();
    let mut numbers: HashMap<&str, u32> = HashMap::new();
    for (number, name) in (0..).zip(there) {
        // The first of equal names wins, as it does in a scene.
        numbers.entry(name).or_insert(number);
    }
    let numbered = names.iter().map(|name| {
        *numbers.entry(name).or_insert_with(|| {
            all.push(name.clone());
            all.len() as u32 - 1
        })
    });
    let numbered = numbered.collect();
    *names = all;
    numbered
}
