//! The yardstick: the same mathematics in a tracer written by hand, without any probe.
//!
//! It is written as one writes a ray tracer of planes and spheres that nobody will look into. It shares no code with the
//! program: only the scene file's numbers, vectors and `pow`.

mod reading;
pub mod shapes;

use glam::DVec3;
use raywalk::scene::file::schema::{Algorithm, Specular};
use shapes::{Crossing, ROUNDINGS, Ray, Shape};

/// A scene, ready to be traced, with every option of the program that a tracer of planes and spheres has to ask for.
pub struct Yardstick {
    eye: DVec3,
    forward: DVec3,
    length: f64,
    right: DVec3,
    up: DVec3,
    pixel_side: f64,
    resolution: [u32; 2],
    ambient: DVec3,
    background: DVec3,
    lights: Vec<Light>,
    materials: Vec<Material>,
    /// What rays hit.
    pub objects: Vec<Object>,
    rules: Rules,
}

struct Rules {
    algorithm: Algorithm,
    specular: Specular,
    max_depth: u32,
    cutoff: f64,
    skips_zero_weight: bool,
    skips_no_local_term: bool,
    skips_blocked: bool,
    skips_cutoff: bool,
}

enum Light {
    Point { position: DVec3, color: DVec3, fading: Option<[f64; 3]> },
    Sun { toward: DVec3, color: DVec3 },
}

/// An object of the scene.
pub struct Object {
    pub shape: Shape,
    material: usize,
    pub is_one_sided: bool,
}

struct Material {
    ambient: DVec3,
    diffuse: DVec3,
    specular: DVec3,
    transmission: DVec3,
    shininess: f64,
    transmission_exponent: f64,
    ior: f64,
    local: DVec3,
    reflected: DVec3,
    transmitted: DVec3,
}

/// The objects that a ray is inside, each with its refractive index.
type Media = Vec<(usize, f64)>;

impl Yardstick {
    /// The colour of a pixel.
    pub fn pixel(&self, [column, row]: [u32; 2]) -> DVec3 {
        let x = (f64::from(column) + 0.5 - f64::from(self.resolution[0]) / 2.0) * self.pixel_side;
        let y = (f64::from(self.resolution[1]) / 2.0 - (f64::from(row) + 0.5)) * self.pixel_side;
        let is_center = x == 0.0 && y == 0.0;
        let offset = (self.right * x + self.up * y) * self.length;
        let direction = unit(if is_center { self.forward } else { self.forward + offset });
        let ray = Ray { origin: self.eye, direction, from: None, start: 0.0, end: f64::INFINITY, slack: 0.0 };
        self.color(&ray, 0, DVec3::ONE, &Media::new())
    }

    /// The colour that a ray brings; `weight` is the product of the weights along its path.
    fn color(&self, ray: &Ray, depth: u32, weight: DVec3, media: &Media) -> DVec3 {
        let mut nearest: Option<(usize, Crossing)> = None;
        for (number, object) in self.objects.iter().enumerate() {
            if let Some(crossing) = object.shape.first_crossing(number, object.is_one_sided, ray)
                && nearest.is_none_or(|(_, other)| crossing.t < other.t)
            {
                nearest = Some((number, crossing));
            }
        }
        let Some((number, crossing)) = nearest else { return self.background };
        let object = &self.objects[number];
        let material = &self.materials[object.material];
        let (point, normal) = object.shape.surface(ray, crossing);
        let slack =
            ROUNDINGS * (2.0 * (ray.origin.abs() + point.abs()).element_sum()) + ROUNDINGS * object.shape.size();
        let goes_deeper = match self.rules.algorithm {
            Algorithm::Recursive => depth < self.rules.max_depth,
            Algorithm::Whitted | Algorithm::Foley => depth + 1 < self.rules.max_depth,
        };
        let hit = Hit { number, material, point, normal, behind: crossing.behind, view: -ray.direction, slack };
        let is_ambient_only = self.rules.algorithm == Algorithm::Whitted && !goes_deeper;
        let local = if is_ambient_only { self.ambient * material.ambient } else { self.local(&hit, media) };
        let mut color = material.local * local;
        if !goes_deeper {
            return color;
        }
        let transmits = material.transmitted != DVec3::ZERO;
        let reflects = material.reflected != DVec3::ZERO || transmits;
        if reflects && !self.is_skipped(weight, material.reflected) {
            let direction = ray.direction - normal * 2.0 * ray.direction.dot(normal);
            let ray = Ray {
                origin: point,
                direction,
                from: Some((number, hit.behind)),
                start: 0.0,
                end: f64::INFINITY,
                slack,
            };
            color += material.reflected * self.color(&ray, depth + 1, weight * material.reflected, media);
        }
        if transmits && !self.is_skipped(weight, material.transmitted) {
            let beyond = beyond(media, number, material.ior, hit.behind);
            if let Some(direction) = refract(ray.direction, normal, ior(&beyond) / ior(media)) {
                let ray = Ray {
                    origin: point,
                    direction,
                    from: Some((number, !hit.behind)),
                    start: 0.0,
                    end: f64::INFINITY,
                    slack,
                };
                color += material.transmitted * self.color(&ray, depth + 1, weight * material.transmitted, &beyond);
            }
        }
        color
    }

    fn is_skipped(&self, weight: DVec3, factor: DVec3) -> bool {
        let rules = &self.rules;
        (rules.skips_zero_weight && factor == DVec3::ZERO)
            || (rules.skips_cutoff && (weight * factor).cmplt(DVec3::splat(rules.cutoff)).all())
    }

    fn local(&self, hit: &Hit, media: &Media) -> DVec3 {
        let material = hit.material;
        let mut sum = self.ambient * material.ambient;
        for light in &self.lights {
            let (toward, distance) = match light {
                Light::Point { position, .. } => {
                    let vector = *position - hit.point;
                    let distance = vector.length();
                    if distance == 0.0 {
                        continue;
                    }
                    (vector / distance, distance)
                }
                Light::Sun { toward, .. } => (*toward, f64::INFINITY),
            };
            let n_dot_l = hit.normal.dot(toward);
            let is_lit = if n_dot_l > 0.0 {
                let uses_light = material.diffuse != DVec3::ZERO || material.specular != DVec3::ZERO;
                uses_light || !self.rules.skips_no_local_term
            } else {
                n_dot_l < 0.0 && material.transmission != DVec3::ZERO
            };
            if !is_lit {
                continue;
            }
            let from = Some((hit.number, hit.behind != (n_dot_l < 0.0)));
            let passed = self.passed(&Ray {
                origin: hit.point,
                direction: toward,
                from,
                start: 0.0,
                end: distance,
                slack: hit.slack,
            });
            if passed == DVec3::ZERO {
                continue;
            }
            let color = match light {
                Light::Point { color, fading: Some([constant, linear, quadratic]), .. } => {
                    *color * (1.0 / (constant + linear * distance + quadratic * (distance * distance))).min(1.0)
                }
                Light::Point { color, .. } | Light::Sun { color, .. } => *color,
            };
            let reflectance = if n_dot_l > 0.0 {
                material.diffuse * n_dot_l.clamp(0.0, 1.0) + self.specular(hit, toward, n_dot_l)
            } else {
                transmission(hit, toward, media)
            };
            sum += color * passed * reflectance;
        }
        sum
    }

    fn specular(&self, hit: &Hit, toward: DVec3, n_dot_l: f64) -> DVec3 {
        let cosine = match self.rules.specular {
            Specular::HalfVector | Specular::HalfVectorCompensated => {
                let half = toward + hit.view;
                let length = half.length();
                if length == 0.0 {
                    return DVec3::ZERO;
                }
                hit.normal.dot(half / length)
            }
            Specular::ReflectionVector => (hit.normal * 2.0 * n_dot_l - toward).dot(hit.view),
        };
        let is_compensated = self.rules.specular == Specular::HalfVectorCompensated;
        let exponent = hit.material.shininess * if is_compensated { 4.0 } else { 1.0 };
        hit.material.specular * libm::pow(cosine.clamp(0.0, 1.0), exponent)
    }

    /// The part of the light that gets along a shadow ray.
    fn passed(&self, ray: &Ray) -> DVec3 {
        let mut crossed = Vec::new();
        let mut is_blocked = false;
        for (number, object) in self.objects.iter().enumerate() {
            if self.materials[object.material].transmitted != DVec3::ZERO {
                let crossings = object.shape.all_crossings(number, ray);
                crossed.extend(crossings.into_iter().flatten().map(|crossing| (crossing.t, number, object.material)));
            } else if object.shape.first_crossing(number, object.is_one_sided, ray).is_some() {
                is_blocked = true;
                if self.rules.skips_blocked {
                    break;
                }
            }
        }
        if is_blocked {
            return DVec3::ZERO;
        }
        crossed.sort_by(|(t, number, _), (other_t, other, _)| t.total_cmp(other_t).then(number.cmp(other)));
        crossed.iter().fold(DVec3::ONE, |passed, (_, _, material)| passed * self.materials[*material].transmitted)
    }
}

struct Hit<'a> {
    number: usize,
    material: &'a Material,
    point: DVec3,
    normal: DVec3,
    behind: bool,
    view: DVec3,
    /// How far rounding may have moved the point.
    slack: f64,
}

/// The transmitted term of the local model.
fn transmission(hit: &Hit, toward: DVec3, media: &Media) -> DVec3 {
    let material = hit.material;
    let eta = ior(media) / ior(&beyond(media, hit.number, material.ior, hit.behind));
    if eta == 1.0 {
        return if hit.view == -toward { material.transmission } else { DVec3::ZERO };
    }
    let half = -(toward + hit.view) / (eta - 1.0) - hit.view;
    let length = half.length();
    if length == 0.0 {
        return DVec3::ZERO;
    }
    let cosine = -hit.normal.dot(half / length);
    material.transmission * libm::pow(cosine.clamp(0.0, 1.0), material.transmission_exponent)
}

fn ior(media: &Media) -> f64 {
    media.last().map_or(1.0, |(_, ior)| *ior)
}

fn beyond(media: &Media, number: usize, ior: f64, behind: bool) -> Media {
    let mut media = media.clone();
    if !behind {
        media.push((number, ior));
    } else if let Some(entered) = media.iter().rposition(|(of, _)| *of == number) {
        media.remove(entered);
    }
    media
}

fn refract(direction: DVec3, normal: DVec3, eta: f64) -> Option<DVec3> {
    let cos_1 = -normal.dot(direction);
    let tangential = direction + normal * cos_1;
    let k = eta * eta - tangential.dot(tangential);
    (k >= 0.0).then(|| direction / eta - normal * (k.sqrt() / eta - cos_1 / eta))
}

fn unit(vector: DVec3) -> DVec3 {
    vector / vector.length()
}
