//! How much a ray of each level can bring at most, whatever it hits: what a cutoff may lose.
//!
//! Level by level from the deepest, in each channel: a ray brings the background, or from a surface W_l·I_local + W_r·(the ceiling of
//! the next level) + W_t·(the same), of which the largest over all materials counts. I_local is at most I_a·K_a and, of every light,
//! I_i·max(K_d + K_e, K_t): cosines and lobes are at most 1, light doesn't grow with distance, and a light is on one side of a
//! surface. What shadow rays keep is at most 1 unless a surface makes more of the light; then there are no ceilings. The
//! mean over a blurred bounce or an area light is at most its largest part. `docs/skipping.md` says what this is used for.

use super::{Color, Light, Material, Scene};

/// What adds up the roundings of a level: fewer than 2³² of them, each by at most 2⁻⁵³ of sums and products of numbers that aren't
/// negative, move a value by less than 2⁻²⁰ of it.
const OUTWARD: f64 = 1.0 + 1.0 / (1 << 20) as f64;

/// An upper bound with room for the roundings on both sides.
pub fn rounded_up(bound: Color) -> Color {
    bound * OUTWARD
}

/// The most that a ray of each level can bring, per channel.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ceilings {
    by_level: Vec<Color>,
}

impl Ceilings {
    /// Those of a scene, for as many levels as its rays have.
    pub fn of(scene: &Scene) -> Ceilings {
        let amplifies = |material: &Material| material.weights.transmitted.cmpgt(Color::ONE).any();
        if scene.materials.iter().any(amplifies) {
            return Ceilings::default();
        }
        let levels = (0..).find(|level| !scene.tracing.goes_deeper(*level)).unwrap_or(0);
        let mut by_level = Vec::new();
        let mut next = Color::ZERO;
        for level in (0..=levels).rev() {
            let of_material = |material: &Material| {
                let weights = &material.weights;
                let reflected = scene.tracing.scale_of_reflected(weights.reflected, material);
                weights.local * local(scene, material, level) + (reflected + weights.transmitted) * next
            };
            next = rounded_up(scene.materials.iter().map(of_material).fold(scene.background, largest));
            by_level.push(next);
        }
        by_level.reverse();
        Ceilings { by_level }
    }

    /// That of the rays of a level, if there is one.
    pub fn of_level(&self, level: u32) -> Option<Color> {
        self.by_level.get(level as usize).copied().filter(|ceiling| ceiling.is_finite())
    }
}

/// The most that a surface of this material can send out by itself.
fn local(scene: &Scene, material: &Material, level: u32) -> Color {
    let pattern = material.pattern.as_deref().map_or(Color::ONE, |pattern| pattern.a.max(pattern.b));
    let ambient = scene.ambient * material.ambient * pattern;
    if scene.tracing.shades_ambient_only(level) {
        return ambient;
    }
    let used = (material.diffuse * pattern + material.specular).max(material.transmission);
    let arriving = |light: &Light| light.color * light.largest_weight() * used;
    ambient + scene.lights.iter().map(arriving).sum::<Color>()
}

/// The larger in each channel; infinite once something is too large for a number.
fn largest(most: Color, another: Color) -> Color {
    if another.is_finite() { most.max(another) } else { Color::INFINITY }
}

#[cfg(test)]
mod tests {
    use crate::scene::{Color, Scene, build, builtin, file};

    fn scene(name: &str, cutoff: f64) -> Scene {
        let mut file = file::parse(builtin::text(name).expect("a scene").as_bytes(), name).expect("a good scene");
        file.tracing.cutoff = cutoff;
        build(&file, &Default::default()).expect("a supported scene")
    }

    #[test]
    fn the_numeric_example_by_hand() {
        // Depth 1: the ball's own light is the most that the reflected ray brings, and both weights are 1.
        let scene = scene("textbook", 0.1);
        let ambient = Color::new(180.0, 160.0, 190.0);
        let light = Color::new(220.0, 200.0, 255.0);
        let wall = ambient * Color::new(0.2, 0.3, 0.1) + light * Color::new(1.5, 1.1, 1.3);
        let ball = ambient * Color::new(0.3, 0.2, 0.4) + light * Color::new(1.2, 1.1, 1.1);
        let deepest = wall.max(ball).max(Color::new(200.0, 200.0, 255.0));
        let expected = [deepest * 2.0, deepest];
        for (level, expected) in (0..).zip(expected) {
            let ceiling = scene.ceilings.of_level(level).expect("a ceiling");
            assert!(ceiling.cmpge(expected).all() && (ceiling / expected).max_element() < 1.00001, "{ceiling}");
        }
        assert_eq!(scene.ceilings.of_level(2), None);
    }

    /// cos²(π/2·ρ) has the mean 1/2 − 2/π² over a square: in the middle it is that much brighter than on the whole.
    #[test]
    fn a_profile_weighs_shadow_rays_by_solid_angle() {
        let scene = |by: &str| {
            let light = r#""rectangle": {"corner": [0, 0, 0], "edge_u": [1, 0, 0], "edge_v": [0, 1, 0]}, "profile": {"cosine_power": 2}"#;
            let text = format!(
                r#"{{"format": "raywalk-scene/1", "camera": {{"position": [0, 0, 9], "direction": [0, 0, -1]}},
                    "lights": [{{{light}, "by": "{by}"}}], "materials": {{"m": {{"diffuse": [1, 1, 1]}}}}, "tracing": {{"cutoff": 0.1}},
                    "objects": [{{"shape": {{"plane": {{"coefficients": [0, 1, 0, 0]}}}}, "material": "m"}}]}}"#
            );
            let file = file::parse(text.as_bytes(), "light").expect("a good scene");
            let scene = build(&file, &Default::default()).expect("a supported scene");
            scene.ceilings.of_level(9).or(scene.ceilings.of_level(4)).expect("a ceiling").x
        };
        let brightest = 1.0 / (0.5 - 2.0 / (std::f64::consts::PI * std::f64::consts::PI));
        assert!((scene("solid_angle") / scene("area") - brightest).abs() < 1e-9);
    }

    #[test]
    fn without_a_cutoff_nobody_asks() {
        assert_eq!(scene("textbook", 0.0).ceilings.of_level(0), None);
    }

    #[test]
    fn a_surface_that_makes_more_of_light_has_no_ceiling() {
        let mut scene = scene("glass-shadows", 0.1);
        assert!(scene.ceilings.of_level(0).is_some());
        scene.materials[1].weights.transmitted.x = 1.5;
        assert_eq!(super::Ceilings::of(&scene).of_level(0), None);
    }
}
