//! What is said at the bottom moves nothing.

use super::*;

const LONG: &str = "a message that is much longer than any line of the terminals that most people have, so that it has to be \
                    broken into lines, of which the last one is cut where not even three of them are enough for all of it";

fn rows(model: &Model, ascii: bool) -> Vec<String> {
    let (width, height) = model.size;
    let text = dump(&frame(model, width, height, &Theme::new(Palette::None, ascii)));
    text.lines().take(usize::from(height)).map(str::to_owned).collect()
}

#[test]
fn no_pane_moves_for_a_message() {
    for (width, height) in SIZES.into_iter().filter(|(width, height)| *width >= 20 && *height >= 6) {
        for keys in ["", "40n", "?", "w"] {
            let mut model = sized(glass(), width, height);
            typed(&mut model, keys);
            let before = rows(&model, false);
            for (message, most) in [("so", 1), (LONG, 3)] {
                model.message = None;
                model.say(message);
                let after = rows(&model, false);
                let changed = (0..before.len()).filter(|row| before[*row] != after[*row]);
                let highest = changed.min().expect("it is shown");
                assert!(highest >= before.len() - most, "{message} after {keys}:\n{}", after.join("\n"));
            }
        }
    }
}

#[test]
fn the_step_stays_beside_a_message_that_leaves_room() {
    let bottom = |message: &str, width: u16| {
        let mut model = sized(textbook(), width, 12);
        typed(&mut model, "t");
        model.message = None;
        model.say(message);
        rows(&model, true).pop().unwrap_or_default()
    };
    assert_eq!(bottom("done", 40), "step 1/98  growing  done");
    assert_eq!(bottom("done with all of that now", 40), "step 1/98  done with all of that now");
    assert_eq!(bottom("done with all of that now, and more", 40), "done with all of that now, and more");
}

#[test]
fn a_long_message_is_broken_and_a_longer_one_cut_with_a_mark() {
    let mut model = sized(textbook(), 40, 12);
    model.warn(LONG);
    let shown = rows(&model, true);
    assert!(shown[9].starts_with("warning: a message"), "{}", shown.join("\n"));
    assert!(shown[11].ends_with('>'), "{}", shown.join("\n"));
    // The line that is typed stays below it.
    typed(&mut model, ":");
    let shown = rows(&model, true);
    assert!(shown[8].starts_with("warning: a message") && shown[11].starts_with(':'), "{}", shown.join("\n"));
    typed(&mut model, "Esc Esc");
    assert!(rows(&model, true)[11].starts_with("step 1/98"));
}
