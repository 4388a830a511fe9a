//! What is said of breakpoints.

use crate::report::language::Language;

texts! {
    /// What is said of breakpoints.
    Breakpoints;
    /// One was set.
    set(text: &str) =
        "breakpoint: {text}; r runs to it, B lists all",
        "punto de interrupción: {text}; r va hasta él, B los enumera";
    /// One was deleted.
    deleted(text: &str) = "no breakpoint any more: {text}", "ya no hay punto de interrupción: {text}";
    /// The quiz hides where it stops.
    hidden = "a quiz hides where that stops; Q ends it", "un cuestionario oculta dónde se para; Q lo termina";
    /// The step can't have one.
    nothing_here = "nothing here that a run could stop at", "aquí no hay nada en lo que pararse";
    /// It stops nowhere.
    nowhere(text: &str) = "nowhere in this log: {text}", "en ningún lugar de este registro: {text}";
    /// All are off.
    all_off =
        "all breakpoints are off; B lists them",
        "todos los puntos de interrupción están desactivados; B los enumera";
    /// There are none.
    none = "no breakpoints; b sets one", "no hay puntos de interrupción; b pone uno";
    /// A run ended: after some of the stops that were asked for, forward or not.
    no_more: fn(usize, usize, bool) -> String =
        |done, times, is_forward| {
            let stopped = if done == 0 { String::new() } else { format!("stopped {done} of {times} times; ") };
            format!("{stopped}no breakpoint stops {} this step", if is_forward { "after" } else { "before" })
        },
        |done, times, is_forward| {
            let stopped = if done == 0 { String::new() } else { format!("parado {done} de {times} veces; ") };
            let side = if is_forward { "después" } else { "antes" };
            format!("{stopped}ningún punto de interrupción {side} de este paso")
        };
    /// A run stopped: by which, and at what.
    stopped(breakpoint: &str, what: &str) = "stopped by {breakpoint}: {what}", "parado por {breakpoint}: {what}";
    /// What can be typed.
    expected =
        "expected a breakpoint: hit, shadow, object NAME, light NAME, depth 2 or T2_A < 0; and, or join several",
        "se espera un punto de interrupción: hit, shadow, object NOMBRE, light NOMBRE, depth 2 o T2_A < 0; and, or unen varios";
    /// One term is missing beside `and` or `or`.
    nothing_joined =
        "expected a condition before and behind `and` and `or`, such as hit and depth 2",
        "se espera una condición antes y después de `and` y de `or`, como hit and depth 2";
    /// A parenthesis isn't closed at the end of its term.
    not_closed(text: &str) =
        "expected `)` at the end of `({text}`; parentheses go around conditions: (hit or miss) and depth 2",
        "se espera `)` al final de `({text}`; los paréntesis encierran condiciones: (hit or miss) and depth 2";
    /// There are too many parentheses inside each other.
    too_nested = "too many parentheses inside each other", "demasiados paréntesis unos dentro de otros";
    /// What is behind `is` is no class of numbers; the nearest, if there is one.
    expected_class: fn(&str, &str) -> String =
        |text, near| match near {
            "" => format!("expected is nan, is infinite or is finite, or is not nan, ..., not is {text}"),
            near => format!("no number is {text}; did you mean is {near}?"),
        },
        |text, near| match near {
            "" => format!("se espera is nan, is infinite o is finite, o is not nan, ..., no is {text}"),
            near => format!("ningún número es is {text}; ¿quiso decir is {near}?"),
        };
    /// What kinds of events there are.
    expected_kind =
        "expected a kind of event such as shadow, hit, occluded or total-internal-reflection",
        "se espera una clase de suceso, como shadow, hit, occluded o total-internal-reflection";
    /// No kind of event is called so, but so.
    kind_like(text: &str, near: &str) =
        "no kind of event is called `{text}`; did you mean `{near}`?",
        "ninguna clase de suceso se llama `{text}`; ¿quiso decir `{near}`?";
    /// The log has no object called so, but one called so.
    object_like(text: &str, near: &str) =
        "there is no object `{text}`; did you mean `{near}`?",
        "no hay ningún objeto `{text}`; ¿quiso decir `{near}`?";
    /// The log has no object called so, but others, and how many more.
    other_objects: fn(&str, &str, usize) -> String =
        |text, others, more| format!("there is no object `{text}`, but {others}{}", Language::English.and_more(more)),
        |text, others, more| format!("no hay ningún objeto `{text}`, sino {others}{}", Language::Spanish.and_more(more));
    /// The log has no objects.
    no_objects = "there is no object in this log", "no hay ningún objeto en este registro";
    /// The log has no light called so, but one called so.
    light_like(text: &str, near: &str) =
        "there is no light `{text}`; did you mean `{near}`?",
        "no hay ninguna fuente `{text}`; ¿quiso decir `{near}`?";
    /// The log has no light called so, but others, and how many more.
    other_lights: fn(&str, &str, usize) -> String =
        |text, others, more| format!("there is no light `{text}`, but {others}{}", Language::English.and_more(more)),
        |text, others, more| format!("no hay ninguna fuente `{text}`, sino {others}{}", Language::Spanish.and_more(more));
    /// The log has no lights.
    no_lights = "there is no light in this log", "no hay ninguna fuente en este registro";
    /// What can be typed behind `depth`.
    expected_depth =
        "expected a level of the ray tree, such as depth 2 or depth >= 2",
        "se espera un nivel del árbol de rayos, como depth 2 o depth >= 2";
    /// A number has no components.
    no_components(symbol: &str) =
        "{symbol} is a number and has no components",
        "{symbol} es un número y no tiene componentes";
    /// A triple can only be compared by parts.
    three_numbers(key: &str) =
        "{key} has three numbers: compare {key}.x, .y or .z (.r, .g or .b), or the length |{key}|",
        "{key} son tres números: compare {key}.x, .y o .z (.r, .g o .b), o la longitud |{key}|";
    /// It is longer than anybody types.
    too_long(terms: usize, characters: usize) =
        "a condition has at most {terms} terms and {characters} characters",
        "una condición tiene como mucho {terms} términos y {characters} caracteres";
    /// Shown in place of a number.
    expected_number: fn(&str) -> String =
        |text| match text {
            "" => "expected a number such as 0 or -1.5e-3 behind the sign".to_owned(),
            text => format!("expected a number such as 0 or -1.5e-3, not `{text}`"),
        },
        |text| match text {
            "" => "se espera un número como 0 o -1,5e-3 tras el signo".to_owned(),
            text => format!("se espera un número como 0 o -1,5e-3, no `{text}`"),
        };
    /// Nothing is called so, but so.
    name_like(text: &str, near: &str) =
        "nothing is called `{text}`; did you mean `{near}`?",
        "nada se llama `{text}`; ¿quiso decir `{near}`?";
    /// Nothing is called so.
    no_name(text: &str) =
        "nothing is called `{text}`: expected a kind of event (hit), object NAME, light NAME, depth 2 or a quantity (T2_A < 0)",
        "nada se llama `{text}`: se espera una clase de suceso (hit), object NOMBRE, light NOMBRE, depth 2 o una magnitud (T2_A < 0)";
}
