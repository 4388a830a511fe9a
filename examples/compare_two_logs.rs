//! Where does arithmetic by hand depart from f64? The same pixel twice, and the first quantity that differs by more than a part.
//!
//!     cargo run --example compare_two_logs

use raywalk::log::{Event, What};
use raywalk::record::{self, Arithmetic};
use raywalk::scene::{OpenError, Scene};

fn main() -> Result<(), OpenError> {
    let scene = Scene::built_in("textbook")?;
    let pixel = scene.camera.resolution.map(|side| side / 2);
    let [by_hand, exact] =
        [Arithmetic::Decimal(3), Arithmetic::F64].map(|arithmetic| record::pixel(&scene, pixel, arithmetic));
    let values = |events: &[Event]| -> Vec<_> {
        let value = |event: &Event| match &event.what {
            What::Note { name, value } => Some((name.symbol(), *value)),
            _ => None,
        };
        events.iter().filter_map(value).collect()
    };
    for ((symbol, a), (_, b)) in values(&by_hand.events).into_iter().zip(values(&exact.events)) {
        let apart = a.components().iter().zip(b.components()).map(|(a, b)| (a - b).abs() / b.abs().max(1.0));
        if apart.fold(0.0, f64::max) > 1e-3 {
            println!("{symbol}: {a:?} by hand, {b:?} in f64");
            break;
        }
    }
    Ok(())
}
