//! Themes in a real pseudo-terminal, which has 256 colours and a dark background.

use crate::session::Session;
use std::collections::BTreeSet;

fn colors_of(theme: &str) -> BTreeSet<u8> {
    let mut session = Session::start(&["walk", "textbook", "--theme", theme], 80, 20);
    session.shows("step 1/98");
    session.press("Tzo");
    session.shows("no tests");
    let colors = session.colors();
    session.press("q");
    session.ends_with(0);
    colors
}

#[test]
fn themes_have_their_colours() {
    assert_eq!(colors_of("mono"), BTreeSet::new());
    let [dark, light, auto] = ["dark", "light", "auto"].map(colors_of);
    assert!(dark.iter().any(|color| *color >= 16) && light.iter().any(|color| *color >= 16), "{dark:?} {light:?}");
    assert_ne!(dark, light);
    // `COLORFGBG` says that the background is dark.
    assert_eq!(auto, dark);
    let of_scheme = colors_of("16");
    assert!(!of_scheme.is_empty() && of_scheme.iter().all(|color| *color < 16), "{of_scheme:?}");
}
