//! A log in the formats of `raywalk trace`.

use super::live::drawing;
use clap::ValueEnum;
use raywalk::files::unpacked_name;
use raywalk::log::{Header, Log, Tree, file as log_file};
use raywalk::report::language::Language;
use raywalk::report::ray_tree::{self, Figure};
use raywalk::report::schematic::Stage;
use raywalk::report::segments::Segment;
use raywalk::report::solution::{self, Task};
use raywalk::report::{Style, lines, text};
use raywalk::scene::Scene;
use std::io;
use std::path::Path;

/// The languages of views for people.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Lang {
    /// English.
    #[default]
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

/// What a tree is of.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum TreeOf {
    /// Rays, with what they hit.
    Rays,
    /// Calls of the algorithm.
    Calls,
}

/// What a log is written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum TraceFormat {
    /// One event per line.
    Ndjson,
    /// One document.
    Json,
    /// The walk as text.
    Text,
    /// A worked solution: numbered steps, formulas in TeX's notation, figures as Mermaid and text.
    Markdown,
    /// A worked solution for pdflatex.
    Latex,
    /// A worked solution as one page by itself, its steps to be folded, its values linked.
    Html,
    /// The ray tree for Graphviz.
    Dot,
    /// The ray tree as a picture.
    Svg,
    /// The ray tree for Mermaid.
    Mermaid,
    /// The rays as lines in space, for 3D viewers (Wavefront OBJ).
    Obj,
    /// The same in the colours of their kinds (Polygon File Format).
    Ply,
}

impl TraceFormat {
    /// Its name.
    pub fn word(self) -> String {
        self.to_possible_value().map_or(String::new(), |value| value.get_name().to_owned())
    }

    /// Whether logs of regions are written so.
    pub fn is_of_regions(self) -> bool {
        matches!(self, TraceFormat::Ndjson | TraceFormat::Json | TraceFormat::Text) || self.lines().is_some()
    }

    /// How rays are written as lines in space, if this is a format for them.
    pub fn lines(self) -> Option<fn(&Header, &[Segment]) -> String> {
        match self {
            TraceFormat::Obj => Some(lines::obj),
            TraceFormat::Ply => Some(lines::ply),
            _ => None,
        }
    }
}

impl TraceFormat {
    /// The endings of names that stand for a format.
    pub const ENDINGS: [&'static str; 11] =
        [".html", ".md", ".tex", ".txt", ".ndjson", ".json", ".svg", ".dot", ".mmd", ".obj", ".ply"];
    const FORMATS: [TraceFormat; 11] = [
        TraceFormat::Html,
        TraceFormat::Markdown,
        TraceFormat::Latex,
        TraceFormat::Text,
        TraceFormat::Ndjson,
        TraceFormat::Json,
        TraceFormat::Svg,
        TraceFormat::Dot,
        TraceFormat::Mermaid,
        TraceFormat::Obj,
        TraceFormat::Ply,
    ];
    /// Those of formats for regions.
    pub const ENDINGS_OF_REGIONS: [&'static str; 5] = [".txt", ".ndjson", ".json", ".obj", ".ply"];

    /// The format that the ending of a file's name stands for, before the ending of what packs it.
    pub fn of_ending(path: &Path) -> Option<TraceFormat> {
        let name = path.file_name()?.to_str()?.to_ascii_lowercase();
        let name = unpacked_name(&name);
        let ending = TraceFormat::ENDINGS.iter().position(|ending| name.ends_with(ending))?;
        Some(TraceFormat::FORMATS[ending])
    }

    /// The view that a file's name stands for, rather than a log.
    pub fn of_view(path: &Path) -> Option<TraceFormat> {
        let is_log = |format: &TraceFormat| {
            matches!(format, TraceFormat::Ndjson | TraceFormat::Json | TraceFormat::Text | TraceFormat::Mermaid)
        };
        TraceFormat::of_ending(path).filter(|format| !is_log(format))
    }
}

/// How a log is to be seen.
pub struct View {
    /// The format.
    pub format: TraceFormat,
    /// What a tree is of.
    pub tree: TreeOf,
    /// The language of text views.
    pub language: Language,
    /// How they show numbers.
    pub style: Style,
}

impl View {
    /// The bytes of a log; of a saved one the scene isn't known, nor therefore what the objects look like.
    pub fn bytes(&self, scene: Option<&Scene>, log: &Log) -> io::Result<Vec<u8>> {
        let text = match self.format {
            TraceFormat::Ndjson => return log_file::to_ndjson(log),
            TraceFormat::Json => return log_file::to_json(log),
            TraceFormat::Text => text::text(self.language, log, self.style),
            TraceFormat::Obj => lines::obj(&log.header, &lines::rays(log)),
            TraceFormat::Ply => lines::ply(&log.header, &lines::rays(log)),
            TraceFormat::Markdown => self.of_solution(scene, log, solution::markdown),
            TraceFormat::Latex => self.of_solution(scene, log, solution::latex),
            TraceFormat::Html => self.of_solution(scene, log, solution::html),
            TraceFormat::Dot => self.of_tree(log, ray_tree::dot),
            TraceFormat::Svg => self.of_tree(log, ray_tree::svg),
            TraceFormat::Mermaid => self.of_tree(log, ray_tree::mermaid),
        };
        Ok(text.into_bytes())
    }

    fn of_solution(&self, scene: Option<&Scene>, log: &Log, write: impl FnOnce(&Task) -> String) -> String {
        let (tree, wireframes) = (Tree::of(&log.events), scene.map(drawing::objects).unwrap_or_default());
        let is_z_up = scene.map(|scene| scene.camera.up().abs()).is_some_and(|up| up.z > up.y);
        let stage = Stage { wireframes: &wireframes, upright: if is_z_up { 2 } else { 1 } };
        write(&Task { log, tree: &tree, stage, language: self.language, style: self.style })
    }

    fn of_tree(&self, log: &Log, write: impl FnOnce(&Figure) -> String) -> String {
        let tree = Tree::of(&log.events);
        let rays = ray_tree::branches(log, &tree, 0);
        let branches = match self.tree {
            TreeOf::Rays => rays,
            TreeOf::Calls => ray_tree::calls(log, &tree, rays),
        };
        write(&Figure { log, branches: &branches, language: self.language, style: self.style })
    }
}
