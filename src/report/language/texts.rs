//! What is said of the steps of a computation and of its sources of light.

use super::close_up::CloseUp;
use super::viewer::Viewer;
use super::{Causes, Figure, Solution};

texts! {
    /// The texts of a language.
    Texts;
    /// Before the decimals.
    decimal_mark: char = '.', ',';
    /// Between the numbers of a triple.
    separator = ", ", "; ";
    // What is walked through.
    /// A pixel by its column and row.
    pixel([x, y]: [u32; 2]) = "pixel {x},{y}", "píxel {x},{y}";
    /// A region by its sides.
    region([x0, y0, x1, y1]: [u32; 4]) = "region {x0},{y0} to {x1},{y1}", "región de {x0},{y0} a {x1},{y1}";
    /// A ray by its origin and direction.
    ray_along(origin: &str, direction: &str) =
        "ray from {origin} along {direction}",
        "rayo desde {origin} en la dirección {direction}";
    /// A method of sampling or one of its parameters by its name in scene files; what isn't known stays as it is.
    sampling_word: fn(&str) -> &str =
        |word| word,
        |word| match word {
            "none" => "ninguno",
            "regular" => "sobremuestreo regular",
            "shared" => "sobremuestreo de esquinas compartidas",
            "adaptive" => "sobremuestreo adaptativo",
            "stochastic" => "sobremuestreo estocástico",
            "random" => "sobremuestreo aleatorio",
            "sobol" => "sobremuestreo de Sobol",
            "statistical" => "sobremuestreo estadístico",
            "guided" => "sobremuestreo guiado",
            "threshold" => "umbral",
            "depth" => "profundidad",
            "confidence" => "confianza",
            "tolerance" => "tolerancia",
            "min" => "mínimo",
            "max" => "máximo",
            _ => word,
        };
    /// The depth limit, before its number.
    depth = "depth", "profundidad";
    /// Before inputs, in text.
    given = "given", "con";
    /// Before the colour, in text.
    result = "result", "resultado";
    /// A frame by its number.
    frame(number: u32) = "frame {number}", "fotograma {number}";
    // Nodes.
    /// A sample by its number.
    sample(number: u32) = "sample {number}", "muestra {number}";
    /// A ray by its path and what it is for.
    ray(path: &str, kind: &str) = "ray {path}, {kind}", "rayo {path}, {kind}";
    /// The test with an object.
    test(object: &str) = "test {object}", "intersección con {object}";
    /// The test with a triangle of an object.
    test_triangle(object: &str, triangle: u32) =
        "test {object}, triangle {triangle}",
        "intersección con {object}, triángulo {triangle}";
    /// The local model on an object.
    local_model(object: &str) = "local model on {object}", "modelo local en {object}";
    /// A light.
    light(light: &str) = "light {light}", "fuente {light}";
    /// A point of an area light.
    light_point(light: &str, number: u32) = "light {light}, point {number}", "fuente {light}, punto {number}";
    /// A moving object in its own frame.
    motion(object: &str) = "{object} where it is at this time", "{object} donde está en este instante";
    /// A zone of a blurred bounce.
    zone_of_reflection(number: u32) = "zone {number} of the reflection", "zona {number} de la reflexión";
    /// The same of the other bounce.
    zone_of_transmission(number: u32) = "zone {number} of the transmission", "zona {number} de la transmisión";
    /// The sum of the three contributions.
    weighted_sum = "weighted sum", "suma ponderada";
    /// A camera ray.
    from_the_eye = "from the eye", "primario";
    /// A shadow ray to a light.
    shadow_ray_to(light: &str) = "shadow ray to {light}", "rayo de sombra hacia {light}";
    /// A reflected ray.
    reflected = "reflected", "reflejado";
    /// A transmitted ray.
    transmitted = "transmitted", "transmitido";
    // Decisions.
    /// The object lies on the ray.
    hit = "hit", "el rayo interseca con el objeto";
    /// It doesn't, and why.
    miss(why: &str) = "miss: {why}", "no hay intersección: {why}";
    /// The ray begins outside the solid.
    outside = "the ray begins outside", "el origen del rayo se encuentra fuera";
    /// It begins inside.
    inside = "the ray begins inside", "el origen del rayo se encuentra dentro";
    /// The nearest object.
    nearest(object: &str) = "nearest: {object}", "intersección más cercana: {object}";
    /// An object in the same place as the nearest one.
    coincident(object: &str) =
        "{object} is in the same place and counts as just behind",
        "{object} está en el mismo lugar y cuenta como justo detrás";
    /// A triangle of an object.
    triangle_of(triangle: u32, object: &str) = "triangle {triangle} of {object}", "el triángulo {triangle} de {object}";
    /// A medium that the ray begins inside.
    immersed(object: &str) = "the ray begins inside {object}", "el rayo empieza dentro de {object}";
    /// Nothing is hit.
    background = "nothing is hit: background", "no interseca con ningún objeto: luz de fondo";
    /// A shadow ray that nothing stops.
    free = "nothing blocks the light", "nada bloquea la luz";
    /// Behind a value that was computed with more digits than the others.
    twice_the_digits = "with twice the digits", "con el doble de cifras";
    /// Behind a value that the book prints although its formula gives another one.
    printed = "printed", "impreso";
    /// The object that blocks.
    blocked_by(object: &str) = "blocked by {object}", "bloqueado por {object}";
    /// The object that a shadow ray passes, and what it keeps.
    passes(object: &str, factor: &str) =
        "passes {object}, which keeps {factor}",
        "atraviesa {object}, que deja pasar {factor}";
    /// A pattern that is too fine.
    too_fine(symbol: &str) =
        "{symbol} has no value: the pattern is finer than numbers are here",
        "{symbol} no tiene valor: el patrón es más fino que los números aquí";
    /// A quantity without a value.
    undefined(symbol: &str) =
        "{symbol} has no value in this arithmetic: it would be divided by zero",
        "{symbol} no tiene valor en esta aritmética: habría que dividir entre cero";
    /// Total internal reflection.
    total_reflection = "total internal reflection", "reflexión total interna";
    /// What the depth limit leaves out.
    depth_limit(what: &str) = "depth limit: no {what}", "profundidad máxima: no se traza {what}";
    /// The rest of a blocked shadow ray isn't traced.
    rest_skipped = "the rest is skipped", "se omite el resto";
    /// What would come through the surface.
    leak_guard(what: &str) =
        "no leak: the {what} lies beyond the surface and contributes nothing",
        "{what} queda al otro lado de la superficie y no aporta nada";
    /// A direction that was bent up above the surface.
    bent(what: &str) =
        "the {what} would run below the surface and is bent up",
        "{what} iría por debajo de la superficie y se dobla hacia arriba";
    /// A direction on the wrong side.
    rejected(what: &str) =
        "rejected: the {what} would run on the wrong side",
        "rechazado: {what} iría por el lado equivocado";
    /// What is left out, and why.
    skipped(what: &str, why: &str) = "skipped: {what} ({why})", "se omite {what} ({why})";
    /// What a decision cost at most.
    lost(bound: &str) = "at most {bound} of the sample was lost", "se pierde como mucho {bound} de la muestra";
    /// A cell that is the whole pixel.
    whole_pixel = "the pixel", "el píxel";
    /// A cell by its corner and its side.
    cell(x: &str, y: &str, side: &str) =
        "the cell at ({x}, {y}) with side {side}",
        "la celda en ({x}; {y}) de lado {side}";
    /// A cell that is cut in four because of its colours.
    subdivided_by_color(cell: &str) =
        "{cell} is subdivided: the colours at its corners differ by more than the threshold",
        "se subdivide {cell}: los colores de sus esquinas difieren más que el umbral";
    /// Because of the objects.
    subdivided_by_objects(cell: &str) =
        "{cell} is subdivided: its corners see different objects",
        "se subdivide {cell}: sus esquinas ven objetos distintos";
    /// Because of a small object.
    subdivided_by_one(cell: &str, object: &str) =
        "{cell} is subdivided: {object} may lie in it, and no corner sees that",
        "se subdivide {cell}: {object} puede estar en su interior y ninguna esquina lo ve";
    /// An object without a name.
    an_object = "an object", "un objeto";
    /// The mean of samples.
    mean = "the mean", "la media";
    /// What is accepted, and why.
    accepted(what: &str, why: &str) = "{what} is accepted: {why}", "se acepta {what}: {why}";
    /// A light in full view whose mean a rule gives.
    asked_by_rule(light: &str, points: u32) =
        "{light} is in full view: a rule of {points} points gives its mean, without shadow rays",
        "{light} está a plena vista: una regla de {points} puntos da su media, sin rayos de sombra";
    /// A light in full view.
    asked_in_view(light: &str, points: u32) =
        "{light} is in full view: {points} points of it need no shadow rays",
        "{light} está a plena vista: {points} de sus puntos no necesitan rayos de sombra";
    /// A light that an object hides.
    hidden(light: &str, object: &str) =
        "{light} is hidden as a whole by {object}",
        "{object} tapa {light} por entero";
    /// A light all of whose points are asked.
    all_asked(light: &str, points: u32) =
        "{light} may be hidden or behind the surface in part: all its {points} points are asked",
        "{light} puede estar en parte tapada o detrás de la superficie: se preguntan todos sus {points} puntos";
    /// How many samples are too few, and how many are taken.
    more_samples(from: u32, to: u32) =
        "{from} samples are too few, the interval of their mean is too wide: {to} are taken",
        "{from} muestras son pocas, el intervalo de su media es demasiado ancho: se toman {to}";
    /// That the pilots around ask for more samples: how many there are and will be.
    more_asked(from: u32, to: u32) =
        "{from} samples are too few for what the first samples of the pixels around it saw: {to} are taken",
        "{from} muestras son pocas para lo que ven las primeras muestras de los píxeles de alrededor: se toman {to}";
    /// How many digits can be trusted; the counts, and whether they are one single digit.
    digits: fn(&str, bool) -> String =
        |counts, is_one| format!("{counts} {}", if is_one { "digit" } else { "digits" }),
        |counts, is_one| format!("{counts} {}", if is_one { "cifra" } else { "cifras" });
    /// A decision that differs between runs.
    decision_differs = "the decision differs between runs", "la decisión no es la misma en todas las ejecuciones";
    /// A value that depends on such a decision.
    no_digits =
        "0 digits: a decision differs between runs",
        "0 cifras: una decisión no es la misma en todas las ejecuciones";
    // Where light comes from.
    /// A light on an object.
    light_on(light: &str, object: &str) = "{light} on {object}", "{light} en {object}";
    /// Ambient light on an object.
    ambient_on(object: &str) = "ambient on {object}", "luz ambiente en {object}";
    /// The background as a source.
    from_background = "background", "luz de fondo";
    /// What the rounding of values adds.
    from_rounding = "rounding of the values", "redondeo de los valores";
    /// What the operands that a log holds leave unexplained.
    unexplained = "not explained by this log", "este registro no lo explica";
    /// A light behind the surface.
    light_behind(light: &str) = "{light} is behind the surface", "{light} está detrás de la superficie";
    /// A light that an object blocks.
    light_blocked(light: &str, object: &str) = "{light} is blocked by {object}", "{object} bloquea {light}";
    /// The log ends within a ray.
    log_ends = "the log ends before this ray does", "el registro termina antes que este rayo";
    /// Why a path contributes nothing, where nobody knows.
    nothing = "nothing", "nada";
    /// What a worked solution says beyond that.
    solution: Solution;
    /// What a study of roundings says.
    causes: Causes;
    /// What figures say.
    figure: Figure;
    /// What close-ups say.
    close_up: CloseUp;
    /// What the viewer says.
    viewer: Viewer;
}
