//! A probe of one's own: it sees every named quantity of the one tracing path, here to find the ray that grazes a surface most.
//!
//!     cargo run --example own_probe

use raywalk::log::{Name, Value};
use raywalk::probe::{Probe, Quantity};
use raywalk::sampling;
use raywalk::scene::{OpenError, Scene};

/// Keeps the least N·L.
struct Grazing(f64);

impl Probe for Grazing {
    fn note<Q: Quantity>(&mut self, name: Name, value: Q) -> Q {
        if let (Name::ShadeNDotL, Value::Number(n_dot_l)) = (name, value.value()) {
            self.0 = self.0.min(n_dot_l);
        }
        // The computation goes on with what is returned.
        value
    }
}

fn main() -> Result<(), OpenError> {
    let scene = Scene::built_in("glass-and-mirror")?;
    let [width, height] = scene.camera.resolution;
    let mut least = (1.0, [0, 0]);
    for pixel in (0..height).step_by(8).flat_map(|y| (0..width).step_by(8).map(move |x| [x, y])) {
        let mut probe = Grazing(1.0);
        sampling::pixel(&scene, pixel, &mut probe);
        if probe.0.abs() < least.0 {
            least = (probe.0.abs(), pixel);
        }
    }
    let ([x, y], cosine) = (least.1, least.0);
    println!("Light grazes a surface most in pixel {x},{y}: N·L = {cosine:.6}");
    println!("raywalk walk glass-and-mirror --pixel {x},{y}");
    Ok(())
}
