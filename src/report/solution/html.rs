//! A worked solution as one page by itself. Its parts fold and its values lead to the step that computed them without any script;
//! with one, all parts open and close at once, and a value shows where else it occurs.

mod formula;

use super::figures::caption;
use super::format::{self, Around, Format};
use super::{Item, Kind, Section, Task, decision};
use crate::log::Decision;
use crate::report::escape;
use crate::report::ray_tree::{self, Figure};
use crate::report::schematic::{self, Plan};
use formula::Formulas;

const STYLE: &str = include_str!("html/style.css");

/// The worked solution of a log.
pub fn html(task: &Task) -> String {
    format::page::<Html>(task)
}

struct Html;

impl Format for Html {
    type Formulas = Formulas;
    const IS_NESTED: bool = true;
    const HEADING: Around = ["<h2>", "</h2>\n"];
    const PARAGRAPH: Around = ["<p>", "</p>\n"];
    const RESULT: Around = ["<p class=\"result\">", "</p>\n"];
    const DATA: Around = ["<dl>\n", "</dl>\n"];
    const GROUP: [&str; 3] = ["<dt>", "</dt>\n<dd>", "</dd>\n"];
    const GIVEN: Around = ["<p class=\"given\">", "</p>\n"];
    const ASSIGNMENT: Around = ["<span class=\"eq\">", "</span>"];
    const COMMA: &str = " ";
    const DECISION: Around = ["<p class=\"decision\">→ ", "</p>\n"];
    const BACK: Around = ["", ""];
    const CLOSE: &str = "</details>\n";
    const LIST: [&str; 3] = ["<details><summary>", "</summary>\n<ul>\n", "</ul></details>\n"];
    const ITEM: Around = ["<li>", "</li>\n"];
    const END: &str = concat!("\n</main>\n<script>\n", include_str!("html/script.js"), "</script>\n</body>\n</html>\n");

    fn escaped(text: &str) -> String {
        escape::xml(text)
    }

    fn begin(task: &Task, title: &str) -> String {
        let language = task.language.code();
        format!(
            "<!DOCTYPE html>\n<html lang=\"{language}\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; \
             script-src 'unsafe-inline'\">\n\
             <title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n<main>\n<h1>{title}</h1>\n"
        )
    }

    fn ray_tree(_task: &Task, figure: &Figure) -> String {
        format!("<figure>\n{}</figure>\n", ray_tree::svg_of(figure))
    }

    fn schematic(task: &Task, plan: &Plan) -> String {
        let (heading, caption) = (escape::xml(task.language.texts().figure.schematic), caption(task, plan));
        let svg = schematic::svg_of(plan, &caption);
        let caption = escape::xml(&caption);
        format!("<h2>{heading}</h2>\n<figure>\n{svg}\n<figcaption>{caption}</figcaption></figure>\n")
    }

    fn around_steps(task: &Task) -> [String; 2] {
        let texts = &task.language.texts().solution;
        let (open, close) = (escape::xml(texts.open_all), escape::xml(texts.close_all));
        [format!("<div id=\"steps\" data-open=\"{open}\" data-close=\"{close}\">\n"), "</div>\n".to_owned()]
    }

    fn open(task: &Task, section: &Section, title: &str) -> String {
        let (class, number) = match section.kind {
            Kind::Ray => ("ray", String::new()),
            Kind::Step(number) => ("step", format!("{number}) ")),
            Kind::Part => ("part", String::new()),
        };
        // What is missed is told in its title, and opened by who wants to know.
        let miss = miss(task, section).map(|miss| format!(" <span class=\"miss\">— {}</span>", escape::xml(&miss)));
        let (open, miss) = miss.map_or((" open", String::new()), |miss| ("", miss));
        format!("<details class=\"{class}\"{open}><summary>{number}{title}{miss}</summary>\n")
    }

    fn equations(task: &Task, events: &[usize]) -> String {
        let equations = events.iter().filter_map(|event| formula::equation(task, *event));
        equations.map(|equation| equation + "\n").collect()
    }

    fn table(columns: &[String; 7], rows: &[[String; 7]]) -> String {
        let row = |cells: &[String; 7], tag: &str| {
            let cells = cells.each_ref().map(|cell| format!("<{tag}>{cell}</{tag}>"));
            format!("<tr>{}</tr>\n", cells.concat())
        };
        let rows: String = rows.iter().map(|cells| row(cells, "td")).collect();
        format!("<div class=\"wide\"><table>\n{}{rows}</table></div>\n", row(columns, "th"))
    }
}

/// Why the ray misses the object that a section tests; nothing if it doesn't.
fn miss(task: &Task, section: &Section) -> Option<String> {
    section.items.iter().find_map(|item| match item {
        Item::Decision(event) => match task.log.events[*event].decision() {
            Some(Decision::Miss { .. }) => decision(task, *event),
            _ => None,
        },
        _ => None,
    })
}
