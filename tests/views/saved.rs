//! Views of saved logs: those of the scene, without what a log doesn't hold.

use crate::calls::{prints, raywalk, says};
use tempfile::TempDir;

/// A folder with a log, and the path of the log.
fn saved(name: &str, call: &[&str]) -> (TempDir, String) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join(name).to_str().expect("UTF-8").to_owned();
    prints(&[call, &["-o", &path]].concat());
    (folder, path)
}

#[test]
fn a_saved_log_is_seen_as_its_scene_is() {
    let call = ["trace", "figure-6", "--pixel", "160,120", "--arithmetic", "decimal:3"];
    for name in ["log.ndjson", "log.ndjson.gz"] {
        let (_folder, log) = saved(name, &call);
        for format in ["ndjson", "json", "text", "markdown", "dot", "svg", "mermaid", "obj", "ply"] {
            let options = ["--format", format, "--lang", "es", "--digits", "2", "--tree", "calls"];
            let options = if matches!(format, "ndjson" | "json" | "obj" | "ply") { &options[..2] } else { &options };
            let (direct, seen) = (prints(&[&call, options].concat()), prints(&[&["trace", &log], options].concat()));
            // Some figures show where the objects are, which no log knows.
            assert!(direct == seen, "{name} {format}");
        }
        let page = prints(&["trace", &log, "--format", "html"]);
        assert!(page.starts_with("<!DOCTYPE html>") && page.contains("</figure>"), "{page:.200}");
        assert!(prints(&["trace", &log, "--format", "latex"]).ends_with("\\end{document}\n"));
    }
}

#[test]
fn a_saved_region_is_written_as_regions_are() {
    let call = ["trace", "textbook", "--region", "158,119,162,121"];
    let (_folder, log) = saved("region.json", &[&call[..], &["--format", "json"]].concat());
    for format in ["ndjson", "text", "obj", "ply"] {
        let direct = prints(&[&call[..], &["--format", format]].concat());
        assert!(direct == prints(&["trace", &log, "--format", format]), "{format}");
    }
    // The log itself unless asked for anything else.
    assert_eq!(prints(&["trace", &log]), prints(&call));
    says(2, &["trace", &log, "--format", "html"], "expected a pixel or a ray, found a region");
}

#[test]
fn a_log_is_traced_already() {
    let (_folder, log) = saved("log.ndjson", &["trace", "textbook", "--pixel", "160,120"]);
    let options: [&[&str]; 6] = [
        &["--pixel", "1,1"],
        &["--region", "1,1,2,2"],
        &["--causes"],
        &["--max-depth", "2"],
        &["--arithmetic", "f32"],
        &["--frames", "1"],
    ];
    for option in options {
        says(2, &[&["trace", &log], option].concat(), "is a log, which is traced already");
    }
    says(2, &["trace", &log, "-o", &log], "would be overwritten");
    let bytes = std::fs::read(&log).expect("the log");
    let piped =
        raywalk(&["trace", "-", "--format", "text"]).write_stdin(&bytes[..bytes.len() / 2]).output().expect("it runs");
    let told = String::from_utf8_lossy(&piped.stderr);
    assert!(piped.status.success() && told.contains("warning: "), "{told}");
    assert!(String::from_utf8_lossy(&piped.stdout).starts_with("textbook · pixel 160,120 · f64"));
}
