//! The configuration file: what it says holds, options win over it, and mistakes in it are said before the screen is taken.

use crate::session::Session;
use std::fs;
use std::path::Path;

const PROGRAM: &str = env!("CARGO_BIN_EXE_raywalk");

/// The viewer with this configuration in its usual place.
fn with(config: &str, arguments: &[&str]) -> (Session, tempfile::TempDir) {
    let home = tempfile::tempdir().expect("a folder");
    fs::create_dir(home.path().join("raywalk")).expect("a folder");
    fs::write(home.path().join("raywalk/config.toml"), config).expect("a configuration");
    let place = format!("XDG_CONFIG_HOME={}", home.path().display());
    let call = [&["-u", "RAYWALK_CONFIG", &place, PROGRAM], arguments].concat();
    (Session::of(Path::new("env").as_os_str(), &call, 120, 40), home)
}

/// What the program prints, and its exit code.
fn printed(arguments: &[&str], variable: &Path) -> (String, String, Option<i32>) {
    let mut command = assert_cmd::Command::cargo_bin("raywalk").expect("the program");
    let output = command.args(arguments).env("RAYWALK_CONFIG", variable).output().expect("it runs");
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("text in UTF-8");
    (text(output.stdout), text(output.stderr), output.status.code())
}

#[test]
fn what_the_configuration_says_holds() {
    let config = "language = \"es\"\ndigits = 5\nmouse = true\n[keys]\nX = \"next-value\"\nn = \"none\"\n\
                  \"ctrl-x\" = \":pixel 160,119\"\nq = \"help\"\nA = \"mark\"\n\"^q\" = \"quit\"\n";
    let (mut session, _home) = with(config, &["walk", "textbook"]);
    session.shows("paso 1/");
    session.has_mouse(true);
    session.shows("X siguiente");
    session.press("X");
    session.shows("ray.length");
    session.press("n");
    session.shows("esa tecla no existe");
    session.press("Ab");
    session.shows("marcador b");
    session.press("q");
    session.shows("Teclas");
    session.press("/calculado");
    session.hides("a la primera fila");
    let help = session.text();
    let row = help.lines().find(|line| line.contains("al siguiente valor calculado")).expect("the row of X");
    assert!(row.contains(" X   "), "{help}");
    session.press("\x03");
    session.hides("teclas con:");
    session.press("\x03");
    session.hides("Teclas");
    session.press("\x18");
    session.shows("160,119");
    // What a prompt is typed with stays.
    session.press(":quitX\x7f\r");
    session.ends_with(0);
}

#[test]
fn options_win_over_the_configuration() {
    let (mut session, _home) = with("language = \"es\"\ndigits = 5\n", &["walk", "textbook", "--lang", "en"]);
    session.shows("step 1/");
    session.press("nn");
    session.shows("step 3/");
    session.press("q");
    session.ends_with(0);
    // The call that leads back needs no more than it had.
    session.shows("back here: raywalk walk textbook --lang en --pixel 160,120 --at 3");
}

#[test]
fn a_broken_configuration_is_said_and_can_be_ignored() {
    let broken = "theme = \"drak\"\n";
    let (mut session, _home) = with(broken, &["walk", "textbook"]);
    session.ends_with(2);
    session.shows("config.toml:1:9: theme: unknown word `drak`, did you mean `dark`?");
    session.shows("note: --config none ignores the file");
    let (mut session, _home) = with(broken, &["walk", "textbook", "--config", "none"]);
    session.shows("step 1/");
    session.press("q");
    session.ends_with(0);
}

#[test]
fn two_logs_beside_each_other_have_the_same_keys() {
    let folder = tempfile::tempdir().expect("a folder");
    let logs = ["f64", "decimal:3"].map(|arithmetic| {
        let log = folder.path().join(arithmetic);
        let mut traced = assert_cmd::Command::cargo_bin("raywalk").expect("the program");
        traced.args(["trace", "textbook", "--pixel", "160,120", "--arithmetic", arithmetic, "-o"]).arg(&log);
        traced.assert().success();
        log.to_string_lossy().into_owned()
    });
    let (mut session, _home) = with("[keys]\nZ = \"quit\"\nq = \"none\"\n", &["diff", &logs[0], &logs[1], "--walk"]);
    session.shows("f64");
    session.press("?");
    session.shows("Z Esc ^c");
    session.press("?qZ");
    session.ends_with(1);
}

#[test]
fn a_printed_configuration_says_the_same() {
    let folder = tempfile::tempdir().expect("a folder");
    let (first, second) = (folder.path().join("first.toml"), folder.path().join("second.toml"));
    fs::write(&first, "digits = 7\n[keys]\nX = \":pixel 3,4\"\nn = \"none\"\n").expect("a configuration");
    let (file, said, code) = printed(&["walk", "--print-config", "--theme", "light"], &first);
    assert_eq!((said.as_str(), code), ("", Some(0)));
    for line in ["theme = \"light\"", "digits = 7", "\"X\" = \":pixel 3,4\"", "\"n\" = \"none\"", "\"d\" = \"delete\""]
    {
        assert!(file.lines().any(|found| found.starts_with(line)), "{line} in\n{file}");
    }
    fs::write(&second, &file).expect("a configuration");
    assert_eq!(printed(&["walk", "--print-config"], &second).0, file);
    // The one that is named wins.
    let named = ["walk", "--print-config", "--config", second.to_str().expect("a path in UTF-8")];
    assert_eq!(printed(&named, &folder.path().join("missing")).0, file);
    is_stable(&printed(&["walk", "--print-config"], Path::new("none")).0);
}

/// The names of actions are stable: whoever has bound keys to them relies on them.
fn is_stable(file: &str) {
    let bare = |line: &str| line.split("  #").next().unwrap_or_default().to_owned();
    let lines: Vec<_> = file.lines().filter(|line| line.starts_with('"')).map(bare).collect();
    crate::support::snapshots().bind(|| insta::assert_snapshot!("viewer_actions", lines.join("\n")));
}

#[test]
fn what_is_written_depends_on_the_call_alone() {
    let folder = tempfile::tempdir().expect("a folder");
    let broken = folder.path().join("broken.toml");
    fs::write(&broken, "nonsense").expect("a configuration");
    let (plain, said, code) = printed(&["walk", "textbook", "--plain"], &broken);
    assert_eq!((said.as_str(), code), ("", Some(0)));
    assert_eq!(plain, printed(&["walk", "textbook", "--plain"], Path::new("none")).0);
    // Unless it says which configuration.
    let named = ["walk", "textbook", "--plain", "--config", broken.to_str().expect("a path in UTF-8")];
    assert_eq!(printed(&named, Path::new("none")).2, Some(2));
}

#[test]
fn a_configuration_that_is_named_must_be_one() {
    let folder = tempfile::tempdir().expect("a folder");
    let refused = |path: &Path, expected: &str| {
        let (_, said, code) = printed(&["walk", "--print-config"], path);
        assert_eq!(code, Some(2), "{said}");
        assert!(said.contains(expected), "{said}");
    };
    refused(&folder.path().join("missing"), "no such file, expected a configuration file");
    refused(folder.path(), "expected a regular file");
    refused(Path::new("/dev/zero"), "expected a regular file");
    let large = folder.path().join("large");
    fs::write(&large, "#".repeat((1 << 18) + 1)).expect("a file");
    refused(&large, "too large, expected at most 262144 bytes");
}
