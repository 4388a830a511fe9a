//! The lists that lie over the panes: their titles, their columns, and what keys do in them.

use crate::report::language::Text;

texts! {
    /// The texts of lists.
    Lists;
    /// What keys do in them.
    hints: Hints;
    /// Where runs stop.
    breakpoints_title = "Breakpoints", "Puntos de interrupción";
    /// Its columns, and what is said where it has no entries.
    breakpoints: List<4> =
        list(["state", "hits", "places", "stops at"], "none: b types one, x sets one here"),
        list(["estado", "paradas", "lugares", "se para en"], "ninguno: b escribe uno, x pone uno aquí");
    /// A breakpoint that is on.
    on = "on", "sí";
    /// One that is off.
    off = "off", "no";
    /// Where they stopped.
    stops_title = "Where runs stopped", "Dónde se ha parado la ejecución";
    /// Its columns, and what is said where it has no entries.
    stops: List<4> =
        list(["step", "pixel", "stopped at", "what is there"], "nowhere yet: r runs to a breakpoint"),
        list(["paso", "píxel", "parado por", "qué hay allí"], "en ningún sitio: r va a un punto de interrupción");
    /// The quantities that are watched.
    watches_title = "Watched values", "Valores vigilados";
    /// Its columns, and what is said where it has no entries.
    watches: List<5> =
        list(["step", "value", "path", "node", ""], "none: * watches the quantity here, :watch KEY any"),
        list(["paso", "valor", "camino", "nodo", ""], "ninguno: * vigila la magnitud de aquí, :watch CLAVE cualquiera");
    /// All values of a quantity.
    history_title(name: &str) = "All values of {name}", "Todos los valores de {name}";
    /// Its columns, and what is said where it has no entries.
    history: List<5> =
        list(["step", "value", "path", "node", ""], "no value"),
        list(["paso", "valor", "camino", "nodo", ""], "ningún valor");
    /// The bookmarks.
    bookmarks_title = "Bookmarks", "Marcadores";
    /// Its columns, and what is said where it has no entries.
    bookmarks: List<4> =
        list(["key", "address", "what is there", "note"], "none: m and a letter set one"),
        list(["letra", "dirección", "qué hay allí", "nota"], "ninguno: m y una letra ponen uno");
    /// A bookmark in a pixel of a region, and what is there.
    in_pixel([x, y]: [u32; 2], what: &str) = "in {x},{y}: {what}", "en {x},{y}: {what}";
    /// A bookmark that leads nowhere.
    not_in_this_log = "(not in this log)", "(no está en este registro)";
    /// What a value is made of.
    operands_title(value: &str) = "What {value} is made of", "De qué se compone {value}";
    /// Its columns, and what is said where it has no entries.
    operands: List<3> =
        list(["operand", "value", "from"], "this step takes nothing that the log names"),
        list(["operando", "valor", "procedencia"], "este paso no toma nada que el registro nombre");
    /// An input of a node.
    given_in(place: &str) = "given in {place}", "dato de {place}";
    /// What takes a value.
    uses_title(value: &str) = "What takes {value}", "Qué pasos toman {value}";
    /// Its columns, and what is said where it has no entries.
    uses: List<2> =
        list(["value", "computed in"], "no later step takes it"),
        list(["valor", "se calcula en"], "ningún paso posterior lo toma");
    /// A step by its number.
    step(number: usize) = "step {number}", "paso {number}";
    /// Why a pixel has its colour.
    account: Account;
    /// The values of a node in several arithmetics.
    arithmetics: Arithmetics;
    /// Which rounding caused the error, in this arithmetic. Its columns are those of the study.
    causes_title(arithmetic: &str) =
        "Which rounding caused the error, {arithmetic}",
        "Qué redondeo causó el error, {arithmetic}";
    /// The worked example on paper.
    book: Book;
    /// The pixels that single precision misses most.
    worst_title = "Pixels by the error of f32", "Píxeles por el error de f32";
    /// Its columns, and what is said where it has no entries.
    worst: List<3> =
        list(["error", "pixel", "colour"], "no pixel is known to be off"),
        list(["error", "píxel", "color"], "no se conoce ningún píxel con error");
    /// What the symbols mean.
    glossary: Glossary;
    /// Why a list can't be shown yet.
    to_come: ToCome;
}

/// The texts of a list with this many columns.
pub struct List<const COLUMNS: usize> {
    /// What is in its columns.
    pub columns: [&'static str; COLUMNS],
    /// What is said where it has no entries.
    pub nothing: &'static str,
}

const fn list<const COLUMNS: usize>(columns: [&'static str; COLUMNS], nothing: &'static str) -> List<COLUMNS> {
    List { columns, nothing }
}

texts! {
    /// What keys do in lists, from the longest way to say it to the shortest.
    Hints;
    /// In a list of places.
    usual: [Text; 2] =
        ["j k select, Enter goes there, Esc closes", "Enter goes, Esc closes"],
        ["j k eligen, Enter va allí, Esc cierra", "Enter va, Esc cierra"];
    /// And where lines are cut.
    cut: [Text; 2] =
        ["j k select, < > scroll, Enter goes there, Esc closes", "< > scroll, Enter goes, Esc closes"],
        ["j k eligen, < > desplazan, Enter va allí, Esc cierra", "< > desplazan, Enter va, Esc cierra"];
    /// Where besides no line leads anywhere.
    cut_plain = "< > scroll, Esc closes", "< > desplazan, Esc cierra";
    /// Where nothing else fits.
    closes = "Esc closes", "Esc cierra";
    /// In that of bookmarks.
    bookmarks: [Text; 2] =
        ["< > scroll, Enter goes there, d deletes, Esc closes", "Enter goes, d deletes, Esc closes"],
        ["< > desplazan, Enter va allí, d borra, Esc cierra", "Enter va, d borra, Esc cierra"];
    /// In that of what is watched.
    watches: [Text; 3] =
        ["d unwatches, Enter goes there or lists all values, Esc closes", "d unwatches, Enter goes, Esc closes", "d unwatches, Enter goes"],
        ["d deja de vigilar, Enter va allí o enumera los valores, Esc cierra", "d lo quita, Enter va, Esc cierra", "d lo quita, Enter va"];
    /// In that of breakpoints.
    breakpoints: [Text; 4] =
        [
            "Space on/off, d deletes, Enter next place, Esc closes",
            "Space on/off, d deletes, Enter next",
            "Space on/off, d del, Enter next",
            "Space on/off, d deletes",
        ],
        [
            "Space activa o no, d borra, Enter al siguiente, Esc cierra",
            "Space activa, d borra, Enter sigue",
            "Space sí/no, d borra, Enter sigue",
            "Space sí/no, d borra",
        ];
}

texts! {
    /// The texts of why a pixel has its colour.
    Account;
    /// Its title with the colour, its columns.
    title(color: &str) = "Why the colour is {color}", "Por qué el color es {color}";
    /// Its columns, and what is said where it has no entries.
    list: List<9> =
        list(
            ["share", "path", "times", "from", "class", "figure 14", "% of r g b", "contributes", "= own colour * weight"],
            "no light is accounted for yet",
        ),
        list(
            ["parte", "camino", "veces", "procedencia", "clase", "figura 14", "% de r g b", "aporta", "= color propio * peso"],
            "todavía no se conoce ninguna contribución",
        );
    /// Its title where the log ends before the colour.
    so_far(color: &str) =
        "The log ends before the colour; so far {color}",
        "El registro termina antes del color; hasta aquí {color}";
    /// Behind the title, the class of the path of the selected ray.
    here(class: &str) = " - here {class}", " - aquí {class}";
    /// The ways of figure 14 as [`cases`](crate::report::path_class::cases) has them, with its words in the language.
    cases: fn(&str) -> &str =
        |cases| cases,
        |cases| match cases {
            "direct" => "directa",
            "for a" => "por a",
            _ => cases,
        };
    /// Smaller contributions, this many, in one.
    smaller(count: usize) = "{count} smaller ones together", "otras {count} menores en total";
    /// What rounding the sums themselves adds, which is no path.
    rounding(color: &str) = "Rounding the sums adds {color}.", "El redondeo de las sumas añade {color}.";
    /// Where the errors of rounded values are, in the arithmetics that round.
    not_in_this_sum =
        "The errors of rounded values aren't in this sum; W lists them.",
        "Los errores de los valores redondeados no están en esta suma; W los enumera.";
    /// The headings of the totals: of each light, of each object, of each kind of ray that sees the object.
    totals: [Text; 3] =
        ["By light:", "By object:", "By the ray that sees the object:"],
        ["Por fuente de luz:", "Por objeto:", "Por el rayo que ve el objeto:"];
    /// The total of ambient light.
    ambient = "ambient light", "luz ambiente";
    /// The heading of the legend.
    legend_title = "Legend:", "Leyenda:";
    /// What is in the columns.
    legend: [Text; 4] =
        [
            "path: C from the eye, R reflected, T transmitted, S1 to the first light",
            "class: L light, D diffuse, S mirror/lens, E eye, A ambient, B background",
            "figure 14: a D-D, b S-D, c D-S, d S-S; ambient light is for a",
            "= own colour * weight: the product of W_l, W_r and W_t on the way",
        ],
        [
            "camino: C primario, R reflejado, T transmitido, S1 a la primera fuente",
            "clase: L fuente, D difusa, S especular, E ojo, A ambiente, B fondo",
            "figura 14: a D-D, b S-D, c D-S, d S-S; la luz ambiente es por a",
            "= color propio * peso: el producto de W_l, W_r y W_t en el camino",
        ];
    /// The heading of this many paths that bring nothing.
    brings_nothing(count: usize) = "What contributes nothing ({count}):", "Lo que no aporta nada ({count}):";
}

texts! {
    /// The texts of the values of a node in several arithmetics.
    Arithmetics;
    /// Its title with the node, its columns: by hand, f32, the digits, f64.
    title(node: &str) = "{node} in three arithmetics", "{node} en tres aritméticas";
    /// Its columns, and what is said where it has no entries.
    list: List<5> =
        list(["", "by hand", "f32", "digits", "f64"], "this node computes nothing itself"),
        list(["", "a mano", "f32", "cifras", "f64"], "este nodo no calcula nada por sí mismo");
    /// The colour of a pixel.
    color = "colour", "color";
    /// Shown in place of a value.
    not_reached = "not reached", "no se alcanza";
    /// Shown in place of the number of digits.
    decided_otherwise = "0: decided otherwise", "0: se decide otra cosa";
    /// The three arithmetics in a sentence.
    names: [Text; 3] = ["by hand", "in f32", "in f64"], ["a mano", "en f32", "en f64"];
    /// An arithmetic doesn't reach the node.
    never_reached(arithmetic: &str) =
        "not reached {arithmetic}: it decides otherwise before",
        "{arithmetic} no se llega aquí: antes se decide otra cosa";
    /// It decides otherwise in it.
    other_decisions(arithmetic: &str) =
        "other decisions {arithmetic} in this node",
        "{arithmetic} se decide otra cosa en este nodo";
}

texts! {
    /// The texts of a worked example on paper.
    Book;
    /// Its title with the scene.
    title(scene: &str) = "The example on paper: {scene}", "El ejemplo sobre papel: {scene}";
    /// Its columns, and what is said where it has no entries.
    list: List<7> =
        list(["step", "quantity", "printed", "verdict", "following it", "by hand", "exact"], "nothing is printed"),
        list(["paso", "magnitud", "impreso", "veredicto", "según él", "a mano", "exacto"], "no hay nada impreso");
    /// What is printed follows from what is printed before.
    agrees = "agrees", "coincide";
    /// It does, with other digits.
    format = "format", "formato";
    /// It doesn't.
    departs = "departs", "se aparta";
    /// Why the quantity that the example calls so departs.
    why: fn(&str, &str) -> String =
        |called, why| format!("{called} departs: {why}"),
        |called, why| match called {
            "P_1" => "P_1 se aparta: el libro imprime el punto exacto (4; 6; 8); sus R_d y t redondeados dan (4; 5,996; 8,002)".to_owned(),
            "H_1" => "H_1 se aparta: 0,637/1,548 = 0,41150 se redondea a 0,411; sin efecto, pues N_1 = (1; 0; 0)".to_owned(),
            "I_local-2 (red)" => "I_local-2 se aparta: impreso con dos decimales; 54 + 86,68 + 154·0,964324 = 289,186".to_owned(),
            _ => format!("{called} se aparta: {why}"),
        };
}

texts! {
    /// The texts of the glossary.
    Glossary;
    /// Its title.
    title = "What the symbols mean", "Qué significan los símbolos";
    /// Its columns, and what is said where it has no entries.
    list: List<2> =
        list(["symbol", "meaning, formula, section of the source text"], "no symbols here"),
        list(["símbolo", "significado, fórmula, sección del texto"], "aquí no hay símbolos");
    /// Its parts: the symbols of the node, of the rest of the log, and the signs.
    headings: [Text; 3] =
        ["Here:", "Elsewhere:", "Signs:"],
        ["Aquí:", "En otros sitios:", "Signos:"];
}

texts! {
    /// Why a list can't be shown yet while the tree grows.
    ToCome;
    /// The colour isn't known.
    color =
        "the colour isn't computed yet; t shows the whole tree",
        "el color no se ha calculado aún; t muestra el árbol entero";
    /// The node isn't complete.
    node =
        "this node isn't computed yet to its end; t shows the whole tree",
        "este nodo no se ha calculado aún hasta el final; t muestra el árbol entero";
    /// What takes a value comes after it.
    uses =
        "what takes a value comes after it; t shows the whole tree",
        "lo que toma un valor viene después; t muestra el árbol entero";
}
