//! Which rays make a pixel: the choice. What each method does is in `sampling`.

use crate::log::Parameter;
use crate::scene::file::validate::limits::MIN_GUIDED;
use std::fmt;

/// The methods.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sampling {
    /// One ray through the pixel's centre.
    Center,
    /// Rays through the centres of n × n cells.
    Regular {
        /// Cells a side, 1 or more.
        n: u32,
    },
    /// Rays through the corners of n × n cells, which neighbours share.
    Shared {
        /// Cells a side, 1 or more.
        n: u32,
    },
    /// Rays through the corners of cells that are cut in four where it matters.
    Adaptive {
        /// The difference between corners that cuts a cell, as a part of white.
        threshold: f64,
        /// How often a side may be halved.
        depth: u32,
    },
    /// A jittered ray in each of n strata.
    Stochastic {
        /// Rays a pixel.
        n: u32,
    },
    /// Rays anywhere.
    Random {
        /// Rays a pixel.
        n: u32,
    },
    /// Rays through scrambled points of Sobol's sequence.
    Sobol {
        /// Rays a pixel.
        n: u32,
    },
    /// As many of those as tell the mean well enough.
    Statistical(Statistical),
    /// As many of those as the first of them, in the pixel and around it, ask for.
    Guided(Guided),
}

/// How the first samples of a neighbourhood say how many a pixel takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Guided {
    /// The error of a sample for which one would be enough, as a part of white.
    pub tolerance: f64,
    /// The fewest samples, which are the pilot.
    pub min: u32,
    /// The most samples.
    pub max: u32,
}

impl Guided {
    /// How many samples the pilot has: a power of two where there may be this many, and so many that they have a variance.
    pub fn pilot(self) -> u32 {
        self.min.max(MIN_GUIDED as u32).next_power_of_two().min(self.max)
    }

    /// How many samples a pixel takes when `asked` are requested: a power of two where there may be this many.
    pub fn samples(self, asked: f64) -> u32 {
        // What is no number, or more than there may be, is as much as there may be.
        let asked = if asked <= f64::from(self.max) { asked.ceil() as u32 } else { self.max };
        asked.next_power_of_two().min(self.max).max(self.pilot())
    }
}

/// When the mean of samples is known well enough.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Statistical {
    /// The probability with which the mean's interval is to hold the pixel's colour.
    pub confidence: f64,
    /// Half the interval's width in each channel at most, as a part of white.
    pub tolerance: f64,
    /// The fewest samples.
    pub min: u32,
    /// The most samples.
    pub max: u32,
}

impl Sampling {
    /// The word of the method, as a scene file has it.
    pub fn word(self) -> &'static str {
        match self {
            Sampling::Center => "none",
            Sampling::Regular { .. } => "regular",
            Sampling::Shared { .. } => "shared",
            Sampling::Adaptive { .. } => "adaptive",
            Sampling::Stochastic { .. } => "stochastic",
            Sampling::Random { .. } => "random",
            Sampling::Sobol { .. } => "sobol",
            Sampling::Statistical(_) => "statistical",
            Sampling::Guided(_) => "guided",
        }
    }

    /// Whether its samples have the same places in every pixel and with every seed, so that pictures with other seeds don't tell how far
    /// it is off.
    pub fn has_fixed_places(self) -> bool {
        matches!(
            self,
            Sampling::Center | Sampling::Regular { .. } | Sampling::Shared { .. } | Sampling::Adaptive { .. }
        )
    }

    /// The most that a sample counts for over all pixels; 1 is a whole pixel.
    pub fn largest_share(self) -> f64 {
        let one_of = |count: u32| 1.0 / f64::from(count.max(1));
        match self {
            // A corner of an uncut cell has a quarter of each of the four pixels that meet there.
            Sampling::Center | Sampling::Adaptive { .. } => 1.0,
            Sampling::Regular { n } | Sampling::Shared { n } => one_of(n) * one_of(n),
            Sampling::Stochastic { n } | Sampling::Random { n } | Sampling::Sobol { n } => one_of(n),
            Sampling::Statistical(Statistical { min, max, .. }) => one_of(min.min(max)),
            Sampling::Guided(guided) => one_of(guided.pilot()),
        }
    }

    /// Its parameters by name.
    pub fn parameters(self) -> Vec<(&'static str, Parameter)> {
        let count = |n: u32| Parameter(n.into());
        match self {
            Sampling::Center => Vec::new(),
            Sampling::Regular { n }
            | Sampling::Shared { n }
            | Sampling::Stochastic { n }
            | Sampling::Random { n }
            | Sampling::Sobol { n } => vec![("n", count(n))],
            Sampling::Adaptive { threshold, depth } => {
                vec![("threshold", Parameter(threshold)), ("depth", count(depth))]
            }
            Sampling::Statistical(Statistical { confidence, tolerance, min, max }) => vec![
                ("confidence", Parameter(confidence)),
                ("tolerance", Parameter(tolerance)),
                ("min", count(min)),
                ("max", count(max)),
            ],
            Sampling::Guided(Guided { tolerance, min, max }) => {
                vec![("tolerance", Parameter(tolerance)), ("min", count(min)), ("max", count(max))]
            }
        }
    }
}

/// As `--sampling` has it.
impl fmt::Display for Sampling {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let parameters = self.parameters();
        match parameters[..] {
            [] => f.write_str(self.word()),
            [("n", n)] => write!(f, "{}:{n}", self.word()),
            _ => {
                let parameters: Vec<_> = parameters.iter().map(|(name, value)| format!("{name}={value}")).collect();
                write!(f, "{}:{}", self.word(), parameters.join(","))
            }
        }
    }
}
