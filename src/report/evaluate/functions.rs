//! The functions of formulas, as the text of [`formula`](crate::log::formula) says what they are.

use crate::log::formula::Function;

/// A function of a number.
pub(super) fn of(function: Function, x: f64) -> f64 {
    match function {
        Function::Cos => libm::cos(x),
        Function::Sin => libm::sin(x),
        Function::Tan => libm::tan(x),
        Function::Exp => libm::exp(x),
        Function::ExpM1 => libm::expm1(x),
        Function::Ln => libm::log(x),
        Function::Ln1p => libm::log1p(x),
        Function::Asin => libm::asin(x),
        Function::Acos => libm::acos(x),
        Function::Atan => libm::atan(x),
        Function::Deg => x.to_degrees(),
        Function::Ceil => libm::ceil(x),
    }
}

/// A function of an angle in degrees. Cosine and sine leave out whole turns, and take quarters of one from their signs.
pub(super) fn of_degrees(function: Function, degrees: f64) -> f64 {
    let within = libm::fmod(degrees, 360.0);
    let quarters = libm::round(within / 90.0);
    let rest = (within - quarters * 90.0).to_radians();
    let quarter = quarters.rem_euclid(4.0);
    let [cos, sin] = [libm::cos(rest), libm::sin(rest)];
    match function {
        Function::Cos if quarter == 0.0 => cos,
        Function::Cos if quarter == 1.0 => -sin,
        Function::Cos if quarter == 2.0 => -cos,
        Function::Cos => sin,
        Function::Sin if quarter == 0.0 => sin,
        Function::Sin if quarter == 1.0 => cos,
        Function::Sin if quarter == 2.0 => -sin,
        Function::Sin => -cos,
        other => of(other, degrees.to_radians()),
    }
}
