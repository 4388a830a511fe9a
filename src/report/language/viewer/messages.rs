//! What is said at the bottom: why something can't be done, and what was done that isn't seen.

use crate::log::file::Ending;

texts! {
    /// What is said at the bottom.
    Messages;
    /// There are fewer steps than that.
    last_step(count: usize) = "there are {count} steps; this is the last", "hay {count} pasos; este es el último";
    /// There is no job control to resume the viewer.
    no_shell = "there is no shell to go to", "no hay intérprete de órdenes al que ir";
    /// A saved log can't be traced.
    no_scene = "a saved log has no scene to trace", "un registro guardado no tiene escena que trazar";
    /// Nothing was changed that could be taken back or compared.
    nothing_changed = "the scene is as it was read; :set changes it", "la escena está como se leyó; :set la cambia";
    /// `:set` was typed alone.
    no_path =
        "expected a path and a value, such as :set objects.sphere.shape.sphere.radius 2.5; Tab completes it",
        "se espera una ruta y un valor, como :set objects.sphere.shape.sphere.radius 2.5; Tab la completa";
    /// A path leads nowhere.
    no_parameter: fn(&str, &str) -> String =
        |path, known| match known {
            "" => format!("nothing is inside of `{path}`"),
            known => format!("no `{path}`; there is {known}"),
        },
        |path, known| match known {
            "" => format!("no hay nada dentro de `{path}`"),
            known => format!("no hay `{path}`; hay {known}"),
        };
    /// The scene has no light of that name; what may have been meant.
    no_light: fn(&str, &str, &str) -> String =
        |name, near, known| match near {
            "" => format!("no light `{name}`; there is {known}"),
            near => format!("no light `{name}`; did you mean `{near}`? there is {known}"),
        },
        |name, near, known| match near {
            "" => format!("no hay luz `{name}`; hay {known}"),
            near => format!("no hay luz `{name}`; ¿quiso decir `{near}`? hay {known}"),
        };
    /// No path can be of that class.
    no_class(class: &str, known: &str) =
        "no path is of the class {class}; here there are {known}",
        "ningún camino es de la clase {class}; aquí hay {known}";
    /// A change of the scene changes nothing here.
    no_value_differs = "nothing differs here", "aquí no cambia nada";
    /// How much a change of the scene changes here.
    values_differ: fn(usize, &str) -> String =
        |count, first| match count {
            1 => format!("1 difference: {first}; :compare shows both"),
            _ => format!("{count} differences, first {first}; :compare shows both"),
        },
        |count, first| match count {
            1 => format!("1 diferencia: {first}; :compare muestra ambos"),
            _ => format!("{count} diferencias, la primera {first}; :compare muestra ambos"),
        };
    /// The scene was read anew.
    reloaded(what: &str) = "reloaded: {what}", "leída de nuevo: {what}";
    /// The files of the scene have changed, and it can't be read any more.
    not_reloaded(why: &str) = "not reloaded: {why}", "no se ha vuelto a leer: {why}";
    /// The scene was saved.
    saved(path: &str) = "saved as {path}", "guardada como {path}";
    /// Something was saved in a file.
    written(path: &str) = "saved as {path}", "guardado como {path}";
    /// Results go to files only.
    no_file = "expected the name of a file", "se espera el nombre de un archivo";
    /// How the name of a file may end.
    expected_ending(known: &str) = "expected a name that ends in one of {known}", "se espera un nombre que termine en uno de {known}";
    /// There is no file to edit.
    no_source = "this scene has no file of its own to edit", "esta escena no tiene un archivo propio que editar";
    /// The editor couldn't be run.
    no_editor(why: &str) = "can't run $EDITOR: {why}", "no se puede ejecutar $EDITOR: {why}";
    /// The titles of what was before a change, and of what is now.
    before_and_now: [&'static str; 2] = ["before", "now"], ["antes", "ahora"];
    /// Whether shadow rays are drawn: no, yes.
    shadows: [&'static str; 2] =
        ["without shadow rays", "with shadow rays"],
        ["sin rayos de sombra", "con rayos de sombra"];
    /// Whether rays are drawn over the picture: no, yes.
    rays_over: [&'static str; 2] =
        ["no rays over the picture", "rays over the picture"],
        ["sin rayos sobre la imagen", "rayos sobre la imagen"];
    /// There is no picture to draw them over.
    no_picture = "there is no picture: a saved log has no scene", "no hay imagen: un registro guardado no tiene escena";
    /// Nor is there an eye to look from.
    no_eye =
        "the view from the eye needs the scene, which a saved log lacks",
        "la vista desde el ojo necesita la escena, que un registro guardado no tiene";
    /// The key is for other panes.
    other_pane =
        "that is for the picture and the schematic; Tab goes there",
        "eso es para la imagen y el esquema; Tab va allí";
    /// The key means nothing.
    no_key = "no such key; ? shows the keys", "esa tecla no existe; ? muestra las teclas";
    /// The node has no more siblings.
    no_siblings = "no more nodes in this one's parent", "no hay más nodos del mismo padre";
    /// The log ends.
    no_steps = "no more steps in this direction", "no hay más pasos en esta dirección";
    /// It has no more values.
    no_values = "no more computed values in this direction", "no hay más valores calculados en esta dirección";
    /// It has no more rays.
    no_rays = "no more rays in this direction", "no hay más rayos en esta dirección";
    /// There is nothing to step over to.
    no_step_over =
        "no more steps here or around it in this direction",
        "no hay más pasos aquí ni alrededor en esta dirección";
    /// There is nothing to step out to.
    no_step_out =
        "nothing around it to step out to in this direction",
        "no hay nada alrededor a lo que salir en esta dirección";
    /// All of the tree is shown.
    whole_tree = "the whole tree is shown", "se muestra el árbol entero";
    /// It grows.
    tree_grows =
        "the tree grows with the steps; t shows all of it",
        "el árbol crece con los pasos; t lo muestra entero";
    /// The tree has no intersection tests now.
    tests_hidden = "rays, local models and sums only; T shows the tests", "solo rayos, modelos locales y sumas; T muestra las pruebas";
    /// It has them again.
    tests_shown = "with the intersection tests", "con las pruebas de intersección";
    /// It plays at this many steps per second, or would.
    rate: fn(u32, bool) -> String =
        |rate, is_playing| {
            let steps = if rate == 1 { "step" } else { "steps" };
            format!("{rate} {steps} a second{}", if is_playing { "" } else { "; P plays" })
        },
        |rate, is_playing| {
            let steps = if rate == 1 { "paso" } else { "pasos" };
            format!("{rate} {steps} por segundo{}", if is_playing { "" } else { "; P reproduce" })
        };
    /// There is nothing left to play.
    nothing_to_play =
        "no more computed values to play; 0 goes to the first step",
        "no hay más valores calculados que reproducir; 0 va al primer paso";
    /// All was played.
    played = "played to the last computed value", "reproducido hasta el último valor calculado";
    /// Nothing was jumped from.
    nowhere_back = "nowhere to go back to: nothing was jumped from", "no hay adónde volver: no ha habido saltos";
    /// There was no jump.
    no_jump = "no jump to come back from", "no hay salto del que volver";
    /// A ray of one's own isn't traced again.
    not_traced_again =
        "where one was before the first pixel isn't traced again",
        "lo anterior al primer píxel no se vuelve a trazar";
    /// The step is only near.
    nearest_step =
        "that step isn't in this log; this is the nearest",
        "ese paso no está en este registro; este es el más cercano";
    /// What was sent to be copied: only the terminal knows whether it allows that.
    copied(text: &str) =
        "sent to the terminal's clipboard: {text}",
        "enviado al portapapeles del terminal: {text}";
    /// The log has no steps.
    no_step_to_remember = "no step to remember", "no hay paso que recordar";
    /// A bookmark, and its address.
    bookmark(letter: char, address: &str) = "bookmark {letter}: {address}", "marcador {letter}: {address}";
    /// A bookmark with a note.
    noted(letter: char, note: &str) = "bookmark {letter}: {note}", "marcador {letter}: {note}";
    /// A bookmark was deleted.
    bookmark_deleted(letter: char) = "no bookmark {letter} any more", "ya no hay marcador {letter}";
    /// No letter is left for another bookmark.
    no_letter = "every letter from a to z is taken; :bookmark a TEXT takes one anew", "todas las letras de la a a la z están ocupadas; :bookmark a TEXTO toma una de nuevo";
    /// A note is too long.
    note_too_long(most: usize) = "a note has at most {most} characters", "una nota tiene como mucho {most} caracteres";
    /// There are too many notes.
    too_many_notes(most: usize) = "at most {most} bookmarks have notes", "como mucho {most} marcadores tienen notas";
    /// What was done with a note, and the file that keeps it.
    kept_in(done: &str, file: &str) = "{done} (kept in {file})", "{done} (guardado en {file})";
    /// What was done with the last note, and the file that kept it.
    kept_no_longer(done: &str, file: &str) = "{done} (no notes are left: {file} is removed)", "{done} (no quedan notas: se elimina {file})";
    /// What was done with a note, and why it isn't kept.
    not_kept(done: &str, why: &str) = "{done} (only until you leave: {why})", "{done} (solo hasta que salga: {why})";
    /// Only notes of saved logs are kept.
    only_of_logs =
        "only notes on a saved log are kept in a file, beside it",
        "solo las notas de un registro guardado se guardan en un archivo, junto a él";
    /// A file isn't one of notes.
    not_ours(file: &str) =
        "{file} is no file of bookmarks of this version, and stays as it is",
        "{file} no es un archivo de marcadores de esta versión, y se queda como está";
    /// A file has been changed by another program.
    changed_meanwhile(file: &str) =
        "{file} has been changed by another program, and stays as it is",
        "otro programa ha cambiado {file}, y se queda como está";
    /// How many notes were found in a file.
    notes_found: fn(usize, &str) -> String =
        |count, file| format!("{count} {} from {file}; M lists them", if count == 1 { "note" } else { "notes" }),
        |count, file| format!("{count} {} de {file}; M las enumera", if count == 1 { "nota" } else { "notas" });
    /// The log has changed since notes were kept: how many have their place in it still.
    notes_of_another(found: usize, count: usize, file: &str) =
        "the log has changed since the notes in {file}: {found} of {count} have a place in it; M lists them",
        "el registro ha cambiado desde las notas de {file}: {found} de {count} tienen lugar en él; M las enumera";
    /// There is no such bookmark.
    no_bookmark(letter: char) =
        "no bookmark {letter}; m{letter} sets it, M lists all",
        "no hay marcador {letter}; m{letter} lo pone, M los enumera";
    /// The log doesn't have its address.
    bookmark_elsewhere(letter: char, address: &str) =
        "bookmark {letter}: this log has no {address}",
        "marcador {letter}: este registro no tiene {address}";
    /// Nothing is searched for.
    no_search = "nothing is searched for; / searches", "no se busca nada; / busca";
    /// A text wasn't found.
    not_found(text: &str) = "not found: {text}", "no se encuentra: {text}";
    /// No row of the tree matches a text.
    no_row(text: &str) = "no row matches: {text}", "ninguna fila coincide: {text}";
    /// The search went on at the beginning.
    from_the_beginning = "from the beginning again", "otra vez desde el principio";
    /// It went on at the end.
    from_the_end = "from the end again", "otra vez desde el final";
    /// A text was pasted where no line is typed.
    pasted_nowhere =
        "text can only be pasted into a line that is being typed, such as after / or :",
        "solo se puede pegar texto en una línea que se está escribiendo, como tras / o :";
    /// The mouse belongs to the viewer.
    mouse_is_ours = "the mouse selects and scrolls; ^t gives it back", "el ratón selecciona y desplaza; ^t lo devuelve";
    /// It belongs to the terminal.
    mouse_is_the_terminals = "the mouse is the terminal's", "el ratón es del terminal";
    /// The book has one pixel.
    one_pixel_printed = "the book prints one pixel only", "el libro solo imprime un píxel";
    /// A region has too many values to be compared.
    regions_not_compared = "only pixels and rays are compared", "solo se comparan píxeles y rayos";
    /// No book has the pixel as its example.
    no_example =
        "no book has this pixel as its example; raywalk walk textbook shows the one that has",
        "ningún libro tiene este píxel como ejemplo; raywalk walk textbook muestra el que lo es";
    /// There are too many quantities to study the rounding of each.
    too_many_quantities(most: usize) =
        "it computes more than {most} quantities, too many to study the rounding of each",
        "calcula más de {most} magnitudes, demasiadas para estudiar el redondeo de cada una";
    /// The roundings of such an arithmetic can't be studied.
    rounds_nothing =
        "the roundings that can be studied are those of decimal:N and f32",
        "los redondeos que se pueden estudiar son los de decimal:N y f32";
    /// The roundings of each quantity are being studied.
    studying = "studying the rounding of every quantity …", "estudiando el redondeo de cada magnitud …";
    /// The log of a pixel would have more events than this.
    too_long(most: usize) = "the log would have more than {most} events", "el registro tendría más de {most} sucesos";
    /// There is no memory for it.
    no_memory = "not enough memory for the log", "no hay memoria para el registro";
    /// It is shown in this language now.
    language = "in English", "en español";
    /// The call that leads back to where the viewer was left.
    back_here(call: &str) = "back here: {call}", "para volver aquí: {call}";
    /// Warnings that stay until they are dismissed.
    warnings: Warnings;
}

texts! {
    /// What to warn of before one looks.
    Warnings;
    /// How a saved log ends, unless it is complete.
    ending: fn(&Ending) -> Option<String> =
        |ending| ending.warning(),
        |ending| match ending {
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
        };
    /// Adaptive sampling is biased with these effects.
    biased(effects: &str) =
        "adaptive sampling is biased with {effects}: cells whose corners agree by chance are not cut; expected \
                 another sampling, such as sobol:64",
        "el muestreo adaptativo tiene sesgo con {effects}: las celdas cuyas esquinas coinciden por azar no se \
                 dividen; se espera otro muestreo, como sobol:64";
}

texts! {
    /// What the quiz says.
    Quiz;
    /// It begins.
    begins =
        "quiz: n goes to the next value, = answers it, Q ends",
        "cuestionario: n va al siguiente valor, = lo responde, Q termina";
    /// It ends: how many values and decisions were right at once, right later, told, passed.
    ends([right, later, told, passed]: [u32; 4]) =
        "the quiz is over: {right} right at the first try, {later} later, {told} told, {passed} passed unanswered",
        "fin del cuestionario: {right} bien a la primera, {later} después, {told} dichos, {passed} pasados sin responder";
    /// There is none.
    none = "no quiz is on; Q begins one", "no hay cuestionario; Q empieza uno";
    /// The step has nothing to answer.
    nothing_hidden =
        "this step hides no result; n goes to the next",
        "este paso no oculta ningún resultado; n va al siguiente";
    /// A decision is asked for.
    what_is_decided =
        "what is decided? hit, miss, inside, background, an object's name, ...",
        "¿qué se decide? hit (interseca), miss (no), inside (dentro), background (fondo), un objeto, ...";
    /// The answer is right.
    right = "right", "correcto";
    /// The answer follows from the numbers as they are shown.
    right_as_shown(value: &str) =
        "right with the numbers as shown; the value is {value}",
        "correcto con los números tal como se ven; el valor es {value}";
    /// The value, and what follows from the numbers as they are shown.
    and_as_shown(value: &str, shown: &str) =
        "{value} ({shown} with the numbers as shown)",
        "{value} ({shown} con los números tal como se ven)";
    /// The value is off by so much.
    off(by: &str) = "off by {by}", "se desvía en {by}";
    /// The decision is another one.
    not_it = "it isn't", "no es eso";
    /// How it is wrong, and what would have been right.
    it_is(off: &str, truth: &str) = "{off}; it is {truth}", "{off}; es {truth}";
    /// How it is wrong, while it may be tried again.
    try_again(off: &str) = "{off}; try again", "{off}; inténtelo otra vez";
    /// The answer is no number.
    no_number = "that is no number: type it like 12.5", "eso no es un número: escríbalo como 12,5";
    /// It isn't three numbers.
    no_triple =
        "that is no triple: type three numbers, like (1, 2, 3) or 1 2 3",
        "eso no son tres números: escríbalos como (1; 2; 3) o 1 2 3";
    /// It is no decision.
    no_decision =
        "that is no decision: type it like hit, miss, nearest, background, or an object's name",
        "eso no es una decisión: escriba hit, miss, nearest, background o el nombre de un objeto";
    /// A list would tell the results.
    tells_results =
        "that would tell the results; Q ends the quiz",
        "eso diría los resultados; Q termina el cuestionario";
    /// A value would.
    tells_result =
        "that would tell the result; = answers, Q ends the quiz",
        "eso diría el resultado; = responde, Q termina el cuestionario";
    /// A name would.
    tells_decision =
        "that would tell the decision; = answers, Q ends the quiz",
        "eso diría la decisión; = responde, Q termina el cuestionario";
}
