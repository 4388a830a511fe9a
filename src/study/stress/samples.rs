//! A small sample of own cases, with answers that were computed to many digits.

use super::case::{Family, parse};
use serde_json::Value;

const SAMPLES: &str = include_str!("samples.json");

/// The sample, a family each.
pub fn samples() -> Result<Vec<Family>, String> {
    let families: Vec<Value> = serde_json::from_str(SAMPLES).map_err(|error| error.to_string())?;
    families.iter().map(|family| parse(family.to_string().as_bytes())).collect()
}
