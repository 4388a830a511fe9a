//! Text from outside, made safe to print, as in logs.

pub(super) use crate::log::escape::{hidden, is_hidden, look, shortened, width};
pub use crate::log::escape::{visible, visible_json, visible_lines};
