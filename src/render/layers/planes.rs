//! Layers that are asked for by name, as a scene has what they name.

use crate::files::suggest;
use crate::log::Name;
use crate::log::plane::{Class, Emitter, Plane, ValueAt, class_word};
use crate::scene::{Sampling, Scene};
use std::sync::Arc;

/// Planes of a scene, and where in the numbers of a pixel each has its own.
#[derive(Clone, Debug, Default)]
pub struct Planes(Arc<Resolved>);

#[derive(Debug, Default)]
pub(super) struct Resolved {
    /// Their names, in the order in which they were asked for.
    names: Vec<Plane>,
    /// The quantities.
    pub values: Vec<Place<ValueAt>>,
    /// Sums of what paths bring.
    pub sums: Vec<Place<Paths>>,
    /// Of each quantity by its number in the table of names, which of the values it is.
    by_name: Vec<Vec<u16>>,
    /// How many numbers a pixel has.
    pub numbers: usize,
    /// Whether cells say how much a sample counts.
    pub has_cells: bool,
}

/// A plane, and which of a pixel's numbers is its first.
#[derive(Debug)]
pub(super) struct Place<T> {
    pub of: T,
    pub at: usize,
}

/// The paths that a layer adds up.
#[derive(Debug)]
pub(super) enum Paths {
    /// Those from a light.
    Light(u32),
    /// Those of ambient light.
    Ambient,
    /// Those from the background.
    Background,
    /// Those of a class: for each beginning (`LD`, `LS`, `A`, `B`) whether this many bounces have it.
    Class([Vec<bool>; 4]),
}

/// Why a plane isn't one of a scene.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NoPlane {
    /// There is no such light.
    #[error("{}", self.text_of_light())]
    Light {
        /// The name that was asked for.
        name: String,
        /// The lights there are.
        known: Vec<String>,
    },
    /// No path can have the class.
    #[error("no path is of the class {class}; here there are {}", known.join(", "))]
    Class {
        /// The class.
        class: String,
        /// The classes there can be, the first of them.
        known: Vec<String>,
    },
    /// There are too many.
    #[error("too many layers, expected at most {MAX_PLANES} that are asked for by name")]
    TooMany,
}

/// The most layers of a picture that are asked for by name.
pub const MAX_PLANES: usize = 256;

/// Up to how many bounces a class of its own is listed; more are one class together.
const LISTED_BOUNCES: u32 = 3;

impl NoPlane {
    fn text_of_light(&self) -> String {
        let NoPlane::Light { name, known } = self else { return String::new() };
        let known: Vec<&str> = known.iter().map(String::as_str).collect();
        crate::files::unknown("light", name, &known)
    }

    /// What was probably meant.
    pub fn near(&self) -> Option<&str> {
        match self {
            NoPlane::Light { name, known } => suggest(name, known.iter().map(String::as_str)),
            _ => None,
        }
    }
}

impl PartialEq for Planes {
    fn eq(&self, other: &Planes) -> bool {
        self.0.names == other.0.names
    }
}

impl Eq for Planes {}

impl Planes {
    /// Those with these names in a scene.
    ///
    /// # Errors
    /// [`NoPlane`].
    pub fn of(scene: &Scene, names: &[Plane]) -> Result<Planes, NoPlane> {
        if names.len() > MAX_PLANES {
            return Err(NoPlane::TooMany);
        }
        let mut found = Resolved {
            names: names.to_vec(),
            by_name: vec![Vec::new(); Name::all().count()],
            has_cells: matches!(scene.sampling, Sampling::Adaptive { .. }),
            ..Resolved::default()
        };
        for plane in names {
            let at = found.numbers;
            found.numbers += plane.numbers();
            match plane {
                Plane::Value(value) => {
                    for name in Name::all().filter(|name| name.is(value.name)) {
                        found.by_name[name as usize].push(found.values.len() as u16);
                    }
                    found.values.push(Place { of: value.clone(), at });
                }
                Plane::Light(name) => found.sums.push(Place { of: paths_from(scene, name)?, at }),
                Plane::Class(class) => found.sums.push(Place { of: paths_of(scene, class)?, at }),
            }
        }
        Ok(Planes(Arc::new(found)))
    }

    pub(super) fn resolved(&self) -> &Resolved {
        &self.0
    }

    /// Their names.
    pub fn names(&self) -> &[Plane] {
        &self.0.names
    }

    /// How many numbers a pixel has of all of them.
    pub fn numbers(&self) -> usize {
        self.0.numbers
    }
}

impl Resolved {
    /// Which of the values a quantity is.
    #[inline]
    pub fn values_of(&self, name: Name) -> &[u16] {
        self.by_name.get(name as usize).map_or(&[], Vec::as_slice)
    }
}

impl Paths {
    /// Whether those are among them that this light begins and that bounce so often.
    pub fn have(&self, emitter: Emitter, bounces: u32) -> bool {
        match self {
            Paths::Light(wanted) => matches!(emitter, Emitter::Light { light, .. } if light == *wanted),
            Paths::Ambient => emitter == Emitter::Ambient,
            Paths::Background => emitter == Emitter::Background,
            Paths::Class(classes) => classes[kind(emitter)].get(bounces as usize).copied().unwrap_or(false),
        }
    }
}

fn kind(emitter: Emitter) -> usize {
    match emitter {
        Emitter::Light { is_diffuse: true, .. } => 0,
        Emitter::Light { is_diffuse: false, .. } => 1,
        Emitter::Ambient => 2,
        Emitter::Background => 3,
    }
}

const KINDS: [Emitter; 4] = [
    Emitter::Light { light: 0, is_diffuse: true },
    Emitter::Light { light: 0, is_diffuse: false },
    Emitter::Ambient,
    Emitter::Background,
];

/// The paths from the light of this name. A light that is called as what comes from no light goes first.
fn paths_from(scene: &Scene, name: &str) -> Result<Paths, NoPlane> {
    if let Some(light) = scene.lights.iter().position(|light| light.name == name) {
        return Ok(Paths::Light(light as u32));
    }
    match name {
        Plane::AMBIENT => Ok(Paths::Ambient),
        Plane::BACKGROUND => Ok(Paths::Background),
        _ => {
            let lights = scene.lights.iter().map(|light| light.name.to_string());
            let known = lights.chain([Plane::AMBIENT, Plane::BACKGROUND].map(str::to_owned)).collect();
            Err(NoPlane::Light { name: name.to_owned(), known })
        }
    }
}

/// The paths of a class, up to the depth of the scene.
fn paths_of(scene: &Scene, class: &Class) -> Result<Paths, NoPlane> {
    let deepest = deepest(scene);
    let classes = KINDS.map(|kind| {
        let of_bounces = |bounces| is_possible(scene, kind) && class.matches(kind.letters(), bounces as usize);
        (0..=deepest).map(of_bounces).collect::<Vec<_>>()
    });
    if classes.iter().flatten().any(|is_there| *is_there) {
        return Ok(Paths::Class(classes));
    }
    Err(NoPlane::Class { class: class.text().to_owned(), known: classes_of(scene) })
}

/// How often light can bounce in a scene.
fn deepest(scene: &Scene) -> u32 {
    let bounces = scene.materials.iter().any(|material| material.reflects() || material.transmits());
    if bounces { scene.tracing.max_depth } else { 0 }
}

/// Whether a scene has light that begins so.
fn is_possible(scene: &Scene, emitter: Emitter) -> bool {
    match emitter {
        Emitter::Light { .. } => !scene.lights.is_empty(),
        Emitter::Ambient | Emitter::Background => true,
    }
}

/// The classes that the paths of a scene can have, as patterns of which each path has one: those of few bounces by themselves, those of more
/// together.
pub fn classes_of(scene: &Scene) -> Vec<String> {
    let deepest = deepest(scene);
    let kinds = || KINDS.into_iter().filter(|kind| is_possible(scene, *kind)).map(Emitter::letters);
    let few = (0..=deepest.min(LISTED_BOUNCES))
        .flat_map(|bounces| kinds().map(move |letters| class_word(letters, bounces as usize)));
    let more = kinds().map(|letters| format!("{letters}{}S*E", "S".repeat(LISTED_BOUNCES as usize + 1)));
    few.chain(more.filter(|_| deepest > LISTED_BOUNCES)).collect()
}

/// All lights of a scene and what comes from none: planes that add up to the picture.
pub fn lights_of(scene: &Scene) -> Vec<Plane> {
    let is_taken = |name: &str| scene.lights.iter().any(|light| light.name == name);
    let rest = [(Plane::AMBIENT, "AS*E"), (Plane::BACKGROUND, "BS*E")].map(|(name, class)| match is_taken(name) {
        false => Plane::Light(name.to_owned()),
        // What has lost its name to a light has a class of its own.
        true => class.parse().map_or_else(|_| Plane::Light(name.to_owned()), Plane::Class),
    });
    scene.lights.iter().map(|light| Plane::Light(light.name.to_string())).chain(rest).collect()
}
