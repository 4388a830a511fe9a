//! Triangles that a mesh has many times over.
//!
//! A file says a triangle between the same few corners in as few bytes as it likes, where what a ray needs of it takes ten times as many. So the tree
//! has each of them once, and knows which ones to go on with; they have one normal. Where a mesh has no more triangles than corners can
//! have around them, nobody looks for copies.

use crate::geometry::mesh::Mesh;
use std::collections::HashMap;
use std::collections::hash_map::Entry;

/// What ends a chain of copies.
const NONE: u32 = u32::MAX;

/// A closed mesh has two triangles a corner. From this many on, some are there more than once.
const PER_CORNER: usize = 8;

/// Fewer copies than these aren't worth a search.
const FEW: usize = 1 << 12;

/// Which triangles have the same corners in the same order.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Copies {
    /// For each triangle the next one that is a copy of it, in the order of the file; empty where there are none.
    next: Vec<u32>,
}

impl Copies {
    /// Those of a mesh, the places of normals, and the triangles that are copies of none; `None` where most are no copies.
    pub fn of(mesh: &Mesh) -> Option<(Copies, Vec<u32>, Vec<u32>)> {
        let count = mesh.faces.len();
        if count <= PER_CORNER * mesh.positions.len() + FEW {
            return None;
        }
        let mut latest: HashMap<[u32; 3], (u32, u32)> = HashMap::new();
        let (mut next, mut places, mut firsts) = (vec![NONE; count], Vec::with_capacity(count), Vec::new());
        for (number, corners) in (0..).zip(&mesh.faces) {
            match latest.entry(*corners) {
                Entry::Occupied(mut entry) => {
                    let (before, place) = *entry.get();
                    next[before as usize] = number;
                    places.push(place);
                    entry.insert((number, place));
                }
                Entry::Vacant(_) if firsts.len() > count / 2 => return None,
                Entry::Vacant(entry) => {
                    let place = firsts.len() as u32;
                    places.push(place);
                    firsts.push(number);
                    entry.insert((number, place));
                }
            }
        }
        Some((Copies { next }, places, firsts))
    }

    /// Whether there are any.
    #[inline(always)]
    pub fn are_there(&self) -> bool {
        !self.next.is_empty()
    }

    /// The copy after this one; none where it is known that there are none.
    #[inline(always)]
    pub fn after<const COPIES: bool>(&self, triangle: u32) -> Option<u32> {
        if !COPIES {
            return None;
        }
        self.next.get(triangle as usize).copied().filter(|next| *next != NONE)
    }
}
