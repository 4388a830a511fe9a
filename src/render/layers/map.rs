//! A layer as a picture for people: false colours, and below them a legend.

use super::{Layer, Layered, PixelFacts};
use crate::log::Unit;
use crate::log::plane::Plane;
use crate::render::scale::inferno;
use crate::render::{Film, export};
use crate::scene::{self, Color};
use font8x8::UnicodeFonts;
use std::collections::BTreeMap;

/// The side of a letter.
const LETTER: u32 = 8;

/// How high a line of the legend is.
const LINE: u32 = LETTER + 4;

/// How wide a picture is at least, so that the legend has room.
const NARROWEST: u32 = 36 * LETTER;

/// How many objects the legend names.
const MOST_NAMED: usize = 12;

/// The part of the pixels that took no longer than where the scale of times ends.
const MOST_TIMES: f64 = 0.995;

/// What isn't known.
const GRAY: Color = Color::new(0.35, 0.35, 0.35);

/// A layer in false colours from 0 to 1, with its legend.
struct Map {
    width: u32,
    colors: Vec<Color>,
}

/// The numbers that a scale goes over.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Range {
    least: f64,
    most: f64,
}

/// A layer in false colours, as the bytes of a PNG. Scales go from the least to the greatest number of the picture: black, violet, red,
/// orange, yellow. What isn't known is grey. Objects have colours of their own, which the legend names by `objects`.
///
/// # Errors
/// Those of the encoder.
pub fn false_colors(layered: &Layered, layer: Layer, objects: &[String]) -> Result<Vec<u8>, export::EncodeError> {
    let mut map = Map::new(layered.width());
    match layer {
        Layer::Normal => {
            let half = Color::splat(0.5);
            map.picture(layered, |seen| if seen.depth.is_some() { seen.normal * 0.5 + half } else { GRAY });
            map.text("normal: x red, y green, z blue, -1 to 1");
        }
        Layer::Object => {
            map.picture(layered, |seen| seen.object.map_or(GRAY, color_of_object));
            map.named(layered, objects);
        }
        _ => {
            let number = |seen: &PixelFacts| number_of(layer, seen).filter(|number| number.is_finite());
            let mut range = Range::of(layered.pixels().iter().filter_map(number));
            if layer == Layer::Time {
                // Now and then the system does something else for a while.
                range.most = percentile(layered.pixels().iter().filter_map(number).collect(), MOST_TIMES);
            }
            map.picture(layered, |seen| number(seen).map_or(GRAY, |number| inferno(range.part(number))));
            map.scale(
                match layer {
                    Layer::Time => "seconds (99.5 %)",
                    Layer::Error => "error / white",
                    _ => layer.word(),
                },
                range,
            );
        }
    }
    map.encoded()
}

/// A plane as the bytes of a PNG, of which `at` is the first number: light as the picture shows it, a number in false colours with a scale, a triple in red,
/// green and blue. What no ray of a pixel has is grey.
///
/// # Errors
/// Those of the encoder.
pub fn of_plane(
    layered: &Layered,
    plane: &Plane,
    at: usize,
    output: &scene::Output,
) -> Result<Vec<u8>, export::EncodeError> {
    let is_light = match plane {
        Plane::Value(value) => value.is_triple() && value.name.unit() == Unit::Intensity,
        Plane::Light(_) | Plane::Class(_) => true,
    };
    let triple = |pixel: usize| {
        let numbers = layered.numbers(pixel);
        let color = Color::new(numbers[at], numbers[at + 1], numbers[at + 2]);
        color.is_finite().then_some(color)
    };
    let pixels = 0..layered.pixels().len();
    if is_light {
        let gray = GRAY * output.white;
        let film = Film::of(layered.area(), pixels.map(|pixel| triple(pixel).unwrap_or(gray)).collect());
        return Ok(export::encode(&film, export::Format::Png8, output)?.bytes);
    }
    let mut map = Map::new(layered.width());
    let name = plane.to_string();
    if plane.numbers() == 1 {
        let numbers: Vec<_> = layered.numbers_of(at).map(|number| Some(number).filter(|x| x.is_finite())).collect();
        let range = Range::of(numbers.iter().flatten().copied());
        map.pixels(layered.width(), numbers.iter().map(|x| x.map_or(GRAY, |number| inferno(range.part(number)))));
        map.scale(&name, range);
    } else {
        let range = Range::of(pixels.clone().filter_map(triple).flat_map(|color| color.to_array()));
        // Directions and normals look the same in every picture.
        let is_within = |most: f64| -most <= range.least && range.most <= most;
        let range = if is_within(1.0) { Range { least: -1.0, most: 1.0 } } else { range };
        let shown = |color: Color| Color::from_array(color.to_array().map(|x| range.part(x)));
        map.pixels(layered.width(), pixels.map(|pixel| triple(pixel).map_or(GRAY, shown)));
        map.text(&name);
        map.text(&format!("x red, y green, z blue, {} to {}", self::shown(range.least), self::shown(range.most)));
    }
    map.encoded()
}

/// What a scale shows of a pixel; `None` where it isn't known.
fn number_of(layer: Layer, seen: &PixelFacts) -> Option<f64> {
    match layer {
        Layer::Rays => Some(seen.rays as f64),
        Layer::Tests => Some(seen.primitive_tests.saturating_add(seen.bounds_tests) as f64),
        Layer::Depth => seen.depth,
        Layer::Samples => Some(seen.samples as f64),
        Layer::Error => seen.error,
        Layer::Time => Some(seen.seconds),
        Layer::Normal | Layer::Object => None,
    }
}

/// Hues that differ much between one object and the next: steps of the golden ratio around the circle, at two lightnesses.
fn color_of_object(object: u32) -> Color {
    let hue = (f64::from(object) * 0.618_033_988_749_895).fract() * 6.0;
    let channel = |shift: f64| (((hue + shift) % 6.0 - 3.0).abs() - 1.0).clamp(0.0, 1.0);
    let lightness = if object.is_multiple_of(2) { 0.9 } else { 0.65 };
    (Color::new(channel(0.0), channel(4.0), channel(2.0)) * 0.75 + Color::splat(0.25)) * lightness
}

/// The number that this part of the numbers doesn't exceed; 0 of none.
fn percentile(mut numbers: Vec<f64>, part: f64) -> f64 {
    numbers.sort_unstable_by(f64::total_cmp);
    numbers.get((numbers.len().saturating_sub(1) as f64 * part) as usize).copied().unwrap_or(0.0)
}

impl Range {
    fn of(numbers: impl Iterator<Item = f64>) -> Range {
        let none = Range { least: f64::INFINITY, most: f64::NEG_INFINITY };
        let range = numbers.fold(none, |range, x| Range { least: range.least.min(x), most: range.most.max(x) });
        if range.least > range.most { Range { least: 0.0, most: 0.0 } } else { range }
    }

    /// Where a number lies between the ends, from 0 to 1.
    fn part(&self, number: f64) -> f64 {
        let size = self.most - self.least;
        if size > 0.0 { (number - self.least) / size } else { 0.0 }
    }
}

impl Map {
    fn new(width: u32) -> Map {
        Map { width: width.max(NARROWEST), colors: Vec::new() }
    }

    fn film(&self) -> Film {
        let height = self.colors.len() as u32 / self.width;
        let mut film = Film::new([0, 0, self.width, height]);
        film.put([0, 0, self.width, height], &self.colors);
        film
    }

    /// As the bytes of a PNG.
    fn encoded(&self) -> Result<Vec<u8>, export::EncodeError> {
        Ok(export::encode(&self.film(), export::Format::Png8, &scene::Output::default())?.bytes)
    }

    /// The rows of the layer; a narrow one has black beside it.
    fn picture(&mut self, layered: &Layered, color: impl Fn(&PixelFacts) -> Color) {
        self.pixels(layered.width(), layered.pixels().iter().map(color));
    }

    /// Rows of pixels of this width.
    fn pixels(&mut self, width: u32, colors: impl Iterator<Item = Color>) {
        for (color, column) in colors.zip((0..width).cycle()) {
            self.colors.push(color);
            if column + 1 == width {
                self.colors.extend((width..self.width).map(|_| Color::ZERO));
            }
        }
    }

    /// Empty rows; gives the place of the first pixel.
    fn rows(&mut self, count: u32) -> usize {
        let start = self.colors.len();
        self.colors.extend((0..count * self.width).map(|_| Color::ZERO));
        start
    }

    /// A line of text.
    fn text(&mut self, text: &str) {
        let start = self.rows(LINE);
        self.write(start, 2, text);
    }

    /// The scale with its ends.
    fn scale(&mut self, name: &str, range: Range) {
        let start = self.rows(LINE);
        for row in 2..LINE as usize {
            for column in 0..self.width as usize {
                let part = column as f64 / f64::from(self.width - 1);
                self.colors[start + row * self.width as usize + column] = inferno(part);
            }
        }
        let (least, most) = (shown(range.least), shown(range.most));
        let start = self.rows(LINE);
        self.write(start, 2, &least);
        self.write(start, (self.width.saturating_sub(name.len() as u32 * LETTER)) / 2, name);
        self.write(start, self.width.saturating_sub(most.len() as u32 * LETTER + 2), &most);
    }

    /// The objects that most pixels show, each with its colour.
    fn named(&mut self, layered: &Layered, objects: &[String]) {
        let mut pixels: BTreeMap<u32, u64> = BTreeMap::new();
        for object in layered.pixels().iter().filter_map(|seen| seen.object) {
            *pixels.entry(object).or_default() += 1;
        }
        let mut most: Vec<(u32, u64)> = pixels.into_iter().collect();
        most.sort_by_key(|(object, count)| (std::cmp::Reverse(*count), *object));
        for (object, count) in most.iter().take(MOST_NAMED) {
            let start = self.rows(LINE);
            for row in 2..2 + LETTER as usize {
                let first = start + row * self.width as usize + 2;
                self.colors[first..first + LETTER as usize].fill(color_of_object(*object));
            }
            let name = objects.get(*object as usize).map_or("", String::as_str);
            self.write(start, 4 + 2 * LETTER, &format!("{count} {name}"));
        }
        if most.len() > MOST_NAMED {
            self.text(&format!("and {} more", most.len() - MOST_NAMED));
        }
    }

    /// Letters in white; what has no letter is a question mark, what has no room is left out.
    fn write(&mut self, start: usize, left: u32, text: &str) {
        let letters = text.chars().map(|letter| {
            font8x8::BASIC_FONTS.get(letter).or_else(|| font8x8::LATIN_FONTS.get(letter)).unwrap_or_else(question_mark)
        });
        let room = (self.width.saturating_sub(left) / LETTER) as usize;
        for (letter, column) in letters.take(room).zip((left..).step_by(LETTER as usize)) {
            for (row, bits) in letter.into_iter().enumerate() {
                let first = start + (row + 2) * self.width as usize + column as usize;
                for bit in (0..LETTER as usize).filter(|bit| bits >> bit & 1 == 1) {
                    self.colors[first + bit] = Color::ONE;
                }
            }
        }
    }
}

fn question_mark() -> [u8; 8] {
    font8x8::BASIC_FONTS.get('?').unwrap_or([0xff; 8])
}

/// A number for a legend: few digits, and powers of ten where it is very large or small.
fn shown(x: f64) -> String {
    match x.abs() {
        0.0 => "0".to_owned(),
        size if x.fract() == 0.0 && size < 1e9 => format!("{x:.0}"),
        size if !(1e-3..1e6).contains(&size) => format!("{x:.2e}"),
        _ => format!("{x:.3}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_a_legend() {
        assert_eq!([0.0, 12.0, 0.5, 1e-7, 2.5e7].map(shown), ["0", "12", "0.500", "1.00e-7", "25000000"]);
    }

    #[test]
    fn a_scale_goes_from_the_least_to_the_most() {
        let range = Range::of([3.0, -1.0, 1.0].into_iter());
        assert_eq!([-1.0, 1.0, 3.0].map(|x| range.part(x)), [0.0, 0.5, 1.0]);
        assert_eq!(Range::of([2.0, 2.0].into_iter()).part(2.0), 0.0);
        assert_eq!(Range::of(std::iter::empty()), Range { least: 0.0, most: 0.0 });
    }

    #[test]
    fn a_percentile_passes_over_the_few() {
        assert_eq!(percentile((0..=1000).rev().map(f64::from).collect(), 0.995), 995.0);
        assert_eq!((percentile(vec![2.0], 0.995), percentile(Vec::new(), 0.995)), (2.0, 0.0));
    }

    #[test]
    fn neighbouring_objects_have_unlike_colours() {
        let distance = |a: u32, b: u32| (color_of_object(a) - color_of_object(b)).length();
        assert!((0..40).all(|object| distance(object, object + 1) > 0.3));
    }

    #[test]
    fn a_narrow_picture_has_room_for_its_legend() {
        let pixels = vec![PixelFacts { rays: 3, ..PixelFacts::default() }; 4];
        let layered = Layered::of([0, 0, 2, 2], pixels, Vec::new());
        let mut map = Map::new(layered.width());
        map.picture(&layered, |_| Color::ONE);
        map.scale("rays", Range { least: 0.0, most: 3.0 });
        let film = map.film();
        assert_eq!((film.width(), film.height()), (NARROWEST, 2 + 2 * LINE));
        assert_eq!(film.pixels()[..3], [Color::ONE, Color::ONE, Color::ZERO]);
        // The scale ends in its lightest colour, and something is written below it.
        assert_eq!(film.pixels()[(5 * NARROWEST - 1) as usize], inferno(1.0));
        assert!(film.pixels()[((2 + LINE) * NARROWEST) as usize..].contains(&Color::ONE));
    }
}
