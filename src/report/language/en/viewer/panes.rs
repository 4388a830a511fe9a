//! The panes and the bottom line in English.

use crate::report::language::viewer::{Outcomes, Panes, Picture, Schematic, Status};

pub(super) const STATUS: Status = Status {
    step: |step, count| format!("step {step}/{count}"),
    section: |section| format!("section {section}"),
    hints: ["n next value  p previous  ? help  q quit", "n next  ? help  q quit", "? help"],
    all_hints: |moves| format!("n next value  p previous  {moves}  ? help  q quit"),
    moves: ["j k move  Space fold", "j k move  Tab tree"],
    playing: |rate| format!("playing {rate}/s"),
    growing: "growing",
    filtered: "filtered",
    mouse: "mouse",
    counting: "counting matches",
    matches: |number, count| format!("match {number}/{count}"),
    quiz: |right, asked| format!("quiz {right} of {asked}"),
    filter: "filter: ",
    break_at: "break at: ",
    keys_with: "keys with: ",
    answer: "your answer: ",
    warning: "warning: ",
    too_small: ["too small:", "needs 20x6", "(q quits)"],
};

pub(super) const PANES: Panes = Panes {
    algorithm: |name| format!("{name} algorithm"),
    calls: "calls",
    shadow_ray: |path| format!("shadow ray {path}"),
    end: "end",
    end_of: |node| format!("end of {node}"),
    hidden_decision: "decision ?",
    hidden_result: "result ?",
    not_computed: "not computed yet",
    result: |color| format!("result {color}"),
    ray: |kind| format!("ray {kind}"),
    hidden_rays: |count| if count == 1 { "1 ray".to_owned() } else { format!("{count} rays") },
    outcomes: Outcomes {
        lit: "lit",
        hit: "hit",
        miss: "miss",
        background: "background",
        blocked_by: |object| format!("blocked by {object}"),
        rejected: "rejected",
        weakened_by: |object| format!("weakened by {object}"),
        depth_limit: "depth limit",
        total_reflection: "total reflection",
    },
    samples: |count| match count {
        1 => "1 sample in the pixel".to_owned(),
        _ => format!("{count} samples in the pixel"),
    },
    picture: Picture {
        layers: ["picture", "depth", "rays per pixel", "samples per pixel", "error of f32"],
        exposure: |stops| format!("{stops} stops"),
        depth: |depth| format!("depth {depth}"),
        rays: |count| format!("rays {count}"),
        levels: |[r, g, b]| format!("8-bit {r} {g} {b}"),
        ends: "the picture ends here",
    },
    schematic: Schematic {
        views: ["schematic from above", "schematic from the front", "schematic from the eye"],
        turns: "v turns",
        no_rays: "the log has no rays here",
        too_far: "the rays reach too far to be drawn",
    },
};
