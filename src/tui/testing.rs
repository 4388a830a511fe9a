//! Logs to test the viewer with, and a way to type at it.

use super::keys;
use super::{Action, Effect, Model, update};
use crate::log::{Event, Events, Header, Log, Name, Step, Subject, Value, What};
use crate::record::{self, Arithmetic};
use crate::scene::{Scene, build, builtin, file};
use std::collections::BTreeMap;

/// The numeric example of the source text.
pub(super) fn textbook() -> Log {
    let text = builtin::text("textbook").unwrap_or_default();
    record::pixel(&scene(text), [160, 120], Arithmetic::Decimal(3))
}

/// A built-in scene's middle pixel in this arithmetic.
pub(super) fn log_of(name: &str, arithmetic: Arithmetic) -> Log {
    let scene = scene(builtin::text(name).unwrap_or_default());
    let [width, height] = scene.camera.resolution;
    record::pixel(&scene, [width / 2, height / 2], arithmetic)
}

/// A glass ball before a mirror, with a lamp in front and one that the ball hides; it goes eight levels deep.
pub(super) fn glass() -> Log {
    let text = r#"{
      "format": "raywalk-scene/1", "name": "glass",
      "camera": {"position": [0, 0, 10], "direction": [0, 0, -1], "resolution": [3, 3], "vertical_fov": 20},
      "background": [0.1, 0.2, 0.3],
      "lights": [{"name": "lamp", "point": {"position": [5, 5, 10]}},
                 {"name": "behind the wall", "point": {"position": [0, 0, -20]}, "attenuation": [1, 0.1, 0]}],
      "materials": {
        "glass": {"ior": 1.5, "diffuse": [0.1, 0.1, 0.1], "transmission": [0.5, 0.5, 0.5], "transmission_exponent": 5,
                  "weights": {"local": 1, "reflected": 0.2, "transmitted": 0.8}},
        "mirror": {"diffuse": [0.5, 0.5, 0.5], "weights": {"local": 0.5, "reflected": 0.5}}},
      "objects": [{"name": "ball", "shape": {"sphere": {"center": [0.2, 0.1, 0], "radius": 2}}, "material": "glass"},
                  {"name": "wall", "shape": {"plane": {"coefficients": [0, 0, 1, 5]}}, "material": "mirror"}],
      "tracing": {"max_depth": 8}}"#;
    record::pixel(&scene(text), [1, 1], Arithmetic::F64)
}

/// A wall with a lamp on its other side.
pub(super) fn lit_from_behind() -> Log {
    let text = r#"{
      "format": "raywalk-scene/1", "name": "behind", "camera": {"position": [0, 0, 5], "direction": [0, 0, -1]},
      "lights": [{"name": "lamp", "point": {"position": [0, 1, -5]}}],
      "objects": [{"name": "wall", "shape": {"plane": {"coefficients": [0, 0, 1, 0]}}}]}"#;
    record::pixel(&scene(text), [160, 120], Arithmetic::F64)
}

/// A mirror that shows a lamp, with all directions in the plane x = 0.
pub(super) fn reflecting() -> Log {
    let text = r#"{
      "format": "raywalk-scene/1", "name": "reflecting", "camera": {"position": [0, 3, 4], "look_at": [0, 0, 0], "resolution": [1, 1]},
      "lights": [{"name": "lamp", "point": {"position": [0, -2, 2]}}],
      "materials": {"mirror": {"specular": [0.5, 0.5, 0.5], "weights": {"local": 0.5, "reflected": 0.5}}},
      "objects": [{"name": "wall", "shape": {"plane": {"coefficients": [0, 0, 1, 0]}}, "material": "mirror"}]}"#;
    record::pixel(&scene(text), [0, 0], Arithmetic::F64)
}

/// A ray that hits a disk and a polygon behind it, which name more quantities after the distance.
pub(super) fn flat() -> Log {
    let text = r#"{
      "format": "raywalk-scene/1", "name": "flat", "camera": {"position": [0, 0, 5], "direction": [0, 0, -1]},
      "objects": [{"name": "disk", "shape": {"disk": {"center": [0.25, 0, 1], "normal": [0, 0, 1], "radius": 1}}},
                  {"name": "square", "shape": {"polygon": {"vertices": [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]}}}]}"#;
    record::pixel(&scene(text), [160, 120], Arithmetic::F64)
}

/// A ray that hits nothing, in a scene without objects.
pub(super) fn empty() -> Log {
    let text = r#"{"format": "raywalk-scene/1", "name": "empty", "objects": [],
      "camera": {"position": [0, 0, 5], "direction": [0, 0, -1]}}"#;
    record::pixel(&scene(text), [160, 120], Arithmetic::F64)
}

/// A scene from the text of its file.
fn scene(text: &str) -> Scene {
    let loaded = file::check(text.as_bytes(), "test").unwrap_or_else(|error| panic!("{}", error.report(false)));
    build(&loaded.scene, &Default::default()).unwrap_or_else(|unsupported| panic!("{unsupported}"))
}

/// A log in which `(` enters a node, `)` leaves it, and `.` notes a value.
pub(super) fn nested(shape: &str) -> Log {
    let mut open = vec![0];
    let mut nodes = 0;
    let mut events = Events::new();
    for (at, character) in (1..).zip(shape.chars()) {
        let parent = open.last().copied().unwrap_or(0);
        let what = match character {
            '(' => {
                nodes += 1;
                open.push(nodes);
                What::Enter { parent, step: Step::Sample { number: nodes } }
            }
            ')' => What::Leave,
            _ => What::Note { name: Name::PlaneVd, value: Value::Number(f64::from(at)) },
        };
        let node = open.last().copied().unwrap_or(0);
        if what == What::Leave {
            open.pop();
        }
        events.add(|given| Event { at, node, what, given, digits: None });
    }
    Log { header: header(), events }
}

fn header() -> Header {
    let mut header =
        record::header(&scene(builtin::text("textbook").unwrap_or_default()), Subject::Pixel([3, 4]), Arithmetic::F64);
    header.sampling = BTreeMap::new();
    header
}

/// Types keys (see [`keys::script`]); gives what the last one asks for.
pub(super) fn typed(model: &mut Model, text: &str) -> Effect {
    let mut effect = Effect::None;
    for key in keys::sequence(text) {
        if let Some(action) = keys::meant(model, key) {
            effect = update(model, action);
        }
    }
    effect
}

/// A model in a terminal of this size.
pub(super) fn sized(log: Log, width: u16, height: u16) -> Model {
    let mut model = Model::new(log);
    update(&mut model, Action::Resize(width, height));
    model
}
