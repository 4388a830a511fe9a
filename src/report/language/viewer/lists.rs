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
    breakpoints: List<2> =
        list(["state", "stops at"], "none: b types one, x sets one here"),
        list(["estado", "se para en"], "ninguno: b escribe uno, x pone uno aquí");
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
    /// The bookmarks.
    bookmarks_title = "Bookmarks", "Marcadores";
    /// Its columns, and what is said where it has no entries.
    bookmarks: List<3> =
        list(["key", "address", "what is there"], "none: m and a letter set one"),
        list(["letra", "dirección", "qué hay allí"], "ninguno: m y una letra ponen uno");
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
