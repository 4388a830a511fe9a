//! A worked solution as one page by itself. Its parts fold and its values lead to the step that computed them without any script;
//! with one, all parts open and close at once, and a value shows where else it occurs.

mod formula;

use super::figures::{Figures, caption};
use super::shares::Shares;
use super::{Item, Kind, Section, Solution, Task, data, decision};
use crate::log::{Decision, Value, What};
use crate::report::escape::{self, line};
use crate::report::{digits, ray_tree, schematic};
use std::fmt::Write;

const STYLE: &str = include_str!("html/style.css");
const SCRIPT: &str = include_str!("html/script.js");

/// The worked solution of a log.
pub fn html(task: &Task) -> String {
    let solution = Solution::of(task);
    let texts = task.language.texts();
    let mut out = String::new();
    let title = escape::xml(&solution.title);
    line!(out, "<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">", task.language.code());
    line!(out, "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">");
    line!(
        out,
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; \
         script-src 'unsafe-inline'\">"
    );
    line!(out, "<title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n<main>\n<h1>{title}</h1>");
    line!(out, "<p>{}</p>", escape::xml(&solution.conditions.join(" ")));
    problem(&mut out, task, &solution);
    figures(&mut out, task);
    let (open, close) = (escape::xml(texts.solution.open_all), escape::xml(texts.solution.close_all));
    line!(out, "<h2>{}</h2>", escape::xml(texts.solution.steps));
    line!(out, "<div id=\"steps\" data-open=\"{open}\" data-close=\"{close}\">");
    section(&mut out, task, &solution.steps);
    line!(out, "</div>\n<h2>{}</h2>", escape::xml(texts.solution.result));
    match solution.result {
        Some((color, event)) => {
            let marker = escape::xml(&digits::marker_in(task.language, &task.log.events[event]));
            let color = formula::linked(&formula::value(task, &Value::Triple(color)), last_color(task));
            let sentence = (texts.solution.conclusion)("\u{0}");
            line!(out, "<p class=\"result\">{}{marker}</p>", escape_around(&sentence, &color));
        }
        None => line!(out, "<p>{}</p>", escape::xml(texts.solution.no_result)),
    }
    shares(&mut out, task);
    line!(out, "</main>\n<script>\n{SCRIPT}</script>\n</body>\n</html>");
    out
}

/// A sentence with a value in the place of its one mark.
fn escape_around(sentence: &str, value: &str) -> String {
    sentence.split('\u{0}').map(escape::xml).collect::<Vec<_>>().join(value)
}

/// The event that computed the pixel's colour, where one sample is the pixel.
fn last_color(task: &Task) -> Option<usize> {
    let is_color = |event: &usize| match task.log.events[*event].what {
        What::Note { name, .. } => name.key() == crate::log::Name::CombineColor.key(),
        _ => false,
    };
    let has_samples = task.tree.nodes().iter().any(|node| matches!(node.step, Some(crate::log::Step::Sample { .. })));
    (0..task.log.events.len()).rev().find(is_color).filter(|_| !has_samples)
}

fn problem(out: &mut String, task: &Task, solution: &Solution) {
    if solution.data.groups.is_empty() {
        return;
    }
    line!(out, "<h2>{}</h2>\n<dl>", escape::xml(task.language.texts().solution.data));
    for (owner, values) in &solution.data.groups {
        let values = values.iter().map(|(name, value)| formula::assignment(task, name.symbol(), value, None));
        line!(out, "<dt>{}</dt>", escape::xml(&data::heading(task, *owner)));
        line!(out, "<dd>{}</dd>", values.collect::<Vec<_>>().join(" "));
    }
    line!(out, "</dl>");
}

fn figures(out: &mut String, task: &Task) {
    let texts = &task.language.texts().figure;
    let figures = Figures::of(task);
    line!(out, "<h2>{}</h2>", escape::xml(texts.ray_tree));
    for note in &figures.notes {
        line!(out, "<p>{}</p>", escape::xml(&note.replace('`', "")));
    }
    if let Some(tree) = figures.tree(task) {
        line!(out, "<figure>\n{}</figure>", ray_tree::svg_of(&tree));
    }
    if let Some(plan) = &figures.plan {
        let caption = caption(task, plan);
        line!(out, "<h2>{}</h2>", escape::xml(texts.schematic));
        line!(out, "<figure>\n{}", schematic::svg_of(plan, &caption));
        line!(out, "<figcaption>{}</figcaption></figure>", escape::xml(&caption));
    }
}

fn section(out: &mut String, task: &Task, section: &Section) {
    if section.is_wrapper() {
        section.items.iter().for_each(|item| self::item(out, task, item));
        return;
    }
    let (class, number) = match section.kind {
        Kind::Ray => ("ray", String::new()),
        Kind::Step(number) => ("step", format!("{number}) ")),
        Kind::Part => ("part", String::new()),
    };
    // What is missed is in its title, and opens on demand.
    let miss = miss(task, section).map(|miss| format!(" <span class=\"miss\">— {}</span>", escape::xml(&miss)));
    let (open, miss) = miss.map_or((" open", String::new()), |miss| ("", miss));
    line!(out, "<details class=\"{class}\"{open}><summary>{number}{}{miss}</summary>", escape::xml(&section.title));
    section.items.iter().for_each(|item| self::item(out, task, item));
    line!(out, "</details>");
}

/// Why the ray misses the object that a section tests; nothing if it doesn't.
fn miss(task: &Task, section: &Section) -> Option<String> {
    section.items.iter().find_map(|item| match item {
        Item::Decision(event) if matches!(task.log.events[*event].what, What::Mark(Decision::Miss { .. })) => {
            decision(task, *event)
        }
        _ => None,
    })
}

fn item(out: &mut String, task: &Task, item: &Item) {
    match item {
        Item::Section(inside) => section(out, task, inside),
        Item::Given(values) => {
            let values =
                values.iter().map(|(name, value, source)| formula::assignment(task, name.symbol(), value, *source));
            let with = escape::xml(task.language.texts().solution.with);
            line!(out, "<p class=\"given\">{with} {}</p>", values.collect::<Vec<_>>().join(" "));
        }
        Item::Equations(events) => events.iter().for_each(|event| {
            if let Some(equation) = formula::equation(task, *event) {
                line!(out, "{equation}");
            }
        }),
        Item::Decision(event) => {
            let decision = decision(task, *event).unwrap_or_default();
            let numbers = formula::compared(task, *event);
            line!(out, "<p class=\"decision\">→ {}{numbers}</p>", escape::xml(&decision));
        }
    }
}

fn shares(out: &mut String, task: &Task) {
    let texts = &task.language.texts().solution;
    let shares = Shares::of(task);
    line!(out, "<h2>{}</h2>\n<div class=\"wide\"><table>", escape::xml(texts.contributions));
    let heads = texts.columns.map(|column| format!("<th>{}</th>", escape::xml(column)));
    line!(out, "<tr>{}</tr>", heads.concat());
    for row in &shares.rows {
        let cells = row.each_ref().map(|cell| format!("<td>{}</td>", escape::xml(cell)));
        line!(out, "<tr>{}</tr>", cells.concat());
    }
    line!(out, "</table></div>");
    if shares.ended.is_empty() {
        return;
    }
    line!(out, "<details><summary>{}</summary>\n<ul>", escape::xml(texts.brings_nothing));
    for (path, why) in &shares.ended {
        line!(out, "<li>{}: {}</li>", escape::xml(path), escape::xml(why));
    }
    if shares.more > 0 {
        line!(out, "<li>{}</li>", escape::xml(&(texts.more)(shares.more)));
    }
    line!(out, "</ul></details>");
}
