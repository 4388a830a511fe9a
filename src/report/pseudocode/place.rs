//! Where in the algorithm a step is, whatever the algorithm's lines are.

use crate::log::{Decision, Event, Log, Name, RayKind, Step, Term, Tree, What, scope};

macro_rules! places {
    ($($(#[$doc:meta])* $place:ident,)*) => {
        /// A place in the algorithm of ray tracing.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Place { $($(#[$doc])* $place,)* }

        impl Place {
            /// Every place.
            pub const ALL: &[Place] = &[$(Place::$place,)*];
        }
    };
}

places! {
    /// A pixel begins.
    Pixel,
    /// A sample of it is chosen.
    Sample,
    /// Its ray is set up.
    Aim,
    /// The pixel gets its colour, or it is asked whether that is known well enough.
    Mean,
    /// A ray begins.
    Call,
    /// The depth limit ends a path.
    TooDeep,
    /// The nearest hit is looked for.
    Nearest,
    /// Nothing is hit.
    Background,
    /// The point and the normal of the hit.
    Surface,
    /// The ambient part of the local colour, and what is the same for all lights.
    Ambient,
    /// A light's direction.
    Light,
    /// A shadow ray.
    Shadow,
    /// What the light adds.
    Terms,
    /// The local colour.
    LocalSum,
    /// The direction of the reflected ray.
    Reflection,
    /// The reflected ray's colour.
    Reflected,
    /// The direction of the transmitted ray.
    Transmission,
    /// Whether there is a transmitted ray.
    TotalReflection,
    /// The transmitted ray's colour.
    Transmitted,
    /// The local part of the sum.
    CombineLocal,
    /// The reflected part.
    CombineReflected,
    /// The transmitted part, and the sum.
    CombineTransmitted,
    /// A ray ends.
    Return,
}

/// Where an event is.
pub fn place(log: &Log, tree: &Tree, event: usize) -> Place {
    let Some(happening) = log.events.get(event) else { return Place::Pixel };
    let node = tree.owner(event);
    match tree.nodes()[node].step {
        None | Some(Step::Pixel(_)) => in_pixel(&happening.what),
        Some(Step::Sample { .. }) => {
            if happening.what == What::Leave {
                Place::Mean
            } else {
                Place::Sample
            }
        }
        Some(Step::Ray { kind: RayKind::Shadow { .. }, .. }) => Place::Shadow,
        Some(Step::Ray { .. }) => in_ray(log, tree, node, event),
        Some(Step::Test { .. } | Step::Motion { .. }) => in_test(log, tree, node, event),
        Some(Step::Shade { .. }) => match &happening.what {
            What::Note { name, .. } if name.is(Name::ShadeLocal) && *name != Name::ShadeLocalAmbient => Place::LocalSum,
            What::Leave => Place::LocalSum,
            _ => Place::Ambient,
        },
        Some(Step::Light { .. }) => in_light(happening),
        Some(Step::Zone { what, .. }) => match (happening.what == What::Leave, what) {
            (false, what) => direction(what),
            (true, what) => color(what),
        },
        Some(Step::Combine) => match happening.what {
            What::Enter { .. } | What::Note { name: Name::CombineLocal, .. } => Place::CombineLocal,
            What::Note { name: Name::CombineReflected, .. } => Place::CombineReflected,
            _ => Place::CombineTransmitted,
        },
    }
}

/// The place of a call inside a ray.
pub(super) fn of_call(inner: RayKind) -> Place {
    match inner {
        RayKind::Camera => Place::Mean,
        RayKind::Reflected => Place::Reflected,
        RayKind::Transmitted => Place::Transmitted,
        RayKind::Shadow { .. } => Place::Shadow,
    }
}

fn in_pixel(what: &What) -> Place {
    match what {
        What::Enter { .. } => Place::Pixel,
        _ => Place::Mean,
    }
}

fn direction(what: Term) -> Place {
    match what {
        Term::Reflected => Place::Reflection,
        Term::Transmitted => Place::Transmission,
        Term::Shadow => Place::Shadow,
        Term::Local | Term::Specular => Place::Terms,
    }
}

fn color(what: Term) -> Place {
    match what {
        Term::Reflected => Place::Reflected,
        Term::Transmitted => Place::Transmitted,
        Term::Shadow => Place::Shadow,
        Term::Local | Term::Specular => Place::Terms,
    }
}

fn in_ray(log: &Log, tree: &Tree, ray: usize, event: usize) -> Place {
    match &log.events[event].what {
        What::Enter { .. } => Place::Call,
        What::Leave | What::Result { .. } => Place::Return,
        What::Note { name, .. } => noted_in_ray(log, tree, ray, event, *name),
        What::Mark(decision) => match decision {
            Decision::Background => Place::Background,
            Decision::DepthLimit { .. } => Place::TooDeep,
            Decision::TotalInternalReflection => Place::TotalReflection,
            Decision::Skipped { what, .. } | Decision::Rejected { what } | Decision::Bent { what } => direction(*what),
            Decision::LeakGuard { what } => color(*what),
            Decision::Undefined { quantity: Name::RayDirection } => Place::Aim,
            Decision::Undefined { quantity: Name::RefractDirection } => Place::Transmission,
            Decision::Nearest { .. } | Decision::Coincident { .. } | Decision::Immersed { .. } => Place::Nearest,
            _ if is_hit_known(log, tree, ray, event) => Place::Surface,
            _ => Place::Nearest,
        },
    }
}

fn noted_in_ray(log: &Log, tree: &Tree, ray: usize, event: usize, name: Name) -> Place {
    match name.key().split('.').next().unwrap_or_default() {
        "reflect" => Place::Reflection,
        "refract" => Place::Transmission,
        "lobe" => {
            let what = latest_bounce(log, tree, ray, event);
            // The sum is of colours that the rays brought; the axes are of the directions.
            if matches!(name, Name::LobeSumFirst | Name::LobeSum | Name::LobeMean) {
                color(what)
            } else {
                direction(what)
            }
        }
        _ if is_hit_known(log, tree, ray, event) => Place::Surface,
        _ => Place::Aim,
    }
}

/// Which bounce a ray has come to: that whose direction it noted last.
fn latest_bounce(log: &Log, tree: &Tree, ray: usize, event: usize) -> Term {
    let latest = |name| scope::latest_note(&log.events, tree, ray, event, name);
    if latest(Name::RefractDirection) > latest(Name::ReflectDirection) { Term::Transmitted } else { Term::Reflected }
}

fn is_hit_known(log: &Log, tree: &Tree, ray: usize, event: usize) -> bool {
    scope::latest_mark(&log.events, tree, ray, event, &Decision::Nearest { object: 0 }).is_some()
}

/// A test belongs to the search of the ray around it; a moving object carries the hit back later.
fn in_test(log: &Log, tree: &Tree, node: usize, event: usize) -> Place {
    match tree.around(node).find_map(|at| Some((at, tree.ray(at)?))) {
        Some((_, RayKind::Shadow { .. })) => Place::Shadow,
        Some((ray, _)) if is_moving(tree, node) && is_hit_known(log, tree, ray, event) => Place::Surface,
        _ => Place::Nearest,
    }
}

fn is_moving(tree: &Tree, node: usize) -> bool {
    matches!(tree.nodes()[node].step, Some(Step::Motion { .. }))
}

fn in_light(happening: &Event) -> Place {
    match &happening.what {
        What::Note { name, .. } => match name.key().split('.').next().unwrap_or_default() {
            "half" | "mirror" | "transmit" => Place::Terms,
            "shadow" => Place::Shadow,
            _ => match name {
                Name::LightAttenuation => Place::Terms,
                Name::ShadeNDotL => Place::Light,
                _ if name.key().starts_with("shade.") => Place::Terms,
                _ => Place::Light,
            },
        },
        What::Mark(Decision::Skipped { what, .. } | Decision::LeakGuard { what }) => direction(*what),
        What::Leave => Place::Terms,
        _ => Place::Light,
    }
}
