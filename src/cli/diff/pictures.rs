//! Two pictures, pixel by pixel.

use super::Diff;
use crate::cli::failure::{Failure, shown};
use crate::cli::inputs::Inputs;
use crate::cli::options::ReportFormat;
use crate::cli::output::{self, Output};
use raywalk::files::{escape_hidden, escape_hidden_json};
use raywalk::log::Value;
use raywalk::render::difference::{Difference, LargestOfLayer, LayerDifference, LayerDifferences, difference};
use raywalk::render::export::{Beside, Format, Picture};
use raywalk::report::number::size;
use serde_json::json;

impl Diff {
    /// Compares two pictures; `false` where they differ.
    pub(super) fn pictures(
        &self,
        (a_name, a, a_layers): (&str, &Picture, &[Beside]),
        (b_name, b, b_layers): (&str, &Picture, &[Beside]),
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
                ReportFormat::Text => {
                    let [[aw, ah], [bw, bh]] = [size_a, size_b];
                    format!("different sizes: {a_name} has {aw} x {ah} pixels, {b_name} {bw} x {bh}\n")
                }
                ReportFormat::Json => format!("{}\n", json!({"same": false, "sizes": [size_a, size_b]})),
            };
            output::print(text.as_bytes())?;
            return Ok(false);
        }
        let tolerance = self.tolerance();
        let differs = |a: f64, b: f64| tolerance.tells_apart(&Value::Number(a), &Value::Number(b));
        let (found, layers) = (difference(a, b, differs), LayerDifferences::of(a_layers, b_layers, differs));
        if let Some(path) = &self.output {
            self.heat_map(path, a, b, &found)?;
        }
        let text = match self.format {
            ReportFormat::Text => text(size_a, &found, &layers) + &text_of_layers(&layers, [a_name, b_name]),
            ReportFormat::Json => json(size_a, &found, &layers),
        };
        output::print(text.as_bytes())?;
        Ok(found.differing == 0 && layers.is_same())
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

fn text([width, height]: [u32; 2], found: &Difference, layers: &LayerDifferences) -> String {
    let pixels = u64::from(width) * u64::from(height);
    let Difference { rmse, largest, differing } = found;
    let Some(largest) = largest else {
        let what = if layers.is_empty() { "the same" } else { "colours: the same" };
        return format!("{what}: {pixels} pixels, none differs\n");
    };
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

/// A line a layer; nothing where there are none.
fn text_of_layers(layers: &LayerDifferences, names: [&str; 2]) -> String {
    let of_both = layers.of_both.iter().map(|LayerDifference { name, pixels, differing, largest }| {
        let name = escape_hidden(name);
        let Some(LargestOfLayer { pixel: [x, y], channel, difference, a, b }) = largest else {
            return format!("layer {name}: the same\n");
        };
        let percent = size(100.0 * *differing as f64 / *pixels as f64);
        let channel = escape_hidden(channel);
        format!(
            "layer {name}: {differing} of {pixels} pixels differ ({percent}%), the largest difference is {} in the channel \
             {channel} of pixel {x},{y}: {a} against {b}\n",
            size(*difference)
        )
    });
    let alone = [&layers.only_in_a, &layers.only_in_b].into_iter().zip(names);
    let alone = alone.flat_map(|(layers, file)| {
        layers.iter().map(move |layer| format!("layer {}: is only in {file}\n", escape_hidden(layer)))
    });
    of_both.chain(alone).collect()
}

fn json(size: [u32; 2], found: &Difference, layers: &LayerDifferences) -> String {
    let mut object = json!({
        "same": found.differing == 0 && layers.is_same(),
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
    if !layers.is_empty() {
        object["layers"] = layers.of_both.iter().map(json_of_layer).collect();
        object["layers_only_in_a"] = json!(layers.only_in_a);
        object["layers_only_in_b"] = json!(layers.only_in_b);
    }
    escape_hidden_json(&format!("{object}\n")).into_owned()
}

fn json_of_layer(layer: &LayerDifference) -> serde_json::Value {
    let mut object = json!({ "name": layer.name, "differing_pixels": layer.differing });
    if let Some(LargestOfLayer { pixel, channel, difference, a, b }) = &layer.largest {
        object["largest"] = json!({ "pixel": pixel, "channel": channel, "difference": difference, "a": a, "b": b });
    }
    object
}
