//! The log of a region: the logs of its pixels, in order, however many threads made them.

use crate::calls::{raywalk, says};
use crate::support::{scene, scene_in};
use raywalk::log::file::{Ending, read, to_json, to_ndjson};
use raywalk::log::{Step, Subject, Tree};
use raywalk::record::{self, Arithmetic, region};
use raywalk::report::contributions;
use std::path::Path;

/// The log of a region as the program writes it.
#[track_caller]
fn written(scene: &str, region: &str, options: &[&str]) -> Vec<u8> {
    let output = raywalk(&["trace", scene, "--region", region]).args(options).output().expect("a program");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    output.stdout
}

/// The lines of the pixel's own log, without its header and its end.
fn own_lines(scene_name: &str, pixel: [u32; 2], arithmetic: Arithmetic) -> Vec<u8> {
    let log = record::pixel(&scene_in(scene_name, arithmetic), pixel, arithmetic);
    let text = to_ndjson(&log).expect("memory");
    let lines: Vec<_> = text.split_inclusive(|byte| *byte == b'\n').collect();
    lines[1..lines.len() - 1].concat()
}

#[track_caller]
fn is_its_pixels(scene_name: &str, region: [u32; 4], arithmetic: Arithmetic) {
    let named = region.map(|side| side.to_string()).join(",");
    let options =
        |threads| ["--arithmetic".to_owned(), arithmetic.to_string(), "--threads".to_owned(), format!("{threads}")];
    let of = |threads: usize| {
        let options = options(threads);
        written(scene_name, &named, &options.each_ref().map(String::as_str))
    };
    let text = of(1);
    assert!(text == of(3), "{scene_name}: other bytes from other threads");
    let mut expected = Vec::new();
    for pixel @ [x, y] in region::pixels(region) {
        expected.extend_from_slice(format!("{{\"at\":0,\"node\":0,\"enter\":{{\"pixel\":[{x},{y}]}}}}\n").as_bytes());
        expected.extend_from_slice(&own_lines(scene_name, pixel, arithmetic));
    }
    let lines: Vec<_> = text.split_inclusive(|byte| *byte == b'\n').collect();
    assert!(lines[1..lines.len() - 1].concat() == expected, "{scene_name}: not the lines of its pixels");

    let found = read(&text).expect("a log");
    assert_eq!((found.ending, found.log.header.subject), (Ending::Complete, Subject::Region(region)));
    assert_eq!(found.log, region::bounded(&scene_in(scene_name, arithmetic), region, arithmetic).expect("a small log"));
    let tree = Tree::of(&found.log.events);
    let opened: Vec<_> = tree.children(0).map(|node| tree.nodes()[node].step).collect();
    assert_eq!(opened, region::pixels(region).map(|pixel| Some(Step::Pixel(pixel))).collect::<Vec<_>>());
    // As a document, too.
    assert_eq!(read(&to_json(&found.log).expect("memory")).expect("a document").log, found.log);
}

#[test]
fn the_log_of_a_region_is_that_of_its_pixels() {
    is_its_pixels("textbook", [158, 119, 162, 121], Arithmetic::Decimal(3));
    is_its_pixels("glass-and-mirror", [0, 0, 13, 9], Arithmetic::F64);
    is_its_pixels("depth-of-field", [20, 20, 23, 22], Arithmetic::F64);
}

#[test]
fn a_region_packed_and_as_text() {
    let folder = tempfile::tempdir().expect("a folder");
    let place = folder.path().join("log.ndjson.gz");
    let write = |place: &Path| {
        let place = place.to_string_lossy().into_owned();
        written("textbook", "159,119,161,121", &["-o", &place]);
    };
    write(&place);
    let packed = std::fs::read(&place).expect("a file");
    write(&place);
    assert!(packed == std::fs::read(&place).expect("a file"), "the same log has other bytes");
    let mut text = Vec::new();
    std::io::Read::read_to_end(&mut flate2::read::GzDecoder::new(&packed[..]), &mut text).expect("gzip");
    assert!(text == written("textbook", "159,119,161,121", &[]));

    let text = String::from_utf8(written("textbook", "160,119,161,121", &["--format", "text"])).expect("UTF-8");
    assert!(text.starts_with("textbook · region 160,119 to 161,121"), "{text}");
    assert_eq!(text.matches("result: ").count(), 2);
    for pixel in ["pixel 160,119", "pixel 160,120"] {
        assert!(text.contains(pixel), "{pixel}:\n{text}");
    }
}

#[test]
fn regions_that_are_none() {
    for region in ["0,0,0,1", "5,0,4,1", "0,0,322,1", "0,0,1,242"] {
        says(2, &["trace", "textbook", "--region", region], "the picture has 321 x 241 pixels");
    }
    says(2, &["trace", "textbook", "--region", "1,2,3"], "--region");
    says(2, &["trace", "textbook", "--region", "0,0,1,1", "--pixel", "1,1"], "cannot be used with");
    says(2, &["trace", "textbook", "--region", "0,0,1,1", "--causes", "--arithmetic", "f32"], "found --region");
    says(2, &["trace", "textbook", "--region", "0,0,321,241", "--format", "json"], "1048576 events");
}

#[test]
fn a_pixel_of_a_region_is_accounted_for_by_its_own_result() {
    let mut log = region::bounded(&scene("textbook"), [160, 120, 162, 121], Arithmetic::F64).expect("a small log");
    let tree = Tree::of(&log.events);
    let pixels: Vec<_> = tree.children(0).collect();
    assert!(pixels.iter().all(|pixel| contributions::account(&log, &tree, *pixel).is_whole));
    // Without the last pixel's result.
    log.events.pop();
    let tree = Tree::of(&log.events);
    assert_eq!([0, 1].map(|k| contributions::account(&log, &tree, pixels[k]).is_whole), [true, false]);
}
