//! The zones of a blurred bounce with their directions, seen along the lobe's axis (Ramos, figure 22).
//!
//! The distance from the middle is the root of the lobe's part that lies nearer to the axis, so that equal areas of the figure are equally
//! likely: the part outside of the angle θ is cosⁿ⁺¹θ (`random::warp::lobe`).

use super::hit::number;
use super::sheet::{Ink, Piece, Point, Sheet};
use super::{CloseUp, CloseUpError, Subject};
use crate::log::{Decision, Log, Name, Step, Term, Tree};
use std::f64::consts::TAU;

/// The size of the sheet, the middle and the radius of the whole lobe.
const SIZE: [f64; 2] = [420.0, 420.0];
const MIDDLE: Point = [210.0, 210.0];
const RADIUS: f64 = 180.0;

/// A zone of the log.
struct Zone {
    number: u32,
    /// The square of the radius at its inner and outer side, in parts of the whole.
    rings: [f64; 2],
    /// Where it begins and ends around the axis, in turns.
    sectors: [f64; 2],
    /// Its direction by the two axes across the lobe and the lobe's own.
    direction: [f64; 3],
    is_rejected: bool,
}

/// The zones of the blurred bounce of a ray's hit: of the reflected one if both are blurred.
///
/// # Errors
/// No ray with the path, or no blurred bounce.
pub fn zones(subject: &Subject) -> Result<CloseUp, CloseUpError> {
    let Subject { log, tree, language, style, .. } = *subject;
    let texts = &language.texts().close_up;
    let expected = "a blurred bounce (a material with `gloss_exponent` or `translucency_exponent`)";
    let (ray, (what, exponent, zones)) = subject.first(expected, |ray| of_ray(log, tree, ray))?;
    let mut pieces = Vec::new();
    for zone in &zones {
        pieces.push(Piece::Path { points: outline(zone), ink: Ink::Gray, is_area: true });
    }
    for part in rings(&zones) {
        let angle = libm::acos(libm::pow(1.0 - part, 1.0 / (exponent + 1.0))).to_degrees();
        let text = format!("{}°", language.marked(format!("{angle:.1}")));
        pieces.push(Piece::Text { at: place(part, 0.0).map(|x| x - 1.0), text, ink: Ink::Black });
    }
    let mut rows = Vec::new();
    for zone in &zones {
        let [x, y, z] = zone.direction;
        let at = place(part_within(zone.direction, exponent), libm::atan2(y, x) / TAU);
        let ink = match what {
            _ if zone.is_rejected => Ink::Blocked,
            Term::Transmitted => Ink::Transmitted,
            _ => Ink::Reflected,
        };
        pieces.push(Piece::Dot { at, radius: 3.5, ink, filled: !zone.is_rejected });
        pieces.push(Piece::Text { at: [at[0], at[1] - 11.0], text: zone.number.to_string(), ink });
        let from_axis = libm::atan2(libm::hypot(x, y), z).to_degrees();
        let fate = if zone.is_rejected { texts.rejected } else { texts.kept };
        let mut row = vec![zone.number.to_string()];
        row.extend([x, y, z].map(|x| language.number(x, style)));
        row.extend([format!("{}°", language.marked(format!("{from_axis:.1}"))), fate.to_owned()]);
        rows.push(row);
    }
    pieces.push(Piece::Dot { at: MIDDLE, radius: 2.0, ink: Ink::Black, filled: true });
    let middle = if what == Term::Transmitted { "T" } else { "R" };
    pieces.push(Piece::Text { at: [MIDDLE[0] + 9.0, MIDDLE[1] + 9.0], text: middle.to_owned(), ink: Ink::Black });
    let caption = (texts.lobe)(middle, &language.number(exponent, style));
    Ok(CloseUp {
        title: (texts.zones)(&tree.path(ray)),
        note: texts.zones_note.to_owned(),
        columns: texts.zone_columns.map(str::to_owned).to_vec(),
        rows,
        sheets: vec![Sheet::new(caption, SIZE, MIDDLE, pieces)],
    })
}

/// Which bounce of a ray's hit is blurred, the exponent of its lobe, and the zones.
fn of_ray(log: &Log, tree: &Tree, ray: usize) -> Option<(Term, f64, Vec<Zone>)> {
    let of = |child: usize| match tree.nodes()[child].step {
        Some(Step::Zone { what, number }) => Some((child, what, number)),
        _ => None,
    };
    let nodes: Vec<_> = tree.children(ray).filter_map(of).collect();
    let (first, what, _) = *nodes.first()?;
    let exponent = number(log, tree, first, Name::LobeExponent)?;
    let zones = nodes.iter().filter(|(_, of, _)| *of == what);
    Some((what, exponent, zones.filter_map(|(node, _, number)| zone(log, tree, *node, *number)).collect()))
}

fn zone(log: &Log, tree: &Tree, node: usize, number_of_zone: u32) -> Option<Zone> {
    let of = |name| number(log, tree, node, name);
    let direction = [of(Name::LobeX)?, of(Name::LobeY)?, of(Name::LobeZ)?];
    // A bounce with one ray has no zones: its direction comes from the whole lobe.
    let strata = [Name::SampleColumn, Name::SampleAcross, Name::SampleAbove, Name::SampleCount].map(of);
    let [rings, sectors] = match strata {
        [Some(column), Some(across), Some(above), Some(count)] => {
            [[above / count, (above + across) / count], [column / across, (column + 1.0) / across]]
        }
        _ => [[0.0, 1.0]; 2],
    };
    let mut decisions = tree.own_events(node).filter_map(|event| log.events[event].decision());
    let is_rejected = decisions.any(|decision| matches!(decision, Decision::Rejected { .. }));
    Some(Zone { number: number_of_zone, rings, sectors, direction, is_rejected })
}

/// The part of the lobe that lies nearer to its axis than a direction does: 1 − cosⁿ⁺¹θ.
fn part_within([x, y, z]: [f64; 3], exponent: f64) -> f64 {
    if z <= 0.0 {
        return 1.0;
    }
    // Near the axis the sine knows the angle better than the cosine.
    let sine_squared = ((x * x + y * y) / (x * x + y * y + z * z)).min(1.0);
    -libm::expm1(0.5 * (exponent + 1.0) * libm::log1p(-sine_squared))
}

/// The place of a direction: the part of the lobe nearer to the axis, and turns around it.
fn place(part: f64, turns: f64) -> Point {
    let (radius, angle) = (RADIUS * part.max(0.0).sqrt(), TAU * turns);
    [MIDDLE[0] + radius * libm::cos(angle), MIDDLE[1] - radius * libm::sin(angle)]
}

/// The outer sides of the rings, each once.
fn rings(zones: &[Zone]) -> Vec<f64> {
    let mut rings: Vec<f64> = zones.iter().map(|zone| zone.rings[1].min(1.0)).collect();
    rings.sort_by(f64::total_cmp);
    rings.dedup();
    rings
}

/// The outline of a zone.
fn outline(zone: &Zone) -> Vec<Point> {
    const STEPS: u32 = 24;
    let along = |ring: f64| {
        let [from, to] = zone.sectors;
        (0..=STEPS).map(move |step| place(ring, from + (to - from) * f64::from(step) / f64::from(STEPS)))
    };
    along(zone.rings[0]).chain(along(zone.rings[1]).collect::<Vec<_>>().into_iter().rev()).collect()
}
