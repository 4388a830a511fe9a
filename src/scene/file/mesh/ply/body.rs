//! The body of a PLY file: its vertices and faces.

use std::ops::Range;

use glam::DVec3;

use super::header::{Element, Header, Kind, Property, Scalar, shown};
use super::values::Values;
use crate::scene::file::mesh::collect::{Collector, Corner, Run};
use crate::scene::file::mesh::fault::Fault;

/// What a property of a vertex or face is good for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Role {
    /// A coordinate of the position: x, y or z.
    Position(usize),
    /// A component of the normal.
    Normal(usize),
    /// The corners of a face or of strips.
    Corners,
    /// Nothing.
    Skipped,
}

/// The names of the properties that are good for something; `vertex_index` is what some writers call `vertex_indices`.
const OF_VERTICES: &[(&str, Role)] = &[
    ("x", Role::Position(0)),
    ("y", Role::Position(1)),
    ("z", Role::Position(2)),
    ("nx", Role::Normal(0)),
    ("ny", Role::Normal(1)),
    ("nz", Role::Normal(2)),
];
const OF_FACES: &[(&str, Role)] = &[("vertex_indices", Role::Corners), ("vertex_index", Role::Corners)];

/// The elements that have triangles, and how. In the lists of a strip -1 begins a new one.
const SURFACES: [(&str, Run); 2] = [("face", Run::Face), ("tristrips", Run::Strip)];

/// Reads what the header promises.
pub fn read(header: &Header, values: &mut impl Values) -> Result<Collector, Fault> {
    let vertices = find(header, &["vertex"], "vertices")?;
    let faces = find(header, &SURFACES.map(|(name, _)| name), "faces")?;
    let vertex_roles = roles(vertices, OF_VERTICES)?;
    let needed = [Role::Position(0), Role::Position(1), Role::Position(2)];
    if needed.iter().any(|role| !vertex_roles.contains(role)) {
        let message = "expected the properties `x`, `y` and `z` of the element `vertex`";
        return Err(Fault::wrong(vertices.span.clone(), message));
    }
    let no_faces = || Fault::wrong(faces.span.clone(), "the file has no faces, expected at least one");
    if !header.elements.iter().any(|element| run_of(element).is_some() && element.count > 0) {
        return Err(no_faces());
    }
    let normals = [Role::Normal(0), Role::Normal(1), Role::Normal(2)];
    let mut body = Body {
        values,
        mesh: Collector::default(),
        vertex_count: vertices.count,
        has_normals: normals.iter().all(|role| vertex_roles.contains(role)),
    };
    for element in &header.elements {
        body.check_room(element)?;
        match (run_of(element), element.name.as_str()) {
            (Some(run), _) => {
                let roles = roles_of_surface(element)?;
                body.records(element, |body| body.surface(run, element, &roles))?;
            }
            (None, "vertex") => body.records(element, |body| body.vertex(element, &vertex_roles))?,
            (None, _) => body.records(element, |body| body.skip(&element.properties))?,
        }
    }
    body.mesh.check_faces(no_faces())?;
    Ok(body.mesh)
}

/// How an element has triangles, if it does.
fn run_of(element: &Element) -> Option<Run> {
    SURFACES.iter().find(|(name, _)| *name == element.name).map(|(_, run)| *run)
}

fn find<'h>(header: &'h Header, names: &[&str], plural: &str) -> Result<&'h Element, Fault> {
    let found = header.elements.iter().find(|element| names.contains(&element.name.as_str()));
    found.ok_or_else(|| {
        let names = names.join("` or `");
        let message = format!("the file has no {plural}, expected an element `{names}` in its header");
        Fault::wrong(0..header.length.min(3), message)
    })
}

fn roles_of_surface(element: &Element) -> Result<Vec<Role>, Fault> {
    let roles = roles(element, OF_FACES)?;
    if roles.contains(&Role::Corners) || element.count == 0 {
        return Ok(roles);
    }
    let message = format!("expected the property `list uchar int vertex_indices` of the element `{}`", element.name);
    Err(Fault::wrong(element.span.clone(), message))
}

fn roles(element: &Element, known: &[(&str, Role)]) -> Result<Vec<Role>, Fault> {
    let mut roles = Vec::new();
    for property in &element.properties {
        let role = known.iter().find(|(name, _)| *name == property.name).map_or(Role::Skipped, |(_, role)| *role);
        let is_fitting = match (role, property.kind) {
            (Role::Skipped, _) => true,
            (Role::Corners, Kind::List { item, .. }) => !matches!(item, Scalar::F32 | Scalar::F64),
            (Role::Corners, Kind::Scalar(_)) => false,
            (Role::Position(_) | Role::Normal(_), Kind::Scalar(_)) => true,
            (Role::Position(_) | Role::Normal(_), Kind::List { .. }) => false,
        };
        let name = &property.name;
        if !is_fitting {
            let expected = if role == Role::Corners { "a list of whole numbers" } else { "a number" };
            return Err(Fault::wrong(property.span.clone(), format!("expected `{name}` to be {expected}")));
        }
        if role != Role::Skipped && roles.contains(&role) {
            let message = format!("the property `{name}` occurs twice, expected it once");
            return Err(Fault::wrong(property.span.clone(), message));
        }
        roles.push(role);
    }
    Ok(roles)
}

struct Body<'v, V> {
    values: &'v mut V,
    mesh: Collector,
    vertex_count: u64,
    has_normals: bool,
}

impl<V: Values> Body<'_, V> {
    /// A count is believed only as far as the file has bytes for it.
    fn check_room(&self, element: &Element) -> Result<(), Fault> {
        let room = self.values.room_for(&mut element.properties.iter().map(|property| property.kind));
        if element.count <= room || element.properties.is_empty() {
            return Ok(());
        }
        let (count, name) = (element.count, shown(&element.name));
        let message = format!("the header promises {count} of `{name}`, the file has room for {room} at most");
        Err(Fault::wrong(element.span.clone(), message))
    }

    fn records(
        &mut self,
        element: &Element,
        mut read: impl FnMut(&mut Self) -> Result<(), Fault>,
    ) -> Result<(), Fault> {
        if element.properties.is_empty() {
            return Ok(());
        }
        for number in 0..element.count {
            self.values.begin_record();
            let read = read(self).and_then(|()| self.values.end_record());
            read.map_err(|fault| fault.inside(|| format!("{} {number}", shown(&element.name))))?;
        }
        Ok(())
    }

    fn vertex(&mut self, element: &Element, roles: &[Role]) -> Result<(), Fault> {
        let (mut position, mut normal) = ([0.0; 3], [0.0; 3]);
        let mut place = 0..0;
        for (property, role) in element.properties.iter().zip(roles) {
            let (slot, scalar) = match (role, property.kind) {
                (Role::Position(axis), Kind::Scalar(scalar)) => (&mut position[*axis], scalar),
                (Role::Normal(axis), Kind::Scalar(scalar)) => (&mut normal[*axis], scalar),
                _ => {
                    self.skip(std::slice::from_ref(property))?;
                    continue;
                }
            };
            let (value, span) = self.values.next(scalar)?;
            if !value.is_finite() && matches!(role, Role::Position(_)) {
                let name = &property.name;
                return Err(Fault::wrong(span, format!("expected a finite `{name}`, found {value}")));
            }
            (*slot, place) = (value, span);
        }
        if self.has_normals {
            self.mesh.normal(DVec3::from(normal), place.clone())?;
        }
        self.mesh.vertex(DVec3::from(position), place)
    }

    fn surface(&mut self, run: Run, element: &Element, roles: &[Role]) -> Result<(), Fault> {
        for (property, role) in element.properties.iter().zip(roles) {
            let (Role::Corners, Kind::List { count, item }) = (role, property.kind) else {
                self.skip(std::slice::from_ref(property))?;
                continue;
            };
            let (corners, start) = self.count(count)?;
            for _ in 0..corners {
                let (vertex, span) = self.values.next(item)?;
                if run == Run::Strip && begins_strip(vertex, item) {
                    self.mesh.end(run, span)?;
                    continue;
                }
                let corner = self.existing(vertex, &span)?;
                self.mesh.corner(run, corner, span)?;
            }
            self.mesh.end(run, start)?;
        }
        Ok(())
    }

    fn existing(&self, vertex: f64, span: &Range<usize>) -> Result<Corner, Fault> {
        // The header may count the faces before the vertices, so what counts is what it promises.
        if (0.0..self.vertex_count as f64).contains(&vertex) {
            let vertex = vertex as u32;
            return Ok(Corner { vertex, normal: self.has_normals.then_some(vertex) });
        }
        let count = self.vertex_count;
        Err(Fault::wrong(span.clone(), format!("there is no vertex {vertex}, the file has {count}, counted from 0")))
    }

    fn skip(&mut self, properties: &[Property]) -> Result<(), Fault> {
        for property in properties {
            match property.kind {
                Kind::Scalar(scalar) => self.values.skip(scalar)?,
                Kind::List { count, item } => {
                    for _ in 0..self.count(count)?.0 {
                        self.values.skip(item)?;
                    }
                }
            }
        }
        Ok(())
    }

    /// The count of a list.
    fn count(&mut self, scalar: Scalar) -> Result<(u64, Range<usize>), Fault> {
        let (count, span) = self.values.next(scalar)?;
        if count < 0.0 {
            return Err(Fault::wrong(span, format!("expected the count of a list, found {count}")));
        }
        Ok((count as u64, span))
    }
}

/// Whether this entry among the vertices of a strip begins a new one: -1, which as a number without a sign is the largest.
fn begins_strip(vertex: f64, item: Scalar) -> bool {
    vertex == -1.0 || (item == Scalar::U32 && vertex == f64::from(u32::MAX))
}
