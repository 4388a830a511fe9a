//! What other programs say of the views. A program that isn't installed is reported, and its test is skipped.

use crate::bitmap::open;
use crate::calls::prints;
use crate::shared::skipped;
use crate::{log, nasty_log, solution, tree};
use raywalk::log::Log;
use raywalk::record::Arithmetic;
use raywalk::report::language::Language;
use raywalk::report::ray_tree::{dot, svg};
use raywalk::report::solution::{html, latex};
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

/// Whether there is a program of this name.
fn has(program: &str, version: &str) -> bool {
    let call = Command::new(program).arg(version).stdout(Stdio::null()).stderr(Stdio::null()).status();
    let is_there = call.is_ok_and(|status| status.success());
    if !is_there {
        skipped(&format!("there is no {program}"));
    }
    is_there
}

#[track_caller]
fn takes(folder: &Path, program: &str, arguments: &[&str]) -> String {
    let output = Command::new(program).args(arguments).current_dir(folder).output().expect("it runs");
    let said = format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success(), "{program} {arguments:?}: {said}");
    said
}

fn examples() -> [Log; 4] {
    let [first, second, third] = ["textbook", "figure-6", "penumbra"].map(|name| log(name, Arithmetic::F64));
    [first, second, third, nasty_log()]
}

#[test]
fn graphviz_takes_ray_trees() {
    if !has("dot", "-V") {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    for log in examples() {
        fs::write(folder.path().join("tree.dot"), tree(&log, Language::Spanish, dot)).expect("written");
        takes(folder.path(), "dot", &["-Tsvg", "-o", "tree.svg", "tree.dot"]);
    }
    // What isn't in its language it refuses, so that the above says something.
    fs::write(folder.path().join("bad.dot"), "digraph { a -> }").expect("written");
    assert!(
        !Command::new("dot")
            .args(["-Tsvg", "bad.dot"])
            .current_dir(&folder)
            .output()
            .expect("it runs")
            .status
            .success()
    );
}

#[test]
fn librsvg_draws_ray_trees() {
    if !has("rsvg-convert", "--version") {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    for log in examples() {
        fs::write(folder.path().join("tree.svg"), tree(&log, Language::English, svg)).expect("written");
        takes(folder.path(), "rsvg-convert", &["tree.svg", "-o", "tree.png"]);
        let picture = open(&folder.path().join("tree.png"));
        let dark = picture.pixels().filter(|pixel| pixel.0.iter().all(|channel| *channel < 100)).count();
        assert!(dark > 100, "something is drawn: {dark}");
    }
}

#[test]
fn pdflatex_takes_solutions() {
    if !has("pdflatex", "--version") {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    for log in examples() {
        for language in Language::ALL {
            fs::write(folder.path().join("solution.tex"), solution(&log, language, latex)).expect("written");
            let said =
                takes(folder.path(), "pdflatex", &["-interaction=nonstopmode", "-halt-on-error", "solution.tex"]);
            assert!(said.contains("Output written on solution.pdf"), "{said}");
            assert!(!said.contains("Missing character"), "{said}");
        }
    }
}

#[test]
fn a_browser_shows_pages_and_runs_their_script() {
    if !has("chromium", "--version") {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let shown = |page: &str, hash: &str| {
        let path = folder.path().join("page.html");
        fs::write(&path, page).expect("written");
        let profile = format!("--user-data-dir={}", folder.path().join("profile").display());
        let address = format!("file://{}{hash}", path.display());
        let options =
            ["--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", &profile, "--dump-dom"];
        takes(folder.path(), "chromium", &[&options[..], &[&address]].concat())
    };
    let page = prints(&["trace", "textbook", "--pixel", "160,120", "--format", "html"]);
    let closed = "<details class=\"step\"><summary>3)";
    assert!(page.contains(closed), "what is missed is closed");
    let (_, within) = page.split_once(closed).expect("the missed sphere");
    let id = within.split("id=\"").nth(1).and_then(|rest| rest.split('"').next()).expect("a value");
    assert!(shown(&page, "").contains("<div class=\"folding\"><button type=\"button\">Open all</button>"));
    assert!(shown(&page, "").contains(closed));
    // A link into a closed part opens it.
    let opened = shown(&page, &format!("#{id}"));
    assert!(opened.contains("<details class=\"step\" open=\"\"><summary>3)"), "{opened}");
    // Names from a file add no element and no script.
    let nasty = shown(&solution(&nasty_log(), Language::English, html), "");
    assert_eq!(nasty.matches("<b a=").count(), 0);
    assert!(nasty.contains("<div class=\"folding\">"), "the script still runs");
}
