//! Media in contact: stacks of slabs refract from the one into the other, with no air between them.

use super::world::{Frame, World};
use crate::random::Random;
use glam::DVec3;
use raywalk::log::{Decision, Log, Name, Step, Tree, Value, What};
use raywalk::record::{self, Arithmetic};
use serde_json::json;

/// A slab of a stack, in the coordinates of its frame.
struct Slab {
    bottom: f64,
    top: f64,
    /// Half the side of its square, or its radius.
    reach: f64,
    is_round: bool,
    ior: f64,
}

impl Slab {
    fn holds(&self, point: DVec3) -> bool {
        let across = if self.is_round { point.truncate().length() } else { point.x.abs().max(point.y.abs()) };
        across < self.reach && self.bottom < point.z && point.z < self.top
    }
}

fn ior_at(slabs: &[Slab], point: DVec3) -> f64 {
    slabs.iter().find(|slab| slab.holds(point)).map_or(1.0, |slab| slab.ior)
}

/// What a ray of a log came to at a surface.
pub struct Meeting {
    pub direction: DVec3,
    pub point: DVec3,
    pub normal: DVec3,
    /// The refractive indices before and behind; `None` where nothing was refracted.
    pub iors: Option<[f64; 2]>,
    pub refracted: Option<DVec3>,
    pub is_total: bool,
    pub coincident: usize,
}

pub fn triple(value: Value) -> DVec3 {
    let [x, y, z] = value.components() else { panic!("{value:?} is no triple") };
    DVec3::new(*x, *y, *z)
}

/// Where the rays of a log met surfaces.
pub fn meetings(log: &Log) -> Vec<Meeting> {
    let tree = Tree::of(&log.events);
    let mut found = Vec::new();
    for node in 0..tree.nodes().len() {
        let own: Vec<_> = tree.own_events(node).map(|index| &log.events[index]).collect();
        let given = |name: Name| {
            own.iter()
                .flat_map(|event| log.events.given(event))
                .find(|(known, _)| *known == name)
                .map(|(_, value)| *value)
        };
        let noted = |key: &str| {
            own.iter().find_map(|event| match event.what {
                What::Note { name, value } if name.key() == key => Some(value),
                _ => None,
            })
        };
        let is_ray = own.iter().any(|event| matches!(event.what, What::Enter { step: Step::Ray { .. }, .. }));
        let Some(point) = noted("hit.point").filter(|_| is_ray) else { continue };
        let direction = given(Name::RayDirection).or(noted("ray.direction")).expect("a direction");
        let mark = |is_it: fn(&Decision) -> bool| {
            own.iter().filter(|event| matches!(&event.what, What::Mark(decision) if is_it(decision))).count()
        };
        let number = |value: Value| value.components()[0];
        found.push(Meeting {
            direction: triple(direction),
            point: triple(point),
            normal: triple(noted("hit.normal").expect("a normal")),
            iors: given(Name::RefractEta1).zip(given(Name::RefractEta2)).map(|(one, two)| [number(one), number(two)]),
            refracted: noted("refract.direction").map(triple),
            is_total: mark(|decision| matches!(decision, Decision::TotalInternalReflection)) > 0,
            coincident: mark(|decision| matches!(decision, Decision::Coincident { .. })),
        });
    }
    found
}

const CUBE: [[u32; 3]; 12] = [
    [0, 2, 1],
    [0, 3, 2],
    [4, 5, 6],
    [4, 6, 7],
    [0, 1, 5],
    [0, 5, 4],
    [1, 2, 6],
    [1, 6, 5],
    [2, 3, 7],
    [2, 7, 6],
    [3, 0, 4],
    [3, 4, 7],
];

/// Two to six slabs one on the other, in a random order of the scene.
fn stack(frame: &Frame, is_upright: bool, random: &mut Random) -> (Vec<Slab>, World) {
    let mut between = |from: f64, to: f64| from + (to - from) * random.part();
    let mut heights = vec![between(-0.5, 0.5)];
    let mut slabs = Vec::new();
    for _ in 0..2 + (between(0.0, 5.0) as usize) {
        let bottom = *heights.last().expect("a height");
        let top = bottom + libm::pow(10.0, between(-2.0, 0.3));
        heights.push(top);
        let (reach, is_round) = (between(2.0, 4.0), between(0.0, 1.0) < 0.4);
        slabs.push(Slab { bottom, top, reach, is_round, ior: between(1.0, 2.5) });
    }
    let mut order: Vec<_> = (0..slabs.len()).collect();
    for k in (1..order.len()).rev() {
        order.swap(k, random.below(k + 1));
    }
    let mut world =
        World::seen(frame, [0.0, 0.0, 9.0], [0.0; 3], 40.0, [1, 1]).set("/tracing", json!({"max_depth": 6}));
    for index in order {
        let Slab { bottom, top, reach, is_round, ior } = slabs[index];
        let name = format!("glass {index}");
        let weights = json!({"local": 0, "reflected": 0.4, "transmitted": 0.6});
        world = world.material(&name, json!({"ior": ior, "weights": weights}));
        let [a, b] = [-reach, reach];
        world = if is_round {
            let ends = if random.below(2) == 0 { [bottom, top] } else { [top, bottom] };
            let [base, apex] = ends.map(|end| frame.at([0.0, 0.0, end]));
            let cylinder = json!({"base": base, "apex": apex, "radius": frame.length(reach), "caps": true});
            world.object(&name, json!({"cylinder": cylinder}))
        } else if is_upright && random.below(2) == 0 {
            world.object(&name, json!({"box": {"min": frame.at([a, a, bottom]), "max": frame.at([b, b, top])}}))
        } else {
            let ring = |height: f64| [[a, a, height], [b, a, height], [b, b, height], [a, b, height]];
            let corners: Vec<_> = ring(bottom).into_iter().chain(ring(top)).collect();
            world.mesh(&name, frame.mesh(&corners, &CUBE))
        };
    }
    (slabs, world)
}

#[test]
fn slabs_refract_from_one_into_the_next() {
    let mut random = Random::new(301);
    let (mut passed, mut total, mut contacts, mut unsure) = (0, 0, 0, 0);
    for case in 0..300 {
        let (far, scale) = [(0.0, 1.0), (3.0, 1e-4), (1e2, 1.0), (1e3, 1e3)][case % 4];
        let is_upright = random.below(2) == 0;
        let frame = match is_upright {
            true => Frame::upright(random.point() * (far * scale), scale),
            false => Frame::turned(&mut random, far, scale),
        };
        let (slabs, world) = stack(&frame, is_upright, &mut random);
        let scene = world.scene();
        for _ in 0..4 {
            let origin = frame.point((random.unit() * 9.0).to_array());
            let mut target = random.point() * 2.0;
            target.z = (slabs[0].bottom + slabs[slabs.len() - 1].top) / 2.0;
            let log = record::ray(&scene, origin, frame.point(target.to_array()) - origin, Arithmetic::F64);
            for meeting in meetings(&log) {
                let Some([eta_1, eta_2]) = meeting.iors else { continue };
                // What the slabs say of the places a little before and behind, unless an edge is near.
                let own = frame.own(meeting.point);
                let normal = frame.own(frame.point([0.0; 3]) + meeting.normal * scale);
                let across = normal.any_orthonormal_vector() * 1e-6;
                let aside = [DVec3::ZERO, across, -across, normal.cross(across), -normal.cross(across)];
                let [before, behind] =
                    [1e-7, -1e-7].map(|step| aside.map(|aside| ior_at(&slabs, own + normal * step + aside)));
                if [before, behind].iter().any(|iors| iors.iter().any(|ior| *ior != iors[0])) {
                    unsure += 1;
                    continue;
                }
                let right = [before[0], behind[0]];
                assert_eq!([eta_1, eta_2], right, "case {case} at {own}");
                let is_contact = right[0] != 1.0 && right[1] != 1.0;
                assert_eq!(meeting.coincident, usize::from(is_contact), "case {case} at {own}");
                contacts += usize::from(is_contact);
                let tangential = meeting.direction - meeting.normal * meeting.direction.dot(meeting.normal);
                let sine = tangential.length() * eta_1 / eta_2;
                if (sine - 1.0).abs() < 1e-9 {
                    unsure += 1;
                    continue;
                }
                assert_eq!(meeting.is_total, sine > 1.0, "case {case} at {own}: {sine}");
                match meeting.refracted {
                    Some(refracted) => {
                        passed += 1;
                        let along = refracted - meeting.normal * refracted.dot(meeting.normal);
                        let off = (along - tangential * (eta_1 / eta_2)).length();
                        assert!(off < 1e-12, "case {case} at {own}: off by {off:e}");
                    }
                    None => total += 1,
                }
            }
        }
    }
    assert!(
        passed > 10_000 && total > 500 && contacts > 8_000 && unsure < 100,
        "{passed}, {total}, {contacts}, {unsure}"
    );
}
