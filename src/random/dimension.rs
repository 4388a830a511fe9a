//! What a random number decides.

use super::hash;

/// A decision of a sample for which it needs a random number or a random point: a dimension of the integral that the pixel is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimension {
    /// Where in the pixel (a point).
    Pixel,
    /// When, between the shutter's opening and its closing (a number).
    Time,
    /// Where on the lens (a point).
    Lens,
    /// Where on a light, seen from the hit at the end of a route (a point).
    Light {
        /// How the ray came there.
        route: Route,
        /// The light's number.
        light: u32,
    },
    /// Where a blurred reflection goes at the end of a route (a point).
    Reflection {
        /// How the ray came there.
        route: Route,
    },
    /// Where a blurred transmission goes at the end of a route (a point).
    Transmission {
        /// How the ray came there.
        route: Route,
    },
}

/// The way of a ray from the eye, as one number: two rays of a sample have the same only if they are the same ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Route(u64);

/// What is spread jointly with the places in the pixel, as points of four dimensions: what an image depends on next to the place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Partner {
    /// Nothing: all other dimensions are spread by themselves.
    Nothing,
    /// Where on the lens.
    Lens,
    /// When.
    Time,
    /// What the surface decides that the camera's ray hits: where on each light, and where its blurred rays go. What each of them brings is added
    /// up, so that they need not know each other.
    Surface,
}

/// Keeps the words of bounces apart from those of decisions.
const BOUNCE: u64 = 1 << 40;

impl Route {
    /// The camera's ray.
    pub const CAMERA: Route = Route(0);

    /// The reflected ray at the end of this one; of several the one with this number.
    #[inline]
    #[must_use]
    pub fn reflected(self, split: u32) -> Route {
        Route(hash(self.0, BOUNCE | u64::from(split) << 1))
    }

    /// The transmitted ray at the end of this one; of several the one with this number.
    #[inline]
    #[must_use]
    pub fn transmitted(self, split: u32) -> Route {
        Route(hash(self.0, BOUNCE | u64::from(split) << 1 | 1))
    }
}

impl Dimension {
    /// Whether the dimension is spread jointly with the places in the pixel, if this is their partner.
    #[inline]
    pub(super) fn is_of(self, partner: Partner) -> bool {
        match self {
            Dimension::Pixel => false,
            Dimension::Time => partner == Partner::Time,
            Dimension::Lens => partner == Partner::Lens,
            Dimension::Light { route, .. } | Dimension::Reflection { route } | Dimension::Transmission { route } => {
                partner == Partner::Surface && route == Route::CAMERA
            }
        }
    }

    /// The dimension as a word to be hashed.
    #[inline]
    pub(super) fn word(self) -> u64 {
        match self {
            Dimension::Pixel => 0,
            Dimension::Time => 1,
            Dimension::Lens => 2,
            Dimension::Light { route, light } => hash(hash(route.0, 3), light.into()),
            Dimension::Reflection { route } => hash(route.0, 4),
            Dimension::Transmission { route } => hash(route.0, 5),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn every_decision_has_a_word_of_its_own() {
        let mut words: HashSet<_> = [Dimension::Pixel, Dimension::Time, Dimension::Lens].map(Dimension::word).into();
        let mut routes = vec![Route::CAMERA];
        for level in 0..4 {
            let bounce =
                |route: &Route| (0..3).flat_map(|k| [route.reflected(k), route.transmitted(k)]).collect::<Vec<_>>();
            let deeper: Vec<_> = routes.iter().flat_map(bounce).collect();
            for route in &routes {
                let lights = (0..5).map(|light| Dimension::Light { route: *route, light });
                let bounces = [Dimension::Reflection { route: *route }, Dimension::Transmission { route: *route }];
                for dimension in lights.chain(bounces) {
                    assert!(words.insert(dimension.word()), "{dimension:?} at level {level}");
                }
            }
            routes = deeper;
        }
    }
}
