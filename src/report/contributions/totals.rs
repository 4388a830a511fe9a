//! Contributions added up by what they have in common: the light, the object that it shines on, the kind of ray that sees the object.

use super::{Color, Contribution, Origin};
use crate::log::{RayKind, Tree};

/// What contributions have in common.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Common {
    /// The light with this number.
    Light(u32),
    /// Ambient light.
    Ambient,
    /// The object with this number.
    Object(u32),
    /// The last ray on the way from the eye, which isn't a shadow ray.
    Ray(RayKind),
    /// They come from no surface: the background, roundings, what isn't explained.
    Other(Origin),
}

/// The sum of all contributions with something in common.
#[derive(Clone, Debug, PartialEq)]
pub struct Total {
    /// What they have in common.
    pub of: Common,
    /// What they add to the pixel.
    pub color: Color,
    /// Their part of its colour.
    pub share: f64,
    /// The event of the greatest of them.
    pub event: Option<usize>,
}

/// A total per light, with those of ambient light and the background; the greatest first.
pub fn by_light(contributions: &[Contribution]) -> Vec<Total> {
    totals(contributions, |one| match one.origin {
        Origin::Light { light, .. } => Common::Light(light),
        Origin::Ambient { .. } => Common::Ambient,
        other => Common::Other(other),
    })
}

/// A total per object that light comes from on its way to the eye.
pub fn by_object(contributions: &[Contribution]) -> Vec<Total> {
    totals(contributions, |one| match one.origin {
        Origin::Light { object, .. } | Origin::Ambient { object } => Common::Object(object),
        other => Common::Other(other),
    })
}

/// A total per kind of the ray that hits the object, or the background.
pub fn by_ray(tree: &Tree, contributions: &[Contribution]) -> Vec<Total> {
    let is_seen_by = |kind: &RayKind| !matches!(kind, RayKind::Shadow { .. });
    totals(contributions, |one| {
        let ray = tree.around(one.way.node).filter_map(|node| tree.ray(node)).find(is_seen_by);
        ray.map_or(Common::Other(one.origin), Common::Ray)
    })
}

fn totals(contributions: &[Contribution], of: impl Fn(&Contribution) -> Common) -> Vec<Total> {
    let mut totals: Vec<Total> = Vec::new();
    // The greatest come first: the event is that of the first.
    for one in contributions {
        let common = of(one);
        match totals.iter_mut().find(|total| total.of == common) {
            Some(total) => {
                total.color = std::array::from_fn(|channel| total.color[channel] + one.color[channel]);
                total.share += one.share;
            }
            None => totals.push(Total { of: common, color: one.color, share: one.share, event: one.event }),
        }
    }
    totals.sort_by(|a, b| b.share.abs().total_cmp(&a.share.abs()));
    totals
}
