//! Values that are watched, their history, expressions, and the marks of breakpoints: frames in both languages, and in a pseudo-terminal
//! while the scene changes.

use crate::frames::usual;
use crate::support::{scene, snapshots};
use raywalk::record::{self, Arithmetic};
use raywalk::report::Language;
use raywalk::tui::{self, Palette, Theme, dump::dump};

fn frame(keys: &str, (width, height): (u16, u16), language: Language, ascii: bool) -> String {
    let theme = Theme::new(Palette::None, ascii);
    let options = usual(theme, language);
    let log = record::pixel(&scene("textbook"), [160, 120], Arithmetic::Decimal(3));
    let model = tui::opened_with_keys(log, &options, None, keys, (width, height));
    dump(&tui::frame(&model, width, height, &theme))
}

const WATCHED: &str = ":watch N·L Enter :watch shade.local.r Enter 38n";

/// Keys that lead to what is said of values, breakpoints of several terms and expressions, right and wrong.
pub const KEYS: [&str; 26] = [
    "*",
    "n *",
    "n * *",
    "n * :watch Enter",
    ":watch Enter",
    ":watch N·L Enter 38n",
    ":watch N·L Enter :watch N·L Enter d",
    ":watch cone.t_0 Enter",
    ":watch zzz Enter",
    ":watch N·K Enter",
    ":unwatch N·L Enter",
    ":history Enter",
    ":history T2_A Enter",
    "n #",
    ":eval Enter",
    ":eval 1 + Enter",
    ":eval (1 Enter",
    ":eval 1 2 Enter",
    ":eval zzz Enter",
    ":eval N + 1 Enter",
    "38n :eval N + 1 Enter",
    "38n :eval dot(N; L) Enter",
    "Q :eval N Enter",
    "bhit and Enter",
    "b(hit Enter",
    "bN·L is nann Enter",
];

#[test]
fn frames_at_three_sizes_in_both_languages() {
    snapshots().bind(|| {
        for (size, at) in [("40x12", (40, 12)), ("80x24", (80, 24)), ("120x40", (120, 40))] {
            for language in Language::ALL {
                let code = language.code();
                let shot = |name: &str, keys: &str| {
                    insta::assert_snapshot!(format!("viewer_{name}_{code}_{size}"), frame(keys, at, language, false));
                };
                shot("watched", &format!("{WATCHED} Tab"));
                shot("watch_list", &format!("{WATCHED} :watch Enter"));
                shot("history", &format!("{WATCHED} :history T2_A Enter"));
                shot("eval", &format!("{WATCHED} :eval dot(N, L) + 1 Enter"));
                shot("gutter", "bT2_A<0 or depth 1 and hit Enter r Esc");
            }
        }
    });
}

#[test]
fn ascii_has_marks_and_bars_of_its_own() {
    let text = frame(&format!("{WATCHED} bN·L<2 Enter 0r :watch Enter"), (100, 30), Language::English, true);
    assert!(text.lines().take(30).all(|line| line.is_ascii()), "{text}");
    assert!(text.contains("N*L = ") && text.contains("_#"), "{text}");
    let text = frame("bN·L<2 Enter 0r Esc", (100, 30), Language::English, true);
    assert!(text.contains(">& ") && text.lines().take(30).any(|line| line.starts_with('&')), "{text}");
}

#[test]
fn no_size_is_too_small() {
    for (width, height) in (0..50).step_by(7).flat_map(|width| (0..20).map(move |height| (width, height))) {
        for keys in ["", " :watch Enter", " A", " bN·L<2 Enter 0r"] {
            frame(&format!("{WATCHED}{keys}"), (width, height), Language::English, false);
        }
    }
}

#[cfg(unix)]
mod in_a_terminal {
    use crate::session::Session;

    #[test]
    fn what_is_watched_stays_while_the_scene_changes() {
        let mut session = Session::start(&["walk", "textbook"], 120, 40);
        session.shows("step 1/");
        session.press(":watch shade.n_dot\t\t");
        session.shows("watch shade.n_dot_h  watch shade.n_dot_l");
        session.press("l\r");
        session.shows("watching shade.n_dot_l: ");
        session.shows("N·L: no value here");
        session.press("bshade.n_dot_l < 0.9 and depth = 1\r");
        session.shows("breakpoint: shade.n_dot_l < 0.9 and depth = 1");
        session.press("r");
        session.shows("stopped by shade.n_dot_l < 0.9 and depth = 1");
        session.shows("▶◆");
        session.press("B");
        session.shows("hits");
        session.shows("on        1       ");
        // By itself the key can't be taken for the beginning of another one.
        session.press("\x1b");
        session.hides("Breakpoints");
        session.press(":set objects.sphere.shape.sphere.radius 2.5\r");
        session.shows("differences");
        session.press(":watch\r");
        session.shows("Watched values");
        session.shows("≠");
        session.press("d");
        session.shows("none: * watches");
        session.press("\x1b");
        session.hides("Watched values");
        session.press(":eval dot(N, L) - N·L\r");
        session.shows("dot(N, L) - N·L = ");
        session.press(":eval dot(N, Q_q)\r");
        session.shows("column 8: nothing is called `Q_q`");
        session.press("\x1b");
        session.hides("column 8");
        session.press("q");
        session.ends_with(0);
    }
}
