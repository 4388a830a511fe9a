//! The ray of a bounce, followed one level deeper.

use super::layer_stack::LayerStack;
use super::one_light::give_ray;
use super::{Media, Meeting, Path, Via, radiance};
use crate::geometry::{Leaving, Ray};
use crate::log::{RayKind, Step};
use crate::probe::Probe;
use crate::scene::{Color, Scene};
use glam::DVec3;

/// A bounce, whatever its direction.
pub(super) struct Bounce<'a> {
    pub kind: RayKind,
    pub leaving: Leaving,
    pub weight: Color,
    /// The media that the ray will be inside.
    pub media: &'a Media,
    /// The surfaces at the ray's origin, if it has still to cross some of them.
    pub place: Option<&'a LayerStack>,
}

impl Bounce<'_> {
    /// The colour that the ray in this direction, one level deeper, brings; of several the one with this number from 1.
    // Each kind of bounce is followed at one or two places.
    #[inline(always)]
    pub fn follow<P: Probe>(
        &self,
        scene: &Scene,
        meeting: &Meeting,
        direction: DVec3,
        split: u32,
        probe: &mut P,
    ) -> Color {
        let (level, weight) = (meeting.path.level + 1, meeting.path.weight * self.weight);
        let is_transmitted = self.kind == RayKind::Transmitted;
        let via = Via { path: meeting.path, is_transmitted, split, weight: self.weight };
        let draws = meeting.path.draws;
        let path = Path { level, media: self.media, weight, draws, via: Some(via), place: self.place };
        let ray = Ray {
            leaving: Some(self.leaving),
            slack: meeting.slack,
            time: meeting.ray.time,
            ..Ray::new(meeting.surface.point, direction)
        };
        give_ray(&ray, probe);
        let step = Step::Ray { kind: self.kind, depth: level, split };
        probe.within(step, |probe| radiance(scene, &ray, &path, probe)).color
    }
}
