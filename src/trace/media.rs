//! The media that a ray is inside.

use crate::geometry::Side;

/// The stack of media around a ray: the objects it has entered and not left, each with its refractive index.
///
/// Leaving an object takes out its own latest entry, wherever it stands, so that overlapping objects refract rightly; an
/// object that was never entered leaves the stack as it is.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Media {
    entered: Vec<(u32, f64)>,
}

impl Media {
    /// The refractive index around the ray: that of the medium entered last, 1 outside all.
    pub fn ior(&self) -> f64 {
        self.entered.last().map_or(1.0, |(_, ior)| *ior)
    }

    /// The refractive index of what [`Media::beyond`] would give, without making it.
    pub fn ior_beyond(&self, (object, ior, arrives_on): (u32, f64, Side)) -> f64 {
        if arrives_on == Side::Front {
            return ior;
        }
        let latest = self.entered.iter().rposition(|(of, _)| *of == object);
        let left = self.entered.iter().enumerate().rev().find(|(at, _)| Some(*at) != latest);
        left.map_or(1.0, |(_, (_, ior))| *ior)
    }

    /// The media behind the surface of an object of this refractive index, crossed from the side on which the ray arrives.
    pub fn beyond(&self, (object, ior, arrives_on): (u32, f64, Side)) -> Media {
        let mut entered = self.entered.clone();
        match arrives_on {
            Side::Front => entered.push((object, ior)),
            Side::Back => {
                if let Some(latest) = entered.iter().rposition(|(of, _)| *of == object) {
                    entered.remove(latest);
                }
            }
        }
        Media { entered }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nested_media_return_to_the_enclosing_one() {
        let in_glass = Media::default().beyond((0, 1.5, Side::Front));
        let in_water = in_glass.beyond((1, 1.33, Side::Front));
        assert_eq!(in_water.ior(), 1.33);
        assert_eq!(in_water.beyond((1, 1.33, Side::Back)).ior(), 1.5);
    }

    #[test]
    fn the_index_beyond_is_that_of_the_media_beyond() {
        let stacks = [vec![], vec![(0, 1.5)], vec![(0, 1.5), (1, 1.3)], vec![(0, 1.5), (1, 1.3), (0, 1.1)]];
        for media in stacks.map(|entered| Media { entered }) {
            for object in 0..3 {
                for side in [Side::Front, Side::Back] {
                    let crossed = (object, 2.0, side);
                    assert_eq!(media.ior_beyond(crossed), media.beyond(crossed).ior(), "{media:?} {crossed:?}");
                }
            }
        }
    }

    #[test]
    fn leaving_takes_out_the_objects_own_entry() {
        let overlapping = Media::default().beyond((0, 1.5, Side::Front)).beyond((1, 1.33, Side::Front));
        assert_eq!(overlapping.beyond((0, 1.5, Side::Back)).ior(), 1.33);
    }

    #[test]
    fn what_was_never_entered_changes_nothing() {
        let in_glass = Media::default().beyond((0, 1.5, Side::Front));
        assert_eq!(in_glass.beyond((7, 2.0, Side::Back)), in_glass);
        assert_eq!(Media::default().beyond((7, 2.0, Side::Back)).ior(), 1.0);
    }
}
