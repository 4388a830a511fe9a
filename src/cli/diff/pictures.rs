//! Two pictures, pixel by pixel.

use super::{Diff, DiffFormat};
use crate::cli::failure::{Failure, shown};
use crate::cli::inputs::Inputs;
use crate::cli::output::{self, Output};
use raywalk::log::Value;
use raywalk::render::difference::{Difference, difference};
use raywalk::render::export::{Format, Picture};
use raywalk::report::number::size;
use serde_json::json;

impl Diff {
    /// Compares two pictures; `false` where they differ.
    pub(super) fn pictures(
        &self,
        (a_name, a): (&str, &Picture),
        (b_name, b): (&str, &Picture),
    ) -> Result<bool, Failure> {
        if a.is_float() != b.is_float() {
            let (float, integer) = if a.is_float() { (a_name, b_name) } else { (b_name, a_name) };
            return Err(Failure::caller(format!(
                "{float} holds the traced values and {integer} what is shown of them (clipped, and by its white and its \
                 transfer curve); expected two of a kind"
            )));
        }
        let [size_a, size_b] = [a, b].map(|picture| picture.size());
        if size_a != size_b {
            let text = match self.format {
                DiffFormat::Text => {
                    let [[aw, ah], [bw, bh]] = [size_a, size_b];
                    format!("different sizes: {a_name} has {aw} x {ah} pixels, {b_name} {bw} x {bh}\n")
                }
                DiffFormat::Json => format!("{}\n", json!({"same": false, "sizes": [size_a, size_b]})),
            };
            output::print(text.as_bytes())?;
            return Ok(false);
        }
        let tolerance = self.tolerance();
        let differs = |a: f64, b: f64| tolerance.tells_apart(&Value::Number(a), &Value::Number(b));
        let found = difference(a, b, differs);
        if let Some(path) = &self.output {
            self.heat_map(path, a, b, &found)?;
        }
        let text = match self.format {
            DiffFormat::Text => text(size_a, &found),
            DiffFormat::Json => json(size_a, &found),
        };
        output::print(text.as_bytes())?;
        Ok(found.differing == 0)
    }

    fn heat_map(&self, path: &std::path::Path, a: &Picture, b: &Picture, found: &Difference) -> Result<(), Failure> {
        let ending = path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
        if Format::of_ending(&ending, false) != Some(Format::Png8) {
            let path = shown(path);
            return Err(Failure::caller(format!("{path}: a heat map is a PNG, expected a name that ends in .png")));
        }
        let output = Output::create(Some(path), &Inputs::of([&self.a, &self.b]))?;
        let heat =
            found.heat_map(a, b).map_err(|error| Failure::machine(format!("cannot write the heat map: {error}")))?;
        output.commit(&heat)
    }
}

fn text([width, height]: [u32; 2], found: &Difference) -> String {
    let pixels = u64::from(width) * u64::from(height);
    let Difference { rmse, largest, differing } = found;
    let Some(largest) = largest else { return format!("the same: {pixels} pixels, none differs\n") };
    let [x, y] = largest.pixel;
    let percent = 100.0 * *differing as f64 / pixels as f64;
    format!(
        "pixels that differ   {differing} of {pixels} ({}%)\nRMSE                 {}\nlargest difference   {} in the {} of \
         pixel {x},{y}: {} against {}\n",
        size(percent),
        size(*rmse),
        size(largest.difference),
        ["red", "green", "blue"][largest.channel],
        largest.a,
        largest.b,
    )
}

fn json(size: [u32; 2], found: &Difference) -> String {
    let mut object = json!({
        "same": found.differing == 0,
        "size": size,
        "differing_pixels": found.differing,
        "rmse": found.rmse,
    });
    if let Some(largest) = &found.largest {
        object["largest"] = json!({
            "pixel": largest.pixel,
            "channel": largest.channel,
            "difference": largest.difference,
            "a": largest.a,
            "b": largest.b,
        });
    }
    format!("{object}\n")
}
