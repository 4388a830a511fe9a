//! Random numbers, the same in every run (Steele et al., Fast splittable pseudorandom number generators, 2014).

// Each test file compiles this for itself and uses a part of it.
#![allow(dead_code)]

use glam::DVec3;

pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Random {
        Random(seed.wrapping_mul(0xd134_2543_de82_ef95))
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// From 0 to 1.
    pub fn part(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// In the cube from −1 to 1.
    pub fn point(&mut self) -> DVec3 {
        let mut number = || 2.0 * self.part() - 1.0;
        DVec3::new(number(), number(), number())
    }

    /// A direction, every one as likely as the others.
    pub fn unit(&mut self) -> DVec3 {
        loop {
            let point = self.point();
            let length = point.length();
            if (0.01..1.0).contains(&length) {
                return point / length;
            }
        }
    }

    pub fn below(&mut self, count: usize) -> usize {
        (self.bits() % count as u64) as usize
    }
}
