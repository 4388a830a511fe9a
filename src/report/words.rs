//! The words for nodes and decisions.

use super::Style;
use super::contributions::{Ended, Origin, Why};
use super::language::Language;
use crate::log::{
    Asking, Decision, Header, Input, Log, Name, Parameter, RayKind, SkipReason, Split, Step, Subject, Term, Tree, Value,
};

/// What a node is, such as `ray C R, reflected` or `test sphere`.
pub fn title(language: Language, log: &Log, tree: &Tree, node: usize) -> String {
    let (header, texts) = (&log.header, language.texts());
    let object = |object| plain(header.object(object));
    match tree.nodes()[node].step {
        None => subject(language, header),
        Some(Step::Pixel(pixel)) => (texts.pixel)(pixel),
        Some(Step::Sample { number }) => (texts.sample)(number),
        Some(Step::Ray { kind, .. }) => (texts.ray)(&tree.shown_path(node), &ray_kind(language, header, kind)),
        Some(Step::Test { object: tested, triangle: None }) => (texts.test)(&object(tested)),
        Some(Step::Test { object: tested, triangle: Some(triangle) }) => {
            (texts.test_triangle)(&object(tested), triangle)
        }
        Some(Step::Shade { object: shaded }) => (texts.local_model)(&object(shaded)),
        Some(Step::Light { light, split: 0 }) => (texts.light)(&plain(header.light(light))),
        Some(Step::Light { light, split }) => (texts.light_point)(&plain(header.light(light)), split),
        Some(Step::Motion { object: moving }) => (texts.motion)(&object(moving)),
        Some(Step::Zone { what: Term::Transmitted, number }) => (texts.zone_of_transmission)(number),
        Some(Step::Zone { number, .. }) => (texts.zone_of_reflection)(number),
        Some(Step::Combine) => texts.weighted_sum.to_owned(),
    }
}

/// What a log is about, such as `pixel 160,120`.
pub fn subject(language: Language, header: &Header) -> String {
    let texts = language.texts();
    match header.subject {
        Subject::Pixel(pixel) => (texts.pixel)(pixel),
        Subject::Region(region) => (texts.region)(region),
        Subject::Ray([ox, oy, oz, dx, dy, dz]) => {
            let triple = |xyz| language.value(&Value::Triple(xyz), Style::default());
            (texts.ray_along)(&triple([ox, oy, oz]), &triple([dx, dy, dz]))
        }
    }
}

/// How pixels were sampled, such as `shared: n = 1`; nothing for one ray through the centre.
pub fn sampling(language: Language, header: &Header) -> Option<String> {
    let texts = language.texts();
    let (method, parameters) = header.sampling.iter().find(|(method, _)| *method != "none")?;
    let parameter = |(name, value): (&String, &Parameter)| {
        format!("{} = {}", (texts.sampling_word)(name), language.parameter(*value))
    };
    let parameters: Vec<_> = parameters.iter().map(parameter).collect();
    Some(format!("{}: {}", plain((texts.sampling_word)(method)), plain(&parameters.join(texts.separator))))
}

/// Which frame of an animation a log is about, such as `frame 7`; nothing where there is one only.
pub fn frame(language: Language, header: &Header) -> Option<String> {
    header.frame.map(|frame| (language.texts().frame)(frame.number))
}

/// The subject with its frame before it, where there are several.
pub fn subject_in_frame(language: Language, header: &Header) -> String {
    frame(language, header).into_iter().chain([subject(language, header)]).collect::<Vec<_>>().join(", ")
}

/// What a ray is for.
pub fn ray_kind(language: Language, header: &Header, kind: RayKind) -> String {
    let texts = language.texts();
    match kind {
        RayKind::Camera => texts.from_the_eye.to_owned(),
        RayKind::Shadow { light } => (texts.shadow_ray_to)(&plain(header.light(light))),
        RayKind::Reflected => texts.reflected.to_owned(),
        RayKind::Transmitted => texts.transmitted.to_owned(),
    }
}

/// A decision as a sentence.
pub fn decision(language: Language, header: &Header, decision: &Decision, style: Style) -> String {
    let texts = language.texts();
    let object = |object: &u32| plain(header.object(*object));
    let an_object = |known: &Option<u32>| known.as_ref().map_or_else(|| texts.an_object.to_owned(), object);
    let light = |light: &u32| plain(header.light(*light));
    let cell = |cell: &[f64; 3]| self::cell(language, cell, style);
    match decision {
        Decision::Hit => texts.hit.to_owned(),
        Decision::Miss { why } => (texts.miss)(language.miss(*why)),
        Decision::Outside => texts.outside.to_owned(),
        Decision::Inside => texts.inside.to_owned(),
        Decision::Nearest { object: nearest } => (texts.nearest)(&object(nearest)),
        Decision::Coincident { object: other, triangle: None } => (texts.coincident)(&object(other)),
        Decision::Coincident { object: other, triangle: Some(triangle) } => {
            (texts.coincident)(&(texts.triangle_of)(*triangle, &object(other)))
        }
        Decision::Immersed { object: medium } => (texts.immersed)(&object(medium)),
        Decision::Bent { what } => (texts.bent)(language.term(*what)),
        Decision::Background => texts.background.to_owned(),
        Decision::Free => texts.free.to_owned(),
        Decision::Occluded { object: blocking } => (texts.blocked_by)(&object(blocking)),
        Decision::Attenuated { object: passed, factor } => {
            (texts.passes)(&object(passed), &language.value(&Value::Triple(*factor), style))
        }
        Decision::Undefined { quantity: Name::PatternCell } => (texts.too_fine)(Name::PatternCell.symbol()),
        Decision::Undefined { quantity } => (texts.undefined)(quantity.symbol()),
        Decision::TotalInternalReflection => texts.total_reflection.to_owned(),
        Decision::DepthLimit { what } => (texts.depth_limit)(language.term(*what)),
        Decision::Skipped { why: SkipReason::Blocked, .. } => texts.rest_skipped.to_owned(),
        Decision::LeakGuard { what } => (texts.leak_guard)(language.term(*what)),
        Decision::Rejected { what } => (texts.rejected)(language.term(*what)),
        Decision::Skipped { what, why } => (texts.skipped)(language.term(*what), language.skip_reason(*why)),
        Decision::Subdivided { cell: cut, why: Split::Color, .. } => (texts.subdivided_by_color)(&cell(cut)),
        Decision::Subdivided { cell: cut, why: Split::Objects, .. } => (texts.subdivided_by_objects)(&cell(cut)),
        Decision::Subdivided { cell: cut, why: Split::SmallObject, object: small } => {
            (texts.subdivided_by_one)(&cell(cut), &an_object(small))
        }
        Decision::Accepted { cell: kept, why } => {
            let what = kept.as_ref().map_or(texts.mean.to_owned(), cell);
            (texts.accepted)(&what, language.acceptance(*why))
        }
        Decision::Asked { light: asked, why, points, object: hiding } => match why {
            Asking::Rule => (texts.asked_by_rule)(&light(asked), *points),
            Asking::InView => (texts.asked_in_view)(&light(asked), *points),
            Asking::Hidden => (texts.hidden)(&light(asked), &an_object(hiding)),
            Asking::All => (texts.all_asked)(&light(asked), *points),
        },
        Decision::MoreSamples { from, to } if header.sampling.contains_key("guided") => (texts.more_asked)(*from, *to),
        Decision::MoreSamples { from, to } => (texts.more_samples)(*from, *to),
    }
}

/// What follows a decision with these inputs where it cost anything: `; at most (0.1, 0, 0) of the sample was lost`.
pub fn lost(language: Language, given: &[Input], style: Style) -> String {
    let bound = given.iter().find(|(name, _)| *name == Name::CutoffLoss);
    bound.map_or(String::new(), |(_, bound)| format!("; {}", (language.texts().lost)(&language.value(bound, style))))
}

/// Where the light of a path comes from.
pub fn origin(language: Language, header: &Header, origin: Origin) -> String {
    let texts = language.texts();
    match origin {
        Origin::Light { light, object } => (texts.light_on)(&plain(header.light(light)), &plain(header.object(object))),
        Origin::Ambient { object } => (texts.ambient_on)(&plain(header.object(object))),
        Origin::Background => texts.from_background.to_owned(),
        Origin::Rounding => texts.from_rounding.to_owned(),
        Origin::Unexplained => texts.unexplained.to_owned(),
    }
}

/// Why a path brings nothing.
pub fn ended(language: Language, log: &Log, ended: &Ended, style: Style) -> String {
    let (header, texts) = (&log.header, language.texts());
    let light = |light: u32| plain(header.light(light));
    match (ended.why, log.events[ended.event].decision()) {
        (Why::LightBehind { light: number }, _) => (texts.light_behind)(&light(number)),
        (Why::LogEnds, _) => texts.log_ends.to_owned(),
        (Why::Blocked { light: number }, Some(Decision::Occluded { object })) => {
            (texts.light_blocked)(&light(number), &plain(header.object(object)))
        }
        (_, Some(decision)) => {
            let lost = lost(language, log.given(ended.event), style);
            format!("{}{lost}", self::decision(language, header, &decision, style))
        }
        (_, None) => texts.nothing.to_owned(),
    }
}

fn cell(language: Language, [x, y, side]: &[f64; 3], style: Style) -> String {
    let number = |x: f64| language.number(x, style);
    if *side == 1.0 {
        return language.texts().whole_pixel.to_owned();
    }
    (language.texts().cell)(&number(*x), &number(*y), &number(*side))
}

/// The arithmetic of a log, and the option that goes with it.
pub fn arithmetic(header: &Header) -> String {
    let option = if header.tracing.round_products { " (--round-products)" } else { "" };
    format!("{}{option}", plain(&header.arithmetic))
}

/// A name from a file with its control characters escaped, so that it can't command a terminal.
pub fn plain(name: &str) -> String {
    if name.chars().any(char::is_control) { name.chars().flat_map(escaped).collect() } else { name.to_owned() }
}

fn escaped(c: char) -> Vec<char> {
    if c.is_control() { c.escape_default().collect() } else { vec![c] }
}
