//! The checks of `tracing`, `sampling`, `frames` and `output`.

use crate::scene::file::schema::{Frames, Guided, Output, Sampling, Statistical, Tracing};

use super::checker::Checker;
use super::limits::{
    MAX_ADAPTIVE_DEPTH, MAX_DEPTH, MAX_EXPOSURE, MAX_FRAMES, MAX_GRID, MAX_SAMPLES, MIN_GUIDED, MIN_STATISTICAL,
};

/// Checks how rays are traced.
pub fn tracing(mut check: Checker<'_>, tracing: &Tracing) {
    check.count("max_depth", tracing.max_depth, 0, MAX_DEPTH);
    check.not_negative("cutoff", tracing.cutoff);
}

/// Checks which rays make a pixel.
pub fn sampling(check: &mut Checker<'_>, sampling: &Sampling) {
    match *sampling {
        Sampling::Center {} => {}
        Sampling::Regular { n } => check.at("regular").count("n", n, 1, MAX_GRID),
        Sampling::Shared { n } => check.at("shared").count("n", n, 1, MAX_GRID),
        Sampling::Adaptive { threshold, depth } => {
            let mut check = check.at("adaptive");
            check.not_negative("threshold", threshold);
            check.count("depth", depth, 0, MAX_ADAPTIVE_DEPTH);
        }
        Sampling::Stochastic { n } => check.at("stochastic").count("n", n, 1, MAX_SAMPLES),
        Sampling::Random { n } => check.at("random").count("n", n, 1, MAX_SAMPLES),
        Sampling::Sobol { n } => check.at("sobol").count("n", n, 1, MAX_SAMPLES),
        Sampling::Statistical(Statistical { confidence, tolerance, min, max }) => {
            let mut check = check.at("statistical");
            check.between("confidence", confidence, 0.0, 1.0);
            fewest_and_most(check, tolerance, [min, max], MIN_STATISTICAL);
        }
        Sampling::Guided(Guided { tolerance, min, max }) => {
            fewest_and_most(check.at("guided"), tolerance, [min, max], MIN_GUIDED);
        }
    }
}

/// Checks a tolerance, and the fewest and the most samples, of which this many are required.
fn fewest_and_most(mut check: Checker<'_>, tolerance: f64, [min, max]: [u32; 2], least: u32) {
    check.positive("tolerance", tolerance);
    check.count("min", min, 1, MAX_SAMPLES);
    check.count("max", max, least, MAX_SAMPLES);
    if max < min {
        check.at("max").error(format!("must be `min`, {min}, or more, found {max}"));
    }
}

/// Checks an animation.
pub fn frames(mut check: Checker<'_>, frames: &Frames) {
    check.count("count", frames.count, 1, MAX_FRAMES);
    check.not_negative("duration", frames.duration);
}

/// Checks how values become the numbers of a picture.
pub fn output(mut check: Checker<'_>, output: &Output) {
    check.positive("white", output.white);
    check.within("exposure", output.exposure, MAX_EXPOSURE);
}
