//! A thin lens: what isn't at its distance of focus is blurred (Ramos, section 1.5; Potmesil and Chakravarty, "A lens and aperture
//! camera model for synthetic image generation", 1981; Cook, Porter and Carpenter, "Distributed ray tracing", 1984).

use super::aim::along;
use super::square::place_in_square;
use crate::geometry::Ray;
use crate::log::Name;
use crate::probe::Probe;
use crate::random::{Dimension, Draws, warp};
use glam::DVec3;

pub use super::file::schema::Lens;

/// All rays of a place of the picture meet where the pinhole's ray meets the plane in focus. A point at the depth z makes a disc with
/// the radius r·|z − f|/z in that plane.
impl Lens {
    /// The ray of a sample through the place of the picture that the vector leads to from the eye; `length` is that of the direction of view.
    // Kept out of the pinhole's way.
    #[inline(never)]
    pub(super) fn ray<P: Probe>(
        &self,
        eye: DVec3,
        (length, [right, up], vector): (f64, [DVec3; 2], DVec3),
        draws: &Draws,
        probe: &mut P,
    ) -> Option<Ray> {
        probe.given(Name::CameraPosition, eye);
        probe.given(Name::LensFocusDistance, self.focus_distance);
        let focus = probe.note(Name::LensFocus, eye + vector * (self.focus_distance / length));
        let [x, y] = warp::disc(place_in_square(draws.pick(Dimension::Lens), probe));
        probe.given(Name::DiscX, x);
        probe.given(Name::DiscY, y);
        probe.given(Name::LensRadius, self.radius);
        let origin = probe.note(Name::RayOriginLens, eye + (right * x + up * y) * self.radius);
        let vector = probe.note(Name::RayVectorLens, focus - origin);
        along(origin, vector, probe)
    }
}
