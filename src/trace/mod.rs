//! The recursion: the colour that a ray brings (Ramos, sections 1.1 and 1.2).
//!
//! This is the only tracer. A probe sees its values, and may change their arithmetic.

mod adaptive_light;
mod bounce;
mod follow;
mod layer_stack;
mod light_points;
mod media;
mod one_light;
mod pattern;
pub mod query;
mod shade;
mod unseen;
mod visibility;
mod zones;

pub use crate::geometry::Hit;
pub(crate) use bounce::{printed_cosine, refract, transmitted_cosine};
pub use layer_stack::{Layer, LayerStack};
pub use media::Media;
pub(crate) use one_light::{power, power_between, segment_to_light, transmitted_half};
pub(crate) use shade::local_intensity;
pub(crate) use visibility::all_crossings;
pub use visibility::{closest_hit, is_any_hit, transmittance};

use crate::geometry::{Intersect, Leaving, Nearest, PACKET, PerRay, Ray, Surface};
use crate::log::plane::Emitter;
use crate::log::{Decision, Name, RayKind, Step};
use crate::probe::Probe;
use crate::random::{Arrangement, Draws, Route};
use crate::scene::{AroundEye, Color, Material, ReflectedScale, Scene, Weights};
use arrayvec::ArrayVec;
use glam::DVec3;

/// The largest channel of a colour that a surface sends out, by itself or with all that its rays bring: larger values are clamped to it. Weights
/// and coefficients are at most 1e100, so no product of one with such a colour overflows, however often weights above 1 have multiplied it.
pub const MAX_INTENSITY: f64 = 1e150;

/// What a ray carries with it down the ray tree.
#[derive(Clone, Copy, Debug)]
pub struct Path<'a> {
    /// The ray's level; the camera's ray has 0.
    pub level: u32,
    /// The media that the ray is inside.
    pub media: &'a Media,
    /// The product of the weights so far.
    pub weight: Color,
    /// The random numbers of the sample.
    pub draws: &'a Draws,
    /// The bounce that the ray came by; `None` for the camera's.
    pub via: Option<Via<'a>>,
    /// The surfaces at the ray's origin, if it has still to cross some of them.
    pub place: Option<&'a LayerStack>,
}

/// The last bounce of a path.
#[derive(Clone, Copy, Debug)]
pub struct Via<'a> {
    /// The path up to there.
    pub path: &'a Path<'a>,
    /// Whether the ray was transmitted; else it was reflected.
    pub is_transmitted: bool,
    /// Its number, from 1, among several; 0 if it is alone.
    pub split: u32,
    /// The bounce's weight.
    pub weight: Color,
}

impl<'a> Path<'a> {
    /// The path of a camera ray.
    pub fn of_camera(media: &'a Media, draws: &'a Draws) -> Path<'a> {
        Path { level: 0, media, weight: Color::ONE, draws, via: None, place: None }
    }

    /// The route from the eye, which names the random decisions at the ray's end. Computed lazily, so that rays that
    /// decide nothing at random don't pay for it.
    pub fn route(&self) -> Route {
        match &self.via {
            None => Route::CAMERA,
            Some(Via { path, is_transmitted: true, split, .. }) => path.route().transmitted(*split),
            Some(Via { path, is_transmitted: false, split, .. }) => path.route().reflected(*split),
        }
    }
}

/// Where a ray hits a surface, and how it came there.
pub(crate) struct Meeting<'a> {
    pub layer: Layer,
    /// All coincident surfaces, if there are several.
    pub place: Option<&'a LayerStack>,
    pub ray: &'a Ray,
    pub surface: Surface,
    pub material: &'a Material,
    /// The material's weights; that of the transmitted ray is for all surfaces that it crosses here.
    pub weights: &'a Weights,
    pub path: &'a Path<'a>,
    /// How far the point may lie from where exact arithmetic would put it.
    pub slack: f64,
}

/// What a ray saw.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen {
    /// The colour that it brings.
    pub color: Color,
    /// The object that it hits first, if it hits any.
    pub object: Option<u32>,
}

/// The colour that a single ray brings; the background's if it has no direction. It begins inside the media that hold its origin.
///
/// The ray belongs to no pixel: its random numbers are those of a place that no picture has.
pub fn camera_ray<P: Probe>(scene: &Scene, aim: impl FnOnce(&mut P) -> Option<Ray>, probe: &mut P) -> Color {
    let draws = Draws::of_pixel(scene.seed, [u32::MAX; 2], 0, Arrangement::Independent);
    seen_from(scene, &draws, aim, |ray| Media::of(&scene.media_around(ray), scene), probe).color
}

/// What a camera ray of a sample with these random numbers sees; the background if it has no direction.
#[inline(always)]
pub fn see<P: Probe>(scene: &Scene, draws: &Draws, aim: impl FnOnce(&mut P) -> Option<Ray>, probe: &mut P) -> Seen {
    let media = |ray: &Ray| match scene.around_eye {
        AroundEye::Nothing => Media::default(),
        _ => around_eye(scene, ray),
    };
    seen_from(scene, draws, aim, media, probe)
}

/// The media that hold the origin of a camera ray.
#[cold]
#[inline(never)]
fn around_eye(scene: &Scene, ray: &Ray) -> Media {
    match &scene.around_eye {
        AroundEye::Nothing => Media::default(),
        AroundEye::Objects(objects) => Media::of(objects, scene),
        AroundEye::EachRay => {
            let ahead = Ray { time: ray.time, ..Ray::along(ray.origin, scene.camera.direction()) };
            Media::of(&scene.media_around(&ahead), scene)
        }
    }
}

/// What camera rays of samples with these random numbers see, at most [`PACKET`] of them, in their order.
///
/// Their first hits are searched for together; from there on each is traced by itself.
pub fn see_together<P: Probe>(
    scene: &Scene,
    draws: &[Draws],
    aimed: &[Option<Ray>],
    mut seen: impl FnMut(Seen),
    probe: &mut P,
) {
    let rays: ArrayVec<Ray, PACKET> = aimed.iter().flatten().copied().collect();
    let mut nearest: PerRay<Nearest> = [const { Nearest::NONE }; PACKET];
    visibility::search_together(scene, &rays, &mut nearest, probe);
    let mut nearest = nearest.into_iter();
    for (draws, ray) in draws.iter().zip(aimed) {
        seen(match (ray, ray.and_then(|_| nearest.next())) {
            (Some(ray), Some(nearest)) => met(scene, draws, ray, nearest, probe),
            _ => nothing_met(scene, probe),
        });
    }
}

/// What a camera ray with a known nearest hit sees.
#[inline(never)]
fn met<P: Probe>(scene: &Scene, draws: &Draws, ray: &Ray, nearest: Nearest, probe: &mut P) -> Seen {
    let media = match scene.around_eye {
        AroundEye::Nothing => Media::default(),
        _ => around_eye(scene, ray),
    };
    seen_at(scene, ray, &Path::of_camera(&media, draws), nearest, probe)
}

// Its body, too, is a part of the caller, so that the ray is made where it is traced from.
#[inline(always)]
fn seen_from<P: Probe>(
    scene: &Scene,
    draws: &Draws,
    aim: impl FnOnce(&mut P) -> Option<Ray>,
    media: impl FnOnce(&Ray) -> Media,
    probe: &mut P,
) -> Seen {
    let step = Step::Ray { kind: RayKind::Camera, depth: 0, split: 0 };
    probe.within(
        step,
        #[inline(always)]
        |probe| {
            let Some(ray) = aim(probe) else { return nothing_met(scene, probe) };
            let media = media(&ray);
            for object in media.objects() {
                probe.mark(Decision::Immersed { object });
            }
            radiance(scene, &ray, &Path::of_camera(&media, draws), probe)
        },
    )
}

/// What a ray sees: the recursion of the source text.
// One function with the search for the nearest hit in it: a hit handed over, here or to the camera, would be a copy a ray.
fn radiance<P: Probe>(scene: &Scene, ray: &Ray, path: &Path, probe: &mut P) -> Seen {
    if let Some(place) = path.place {
        let hit = visibility::touched(scene, ray, place, probe);
        return in_place(scene, ray, path, &hit, place, probe);
    }
    let nearest = visibility::search(scene, ray, probe);
    seen_at(scene, ray, path, nearest, probe)
}

/// What a ray with a known nearest hit sees.
#[inline(always)]
fn seen_at<P: Probe>(scene: &Scene, ray: &Ray, path: &Path, nearest: Nearest, probe: &mut P) -> Seen {
    let Some(mut hit) = nearest.hit() else {
        return nothing_met(scene, probe);
    };
    if !nearest.is_alone() {
        let hits = visibility::settled(scene, ray, nearest, probe);
        if hits.len() > 1 {
            return in_place(scene, ray, path, &hits[0], &LayerStack::of(&hits), probe);
        }
        // At the same distance the search may have found another one first.
        hit = hits[0];
    } else {
        probe.mark(Decision::Nearest { object: hit.object });
    }
    shaded(scene, ray, path, &hit, None, probe)
}

/// What a ray that hits nothing sees.
#[inline(always)]
fn nothing_met<P: Probe>(scene: &Scene, probe: &mut P) -> Seen {
    probe.given(Name::BackgroundColor, scene.background);
    probe.mark(Decision::Background);
    if probe.sees_parts() {
        probe.part(Emitter::Background, scene.background);
    }
    Seen { color: scene.background, object: None }
}

/// What a ray that hits the first of several coincident surfaces sees.
// Outlined, so that a single surface doesn't pay for it.
#[cold]
#[inline(never)]
fn in_place<P: Probe>(scene: &Scene, ray: &Ray, path: &Path, hit: &Hit, place: &LayerStack, probe: &mut P) -> Seen {
    shaded(scene, ray, path, hit, Some(place), probe)
}

/// What a ray that hits a surface sees; the surface may be one of several coincident ones.
#[inline(always)]
fn shaded<P: Probe>(
    scene: &Scene,
    ray: &Ray,
    path: &Path,
    hit: &Hit,
    place: Option<&LayerStack>,
    probe: &mut P,
) -> Seen {
    let surface = scene.objects[hit.object as usize].shape.surface(ray, hit.crossing, probe);
    let material = scene.material_of(hit.object);
    let merged = place.filter(|_| material.transmits()).map(|place| place.merged(&material.weights, scene));
    let weights = merged.as_ref().unwrap_or(&material.weights);
    let begun = if path.place.is_some() { ray.slack } else { 0.0 };
    let slack = ray.slack_at(surface.point, probe) + scene.objects[hit.object as usize].slack + begun;
    let meeting = Meeting { layer: Layer::of(hit), place, ray, surface, material, weights, path, slack };
    let local = shade::local_intensity(scene, &meeting, probe);
    let reflected = bounce::reflected(scene, &meeting, probe);
    let transmitted = bounce::transmitted(scene, &meeting, probe);
    let color = combine(scene, &meeting, [local, reflected, transmitted], probe);
    Seen { color, object: Some(hit.object) }
}

/// I = W_l·I_local + W_r·I_reflected + W_t·I_transmitted (Ramos, section 1.2.3); W_r·K_e instead of W_r where the scene asks for it.
fn combine<P: Probe>(
    scene: &Scene,
    meeting: &Meeting,
    [local, reflected, transmitted]: [Color; 3],
    probe: &mut P,
) -> Color {
    let Meeting { weights, material, .. } = meeting;
    probe.within(Step::Combine, |probe| {
        probe.given(Name::WeightLocal, weights.local);
        probe.given(Name::ShadeLocal, local);
        let local = probe.note(Name::CombineLocal, weights.local * local);
        probe.given(Name::WeightReflected, weights.reflected);
        probe.given(Name::IncomingReflected, reflected);
        let name = match scene.tracing.reflected_scale {
            ReflectedScale::Weight => Name::CombineReflected,
            ReflectedScale::Specular => {
                probe.given(Name::MaterialSpecular, material.specular);
                Name::CombineReflectedSpecular
            }
        };
        let scale = scene.tracing.scale_of_reflected(weights.reflected, material);
        let reflected = probe.note(name, scale * reflected);
        probe.given(Name::WeightTransmitted, weights.transmitted);
        probe.given(Name::IncomingTransmitted, transmitted);
        let transmitted = probe.note(Name::CombineTransmitted, weights.transmitted * transmitted);
        probe.note(Name::CombineColor, in_range(local + reflected + transmitted))
    })
}

/// A colour in which no channel is above [`MAX_INTENSITY`].
#[inline(always)]
pub(crate) fn in_range(color: Color) -> Color {
    color.min(Color::splat(MAX_INTENSITY))
}

impl Meeting<'_> {
    /// The surface, for a ray that leaves it on the side where `ray` arrived.
    fn leaving_here(&self) -> Leaving {
        let Layer { object, primitive, .. } = self.layer;
        Leaving { object, primitive, side: self.surface.side }
    }

    /// The surface, for a ray that leaves it on the other side.
    fn leaving_beyond(&self) -> Leaving {
        Leaving { side: self.surface.side.opposite(), ..self.leaving_here() }
    }

    /// The surfaces that a transmitted ray crosses here at once.
    fn interface(&self, scene: &Scene) -> &[Layer] {
        match self.place {
            None => std::slice::from_ref(&self.layer),
            Some(place) => place.interface(scene),
        }
    }

    /// Whether a ray that by the interpolated normal sets off on this side of the surface lies on the other side by the
    /// surface's own. What it brings would leak through the surface, so it counts as black; the ray is traced all the same.
    fn leaks(&self, direction: DVec3, is_meant_here: bool) -> bool {
        self.surface.beneath.is_some_and(|geometric_normal| {
            let height = geometric_normal.dot(direction);
            if is_meant_here { height < 0.0 } else { height > 0.0 }
        })
    }
}
