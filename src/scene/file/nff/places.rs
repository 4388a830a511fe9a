//! Where the parts of a scene are in the NFF text that it came from.

use std::ops::Range;

use super::records::{Records, View};
use super::tokens::Tokens;
use crate::files::{KeyPath, Problem, Source, Step};
use crate::scene::file::validate::Finding;

/// The offset of every entity.
pub struct Places {
    view: View,
    background: Option<u32>,
    lights: Vec<u32>,
    fills: Vec<u32>,
    objects: Vec<u32>,
}

impl Places {
    /// Those of these records.
    pub fn of(records: &Records) -> Self {
        Self {
            view: records.view,
            background: records.background.map(|(_, at)| at),
            lights: records.lights.iter().map(|light| light.at).collect(),
            fills: records.fills.iter().map(|fill| fill.at).collect(),
            objects: records.primitives.iter().map(|primitive| primitive.at).collect(),
        }
    }

    /// Each finding about the scene at its place in the text.
    pub fn place(&self, findings: &[Finding], source: &Source) -> Vec<Problem> {
        let problem = |finding: &Finding| {
            let span = self.span(&finding.path, source.text);
            source.problem(span, finding.path.clone(), finding.message.clone())
        };
        findings.iter().map(problem).collect()
    }

    /// The word of the entity that a path of the scene leads to; the beginning of the text where there is none.
    fn span(&self, path: &KeyPath, text: &[u8]) -> Range<usize> {
        let Some(at) = self.offset(path) else { return 0..0 };
        let at = at as usize;
        let length = Tokens::new(&text[at..]).next().map_or(0, |word| word.text.len());
        at..at + length
    }

    fn offset(&self, path: &KeyPath) -> Option<u32> {
        let (Step::Key(key), rest) = path.steps().split_first()? else { return None };
        match (&**key, rest.first()) {
            ("camera", Some(Step::Key(key))) => Some(match &**key {
                "look_at" => self.view.at.at,
                "up" => self.view.up.at,
                "vertical_fov" => self.view.angle.at,
                "resolution" => self.view.resolution.at,
                _ => self.view.from.at,
            }),
            ("background", _) => self.background,
            ("lights", Some(Step::Index(index))) => self.lights.get(*index).copied(),
            ("objects", Some(Step::Index(index))) => self.objects.get(*index).copied(),
            ("materials", Some(Step::Key(name))) => {
                let number: usize = name.strip_prefix("fill-")?.parse().ok()?;
                self.fills.get(number.checked_sub(1)?).copied()
            }
            _ => None,
        }
    }
}
