//! Ray queries as users ask them: what a ray is said to leave, and what is wrong with a line.

use crate::rays as random;
use crate::support;
use assert_cmd::Command;
use glam::DVec3;
use proptest::prelude::*;
use raywalk::geometry::shape::TriangleMesh;
use raywalk::geometry::{Leaving, Mesh, Shape, Side};
use raywalk::scene::Scene;
use raywalk::trace::query::{Answer, Query};
use std::cell::Cell;
use std::sync::Arc;

const BOX: &str = r#"{"format": "raywalk-scene/1", "camera": {"position": [0, 0, 9], "direction": [0, 0, -1]},
  "objects": [{"name": "b", "shape": {"box": {"min": [0, 0, 0.3], "max": [1, 1, 1.1]}}}]}"#;

fn ask(scene: &Scene, origin: DVec3, direction: DVec3, leaves: bool) -> Option<Answer> {
    let from = leaves.then_some((0, Leaving::ANY_PRIMITIVE));
    Query { origin, direction, t_min: 0.0, t_max: f64::INFINITY, from }.nearest(scene)
}

#[test]
fn a_ray_that_leaves_a_box_meets_it_again_inward_only() {
    let scene = support::scene_of(BOX.as_bytes(), "box");
    let coordinate = |low: f64, high: f64| low..high;
    let aim = (coordinate(0.1, 0.9), coordinate(0.1, 0.9), coordinate(0.4, 1.0));
    let strategy = (aim, random::point(), random::point())
        .prop_filter("directions", |(_, way, direction)| way.length() > 2.0 && direction.length() > 0.1);
    random::property(strategy, |((x, y, z), way, direction)| {
        let aim = DVec3::new(x, y, z);
        let hit = ask(&scene, aim + way, -way, false).expect("the ray was aimed at the box from outside");
        let again = ask(&scene, hit.point, direction, true);
        // Along a face rounding may decide.
        let slope = direction.dot(hit.normal);
        if slope < -1e-9 {
            assert!(again.is_some_and(|again| again.t > 1e-12 && again.normal != hit.normal), "{hit:?}: {again:?}");
        } else if slope > 1e-9 {
            assert_eq!(again, None, "{hit:?}");
        }
        again.is_some()
    });
}

/// Hits have tmin < t < tmax in the very numbers that are printed, whatever the length of the direction.
#[test]
fn the_ends_of_a_query_are_exact() {
    let scenes = [
        BOX,
        r#"{"format": "raywalk-scene/1", "camera": {"position": [0, 0, 9], "direction": [0, 0, -1]},
        "objects": [{"name": "s", "shape": {"sphere": {"center": [0.1, 0.2, 0.3], "radius": 0.9}}}]}"#,
        r#"{"format": "raywalk-scene/1", "camera": {"position": [0, 0, 9], "direction": [0, 0, -1]},
        "objects": [{"name": "p", "shape": {"plane": {"coefficients": [0.1, 0.5, -0.7, 0.3]}}}]}"#,
    ]
    .map(|text| support::scene_of(text.as_bytes(), "ends"));
    let scenes: Vec<_> = scenes.into_iter().chain(each_shape()).collect();
    random::property((random::point(), random::point()), |(origin, direction)| {
        if direction.length() < 0.1 {
            return false;
        }
        let hits = scenes.iter().filter_map(|scene| {
            let query = |t_min: f64, t_max: f64| Query { origin, direction, t_min, t_max, from: None };
            let t = query(0.0, f64::INFINITY).nearest(scene)?.t;
            assert!(query(t, f64::INFINITY).nearest(scene).is_none_or(|next| next.t > t));
            assert_eq!(query(0.0, t).nearest(scene), None);
            assert!(!query(0.0, t).is_occluded(scene));
            let around = query(t.next_down(), t.next_up());
            assert_eq!(around.nearest(scene).map(|hit| hit.t), Some(t));
            assert!(around.is_occluded(scene));
            Some(())
        });
        hits.count() > 0
    });
}

/// A scene for each object of the scene that has every shape.
fn each_shape() -> Vec<Scene> {
    let mut file: serde_json::Value = serde_json::from_str(include_str!("../support/shapes.json")).expect("JSON");
    let objects = file["objects"].as_array().expect("a list").clone();
    assert!(objects.len() >= 8);
    let alone = objects.into_iter().map(|object| {
        file["objects"] = serde_json::json!([object]);
        support::scene_of(file.to_string().as_bytes(), "alone")
    });
    alone.collect()
}

/// What `raywalk rays` answers to a line.
fn answer(scene: &str, line: &str) -> String {
    let mut command = Command::cargo_bin("raywalk").expect("the program");
    let input = if scene == "-" { BOX } else { line };
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("box.json");
    std::fs::write(&file, input).expect("written");
    let name = if scene == "-" { file.to_str().expect("UTF-8") } else { scene };
    let output = command.args(["rays", name]).write_stdin(format!("{line}\n")).output().expect("it runs");
    assert!(output.status.success(), "{output:?}");
    String::from_utf8(output.stdout).expect("UTF-8").trim_end().to_owned()
}

#[test]
fn the_face_of_a_box_that_is_left_needs_no_name() {
    let exit = answer("-", r#"{"o":[0.5,0.5,0.3],"d":[-1,0,0.1],"from":"b"}"#);
    assert!(exit.contains(r#""t":0.5,"#) && exit.contains(r#""normal":[-1.0,0.0,0.0]"#), "{exit}");
    assert!(answer("-", r#"{"o":[1,0.5,0.5],"d":[-1,0,0],"from":"b","from_primitive":0}"#).contains(r#""t":1.0,"#));
    let outward = answer("-", r#"{"o":[0.5,0.999999999999999,0.5],"d":[0.1,2,0.1],"from":"b"}"#);
    assert_eq!(outward, r#"{"hit":null}"#);
}

#[track_caller]
fn refuses(line: &str, expected: &str) {
    let answer: serde_json::Value = serde_json::from_str(&answer("textbook", line)).expect("JSON");
    assert_eq!(answer["error"], expected);
}

#[test]
fn unusable_lines_say_why() {
    refuses(
        r#"{"o":[16,2,7],"d":[1,0,0],"from":"sphre"}"#,
        "from: no object is called `sphre`, did you mean `sphere`?",
    );
    refuses(
        r#"{"o":[16,2,7],"d":[1,0,0],"tmn":1}"#,
        "column 31: unknown key `tmn`, did you mean `tmin`? expected `id`, `o`, `d`, `tmin`, `tmax`, `from` or `from_primitive`",
    );
    refuses(
        "[1,[16,2,7],[-12,4,1],0,null,null,null]",
        r#"expected an object, {"o": [x, y, z], "d": [x, y, z]}, found an array"#,
    );
    refuses("7", r#"expected an object, {"o": [x, y, z], "d": [x, y, z]}, found `7`"#);
    refuses(r#"{"o":[16,2,7],"d":[0,0,0]}"#, "d: expected a direction that is not zero");
    refuses(
        r#"{"o":[16,2,7],"d":[1,0,0],"from_primitive":1}"#,
        "from_primitive: expected `from` too, the object that has it",
    );
    refuses(
        r#"{"o":[16,2,7],"d":[1,0,0],"from":"sphere","from_primitive":33}"#,
        "from_primitive: `sphere` has primitive 0 only, found 33",
    );
}

/// A cube of twelve triangles from 0 to 8 that share their corners.
fn cube() -> Scene {
    const FACES: [[u32; 3]; 12] = [
        [0, 2, 1],
        [1, 2, 3],
        [4, 5, 6],
        [5, 7, 6],
        [0, 1, 4],
        [1, 5, 4],
        [2, 6, 3],
        [3, 6, 7],
        [0, 4, 2],
        [2, 4, 6],
        [1, 3, 5],
        [3, 7, 5],
    ];
    let corner = |number: u8| DVec3::new((number & 1).into(), (number >> 1 & 1).into(), (number >> 2).into()) * 8.0;
    let mesh = Mesh { positions: (0..8).map(corner).collect(), normals: None, faces: FACES.to_vec() };
    Scene::of_shapes("cube", vec![Shape::Mesh(Arc::new(TriangleMesh::new(Arc::new(mesh))))])
}

/// A line through the inside of a convex solid enters once and leaves once, also where it does so on a corner or an edge.
#[test]
fn a_line_through_a_cube_crosses_its_surface_twice() {
    let scene = cube();
    // Of the points on the surface with whole coordinates nearly a third are on an edge, a corner or a diagonal.
    let on_surface = (0..6_u8, 0..=8_u8, 0..=8_u8).prop_map(|(face, u, v)| {
        let (axis, w) = (usize::from(face / 2), f64::from(face % 2) * 8.0);
        let mut point = [f64::from(u); 3];
        (point[axis], point[(axis + 1) % 3]) = (w, f64::from(v));
        DVec3::from(point)
    });
    let inside = (1..=15_u8, 1..=15_u8, 1..=15_u8).prop_map(|(x, y, z)| DVec3::new(x.into(), y.into(), z.into()) / 2.0);
    proptest!(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(4000) }, |(enters in on_surface, inside in inside, before in 1..9_u8)| {
        let direction = inside - enters;
        let query = Query::new(enters - direction * f64::from(before), direction);
        let hits = query.all(&scene);
        prop_assert_eq!(hits.iter().map(|hit| hit.side).collect::<Vec<_>>(), [Side::Front, Side::Back], "{:?}", hits);
        prop_assert!((hits[0].t - f64::from(before)).abs() < 1e-12 && hits[1].t > f64::from(before) + 1.0, "{:?}", hits);
        prop_assert_eq!(query.nearest(&scene), Some(hits[0]));
    });
}

/// All hits are those that are found one after the other.
#[test]
fn every_crossing_is_that_beyond_the_last_one() {
    let scene = support::scene_of(include_bytes!("../support/shapes.json"), "shapes");
    let several = Cell::new(0);
    proptest!(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(4000) }, |(origin in random::point(), direction in random::point())| {
        prop_assume!(direction.length() > 0.1);
        let mut query = Query::new(origin, direction);
        let all = query.all(&scene);
        for hit in &all {
            let next = query.nearest(&scene);
            prop_assert_eq!(next, Some(*hit));
            query.t_min = hit.t;
        }
        prop_assert_eq!(query.nearest(&scene), None);
        several.set(several.get() + usize::from(all.len() > 1));
    });
    assert!(several.get() > 20, "{} rays cross several surfaces", several.get());
}

/// What the help shows is what comes.
#[test]
fn the_examples_of_the_help() {
    let raywalk = || Command::new(env!("CARGO_BIN_EXE_raywalk"));
    let help = String::from_utf8(raywalk().args(["rays", "--help"]).output().expect("it runs").stdout).expect("UTF-8");
    let examples: Vec<_> = help.split("$ echo '").skip(1).collect();
    assert_eq!(examples.len(), 2);
    for example in examples {
        let (query, rest) = example.split_once("' | raywalk ").expect("a query");
        let (arguments, rest) = rest.split_once('\n').expect("a call");
        let answer = rest.lines().next().expect("an answer").trim();
        let said = raywalk().args(arguments.split(' ')).write_stdin(query).output().expect("it runs").stdout;
        assert_eq!(String::from_utf8_lossy(&said).trim(), answer);
    }
}
