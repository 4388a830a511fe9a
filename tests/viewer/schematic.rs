//! The frames of the schematic, of the vectors at a hit, and of rays over the picture, at three sizes in both languages.

use crate::frames::usual;
use crate::support::{scene, snapshots};
use raywalk::log::{Log, Subject};
use raywalk::record::{self, Arithmetic};
use raywalk::report::language::Language;
use raywalk::tui::{self, Dot, Drawing, Image, Live, Palette, Refusal, Theme, Wanted, Wireframe, dump::dump};
use std::sync::Arc;

/// The numeric example with a picture of one colour.
struct Example;

impl Live for Example {
    fn trace(&mut self, _: [u32; 2]) -> Result<Log, Refusal> {
        Ok(by_hand())
    }

    fn picture(&mut self, _: Wanted) -> Option<Arc<Image>> {
        let mut image = Image::empty([320, 240], Arc::new(|color, _| color.map(|part| part as u8)));
        let color = [30.0, 40.0, 50.0];
        image.dots.fill(Some(Dot {
            color,
            depth: Some(1.0),
            rays: 3,
            samples: 1,
            error: Some(0.0),
            is_rough: false,
            named: None,
        }));
        Some(Arc::new(image))
    }

    fn drawing(&mut self) -> Option<Arc<Drawing>> {
        let scene = scene("textbook");
        let around = |turn: f64| [17.0 + 3.0 * libm::cos(turn), 9.0 + 3.0 * libm::sin(turn), 8.0];
        let sphere = (0..=24).map(|step| around(f64::from(step) / 24.0 * std::f64::consts::TAU)).collect();
        Some(Arc::new(Drawing {
            objects: vec![Wireframe { name: "sphere".to_owned(), lines: vec![sphere] }],
            lights: vec![Wireframe { name: "F".to_owned(), lines: vec![vec![[9.0, 12.0, 16.0]]] }],
            eye: [16.0, 2.0, 7.0],
            place_of: Arc::new(move |point| scene.camera.place_of(point.into())),
            size: [320, 240],
        }))
    }

    fn compare(&mut self, _: Subject) -> Result<Vec<Log>, Refusal> {
        Err(Refusal::NoScene)
    }
}

fn by_hand() -> Log {
    record::pixel(&scene("textbook"), [160, 120], Arithmetic::Decimal(3))
}

#[test]
fn frames_of_rays_and_vectors() {
    const VIEWS: [(&str, &str); 3] = [
        ("schematic", "j :schematic Space branch Enter zo"),
        ("vectors", "j :schematic Space vectors Enter zo"),
        ("rays_over", "j Shift-Tab zo :shadows Enter A"),
    ];
    snapshots().bind(|| {
        for (name, keys) in VIEWS {
            for (size, width, height) in [("40x12", 40, 12), ("80x24", 80, 24), ("120x40", 120, 40)] {
                for (language, code) in [(Language::English, ""), (Language::Spanish, "_es")] {
                    let options = usual(Theme::new(Palette::Indexed, false), language);
                    let mut example = Example;
                    let live = Some(&mut example as &mut dyn Live);
                    let model = tui::opened_with_keys(by_hand(), &options, live, keys, (width, height));
                    let frame = dump(&tui::frame(&model, width, height, &options.theme));
                    insta::assert_snapshot!(format!("viewer_{name}{code}_{size}"), frame);
                }
            }
        }
    });
}
