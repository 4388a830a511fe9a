//! `raywalk trace --causes`: which rounding caused the error of a result.

use super::failure::Failure;
use raywalk::probe::CutOff;
use raywalk::record::{Arithmetic, Part};
use raywalk::scene::Scene;
use raywalk::study::rounding::{self, MAX_CAUSES, Rounding, Study};

/// The rounding of an arithmetic that rounds.
pub fn rounding(arithmetic: Arithmetic) -> Result<Rounding, Failure> {
    Rounding::of(arithmetic).ok_or_else(|| {
        let found = if arithmetic.rounds_products() { "--round-products".to_owned() } else { arithmetic.to_string() };
        Failure::caller(format!(
            "--causes: expected --arithmetic decimal:N or f32, whose roundings of named quantities it studies, found {found}"
        ))
    })
}

/// The study of a pixel or ray.
pub fn study_of(scene: &Scene, part: Part, rounding: Rounding) -> Result<Study, Failure> {
    rounding::study(scene, part, rounding).map_err(|cut_off| match cut_off {
        CutOff::TooLong { .. } => Failure::caller(format!(
            "--causes: at most {MAX_CAUSES} quantities can be studied, the computation has more; expected a smaller --max-depth"
        )),
        CutOff::Memory | CutOff::Io(_) => Failure::machine(cut_off.to_string()),
    })
}
