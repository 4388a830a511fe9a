//! Inputs of which twice as much takes twice the time and twice the bytes of output, and not four times.

use crate::run::{limited_answer, raywalk};
use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::time::Duration;

/// A program built for tests is several times as slow as a release. What is quadratic takes minutes of these inputs.
const MOST_TIME: Duration = Duration::from_secs(30);

const COLOR: &str = "[0.1,0.2,0.3]";

/// The lines of a log, while it is made.
struct Made {
    lines: String,
    events: usize,
    nodes: usize,
}

impl Made {
    fn new() -> Made {
        let header = concat!(
            r#"{"log":"raywalk-log/1","version":"0.1.0","scene":{"name":"x","digest":"blake3:00"},"pixel":[1,1],"#,
            r#""arithmetic":"f64","tracing":{"algorithm":"recursive","max_depth":1,"specular":"half_vector","#,
            r#""sphere_method":"geometric","cutoff":0.0,"two_sided":true},"sampling":{"none":{}},"#,
            r#""objects":["plane"],"lights":["F"]}"#
        );
        Made { lines: format!("{header}\n"), events: 0, nodes: 0 }
    }

    fn event(&mut self, node: usize, rest: &str) {
        self.events += 1;
        writeln!(self.lines, "{{\"at\":{},\"node\":{node},{rest}}}", self.events).expect("memory");
    }

    fn enter(&mut self, parent: usize, step: &str) -> usize {
        self.nodes += 1;
        self.event(self.nodes, &format!("\"enter\":{step},\"parent\":{parent}"));
        self.nodes
    }

    fn note(&mut self, node: usize, name: &str, value: &str) {
        self.event(node, &format!("\"note\":\"{name}\",\"value\":{value}"));
    }

    fn leave(&mut self, node: usize) {
        self.event(node, "\"leave\":{}");
    }

    fn finished(mut self) -> String {
        self.event(0, &format!("\"result\":{{\"color\":{COLOR}}}"));
        writeln!(self.lines, "{{\"end\":{{\"events\":{}}}}}", self.events).expect("memory");
        self.lines
    }
}

/// Rays in rays, each with a weighted sum.
fn nested(depth: usize) -> String {
    let mut made = Made::new();
    let mut open = vec![0];
    for level in 0..depth {
        let kind = if level == 0 { "camera" } else { "reflected" };
        let ray = made.enter(open[level], &format!("{{\"ray\":{{\"kind\":\"{kind}\",\"depth\":{level}}}}}"));
        made.note(ray, "ray.length", "1.5");
        made.note(ray, "ray.direction", "[0.6,0.8,0]");
        open.push(ray);
    }
    while let Some(ray) = open.pop().filter(|ray| *ray != 0) {
        let combine = made.enter(ray, "{\"combine\":{}}");
        made.note(combine, "combine.color", COLOR);
        made.leave(combine);
        made.leave(ray);
    }
    made.finished()
}

/// How many bytes a call prints.
fn printed(folder: &Path, call: &[&str]) -> usize {
    let answer = limited_answer(&mut raywalk(folder, call), MOST_TIME);
    assert!(matches!(answer.code, Some(0 | 1)), "{call:?}: {}", answer.message);
    answer.out.len()
}

#[test]
fn views_of_deep_logs_grow_with_the_log() {
    let folder = tempfile::tempdir().expect("a folder");
    for depth in [500, 1000, 2000] {
        fs::write(folder.path().join(format!("{depth}.log")), nested(depth)).expect("written");
        let other = nested(depth).replace("0.2,0.3", "0.25,0.35").replace("1.5", "1.75");
        fs::write(folder.path().join(format!("{depth}.other")), other).expect("written");
    }
    let grows = |of: &dyn Fn(usize) -> usize, what: &str| {
        let [small, middle, large] = [500, 1000, 2000].map(of);
        assert!(middle * 10 <= small * 22 && large * 10 <= middle * 22, "{what}: {small}, {middle}, {large} bytes");
    };
    for format in ["text", "html", "markdown", "latex", "dot", "svg", "mermaid", "obj"] {
        let of = |depth: usize| printed(folder.path(), &["trace", &format!("{depth}.log"), "--format", format]);
        grows(&of, format);
    }
    grows(&|depth| printed(folder.path(), &["walk", "--plain", &format!("{depth}.log")]), "walk");
    let of = |depth: usize| printed(folder.path(), &["diff", &format!("{depth}.log"), &format!("{depth}.other")]);
    grows(&of, "diff");
}

/// Logs of many events of a kind in one node.
fn many(kind: &str, count: usize) -> String {
    let mut made = Made::new();
    let ray = made.enter(0, "{\"ray\":{\"kind\":\"camera\",\"depth\":0}}");
    let shade = made.enter(ray, "{\"shade\":{\"object\":\"plane\"}}");
    let light = made.enter(shade, "{\"light\":{\"light\":\"F\"}}");
    let shadow = "{\"ray\":{\"kind\":\"shadow\",\"depth\":0,\"light\":\"F\"}}";
    match kind {
        "occluded" => {
            let shadow = made.enter(light, shadow);
            (0..count).for_each(|_| made.event(shadow, "\"mark\":{\"occluded\":{\"object\":\"plane\"}}"));
            made.leave(shadow);
        }
        "transmittances" => {
            for _ in 0..count / 2 {
                let shadow = made.enter(light, shadow);
                made.leave(shadow);
                made.note(light, "shadow.transmittance", COLOR);
            }
        }
        _ => {}
    }
    made.leave(light);
    if kind == "locals" {
        for _ in 0..count / 10 {
            let light = made.enter(shade, "{\"light\":{\"light\":\"F\"}}");
            made.note(light, "shade.n_dot_l", "0.5");
            made.leave(light);
            made.note(shade, "shade.local", COLOR);
        }
    }
    if kind == "lights" {
        for _ in 0..count / 8 {
            let light = made.enter(shade, "{\"light\":{\"light\":\"F\"}}");
            made.note(light, "shade.n_dot_l", "0.5");
            made.leave(light);
        }
        made.note(shade, "shade.local", COLOR);
    }
    made.leave(shade);
    if kind == "combines" {
        for _ in 0..count / 4 {
            let combine = made.enter(ray, "{\"combine\":{}}");
            let given = format!("\"note\":\"combine.local\",\"value\":{COLOR},\"given\":{{\"shade.local\":{COLOR}}}");
            made.event(combine, &given);
            made.leave(combine);
        }
    }
    made.leave(ray);
    made.finished()
}

#[test]
fn many_events_of_a_kind_in_one_node_take_their_share_of_time() {
    let folder = tempfile::tempdir().expect("a folder");
    for kind in ["occluded", "transmittances", "locals", "lights", "combines"] {
        fs::write(folder.path().join("a.log"), many(kind, 80_000)).expect("written");
        fs::write(folder.path().join("b.log"), many(kind, 80_000).replace("0.2,0.3", "0.25,0.35")).expect("written");
        for call in
            [&["walk", "--plain", "a.log"][..], &["trace", "a.log", "--format", "html"], &["diff", "a.log", "b.log"]]
        {
            printed(folder.path(), call);
        }
    }
}

#[test]
fn lights_behind_surfaces_in_one_place_are_checked_up_to_a_bound() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut scene = String::from("v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 40\nhither 1\nresolution 64 48\n");
    (0..6000).for_each(|at| scene += &format!("l 0 0 -{}\n", at + 9));
    scene += "f 1 1 1 0.5 0.5 20 0 1\n";
    scene += &"p 3\n-9 -9 0\n9 -9 0\n0 9 0\n".repeat(6000);
    fs::write(folder.path().join("c.nff"), scene).expect("written");
    let answer = limited_answer(&mut raywalk(folder.path(), &["scene", "check", "c.nff"]), MOST_TIME).ends_with(0);
    // How many pixels were enough, or that they were too few.
    let is_told = answer.message.contains("seen through") || answer.message.contains("isn't known");
    assert!(is_told && !answer.message.contains("3072 pixels"), "{}", answer.message);
}

/// A scene whose objects are meshes of these paths.
fn scene_of(paths: impl Iterator<Item = String>) -> String {
    let object = |(number, path): (usize, String)| {
        format!(r#"{{"name":"o{number}","shape":{{"mesh":{{"path":"{path}"}}}},"material":"m"}}"#)
    };
    let objects: Vec<_> = paths.enumerate().map(object).collect();
    let (camera, materials) = (
        r#"{"position":[0.1,0.05,-2],"direction":[0,0,-1],"resolution":[1,1]}"#,
        r#"{"m":{"weights":{"transmitted":0.5}},"o":{"diffuse":[1,1,1]}}"#,
    );
    format!(
        r#"{{"format":"raywalk-scene/1","camera":{camera},"materials":{materials},"lights":[{{"name":"L","point":{{"position":[0.1,0.05,8]}}}}],
        "objects":[{{"name":"floor","shape":{{"plane":{{"coefficients":[0,0,1,3]}}}},"material":"o"}},{}]}}"#,
        objects.join(",")
    )
}

#[test]
fn triangles_in_one_place_take_their_share_of_time() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("s.json"), scene_of(["m.obj".to_owned()].into_iter())).expect("written");
    let count = 64_000;
    let alike = format!("v -3 -3 0\nv 3 -3 0\nv 0 3 0\n{}", "f 1 2 3\n".repeat(count));
    let at_one_edge: String = (0..count).map(|at| format!("v 0.{at:05} 3 0\nf 1 2 {}\n", at + 3)).collect();
    for mesh in [alike, format!("v -3 -3 0\nv 3 -3 0\n{at_one_edge}")] {
        fs::write(folder.path().join("m.obj"), mesh).expect("written");
        let call = ["render", "s.json", "-o", "a.ppm", "-q"];
        limited_answer(&mut raywalk(folder.path(), &call), MOST_TIME).ends_with(0);
    }
}

#[test]
fn a_mesh_under_many_names_is_held_once() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::create_dir(folder.path().join("x")).expect("a folder");
    let mesh = raywalk::scene::generate::icosphere(5);
    raywalk::scene::generate::write_obj(&mesh, &mut fs::File::create(folder.path().join("m.obj")).expect("a file"))
        .expect("written");
    let paths = (0..300).map(|number| format!("{}x/../m.obj", "./".repeat(number)));
    fs::write(folder.path().join("s.json"), scene_of(paths)).expect("written");
    let call = ["render", "s.json", "-o", "a.ppm", "-q"];
    let answer = limited_answer(&mut raywalk(folder.path(), &call), MOST_TIME).ends_with(0);
    assert!(answer.peak < 100 << 10, "{} KiB", answer.peak);
}
