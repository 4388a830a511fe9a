//! What the keys for understanding do.

use super::dump::dump;
use super::testing::{glass, log_of, nested, sized, textbook, typed};
use super::*;
use crate::log::What;
use crate::record::Arithmetic;

/// The symbol of the quantity at the current step; `-` for other events.
fn symbol(model: &Model) -> &'static str {
    match model.log.events[model.event].what {
        What::Note { name, .. } => name.symbol(),
        _ => "-",
    }
}

/// Types `keys` at the numeric example; the current step is then this quantity, and nothing lies over the panes.
#[track_caller]
fn leads_to(keys: &str, expected: &str) {
    let mut model = sized(textbook(), 100, 30);
    typed(&mut model, keys);
    assert_eq!(symbol(&model), expected, "after {keys}");
    assert_eq!(model.overlay, None, "after {keys}");
}

#[test]
fn values_lead_to_their_operands_and_uses_and_back() {
    // The fifth value is t = V_o/V_d.
    leads_to("5n", "t");
    leads_to("5n d Enter", "V_o");
    leads_to("5n d j Enter", "V_d");
    leads_to("5n d j Enter ^o", "t");
    leads_to("5n D Enter", "P");
    leads_to("5n D Enter D Enter ^o ^o", "t");
    leads_to("5n d Esc", "t");
    leads_to("5n ^o", "t");
}

#[test]
fn the_colour_is_accounted_for_and_leads_to_its_parts() {
    let mut model = sized(textbook(), 100, 30);
    typed(&mut model, "w");
    let text = dump(&frame(&model, 100, 30, &Theme::new(Palette::None, false)));
    assert!(text.contains("(394.134, "), "{text}");
    assert!(text.contains("60.6 %  C R S1  F on sphere  "), "{text}");
    assert!(text.contains("depth limit"), "{text}");
    typed(&mut model, "Enter");
    let title = crate::report::words::title(Language::English, &model.log, &model.tree, model.cursor);
    assert_eq!((title.as_str(), model.tree.path(model.cursor).as_str()), ("light F", "C R"));
}

#[test]
fn arithmetics_are_asked_for_and_then_shown() {
    let mut model = sized(textbook(), 100, 30);
    assert_eq!(typed(&mut model, "4n a"), Effect::Compare);
    live::answer(&mut model, Effect::Compare, &mut None);
    assert!(model.message.as_ref().is_some_and(|message| message.text.contains("no scene")));
    assert_eq!(model.overlay, None);
    struct Others;
    impl Live for Others {
        fn trace(&mut self, _: [u32; 2]) -> Result<Log, Refusal> {
            Err(Refusal::Other("no".to_owned()))
        }
        fn compare(&mut self, _: Subject) -> Result<Vec<Log>, Refusal> {
            Ok(vec![textbook()])
        }
    }
    let mut others = Others;
    live::answer(&mut model, Effect::Compare, &mut Some(&mut others));
    assert_eq!(model.overlay, Some(Overlay::List { kind: Kind::Arithmetics, selected: 0, shift: 0 }));
    let text = dump(&frame(&model, 100, 30, &Theme::new(Palette::None, false)));
    assert!(text.contains("by hand") && text.contains("-0.946"), "{text}");
}

#[test]
fn a_quiz_is_answered() {
    let said = |model: &Model| model.message.as_ref().map(|message| message.text.clone()).unwrap_or_default();
    let mut model = sized(textbook(), 100, 30);
    typed(&mut model, "Q 3n");
    assert_eq!(symbol(&model), "V_d");
    let screen = |model: &Model| dump(&frame(model, 100, 30, &Theme::new(Palette::None, false)));
    assert!(!screen(&model).contains("= -0.946 "), "{}", screen(&model));
    assert!(screen(&model).contains("= ?"), "{}", screen(&model));
    typed(&mut model, "= x Enter");
    assert!(said(&model).contains("no number"), "{}", said(&model));
    typed(&mut model, "^u - 0 , 9 4 6 Enter");
    assert_eq!(said(&model), "right");
    // Two values and a decision were passed before.
    assert_eq!(model.score().as_deref(), Some("quiz 1 right, 2 passed"));
    assert!(!model.hides(model.event));
    typed(&mut model, "n = 1 Enter");
    assert!(said(&model).starts_with("off by 13; try again"), "{}", said(&model));
    typed(&mut model, "= 1 Enter");
    assert_eq!(said(&model), "off by 13; it is -12");
    assert_eq!(model.score().as_deref(), Some("quiz 1 right, 1 told, 2 passed"));
    // Where the computation has the focus Enter asks, too.
    typed(&mut model, "n Tab Enter");
    assert!(model.prompt.is_some());
    typed(&mut model, "Esc w");
    assert_eq!(model.overlay, None);
    typed(&mut model, "Q");
    assert!(said(&model).contains("1 right at the first try, 0 later, 1 told"), "{}", said(&model));
    assert_eq!(model.score(), None);
}

/// Types answers at the last step with this symbol; each is judged so, in a quiz of its own, beside the line that the step shows.
#[track_caller]
fn judges(arithmetic: Arithmetic, key: &str, line: &str, answers: &[(&str, &str)]) {
    for (answer, expected) in answers {
        let mut model = sized(log_of("textbook", arithmetic), 140, 30);
        model.numbers = crate::report::Style::of(&model.log.header, 3);
        let is_it = |event: &crate::log::Event| event.noted().is_some_and(|(name, _)| name.key() == key);
        let event = model.log.events.iter().rposition(is_it).expect("the example has the quantity");
        typed(&mut model, &format!("{}G Q =", event + 1));
        let shown = dump(&frame(&model, 140, 30, &Theme::new(Palette::None, false)));
        assert!(shown.contains(line), "{shown}");
        prompt::pasted(&mut model, answer);
        typed(&mut model, "Enter");
        assert_eq!(model.message.as_ref().map(|message| message.text.as_str()), Some(*expected), "{answer}");
    }
}

/// What follows from the numbers on the screen is right, and so is the value itself; what follows from neither is wrong.
#[test]
fn answers_from_the_screen_are_right() {
    let as_shown = "right with the numbers as shown; the value is 6.304";
    judges(
        Arithmetic::F64,
        "sphere.t2_a",
        "9 − 178 + 13.240² = ?",
        &[("6.298", as_shown), ("6.304", "right"), ("6.311", "off by 0.00665; try again")],
    );
    // The book prints P₂ = (14.139, 9.376, 8.847).
    judges(
        Arithmetic::Printed,
        "hit.point",
        "(4, 6, 8) + (0.946, 0.315, 0.079)·10.718 = ?",
        &[("14.139 9.376 8.847", "right"), ("14.139 9.376 8.857", "off by 0.010; try again")],
    );
}

/// What was passed counts, and is hidden again where one goes back; then an answer isn't one at the first try.
#[test]
fn the_score_counts_every_value() {
    let mut model = sized(textbook(), 100, 30);
    typed(&mut model, "Q");
    let asked = |model: &Model| {
        let before = model.log.events.iter().take(model.event);
        before.filter(|event| matches!(event.what, What::Note { .. } | What::Mark(_) | What::Result { .. })).count()
    };
    typed(&mut model, "5n");
    let passed = asked(&model);
    assert_eq!(model.understanding.quiz.as_ref().map(|quiz| quiz.score()), Some([0, 0, 0, passed as u32]));
    typed(&mut model, "2N");
    let passed = asked(&model) as u32;
    typed(&mut model, "= -0.946 Enter");
    assert_eq!(model.understanding.quiz.as_ref().map(|quiz| quiz.score()), Some([0, 1, 0, passed]));
    typed(&mut model, "$");
    let all = asked(&model) as u32;
    assert_eq!(model.understanding.quiz.as_ref().map(|quiz| quiz.score()), Some([0, 1, 0, all - 1]));
}

/// No frame of a quiz shows a result of a later step that doesn't occur before.
#[test]
fn a_quiz_tells_no_later_result() {
    let theme = Theme::new(Palette::None, false);
    let mut model = sized(textbook(), 200, 60);
    typed(&mut model, "Q");
    let is_sum =
        |event: &crate::log::Event| matches!(event.what, What::Note { name: crate::log::Name::CombineColor, .. });
    let last = model.log.events.iter().rposition(is_sum).unwrap_or_default();
    while model.event <= last {
        let text = dump(&frame(&model, 200, 60, &theme));
        assert!(!text.contains("394.134"), "step {}:\n{text}", model.step());
        if model.event < 50 {
            assert!(!text.contains("289.296"), "step {}:\n{text}", model.step());
        }
        typed(&mut model, "]");
    }
}

#[test]
fn understanding_keys_do_no_harm_anywhere() {
    for log in [textbook(), glass(), nested(""), nested("."), nested("(((")] {
        for size in [(0, 0), (1, 1), (20, 6), (40, 12), (200, 60)] {
            let mut model = sized(log.clone(), size.0, size.1);
            for keys in
                ["d", "Esc D", "Esc w", "G Enter", "^o", "Q", "=", "1 Enter", "Esc Q w j j k Esc", "7n d Enter D Enter"]
            {
                typed(&mut model, keys);
                frame(&model, size.0, size.1, &Theme::new(Palette::True, true));
            }
        }
    }
}

#[test]
fn the_algorithm_is_drawn_with_its_line_and_calls() {
    let mut model = sized(textbook(), 100, 30);
    typed(&mut model, "28n");
    for (width, height) in [(0, 0), (1, 1), (30, 5), (50, 30)] {
        let area = Rect::new(0, 0, width, height);
        let mut buffer = Buffer::empty(area);
        view::code::draw(&model, &Theme::new(Palette::None, false), area, &mut buffer);
        let text = dump(&buffer);
        if height == 30 {
            assert!(text.contains("▶   point = nearest_intersection"), "{text}");
            assert!(text.contains("TR(C, 0)") && text.contains("TR(C R, 1)"), "{text}");
        }
    }
}

/// The distance to the plane and the colour of the numeric example, by hand.
const HIDDEN: [&str; 2] = ["12.685", "394.134"];

#[test]
fn a_quiz_tells_nothing() {
    for keys in [
        "",
        "y",
        "g y",
        "/ 12.685 <Enter>",
        "b plane.t <Enter> r",
        "b plane.t <Enter> r L",
        "b plane.t <Enter> r y",
        "b plane.t <Enter> r m a N M",
        "w",
        "a",
        "t E",
        "Tab",
        "f plane <Enter>",
        ":bookmarks <Enter>",
    ] {
        let mut model = sized(textbook(), 100, 30);
        let effect = typed(&mut model, &format!("Q {keys}"));
        let shown = dump(&frame(&model, 100, 30, &Theme::new(Palette::None, false)));
        for hidden in HIDDEN {
            let is_typed = keys.contains(hidden);
            assert!(is_typed || !shown.contains(hidden), "{hidden} after {keys}:\n{shown}");
            assert!(!matches!(&effect, Effect::Copy(text) if text.contains(hidden)), "{hidden} after {keys}");
        }
        if keys.starts_with('/') {
            assert!(shown.contains("not found: 12.685") && !shown.contains("match 1"), "{shown}");
        }
    }
}

/// The words and signs of decisions in the glass ball's log, which no frame of a quiz shows before they are passed.
#[test]
fn a_quiz_tells_no_later_decision() {
    let theme = Theme::new(Palette::None, false);
    let words = ["hit", "miss", "blocked", " lit", "background", "total reflection", "depth limit", "inside"];
    let shown = |model: &Model| dump(&frame(model, 200, 60, &theme));
    let mut model = sized(glass(), 200, 60);
    let everything = shown(&model);
    assert!(words.iter().filter(|word| everything.contains(*word)).count() > 2, "{everything}");
    typed(&mut model, "Q");
    let begun = shown(&model);
    assert!(begun.contains("test ball  ?"), "{begun}");
    for word in words {
        // The title of a test and the algorithm have such words, too; those are no decisions.
        let trees = begun.lines().map(|line| line.split('│').next().unwrap_or_default());
        assert!(trees.clone().all(|line| !line.contains(word)), "{word}\n{begun}");
    }
    // The first decision is hidden where it is taken, and known where it is passed.
    let is_mark = |event: &crate::log::Event| matches!(event.what, What::Mark(_));
    let first = model.log.events.iter().position(is_mark).expect("a decision");
    typed(&mut model, &format!("{}G", first + 1));
    assert!(model.hides_name(first));
    let at_it = shown(&model);
    typed(&mut model, "s");
    let after = shown(&model);
    let crate::log::What::Mark(decision) = model.log.events[first].what else { panic!("a decision") };
    let text = crate::report::words::decision(Language::English, &model.log.header, &decision, model.numbers);
    assert!(!at_it.contains(&text) && after.contains(&text), "{text}\n{at_it}\n{after}");
}

/// Sets a breakpoint in a quiz of the glass ball and types `keys`; then this is said.
#[track_caller]
fn a_run_says(breakpoint: &str, keys: &str, expected: &str) {
    let mut model = sized(glass(), 100, 30);
    typed(&mut model, &format!("Q b {} Enter {keys}", breakpoint.replace(' ', " Space ").replace("Space", "<Space>")));
    let said = model.message.as_ref().map(|message| message.text.clone()).unwrap_or_default();
    assert!(said.contains(expected), "{breakpoint}, {keys}: {said}");
    let told = model.step() > 1;
    assert_eq!(told, !expected.contains("a quiz hides"), "{breakpoint}, {keys}: step {}", model.step());
}

#[test]
fn a_run_in_a_quiz_tells_nothing() {
    for keys in ["r", "B Enter", "R B Enter"] {
        for breakpoint in ["hit", "nearest", "shade.n_dot_l>0.3", "|ray.direction|~1", "total-internal-reflection"] {
            a_run_says(breakpoint, keys, "a quiz hides where that stops; Q ends it");
        }
    }
    a_run_says("shadow", "r", "stopped by shadow");
    a_run_says("shade.n_dot_l", "r", "stopped by shade.n_dot_l");
    a_run_says("result", "r", "result ?");
    // The test of an object is seen, a decision that names it isn't before it is passed.
    a_run_says("object ball", "r", "stopped by object ball: test ball");
    // What was passed is shown, and so is everything after the quiz.
    a_run_says("hit", "$ R", "stopped by hit");
    a_run_says("hit", "Q r", "stopped by hit: hit");
}

#[test]
fn a_quiz_asks_for_decisions() {
    let said = |model: &Model| model.message.as_ref().map(|message| message.text.clone()).unwrap_or_default();
    let mut model = sized(textbook(), 100, 30);
    let is = |wanted: &'static str| {
        move |event: &crate::log::Event| crate::tui::model::breakpoint::kind::of(&event.what).contains(&wanted)
    };
    let nearest = model.log.events.iter().position(is("nearest")).expect("a nearest hit");
    let hit = model.log.events.iter().position(is("hit")).expect("a hit");
    typed(&mut model, &format!("Q {}G =", hit + 1));
    assert!(said(&model).contains("what is decided"), "{}", said(&model));
    typed(&mut model, "h i t t Enter");
    assert!(said(&model).contains("no decision") && model.prompt.is_some(), "{}", said(&model));
    typed(&mut model, "^u h i t Enter");
    assert_eq!((said(&model).as_str(), model.score().as_deref()), ("right", Some("quiz 1 right, 5 passed")));
    typed(&mut model, &format!("{}G = m i s s Enter", nearest + 1));
    assert_eq!(said(&model), "it isn't; try again");
    for keys in ["Y", "x"] {
        typed(&mut model, keys);
        assert!(said(&model).contains("would tell the decision"), "{keys}: {}", said(&model));
    }
    typed(&mut model, "m a");
    assert_eq!(said(&model), "bookmark a: decision ?");
    let What::Mark(crate::log::Decision::Nearest { object }) = model.log.events[nearest].what else {
        panic!("nearest")
    };
    let name = model.log.header.object(object).to_owned();
    let keys: Vec<_> = name.chars().map(String::from).collect();
    typed(&mut model, &format!("= {} Enter", keys.join(" ")));
    assert_eq!((said(&model).as_str(), model.score().as_deref()), ("right", Some("quiz 1 right, 1 later, 11 passed")));
    // What is searched isn't found where it would tell.
    typed(&mut model, "0 / b a c k g r o u n d Enter");
    assert!(said(&model).contains("not found"), "{}", said(&model));
    // What was answered is found, and nothing else of its kind before it is passed.
    typed(&mut model, "Esc / n e a r e s t Enter");
    assert_eq!(model.event, nearest);
    typed(&mut model, ";");
    assert_eq!((model.event, said(&model).as_str()), (nearest, "from the beginning again"));
    typed(&mut model, "$ , ");
    assert!(model.event > nearest);
    typed(&mut model, "0 Esc Q / n e a r e s t Enter");
    assert_eq!(model.event, nearest);
}

#[test]
fn a_quiz_goes_on_in_another_pixel() {
    let mut model = sized(textbook(), 100, 30);
    typed(&mut model, "Q 3n = 1 Enter");
    let asked = model.event;
    live::show_log(&mut model, glass());
    assert!(model.understanding.quiz.is_some() && model.hides(model.log.events.len() - 1));
    // A miss counts for the step of its pixel alone, and an answer is one also after another pixel.
    live::show_log(&mut model, textbook());
    model.go_to_event(asked);
    typed(&mut model, "= - 0 . 9 4 6 Enter");
    // It was passed, so it could be seen: the answer is a later one.
    assert_eq!(model.score().as_deref(), Some("quiz 1 later, 2 passed"));
    live::show_log(&mut model, glass());
    live::show_log(&mut model, textbook());
    model.go_to_event(asked);
    assert!(!model.hides(asked));
    typed(&mut model, "=");
    assert!(model.prompt.is_none());
    typed(&mut model, "Q Q");
    assert!(model.hides(asked), "another quiz starts again");
}
