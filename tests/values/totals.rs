//! What the paths of a pixel come to together.

use crate::support::{middle, scene};
use raywalk::log::{Log, RayKind, Tree};
use raywalk::record::{self, Arithmetic};
use raywalk::report::contributions;
use raywalk::report::contributions::totals::{self, Common, Total};
use raywalk::scene::builtin;

fn traced(name: &str, arithmetic: Arithmetic) -> (Log, Tree) {
    let scene = scene(name);
    let log = record::pixel(&scene, middle(&scene), arithmetic);
    let tree = Tree::of(&log.events);
    (log, tree)
}

/// In every built-in scene the totals of each kind add up to the colour of the pixel.
#[test]
fn totals_add_up_to_the_colour() {
    let mut counts = [0; 3];
    for name in builtin::names() {
        let (log, tree) = traced(name, Arithmetic::F64);
        let account = contributions::account(&log, &tree, 0);
        let all = [
            totals::by_light(&account.contributions),
            totals::by_object(&account.contributions),
            totals::by_ray(&tree, &account.contributions),
        ];
        for (count, totals) in counts.iter_mut().zip(all) {
            *count = totals.len().max(*count);
            for channel in 0..3 {
                let sum: f64 = totals.iter().map(|total| total.color[channel]).sum();
                let whole = account.color[channel];
                assert!((sum - whole).abs() <= 1e-9 * whole.abs(), "{name}: {sum} of {whole}");
            }
        }
    }
    assert!(counts.iter().all(|count| *count >= 3), "nothing to add up: {counts:?}");
    // The numeric example: F brings 1·183.926 and what is local on the plane without its ambient light.
    let (log, tree) = traced("textbook", Arithmetic::Decimal(3));
    let contributions = contributions::account(&log, &tree, 0).contributions;
    let red = |totals: Vec<Total>, of: Common| totals.iter().find(|total| total.of == of).expect("it").color[0];
    let on_plane = red(totals::by_object(&contributions), Common::Object(0));
    assert!((on_plane - 104.838).abs() < 1e-3, "{on_plane}");
    let reflected = red(totals::by_ray(&tree, &contributions), Common::Ray(RayKind::Reflected));
    assert!((reflected - 289.296).abs() < 1e-3, "{reflected}");
    // K_a·I_a of both: 0.2·180 + 0.3·180.
    assert!((red(totals::by_light(&contributions), Common::Ambient) - 90.0).abs() < 1e-9);
}
