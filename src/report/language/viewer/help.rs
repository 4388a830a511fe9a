//! The help: every key in words.

/// A table of texts that also has a table of the names of its rows.
macro_rules! named_texts {
    ($(#[$about:meta])* $table:ident; $($name:ident = $english:expr, $spanish:expr;)*) => {
        texts! { $(#[$about])* $table; $($name = $english, $spanish;)* }

        impl $table {
            /// The names of the texts instead of them.
            pub const NAMES: $table = $table { $($name: stringify!($name)),* };
        }
    };
}

texts! {
    /// The texts of the help.
    Help;
    /// Its title.
    title = "Keys", "Teclas";
    /// What keys do in it where all of it is seen.
    finds = "/ finds, Esc closes", "/ busca, Esc cierra";
    /// What they do where it scrolls.
    scrolls = "j k scroll, / finds, Esc closes", "j k desplazan, / busca, Esc cierra";
    /// What represents the letter of one's choice in `m+letter`.
    letter = "letter", "letra";
    /// What a number before a key does.
    counts = "A number before a key repeats it: 5j, 10n.", "Un número antes de una tecla la repite: 5j, 10n.";
    /// All commands, in a sentence.
    commands(list: &str) = "Commands: {list}.", "Órdenes: {list}.";
    /// How to change to another language; in that language, so that those who want it can read it.
    other_language = ":lang es: en español.", ":lang en: in English.";
    /// No key matches.
    nothing = "no key does that", "ninguna tecla hace eso";
    /// The headings.
    groups: Groups;
    /// The keys.
    keys: Keys;
}

texts! {
    /// The headings of the help, by what the keys under them are for.
    #[allow(missing_docs)]
    Groups;
    step = "Step through the computation", "Recorrer el cálculo paso a paso";
    tree = "Move in the tree", "Moverse por el árbol";
    fold = "Fold", "Plegar";
    picture = "In the picture and the schematic", "En la imagen y el esquema";
    understand = "Understand", "Comprender";
    viewer = "The viewer", "El visor";
    nesting = "Step into, over and out", "Entrar, saltar y salir";
    run = "Run and play", "Ejecutar y reproducir";
    find = "Find", "Buscar";
    keep = "Remember and copy", "Recordar y copiar";
    breakpoints =
        "In the lists of breakpoints, bookmarks and watches",
        "En las listas de puntos de interrupción, marcadores y vigilancias";
    own = "Your own keys", "Sus propias teclas";
}

named_texts! {
    /// What the keys do; the names are those of the actions.
    #[allow(missing_docs)]
    Keys;
    next_value = "to the next computed value", "al siguiente valor calculado";
    previous_value = "to the previous computed value", "al valor calculado anterior";
    next_event = "to the next event", "al siguiente suceso";
    previous_event = "to the previous event", "al suceso anterior";
    next_ray = "to the next ray", "al siguiente rayo";
    previous_ray = "to the previous ray", "al rayo anterior";
    down = "down", "abajo";
    up = "up", "arriba";
    out = "close the node, or go to the one around it", "cerrar el nodo, o ir al que lo contiene";
    r#in = "open the node, go into it, then to its computation", "abrir el nodo, entrar en él y después en su cálculo";
    enter = "the same; in the picture: to the tree of the pixel", "lo mismo; en la imagen: al árbol del píxel";
    next_sibling = "to the next node of the same parent", "al siguiente nodo del mismo padre";
    previous_sibling = "to the previous node of the same parent", "al nodo anterior del mismo padre";
    first = "to the first row", "a la primera fila";
    last = "to the last row; with a count, to that step", "a la última fila; con un número, a ese paso";
    half_page_down = "half a page down", "media página abajo";
    half_page_up = "half a page up", "media página arriba";
    page_down = "a page down", "una página abajo";
    page_up = "a page up", "una página arriba";
    center = "put the row into the middle", "poner la fila en el centro";
    toggle = "open or close the node", "abrir o cerrar el nodo";
    open_siblings = "open the node and its siblings", "abrir el nodo y sus hermanos";
    close_siblings = "close the node and its siblings", "cerrar el nodo y sus hermanos";
    open_all = "open everything inside the node", "abrir todo lo que hay dentro del nodo";
    close_all = "close everything inside the node", "cerrar todo lo que hay dentro del nodo";
    zoom_in = "larger", "más grande";
    zoom_out = "smaller", "más pequeño";
    brighter = "brighter by half a stop", "medio punto de exposición más";
    darker = "darker by half a stop", "medio punto de exposición menos";
    next_view =
        "another view: colours, depth, rays, samples; top, front, side, eye",
        "otra vista: colores, profundidad, rayos, muestras; desde arriba, de frente, de lado, desde el ojo";
    schematic =
        "what the schematic shows: this branch, all rays, the vectors at the hit",
        "qué muestra el esquema: esta rama, todos los rayos, los vectores en la intersección";
    shadow_rays = "shadow rays in the schematic, or not", "rayos de sombra en el esquema, o no";
    rays_over = "the rays over the picture, or not", "los rayos sobre la imagen, o no";
    cell_left =
        "H J K L: left, down, up, right by a cell of the screen; + and -: to the greatest and the least value, in colours the brightest and the darkest pixel",
        "H J K L: a la izquierda, abajo, arriba, a la derecha una celda de la pantalla; + y -: al valor mayor y al menor, en colores al píxel más claro y al más oscuro";
    worst = "list the pixels that single precision misses most", "lista de los píxeles en los que más falla la precisión simple";
    operands =
        "what this value is made of; Enter goes to an operand",
        "de qué se compone este valor; Enter va a un operando";
    uses = "which steps take this value", "qué pasos toman este valor";
    back =
        "back to before the last jump, then to before the one before it",
        "volver a antes del último salto, y luego a antes del anterior";
    contributions = "why the pixel has this colour", "por qué el píxel tiene este color";
    arithmetics =
        "the node's values by hand, in f32 and in f64, with the digits to trust",
        "los valores del nodo a mano, en f32 y en f64, con las cifras fiables";
    causes =
        "which rounding caused the error of the result",
        "qué redondeo causó el error del resultado";
    glossary = "what the symbols mean", "qué significan los símbolos";
    quiz =
        "begin or end a quiz, which hides results and decisions",
        "empezar o terminar un cuestionario, que oculta resultados y decisiones";
    answer =
        "answer in the quiz (Enter in the computation, too)",
        "responder en el cuestionario (también Enter en el cálculo)";
    switch_pane =
        "to the next pane; in the computation j and k move too",
        "al siguiente panel; en el cálculo también se mueven j y k";
    previous_pane = "to the pane before", "al panel anterior";
    only_pane = "only this pane, or all again", "solo este panel, o todos otra vez";
    wider = "a wider tree; in a list, on to the right", "un árbol más ancho; en una lista, hacia la derecha";
    narrower =
        "a narrower tree; in a list, back to the left",
        "un árbol más estrecho; en una lista, hacia la izquierda";
    help = "this help", "esta ayuda";
    close =
        "close what lies over the panes; else dismiss the message, stop playing, end the search, then the filter",
        "cerrar lo que tapa los paneles; si no, quitar el mensaje, parar la reproducción, terminar la búsqueda y después el filtro";
    quit = "quit (or close the help)", "salir (o cerrar la ayuda)";
    interrupt = "quit at once; close a line, a list or this help", "salir en el acto; cerrar una línea, una lista o esta ayuda";
    suspend = "to the shell; fg comes back", "al intérprete de órdenes; fg vuelve";
    step_into = "into: to the next event, wherever it is", "entrar: al siguiente suceso, esté donde esté";
    step_into_back = "into, backward", "entrar, hacia atrás";
    step_over =
        "over: to the next event of this node or one around it",
        "saltar: al siguiente suceso de este nodo o de uno que lo contiene";
    step_over_back = "over, backward", "saltar, hacia atrás";
    step_out =
        "out: past the end of this node, to one around it",
        "salir: más allá del final de este nodo, a uno que lo contiene";
    step_out_back = "out, backward: to before this node", "salir, hacia atrás: a antes de este nodo";
    first_step = "to the first step (42G goes to step 42)", "al primer paso (42G va al paso 42)";
    last_step = "to the last step", "al último paso";
    r#break =
        "type a breakpoint: hit, object NAME, depth 2, T2_A < 0",
        "escribir un punto de interrupción: hit, object NOMBRE, depth 2, T2_A < 0";
    toggle_break =
        "set or clear a breakpoint on what happens here",
        "poner o quitar un punto de interrupción en lo que ocurre aquí";
    breakpoints = "list the breakpoints", "lista de los puntos de interrupción";
    run = "run to the next breakpoint (c folds)", "ejecutar hasta el siguiente punto de interrupción (c pliega)";
    run_back = "run back to the previous breakpoint", "volver hasta el punto de interrupción anterior";
    stops = "list where the runs stopped", "lista de dónde se ha parado la ejecución";
    watch = "watch the quantity computed here, or no longer; :watch lists all", "vigilar la magnitud que se calcula aquí, o ya no; :watch las enumera";
    history = "all values of this quantity, in order", "todos los valores de esta magnitud, en orden";
    play = "play, value by value; again to stop", "reproducir, valor a valor; otra vez para parar";
    faster = "play twice as fast", "reproducir el doble de rápido";
    slower = "play half as fast", "reproducir la mitad de rápido";
    grow =
        "let the tree grow with the steps; again to see all of it",
        "que el árbol crezca con los pasos; otra vez para verlo entero";
    search =
        "search names, symbols, words and values; capitals count if there are any",
        "buscar nombres, símbolos, palabras y valores; las mayúsculas cuentan si las hay";
    next_match = "to the next match (n steps)", "a la siguiente coincidencia (n avanza un paso)";
    previous_match = "to the previous match", "a la coincidencia anterior";
    filter =
        "show only rows that match; nothing typed shows all",
        "mostrar solo las filas que coinciden; sin texto se muestran todas";
    tests =
        "hide the intersection tests, or show them again",
        "ocultar las pruebas de intersección, o mostrarlas otra vez";
    mark = "set a bookmark here", "poner un marcador aquí";
    go_to_mark = "go to a bookmark", "ir a un marcador";
    jump_back = "go back to before the last jump", "volver a antes del último salto";
    marks = "list the bookmarks", "lista de los marcadores";
    copy_value = "copy the value with all its digits", "copiar el valor con todas sus cifras";
    copy_path = "copy the address, such as C R S1 shade.n_dot_l", "copiar la dirección, como C R S1 shade.n_dot_l";
    command = "type a command; :help lists them", "escribir una orden; :help las enumera";
    edit = "open the scene in $EDITOR, at the object of this step", "abrir la escena en $EDITOR, en el objeto de este paso";
    mouse = "let the mouse select and scroll, or not", "que el ratón seleccione y desplace, o no";
    delete =
        "delete it; Space turns a breakpoint on or off, Enter goes to its next place",
        "lo borra; Space activa o desactiva un punto de interrupción, Enter va al siguiente lugar";
}
