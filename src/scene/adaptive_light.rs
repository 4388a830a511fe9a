//! Area lights that are asked only as much as they must: the rules by which the mean of one in full view is taken.

use super::light_surface::{By, LightSurface};
use std::f64::consts::{PI, TAU};

/// How a light is asked for as many of its points as it takes.
#[derive(Clone, Debug, PartialEq)]
pub struct Adaptive {
    /// How many points are asked at least.
    least: u32,
    /// The rules for a light in full view, of orders that rise.
    rules: Vec<Rule>,
}

/// A rule of quadrature: points with weights.
#[derive(Clone, Debug, PartialEq)]
pub struct Rule {
    /// Its order, m: it is exact for polynomials of degree 2m − 1.
    pub order: u32,
    /// Its points.
    pub points: Vec<RulePoint>,
}

/// A point of a rule.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RulePoint {
    /// Where it is: a place in the unit square, for a disk one in the unit disc.
    pub at: [f64; 2],
    /// Its part of the mean. The weights of a rule are 1 in all.
    pub weight: f64,
}

/// What a light looks like from a surface point, as far as it tells how smooth its light is there.
#[derive(Clone, Copy, Debug)]
pub struct Sight {
    /// The square of the sine of the angle under which its ball is seen, half of it: δ².
    pub spread: f64,
    /// Whether it fades with the distance.
    pub fades: bool,
    /// Exponent times the square of the angle over which the lobe of a highlight is asked; 0 where there is no highlight.
    pub sharpness: f64,
}

/// The orders of the rules that there are. The first three are those that [`Adaptive::rule`] chooses; where these have fewer points than are asked
/// for at least, greater ones follow.
const ORDERS: std::ops::RangeInclusive<u32> = 2..=8;

/// Up to which δ² rules of the orders 2, 3 and 4 are right to 4·10⁻⁴ of the mean, for rectangles and for round lights
/// (`docs/sampling.md` has the measurements).
const WIDEST: [[f64; 3]; 2] = [[1.0 / 16.0, 1.0 / 4.0, 1.0 / 2.0], [1.0 / 32.0, 1.0 / 8.0, 1.0 / 4.0]];

/// Light that fades with the distance is taken for that of a light this many times as wide, squared.
const OF_FADING: f64 = 4.0;

/// Up to which sharpness of a highlight rules of the orders 3 and 4 are right to 10⁻³ of the mean.
const SHARPEST: [[f64; 2]; 2] = [[0.25, 1.0], [0.0625, 0.25]];

impl Adaptive {
    /// For a light of which this many points are asked at least.
    pub fn new(surface: &LightSurface, by: By, least: u32) -> Adaptive {
        Adaptive { least, rules: ORDERS.map(|order| Rule::new(surface, by, order)).collect() }
    }

    /// The rule that does for a light in full view that looks like this; `None` where none does.
    pub fn rule(&self, surface: &LightSurface, sight: Sight) -> Option<&Rule> {
        let kind = usize::from(!matches!(surface, LightSurface::Rectangle { .. }));
        let spread = if sight.fades { OF_FADING * sight.spread } else { sight.spread };
        let smooth = (2..).zip(WIDEST[kind]).find(|(_, widest)| spread <= *widest)?.0;
        let order = match sight.sharpness {
            0.0 => smooth,
            sharpness => smooth.max((3..).zip(SHARPEST[kind]).find(|(_, sharpest)| sharpness <= *sharpest)?.0),
        };
        self.rules.iter().find(|rule| rule.order >= order && rule.points.len() >= self.least as usize)
    }
}

impl Rule {
    /// The rule of an order: on a rectangle Gauss and Legendre's along both sides; on a disk rings, by a rule in the square of the radius; on a
    /// sphere circles, by a rule in the height. Of the orders that are used most those with the fewest points: seven of Radon's ("Zur
    /// mechanischen Kubatur", 1948), the corners of an octahedron and of an icosahedron.
    pub fn new(surface: &LightSurface, by: By, order: u32) -> Rule {
        let points = match surface {
            LightSurface::Rectangle { .. } if order == 3 => radon(),
            LightSurface::Rectangle { .. } => {
                let nodes = gauss(order);
                let row = |[y, of_y]: [f64; 2]| {
                    let at = move |[x, of_x]: [f64; 2]| RulePoint { at: [x, y], weight: of_x * of_y };
                    nodes.clone().into_iter().map(at).collect::<Vec<_>>()
                };
                nodes.iter().flat_map(|node| row(*node)).collect()
            }
            LightSurface::Disk { .. } => {
                let on_disc = |[square, turn, weight]: [f64; 3]| {
                    let (radius, angle) = (square.sqrt(), TAU * turn);
                    // No −0.
                    RulePoint { at: [radius * libm::cos(angle) + 0.0, radius * libm::sin(angle) + 0.0], weight }
                };
                rings(order).into_iter().map(on_disc).collect()
            }
            LightSurface::Sphere { .. } => {
                let in_square = |[height, turn, weight]: [f64; 3]| RulePoint { at: [turn, height], weight };
                let circles = match by {
                    By::Area => parallels(order),
                    // The cap that is seen is round, too: its middle is at the height 0, and its rim at 1.
                    By::SolidAngle => rings(order),
                };
                circles.into_iter().map(in_square).collect()
            }
        };
        Rule { order, points }
    }
}

/// Points of a disk: the squares of their distances from the middle, their parts of a turn, and their weights.
fn rings(order: u32) -> Vec<[f64; 3]> {
    match order {
        3 => circles([[0.0, 0.25, 1.0], [2.0 / 3.0, 0.75, 6.0]]),
        _ => circles(gauss(order.div_ceil(2)).into_iter().map(|[x, weight]| [x, weight, f64::from(2 * order)])),
    }
}

/// Points of a sphere: their heights from 0 to 1, their parts of a turn, and their weights.
fn parallels(order: u32) -> Vec<[f64; 3]> {
    let near = (1.0 - 0.2_f64.sqrt()) / 2.0;
    let [pole, five] = [1.0 / 12.0, 5.0 / 12.0];
    match order {
        2 => circles(gauss(2).into_iter().map(|[x, weight]| [x, weight, 3.0])),
        3 => circles([[0.0, pole, 1.0], [near, five, 5.0], [1.0 - near, five, 5.0], [1.0, pole, 1.0]]),
        _ => circles(gauss(order).into_iter().map(|[x, weight]| [x, weight, f64::from(2 * order)])),
    }
}

/// Points on circles, each of which has a place, a weight and this many points; a point as its circle's place, its part of the turn and its weight. Every other circle
/// is turned by half a step.
fn circles(circles: impl IntoIterator<Item = [f64; 3]>) -> Vec<[f64; 3]> {
    let circle = |(number, [x, weight, count]): (usize, [f64; 3])| {
        let turned = if number.is_multiple_of(2) { 0.5 } else { 0.0 };
        (0..count as u32).map(move |k| [x, (f64::from(k) + turned) / count, weight / count])
    };
    circles.into_iter().enumerate().flat_map(circle).collect()
}

/// Radon's seven points in the unit square.
fn radon() -> Vec<RulePoint> {
    let [far, x, y] = [14.0 / 15.0, 3.0 / 5.0, 1.0 / 3.0].map(|square: f64| square.sqrt());
    let (middle, end, corner) = (2.0 / 7.0, 5.0 / 63.0, 5.0 / 36.0);
    [
        ([0.0, 0.0], middle),
        ([0.0, -far], end),
        ([0.0, far], end),
        ([-x, -y], corner),
        ([x, -y], corner),
        ([-x, y], corner),
        ([x, y], corner),
    ]
    .map(|(at, weight)| RulePoint { at: at.map(|x: f64| (x + 1.0) / 2.0), weight })
    .to_vec()
}

/// The nodes of Gauss and Legendre's rule between 0 and 1, and their weights, which are 1 in all: roots of the Legendre polynomial by Newton's method
/// from Tricomi's guess.
fn gauss(count: u32) -> Vec<[f64; 2]> {
    let n = f64::from(count);
    let node = |k: u32| {
        let mut x = libm::cos(PI * (f64::from(k) + 0.75) / (n + 0.5));
        let mut slope = 1.0;
        for _ in 0..8 {
            let (mut value, mut before) = (1.0, 0.0);
            for degree in 0..count {
                let degree = f64::from(degree);
                (value, before) = (((2.0 * degree + 1.0) * x * value - degree * before) / (degree + 1.0), value);
            }
            slope = n * (x * value - before) / (x * x - 1.0);
            x -= value / slope;
        }
        [(1.0 - x) / 2.0, 1.0 / ((1.0 - x * x) * slope * slope)]
    };
    (0..count).map(node).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    const SURFACES: [LightSurface; 3] = [
        LightSurface::Rectangle { center: DVec3::ZERO, edges: [DVec3::X, DVec3::Y] },
        LightSurface::Disk { center: DVec3::ZERO, edges: [DVec3::X, DVec3::Y] },
        LightSurface::Sphere { center: DVec3::ZERO, radius: 1.0 },
    ];

    /// Σw·x^k is ∫x^k dx = 1/(k + 1) up to the degree 2m − 1.
    #[test]
    fn gauss_is_exact_for_polynomials() {
        for count in 1..=8 {
            let nodes = gauss(count);
            for power in 0..2 * count as i32 {
                let sum: f64 = nodes.iter().map(|[x, weight]| weight * libm::pow(*x, power.into())).sum();
                assert!((sum - 1.0 / f64::from(power + 1)).abs() < 1e-15, "{count} {power}: {sum}");
            }
        }
    }

    /// Means of x^a·y^b (of z^b for the sphere) up to the degree 2m − 1, by their formulas.
    #[test]
    fn rules_are_exact_for_polynomials() {
        for surface in SURFACES {
            for order in ORDERS {
                let rule = Rule::new(&surface, By::Area, order);
                for (a, b) in (0..2 * order as i32).flat_map(|a| (0..2 * order as i32 - a).map(move |b| (a, b))) {
                    let of = |point: &RulePoint| {
                        let [x, y] = match surface {
                            LightSurface::Rectangle { .. } => point.at.map(|x| 2.0 * x - 1.0),
                            LightSurface::Disk { .. } => point.at,
                            LightSurface::Sphere { .. } => {
                                let [x, _, z] = crate::random::warp::sphere(point.at);
                                [x, z]
                            }
                        };
                        point.weight * libm::pow(x, a.into()) * libm::pow(y, b.into())
                    };
                    let found: f64 = rule.points.iter().map(of).sum();
                    let both_even = a % 2 == 0 && b % 2 == 0;
                    // (n − 1)!!
                    let double = |n: i32| (1..n).step_by(2).map(f64::from).product::<f64>();
                    let (c, d) = (f64::from(a), f64::from(b));
                    let expected = match surface {
                        _ if !both_even => 0.0,
                        LightSurface::Rectangle { .. } => 1.0 / ((c + 1.0) * (d + 1.0)),
                        LightSurface::Disk { .. } => {
                            let even = (2..=a + b).step_by(2).map(f64::from).product::<f64>();
                            double(a) * double(b) / even * 2.0 / (c + d + 2.0)
                        }
                        LightSurface::Sphere { .. } => double(a) * double(b) / double(a + b + 2),
                    };
                    assert!((found - expected).abs() < 1e-14, "{surface:?} {order} {a} {b}: {found}, not {expected}");
                }
            }
        }
    }

    #[test]
    fn a_rule_has_no_fewer_points_than_are_asked_at_least() {
        let sight = Sight { spread: 0.01, fades: false, sharpness: 0.0 };
        let order = |least: u32, sight| {
            let adaptive = Adaptive::new(&SURFACES[0], By::Area, least);
            adaptive.rule(&SURFACES[0], sight).map(|rule| rule.order)
        };
        assert_eq!(
            [1, 4, 5, 8, 64, 65].map(|least| order(least, sight)),
            [2, 2, 3, 4, 8, 0].map(|m| (m > 0).then_some(m))
        );
        assert_eq!(order(1, Sight { spread: 0.1, ..sight }), Some(3));
        assert_eq!(order(1, Sight { spread: 0.1, fades: true, ..sight }), Some(4));
        assert_eq!(order(1, Sight { spread: 0.6, ..sight }), None);
        assert_eq!(order(1, Sight { spread: f64::NAN, ..sight }), None);
        assert_eq!(order(1, Sight { sharpness: 0.2, ..sight }), Some(3));
        assert_eq!(order(1, Sight { sharpness: 0.6, ..sight }), Some(4));
        assert_eq!(order(1, Sight { sharpness: 1.1, ..sight }), None);
    }
}
