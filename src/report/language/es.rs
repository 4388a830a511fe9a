//! Spanish, with the terms of the source text.

mod close_up;
mod viewer;

use super::{Causes, Figure, Solution, Texts};
use crate::log::{Acceptance, Asking, Miss, SkipReason, Skippable, Split};

pub(super) const TEXTS: Texts = Texts {
    decimal_mark: ',',
    separator: "; ",
    pixel: |[x, y]| format!("píxel {x},{y}"),
    region: |[x0, y0, x1, y1]| format!("región de {x0},{y0} a {x1},{y1}"),
    ray_along: |origin, direction| format!("rayo desde {origin} en la dirección {direction}"),
    sampling_word: |word| match word {
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
    },
    depth: "profundidad",
    given: "con",
    result: "resultado",
    frame: |number| format!("fotograma {number}"),
    sample: |number| format!("muestra {number}"),
    ray: |path, kind| format!("rayo {path}, {kind}"),
    test: |object| format!("intersección con {object}"),
    test_triangle: |object, triangle| format!("intersección con {object}, triángulo {triangle}"),
    local_model: |object| format!("modelo local en {object}"),
    light: |light| format!("fuente {light}"),
    light_point: |light, number| format!("fuente {light}, punto {number}"),
    motion: |object| format!("{object} donde está en este instante"),
    zone: |what, number| match what {
        Skippable::Transmitted => format!("zona {number} de la transmisión"),
        _ => format!("zona {number} de la reflexión"),
    },
    weighted_sum: "suma ponderada",
    from_the_eye: "primario",
    shadow_ray_to: |light| format!("rayo de sombra hacia {light}"),
    reflected: "reflejado",
    transmitted: "transmitido",
    hit: "el rayo interseca con el objeto",
    miss: |why| format!("no hay intersección: {}", miss(why)),
    outside: "el origen del rayo se encuentra fuera",
    inside: "el origen del rayo se encuentra dentro",
    nearest: |object| format!("intersección más cercana: {object}"),
    coincident: |object, triangle| match triangle {
        None => format!("{object} está en el mismo lugar y cuenta como justo detrás"),
        Some(triangle) => {
            format!("el triángulo {triangle} de {object} está en el mismo lugar y cuenta como justo detrás")
        }
    },
    immersed: |object| format!("el rayo empieza dentro de {object}"),
    background: "no interseca con ningún objeto: luz de fondo",
    free: "nada se interpone",
    twice_the_digits: "con el doble de cifras",
    blocked_by: |object| format!("bloqueado por {object}"),
    passes: |object, factor| format!("atraviesa {object}, que deja pasar {factor}"),
    too_fine: |symbol| format!("{symbol} no tiene valor: el patrón es más fino que los números aquí"),
    undefined: |symbol| format!("{symbol} no tiene valor en esta aritmética: habría que dividir entre cero"),
    total_reflection: "reflexión total interna",
    depth_limit: |what| format!("profundidad máxima: no se traza {}", skippable(what)),
    rest_skipped: "se omite el resto",
    leak_guard: |what| format!("{} queda al otro lado de la superficie y no aporta nada", skippable(what)),
    bent: |what| format!("{} iría por debajo de la superficie y se dobla hacia arriba", skippable(what)),
    rejected: |what| format!("rechazado: {} iría por el lado equivocado", skippable(what)),
    skipped: |what, why| format!("se omite {} ({})", skippable(what), skip_reason(why)),
    lost: |bound| format!("se pierde como mucho {bound} de la muestra"),
    whole_pixel: "el píxel",
    cell: |x, y, side| format!("la celda en ({x}; {y}) de lado {side}"),
    subdivided: |cell, why, object| match why {
        Split::Color => format!("se subdivide {cell}: los colores de sus esquinas difieren más que el umbral"),
        Split::Objects => format!("se subdivide {cell}: sus esquinas ven objetos distintos"),
        Split::SmallObject => {
            format!("se subdivide {cell}: {object} puede estar en su interior y ninguna esquina lo ve")
        }
    },
    an_object: "un objeto",
    mean: "la media",
    accepted: |what, why| format!("se acepta {what}: {}", acceptance(why)),
    asked: |light, why, points, object| match why {
        Asking::Rule => {
            format!("{light} está a plena vista: una regla de {points} puntos da su media, sin rayos de sombra")
        }
        Asking::InView => format!("{light} está a plena vista: {points} de sus puntos no necesitan rayos de sombra"),
        Asking::Hidden => format!("{object} tapa {light} por entero"),
        Asking::All => format!(
            "{light} puede estar en parte tapada o detrás de la superficie: se preguntan todos sus {points} puntos"
        ),
    },
    more_samples: |from, to| {
        format!("{from} muestras son pocas, el intervalo de su media es demasiado ancho: se toman {to}")
    },
    more_asked: |from, to| {
        format!(
            "{from} muestras son pocas para lo que ven las primeras muestras de los píxeles de alrededor: se toman {to}"
        )
    },
    digits: |counts, is_one| format!("{counts} {}", if is_one { "cifra" } else { "cifras" }),
    decision_differs: "la decisión no es la misma en todas las ejecuciones",
    no_digits: "0 cifras: una decisión no es la misma en todas las ejecuciones",
    light_on: |light, object| format!("{light} en {object}"),
    ambient_on: |object| format!("luz ambiente en {object}"),
    from_background: "luz de fondo",
    from_rounding: "redondeo de los valores",
    unexplained: "este registro no lo explica",
    light_behind: |light| format!("{light} está detrás de la superficie"),
    light_blocked: |light, object| format!("{object} bloquea {light}"),
    log_ends: "el registro termina antes que este rayo",
    nothing: "nada",
    solution: Solution {
        title: |subject, scene| format!("Ejemplo resuelto: {subject} de {scene}"),
        conditions: |arithmetic, algorithm, depth| {
            format!("Aritmética {arithmetic}, algoritmo {algorithm}, nivel de profundidad máximo {depth}.")
        },
        sampled: |method| format!("Muestras: {method}."),
        data: "Datos",
        everywhere: "En toda la escena",
        object: |object| format!("Objeto {object}"),
        source: |light| format!("Fuente {light}"),
        steps: "Desarrollo",
        with: "Con",
        aim: "Se calcula el vector director del rayo",
        intersection: |object| format!("Se averigua si el rayo interseca con {object}"),
        intersection_triangle: |object, triangle| {
            format!("Se averigua si el rayo interseca con el triángulo {triangle} de {object}")
        },
        intersection_moving: |object| format!("Se averigua si el rayo interseca con {object}, que se mueve"),
        point: "Se calculan el punto de intersección más cercano y su normal",
        local: |object| format!("Se calcula la intensidad local en {object}"),
        reflection: "Se calcula el vector director del rayo reflejado",
        transmission: "Se calcula el vector director del rayo transmitido",
        blur: "Se calcula la media de la contribución difusa de las zonas",
        combine: |path| format!("Se calcula la intensidad global que aporta el rayo {path}"),
        sampling: "Se eligen las muestras del píxel",
        back: |title| format!("De vuelta en el {title}"),
        result: "Resultado",
        conclusion: |color| format!("Finalmente, la intensidad que llega al observador es {color}."),
        no_result: "El registro termina antes de conocerse la intensidad.",
        contributions: "Contribuciones",
        columns: ["camino", "procedencia", "clase", "intensidad", "peso", "aporta", "parte"],
        sum: "suma",
        smaller: |count| format!("otras {count} menores"),
        brings_nothing: "Lo que no aporta nada",
        more: |count| format!("y {count} más"),
        section: |section| format!("sección {section} del texto"),
        open_all: "Abrir todo",
        close_all: "Cerrar todo",
    },
    causes: Causes {
        rounded: "redondeado",
        exact: "en f64",
        off: "diferencia",
        expected: "esperada",
        of_runs: |runs| format!("de {runs} ejecuciones que redondean hacia arriba o hacia abajo al azar"),
        other_tree: "El redondeo cambia el árbol de rayos: lo que solo se calcula en él no figura aquí.",
        columns: ["solo ella redondeada", "todas menos ella", "magnitud", "dónde"],
        idle: |quantities| match quantities {
            1 => "Otra magnitud no cambia nada cuando solo se redondea ella.".to_owned(),
            _ => format!("Otras {quantities} magnitudes no cambian nada cuando solo se redondea una de ellas."),
        },
        star: "*  El árbol de rayos es otro que en f64.",
    },
    figure: Figure {
        ray_tree: "Árbol de rayos",
        call_tree: "Árbol de llamadas",
        schematic: "Esquema de los rayos",
        plane: |right, up| format!("{right} hacia la derecha, {up} hacia arriba"),
        eye: "ojo",
        background: "fondo",
        blocked: |object| format!("bloqueado por {object}"),
        too_many: |rays| {
            format!("El árbol tiene {rays} rayos, demasiados para esta página: lo dibuja `raywalk trace --format svg`.")
        },
        first_sample: |samples| format!("La figura muestra la primera de {samples} muestras."),
        width: "cuanto más ancha la línea, más intensidad del píxel llega por ella",
        kinds: ["C: primario", "R: reflejado", "T: transmitido", "S: de sombra", "S: bloqueado"],
        adds: |share, color| format!("{share} de la intensidad, {color}"),
        no_rays: "El registro no tiene rayos que se puedan dibujar.",
    },
    close_up: close_up::CLOSE_UP,
    viewer: viewer::VIEWER,
};

fn miss(why: Miss) -> &'static str {
    match why {
        Miss::Parallel => "el rayo es paralelo",
        Miss::Behind => "queda detrás del origen del rayo",
        Miss::Beside => "el rayo pasa de largo",
        Miss::Beyond => "queda más allá de la fuente",
        Miss::FacesAway => "da la espalda al rayo",
        Miss::BeginsThere => "el rayo empieza en él",
    }
}

fn skippable(what: Skippable) -> &'static str {
    match what {
        Skippable::Reflected => "el rayo reflejado",
        Skippable::Transmitted => "el rayo transmitido",
        Skippable::Shadow => "el rayo de sombra",
        Skippable::Local => "el modelo local",
        Skippable::Specular => "la componente especular",
    }
}

fn skip_reason(why: SkipReason) -> &'static str {
    match why {
        SkipReason::ZeroWeight | SkipReason::ZeroLocal => "su peso es cero",
        SkipReason::NoLocalTerm => "ningún coeficiente usaría la luz",
        SkipReason::Blocked => "ya está totalmente bloqueado",
        SkipReason::Cutoff => "su peso está por debajo del límite",
        SkipReason::ZeroPath => "los pesos de su camino no dejan nada de ningún color",
        SkipReason::ZeroTerm => "su coeficiente es cero",
        SkipReason::Behind => "la fuente está detrás de la superficie",
        SkipReason::ZeroLight => "el color de la fuente y los coeficientes no dejan nada de ningún color",
        SkipReason::ZeroPathLocal => "su peso y los de su camino no dejan nada de ningún color",
        SkipReason::ZeroPathLight => {
            "los pesos de su camino, el color de la fuente y los coeficientes no dejan nada de ningún color"
        }
    }
}

fn acceptance(why: Acceptance) -> &'static str {
    match why {
        Acceptance::Alike => "las muestras coinciden",
        Acceptance::Depth => "no se puede dividir más",
        Acceptance::Interval => "su intervalo es bastante estrecho",
        Acceptance::Max => "no puede haber más muestras",
        Acceptance::Guided => "sus muestras son tantas como piden las primeras muestras de los píxeles de alrededor",
    }
}
