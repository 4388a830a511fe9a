//! What is said at the bottom, in Spanish.

use crate::log::file::Ending;
use crate::report::language::viewer::{Breakpoints, Commands, Messages, Quiz, Warnings};

pub(super) const MESSAGES: Messages = Messages {
    last_step: |count| format!("hay {count} pasos; este es el último"),
    no_shell: "no hay intérprete de órdenes al que ir",
    no_scene: "un registro guardado no tiene escena que trazar",
    other_pane: "eso es para la imagen y el esquema; Tab va allí",
    no_key: "esa tecla no existe; ? muestra las teclas",
    no_siblings: "no hay más nodos del mismo padre",
    no_steps: "no hay más pasos en esta dirección",
    no_values: "no hay más valores calculados en esta dirección",
    no_rays: "no hay más rayos en esta dirección",
    no_step_over: "no hay más pasos aquí ni alrededor en esta dirección",
    no_step_out: "no hay nada alrededor a lo que salir en esta dirección",
    whole_tree: "se muestra el árbol entero",
    tree_grows: "el árbol crece con los pasos; t lo muestra entero",
    rate: |rate, is_playing| {
        let steps = if rate == 1 { "paso" } else { "pasos" };
        format!("{rate} {steps} por segundo{}", if is_playing { "" } else { "; P reproduce" })
    },
    nothing_to_play: "no hay más valores calculados que reproducir; 0 va al primer paso",
    played: "reproducido hasta el último valor calculado",
    nowhere_back: "no hay adónde volver: no ha habido saltos",
    no_jump: "no hay salto del que volver",
    not_traced_again: "lo anterior al primer píxel no se vuelve a trazar",
    nearest_step: "ese paso no está en este registro; este es el más cercano",
    copied: |text| format!("copiado: {text}"),
    no_step_to_remember: "no hay paso que recordar",
    bookmark: |letter, address| format!("marcador {letter}: {address}"),
    no_bookmark: |letter| format!("no hay marcador {letter}; m{letter} lo pone, M los enumera"),
    bookmark_elsewhere: |letter, address| format!("marcador {letter}: este registro no tiene {address}"),
    no_search: "no se busca nada; / busca",
    not_found: |text| format!("no se encuentra: {text}"),
    no_row: |text| format!("ninguna fila coincide: {text}"),
    from_the_beginning: "otra vez desde el principio",
    from_the_end: "otra vez desde el final",
    pasted_nowhere: "solo se puede pegar texto en una línea que se está escribiendo, como tras / o :",
    mouse_is_ours: "el ratón selecciona y desplaza; ^t lo devuelve",
    mouse_is_the_terminals: "el ratón es del terminal",
    one_pixel_printed: "el libro solo imprime un píxel",
    regions_not_compared: "solo se comparan píxeles y rayos",
    too_long: |most| format!("el registro tendría más de {most} sucesos"),
    no_memory: "no hay memoria para el registro",
    language: "en español",
    back_here: |call| format!("para volver aquí: {call}"),
    warnings: Warnings {
        ending: |ending| match ending {
            Ending::Complete => None,
            Ending::Missing { incomplete_record: false } => {
                Some("el registro no tiene línea final: está cortado".to_owned())
            }
            Ending::Missing { incomplete_record: true } => {
                Some("el registro está cortado: se ha omitido 1 línea incompleta".to_owned())
            }
            Ending::Unknown { count, key, line } => {
                let values = if *count == 1 { "1 valor" } else { &format!("{count} valores") };
                Some(format!(
                    "se han omitido {values} de magnitudes desconocidas, el primero en la línea {line}: `{key}`"
                ))
            }
            Ending::Mismatch { what } => Some(format!("el registro ha cambiado después de escribirse: {what}")),
            Ending::Damaged { what } => Some(format!("el registro está dañado, esto es lo que hay antes: {what}")),
        },
        biased: |effects| {
            format!(
                "el muestreo adaptativo tiene sesgo con {effects}: las celdas cuyas esquinas coinciden por azar no se \
                 dividen; se espera otro muestreo, como sobol:64"
            )
        },
    },
};

pub(super) const QUIZ: Quiz = Quiz {
    begins: "cuestionario: n va al siguiente valor, = lo responde, Q termina",
    ends: |right, asked| format!("fin del cuestionario: {right} de {asked} bien"),
    none: "no hay cuestionario; Q empieza uno",
    nothing_hidden: "este paso no oculta ningún resultado; n va al siguiente",
    what_is_decided: "¿qué se decide? hit (interseca), miss (no), inside (dentro), background (fondo), un objeto, ...",
    right: "correcto",
    off: |by| format!("se desvía en {by}"),
    not_it: "no es eso",
    it_is: |off, truth| format!("{off}; es {truth}"),
    try_again: |off| format!("{off}; inténtelo otra vez"),
    no_number: "eso no es un número: escríbalo como 12,5",
    no_triple: "eso no son tres números: escríbalos como (1; 2; 3) o 1 2 3",
    no_decision: "eso no es una decisión: escriba hit, miss, nearest, background o el nombre de un objeto",
    tells_results: "eso diría los resultados; Q termina el cuestionario",
    tells_result: "eso diría el resultado; = responde, Q termina el cuestionario",
    tells_decision: "eso diría la decisión; = responde, Q termina el cuestionario",
};

pub(super) const BREAKPOINTS: Breakpoints = Breakpoints {
    set: |text| format!("punto de interrupción: {text}; r va hasta él, B los enumera"),
    deleted: |text| format!("ya no hay punto de interrupción: {text}"),
    hidden: "un cuestionario oculta dónde se para; Q lo termina",
    nothing_here: "aquí no hay nada en lo que pararse",
    nowhere: |text| format!("en ningún lugar de este registro: {text}"),
    all_off: "todos los puntos de interrupción están desactivados; B los enumera",
    none: "no hay puntos de interrupción; b pone uno",
    no_more: |done, times, is_forward| {
        let stopped = if done == 0 { String::new() } else { format!("parado {done} de {times} veces; ") };
        let side = if is_forward { "después" } else { "antes" };
        format!("{stopped}ningún punto de interrupción {side} de este paso")
    },
    stopped: |breakpoint, what| format!("parado por {breakpoint}: {what}"),
    expected: "se espera un punto de interrupción: hit, shadow, object NOMBRE, light NOMBRE, depth 2 o T2_A < 0",
    expected_kind: "se espera una clase de suceso, como shadow, hit, occluded o total-internal-reflection",
    kind_like: |text, near| format!("ninguna clase de suceso se llama `{text}`; ¿quiso decir `{near}`?"),
    object_like: |text, near| format!("no hay ningún objeto `{text}`; ¿quiso decir `{near}`?"),
    other_objects: |text, others, more| format!("no hay ningún objeto `{text}`, sino {others}{}", and_more(more)),
    no_objects: "no hay ningún objeto en este registro",
    light_like: |text, near| format!("no hay ninguna fuente `{text}`; ¿quiso decir `{near}`?"),
    other_lights: |text, others, more| format!("no hay ninguna fuente `{text}`, sino {others}{}", and_more(more)),
    no_lights: "no hay ninguna fuente en este registro",
    expected_depth: "se espera un nivel del árbol de rayos, como depth 2",
    no_components: |symbol| format!("{symbol} es un número y no tiene componentes"),
    three_numbers: |key| {
        format!("{key} son tres números: compare {key}.x, .y o .z (.r, .g o .b), o la longitud |{key}|")
    },
    expected_number: |text| format!("se espera un número como 0 o -1,5e-3, no `{text}`"),
    name_like: |text, near| format!("nada se llama `{text}`; ¿quiso decir `{near}`?"),
    no_name: |text| {
        format!(
            "nada se llama `{text}`: se espera una clase de suceso (hit), object NOMBRE, light NOMBRE, depth 2 o una magnitud (T2_A < 0)"
        )
    },
};

pub(super) const COMMANDS: Commands = Commands {
    letter: "LETRA",
    condition: "CONDICIÓN",
    text: "TEXTO",
    step: ":42 (un paso)",
    nothing_behind: |command| format!("detrás de :{command} no va nada"),
    like: |text, near| format!("no hay orden :{text}; ¿quiso decir :{near}?"),
    expected: |commands| format!("se espera un paso o una orden: {commands}"),
    may_be: |text, commands| format!(":{text} puede ser {commands}"),
    steps: |count| format!("hay pasos del 1 al {count}"),
    expected_letter: "se espera una letra, como :bookmark a",
    expected_pixel: "se esperan una columna y una fila, como :pixel 160,120",
    expected_language: "se espera un idioma: :lang en o :lang es",
    log_has: |[left, top, right, bottom]| {
        format!("el registro tiene las columnas {left} a {right} y las filas {top} a {bottom}")
    },
    picture_has: |[column, row]| format!("la imagen tiene las columnas 0 a {column} y las filas 0 a {row}"),
};

/// So many more, behind some names.
fn and_more(count: usize) -> String {
    if count == 0 { String::new() } else { format!(" y {count} más") }
}
