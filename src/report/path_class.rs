//! What kind of path light takes (Ramos, section 1.2.4 and figure 14; the notation is Heckbert's, "Adaptive radiosity textures for
//! bidirectional ray tracing", 1990).
//!
//! From the light L to the eye E every surface scatters diffusely, D, or like a mirror or a lens, S. Figure 14 has the four ways
//! in which light goes from one surface to the next: a D→D, b S→D, c D→S, d S→S. Ray tracing has c and d, and d only along sharp
//! directions; direct light, which comes from no surface, is scattered as in b. For all of a and the rest of b is the
//! ambient light, A. What leaves the scene gets the background, B.

use crate::log::plane::class_word;
use crate::log::{Decision, Log, RayKind, Tree, What};

/// How the last surface before the bounces, the first after the light, scatters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// A light on a surface, which scatters it diffusely, like a blurred mirror or lens, or both.
    Light {
        /// The diffuse term is there.
        diffuse: bool,
        /// The specular or the transmitted term is there.
        specular: bool,
    },
    /// Ambient light.
    Ambient,
    /// The background.
    Background,
}

/// The class of a path that bounces so often, such as `LDSE`.
pub fn notation(source: Source, bounces: usize) -> String {
    let source = match source {
        Source::Light { diffuse: true, specular: true } => "L(D|S)",
        Source::Light { diffuse: true, .. } => "LD",
        Source::Light { .. } => "LS",
        Source::Ambient => "A",
        Source::Background => "B",
    };
    class_word(source, bounces)
}

/// The ways of figure 14 that light goes on such a path, from surface to surface.
pub fn cases(source: Source, bounces: usize) -> &'static str {
    match (source, bounces) {
        (Source::Light { .. }, 0) => "direct",
        (Source::Light { diffuse: true, specular: true }, _) => "c d",
        (Source::Light { diffuse: true, .. }, 1) => "c",
        (Source::Light { diffuse: true, .. }, _) => "c d",
        (Source::Light { .. }, _) => "d",
        (Source::Ambient, _) => "for a",
        (Source::Background, _) => "",
    }
}

/// The class of the light that a ray brings from the lights to the eye, such as `L(D|S)SE`; `None` outside every ray.
pub fn of_ray(log: &Log, tree: &Tree, node: usize) -> Option<String> {
    let ray = tree.around(node).find(|at| tree.ray(*at).is_some())?;
    let meets_nothing = |event: usize| log.events[event].what == What::Mark(Decision::Background);
    let source = match tree.own_events(ray).any(meets_nothing) {
        true => Source::Background,
        false => Source::Light { diffuse: true, specular: true },
    };
    let kinds = tree.around(node).filter_map(|at| tree.ray(at));
    let bounces = kinds.filter(|kind| matches!(kind, RayKind::Reflected | RayKind::Transmitted)).count();
    Some(notation(source, bounces))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figure_14() {
        let [diffuse, specular, both] =
            [(true, false), (false, true), (true, true)].map(|(diffuse, specular)| Source::Light { diffuse, specular });
        assert_eq!((notation(both, 0).as_str(), cases(both, 0)), ("L(D|S)E", "direct"));
        assert_eq!((notation(diffuse, 1).as_str(), cases(diffuse, 1)), ("LDSE", "c"));
        assert_eq!((notation(specular, 2).as_str(), cases(specular, 2)), ("LSSSE", "d"));
        assert_eq!((notation(diffuse, 2).as_str(), cases(diffuse, 2)), ("LDSSE", "c d"));
        assert_eq!(notation(Source::Background, 12), "BS¹²E");
        assert_eq!(notation(Source::Ambient, 0), "AE");
    }
}
