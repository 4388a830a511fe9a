//! The arithmetic ladder: errors against f64, rung by rung.

use crate::support::scene_of;
use assert_cmd::Command;
use raywalk::log::What;
use raywalk::record::{self, Arithmetic};
use raywalk::scene::{Scene, build, builtin, file};
use raywalk::study::ladder::{DECIMALS, Rung, ladder};

fn result(scene: &Scene, arithmetic: Arithmetic) -> [f64; 3] {
    match record::pixel(scene, [0, 0], arithmetic).events.last().map(|event| &event.what) {
        Some(What::Result { color }) => *color,
        _ => panic!("a log ends with the result"),
    }
}

/// A picture of one pixel, which is the numeric example itself.
#[test]
fn a_rung_has_the_error_of_the_log() {
    let text = builtin::text("textbook").expect("built in").replace("[321, 241]", "[1, 1]");
    let scene = scene_of(text.as_bytes(), "one-pixel");
    let exact = result(&scene, Arithmetic::F64);
    let rungs = ladder(&scene, 1).expect("rendered");
    assert_eq!(rungs.len(), DECIMALS.count() + 2);
    for rung in &rungs[..rungs.len() - 1] {
        let arithmetic: Arithmetic = rung.arithmetic.parse().expect("a name");
        let found = result(&scene, arithmetic);
        let errors = [0, 1, 2].map(|k| (found[k] - exact[k]) / scene.output.white);
        let worst = errors.iter().fold(0.0, |worst: f64, error| worst.max(error.abs()));
        assert!((rung.deviation.worst - worst).abs() <= 1e-15, "{rung:?}");
        let rmse = (errors.iter().map(|error| error * error).sum::<f64>() / 3.0).sqrt();
        assert!((rung.deviation.rmse - rmse).abs() <= 1e-15 && rung.seconds > 0.0, "{rung:?}");
        assert_eq!(rung.deviation.visible, f64::from(u8::from(worst > 1.0 / 255.0)), "{rung:?}");
    }
    // By hand with three decimals: 394.134 instead of 393.054, which is more than one level of 255.
    assert!((rungs[1].arithmetic == "decimal:3") && rungs[1].deviation.visible == 1.0);
    assert!(rungs[1].deviation.worst >= 1.07 / 255.0);
}

#[test]
fn more_digits_are_better() {
    let text = builtin::text("figure-6").expect("built in");
    let mut file = file::check(text.as_bytes(), "figure-6").expect("good").scene;
    file.camera.resolution = [24, 18];
    let scene = build(&file, &Default::default()).expect("built");
    let rungs = ladder(&scene, 0).expect("rendered");
    let rmse = |name: &str| rungs.iter().find(|rung: &&Rung| rung.arithmetic == name).expect("a rung").deviation.rmse;
    // Three decimals more are a thousand times better; a hundred times is not left to chance.
    for (few, many) in [("decimal:3", "decimal:6"), ("decimal:6", "decimal:9"), ("decimal:9", "decimal:12")] {
        assert!(rmse(many) * 100.0 < rmse(few), "{few} {} {many} {}", rmse(few), rmse(many));
    }
    // An f32 has 24 binary digits, some seven decimals of numbers near 1.
    assert!(rmse("f32") < rmse("decimal:4") && rmse("f32") > rmse("decimal:10"));
    assert!(rmse("f64") > 0.0 && rmse("f64") < 1e-13, "{}", rmse("f64"));
}

#[test]
fn the_command_prints_every_rung() {
    let bench = |arguments: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_raywalk"));
        command.args(["bench", "error"]).args(arguments).output().expect("it runs")
    };
    let csv = bench(&["--arithmetic", "textbook", "--size", "5x4", "--format", "csv"]);
    let text = String::from_utf8(csv.stdout).expect("text");
    let lines: Vec<_> = text.lines().collect();
    assert_eq!(lines.len(), 1 + 16, "{text}");
    assert_eq!(lines[0], "scene,arithmetic,rmse,worst,visible,seconds");
    assert!(lines[1].starts_with("textbook,decimal:2,") && lines[16].starts_with("textbook,f64,"));
    let json = bench(&["--arithmetic", "textbook", "--size", "5x4", "--format", "json"]);
    let json: serde_json::Value = serde_json::from_slice(&json.stdout).expect("JSON");
    assert_eq!(json["scenes"][0]["rungs"][14]["arithmetic"], "f32");
    assert_eq!(bench(&["--arithmetic", "no-such-scene"]).status.code(), Some(2));
}
