//! The picture that is rendered in the background while the viewer shows it.

use raywalk::log::plane::Plane;
use raywalk::log::{Unit, Value};
use raywalk::record::Arithmetic;
use raywalk::render::layers::Planes;
use raywalk::render::{export, preview};
use raywalk::report::words::plain;
use raywalk::scene::{Sampling, Scene};
use raywalk::threads::work_alone;
use raywalk::tui::{COARSEST, Dot, Image, Named, Shows};
use std::collections::BTreeSet;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

/// How long a picture in the making is kept back between two that are shown.
const PAUSE: Duration = Duration::from_millis(100);

/// How long the viewer waits for a picture where no thread can be started for it: what has been rendered by then is shown.
const PATIENCE: Duration = Duration::from_secs(1);

/// What is rendered.
#[derive(Clone)]
pub struct Subject {
    pub scene: Arc<Scene>,
    pub arithmetic: Arithmetic,
    /// What was asked for by name: one plane.
    pub planes: Option<Planes>,
}

impl Subject {
    /// The dot of a pixel; what one ray through its middle says, if it is rough.
    fn dot(&self, pixel: [u32; 2], is_rough: bool) -> Dot {
        let Subject { scene, arithmetic, planes } = self;
        let Some(planes) = planes else {
            let of = if is_rough { preview::rough_dot } else { preview::dot };
            return shown(of(scene, pixel, *arithmetic), is_rough);
        };
        let (dot, numbers) = preview::named_dot(scene, pixel, *arithmetic, planes, is_rough);
        let value = match numbers[..] {
            [x, y, z] => Value::Triple([x, y, z]),
            _ => Value::Number(numbers.first().copied().unwrap_or(f64::NAN)),
        };
        let named = Some(value).filter(|value| value.components().iter().all(|x| x.is_finite()));
        Dot { named, ..shown(dot, is_rough) }
    }

    /// What was asked for, as the viewer knows it.
    fn named(&self) -> Option<Named> {
        let plane = self.planes.as_ref()?.names().first()?;
        let shows = match plane {
            Plane::Value(value) if !value.is_triple() => Shows::Numbers,
            Plane::Value(value) if value.name.unit() != Unit::Intensity => Shows::Triples,
            _ => Shows::Light,
        };
        let title = match plane {
            Plane::Value(value) => value.to_string(),
            other => other.to_string(),
        };
        Some(Named { title: plain(&title), shows })
    }
}

/// The thread that renders, and what it has. Dropping it ends the work.
pub struct Rendering {
    shared: Arc<Shared>,
    thread: Option<JoinHandle<()>>,
}

struct Shared {
    /// The latest picture, until somebody takes it.
    latest: Mutex<Option<Arc<Image>>>,
    stop: AtomicBool,
}

/// The picture without any dots.
pub fn empty(subject: &Subject) -> Arc<Image> {
    let scene = &subject.scene;
    let output = scene.output;
    let levels = move |color: [f64; 3], stops: f64| export::levels(color, &output, stops);
    let mut empty = Image::empty(scene.camera.resolution, Arc::new(levels));
    // Who asks for an exposure gets it.
    if output.exposure == 0.0 {
        empty.white = output.white;
    }
    empty.named = subject.named();
    Arc::new(empty)
}

/// The picture with the dots of these pixels.
pub fn of(subject: &Subject, pixels: Vec<[u32; 2]>) -> Arc<Image> {
    let mut image = Image::clone(&empty(subject));
    let numbers: BTreeSet<usize> = pixels.into_iter().map(|pixel| image.index(pixel)).collect();
    fill_between(&mut image, &numbers, subject);
    let pixel = |number: &usize| {
        [number % image.columns() as usize, number / image.columns() as usize].map(|at| at as u32 * image.step)
    };
    let dots = preview::all_dots(numbers.iter().map(pixel).collect(), |pixel| subject.dot(pixel, false));
    for (number, dot) in numbers.into_iter().zip(dots) {
        image.dots[number] = Some(dot);
    }
    Arc::new(image)
}

/// Gives the other dots of the rectangle that these lie in what one ray says of each: a cell of the screen shows the mean of its dots.
fn fill_between(image: &mut Image, numbers: &BTreeSet<usize>, subject: &Subject) {
    let (columns, step) = (image.columns(), image.step);
    let places = || numbers.iter().map(|number| [*number as u32 % columns, *number as u32 / columns]);
    let Some(least) = places().reduce(|a, b| [0, 1].map(|axis| a[axis].min(b[axis]))) else { return };
    let most = places().fold(least, |a, b| [0, 1].map(|axis| a[axis].max(b[axis])));
    let place = |offset: [u32; 2]| [0, 1].map(|axis| least[axis] + offset[axis]);
    let dot = |offset| subject.dot(place(offset).map(|number| number * step), true);
    let publish = |dots: Vec<([u32; 2], Dot)>| {
        for (offset, dot) in dots {
            let [column, row] = place(offset);
            image.dots[(row * columns + column) as usize] = Some(dot);
        }
    };
    let grid = [0, 1].map(|axis| most[axis] - least[axis] + 1);
    preview::in_passes(grid, COARSEST, dot, publish, &AtomicBool::new(false));
}

fn shown(preview::Dot { color, depth, rays, samples }: preview::Dot, is_rough: bool) -> Dot {
    Dot { color: color.to_array(), depth, rays, samples, error: None, named: None, is_rough }
}

impl Rendering {
    /// Begins to render, on a thread of its own; the whole picture, if nothing is shown before it.
    pub fn start(subject: Subject, whole: bool) -> Rendering {
        let empty = empty(&subject);
        let shared = Arc::new(Shared { latest: Mutex::new(Some(Arc::clone(&empty))), stop: AtomicBool::new(false) });
        let empty = Image::clone(&empty);
        if whole {
            shared.render(&subject, empty, None);
            return Rendering { shared, thread: None };
        }
        let (of_thread, of_subject, image) = (Arc::clone(&shared), subject.clone(), empty.clone());
        let work = move || {
            work_alone();
            of_thread.render(&of_subject, image, None);
        };
        let thread = thread::Builder::new().name("picture".to_owned()).spawn(work).ok();
        if thread.is_none() {
            shared.render(&subject, empty, Some(Instant::now() + PATIENCE));
        }
        Rendering { shared, thread }
    }

    /// The latest picture, if there is one that wasn't taken yet.
    pub fn latest(&self) -> Option<Arc<Image>> {
        self.shared.latest.lock().unwrap_or_else(PoisonError::into_inner).take()
    }

    /// Waits for the whole picture.
    pub fn finish(&mut self) {
        if let Some(thread) = self.thread.take() {
            // A panic there is no reason to end the viewer: it keeps the picture that it has.
            let _ = thread.join();
        }
    }
}

impl Drop for Rendering {
    fn drop(&mut self) {
        self.shared.stop.store(true, Ordering::Relaxed);
        self.finish();
    }
}

impl Shared {
    /// Renders the picture, or as much of it as there is time for.
    fn render(&self, subject: &Subject, mut image: Image, until: Option<Instant>) {
        let scene = &subject.scene;
        let grid = [image.columns(), image.rows()];
        let (step, columns) = (image.step, image.columns() as usize);
        let pixel = |place: [u32; 2]| place.map(|number| number * step);
        let index = move |[column, row]: [u32; 2]| row as usize * columns + column as usize;
        let mut clock = Clock(Instant::now());
        // One sample of each pixel is there soon, however many it has.
        let has_more = !matches!(scene.sampling, Sampling::Center {});
        for is_rough in [true, false].into_iter().filter(|is_rough| has_more || !is_rough) {
            let publish = |dots: Vec<([u32; 2], Dot)>| {
                for (place, dot) in dots {
                    image.dots[index(place)] = Some(dot);
                }
                clock.publish(self, &image);
                if until.is_some_and(|until| Instant::now() >= until) {
                    self.stop.store(true, Ordering::Relaxed);
                }
            };
            preview::in_passes(grid, COARSEST, |place| subject.dot(pixel(place), is_rough), publish, &self.stop);
        }
        self.put(&image);
        let colors: Vec<_> = image.dots.iter().map(|dot| dot.map(|dot| dot.color)).collect();
        let error = |place| {
            let color = colors[index(place)]?;
            Some(preview::error_of_single(scene, pixel(place), color.into()))
        };
        let publish = |errors: Vec<([u32; 2], Option<f64>)>| {
            for (place, error) in errors {
                if let Some(dot) = &mut image.dots[index(place)] {
                    dot.error = error;
                }
            }
            clock.publish(self, &image);
        };
        preview::in_passes(grid, COARSEST, error, publish, &self.stop);
        self.put(&image);
    }

    fn put(&self, image: &Image) {
        *self.latest.lock().unwrap_or_else(PoisonError::into_inner) = Some(Arc::new(image.clone()));
    }
}

/// When a picture was shown last.
struct Clock(Instant);

impl Clock {
    fn publish(&mut self, shared: &Shared, image: &Image) {
        if self.0.elapsed() >= PAUSE {
            shared.put(image);
            self.0 = Instant::now();
        }
    }
}
