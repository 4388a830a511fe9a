//! Random points of the unit square in a log: a place in the pixel or on the lens, on a light, in a lobe.

use crate::log::Name;
use crate::probe::Probe;
use crate::random::{Pick, Stratum};

/// A random point of the unit square, with what it was made of.
pub fn place_in_square<P: Probe>(Pick { stratum, jitter }: Pick, probe: &mut P) -> [f64; 2] {
    if stratum == Stratum::WHOLE {
        probe.given(Name::SampleX, jitter[0]);
        probe.given(Name::SampleY, jitter[1]);
        return jitter;
    }
    let [x, y] = stratum.at(jitter);
    probe.given(Name::SampleColumn, f64::from(stratum.column));
    probe.given(Name::SampleJitterX, jitter[0]);
    probe.given(Name::SampleAcross, f64::from(stratum.across));
    let x = probe.note(Name::SampleX, x);
    probe.given(Name::SampleAbove, f64::from(stratum.above));
    probe.given(Name::SampleJitterY, jitter[1]);
    probe.given(Name::SampleCount, f64::from(stratum.count));
    let y = probe.note(Name::SampleY, y);
    [x, y]
}
