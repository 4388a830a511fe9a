//! What worked solutions, studies of roundings and figures say.

use super::Text;

texts! {
    /// The texts of a worked solution.
    Solution;
    /// Its title: the subject and the scene.
    title(subject: &str, scene: &str) =
        "Worked solution: {subject} of {scene}",
        "Ejemplo resuelto: {subject} de {scene}";
    /// How it was computed: arithmetic, algorithm and depth limit.
    conditions(arithmetic: &str, algorithm: &str, depth: u32) =
        "Arithmetic {arithmetic}, algorithm {algorithm}, greatest depth {depth}.",
        "Aritmética {arithmetic}, algoritmo {algorithm}, nivel de profundidad máximo {depth}.";
    /// How a pixel was sampled.
    sampled(method: &str) = "Samples: {method}.", "Muestras: {method}.";
    /// The heading of what the problem states.
    data = "Data", "Datos";
    /// What is the same for all objects.
    everywhere = "Everywhere", "En toda la escena";
    /// An object among the data.
    object(object: &str) = "Object {object}", "Objeto {object}";
    /// A light among the data.
    source(light: &str) = "Light {light}", "Fuente {light}";
    /// The heading of the steps.
    steps = "Steps", "Desarrollo";
    /// Before inputs.
    with = "With", "Con";
    /// The step that makes a ray's direction.
    aim = "Direction of the ray", "Se calcula el vector director del rayo";
    /// The step that tests an object.
    intersection(object: &str) = "Intersection with {object}", "Se averigua si el rayo interseca con {object}";
    /// The step that tests a triangle of an object.
    intersection_triangle(object: &str, triangle: u32) =
        "Intersection with triangle {triangle} of {object}",
        "Se averigua si el rayo interseca con el triángulo {triangle} de {object}";
    /// The step that tests a moving object.
    intersection_moving(object: &str) =
        "Intersection with {object}, which moves",
        "Se averigua si el rayo interseca con {object}, que se mueve";
    /// The step that finds the point and the normal.
    point =
        "Nearest intersection: its point and the normal there",
        "Se calculan el punto de intersección más cercano y su normal";
    /// The step of the local model on an object.
    local(object: &str) = "Local intensity on {object}", "Se calcula la intensidad local en {object}";
    /// The step of the reflected direction.
    reflection = "Direction of the reflected ray", "Se calcula el vector director del rayo reflejado";
    /// The step of the transmitted direction.
    transmission = "Direction of the transmitted ray", "Se calcula el vector director del rayo transmitido";
    /// The step of a blurred bounce.
    blur = "Mean of the blurred bounce", "Se calcula la media de la contribución difusa de las zonas";
    /// The step of the weighted sum of a ray.
    combine(path: &str) =
        "Intensity that ray {path} contributes",
        "Se calcula la intensidad global que aporta el rayo {path}";
    /// The step of choosing samples.
    sampling = "Samples of the pixel", "Se eligen las muestras del píxel";
    /// The steps of a ray go on after those of another.
    back(title: &str) = "Back at {title}", "De vuelta en el {title}";
    /// The heading of the result.
    result = "Result", "Resultado";
    /// The intensity of the pixel.
    conclusion(color: &str) =
        "The intensity that reaches the eye is {color}.",
        "Finalmente, la intensidad que llega al observador es {color}.";
    /// The log has no result.
    no_result = "The log ends before the intensity is known.", "El registro termina antes de conocerse la intensidad.";
    /// The heading of the contributions.
    contributions = "Contributions", "Contribuciones";
    /// Their columns: path, origin, class, what it brings, weight, what it adds, share.
    columns: [Text; 7] =
        ["path", "light", "class", "intensity", "weight", "adds", "share"],
        ["camino", "procedencia", "clase", "intensidad", "peso", "aporta", "parte"];
    /// The sum of all of them.
    sum = "sum", "suma";
    /// The number of smaller ones.
    smaller(count: usize) = "{count} smaller ones together", "otras {count} menores";
    /// The heading of what brings nothing.
    brings_nothing = "What contributes nothing", "Lo que no aporta nada";
    /// So many more of those.
    more(count: usize) = "and {count} more", "y {count} más";
    /// The section of the source text that has a quantity.
    section(section: &str) = "section {section} of the source text", "sección {section} del texto";
    /// Opens all parts.
    open_all = "Open all", "Abrir todo";
    /// Closes them.
    close_all = "Close all", "Cerrar todo";
}

texts! {
    /// The texts of a study of roundings.
    Causes;
    /// The result of the arithmetic that rounds.
    rounded = "rounded", "redondeado";
    /// The result in f64.
    exact = "in f64", "en f64";
    /// How far the two are apart.
    off = "off by", "diferencia";
    /// How far they may be expected to be.
    expected = "to expect", "esperada";
    /// From how many runs that is known.
    of_runs(runs: u32) =
        "from {runs} runs that round up or down at random",
        "de {runs} ejecuciones que redondean hacia arriba o hacia abajo al azar";
    /// Rounding changes the ray tree.
    other_tree =
        "Rounding changes the ray tree: what is computed only there isn't listed here.",
        "El redondeo cambia el árbol de rayos: lo que solo se calcula en él no figura aquí.";
    /// The columns: only the quantity rounded, all but it, its name, where it is.
    columns: [Text; 4] =
        ["only it rounded", "all but it", "quantity", "where"],
        ["solo ella redondeada", "todas menos ella", "magnitud", "dónde"];
    /// The number of quantities without an effect.
    idle: fn(usize) -> String =
        |quantities| match quantities {
            1 => "1 further quantity changes nothing when only it is rounded.".to_owned(),
            _ => format!("{quantities} further quantities change nothing when only they are rounded."),
        },
        |quantities| match quantities {
            1 => "Otra magnitud no cambia nada cuando solo se redondea ella.".to_owned(),
            _ => format!("Otras {quantities} magnitudes no cambian nada cuando solo se redondea una de ellas."),
        };
    /// What the star behind a change means.
    star = "*  The ray tree is another than in f64.", "*  El árbol de rayos es otro que en f64.";
}

texts! {
    /// The texts of figures.
    Figure;
    /// The title of the ray tree.
    ray_tree = "Ray tree", "Árbol de rayos";
    /// The title of the call tree.
    call_tree = "Call tree", "Árbol de llamadas";
    /// The title of the schematic.
    schematic = "Schematic of the rays", "Esquema de los rayos";
    /// Along which two axes the schematic is drawn.
    plane(right: &str, up: &str) = "{right} to the right, {up} upward", "{right} hacia la derecha, {up} hacia arriba";
    /// The root of the ray tree.
    eye = "eye", "ojo";
    /// Where a ray that hits nothing ends.
    background = "background", "fondo";
    /// A shadow ray that doesn't reach its light, by the object.
    blocked(object: &str) = "blocked by {object}", "bloqueado por {object}";
    /// The tree has too many rays to be drawn in the text.
    too_many(rays: usize) =
        "The tree has {rays} rays, too many for this page: `raywalk trace --format svg` draws it.",
        "El árbol tiene {rays} rayos, demasiados para esta página: lo dibuja `raywalk trace --format svg`.";
    /// Only the first sample is drawn.
    first_sample(samples: usize) =
        "The figure shows the first of {samples} samples.",
        "La figura muestra la primera de {samples} muestras.";
    /// What the width of a line means.
    width =
        "the wider a line, the more of the pixel's intensity comes along it",
        "cuanto más ancha la línea, más intensidad del píxel llega por ella";
    /// The kinds of rays: from the eye, reflected, transmitted, shadow, blocked shadow.
    kinds: [Text; 5] =
        ["C: from the eye", "R: reflected", "T: transmitted", "S: to a light", "S: blocked"],
        ["C: primario", "R: reflejado", "T: transmitido", "S: de sombra", "S: bloqueado"];
    /// A ray that adds this to the pixel.
    adds(share: &str, color: &str) = "{share} of the intensity, {color}", "{share} de la intensidad, {color}";
}
