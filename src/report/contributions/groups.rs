//! Contributions of one kind taken together: of all samples of a pixel, and of all rays of a split.

use super::{Contribution, Origin};
use std::collections::HashMap;

/// Paths that differ only in their sample, or in their number among the rays of a split.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// Their sum. Path and weight are those that all have; the event is that of the greatest.
    pub sum: Contribution,
    /// How many they are.
    pub count: usize,
}

/// The groups, the greatest first.
pub fn groups(contributions: &[Contribution]) -> Vec<Group> {
    let mut places: HashMap<(u32, Origin, &str), usize> = HashMap::new();
    let mut groups: Vec<Group> = Vec::new();
    for one in contributions {
        let place = *places.entry((one.way.number, one.origin, one.class.as_str())).or_insert(groups.len());
        match groups.get_mut(place) {
            None => groups.push(Group { sum: one.clone(), count: 1 }),
            Some(Group { sum, count }) => {
                sum.path = without_numbers(&one.path);
                sum.color = std::array::from_fn(|channel| sum.color[channel] + one.color[channel]);
                sum.share += one.share;
                *count += 1;
            }
        }
    }
    groups.sort_by(|a, b| b.sum.share.abs().total_cmp(&a.sum.share.abs()));
    groups
}

/// A path without the number of its sample, and without those of splits: `3 C R.2 S1` is `C R S1`.
fn without_numbers(path: &str) -> String {
    let of_rays = path.split(' ').filter(|step| !step.starts_with(|first: char| first.is_ascii_digit()));
    let steps = of_rays.map(|step| step.split_once('.').map_or(step, |(step, _)| step));
    steps.collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::super::LightPath;
    use super::*;

    fn one((path, number): (&str, u32), light: u32, red: f64) -> Contribution {
        Contribution {
            origin: Origin::Light { light, object: 0 },
            path: path.to_owned(),
            way: LightPath { number, ..LightPath::default() },
            weight: [1.0; 3],
            own: [red, 0.0, 0.0],
            color: [red, 0.0, 0.0],
            share: red,
            class: "LDE".to_owned(),
            cases: "",
            event: Some(red as usize),
        }
    }

    #[test]
    fn samples_and_splits_are_summed() {
        let all = [
            one(("1 C R.2 S1", 1), 0, 4.0),
            one(("1 C S2", 2), 1, 3.0),
            one(("12 C R.11 S1", 1), 0, 1.0),
            one(("2 C S2", 2), 1, 3.0),
        ];
        let groups = groups(&all);
        let shown: Vec<_> =
            groups.iter().map(|group| (group.sum.path.as_str(), group.count, group.sum.color[0])).collect();
        assert_eq!(shown, [("C S2", 2, 6.0), ("C R S1", 2, 5.0)]);
        assert_eq!(groups[1].sum.event, Some(4));
        assert_eq!(groups[0].sum.share + groups[1].sum.share, 11.0);
        let alone = super::groups(&all[..1]);
        assert_eq!((alone[0].sum.path.as_str(), alone[0].count), ("1 C R.2 S1", 1));
    }
}
