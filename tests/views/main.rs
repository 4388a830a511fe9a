//! Views of a log for people: worked solutions, ray trees, rays as geometry; and that the tools for them take them.

// Each test program uses a part of it.
#[allow(dead_code)]
#[path = "../support/bitmap.rs"]
mod bitmap;
#[path = "../support/calls.rs"]
mod calls;
// The place of data of others is for other tests.
#[allow(dead_code)]
#[path = "../support/shared.rs"]
mod shared;
#[path = "../support/mod.rs"]
mod support;

mod close_up;
mod figures;
mod lines;
mod saved;
mod solutions;
mod steps;
mod tags;
mod tools;

use raywalk::log::{Log, Tree};
use raywalk::record::{self, Arithmetic};
use raywalk::report::Style;
use raywalk::report::language::Language;
use raywalk::report::ray_tree::{self, Figure};
use raywalk::report::schematic::Stage;
use raywalk::report::solution::Task;

/// A name with something of everything that a format reads.
const NASTY: &str =
    "</script><b a=\"x\" '>&amp; \\end{document} $x_1^2$ `c` [l](u) | #1 % ~ {} -- \u{1b}[2J\u{202e} 球 é";

/// The middle pixel of a built-in scene.
fn log(scene: &str, arithmetic: Arithmetic) -> Log {
    let scene = support::scene(scene);
    record::pixel(&scene, support::middle(&scene), arithmetic)
}

/// The numeric example with names that try to be markup.
fn nasty_log() -> Log {
    let mut log = log("textbook", Arithmetic::Decimal(3));
    log.header.scene.name = NASTY.to_owned();
    log.header.objects = vec![NASTY.to_owned(), format!("2{NASTY}")];
    log.header.lights = vec![NASTY.to_owned()];
    log
}

/// A view of a whole log, without the scene's outlines.
fn solution(log: &Log, language: Language, write: fn(&Task) -> String) -> String {
    let tree = Tree::of(&log.events);
    let stage = Stage { wireframes: &[], upright: 1 };
    write(&Task { log, tree: &tree, stage, language, style: Style::default() })
}

/// A ray tree of a log.
fn tree(log: &Log, language: Language, write: fn(&Figure) -> String) -> String {
    let branches = ray_tree::branches(log, &Tree::of(&log.events), 0);
    write(&Figure { log, branches: &branches, language, style: Style::default() })
}
