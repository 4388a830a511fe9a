//! The texts of close-ups: a hit's vectors, the zones of a blurred bounce, the points of an area light.

use super::Text;

texts! {
    /// The texts of close-ups.
    CloseUp;
    /// The vectors at the hit of a ray, by its path.
    vectors(path: &str) = "Vectors at the hit of the ray {path}", "Vectores en la intersección del rayo {path}";
    /// How their figure is to be read.
    vectors_note =
        "Each figure lies in the plane of its vectors: its angles are those of the log.",
        "Cada figura está en el plano de sus vectores: sus ángulos son los del registro.";
    /// Two vectors, their product, their angle, the light that they are for.
    vector_columns: [Text; 4] = ["vectors", "product", "angle", "light"], ["vectores", "producto", "ángulo", "fuente"];
    /// The plane of the arriving ray and the normal.
    plane_of_incidence = "plane of incidence", "plano de incidencia";
    /// Nothing is transmitted.
    total_reflection = "total internal reflection", "reflexión total";
    /// The plane of the normal and the direction to a light.
    plane_of_light(light: &str) = "plane of N and L: light {light}", "plano de N y L: fuente {light}";
    /// The plane of the directions to a light and to the viewer.
    plane_of_view(light: &str) = "plane of L and V: light {light}", "plano de L y V: fuente {light}";
    /// The zones of a ray's hit.
    zones(path: &str) =
        "Zones of the blurred bounce at the hit of the ray {path}",
        "Zonas angulares en la intersección del rayo {path}";
    /// How their figure is to be read.
    zones_note =
        "Seen along the axis of the lobe; equal areas are equally likely, the angles are those from the axis.",
        "Vistas a lo largo del eje del lóbulo; áreas iguales son igual de probables, los ángulos se miden desde el eje.";
    /// Number, the direction's three parts, its angle from the axis, what became of it.
    zone_columns: [Text; 6] =
        ["zone", "x_z", "y_z", "z_z", "angle", "direction"],
        ["zona", "x_z", "y_z", "z_z", "ángulo", "dirección"];
    /// The lobe about a direction, with its exponent.
    lobe(middle: &str, exponent: &str) =
        "lobe cosⁿ about {middle}, n = {exponent}",
        "lóbulo cosⁿ alrededor de {middle}, n = {exponent}";
    /// A direction on the right side of the surface.
    kept = "kept", "aceptada";
    /// One on the wrong side.
    rejected = "rejected: wrong side of the surface", "rechazada: al otro lado de la superficie";
    /// The points of a light that a ray's hit asks.
    light(light: &str, path: &str) =
        "Light {light} at the hit of the ray {path}",
        "Fuente {light} en la intersección del rayo {path}";
    /// How their figure is to be read.
    light_note =
        "The area of a point is the weight of its shadow ray; hollow: blocked, or on the far side of a sphere.",
        "El área de un punto es el peso de su rayo de sombra; hueco: bloqueado, o en la cara oculta de una esfera.";
    /// How another area light of the hit is shown: its path and its name.
    another_light(path: &str, light: &str) =
        "--path '{path}' shows light {light}.",
        "--path '{path}' muestra la fuente {light}.";
    /// Number, point, weight, what passes, what it adds.
    light_columns: [Text; 5] = ["ray", "F", "weight", "τ", "adds"], ["rayo", "F", "peso", "τ", "aporta"];
    /// The sum of the weights.
    weights(sum: &str) = "sum of the weights: {sum}", "suma de los pesos: {sum}";
}
