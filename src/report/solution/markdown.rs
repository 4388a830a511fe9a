//! A worked solution in Markdown, with formulas in TeX's notation and the ray tree for Mermaid.

use super::figures::caption;
use super::format::{self, Around, Format};
use super::math::{self, Tex};
use super::{Kind, Section, Task};
use crate::report::escape;
use crate::report::ray_tree::{self, Figure};
use crate::report::schematic::{self, Plan};
use std::convert::identity;

/// The worked solution of a log.
pub fn markdown(task: &Task) -> String {
    format::page::<Markdown>(task)
}

struct Markdown;

impl Format for Markdown {
    type Formulas = Tex;
    const HEADING: Around = ["## ", "\n\n"];
    const PARAGRAPH: Around = ["", "\n\n"];
    const DATA: Around = ["", "\n"];
    const GROUP: [&str; 3] = ["- **", ":** ", "\n"];
    const GIVEN: Around = ["", ":\n\n"];
    const ASSIGNMENT: Around = ["$", "$"];
    const DECISION: Around = ["→ ", "\n\n"];
    const BACK: Around = ["### ", "\n\n"];
    const LIST: [&str; 3] = ["", ":\n\n", ""];
    const ITEM: Around = ["- ", "\n"];
    const END: &str = "\n";

    fn escaped(text: &str) -> String {
        escape::markdown(text)
    }

    /// Code in a note is code here, too.
    fn note(note: &str) -> String {
        note.to_owned()
    }

    fn begin(_task: &Task, title: &str) -> String {
        format!("# {title}\n\n")
    }

    fn ray_tree(_task: &Task, figure: &Figure) -> String {
        format!("```mermaid\n{}```\n\n", ray_tree::mermaid(figure))
    }

    fn schematic(task: &Task, plan: &Plan) -> String {
        let (caption, drawing) = (escape::markdown(&caption(task, plan)), schematic::braille(plan));
        format!("## {caption}\n\n```text\n{}\n```\n\n", drawing.replace("```", "'''"))
    }

    fn open(_task: &Task, section: &Section, title: &str) -> String {
        match section.kind {
            Kind::Ray => format!("### {title}\n\n"),
            Kind::Step(number) => format!("**{number}) {title}**\n\n"),
            Kind::Part => format!("*{title}*\n\n"),
        }
    }

    fn equations(task: &Task, events: &[usize]) -> String {
        match &math::aligned(task, events, identity)[..] {
            [line] => format!("$$\n{}\n$$\n\n", line.replacen(" &=", " =", 1)),
            lines => format!("$$\n\\begin{{aligned}}\n{}\n\\end{{aligned}}\n$$\n\n", lines.join(" \\\\\n")),
        }
    }

    fn table(columns: &[String; 7], rows: &[[String; 7]]) -> String {
        let row = |cells: &[String; 7]| format!("| {} |\n", cells.join(" | "));
        let rows: String = rows.iter().map(row).collect();
        format!("{}|---|---|---|---|---|---|--:|\n{rows}\n", row(columns))
    }
}
