//! Where in the algorithm a step is, whatever the algorithm's lines are.

use crate::log::{Decision, Event, Log, Name, RayKind, Step, Term, Tree, What, scope};

macro_rules! stages {
    ($($(#[$doc:meta])* $stage:ident,)*) => {
        /// A stage of the algorithm of ray tracing.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Stage { $($(#[$doc])* $stage,)* }

        impl Stage {
            /// Every stage.
            pub const ALL: &[Stage] = &[$(Stage::$stage,)*];
        }
    };
}

stages! {
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
pub fn stage(log: &Log, tree: &Tree, event: usize) -> Stage {
    let Some(happening) = log.events.get(event) else { return Stage::Pixel };
    let node = tree.owner(event);
    match tree.nodes()[node].step {
        None | Some(Step::Pixel(_)) => in_pixel(&happening.what),
        Some(Step::Sample { .. }) => {
            if happening.what == What::Leave {
                Stage::Mean
            } else {
                Stage::Sample
            }
        }
        Some(Step::Ray { kind: RayKind::Shadow { .. }, .. }) => Stage::Shadow,
        Some(Step::Ray { .. }) => in_ray(log, tree, node, event),
        Some(Step::Test { .. } | Step::Motion { .. }) => in_test(log, tree, node, event),
        Some(Step::Shade { .. }) => match &happening.what {
            What::Note { name, .. } if name.is(Name::ShadeLocal) && *name != Name::ShadeLocalAmbient => Stage::LocalSum,
            What::Leave => Stage::LocalSum,
            _ => Stage::Ambient,
        },
        Some(Step::Light { .. }) => in_light(happening),
        Some(Step::Zone { what, .. }) => match (happening.what == What::Leave, what) {
            (false, what) => direction(what),
            (true, what) => color(what),
        },
        Some(Step::Combine) => match happening.what {
            What::Enter { .. } | What::Note { name: Name::CombineLocal, .. } => Stage::CombineLocal,
            What::Note { name: Name::CombineReflected, .. } => Stage::CombineReflected,
            _ => Stage::CombineTransmitted,
        },
    }
}

/// The stage of a call inside a ray.
pub(super) fn of_call(inner: RayKind) -> Stage {
    match inner {
        RayKind::Camera => Stage::Mean,
        RayKind::Reflected => Stage::Reflected,
        RayKind::Transmitted => Stage::Transmitted,
        RayKind::Shadow { .. } => Stage::Shadow,
    }
}

fn in_pixel(what: &What) -> Stage {
    match what {
        What::Enter { .. } => Stage::Pixel,
        _ => Stage::Mean,
    }
}

fn direction(what: Term) -> Stage {
    match what {
        Term::Reflected => Stage::Reflection,
        Term::Transmitted => Stage::Transmission,
        Term::Shadow => Stage::Shadow,
        Term::Local | Term::Specular => Stage::Terms,
    }
}

fn color(what: Term) -> Stage {
    match what {
        Term::Reflected => Stage::Reflected,
        Term::Transmitted => Stage::Transmitted,
        Term::Shadow => Stage::Shadow,
        Term::Local | Term::Specular => Stage::Terms,
    }
}

fn in_ray(log: &Log, tree: &Tree, ray: usize, event: usize) -> Stage {
    match &log.events[event].what {
        What::Enter { .. } => Stage::Call,
        What::Leave | What::Result { .. } => Stage::Return,
        What::Note { name, .. } => noted_in_ray(log, tree, ray, event, *name),
        What::Mark(decision) => match decision {
            Decision::Background => Stage::Background,
            Decision::DepthLimit { .. } => Stage::TooDeep,
            Decision::TotalInternalReflection => Stage::TotalReflection,
            Decision::Skipped { what, .. } | Decision::Rejected { what } | Decision::Bent { what } => direction(*what),
            Decision::LeakGuard { what } => color(*what),
            Decision::Undefined { quantity: Name::RayDirection } => Stage::Aim,
            Decision::Undefined { quantity: Name::RefractDirection } => Stage::Transmission,
            Decision::Nearest { .. } | Decision::Coincident { .. } | Decision::Immersed { .. } => Stage::Nearest,
            _ if is_hit_known(log, tree, ray, event) => Stage::Surface,
            _ => Stage::Nearest,
        },
    }
}

fn noted_in_ray(log: &Log, tree: &Tree, ray: usize, event: usize, name: Name) -> Stage {
    match name.key().split('.').next().unwrap_or_default() {
        "reflect" => Stage::Reflection,
        "refract" => Stage::Transmission,
        "lobe" => {
            let what = latest_bounce(log, tree, ray, event);
            // The sum is of colours that the rays brought; the axes are of the directions.
            if matches!(name, Name::LobeSumFirst | Name::LobeSum | Name::LobeMean) {
                color(what)
            } else {
                direction(what)
            }
        }
        _ if is_hit_known(log, tree, ray, event) => Stage::Surface,
        _ => Stage::Aim,
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
fn in_test(log: &Log, tree: &Tree, node: usize, event: usize) -> Stage {
    match tree.around(node).find_map(|at| Some((at, tree.ray(at)?))) {
        Some((_, RayKind::Shadow { .. })) => Stage::Shadow,
        Some((ray, _)) if is_moving(tree, node) && is_hit_known(log, tree, ray, event) => Stage::Surface,
        _ => Stage::Nearest,
    }
}

fn is_moving(tree: &Tree, node: usize) -> bool {
    matches!(tree.nodes()[node].step, Some(Step::Motion { .. }))
}

fn in_light(happening: &Event) -> Stage {
    match &happening.what {
        What::Note { name, .. } => match name.key().split('.').next().unwrap_or_default() {
            "half" | "mirror" | "transmit" => Stage::Terms,
            "shadow" => Stage::Shadow,
            _ => match name {
                Name::LightAttenuation => Stage::Terms,
                Name::ShadeNDotL => Stage::Light,
                _ if name.key().starts_with("shade.") => Stage::Terms,
                _ => Stage::Light,
            },
        },
        What::Mark(Decision::Skipped { what, .. } | Decision::LeakGuard { what }) => direction(*what),
        What::Leave => Stage::Terms,
        _ => Stage::Light,
    }
}
