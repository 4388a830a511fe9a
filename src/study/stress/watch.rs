//! The probe that the rows of the table are read from.

use crate::log::{Name, RayKind, Step, Value};
use crate::probe::{Probe, Quantity};
use std::collections::HashMap;

/// Remembers the latest value of every quantity, and counts transmitted rays.
#[derive(Clone, Debug, Default)]
pub(super) struct Watch {
    latest: HashMap<&'static str, Value>,
    /// How many transmitted rays there were.
    pub transmitted_rays: u64,
}

impl Watch {
    /// The latest number noted under this name's key.
    pub fn number(&self, name: Name) -> Option<f64> {
        self.latest.get(name.key()).and_then(|value| value.components().first().copied())
    }

    /// The latest triple noted under this name's key.
    pub fn triple(&self, name: Name) -> Option<[f64; 3]> {
        self.latest.get(name.key()).and_then(|value| value.components().try_into().ok())
    }
}

impl Probe for Watch {
    fn note<Q: Quantity>(&mut self, name: Name, value: Q) -> Q {
        self.latest.insert(name.key(), value.value());
        value
    }

    fn enter(&mut self, step: Step) {
        if let Step::Ray { kind: RayKind::Transmitted, .. } = step {
            self.transmitted_rays += 1;
        }
    }
}
