//! By which comparisons decisions are taken, as text: `L2oc > r²`.

use super::Relation;
use crate::log::formula::{self, Formula};
use crate::log::{Acceptance, Decision, Miss, SkipReason, Split, Term};
use std::collections::HashMap;
use std::sync::{LazyLock, Mutex, PoisonError};

/// Several groups hold together; of each the first comparison counts whose quantities the log holds, and which holds for them.
pub(super) type Groups = &'static [&'static [&'static str]];

/// Of several reasons the first counts all of whose comparisons hold.
pub(super) type Reasons = &'static [&'static [&'static str]];

/// The point of the line is on the surface.
const MEETS: &[&str] = &[
    "T2_A ≥ 0",
    "Δ ≥ 0",
    "t_in ≤ t_out",
    "min(E) ≥ 0",
    "max(E) ≤ 0",
    "min(E_a, min(E_b, E_c)) ≥ 0",
    "max(E_a, max(E_b, E_c)) ≤ 0",
    "ρ² ≤ r_d·r_d",
    "κ − 2·⌊κ/2⌋ = 1",
];

/// A ray that leaves a sphere begins inside if it sets off toward the centre; the side is that on which the tracer sent it off.
pub(super) const SETS_OFF_INWARD: &str = "T_A > 0";

/// The comparison that decides total reflection where the formulas are those of the source text.
pub(super) const PRINTED_REFLECTION: &str = "1 − (1 − cosφ_1²)/η² < 0";

/// By which comparisons a decision is taken that is no miss.
pub(super) fn groups(decision: &Decision) -> Groups {
    match decision {
        Decision::Outside => &[&["L2oc > r²", "c > 0", "min(min(O − b_min, b_max − O)) < 0"]],
        Decision::Inside => &[&["L2oc ≤ r²", "c ≤ 0", "min(min(O − b_min, b_max − O)) ≥ 0"]],
        Decision::Hit => &[&["T_A > 0"], MEETS, &["t > 0", "t = 0"], &["t < |ℓ|"]],
        Decision::TotalInternalReflection => &[&["η² − |d + cosφ_1·N|² < 0"]],
        Decision::Skipped { what: Term::Shadow, why: SkipReason::Behind } => &[&["N·L < 0", "N·L = 0"]],
        Decision::Skipped { what: Term::Shadow, why: SkipReason::NoLocalTerm } => {
            &[&["max(K_d) = 0"], &["max(K_e) = 0"]]
        }
        Decision::Rejected { what: Term::Transmitted } => &[&["h_z > 0"]],
        Decision::Rejected { .. } => &[&["h_z < 0"]],
        Decision::LeakGuard { .. } => &[&["N_g · L < 0", "N_g · L > 0"]],
        Decision::Bent { what: Term::Transmitted } => &[&["N_g · T > 0"]],
        Decision::Bent { .. } => &[&["N_g · R < 0"]],
        Decision::Undefined { .. } => &[&["|D| = 0"]],
        Decision::Subdivided { why: Split::Color, .. } => &[&["Δ_I > Δ_max"]],
        Decision::Accepted { cell: Some(_), why: Acceptance::Alike } => &[&["Δ_I ≤ Δ_max"]],
        Decision::Accepted { cell: None, why: Acceptance::Alike } => &[&["n_p ≥ n_m"]],
        Decision::Accepted { why: Acceptance::Interval, .. } => &[&["h_max ≤ h_lim"]],
        Decision::Accepted { why: Acceptance::Guided, .. } => &[&["n_g ≤ n_p"]],
        Decision::Accepted { why: Acceptance::Max, .. } => &[&["n_g > n_p"]],
        Decision::MoreSamples { .. } => &[&["h_max > h_lim", "n_p < n_m", "n_g > n_p"]],
        _ => &[],
    }
}

/// Which crossing a ray hits, where all were asked for and none was chosen: it lies on the surface, and between the ends of the ray. A
/// crossing of the wall must be between the ends of the solid; one of the solid may be of a cap.
pub(super) fn hits(is_cone: bool) -> Reasons {
    if is_cone { HITS_CONE } else { HITS }
}

const HITS: Reasons = &[
    &["t_in > 0", "t_in < |ℓ|"],
    &["t_out > 0", "t_out < |ℓ|"],
    &["min(t_1, t_2) ≥ min(t_b, t_a)", "min(t_1, t_2) ≤ max(t_b, t_a)", "min(t_1, t_2) > 0", "min(t_1, t_2) < |ℓ|"],
    &["max(t_1, t_2) ≥ min(t_b, t_a)", "max(t_1, t_2) ≤ max(t_b, t_a)", "max(t_1, t_2) > 0", "max(t_1, t_2) < |ℓ|"],
    &["min(t_1, t_2) ≤ min(t_b, t_a)", "min(t_b, t_a) ≤ max(t_1, t_2)", "min(t_b, t_a) > 0", "min(t_b, t_a) < |ℓ|"],
    &["min(t_1, t_2) ≤ max(t_b, t_a)", "max(t_b, t_a) ≤ max(t_1, t_2)", "max(t_b, t_a) > 0", "max(t_b, t_a) < |ℓ|"],
    // Across the axis, or an ellipsoid; along the axis.
    &["min(t_1, t_2) > 0", "min(t_1, t_2) < |ℓ|"],
    &["max(t_1, t_2) > 0", "max(t_1, t_2) < |ℓ|"],
    &["min(t_b, t_a) > 0", "min(t_b, t_a) < |ℓ|"],
    &["max(t_b, t_a) > 0", "max(t_b, t_a) < |ℓ|"],
];

const HITS_CONE: Reasons = &[
    &[
        "min(t_1, t_2) ≥ min(t_b, t_a)",
        "min(t_1, t_2) ≤ max(t_b, t_a)",
        "t_0 + min(t_1, t_2) > 0",
        "t_0 + min(t_1, t_2) < |ℓ|",
    ],
    &[
        "max(t_1, t_2) ≥ min(t_b, t_a)",
        "max(t_1, t_2) ≤ max(t_b, t_a)",
        "t_0 + max(t_1, t_2) > 0",
        "t_0 + max(t_1, t_2) < |ℓ|",
    ],
    &["a = 0", "t_2 ≥ min(t_b, t_a)", "t_2 ≤ max(t_b, t_a)", "t_0 + t_2 > 0", "t_0 + t_2 < |ℓ|"],
    &["d_w = 0", "t_0 + min(t_1, t_2) > 0", "t_0 + min(t_1, t_2) < |ℓ|"],
    &["d_w = 0", "t_0 + max(t_1, t_2) > 0", "t_0 + max(t_1, t_2) < |ℓ|"],
    &["t_0 + min(t_b, t_a) > 0", "t_0 + min(t_b, t_a) < |ℓ|"],
    &["t_0 + max(t_b, t_a) > 0", "t_0 + max(t_b, t_a) < |ℓ|"],
];

/// Why a surface is missed. A cone's crossings t_1, t_2 and those of its ends t_b, t_a are counted from t_0.
pub(super) fn misses(why: Miss, is_cone: bool) -> Reasons {
    match (why, is_cone) {
        (Miss::Parallel, _) => &[&["V_d = 0"], &["a = 0"]],
        (Miss::FacesAway, false) => FACES_AWAY,
        (Miss::FacesAway, true) => FACES_AWAY_CONE,
        (Miss::Behind, false) => &[
            &["t ≤ 0"],
            &["t_out ≤ 0"],
            &["max(t_1, t_2) ≤ 0"],
            &["T_A < 0"],
            &["max(t_b, t_a) ≤ 0"],
            &["(−b + √Δ)/a ≤ 0"],
            // The ray begins at the other one.
            &["min(t_1, t_2) ≤ 0"],
            &["t_in ≤ 0"],
        ],
        (Miss::Behind, true) => &[
            &["t_0 + max(t_b, t_a) ≤ 0"],
            &["t_0 + max(t_1, t_2) ≤ 0"],
            &["a < 0", "ρ_d ≤ 0", "t_0 + min(t_1, t_2) ≤ 0"],
            &["a = 0", "t_0 + t_2 ≤ 0"],
            &["t_0 + min(t_1, t_2) ≤ 0"],
        ],
        (Miss::Beyond, false) => &[
            &["t ≥ |ℓ|"],
            &["t_in ≥ |ℓ|"],
            &["min(t_1, t_2) ≥ |ℓ|"],
            &["min(t_b, t_a) ≥ |ℓ|"],
            &["(−b − √Δ)/a ≥ |ℓ|"],
            // The ray begins inside, or enters through an open end: where it would come out.
            &["t_out ≥ |ℓ|"],
            &["min(max(t_1, t_2), max(t_b, t_a)) ≥ |ℓ|"],
            &["max(t_1, t_2) ≥ |ℓ|"],
            &["min((−b + √Δ)/a, max(t_b, t_a)) ≥ |ℓ|"],
            &["(−b + √Δ)/a ≥ |ℓ|"],
            &["max(t_b, t_a) ≥ |ℓ|"],
        ],
        (Miss::Beyond, true) => &[
            &["t_0 + min(t_b, t_a) ≥ |ℓ|"],
            &["t_0 + min(t_1, t_2) ≥ |ℓ|"],
            &["a < 0", "ρ_d > 0", "t_0 + max(t_1, t_2) ≥ |ℓ|"],
            &["a = 0", "t_0 + t_2 ≥ |ℓ|"],
            &["a < 0", "t_0 + max(t_b, t_a) ≥ |ℓ|"],
            &["t_0 + min(max(t_1, t_2), max(t_b, t_a)) ≥ |ℓ|"],
            &["t_0 + max(t_1, t_2) ≥ |ℓ|"],
            &["t_0 + max(t_b, t_a) ≥ |ℓ|"],
        ],
        (Miss::Beside, false) => BESIDE,
        (Miss::Beside, true) => BESIDE_CONE,
        (Miss::BeginsThere, _) => &[],
    }
}

/// The ray comes to the side that isn't there for it. Of a sphere the log has the crossing that doesn't show itself: it comes out of the
/// ball behind the middle of the chord, and into one that is turned inward before it.
const FACES_AWAY: Reasons = &[
    &["V_d > 0"],
    &["t > T_A"],
    &["t < T_A"],
    &["L2oc ≤ r²"],
    &["T_A > 0"],
    &["t_in ≤ 0", "t_out > 0"],
    &["t_out > 0"],
    &["max(min(t_1, t_2), min(t_b, t_a)) ≤ 0", "min(max(t_1, t_2), max(t_b, t_a)) > 0"],
    &["min(t_1, t_2) ≤ 0", "max(t_1, t_2) > 0"],
    // Through an open end; turned inward, out of one, or to what lies beyond the light.
    &["min(t_1, t_2) < min(t_b, t_a)", "max(t_1, t_2) > 0"],
    &["min(t_1, t_2) > 0", "max(t_1, t_2) > max(t_b, t_a)"],
    &["max(min(t_1, t_2), min(t_b, t_a)) > 0", "min(max(t_1, t_2), max(t_b, t_a)) ≥ |ℓ|"],
    &["max(t_1, t_2) > 0"],
    // No crossings are noted where they have twice the digits, or the ray runs along the axis.
    &["(−b − √Δ)/a ≤ 0", "(−b + √Δ)/a > 0"],
    &["(−b + √Δ)/a > 0"],
    &["min(t_b, t_a) ≤ 0", "max(t_b, t_a) > 0"],
    &["max(t_b, t_a) > 0"],
];

/// The same of a cone, whose crossings count as those of [`BESIDE_CONE`].
const FACES_AWAY_CONE: Reasons = &[
    &["a > 0", "t_0 + max(min(t_1, t_2), min(t_b, t_a)) ≤ 0", "t_0 + min(max(t_1, t_2), max(t_b, t_a)) > 0"],
    &["a < 0", "ρ_d > 0", "t_0 + max(max(t_1, t_2), min(t_b, t_a)) ≤ 0", "t_0 + max(t_b, t_a) > 0"],
    &["a < 0", "ρ_d ≤ 0", "t_0 + min(t_b, t_a) ≤ 0", "t_0 + min(min(t_1, t_2), max(t_b, t_a)) > 0"],
    &["a = 0", "b < 0", "t_0 + max(t_2, min(t_b, t_a)) ≤ 0", "t_0 + max(t_b, t_a) > 0"],
    &["a = 0", "t_0 + min(t_b, t_a) ≤ 0", "t_0 + min(t_2, max(t_b, t_a)) > 0"],
    &["d_w = 0", "t_0 + min(t_1, t_2) ≤ 0", "t_0 + max(t_1, t_2) > 0"],
    // Through an open end, or turned inward.
    &["a < 0", "ρ_d ≤ 0", "t_0 + min(t_1, t_2) > 0"],
    &["a < 0", "ρ_d > 0", "t_0 + max(t_1, t_2) > 0"],
    &["a = 0", "t_0 + t_2 > 0"],
    &["t_0 + max(t_1, t_2) > 0"],
    &["t_0 + max(t_b, t_a) > 0"],
];

/// The line doesn't meet the surface where the ray is.
const BESIDE: Reasons = &[
    &["T2_A < 0"],
    &["T2_A = 0"],
    &["Δ < 0"],
    &["t_in > t_out"],
    &["min(E) < 0", "max(E) > 0"],
    &["min(E_a, min(E_b, E_c)) < 0", "max(E_a, max(E_b, E_c)) > 0"],
    &["ρ² > r_d·r_d"],
    &["κ − 2·⌊κ/2⌋ = 0"],
    // A cylinder's crossings, or the open cylinder's one that the ray comes to, are off its length.
    &["d_w = 0", "o_w < 0"],
    &["d_w = 0", "o_w > l_w"],
    &["min(t_1, t_2) > max(t_b, t_a)"],
    &["max(t_1, t_2) < min(t_b, t_a)"],
    &["min(t_1, t_2) < min(t_b, t_a)", "max(t_1, t_2) > max(t_b, t_a)"],
    &["min(t_1, t_2) ≤ 0", "max(t_1, t_2) > max(t_b, t_a)"],
    // The ray begins at the other one.
    &["max(t_1, t_2) > max(t_b, t_a)"],
    &["min(t_1, t_2) < min(t_b, t_a)"],
    // No crossings are noted where they have twice the digits.
    &["(−b − √Δ)/a > max(t_b, t_a)"],
    &["(−b + √Δ)/a < min(t_b, t_a)"],
    &["(−b − √Δ)/a < min(t_b, t_a)", "(−b + √Δ)/a > max(t_b, t_a)"],
];

/// The same of a cone. If a > 0, both crossings are on one half of the double cone. If a < 0, there is one on each half, and the later one
/// counts where the radius grows along the ray.
const BESIDE_CONE: Reasons = &[
    &["Δ < 0"],
    &["d_w = 0", "o_w < 0"],
    &["d_w = 0", "o_w > l_w"],
    &["min(t_1, t_2) > max(t_b, t_a)"],
    &["max(t_1, t_2) < min(t_b, t_a)"],
    &["a < 0", "ρ_d > 0", "max(t_1, t_2) > max(t_b, t_a)"],
    &["a < 0", "ρ_d ≤ 0", "min(t_1, t_2) < min(t_b, t_a)"],
    &["a < 0", "ρ_d > 0", "t_0 + max(t_1, t_2) ≤ 0"],
    // The ray begins at the one that counts.
    &["a < 0"],
    &["min(t_1, t_2) < min(t_b, t_a)", "max(t_1, t_2) > max(t_b, t_a)"],
    &["t_0 + min(t_1, t_2) ≤ 0", "max(t_1, t_2) > max(t_b, t_a)"],
    // Where the crossings are on the half that doesn't count.
    &["ρ_o + ρ_d·(t_1 + t_2)/2 < 0"],
    // Parallel to a line of the cone, or to the axis.
    &["a = 0", "b < 0", "ρ_d < 0"],
    &["a = 0", "b ≥ 0", "ρ_d > 0"],
    &["a = 0", "t_2 > max(t_b, t_a)"],
    &["a = 0", "t_2 < min(t_b, t_a)"],
    &["a = 0", "t_0 + t_2 ≤ 0"],
    &["a = 0", "b = 0", "c > 0"],
    // The ray begins at the other crossing.
    &["max(t_1, t_2) > max(t_b, t_a)"],
    &["min(t_1, t_2) < min(t_b, t_a)"],
];

/// Two sides, and how they are compared.
pub(super) type Parsed = (Formula, Relation, Formula);

/// A comparison of the table, which is parsed once.
pub(super) fn parsed(text: &'static str) -> Option<&'static Parsed> {
    type Known = HashMap<&'static str, Option<&'static Parsed>>;
    static KNOWN: LazyLock<Mutex<Known>> = LazyLock::new(Mutex::default);
    let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    *known.entry(text).or_insert_with(|| parse(text).map(|parsed| &*Box::leak(Box::new(parsed))))
}

fn parse(text: &str) -> Option<Parsed> {
    let (relation, sign) = Relation::SIGNS.iter().find(|(_, sign)| text.contains(sign))?;
    let (left, right) = text.split_once(sign)?;
    Some((formula::parse(left).ok()?, *relation, formula::parse(right).ok()?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::log::Name;

    /// Every text of the table.
    fn texts() -> impl Iterator<Item = &'static str> {
        use Term::{Reflected, Shadow, Transmitted};
        let others = [
            Decision::Outside,
            Decision::Inside,
            Decision::Hit,
            Decision::TotalInternalReflection,
            Decision::Skipped { what: Shadow, why: SkipReason::Behind },
            Decision::Skipped { what: Shadow, why: SkipReason::NoLocalTerm },
            Decision::Rejected { what: Transmitted },
            Decision::Rejected { what: Reflected },
            Decision::LeakGuard { what: Shadow },
            Decision::Bent { what: Transmitted },
            Decision::Bent { what: Reflected },
            Decision::Undefined { quantity: Name::RayDirection },
            Decision::Subdivided { cell: [0.0; 3], why: Split::Color, object: None },
            Decision::Accepted { cell: Some([0.0; 3]), why: Acceptance::Alike },
            Decision::Accepted { cell: None, why: Acceptance::Alike },
            Decision::Accepted { cell: None, why: Acceptance::Interval },
            Decision::Accepted { cell: None, why: Acceptance::Guided },
            Decision::MoreSamples { from: 0, to: 0 },
        ];
        let of_groups = others.into_iter().flat_map(|decision| groups(&decision).iter().copied());
        let of_misses = Miss::ALL.iter().flat_map(|why| [false, true].map(|is_cone| misses(*why, is_cone)));
        let of_misses = of_misses.flat_map(|reasons| reasons.iter().copied());
        let of_hits = [false, true].into_iter().flat_map(|is_cone| hits(is_cone).iter().copied());
        of_groups.chain(of_misses).chain(of_hits).flatten().copied().chain([SETS_OFF_INWARD, PRINTED_REFLECTION])
    }

    #[test]
    fn every_comparison_of_the_table_parses() {
        assert!(texts().count() > 40);
        for text in texts() {
            assert!(parsed(text).is_some(), "{text}");
        }
    }
}
