//! The options that say how values are shown in a picture's integer formats. They override what the scene says.

use clap::Args;
use raywalk::scene::file::validate::limits::MAX_EXPOSURE;
use raywalk::scene::{Output, Transfer};

/// How values become the numbers of a picture.
#[derive(Args, Debug, Default, Clone, Copy, PartialEq)]
#[command(next_help_heading = "Levels")]
pub struct ShownOptions {
    /// Exposure in stops: multiplies values by 2 to this power before white and the transfer curve. It changes what integer
    /// formats show, and nothing that is traced
    #[arg(long, value_name = "STOPS", value_parser = exposure, allow_hyphen_values = true)]
    pub exposure: Option<f64>,
    /// The value shown as full white. The thresholds and tolerances of adaptive, statistical and guided sampling are fractions of it
    #[arg(long, value_name = "VALUE", value_parser = white, allow_hyphen_values = true)]
    pub white: Option<f64>,
    /// The transfer curve from values to levels
    #[arg(long, value_enum, value_name = "CURVE")]
    pub transfer: Option<Transfer>,
}

impl ShownOptions {
    /// What a scene says, with them.
    pub fn over(&self, output: Output) -> Output {
        Output {
            exposure: self.exposure.unwrap_or(output.exposure),
            white: self.white.unwrap_or(output.white),
            transfer: self.transfer.unwrap_or(output.transfer),
        }
    }

    /// The options that were given, by their names.
    pub fn given(&self) -> Vec<&'static str> {
        let options = [
            ("--exposure", self.exposure.is_some()),
            ("--white", self.white.is_some()),
            ("--transfer", self.transfer.is_some()),
        ];
        options.into_iter().filter_map(|(option, is_given)| is_given.then_some(option)).collect()
    }
}

fn exposure(text: &str) -> Result<f64, String> {
    let stops = text.parse().ok().filter(|stops: &f64| stops.abs() <= MAX_EXPOSURE);
    stops.ok_or_else(|| format!("expected stops from -{MAX_EXPOSURE} to {MAX_EXPOSURE}, found `{text}`"))
}

fn white(text: &str) -> Result<f64, String> {
    let white = text.parse().ok().filter(|white: &f64| white.is_finite() && *white > 0.0);
    white.ok_or_else(|| format!("expected a number above 0, found `{text}`"))
}
