//! What the problem states, gathered from where the steps put it in: the objects with their materials, the lights, the ambient light.

use super::Task;
use crate::log::{Log, Name, Step, Tree, Value};
use crate::report::words;
use std::collections::{HashMap, HashSet};

/// Whose data it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Owner {
    Everywhere,
    Object(u32),
    Light(u32),
}

/// What is the same wherever it is put in.
pub(super) struct Data {
    pub groups: Vec<(Owner, Vec<(Name, Value)>)>,
    /// Where the group of an owner is.
    places: HashMap<Owner, usize>,
}

/// Inputs that don't belong to the object or light at whose node they are.
const OF_THE_STEP: &[Name] = &[Name::RayOrigin, Name::RayDirection];

impl Data {
    pub(super) fn of(log: &Log, tree: &Tree) -> Data {
        let mut data = Data { groups: Vec::new(), places: HashMap::new() };
        // What has another value elsewhere, as the points of an area light have, is listed where it is put in.
        let mut varying: HashSet<(Owner, Name)> = HashSet::new();
        for (index, (_, given)) in log.events.with_given().enumerate() {
            for (name, value) in given {
                let Some(owner) = owner(tree, index, *name) else { continue };
                match data.find(owner, *name) {
                    Some(known) if known.same_bits(value) => {}
                    Some(_) => drop(varying.insert((owner, *name))),
                    None => data.put(owner, *name, *value),
                }
            }
        }
        for (owner, names) in &mut data.groups {
            names.retain(|(name, _)| !varying.contains(&(*owner, *name)));
        }
        data.groups.retain(|(_, names)| !names.is_empty());
        data.places = data.groups.iter().enumerate().map(|(place, (owner, _))| (*owner, place)).collect();
        data
    }

    fn find(&self, owner: Owner, name: Name) -> Option<Value> {
        let (_, names) = &self.groups[*self.places.get(&owner)?];
        names.iter().find(|(known, _)| *known == name).map(|(_, value)| *value)
    }

    fn put(&mut self, owner: Owner, name: Name, value: Value) {
        let place = *self.places.entry(owner).or_insert(self.groups.len());
        match self.groups.get_mut(place) {
            Some((_, names)) => names.push((name, value)),
            None => self.groups.push((owner, vec![(name, value)])),
        }
    }

    /// Whether the data have this input of an event, so that the step needn't.
    pub(super) fn has(&self, tree: &Tree, event: usize, name: Name) -> bool {
        owner(tree, event, name).is_some_and(|owner| self.find(owner, name).is_some())
    }
}

fn owner(tree: &Tree, event: usize, name: Name) -> Option<Owner> {
    if OF_THE_STEP.contains(&name) {
        return None;
    }
    if name == Name::AmbientLight {
        return Some(Owner::Everywhere);
    }
    match tree.nodes()[tree.owner(event)].step? {
        Step::Test { object, triangle: None } | Step::Shade { object } => Some(Owner::Object(object)),
        Step::Light { light, split: 0 } => Some(Owner::Light(light)),
        _ => None,
    }
}

/// The heading of a group.
pub(super) fn heading(task: &Task, owner: Owner) -> String {
    let (texts, header) = (&task.language.texts().solution, &task.log.header);
    match owner {
        Owner::Everywhere => texts.everywhere.to_owned(),
        Owner::Object(object) => (texts.object)(&words::plain(header.object(object))),
        Owner::Light(light) => (texts.source)(&words::plain(header.light(light))),
    }
}
