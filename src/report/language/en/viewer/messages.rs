//! What is said at the bottom, in English.

use crate::report::language::viewer::{Breakpoints, Commands, Messages, Quiz, Warnings};

pub(super) const MESSAGES: Messages = Messages {
    last_step: |count| format!("there are {count} steps; this is the last"),
    no_shell: "there is no shell to go to",
    no_scene: "a saved log has no scene to trace",
    other_pane: "that is for the picture and the schematic; Tab goes there",
    no_key: "no such key; ? shows the keys",
    no_siblings: "no more nodes in this one's parent",
    no_steps: "no more steps in this direction",
    no_values: "no more computed values in this direction",
    no_rays: "no more rays in this direction",
    no_step_over: "no more steps here or around it in this direction",
    no_step_out: "nothing around it to step out to in this direction",
    whole_tree: "the whole tree is shown",
    tree_grows: "the tree grows with the steps; t shows all of it",
    rate: |rate, is_playing| {
        let steps = if rate == 1 { "step" } else { "steps" };
        format!("{rate} {steps} a second{}", if is_playing { "" } else { "; P plays" })
    },
    nothing_to_play: "no more computed values to play; 0 goes to the first step",
    played: "played to the last computed value",
    nowhere_back: "nowhere to go back to: nothing was jumped from",
    no_jump: "no jump to come back from",
    not_traced_again: "where one was before the first pixel isn't traced again",
    nearest_step: "that step isn't in this log; this is the nearest",
    copied: |text| format!("copied: {text}"),
    no_step_to_remember: "no step to remember",
    bookmark: |letter, address| format!("bookmark {letter}: {address}"),
    no_bookmark: |letter| format!("no bookmark {letter}; m{letter} sets it, M lists all"),
    bookmark_elsewhere: |letter, address| format!("bookmark {letter}: this log has no {address}"),
    no_search: "nothing is searched for; / searches",
    not_found: |text| format!("not found: {text}"),
    no_row: |text| format!("no row matches: {text}"),
    from_the_beginning: "from the beginning again",
    from_the_end: "from the end again",
    pasted_nowhere: "text can only be pasted into a line that is being typed, such as after / or :",
    mouse_is_ours: "the mouse selects and scrolls; ^t gives it back",
    mouse_is_the_terminals: "the mouse is the terminal's",
    one_pixel_printed: "the book prints one pixel only",
    regions_not_compared: "only pixels and rays are compared",
    too_long: |most| format!("the log would have more than {most} events"),
    no_memory: "not enough memory for the log",
    language: "in English",
    back_here: |call| format!("back here: {call}"),
    warnings: Warnings {
        ending: |ending| ending.warning(),
        biased: |effects| {
            format!(
                "adaptive sampling is biased with {effects}: cells whose corners agree by chance are not cut; expected \
                 another sampling, such as sobol:64"
            )
        },
    },
};

pub(super) const QUIZ: Quiz = Quiz {
    begins: "quiz: n goes to the next value, = answers it, Q ends",
    ends: |right, asked| format!("the quiz is over: {right} of {asked} right"),
    none: "no quiz is on; Q begins one",
    nothing_hidden: "this step hides no result; n goes to the next",
    what_is_decided: "what is decided? hit, miss, inside, background, an object's name, ...",
    right: "right",
    off: |by| format!("off by {by}"),
    not_it: "it isn't",
    it_is: |off, truth| format!("{off}; it is {truth}"),
    try_again: |off| format!("{off}; try again"),
    // No value of the numeric example, which would be answered by it.
    no_number: "that is no number: type it like 12.5",
    no_triple: "that is no triple: type three numbers, like (1, 2, 3) or 1 2 3",
    no_decision: "that is no decision: type it like hit, miss, nearest, background, or an object's name",
    tells_results: "that would tell the results; Q ends the quiz",
    tells_result: "that would tell the result; = answers, Q ends the quiz",
    tells_decision: "that would tell the decision; = answers, Q ends the quiz",
};

pub(super) const BREAKPOINTS: Breakpoints = Breakpoints {
    set: |text| format!("breakpoint: {text}; r runs to it, B lists all"),
    deleted: |text| format!("no breakpoint any more: {text}"),
    hidden: "a quiz hides where that stops; Q ends it",
    nothing_here: "nothing here that a run could stop at",
    nowhere: |text| format!("nowhere in this log: {text}"),
    all_off: "all breakpoints are off; B lists them",
    none: "no breakpoints; b sets one",
    no_more: |done, times, is_forward| {
        let stopped = if done == 0 { String::new() } else { format!("stopped {done} of {times} times; ") };
        format!("{stopped}no breakpoint stops {} this step", if is_forward { "after" } else { "before" })
    },
    stopped: |breakpoint, what| format!("stopped by {breakpoint}: {what}"),
    expected: "expected a breakpoint: hit, shadow, object NAME, light NAME, depth 2 or T2_A < 0",
    expected_kind: "expected a kind of event such as shadow, hit, occluded or total-internal-reflection",
    kind_like: |text, near| format!("no kind of event is called `{text}`; did you mean `{near}`?"),
    object_like: |text, near| format!("there is no object `{text}`; did you mean `{near}`?"),
    other_objects: |text, others, more| format!("there is no object `{text}`, but {others}{}", and_more(more)),
    no_objects: "there is no object in this log",
    light_like: |text, near| format!("there is no light `{text}`; did you mean `{near}`?"),
    other_lights: |text, others, more| format!("there is no light `{text}`, but {others}{}", and_more(more)),
    no_lights: "there is no light in this log",
    expected_depth: "expected a level of the ray tree, such as depth 2",
    no_components: |symbol| format!("{symbol} is a number and has no components"),
    three_numbers: |key| {
        format!("{key} has three numbers: compare {key}.x, .y or .z (.r, .g or .b), or the length |{key}|")
    },
    expected_number: |text| format!("expected a number such as 0 or -1.5e-3, not `{text}`"),
    name_like: |text, near| format!("nothing is called `{text}`; did you mean `{near}`?"),
    no_name: |text| {
        format!(
            "nothing is called `{text}`: expected a kind of event (hit), object NAME, light NAME, depth 2 or a quantity (T2_A < 0)"
        )
    },
};

pub(super) const COMMANDS: Commands = Commands {
    letter: "LETTER",
    condition: "CONDITION",
    text: "TEXT",
    step: ":42 (a step)",
    nothing_behind: |command| format!("nothing stands behind :{command}"),
    like: |text, near| format!("no command :{text}; did you mean :{near}?"),
    expected: |commands| format!("expected a step or a command: {commands}"),
    may_be: |text, commands| format!(":{text} may be {commands}"),
    steps: |count| format!("there are steps 1 to {count}"),
    expected_letter: "expected one letter, such as :bookmark a",
    expected_pixel: "expected a column and a row, such as :pixel 160,120",
    expected_language: "expected a language: :lang en or :lang es",
    log_has: |[left, top, right, bottom]| format!("the log has columns {left} to {right} and rows {top} to {bottom}"),
    picture_has: |[column, row]| format!("the picture has columns 0 to {column} and rows 0 to {row}"),
};

/// So many more, behind some names.
fn and_more(count: usize) -> String {
    if count == 0 { String::new() } else { format!(" and {count} more") }
}
