//! The viewer in a real pseudo-terminal: it shows the walk, steps, and always gives the terminal back.

use crate::session::{PATIENCE, Session, spawned};
use std::io::{Read, Write};
use std::thread;
use std::time::{Duration, Instant};

#[test]
fn the_main_job_opens_the_numeric_example_and_steps() {
    let mut session = Session::start(&[], 100, 30);
    session.shows("pixel 160,120");
    session.shows("step 1/");
    session.press("n");
    session.shows("ray.length");
    session.press("nn");
    session.shows("plane.v_d");
    session.press("N");
    session.shows("ray.direction");
    session.press("?");
    session.shows("to the next computed value");
    // An escape that is followed at once would be read as the Alt key.
    session.press("\x1b");
    session.hides("to the next computed value");
    session.press("q");
    session.ends_with(0);
    let written = String::from_utf8_lossy(&session.written.lock().expect("the output")).into_owned();
    assert!(written.contains("raywalk walk textbook --pixel 160,120 --at 3"), "{written}");
}

#[test]
fn it_breaks_searches_shrinks_and_comes_back() {
    let mut session = Session::start(&["walk", "textbook", "--pixel", "160,120"], 100, 30);
    session.shows("step 1/98");
    session.press("s");
    session.shows("step 2/98");
    session.press("bobject sphere\r");
    session.shows("breakpoint: object sphere");
    session.press("r");
    session.shows("stopped by object sphere: test sphere");
    session.press("L");
    session.shows("Where runs stopped");
    session.press("q/n_dot_l\r");
    session.shows("match 1/");
    session.resize(1, 1);
    session.press(";");
    thread::sleep(Duration::from_millis(100));
    session.resize(100, 30);
    session.shows("match 2/");
    session.press(":quit\r");
    session.ends_with(0);
}

#[test]
fn it_plays_by_itself() {
    let mut session = Session::start(&["walk", "textbook"], 100, 30);
    session.shows("step 1/98");
    session.press("++++++P");
    session.shows("played to the last computed value");
    session.press("q");
    session.ends_with(0);
}

/// The sequences that ask a terminal to tell of the mouse, and to stop that.
const MOUSE: [&str; 2] = ["\x1b[?1000h", "\x1b[?1000l"];

#[test]
fn the_mouse_is_given_back() {
    for (ending, code) in [("key", 0), ("signal", 143), ("toggle", 0)] {
        let mut session = Session::start(&["walk", "textbook"], 100, 30);
        session.shows("step 1/98");
        assert!(!session.has_written(MOUSE[0]), "nobody asked for the mouse");
        session.press(":mouse\r");
        session.shows("the mouse selects and scrolls");
        // A click into the third row of the tree: button 0 at column 6, row 4.
        session.press("\x1b[<0;6;4M\x1b[<0;6;4m");
        session.shows("3/");
        assert!(session.has_written(MOUSE[0]) && !session.has_written(MOUSE[1]));
        match ending {
            "signal" => session.signal("TERM"),
            "toggle" => {
                session.press("\x14");
                session.shows("the mouse is the terminal's");
                session.press("q");
            }
            _ => session.press("q"),
        }
        session.ends_with(code);
        assert!(session.has_written(MOUSE[1]), "the mouse was kept after a {ending}");
    }
}

#[test]
fn values_reach_the_clipboard() {
    let mut session = Session::start(&["walk", "textbook"], 100, 30);
    session.shows("step 1/98");
    session.press("0Y");
    session.shows("clipboard: C camera");
    session.press("q");
    session.ends_with(0);
    // Base64 of `C camera`.
    assert!(session.has_written("\x1b]52;c;QyBjYW1lcmE=\x1b\\"));
}

#[test]
fn a_link_leads_back_to_the_step() {
    let mut session = Session::start(&["walk", "textbook", "--pixel", "160,120", "--at", "7"], 100, 30);
    session.shows("step 7/");
    session.shows("plane.t");
    session.press("q");
    session.ends_with(0);
}

#[test]
fn e12_tty_1x1() {
    let mut session = Session::start(&["walk", "figure-6"], 1, 1);
    for (columns, rows) in [(19, 5), (40, 12), (500, 200), (1, 1), (2, 90), (500, 200), (80, 24)] {
        session.resize(columns, rows);
        session.press("n");
        thread::sleep(Duration::from_millis(30));
    }
    session.shows("step ");
    session.press("q");
    session.ends_with(0);
}

#[test]
fn e13_tty_restore() {
    for (signal, code) in [("TERM", 143), ("INT", 130), ("HUP", 129), ("QUIT", 143)] {
        let mut session = Session::start(&["walk", "textbook"], 80, 24);
        session.shows("step 1/");
        session.signal(signal);
        session.ends_with(code);
    }
}

/// A terminal that goes away while the viewer runs: it ends as by the signal, and keeps no processor busy.
#[test]
fn s05_sighup_of_a_viewer() {
    let folder = tempfile::tempdir().expect("a folder");
    let log = folder.path().join("a.ndjson");
    let mut traced = assert_cmd::Command::cargo_bin("raywalk").expect("the program");
    traced.args(["trace", "textbook", "--pixel", "160,120", "-o"]).arg(&log).assert().success();
    let log = &*log.to_string_lossy();
    // Also one that draws all the time, so that it may be writing when the terminal goes.
    for (arguments, keys) in
        [(&["walk", "textbook"][..], ""), (&["walk", "textbook"], "++++P"), (&["diff", log, log, "--walk"], "j")]
    {
        let (mut child, master, mut reader) = spawned(env!("CARGO_BIN_EXE_raywalk").as_ref(), arguments, 80, 24);
        let mut writer = master.take_writer().expect("a writer");
        let (mut screen, mut buffer) = (vt100::Parser::new(24, 80, 0), [0; 4096]);
        while !["step 1/", "row 1/"].iter().any(|shown| screen.screen().contents().contains(shown)) {
            let count = reader.read(&mut buffer).expect("it draws");
            assert!(count > 0, "{}", screen.screen().contents());
            screen.process(&buffer[..count]);
        }
        writer.write_all(keys.as_bytes()).expect("keys are read");
        thread::sleep(Duration::from_millis(100));
        // Nobody holds the terminal any more.
        drop((writer, reader, master));
        assert_eq!(code_of(&mut child), 129, "{arguments:?} {keys}");
    }
}

/// The exit code of a program that must end by itself.
#[track_caller]
fn code_of(child: &mut Box<dyn portable_pty::Child + Send + Sync>) -> u32 {
    let start = Instant::now();
    loop {
        if let Some(status) = child.try_wait().expect("a status") {
            return status.exit_code();
        }
        assert!(start.elapsed() < PATIENCE, "it goes on without a terminal");
        thread::sleep(Duration::from_millis(10));
    }
}

/// The signal of a terminal that was closed goes to the shell of a script, which may keep it for itself.
#[test]
fn a_terminal_that_is_gone_is_noticed_without_a_signal() {
    let script = concat!("trap : HUP; ", env!("CARGO_BIN_EXE_raywalk"), " walk textbook; exit $?");
    let (mut child, master, mut reader) = spawned("bash".as_ref(), &["--norc", "-c", script], 80, 24);
    let (mut written, mut buffer) = (Vec::new(), [0; 4096]);
    while !String::from_utf8_lossy(&written).contains("step 1/") {
        let count = reader.read(&mut buffer).expect("it draws");
        assert!(count > 0, "{}", String::from_utf8_lossy(&written));
        written.extend_from_slice(&buffer[..count]);
    }
    drop((reader, master));
    assert_eq!(code_of(&mut child), 129);
}

/// What a terminal sends of a text that is pasted.
fn pasted(text: &str) -> String {
    format!("\x1b[200~{text}\x1b[201~")
}

#[test]
fn a_pasted_text_is_text() {
    let mut session = Session::start(&["walk", "textbook"], 100, 30);
    session.shows("step 1/98");
    session.is_taken(true);
    // As keys these would leave the viewer.
    session.press(&pasted("q:quit\r\x03"));
    session.shows("text can only be pasted into a line");
    session.press("n");
    session.hides("text can only be pasted");
    session.press("/ol");
    session.press(&pasted("n_dot_l\r\n\x03\x1b[31m\tsecond"));
    session.shows("/oln_dot_l \\u{3}\\u{1b}[31m second");
    session.press("\x15");
    session.press(&pasted("n_dot_l"));
    session.press("\r");
    session.shows("match 1/");
    session.press("q");
    session.ends_with(0);
}

#[test]
fn a_pasted_text_does_nothing_to_two_logs() {
    let folder = tempfile::tempdir().expect("a folder");
    let log = folder.path().join("a.ndjson");
    let mut traced = assert_cmd::Command::cargo_bin("raywalk").expect("the program");
    traced.args(["trace", "textbook", "--pixel", "160,120", "-o"]).arg(&log).assert().success();
    let log = &*log.to_string_lossy();
    let mut session = Session::start(&["diff", log, log, "--walk"], 120, 30);
    session.shows("row 1/");
    session.press(&pasted("q\x03"));
    session.shows("text can only be pasted into a line");
    session.press("j");
    session.shows("row 2/");
    session.hides("text can only be pasted");
    session.press("q");
    session.ends_with(0);
}

#[test]
fn control_c_leaves() {
    let mut session = Session::start(&["walk", "textbook"], 80, 24);
    session.shows("step 1/");
    session.press("\x03");
    session.ends_with(130);
}

#[test]
fn e11_tty_0x0() {
    let mut session = Session::start(&["walk", "textbook"], 0, 0);
    session.resize(80, 24);
    session.shows("step 1/");
    session.press("q");
    session.ends_with(0);
    for terminal in [Some("dumb"), Some(""), None] {
        let mut command = assert_cmd::Command::cargo_bin("raywalk").expect("the program");
        match terminal {
            Some(name) => command.env("TERM", name),
            None => command.env_remove("TERM"),
        };
        let output = command.output().expect("it runs");
        assert!(output.status.success());
        assert!(!output.stdout.contains(&0x1b), "no escape sequences");
    }
}

#[test]
fn e14_no_color() {
    // Elsewhere than in a terminal there are none anyway.
    for arguments in
        [&["walk", "textbook"][..], &["textbook"], &["--help"], &["scene", "check", "no.json"], &["--wrong"]]
    {
        let mut command = assert_cmd::Command::cargo_bin("raywalk").expect("the program");
        let output = command.args(arguments).env("NO_COLOR", "1").output().expect("it runs");
        assert!(![output.stdout, output.stderr].concat().contains(&0x1b), "{arguments:?}");
    }
}

#[test]
fn the_shell_gets_the_terminal_and_gives_it_back() {
    let mut session = Session::of("bash".as_ref(), &["--norc", "--noprofile", "-i"], 100, 30);
    session.press(concat!(env!("CARGO_BIN_EXE_raywalk"), " walk textbook\r"));
    session.shows("step 1/98");
    session.is_taken(true);
    session.press("n\x1a");
    session.shows("Stopped");
    session.is_taken(false);
    session.press("fg\r");
    session.is_taken(true);
    session.shows("step 2/98");
    session.press("n");
    session.shows("step 3/98");
    session.press("q");
    session.shows("back here:");
    session.is_taken(false);
    session.press("exit 7\r");
    session.ends_with(7);
}

/// The shell must not get mouse events while the viewer is stopped; the viewer must be again when it goes on.
#[test]
fn the_mouse_is_given_to_the_shell_and_taken_again() {
    let mut session = Session::of("bash".as_ref(), &["--norc", "--noprofile", "-i"], 100, 30);
    session.press(concat!(env!("CARGO_BIN_EXE_raywalk"), " walk textbook\r"));
    session.shows("step 1/98");
    session.has_mouse(false);
    session.press("\x14");
    session.shows("the mouse selects and scrolls");
    session.has_mouse(true);
    session.press("\x1a");
    session.shows("Stopped");
    session.has_mouse(false);
    session.press("fg\r");
    session.is_taken(true);
    session.has_mouse(true);
    // A click into the third row of the tree: button 0 at column 6, row 4.
    session.press("\x1b[<0;6;4M\x1b[<0;6;4m");
    session.shows("3/");
    session.press("q");
    session.shows("back here:");
    session.has_mouse(false);
    session.press("exit 7\r");
    session.ends_with(7);
}

#[test]
fn the_cursor_walks_over_the_picture() {
    let mut session = Session::start(&["walk", "figure-6"], 160, 48);
    session.shows("160,120");
    // Shift-Tab goes from the tree to the picture.
    session.press("\x1b[Z3l2k");
    session.shows("pixel 163,118");
    session.press("\r:pixel 5,7\r");
    session.shows("pixel 5,7");
    session.press("q");
    session.ends_with(0);
    assert!(session.has_written("--pixel 5,7 --at"), "the way back is to another pixel");
}

/// A viewer of a scene whose tracer panics: `a_panic_gives_the_terminal_back` runs it in a terminal.
#[test]
#[ignore = "only in the terminal of another test"]
fn panicking_viewer() {
    struct Panics;
    impl raywalk::tui::Live for Panics {
        fn trace(&mut self, _: [u32; 2]) -> Result<raywalk::log::Log, raywalk::tui::Refusal> {
            panic!("the tracer gave up")
        }
        fn compare(&mut self, _: raywalk::log::Subject) -> Result<Vec<raywalk::log::Log>, raywalk::tui::Refusal> {
            panic!("the tracer gave up")
        }
    }
    let text = raywalk::scene::builtin::text("textbook").expect("the numeric example");
    let loaded = raywalk::scene::file::check(text.as_bytes(), "textbook").expect("a scene");
    let scene = raywalk::scene::build(&loaded.scene, &Default::default()).expect("a scene");
    let log = raywalk::record::pixel(&scene, [160, 120], raywalk::record::Arithmetic::F64);
    let theme = raywalk::tui::Theme::new(raywalk::tui::Palette::None, false);
    let numbers = raywalk::report::Style::default();
    let options = raywalk::tui::Options {
        theme,
        start: None,
        warning: None,
        note: None,
        numbers,
        language: Default::default(),
        controls: Default::default(),
    };
    raywalk::tui::run(log, options, Some(&mut Panics)).expect("a terminal");
}

#[test]
fn a_panic_gives_the_terminal_back() {
    let program = std::env::current_exe().expect("this program");
    let arguments = ["--ignored", "--exact", "terminal::panicking_viewer", "--nocapture"];
    let mut session = Session::of(program.as_os_str(), &arguments, 100, 30);
    session.shows("step 1/98");
    session.is_taken(true);
    // The other arithmetics are asked for.
    session.press("a");
    session.shows("the tracer gave up");
    session.ends_with(101);
}

#[test]
fn an_early_end_gives_the_terminal_back() {
    let mut session = Session::start(&["walk", "textbook"], 100, 30);
    session.shows("step 1/98");
    session.press("m");
    session.is_taken(true);
    // As an allocation that fails ends it: in the middle of the work, without destructors.
    session.signal("ABRT");
    session.ends_with(3);
    session.has_mouse(false);
}
