//! `:picture`: the picture of a quantity, of a light, of a class of paths.

use super::effect::Effect;
use super::model::picture::Layer;
use super::model::{Model, Pane, quantity};
use super::watch;
use crate::files::escape::is_hidden;
use crate::log::plane::{PathPattern, PathStep, Plane, PlaneError, ValueAt, ValueError, class_word};
use crate::log::{Name, RayKind, Step};
use crate::report::words::plain;
use std::collections::BTreeSet;

/// The command.
pub(super) const PICTURE: &str = "picture";

/// Shows what is named, without a name the colours again.
pub(super) fn run(model: &mut Model, text: &str) -> Result<Effect, String> {
    if model.picture.is_none() {
        return Err(model.texts().messages.no_scene.to_owned());
    }
    let usual = Some(Layer::Colors).filter(|_| text.is_empty());
    let known = Layer::WORDS.iter().find(|(word, _)| *word == text).map(|(_, layer)| *layer);
    if let Some(layer) = usual.or(known) {
        show(model, layer);
        return Ok(Effect::None);
    }
    if let Some(why) = model.hides_outcome() {
        return Err(why.to_owned());
    }
    let is_kind = |kind: &str| text.strip_prefix(kind).is_some_and(|rest| rest.starts_with(':'));
    let plane = match Plane::KINDS.into_iter().any(is_kind) {
        true => text.parse::<Plane>(),
        false => {
            let text = with_key(model, text)?;
            ValueAt::read(&text, || path_here(model)).map(Plane::Value).map_err(PlaneError::Value)
        }
    };
    plane.map(Effect::Picture).map_err(|error| refused(model, &error))
}

/// The text with the key of the quantity that it names by its symbol, such as `N·L@C R`.
fn with_key(model: &Model, text: &str) -> Result<String, String> {
    let (called, path) = text.split_at(text.find('@').unwrap_or(text.len()));
    // A key that isn't known is answered with what `render --layers` says.
    let is_symbol =
        quantity::named(called).is_some_and(|(names, _)| names.iter().all(|name| !called.contains(name.key())));
    if is_symbol { Ok(watch::named(model, called)?.key() + path) } else { Ok(text.to_owned()) }
}

/// What was asked for is being rendered.
pub(super) fn is_shown(model: &mut Model) {
    show(model, Layer::Named);
    if let Some(view) = &mut model.picture {
        view.is_finished = false;
    }
}

/// Shows the colours again where a quiz begins, or a tree to grow: the range of values would tell some of them.
pub(super) fn hide(model: &mut Model) {
    let hides = model.hides_outcome().is_some();
    if let Some(view) = model.picture.as_mut().filter(|view| hides && view.layer == Layer::Named) {
        view.layer = Layer::Colors;
    }
}

fn show(model: &mut Model, layer: Layer) {
    if let Some(view) = &mut model.picture {
        view.layer = layer;
        model.focus_on(Pane::Picture);
    }
}

fn refused(model: &Model, error: &PlaneError) -> String {
    let texts = &model.texts().commands;
    match error {
        PlaneError::Kind | PlaneError::NoLight => texts.expected_light.to_owned(),
        PlaneError::Value(ValueError::Key(key, near)) => (texts.no_quantity)(&plain(key), near.unwrap_or_default()),
        PlaneError::Value(ValueError::Component(key)) => (texts.no_components)(key),
        PlaneError::Value(ValueError::Path(path)) => (texts.no_ray_path)(&plain(&path.0)),
        PlaneError::Class(class) => (texts.no_class)(&plain(&class.0)),
    }
}

/// The path of the selected node, for all samples; the camera's ray outside every ray.
fn path_here(model: &Model) -> PathPattern {
    let mut path: PathPattern = model.tree.path(model.cursor).parse().unwrap_or_default();
    if path.steps.is_empty() {
        return PathPattern::of_camera();
    }
    // What is said of a light has the path of the ray to it.
    let is_place = |step: &Step| matches!(step, Step::Light { .. } | Step::Ray { .. });
    let mut around = model.tree.around(model.cursor).filter_map(|node| model.tree.nodes()[node].step);
    if let Some(Step::Light { light, split }) = around.find(is_place) {
        path.steps.push(PathStep { kind: RayKind::Shadow { light }, split });
    }
    path.of_all()
}

/// How the line may go on.
pub(super) fn completions(model: &Model, line: &str) -> Vec<String> {
    let typed = line.strip_prefix(PICTURE).unwrap_or_default().trim_start();
    let ways: Vec<String> = match typed.split_once('@') {
        Some((key, _)) => paths(model).into_iter().map(|path| format!("{key}@{path}")).collect(),
        None if typed.starts_with("light:") => {
            let lights = model.log.header.lights.iter().map(String::as_str);
            let all = lights.chain([Plane::AMBIENT, Plane::BACKGROUND]).filter(|name| !name.chars().any(is_hidden));
            all.map(|name| format!("light:{name}")).collect()
        }
        None if typed.starts_with("class:") => {
            let words = (0..=3).flat_map(|bounces| ["LD", "LS", "A", "B"].map(|start| class_word(start, bounces)));
            words.map(|word| format!("class:{word}")).collect()
        }
        // What is complete goes on with a path.
        None if Name::with_key(typed).is_some() => paths(model).iter().map(|path| format!("{typed}@{path}")).collect(),
        None => {
            let keys: BTreeSet<&str> = Name::all().map(Name::key).collect();
            let words = Layer::WORDS.iter().map(|(word, _)| *word).chain(["light:", "class:"]);
            words.chain(keys).map(str::to_owned).collect()
        }
    };
    ways.into_iter().filter(|way| way.starts_with(typed)).map(|way| format!("{PICTURE} {way}")).collect()
}

/// The paths of the selected ray, of the rays before it, and of the rays and lights behind it.
fn paths(model: &Model) -> Vec<String> {
    const MOST: usize = 1000;
    let tree = &model.tree;
    let is_ray = |node: &usize| tree.ray(*node).is_some();
    let here = tree.around(model.cursor).find(|node| tree.ray(*node).is_some_and(|kind| kind.light().is_none()));
    let here = here.or_else(|| (0..tree.nodes().len()).take(MOST).find(is_ray));
    let Some(here) = here else { return vec![PathPattern::of_camera().to_string()] };
    let path = |node: usize| tree.path(node).parse::<PathPattern>().ok().map(PathPattern::of_all);
    let before = tree.around(here).filter(is_ray).filter_map(path);
    let end = tree.nodes()[here].events.end;
    let inside = (here + 1..tree.nodes().len()).take(MOST).take_while(|node| tree.nodes()[*node].events.start < end);
    let behind = inside.filter(is_ray).filter_map(path);
    let all: BTreeSet<String> = before.chain(behind).map(|path| path.to_string()).collect();
    all.into_iter().collect()
}
