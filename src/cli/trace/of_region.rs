//! The log of a region.

use super::{Trace, TraceFormat, not_printed, too_long};
use crate::cli::failure::Failure;
use crate::cli::inputs::Inputs;
use crate::cli::options::{region_in, warning_of_sampling};
use crate::cli::output::{self, Output};
use crate::cli::region::Traced;
use crate::cli::saved_log;
use raywalk::files::escape_hidden;
use raywalk::log::{Header, Log, Subject};
use raywalk::probe::CutOff;
use raywalk::record::{self, Arithmetic, MAX_EVENTS};
use raywalk::report::lines;
use raywalk::report::segments::Segment;
use raywalk::scene::Scene;
use raywalk::threads::Threads;
use std::io;

impl Trace {
    /// The log of a region: in NDJSON as it grows, otherwise of at most as many events as memory holds.
    pub(super) fn of_region(&self, scene: &Scene, region: [u32; 4], inputs: &Inputs) -> Result<(), Failure> {
        let arithmetic = self.tracing.arithmetic();
        let region = region_in(scene, "--region", region)?;
        if self.causes {
            return Err(Failure::caller("--causes: expected --pixel or --ray, found --region"));
        }
        if arithmetic == Arithmetic::Printed {
            return Err(not_printed());
        }
        let traced = Traced { scene, region, arithmetic, shard: self.shard };
        if let (Some(path), Some(_)) = (&self.output, self.shard)
            && saved_log::is_whole(path, &traced.header())
        {
            if !self.progress.quiet {
                output::tell(&format!(
                    "note: {}: exists already and is complete",
                    escape_hidden(&path.to_string_lossy())
                ));
            }
            output::sweep_around(path);
            return Ok(());
        }
        let output = Output::create(self.output.as_deref(), inputs)?;
        if let (false, Some(warning)) = (self.progress.quiet, warning_of_sampling(scene)) {
            output::tell(&format!("warning: {}: {warning}", escape_hidden(&self.scene.to_string_lossy())));
        }
        if let Some(write) = self.format.and_then(TraceFormat::lines) {
            let header = record::header(scene, Subject::Region(region), arithmetic);
            return output.commit(write(&header, &self.rays_of(scene, &header, region)?).as_bytes());
        }
        if let Some(format) = self.format.filter(|format| *format != TraceFormat::Ndjson) {
            let log = record::region::bounded(scene, region, arithmetic).map_err(|why| too_long(why, arithmetic))?;
            return output.commit(&self.view(Some(scene), &log, format)?);
        }
        let count = traced.pixels().count();
        let threads = Threads::of(self.tracing.threads.into(), count);
        let progress = self.progress.start(count as u64);
        let written = output.stream(|out| traced.write(&threads, out, || progress.advance(1)));
        progress.finish();
        written
    }

    /// The rays of a region as lines in space; of each pixel's log only they are kept.
    fn rays_of(&self, scene: &Scene, header: &Header, region: [u32; 4]) -> Result<Vec<Segment>, Failure> {
        let arithmetic = self.tracing.arithmetic();
        let threads = Threads::of(self.tracing.threads.into(), record::region::pixels(region).count());
        let make = |pixel| {
            let events = record::region::of_pixel(scene, pixel, arithmetic, MAX_EVENTS)?;
            Ok(lines::rays(&Log { header: header.clone(), events }))
        };
        let mut rays = Vec::new();
        let mut cut_off = None;
        let kept = record::region::in_order(
            record::region::pixels(region),
            &threads,
            make,
            |_, made: Result<Vec<_>, CutOff>| match made {
                Ok(made) => {
                    rays.extend(made);
                    Ok(())
                }
                Err(why) => {
                    cut_off = Some(why);
                    Err(io::ErrorKind::Other.into())
                }
            },
        );
        match (cut_off, kept) {
            (Some(why), _) => Err(too_long(why, arithmetic)),
            (None, Err(error)) => Err(Failure::machine(error.to_string())),
            (None, Ok(())) => Ok(rays),
        }
    }
}
