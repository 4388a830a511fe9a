//! NFF files: those of the Standard Procedural Databases, where they are at hand, and the command line.

use crate::shared::shared;
use assert_cmd::Command;
use flate2::{Compression, write::GzEncoder};
use glam::DVec3;
use raywalk::files::FileError;
use raywalk::render::{Settings, render};
use raywalk::scene::build;
use raywalk::scene::file::nff::Import;
use raywalk::scene::file::schema::{Sampling, SceneFile, Shape};
use raywalk::scene::file::{self, Loaded};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

/// The folder of the databases, which are no part of this repository; says so where it is absent.
fn databases() -> Option<PathBuf> {
    shared("nff")
}

fn load(path: &Path) -> Result<Loaded, FileError> {
    file::read(path)
}

#[test]
fn the_databases_have_the_counts_of_their_manifest() {
    let Some(folder) = databases() else { return };
    let manifest = std::fs::read_to_string(folder.join("MANIFEST.tsv")).expect("the manifest");
    let mut lines = manifest.lines();
    let header: Vec<_> = lines.next().expect("a header").split('\t').collect();
    let mut files = 0;
    for line in lines {
        let row: Vec<_> = line.split('\t').collect();
        let column = |name: &str| row[header.iter().position(|column| *column == name).expect("the column")];
        let number = |name: &str| column(name).parse::<usize>().expect("a number");
        let loaded = load(&folder.join(column("file"))).unwrap_or_else(|error| panic!("{}", error.report(false)));
        let scene = loaded.scene;
        let count = |is: fn(&Shape) -> bool| scene.objects.iter().filter(|object| is(&object.shape)).count();
        let found = [
            count(|shape| matches!(shape, Shape::Sphere(_))),
            count(|shape| matches!(shape, Shape::Cone(_) | Shape::Cylinder(_))),
            count(|shape| !is_curved(shape) && !has_normals(shape)),
            count(|shape| !is_curved(shape) && has_normals(shape)),
            scene.objects.len(),
            scene.materials.len(),
            scene.lights.len(),
            scene.objects.iter().map(|object| corners(&object.shape)).max().unwrap_or(0),
        ];
        let expected =
            ["spheres", "cones_cylinders", "polygons", "patches", "primitives", "fills", "lights", "largest_polygon"];
        assert_eq!(found, expected.map(number), "{line}");
        assert_eq!(loaded.warnings, [], "{line}");
        files += 1;
    }
    assert!(files > 30, "{files} files");
}

fn is_curved(shape: &Shape) -> bool {
    matches!(shape, Shape::Sphere(_) | Shape::Cone(_) | Shape::Cylinder(_))
}

fn has_normals(shape: &Shape) -> bool {
    match shape {
        Shape::Triangle(triangle) => triangle.normals.is_some(),
        Shape::Polygon(polygon) => polygon.normals.is_some(),
        _ => false,
    }
}

fn corners(shape: &Shape) -> usize {
    match shape {
        Shape::Triangle(_) => 3,
        Shape::Polygon(polygon) => polygon.vertices.len(),
        _ => 0,
    }
}

#[test]
fn irregular_files_are_understood_or_refused_clearly() {
    let Some(folder) = databases() else { return };
    let folder = folder.join("other-nff");
    let textured = load(&folder.join("ManyEarthsNotJustOne.nff")).expect("a good file");
    assert_eq!((textured.scene.objects.len(), textured.warnings.len()), (10, 1));
    let plain = load(&folder.join("WithCamera.nff")).expect("a good file");
    assert_eq!((plain.scene.objects.len(), plain.warnings.len()), (4, 0));
    assert_eq!(plain.scene.camera.resolution, [640, 480]);
    let refused = [
        ("cone-seven-numbers.nff", ":3:31: expected a number for the refractive index of `f`, found `cantfindme.png`"),
        ("cylinder.nff", ":10:14: the file has no view, expected `v`"),
        ("positionTest.nff", ":10:1: expected a number for Shine of `f`, found `s`"),
        ("spheres.nff", ":5:1: `s` comes before the first fill, expected `f` before it"),
    ];
    for (name, expected) in refused {
        let error = load(&folder.join(name)).expect_err("a bad file");
        assert_eq!(error.exit_code(), 2);
        assert!(error.to_string().ends_with(expected), "{error}");
    }
}

/// How many rays of the grid through the pixel corners there are, and how many meet something.
fn eye_rays(mut file: SceneFile) -> (u64, u64) {
    file.lights.clear();
    file.tracing.max_depth = 0;
    file.sampling = Sampling::Shared { n: 1 };
    let scene = build(&file, &Default::default()).expect("a supported scene");
    let settings = Settings { threads: 2, counts_rays: true, ..Settings::whole(&scene) };
    let rendered = render(&scene, &settings, |_| (), &AtomicBool::new(false)).expect("a picture");
    let counts = rendered.counts.expect("counts").statistics(0, Default::default(), 0);
    let json = serde_json::to_value(counts).expect("JSON");
    let number = |key: &str| json[key]["camera"].as_u64().expect("a number");
    (number("rays"), number("hits"))
}

#[track_caller]
fn is_hit(name: &str, expected: u64) {
    let Some(folder) = databases() else { return };
    let loaded = load(&folder.join(name)).expect("a good file");
    let (rays, hits) = eye_rays(loaded.scene);
    assert_eq!(rays, 263_169);
    let difference = hits.abs_diff(expected) as f64 / expected as f64;
    assert!(difference <= 0.0005, "{name}: {hits} eye rays hit, published {expected}");
}

#[test]
fn as_many_eye_rays_hit_tetra_6_as_published() {
    is_hit("tetra-6.nff.gz", 49_788);
}

#[test]
fn every_eye_ray_hits_balls_4_as_published() {
    is_hit("balls-4.nff.gz", 263_169);
}

#[test]
fn eye_rays_lie_where_the_format_says() {
    let Some(folder) = databases() else { return };
    let file = load(&folder.join("shells-1.nff")).expect("a good file").scene;
    let expected = spheres_met(&file, 45.0);
    let (rays, hits) = eye_rays(file);
    assert_eq!(rays, 513 * 513);
    assert!(10_000 < expected && expected < 200_000, "{expected}");
    // A ray that grazes may fall on either side.
    assert!(hits.abs_diff(expected) <= 2, "{hits} eye rays hit, expected {expected}");
}

/// How many of the rays of the format's description hit one of the spheres: ray k of 0..X lies at
/// −t − t/(X − 1) + k·2t/(X − 1), t = tan(angle/2).
fn spheres_met(file: &SceneFile, angle: f64) -> u64 {
    let spheres: Vec<_> = file.objects.iter().map(|object| sphere(&object.shape)).collect();
    let from = DVec3::from(file.camera.position);
    let ahead = DVec3::from(file.camera.direction()).normalize();
    let right = ahead.cross(file.camera.up.into()).normalize();
    let up = right.cross(ahead);
    let side = file.camera.resolution[0];
    assert_eq!(file.camera.resolution, [side; 2]);
    let t = libm::tan(angle.to_radians() / 2.0);
    let step = t / f64::from(side - 1);
    let place = |k: u32| -t - step + f64::from(k) * 2.0 * step;
    let meets = |x: f64, y: f64| {
        let direction = ahead + right * x - up * y;
        let is_met = |(center, radius): &(DVec3, f64)| {
            let to_center = *center - from;
            let along = to_center.dot(direction);
            along > 0.0 && along * along > (to_center.length_squared() - radius * radius) * direction.length_squared()
        };
        spheres.iter().any(is_met)
    };
    let row = |y: u32| (0..=side).filter(|x| meets(place(*x), place(y))).count() as u64;
    (0..=side).map(row).sum()
}

fn sphere(shape: &Shape) -> (DVec3, f64) {
    match shape {
        Shape::Sphere(sphere) => (sphere.center.into(), sphere.radius),
        _ => panic!("expected a sphere, found {}", shape.key()),
    }
}

/// Two spheres, the second one seen from its inside only.
const SAMPLE: &str = "# our own sample\nb .1 .2 .3\nv from 0 0 9 at 0 0 0 up 0 1 0 angle 45 hither 1 resolution 16 12\n\
                      l 5 5 9\nf 1 .5 .2 .8 .25 30 0 0\ns 0 0 0 1\nf .2 .5 1 .5 0 100000 0 0\ns 2 0 0 -1.5\n";

fn raywalk(arguments: &[&str]) -> Command {
    let mut command = Command::cargo_bin("raywalk").expect("the program");
    command.args(arguments).env_remove("NO_COLOR");
    command
}

#[track_caller]
fn prints(arguments: &[&str]) -> String {
    let output = raywalk(arguments).output().expect("it runs");
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("UTF-8")
}

#[track_caller]
fn says(arguments: &[&str], expected: &str) {
    let output = raywalk(arguments).output().expect("it runs");
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {message}");
    assert!(message.contains(expected), "{arguments:?}: expected `{expected}` in: {message}");
}

/// A folder with the sample as `sample.nff` and as `packed.nff.gz`, and their paths.
fn samples() -> (tempfile::TempDir, String, String) {
    let folder = tempfile::tempdir().expect("a folder");
    let (plain, packed) = (folder.path().join("sample.nff"), folder.path().join("sample.nff.gz"));
    std::fs::write(&plain, SAMPLE).expect("a file");
    let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(SAMPLE.as_bytes()).expect("in memory");
    std::fs::write(&packed, encoder.finish().expect("in memory")).expect("a file");
    let name = |path: PathBuf| path.to_str().expect("UTF-8").to_owned();
    (folder, name(plain), name(packed))
}

#[test]
fn every_command_takes_nff_packed_or_not() {
    let (folder, plain, packed) = samples();
    assert_eq!(prints(&["scene", "check", &packed]), "sample: ok, 2 objects, 1 light, 2 materials\n");
    let shown = prints(&["scene", "show", &plain]);
    assert_eq!(prints(&["scene", "show", &packed]), shown);
    assert_eq!(prints(&["scene", "convert", &packed]), shown);
    let piped = raywalk(&["scene", "show", "-"]).write_stdin(SAMPLE).output().expect("it runs");
    assert_eq!(String::from_utf8_lossy(&piped.stdout), shown.replace("\"sample\"", "\"stdin\""));

    let json = folder.path().join("sample.json");
    let json = json.to_str().expect("UTF-8");
    assert_eq!(prints(&["scene", "convert", &plain, "-o", json]), "");
    assert_eq!(prints(&["scene", "show", json]), shown);
    let log = prints(&["trace", &packed, "--pixel", "8,6"]);
    assert_eq!(prints(&["trace", json, "--pixel", "8,6"]), log);
    assert_eq!(
        prints(&["walk", &plain, "--pixel", "8,6"]),
        prints(&["trace", json, "--pixel", "8,6", "--format", "text"])
    );
}

#[test]
fn the_angle_is_measured_as_asked() {
    let (_folder, plain, _) = samples();
    assert!(prints(&["scene", "show", &plain, "--nff-angle", "edges"]).contains("\"vertical_fov\": 45,"));
    let x_of = |arguments: &[&str]| {
        let text =
            prints(&[&["trace", &plain, "--pixel", "0,0", "--format", "text", "--digits", "12"], arguments].concat());
        let computed = text.lines().find(|line| line.contains("[pixel.x]")).expect("a place");
        let x = computed.split("   [").next().and_then(|chain| chain.rsplit(" = ").next()).expect("a number");
        x.parse::<f64>().expect("a number")
    };
    let t = libm::tan(45_f64.to_radians() / 2.0);
    let near = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-11, "{found} {expected}");
    near(x_of(&["--nff-angle", "edges"]), -t / 12.0 * 15.0);
    near(x_of(&[]), -t / 11.0 * 15.0);
    near(x_of(&["--size", "5x5"]), -t);
    near(x_of(&["--size", "5x5", "--pixel-grid", "corners"]), -t - t / 4.0);
    near(x_of(&["--size", "5x5", "--pixel-grid", "corners", "--nff-angle", "edges"]), -t);
}

#[test]
fn the_grid_of_corners_counts_its_rays() {
    let (folder, plain, _) = samples();
    let picture = folder.path().join("picture.pfm");
    let picture = picture.to_str().expect("UTF-8");
    let rays = |arguments: &[&str]| {
        let stats = prints(&[&["render", &plain, "-o", picture, "--stats", "json"], arguments].concat());
        let stats: serde_json::Value = serde_json::from_str(&stats).expect("JSON");
        stats["rays"]["camera"].as_u64().expect("a number")
    };
    assert_eq!(rays(&[]), 16 * 12);
    assert_eq!(rays(&["--pixel-grid", "corners"]), 17 * 13);
    assert_eq!(rays(&["--sampling", "shared:1"]), 17 * 13);
    assert_eq!(rays(&["--sampling", "shared:2"]), 33 * 25);
    assert_eq!(rays(&["--pixel-grid", "corners", "--crop", "3,4,8,6"]), 6 * 3);
    let log = prints(&["trace", &plain, "--pixel", "3,4", "--pixel-grid", "corners"]);
    assert!(log.contains("\"sampling\":{\"shared\":{\"n\":1}}"), "{log}");
    let text = prints(&["trace", &plain, "--pixel", "3,4", "--pixel-grid", "corners", "--format", "text"]);
    assert!(
        text.starts_with(
            "sample · pixel 3,4 · f64 · recursive, depth 4 · shared: n = 1\nsample 1: s_x = 0, s_y = 0, w_s = 1\n"
        ),
        "{text}"
    );

    says(
        &["trace", &plain, "--pixel", "3,4", "--sampling", "shared:2", "--pixel-grid", "corners"],
        "--pixel-grid corners",
    );
    says(&["trace", &plain, "--pixel", "3,4", "--sampling", "shared:0"], "from 1 to 1024");
    says(&["trace", &plain, "--pixel", "3,4", "--sampling", "shred:1"], "unknown sampling `shred`");
}

#[test]
fn faces_seen_from_behind_are_shown_when_asked() {
    let (_folder, plain, _) = samples();
    let text = |arguments: &[&str]| {
        prints(&[&["trace", &plain, "--ray", "2,0,9,0,0,-1", "--format", "text"], arguments].concat())
    };
    // The front of an inward sphere is its far side.
    let (front, both) = (text(&[]), text(&["--two-sided"]));
    let distance = |text: &str| text.lines().find(|line| line.contains("[sphere.t ")).map(str::to_owned);
    assert!(distance(&front).expect("a hit").contains("= 10.500"), "{front}");
    assert!(distance(&both).expect("a hit").contains("= 7.500"), "{both}");
}

#[test]
fn problems_are_placed_in_the_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("bad.nff");
    std::fs::write(&path, SAMPLE.replace("s 0 0 0 1", "shpere 0 0 0 1")).expect("a file");
    let path = path.to_str().expect("UTF-8");
    says(&["scene", "check", path], "bad.nff:6:1: unknown entity `shpere`, did you mean `s`?");
    says(&["scene", "check", path], "\n6 | shpere 0 0 0 1\n  | ^^^^^^");
    let packed = folder.path().join("cut.nff.gz");
    std::fs::write(&packed, b"\x1f\x8b\x08\x00\x00").expect("a file");
    let packed = packed.to_str().expect("UTF-8");
    says(&["scene", "check", packed], "cut.nff.gz: the gzip data end too early, expected a whole file");
}

#[test]
fn an_import_is_the_same_however_it_is_asked_for() {
    let by_name = file::check(SAMPLE.as_bytes(), "a.nff").expect("a good file");
    let by_content = file::check_as(SAMPLE.as_bytes(), "a", &Import::default()).expect("a good file");
    assert_eq!(by_name.scene, by_content.scene);
}
