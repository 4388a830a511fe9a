//! A shape that is in a scene twice looks as it does alone in the other arithmetics, too.

use super::doubled::{MATERIALS, forms, with, world};
use super::world::{Frame, wrong};
use crate::random::Random;
use raywalk::record::Arithmetic;

#[test]
fn doubled_shapes_in_coarse_arithmetics() {
    let mut random = Random::new(601);
    let mut lit = 0;
    for arithmetic in [Arithmetic::F32, Arithmetic::Perturbed(1)] {
        for (far, scale) in [(0.0, 1.0), (30.0, 1.0), (3.0, 1e-3)] {
            let frame = Frame::turned(&mut random, far, scale);
            let world = world(&frame, [1.6, -2.5, 1.9], [12, 9]);
            for (name, form) in forms(&frame) {
                let material = MATERIALS[random.below(3)];
                let [single, double] =
                    [1, 2].map(|times| with(&world, &frame, &form, material, times, None).picture_in(arithmetic));
                let (count, worst) = wrong(&double, &single, 1e-3);
                let case = format!("{name} of {material} in {arithmetic}, {far} sizes of {scale} away");
                assert_eq!(count, 0, "{case}: off by {worst:e}");
                lit += double.iter().filter(|color| color.max_element() > 0.05).count();
            }
        }
    }
    assert!(lit > 6000, "{lit}");
}
