//! What the symbols mean, in the words of the source text (Ramos, "Trazado de rayos").

mod sampling;
mod shapes;

use crate::report::language::{Language, Text};

/// Signs of formulas, paths and classes, with what they mean.
const SIGNS: &[(Text, [Text; 2])] = &[
    (
        "C R S1",
        [
            "path of a ray: C from the eye, R reflected, T transmitted, S1 to the first light",
            "camino de un rayo: C primario, R reflejado, T transmitido, S1 hacia la primera fuente",
        ],
    ),
    (
        "R.2",
        [
            "the second of several rays of its kind from one place",
            "el segundo de varios rayos iguales desde un mismo punto",
        ],
    ),
    (
        "L(D|S)E",
        [
            "class of a path of light: L light, D diffuse or S mirror or lens, E eye",
            "clase de un camino de la luz: L fuente, D difusa o S especular, E ojo",
        ],
    ),
    ("A, B", ["first in a class: ambient light, background", "al principio de una clase: luz ambiente, fondo"]),
    (
        "TR(C R, 1)",
        [
            "a call of the algorithm: the path of its ray, its depth",
            "una llamada del algoritmo: el camino de su rayo, su profundidad",
        ],
    ),
    ("a · b", ["dot product", "producto escalar"]),
    ("a × b", ["cross product", "producto vectorial"]),
    ("a∘b", ["channel by channel: red, green, blue", "canal a canal: rojo, verde, azul"]),
    ("|a|", ["length", "longitud"]),
    ("x⁺", ["x, or 0 where it is negative", "x, o 0 donde es negativo"]),
    (
        "Σ, Π",
        [
            "sum over the lights; product over the surfaces in between",
            "suma sobre las fuentes; producto sobre las superficies intermedias",
        ],
    ),
];

/// What quantities mean, by their keys in a log; those of shapes and of sampling have tables of their own.
const QUANTITIES: &[(&str, [Text; 2])] = &[
    ("ray.origin", ["origin of the ray", "origen del rayo"]),
    ("ray.vector", ["vector of the ray before it is normalised", "vector del rayo antes de normalizar"]),
    ("ray.length", ["its length", "su longitud"]),
    ("ray.direction", ["unit direction of the ray, R_d in the book", "dirección unitaria del rayo, R_d en el libro"]),
    ("camera.direction", ["direction of view", "dirección de la vista"]),
    ("camera.up_as_given", ["upward direction as given", "dirección vertical dada"]),
    ("camera.length", ["length of the direction of view", "longitud de la dirección de la vista"]),
    ("camera.right", ["unit vector to the right in the picture", "vector unitario hacia la derecha en la imagen"]),
    ("camera.up", ["unit vector upward in the picture", "vector unitario hacia arriba en la imagen"]),
    ("camera.vertical_fov", ["vertical angle of view, in degrees", "ángulo de visión vertical, en grados"]),
    ("camera.rows", ["rows of the picture", "filas de la imagen"]),
    ("pixel.column", ["column of the pixel", "columna del píxel"]),
    ("pixel.middle_column", ["middle column of the picture", "columna central de la imagen"]),
    ("pixel.row", ["row of the pixel", "fila del píxel"]),
    ("pixel.middle_row", ["middle row of the picture", "fila central de la imagen"]),
    ("pixel.side", ["side of a pixel at the distance 1", "lado de un píxel a la distancia 1"]),
    ("pixel.x", ["how far right of the middle", "cuánto a la derecha del centro"]),
    ("pixel.y", ["how far above the middle", "cuánto por encima del centro"]),
    ("plane.normal", ["unit normal of the plane: A, B, C", "normal unitaria del plano: A, B, C"]),
    ("plane.offset", ["D in the equation of the plane", "D en la ecuación del plano"]),
    (
        "plane.v_d",
        [
            "normal · direction; 0 if the ray runs parallel to the plane",
            "normal · dirección; 0 si el rayo es paralelo al plano",
        ],
    ),
    (
        "plane.v_o",
        [
            "how far the origin lies from the plane, negative in front of it",
            "distancia del origen al plano, negativa delante de él",
        ],
    ),
    ("plane.t", ["distance along the ray to the plane", "distancia al plano a lo largo del rayo"]),
    (
        "touch.t",
        ["distance to a surface that the ray begins on", "distancia a una superficie en la que empieza el rayo"],
    ),
    ("sphere.center", ["centre of the sphere", "centro de la esfera"]),
    ("sphere.radius", ["its radius", "su radio"]),
    ("sphere.radius_squared", ["its radius squared", "su radio al cuadrado"]),
    (
        "sphere.oc",
        ["from the origin of the ray to the centre of the sphere", "del origen del rayo al centro de la esfera"],
    ),
    (
        "sphere.l2_oc",
        [
            "square of that distance; above r² the origin is outside",
            "cuadrado de esa distancia; mayor que r² si el origen está fuera",
        ],
    ),
    (
        "sphere.t_a",
        [
            "distance along the ray to the point nearest to the centre; negative if the sphere lies behind",
            "distancia a lo largo del rayo al punto más cercano al centro; negativa si la esfera queda detrás",
        ],
    ),
    (
        "sphere.t2_a",
        [
            "square of half the chord; negative if the ray passes beside the sphere",
            "cuadrado de la semicuerda; negativo si el rayo pasa de largo",
        ],
    ),
    ("sphere.t", ["distance along the ray to the sphere", "distancia a la esfera a lo largo del rayo"]),
    (
        "sphere.from_center",
        [
            "from the centre to the point, before it is put onto the sphere",
            "del centro al punto, antes de llevarlo a la esfera",
        ],
    ),
    ("hit.point", ["point of intersection", "punto de intersección"]),
    ("hit.normal", ["unit normal there, toward the arriving ray", "normal unitaria en él, hacia el rayo que llega"]),
    (
        "hit.geometric_normal",
        [
            "normal of the surface itself, where normals are interpolated",
            "normal de la propia superficie, donde se interpolan normales",
        ],
    ),
    ("reflect.direction", ["reflected direction", "dirección reflejada"]),
    ("refract.eta_1", ["refractive index on the side of the ray", "índice de refracción del lado del rayo"]),
    ("refract.eta_2", ["refractive index on the other side", "índice de refracción del otro lado"]),
    ("refract.eta", ["ratio of the refractive indices", "cociente de los índices de refracción"]),
    ("refract.cos_1", ["cosine of the angle of incidence", "coseno del ángulo de incidencia"]),
    ("refract.cos_2", ["cosine of the angle of refraction", "coseno del ángulo de refracción"]),
    ("refract.direction", ["transmitted direction", "dirección transmitida"]),
    ("light.position", ["position of the light", "posición de la fuente"]),
    ("light.travel", ["direction in which the light travels", "dirección en que viaja la luz"]),
    ("light.color", ["intensity of the light", "intensidad de la fuente"]),
    ("light.ambient", ["intensity of the ambient light", "intensidad de la luz ambiente"]),
    ("light.vector", ["from the point to the light", "del punto a la fuente"]),
    ("light.distance", ["distance of the light", "distancia de la fuente"]),
    ("light.direction", ["unit vector toward the light", "vector unitario hacia la fuente"]),
    ("light.constant", ["attenuation: the constant coefficient", "atenuación: coeficiente constante"]),
    ("light.linear", ["attenuation: the linear coefficient", "atenuación: coeficiente lineal"]),
    ("light.quadratic", ["attenuation: the quadratic coefficient", "atenuación: coeficiente cuadrático"]),
    ("light.attenuation", ["attenuation by distance", "atenuación por la distancia"]),
    (
        "shadow.transmittance",
        ["how much light the objects in between let through", "cuánta luz dejan pasar los objetos intermedios"],
    ),
    ("view.direction", ["unit vector toward the observer", "vector unitario hacia el observador"]),
    ("half.sum", ["sum of L and V", "suma de L y V"]),
    ("half.length", ["its length", "su longitud"]),
    (
        "half.direction",
        [
            "unit vector halfway between light and observer",
            "vector unitario a medio camino entre la fuente y el observador",
        ],
    ),
    (
        "mirror.direction",
        ["direction in which the surface would mirror the light", "dirección en que la superficie reflejaría la luz"],
    ),
    (
        "transmit.eta",
        [
            "ratio of the refractive indices, for the transmitted term",
            "cociente de los índices de refracción, para la componente transmitida",
        ],
    ),
    (
        "transmit.sum",
        [
            "the halfway vector of transmission, before it is normalised",
            "el vector medio de la transmisión, antes de normalizar",
        ],
    ),
    ("transmit.length", ["its length", "su longitud"]),
    ("transmit.direction", ["unit halfway vector of transmission", "vector medio unitario de la transmisión"]),
    (
        "shade.n_dot_l",
        [
            "cosine between normal and light; negative if the light is behind the surface",
            "coseno entre la normal y la luz; negativo si la fuente está detrás de la superficie",
        ],
    ),
    ("shade.n_dot_h", ["cosine between normal and halfway vector", "coseno entre la normal y el vector medio"]),
    ("shade.r_dot_v", ["cosine between mirrored light and observer", "coseno entre la luz reflejada y el observador"]),
    (
        "shade.n_dot_transmitted",
        [
            "cosine between normal and halfway vector of transmission",
            "coseno entre la normal y el vector medio de la transmisión",
        ],
    ),
    ("shade.specular_power", ["the power of the specular term", "la potencia de la componente especular"]),
    ("shade.transmitted_power", ["the power of the transmitted term", "la potencia de la componente transmitida"]),
    ("material.ambient", ["ambient coefficient", "coeficiente ambiente"]),
    ("material.diffuse", ["diffuse coefficient", "coeficiente de reflexión difusa"]),
    ("material.specular", ["specular coefficient", "coeficiente de reflexión especular"]),
    ("material.shininess", ["specular exponent", "exponente especular"]),
    ("material.transmission", ["coefficient of transmission", "coeficiente de transmisión"]),
    ("material.transmission_exponent", ["exponent of transmission", "exponente de transmisión"]),
    ("material.ambient_plain", ["ambient coefficient before the pattern", "coeficiente ambiente antes del patrón"]),
    (
        "material.diffuse_plain",
        ["diffuse coefficient before the pattern", "coeficiente de reflexión difusa antes del patrón"],
    ),
    ("weight.local", ["weight of the local intensity", "peso de la intensidad local"]),
    ("weight.reflected", ["weight of the reflected intensity", "peso de la intensidad reflejada"]),
    ("weight.transmitted", ["weight of the transmitted intensity", "peso de la intensidad transmitida"]),
    (
        "shade.local",
        [
            "intensity of the local model: ambient, diffuse, specular",
            "intensidad del modelo local: ambiente, difusa, especular",
        ],
    ),
    ("incoming.reflected", ["intensity that the reflected ray brings", "intensidad que trae el rayo reflejado"]),
    ("incoming.transmitted", ["intensity that the transmitted ray brings", "intensidad que trae el rayo transmitido"]),
    ("combine.local", ["local contribution", "contribución local"]),
    ("combine.reflected", ["reflected contribution", "contribución reflejada"]),
    ("combine.transmitted", ["transmitted contribution", "contribución transmitida"]),
    (
        "combine.color",
        [
            "intensity of the ray: the global one, I_global at the eye",
            "intensidad del rayo: la global, I_global en el ojo",
        ],
    ),
    ("background.color", ["colour of the background", "color del fondo"]),
    ("cutoff.loss", ["what is lost at most by leaving a ray out", "lo que se pierde como mucho al omitir un rayo"]),
    (
        "sample.x",
        ["place of the sample in the pixel, to the right", "lugar de la muestra en el píxel, hacia la derecha"],
    ),
    ("sample.y", ["place of the sample in the pixel, downward", "lugar de la muestra en el píxel, hacia abajo"]),
    ("sample.weight", ["weight of the sample", "peso de la muestra"]),
    ("pixel.samples", ["number of samples", "número de muestras"]),
    ("pixel.mean", ["mean of the samples: the colour of the pixel", "media de las muestras: el color del píxel"]),
    ("ray.time", ["time at which the ray sees the scene", "instante en que el rayo ve la escena"]),
];

/// The rows of all tables of quantities.
fn rows() -> impl Iterator<Item = &'static (&'static str, [Text; 2])> {
    [QUANTITIES, shapes::ROWS, sampling::ROWS].into_iter().flatten()
}

impl Language {
    /// What a quantity means, by its key in a log; none for what is no key.
    pub fn meaning(self, key: &str) -> Option<Text> {
        rows().find(|(known, _)| *known == key).map(|(_, meanings)| meanings[self as usize])
    }

    /// Signs of formulas, paths and classes, with what they mean.
    pub fn signs(self) -> impl Iterator<Item = (Text, Text)> {
        SIGNS.iter().map(move |(sign, meanings)| (*sign, meanings[self as usize]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::log::Name;

    #[test]
    fn every_meaning_is_that_of_a_quantity_and_in_its_language() {
        for (at, (key, meanings)) in rows().enumerate() {
            assert!(Name::with_key(key).is_some(), "{key}");
            assert!(meanings[0] != meanings[1], "{key}");
            assert!(rows().take(at).all(|(other, _)| other != key), "{key} twice");
        }
    }

    #[test]
    fn every_quantity_has_a_meaning() {
        for name in Name::all() {
            assert!(Language::Spanish.meaning(name.key()).is_some(), "{}", name.key());
        }
    }
}
