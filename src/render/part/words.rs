//! Pixels as words of 64 bits.

use super::Content;
use crate::render::layers::{Layered, PixelFacts};
use crate::render::{Canvas, Film};
use crate::scene::Color;

/// The words of a colour.
const OF_COLOR: usize = 3;

/// The words of a pixel with what it costs and sees.
const FACTS: usize = 14;

/// No object: a number that none has.
const NONE: u64 = u64::MAX;

/// The words of a pixel.
pub fn count(content: &Content) -> usize {
    match content {
        Content::Colors | Content::Digits { .. } => OF_COLOR,
        Content::Layers { .. } => FACTS + content.numbers(),
    }
}

/// Pixels as bytes.
pub fn to_bytes(pixels: &Canvas) -> Vec<u8> {
    match pixels {
        Canvas::Colors(film) | Canvas::Digits(film) => {
            film.pixels().iter().flat_map(|color| bytes(&of_color(*color))).collect()
        }
        Canvas::Layers(film) => {
            let of_pixel = |(at, seen)| {
                let numbers = film.numbers(at).iter().map(|number| number.to_bits());
                bytes(&words_of_facts(seen).into_iter().chain(numbers).collect::<Vec<_>>())
            };
            film.pixels().iter().enumerate().flat_map(of_pixel).collect()
        }
    }
}

/// A piece of a part with this content from bytes, whose number is right.
pub fn from_bytes(content: &Content, area: [u32; 4], bytes: &[u8]) -> Canvas {
    let (words, _) = bytes.as_chunks::<8>();
    let words: Vec<u64> = words.iter().map(|word| u64::from_le_bytes(*word)).collect();
    let colors = || Film::of(area, words.as_chunks::<OF_COLOR>().0.iter().map(|words| color(*words)).collect());
    match content {
        Content::Colors => Canvas::Colors(colors()),
        Content::Digits { .. } => Canvas::Digits(colors()),
        Content::Layers { .. } => {
            let pixels = words.chunks_exact(count(content)).filter_map(<[u64]>::split_first_chunk);
            let (facts, numbers): (Vec<_>, Vec<_>) = pixels.map(|(facts, numbers)| (seen(facts), numbers)).unzip();
            let numbers = numbers.concat().into_iter().map(f64::from_bits).collect();
            Canvas::Layers(Layered::of(area, facts, numbers))
        }
    }
}

fn bytes(words: &[u64]) -> Vec<u8> {
    words.iter().flat_map(|word| word.to_le_bytes()).collect()
}

fn of_color(color: Color) -> [u64; OF_COLOR] {
    color.to_array().map(f64::to_bits)
}

fn color(words: [u64; OF_COLOR]) -> Color {
    Color::from(words.map(f64::from_bits))
}

/// What isn't known isn't a number.
fn of_option(known: Option<f64>) -> u64 {
    known.unwrap_or(f64::NAN).to_bits()
}

fn option(word: u64) -> Option<f64> {
    Some(f64::from_bits(word)).filter(|known| !known.is_nan())
}

fn words_of_facts(seen: &PixelFacts) -> [u64; FACTS] {
    let [red, green, blue] = of_color(seen.color);
    let [x, y, z] = of_color(seen.normal);
    [
        red,
        green,
        blue,
        seen.rays,
        seen.primitive_tests,
        seen.bounds_tests,
        of_option(seen.depth),
        x,
        y,
        z,
        seen.object.map_or(NONE, u64::from),
        seen.samples,
        of_option(seen.error),
        seen.seconds.to_bits(),
    ]
}

fn seen(words: &[u64; FACTS]) -> PixelFacts {
    let [red, green, blue, rays, primitive_tests, bounds_tests, depth, x, y, z, object, samples, error, seconds] =
        *words;
    PixelFacts {
        color: color([red, green, blue]),
        rays,
        primitive_tests,
        bounds_tests,
        depth: option(depth),
        normal: color([x, y, z]),
        object: u32::try_from(object).ok(),
        samples,
        error: option(error),
        seconds: f64::from_bits(seconds),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_come_back_bit_for_bit() {
        let color = Color::new(-0.0, 5e-324, 1e300);
        let area = [5, 6, 7, 7];
        let colors = Canvas::Colors(Film::of(area, vec![color, Color::ONE]));
        assert_eq!(from_bytes(&Content::Colors, area, &to_bytes(&colors)), colors);
        let seen = PixelFacts {
            color,
            rays: u64::MAX,
            primitive_tests: 2,
            bounds_tests: 3,
            depth: Some(0.1),
            ..PixelFacts::default()
        };
        let other = PixelFacts { object: Some(u32::MAX), error: Some(0.0), seconds: 1e-9, samples: 7, ..seen };
        let area = [0, 0, 1, 3];
        let layers = Canvas::Layers(Layered::of(area, vec![seen, other, PixelFacts::default()], vec![1.5, -0.0, 2.0]));
        let names = ["depth", "value:shade.n_dot_l@C R"].map(str::to_owned).to_vec();
        let content = Content::Layers { names, objects: Vec::new() };
        let bytes = to_bytes(&layers);
        assert_eq!(bytes.len(), 3 * 8 * count(&content));
        assert_eq!(from_bytes(&content, area, &bytes), layers);
    }
}
