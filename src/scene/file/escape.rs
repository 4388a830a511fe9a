//! Text from outside, made safe to print, as in logs.

pub use crate::log::escape::visible;
pub(super) use crate::log::escape::{hidden, is_hidden, shortened, width};
