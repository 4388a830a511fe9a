//! What is watched: its values here and everywhere, in any log, and what a quiz keeps.

use super::super::dump::dump;
use super::super::listing::listing;
use super::super::testing::{flat, glass, lit_from_behind, nested, sized, textbook, typed};
use super::super::{Palette, Theme, frame, live};
use super::*;
use crate::log::{Log, What};
use std::collections::HashMap;

fn said(model: &Model) -> &str {
    model.message.as_ref().map_or("", |message| &message.text)
}

/// The texts of the list that is open.
fn listed(model: &Model, kind: Kind) -> Vec<String> {
    listing(model, kind).entries.into_iter().map(|entry| entry.text).collect()
}

/// The steps, from 1, that note a quantity, by going through the log.
fn noted(log: &Log, key: &str) -> Vec<usize> {
    let is_it = |event: &crate::log::Event| event.noted().is_some_and(|(name, _)| name.key() == key);
    (1..).zip(log.events.iter()).filter(|(_, event)| is_it(event)).map(|(step, _)| step).collect()
}

/// The steps that a list leads to.
fn targets(model: &Model, kind: Kind) -> Vec<usize> {
    listing(model, kind).entries.iter().filter_map(|entry| entry.target.map(|event| event + 1)).collect()
}

#[test]
fn all_values_are_listed_and_led_to() {
    let mut model = sized(glass(), 100, 30);
    add(&mut model, "shade.n_dot_l").expect("a key");
    let steps = noted(&model.log, "shade.n_dot_l");
    assert!(steps.len() > 5);
    assert_eq!(said(&model), format!("watching shade.n_dot_l: {} values; :watch lists all", steps.len()));
    add(&mut model, "").expect("the list");
    assert_eq!(targets(&model, Kind::Watches), steps);
    let texts = listed(&model, Kind::Watches);
    assert!(texts[0].starts_with(&format!("N·L: no value here; {} values, ", steps.len())), "{}", texts[0]);
    typed(&mut model, "j j Enter");
    assert_eq!((model.step(), model.overlay), (steps[1], None));
    // An overview leads to the history, at the value that holds here.
    add(&mut model, "").expect("the list");
    typed(&mut model, "Enter");
    assert_eq!(targets(&model, Kind::History), steps);
    assert_eq!(model.overlay, Some(Overlay::List { kind: Kind::History, selected: 2, shift: 0 }));
    typed(&mut model, "G Enter");
    assert_eq!(Some(&model.step()), steps.last());
}

/// What goes through the log by hand says holds at each step: the latest value in the nodes that are open.
#[test]
fn the_value_here_is_that_of_the_innermost_open_node() {
    let mut model = sized(glass(), 100, 30);
    for key in ["shade.n_dot_l", "ray.direction", "shade.n_dot_h"] {
        add(&mut model, key).expect("a key");
    }
    let pinned = model.guide.watches.pinned.clone();
    let log = model.log.clone();
    let mut open: Vec<HashMap<&str, Value>> = vec![HashMap::new()];
    let (mut found, mut none) = (0, 0);
    for (at, event) in log.events.iter().enumerate() {
        if let What::Enter { .. } = event.what {
            open.push(HashMap::new());
        }
        let here = open.last_mut().expect("the root is open");
        here.extend(log.events.given(event).iter().map(|(name, value)| (name.key(), *value)));
        here.extend(event.noted().map(|(name, value)| (name.key(), value)));
        model.go_to_event(at);
        for watched in &pinned {
            let expected = open.iter().rev().find_map(|node| node.get(watched.key().as_str()).copied());
            let value = super::here(&model, watched).map(|here| here.value);
            assert_eq!(value, expected, "{} at step {}", watched.key(), at + 1);
            *(if value.is_some() { &mut found } else { &mut none }) += 1;
        }
        if event.what == What::Leave {
            open.pop();
        }
    }
    assert!(found > 100 && none > 100, "{found} {none}");
}

#[test]
fn what_is_pinned_survives_another_log() {
    let mut model = sized(glass(), 100, 30);
    for text in ["N·L", "N*H", "shade.local.r", "|N|"] {
        add(&mut model, text).unwrap_or_else(|why| panic!("{text}: {why}"));
    }
    open_history(&mut model, "N·L").expect("a symbol");
    let keys: Vec<_> = model.guide.watches.pinned.iter().map(Watched::key).collect();
    assert_eq!(keys, ["shade.n_dot_l", "shade.n_dot_h", "shade.local.r", "|hit.normal|"]);
    for log in [textbook(), flat(), lit_from_behind(), nested(""), glass()] {
        live::show_log(&mut model, log);
        assert_eq!(targets(&model, Kind::History), noted(&model.log, "shade.n_dot_l"));
        let expected: Vec<_> = ["shade.n_dot_l", "shade.n_dot_h", "shade.local", "hit.normal"]
            .into_iter()
            .flat_map(|key| noted(&model.log, key))
            .collect();
        assert_eq!(targets(&model, Kind::Watches), expected);
    }
    remove(&mut model, "shade.local.r").expect("it is pinned");
    assert_eq!(said(&model), "no longer watching shade.local.r");
    add(&mut model, "").expect("the list");
    typed(&mut model, "d d");
    assert_eq!(model.guide.watches.pinned.iter().map(Watched::key).collect::<Vec<_>>(), ["|hit.normal|"]);
    typed(&mut model, "G d d");
    assert!(model.guide.watches.pinned.is_empty());
    assert!(listed(&model, Kind::Watches).is_empty());
}

#[test]
fn what_cant_be_watched_is_explained() {
    let mut model = sized(glass(), 100, 30);
    for (text, why) in [
        ("shade.n_dot_k", "did you mean `shade.n_dot_l`?"),
        ("N·K", "did you mean `N·"),
        ("zzzzzzzzz", "expected a key such as shade.n_dot_l"),
        ("t", "`t` may be plane.t, sphere.t"),
        ("N·L.x", "N·L is a number and has no components"),
        ("\x1b[2J", "\\u{1b}[2J"),
    ] {
        assert!(add(&mut model, text).is_err_and(|said| said.contains(why)), "{text}");
        assert!(open_history(&mut model, text).is_err(), "{text}");
    }
    assert!(remove(&mut model, "N·L").is_err_and(|said| said.contains("nothing is")));
    add(&mut model, "V_d").expect("the log has planes only");
    assert!(remove(&mut model, "N·L").is_err_and(|said| said.ends_with("but plane.v_d")));
    assert!(open_history(&mut model, "").is_err_and(|said| said.contains("this step computes no quantity")));
    // It may be in another pixel.
    add(&mut model, "torus.t").expect_err("there is none");
    add(&mut model, "cone.t_0").expect("a key");
    assert!(said(&model).contains("which this log doesn't have"), "{}", said(&model));
}

#[test]
fn keys_watch_the_quantity_here() {
    let mut model = sized(textbook(), 100, 30);
    typed(&mut model, "*");
    assert!(said(&model).contains("computes no quantity"), "{}", said(&model));
    typed(&mut model, "n *");
    assert_eq!(model.guide.watches.pinned.len(), 1);
    typed(&mut model, "*");
    assert_eq!((said(&model), model.guide.watches.pinned.len()), ("no longer watching ray.length", 0));
    typed(&mut model, "#");
    assert_eq!(targets(&model, Kind::History), noted(&model.log, "ray.length"));
}

#[test]
fn completions_are_the_keys_of_the_log() {
    let mut model = sized(textbook(), 100, 30);
    assert_eq!(completions(&model, "plane.v"), ["plane.v_d", "plane.v_o"]);
    assert!(completions(&model, "cone.").iter().all(|key| key.starts_with("cone.")));
    add(&mut model, "plane.v_d").expect("a key");
    assert_eq!(pinned_completions(&model, ""), ["plane.v_d"]);
    typed(&mut model, ":watch Space plane.v Tab");
    assert_eq!(model.prompt.as_ref().map(|prompt| prompt.line.value().to_owned()).as_deref(), Some("watch plane.v_"));
}

#[test]
fn values_are_below_the_computation_while_one_steps() {
    let theme = Theme::new(Palette::None, false);
    let mut model = sized(textbook(), 80, 24);
    add(&mut model, "N·L").expect("a symbol");
    let shown = |model: &Model| dump(&frame(model, 80, 24, &theme));
    typed(&mut model, "0");
    assert!(shown(&model).contains("N·L: no value here"), "{}", shown(&model));
    let step = noted(&model.log, "shade.n_dot_l")[0];
    typed(&mut model, &format!("{step}G"));
    let value = model.value(&model.here(&[Name::ShadeNDotL]).expect("it is computed here").value);
    let line = format!("  N·L = {value}");
    assert!(shown(&model).contains(&line), "{line}\n{}", shown(&model));
    // As many as fit, and how many more there are.
    for key in ["N·H", "ray.length", "ray.direction", "hit.point", "hit.normal", "light.distance"] {
        add(&mut model, key).unwrap_or_else(|why| panic!("{key}: {why}"));
    }
    typed(&mut model, "Esc");
    assert!(shown(&model).contains("  3 more: :watch"), "{}", shown(&model));
}

#[test]
fn a_quiz_keeps_its_answers() {
    let theme = Theme::new(Palette::None, false);
    let mut model = sized(glass(), 120, 40);
    let step = noted(&model.log, "shade.n_dot_l")[0];
    typed(&mut model, &format!("{step}G"));
    let answer = model.value(&model.here(&[Name::ShadeNDotL]).expect("it is computed here").value);
    typed(&mut model, "Q");
    add(&mut model, "N·L").expect("a symbol");
    assert_eq!(said(&model), "watching shade.n_dot_l; :watch lists all");
    typed(&mut model, "Esc");
    for keys in ["", "#"] {
        typed(&mut model, keys);
        let shown = dump(&frame(&model, 120, 40, &theme));
        assert!(!shown.contains(&answer), "{answer} after {keys}:\n{shown}");
        assert!(targets(&model, Kind::Watches).is_empty());
    }
    typed(&mut model, "Esc ]");
    assert_eq!(targets(&model, Kind::Watches), [step]);
    // A tree that grows tells nothing that is to come.
    typed(&mut model, "Q t");
    assert_eq!(targets(&model, Kind::Watches), [step]);
}

#[test]
fn long_histories_are_listed_around_the_step() {
    let mut model = sized(nested(&"(.)".repeat(3000)), 100, 30);
    add(&mut model, "V_d").expect("a symbol");
    model.go_to_event(4501);
    open_history(&mut model, "plane.v_d").expect("a key");
    let texts = listed(&model, Kind::History);
    assert_eq!(texts.len(), MOST + 3);
    assert!(texts[0].contains("3000 values, 2 to 8999"), "{}", texts[0]);
    assert!(texts[1].starts_with("... ") && texts[1].ends_with(" earlier"), "{}", texts[1]);
    assert!(texts[MOST + 2].ends_with(" later"), "{}", texts[MOST + 2]);
    typed(&mut model, "Enter");
    assert_eq!(model.step(), 4502);
    for (width, height) in [(20, 6), (40, 12), (300, 100)] {
        typed(&mut model, "#");
        frame(&model, width, height, &Theme::new(Palette::None, true));
        typed(&mut model, "Esc");
    }
}

#[test]
fn spreads_are_bars_between_the_least_and_the_greatest() {
    let bars =
        |numbers: &[f64], most| Spread::of(numbers, most).map(|spread| (spread.least, spread.greatest, spread.bars));
    assert_eq!(bars(&[1.0, 3.0, 2.0], 9), Some((1.0, 3.0, vec![Some(0.0), Some(1.0), Some(0.5)])));
    assert_eq!(bars(&[1.0, 3.0, 2.0, 2.0], 2), Some((1.0, 3.0, vec![Some(0.5), Some(0.5)])));
    assert_eq!(bars(&[5.0, f64::NAN, 5.0], 9), Some((5.0, 5.0, vec![Some(0.5), None, Some(0.5)])));
    assert_eq!(bars(&[f64::NAN, f64::INFINITY], 9), None);
    assert_eq!(bars(&[], 9), None);
    assert_eq!(bars(&[f64::MIN, f64::MAX], 9), Some((f64::MIN, f64::MAX, vec![Some(0.0), Some(1.0)])));
}
