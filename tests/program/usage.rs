//! What is said of calls that can't be read: arguments are shown, and never reach the terminal as they are.

use crate::calls::raywalk;
use crate::help::commands;
use portable_pty::{CommandBuilder, PtySize, native_pty_system};
use std::ffi::{OsStr, OsString};
use std::io::Read;
use std::os::unix::ffi::{OsStrExt, OsStringExt};
use std::process::Command;

/// What drives terminals, turns the writing, isn't seen, or begins a line of its own; the last is no UTF-8.
const HOSTILE: &[&[u8]] = &[
    b"\x1b]0;title\x07",
    b"\x1b]52;c;YQ==\x07",
    b"\x1b[31mred",
    b"\xc2\x9b31mred",
    "a\u{202e}b".as_bytes(),
    "a\u{200b}\u{ad}\u{2066}b".as_bytes(),
    "\u{e0041}\u{3164}".as_bytes(),
    b"x\nerror: everything is well",
    b"\x08\x7f\r",
    b"\xff\xfe\x1b[2J",
];

fn joined(before: &str, value: &[u8]) -> OsString {
    OsString::from_vec([before.as_bytes(), value].concat())
}

/// A message without the colours of ours.
fn without_colors(message: &str) -> String {
    let mut parts = message.split('\u{1b}');
    let mut text = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let rest = part.strip_prefix('[').map(|rest| rest.trim_start_matches(|c: char| c.is_ascii_digit() || c == ';'));
        match rest.and_then(|rest| rest.strip_prefix('m')) {
            Some(rest) => text.push_str(rest),
            None => text.extend(["\u{1b}", part]),
        }
    }
    text
}

#[track_caller]
fn is_safe(arguments: &[OsString], message: &[u8]) {
    let text = String::from_utf8(message.to_vec()).expect("UTF-8");
    let is_bad =
        |c: char| (c.is_control() && c != '\n') || "\u{202e}\u{200b}\u{ad}\u{2066}\u{e0041}\u{3164}".contains(c);
    assert!(!text.contains(is_bad), "{arguments:?}: {text:?}");
    assert!(!text.lines().any(|line| line == "error: everything is well"), "{arguments:?}: {text}");
}

/// The options of a command, as its help names them.
fn options(words: &[&str]) -> Vec<String> {
    let help = raywalk(&[words, &["--help"]].concat()).output().expect("it runs").stdout;
    let help = String::from_utf8(help).expect("UTF-8");
    let of_line = |line: &str| {
        let line = line.trim_start();
        let option = if line.starts_with("--") { line } else { line.strip_prefix('-')?.split_once(", ")?.1 };
        Some(option.split([' ', ',']).next()?.to_owned()).filter(|option| option.starts_with("--"))
    };
    help.lines().filter_map(of_line).collect()
}

#[test]
fn no_escape_of_an_argument_reaches_the_terminal() {
    let folder = tempfile::tempdir().expect("a folder");
    let (mut calls, mut refused) = (0, 0);
    for command in commands() {
        let words: Vec<&str> = command.split('-').skip(1).collect();
        let mut tries: Vec<Vec<OsString>> = Vec::new();
        for value in HOSTILE {
            let hostile = OsStr::from_bytes(value).to_owned();
            tries.push(vec![joined("--", value)]);
            tries.push(vec![joined("--no-such=", value)]);
            tries.push(vec![joined("-", value)]);
            // A file of that name, where it isn't the name of a command; and one file too many.
            tries.push(vec![hostile.clone()]);
            tries.push(vec![hostile.clone(), hostile.clone(), hostile, "--no-such".into()]);
        }
        for (number, option) in options(&words).into_iter().enumerate() {
            // Each option with some of them, with another one first each time.
            for value in HOSTILE.iter().cycle().skip(number).take(3) {
                let hostile = OsStr::from_bytes(value).to_owned();
                tries.push(vec![joined(&format!("{option}="), value), "--no-such".into()]);
                tries.push(vec![option.clone().into(), hostile, "--no-such".into()]);
                tries.push(vec![joined(&option, value)]);
            }
        }
        for arguments in tries {
            let mut call = Command::new(env!("CARGO_BIN_EXE_raywalk"));
            let output = call.args(&words).args(&arguments).current_dir(folder.path()).output().expect("it runs");
            is_safe(&arguments, &output.stderr);
            is_safe(&arguments, &output.stdout);
            let code = output.status.code();
            assert!(matches!(code, Some(0 | 2)), "{words:?} {arguments:?}: {code:?}");
            refused += u32::from(code == Some(2));
            calls += 1;
        }
    }
    assert!(calls > 1000 && refused > calls * 9 / 10, "{refused} of {calls}");
    assert_eq!(std::fs::read_dir(folder.path()).expect("the folder").count(), 0);
}

/// What the program writes to a terminal.
fn on_terminal(words: &[&str], arguments: &[OsString]) -> String {
    let size = PtySize { rows: 24, cols: 80, pixel_width: 0, pixel_height: 0 };
    let pair = native_pty_system().openpty(size).expect("a pseudo-terminal");
    let mut command = CommandBuilder::new(env!("CARGO_BIN_EXE_raywalk"));
    command.args(words);
    command.args(arguments);
    command.env("TERM", "xterm-256color");
    command.env_remove("NO_COLOR");
    let mut child = pair.slave.spawn_command(command).expect("the program starts");
    drop(pair.slave);
    let mut written = Vec::new();
    // The end of a terminal is an error on some systems.
    let _ = pair.master.try_clone_reader().expect("a reader").read_to_end(&mut written);
    child.wait().expect("it ends");
    // A terminal makes two characters of the end of a line.
    String::from_utf8(written).expect("UTF-8").replace("\r\n", "\n")
}

#[test]
fn nor_with_colours() {
    // Ours are there.
    let bad = on_terminal(&["trace"], &["--bad".into()]);
    assert!(bad.contains("\u{1b}[") && without_colors(&bad).contains("unexpected argument '--bad' found"), "{bad:?}");
    for value in HOSTILE {
        let hostile = OsStr::from_bytes(value).to_owned();
        for (words, arguments) in [
            (&["render"][..], vec![joined("--size=", value)]),
            (&["render", "textbook", "--frames"], vec![hostile.clone()]),
            (&["trace", "textbook", "--pixel"], vec![hostile.clone()]),
            (&["trace", "textbook", "--format"], vec![hostile.clone()]),
            (&["bench"], vec![hostile.clone()]),
            (&["help"], vec![hostile.clone()]),
            (&["completions"], vec![hostile.clone()]),
            (&["diff", "a", "b"], vec![hostile.clone()]),
            (&["walk"], vec![joined("--sca", value)]),
            (&["scene", "check"], vec![hostile.clone()]),
            (&["scene", "check", "--nff-angle"], vec![hostile.clone()]),
        ] {
            let written = on_terminal(words, &arguments);
            assert!(written.contains("error"), "{words:?} {arguments:?}: {written:?}");
            is_safe(&arguments, without_colors(&written).as_bytes());
            assert!(!written.contains("\u{1b}[31mred"), "{words:?} {arguments:?}: {written:?}");
        }
    }
}

#[test]
fn what_is_wrong_is_said_with_the_argument_made_visible() {
    let says = |arguments: &[&[u8]], expected: &str| {
        let mut call = Command::new(env!("CARGO_BIN_EXE_raywalk"));
        let output = call.args(arguments.iter().map(|argument| OsStr::from_bytes(argument))).output().expect("it runs");
        let message = String::from_utf8(output.stderr).expect("UTF-8");
        assert!(output.status.code() == Some(2) && message.starts_with(expected), "{arguments:?}: {message}");
    };
    says(&[b"\x1b[2J"], "error: unrecognized subcommand '\\u{1b}[2J'\n\nUsage: raywalk [OPTIONS] [COMMAND]\n");
    says(&[b"render", b"--\x1b]0;a\x07"], "error: unexpected argument '--\\u{1b}]0;a\\u{7}' found\n");
    says(
        &[b"trace", b"textbook", b"--pixel", "1,\u{202e}2\nerror: b".as_bytes()],
        "error: invalid value '1,\\u{202e}2\\nerror: b' for '--pixel <X,Y>': ",
    );
    says(&[b"walk", b"--digits=\xc2\x9b3"], "error: invalid value '\\u{9b}3' for '--digits <N>': ");
    says(
        &[b"render", b"--color", b"\x1b[31m"],
        "error: invalid value '\\u{1b}[31m' for '--color <COLOR>'\n  [possible values: auto, always, never]\n",
    );
    // The name by which the program was called isn't ours, either.
    let mut shell = Command::new("bash");
    shell.args(["-c", "exec -a $'\\e]0;a\\a' \"$0\" --bad", env!("CARGO_BIN_EXE_raywalk")]);
    if let Ok(output) = shell.output() {
        is_safe(&[], &output.stderr);
        assert!(String::from_utf8_lossy(&output.stderr).contains("Usage: raywalk "));
    }
}

/// Names of files are arguments, too, and texts of files are shown in results as well as in messages.
#[test]
fn no_escape_of_a_file_reaches_the_terminal() {
    let folder = tempfile::tempdir().expect("a folder");
    let name = "a\u{1b}]0;t\u{7}\u{9b}31m\u{202e}\u{200b}";
    let write = |ending: &str, text: &str| {
        std::fs::write(folder.path().join(format!("{name}{ending}")), text).expect("written");
    };
    let scene = |mesh: &str| {
        format!(
            "{{\"format\": \"raywalk-scene/1\", \"camera\": {{\"position\": [0.4, 0.7, 5], \"direction\": [0, 0, -1], \"resolution\": [8, 6]}},\n \
             \"objects\": [{{\"name\": \"m\", \"shape\": {{\"mesh\": {{\"path\": {}}}}}}}]}}",
            serde_json::json!(mesh)
        )
    };
    write(".obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
    write(".json", &scene(&format!("{name}.obj")));
    write(".missing", &scene("x\u{9b}\u{202e}.obj"));
    write(".bad", "{\"format\": \"raywalk-scene/1\", \"a\u{9b}\": 1, \"\u{202e}\": [");
    write(".csv", "quantity,printed\n\u{202e}\u{9b}31m,1\n");
    let calls = [
        "trace textbook --pixel 1,1 -o @.nd",
        "render textbook --size 4x3 -q -o @.png",
        "render textbook --size 4x3 -q -o @.part --shard 1/2",
        "render textbook --size 4x3 -o @.part --shard 1/2",
        "scene show @.json",
        "scene show @.missing",
        "scene convert @.json",
        "scene convert @.json -o nowhere/@",
        "scene check @.json",
        "scene check @.missing",
        "scene check @.bad",
        "scene check @.part",
        "render @.json -o @.zzz",
        "render @.json -o @/x.png",
        "render @.json -o @.json --shard 1/2",
        "render textbook --size 4x3 -o @.pfm --resume",
        "trace @.json --pixel 4,3",
        "trace @.json --pixel 4,3 --format text",
        "trace @.json --pixel 4,3 --format markdown --lang es",
        "trace @.nd --causes",
        "walk @.json --plain",
        "walk @.nd --plain --lang es",
        "walk @.nd --pixel 1,1",
        "walk textbook --screenshot @",
        "walk textbook --screenshot a.svg --keys <@>",
        "diff @.nd @.nd",
        "diff @.nd @.nd --format json",
        "diff @.nd @.png",
        "diff @.png @.bad",
        "merge @.part -o @.png",
        "merge @.nd -o @",
        "merge @.png -o @",
        "textbook --with @.csv",
        "stress @.csv",
        "rays @.json",
        "bench rays @",
        "bench rays @ --dump @",
        "bench error @.json --size 4x3 --depths --format csv -q",
        "bench error @.json --size 4x3 --depths --format json -q",
        "man -o @.csv",
    ];
    for call in calls {
        let words: Vec<OsString> = call.split(' ').map(|word| word.replace('@', name).into()).collect();
        let mut program = Command::new(env!("CARGO_BIN_EXE_raywalk"));
        let output = program.args(&words).current_dir(folder.path()).output().expect("it runs");
        assert!(matches!(output.status.code(), Some(0..=3)), "{call}: {:?}", output.status);
        is_safe(&words, &output.stderr);
        is_safe(&words, &output.stdout);
    }
}
