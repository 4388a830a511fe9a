//! How breakpoints are read, and where they stop.

use super::condition::{Operator, Quantity, Test};
use super::*;
use crate::log::{Event, Events, Log, Name, Tree, Value, What};
use crate::report::Style;
use crate::report::language::Language;
use crate::report::language::viewer::Breakpoints;
use crate::tui::model::quantity::Part;
use crate::tui::testing::{glass, textbook};

fn texts() -> &'static Breakpoints {
    &Language::English.texts().viewer.breakpoints
}

#[track_caller]
fn condition(text: &str) -> Condition {
    parse(text, &glass(), texts()).unwrap_or_else(|why| panic!("{text}: {why}"))
}

#[track_caller]
fn reads(text: &str, expected: Condition) {
    assert_eq!(condition(text), expected, "{text}");
}

/// A condition on the quantity with this key.
fn of(key: &str, part: Part, test: Option<(Operator, f64)>) -> Condition {
    let names = Name::all().filter(|name| name.key() == key).collect();
    let test = test.map(|(operator, number)| Test::Compared(operator, number));
    Condition::Quantity(Quantity { names, part, test })
}

#[test]
fn kinds() {
    reads("hit", Condition::Kind("hit"));
    reads("kind shadow", Condition::Kind("shadow"));
    reads("Kind  Reflected", Condition::Kind("reflected"));
    reads("kind total-internal-reflection", Condition::Kind("total-internal-reflection"));
    reads("total_internal_reflection", Condition::Kind("total-internal-reflection"));
    reads("depth limit", Condition::Kind("depth-limit"));
    reads("light", Condition::Kind("light"));
}

#[test]
fn objects_lights_and_depths() {
    reads("object ball", Condition::Object(vec![0]));
    reads("object \"Wall\"", Condition::Object(vec![1]));
    reads("light lamp", Condition::Light(vec![0]));
    reads("light behind the wall", Condition::Light(vec![1]));
    reads("depth 2", Condition::Depth(Operator::Equal, 2));
    reads("depth = 0", Condition::Depth(Operator::Equal, 0));
    reads("depth>=2", Condition::Depth(Operator::AtLeast, 2));
    reads("depth ≠ 3", Condition::Depth(Operator::Unequal, 3));
}

#[test]
fn quantities() {
    let n_dot_l = |test| of("shade.n_dot_l", Part::Whole, test);
    reads("shade.n_dot_l < 0", n_dot_l(Some((Operator::Below, 0.0))));
    reads("shade.n_dot_l<=-1.5e-3", n_dot_l(Some((Operator::AtMost, -1.5e-3))));
    reads("N·L ≥ −2", n_dot_l(Some((Operator::AtLeast, -2.0))));
    reads("N*L > 0", n_dot_l(Some((Operator::Above, 0.0))));
    reads("N · L != 0", n_dot_l(Some((Operator::Unequal, 0.0))));
    reads("shade.n_dot_l", n_dot_l(None));
    reads("T2_A ~ 0", of("sphere.t2_a", Part::Whole, Some((Operator::Near, 0.0))));
    reads("T2_A == 1", of("sphere.t2_a", Part::Whole, Some((Operator::Equal, 1.0))));
    reads("cosphi_1 = 1", of("refract.cos_1", Part::Whole, Some((Operator::Equal, 1.0))));
    for (letter, index) in [("x", 0), ("y", 1), ("z", 2), ("r", 0), ("g", 1), ("b", 2)] {
        let part = Part::Component(index);
        reads(&format!("ray.direction.{letter} < 0"), of("ray.direction", part, Some((Operator::Below, 0.0))));
    }
    reads("|ray.direction| > 1", of("ray.direction", Part::Length, Some((Operator::Above, 1.0))));
    // A symbol that is a length itself.
    reads("|ℓ| < 3", of("light.distance", Part::Whole, Some((Operator::Below, 3.0))));
}

#[track_caller]
fn refuses(text: &str, expected: &str) {
    let said = parse(text, &glass(), texts()).err().unwrap_or_default();
    assert!(said.contains(expected), "{text}: {said}");
}

#[test]
fn mistakes_are_distinguished_from_each_other() {
    refuses("", "expected a breakpoint");
    refuses("kind shadwo", "did you mean `shadow`?");
    refuses("kind", "expected a kind of event");
    refuses("object bal", "there is no object `bal`; did you mean `ball`?");
    refuses("object nothing-like-it", "there is no object `nothing-like-it`, but ball, wall");
    refuses("light lmap", "did you mean `lamp`?");
    refuses("depth two", "expected a level of the ray tree");
    refuses("depth -1", "expected a level of the ray tree");
    refuses("shade.n_dot_k < 0", "did you mean `shade.n_dot_l`?");
    refuses("shade.n_dot_l < ", "expected a number");
    refuses("shade.n_dot_l < much", "expected a number such as 0 or -1.5e-3, not `much`");
    refuses("shade.n_dot_l < inf", "expected a number");
    refuses("ray.direction < 0", "ray.direction has three numbers");
    refuses("shade.n_dot_l.x < 0", "is a number and has no components");
    refuses("< 0", "nothing is called ``");
    refuses("hti", "did you mean `hit`?");
    refuses("\x1b[2J", "nothing is called `\\u{1b}[2J`");
}

/// How many events of a log a condition stops at.
fn stops(log: &Log, text: &str) -> usize {
    let mut breakpoint = Breakpoint::new(condition(text), text);
    breakpoint.find(Run { log, tree: &Tree::of(&log.events) }, Style::default());
    breakpoint.places.count()
}

#[test]
fn conditions_hold_where_they_say() {
    let log = glass();
    let count = |is: fn(&Event) -> bool| log.events.iter().filter(|event| is(event)).count();
    assert_eq!(stops(&log, "shade.n_dot_l"), stops(&log, "N·L < 0") + stops(&log, "N·L >= 0"));
    assert!(stops(&log, "N·L < 0") > 0);
    assert_eq!(stops(&log, "N·L = 0") + stops(&log, "N·L != 0"), stops(&log, "N·L"));
    assert_eq!(stops(&log, "|ray.direction| ~ 1"), stops(&log, "ray.direction"));
    let rays = ["camera", "shadow", "reflected", "transmitted"].map(|kind| stops(&log, kind));
    assert_eq!(rays.iter().sum::<usize>(), stops(&log, "ray"));
    assert_eq!((0..=9).map(|depth| stops(&log, &format!("depth {depth}"))).sum::<usize>(), stops(&log, "ray"));
    assert_eq!(stops(&log, "camera"), 1);
    assert!(stops(&log, "hit") + stops(&log, "miss") >= stops(&log, "test"));
    assert_eq!(stops(&log, "light lamp") + stops(&log, "light behind the wall"), stops(&log, "light") + rays[1]);
    assert!(stops(&log, "object ball") > stops(&log, "shade") / 2);
    assert_eq!(stops(&log, "result"), count(|event| matches!(event.what, What::Result { .. })));
}

#[test]
fn near_is_as_near_as_one_can_see() {
    let holds = |number: f64, digits: u32| {
        let near = Quantity {
            names: vec![Name::SphereT2a],
            part: Part::Whole,
            test: Some(Test::Compared(Operator::Near, 2.0)),
        };
        let mut event = textbook().events.remove(0);
        event.what = What::Note { name: Name::SphereT2a, value: Value::Number(number) };
        let log = Log { events: Events::from(event), ..textbook() };
        let run = Run { log: &log, tree: &Tree::of(&log.events) };
        Condition::Quantity(near).stops_at(run, 0, Style::default().with(digits))
    };
    assert!(holds(2.000_4, 3) && holds(1.999_6, 3) && !holds(2.000_6, 3));
    assert!(holds(2.04, 1) && !holds(2.06, 1));
    assert!(holds(2.0 + 9e-10, 15) && !holds(2.0 + 2e-9, 15));
    assert!(!holds(f64::NAN, 3));
}

#[test]
fn every_kind_of_an_event_has_its_word() {
    for log in [glass(), textbook()] {
        let kinds = log.events.iter().flat_map(|event| kind::of(&event.what));
        assert!(kinds.into_iter().all(|word| kind::find(word) == Some(word)));
    }
    assert!(kind::WORDS.iter().all(|word| kind::find(word) == Some(word)));
}

/// Whether a name goes on is asked of every later term, so there are so many at most; names with quotes are themselves.
#[test]
fn long_conditions_are_refused() {
    let many = |count: usize| vec!["object plane"; count].join(" and ");
    assert!(parse(&many(64), &textbook(), texts()).is_ok());
    for text in [many(65), many(600), format!("({})", many(65)), format!("object {}", "x".repeat(5000))] {
        let said = parse(&text, &textbook(), texts()).expect_err("a condition that is too long");
        assert!(said.contains("at most 64 terms and 4096 characters"), "{said}");
    }
    let mut log = textbook();
    log.header.objects[0] = "\"q\"".to_owned();
    for text in ["object \"q\"", "object \"sphere\"", "hit and object \"q\""] {
        assert!(parse(text, &log, texts()).is_ok(), "{text}");
    }
}
