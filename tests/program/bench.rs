//! `raywalk bench` on the command line, with tiny inputs. No test looks at a time.

use assert_cmd::Command;
use serde_json::Value;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

#[track_caller]
fn bench(arguments: &[&str]) -> (i32, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_raywalk"));
    let output = command.arg("bench").args(arguments).output().expect("it runs");
    let text = |bytes| String::from_utf8(bytes).expect("text");
    (output.status.code().expect("no signal"), text(output.stdout), text(output.stderr))
}

/// The objects of lines of JSON.
fn lines(text: &str) -> Vec<Value> {
    text.lines().map(|line| serde_json::from_str(line).expect("an object a line")).collect()
}

fn bytes(letters: &str, head: &[u32], floats: &[f32]) -> Vec<u8> {
    let head = head.iter().flat_map(|number| number.to_le_bytes());
    let floats = floats.iter().flat_map(|number| number.to_le_bytes());
    letters.bytes().chain(head).chain(floats).collect()
}

const RAY: [f32; 8] = [0.25, 0.25, 3.0, 0.0, 0.0, 0.0, -1.0, f32::INFINITY];
const BESIDE: [f32; 8] = [9.0, 0.25, 3.0, 0.0, 0.0, 0.0, -1.0, f32::INFINITY];

/// A folder with spheres and rays: `two.spheres`, `two.primary.rays`, `two.shadow.rays`.
fn files() -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let write = |name: &str, bytes: Vec<u8>| fs::write(folder.path().join(name), bytes).expect("written");
    let spheres = [9.0, 9.0, 0.0, 1.0, 0.25, 0.25, 0.0, 1.0];
    write("two.spheres", bytes("RWSPHR01", &[2, 0], &spheres));
    write("two.primary.rays", bytes("RWRAYS01", &[0, 2, 1, 0, 2, 0], &[RAY, BESIDE].concat()));
    write("two.shadow.rays", bytes("RWRAYS01", &[1, 0, 0, 0, 2, 0], &[RAY, BESIDE].concat()));
    folder
}

fn stem(folder: &Path) -> String {
    folder.join("two").to_str().expect("text").to_owned()
}

#[test]
fn rays_are_measured_and_dumped() {
    let folder = files();
    let (stem, dump) = (stem(folder.path()), folder.path().to_str().expect("text"));
    let (code, text, errors) = bench(&["rays", &stem, "--passes", "2", "--format", "json", "--dump", dump]);
    assert_eq!((code, errors.as_str()), (0, ""));
    let lines = lines(&text);
    assert_eq!(lines.len(), 2 + 8, "{text}");
    for (line, threads) in lines.iter().zip([1, 2]) {
        assert_eq!((&line["engine"], &line["scene"]), (&"raywalk".into(), &"two".into()));
        assert_eq!((&line["build_threads"], &line["primitives"]), (&threads.into(), &2.into()));
        assert!(line["build_s"].is_f64() && line["cores"].is_u64() && line["version"].is_string());
    }
    let figures = [("primary", 2.0), ("shadow", 0.0)].into_iter().flat_map(|(rays, tsum)| {
        [("single", 1), ("single", 2), ("batch", 1), ("batch", 2)].map(|(mode, threads)| (rays, mode, threads, tsum))
    });
    for (line, (rays, mode, threads, tsum)) in lines[2..].iter().zip(figures) {
        assert_eq!((&line["rays"], &line["threads"], &line["n"]), (&rays.into(), &threads.into(), &2.into()));
        assert_eq!((&line["hits"], &line["tsum"], &line["passes"]), (&1.into(), &tsum.into(), &2.into()));
        assert!(line["mrays_median"].is_f64() && line["mrays_best"].is_f64() && line["mrays_per_cpu_s"].is_f64());
        assert_eq!(line["mode"], mode);
    }
    let dumped = |name: &str| fs::read(folder.path().join(name)).expect("dumped");
    let hits = |hits: [(f32, u32); 2]| -> Vec<u8> {
        hits.iter().flat_map(|(t, primitive)| [t.to_le_bytes(), primitive.to_le_bytes()].concat()).collect()
    };
    assert_eq!(dumped("two.primary.raywalk.hits"), hits([(2.0, 1), (f32::INFINITY, u32::MAX)]));
    assert_eq!(dumped("two.shadow.raywalk.hits"), hits([(0.0, 0), (0.0, u32::MAX)]));
}

#[test]
fn rays_as_a_table() {
    let folder = files();
    let stem = stem(folder.path());
    let (code, text, _) = bench(&["rays", &stem, &stem, "--threads", "1", "--passes", "1"]);
    assert_eq!(code, 0);
    assert!(text.starts_with("raywalk ") && text.contains("two: 2 primitives"), "{text}");
    assert_eq!(text.lines().filter(|line| line.trim_start().starts_with("primary")).count(), 4, "{text}");
    let (_, csv, _) = bench(&["rays", &stem, "--threads", "1", "--passes", "1", "--format", "csv"]);
    let columns: Vec<_> = csv.lines().map(|line| line.split(',').count()).collect();
    assert_eq!(columns, [14; 5], "{csv}");
}

#[test]
fn files_of_rays_that_are_no_good() {
    let folder = files();
    let (path, stem) = (folder.path(), stem(folder.path()));
    let refuses = |arguments: &[&str], expected: &str| {
        let (code, text, errors) = bench(&[&["rays"], arguments].concat());
        assert_eq!((code, text.as_str()), (2, ""), "{errors}");
        assert!(errors.contains(expected), "{errors}");
    };
    refuses(&["/no/such/stem"], "no such scene");
    refuses(&[&stem, "--dump", "/no/such/folder"], "expected a folder");
    refuses(&[&stem, "--threads", "0"], "--threads");
    refuses(&[&stem, "--seconds", "-1"], "--seconds");
    refuses(&[], "STEM");
    fs::write(path.join("two.shadow.rays"), b"RWRAYS01\0").expect("written");
    refuses(&[&stem], "two.shadow.rays: ends within its head, expected 32 bytes, found 9");
    fs::write(path.join("two.mesh"), b"").expect("written");
    refuses(&[&stem], "two.mesh: is empty");
    for name in ["two.shadow.rays", "two.primary.rays", "two.mesh"] {
        fs::remove_file(path.join(name)).expect("removed");
    }
    refuses(&[&stem], "no rays");
}

#[test]
fn overhead_is_measured_in_every_way() {
    let (code, text, errors) = bench(&["overhead", "textbook", "--size", "3x2", "--pairs", "1", "--format", "json"]);
    assert_eq!((code, errors.as_str()), (0, ""));
    let found: Value = serde_json::from_str(&text).expect("JSON");
    let scene = &found["scenes"][0];
    assert_eq!((&scene["scene"], &scene["pixels"]), (&"textbook".into(), &6.into()));
    assert!(scene["events_per_pixel"].as_f64().expect("a number") > 10.0);
    let ways: Vec<_> = scene["costs"].as_array().expect("a list").iter().map(|cost| &cost["way"]).collect();
    assert_eq!(ways, ["silent", "counter", "recorder", "f32", "decimal:3", "decimal:3+recorder", "perturbed"]);
    assert!(found["machine"]["cores"].is_u64());
    for format in ["text", "csv"] {
        let (code, text, _) = bench(&["overhead", "textbook", "--size", "3x2", "--pairs", "1", "--format", format]);
        assert_eq!(code, 0);
        assert!(text.contains("decimal:3+recorder"), "{text}");
    }
    assert_eq!(bench(&["overhead", "no-such-scene"]).0, 2);
}

#[test]
fn scaling_has_a_row_for_each_step() {
    let call = ["scaling", "textbook", "--spheres", "1000", "--size", "8x6", "--passes", "1", "--format"];
    let (code, text, errors) = bench(&[&call[..], &["json"]].concat());
    assert_eq!((code, errors.as_str()), (0, ""));
    let found: Value = serde_json::from_str(&text).expect("JSON");
    let spheres = found["spheres"].as_array().expect("a list");
    assert_eq!(spheres.iter().map(|row| row["spheres"].as_u64()).collect::<Vec<_>>(), [Some(100), Some(1000)]);
    assert!(spheres[0].get("growth").is_none() && spheres[1]["growth"].is_f64());
    let sizes = found["picture"]["sizes"].as_array().expect("a list");
    assert_eq!(sizes.iter().map(|row| row["width"].as_u64()).collect::<Vec<_>>(), [2, 4, 8].map(Some));
    let (_, text, _) = bench(&[&call[..], &["text"]].concat());
    assert!(text.contains("pictures of textbook") && text.contains("8x6"), "{text}");
    let (_, csv, _) = bench(&[&call[..], &["csv"]].concat());
    assert!(csv.lines().all(|line| line.split(',').count() == 8) && csv.lines().count() == 1 + 4 + 3, "{csv}");
    assert_eq!(bench(&["scaling", "--spheres", "99"]).0, 2);
}

#[test]
fn methods_of_sampling_are_compared_and_drawn() {
    let folder = tempfile::tempdir().expect("a folder");
    let chart = folder.path().join("chart.svg");
    let path = chart.to_str().expect("text");
    let call = ["error", "figure-17", "penumbra", "--size", "8x6", "--runs", "2", "--reference", "sobol:16"];
    let methods = ["--sampling", "none", "--sampling", "adaptive:threshold=0.1,depth=2", "--target", "0.9"];
    let (code, text, errors) = bench(&[&call[..], &methods, &["--format", "json", "--chart", path]].concat());
    assert_eq!((code, errors.as_str()), (0, ""));
    let found: Value = serde_json::from_str(&text).expect("JSON");
    for (scene, name) in found["scenes"].as_array().expect("a list").iter().zip(["figure-17", "penumbra"]) {
        assert_eq!((&scene["scene"], &scene["reference"]), (&name.into(), &"sobol:16".into()));
        assert!(scene["reference_error"].as_f64().expect("a number") > 0.0);
        let outcomes = scene["outcomes"].as_array().expect("a list");
        assert_eq!(outcomes[1]["sampling"], "adaptive:threshold=0.1,depth=2");
        assert_eq!(outcomes[0]["samples_per_pixel"], 1.0);
        assert!(outcomes[0]["rmse"]["median"].as_f64().expect("a number") > 0.0);
        assert!(outcomes.iter().any(|outcome| outcome["is_on_front"] == true) && scene["best"].is_string());
    }
    let svg = fs::read_to_string(&chart).expect("drawn");
    assert!(svg.starts_with("<svg ") && svg.ends_with("</svg>\n") && svg.matches("<polyline").count() == 2);
    assert_eq!(svg.matches("<g").count(), svg.matches("</g>").count());
    let (_, text, _) = bench(&[&call[..], &methods].concat());
    assert!(text.contains("best for an error of at most 0.9: "), "{text}");
    let (_, csv, _) = bench(&[&call[..], &methods, &["--format", "csv"]].concat());
    assert_eq!(csv.lines().count(), 1 + 4, "{csv}");
}

#[test]
fn calls_for_errors_that_mean_nothing() {
    let refuses = |arguments: &[&str], expected: &str| {
        let (code, text, errors) = bench(&[&["error", "textbook"], arguments].concat());
        assert_eq!((code, text.as_str()), (2, ""), "{errors}");
        assert!(errors.contains(expected), "{errors}");
    };
    refuses(&["--target", "0"], "expected an error above 0");
    refuses(&["--arithmetic", "--runs", "3"], "cannot be used with");
    refuses(&["--sampling", "sobel:4"], "did you mean `sobol`?");
}

/// Two pictures with their samples in the same places err alike: what they differ by tells nothing.
#[test]
fn the_error_of_a_reference_without_chance_is_unknown() {
    let call = ["error", "penumbra", "--size", "8x6", "--runs", "1", "--sampling", "none", "--format"];
    for reference in ["none", "regular:2", "shared:2", "adaptive:threshold=0.1,depth=2"] {
        let call = [&[
            "error",
            "penumbra",
            "--size",
            "4x3",
            "--runs",
            "1",
            "--sampling",
            "none",
            "--reference",
            reference,
            "--format",
        ][..]]
        .concat();
        let (code, text, errors) = bench(&[&call[..], &["text"]].concat());
        assert_eq!((code, errors.as_str()), (0, ""));
        assert!(text.contains(&format!("two pictures with {reference}, whose own error is unknown")), "{text}");
        let (_, json, _) = bench(&[&call[..], &["json"]].concat());
        let found: Value = serde_json::from_str(&json).expect("JSON");
        assert_eq!(found["scenes"][0].get("reference_error"), None);
        assert!(!json.contains("null"), "{json}");
        let (_, csv, _) = bench(&[&call[..], &["csv"]].concat());
        let row = csv.lines().nth(1).unwrap_or_default();
        assert!(row.replace('"', "").contains(&format!(",{reference},,none,")), "{csv}");
    }
    let (_, text, _) = bench(&[&call[..], &["text", "--reference", "sobol:4"]].concat());
    assert!(text.contains("whose own error is ") && !text.contains("unknown"), "{text}");
}

#[test]
fn flat_figures_are_compared_with_exact_areas() {
    let call = ["--size", "12x8", "--runs", "1", "--sampling", "regular:1", "--sampling", "regular:16", "--format"];
    for exact in [&["--reference", "exact"][..], &[]] {
        let (code, text, errors) = bench(&[&["error", "figure-17", "figure-20"], &call[..], &["json"], exact].concat());
        assert_eq!((code, errors.as_str()), (0, ""));
        let found: Value = serde_json::from_str(&text).expect("JSON");
        for scene in found["scenes"].as_array().expect("a list") {
            assert_eq!((&scene["reference"], scene.get("reference_error")), (&"exact".into(), None));
            let error = |k: usize| scene["outcomes"][k]["rmse"]["median"].as_f64().expect("a number");
            // Some edges fall together with the grid of cells, so that even few cells see them right.
            assert!(error(0) > 0.01 && error(1) < error(0) / 5.0, "{} {}", error(0), error(1));
        }
    }
    let (_, text, _) = bench(&[&["error", "figure-18"], &call[..], &["text"]].concat());
    assert!(text.contains("figure-18, 12 x 8 pixels, against the exact areas\n"), "{text}");
    let (code, text, errors) = bench(&["error", "textbook", "--reference", "exact"]);
    assert_eq!((code, text.as_str()), (2, ""));
    assert!(errors.contains("scene `textbook` has no exact reference: object `plane`"), "{errors}");
    assert!(errors.contains("figure-17, figure-18, figure-19, figure-20"), "{errors}");
    // Where there is none, and none is asked for, there are two pictures.
    let (_, text, _) = bench(&["error", "textbook", "--size", "2x2", "--runs", "1", "--sampling", "none"]);
    assert!(text.contains("two pictures with sobol:1024"), "{text}");
}

#[test]
fn limits_of_the_ray_tree_are_compared() {
    let call = ["hall-of-mirrors", "--size", "12x9", "--format"];
    let (code, text, errors) = bench(&[&["error", "--depths"], &call[..], &["json"]].concat());
    assert_eq!((code, errors.as_str()), (0, ""));
    let found: Value = serde_json::from_str(&text).expect("JSON");
    let scene = &found["scenes"][0];
    let rungs = scene["rungs"].as_array().expect("a list");
    let own = rungs.len() as u64 - 1;
    assert_eq!(scene["reference"]["max_depth"], own + 2);
    let of = |key: &str| rungs.iter().map(|rung| rung[key].as_f64().expect("a number")).collect::<Vec<_>>();
    assert_eq!(of("max_depth"), (0..=own).map(|depth| depth as f64).collect::<Vec<_>>());
    assert!(of("rmse").windows(2).all(|pair| pair[1] <= pair[0]), "{:?}", of("rmse"));
    assert!(of("rays_per_pixel").windows(2).all(|pair| pair[1] >= pair[0]) && rungs[0].get("bound").is_none());

    let (_, text, _) = bench(&[&["error", "--cutoffs"], &call[..], &["json"]].concat());
    let found: Value = serde_json::from_str(&text).expect("JSON");
    let rungs = found["scenes"][0]["rungs"].as_array().expect("a list");
    assert_eq!(rungs.len(), 7);
    for rung in rungs {
        let number = |key: &str| rung[key].as_f64().expect("a number");
        // No picture loses more than is said.
        assert!(number("worst") <= number("bound"), "{rung}");
    }
    assert!(rungs[0]["worst"].as_f64().is_some_and(|worst| worst > 0.0), "{text}");
    assert_eq!((&rungs[6]["worst"], &rungs[6]["cutoff"]), (&0.0.into(), &0.0.into()));
    for (ladder, columns) in [("--depths", 9), ("--cutoffs", 10)] {
        let (_, csv, _) = bench(&[&["error", ladder], &call[..], &["csv"]].concat());
        assert!(csv.lines().all(|line| line.split(',').count() == columns), "{csv}");
        let (_, text, _) = bench(&[&["error", ladder], &call[..], &["text"]].concat());
        assert!(text.starts_with("hall-of-mirrors, against "), "{text}");
        // Of what depth limits lose there is no bound.
        for word in ["bound", "cutoff"] {
            assert_eq!(text.contains(word), ladder == "--cutoffs", "{text}");
            assert_eq!(csv.contains(word), ladder == "--cutoffs", "{csv}");
        }
    }
    assert_eq!(bench(&["error", "--depths", "--cutoffs"]).0, 2);
    assert_eq!(bench(&["error", "--depths", "--runs", "3"]).0, 2);
}

#[test]
fn the_own_error_of_a_reference_is_spoken_of_where_it_has_one() {
    let of = |arguments: &[&str]| {
        let call = ["error", "figure-17", "--size", "4x3", "--runs", "1", "--sampling", "none"];
        let (code, text, errors) = bench(&[&call[..], arguments].concat());
        assert_eq!((code, errors.as_str()), (0, ""));
        text
    };
    let own = "errors no greater than the reference's own say nothing";
    let exact = of(&["--reference", "exact"]);
    assert!(exact.ends_with("\nerrors in units of the scene's white\n"), "{exact}");
    assert!(of(&["--reference", "sobol:16"]).ends_with(&format!("white; {own}\n")));
    let (code, _, errors) = bench(&["error", "figure-17", "--reference", "foo"]);
    assert_eq!(code, 2);
    assert!(errors.contains("unknown sampling `foo`, expected `exact`, `none`, `regular`"), "{errors}");
    // As a method to compare it is none.
    let (_, _, errors) = bench(&["error", "figure-17", "--sampling", "exact"]);
    assert!(errors.contains("unknown sampling `exact`, expected `none`, `regular`"), "{errors}");
}

/// A picture without an error has a place in the chart.
#[test]
fn a_scene_without_anything_is_drawn() {
    let folder = tempfile::tempdir().expect("a folder");
    let (scene, chart) = (folder.path().join("empty.json"), folder.path().join("chart.svg"));
    let text =
        r#"{"format": "raywalk-scene/1", "camera": {"position": [0, 0, 5], "direction": [0, 0, -1]}, "objects": []}"#;
    fs::write(&scene, text).expect("written");
    let (scene, chart) = (scene.to_str().expect("text"), chart.to_str().expect("text"));
    let (code, ..) = bench(&[
        "error",
        scene,
        "--size",
        "4x3",
        "--runs",
        "1",
        "--reference",
        "none",
        "--sampling",
        "none",
        "--chart",
        chart,
    ]);
    assert_eq!(code, 0);
    assert!(!fs::read_to_string(chart).expect("drawn").contains("NaN"));
}

/// A square between a disk lamp and a floor, with an error of their quadrature: the example of docs/benchmarks.md.
#[test]
fn penumbras_are_an_exact_reference() {
    let scene = "docs/benchmarks/square-shadow.json";
    let call =
        ["error", scene, "--reference", "exact", "--runs", "1", "--sampling", "sobol:64", "--sampling", "sobol:65536"];
    let (code, text, errors) = bench(&[&call[..], &["--size", "4x3", "--format", "json"]].concat());
    assert_eq!((code, errors.as_str()), (0, ""));
    let found: Value = serde_json::from_str(&text).expect("JSON");
    let found = &found["scenes"][0];
    let own = found["reference_error"].as_f64().expect("an error of the reference");
    assert!(own > 0.0 && own < 1e-6, "{own:e}");
    assert_eq!(found["reference"], "exact");
    // What a sample sees lies between 0 and 1. Its variance is 1/4 at most (Popoviciu), so that n independent ones err by 1/(2√n) at
    // the most, and Sobol's points err less. A reference that is off by more than twice that, 0.4 %, can't pass.
    for (k, bound) in [(0, 1.0 / 16.0), (1, 1.0 / 512.0)] {
        let error = found["outcomes"][k]["rmse"]["median"].as_f64().expect("a number");
        assert!(error < bound && error > own, "{k}: {error:e}, {bound:e}, {own:e}");
    }
    let (code, text, _) = bench(&[&call[..], &["--size", "2x1"]].concat());
    assert_eq!(code, 0);
    assert!(text.contains("against the exact penumbra, integrated with an error of about "), "{text}");
    assert!(text.ends_with("; errors no greater than the reference's own say nothing\n"), "{text}");
}
