//! The algorithms of the source text as lines (Ramos, section 1.1.1), and which line each step of a log belongs to.
//!
//! The lines follow the two pseudocodes, with what they leave open filled in as the tracer does it. A tracer that
//! has one code path for all three runs them in its own order only where that can't be told from the log: it asks for the depth
//! before a bounce instead of after it.

mod stage;

pub use stage::{Stage, stage};

use super::language::Language;
use crate::log::{Header, Log, RayKind, Step, Tree};
use Stage::*;
use std::sync::LazyLock;

/// A line of an algorithm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line {
    /// How far it is indented.
    pub indent: u8,
    /// What it says in English and in Spanish, there in the source text's own words as far as it has them.
    texts: [&'static str; 2],
    /// The steps that belong to it.
    pub stages: &'static [Stage],
}

impl Line {
    /// What it says in a language.
    pub fn text(&self, language: Language) -> &'static str {
        self.texts[language as usize]
    }
}

const fn line(indent: u8, english: &'static str, spanish: &'static str, stages: &'static [Stage]) -> Line {
    Line { indent, texts: [english, spanish], stages }
}

/// The first pseudocode.
const RECURSIVE: &[Line] = &[
    line(0, "picture()", "imagen()", &[]),
    line(1, "for each pixel", "for cada píxel", &[Pixel]),
    line(
        2,
        "for each sample: the ray from the eye through it",
        "for cada muestra: el rayo desde el ojo que pasa por ella",
        &[Sample, Aim],
    ),
    line(2, "pixel = mean of TR(eye, direction, 0)", "píxel = media de TR(ojo, dirección, 0)", &[Mean]),
    line(0, "color TR(origin, direction, depth)", "color TR(inicio_rayo, dir_rayo, profundidad)", &[Call]),
    line(1, "if depth > max_depth return black", "if profundidad > PROFUNDIDAD_MAX return negro", &[TooDeep]),
    line(
        1,
        "point = nearest_intersection(origin, direction)",
        "pto_interseccion = hallar_interseccion(inicio_rayo, dir_rayo)",
        &[Nearest, Surface],
    ),
    line(1, "if there is none return background", "if no hay intersección return COLOR_FONDO", &[Background]),
    line(
        1,
        "local = local_contribution(point)",
        "color_local = contribucion_local(pto_interseccion)",
        &[Ambient, LocalSum],
    ),
    line(2, "for each light: its direction, N · L", "for cada fuente de luz: su dirección, N · L", &[Light]),
    line(3, "shadow ray: how much light gets through", "rayo de sombra: cuánta luz llega", &[Shadow]),
    line(3, "diffuse, specular and transmitted terms", "términos de luz difusa, especular y transmitida", &[Terms]),
    line(1, "dir_r = reflection_direction()", "dir_reflexion = direccion_reflexion()", &[Reflection]),
    line(
        1,
        "reflected = TR(point, dir_r, depth + 1)",
        "color_reflexion = TR(pto_interseccion, dir_reflexion, profundidad + 1)",
        &[Reflected],
    ),
    line(
        1,
        "dir_t = transmission_direction()",
        "dir_transmision = direccion_transmision()",
        &[Transmission, TotalReflection],
    ),
    line(
        1,
        "transmitted = TR(point, dir_t, depth + 1)",
        "color_transmision = TR(pto_interseccion, dir_transmision, profundidad + 1)",
        &[Transmitted],
    ),
    line(1, "return combine(local, W_l,", "return combinar_colores(color_local, W_l,", &[CombineLocal]),
    line(3, "reflected, W_r,", "color_reflexion, W_r,", &[CombineReflected]),
    line(3, "transmitted, W_t)", "color_transmision, W_t)", &[CombineTransmitted, Return]),
];

/// The second pseudocode up to its lights.
const SECOND: &[Line] = &[
    line(0, "procedure RT_picture", "procedure TR_recursivo", &[]),
    line(
        1,
        "for each line, for each pixel of it",
        "for cada línea horizontal, for cada píxel de la línea do",
        &[Pixel],
    ),
    line(
        2,
        "the ray from the eye through the pixel",
        "el rayo desde el centro de proyección hacia el píxel",
        &[Sample, Aim],
    ),
    line(2, "pixel := RT_trace(ray, 1)", "píxel := TR_trazado(rayo, 1)", &[Mean]),
    line(0, "procedure RT_trace(ray, depth)", "procedure TR_trazado(rayo, prof_actual)", &[Call]),
    line(1, "the nearest intersection with an object", "la intersección más cercana con un objeto", &[Nearest]),
    line(1, "if there is one", "if interseca con un objeto then", &[]),
    line(2, "the normal there", "el vector normal en el punto de intersección", &[Surface]),
    line(
        2,
        "RT_trace := RT_shade(object, ray, point, normal, depth)",
        "TR_trazado := TR_tonalidad(objeto, rayo, punto, normal, prof_actual)",
        &[Return],
    ),
    line(1, "else RT_trace := BACKGROUND", "else TR_trazado := COLOR_DE_FONDO", &[Background]),
    line(
        0,
        "procedure RT_shade(object, ray, point, normal, depth)",
        "procedure TR_tonalidad(objeto, rayo, punto, normal, prof_actual)",
        &[],
    ),
    line(1, "color := ambient colour", "color := COLOR_AMBIENTAL", &[Ambient]),
];

/// The depth limit of the second pseudocode.
const LIMIT: Line = line(1, "if depth < depth limit", "if prof_actual < ProfundidadLimite then", &[TooDeep]);

/// What it does with lights, where the depth limit doesn't stop that.
const LIGHTS: &[Line] = &[
    line(1, "for each light", "for cada fuente de luz do", &[Light]),
    line(2, "ray_s := from the point to the light", "RayoS := rayo desde el punto hacia la fuente de luz", &[]),
    line(2, "if it is in front of the surface", "if la dirección de la luz es positiva respecto a la normal then", &[]),
    line(3, "how much light is blocked", "cuánta luz es bloqueada", &[Shadow]),
    line(
        3,
        "diffuse and specular terms, added to color",
        "términos de luz difusa y especular, añadidos a color",
        &[Terms, LocalSum],
    ),
];

/// What the depth limit stops in any case, and the end.
const BOUNCES: &[Line] = &[
    line(2, "if the object reflects", "if el objeto es reflectante then", &[]),
    line(3, "ray_r := direction of reflection", "RayoR := dirección del rayo reflejado", &[Reflection]),
    line(3, "color_r := RT_trace(ray_r, depth + 1)", "ColorR := TR_trazado(RayoR, prof_actual + 1)", &[Reflected]),
    line(3, "scale color_r, add it to color", "escalar ColorR y añadirlo a color", &[CombineLocal, CombineReflected]),
    line(2, "if the object transmits", "if el objeto es transparente then", &[]),
    line(3, "ray_t := direction of refraction", "RayoT := dirección del rayo transmitido", &[Transmission]),
    line(3, "if there is no total reflection", "if no hay reflexión total then", &[TotalReflection]),
    line(4, "color_t := RT_trace(ray_t, depth + 1)", "ColorT := TR_trazado(RayoT, prof_actual + 1)", &[Transmitted]),
    line(4, "scale color_t, add it to color", "escalar ColorT y añadirlo a color", &[CombineTransmitted]),
    line(1, "RT_shade := color", "TR_tonalidad := color", &[]),
];

/// The second pseudocode as printed: at the limit a hit has its ambient colour only.
static WHITTED: LazyLock<Vec<Line>> = LazyLock::new(|| {
    let lights = LIGHTS.iter().map(|line| Line { indent: line.indent + 1, ..*line });
    SECOND.iter().copied().chain([LIMIT]).chain(lights).chain(BOUNCES.iter().copied()).collect()
});

/// The second as in its source: at the limit only the bounces stop.
static FOLEY: LazyLock<Vec<Line>> = LazyLock::new(|| [SECOND, LIGHTS, &[LIMIT], BOUNCES].concat());

/// The lines of the algorithm in use.
pub fn lines(header: &Header) -> &'static [Line] {
    match header.tracing.algorithm.as_str() {
        "whitted" => &WHITTED,
        "foley" => &FOLEY,
        _ => RECURSIVE,
    }
}

/// The line of a stage.
pub fn line_of(header: &Header, stage: Stage) -> usize {
    // Every stage has a line in every algorithm; a test says so.
    lines(header).iter().position(|line| line.stages.contains(&stage)).unwrap_or(0)
}

/// The line that an event belongs to.
pub fn current_line(log: &Log, tree: &Tree, event: usize) -> usize {
    line_of(&log.header, stage(log, tree, event))
}

/// A call of the tracer that isn't over: a ray on the way from the eye.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Call {
    /// Its node.
    pub node: usize,
    /// What is called, such as `TR(C R, 1)`.
    pub text: String,
    /// The line at which it is now: where it calls the next, or the current line.
    pub line: usize,
}

/// The call that traces the ray with this path, at this depth of the ray tree: `TR(C R, 1)`. The language names the procedures of the
/// second pseudocode.
pub fn call(language: Language, header: &Header, path: &str, depth: u32) -> String {
    let (procedure, first) = match (calls_too_deep(header), language) {
        (true, _) => ("TR", 0),
        (false, Language::English) => ("RT_trace", 1),
        (false, Language::Spanish) => ("TR_trazado", 1),
    };
    format!("{procedure}({path}, {})", u64::from(depth) + first)
}

/// Whether the algorithm asks for the depth in the call, and not before it.
pub fn calls_too_deep(header: &Header) -> bool {
    header.tracing.algorithm == "recursive"
}

/// The calls around an event, the outermost first: the way through the tree of calls (figure 9). A shadow ray is the last.
pub fn stack(language: Language, log: &Log, tree: &Tree, event: usize) -> Vec<Call> {
    let calls = tree.around(tree.owner(event)).filter_map(|node| match tree.nodes()[node].step {
        Some(Step::Ray { kind, depth, .. }) => Some((node, kind, depth)),
        _ => None,
    });
    let mut stack: Vec<Call> = Vec::new();
    let mut inner: Option<RayKind> = None;
    for (node, kind, depth) in calls {
        let line = match inner {
            None => current_line(log, tree, event),
            Some(inner) => line_of(&log.header, stage::of_call(inner)),
        };
        let path = tree.shown_path(node);
        let text = match kind {
            RayKind::Shadow { .. } => (language.texts().viewer.panes.shadow_ray)(&path),
            _ => call(language, &log.header, &path, depth),
        };
        stack.push(Call { node, text, line });
        inner = Some(kind);
    }
    stack.reverse();
    stack
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_stage_has_one_line_in_every_algorithm() {
        for lines in [RECURSIVE, &WHITTED, &FOLEY] {
            for stage in Stage::ALL {
                let count = lines.iter().filter(|line| line.stages.contains(stage)).count();
                assert_eq!(count, 1, "{stage:?} in {}", lines[0].text(Language::English));
            }
        }
    }
}
