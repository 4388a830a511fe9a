//! The words for nodes and decisions.

use super::{Style, number};
use crate::log::{
    Acceptance, Decision, Event, Header, Log, Miss, Name, RayKind, SkipReason, Skippable, Split, Step, Subject, Tree,
    Value,
};

/// What a node is, such as `ray C R, reflected` or `test sphere`.
pub fn title(log: &Log, tree: &Tree, node: usize) -> String {
    let header = &log.header;
    match tree.nodes()[node].step {
        None => subject(header),
        Some(Step::Pixel([x, y])) => format!("pixel {x},{y}"),
        Some(Step::Sample { number }) => format!("sample {number}"),
        Some(Step::Ray { kind, .. }) => format!("ray {}, {}", tree.path(node), ray_kind(header, kind)),
        Some(Step::Test { object, triangle: None }) => format!("test {}", plain(header.object(object))),
        Some(Step::Test { object, triangle: Some(triangle) }) => {
            format!("test {}, triangle {triangle}", plain(header.object(object)))
        }
        Some(Step::Shade { object }) => format!("local model on {}", plain(header.object(object))),
        Some(Step::Light { light, split: 0 }) => format!("light {}", plain(header.light(light))),
        Some(Step::Light { light, split }) => format!("light {}, point {split}", plain(header.light(light))),
        Some(Step::Motion { object }) => format!("{} where it is at this time", plain(header.object(object))),
        Some(Step::Zone { what: Skippable::Transmitted, number }) => format!("zone {number} of the transmission"),
        Some(Step::Zone { number, .. }) => format!("zone {number} of the reflection"),
        Some(Step::Combine) => "weighted sum".to_owned(),
    }
}

/// What a log is about, such as `pixel 160,120`.
pub fn subject(header: &Header) -> String {
    match header.subject {
        Subject::Pixel([x, y]) => format!("pixel {x},{y}"),
        Subject::Region([x0, y0, x1, y1]) => format!("region {x0},{y0} to {x1},{y1}"),
        Subject::Ray([ox, oy, oz, dx, dy, dz]) => {
            let triple = |xyz| number::value(&Value::Triple(xyz), Style::default());
            format!("ray from {} along {}", triple([ox, oy, oz]), triple([dx, dy, dz]))
        }
    }
}

/// How pixels were sampled, such as `shared: n = 1`; nothing for one ray through the centre.
pub fn sampling(header: &Header) -> Option<String> {
    let (method, parameters) = header.sampling.iter().find(|(method, _)| *method != "none")?;
    let parameters: Vec<_> = parameters.iter().map(|(name, value)| format!("{name} = {value}")).collect();
    Some(format!("{}: {}", plain(method), plain(&parameters.join(", "))))
}

/// Which frame of an animation a log is about, such as `frame 7`; nothing where there is one only.
pub fn frame(header: &Header) -> Option<String> {
    header.frame.map(|frame| format!("frame {}", frame.number))
}

/// What a ray is for.
pub fn ray_kind(header: &Header, kind: RayKind) -> String {
    match kind {
        RayKind::Camera => "from the eye".to_owned(),
        RayKind::Shadow { light } => format!("shadow ray to {}", plain(header.light(light))),
        RayKind::Reflected => "reflected".to_owned(),
        RayKind::Transmitted => "transmitted".to_owned(),
    }
}

/// A decision as a sentence.
pub fn decision(header: &Header, decision: &Decision, style: Style) -> String {
    match decision {
        Decision::Hit => "hit".to_owned(),
        Decision::Miss { why } => format!("miss: {}", miss(*why)),
        Decision::Outside => "the ray begins outside".to_owned(),
        Decision::Inside => "the ray begins inside".to_owned(),
        Decision::Nearest { object } => format!("nearest: {}", plain(header.object(*object))),
        Decision::Background => "nothing is hit: background".to_owned(),
        Decision::Occluded { object } => format!("blocked by {}", plain(header.object(*object))),
        Decision::Attenuated { object, factor } => {
            format!(
                "passes {}, which keeps {}",
                plain(header.object(*object)),
                number::value(&Value::Triple(*factor), style)
            )
        }
        Decision::Undefined { quantity: Name::PatternCell } => {
            format!("{} has no value: the pattern is finer than numbers are here", Name::PatternCell.symbol())
        }
        Decision::Undefined { quantity } => {
            format!("{} has no value in this arithmetic: it would be divided by zero", quantity.symbol())
        }
        Decision::TotalInternalReflection => "total internal reflection".to_owned(),
        Decision::DepthLimit { what } => format!("depth limit: no {}", skippable(*what)),
        Decision::Skipped { why: SkipReason::Blocked, .. } => "the rest is skipped".to_owned(),
        Decision::LeakGuard { what } => {
            format!("no leak: the {} lies beyond the surface and brings nothing", skippable(*what))
        }
        Decision::Rejected { what } => format!("rejected: the {} would run on the wrong side", skippable(*what)),
        Decision::Skipped { what, why } => format!("skipped: {} ({})", skippable(*what), skip_reason(*why)),
        Decision::Subdivided { cell, why, object } => {
            let object = object.map_or("an object", |object| header.object(object));
            format!("{} is subdivided: {}", self::cell(cell, style), split(*why, &plain(object)))
        }
        Decision::Accepted { cell, why } => {
            let what = cell.map_or("the mean".to_owned(), |cell| self::cell(&cell, style));
            format!("{what} is accepted: {}", acceptance(*why))
        }
        Decision::MoreSamples { from, to } => {
            format!("{from} samples are too few, the interval of their mean is too wide: {to} are taken")
        }
    }
}

/// What a decision cost at most, where it cost anything: `at most (0.1, 0, 0) of the sample was lost`.
pub fn lost(event: &Event, style: Style) -> Option<String> {
    let (_, bound) = event.given.iter().find(|(name, _)| *name == Name::CutoffLoss)?;
    Some(format!("at most {} of the sample was lost", number::value(bound, style)))
}

fn cell([x, y, side]: &[f64; 3], style: Style) -> String {
    let number = |x: f64| number::value(&Value::Number(x), style);
    if *side == 1.0 {
        return "the pixel".to_owned();
    }
    format!("the cell at ({}, {}) with side {}", number(*x), number(*y), number(*side))
}

fn split(why: Split, object: &str) -> String {
    match why {
        Split::Color => "the colours at its corners differ by more than the threshold".to_owned(),
        Split::Objects => "its corners see different objects".to_owned(),
        Split::SmallObject => format!("{object} may lie in it, and no corner sees that"),
    }
}

fn acceptance(why: Acceptance) -> &'static str {
    match why {
        Acceptance::Alike => "the samples agree",
        Acceptance::Depth => "it may not be cut further",
        Acceptance::Interval => "its interval is narrow enough",
        Acceptance::Max => "there may be no more samples",
    }
}

fn miss(why: Miss) -> &'static str {
    match why {
        Miss::Parallel => "the ray runs parallel to it",
        Miss::Behind => "it lies behind the ray",
        Miss::Beside => "the ray passes beside it",
        Miss::Beyond => "it lies beyond the light",
        Miss::FacesAway => "it turns its back to the ray",
    }
}

fn skippable(what: Skippable) -> &'static str {
    match what {
        Skippable::Reflected => "reflected ray",
        Skippable::Transmitted => "transmitted ray",
        Skippable::Shadow => "shadow ray",
        Skippable::Local => "local model",
        Skippable::Specular => "specular term",
    }
}

fn skip_reason(why: SkipReason) -> &'static str {
    match why {
        SkipReason::ZeroWeight => "its weight is zero",
        SkipReason::NoLocalTerm => "no coefficient could use the light",
        SkipReason::Blocked => "already fully blocked",
        SkipReason::Cutoff => "its weight is below the cutoff",
        SkipReason::ZeroPath => "the weights on its path leave nothing of any channel",
        SkipReason::ZeroLocal => "its weight is zero",
        SkipReason::ZeroTerm => "its coefficient is zero",
        SkipReason::Behind => "the light stands behind the surface",
    }
}

/// A name from a file with its control characters escaped, so that it can't command a terminal.
pub fn plain(name: &str) -> String {
    if name.chars().any(char::is_control) { name.chars().flat_map(escaped).collect() } else { name.to_owned() }
}

fn escaped(c: char) -> Vec<char> {
    if c.is_control() { c.escape_default().collect() } else { vec![c] }
}
