//! `:picture`: any quantity, any light and any class of paths, over the numeric example.

use crate::frames::usual;
use crate::support::{scene, snapshots};
use raywalk::log::plane::Plane;
use raywalk::log::{Log, Subject, Value};
use raywalk::record::{self, Arithmetic};
use raywalk::render::layers::{NoPlane, Planes};
use raywalk::render::preview;
use raywalk::report::language::Language;
use raywalk::scene::Scene;
use raywalk::tui::{
    self, Dot, Image, Layer, Live, Model, Named, Options, Palette, Refusal, Shows, Theme, Wanted, dump::dump,
};
use std::sync::Arc;

const PIXEL: [u32; 2] = [160, 120];

/// A scene that is traced when the picture is asked for, every eighth pixel of it.
struct Example {
    scene: Scene,
    planes: Planes,
}

impl Example {
    fn new() -> Example {
        Example { scene: scene("textbook"), planes: Planes::default() }
    }
}

impl Live for Example {
    fn trace(&mut self, pixel: [u32; 2]) -> Result<Log, Refusal> {
        Ok(record::pixel(&self.scene, pixel, Arithmetic::F64))
    }

    fn picture(&mut self, _: Wanted) -> Option<Arc<Image>> {
        let mut image = Image::empty([320, 240], Arc::new(|color, _| color.map(|part| part.min(255.0) as u8)));
        image.step = 8;
        image.dots.truncate(40 * 30);
        image.named = self.planes.names().first().map(|plane| {
            let shows = match plane {
                Plane::Value(value) if !value.is_triple() => Shows::Numbers,
                Plane::Value(_) => Shows::Triples,
                _ => Shows::Light,
            };
            let title = plane.to_string();
            Named { title: title.strip_prefix("value:").unwrap_or(&title).to_owned(), shows }
        });
        for (number, place) in image.dots.iter_mut().enumerate() {
            let pixel = [number % 40, number / 40].map(|at| 8 * at as u32);
            let (dot, numbers) = preview::named_dot(&self.scene, pixel, Arithmetic::F64, &self.planes, false);
            let named = match numbers[..] {
                [x] if x.is_finite() => Some(Value::Number(x)),
                [x, y, z] if x.is_finite() => Some(Value::Triple([x, y, z])),
                _ => None,
            };
            let (color, depth, rays, samples) = (dot.color.to_array(), dot.depth, dot.rays, dot.samples);
            *place = Some(Dot { color, depth, rays, samples, error: Some(0.0), named, is_rough: false });
        }
        Some(Arc::new(image))
    }

    fn show(&mut self, plane: &Plane) -> Result<(), Refusal> {
        self.planes = Planes::of(&self.scene, std::slice::from_ref(plane)).map_err(|error| match error {
            NoPlane::Light { name, known } => Refusal::NoLight(name, known),
            NoPlane::Class { class, known } => Refusal::NoClass(class, known),
            NoPlane::TooMany => Refusal::Other(error.to_string()),
        })?;
        Ok(())
    }

    fn compare(&mut self, _: Subject) -> Result<Vec<Log>, Refusal> {
        Err(Refusal::NoScene)
    }
}

fn options(language: Language) -> Options {
    let theme = Theme::new(Palette::Indexed, false);
    usual(theme, language)
}

fn after(keys: &str, size: (u16, u16), language: Language) -> Model {
    let mut example = Example::new();
    let log = record::pixel(&example.scene, PIXEL, Arithmetic::F64);
    tui::opened_with_keys(log, &options(language), Some(&mut example), keys, size)
}

fn frame_after(keys: &str, size: (u16, u16), language: Language) -> String {
    let model = after(keys, size, language);
    dump(&tui::frame(&model, size.0, size.1, &options(language).theme))
}

fn said(keys: &str) -> String {
    after(keys, (100, 30), Language::English).message.map(|message| message.text).unwrap_or_default()
}

#[test]
fn frames_of_pictures_by_name() {
    const NAMES: [(&str, &str); 2] =
        [("number", ":picture shade.n_dot_l@C Enter"), ("triple", ":picture hit.normal@C Enter")];
    snapshots().bind(|| {
        for (name, keys) in NAMES {
            for (language, code) in [(Language::English, "en"), (Language::Spanish, "es")] {
                for (width, height) in [(40, 12), (80, 24), (120, 40)] {
                    let frame = frame_after(keys, (width, height), language);
                    insta::assert_snapshot!(format!("viewer_picture_{name}_{code}_{width}x{height}"), frame);
                }
            }
        }
    });
}

/// The value under the cursor is that of the pixel's log.
#[test]
fn the_value_of_the_pixel_is_shown() {
    let log = record::pixel(&scene("textbook"), PIXEL, Arithmetic::F64);
    let n_dot_l = log.events.iter().filter_map(|event| event.noted()).find(|(name, _)| name.key() == "shade.n_dot_l");
    let Some((_, Value::Number(expected))) = n_dot_l else { panic!("no value") };
    let frame = frame_after(":picture shade.n_dot_l@C Enter", (120, 40), Language::English);
    assert!(frame.contains(&format!("shade.n_dot_l@C {expected:.3}")), "{frame}");
    assert!(frame.contains("shade.n_dot_l@C S1") || !frame.contains("none"), "{frame}");
}

#[test]
fn the_usual_path_is_that_of_the_selected_node() {
    let title = |keys: &str| {
        let model = after(keys, (100, 30), Language::English);
        model.picture.as_ref().map(|view| view.title(model.language).to_owned()).unwrap_or_default()
    };
    assert_eq!(title(":picture shade.n_dot_l Enter"), "shade.n_dot_l@C");
    assert_eq!(title("/C R reflected Enter :picture hit.point.y Enter"), "hit.point.y@C R");
    assert_eq!(title(":picture light:ambient Enter"), "light:ambient");
    assert_eq!(title(":picture class:L(D|S)SE Enter"), "class:L(D|S)SE");
    assert_eq!(title(":picture hit.point Enter :picture Enter"), "picture");
    assert_eq!(title(":picture depth Enter"), "depth");
    // `v` goes on to it.
    assert_eq!(title(":picture hit.point Enter :picture error Enter v"), "hit.point@C");
    assert_eq!(title(":picture error Enter v"), "picture");
}

#[test]
fn what_is_misspelt_is_answered_with_what_there_is() {
    assert!(said(":picture shade.n_dotl Enter").contains("did you mean `shade.n_dot_l`?"));
    assert!(said(":picture light:lampara Enter").contains("there is"));
    assert!(
        said(":picture class:LDDE Enter").contains("no path is of the class LDDE; here there are AE")
            || said(":picture class:LDDE Enter").contains("LDE")
    );
    assert!(said(":picture hit.point@X Enter").contains("`X` is no path"));
    assert!(said(":picture shade.n_dot_l.x Enter").contains("no components"));
    assert!(said(":picture class:q Enter").contains("no class"));
    assert!(said(":picture light: Enter").contains("expected the name of a light"));
}

/// A quiz asks for values, and a tree that grows hasn't come to them: the range of a picture would tell them.
#[test]
fn no_picture_tells_what_is_asked() {
    for keys in [
        "Q :picture Space plane.v_o@C Enter",
        "t :picture Space plane.v_o@C Enter",
        ":picture Space plane.v_o@C Enter Q",
        ":picture Space plane.v_o@C Enter t",
    ] {
        let frame = frame_after(keys, (120, 40), Language::English);
        assert!(!frame.contains("plane.v_o@C -12"), "{keys}: {frame}");
        let model = after(keys, (100, 30), Language::English);
        assert_eq!(model.picture.map(|view| view.layer), Some(Layer::Colors), "{keys}");
    }
    // Everywhere it is -12.
    assert!(frame_after(":picture plane.v_o@C Enter", (120, 40), Language::English).contains("plane.v_o@C -12"));
}

#[test]
fn symbols_are_known() {
    let title = |keys: &str| {
        let model = after(keys, (100, 30), Language::English);
        model.picture.as_ref().map(|view| view.title(model.language).to_owned()).unwrap_or_default()
    };
    assert_eq!(title(":picture N·L Enter"), "shade.n_dot_l@C");
    assert_eq!(title(":picture N·L@C Space R Enter"), "shade.n_dot_l@C R");
}

#[test]
fn tab_completes_keys_lights_and_paths() {
    let line = |keys: &str| {
        let model = after(keys, (100, 30), Language::English);
        model.prompt.map(|prompt| prompt.line.value().to_owned()).unwrap_or_default()
    };
    assert_eq!(line(":picture shade.n_dot_l Tab"), "picture shade.n_dot_l@C");
    assert_eq!(line(":picture light:amb Tab"), "picture light:ambient");
    assert_eq!(line(":picture class:AS Tab"), "picture class:AS");
    assert_eq!(line(":picture mirror.d Tab"), "picture mirror.direction");
    assert!(said(":picture hit.point@ Tab").is_empty());
    assert!(said(":picture hit.point@C Tab").contains("hit.point@C R"), "{}", said(":picture hit.point@C Tab"));
}

#[test]
fn a_saved_log_says_that_it_has_no_scene() {
    let log = record::pixel(&scene("textbook"), PIXEL, Arithmetic::F64);
    let options = options(Language::Spanish);
    let model = tui::opened_with_keys(log, &options, None, ":picture hit.point Enter", (100, 30));
    let said = model.message.map(|message| message.text).unwrap_or_default();
    assert_eq!(said, "un registro guardado no tiene escena que trazar");
    assert!(model.picture.is_none_or(|view| view.layer == Layer::Colors));
}
