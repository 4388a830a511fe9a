//! Scenes: read, printed, read again, and a pixel of them traced.

use super::is_a_message;
use raywalk::files::Source;
use raywalk::log::file::{Ending, read, to_ndjson};
use raywalk::log::{Event, Input, Log, Subject, Value, What};
use raywalk::record::{self, Arithmetic, region};
use raywalk::scene::file::mesh::{self, Folder};
use raywalk::scene::file::nff::Import;
use raywalk::scene::file::schema::{LightSamples, Sampling, SceneFile};
use raywalk::scene::file::{self, Loaded};
use raywalk::scene::{Scene, build};

/// A scene in JSON.
pub fn scene(bytes: &[u8]) {
    checked(bytes, "a.json");
}

/// A scene in NFF, which `scene convert` prints as JSON.
pub fn nff(bytes: &[u8]) {
    checked(bytes, "a.nff");
}

fn checked(bytes: &[u8], name: &str) {
    let Loaded { scene, warnings, .. } = match file::check_as(bytes, name, &Import::default()) {
        Ok(loaded) => loaded,
        Err(error) => return is_a_message(&error),
    };
    assert!(warnings.iter().all(|warning| warning.file == name));
    is_printed_as_it_is(&scene);
    traced(scene);
}

/// What is accepted is printed as a text that is accepted and says the same.
fn is_printed_as_it_is(scene: &SceneFile) {
    let text = scene.to_json();
    let again = file::check(text.as_bytes(), "printed.json");
    let again = again.unwrap_or_else(|error| panic!("{}\n{text}", error.report(false)));
    assert_eq!(&again.scene, scene, "{text}");
    assert_eq!(again.scene.to_json(), text);
}

/// The most objects of a scene that is traced, and the most lights: a fuzzer should try many scenes, not one for long.
const MOST: [usize; 2] = [64, 8];

/// Traces the pixel in the middle of a scene that takes little time: all that is logged are numbers.
fn traced(mut file: SceneFile) {
    if file.objects.len() > MOST[0] || file.lights.len() > MOST[1] {
        return;
    }
    file.tracing.max_depth = file.tracing.max_depth.min(4);
    file.sampling = Sampling::Center {};
    for samples in file.lights.iter_mut().filter_map(|light| light.samples.as_mut()) {
        *samples = match *samples {
            LightSamples::Count(count) => LightSamples::Count(count.min(4)),
            LightSamples::Range { min, max } => LightSamples::Range { min: min.min(4), max: max.min(4) },
        };
    }
    let text = file.to_json();
    let source = Source { name: "a.json", text: text.as_bytes() };
    let Ok((meshes, _)) = mesh::load(&file, &source, Folder::BuiltIn(square)) else { return };
    let Ok(scene) = build(&file, &meshes) else { return };
    for arithmetic in [Arithmetic::F64, Arithmetic::F32, Arithmetic::Decimal(3)] {
        logged(&scene, arithmetic);
    }
}

/// What every mesh of a scene is here.
fn square(_: &str) -> Option<&'static [u8]> {
    Some(b"v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvn 0 0 1\nf 1//1 2//1 3//1 4//1\n")
}

fn logged(scene: &Scene, arithmetic: Arithmetic) {
    /// The longest log, for the same reason.
    const EVENTS: usize = 4096;
    let pixel = scene.camera.resolution.map(|side| side / 2);
    let Ok(events) = region::of_pixel(scene, pixel, arithmetic, EVENTS) else { return };
    assert!(!events.is_empty());
    events.with_given().for_each(|(event, given)| is_of_numbers(event, given, arithmetic));
    let log = Log { header: record::header(scene, Subject::Pixel(pixel), arithmetic), events };
    let written = to_ndjson(&log).expect("there is memory");
    let again = read(&written).expect("what was written can be read");
    assert_eq!(again.ending, Ending::Complete);
    assert_eq!(again.log, log);
}

fn is_of_numbers(event: &Event, given: &[Input], arithmetic: Arithmetic) {
    let is_finite = |value: &Value| match value {
        Value::Number(x) => x.is_finite(),
        Value::Triple(xyz) => xyz.iter().all(|x| x.is_finite()),
    };
    let value = match event.what {
        What::Note { value, .. } => Some(value),
        What::Result { color } => Some(Value::Triple(color)),
        _ => None,
    };
    let all = value.iter().chain(given.iter().map(|(_, value)| value)).all(is_finite);
    assert!(all, "{arithmetic}: {event:?}");
}
