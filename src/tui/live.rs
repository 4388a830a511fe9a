//! What the viewer can ask of a scene that is traced while one looks. A saved log has nobody to ask.

use super::drawing::Drawing;
use super::picture::Image;
use crate::log::{Log, Subject};
use std::sync::Arc;

/// Somebody who traces the scene that the viewer shows.
pub trait Live {
    /// The log of another pixel, in the viewer's arithmetic; what to say if there is none.
    fn trace(&mut self, pixel: [u32; 2]) -> Result<Log, String>;

    /// The picture as far as it is there, if there is more of it than when it was asked for last; `whole` waits for all of it.
    fn picture(&mut self, _whole: bool) -> Option<Arc<Image>> {
        None
    }

    /// The scene as lines.
    fn drawing(&mut self) -> Option<Arc<Drawing>> {
        None
    }

    /// The logs of the same pixel or ray in other arithmetics: by hand, in single precision, in f64 with the digits that can
    /// be trusted.
    fn compare(&mut self, subject: Subject) -> Result<Vec<Log>, String>;
}
