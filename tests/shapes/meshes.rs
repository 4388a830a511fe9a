//! Meshes as users of the command line meet them: where they are found, what is wrong with them, what rays hit.

use assert_cmd::Command;
use std::fs;
use std::path::Path;

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

fn raywalk(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::cargo_bin("raywalk").expect("the program");
    command.args(arguments).env_remove("NO_COLOR").current_dir(folder);
    command
}

/// A folder with a scene whose second object is the mesh `path`.
fn folder(path: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = format!(
        "{{\"format\": \"raywalk-scene/1\",\n \"camera\": {{\"position\": [0.3, 0.2, 5], \"direction\": [0, 0, -1]}},\n \
         \"objects\": [\n  {{\"name\": \"ball\", \"shape\": {{\"sphere\": {{\"center\": [50, 0, -9], \"radius\": 1}}}}}},\n  \
         {{\"name\": \"mesh\", \"shape\": {{\"mesh\": {{\"path\": \"{path}\"}}}}}}]}}\n"
    );
    fs::write(folder.path().join("scene.json"), scene).expect("written");
    fs::write(folder.path().join("square.obj"), SQUARE).expect("written");
    folder
}

/// What standard output and standard error hold, of a call that ends with this code.
#[track_caller]
fn ends(code: i32, folder: &Path, arguments: &[&str]) -> (String, String) {
    let output = raywalk(folder, arguments).output().expect("it runs");
    let texts = [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).expect("UTF-8"));
    assert_eq!(output.status.code(), Some(code), "{arguments:?}: {}", texts[1]);
    texts.into()
}

#[test]
fn meshes_are_found_beside_the_scene() {
    let folder = folder("square.obj");
    let elsewhere = tempfile::tempdir().expect("a folder");
    let scene = folder.path().join("scene.json");
    ends(0, elsewhere.path(), &["scene", "check", scene.to_str().expect("UTF-8")]);
    // Standard input has no folder of its own.
    let text = fs::read(&scene).expect("the scene");
    let piped =
        |place: &Path| raywalk(place, &["scene", "check", "-"]).write_stdin(text.clone()).output().expect("it runs");
    assert!(piped(folder.path()).status.success());
    assert_eq!(piped(elsewhere.path()).status.code(), Some(2));
}

#[test]
fn rays_meet_triangles_by_their_numbers() {
    let folder = folder("square.obj");
    let rays = concat!(
        "{\"o\":[0.75,0.25,2],\"d\":[0,0,-2]}\n",
        "{\"o\":[0.25,0.75,2],\"d\":[0,0,-2]}\n",
        "{\"o\":[0.5,0.5,2],\"d\":[0,0,-2]}\n",
        "{\"o\":[0.25,0.75,0],\"d\":[0,0,-1],\"from\":\"mesh\",\"from_primitive\":1}\n",
        "{\"o\":[0.25,0.75,0],\"d\":[0,0,-1],\"from\":\"mesh\"}\n",
    );
    let output = raywalk(folder.path(), &["rays", "scene.json"]).write_stdin(rays).output().expect("it runs");
    let replies = String::from_utf8(output.stdout).expect("UTF-8");
    let replies: Vec<serde_json::Value> =
        replies.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
    for (reply, primitive) in replies.iter().zip([0, 1, 0]) {
        assert_eq!(reply["hit"]["object"], "mesh");
        assert_eq!(reply["hit"]["primitive"], primitive);
        assert_eq!(reply["hit"]["t"], 1.0);
        assert_eq!(reply["hit"]["normal"], serde_json::json!([0.0, 0.0, 1.0]));
    }
    assert_eq!(replies[3]["hit"], serde_json::Value::Null);
    assert!(replies[4]["error"].as_str().is_some_and(|error| error.contains("from_primitive")));
}

#[test]
fn the_digest_of_a_scene_covers_its_meshes() {
    let folder = folder("square.obj");
    let digest = || {
        let (log, _) = ends(0, folder.path(), &["trace", "scene.json", "--ray", "0,0,5,0,0,1"]);
        let header: serde_json::Value = serde_json::from_str(log.lines().next().expect("a header")).expect("JSON");
        header["scene"]["digest"].as_str().expect("a digest").to_owned()
    };
    let before = digest();
    assert_eq!(digest(), before);
    fs::write(folder.path().join("square.obj"), SQUARE.replace("v 1 1 0", "v 1 1 1")).expect("written");
    assert_ne!(digest(), before);
}

#[test]
fn a_log_shows_a_test_for_each_triangle() {
    let folder = folder("square.obj");
    let (log, _) = ends(0, folder.path(), &["trace", "scene.json", "--ray", "0.25,0.75,2,0,0,-1"]);
    assert!(log.contains("\"enter\":{\"test\":{\"object\":\"mesh\",\"triangle\":1}}"), "{log}");
}

#[test]
fn faces_with_a_notch_are_cut_inside_their_outline() {
    let folder = folder("dart.obj");
    // The notch is over against no corner that a fan could begin at.
    fs::write(folder.path().join("dart.obj"), "v 2 2 0\nv 1 0.5 0\nv 0 2 0\nv 1 0 0\nf 1 2 3 4\n").expect("written");
    let asks =
        "{\"o\":[1,1.2,5],\"d\":[0,0,-1]}\n{\"o\":[1,0.3,5],\"d\":[0,0,-1]}\n{\"o\":[0.3,1.5,5],\"d\":[0,0,-1]}\n";
    let output = raywalk(folder.path(), &["rays", "scene.json"]).write_stdin(asks).output().expect("it runs");
    let answers = String::from_utf8(output.stdout).expect("UTF-8");
    let met: Vec<bool> = answers.lines().map(|answer| answer.contains("\"object\":\"mesh\"")).collect();
    assert_eq!(met, [false, true, true], "{answers}");
}

#[test]
fn coordinates_have_the_limit_of_scenes() {
    let folder = folder("far.obj");
    fs::write(folder.path().join("far.obj"), "v 0 0 0\nv 1e160 0 0\nv 0 1 0\nf 1 2 3\n").expect("written");
    let (_, message) = ends(2, folder.path(), &["scene", "check", "scene.json"]);
    assert!(
        message.contains("far.obj:2:") && message.contains("expected coordinates from -1e100 to 1e100"),
        "{message}"
    );
}

#[test]
fn a_converted_scene_that_leaves_its_meshes_behind_is_warned_of() {
    let folder = folder("square.obj");
    let (_, beside) = ends(0, folder.path(), &["scene", "convert", "scene.json", "-o", "copy.json"]);
    assert_eq!(beside, "");
    fs::create_dir(folder.path().join("out")).expect("created");
    let (_, away) = ends(0, folder.path(), &["scene", "convert", "scene.json", "-o", "out/copy.json"]);
    assert!(away.contains("warning: the meshes `square.obj`"), "{away}");
}

#[test]
fn generated_meshes_read_back() {
    let folder = folder("ball.obj");
    for what in ["knot", "icosphere"] {
        ends(0, folder.path(), &["scene", "generate", what, "--level", "2", "-o", "ball.obj"]);
        let (_, warnings) = ends(0, folder.path(), &["scene", "check", "scene.json"]);
        assert!(!warnings.contains("warning:"), "{warnings}");
    }
}

#[test]
fn generated_flakes_are_scenes() {
    let folder = folder("square.obj");
    for (level, objects) in [("1", "12 objects"), ("4", "11112 objects")] {
        ends(0, folder.path(), &["scene", "generate", "sphere-flake", "--level", level, "-o", "flake.json"]);
        let (out, warnings) = ends(0, folder.path(), &["scene", "check", "flake.json"]);
        // Its lights are beside the eye; nothing else is worth a warning.
        let of_lights = |warning: &str| warning.contains("is outside the field of view");
        assert!(warnings.lines().filter(|line| line.starts_with("warning:")).all(of_lights), "{warnings}");
        assert!(out.contains(objects), "{out}");
    }
    ends(2, folder.path(), &["scene", "generate", "sphere-flake", "--level", "8"]);
    let (_, message) = ends(2, folder.path(), &["scene", "generate", "sphere-flake", "--level", "7"]);
    assert!(message.contains("--level: must be from 0 to 6 for a sphere-flake, found 7"), "{message}");
}
