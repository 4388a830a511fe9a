//! A close-up of a hit: the angles of the figure are those of the log, its areas those of the lobe, its weights those of the light.

use crate::calls::prints;
use crate::support::{grid, scene, scene_of, snapshots};
use crate::tags::read;
use insta::assert_snapshot;
use raywalk::log::{Log, Step, Tree, Value, What};
use raywalk::record::{self, Arithmetic};
use raywalk::report::close_up::{CloseUp, CloseUpError, Ink, Piece, Point, Subject, latex, light, svg, vectors, zones};
use raywalk::report::{Language, Style};
use std::collections::HashMap;

type Make = fn(&Subject) -> Result<CloseUp, CloseUpError>;

fn made(log: &Log, path: Option<&str>, make: Make) -> Result<CloseUp, CloseUpError> {
    let tree = Tree::of(&log.events);
    make(&Subject { log, tree: &tree, path, language: Language::English, style: Style::default() })
}

/// The vectors of a sheet by their names, as the page shows them: to the right and upward.
fn arrows(pieces: &[Piece]) -> HashMap<&str, [f64; 2]> {
    let named = pieces.windows(2).filter_map(|pair| match pair {
        [Piece::Arrow { from, to, .. }, Piece::Text { text, .. }] => {
            Some((text.as_str(), [to[0] - from[0], from[1] - to[1]]))
        }
        _ => None,
    });
    named.collect()
}

fn angle_on_page(a: [f64; 2], b: [f64; 2]) -> f64 {
    libm::atan2((a[0] * b[1] - a[1] * b[0]).abs(), a[0] * b[0] + a[1] * b[1])
}

/// The last vector of a key that a node notes or is given.
fn logged(log: &Log, tree: &Tree, node: usize, key: &str) -> Option<[f64; 3]> {
    let of = |event: usize| {
        let noted = match log.events[event].what {
            What::Note { name, value } if name.key() == key => Some(value),
            _ => None,
        };
        noted.or(log.given(event).iter().find(|(name, _)| name.key() == key).map(|(_, value)| *value))
    };
    match tree.own_events(node).filter_map(of).next_back()? {
        Value::Triple(xyz) => Some(xyz),
        Value::Number(_) => None,
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|axis| a[axis] * b[axis]).sum()
}

/// The angle on the page is the arc cosine of the product of the logged vectors.
#[track_caller]
fn agrees(page: &HashMap<&str, [f64; 2]>, [a, b]: [&str; 2], product: f64) {
    let turned = |name: &str| match name.strip_prefix('−') {
        Some(name) => page[name].map(|x| -x),
        None => page[name],
    };
    let found = angle_on_page(turned(a), turned(b));
    let expected = libm::acos(product.clamp(-1.0, 1.0));
    // Near 0 the arc cosine has lost half of its digits.
    assert!((found - expected).abs() < 3e-7, "{a}, {b}: {found} is not {expected}");
}

#[test]
fn angles_of_the_figure_are_those_of_the_logged_products() {
    let mut checked: HashMap<&str, u32> = HashMap::new();
    for name in ["textbook", "total-reflection", "transmission", "glass-and-mirror", "figure-6", "glass-shadows"] {
        let scene = scene(name);
        for pixel in grid(&scene, 7) {
            let log = record::pixel(&scene, pixel, Arithmetic::F64);
            let tree = Tree::of(&log.events);
            for node in 0..tree.nodes().len() {
                let path = tree.path(node);
                let is_ray = matches!(tree.nodes()[node].step, Some(Step::Ray { .. }));
                if !is_ray || path.contains('S') {
                    continue;
                }
                let Some(normal) = logged(&log, &tree, node, "hit.normal") else { continue };
                let close_up = made(&log, Some(&path), vectors).expect("a hit");
                let of_ray = |key| logged(&log, &tree, node, key);
                let page = arrows(&close_up.sheets[0].pieces);
                let incident = of_ray("ray.direction").expect("a direction");
                agrees(&page, ["N", "V"], -dot(normal, incident));
                agrees(&page, ["N", "d"], dot(normal, incident));
                for (symbol, key, against) in [("R", "reflect.direction", "N"), ("T", "refract.direction", "−N")] {
                    let Some(vector) = of_ray(key) else { continue };
                    let sign = if against == "N" { 1.0 } else { -1.0 };
                    agrees(&page, [against, symbol], sign * dot(normal, vector));
                    *checked.entry(symbol).or_default() += 1;
                }
                of_lights(&log, &tree, node, &close_up, normal, &mut checked);
            }
        }
    }
    for symbol in ["R", "T", "L", "H", "H′"] {
        assert!(checked[symbol] > 30, "{symbol}: {checked:?}");
    }
}

fn of_lights(
    log: &Log,
    tree: &Tree,
    ray: usize,
    close_up: &CloseUp,
    normal: [f64; 3],
    checked: &mut HashMap<&'static str, u32>,
) {
    let is = |node: &usize, wanted: fn(Step) -> bool| tree.nodes()[*node].step.is_some_and(wanted);
    let Some(shade) = tree.children(ray).find(|node| is(node, |step| matches!(step, Step::Shade { .. }))) else {
        return;
    };
    let Some(view) = logged(log, tree, shade, "view.direction") else { return };
    let mut sheets = close_up.sheets[1..].iter();
    for light in tree.children(shade).filter(|node| is(node, |step| matches!(step, Step::Light { .. }))) {
        let Some(toward) = logged(log, tree, light, "light.direction") else { continue };
        let page = arrows(&sheets.next().expect("a sheet for the light").pieces);
        agrees(&page, ["N", "L"], dot(normal, toward));
        *checked.entry("L").or_default() += 1;
        let halves = [("H", "half.direction", "H"), ("H′", "transmit.direction", "−H′")];
        let found = halves.iter().find_map(|(symbol, key, far)| Some((*symbol, *far, logged(log, tree, light, key)?)));
        let Some((symbol, far, half)) = found else { continue };
        let page = arrows(&sheets.next().expect("a sheet for H").pieces);
        agrees(&page, ["L", symbol], dot(toward, half));
        let sign = if symbol == "H" { 1.0 } else { -1.0 };
        agrees(&page, [far, "V"], sign * dot(half, view));
        *checked.entry(symbol).or_default() += 1;
        if symbol == "H′" {
            // Snell's law holds in the figure: H′ is the normal that would refract L toward −V.
            let sine = |a: [f64; 2], b: [f64; 2]| libm::sin(angle_on_page(a, b));
            let eta = log.events.iter().enumerate().find_map(|(event, happening)| match happening.what {
                What::Note { name, value: Value::Number(eta) }
                    if name.key() == "transmit.eta" && tree.owner(event) == light =>
                {
                    Some(eta)
                }
                _ => None,
            });
            let (of_light, of_view) = (sine(page["L"], page["H′"]), sine(page["V"], page["H′"]));
            assert!((of_light - eta.expect("an index") * of_view).abs() < 1e-9, "{of_light}, {of_view}, {eta:?}");
        }
    }
    assert_eq!(sheets.next(), None);
}

#[test]
fn the_numeric_example_has_its_angles() {
    let text = prints(&["trace", "textbook", "--pixel", "160,120", "--view", "vectors", "--format", "text"]);
    // acos(12/√161) and acos(√5/5).
    assert!(text.contains("N, V     0.946    19.0°") && text.contains("N, L     0.447    63.4°"), "{text}");
    let picture = prints(&["trace", "total-reflection", "--pixel", "100,110", "--view", "vectors", "--path", "C T"]);
    read(&picture);
    snapshots().bind(|| assert_snapshot!("close_up_vectors_svg", picture));
}

const MIDDLE: Point = [210.0, 210.0];
const RADIUS: f64 = 180.0;

/// The area of a polygon.
fn area(points: &[Point]) -> f64 {
    let next = |at: usize| points[(at + 1) % points.len()];
    let twice = |at: usize| points[at][0] * next(at)[1] - points[at][1] * next(at)[0];
    (0..points.len()).map(twice).sum::<f64>().abs() / 2.0
}

#[test]
fn the_sixteen_zones_are_equally_large_and_each_holds_its_direction() {
    let scene = scene("polished-surface");
    let log = record::pixel(&scene, [105, 95], Arithmetic::F64);
    let close_up = made(&log, None, zones).expect("a blurred bounce");
    let pieces = &close_up.sheets[0].pieces;
    let zones: Vec<_> = pieces
        .iter()
        .filter_map(|piece| if let Piece::Path { points, .. } = piece { Some(points) } else { None })
        .collect();
    assert_eq!(zones.len(), 16);
    for zone in &zones {
        // A sector of 24 chords; its area doesn't depend on the ring.
        let chords = 24.0 * libm::sin(std::f64::consts::TAU / 4.0 / 24.0) / 2.0 / 4.0;
        assert!((area(zone) / (RADIUS * RADIUS) - chords).abs() < 1e-9);
    }
    let dots: Vec<_> = pieces
        .iter()
        .filter_map(|piece| match piece {
            Piece::Dot { at, ink, .. } if *ink != Ink::Black => Some(*at),
            _ => None,
        })
        .collect();
    assert_eq!(dots.len(), 16);
    for (number, (at, zone)) in dots.iter().zip(&zones).enumerate() {
        let polar = |place: Point| {
            let [x, y] = [place[0] - MIDDLE[0], MIDDLE[1] - place[1]];
            (libm::hypot(x, y), libm::atan2(y, x).rem_euclid(std::f64::consts::TAU))
        };
        let (radius, angle) = polar(*at);
        let radii: Vec<_> = zone.iter().map(|place| polar(*place).0).collect();
        let [least, largest] =
            [radii.iter().copied().fold(f64::MAX, f64::min), radii.iter().copied().fold(0.0, f64::max)];
        assert!((least - 1e-6..=largest + 1e-6).contains(&radius), "zone {}", number + 1);
        // Four zones a ring, in the order of their numbers.
        let sector = (angle / (std::f64::consts::TAU / 4.0)).floor() as usize;
        let outer = zone[zone.len() / 2 + 12];
        assert_eq!((polar(outer).1 / (std::f64::consts::TAU / 4.0)).floor() as usize, sector, "zone {}", number + 1);
    }
    snapshots().bind(|| assert_snapshot!("close_up_zones_svg", svg(&close_up)));
}

/// cosⁿ⁺¹θ at the rings: with n = 60 three quarters of the lobe lie within acos(4^(−1/61)) of its axis.
#[test]
fn the_rings_have_their_angles() {
    let log = record::pixel(&scene("polished-surface"), [105, 95], Arithmetic::F64);
    let close_up = made(&log, None, zones).expect("a blurred bounce");
    let texts: Vec<_> = close_up.sheets[0]
        .pieces
        .iter()
        .filter_map(|piece| if let Piece::Text { text, .. } = piece { Some(text.as_str()) } else { None })
        .collect();
    for part in [0.25, 0.5, 0.75] {
        let degrees = libm::acos(libm::pow(1.0 - part, 1.0 / 61.0)).to_degrees();
        assert!(texts.contains(&format!("{degrees:.1}°").as_str()), "{degrees}: {texts:?}");
    }
}

#[test]
fn weights_of_the_shadow_rays_of_a_light() {
    let log = record::pixel(&scene("penumbra"), [78, 80], Arithmetic::F64);
    let close_up = made(&log, None, light).expect("an area light");
    assert_eq!(close_up.rows.len(), 9);
    // By area all have the same weight.
    assert!(close_up.rows.iter().all(|row| row[2] == "0.111"), "{:?}", close_up.rows);
    assert_eq!(close_up.sheets[0].caption, "sum of the weights: 1.000");
    let is_dark = |row: &&Vec<String>| row[3] == "(0, 0, 0)";
    let dark = close_up.rows.iter().filter(is_dark).count();
    assert!(dark > 0 && dark < 9, "{:?}", close_up.rows);
    assert!(close_up.rows.iter().filter(is_dark).all(|row| row[4] == "(0, 0, 0)"));
    snapshots().bind(|| assert_snapshot!("close_up_light_svg", svg(&close_up)));

    // By solid angle the profile weighs them.
    let text = r#"{"format": "raywalk-scene/1", "camera": {"position": [0, 0.5, 9], "direction": [0, -0.5, -9], "resolution": [3, 3]},
        "lights": [{"rectangle": {"corner": [-1, 1, -1], "edge_u": [2, 0, 0], "edge_v": [0, 0, 2]}, "samples": 16,
                    "profile": {"cosine_power": 2}, "by": "solid_angle"}],
        "materials": {"paper": {"diffuse": [1, 1, 1]}},
        "objects": [{"shape": {"plane": {"coefficients": [0, 1, 0, 0]}}, "material": "paper"}]}"#;
    let log = record::pixel(&scene_of(text.as_bytes(), "weighted"), [1, 1], Arithmetic::F64);
    let close_up = made(&log, None, light).expect("an area light");
    let mut weights: Vec<_> = close_up.rows.iter().map(|row| row[2].as_str()).collect();
    weights.sort_unstable();
    weights.dedup();
    assert!(close_up.rows.len() == 16 && weights.len() > 10, "{weights:?}");
}

#[test]
fn weights_of_a_rule() {
    let adaptive = r#""samples": {"min": 4, "max": 9}"#;
    let text = include_str!("../../scenes/penumbra.json").replace(r#""samples": 9"#, adaptive);
    let log = record::pixel(&scene_of(text.as_bytes(), "rule"), [20, 110], Arithmetic::F64);
    let rows = made(&log, None, light).expect("an area light").rows;
    let is_lit = |row: &&Vec<String>| row[2] == "0.125" && row[3] == "(1, 1, 1)" && row[4] != "(0, 0, 0)";
    assert!(rows[0][2] == "0.250" && rows[1..].iter().filter(is_lit).count() == 6, "{rows:?}");
}

#[test]
fn a_shadow_ray_in_the_path_chooses_the_area_light() {
    let view = ["trace", "weighted-light", "--pixel", "80,80", "--view", "light", "--format", "text"];
    let of = |path: &[&str]| prints(&[&view[..], path].concat());
    let first = of(&[]);
    assert!(first.starts_with("Light even at the hit of the ray C\n"), "{first}");
    assert!(first.ends_with("--path 'C S2' shows light weighted.\n"), "{first}");
    let second = of(&["--path", "C S2"]);
    assert!(second.starts_with("Light weighted at the hit of the ray C\n"), "{second}");
    assert!(second.ends_with("--path 'C S1' shows light even.\n"), "{second}");
    assert_eq!(
        (of(&["--path", "C S2.3"]), of(&["--path", "C"]), of(&["--path", "C S1"])),
        (second, first.clone(), first)
    );
    let unknown = [&view[..], &["--path", "C S3"]].concat();
    crate::calls::says(2, &unknown, "expected the path of a ray in the log (C S1, C S2), found `C S3`");
    let unknown = [&view[..], &["--path", "C T S1"]].concat();
    crate::calls::says(2, &unknown, "expected the path of a ray in the log (C");
}

#[test]
fn angles_name_their_lights() {
    let call = ["trace", "figure-6", "--pixel", "160,120", "--path", "C T", "--view", "vectors", "--format", "text"];
    let text = prints(&call);
    let log = record::pixel(&scene("figure-6"), [160, 120], Arithmetic::F64);
    let close_up = made(&log, Some("C T"), vectors).expect("a hit");
    let named: Vec<_> = close_up.rows.iter().filter(|row| row[0] == "N, L").map(|row| row[3].as_str()).collect();
    let lights: Vec<_> = scene("figure-6").lights.iter().map(|light| light.name.to_string()).collect();
    assert!(named.len() > 1, "{text}");
    assert_eq!(named, lights.iter().map(String::as_str).take(named.len()).collect::<Vec<_>>());
    for row in &close_up.rows {
        // What has to do with no light names none.
        assert_eq!(row[3].is_empty(), !row[0].contains('L') && !row[0].contains('H'), "{row:?}");
        assert!(text.contains(&row[3]));
    }
}

/// A room for the letters as most fonts have it, a little less than the one that is kept free.
#[test]
fn no_two_labels_cover_each_other() {
    let mut checked = 0;
    for name in raywalk::scene::builtin::names() {
        let scene = scene(name);
        let [width, height] = scene.camera.resolution;
        let log = record::pixel(&scene, [width / 2, height / 2], Arithmetic::F64);
        let tree = Tree::of(&log.events);
        let is_ray = |node: &usize| matches!(tree.nodes()[*node].step, Some(Step::Ray { .. }));
        for node in (0..tree.nodes().len()).filter(is_ray).take(40) {
            for make in [vectors as Make, zones, light] {
                let Ok(close_up) = made(&log, Some(&tree.path(node)), make) else { continue };
                for sheet in &close_up.sheets {
                    assert_no_overlap(&sheet.pieces, &format!("{name} {}: {}", tree.path(node), sheet.caption));
                    checked += 1;
                }
            }
        }
    }
    assert!(checked > 100, "{checked}");
    for (name, pixel, path) in
        [("textbook", [160, 120], "C"), ("transmission", [150, 95], "C"), ("polished-surface", [105, 95], "C")]
    {
        let log = record::pixel(&scene(name), pixel, Arithmetic::F64);
        for make in [vectors as Make, zones] {
            let Ok(close_up) = made(&log, Some(path), make) else { continue };
            close_up.sheets.iter().for_each(|sheet| assert_no_overlap(&sheet.pieces, name));
        }
    }
}

#[track_caller]
fn assert_no_overlap(pieces: &[Piece], about: &str) {
    let labels: Vec<_> = pieces
        .iter()
        .filter_map(|piece| match piece {
            Piece::Text { at, text, .. } => Some((text, *at, 3.4 * text.chars().count() as f64)),
            _ => None,
        })
        .collect();
    for (number, (text, at, half)) in labels.iter().enumerate() {
        for (other, place, other_half) in &labels[..number] {
            let is_apart = (at[0] - place[0]).abs() >= half + other_half || (at[1] - place[1]).abs() >= 11.0;
            assert!(is_apart, "{about}: {other} at {place:?} and {text} at {at:?}");
        }
    }
}

#[test]
fn latex_has_degrees_and_powers() {
    let of = |scene: &str, pixel: &str, view: &str, more: &[&str]| {
        prints(&[&["trace", scene, "--pixel", pixel, "--view", view, "--format", "latex"], more].concat())
    };
    for lang in ["en", "es"] {
        let vectors = of("total-reflection", "130,150", "vectors", &["--lang", lang]);
        let zones = of("polished-surface", "105,95", "zones", &["--lang", lang]);
        let expected = if lang == "en" { r"{$57.7^\circ$}" } else { r"{$57{,}7^\circ$}" };
        assert!(vectors.contains(expected), "{vectors}");
        assert!(zones.contains(r"$\cos^n$"), "{zones}");
        for text in [vectors, zones, of("weighted-light", "80,80", "light", &["--lang", lang])] {
            assert!(!text.contains("U+"), "{text}");
        }
    }
}

#[test]
fn every_format_and_language() {
    let log = record::pixel(&scene("polished-surface"), [105, 95], Arithmetic::Decimal(3));
    let tree = Tree::of(&log.events);
    for language in Language::ALL {
        let subject = Subject { log: &log, tree: &tree, path: None, language, style: Style::default() };
        let zones = zones(&subject).expect("a blurred bounce");
        assert!(latex(&zones).ends_with("\\end{document}\n"));
        read(&svg(&zones));
        assert_eq!(zones.title.starts_with("Zonas"), language == Language::Spanish);
    }
    // A saved log needs no scene.
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("pixel.ndjson");
    let file = file.to_str().expect("a plain name");
    prints(&["trace", "textbook", "--pixel", "160,120", "-o", file]);
    let of_scene = prints(&["trace", "textbook", "--pixel", "160,120", "--view", "vectors"]);
    assert_eq!(prints(&["trace", file, "--view", "vectors"]), of_scene);
}

#[test]
fn what_is_not_there_is_said() {
    let pixel = ["trace", "textbook", "--pixel", "160,120", "--view"];
    let says = |more: &[&str], expected: &str| {
        crate::calls::says(2, &[&pixel[..], more].concat(), expected);
    };
    says(&["zones"], "--view zones: expected a blurred bounce");
    says(&["light"], "--view light: expected an area light");
    says(&["vectors", "--path", "C T"], "expected the path of a ray in the log (C, C R), found `C T`");
    says(&["vectors", "--format", "json"], "--view: expected --format svg, latex or text, found json");
    let region = ["trace", "textbook", "--region", "0,0,2,2", "--view", "vectors"];
    crate::calls::says(2, &region, "expected a pixel or a ray, found a region");
}
