//! What the program says of itself: the help and the manual page of every command, and what completes them.

use crate::calls::{prints, raywalk, says};
use crate::support::snapshots;
use std::fs;
use std::process::{Command, Stdio};

/// All commands, as their manual pages name them: `raywalk-scene-check`.
pub fn commands() -> Vec<String> {
    let folder = tempfile::tempdir().expect("a folder");
    prints(&["man", "-o", folder.path().to_str().expect("UTF-8")]);
    let names = fs::read_dir(folder.path()).expect("the folder").map(|entry| {
        let name = entry.expect("a page").file_name().into_string().expect("UTF-8");
        let page = fs::read_to_string(folder.path().join(&name)).expect("a page");
        assert!(page.starts_with(".ie") || page.contains(".TH "), "{name}: {page:.80}");
        name.strip_suffix(".1").expect(&name).to_owned()
    });
    let mut names: Vec<String> = names.collect();
    names.sort();
    names
}

#[test]
fn every_command_says_what_it_does() {
    let commands = commands();
    for expected in ["raywalk", "raywalk-merge", "raywalk-scene-generate", "raywalk-bench-error", "raywalk-man"] {
        assert!(commands.iter().any(|name| name == expected), "{expected} in {commands:?}");
    }
    for name in commands {
        let words: Vec<&str> = name.split('-').skip(1).collect();
        let help = prints(&[&words[..], &["--help"]].concat());
        assert!(help.contains("Usage: raywalk"), "{name}: {help}");
        snapshots().bind(|| insta::assert_snapshot!(format!("help_{name}"), help));
        // The short help says the same in fewer words.
        let short = prints(&[&words[..], &["-h"]].concat());
        assert!(short.lines().count() <= help.lines().count() && short.contains("Usage: raywalk"), "{name}: {short}");
    }
}

#[test]
fn help_is_of_its_own_command() {
    let help = |command: &str| prints(&[command, "--help"]).split_whitespace().collect::<Vec<_>>().join(" ");
    // The formats that are read are listed where they are read.
    assert!(help("diff").contains(&format!("Pictures are {}. The layers that", raywalk::render::export::READABLE)));
    // Nothing is sampled where parts are put together.
    assert!(help("merge").contains("--white <VALUE>") && !help("merge").contains("tolerances of adaptive"));
    assert!(help("render").contains("tolerances of adaptive"));
}

#[test]
fn pages_are_good_troff() {
    let page = prints(&["man"]);
    let Ok(checker) = Command::new("groff")
        .args(["-man", "-Tutf8", "-ww"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
    else {
        crate::shared::skipped("no groff here");
        return;
    };
    let mut checker = checker;
    std::io::Write::write_all(&mut checker.stdin.take().expect("a pipe"), page.as_bytes()).expect("written");
    let shown = checker.wait_with_output().expect("it ends");
    assert!(shown.status.success() && shown.stderr.is_empty(), "{}", String::from_utf8_lossy(&shown.stderr));
    assert!(String::from_utf8_lossy(&shown.stdout).contains("raywalk"));
}

#[test]
fn shells_can_complete() {
    for (shell, part) in [("bash", "_raywalk()"), ("zsh", "#compdef raywalk"), ("fish", "complete -c raywalk")] {
        let script = prints(&["completions", shell]);
        assert!(script.contains(part) && script.contains("sampling") && script.contains("merge"), "{shell}");
        // The shell itself has nothing against it.
        let Ok(mut checker) = Command::new(shell).arg("-n").stdin(Stdio::piped()).spawn() else {
            crate::shared::skipped(&format!("no {shell} here"));
            continue;
        };
        std::io::Write::write_all(&mut checker.stdin.take().expect("a pipe"), script.as_bytes()).expect("written");
        assert!(checker.wait().expect("it ends").success(), "{shell}");
    }
    says(2, &["completions", "cmd"], "possible values: bash");
    assert!(raywalk(&["completions", "bash"]).output().expect("it runs").stderr.is_empty());
}
