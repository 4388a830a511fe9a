//! What worked solutions, studies of roundings and figures say.

use super::{OfName, OfNames, Text};

texts! {
    /// The texts of a worked solution.
    Solution;

    /// Its title: the subject and the scene.
    title: OfNames =
        |subject, scene| format!("Worked solution: {subject} of {scene}"),
        |subject, scene| format!("Ejemplo resuelto: {subject} de {scene}");
    /// How it was computed: arithmetic, algorithm and depth limit.
    conditions: fn(&str, &str, u32) -> String =
        |arithmetic, algorithm, depth| {
            format!("Arithmetic {arithmetic}, algorithm {algorithm}, greatest depth {depth}.")
        },
        |arithmetic, algorithm, depth| {
            format!("Aritmética {arithmetic}, algoritmo {algorithm}, nivel de profundidad máximo {depth}.")
        };
    /// How a pixel was sampled.
    sampled: OfName = |method| format!("Samples: {method}."), |method| format!("Muestras: {method}.");
    /// The heading of what the problem states.
    data: Text = "Data", "Datos";
    /// What is the same for all objects.
    everywhere: Text = "Everywhere", "En toda la escena";
    /// An object among the data.
    object: OfName = |object| format!("Object {object}"), |object| format!("Objeto {object}");
    /// A light among the data.
    source: OfName = |light| format!("Light {light}"), |light| format!("Fuente {light}");
    /// The heading of the steps.
    steps: Text = "Steps", "Desarrollo";
    /// Before inputs.
    with: Text = "With", "Con";
    /// The step that makes a ray's direction.
    aim: Text = "Direction of the ray", "Se calcula el vector director del rayo";
    /// The step that tests an object.
    intersection: OfName =
        |object| format!("Intersection with {object}"),
        |object| format!("Se averigua si el rayo interseca con {object}");
    /// The step that tests a triangle of an object.
    intersection_triangle: fn(&str, u32) -> String =
        |object, triangle| format!("Intersection with triangle {triangle} of {object}"),
        |object, triangle| {
            format!("Se averigua si el rayo interseca con el triángulo {triangle} de {object}")
        };
    /// The step that tests a moving object.
    intersection_moving: OfName =
        |object| format!("Intersection with {object}, which moves"),
        |object| format!("Se averigua si el rayo interseca con {object}, que se mueve");
    /// The step that finds the point and the normal.
    point: Text =
        "Nearest intersection: its point and the normal there",
        "Se calculan el punto de intersección más cercano y su normal";
    /// The step of the local model on an object.
    local: OfName =
        |object| format!("Local intensity on {object}"),
        |object| format!("Se calcula la intensidad local en {object}");
    /// The step of the reflected direction.
    reflection: Text = "Direction of the reflected ray", "Se calcula el vector director del rayo reflejado";
    /// The step of the transmitted direction.
    transmission: Text = "Direction of the transmitted ray", "Se calcula el vector director del rayo transmitido";
    /// The step of a blurred bounce.
    blur: Text = "Mean of the blurred bounce", "Se calcula la media de la contribución difusa de las zonas";
    /// The step of the weighted sum of a ray.
    combine: OfName =
        |path| format!("Intensity that ray {path} brings"),
        |path| format!("Se calcula la intensidad global que aporta el rayo {path}");
    /// The step of choosing samples.
    sampling: Text = "Samples of the pixel", "Se eligen las muestras del píxel";
    /// The steps of a ray go on after those of another.
    back: OfName = |title| format!("Back at {title}"), |title| format!("De vuelta en el {title}");
    /// The heading of the result.
    result: Text = "Result", "Resultado";
    /// The intensity of the pixel.
    conclusion: OfName =
        |color| format!("The intensity that reaches the eye is {color}."),
        |color| format!("Finalmente, la intensidad que llega al observador es {color}.");
    /// The log has no result.
    no_result: Text =
        "The log ends before the intensity is known.",
        "El registro termina antes de conocerse la intensidad.";
    /// The heading of the contributions.
    contributions: Text = "Contributions", "Contribuciones";
    /// Their columns: path, origin, class, what it brings, weight, what it adds, share.
    columns: [Text; 7] =
        ["path", "light", "class", "brings", "weight", "adds", "share"],
        ["camino", "procedencia", "clase", "intensidad", "peso", "aporta", "parte"];
    /// The sum of all of them.
    sum: Text = "sum", "suma";
    /// The number of smaller ones.
    smaller: fn(usize) -> String =
        |count| format!("{count} smaller ones together"),
        |count| format!("otras {count} menores");
    /// The heading of what brings nothing.
    brings_nothing: Text = "What brings nothing", "Lo que no aporta nada";
    /// So many more of those.
    more: fn(usize) -> String = |count| format!("and {count} more"), |count| format!("y {count} más");
    /// The section of the source text that has a quantity.
    section: OfName =
        |section| format!("section {section} of the source text"),
        |section| format!("sección {section} del texto");
    /// Opens all parts.
    open_all: Text = "Open all", "Abrir todo";
    /// Closes them.
    close_all: Text = "Close all", "Cerrar todo";
}

texts! {
    /// The texts of a study of roundings.
    Causes;

    /// The result of the arithmetic that rounds.
    rounded: Text = "rounded", "redondeado";
    /// The result in f64.
    exact: Text = "in f64", "en f64";
    /// How far the two are apart.
    off: Text = "off by", "diferencia";
    /// How far they may be expected to be.
    expected: Text = "to expect", "esperada";
    /// From how many runs that is known.
    of_runs: fn(u32) -> String =
        |runs| format!("from {runs} runs that round up or down at random"),
        |runs| format!("de {runs} ejecuciones que redondean hacia arriba o hacia abajo al azar");
    /// Rounding changes the ray tree.
    other_tree: Text =
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
    star: Text = "*  The ray tree is another than in f64.", "*  El árbol de rayos es otro que en f64.";
}

texts! {
    /// The texts of figures.
    Figure;

    /// The title of the ray tree.
    ray_tree: Text = "Ray tree", "Árbol de rayos";
    /// The title of the call tree.
    call_tree: Text = "Call tree", "Árbol de llamadas";
    /// The title of the schematic.
    schematic: Text = "Schematic of the rays", "Esquema de los rayos";
    /// Along which two axes the schematic is drawn.
    plane: OfNames =
        |right, up| format!("{right} to the right, {up} upward"),
        |right, up| format!("{right} hacia la derecha, {up} hacia arriba");
    /// The root of the ray tree.
    eye: Text = "eye", "ojo";
    /// Where a ray that hits nothing ends.
    background: Text = "background", "fondo";
    /// A shadow ray that doesn't reach its light, by the object.
    blocked: OfName = |object| format!("blocked by {object}"), |object| format!("bloqueado por {object}");
    /// The tree has too many rays to be drawn in the text.
    too_many: fn(usize) -> String =
        |rays| {
            format!("The tree has {rays} rays, too many for this page: `raywalk trace --format svg` draws it.")
        },
        |rays| {
            format!("El árbol tiene {rays} rayos, demasiados para esta página: lo dibuja `raywalk trace --format svg`.")
        };
    /// Only the first sample is drawn.
    first_sample: fn(usize) -> String =
        |samples| format!("The figure shows the first of {samples} samples."),
        |samples| format!("La figura muestra la primera de {samples} muestras.");
    /// What the width of a line means.
    width: Text =
        "the wider a line, the more of the pixel's intensity comes along it",
        "cuanto más ancha la línea, más intensidad del píxel llega por ella";
    /// The kinds of rays: from the eye, reflected, transmitted, shadow, blocked shadow.
    kinds: [Text; 5] =
        ["C: from the eye", "R: reflected", "T: transmitted", "S: to a light", "S: blocked"],
        ["C: primario", "R: reflejado", "T: transmitido", "S: de sombra", "S: bloqueado"];
    /// A ray that adds this to the pixel.
    adds: fn(&str, &str) -> String =
        |share, color| format!("{share} of the intensity, {color}"),
        |share, color| format!("{share} de la intensidad, {color}");
    /// There is no ray to be drawn.
    no_rays: Text = "The log has no rays that can be drawn.", "El registro no tiene rayos que se puedan dibujar.";
}
