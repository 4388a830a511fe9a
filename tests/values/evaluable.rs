//! From a log alone every quantity can be evaluated: each noted value by its formula on logged operands, bit for bit or within its
//! bound, and the result by the last of them. Over random scenes, samplers and arithmetics.

use crate::formulas::verdict;
use crate::random::Random;
use crate::random_scenes;
use proptest::prelude::*;
use raywalk::log::{Log, Name, Tree, Value, What};
use raywalk::record::{self, Arithmetic};
use raywalk::report::evaluate::{evaluate, result};

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn every_quantity_of_a_log_can_be_evaluated(seed in any::<u64>()) {
        let scene = if seed % 3 == 0 { random_scenes::adaptive(seed) } else { random_scenes::scene(seed) };
        let mut random = Random::new(!seed);
        let by_hand = [Arithmetic::Decimal(3), Arithmetic::DecimalProducts(3)];
        let arithmetics = [Arithmetic::F64, Arithmetic::F32, by_hand[0], by_hand[1], Arithmetic::Perturbed(seed)];
        for arithmetic in arithmetics {
            let pixel = [random.below(9) as u32, random.below(7) as u32];
            let log = record::pixel(&scene, pixel, arithmetic);
            let wrong = wrong(&log, arithmetic);
            prop_assert!(wrong.is_empty(), "{arithmetic}, {pixel:?}: {wrong:#?}");
        }
    }
}

/// What can't be evaluated, or comes to another value.
fn wrong(log: &Log, arithmetic: Arithmetic) -> Vec<String> {
    let (events, tree) = (&log.events, Tree::of(&log.events));
    let mut wrong = Vec::new();
    for (at, event) in events.iter().enumerate() {
        for (name, value) in log.given(at) {
            // An input with a formula of its own; others under names of quantities were passed on.
            let is_made = *name == Name::PixelSide;
            if is_made
                && evaluate(log, &tree, at, *name).is_none_or(|found| found.is_ok_and(|found| !found.same_bits(value)))
            {
                wrong.push(format!("{name:?} is {value:?}"));
            }
        }
        match event.what {
            What::Note { name, .. } => match verdict(log, &tree, at, arithmetic) {
                None => wrong.push(format!("{name:?} has no formula")),
                Some(Ok(())) => {}
                Some(Err(why)) => wrong.push(format!("event {}: {why}", event.at)),
            },
            What::Result { color } => {
                let brought = result(events, &tree, 0);
                if brought.is_none_or(|brought| !brought.same_bits(&Value::Triple(color))) {
                    wrong.push(format!("the result is {color:?}, the last colour {brought:?}"));
                }
            }
            _ => {}
        }
    }
    wrong
}
