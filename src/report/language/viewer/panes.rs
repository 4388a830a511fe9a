//! The panes and the bottom line.

use crate::report::language::Text;

texts! {
    /// The texts of the bottom line.
    Status;
    /// The step, of how many.
    step(step: usize, count: usize) = "step {step}/{count}", "paso {step}/{count}";
    /// The section of the source text that has a quantity.
    section(section: &str) = "section {section}", "sección {section}";
    /// The numeric example of the source text doesn't compute it.
    left_out = "(left out)", "(omitido)";
    /// What some keys do, by pane and mode.
    hints: StatusHints;
    /// It plays, at this many steps per second.
    playing(rate: u32) = "playing {rate}/s", "reproduce {rate}/s";
    /// The tree grows.
    growing = "growing", "crece";
    /// The tree is filtered.
    filtered = "filtered", "filtrado";
    /// The tree has no intersection tests.
    no_tests = "no tests", "sin pruebas";
    /// The word for shadow rays.
    shadow = "shadow", "sombra";
    /// The mouse is used.
    mouse = "mouse", "ratón";
    /// A search isn't complete.
    counting = "counting matches", "contando coincidencias";
    /// Which match, of how many.
    matches(number: &str, count: &str) = "match {number}/{count}", "coincidencia {number}/{count}";
    /// How many values and decisions of a quiz were right at once, right later, told, passed.
    quiz: fn([u32; 4]) -> String =
        |counts| score("quiz", counts, ["right", "later", "told", "passed"]),
        |counts| score("cuestionario", counts, ["bien", "después", "dichos", "pasados"]);
    /// Before a line that filters.
    filter = "filter: ", "filtro: ";
    /// Before a breakpoint.
    break_at = "break at: ", "parar en: ";
    /// Before what keys are looked for by.
    keys_with = "keys with: ", "teclas con: ";
    /// Before an answer.
    answer = "your answer: ", "su respuesta: ";
    /// Before a warning.
    warning = "warning: ", "aviso: ";
    /// The terminal is too small.
    too_small: [Text; 3] = ["too small:", "needs 20x6", "(q quits)"], ["pequeño:", "mínimo 20x6", "(q sale)"];
}

/// A score without what there is none of.
fn score(quiz: &str, counts: [u32; 4], words: [&str; 4]) -> String {
    let some = counts.iter().zip(words).filter(|(count, _)| **count > 0);
    let some: Vec<_> = some.map(|(count, word)| format!("{count} {word}")).collect();
    format!("{quiz} {}", some.join(", ")).trim_end().to_owned()
}

texts! {
    /// What some keys do, the most useful first: as many are shown as there is room for.
    StatusHints;
    /// Where there is no room for others.
    help = "? help", "? ayuda";
    /// Behind all others.
    quit = "q quit", "q salir";
    /// In the tree.
    tree: &'static [Text] =
        &["n next value", "w why", "d made of", "a digits", "/ find", "b break", "T no tests", "V symbols", "p previous", "Space fold", "W rounding", "r run"],
        &["n siguiente", "w por qué", "d de qué", "a cifras", "/ busca", "b para", "T sin pruebas", "V símbolos", "p anterior", "Space pliega", "W redondeo", "r ejecuta"];
    /// In the computation.
    computation: &'static [Text] =
        &["n next value", "d made of", "D used in", "a digits", "j k move", "V symbols", "W rounding", "p previous", "y copy", "Tab pane"],
        &["n siguiente", "d de qué", "D para qué", "a cifras", "j k mueven", "V símbolos", "W redondeo", "p anterior", "y copia", "Tab panel"];
    /// In the picture.
    picture: &'static [Text] =
        &["h j k l pixel", "H J K L cell", "Enter tree", "v layers", "i I zoom", "A rays", "( ) exposure", "w why", "Tab pane"],
        &["h j k l píxel", "H J K L celda", "Enter árbol", "v capas", "i I zoom", "A rayos", "( ) exposición", "w por qué", "Tab panel"];
    /// In the schematic.
    schematic: &'static [Text] =
        &["v turn", "Z what", "X shadow rays", "i I zoom", "n next value", "} next ray", "Tab pane"],
        &["v gira", "Z qué", "X sombras", "i I zoom", "n siguiente", "} rayo siguiente", "Tab panel"];
    /// In the schematic while it shows vectors.
    vectors: &'static [Text] =
        &["Z rays", "} next ray", "n next value", "Tab pane"],
        &["Z rayos", "} rayo siguiente", "n siguiente", "Tab panel"];
    /// In the algorithm.
    code: &'static [Text] =
        &["n next value", "] next event", "} next ray", "p previous", "Tab pane"],
        &["n siguiente", "] suceso siguiente", "} rayo siguiente", "p anterior", "Tab panel"];
    /// While something is searched for.
    search: &'static [Text] = &["; next  , previous"], &["; siguiente  , anterior"];
    /// While it plays.
    playing: &'static [Text] = &["P stop", "+ - speed"], &["P para", "+ - velocidad"];
    /// In a quiz.
    quiz: &'static [Text] = &["= answer", "Q end"], &["= responde", "Q termina"];
}

texts! {
    /// The texts of panes.
    Panes;
    /// What is shown: the pixel or ray of which scene, and how many steps.
    what(subject: &str, scene: &str, steps: usize) =
        "raywalk: {subject} of {scene}, {steps} steps",
        "raywalk: {subject} de {scene}, {steps} pasos";
    /// The program, and what it shows in fewer words.
    program(what: &str) = "raywalk: {what}", "raywalk: {what}";
    /// The pixel or ray and the scene.
    what_briefly(subject: &str, scene: &str) = "{subject} of {scene}", "{subject} de {scene}";
    /// The algorithm, by its name.
    algorithm(name: &str) = "{name} algorithm", "algoritmo {name}";
    /// The calls below it.
    calls = "calls", "llamadas";
    /// A shadow ray among them.
    shadow_ray(path: &str) = "shadow ray {path}", "rayo de sombra {path}";
    /// The end of a node.
    end = "end", "fin";
    /// The end of a node, by what it is.
    end_of(node: &str) = "end of {node}", "fin de: {node}";
    /// A decision that is hidden.
    hidden_decision = "decision ?", "¿decisión?";
    /// A result that is hidden.
    hidden_result = "result ?", "¿resultado?";
    /// What is still to come.
    not_computed = "not computed yet", "no calculado aún";
    /// A colour as the result.
    result(color: &str) = "result {color}", "resultado {color}";
    /// A ray by what it is for, without its path.
    ray(kind: &str) = "ray {kind}", "rayo {kind}";
    /// How many rays a closed node hides.
    hidden_rays: fn(u32) -> String =
        |count| if count == 1 { "1 ray".to_owned() } else { format!("{count} rays") },
        |count| if count == 1 { "1 rayo".to_owned() } else { format!("{count} rayos") };
    /// What nodes came to.
    outcomes: Outcomes;
    /// The number of samples that are drawn.
    samples: fn(usize) -> String =
        |count| match count {
            1 => "1 sample in the pixel".to_owned(),
            _ => format!("{count} samples in the pixel"),
        },
        |count| match count {
            1 => "1 muestra en el píxel".to_owned(),
            _ => format!("{count} muestras en el píxel"),
        };
    /// The picture.
    picture: Picture;
    /// The schematic.
    schematic: Schematic;
}

texts! {
    /// What a node came to, in a word or two.
    Outcomes;
    /// A shadow ray that reaches its light.
    lit = "lit", "llega la luz";
    /// A hit.
    hit = "hit", "interseca";
    /// A miss.
    miss = "miss", "no interseca";
    /// Nothing is hit.
    background = "background", "fondo";
    /// An object blocks the light.
    blocked_by(object: &str) = "blocked by {object}", "bloqueado por {object}";
    /// A direction on the wrong side.
    rejected = "rejected", "rechazado";
    /// An object weakens the light.
    weakened_by(object: &str) = "weakened by {object}", "atenuado por {object}";
    /// A light on the other side of the surface.
    behind = "behind the surface", "detrás de la superficie";
    /// A light that no shadow ray goes to, for another reason.
    no_shadow_ray = "no shadow ray", "sin rayo de sombra";
    /// The depth limit.
    depth_limit = "depth limit", "profundidad máxima";
    /// Total internal reflection.
    total_reflection = "total reflection", "reflexión total";
}

texts! {
    /// The texts of the picture.
    Picture;
    /// Its layers: the colours, the depth, the rays, the samples, the error of single precision.
    layers: [Text; 5] =
        ["picture", "depth", "rays per pixel", "samples per pixel", "error of f32"],
        ["imagen", "profundidad", "rayos por píxel", "muestras por píxel", "error de f32"];
    /// The exposure in stops.
    exposure(stops: &str) = "{stops} stops", "exposición {stops}";
    /// The exposure that fits the picture into what can be shown.
    fitting(stops: &str) = "above white: shown {stops} stops", "supera el blanco: exposición {stops}";
    /// The depth of a pixel.
    depth(depth: &str) = "depth {depth}", "profundidad {depth}";
    /// The rays of a pixel.
    rays(count: u32) = "rays {count}", "rayos {count}";
    /// Its levels in a file.
    levels([r, g, b]: [u8; 3]) = "8-bit {r} {g} {b}", "8 bits {r} {g} {b}";
    /// How the components of a triple are shown.
    axes([least, greatest]: &[String; 2]) =
        "x red, y green, z blue, {least} to {greatest}",
        "x rojo, y verde, z azul, de {least} a {greatest}";
    /// A pixel has no value.
    none = "none", "ninguno";
    /// No pixel has a value.
    no_pixel_has_it = "no pixel has it", "ningún píxel lo tiene";
    /// The cursor is at the edge.
    ends = "the picture ends here", "la imagen termina aquí";
}

texts! {
    /// The texts of the schematic.
    Schematic;
    /// From where it is seen: from above, from the front, from the right, from the eye.
    views: [Text; 4] =
        ["schematic from above", "schematic from the front", "schematic from the side", "schematic from the eye"],
        ["esquema desde arriba", "esquema de frente", "esquema de lado", "esquema desde el ojo"];
    /// What it shows: the rays to the selected node and below it, all of the pixel, the vectors at the hit.
    shown: [Text; 3] =
        ["this branch", "all rays", "vectors at the hit"],
        ["esta rama", "todos los rayos", "vectores en la intersección"];
    /// Shadow rays are drawn, too.
    with_shadows = ", shadow rays", ", rayos de sombra";
    /// The keys that change it.
    turns = "v turns, Z rays", "v gira, Z rayos";
    /// The vectors at a point, which a ray hits.
    vectors(point: &str, path: &str) = "vectors at {point} ({path})", "vectores en {point} ({path})";
    /// The selected node belongs to no hit.
    no_hit = "nothing is hit here", "aquí no se interseca nada";
    /// The pane is too small.
    too_small = "too small", "sin espacio";
    /// What they can't be seen from.
    own_plane = "the vectors are drawn in a plane of their own", "los vectores se dibujan en un plano propio";
    /// An arrow is drawn shorter than the vector is.
    out_of_plane = "short arrows point out of the plane", "las flechas cortas salen del plano";
    /// There is no ray to be drawn.
    no_rays = "the log has no rays here", "el registro no tiene rayos aquí";
    /// The rays are too long to be drawn.
    too_far = "the rays reach too far to be drawn", "los rayos llegan demasiado lejos para dibujarlos";
}
