//! A log in the formats of `raywalk trace`.

use super::live::drawing;
use super::trace::TraceFormat;
use clap::ValueEnum;
use raywalk::log::{Log, Tree, file as log_file};
use raywalk::report::language::Language;
use raywalk::report::ray_tree::{self, Figure};
use raywalk::report::solution::{self, Task};
use raywalk::report::{Style, obj, text};
use raywalk::scene::Scene;
use std::io;

/// The languages of views for people.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Lang {
    /// English.
    En,
    /// Spanish, with decimal commas and the terms of the source text.
    Es,
}

impl From<Lang> for Language {
    fn from(lang: Lang) -> Language {
        match lang {
            Lang::En => Language::English,
            Lang::Es => Language::Spanish,
        }
    }
}

/// The bytes of a log in a format.
pub fn view(scene: &Scene, log: &Log, format: TraceFormat, language: Language, style: Style) -> io::Result<Vec<u8>> {
    let text = match format {
        TraceFormat::Ndjson => return log_file::to_ndjson(log),
        TraceFormat::Json => return log_file::to_json(log),
        TraceFormat::Text => text::text(log, style),
        TraceFormat::Obj => obj::obj(log),
        TraceFormat::Markdown => of_solution(scene, log, language, style, solution::markdown),
        TraceFormat::Latex => of_solution(scene, log, language, style, solution::latex),
        TraceFormat::Html => of_solution(scene, log, language, style, solution::html),
        TraceFormat::Dot => of_tree(log, language, style, ray_tree::dot),
        TraceFormat::Svg => of_tree(log, language, style, ray_tree::svg),
        TraceFormat::Mermaid => of_tree(log, language, style, ray_tree::mermaid),
    };
    Ok(text.into_bytes())
}

fn of_solution(
    scene: &Scene,
    log: &Log,
    language: Language,
    style: Style,
    write: impl FnOnce(&Task) -> String,
) -> String {
    let (tree, things) = (Tree::of(&log.events), drawing::objects(scene));
    write(&Task { log, tree: &tree, things: &things, language, style })
}

fn of_tree(log: &Log, language: Language, style: Style, write: impl FnOnce(&Figure) -> String) -> String {
    let branches = ray_tree::branches(log, &Tree::of(&log.events), 0);
    write(&Figure { log, branches: &branches, language, style })
}
