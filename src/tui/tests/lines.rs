//! The lines that one types: commands, lines that are wrong, brought back and completed.

use super::*;

pub fn said(model: &Model) -> &str {
    model.message.as_ref().map_or("", |message| &message.text)
}

/// Types a line behind a key and ends it.
pub fn line(model: &mut Model, key: &str, text: &str) -> Effect {
    begin(model, key, text);
    typed(model, "Enter")
}

/// Types a line behind a key.
pub fn begin(model: &mut Model, key: &str, text: &str) {
    typed(model, key);
    for character in text.chars() {
        let key = if character == ' ' { "Space".to_owned() } else { character.to_string() };
        typed(model, &key);
    }
}
#[test]
fn commands() {
    let mut model = sized(textbook(), 100, 30);
    line(&mut model, ":", "42");
    assert_eq!(model.step(), 42);
    line(&mut model, ":", "4200");
    assert_eq!((model.step(), said(&model)), (98, "there are steps 1 to 98"));
    for (text, step) in [("0", 1), ("99999999999999999999999", 98), ("-3", 1), ("3.5", 1)] {
        line(&mut model, ":", text);
        assert_eq!((model.step(), said(&model)), (step, "there are steps 1 to 98"), ":{text}");
    }
    typed(&mut model, "Esc");
    line(&mut model, ":", "break T2_A < 0");
    assert_eq!(model.guide.breakpoints.len(), 1);
    line(&mut model, ":", "search plane");
    assert!(model.guide.search.is_some());
    line(&mut model, ":", "digits 6");
    assert!(dump(&frame(&model, 100, 30, &Theme::new(Palette::None, false))).contains("t = 12.685000"));
    line(&mut model, ":", "digits 16");
    assert_eq!(said(&model), "expected the decimals of numbers, 0 to 15: :digits 6");
    typed(&mut model, "Esc");
    line(&mut model, ":", "dig 3");
    assert_eq!(said(&model), "3 decimals");
    line(&mut model, ":", "filter plane");
    assert_eq!(model.guide.filter.as_deref(), Some("plane"));
    line(&mut model, ":", "fil");
    assert_eq!(model.guide.filter, None);
    assert_eq!(line(&mut model, ":", "pixel 3,4"), Effect::Trace([3, 4]));
    assert_eq!(line(&mut model, ":", "pix 3 4"), Effect::Trace([3, 4]));
    // Its own pixel is there, also in a saved log.
    assert_eq!((line(&mut model, ":", "pixel 160,120"), model.step()), (Effect::None, 1));
    for (text, expected) in [
        ("pixel 3", "expected a column and a row"),
        ("pixel 3,4,5", "expected a column and a row"),
        ("pixel -3,4", "expected a column and a row"),
        ("bookmark", "expected one letter"),
        ("bookmark ab", "expected one letter"),
        ("serach x", "did you mean :search?"),
        ("b", "may be :book, :bookmark LETTER [NOTE], :bookmarks, :break CONDITION"),
        ("xyzzy", "no command :xyzzy; Tab completes commands, ? lists them"),
        ("note", "expected :note TEXT"),
        ("screenshot", "expected :screenshot FILE"),
        ("quit now", "nothing may follow :quit"),
        ("break object x", "no object"),
    ] {
        line(&mut model, ":", text);
        assert!(said(&model).contains(expected), ":{text}: {}", said(&model));
        typed(&mut model, "Esc");
    }
    line(&mut model, ":", "bookmark z");
    assert_eq!(model.guide.bookmarks[0].letter, 'z');
    line(&mut model, ":", "mouse");
    assert!(model.guide.has_mouse);
    line(&mut model, ":", "help");
    assert_eq!(model.overlay, Some(Overlay::Help { top: 0 }));
    typed(&mut model, "Esc");
    assert_eq!(line(&mut model, ":", "q"), Effect::Leave(Exit::Quit));
    assert_eq!(line(&mut model, ":", ""), Effect::None);
}

/// Types a line that is wrong; it then stays as it is, and what is wrong is said.
#[track_caller]
fn stays(key: &str, text: &str, expected: &str) {
    let mut model = sized(glass(), 100, 30);
    begin(&mut model, key, text);
    typed(&mut model, "Left Enter");
    let prompt = model.prompt.as_ref().map(|prompt| (prompt.line.value(), prompt.line.cursor()));
    assert_eq!(prompt, Some((text, text.len() - 1)), "{key}{text}");
    assert!(said(&model).contains(expected), "{key}{text}: {}", said(&model));
    let shown = dump(&frame(&model, 100, 30, &Theme::new(Palette::None, false)));
    assert!(shown.contains(text) && shown.contains(expected), "{shown}");
    typed(&mut model, "Right");
    assert_eq!(said(&model), "", "{key}{text}");
}

#[test]
fn lines_that_are_wrong_stay_to_be_mended() {
    stays("/", "no such text", "not found");
    stays("f", "no such text", "no row matches");
    stays("b", "object bal", "did you mean `ball`?");
    stays(":", "serach", "did you mean :search?");
    stays(":", "pixel 3", "expected a column and a row");
    stays("Q n =", "x", "no number");
}

#[test]
fn a_warning_gives_way_to_what_is_wrong_with_a_line() {
    let mut model = sized(glass(), 100, 30);
    model.warn("cut off");
    line(&mut model, ":", "serach");
    assert!(said(&model).contains("did you mean :search?"), "{}", said(&model));
    typed(&mut model, "Left");
    let warning = |model: &Model| model.warning.as_ref().map(|warning| warning.text.clone());
    assert_eq!((said(&model), warning(&model).as_deref()), ("", Some("cut off")));
    typed(&mut model, "Enter Esc");
    assert_eq!((said(&model), model.prompt.is_none(), warning(&model).as_deref()), ("", true, Some("cut off")));
}

/// Types `keys` after three searches, a filter and a breakpoint; the line is then this.
#[track_caller]
fn recalls(keys: &str, expected: &str) {
    let mut model = sized(glass(), 100, 30);
    for (key, text) in [("/", "ball"), ("/", "wall"), ("/", "wall"), ("f", "ball"), ("f", ""), ("b", "hit")] {
        line(&mut model, key, text);
    }
    typed(&mut model, keys);
    assert_eq!(model.prompt.as_ref().map(|prompt| prompt.line.value()), Some(expected), "after {keys}");
}

#[test]
fn lines_are_brought_back() {
    recalls("/ Up", "wall");
    recalls("/ Up Up", "ball");
    recalls("/ Up Up Up Up", "ball");
    recalls("/ Up Up Down", "wall");
    recalls("/ x y Up Down", "xy");
    recalls("/ x y Up Down Down", "xy");
    recalls("/ Down", "");
    recalls("/ Up s Up Down", "walls");
    recalls("/ x Up s Down", "x");
    recalls("/ x Up s Down Up", "walls");
    recalls("f Up", "ball");
    recalls("b Up", "hit");
    recalls(": Up", "");
    // What was wrong is the latest.
    recalls("/ q q q q Enter", "qqqq");
    recalls("/ q q q q Enter Up", "wall");
    recalls("/ q q q q Enter Esc / Up", "qqqq");
    // What mends it isn't lost.
    recalls("/ q q q q Enter s Up Down", "qqqqs");
    recalls("/ q q q q Enter Up Down", "qqqq");
    recalls("/ q q q q Enter Down", "qqqq");
    recalls("f q q q q Enter Up Up Down", "qqqq");
    recalls(": q q q q Enter s Up Down", "qqqqs");
}

/// Types a line and `Tab`; it then says this.
#[track_caller]
fn completes(key: &str, text: &str, expected: &str) {
    let mut model = sized(glass(), 100, 30);
    begin(&mut model, key, text);
    typed(&mut model, "Tab");
    assert_eq!(model.prompt.as_ref().map(|prompt| prompt.line.value()), Some(expected), "{key}{text}");
}

#[test]
fn lines_are_completed() {
    completes(":", "sea", "search ");
    completes(":", "boo", "book");
    completes(":", "bookm", "bookmark");
    completes(":", "brea", "break");
    completes(":", "break object b", "break object ball");
    completes("b", "light beh", "light behind the wall");
    completes("b", "total", "total-internal-reflection");
    completes("b", "shade.n_dot_l", "shade.n_dot_l");
    completes("/", "se", "se");
    completes(":", "nothing", "nothing");
}

#[test]
fn a_pasted_text_is_where_the_cursor_is() {
    let mut model = sized(textbook(), 100, 30);
    begin(&mut model, "/", "añb");
    typed(&mut model, "Left");
    prompt::pasted(&mut model, "x\r\ny\rz\nw\tß\u{1b}[0m\u{202e}");
    let value = |model: &Model| model.prompt.as_ref().expect("a line").line.value().to_owned();
    assert_eq!(value(&model), "añx y z w ß\\u{1b}[0m\\u{202e}b");
    typed(&mut model, "c");
    assert!(value(&model).ends_with("\\u{202e}cb"), "{}", value(&model));
    // A line that was wrong is mended.
    typed(&mut model, "Esc");
    line(&mut model, ":", "xyzzy");
    typed(&mut model, "^u");
    prompt::pasted(&mut model, "42");
    assert_eq!(said(&model), "");
    typed(&mut model, "Enter");
    assert_eq!(model.step(), 42);
}

#[test]
fn a_pasted_text_does_nothing_where_no_line_is_typed() {
    for (language, expected) in
        [(Language::English, "text can only be pasted"), (Language::Spanish, "solo se puede pegar")]
    {
        for keys in ["", "?", "M", "Tab", "12"] {
            let mut model = sized(textbook(), 100, 30);
            model.language = language;
            typed(&mut model, keys);
            let frame_of = |model: &Model| dump(&frame(model, 100, 30, &Theme::new(Palette::None, false)));
            let before = (model.step(), model.cursor, frame_of(&model));
            prompt::pasted(&mut model, "q:quit\rjjj");
            assert!(said(&model).contains(expected), "{keys}: {}", said(&model));
            assert!(frame_of(&model).contains(expected), "{keys}: {}", frame_of(&model));
            model.message = None;
            assert_eq!((model.step(), model.cursor, frame_of(&model)), before, "{keys}");
        }
    }
}
