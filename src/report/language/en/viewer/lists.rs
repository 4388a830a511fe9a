//! The lists in English.

use crate::report::language::viewer::{Account, Arithmetics, Hints, List, Lists, ToCome};

pub(super) const LISTS: Lists = Lists {
    hints: Hints {
        usual: ["j k select, Enter goes there, Esc closes", "Enter goes, Esc closes"],
        cut: ["j k select, < > scroll, Enter goes there, Esc closes", "< > scroll, Enter goes, Esc closes"],
        cut_plain: "< > scroll, Esc closes",
        closes: "Esc closes",
        breakpoints: [
            "Space on/off, d deletes, Enter next place, Esc closes",
            "Space on/off, d deletes, Enter next",
            "Space on/off, d del, Enter next",
            "Space on/off, d deletes",
        ],
    },
    breakpoints: List {
        title: "Breakpoints",
        columns: ["state", "stops at"],
        nothing: "none: b types one, x sets one here",
    },
    on: "on",
    off: "off",
    stops: List {
        title: "Where runs stopped",
        columns: ["step", "pixel", "stopped at", "what is there"],
        nothing: "nowhere yet: r runs to a breakpoint",
    },
    bookmarks: List {
        title: "Bookmarks",
        columns: ["key", "address", "what is there"],
        nothing: "none: m and a letter set one",
    },
    in_pixel: |[x, y], what| format!("in {x},{y}: {what}"),
    not_in_this_log: "(not in this log)",
    operands: List {
        title: |value| format!("What {value} is made of"),
        columns: ["operand", "value", "from"],
        nothing: "this step takes nothing that the log names",
    },
    given_in: |place| format!("given in {place}"),
    uses: List {
        title: |value| format!("What takes {value}"),
        columns: ["value", "computed in"],
        nothing: "no later step takes it",
    },
    step: |number| format!("step {number}"),
    account: Account {
        list: List {
            title: |color| format!("Why the colour is {color}"),
            columns: [
                "share",
                "path",
                "times",
                "from",
                "class",
                "figure 14",
                "% of r g b",
                "brings",
                "= own colour * weight",
            ],
            nothing: "no light is accounted for yet",
        },
        so_far: |color| format!("The log ends before the colour; so far {color}"),
        here: |class| format!(" - here {class}"),
        cases: |cases| cases,
        smaller: |count| format!("{count} smaller ones together"),
        brings_nothing: |count| format!("What brings nothing ({count}):"),
    },
    arithmetics: Arithmetics {
        list: List {
            title: |node| format!("{node} in three arithmetics"),
            columns: ["", "by hand", "f32", "digits", "f64"],
            nothing: "this node computes nothing itself",
        },
        not_reached: "not reached",
        decided_otherwise: "0: decided otherwise",
        names: ["by hand", "in f32", "in f64"],
        never_reached: |arithmetic| format!("not reached {arithmetic}: it decides otherwise before"),
        other_decisions: |arithmetic| format!("other decisions {arithmetic} in this node"),
    },
    to_come: ToCome {
        color: "the colour isn't computed yet; t shows the whole tree",
        node: "this node isn't computed yet to its end; t shows the whole tree",
        uses: "what takes a value comes after it; t shows the whole tree",
    },
};
