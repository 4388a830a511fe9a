//! The probe that sees nothing: fast rendering.

use super::Probe;

/// Sees nothing, alters nothing and costs nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl Probe for Silent {}
