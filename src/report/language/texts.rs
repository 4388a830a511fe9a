//! What is said of the steps of a computation and of its sources of light.

use super::close_up::CloseUp;
use super::viewer::Viewer;
use super::words::{self, EN, ES};
use super::{Causes, Figure, OfName, OfNames, Solution, Text};
use crate::log::{Acceptance, Asking, Miss, SkipReason, Split, Term};

texts! {
    /// The texts of a language.
    Texts;

    /// Before the decimals.
    decimal_mark: char = '.', ',';
    /// Between the numbers of a triple.
    separator: Text = ", ", "; ";

    // What is walked through.
    /// A pixel by its column and row.
    pixel: fn([u32; 2]) -> String = |[x, y]| format!("pixel {x},{y}"), |[x, y]| format!("píxel {x},{y}");
    /// A region by its sides.
    region: fn([u32; 4]) -> String =
        |[x0, y0, x1, y1]| format!("region {x0},{y0} to {x1},{y1}"),
        |[x0, y0, x1, y1]| format!("región de {x0},{y0} a {x1},{y1}");
    /// A ray by its origin and direction.
    ray_along: OfNames =
        |origin, direction| format!("ray from {origin} along {direction}"),
        |origin, direction| format!("rayo desde {origin} en la dirección {direction}");
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
    depth: Text = "depth", "profundidad";
    /// Before inputs, in text.
    given: Text = "given", "con";
    /// Before the colour, in text.
    result: Text = "result", "resultado";
    /// A frame by its number.
    frame: fn(u32) -> String = |number| format!("frame {number}"), |number| format!("fotograma {number}");

    // Nodes.
    /// A sample by its number.
    sample: fn(u32) -> String = |number| format!("sample {number}"), |number| format!("muestra {number}");
    /// A ray by its path and what it is for.
    ray: OfNames = |path, kind| format!("ray {path}, {kind}"), |path, kind| format!("rayo {path}, {kind}");
    /// The test with an object.
    test: OfName = |object| format!("test {object}"), |object| format!("intersección con {object}");
    /// The test with a triangle of an object.
    test_triangle: fn(&str, u32) -> String =
        |object, triangle| format!("test {object}, triangle {triangle}"),
        |object, triangle| format!("intersección con {object}, triángulo {triangle}");
    /// The local model on an object.
    local_model: OfName = |object| format!("local model on {object}"), |object| format!("modelo local en {object}");
    /// A light.
    light: OfName = |light| format!("light {light}"), |light| format!("fuente {light}");
    /// A point of an area light.
    light_point: fn(&str, u32) -> String =
        |light, number| format!("light {light}, point {number}"),
        |light, number| format!("fuente {light}, punto {number}");
    /// A moving object in its own frame.
    motion: OfName =
        |object| format!("{object} where it is at this time"),
        |object| format!("{object} donde está en este instante");
    /// A zone of a blurred bounce.
    zone: fn(Term, u32) -> String =
        |what, number| match what {
            Term::Transmitted => format!("zone {number} of the transmission"),
            _ => format!("zone {number} of the reflection"),
        },
        |what, number| match what {
            Term::Transmitted => format!("zona {number} de la transmisión"),
            _ => format!("zona {number} de la reflexión"),
        };
    /// The sum of the three contributions.
    weighted_sum: Text = "weighted sum", "suma ponderada";
    /// A camera ray.
    from_the_eye: Text = "from the eye", "primario";
    /// A shadow ray to a light.
    shadow_ray_to: OfName = |light| format!("shadow ray to {light}"), |light| format!("rayo de sombra hacia {light}");
    /// A reflected ray.
    reflected: Text = "reflected", "reflejado";
    /// A transmitted ray.
    transmitted: Text = "transmitted", "transmitido";

    // Decisions.
    /// The object lies on the ray.
    hit: Text = "hit", "el rayo interseca con el objeto";
    /// It doesn't, and why.
    miss: fn(Miss) -> String =
        |why| format!("miss: {}", words::miss(why)[EN]),
        |why| format!("no hay intersección: {}", words::miss(why)[ES]);
    /// The ray begins outside the solid.
    outside: Text = "the ray begins outside", "el origen del rayo se encuentra fuera";
    /// It begins inside.
    inside: Text = "the ray begins inside", "el origen del rayo se encuentra dentro";
    /// The nearest object.
    nearest: OfName = |object| format!("nearest: {object}"), |object| format!("intersección más cercana: {object}");
    /// An object in the same place as the nearest one, or a triangle of it.
    coincident: fn(&str, Option<u32>) -> String =
        |object, triangle| match triangle {
            None => format!("{object} is in the same place and counts as just behind"),
            Some(triangle) => format!("triangle {triangle} of {object} is in the same place and counts as just behind"),
        },
        |object, triangle| match triangle {
            None => format!("{object} está en el mismo lugar y cuenta como justo detrás"),
            Some(triangle) => {
                format!("el triángulo {triangle} de {object} está en el mismo lugar y cuenta como justo detrás")
            }
        };
    /// A medium that the ray begins inside.
    immersed: OfName =
        |object| format!("the ray begins inside {object}"),
        |object| format!("el rayo empieza dentro de {object}");
    /// Nothing is hit.
    background: Text = "nothing is hit: background", "no interseca con ningún objeto: luz de fondo";
    /// A shadow ray that nothing stops.
    free: Text = "nothing stands in the way", "nada se interpone";
    /// Behind a value that was computed with more digits than the others.
    twice_the_digits: Text = "with twice the digits", "con el doble de cifras";
    /// The object that blocks.
    blocked_by: OfName = |object| format!("blocked by {object}"), |object| format!("bloqueado por {object}");
    /// The object that a shadow ray passes, and what it keeps.
    passes: OfNames =
        |object, factor| format!("passes {object}, which keeps {factor}"),
        |object, factor| format!("atraviesa {object}, que deja pasar {factor}");
    /// A pattern that is too fine.
    too_fine: OfName =
        |symbol| format!("{symbol} has no value: the pattern is finer than numbers are here"),
        |symbol| format!("{symbol} no tiene valor: el patrón es más fino que los números aquí");
    /// A quantity without a value.
    undefined: OfName =
        |symbol| format!("{symbol} has no value in this arithmetic: it would be divided by zero"),
        |symbol| format!("{symbol} no tiene valor en esta aritmética: habría que dividir entre cero");
    /// Total internal reflection.
    total_reflection: Text = "total internal reflection", "reflexión total interna";
    /// What the depth limit leaves out.
    depth_limit: fn(Term) -> String =
        |what| format!("depth limit: no {}", words::term(what)[EN]),
        |what| format!("profundidad máxima: no se traza {}", words::term(what)[ES]);
    /// The rest of a blocked shadow ray isn't traced.
    rest_skipped: Text = "the rest is skipped", "se omite el resto";
    /// What would come through the surface.
    leak_guard: fn(Term) -> String =
        |what| format!("no leak: the {} lies beyond the surface and brings nothing", words::term(what)[EN]),
        |what| format!("{} queda al otro lado de la superficie y no aporta nada", words::term(what)[ES]);
    /// A direction that was bent up above the surface.
    bent: fn(Term) -> String =
        |what| format!("the {} would run below the surface and is bent up", words::term(what)[EN]),
        |what| format!("{} iría por debajo de la superficie y se dobla hacia arriba", words::term(what)[ES]);
    /// A direction on the wrong side.
    rejected: fn(Term) -> String =
        |what| format!("rejected: the {} would run on the wrong side", words::term(what)[EN]),
        |what| format!("rechazado: {} iría por el lado equivocado", words::term(what)[ES]);
    /// What is left out, and why.
    skipped: fn(Term, SkipReason) -> String =
        |what, why| format!("skipped: {} ({})", words::term(what)[EN], words::skip_reason(why)[EN]),
        |what, why| format!("se omite {} ({})", words::term(what)[ES], words::skip_reason(why)[ES]);
    /// What a decision cost at most.
    lost: OfName =
        |bound| format!("at most {bound} of the sample was lost"),
        |bound| format!("se pierde como mucho {bound} de la muestra");
    /// A cell that is the whole pixel.
    whole_pixel: Text = "the pixel", "el píxel";
    /// A cell by its corner and its side.
    cell: fn(&str, &str, &str) -> String =
        |x, y, side| format!("the cell at ({x}, {y}) with side {side}"),
        |x, y, side| format!("la celda en ({x}; {y}) de lado {side}");
    /// A cell that is cut in four, and why; the last name is that of an object.
    subdivided: fn(&str, Split, &str) -> String =
        |cell, why, object| match why {
            Split::Color => format!("{cell} is subdivided: the colours at its corners differ by more than the threshold"),
            Split::Objects => format!("{cell} is subdivided: its corners see different objects"),
            Split::SmallObject => format!("{cell} is subdivided: {object} may lie in it, and no corner sees that"),
        },
        |cell, why, object| match why {
            Split::Color => format!("se subdivide {cell}: los colores de sus esquinas difieren más que el umbral"),
            Split::Objects => format!("se subdivide {cell}: sus esquinas ven objetos distintos"),
            Split::SmallObject => {
                format!("se subdivide {cell}: {object} puede estar en su interior y ninguna esquina lo ve")
            }
        };
    /// An object without a name.
    an_object: Text = "an object", "un objeto";
    /// The mean of samples.
    mean: Text = "the mean", "la media";
    /// What is accepted, and why.
    accepted: fn(&str, Acceptance) -> String =
        |what, why| format!("{what} is accepted: {}", words::acceptance(why)[EN]),
        |what, why| format!("se acepta {what}: {}", words::acceptance(why)[ES]);
    /// How many points of a light are asked, and why; the last name is that of an object.
    asked: fn(&str, Asking, u32, &str) -> String =
        |light, why, points, object| match why {
            Asking::Rule => {
                format!("{light} is in full view: a rule of {points} points gives its mean, without shadow rays")
            }
            Asking::InView => format!("{light} is in full view: {points} points of it need no shadow rays"),
            Asking::Hidden => format!("{light} is hidden as a whole by {object}"),
            Asking::All => {
                format!("{light} may be hidden or behind the surface in part: all its {points} points are asked")
            }
        },
        |light, why, points, object| match why {
            Asking::Rule => {
                format!("{light} está a plena vista: una regla de {points} puntos da su media, sin rayos de sombra")
            }
            Asking::InView => format!("{light} está a plena vista: {points} de sus puntos no necesitan rayos de sombra"),
            Asking::Hidden => format!("{object} tapa {light} por entero"),
            Asking::All => format!(
                "{light} puede estar en parte tapada o detrás de la superficie: se preguntan todos sus {points} puntos"
            ),
        };
    /// How many samples are too few, and how many are taken.
    more_samples: fn(u32, u32) -> String =
        |from, to| {
            format!("{from} samples are too few, the interval of their mean is too wide: {to} are taken")
        },
        |from, to| {
            format!("{from} muestras son pocas, el intervalo de su media es demasiado ancho: se toman {to}")
        };
    /// That the pilots around ask for more samples: how many there are and will be.
    more_asked: fn(u32, u32) -> String =
        |from, to| {
            format!("{from} samples are too few for what the first samples of the pixels around it saw: {to} are taken")
        },
        |from, to| {
            format!(
                "{from} muestras son pocas para lo que ven las primeras muestras de los píxeles de alrededor: se toman {to}"
            )
        };
    /// How many digits can be trusted; the counts, and whether they are one single digit.
    digits: fn(&str, bool) -> String =
        |counts, is_one| format!("{counts} {}", if is_one { "digit" } else { "digits" }),
        |counts, is_one| format!("{counts} {}", if is_one { "cifra" } else { "cifras" });
    /// A decision that differs between runs.
    decision_differs: Text = "the decision differs between runs", "la decisión no es la misma en todas las ejecuciones";
    /// A value that depends on such a decision.
    no_digits: Text =
        "0 digits: a decision differs between runs",
        "0 cifras: una decisión no es la misma en todas las ejecuciones";

    // Where light comes from.
    /// A light on an object.
    light_on: OfNames = |light, object| format!("{light} on {object}"), |light, object| format!("{light} en {object}");
    /// Ambient light on an object.
    ambient_on: OfName = |object| format!("ambient on {object}"), |object| format!("luz ambiente en {object}");
    /// The background as a source.
    from_background: Text = "background", "luz de fondo";
    /// What the rounding of values adds.
    from_rounding: Text = "rounding of the values", "redondeo de los valores";
    /// What the operands that a log holds leave unexplained.
    unexplained: Text = "not explained by this log", "este registro no lo explica";
    /// A light behind the surface.
    light_behind: OfName =
        |light| format!("{light} stands behind the surface"),
        |light| format!("{light} está detrás de la superficie");
    /// A light that an object blocks.
    light_blocked: OfNames =
        |light, object| format!("{light} is blocked by {object}"),
        |light, object| format!("{object} bloquea {light}");
    /// The log ends within a ray.
    log_ends: Text = "the log ends before this ray does", "el registro termina antes que este rayo";
    /// Why a path brings nothing, where nobody knows.
    nothing: Text = "nothing", "nada";

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
