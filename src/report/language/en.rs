//! English.

mod close_up;
mod viewer;

use super::{Causes, Figure, Solution, Texts};
use crate::log::{Acceptance, Asking, Miss, SkipReason, Skippable, Split};

pub(super) const TEXTS: Texts = Texts {
    decimal_mark: '.',
    separator: ", ",
    pixel: |[x, y]| format!("pixel {x},{y}"),
    region: |[x0, y0, x1, y1]| format!("region {x0},{y0} to {x1},{y1}"),
    ray_along: |origin, direction| format!("ray from {origin} along {direction}"),
    sampling_word: |word| word,
    depth: "depth",
    given: "given",
    result: "result",
    frame: |number| format!("frame {number}"),
    sample: |number| format!("sample {number}"),
    ray: |path, kind| format!("ray {path}, {kind}"),
    test: |object| format!("test {object}"),
    test_triangle: |object, triangle| format!("test {object}, triangle {triangle}"),
    local_model: |object| format!("local model on {object}"),
    light: |light| format!("light {light}"),
    light_point: |light, number| format!("light {light}, point {number}"),
    motion: |object| format!("{object} where it is at this time"),
    zone: |what, number| match what {
        Skippable::Transmitted => format!("zone {number} of the transmission"),
        _ => format!("zone {number} of the reflection"),
    },
    weighted_sum: "weighted sum",
    from_the_eye: "from the eye",
    shadow_ray_to: |light| format!("shadow ray to {light}"),
    reflected: "reflected",
    transmitted: "transmitted",
    hit: "hit",
    miss: |why| format!("miss: {}", miss(why)),
    outside: "the ray begins outside",
    inside: "the ray begins inside",
    nearest: |object| format!("nearest: {object}"),
    coincident: |object, triangle| match triangle {
        None => format!("{object} is in the same place and counts as just behind"),
        Some(triangle) => format!("triangle {triangle} of {object} is in the same place and counts as just behind"),
    },
    immersed: |object| format!("the ray begins inside {object}"),
    background: "nothing is hit: background",
    free: "nothing stands in the way",
    twice_the_digits: "with twice the digits",
    blocked_by: |object| format!("blocked by {object}"),
    passes: |object, factor| format!("passes {object}, which keeps {factor}"),
    too_fine: |symbol| format!("{symbol} has no value: the pattern is finer than numbers are here"),
    undefined: |symbol| format!("{symbol} has no value in this arithmetic: it would be divided by zero"),
    total_reflection: "total internal reflection",
    depth_limit: |what| format!("depth limit: no {}", skippable(what)),
    rest_skipped: "the rest is skipped",
    leak_guard: |what| format!("no leak: the {} lies beyond the surface and brings nothing", skippable(what)),
    bent: |what| format!("the {} would run below the surface and is bent up", skippable(what)),
    rejected: |what| format!("rejected: the {} would run on the wrong side", skippable(what)),
    skipped: |what, why| format!("skipped: {} ({})", skippable(what), skip_reason(why)),
    lost: |bound| format!("at most {bound} of the sample was lost"),
    whole_pixel: "the pixel",
    cell: |x, y, side| format!("the cell at ({x}, {y}) with side {side}"),
    subdivided: |cell, why, object| match why {
        Split::Color => format!("{cell} is subdivided: the colours at its corners differ by more than the threshold"),
        Split::Objects => format!("{cell} is subdivided: its corners see different objects"),
        Split::SmallObject => format!("{cell} is subdivided: {object} may lie in it, and no corner sees that"),
    },
    an_object: "an object",
    mean: "the mean",
    accepted: |what, why| format!("{what} is accepted: {}", acceptance(why)),
    asked: |light, why, points, object| match why {
        Asking::Rule => {
            format!("{light} is in full view: a rule of {points} points gives its mean, without shadow rays")
        }
        Asking::InView => format!("{light} is in full view: {points} points of it need no shadow rays"),
        Asking::Hidden => format!("{light} is hidden as a whole by {object}"),
        Asking::All => {
            format!("{light} may be hidden or behind the surface in part: all its {points} points are asked")
        }
    },
    more_samples: |from, to| {
        format!("{from} samples are too few, the interval of their mean is too wide: {to} are taken")
    },
    more_asked: |from, to| {
        format!("{from} samples are too few for what the first samples of the pixels around it saw: {to} are taken")
    },
    digits: |counts, is_one| format!("{counts} {}", if is_one { "digit" } else { "digits" }),
    decision_differs: "the decision differs between runs",
    no_digits: "0 digits: a decision differs between runs",
    light_on: |light, object| format!("{light} on {object}"),
    ambient_on: |object| format!("ambient on {object}"),
    from_background: "background",
    from_rounding: "rounding of the values",
    unexplained: "not explained by this log",
    light_behind: |light| format!("{light} stands behind the surface"),
    light_blocked: |light, object| format!("{light} is blocked by {object}"),
    log_ends: "the log ends before this ray does",
    nothing: "nothing",
    solution: Solution {
        title: |subject, scene| format!("Worked solution: {subject} of {scene}"),
        conditions: |arithmetic, algorithm, depth| {
            format!("Arithmetic {arithmetic}, algorithm {algorithm}, greatest depth {depth}.")
        },
        sampled: |method| format!("Samples: {method}."),
        data: "Data",
        everywhere: "Everywhere",
        object: |object| format!("Object {object}"),
        source: |light| format!("Light {light}"),
        steps: "Steps",
        with: "With",
        aim: "Direction of the ray",
        intersection: |object| format!("Intersection with {object}"),
        intersection_triangle: |object, triangle| format!("Intersection with triangle {triangle} of {object}"),
        intersection_moving: |object| format!("Intersection with {object}, which moves"),
        point: "Nearest intersection: its point and the normal there",
        local: |object| format!("Local intensity on {object}"),
        reflection: "Direction of the reflected ray",
        transmission: "Direction of the transmitted ray",
        blur: "Mean of the blurred bounce",
        combine: |path| format!("Intensity that ray {path} brings"),
        sampling: "Samples of the pixel",
        back: |title| format!("Back at {title}"),
        result: "Result",
        conclusion: |color| format!("The intensity that reaches the eye is {color}."),
        no_result: "The log ends before the intensity is known.",
        contributions: "Contributions",
        columns: ["path", "light", "class", "brings", "weight", "adds", "share"],
        sum: "sum",
        smaller: |count| format!("{count} smaller ones together"),
        brings_nothing: "What brings nothing",
        more: |count| format!("and {count} more"),
        section: |section| format!("section {section} of the source text"),
        open_all: "Open all",
        close_all: "Close all",
    },
    causes: Causes {
        rounded: "rounded",
        exact: "in f64",
        off: "off by",
        expected: "to expect",
        of_runs: |runs| format!("from {runs} runs that round up or down at random"),
        other_tree: "Rounding changes the ray tree: what is computed only there isn't listed here.",
        columns: ["only it rounded", "all but it", "quantity", "where"],
        idle: |quantities| match quantities {
            1 => "1 further quantity changes nothing when only it is rounded.".to_owned(),
            _ => format!("{quantities} further quantities change nothing when only they are rounded."),
        },
        star: "*  The ray tree is another than in f64.",
    },
    figure: Figure {
        ray_tree: "Ray tree",
        call_tree: "Call tree",
        schematic: "Schematic of the rays",
        plane: |right, up| format!("{right} to the right, {up} upward"),
        eye: "eye",
        background: "background",
        blocked: |object| format!("blocked by {object}"),
        too_many: |rays| {
            format!("The tree has {rays} rays, too many for this page: `raywalk trace --format svg` draws it.")
        },
        first_sample: |samples| format!("The figure shows the first of {samples} samples."),
        width: "the wider a line, the more of the pixel's intensity comes along it",
        kinds: ["C: from the eye", "R: reflected", "T: transmitted", "S: to a light", "S: blocked"],
        adds: |share, color| format!("{share} of the intensity, {color}"),
        no_rays: "The log has no rays that can be drawn.",
    },
    close_up: close_up::CLOSE_UP,
    viewer: viewer::VIEWER,
};

fn miss(why: Miss) -> &'static str {
    match why {
        Miss::Parallel => "the ray runs parallel to it",
        Miss::Behind => "it lies behind the ray",
        Miss::Beside => "the ray passes beside it",
        Miss::Beyond => "it lies beyond the light",
        Miss::FacesAway => "it turns its back to the ray",
        Miss::BeginsThere => "the ray begins on it",
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
        SkipReason::ZeroLight => "the light's colour and the coefficients leave nothing of any channel",
        SkipReason::ZeroPathLocal => "its weight and those on its path leave nothing of any channel",
        SkipReason::ZeroPathLight => {
            "the weights on its path, the light's colour and the coefficients leave nothing of any channel"
        }
    }
}

fn acceptance(why: Acceptance) -> &'static str {
    match why {
        Acceptance::Alike => "the samples agree",
        Acceptance::Depth => "it may not be cut further",
        Acceptance::Interval => "its interval is narrow enough",
        Acceptance::Max => "there may be no more samples",
        Acceptance::Guided => "its samples are as many as the first samples of the pixels around it ask for",
    }
}
