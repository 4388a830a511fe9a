//! A worked solution for pdflatex, with what a standard distribution has: amsmath, longtable and TikZ.

use super::figures::{Figures, caption};
use super::shares::Shares;
use super::{Item, Kind, Section, Solution, Task, data, decision, lowered, math};
use crate::log::Value;
use crate::report::escape::{self, line};
use crate::report::{digits, ray_tree, schematic};
use std::fmt::Write;

/// What precedes the text. A figure that is wider than the page is made to fit.
const PREAMBLE: &str = r"\documentclass[10pt,a4paper,fleqn]{article}
\usepackage[utf8]{inputenc}
\usepackage[margin=2cm]{geometry}
\usepackage{amsmath}
\usepackage{array}
\usepackage{longtable}
\usepackage{tikz}
\definecolor{camera}{HTML}{3B4252}
\definecolor{reflected}{HTML}{1D6FB8}
\definecolor{transmitted}{HTML}{2C8A4B}
\definecolor{shadow}{HTML}{C98A00}
\definecolor{blocked}{HTML}{C0392B}
\setlength{\parindent}{0pt}
\setlength{\parskip}{4pt}
\setlength{\mathindent}{1.5em}
\setlength{\emergencystretch}{3em}
\allowdisplaybreaks
\raggedright
\AtBeginDocument{\setlength{\abovedisplayskip}{3pt}\setlength{\belowdisplayskip}{5pt}%
  \setlength{\abovedisplayshortskip}{3pt}\setlength{\belowdisplayshortskip}{5pt}}
\newcolumntype{P}[1]{>{\raggedright\arraybackslash}p{#1}}
\newsavebox{\drawing}
\newcommand{\drawn}{\begin{center}\ifdim\wd\drawing>\linewidth
  \resizebox{\linewidth}{!}{\usebox{\drawing}}\else\usebox{\drawing}\fi\end{center}}
\newcommand{\fitted}[1]{\sbox{\drawing}{$\displaystyle #1$}\ifdim\wd\drawing>0.9\linewidth
  \resizebox{0.9\linewidth}{!}{\usebox{\drawing}}\else\usebox{\drawing}\fi}
\newcommand{\step}[2]{\par\medskip\textbf{#1) #2}\nopagebreak}
\newcommand{\parttitle}[1]{\par\smallskip\textit{#1}\nopagebreak}
\begin{document}
";

/// The worked solution of a log.
pub fn latex(task: &Task) -> String {
    let solution = Solution::of(task);
    let texts = task.language.texts();
    let mut out = PREAMBLE.to_owned();
    line!(out, "\\section*{{{}}}", escape::latex(&solution.title));
    line!(out, "{}\n", escape::latex(&solution.conditions.join(" ")));
    if !solution.data.groups.is_empty() {
        line!(out, "\\subsection*{{{}}}", escape::latex(texts.solution.data));
        for (owner, values) in &solution.data.groups {
            let values =
                values.iter().map(|(name, value)| format!("${}$", math::assignment(task, name.symbol(), value)));
            let heading = escape::latex(&data::heading(task, *owner));
            line!(out, "\\textbf{{{heading}:}} {}\n", values.collect::<Vec<_>>().join(", "));
        }
    }
    figures(&mut out, task);
    line!(out, "\\subsection*{{{}}}", escape::latex(texts.solution.steps));
    section(&mut out, task, &solution.steps);
    line!(out, "\\subsection*{{{}}}", escape::latex(texts.solution.result));
    match solution.result {
        Some((color, event)) => {
            let marker = digits::marker_in(task.language, &task.log.events[event]);
            // The sentence is the language's own and has nothing that TeX reads.
            let color = format!("${}$", math::value(task, &Value::Triple(color)));
            line!(out, "{}{}\n", (texts.solution.conclusion)(&color), escape::latex(&marker));
        }
        None => line!(out, "{}\n", escape::latex(texts.solution.no_result)),
    }
    shares(&mut out, task);
    line!(out, "\\end{{document}}");
    out
}

fn figures(out: &mut String, task: &Task) {
    let texts = &task.language.texts().figure;
    let figures = Figures::of(task);
    line!(out, "\\subsection*{{{}}}", escape::latex(texts.ray_tree));
    for note in &figures.notes {
        line!(out, "{}\n", escape::latex(&note.replace('`', "")));
    }
    if let Some(tree) = figures.tree(task) {
        line!(out, "\\begin{{lrbox}}{{\\drawing}}\n{}\\end{{lrbox}}\\drawn", ray_tree::tikz(&tree));
        line!(out, "\\begin{{center}}\\small {}\\end{{center}}\n", escape::latex(texts.width));
    }
    if let Some(plan) = &figures.plan {
        line!(out, "\\subsection*{{{}}}", escape::latex(&caption(task, plan)));
        line!(out, "\\begin{{lrbox}}{{\\drawing}}\n{}\\end{{lrbox}}\\drawn", schematic::tikz(plan));
    }
}

fn section(out: &mut String, task: &Task, section: &Section) {
    let title = escape::latex(&section.title);
    match section.kind {
        // A pixel of one sample is said in the title.
        Kind::Ray if section.is_wrapper() => {}
        Kind::Ray => line!(out, "\\subsubsection*{{{title}}}"),
        Kind::Step(number) => line!(out, "\\step{{{number}}}{{{title}}}"),
        Kind::Part => line!(out, "\\parttitle{{{title}}}"),
    }
    // Steps after another ray's say that they are this ray's again.
    let mut is_away = false;
    for item in &section.items {
        match item {
            Item::Section(inside) => {
                if is_away && inside.kind != Kind::Ray {
                    let title = (task.language.texts().solution.back)(&lowered(&section.title));
                    line!(out, "\\subsubsection*{{{}}}", escape::latex(&title));
                }
                is_away = inside.kind == Kind::Ray && section.kind == Kind::Ray;
                self::section(out, task, inside);
            }
            Item::Given(values) => {
                let values =
                    values.iter().map(|(name, value, _)| format!("${}$", math::assignment(task, name.symbol(), value)));
                // No empty line: a formula that follows would begin a paragraph of its own.
                line!(out, "\\par {} {}:", task.language.texts().solution.with, values.collect::<Vec<_>>().join(", "));
            }
            Item::Equations(events) => {
                let lines = math::aligned(task, events, fitted).join(" \\\\\n");
                line!(out, "\\begin{{align*}}\n{lines}\n\\end{{align*}}");
            }
            Item::Decision(event) => {
                let decision = decision(task, *event).unwrap_or_default();
                let numbers = math::compared(task, *event);
                line!(out, "\\par $\\rightarrow$ {}{numbers}", escape::latex(&decision));
            }
        }
    }
}

/// A formula made narrow enough for the page.
fn fitted(formula: String) -> String {
    format!("\\fitted{{{formula}}}")
}

fn shares(out: &mut String, task: &Task) {
    let texts = &task.language.texts().solution;
    let shares = Shares::of(task);
    let cells = |cells: &[String]| cells.join(" & ");
    line!(out, "\\subsection*{{{}}}", escape::latex(texts.contributions));
    line!(out, "{{\\scriptsize\\setlength{{\\tabcolsep}}{{3pt}}\\renewcommand{{\\arraystretch}}{{1.25}}");
    line!(out, "\\begin{{longtable}}{{P{{2cm}}P{{2.5cm}}P{{1.8cm}}P{{3.4cm}}P{{1.6cm}}P{{3.4cm}}r}}");
    line!(out, "{} \\\\ \\hline \\endhead", cells(&texts.columns.map(escape::latex)));
    for (number, row) in shares.rows.iter().enumerate() {
        let rule = if number + 1 == shares.rows.len() { "\\hline " } else { "" };
        line!(out, "{rule}{} \\\\", cells(&row.each_ref().map(|cell| escape::latex(cell))));
    }
    line!(out, "\\end{{longtable}}}}");
    if shares.ended.is_empty() {
        return;
    }
    line!(out, "{}:", escape::latex(texts.brings_nothing));
    line!(out, "\\begin{{itemize}}\\setlength{{\\itemsep}}{{0pt}}");
    for (path, why) in &shares.ended {
        line!(out, "\\item {}: {}", escape::latex(path), escape::latex(why));
    }
    if shares.more > 0 {
        line!(out, "\\item {}", escape::latex(&(texts.more)(shares.more)));
    }
    line!(out, "\\end{{itemize}}");
}
