//! Close-ups in Spanish.

use crate::report::language::close_up::CloseUp;

pub(super) const CLOSE_UP: CloseUp = CloseUp {
    vectors: |path| format!("Vectores en la intersección del rayo {path}"),
    vectors_note: "Cada figura está en el plano de sus vectores: sus ángulos son los del registro.",
    vector_columns: ["vectores", "producto", "ángulo", "fuente"],
    plane_of_incidence: "plano de incidencia",
    total_reflection: "reflexión total",
    plane_of_light: |light| format!("plano de N y L: fuente {light}"),
    plane_of_view: |light| format!("plano de L y V: fuente {light}"),
    zones: |path| format!("Zonas angulares en la intersección del rayo {path}"),
    zones_note: "Vistas a lo largo del eje del lóbulo; áreas iguales son igual de probables, los ángulos se miden desde el eje.",
    zone_columns: ["zona", "x_z", "y_z", "z_z", "ángulo", "dirección"],
    lobe: |middle, exponent| format!("lóbulo cosⁿ alrededor de {middle}, n = {exponent}"),
    kept: "aceptada",
    rejected: "rechazada: al otro lado de la superficie",
    light: |light, path| format!("Fuente {light} en la intersección del rayo {path}"),
    light_note: "El área de un punto es el peso de su rayo de sombra; hueco: bloqueado, o en la cara oculta de una esfera.",
    another_light: |path, light| format!("--path '{path}' muestra la fuente {light}."),
    light_columns: ["rayo", "F", "peso", "τ", "aporta"],
    weights: |sum| format!("suma de los pesos: {sum}"),
};
