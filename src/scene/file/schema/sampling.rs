//! The key `sampling`: which rays make a pixel. What each method does is in `sampling`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::fmt;

use crate::scene::file::validate::limits::{MAX_ADAPTIVE_DEPTH, MAX_GRID, MAX_SAMPLES, MIN_GUIDED, MIN_STATISTICAL};

/// How each method is written in one word, as `--sampling` has it, and what it does. C and T stand for any numbers, the others for whole ones.
pub const FORMS: &[(&str, &str)] = &[
    ("none", "one through its centre"),
    ("regular:N", "N x N cell centres"),
    ("shared:N", "the corners of N x N cells, which neighbours share"),
    ("adaptive:threshold=T,depth=D", "cells cut where corners differ by more than T of white"),
    ("stochastic:N", "N jittered"),
    ("random:N", "N anywhere"),
    ("sobol:N", "N scrambled Sobol points"),
    ("statistical:confidence=C,tolerance=T,min=M,max=N", "until the mean is within T of white"),
    ("guided:tolerance=T,min=M,max=N", "as many as the first M of the pixels around call for"),
];

/// Which rays make a pixel.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Sampling {
    /// One ray through the pixel's centre.
    #[serde(rename = "none")]
    Center {},
    /// n × n cell centres.
    Regular {
        /// Cells a side.
        #[schemars(range(min = 1, max = MAX_GRID))]
        n: u32,
    },
    /// Corners of n × n cells, shared with the neighbours.
    Shared {
        /// Cells a side.
        #[schemars(range(min = 1, max = MAX_GRID))]
        n: u32,
    },
    /// Cells split where their corners differ.
    Adaptive {
        /// The difference that splits, as a fraction of `output.white`.
        #[schemars(range(min = 0))]
        threshold: f64,
        /// How often a cell may be halved.
        #[schemars(range(max = MAX_ADAPTIVE_DEPTH))]
        depth: u32,
    },
    /// n in all, jittered in near-square strata.
    Stochastic {
        /// Rays a pixel.
        #[schemars(range(min = 1, max = MAX_SAMPLES))]
        n: u32,
    },
    /// n uniform points.
    Random {
        /// Rays a pixel.
        #[schemars(range(min = 1, max = MAX_SAMPLES))]
        n: u32,
    },
    /// n Owen-scrambled Sobol points.
    Sobol {
        /// Rays a pixel.
        #[schemars(range(min = 1, max = MAX_SAMPLES))]
        n: u32,
    },
    /// As many as the wanted quality needs.
    Statistical(Statistical),
    /// As many as a pilot in the pixel and around it asks for.
    Guided(Guided),
}

/// When the mean of samples is known well enough.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(inline)]
pub struct Statistical {
    /// Confidence of the interval, between 0 and 1.
    #[schemars(extend("exclusiveMinimum" = 0, "exclusiveMaximum" = 1))]
    pub confidence: f64,
    /// Half-width of the interval, as a fraction of `output.white`.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub tolerance: f64,
    /// Fewest rays per pixel.
    #[schemars(range(min = 1, max = MAX_SAMPLES))]
    pub min: u32,
    /// Most rays per pixel.
    #[schemars(range(min = MIN_STATISTICAL, max = MAX_SAMPLES))]
    pub max: u32,
}

/// How the first samples of a neighbourhood say how many a pixel takes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
#[schemars(inline)]
pub struct Guided {
    /// The error of a sample for which one would be enough, as a fraction of `output.white`.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub tolerance: f64,
    /// Fewest rays per pixel, the pilot; rounded up to a power of two, and to 2.
    #[schemars(range(min = 1, max = MAX_SAMPLES))]
    pub min: u32,
    /// Most rays per pixel.
    #[schemars(range(min = MIN_GUIDED, max = MAX_SAMPLES))]
    pub max: u32,
}

impl Default for Guided {
    fn default() -> Self {
        Self { tolerance: 0.002, min: 4, max: 4096 }
    }
}

impl Guided {
    /// How many samples the pilot has: a power of two where there may be this many, and so many that they have a variance.
    pub fn pilot(self) -> u32 {
        self.min.max(MIN_GUIDED).next_power_of_two().min(self.max)
    }

    /// How many samples a pixel takes when `asked` are requested: a power of two where there may be this many.
    pub fn samples(self, asked: f64) -> u32 {
        // What is no number, or more than there may be, is as much as there may be.
        let asked = if asked <= f64::from(self.max) { asked.ceil() as u32 } else { self.max };
        asked.next_power_of_two().min(self.max).max(self.pilot())
    }
}

impl Default for Sampling {
    fn default() -> Self {
        Self::Center {}
    }
}

impl Sampling {
    /// The key of the method, and its parameters by name.
    pub fn parts(self) -> (&'static str, Vec<(&'static str, f64)>) {
        let n_of = |n: u32| vec![("n", f64::from(n))];
        match self {
            Sampling::Center {} => ("none", Vec::new()),
            Sampling::Regular { n } => ("regular", n_of(n)),
            Sampling::Shared { n } => ("shared", n_of(n)),
            Sampling::Adaptive { threshold, depth } => {
                ("adaptive", vec![("threshold", threshold), ("depth", depth.into())])
            }
            Sampling::Stochastic { n } => ("stochastic", n_of(n)),
            Sampling::Random { n } => ("random", n_of(n)),
            Sampling::Sobol { n } => ("sobol", n_of(n)),
            Sampling::Statistical(Statistical { confidence, tolerance, min, max }) => {
                let parameters = [("confidence", confidence), ("tolerance", tolerance)];
                ("statistical", [parameters, [("min", min.into()), ("max", max.into())]].concat())
            }
            Sampling::Guided(Guided { tolerance, min, max }) => {
                ("guided", vec![("tolerance", tolerance), ("min", min.into()), ("max", max.into())])
            }
        }
    }

    /// The key of the method.
    pub fn key(self) -> &'static str {
        self.parts().0
    }

    /// Whether its samples have the same places in every pixel and with every seed, so that pictures with other seeds don't tell how far
    /// it is off.
    pub fn has_fixed_places(self) -> bool {
        matches!(
            self,
            Sampling::Center {} | Sampling::Regular { .. } | Sampling::Shared { .. } | Sampling::Adaptive { .. }
        )
    }

    /// The largest part of the picture that one sample makes up, in pixels: 1 where a pixel has a single one.
    pub fn largest_share(self) -> f64 {
        let one_of = |count: u32| 1.0 / f64::from(count.max(1));
        match self {
            // A corner of an uncut cell has a quarter of each of the four pixels that meet there.
            Sampling::Center {} | Sampling::Adaptive { .. } => 1.0,
            Sampling::Regular { n } | Sampling::Shared { n } => one_of(n) * one_of(n),
            Sampling::Stochastic { n } | Sampling::Random { n } | Sampling::Sobol { n } => one_of(n),
            Sampling::Statistical(Statistical { min, max, .. }) => one_of(min.min(max)),
            Sampling::Guided(guided) => one_of(guided.pilot()),
        }
    }
}

/// As `--sampling` has it.
impl fmt::Display for Sampling {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let (key, parameters) = self.parts();
        match parameters[..] {
            [] => f.write_str(key),
            [("n", n)] => write!(f, "{key}:{n}"),
            _ => {
                let parameters: Vec<_> = parameters.iter().map(|(name, value)| format!("{name}={value}")).collect();
                write!(f, "{key}:{}", parameters.join(","))
            }
        }
    }
}
