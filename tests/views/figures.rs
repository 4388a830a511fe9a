//! Ray trees as graphics.

use crate::calls::prints;
use crate::support::snapshots;
use crate::tags::read;
use crate::{log, nasty_log, tree};
use insta::assert_snapshot;
use raywalk::log::{Step, Tree};
use raywalk::record::Arithmetic;
use raywalk::report::language::Language;
use raywalk::report::ray_tree::{self, Branch, Figure, dot, mermaid, svg};
use raywalk::scene::builtin;

fn figure(scene: &str, format: &str) -> String {
    prints(&["trace", scene, "--pixel", "160,120", "--format", format])
}

#[test]
fn trees_of_the_numeric_example_and_of_figure_7() {
    for (scene, name) in [("textbook", "textbook"), ("figure-6", "figure_6")] {
        for format in ["dot", "svg", "mermaid"] {
            let text = figure(scene, format);
            snapshots().bind(|| assert_snapshot!(format!("tree_{name}_{format}"), text));
        }
    }
}

#[test]
fn trees_of_calls() {
    let of_calls = |scene: &str, format: &str, more: &[&str]| {
        prints(&[&["trace", scene, "--pixel", "160,120", "--tree", "calls", "--format", format], more].concat())
    };
    let text = of_calls("figure-6", "mermaid", &["--max-depth", "1"]);
    snapshots().bind(|| assert_snapshot!("tree_of_calls_figure_6_mermaid", text));
    // The second pseudocode asks for the depth before it calls, and counts from 1.
    let text = of_calls("figure-6", "dot", &["--max-depth", "2", "--algorithm", "whitted"]);
    assert!(text.contains("RT_trace(C R, 2)") && !text.contains(", 3)"), "{text}");
    assert!(of_calls("textbook", "svg", &["--lang", "es"]).contains("<title>Árbol de llamadas: textbook"));
}

#[test]
fn every_ray_of_every_scene_is_in_its_tree() {
    for name in builtin::names() {
        let log = log(name, Arithmetic::F64);
        let nodes = Tree::of(&log.events);
        let rays = nodes.nodes().iter().filter(|node| matches!(node.step, Some(Step::Ray { .. }))).count();
        let branches = ray_tree::branches(&log, &nodes, 0);
        assert_eq!(ray_tree::count(&branches), rays, "{name}");
        let picture = tree(&log, Language::English, svg);
        assert_eq!(
            read(&picture).names.iter().filter(|name| *name == "line").count(),
            rays + 5,
            "{name}: with the legend"
        );
        assert_eq!(tree(&log, Language::English, dot).matches(" -> ").count(), rays, "{name}");
        assert_eq!(tree(&log, Language::English, mermaid).matches("linkStyle").count(), rays, "{name}");
    }
}

#[test]
fn what_comes_along_a_ray_is_the_sum_of_what_comes_along_those_after_it_and_more() {
    let log = log("figure-6", Arithmetic::F64);
    let branches = ray_tree::branches(&log, &Tree::of(&log.events), 0);
    let [eye] = &branches[..] else { panic!("{} rays from the eye", branches.len()) };
    assert!((eye.share - 1.0).abs() < 1e-12, "{}", eye.share);
    check(eye);

    fn check(branch: &Branch) {
        let below: f64 = branch.children.iter().map(|child| child.share).sum();
        // The rest is ambient light.
        assert!(below <= branch.share + 1e-12, "{}: {below} of {}", branch.path, branch.share);
        assert!(!branch.is_blocked() || branch.share == 0.0, "{}", branch.path);
        branch.children.iter().for_each(check);
    }
}

#[test]
fn a_blocked_shadow_ray_is_marked_in_every_format() {
    let log = log("figure-6", Arithmetic::F64);
    for write in [dot as fn(&Figure) -> String, mermaid] {
        assert_eq!(tree(&log, Language::English, write).matches("S2 ✗").count(), 2);
    }
    assert_eq!(tree(&log, Language::English, svg).matches("blocked by 4").count(), 2);
    assert!(tree(&log, Language::Spanish, svg).contains("bloqueado por 4"));
}

#[test]
fn names_stay_text() {
    let log = nasty_log();
    let picture = read(&tree(&log, Language::English, svg));
    assert!(!picture.names.contains(&"b".to_owned()));
    for write in [dot as fn(&Figure) -> String, mermaid] {
        for line in tree(&log, Language::English, write).lines() {
            assert_eq!(line.replace("\\\\", "").replace("\\\"", "").matches('"').count() % 2, 0, "{line}");
        }
    }
}

#[test]
fn samples_have_a_tree_each() {
    let text = prints(&["trace", "textbook", "--pixel", "160,120", "--sampling", "regular:2", "--format", "mermaid"]);
    for sample in 1..=4 {
        assert!(text.contains(&format!("eye -- \"{sample} C\"")), "{text}");
    }
}
