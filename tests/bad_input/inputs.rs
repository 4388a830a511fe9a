//! A result is never one of the files that it is made of, by whatever name, and no two results are one file.

use crate::run::{answer, names_in, raywalk, raywalk_after};
use std::collections::BTreeMap;
use std::fs::{self, OpenOptions};
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::Command;

const SCENE: &str = r#"{"format": "raywalk-scene/1", "camera": {"position": [0.4, 0.7, 5], "direction": [0, 0, -1], "resolution": [8, 6]},
 "lights": [{"name": "F", "point": {"position": [1, 1, 5]}}], "frames": {"count": 2, "duration": 1},
 "objects": [{"name": "m", "shape": {"mesh": {"path": "meshes/m.obj"}}}, {"name": "n", "shape": {"mesh": {"path": "n.obj"}}}]}"#;

const MESH: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n";

/// A raw mesh of one triangle, and a file of one ray.
fn raw() -> [Vec<u8>; 2] {
    let floats = |numbers: &[f32]| numbers.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<_>>();
    let (mut mesh, mut rays) = (b"RWMESH01".to_vec(), b"RWRAYS01".to_vec());
    mesh.extend([3_u64.to_le_bytes(), 1_u64.to_le_bytes()].concat());
    mesh.extend(floats(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0]));
    mesh.extend([0_u32, 1, 2].map(u32::to_le_bytes).concat());
    rays.extend([0_u32, 1, 1, 0].map(u32::to_le_bytes).concat());
    rays.extend(1_u64.to_le_bytes());
    rays.extend(floats(&[0.2, 0.2, 1.0, 0.0, 0.0, 0.0, -1.0, f32::INFINITY]));
    [mesh, rays]
}

/// A folder with inputs of every kind.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    for name in ["meshes", "dump", "other"] {
        fs::create_dir(at(name)).expect("a folder");
    }
    for (name, text) in [("s.json", SCENE), ("meshes/m.obj", MESH), ("n.obj", MESH)] {
        fs::write(at(name), text).expect("written");
    }
    let [mesh, rays] = raw();
    for name in ["r", "other/r"] {
        fs::write(at(&format!("{name}.mesh")), &mesh).expect("written");
        fs::write(at(&format!("{name}.primary.rays")), &rays).expect("written");
    }
    for call in [
        "trace s.json --pixel 4,3 -o a.ndjson",
        "render s.json -q -o a.png",
        "render s.json -q -o b.png --exposure 1",
        "render s.json -q -o 1.part --shard 1/2",
        "render s.json -q -o 2.part --shard 2/2",
        "trace s.json -q --region 0,0,4,4 --shard 1/2 -o 1.ndjson",
        "trace s.json -q --region 0,0,4,4 --shard 2/2 -o 2.ndjson",
    ] {
        answer(&mut raywalk(folder.path(), &call.split(' ').collect::<Vec<_>>())).ends_with(0);
    }
    folder
}

/// Every file in a folder and in those below it, with its bytes.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    for name in names_in(folder) {
        let path = folder.join(&name);
        if path.is_dir() {
            found.extend(files(&path).into_iter().map(|(below, bytes)| (format!("{name}/{below}"), bytes)));
        } else {
            found.insert(name, fs::read(&path).expect("a file"));
        }
    }
    found
}

/// Every command with a result: the call, where the result goes, and what it is made of.
const CALLS: &[(&str, &str, &[&str])] = &[
    ("render s.json -q -o out.png", "out.png", OF_SCENE),
    ("render s.json -q -o out.exr --layers depth", "out.exr", OF_SCENE),
    ("render s.json -q -o out.png --layers depth,object", "out.object.png", OF_SCENE),
    ("render s.json -q -o out.pfm --resume", "out.pfm", OF_SCENE),
    ("render s.json -q -o out.pfm --resume", "out.pfm.checkpoint", OF_SCENE),
    ("render s.json -q -o out-#.png --frames 1-2", "out-1.png", OF_SCENE),
    ("render s.json -q -o out-#.png --frames 1-2", "out-2.png", OF_SCENE),
    ("render s.json -q -o out.part --shard 1/2", "out.part", OF_SCENE),
    ("render s.json -q -o out.part --shard 1/2 --resume", "out.part.checkpoint", OF_SCENE),
    ("trace s.json --pixel 4,3 -o out", "out", OF_SCENE),
    ("trace s.json --pixel 4,3 -o out --format svg", "out", OF_SCENE),
    ("trace s.json --pixel 4,3 -o out --view vectors --format svg", "out", OF_SCENE),
    ("trace s.json --pixel 4,3 -o out --causes --arithmetic f32", "out", OF_SCENE),
    ("trace s.json -q --region 0,0,4,4 -o out", "out", OF_SCENE),
    ("trace s.json -q --region 0,0,4,4 -o out --shard 1/2", "out", OF_SCENE),
    ("trace a.ndjson -o out --format text", "out", &["a.ndjson"]),
    ("scene convert s.json -o out.json", "out.json", OF_SCENE),
    ("walk s.json --screenshot out.svg", "out.svg", OF_SCENE),
    ("walk a.ndjson --screenshot out.svg", "out.svg", &["a.ndjson"]),
    ("merge -q 1.part 2.part -o out.png", "out.png", &["1.part", "2.part"]),
    ("merge -q 1.ndjson 2.ndjson -o out", "out", &["1.ndjson", "2.ndjson"]),
    ("diff a.png b.png -o out.png", "out.png", &["a.png", "b.png"]),
    ("bench error -q textbook s.json --size 8x6 --runs 1 --sampling none --chart out.svg", "out.svg", OF_SCENE),
    ("bench rays r --passes 1 --threads 1 --dump dump", "dump/r.primary.raywalk.hits", &["r.mesh", "r.primary.rays"]),
];

const OF_SCENE: &[&str] = &["s.json", "meshes/m.obj", "n.obj"];

#[test]
fn no_result_is_an_input() {
    let folder = folder();
    let mut tries = 0;
    for (call, result, inputs) in CALLS {
        let place = folder.path().join(result);
        let words: Vec<_> = call.split(' ').collect();
        for input in *inputs {
            for is_hard in [true, false] {
                let target = folder.path().join(input);
                match is_hard {
                    true => fs::hard_link(&target, &place).expect("a hard link"),
                    false => symlink(&target, &place).expect("a link"),
                }
                let before = files(folder.path());
                let said = answer(&mut raywalk(folder.path(), &words));
                let first = (*result == "out-2.png").then(|| fs::remove_file(folder.path().join("out-1.png")));
                assert_eq!(said.code, Some(2), "{call} over {input}: {}", said.message);
                let expected = format!("error: {result}: is the input, which would be overwritten\n");
                assert_eq!((said.message.as_str(), first.is_none_or(|gone| gone.is_ok())), (expected.as_str(), true));
                assert!(files(folder.path()) == before, "{call} over {input} changed {:?}", names_in(folder.path()));
                fs::remove_file(&place).expect("the link");
                tries += 1;
            }
        }
    }
    assert!(tries > 100, "{tries}");
}

#[test]
fn an_input_by_its_own_name_and_by_a_way_around() {
    let folder = folder();
    let before = files(folder.path());
    for call in [
        "scene convert s.json -o s.json",
        "scene convert ./s.json -o meshes/../s.json",
        "scene convert meshes/../s.json -o s.json",
        "trace s.json --pixel 4,3 -o meshes/m.obj",
        "trace dump/../s.json --pixel 4,3 -o ./n.obj",
        "diff a.png dump/../b.png -o b.png",
        "merge 1.ndjson 2.ndjson -o dump/../2.ndjson",
    ] {
        let words: Vec<_> = call.split(' ').collect();
        answer(&mut raywalk(folder.path(), &words)).fails(2, ": is the input, which would be overwritten");
    }
    // What comes by standard input lies somewhere, too, and so does what goes to standard output.
    for (before, call, expected) in [
        ("exec < s.json", "scene convert - -o s.json", "error: s.json: is the input"),
        ("exec < a.ndjson", "trace - --format text -o a.ndjson", "error: a.ndjson: is the input"),
        ("exec >> s.json", "scene convert s.json", "error: s.json: is the input and standard output, too"),
        (
            "exec >> meshes/m.obj",
            "trace s.json --pixel 4,3",
            "error: meshes/m.obj: is the input and standard output, too",
        ),
    ] {
        let words: Vec<_> = call.split(' ').collect();
        answer(&mut raywalk_after(before, folder.path(), &words)).fails(2, expected);
    }
    assert!(files(folder.path()) == before);
}

/// What isn't read may be overwritten.
#[test]
fn other_files_are_overwritten() {
    let folder = folder();
    for call in [
        "scene generate knot --level 1 -o n.obj",
        "trace textbook --pixel 1,1 -o a.ndjson",
        "scene convert s.json -o a.ndjson",
        "scene convert s.json -o new.json",
    ] {
        answer(&mut raywalk(folder.path(), &call.split(' ').collect::<Vec<_>>())).ends_with(0);
    }
}

#[test]
fn no_two_results_are_one_file() {
    let folder = folder();
    for (link, to, call) in [
        ("out.depth.png", "out.png", "render s.json -q -o out.png --layers depth"),
        ("out.depth.png", "out.object.png", "render s.json -q -o out.png --layers depth,object"),
        ("out.png.checkpoint", "out.png", "render s.json -q -o out.png --resume"),
        ("out.part.checkpoint", "out.part", "render s.json -q -o out.part --shard 1/2 --resume"),
        ("out-2.png", "out-1.png", "render s.json -q -o out-#.png --frames 1-2"),
    ] {
        let words: Vec<_> = call.split(' ').collect();
        // The first of the two is not there, or it is.
        for is_there in [false, true] {
            let _ = fs::remove_file(folder.path().join(to));
            symlink(to, folder.path().join(link)).expect("a link");
            if is_there {
                OpenOptions::new().create(true).append(true).open(folder.path().join(to)).expect("a file");
            }
            let said = answer(&mut raywalk(folder.path(), &words));
            assert!(
                said.code == Some(2) && said.message.contains(": is another result of this call"),
                "{call}: {}",
                said.message
            );
            fs::remove_file(folder.path().join(link)).expect("the link");
            let _ = fs::remove_file(folder.path().join(to));
        }
    }
    let twice = ["bench", "rays", "r", "other/r", "--passes", "1", "--threads", "1", "--dump", "dump"];
    answer(&mut raywalk(folder.path(), &twice)).fails(2, "r.primary.raywalk.hits: is another result of this call");
    assert_eq!(names_in(&folder.path().join("dump")), [""; 0]);
}

/// What is only printed goes nowhere that it is read from, either: `rays` would read its own answers forever.
#[test]
fn nothing_is_printed_into_what_is_read() {
    let folder = tempfile::tempdir().expect("a folder");
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes");
    for name in ["mesh.json", "knot.obj"] {
        fs::copy(scenes.join(name), folder.path().join(name)).expect("a scene");
    }
    fs::write(folder.path().join("q.ndjson"), "{\"o\":[0,0,9],\"d\":[0,0,-1]}\n").expect("written");
    let trace = ["trace", "textbook", "--pixel", "160,120", "-o", "a.ndjson"];
    answer(&mut raywalk(folder.path(), &trace)).ends_with(0);
    for (call, printed_into) in [
        ("rays mesh.json <q.ndjson", "q.ndjson"),
        ("rays mesh.json <q.ndjson", "knot.obj"),
        ("scene show mesh.json", "mesh.json"),
        ("walk a.ndjson --plain", "./a.ndjson"),
        ("walk - --plain <a.ndjson", "a.ndjson"),
        ("walk mesh.json --plain", "knot.obj"),
        ("diff a.ndjson a.ndjson", "a.ndjson"),
        ("trace a.ndjson --format text", "a.ndjson"),
        ("render mesh.json --size 4x4 -q -o z.png --stats json", "mesh.json"),
        ("bench overhead mesh.json --pairs 1 --size 4x4", "knot.obj"),
    ] {
        let before = fs::read(folder.path().join(printed_into)).expect("an input");
        let mut shell = Command::new("sh");
        let line = format!("timeout 60 \"$0\" {call} >>{printed_into}");
        shell.args(["-c", &line, env!("CARGO_BIN_EXE_raywalk")]).current_dir(folder.path());
        let output = shell.output().expect("it runs");
        assert_eq!(output.status.code(), Some(2), "{line}: {}", String::from_utf8_lossy(&output.stderr));
        assert!(fs::read(folder.path().join(printed_into)).expect("an input") == before, "{line}");
    }
}
