//! What an NFF file may and may not say, in many small cases.

#![allow(clippy::unwrap_used)]

use super::{Angle, Import, check, is_nff};
use crate::files::Severity;
use crate::scene::file::Loaded;
use crate::scene::file::schema::{Aim, LightKind, PointLight, SceneFile, Shape, Weight};

/// A view, on one line, and a fill on the next.
const BEFORE: &str = "v from 0 0 9 at 0 0 0 up 0 1 0 angle 45 hither 1 resolution 512 512\nf 1 .5 0 .8 .25 30 0 1\n";

fn load(text: impl AsRef<[u8]>, import: Import) -> Loaded {
    check(text.as_ref(), "dir/my.nff.gz", &import).unwrap_or_else(|error| panic!("{}", error.report(false)))
}

fn scene(text: &str) -> SceneFile {
    load(text, Import::default()).scene
}

/// The shape of the only primitive behind the view and the fill.
#[track_caller]
fn shape(primitive: &str) -> Shape {
    let scene = scene(&format!("{BEFORE}{primitive}"));
    assert_eq!(scene.objects.len(), 1, "{primitive}");
    scene.objects.into_iter().next().unwrap().shape
}

#[track_caller]
fn refuses(text: impl AsRef<[u8]>, expected: &str) {
    let error = check(text.as_ref(), "t", &Import::default()).unwrap_err();
    assert_eq!(error.exit_code(), 2);
    assert_eq!(error.to_string(), format!("t:{expected}"), "\n{}", error.report(false));
}

/// What follows the view and the fill is refused; its first line is line 3.
#[track_caller]
fn refuses_after(text: &str, expected: &str) {
    refuses(format!("{BEFORE}{text}"), expected);
}

#[track_caller]
fn warns(text: &str, expected: &[&str]) {
    let warnings = load(text, Import::default()).warnings;
    let found: Vec<_> = warnings.iter().map(ToString::to_string).collect();
    let expected: Vec<_> = expected.iter().map(|line| format!("dir/my.nff.gz:{line}")).collect();
    assert_eq!(found, expected);
    assert!(warnings.iter().all(|warning| warning.report(Severity::Warning, false).contains('^')));
}

#[test]
fn a_whole_file() {
    let scene = scene(
        "# a comment\r\nb 0.1 0.2 0.3 # before the view\r\nv\r\nfrom 1 2 -3e0\r\nat 0 0 0\r\nup 0 0 1\r\nangle 30\r\n\
         hither 0.01\r\nresolution 640 480\r\nl 4 3 2\r\nl -1 -4 4 .5 .6 .7\r\nf 1 .5 0 0.5 0.25 27 0.75 1.5\r\n\
         s 0 0 0 0.5\r\ns 1 0 0 0.5\r\nf 1 1 1 1 0 100000 0 0\r\nc 0 0 0 1 0 0 1 1",
    );
    assert_eq!(scene.name, "my");
    assert_eq!(scene.background, [0.1, 0.2, 0.3]);
    assert_eq!(scene.camera.position, [1.0, 2.0, -3.0]);
    assert_eq!(scene.camera.aim, Aim::LookAt([0.0; 3]));
    assert_eq!(scene.camera.up, [0.0, 0.0, 1.0]);
    assert_eq!(scene.camera.resolution, [640, 480]);
    let lights: Vec<_> = scene.lights.iter().map(|light| (light.name.as_str(), light.kind, light.color)).collect();
    let point = |position| LightKind::Point(PointLight { position });
    let half = 1.0 / 2.0_f64.sqrt();
    let expected =
        [("light-1", point([4.0, 3.0, 2.0]), [half; 3]), ("light-2", point([-1.0, -4.0, 4.0]), [0.5, 0.6, 0.7])];
    assert_eq!(lights, expected);
    let objects: Vec<_> =
        scene.objects.iter().map(|object| (object.name.as_str(), object.material.as_deref().unwrap())).collect();
    assert_eq!(objects, [("sphere-1", "fill-1"), ("sphere-2", "fill-1"), ("cylinder-1", "fill-2")]);
    assert!(!scene.tracing.two_sided);
    assert_eq!(scene.tracing.max_depth, 4);
    assert_eq!((scene.output.white, scene.ambient), (1.0, [0.0; 3]));
}

#[test]
fn a_fill_is_a_material() {
    let scene = scene(&format!("{BEFORE}f 1 .5 0 0.5 0.25 27 0.75 1.5 s 0 0 0 1 f 0 0 0 0 0 1 0 0 s 0 0 0 2"));
    let glass = scene.materials.get("fill-2").unwrap();
    assert_eq!((glass.diffuse, glass.specular, glass.ambient), ([0.5, 0.25, 0.0], [0.25; 3], [0.0; 3]));
    assert_eq!((glass.shininess, glass.ior, glass.transmission), (27.0, 1.5, [0.0; 3]));
    let weights = [glass.weights.local, glass.weights.reflected, glass.weights.transmitted];
    assert_eq!(weights, [1.0, 0.25, 0.75].map(Weight::Scalar));
    assert_eq!(scene.materials.get("fill-3").unwrap().ior, 1.0, "opaque fills may carry the index 0");
}

#[test]
fn defaults() {
    let scene = scene(BEFORE);
    assert_eq!(scene.background, [0.0; 3]);
    assert_eq!((scene.lights.len(), scene.objects.len()), (0, 0));
}

#[test]
fn primitives() {
    use crate::scene::file::schema::{Cone, Cylinder, Polygon, Sphere, Triangle};
    let center = [1.0, 2.0, 3.0];
    assert_eq!(shape("s 1 2 3 4"), Shape::Sphere(Sphere { center, radius: 4.0, inward: false }));
    assert_eq!(shape("s 1 2 3 -4"), Shape::Sphere(Sphere { center, radius: 4.0, inward: true }));
    let (base, apex) = ([0.0; 3], [0.0, 0.0, 1.0]);
    let cylinder = |inward| Shape::Cylinder(Box::new(Cylinder { base, apex, radius: 2.0, caps: false, inward }));
    assert_eq!(shape("c\n0 0 0 2\n0 0 1 2"), cylinder(false));
    assert_eq!(shape("c 0 0 0 -2 0 0 1 -2"), cylinder(true));
    let cone = |base_radius, apex_radius, inward| {
        Shape::Cone(Box::new(Cone { base, base_radius, apex, apex_radius, caps: false, inward }))
    };
    assert_eq!(shape("c 0 0 0 2 0 0 1 0"), cone(2.0, 0.0, false));
    assert_eq!(shape("c 0 0 0 -2 0 0 1 -1"), cone(2.0, 1.0, true));
    assert_eq!(shape("c 0 0 0 0 0 0 1 -1"), cone(0.0, 1.0, true));
    let (a, b, c, d) = ([0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]);
    assert_eq!(
        shape("p 3 0 0 0 1 0 0 1 1 0"),
        Shape::Triangle(Box::new(Triangle { vertices: [a, b, c], normals: None }))
    );
    let quad = Polygon { vertices: vec![a, b, c, d], normals: None };
    assert_eq!(shape("p 4 0 0 0 1 0 0 1 1 0 0 1 0"), Shape::Polygon(Box::new(quad.clone())));
    let normal = [0.0, 0.0, 1.0];
    let smooth = Triangle { vertices: [a, b, c], normals: Some(Box::new([normal; 3])) };
    assert_eq!(shape("pp 3 0 0 0 0 0 1 1 0 0 0 0 1 1 1 0 0 0 1"), Shape::Triangle(Box::new(smooth)));
    let smooth = Polygon { normals: Some(vec![normal; 4]), ..quad };
    assert_eq!(shape("pp 4 0 0 0 0 0 1 1 0 0 0 0 1 1 1 0 0 0 1 0 1 0 0 0 1"), Shape::Polygon(Box::new(smooth)));
}

#[test]
fn the_angle_between_centers_widens_to_the_edges() {
    let fov = |import: Import| load(BEFORE, import).scene.camera.vertical_fov;
    assert_eq!(fov(Import { angle: Angle::Edges, resolution: None }), 45.0);
    let half = |degrees: f64| libm::tan(degrees.to_radians() / 2.0);
    let near = |found: f64, expected: f64| assert!((found / expected - 1.0).abs() < 1e-14, "{found} {expected}");
    near(half(fov(Import::default())), half(45.0) * 512.0 / 511.0);
    // Another size has other centres; the angle stays.
    near(half(fov(Import { resolution: Some([640, 100]), ..Import::default() })), half(45.0) * 100.0 / 99.0);
    assert_eq!(fov(Import { resolution: Some([1, 1]), ..Import::default() }), 45.0);
    let resolution = load(BEFORE, Import { resolution: Some([7, 5]), ..Import::default() }).scene.camera.resolution;
    assert_eq!(resolution, [7, 5]);
}

#[test]
fn unknown_entities() {
    let expected = "expected `b`, `v`, `l`, `f`, `c`, `s`, `p` or `pp`";
    refuses_after("sphere 0 0 0 1", &format!("3:1: unknown entity `sphere`, did you mean `s`? {expected}"));
    refuses_after("  shpere 0 0 0 1", &format!("3:3: unknown entity `shpere`, did you mean `s`? {expected}"));
    refuses_after("S 0 0 0 1", &format!("3:1: unknown entity `S`, did you mean `s`? {expected}"));
    refuses_after("q 1", &format!("3:1: unknown entity `q`, {expected}"));
    refuses_after("\u{1b}[2J", &format!("3:1: unknown entity `\\u{{1b}}[2J`, {expected}"));
    refuses_after("at 0 0 0", "3:1: `at` belongs to a view, expected `v` before it");
    refuses_after(
        "s 0 0 0 1 2 2",
        "3:11: expected an entity, `b`, `v`, `l`, `f`, `c`, `s`, `p` or `pp`, found the number `2` (`s` takes 4 numbers)",
    );
    refuses("{}", "1:1: found `{}` as in JSON, expected an entity of NFF, `b`, `v`, `l`, `f`, `c`, `s`, `p` or `pp`");
}

#[test]
fn short_entities() {
    refuses_after("s 0 0 0\ns 0 0 0 1", "4:1: expected a number for the radius of `s`, found `s`");
    refuses_after("s 0 0 # 0", "3:6: expected a number for the centre of `s`, found the end of the file");
    refuses_after("s 0 0 0 nan", "3:9: expected a number for the radius of `s`, found `nan`");
    refuses_after("s 0 0 0 1e999", "3:9: expected a number for the radius of `s`, found `1e999`");
    refuses_after("l 1 2 3 .5 .5 s 0 0 0 1", "3:15: expected a number for the colour of `l`, found `s`");
    refuses_after("c 0 0 0 1\n\t1 1 x", "4:6: expected a number for the apex of `c`, found `x`");
    refuses_after("pp 3 0 0 0 0 0 1 1 0 0", "3:23: expected a number for a normal of `pp`, found the end of the file");
    refuses_after("p 4000000000 1", "3:15: expected a number for a corner of `p`, found the end of the file");
    let number = "the number of corners of `p` must be a whole number from 3 to 4294967295, found";
    refuses_after("p 2 0 0 0 1 1 1", &format!("3:3: {number} `2`"));
    refuses_after("p 3.5", &format!("3:3: {number} `3.5`"));
    refuses("f 1 1 1 1 1", "1:12: expected a number for Shine of `f`, found the end of the file");
    refuses("shader", "1:1: expected a name after `shader`, found the end of the file");
}

#[test]
fn views() {
    refuses("b 0 0 0\n", "1:8: the file has no view, expected `v`");
    refuses("", "1:1: the file has no view, expected `v`");
    refuses("v from 0 0 9 up 0 1 0 angle 45 resolution 5 5", "1:1: the view lacks `at`, expected it after `v`");
    refuses("v from 0 0 9 from 0 1 0", "1:14: a second `from` in the view, expected one");
    refuses_after("v", "3:1: a second view `v`, expected one");
    refuses(BEFORE.replace(" 512\nf", "\nf"), "2:1: expected a number for the height of `resolution`, found `f`");
    let angle = "the angle must be between 0 and 180 degrees, both excluded, found";
    refuses(BEFORE.replace("angle 45", "angle 180"), &format!("1:38: {angle} `180`"));
    let width = "the width of `resolution` must be a whole number from 1 to 65535, found";
    refuses(BEFORE.replace("512 512", "0 512"), &format!("1:61: {width} `0`"));
    refuses(BEFORE.replace("512 512", "5.5 512"), &format!("1:61: {width} `5.5`"));
}

#[test]
fn values_that_make_no_sense_are_placed_too() {
    refuses_after("s 0 0 0 0", "3:9: the radius of a sphere must not be 0");
    refuses_after("c 1 1 1 1 1 1 1 2", "3:1: the ends of a cone must not coincide");
    refuses_after("c 1 1 1 0 1 1 2 -0", "3:1: the radii of a cone must not both be 0");
    refuses_after(
        "c 1 1 1 -1 1 1 2 1",
        "3:1: the radii of a cone must have one sign (both negative: the inside is seen), found -1 and 1",
    );
    refuses_after(
        "f 1 1 1 1 0 1 .5 0",
        "3:18: the refractive index of a transmitting fill must be positive, found `0`",
    );
    refuses_after("b 0 0 0 b 0 0 0", "3:9: a second background `b`, expected one");
    refuses("s 0 0 0 1", "1:1: `s` comes before the first fill, expected `f` before it");
    refuses_after(
        "\ns 1 1 1 1 s 0 0 1e300 1",
        "4:11: objects[1].shape.sphere.center[2]: must be at most 1e100 in size, found 1e300",
    );
    refuses_after("f 1 -1 1 .5 0 1 0 1 s 0 0 0 1", "3:1: materials.fill-2.diffuse[1]: must be 0 or more, found -0.5");
    refuses_after("l 0 0 0 1 -1 1", "3:1: lights[0].color[1]: must be 0 or more, found -1");
    refuses_after("b 1 1 -1", "3:1: background[2]: must be 0 or more, found -1");
    refuses(
        BEFORE.replace("up 0 1 0", "up 0 0 2"),
        "1:23: camera.up: must not be parallel to the direction of view [0, 0, -9], found [0, 0, 2]",
    );
    refuses_after(
        "pp 3 0 0 0 0 0 1 1 0 0 0 0 1 1 1 0 0 0 0",
        "3:1: objects[0].shape.triangle.normals[2]: must not be the zero vector, found [0, 0, 0]",
    );
}

#[test]
fn what_other_programs_write() {
    let sphere = "s 0 0 0 1\n";
    let texture = "textures are not supported, the name after `f` is ignored";
    let textured = "f 1 1 1 1 0 1 0 1 ../my.jpg\n";
    warns(&format!("{BEFORE}{sphere}{textured}{sphere}"), &[&format!("4:19: {texture}")]);
    let twice = format!("{BEFORE}{sphere}{textured}{sphere}{textured}{sphere}");
    warns(&twice, &[&format!("4:19: {texture} (2 times in this file)")]);
    warns(
        &format!("{BEFORE}{sphere}f 1 1 1 1 0 1 0 1 .3\n{sphere}"),
        &["4:19: NFF has no ambient light, a ninth number after `f` is ignored"],
    );
    warns(&format!("{BEFORE}tess 4 {sphere}"), &[]);
    warns(&format!("{BEFORE}shader x.png {sphere}"), &["3:1: textures are not supported, `shader` is ignored"]);
    warns(
        &format!("{BEFORE}tpp 3 0 0 0 0 0 1 .1 .2 1 0 0 0 0 1 .3 .4 1 1 0 0 0 1 .5 .6"),
        &["3:1: textures are not supported, the texture coordinates of `tpp` are ignored"],
    );
    warns(
        &format!("{BEFORE}{sphere}p 3 0 0 0 1 1 1 2 2 2 p 4 0 0 0 0 0 0 0 0 0 0 0 0"),
        &["4:1: a polygon without area can't be hit and is left out (2 times in this file)"],
    );
    // On a line of its own a word is an entity.
    let message = "unknown entity `my.jpg`, expected `b`, `v`, `l`, `f`, `c`, `s`, `p` or `pp`";
    refuses_after("f 1 1 1 1 0 1 0 1\nmy.jpg", &format!("4:1: {message}"));
    refuses(
        "nff\nversion 2.0\n",
        "1:1: a file of Sense8 WorldToolKit, which begins with `nff`, expected the Neutral File Format of ray tracers",
    );
}

#[test]
fn bytes_that_are_no_text_are_no_harm() {
    load([b"# caf\xe9\n", BEFORE.as_bytes()].concat(), Import::default());
    refuses(b"\xff\xfe", "1:1: unknown entity `\u{fffd}\u{fffd}`, expected `b`, `v`, `l`, `f`, `c`, `s`, `p` or `pp`");
}

#[test]
fn which_files_are_nff() {
    for name in ["a.nff", "A.NFF", "a.nff.gz"] {
        assert!(is_nff(b"{", name), "{name}");
    }
    for text in ["v\n", "\n # x\n b 0 0 0", "nff\nversion 2", "\u{feff}s 0 0 0 1"] {
        assert!(is_nff(text.as_bytes(), "<stdin>"), "{text}");
        assert!(!is_nff(text.as_bytes(), "a.json.gz"), "{text}");
    }
    for text in ["", "{\"format\": 1}", "# only a comment", "vertex"] {
        assert!(!is_nff(text.as_bytes(), "<stdin>"), "{text}");
    }
}

#[test]
fn the_scene_reads_back_from_json() {
    let scene = scene(&format!("{BEFORE}l 1 2 3 s 0 0 0 -1 c 0 0 0 1 0 0 1 2 p 4 0 0 0 1 0 0 1 1 0 0 1 0"));
    let again = crate::scene::file::check(scene.to_json().as_bytes(), "my.json").unwrap().scene;
    assert_eq!(again, scene);
}
