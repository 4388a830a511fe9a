//! Views of a log that was saved.

use super::{Subject, Trace, TraceFormat};
use crate::cli::failure::Failure;
use crate::cli::inputs::Inputs;
use crate::cli::options::TracingOptions;
use crate::cli::output::{self, Output};
use crate::cli::saved_log;
use raywalk::files::Opened;
use raywalk::log;

impl Trace {
    /// Writes a saved log in another format, or as another file.
    pub(super) fn of_log(&self, opened: Opened) -> Result<(), Failure> {
        let has_subject = self.region.is_some() || self.subject != Subject::default();
        if has_subject
            || self.shard.is_some()
            || self.causes
            || self.frames.is_some()
            || self.tracing != TracingOptions::default()
        {
            return Err(saved_log::is_traced_already(&opened));
        }
        let saved = saved_log::read(opened, &self.progress)?;
        self.check_format(matches!(saved.log.header.subject, log::Subject::Region(_)))?;
        let output = Output::create(self.output.as_deref(), &Inputs::of([&self.scene]))?;
        if let Some(warning) = saved.ending.warning() {
            output::tell(&format!("warning: {}: {warning}", saved.name));
        }
        if let Some(of) = self.view {
            return output.commit(&self.close_up(of, &saved.log)?);
        }
        output.commit(&self.view(None, &saved.log, self.format.unwrap_or(TraceFormat::Ndjson))?)
    }
}
