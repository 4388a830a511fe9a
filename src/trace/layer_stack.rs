//! Coincident surfaces, and how rays pass through them.
//!
//! There the order of the scene decides, for every kind of ray and from either side: the first surface is the nearer one, and the
//! others lie just behind it, as the arriving ray sees it. Transmitting surfaces that follow each other are one interface.

use super::in_range;
use crate::geometry::{Crossing, Hit, Side};
use crate::scene::{Color, Scene, Weights};

/// A surface that a ray crosses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layer {
    /// The object.
    pub object: u32,
    /// Which part of its surface.
    pub primitive: u32,
    /// The side from which the ray arrives.
    pub side: Side,
}

/// The surfaces in one place, as a ray sees them that is among them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LayerStack {
    /// Those that the ray has crossed.
    pub(super) crossed: Vec<Layer>,
    /// Those that it has still to cross, the first of them next. There is one at least.
    pub(super) ahead: Vec<Layer>,
}

impl Layer {
    /// The surface of a hit.
    pub fn of(hit: &Hit) -> Layer {
        Layer { object: hit.object, primitive: hit.crossing.primitive, side: hit.crossing.side }
    }

    /// The hit of a ray that begins in front of the surface.
    pub fn touched(self) -> Hit {
        Hit { object: self.object, crossing: Crossing { t: 0.0, side: self.side, primitive: self.primitive } }
    }

    fn seen_from_behind(self) -> Layer {
        Layer { side: self.side.opposite(), ..self }
    }

    fn transmits(self, scene: &Scene) -> bool {
        scene.material_of(self.object).transmits()
    }

    /// Whether a ray that crosses the surface enters its medium. That of a surface that encloses nothing lies behind it.
    pub fn enters(self, scene: &Scene) -> bool {
        self.side != scene.objects[self.object as usize].inside.unwrap_or(Side::Back)
    }
}

impl LayerStack {
    /// The place where a ray arrives, with its hits in the order of the scene.
    #[cold]
    pub(super) fn of(hits: &[Hit]) -> LayerStack {
        LayerStack { crossed: Vec::new(), ahead: hits.iter().map(Layer::of).collect() }
    }

    /// The surfaces that a transmitted ray crosses at once: the next one and those that transmit right behind it.
    pub fn interface(&self, scene: &Scene) -> &[Layer] {
        let following = self.ahead.iter().skip(1).take_while(|layer| layer.transmits(scene)).count();
        &self.ahead[..self.ahead.len().min(1 + following)]
    }

    /// The weights of the next surface, that of the transmitted ray multiplied over the whole interface.
    #[cold]
    pub fn merged(&self, weights: &Weights, scene: &Scene) -> Weights {
        let of_layer = |layer: &Layer| scene.material_of(layer.object).weights.transmitted;
        let transmitted: Color = self.interface(scene).iter().map(of_layer).product();
        Weights { transmitted: in_range(transmitted), ..*weights }
    }

    /// The place for the ray that was transmitted through the interface; `None` where nothing in it is ahead.
    #[cold]
    pub fn beyond_interface(&self, scene: &Scene) -> Option<Box<LayerStack>> {
        let (interface, rest) = self.ahead.split_at(self.interface(scene).len());
        (!rest.is_empty())
            .then(|| Box::new(LayerStack { crossed: [&self.crossed, interface].concat(), ahead: rest.to_vec() }))
    }

    /// The place for the ray that was reflected at the next surface; `None` where nothing in it is ahead.
    #[cold]
    pub fn turned_back(&self) -> Option<Box<LayerStack>> {
        let seen_from_behind = |layers: &[Layer]| layers.iter().map(|layer| layer.seen_from_behind()).collect();
        (!self.crossed.is_empty()).then(|| {
            Box::new(LayerStack { crossed: seen_from_behind(&self.ahead), ahead: seen_from_behind(&self.crossed) })
        })
    }
}
