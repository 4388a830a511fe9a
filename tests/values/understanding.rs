//! What the reports say of where values come from and where colours do, checked on every built-in scene.

use crate::support::{grid, middle, scene};
use raywalk::log::file::{read, to_ndjson};
use raywalk::log::{Event, Events, Log, Name, Step, Subject, Tree, Value, What};
use raywalk::record::{self, Arithmetic};
use raywalk::report::contributions::{self, Account, Origin, Why};
use raywalk::report::language::Language;
use raywalk::report::provenance::{operands, uses};
use raywalk::scene::{Sampling, builtin};

fn log(name: &str, arithmetic: Arithmetic) -> (Log, Tree) {
    let scene = scene(name);
    let log = record::pixel(&scene, middle(&scene), arithmetic);
    let tree = Tree::of(&log.events);
    (log, tree)
}

fn by_hand() -> (Log, Tree) {
    log("textbook", Arithmetic::Decimal(3))
}

/// The event of the k-th quantity with this key, from 1.
#[track_caller]
fn at(log: &Log, key: &str, occurrence: usize) -> usize {
    let is_it = |event: &usize| matches!(log.events[*event].what, What::Note { name, .. } if name.key() == key);
    (0..log.events.len()).filter(is_it).nth(occurrence - 1).unwrap_or_else(|| panic!("no {key}"))
}

fn account_of(log: &Log, tree: &Tree) -> Account {
    contributions::account(log, tree, 0)
}

/// `path: origin share` of each contribution.
fn rows(account: &Account) -> Vec<String> {
    let row = |part: &contributions::Contribution| {
        let origin = match part.origin {
            Origin::Light { light, .. } => format!("light {light}"),
            Origin::Ambient { .. } => "ambient".to_owned(),
            Origin::Background => "background".to_owned(),
            Origin::Rounding => "rounding".to_owned(),
            Origin::Unexplained => "unexplained".to_owned(),
        };
        format!("{}: {origin} {:.3} {:.2}% {}", part.path, part.color[0], 100.0 * part.share, part.class)
    };
    account.contributions.iter().map(row).collect()
}

#[test]
fn the_numeric_example_as_a_sum() {
    let (log, tree) = by_hand();
    let account = account_of(&log, &tree);
    assert!((account.color[0] - 394.134).abs() < 1e-9);
    // By hand: 180·0.3 = 54, 180·0.2 = 36, 220·0.7·0.447 = 68.838 and nothing specular, as in the source text's 104.838.
    assert_eq!(
        rows(&account),
        [
            "C R S1: light 0 235.296 60.63% L(D|S)SE",
            "C R: ambient 54.000 15.04% ASE",
            "C S1: light 0 68.838 14.77% L(D|S)E",
            "C: ambient 36.000 9.56% AE",
            ": rounding 0.000 0.00% ",
        ]
    );
}

#[test]
fn contributions_add_up_to_the_pixel_in_every_built_in_scene() {
    let mut worst: f64 = 0.0;
    for name in builtin::names() {
        let scene = scene(name);
        for pixel in grid(&scene, 3) {
            let log = record::pixel(&scene, pixel, Arithmetic::F64);
            let tree = Tree::of(&log.events);
            let account = account_of(&log, &tree);
            let sum = contributions::sum(&account.contributions);
            let color = record::pixel_color(&scene, pixel, Arithmetic::F64).to_array();
            assert_eq!(account.color, color);
            for channel in 0..3 {
                let off = (sum[channel] - color[channel]).abs() / color[channel].abs().max(1.0);
                worst = worst.max(off);
                assert!(off < 1e-9, "{name} {pixel:?}: {sum:?} for {color:?}\n{:#?}", rows(&account));
            }
            let without = account.contributions.iter().all(|part| part.origin != Origin::Rounding);
            assert!(without, "{name} {pixel:?}");
            for part in account.contributions.iter().filter(|part| part.origin == Origin::Background) {
                let background = scene.background.to_array();
                let is_it = (0..3).all(|k| (part.own[k] - background[k]).abs() <= 1e-9 * background[k].abs().max(1.0));
                assert!(is_it, "{name} {pixel:?}: {:?} for {background:?}", part.own);
            }
        }
    }
    println!("the sums are off by at most {worst:e}");
}

/// A sample's part of the pixel, by every method, where the samples differ; also in f32, where the rest is rounding.
#[test]
fn samples_add_up_by_every_method() {
    use raywalk::scene::{Guided, Statistical};
    let statistical = Statistical { confidence: 0.95, tolerance: 0.01, min: 4, max: 32 };
    let methods = [
        Sampling::Regular { n: 3 },
        Sampling::Shared { n: 2 },
        Sampling::Adaptive { threshold: 0.05, depth: 3 },
        Sampling::Stochastic { n: 5 },
        Sampling::Random { n: 5 },
        Sampling::Sobol { n: 8 },
        Sampling::Statistical(statistical),
        Sampling::Guided(Guided { tolerance: 0.05, min: 4, max: 11 }),
    ];
    for name in ["textbook", "figure-6", "glass-and-mirror", "penumbra", "polished-surface"] {
        for sampling in methods {
            let mut scene = scene(name);
            scene.sampling = sampling;
            for pixel in grid(&scene, 2) {
                let log = record::pixel(&scene, pixel, Arithmetic::F64);
                let account = account_of(&log, &Tree::of(&log.events));
                let sum = contributions::sum(&account.contributions);
                let is_same =
                    (0..3).all(|k| (sum[k] - account.color[k]).abs() < 1e-9 * account.color[k].abs().max(1.0));
                let without = account.contributions.iter().all(|part| part.origin != Origin::Rounding);
                assert!(is_same && without, "{name} {sampling:?} {pixel:?}: {sum:?} for {:?}", account.color);
            }
        }
    }
}

/// The log of several pixels: each is opened by an event of its own and never left. (Nothing writes such logs yet; they are read.)
fn region(scene: &raywalk::scene::Scene, [left, top, right, bottom]: [u32; 4]) -> Log {
    let mut events = Events::new();
    for pixel in (top..bottom).flat_map(|y| (left..right).map(move |x| [x, y])) {
        events.add_all(&Event::opening(pixel).into());
        events.add_all(&record::pixel(scene, pixel, Arithmetic::F64).events);
    }
    let header = record::header(scene, Subject::Region([left, top, right, bottom]), Arithmetic::F64);
    let text = to_ndjson(&Log { header, events }).expect("a log can be written");
    read(&text).expect("what was written can be read").log
}

#[test]
fn each_pixel_of_a_region_has_its_own_account() {
    for (name, sampling) in [("textbook", None), ("glass-and-mirror", Some(Sampling::Regular { n: 2 }))] {
        let mut scene = scene(name);
        scene.sampling = sampling.unwrap_or(scene.sampling);
        let [x, y] = middle(&scene);
        let log = region(&scene, [x - 1, y - 1, x + 2, y + 1]);
        let tree = Tree::of(&log.events);
        let pixels: Vec<_> = tree.children(0).collect();
        assert_eq!(pixels.len(), 6, "{name}");
        let mut colors = Vec::new();
        for pixel in pixels {
            let Some(Step::Pixel(place)) = tree.nodes()[pixel].step else { panic!("{name}: node {pixel}") };
            let alone = record::pixel(&scene, place, Arithmetic::F64);
            let expected = account_of(&alone, &Tree::of(&alone.events));
            // From whichever node of the pixel one asks.
            for node in [pixel, pixel + 1, tree.nodes()[pixel].subtree_end - 1] {
                let account = contributions::account(&log, &tree, node);
                assert_eq!(account.color, record::pixel_color(&scene, place, Arithmetic::F64).to_array(), "{name}");
                assert_eq!(rows(&account), rows(&expected), "{name} {place:?}");
                assert_eq!(account.ended.len(), expected.ended.len(), "{name} {place:?}");
                let sum = contributions::sum(&account.contributions);
                let is_same =
                    (0..3).all(|k| (sum[k] - account.color[k]).abs() < 1e-9 * account.color[k].abs().max(1.0));
                assert!(is_same, "{name} {place:?}: {sum:?} for {:?}", account.color);
            }
            colors.push(expected.color);
        }
        assert!(colors.iter().any(|color| *color != colors[0]), "{name}: the pixels differ");
        // With none of them selected it is the first.
        assert_eq!(contributions::account(&log, &tree, 0).color, colors[0], "{name}");
    }
}

#[test]
fn what_brings_nothing_says_why() {
    let (log, tree) = by_hand();
    let ended = account_of(&log, &tree).ended;
    assert_eq!(ended.len(), 1, "{ended:?}");
    assert_eq!((ended[0].path.as_str(), ended[0].why), ("C R", Why::Decided));
    let (log, tree) = self::log("figure-6", Arithmetic::F64);
    let blocked = |ended: &contributions::Ended| matches!(ended.why, Why::Blocked { .. });
    assert!(account_of(&log, &tree).ended.iter().any(blocked));
}

#[test]
fn a_log_that_was_cut_off_is_accounted_for_as_far_as_it_goes() {
    let (log, _) = by_hand();
    for length in 0..log.events.len() {
        let mut log = log.clone();
        log.events.truncate(length);
        account_of(&log, &Tree::of(&log.events));
    }
}

#[test]
fn operands_of_the_numeric_example() {
    let (log, tree) = by_hand();
    let found = |event| -> Vec<_> {
        let operands = operands(&log, &tree, event).into_iter();
        operands.map(|operand| (operand.symbol, operand.is_given, operand.computed)).collect()
    };
    let t = at(&log, "plane.t", 1);
    assert_eq!(
        found(t),
        [("V_o", false, Some(at(&log, "plane.v_o", 1))), ("V_d", false, Some(at(&log, "plane.v_d", 1)))]
    );
    // The hit point takes the distance from the test that found it; the direction is the ray's own.
    let point = at(&log, "hit.point", 1);
    assert_eq!(
        found(point),
        [("O", true, None), ("d", false, Some(at(&log, "ray.direction", 1))), ("t", false, Some(t))]
    );
    // On the sphere the origin of the ray is the hit point on the plane, passed on.
    let oc = operands(&log, &tree, at(&log, "sphere.oc", 2));
    let origin = oc.iter().find(|operand| operand.symbol == "O").expect("its origin");
    assert_eq!((origin.is_given, origin.computed), (true, Some(point)));
    // The last sum takes three contributions, and I_reflected is the colour of the ray R.
    let reflected = operands(&log, &tree, at(&log, "combine.reflected", 2));
    let brought = reflected.iter().find(|operand| operand.symbol == "I_reflected").expect("its colour");
    assert_eq!(brought.computed, Some(at(&log, "combine.color", 1)));
    let local = operands(&log, &tree, at(&log, "shade.local", 1));
    let n_dot_l = local.iter().find(|operand| operand.symbol == "N·L").expect("N·L");
    assert_eq!(n_dot_l.computed, Some(at(&log, "shade.n_dot_l", 1)));
    assert!(n_dot_l.light.is_some());
}

#[test]
fn uses_of_the_numeric_example() {
    let (log, tree) = by_hand();
    let keys = |event| -> Vec<_> {
        let key = |at: usize| match log.events[at].what {
            What::Note { name, .. } => name.key(),
            _ => "enter",
        };
        uses(&log, &tree, event, usize::MAX).into_iter().map(key).collect()
    };
    assert_eq!(keys(at(&log, "plane.v_d", 1)), ["plane.t"]);
    assert_eq!(keys(at(&log, "plane.t", 1)), ["hit.point"]);
    assert_eq!(keys(at(&log, "combine.color", 1)), ["combine.reflected"]);
    assert_eq!(keys(at(&log, "shade.local", 2)), ["combine.local"]);
    assert_eq!(keys(at(&log, "combine.color", 2)), Vec::<&str>::new());
    assert!(keys(at(&log, "shade.n_dot_l", 1)).contains(&"shade.local"));
}

/// The two directions say the same, on every value of every built-in scene whose log isn't too long for this.
#[test]
fn a_step_is_among_the_uses_of_its_operands_and_only_of_those() {
    for name in builtin::names() {
        let (log, tree) = log(name, Arithmetic::F64);
        if log.events.len() > 6000 {
            continue;
        }
        let mut by_operands = vec![Vec::new(); log.events.len()];
        for event in 0..log.events.len() {
            for operand in operands(&log, &tree, event) {
                if let Some(source) = operand.computed.filter(|source| !by_operands[*source].contains(&event)) {
                    by_operands[source].push(event);
                }
            }
        }
        for (event, expected) in by_operands.iter().enumerate() {
            let found = uses(&log, &tree, event, usize::MAX);
            assert_eq!(&found, expected, "{name}: uses of {event}, {:?}", log.events[event].what);
        }
    }
}

/// Ten thousand copies of the example's tree under one root: uses of a value at the root are looked for in a million events.
#[test]
fn uses_are_found_in_a_million_events() {
    let (log, _) = by_hand();
    let ray = Tree::of(&log.events).nodes()[1].events.clone();
    let mut events = log.events.clone();
    let inner = events[3..ray.end - 1].to_vec();
    events.truncate(3);
    while events.len() < 1_000_000 {
        events.extend(inner.iter().cloned());
    }
    let large = Log { events, ..log };
    let tree = Tree::of(&large.events);
    let note = at(&large, "ray.direction", 1);
    // Where they are looked for and where not makes the difference of a minute here.
    let found = uses(&large, &tree, note, 1000);
    assert_eq!(found.len(), 1000);
}

#[test]
fn operands_have_the_values_that_the_formula_puts_in() {
    let (log, tree) = by_hand();
    let t2_a = operands(&log, &tree, at(&log, "sphere.t2_a", 2));
    let values: Vec<_> = t2_a.iter().map(|operand| (operand.symbol, operand.value)).collect();
    assert_eq!(values[0], (Name::SphereRadiusSquared.symbol(), Value::Number(9.0)));
    assert_eq!(values.len(), 3);
}

#[test]
fn every_event_of_every_built_in_scene_has_a_line_of_its_algorithm() {
    use raywalk::report::pseudocode::{self, Stage};
    let mut met = std::collections::HashSet::new();
    for name in builtin::names() {
        let (log, tree) = log(name, Arithmetic::F64);
        for event in 0..log.events.len() {
            let stage = pseudocode::stage(&log, &tree, event);
            let line = pseudocode::lines(&log.header)[pseudocode::current_line(&log, &tree, event)];
            assert!(line.stages.contains(&stage), "{name}: {event} at {line:?}");
            met.insert(stage);
        }
    }
    // Every stage is met somewhere; only logs of a region have events that open a pixel.
    let unmet: Vec<_> = Stage::ALL.iter().filter(|stage| !met.contains(stage) && **stage != Stage::Pixel).collect();
    assert!(unmet.is_empty(), "{unmet:?}");
}

#[test]
fn lines_and_calls_of_the_numeric_example() {
    use raywalk::report::pseudocode::{current_line, lines, stack};
    let (log, tree) = by_hand();
    let text = |event| lines(&log.header)[current_line(&log, &tree, event)].text(Language::English);
    assert_eq!(text(at(&log, "plane.t", 1)), "point = nearest_intersection(origin, direction)");
    assert_eq!(text(at(&log, "reflect.direction", 1)), "dir_r = reflection_direction()");
    assert_eq!(text(at(&log, "shade.n_dot_h", 1)), "diffuse, specular and transmitted terms");
    assert_eq!(text(at(&log, "combine.reflected", 1)), "reflected, W_r,");
    let calls = stack(Language::English, &log, &tree, at(&log, "sphere.t2_a", 3));
    let calls: Vec<_> =
        calls.iter().map(|call| (call.text.as_str(), lines(&log.header)[call.line].text(Language::English))).collect();
    assert_eq!(
        calls,
        [
            ("TR(C, 0)", "reflected = TR(point, dir_r, depth + 1)"),
            ("TR(C R, 1)", "point = nearest_intersection(origin, direction)")
        ]
    );
}

#[test]
fn arithmetics_side_by_side() {
    use raywalk::report::side_by_side::{Run, table};
    let logs =
        [Arithmetic::Decimal(3), Arithmetic::F32, Arithmetic::F64].map(|arithmetic| self::log("textbook", arithmetic));
    let runs = logs.each_ref().map(|(log, tree)| Run { log, tree });
    let event = at(runs[0].log, "sphere.t2_a", 3);
    let table = table(&runs, runs[0].tree.owner(event));
    assert_eq!((table.reaches.as_slice(), table.agrees.as_slice()), ([true; 3].as_slice(), [true; 3].as_slice()));
    let row = table.rows.iter().find(|row| row.name.is_some_and(|name| name.key() == "sphere.t2_a")).expect("its row");
    let numbers: Vec<f64> = row.values.iter().flatten().map(|value| value.components()[0]).collect();
    assert_eq!(numbers[0], 6.38);
    assert_eq!(f64::from(numbers[1] as f32), numbers[1]);
    assert!((numbers[2] - 6.304_347_826_086_957).abs() < 1e-12);
    // A run that is cut off never comes there.
    let mut short = logs[2].0.clone();
    short.events.truncate(10);
    let short_tree = Tree::of(&short.events);
    let cut = raywalk::report::side_by_side::table(
        &[runs[0], Run { log: &short, tree: &short_tree }],
        runs[0].tree.owner(event),
    );
    assert_eq!(cut.reaches, [true, false]);
    assert!(cut.rows.iter().all(|row| row.values[1].is_none()));
}

#[test]
fn a_long_log_is_accounted_for() {
    let mut scene = scene("penumbra");
    scene.sampling = Sampling::Sobol { n: 512 };
    let log = record::pixel(&scene, middle(&scene), Arithmetic::F64);
    let tree = Tree::of(&log.events);
    let account = account_of(&log, &tree);
    assert!(account.contributions.len() >= 512);
}
