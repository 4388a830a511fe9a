//! How many rays per second are answered: whole passes over the rays of a file, which threads take from a queue.

use super::Spread;
use super::clock::{Lap, timed};
use crate::geometry::shape::{Sphere, SphereMethod, TriangleMesh};
use crate::geometry::{PACKET, Shape};
use crate::log::words::words;
use crate::scene::Scene;
use crate::scene::file::raw::{Primitives, Question, RawRay, RayFile};
use crate::threads::Threads;
use crate::trace::query::{Query, RayHit};
use arrayvec::ArrayVec;
use glam::DVec3;
use rayon::prelude::*;
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;

/// How many rays a thread takes from the queue at a time.
pub const QUEUE: usize = 4096;

/// The primitive of a ray that hits none.
pub const NOTHING: u32 = u32::MAX;

/// How often the rays are traced.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Passes {
    /// So often.
    Number(usize),
    /// For about this many seconds, 3 to 15 times.
    Seconds(f64),
}

words! {
    /// How rays are asked.
    pub Mode {
        /// Each by itself.
        Single = "single",
        /// Eight that follow each other in the file at a time.
        Batch = "batch",
    }
}

/// What each ray met.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Hits {
    /// The distances, in units of the directions; infinite where nothing is met, 0 where no distance was asked for.
    pub t: Vec<f32>,
    /// The triangles of a mesh, or the spheres; [`NOTHING`] where nothing is met, 0 where only that was asked.
    pub primitive: Vec<u32>,
}

/// The speed over a file of rays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Throughput {
    /// On how many threads.
    pub threads: usize,
    /// Rays a second by the clock.
    pub per_second: Spread,
    /// Rays a processor second.
    pub per_cpu_second: Spread,
    /// How many rays met something.
    pub hits: usize,
    /// The sum of all distances.
    pub t_sum: f64,
}

/// The scene of the primitives: one object for a mesh, one for each sphere. Says how long it took on this many threads to make it
/// ready to be traced.
pub fn build(name: &str, primitives: &Primitives, threads: usize) -> (Scene, Lap) {
    let threads = Threads::of(threads, usize::MAX);
    match primitives {
        Primitives::Mesh(mesh) => {
            let mesh = Arc::new(mesh.clone());
            threads.run(|| timed(|| Scene::of_shapes(name, [Shape::Mesh(Arc::new(TriangleMesh::new(mesh)))])))
        }
        Primitives::Spheres(spheres) => {
            let shapes = spheres.par_iter().map(|sphere| {
                let center = DVec3::from_array(sphere.center.map(f64::from));
                Shape::Sphere(Sphere::new(center, sphere.radius.into(), false, SphereMethod::Robust))
            });
            threads.run(|| timed(|| Scene::of_shapes(name, shapes)))
        }
    }
}

/// Traces the rays again and again on this many threads, or on those that can be started. `hits` holds what the last pass found.
pub fn measure(
    scene: &Scene,
    file: &RayFile,
    mode: Mode,
    threads: usize,
    passes: Passes,
    hits: &mut Hits,
) -> Throughput {
    // One before it counts, which warms the caches up.
    let (first, threads) = pass(scene, file, mode, threads, hits);
    let number = match passes {
        Passes::Number(number) => number,
        Passes::Seconds(seconds) => (seconds / first.seconds).ceil().clamp(3.0, 15.0) as usize,
    };
    let laps: Vec<Lap> = (0..number).map(|_| pass(scene, file, mode, threads, hits).0).collect();
    let rays = file.rays.len() as f64;
    let met = || hits.t.iter().zip(&hits.primitive).filter(|(_, primitive)| **primitive != NOTHING);
    Throughput {
        threads,
        per_second: Spread::of(laps.iter().map(|lap| lap.seconds).collect()).under(rays),
        per_cpu_second: Spread::of(laps.iter().map(|lap| lap.cpu_seconds).collect()).under(rays),
        hits: met().count(),
        t_sum: met().map(|(t, _)| f64::from(*t)).sum(),
    }
}

/// Traces all rays once; says how long it took and on how many threads.
fn pass(scene: &Scene, file: &RayFile, mode: Mode, threads: usize, hits: &mut Hits) -> (Lap, usize) {
    hits.t.resize(file.rays.len(), 0.0);
    hits.primitive.resize(file.rays.len(), NOTHING);
    let answers = hits.t.chunks_mut(QUEUE).zip(hits.primitive.chunks_mut(QUEUE));
    let queue = Mutex::new(file.rays.chunks(QUEUE).zip(answers));
    let next = || queue.lock().unwrap_or_else(PoisonError::into_inner).next();
    let work = || {
        while let Some((rays, answers)) = next() {
            answer(scene, rays, (file.question, mode), answers);
        }
    };
    let run = || {
        thread::scope(|scope| {
            let others = (1..threads).take_while(|_| thread::Builder::new().spawn_scoped(scope, work).is_ok()).count();
            work();
            others + 1
        })
    };
    let (threads, lap) = timed(run);
    (lap, threads)
}

/// Answers some rays into their places.
fn answer(scene: &Scene, rays: &[RawRay], how: (Question, Mode), (t, primitive): (&mut [f32], &mut [u32])) {
    let mut places = t.iter_mut().zip(primitive);
    let mut put = |answer: (f32, u32)| {
        if let Some((t, primitive)) = places.next() {
            (*t, *primitive) = answer;
        }
    };
    match how {
        (Question::Closest, Mode::Single) => rays.iter().for_each(|ray| put(hit(query(ray).hit(scene)))),
        (Question::Closest, Mode::Batch) => {
            rays.chunks(PACKET).for_each(|rays| Query::hits(&queries(rays), scene, |found| put(hit(found))));
        }
        (Question::Occlusion, Mode::Single) => rays.iter().for_each(|ray| put(blocked(query(ray).is_occluded(scene)))),
        (Question::Occlusion, Mode::Batch) => rays.chunks(PACKET).for_each(|rays| {
            let occluded = Query::are_occluded(&queries(rays), scene);
            (0..rays.len()).for_each(|at| put(blocked(occluded >> at & 1 == 1)));
        }),
    }
}

fn queries(rays: &[RawRay]) -> ArrayVec<Query, PACKET> {
    rays.iter().map(query).collect()
}

fn hit(hit: Option<RayHit>) -> (f32, u32) {
    // The object of a mesh is the only one, and the primitive of a sphere its only part.
    hit.map_or((f32::INFINITY, NOTHING), |hit| (hit.t as f32, hit.object.max(hit.primitive)))
}

fn blocked(is_blocked: bool) -> (f32, u32) {
    (0.0, if is_blocked { 0 } else { NOTHING })
}

#[inline]
fn query(ray: &RawRay) -> Query {
    Query {
        origin: DVec3::from_array(ray.origin.map(f64::from)),
        direction: DVec3::from_array(ray.direction.map(f64::from)),
        t_min: ray.t_min.into(),
        t_max: ray.t_max.into(),
        from: None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::mesh::Mesh;
    use crate::scene::file::raw::RawSphere;

    fn ray(x: f32, t_max: f32) -> RawRay {
        RawRay { origin: [x, 0.25, 3.0], t_min: 0.0, direction: [0.0, 0.0, -1.0], t_max }
    }

    /// More rays than a thread takes at a time: those that meet something and those that don't, in turn.
    fn file(question: Question) -> RayFile {
        let rays = (0..QUEUE + 100).map(|k| ray(if k % 2 == 0 { 0.25 } else { 9.0 }, f32::INFINITY)).collect();
        RayFile { question, resolution: [0, 0], rays }
    }

    #[track_caller]
    fn finds(primitives: &Primitives, question: Question, t: [f32; 2], primitive: u32) {
        for (threads, mode) in [(1, Mode::Single), (1, Mode::Batch), (3, Mode::Single), (3, Mode::Batch)] {
            let (scene, _) = build("test", primitives, threads);
            let mut hits = Hits::default();
            let measured = measure(&scene, &file(question), mode, threads, Passes::Number(2), &mut hits);
            assert_eq!(measured.threads, threads);
            assert!(hits.t.chunks(2).all(|pair| pair == t), "{:?}", &hits.t[..2]);
            assert!(hits.primitive.chunks(2).all(|pair| pair == [primitive, NOTHING]));
            assert_eq!(measured.hits, hits.t.len() / 2);
            assert_eq!(measured.t_sum, f64::from(t[0]) * measured.hits as f64);
            assert_eq!(measured.per_second.count, 2);
        }
    }

    #[test]
    fn rays_of_all_threads_are_answered() {
        let positions = [[9.0, 9.0, 0.0], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(DVec3::from).to_vec();
        let mesh = Primitives::Mesh(Mesh { positions, normals: None, faces: vec![[0, 0, 0], [1, 2, 3]] });
        finds(&mesh, Question::Closest, [3.0, f32::INFINITY], 1);
        finds(&mesh, Question::Occlusion, [0.0, 0.0], 0);
        let sphere = |x| RawSphere { center: [x, 0.25, 0.0], radius: 1.0 };
        let spheres = Primitives::Spheres(vec![sphere(-5.0), sphere(-9.0), sphere(0.25)]);
        finds(&spheres, Question::Closest, [2.0, f32::INFINITY], 2);
        finds(&spheres, Question::Occlusion, [0.0, 0.0], 0);
    }

    #[test]
    fn rays_end_where_they_are_said_to_end() {
        let sphere = RawSphere { center: [0.25, 0.25, 0.0], radius: 1.0 };
        let (scene, _) = build("test", &Primitives::Spheres(vec![sphere]), 1);
        let rays = vec![ray(0.25, 2.0), ray(0.25, 2.0_f32.next_up())];
        for (question, mode) in [Question::Closest, Question::Occlusion]
            .into_iter()
            .flat_map(|question| Mode::ALL.map(|mode| (question, mode)))
        {
            let mut hits = Hits::default();
            let file = RayFile { question, resolution: [0, 0], rays: rays.clone() };
            measure(&scene, &file, mode, 1, Passes::Number(1), &mut hits);
            assert_eq!(hits.primitive, [NOTHING, 0], "{question:?}");
        }
    }
}
