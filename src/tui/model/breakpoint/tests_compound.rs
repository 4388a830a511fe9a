//! Conditions of several terms: how they are read, and that they stop where somebody who goes through the events says.

use super::condition::{Class, Operator, Quantity, Test};
use super::*;
use crate::log::{Log, Name, RayKind, Step, Tree, Value, What};
use crate::record::Arithmetic;
use crate::report::Style;
use crate::report::language::Language;
use crate::report::language::viewer::Breakpoints;
use crate::tui::model::quantity::Part;
use crate::tui::testing::{glass, log_of};
use proptest::prelude::*;
use std::collections::HashMap;
use std::sync::LazyLock;

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

fn depth(level: u32) -> Condition {
    Condition::Depth(Operator::Equal, level)
}

#[test]
fn and_binds_tighter_than_or() {
    use Condition::{All, Any, Kind};
    reads("hit and depth 2", All(vec![Kind("hit"), depth(2)]));
    reads("hit or miss and depth 2", Any(vec![Kind("hit"), All(vec![Kind("miss"), depth(2)])]));
    reads("hit and depth 2 or miss", Any(vec![All(vec![Kind("hit"), depth(2)]), Kind("miss")]));
    reads("(hit or miss) and depth 2", All(vec![Any(vec![Kind("hit"), Kind("miss")]), depth(2)]));
    reads("((hit)) AND(depth 2)", All(vec![Kind("hit"), depth(2)]));
    reads("depth limit or depth 2", Any(vec![Kind("depth-limit"), depth(2)]));
    reads("object \"ball\" and light lamp", All(vec![Condition::Object(vec![0]), Condition::Light(vec![0])]));
}

#[test]
fn names_may_have_and_in_them() {
    let mut log = glass();
    log.header.objects = ["salt and pepper", "this or that", "orange"].map(str::to_owned).to_vec();
    let read = |text: &str| parse(text, &log, texts()).unwrap_or_else(|why| panic!("{text}: {why}"));
    let object = |number| Condition::Object(vec![number]);
    assert_eq!(read("object salt and pepper"), object(0));
    assert_eq!(read("object salt and pepper and depth 2"), Condition::All(vec![object(0), depth(2)]));
    assert_eq!(read("depth 2 or object this or that"), Condition::Any(vec![depth(2), object(1)]));
    assert_eq!(read("object \"salt and pepper\" or hit"), Condition::Any(vec![object(0), Condition::Kind("hit")]));
    assert_eq!(read("object orange"), object(2));
}

#[test]
fn classes_of_numbers() {
    let is = |class, is_negated| {
        let names = Name::all().filter(|name| name.key() == "ray.direction").collect();
        Condition::Quantity(Quantity { names, part: Part::Whole, test: Some(Test::Is { class, is_negated }) })
    };
    reads("ray.direction is nan", is(Class::Nan, false));
    reads("ray.direction  IS  NaN", is(Class::Nan, false));
    reads("d is infinite", is(Class::Infinite, false));
    reads("d is not finite", is(Class::Finite, true));
    let mut log = glass();
    let first =
        |log: &Log| log.events.iter().position(|event| event.noted().is_some_and(|(name, _)| name.symbol() == "d"));
    let at = first(&log).unwrap_or_default();
    let mut count = |text: &str, z: f64| {
        if let What::Note { value, .. } = &mut log.events[at].what {
            *value = Value::Triple([0.0, 1.0, z]);
        }
        let mut breakpoint = Breakpoint::new(condition(text), text);
        breakpoint.find(Run { log: &log, tree: &Tree::of(&log.events) }, Style::default());
        breakpoint.places.count()
    };
    let all = count("d", 0.0);
    assert!(all > 0);
    for (z, nan, infinite, finite) in [
        (0.0, 0, 0, all),
        (f64::NAN, 1, 0, all - 1),
        (f64::INFINITY, 0, 1, all - 1),
        (f64::NEG_INFINITY, 0, 1, all - 1),
    ] {
        assert_eq!((count("d is nan", z), count("d is not nan", z)), (nan, all - nan), "{z}");
        assert_eq!((count("d is infinite", z), count("d.y is infinite", z)), (infinite, 0), "{z}");
        assert_eq!((count("d is finite", z), count("d is not finite", z)), (finite, all - finite), "{z}");
        assert_eq!(count("d.z is not finite", z), all - finite, "{z}");
    }
}

#[track_caller]
fn refuses(text: &str, expected: &str) {
    let said = parse(text, &glass(), texts()).err().unwrap_or_default();
    assert!(said.contains(expected), "{text}: {said}");
}

#[test]
fn mistakes_in_several_terms() {
    refuses("hit and", "expected a condition before and behind");
    refuses("or hit", "expected a condition before and behind");
    refuses("hit and and miss", "expected a condition before and behind");
    refuses("hit and shadwo", "did you mean `shadow`?");
    refuses("hit and object bal", "there is no object `bal`; did you mean `ball`?");
    refuses("(hit or miss", "expected `)`");
    refuses("(hit or miss) and (depth 2", "expected `)`");
    refuses("()", "expected a breakpoint");
    refuses("N·L is nann", "no number is nann; did you mean is nan?");
    refuses("N·L is", "expected is nan");
    refuses("N·K is nan", "did you mean `N·");
    refuses("depth >= two", "expected a level of the ray tree");
    refuses(&"(".repeat(100_000), "at most 64 terms and 4096 characters");
    refuses(&"(".repeat(4000), "expected `)`");
    refuses(&format!("{}hit{}", "(".repeat(1000), ")".repeat(1000)), "too many parentheses");
}

#[test]
fn terms_are_completed_one_by_one() {
    let log = glass();
    let has = |text: &str, way: &str| completions(&log, text).contains(&way.to_owned());
    assert!(has("occl", "occluded"));
    assert!(has("hit and shade.n_dot_l < 0.2 or (dep", "hit and shade.n_dot_l < 0.2 or (depth "));
    assert!(has("hit and object b", "hit and object ball"));
    assert!(has("shade.n_dot_l i", "shade.n_dot_l is nan"));
    assert!(completions(&log, "hit and zzz").is_empty());
}

/// A node that is open while one goes through the events: what it is, and the latest value of each symbol in it.
struct Open {
    step: Step,
    values: HashMap<&'static str, Value>,
}

/// An event with the nodes around it, outermost first.
struct Moment<'a> {
    what: &'a What,
    around: &'a [Open],
}

impl Moment<'_> {
    fn ray(&self) -> Option<(u32, RayKind)> {
        self.around.iter().rev().find_map(|open| match open.step {
            Step::Ray { depth, kind, .. } => Some((depth, kind)),
            _ => None,
        })
    }

    fn enters(&self) -> Option<Step> {
        match self.what {
            What::Enter { step, .. } => Some(*step),
            _ => None,
        }
    }

    fn noted(&self, symbol: &str) -> Option<Value> {
        match self.what {
            What::Note { name, value } if name.symbol() == symbol => Some(*value),
            _ => None,
        }
    }

    /// The value at the event itself, else the innermost.
    fn seen(&self, symbol: &str) -> Option<Value> {
        self.noted(symbol).or_else(|| self.around.iter().rev().find_map(|open| open.values.get(symbol).copied()))
    }
}

/// A term: how it is typed, whether it is about a value or a decision, where it happens, where it holds.
type Term = (&'static str, bool, fn(&Moment) -> bool, fn(&Moment) -> bool);

fn number(value: Option<Value>) -> f64 {
    value.and_then(Value::number).unwrap_or(f64::NAN)
}

const TERMS: [Term; 10] = [
    ("shade.n_dot_l < 0.5", true, |at| number(at.noted("N·L")) < 0.5, |at| number(at.seen("N·L")) < 0.5),
    ("N·L >= 0.5", true, |at| number(at.noted("N·L")) >= 0.5, |at| number(at.seen("N·L")) >= 0.5),
    ("N·H > 0.5", true, |at| number(at.noted("N·H")) > 0.5, |at| number(at.seen("N·H")) > 0.5),
    ("N·L is not nan", true, |at| at.noted("N·L").is_some(), |at| at.seen("N·L").is_some()),
    (
        "hit",
        true,
        |at| matches!(at.what, What::Mark(crate::log::Decision::Hit)),
        |at| matches!(at.what, What::Mark(crate::log::Decision::Hit)),
    ),
    (
        "shadow",
        false,
        |at| matches!(at.enters(), Some(Step::Ray { kind: RayKind::Shadow { .. }, .. })),
        |at| matches!(at.ray(), Some((_, RayKind::Shadow { .. }))),
    ),
    (
        "transmitted",
        false,
        |at| matches!(at.enters(), Some(Step::Ray { kind: RayKind::Transmitted, .. })),
        |at| matches!(at.ray(), Some((_, RayKind::Transmitted))),
    ),
    (
        "test",
        false,
        |at| matches!(at.enters(), Some(Step::Test { .. })),
        |at| at.around.iter().any(|open| matches!(open.step, Step::Test { .. })),
    ),
    (
        "depth >= 2",
        false,
        |at| matches!(at.enters(), Some(Step::Ray { depth, .. }) if depth >= 2),
        |at| at.ray().is_some_and(|(depth, _)| depth >= 2),
    ),
    (
        "depth != 1",
        false,
        |at| matches!(at.enters(), Some(Step::Ray { depth, .. }) if depth != 1),
        |at| at.ray().is_some_and(|(depth, _)| depth != 1),
    ),
];

#[derive(Clone, Debug)]
enum Random {
    Term(usize),
    All(Vec<Random>),
    Any(Vec<Random>),
}

impl Random {
    fn text(&self) -> String {
        let joined = |parts: &[Random], word: &str| {
            let texts = parts.iter().map(|part| match part {
                Random::Term(_) => part.text(),
                several => format!("({})", several.text()),
            });
            texts.collect::<Vec<_>>().join(word)
        };
        match self {
            Random::Term(term) => TERMS[*term].0.to_owned(),
            Random::All(parts) => joined(parts, " and "),
            Random::Any(parts) => joined(parts, " or "),
        }
    }

    fn is_moment(&self) -> bool {
        match self {
            Random::Term(term) => TERMS[*term].1,
            Random::All(parts) | Random::Any(parts) => parts.iter().any(Random::is_moment),
        }
    }

    fn happens(&self, at: &Moment) -> bool {
        match self {
            Random::Term(term) => TERMS[*term].2(at),
            Random::Any(parts) => parts.iter().any(|part| part.happens(at)),
            Random::All(parts) => {
                let stopping = |part: &&Random| part.is_moment() || !self.is_moment();
                parts.iter().filter(stopping).any(|part| part.happens(at)) && self.holds(at)
            }
        }
    }

    fn holds(&self, at: &Moment) -> bool {
        match self {
            Random::Term(term) => TERMS[*term].3(at),
            Random::Any(parts) => parts.iter().any(|part| part.holds(at)),
            Random::All(parts) => parts.iter().all(|part| part.holds(at)),
        }
    }
}

/// The events at which a condition stops, by going through all of them.
fn brute_force(log: &Log, random: &Random) -> Vec<usize> {
    let mut open: Vec<Open> = Vec::new();
    let mut found = Vec::new();
    for (at, event) in log.events.iter().enumerate() {
        if let What::Enter { step, .. } = event.what {
            open.push(Open { step, values: HashMap::new() });
        }
        if let Some(here) = open.last_mut() {
            here.values.extend(log.events.given(event).iter().map(|(name, value)| (name.symbol(), *value)));
        }
        if random.happens(&Moment { what: &event.what, around: &open }) {
            found.push(at);
        }
        match event.what {
            What::Note { name, value } => {
                open.last_mut().map(|here| here.values.insert(name.symbol(), value));
            }
            What::Leave => _ = open.pop(),
            _ => {}
        }
    }
    found
}

fn random() -> impl Strategy<Value = Random> {
    let term = (0..TERMS.len()).prop_map(Random::Term);
    term.prop_recursive(3, 8, 3, |inner| {
        let several = || prop::collection::vec(inner.clone(), 2..4);
        prop_oneof![several().prop_map(Random::All), several().prop_map(Random::Any)]
    })
}

/// A glass ball, and the numeric example, which has highlights.
static LOGS: LazyLock<[(Log, Tree); 2]> = LazyLock::new(|| {
    [glass(), log_of("textbook", Arithmetic::F64)].map(|log| {
        let tree = Tree::of(&log.events);
        (log, tree)
    })
});

#[test]
fn several_terms_stop_somewhere_and_not_everywhere() {
    use Random::{All, Any, Term};
    for random in [
        All(vec![Term(0), Term(8)]),
        All(vec![Term(0), Term(2)]),
        All(vec![Term(5), Term(8)]),
        All(vec![Term(4), Term(6)]),
        Any(vec![Term(4), Term(8)]),
    ] {
        let count: usize = LOGS.iter().map(|(log, _)| brute_force(log, &random).len()).sum();
        let all: usize = LOGS.iter().map(|(log, _)| log.events.len()).sum();
        assert!(count > 0 && count < all / 2, "{}: {count}", random.text());
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_conditions_stop_where_brute_force_does(random in random()) {
        let text = random.text();
        for (log, tree) in &*LOGS {
            let condition = parse(&text, log, texts()).unwrap_or_else(|why| panic!("{text}: {why}"));
            let run = Run { log, tree };
            let stops: Vec<_> =
                (0..log.events.len()).filter(|at| condition.stops_at(run, *at, Style::default())).collect();
            prop_assert_eq!(&stops, &brute_force(log, &random), "{}", text);
            let mut breakpoint = Breakpoint::new(condition, &text);
            breakpoint.find(run, Style::default());
            prop_assert_eq!(breakpoint.places.among(0..log.events.len()).collect::<Vec<_>>(), stops);
        }
    }
}
