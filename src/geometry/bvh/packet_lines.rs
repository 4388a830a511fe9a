//! The rays of a packet, side by side.

use super::lanes::Eight;
use super::space::{Distance, LEAST, NEAR, OF_BOX, ROUNDINGS, Space, U, WIDEST};
use crate::geometry::line::Line;

/// The most rays in a packet.
pub const PACKET: usize = 8;

/// A number for each ray of a packet.
pub type PerRay<T> = [T; PACKET];

/// The rays of a packet, a bit for each.
pub type RayMask = u32;

/// The numbers of the rays in a set.
#[inline(always)]
pub fn each(rays: RayMask) -> impl Iterator<Item = usize> {
    let mut rest = rays;
    std::iter::from_fn(move || {
        let ray = rest.trailing_zeros() as usize;
        rest &= rest.wrapping_sub(1);
        (ray < PACKET).then_some(ray)
    })
}

/// Lines, one in each lane.
pub(super) struct Lines {
    pub origin: [PerRay<f64>; 3],
    pub direction: [PerRay<f64>; 3],
    pub unit: PerRay<f64>,
    pub t_min: PerRay<f64>,
    pub t_max: PerRay<f64>,
}

impl Lines {
    pub const NONE: Lines = Lines {
        origin: [[0.0; PACKET]; 3],
        direction: [[1.0; PACKET]; 3],
        unit: [1.0; PACKET],
        t_min: [0.0; PACKET],
        t_max: [-1.0; PACKET],
    };

    /// Puts a line into a lane, which reaches that far.
    #[inline(always)]
    pub fn set(&mut self, at: usize, line: &Line, t_max: f64) {
        for axis in 0..3 {
            self.origin[axis][at] = line.origin[axis];
            self.direction[axis][at] = line.direction[axis];
        }
        (self.unit[at], self.t_min[at], self.t_max[at]) = (line.unit, line.t_min, t_max);
    }
}

/// The rays in the tree's space, one in each lane.
pub(super) struct Local {
    pub origin: [Eight; 3],
    pub direction: [Eight; 3],
    pub inverse: [Eight; 3],
    pub near: [Eight; 3],
    pub far: [Eight; 3],
    pub near_side: [usize; 3],
    pub slack: Eight,
    pub t_min: Eight,
    pub t_max: Eight,
    pub distance: PerRay<Distance>,
    /// Between which distances a crossing certainly counts.
    pub sure: PerRay<Option<[f32; 2]>>,
}

impl Local {
    pub const NONE: Local = Local {
        origin: [[0.0; 8]; 3],
        direction: [[0.0; 8]; 3],
        inverse: [[0.0; 8]; 3],
        near: [[0.0; 8]; 3],
        far: [[0.0; 8]; 3],
        near_side: [0; 3],
        slack: [0.0; 8],
        t_min: [0.0; 8],
        t_max: [f32::NEG_INFINITY; 8],
        distance: [Distance::NONE; PACKET],
        sure: [None; PACKET],
    };

    /// The last distance that matters to any ray; nothing matters to one that has ended.
    #[inline(always)]
    pub fn farthest(&self) -> f32 {
        self.t_max.iter().fold(f32::NEG_INFINITY, |farthest, t| if *t > farthest { *t } else { farthest })
    }
}

impl Space {
    /// The same for several lines at once. The slack of one of which [`Space::ray`] has no ray is at least [`WIDEST`].
    // The same operations lane by lane, without a branch, so that the compiler puts lanes side by side.
    #[inline(always)]
    pub fn rays(&self, lines: &Lines, local: &mut Local) {
        let Lines { origin: [o_x, o_y, o_z], direction: [d_x, d_y, d_z], unit, t_min, t_max } = lines;
        let [c_x, c_y, c_z] = self.center.to_array();
        let scale = self.scale;
        let (mut shifts, mut slacks) = ([0.0; PACKET], [0.0; PACKET]);
        for at in 0..PACKET {
            let (x, y, z) = ((o_x[at] - c_x) * scale, (o_y[at] - c_y) * scale, (o_z[at] - c_z) * scale);
            let along = x * d_x[at] + y * d_y[at] + z * d_z[at];
            let is_far = x * x + y * y + z * z > NEAR;
            let shift = if is_far { -along - 2.0 } else { 0.0 };
            let size = x.abs() + y.abs() + z.abs();
            let offset = (o_x[at].abs() + o_y[at].abs() + o_z[at].abs()) * scale;
            let slack = ROUNDINGS * (size + shift.abs() + offset + 8.0);
            // What is no number is no slack, either.
            slacks[at] = if slack < f64::from(WIDEST) { slack } else { f64::from(WIDEST) };
            shifts[at] = shift;
            local.origin[0][at] = (x + d_x[at] * shift) as f32;
            local.origin[1][at] = (y + d_y[at] * shift) as f32;
            local.origin[2][at] = (z + d_z[at] * shift) as f32;
        }
        for at in 0..PACKET {
            local.direction[0][at] = d_x[at] as f32;
            local.direction[1][at] = d_y[at] as f32;
            local.direction[2][at] = d_z[at] as f32;
            local.slack[at] = slacks[at] as f32 * (1.0 + 4.0 * U);
        }
        for axis in 0..3 {
            for at in 0..PACKET {
                let direction = local.direction[axis][at];
                let along = if direction.abs() < LEAST { LEAST.copysign(direction) } else { direction };
                let inverse = 1.0 / along;
                let center = local.origin[axis][at] * inverse;
                let around = inverse.abs() * (OF_BOX + local.slack[at]);
                local.inverse[axis][at] = inverse;
                local.near[axis][at] = center + around;
                local.far[axis][at] = center - around;
            }
        }
        for at in 0..PACKET {
            let distance = Distance { unit: scale, scale: unit[at] * scale, shift: shifts[at], slack: slacks[at] };
            local.t_min[at] = distance.earliest(t_min[at]);
            local.t_max[at] = distance.latest(t_max[at]);
            local.distance[at] = distance;
        }
    }
}
