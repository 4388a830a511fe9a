//! A worked solution in Markdown, with formulas in TeX's notation and the ray tree for Mermaid.

use super::figures::{Figures, caption};
use super::shares::Shares;
use super::{Item, Kind, Section, Solution, Task, data, decision, lowered, math};
use crate::log::Value;
use crate::report::escape::{self, line};
use crate::report::{digits, ray_tree, schematic};
use std::convert::identity;
use std::fmt::Write;

/// The worked solution of a log.
pub fn markdown(task: &Task) -> String {
    let solution = Solution::of(task);
    let texts = task.language.texts();
    let mut out = String::new();
    line!(out, "# {}\n", escape::markdown(&solution.title));
    line!(out, "{}\n", escape::markdown(&solution.conditions.join(" ")));
    if !solution.data.groups.is_empty() {
        line!(out, "## {}\n", texts.solution.data);
        for (owner, values) in &solution.data.groups {
            let values =
                values.iter().map(|(name, value)| format!("${}$", math::assignment(task, name.symbol(), value)));
            let heading = escape::markdown(&data::heading(task, *owner));
            line!(out, "- **{heading}:** {}", values.collect::<Vec<_>>().join(", "));
        }
        line!(out);
    }
    figures(&mut out, task);
    line!(out, "## {}\n", texts.solution.steps);
    section(&mut out, task, &solution.steps);
    line!(out, "## {}\n", texts.solution.result);
    match solution.result {
        Some((color, event)) => {
            let marker = digits::marker_in(task.language, &task.log.events[event]);
            let color = format!("${}$", math::value(task, &Value::Triple(color)));
            line!(out, "{}{marker}\n", (texts.solution.conclusion)(&color));
        }
        None => line!(out, "{}\n", texts.solution.no_result),
    }
    shares(&mut out, task);
    out.truncate(out.trim_end().len());
    out.push('\n');
    out
}

fn figures(out: &mut String, task: &Task) {
    let texts = &task.language.texts().figure;
    let figures = Figures::of(task);
    line!(out, "## {}\n", texts.ray_tree);
    for note in &figures.notes {
        // Code in a note is code here, too.
        line!(out, "{note}\n");
    }
    if let Some(tree) = figures.tree(task) {
        line!(out, "```mermaid\n{}```\n", ray_tree::mermaid(&tree));
    }
    if let Some(plan) = &figures.plan {
        line!(out, "## {}\n", escape::markdown(&caption(task, plan)));
        line!(out, "```text\n{}\n```\n", schematic::braille(plan).replace("```", "'''"));
    }
}

fn section(out: &mut String, task: &Task, section: &Section) {
    let title = escape::markdown(&section.title);
    match section.kind {
        // A pixel of one sample is said in the title.
        Kind::Ray if section.is_wrapper() => {}
        Kind::Ray => line!(out, "### {title}\n"),
        Kind::Step(number) => line!(out, "**{number}) {title}**\n"),
        Kind::Part => line!(out, "*{title}*\n"),
    }
    // Steps after another ray's say that they are this ray's again.
    let mut is_away = false;
    for item in &section.items {
        if let Item::Section(inside) = item {
            if is_away && inside.kind != Kind::Ray {
                let title = (task.language.texts().solution.back)(&lowered(&section.title));
                line!(out, "### {}\n", escape::markdown(&title));
            }
            is_away = inside.kind == Kind::Ray && section.kind == Kind::Ray;
            self::section(out, task, inside);
            continue;
        }
        if let Some(text) = self::item(task, item) {
            line!(out, "{text}\n");
        }
    }
}

fn item(task: &Task, item: &Item) -> Option<String> {
    match item {
        Item::Section(_) => None,
        Item::Given(values) => {
            let values =
                values.iter().map(|(name, value, _)| format!("${}$", math::assignment(task, name.symbol(), value)));
            let texts = &task.language.texts().solution;
            Some(format!("{} {}:", texts.with, values.collect::<Vec<_>>().join(", ")))
        }
        Item::Equations(events) => Some(match &math::aligned(task, events, identity)[..] {
            [line] => format!("$$\n{}\n$$", line.replacen(" &=", " =", 1)),
            lines => format!("$$\n\\begin{{aligned}}\n{}\n\\end{{aligned}}\n$$", lines.join(" \\\\\n")),
        }),
        Item::Decision(event) => {
            let numbers = math::compared(task, *event);
            Some(format!("→ {}{numbers}", escape::markdown(&decision(task, *event)?)))
        }
    }
}

fn shares(out: &mut String, task: &Task) {
    let texts = &task.language.texts().solution;
    let shares = Shares::of(task);
    line!(out, "## {}\n", texts.contributions);
    line!(out, "| {} |", texts.columns.join(" | "));
    line!(out, "|---|---|---|---|---|---|--:|");
    for row in &shares.rows {
        let cells = row.each_ref().map(|cell| escape::markdown(cell));
        line!(out, "| {} |", cells.join(" | "));
    }
    line!(out);
    if shares.ended.is_empty() {
        return;
    }
    line!(out, "{}:\n", texts.brings_nothing);
    for (path, why) in &shares.ended {
        line!(out, "- {path}: {}", escape::markdown(why));
    }
    if shares.more > 0 {
        line!(out, "- {}", (texts.more)(shares.more));
    }
}
