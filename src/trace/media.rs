//! The media that a ray is inside.

use super::layer_stack::Layer;
use crate::scene::Scene;

/// The stack of media around a ray: the objects it has entered and not left, each with its refractive index.
///
/// Leaving an object takes out its own latest entry, wherever it is, so that overlapping objects refract rightly; an
/// object that was never entered leaves the stack as it is.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Media {
    entered: Vec<(u32, f64)>,
}

impl Media {
    /// These objects, each with its refractive index, the innermost last.
    pub fn around(entered: Vec<(u32, f64)>) -> Media {
        Media { entered }
    }

    /// These objects of the scene, the innermost last.
    pub fn of(objects: &[u32], scene: &Scene) -> Media {
        Media { entered: objects.iter().map(|object| (*object, scene.material_of(*object).ior)).collect() }
    }

    /// The objects, the innermost last.
    pub fn objects(&self) -> impl Iterator<Item = u32> + '_ {
        self.entered.iter().map(|(object, _)| *object)
    }

    /// The refractive index around the ray: that of the medium entered last, 1 outside all.
    pub fn ior(&self) -> f64 {
        self.entered.last().map_or(1.0, |(_, ior)| *ior)
    }

    /// The refractive index of what [`Media::beyond`] would give; of a single surface, without making it.
    pub fn ior_beyond(&self, crossed: &[Layer], scene: &Scene) -> f64 {
        let [layer] = crossed else { return self.beyond(crossed, scene).ior() };
        if layer.enters(scene) {
            return scene.material_of(layer.object).ior;
        }
        let latest = self.entered.iter().rposition(|(of, _)| *of == layer.object);
        let left = self.entered.iter().enumerate().rev().find(|(at, _)| Some(*at) != latest);
        left.map_or(1.0, |(_, (_, ior))| *ior)
    }

    /// The media behind surfaces that are crossed at once: all objects that are left are taken out, then those that are entered are put
    /// on top in their order. The first of an object's surfaces there decides: a mesh may have a face twice, wound either way.
    pub fn beyond(&self, crossed: &[Layer], scene: &Scene) -> Media {
        let is_first =
            |(number, layer): &(usize, &Layer)| !crossed[..*number].iter().any(|before| before.object == layer.object);
        let crossed: Vec<&Layer> = crossed.iter().enumerate().filter(is_first).map(|(_, layer)| layer).collect();
        let mut entered = self.entered.clone();
        for layer in crossed.iter().filter(|layer| !layer.enters(scene)) {
            if let Some(latest) = entered.iter().rposition(|(of, _)| *of == layer.object) {
                entered.remove(latest);
            }
        }
        let entries = crossed.iter().filter(|layer| layer.enters(scene));
        entered.extend(entries.map(|layer| (layer.object, scene.material_of(layer.object).ior)));
        Media { entered }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Side;
    use crate::scene::{build, file};

    /// Three balls with refractive indices of their own.
    fn scene() -> Scene {
        let ball = |name: &str| {
            format!(
                r#"{{"name": "{name}", "material": "{name}", "shape": {{"sphere": {{"center": [0, 0, 0], "radius": 1}}}}}}"#
            )
        };
        let material =
            |(name, ior): (&str, f64)| format!(r#""{name}": {{"ior": {ior}, "weights": {{"transmitted": 1}}}}"#);
        let text = format!(
            r#"{{"format": "raywalk-scene/1", "camera": {{"position": [0, 0, 5], "direction": [0, 0, -1]}},
            "materials": {{{}}}, "objects": [{}]}}"#,
            [("glass", 1.5), ("water", 1.33), ("ice", 1.31)].map(material).join(","),
            ["glass", "water", "ice"].map(ball).join(","),
        );
        let loaded = file::check(text.as_bytes(), "media").unwrap_or_else(|error| panic!("{}", error.report(false)));
        build(&loaded.scene, &Default::default()).unwrap_or_else(|unsupported| panic!("{unsupported}"))
    }

    const GLASS: u32 = 0;
    const WATER: u32 = 1;
    const ICE: u32 = 2;

    fn into(object: u32) -> Layer {
        Layer { object, primitive: 0, side: Side::Front }
    }

    fn out_of(object: u32) -> Layer {
        Layer { object, primitive: 0, side: Side::Back }
    }

    /// The indices of the media after crossing these interfaces one after the other, the innermost last.
    fn after(interfaces: &[&[Layer]]) -> Media {
        let scene = scene();
        interfaces.iter().fold(Media::default(), |media, crossed| {
            assert_eq!(media.ior_beyond(crossed, &scene), media.beyond(crossed, &scene).ior());
            media.beyond(crossed, &scene)
        })
    }

    #[track_caller]
    fn refracts(interfaces: &[&[Layer]], ior: f64) {
        assert_eq!(after(interfaces).ior(), ior);
    }

    #[test]
    fn nested_media_return_to_the_enclosing_one() {
        refracts(&[&[into(GLASS)], &[into(WATER)]], 1.33);
        refracts(&[&[into(GLASS)], &[into(WATER)], &[out_of(WATER)]], 1.5);
    }

    #[test]
    fn leaving_takes_out_the_objects_own_entry() {
        refracts(&[&[into(GLASS)], &[into(WATER)], &[out_of(GLASS)]], 1.33);
    }

    #[test]
    fn what_was_never_entered_changes_nothing() {
        refracts(&[&[into(GLASS)], &[out_of(ICE)]], 1.5);
        refracts(&[&[out_of(ICE)]], 1.0);
    }

    #[test]
    fn at_an_interface_exits_come_before_entries() {
        refracts(&[&[into(WATER)], &[into(GLASS), out_of(WATER)]], 1.5);
        refracts(&[&[into(GLASS)], &[out_of(GLASS), into(WATER)]], 1.33);
        refracts(&[&[into(GLASS), into(WATER)]], 1.33);
        refracts(&[&[into(GLASS), out_of(GLASS)]], 1.5);
        refracts(&[&[into(GLASS), out_of(GLASS)], &[out_of(GLASS), into(GLASS)]], 1.0);
        refracts(&[&[into(GLASS), into(WATER)], &[out_of(GLASS), out_of(WATER)]], 1.0);
    }
}
