//! Text from outside, made safe to print, as in logs.

pub use crate::log::escape::{escape_hidden, escape_hidden_json, escape_hidden_lines};
pub(super) use crate::log::escape::{hidden, is_hidden, look, shortened, width};
