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

    /// The media behind the surface of an object, crossed from the side on which the ray arrives.
    pub fn beyond(&self, object: u32, ior: f64, arrives_on: Side) -> Media {
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
        let in_glass = Media::default().beyond(0, 1.5, Side::Front);
        let in_water = in_glass.beyond(1, 1.33, Side::Front);
        assert_eq!(in_water.ior(), 1.33);
        assert_eq!(in_water.beyond(1, 1.33, Side::Back).ior(), 1.5);
    }

    #[test]
    fn leaving_takes_out_the_objects_own_entry() {
        let overlapping = Media::default().beyond(0, 1.5, Side::Front).beyond(1, 1.33, Side::Front);
        assert_eq!(overlapping.beyond(0, 1.5, Side::Back).ior(), 1.33);
    }

    #[test]
    fn what_was_never_entered_changes_nothing() {
        let in_glass = Media::default().beyond(0, 1.5, Side::Front);
        assert_eq!(in_glass.beyond(7, 2.0, Side::Back), in_glass);
        assert_eq!(Media::default().beyond(7, 2.0, Side::Back).ior(), 1.0);
    }
}
