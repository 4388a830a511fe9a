//! A ray that begins inside a solid, whose light is inside too: the surface lies beyond the light, whatever the solid is.

use crate::support;
use glam::DVec3;
use proptest::prelude::*;
use raywalk::log::{Decision, Log, Miss, RayKind, Step, Tree, What};
use raywalk::record::{self, Arithmetic};
use raywalk::report::Style;
use raywalk::report::language::Language;
use raywalk::report::{decided, notation};
use raywalk::scene::Scene;
use serde_json::{Value, json};

/// A point clearly inside the unit ball, of a place of the cube; inside the circle, of one whose z is 0.
fn in_ball([x, y, z]: [f64; 3]) -> DVec3 {
    let point = DVec3::new(x, y, z);
    point * (0.9 * point.abs().max_element() / point.length().max(1e-9))
}

/// A solid, and where its points are: of a place of the cube, the point clearly inside the solid.
type Solid = (Value, Box<dyn Fn([f64; 3]) -> DVec3>);

fn solid(kind: usize, center: DVec3, sizes: [f64; 3], axis: DVec3) -> Solid {
    let size = DVec3::from_array(sizes);
    let apex = center + axis;
    let across = axis.any_orthogonal_vector().normalize();
    let other = axis.normalize().cross(across);
    let along = move |place: [f64; 3], radius: &dyn Fn(f64) -> f64| {
        let height = 0.5 + 0.45 * place[0];
        let disk = in_ball([place[1], place[2], 0.0]);
        center + axis * height + (across * disk.x + other * disk.y) * radius(height)
    };
    match kind {
        0 => {
            let shape = json!({"box": {"min": (center - size).to_array(), "max": (center + size).to_array()}});
            (shape, Box::new(move |place| center + size * DVec3::from_array(place) * 0.9))
        }
        1 => {
            let shape = json!({"ellipsoid": {"center": center.to_array(), "radii": sizes}});
            (shape, Box::new(move |place| center + size * in_ball(place)))
        }
        2 => {
            let shape = json!({"cylinder":
                {"base": center.to_array(), "apex": apex.to_array(), "radius": sizes[0], "caps": true}});
            (shape, Box::new(move |place| along(place, &|_| sizes[0])))
        }
        3 => {
            let shape = json!({"sphere": {"center": center.to_array(), "radius": sizes[0]}});
            (shape, Box::new(move |place| center + sizes[0] * in_ball(place)))
        }
        _ => {
            // A cone with a tip, and a frustum.
            let radii = if kind == 4 { [sizes[0], 0.0] } else { [sizes[0], sizes[1]] };
            let shape = json!({"cone": {"base": center.to_array(), "base_radius": radii[0],
                "apex": apex.to_array(), "apex_radius": radii[1], "caps": true}});
            (shape, Box::new(move |place| along(place, &|height| radii[0] + height * (radii[1] - radii[0]))))
        }
    }
}

/// A speck in the solid that is seen from one point of it and lit from another.
fn scene(shape: &Value, [eye, speck, light]: [DVec3; 3], two_sided: bool) -> Scene {
    let normal = (eye - speck).normalize() + (light - speck).normalize();
    let scene = json!({
        "format": "raywalk-scene/1",
        "camera": {"position": [0, 0, 9], "direction": [0, 0, -1], "vertical_fov": 1, "resolution": [1, 1]},
        "lights": [{"name": "lamp", "point": {"position": light.to_array()}}],
        "materials": {"m": {"diffuse": [0.5, 0.5, 0.5]}},
        "objects": [
            {"name": "speck", "material": "m", "shape":
                {"disk": {"center": speck.to_array(), "normal": normal.to_array(), "radius": 1e-4}}},
            {"name": "solid", "material": "m", "shape": shape},
        ],
        "tracing": {"max_depth": 0, "two_sided": two_sided},
    });
    support::scene_of(scene.to_string().as_bytes(), "inside a solid")
}

/// What the tests of the solid on the shadow ray decided: each reason, with whether it has its numbers.
fn on_the_shadow_ray(log: &Log) -> Vec<(Miss, usize)> {
    let tree = Tree::of(&log.events);
    let of_solid = |event: &usize| {
        let node = tree.owner(*event);
        let around = tree.nodes()[tree.nodes()[node].parent].step;
        matches!(tree.nodes()[node].step, Some(Step::Test { object: 1, .. }))
            && matches!(around, Some(Step::Ray { kind, .. }) if kind != RayKind::Camera)
    };
    let reason = |event: usize| match log.events[event].what {
        What::Mark(Decision::Miss { why }) => {
            let found = decided::comparisons(log, &tree, event, Style::default());
            assert!(found.iter().all(|comparison| comparison.relation.holds(comparison.values)), "{found:?}");
            Some((why, found.len()))
        }
        _ => None,
    };
    (0..log.events.len()).filter(of_solid).filter_map(reason).collect()
}

/// A shadow ray through a transmitting solid asks for all of its crossings and chooses none: which of them are hit follows from their
/// distances. By hand, for a ray along the x axis from x = −5 to a light at x = 5.
#[test]
fn hits_of_transmitting_solids_say_at_which_crossing() {
    let (base, apex) = ([0, 0, -1], [0, 0, 1]);
    let along = ([-1, 0, 0], [1, 0, 0]);
    for (shape, expected) in [
        // Entered at t = 4, left at 6; open or not.
        (json!({"box": {"min": [-1, -1, -1], "max": [1, 1, 1]}}), "t_in ≤ t_out; t_in > 0; t_in < |ℓ|"),
        (
            json!({"ellipsoid": {"center": [0, 0, 0], "radii": [1, 2, 3]}}),
            "Δ ≥ 0; min(t_1, t_2) > 0; min(t_1, t_2) < |ℓ|",
        ),
        (
            json!({"cylinder": {"base": base, "apex": apex, "radius": 1, "caps": true}}),
            "Δ ≥ 0; min(t_1, t_2) > 0; min(t_1, t_2) < |ℓ|",
        ),
        (
            json!({"cone": {"base": base, "base_radius": 1, "apex": apex, "apex_radius": 2, "caps": false}}),
            "Δ ≥ 0; d_w = 0; t_0 + min(t_1, t_2) > 0; t_0 + min(t_1, t_2) < |ℓ|",
        ),
        // Through both caps at t = 4 and 6.
        (
            json!({"cylinder": {"base": along.0, "apex": along.1, "radius": 1, "caps": true}}),
            "min(t_b, t_a) > 0; min(t_b, t_a) < |ℓ|",
        ),
        // The ray begins inside, and comes out at t = 2.
        (json!({"box": {"min": [-9, -1, -1], "max": [-3, 1, 1]}}), "t_in ≤ t_out; t_out > 0; t_out < |ℓ|"),
        (
            json!({"ellipsoid": {"center": [-5, 0, 0], "radii": [2, 1, 1]}}),
            "Δ ≥ 0; max(t_1, t_2) > 0; max(t_1, t_2) < |ℓ|",
        ),
    ] {
        let scene = json!({
            "format": "raywalk-scene/1",
            "camera": {"position": [0, 0, 9], "direction": [0, 0, -1], "vertical_fov": 1, "resolution": [1, 1]},
            "lights": [{"name": "lamp", "point": {"position": [5, 0, 0]}}],
            "materials": {"m": {"diffuse": [0.5, 0.5, 0.5]}, "glass": {"weights": {"local": 0.5, "transmitted": 0.5}}},
            "objects": [
                {"name": "speck", "material": "m", "shape": {"disk": {"center": [-5, 0, 0], "normal": [1, 0, 0], "radius": 0.01}}},
                {"name": "solid", "material": "glass", "shape": shape},
            ],
            "tracing": {"max_depth": 0},
        });
        let scene = support::scene_of(scene.to_string().as_bytes(), "glass");
        // From between the speck and the solid.
        let log = record::ray(&scene, DVec3::new(-4.5, 0.0, 0.0), DVec3::NEG_X, Arithmetic::F64);
        let tree = Tree::of(&log.events);
        let is_hit = |event: &usize| {
            let node = tree.owner(*event);
            log.events[*event].what == What::Mark(Decision::Hit)
                && matches!(tree.nodes()[node].step, Some(Step::Test { object: 1, .. }))
                && matches!(
                    tree.nodes()[tree.nodes()[node].parent].step,
                    Some(Step::Ray { kind: RayKind::Shadow { .. }, .. })
                )
        };
        let hit = (0..log.events.len()).find(is_hit).unwrap_or_else(|| panic!("{expected}: {:#?}", log.events));
        let line = notation::line(Language::English, &log, &tree, hit, Style::default()).expect("a comparison");
        let symbols: Vec<_> = line.split("; ").filter_map(|part| part.split(": ").next()).collect();
        assert_eq!(symbols.join("; "), expected, "{line}");
    }
}

fn place() -> impl Strategy<Value = [f64; 3]> {
    proptest::array::uniform3(-1.0_f64..1.0)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    /// Two-sided, the crossing before the ray lies beyond the light; one-sided, it turns its back.
    #[test]
    fn a_solid_around_the_light_lies_beyond_it(
        kind in 0_usize..6,
        center in place(),
        sizes in proptest::array::uniform3(0.2_f64..3.0),
        axis in place(),
        places in proptest::array::uniform3(place()),
    ) {
        let axis = DVec3::from_array(axis);
        prop_assume!(axis.length() > 0.2);
        let (shape, point) = solid(kind, DVec3::from_array(center), sizes, axis);
        let points @ [eye, speck, light] = places.map(point);
        let (to_eye, to_light) = ((eye - speck).normalize(), (light - speck).normalize());
        prop_assume!((to_eye + to_light).length() > 0.1 && (eye - speck).length().min((light - speck).length()) > 1e-2);
        for (two_sided, expected) in [(true, Miss::Beyond), (false, Miss::FacesAway)] {
            let scene = scene(&shape, points, two_sided);
            let log = record::ray(&scene, eye, speck - eye, Arithmetic::F64);
            let found = on_the_shadow_ray(&log);
            prop_assert!(found.len() == 1, "{shape}: {found:?}");
            prop_assert!(found[0].0 == expected && found[0].1 > 0, "{shape}: {found:?}");
        }
    }
}
