//! The schematic, the vectors at a hit, and the rays over the picture, without a terminal.

use super::dump::dump;
use super::testing::{empty, flat, glass, log_of, nested, sized, textbook, typed};
use super::*;
use crate::log::{Log, RayKind};
use crate::record::Arithmetic;
use proptest::prelude::*;
use ratatui::style::Color;
use std::cell::Cell;
use std::sync::Arc;

/// A model that shows the schematic alone.
fn schematic(log: Log, (width, height): (u16, u16)) -> Model {
    let mut model = sized(log, width, height);
    model.focus_on(Pane::Schematic);
    model.is_alone = true;
    model
}

fn shown(model: &Model) -> String {
    let (width, height) = model.size;
    dump(&frame(model, width, height, &Theme::new(Palette::None, false)))
}

/// The paths of the rays that are drawn.
fn drawn(model: &Model) -> Vec<String> {
    model.drawn().rays.iter().map(|ray| model.tree.path(ray.node)).collect()
}

fn is_shadow(model: &Model, node: usize) -> bool {
    matches!(model.tree.ray(node), Some(RayKind::Shadow { .. }))
}

#[test]
fn a_branch_is_the_way_from_the_eye_and_what_hangs_below() {
    for log in [glass(), textbook(), log_of("figure-6", Arithmetic::F64)] {
        let mut model = schematic(log, (80, 24));
        let rays: Vec<usize> = (0..model.tree.nodes().len()).filter(|node| model.tree.ray(*node).is_some()).collect();
        for current in rays.iter().copied() {
            if is_shadow(&model, current) {
                continue;
            }
            model.go_to_node(current);
            let here = format!("{} ", model.tree.path(current));
            let belongs = |node: &usize| {
                let path = format!("{} ", model.tree.path(*node));
                !is_shadow(&model, *node) && (path.starts_with(&here) || here.starts_with(&path))
            };
            let expected: Vec<_> =
                rays.iter().filter(|node| belongs(node)).map(|node| model.tree.path(*node)).collect();
            assert_eq!(drawn(&model), expected, "at {here}");
        }
    }
}

#[test]
fn shadow_rays_are_drawn_when_asked_for_or_selected() {
    let mut model = schematic(textbook(), (80, 24));
    assert_eq!(drawn(&model), ["C", "C R"]);
    typed(&mut model, "X");
    assert_eq!(drawn(&model), ["C", "C S1", "C R", "C R S1"]);
    typed(&mut model, "X");
    let shadow = (0..model.tree.nodes().len()).find(|node| model.tree.path(*node) == "C R S1").expect("a shadow ray");
    model.go_to_node(shadow);
    assert_eq!(drawn(&model), ["C", "C R", "C R S1"]);
    // The light around it is about that ray, too.
    model.go_to_node(model.tree.nodes()[shadow].parent);
    assert_eq!(drawn(&model), ["C", "C R", "C R S1"]);
    typed(&mut model, ":shadows Enter");
    assert_eq!(drawn(&model), ["C", "C R", "C R S1"]);
    typed(&mut model, "Z");
    assert_eq!(drawn(&model), ["C", "C S1", "C R", "C R S1"]);
}

/// P₀ = (16, 2, 7), P₁ = (4, 6, 8), P₂ = (14.139, 9.376, 8.847): from the front the triangle has an area of 40.5, from above of 10.1,
/// from the side of 0.006.
#[test]
fn the_schematic_opens_from_where_the_rays_spread_most_until_somebody_turns_it() {
    let mut model = schematic(textbook(), (80, 24));
    assert_eq!(model.side(), Projection::Front);
    assert!(shown(&model).contains("schematic from the front: this branch"), "{}", shown(&model));
    typed(&mut model, "v");
    // Without a scene there is no eye.
    assert_eq!(model.side(), Projection::Side);
    typed(&mut model, "v");
    assert_eq!(model.side(), Projection::Top);
    typed(&mut model, "9j");
    assert_eq!(model.side(), Projection::Top);
    typed(&mut model, ":schematic Space auto Enter");
    assert_eq!(model.side(), Projection::Front);
}

#[test]
fn commands_say_what_the_schematic_can_show() {
    let mut model = sized(textbook(), 80, 24);
    let said = |model: &mut Model, keys: &str| {
        typed(model, keys);
        let said = model.message.as_ref().map(|message| message.text.clone());
        typed(model, "Esc");
        said.unwrap_or_default()
    };
    assert!(said(&mut model, ":schematic Space vectros Enter").contains("did you mean vectors?"));
    assert!(
        said(&mut model, ":schematic Space zzz Enter").contains("branch, pixel, vectors, top, front, side, eye, auto")
    );
    assert!(said(&mut model, ":schematic Space eye Enter").contains("needs the scene"));
    assert!(said(&mut model, ":rays Enter").contains("no picture"));
    assert_eq!(said(&mut model, ":schematic Space vec Tab Enter"), "");
    assert_eq!((model.schematic.shown, model.focus), (Shown::Vectors, Pane::Schematic));
    assert_eq!(said(&mut model, ":schematic Space side Enter"), "");
    assert_eq!((model.schematic.shown, model.side()), (Shown::Branch, Projection::Side));
    // Elsewhere the keys are for another pane.
    model.focus_on(Pane::Computation);
    typed(&mut model, "Z");
    assert!(model.message.take().is_some_and(|message| message.text.contains("schematic")));
}

#[test]
fn the_vectors_are_those_of_the_selected_node() {
    let mut model = schematic(textbook(), (80, 24));
    typed(&mut model, ":schematic Space vectors Enter g");
    assert!(shown(&model).contains("nothing is hit here"));
    typed(&mut model, "j");
    let text = shown(&model);
    for letter in ["vectors at P₁ (C)", "P₀", "P₁", "P₂", "N", "L", "V", "H", "R", "plane"] {
        assert!(text.contains(letter), "{letter} in\n{text}");
    }
    let reflected = (0..model.tree.nodes().len()).find(|node| model.tree.path(*node) == "C R").expect("a ray");
    model.go_to_node(reflected);
    let text = shown(&model);
    assert!(text.contains("vectors at P₂ (C R)") && text.contains("P₁") && !text.contains("P₃"), "{text}");
    model.size = (40, 12);
    assert!(shown(&model).contains("P₂"));
    model.size = (20, 6);
    assert!(shown(&model).contains("P₂") || shown(&model).contains("too small"), "{}", shown(&model));
    // While the tree grows, only what is computed already.
    model.size = (80, 24);
    typed(&mut model, "0 t j 3n");
    assert!(!shown(&model).contains("P₂"), "{}", shown(&model));
}

/// A picture of one colour before which a camera at z = 10 looks along −z, 8 × 6 pixels.
fn with_picture(log: Log, size: (u16, u16)) -> Model {
    let mut model = sized(log, size.0, size.1);
    let mut image = Image::empty([8, 6], Arc::new(|color, _| color.map(|part| part as u8)));
    let dot = Dot {
        color: [40.0, 60.0, 80.0],
        depth: Some(1.0),
        rays: 3,
        samples: 1,
        error: Some(0.0),
        is_rough: false,
        named: None,
    };
    image.dots.fill(Some(dot));
    model.picture = Some(PictureView::new(Arc::new(image), [4, 3]));
    let place_of = |[x, y, z]: [f64; 3]| (z < 10.0).then(|| [4.0 + 10.0 * x / (10.0 - z), 3.0 - 10.0 * y / (10.0 - z)]);
    let ring = vec![[-2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [2.0, 0.0, 0.0], [0.0, -2.0, 0.0], [-2.0, 0.0, 0.0]];
    let named = |name: &str, lines| Wireframe { name: name.to_owned(), lines };
    model.drawing = Some(Arc::new(Drawing {
        objects: vec![
            named("b\u{1b}[31mll", vec![ring]),
            named("wall", vec![vec![[-9.0, -3.0, -5.0], [9.0, -3.0, -5.0]]]),
        ],
        lights: vec![named("lamp", vec![vec![[5.0, 5.0, 9.0]]])],
        eye: [0.0, 0.0, 10.0],
        place_of: Arc::new(place_of),
        size: [8, 6],
    }));
    model.focus_on(Pane::Picture);
    model
}

#[test]
fn names_are_at_outlines_and_escaped() {
    let mut model = with_picture(textbook(), (100, 30));
    model.focus_on(Pane::Schematic);
    model.is_alone = true;
    for keys in ["j", "v", "v", "v", "Z"] {
        typed(&mut model, keys);
        let text = shown(&model);
        assert!(!text.contains('\u{1b}') && text.contains("b\\u{1b}[31mll"), "{text}");
    }
}

fn braille(model: &Model) -> Vec<([u16; 2], Color, Color)> {
    let (width, height) = model.size;
    let shown = frame(model, width, height, &Theme::new(Palette::True, false));
    let cells = shown.area.positions().filter_map(|place| Some((place, shown.cell(place)?)));
    let is_braille = |symbol: &str| symbol.chars().all(|c| ('\u{2801}'..='\u{28ff}').contains(&c));
    let cells = cells.filter(|(_, cell)| is_braille(cell.symbol()));
    cells.map(|(place, cell)| ([place.x, place.y], cell.fg, cell.bg)).collect()
}

#[test]
fn rays_lie_over_the_picture_and_its_colour_stays_behind() {
    let mut model = with_picture(glass(), (100, 30));
    model.is_alone = true;
    typed(&mut model, "X");
    assert!(model.message.take().is_some(), "there is no schematic on the screen");
    model.schematic.has_shadows = true;
    let before = dump(&frame(&model, 100, 30, &Theme::new(Palette::True, false)));
    assert_eq!(braille(&model), []);
    typed(&mut model, "A Esc");
    let over = braille(&model);
    assert!(over.len() > 10, "{over:?}");
    assert!(over.iter().all(|(_, _, behind)| *behind == Color::Rgb(40, 60, 80)), "{over:?}");
    // The lamp is seen beyond the upper right corner: its ray leaves the picture there.
    let rightmost = over.iter().max_by_key(|([x, _], ..)| *x).expect("a cell");
    assert!(rightmost.0[0] > 60 && rightmost.0[1] < 15, "{rightmost:?}");
    for keys in ["i", "i", "v", "v", "I"] {
        typed(&mut model, keys);
        assert!(!braille(&model).is_empty(), "after {keys}");
    }
    typed(&mut model, "I I v v v :rays Enter Esc");
    assert_eq!(dump(&frame(&model, 100, 30, &Theme::new(Palette::True, false))), before);
}

#[test]
fn rays_over_a_picture_that_is_narrower_than_its_pane_stay_inside() {
    let mut model = with_picture(glass(), (120, 30));
    model.is_alone = true;
    model.schematic.has_shadows = true;
    model.schematic.is_over_picture = true;
    // 27 rows are 54 dots, and so 72 columns: from 24 to 96.
    assert!(
        braille(&model).iter().all(|([x, y], ..)| (24..96).contains(x) && (1..28).contains(y)),
        "{:?}",
        braille(&model)
    );
}

fn logs() -> Vec<Log> {
    vec![
        textbook(),
        glass(),
        empty(),
        flat(),
        nested("(.)((.)."),
        log_of("figure-6", Arithmetic::F64),
        log_of("penumbra", Arithmetic::F64),
        log_of("frosted-glass", Arithmetic::F32),
    ]
}

#[test]
fn any_node_in_any_size_and_look_can_be_drawn() {
    let models: Vec<Model> = logs().into_iter().map(|log| with_picture(log, (80, 24))).collect();
    let mut runner = proptest::test_runner::TestRunner::new(ProptestConfig { cases: 300, ..ProptestConfig::default() });
    let place = (0..models.len(), any::<prop::sample::Index>(), 1_u16..160, 1_u16..60);
    let look = (0..3_usize, prop::option::of(0..4_usize), 0..=10_u32, any::<[bool; 5]>(), any::<bool>());
    let kinds = [0, 0, 0].map(Cell::new);
    runner
        .run(&(place, look), |((log, node, width, height), (what, side, magnification, flags, is_picture))| {
            let mut model = models[log].clone();
            let [has_shadows, is_over_picture, is_ascii, grows, has_scene] = flags;
            model.size = (width, height);
            model.go_to_node(node.index(model.tree.nodes().len()));
            let side = side.map(|side| Projection::ALL[side]);
            model.schematic =
                SchematicView { side, shown: Shown::ALL[what], has_shadows, is_over_picture, magnification };
            if grows {
                typed(&mut model, "t");
            }
            if !has_scene {
                model.drawing = None;
            }
            model.focus_on(if is_picture { Pane::Picture } else { Pane::Schematic });
            model.is_alone = width % 2 == 0;
            for palette in [Palette::True, Palette::None] {
                let shown = frame(&model, width, height, &Theme::new(palette, is_ascii));
                let symbols = || shown.content().iter().map(|cell| cell.symbol());
                let is_plain = !is_ascii || symbols().all(|symbol| symbol.is_ascii());
                let is_safe = symbols().all(|symbol| !symbol.contains('\u{1b}'));
                prop_assert!(is_plain && is_safe);
            }
            kinds[what].set(kinds[what].get() + 1);
            Ok(())
        })
        .unwrap_or_else(|error| panic!("{error}"));
    assert!(kinds.iter().all(|count| count.get() > 20), "{kinds:?}");
}
