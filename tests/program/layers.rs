//! `render --layers`, OpenEXR, and what is packed by its name.

#![allow(clippy::unwrap_used)]

use crate::bitmap::open;
use crate::calls::{prints, raywalk, says};
use crate::support;
use exr::prelude::*;
use raywalk::log::{Decision, What};
use raywalk::record::{self, Arithmetic};
use raywalk::render::layers::{Layer, Layered, Planes};
use raywalk::render::{Canvas, Job, Settings, TileOrder, render, render_job};
use raywalk::scene::{Sampling, Scene};
use std::fs;
use std::path::Path;
use std::sync::atomic::AtomicBool;

const CROP: [u32; 4] = [150, 110, 170, 128];

fn settings() -> Settings {
    Settings { crop: CROP, arithmetic: Arithmetic::F64, threads: 2, counts_rays: true, order: TileOrder::Rows }
}

fn layered(scene: &Scene, crop: [u32; 4]) -> Layered {
    let settings = Settings { crop, ..settings() };
    match render_job(Job::Layers(Planes::default()), scene, &settings, |_| (), &AtomicBool::new(false)).unwrap().film {
        Canvas::Layers(layered) => layered,
        other => panic!("layers, not {other:?}"),
    }
}

/// The colours are those of a rendering to the last bit, and the counts of all pixels are those of its statistics.
#[test]
fn layers_belong_to_the_picture() {
    for sampling in [Sampling::Center {}, Sampling::Sobol { n: 4 }, Sampling::Adaptive { threshold: 0.1, depth: 2 }] {
        let mut scene = support::scene("glass-and-mirror");
        scene.sampling = sampling;
        let layered = layered(&scene, CROP);
        let rendered = render(&scene, &settings(), |_| (), &AtomicBool::new(false)).unwrap();
        assert_eq!(layered.film().pixels(), rendered.film.pixels(), "{sampling:?}");
        if matches!(sampling, Sampling::Adaptive { .. }) {
            // Pixels that share corners cost less than each by itself.
            continue;
        }
        let counts = rendered.counts.unwrap();
        let sum = |of: fn(&raywalk::render::layers::PixelFacts) -> u64| layered.pixels().iter().map(of).sum::<u64>();
        assert_eq!(sum(|seen| seen.rays), counts.rays());
        assert_eq!(sum(|seen| seen.samples), counts.samples());
        assert_eq!(sum(|seen| seen.primitive_tests), counts.primitive_tests());
        assert_eq!(sum(|seen| seen.bounds_tests), counts.bounds_tests());
    }
}

/// What the layers say of a pixel is what its log says.
#[test]
fn layers_say_what_the_log_says() {
    for name in ["glass-and-mirror", "mesh", "motion-blur"] {
        let mut scene = support::scene(name);
        scene.sampling = Sampling::Center {};
        let layered = layered(&scene, CROP);
        let mut hits = 0;
        for (seen, place) in layered.pixels().iter().zip(0_u32..) {
            let width = CROP[2] - CROP[0];
            let pixel = [CROP[0] + place % width, CROP[1] + place / width];
            let log = record::pixel(&scene, pixel, Arithmetic::F64);
            let first = log.events.iter().find_map(|event| match event.what {
                What::Mark(Decision::Nearest { object }) => Some(Some(object)),
                What::Mark(Decision::Background) => Some(None),
                _ => None,
            });
            assert_eq!(Some(seen.object), first, "{name} {pixel:?}");
            assert_eq!((seen.samples, seen.error), (1, None));
            assert_eq!(seen.depth.is_some(), seen.object.is_some());
            if seen.object.is_some() {
                hits += 1;
                assert!((seen.normal.length() - 1.0).abs() < 1e-12, "{name} {pixel:?}: {:?}", seen.normal);
            }
        }
        assert!(hits > 50, "{name}: {hits}");
    }
}

/// The depth of a plane across the view is known, and so is the standard error of an edge.
#[test]
fn depth_and_error_are_those_of_geometry() {
    let text = r#"{"format": "raywalk-scene/1", "camera": {"position": [0, 0, 5], "direction": [0, 0, -1], "vertical_fov": 40,
        "resolution": [200, 200]}, "background": [1, 1, 1], "sampling": {"random": {"n": 400}}, "tracing": {"max_depth": 0},
        "materials": {"black": {"ambient": [0, 0, 0], "diffuse": [0, 0, 0], "specular": [0, 0, 0]}},
        "objects": [{"name": "half", "material": "black", "shape": {"box": {"min": [-9, -9, -1], "max": [0.0002, 9, 0]}}}]}"#;
    let scene = support::scene_of(text.as_bytes(), "half");
    let crop = [99, 100, 101, 101];
    let layered = layered(&scene, crop);
    let [left, right] = [layered.pixels()[0], layered.pixels()[1]];
    assert!((left.depth.unwrap() - 5.0).abs() < 1e-3 && left.error == Some(0.0), "{left:?}");
    assert!(right.error.unwrap() > 0.0, "{right:?}");
    // Of n samples a part p sees white: s/√n is √(p(1 − p)/(n − 1)).
    let p = right.color.x;
    assert!((right.error.unwrap() - (p * (1.0 - p) / 399.0).sqrt()).abs() < 1e-12, "{right:?}");
}

fn channel(path: &Path, name: &str) -> Vec<f32> {
    let image = read().no_deep_data().largest_resolution_level().all_channels().first_valid_layer().all_attributes();
    let image = image.from_file(path).unwrap();
    let channel = image.layer_data.channel_data.list.into_iter().find(|channel| channel.name.eq(name));
    channel.unwrap_or_else(|| panic!("no channel {name}")).sample_data.values_as_f32().collect()
}

#[test]
fn an_exr_file_holds_the_picture_and_its_layers() {
    let folder = tempfile::tempdir().unwrap();
    let [exr, pfm, plain] = ["all.exr", "all.pfm", "plain.exr"].map(|name| folder.path().join(name));
    let crop = CROP.map(|side| side.to_string()).join(",");
    for (path, layers) in [(&exr, Some("depth,normal,object")), (&pfm, None), (&plain, None)] {
        let mut call = vec!["render", "glass-and-mirror", "--quiet", "--crop", &crop, "-o", path.to_str().unwrap()];
        call.extend(layers.into_iter().flat_map(|layers| ["--layers", layers]));
        prints(&call);
    }
    let values = fs::read(&pfm).unwrap();
    let head = b"PF\n20 18\n-1.0\n".len();
    let rows: Vec<&[u8]> = values[head..].chunks(20 * 12).rev().collect();
    let red =
        rows.concat().chunks(12).map(|pixel| f32::from_le_bytes(pixel[..4].try_into().unwrap())).collect::<Vec<_>>();
    assert_eq!(channel(&exr, "R"), red);
    assert_eq!(channel(&plain, "R"), red);
    let scene = support::scene("glass-and-mirror");
    let layer = layered(&scene, CROP).layer(Layer::Normal);
    for (name, expected) in ["normal.X", "normal.Y", "normal.Z"].into_iter().zip(layer.channels) {
        assert_eq!(channel(&exr, name), expected.values, "{name}");
    }
    assert!(channel(&exr, "depth.Z").iter().all(|depth| *depth > 0.0));
}

#[test]
fn png_files_of_layers_stand_beside_the_picture() {
    let folder = tempfile::tempdir().unwrap();
    let picture = folder.path().join("out.png");
    let crop = CROP.map(|side| side.to_string()).join(",");
    let picture = picture.to_str().unwrap();
    prints(&["render", "textbook", "--quiet", "--crop", &crop, "-o", picture, "--layers", "all"]);
    let mut files: Vec<_> =
        fs::read_dir(folder.path()).unwrap().map(|file| file.unwrap().file_name().into_string().unwrap()).collect();
    files.sort();
    let mut expected: Vec<_> = Layer::ALL.iter().map(|layer| format!("out.{}.png", layer.word())).collect();
    expected.push("out.png".to_owned());
    expected.sort();
    assert_eq!(files, expected);
    let (width, height) = open(&folder.path().join("out.depth.png")).dimensions();
    assert!(width >= 20 && height > 18, "a legend stands below");
    says(2, &["render", "textbook", "-o", "x.pfm", "--layers", "depth"], "expected a picture in .exr");
    says(2, &["render", "textbook", "-o", "x.png", "--layers", "deep"], "unknown layer `deep`");
    says(2, &["render", "textbook", "-o", "x.png", "--layers", "depth,depth"], "occurs twice");
}

/// What is asked for by name is in channels of its own, the same from shards, and `diff` names what differs.
#[test]
fn layers_by_name_go_through_files_and_parts() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let layers = "value:shade.n_dot_l@C,value:hit.point,light:all,class:L(D|S)S*E";
    let call = ["render", "textbook", "--quiet", "--crop", "140,100,190,140", "--layers", layers, "-o"];
    prints(&[&call[..], &[&path("whole.exr")]].concat());
    for shard in ["1/2", "2/2"] {
        let part = path(&format!("{}.part", &shard[..1]));
        prints(&[&call[..], &[&part, "--shard", shard]].concat());
    }
    prints(&["merge", &path("1.part"), &path("2.part"), "--quiet", "-o", &path("merged.exr")]);
    assert!(fs::read(path("whole.exr")).unwrap() == fs::read(path("merged.exr")).unwrap());
    let values = channel(Path::new(&path("whole.exr")), "value-shade-n_dot_l-C.value");
    let scene = support::scene("textbook");
    let mut hits = 0;
    for (at, value) in values.iter().enumerate().step_by(37) {
        let pixel = [140 + at as u32 % 50, 100 + at as u32 / 50];
        let log = record::pixel(&scene, pixel, Arithmetic::F64);
        let tree = raywalk::log::Tree::of(&log.events);
        let of_camera = log.events.iter().enumerate().find_map(|(event, what)| match what.noted()? {
            (name, raywalk::log::Value::Number(number)) if name.key() == "shade.n_dot_l" => {
                (tree.path(tree.owner(event)) == "C").then_some(number as f32)
            }
            _ => None,
        });
        hits += usize::from(of_camera.is_some());
        assert_eq!(Some(*value).filter(|value| !value.is_nan()), of_camera, "{pixel:?}");
    }
    assert!(hits > 5, "{hits}");
    let colors = channel(Path::new(&path("whole.exr")), "R");
    let lights: Vec<_> = scene.lights.iter().map(|light| format!("light-{}.R", light.name)).collect();
    let parts = lights.iter().map(String::as_str).chain(["light-ambient.R", "light-background.R"]);
    let parts: Vec<_> = parts.map(|name| channel(Path::new(&path("whole.exr")), name)).collect();
    for (at, color) in colors.iter().enumerate() {
        let sum: f32 = parts.iter().map(|part| part[at]).sum();
        assert!((sum - color).abs() <= 1e-5 * color.abs().max(1.0), "{sum} {color}");
    }
    prints(&[&call[..], &[&path("other.exr"), "--arithmetic", "decimal:3"]].concat());
    let output = raywalk(&["diff", &path("whole.exr"), &path("other.exr")]).output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("layer value-shade-n_dot_l-C: "), "{text}");
    let same = raywalk(&["diff", &path("whole.exr"), &path("merged.exr")]).output().unwrap();
    assert_eq!(same.status.code(), Some(0));
}

#[test]
fn layers_that_are_not_there_are_refused_with_what_there_is() {
    let refused =
        |layers: &str, expected: &str| says(2, &["render", "textbook", "-o", "x.exr", "--layers", layers], expected);
    refused("value:shade.n_dotl", "did you mean `shade.n_dot_l`?");
    refused("value:hit.point@C X", "`C X` is no path, expected C and then R or T");
    refused("light:lampp", "unknown light `lampp`");
    refused("class:LDDE", "no path is of the class LDDE; here there are LDE, LSE, AE, BE");
    refused("class:l", "is no class of paths");
    refused("light:all,light:ambient", "the layer `light:ambient` occurs twice");
    refused("depht", "unknown layer `depht`, did you mean `depth`?");
}

/// A picture of errors that are all unknown is grey throughout; the program says why.
#[test]
fn the_layer_of_errors_says_that_single_samples_have_none() {
    let folder = tempfile::tempdir().unwrap();
    let picture = folder.path().join("out.png");
    let note = "note: layer error: a single sample has no error";
    for (sampling, layers, is_noted) in
        [("none", "rays,error", true), ("regular:2", "rays,error", false), ("none", "rays", false)]
    {
        let call =
            ["render", "textbook", "--crop", "150,110,154,114", "--sampling", sampling, "--layers", layers, "-o"];
        let output = raywalk(&call).arg(&picture).output().unwrap();
        assert!(output.status.success(), "{output:?}");
        assert_eq!(String::from_utf8_lossy(&output.stderr).contains(note), is_noted, "{output:?}");
    }
}

/// A log in a `.zst` file is the log, byte for byte, and every command reads it.
#[test]
fn what_is_named_zst_is_packed_and_read() {
    let folder = tempfile::tempdir().unwrap();
    let [packed, plain] = ["log.ndjson.zst", "log.ndjson"].map(|name| folder.path().join(name));
    for path in [&packed, &plain] {
        prints(&["trace", "textbook", "--region", "150,110,170,130", "-o", path.to_str().unwrap()]);
    }
    let bytes = fs::read(&packed).unwrap();
    assert!(bytes.starts_with(b"\x28\xb5\x2f\xfd") && bytes.len() * 3 < fs::metadata(&plain).unwrap().len() as usize);
    let mut unpacked = Vec::new();
    let mut decoder = ruzstd::decoding::StreamingDecoder::new(&bytes[..]).unwrap();
    std::io::Read::read_to_end(&mut decoder, &mut unpacked).unwrap();
    assert!(unpacked == fs::read(&plain).unwrap());
    prints(&["diff", packed.to_str().unwrap(), plain.to_str().unwrap()]);
    let scene = folder.path().join("scene.json.zst");
    let text = fs::read("scenes/textbook.json").unwrap();
    fs::write(&scene, ruzstd::encoding::compress_to_vec(&text[..], ruzstd::encoding::CompressionLevel::Fastest))
        .unwrap();
    prints(&["scene", "check", scene.to_str().unwrap()]);
    fs::write(&packed, &bytes[..bytes.len() / 2]).unwrap();
    let output = raywalk(&["diff", packed.to_str().unwrap(), plain.to_str().unwrap()]).output().unwrap();
    assert!(String::from_utf8_lossy(&output.stderr).contains("the log was cut off"), "{output:?}");
}

/// An OpenEXR of two by one pixels that are all black, with these channels beside the colours.
fn black_with(folder: &Path, name: &str, beside: &[(&str, FlatSamples)]) -> String {
    let black = ["R", "G", "B"].map(|name| (name, FlatSamples::F32(vec![0.0, 0.0])));
    let channels = black.iter().chain(beside).map(|(name, samples)| AnyChannel::new(*name, samples.clone())).collect();
    let channels = AnyChannels::sort(channels);
    let layer = exr::prelude::Layer::new((2, 1), LayerAttributes::default(), Encoding::UNCOMPRESSED, channels);
    let path = folder.join(name);
    Image::from_layer(layer).write().non_parallel().to_file(&path).unwrap();
    path.to_str().unwrap().to_owned()
}

#[test]
fn layers_that_differ_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str, beside: &[(&str, FlatSamples)]| black_with(folder.path(), name, beside);
    let floats = |a: f32, b: f32| FlatSamples::F32(vec![a, b]);
    let ids = |a: u32, b: u32| FlatSamples::U32(vec![a, b]);
    let a = file(
        "a.exr",
        &[
            ("depth.Z", floats(1.0, 2.0)),
            ("id", ids(7, 4_294_967_295)),
            ("n.X", floats(0.0, 0.5)),
            ("n.Y", floats(1.0, f32::NAN)),
        ],
    );
    let same = file(
        "same.exr",
        &[
            ("depth.Z", floats(1.0, 2.0)),
            ("id", ids(7, 4_294_967_295)),
            ("n.X", floats(0.0, 0.5)),
            ("n.Y", floats(1.0, f32::NAN)),
        ],
    );
    let b = file(
        "b.exr",
        &[
            ("A", floats(1.0, 1.0)),
            ("depth.Z", floats(1.0, 2.25)),
            ("Z", floats(1.0, 1.0)),
            ("id", ids(7, 4_294_967_294)),
            ("n.X", floats(0.25, 0.5)),
            ("n.Z", floats(0.0, 0.0)),
        ],
    );
    let none = file("none.exr", &[]);
    let diff = |arguments: &[&str]| {
        let output = raywalk(&[&["diff"], arguments].concat()).output().unwrap();
        (
            String::from_utf8(output.stdout).unwrap().replace(folder.path().to_str().unwrap(), ""),
            output.status.code().unwrap(),
        )
    };
    let colours = "colours: the same: 2 pixels, none differs\n";
    assert_eq!(
        diff(&[&a, &same]),
        (format!("{colours}layer depth: the same\nlayer id: the same\nlayer n: the same\n"), 0)
    );
    let expected = "layer depth: 1 of 2 pixels differ (50.0%), the largest difference is 0.250 in the channel Z of pixel 1,0: 2 against 2.25\n\
                    layer id: 1 of 2 pixels differ (50.0%), the largest difference is 1.00 in the channel id of pixel 1,0: 4294967295 against \
                    4294967294\n\
                    layer n: 1 of 2 pixels differ (50.0%), the largest difference is 0.250 in the channel X of pixel 0,0: 0 against 0.25\n\
                    layer n.Y: is only in /a.exr\nlayer n.Z: is only in /b.exr\nlayer Z: is only in /b.exr\n";
    let (text, code) = diff(&[&a, &b]);
    assert_eq!((text.as_str(), code), (format!("{colours}{expected}").as_str(), 1));
    assert_eq!(diff(&[&none, &none]), ("the same: 2 pixels, none differs\n".to_owned(), 0));
    assert_eq!(diff(&[&a, &none]).1, 1);
    // A format without layers lacks none, and alpha is not compared.
    let pfm = folder.path().join("a.pfm");
    fs::write(&pfm, [&b"PF 2 1 -1.0\n"[..], &[0; 24]].concat()).unwrap();
    assert_eq!(diff(&[&a, pfm.to_str().unwrap()]), ("the same: 2 pixels, none differs\n".to_owned(), 0));
    let alpha = file("alpha.exr", &[("A", floats(1.0, 0.5))]);
    assert_eq!(diff(&[&alpha, &none]).1, 0);
    // What is tolerated in colours is tolerated in layers, but not that one is missing.
    let c = file("c.exr", &[("depth.Z", floats(1.0, 2.25))]);
    let d = file("d.exr", &[("depth.Z", floats(1.0, 2.0))]);
    assert_eq!((diff(&[&c, &d]).1, diff(&[&c, &d, "--abs", "0.25"]).1, diff(&[&c, &d, "--rel", "0.01"]).1), (1, 0, 1));
    let (json, code) = diff(&[&a, &b, "--format", "json"]);
    let found: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!((code, &found["same"], &found["differing_pixels"]), (1, &false.into(), &0.into()));
    let depth = serde_json::json!({
        "name": "depth", "differing_pixels": 1,
        "largest": {"pixel": [1, 0], "channel": "Z", "difference": 0.25, "a": 2.0, "b": 2.25},
    });
    assert_eq!((&found["layers"][0], &found["layers_only_in_b"]), (&depth, &serde_json::json!(["n.Z", "Z"])));
    // Names come from outside.
    let hostile = file("hostile.exr", &[("\u{1b}[2J.\u{9b}Z", floats(1.0, 1.0))]);
    for arguments in [&["diff", hostile.as_str(), none.as_str()][..], &["diff", &hostile, &none, "--format", "json"]] {
        let shown = String::from_utf8(raywalk(arguments).output().unwrap().stdout).unwrap();
        assert!(!shown.contains(|c: char| c.is_control() && c != '\n'), "{shown:?}");
    }
}
