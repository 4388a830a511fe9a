//! Shapes as NFF gives them: a negative radius turns a surface inside out.

use crate::scene::file::schema::{Cone, Cylinder, Polygon, Shape, Sphere, Triangle, Vec3};
use crate::scene::file::validate::vector::has_area;

/// A sphere; the radius must not be 0.
pub fn sphere(center: Vec3, radius: f64) -> Result<Shape, String> {
    if radius == 0.0 {
        return Err("the radius of a sphere must not be 0".to_string());
    }
    Ok(Shape::Sphere(Sphere { center, radius: radius.abs(), inward: radius < 0.0 }))
}

/// An open cone, or a cylinder where both radii are the same.
pub fn cone(base: Vec3, base_radius: f64, apex: Vec3, apex_radius: f64) -> Result<Shape, String> {
    if base == apex {
        return Err("the ends of a cone must not coincide".to_string());
    }
    if base_radius == 0.0 && apex_radius == 0.0 {
        return Err("the radii of a cone must not both be 0".to_string());
    }
    if base_radius.min(apex_radius) < 0.0 && base_radius.max(apex_radius) > 0.0 {
        return Err(format!(
            "the radii of a cone must have one sign (both negative: the inside is seen), found {base_radius} and \
             {apex_radius}"
        ));
    }
    let inward = base_radius < 0.0 || apex_radius < 0.0;
    let (base_radius, apex_radius) = (base_radius.abs(), apex_radius.abs());
    Ok(if base_radius == apex_radius {
        Shape::Cylinder(Box::new(Cylinder { base, apex, radius: base_radius, caps: false, inward }))
    } else {
        Shape::Cone(Box::new(Cone { base, base_radius, apex, apex_radius, caps: false, inward }))
    })
}

/// A polygon of three or more corners, with normals or without; `None` when it has no area, so that no ray can hit it.
pub fn polygon(vertices: Vec<Vec3>, normals: Option<Vec<Vec3>>) -> Option<Shape> {
    if !has_area(&vertices) {
        return None;
    }
    if let [a, b, c] = vertices[..] {
        let normals = normals.and_then(|normals| <[Vec3; 3]>::try_from(normals).ok()).map(Box::new);
        return Some(Shape::Triangle(Box::new(Triangle { vertices: [a, b, c], normals })));
    }
    Some(Shape::Polygon(Box::new(Polygon { vertices, normals })))
}
