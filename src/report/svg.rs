//! What figures in SVG have in common.

use super::escape;

/// The beginning of a figure with its size, in so many decimals, and its title, on white.
pub(super) fn begin([width, height]: [f64; 2], decimals: usize, title: &str) -> String {
    let [width, height] = [width, height].map(|side| format!("{side:.decimals$}"));
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" \
         font-family=\"Helvetica, Arial, sans-serif\" font-size=\"12\" text-anchor=\"middle\" role=\"img\">\n\
         <title>{}</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
        escape::xml(title)
    )
}

/// A figure as a file of its own.
pub(super) fn file(figure: &str) -> String {
    format!("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{figure}")
}

/// A text around a place, in a white rim of this width that keeps it apart from lines behind it.
pub(super) fn label([x, y]: [f64; 2], attributes: &str, rim: u32, text: &str) -> String {
    format!(
        "<text x=\"{x:.1}\" y=\"{:.1}\" {attributes} paint-order=\"stroke\" stroke=\"#ffffff\" stroke-width=\"{rim}\">{}</text>\n",
        y + 4.0,
        escape::xml(text)
    )
}

/// The corners of a line or an area.
pub(super) fn points(places: &[[f64; 2]], decimals: usize) -> String {
    let places = places.iter().map(|[x, y]| format!("{x:.decimals$},{y:.decimals$}"));
    places.collect::<Vec<_>>().join(" ")
}
