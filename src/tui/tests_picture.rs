//! The picture and the schematic without a terminal: a scene that somebody else traces.

use super::dump::dump;
use super::listing::listing;
use super::testing::{empty, glass, nested, sized, textbook, typed};
use super::*;
use crate::log::{Log, Subject};
use crate::tui::keys::sequence;
use ratatui::style::Color;
use std::sync::Arc;

/// A scene of 8 × 6 pixels whose colour, depth and counts are its column and row. Each pixel has the log of the glass ball.
#[derive(Default)]
struct Fake {
    traced: Vec<[u32; 2]>,
}

impl Live for Fake {
    fn trace(&mut self, pixel: [u32; 2]) -> Result<Log, Refusal> {
        if pixel == [7, 5] {
            return Err(Refusal::Other("too long".to_owned()));
        }
        self.traced.push(pixel);
        Ok(of_pixel(glass(), pixel))
    }

    fn picture(&mut self, _wanted: Wanted) -> Option<Arc<Image>> {
        let levels = |color: [f64; 3], stops: f64| color.map(|x| (x * libm::exp2(stops)).min(255.0) as u8);
        let mut image = Image::empty([8, 6], Arc::new(levels));
        for (number, dot) in image.dots.iter_mut().enumerate() {
            let (x, y) = ((number % 8) as f64, (number / 8) as f64);
            let color = [20.0 * x, 30.0 * y, 100.0];
            let (depth, rays, error) = (Some(x), number as u32, Some(0.0));
            *dot = Some(Dot { color, depth, rays, samples: 1, error, ..Dot::default() });
        }
        Some(Arc::new(image))
    }

    fn drawing(&mut self) -> Option<Arc<Drawing>> {
        let ball = Wireframe { name: "ball".to_owned(), lines: vec![vec![[-2.0, 0.0, 0.0], [2.0, 0.0, 0.0]]] };
        let lamp = Wireframe { name: "lamp".to_owned(), lines: vec![vec![[5.0, 5.0, 10.0]]] };
        let place_of = |[x, y, z]: [f64; 3]| (z < 10.0).then(|| [4.0 + x / (10.0 - z), 3.0 - y / (10.0 - z)]);
        Some(Arc::new(Drawing {
            objects: vec![ball],
            lights: vec![lamp],
            eye: [0.0, 0.0, 10.0],
            place_of: Arc::new(place_of),
            size: [8, 6],
        }))
    }

    fn compare(&mut self, _subject: Subject) -> Result<Vec<Log>, Refusal> {
        Ok(vec![textbook()])
    }
}

fn of_pixel(mut log: Log, pixel: [u32; 2]) -> Log {
    log.header.subject = Subject::Pixel(pixel);
    log
}

/// The model with the focus on the picture, at pixel 3,2, after these keys; and the pixels that were traced.
fn after(keys: &str, size: (u16, u16)) -> (Model, Vec<[u32; 2]>) {
    let mut fake = Fake::default();
    let mut model = sized(of_pixel(glass(), [3, 2]), size.0, size.1);
    {
        let mut live: Option<&mut dyn Live> = Some(&mut fake);
        live::look(&mut model, &mut live, Wanted::Latest);
        model.focus_on(Pane::Picture);
        for key in sequence(keys) {
            if let Some(action) = super::keys::meant(&model, key) {
                let effect = update(&mut model, action);
                live::answer(&mut model, effect, &mut live);
            }
        }
    }
    (model, fake.traced)
}

#[track_caller]
fn goes_to(keys: &str, pixel: [u32; 2]) {
    let (model, traced) = after(keys, (100, 30));
    assert_eq!(model.pixel(), Some(pixel), "after {keys}");
    assert_eq!(model.picture.as_ref().map(|view| view.cursor), Some(pixel), "after {keys}");
    assert_eq!(traced.last().copied().unwrap_or([3, 2]), pixel, "after {keys}");
}

#[test]
fn the_cursor_walks_and_each_pixel_is_traced() {
    goes_to("", [3, 2]);
    goes_to("l", [4, 2]);
    goes_to("h", [2, 2]);
    goes_to("j", [3, 3]);
    goes_to("k", [3, 1]);
    goes_to("2l2j", [5, 4]);
    goes_to("99h99k", [0, 0]);
    goes_to("g", [0, 2]);
    goes_to("kG", [7, 1]);
}

#[test]
fn a_pixel_that_cannot_be_traced_is_said_and_the_old_one_stays() {
    let (model, _) = after("99l99j", (100, 30));
    assert_eq!(model.pixel(), Some([7, 2]));
    assert!(model.message.is_some_and(|message| message.text == "too long"));
    assert_eq!(model.picture.map(|view| view.cursor), Some([7, 2]));
}

#[test]
fn the_picture_ends() {
    let (model, traced) = after("9h h", (100, 30));
    assert_eq!(traced, [[0, 2]]);
    assert!(model.message.is_some_and(|message| message.text.contains("ends here")));
}

#[test]
fn the_selection_stays_where_the_trees_agree() {
    let (mut model, _) = after("", (100, 30));
    model.go_to_event(40);
    let (event, cursor) = (model.event, model.cursor);
    live::show_log(&mut model, of_pixel(glass(), [1, 1]));
    assert_eq!((model.event, model.cursor), (event, cursor));
    live::show_log(&mut model, textbook());
    assert!(model.event < model.log.events.len());
}

#[test]
fn jumps_and_stops_outlive_another_pixel() {
    // At the first value a jump to the last step, then the pixel at the right.
    let from = after("<Tab> n", (100, 30)).0.event;
    let there = |keys: &str| {
        let (model, traced) = after(&format!("<Tab> n $ <BackTab> l {keys}"), (100, 30));
        (model.pixel(), model.event, traced.len())
    };
    let last = glass().events.len() - 1;
    assert_eq!(there(""), (Some([4, 2]), last, 1));
    assert_eq!(there("^o"), (Some([3, 2]), from, 2));
    assert_eq!(there("''"), (Some([3, 2]), from, 2));
    assert_eq!(there("'' ''"), (Some([4, 2]), last, 3));
    assert_eq!(there("^o ^o"), (Some([3, 2]), from, 2));
    // Going to a pixel by its numbers is a jump, going from pixel to pixel isn't.
    assert_eq!(there(":pixel<Space>1,1<Enter> ^o"), (Some([4, 2]), last, 3));
    // A pixel that can't be traced leads nowhere, and so isn't come back from.
    assert_eq!(there(":pixel<Space>7,5<Enter> ^o"), (Some([3, 2]), from, 2));

    let (model, _) = after("<Tab> bhit<Enter> r <BackTab> l", (100, 30));
    let entry = |model: &Model| listing(model, Kind::Stops).entries[0].text.clone();
    assert!(entry(&model).contains("\t3,2\thit\thit"), "{}", entry(&model));
    let (back, traced) = after("<Tab> bhit<Enter> r <BackTab> l <Tab> L <Enter>", (100, 30));
    assert_eq!((back.pixel(), back.event, back.overlay), (Some([3, 2]), model.event, None));
    assert_eq!(traced.len(), 2);
    assert!(!entry(&back).contains("3,2"), "{}", entry(&back));
}

#[test]
fn what_was_closed_stays_closed_when_one_comes_back() {
    let closed = |keys: &str| {
        let (model, _) = after(&format!("<Tab> 0 C <BackTab> {keys}"), (100, 30));
        (0..model.tree.nodes().len()).filter(|node| !model.fold.is_open(&model.tree, *node)).count()
    };
    let there = closed("");
    assert_eq!(closed("l h"), there);
    assert_ne!(closed("l"), there);
}

#[test]
fn a_step_that_is_gone_is_come_back_to_nearby() {
    let (mut model, _) = after("<Tab> $ 0", (100, 30));
    let spot = model.spot(glass().events.len() / 2);
    live::show_log(&mut model, of_pixel(textbook(), [3, 2]));
    assert_eq!(super::jumps::go(&mut model, spot), Effect::None);
    assert!(model.message.is_some_and(|message| message.text.contains("the nearest")));
}

#[test]
fn layers_exposure_and_zoom() {
    let view = |keys: &str| after(keys, (100, 30)).0.picture.expect("a picture");
    assert_eq!(view("v").layer, Layer::Depth);
    assert_eq!(view("vvvvv").layer, Layer::Colors);
    assert_eq!(view("3)").exposure, 3);
    assert_eq!(view(")((").exposure, -1);
    assert_eq!(view("iiI").zoom, 1);
    assert_eq!(view("I").zoom, 0);
    assert_eq!(view("").image.range(Layer::Rays), Some([0.0, 47.0]));
}

#[test]
fn enter_goes_to_the_tree() {
    assert_eq!(after("<Enter>", (100, 30)).0.focus, Pane::Tree);
}

#[test]
fn every_dot_of_the_screen_is_the_pixel_under_it() {
    let (model, _) = after("", (100, 30));
    let mut view = model.picture.expect("a picture");
    // Two dots to a pixel.
    for (column, row) in (0..16).flat_map(|column| (0..12).map(move |row| (column, row))) {
        assert_eq!(view.pixel_under([16, 12], [column, row]), Some([column / 2, row / 2]));
    }
    assert_eq!(view.pixel_under([20, 12], [1, 0]), None);
    assert_eq!(view.pixel_under([20, 12], [2, 0]), Some([0, 0]));
    view.zoom = 1;
    assert_eq!(view.pixel_under([16, 12], [8, 6]), Some([3, 2]));
    view.cursor = [0, 0];
    assert_eq!(view.pixel_under([16, 12], [0, 0]), Some([0, 0]));
}

#[test]
fn half_blocks_have_the_colours_of_their_pixels() {
    let (model, _) = after("zo", (8, 6));
    let frame = frame(&Model { size: (20, 8), ..model }, 20, 8, &Theme::new(Palette::True, false));
    // 20 columns and 10 rows of dots for 8 x 6 pixels: 10/6 dots a pixel, centred.
    let colors: Vec<Color> = frame.content().iter().map(|cell| cell.fg).collect();
    assert!(colors.contains(&Color::Rgb(0, 0, 100)) && colors.contains(&Color::Rgb(140, 0, 100)), "{colors:?}");
}

#[test]
fn a_cell_has_the_mean_of_its_pixels() {
    let image = after("", (100, 30)).0.picture.expect("a picture").image;
    let mean = |area| image.mean(area, |dot| Some(dot.color));
    // Columns 2 and 3, rows 1 and 2.
    assert_eq!(mean([[2.0, 4.0], [1.0, 3.0]]), Some([50.0, 45.0, 100.0]));
    assert_eq!(mean([[0.0, 8.0], [0.0, 6.0]]), Some([70.0, 75.0, 100.0]));
    // Where no pixel's middle is, the pixel there; none beyond the picture.
    assert_eq!(mean([[2.6, 2.9], [1.0, 1.4]]), Some([40.0, 30.0, 100.0]));
    assert_eq!(mean([[8.0, 8.4], [0.0, 1.0]]), None);
    let mut view = after("", (100, 30)).0.picture.expect("a picture");
    assert_eq!(view.area_under([4, 4], [1, 1]), Some([[2.0, 4.0], [1.0, 3.0]]));
    // Each pixel is in exactly one cell, whatever the screen.
    for (columns, rows) in (1..12).flat_map(|columns| (1..12).map(move |rows| (columns, rows))) {
        let counted = std::cell::Cell::new(0);
        for dot in (0..columns).flat_map(|column| (0..rows).map(move |row| [column, row])) {
            let area = view.area_under([columns, rows], dot).unwrap_or([[9.0; 2]; 2]);
            let is_point = area.iter().all(|[from, to]| to - from < 1.0);
            view.image.mean(area, |dot| {
                counted.set(counted.get() + 1);
                Some(dot.color)
            });
            if is_point {
                counted.set(48);
                break;
            }
        }
        assert_eq!(counted.get(), 48, "{columns}x{rows}");
    }
    view.layer = Layer::Depth;
    assert_eq!(view.image.mean([[2.0, 4.0], [0.0, 6.0]], |dot| view.layer.of(dot).map(|x| [x])), Some([2.5]));
}

#[test]
fn a_picture_above_white_is_shown_darker() {
    let (mut model, _) = after("", (140, 40));
    let mut view = model.picture.clone().expect("a picture");
    // The brightest channel is 150.
    for (white, expected) in [(70.0, -3), (75.0, -2), (150.0, 0), (f64::INFINITY, 0)] {
        let image = Image { white, ..(*view.image).clone() };
        view.show(Arc::new(image));
        assert_eq!(view.fitting, expected, "{white}");
    }
    let image = Image { white: 70.0, ..(*view.image).clone() };
    view.show(Arc::new(image));
    model.picture = Some(view);
    model.is_alone = true;
    let text = dump(&frame(&model, 140, 40, &Theme::new(Palette::None, false)));
    assert!(text.matches("above white: shown -1.5 stops").count() == 2, "{text}");
    assert!(text.contains("3,2 ball  ("), "{text}");
    typed(&mut model, ")");
    assert_eq!(model.picture.as_ref().map(PictureView::stops), Some(-1.0));
}

/// With a picture of 400 × 300 pixels on the screen, these keys ask for this pixel.
#[track_caller]
fn asks_for(keys: &str, pixel: [u32; 2]) {
    let mut model = sized(of_pixel(glass(), [200, 150]), 100, 30);
    let mut image = Image::empty([400, 300], Arc::new(|_, _| [0; 3]));
    for (number, dot) in image.dots.iter_mut().enumerate() {
        let value = (number % 1000) as f64;
        *dot = Some(Dot {
            color: [value; 3],
            depth: None,
            rays: 1,
            samples: 1,
            error: Some(value * 1e-9),
            ..Dot::default()
        });
    }
    model.picture = Some(PictureView::new(Arc::new(image), [200, 150]));
    model.focus_on(Pane::Picture);
    assert_eq!(typed(&mut model, &format!("zo {keys}")), Effect::Trace(pixel), "after {keys}");
}

#[test]
fn the_cursor_goes_by_cells_and_to_the_extremes() {
    // 100 columns and 27 rows, two dots a row: 300/54 pixels a dot.
    asks_for("L", [206, 150]);
    asks_for("2H", [188, 150]);
    asks_for("J", [200, 161]);
    asks_for("K", [200, 139]);
    asks_for("+", [199, 2]);
    asks_for("-", [0, 0]);
    asks_for("vv +", [0, 0]);
    asks_for("! Enter", [199, 2]);
    asks_for("! j Enter", [399, 4]);
}

#[test]
fn a_bar_has_the_colours_of_the_layer() {
    let (model, _) = after("zo v", (100, 30));
    let shown = frame(&model, 100, 30, &Theme::new(Palette::True, false));
    let colors: Vec<Color> =
        shown.content()[..100].iter().filter(|cell| cell.symbol() == "█").map(|cell| cell.fg).collect();
    assert_eq!(colors.len(), 12);
    assert_eq!((colors[0], colors[11]), (Color::Rgb(0, 32, 76), Color::Rgb(255, 234, 70)));
    let text = dump(&frame(&model, 100, 30, &Theme::new(Palette::None, true)));
    let title = text.lines().next().unwrap_or_default();
    assert!(title.contains("depth 0 ..") && title.contains("% 7 "), "{title}");
}

#[test]
fn any_size_in_any_look_can_be_drawn() {
    for keys in ["", "v", "iii", "Tab Tab Tab Tab v", "Shift-Tab v v iii"] {
        let (mut model, _) = after(keys, (100, 30));
        for pane in Pane::ALL {
            model.focus_on(pane);
            for (width, height) in
                (1..240).step_by(13).flat_map(|width| (1..70).step_by(7).map(move |height| (width, height)))
            {
                for (palette, ascii) in [(Palette::True, false), (Palette::Indexed, true), (Palette::None, false)] {
                    model.size = (width, height);
                    let shown = frame(&model, width, height, &Theme::new(palette, ascii));
                    let is_ascii = shown.content().iter().all(|cell| cell.symbol().is_ascii());
                    assert!(is_ascii || !ascii, "{width}x{height} {pane:?}");
                }
            }
        }
    }
}

/// The letter of the current ray in the schematic, alone on the screen.
fn letter(model: &Model) -> Option<String> {
    let (width, height) = model.size;
    let frame = frame(model, width, height, &Theme::new(Palette::None, false));
    let is_letter = |cell: &&ratatui::buffer::Cell| {
        cell.modifier.contains(ratatui::style::Modifier::REVERSED | ratatui::style::Modifier::BOLD)
    };
    frame.content().iter().find(is_letter).map(|cell| cell.symbol().to_owned())
}

#[test]
fn the_letter_of_a_ray_stays_on_the_screen() {
    for (log, keys, expected) in [(textbook(), "1j", "C"), (textbook(), "9j", "R"), (glass(), "1j", "C")] {
        let mut model = sized(log, 80, 24);
        typed(&mut model, keys);
        model.focus_on(Pane::Schematic);
        model.is_alone = true;
        for _ in 0..2 {
            model.schematic.magnification = 0;
            for _ in 0..=10 {
                let found = letter(&model);
                assert_eq!(found.as_deref(), Some(expected), "{:?} x2^{}", model.side(), model.schematic.magnification);
                typed(&mut model, "i");
            }
            typed(&mut model, "v");
        }
    }
}

#[test]
fn a_ray_that_hits_nothing_is_drawn_and_a_log_without_rays_says_so() {
    let shown = |log: Log, keys: &str| {
        let mut model = sized(log, 80, 24);
        model.focus_on(Pane::Schematic);
        model.is_alone = true;
        typed(&mut model, keys);
        dump(&frame(&model, 80, 24, &Theme::new(Palette::None, false)))
    };
    for keys in ["j", "j v", "j iii"] {
        let text = shown(empty(), keys);
        assert!(!text.contains("no rays") && text.lines().take(24).any(|line| line.contains('C')), "{keys}:\n{text}");
    }
    assert!(shown(nested("(.)"), "").contains("the log has no rays here"));
}

/// While the tree grows, the line below the picture keeps the colour back until it is computed.
#[test]
fn a_growing_tree_keeps_the_colour_back() {
    let below = |keys: &str| {
        let (model, _) = after(keys, (140, 40));
        let text = dump(&frame(&model, 140, 40, &Theme::new(Palette::None, false)));
        text.lines()
            .find(|line| line.starts_with("3,2"))
            .map(|line| line.split('│').next().unwrap_or_default().trim().to_owned())
    };
    let told = below("").expect("the line of the pixel");
    assert!(told.contains("(0.397, 0.459, 0.520)"), "{told}");
    assert_eq!(below("t").as_deref(), Some("3,2"));
    assert_eq!(below("t$"), Some(told));
}
