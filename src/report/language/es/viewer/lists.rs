//! The lists in Spanish.

use crate::report::language::viewer::{Account, Arithmetics, Hints, List, Lists, ToCome};

pub(super) const LISTS: Lists = Lists {
    hints: Hints {
        usual: ["j k eligen, Enter va allí, Esc cierra", "Enter va, Esc cierra"],
        cut: ["j k eligen, < > desplazan, Enter va allí, Esc cierra", "< > desplazan, Enter va, Esc cierra"],
        cut_plain: "< > desplazan, Esc cierra",
        closes: "Esc cierra",
        breakpoints: [
            "Space activa o no, d borra, Enter al siguiente, Esc cierra",
            "Space activa, d borra, Enter sigue",
            "Space sí/no, d borra, Enter sigue",
            "Space sí/no, d borra",
        ],
    },
    breakpoints: List {
        title: "Puntos de interrupción",
        columns: ["estado", "se para en"],
        nothing: "ninguno: b escribe uno, x pone uno aquí",
    },
    on: "sí",
    off: "no",
    stops: List {
        title: "Dónde se ha parado la ejecución",
        columns: ["paso", "píxel", "parado por", "qué hay allí"],
        nothing: "en ningún sitio: r va a un punto de interrupción",
    },
    bookmarks: List {
        title: "Marcadores",
        columns: ["letra", "dirección", "qué hay allí"],
        nothing: "ninguno: m y una letra ponen uno",
    },
    in_pixel: |[x, y], what| format!("en {x},{y}: {what}"),
    not_in_this_log: "(no está en este registro)",
    operands: List {
        title: |value| format!("De qué se compone {value}"),
        columns: ["operando", "valor", "procedencia"],
        nothing: "este paso no toma nada que el registro nombre",
    },
    given_in: |place| format!("dato de {place}"),
    uses: List {
        title: |value| format!("Qué pasos toman {value}"),
        columns: ["valor", "se calcula en"],
        nothing: "ningún paso posterior lo toma",
    },
    step: |number| format!("paso {number}"),
    account: Account {
        list: List {
            title: |color| format!("Por qué el color es {color}"),
            columns: [
                "parte",
                "camino",
                "veces",
                "procedencia",
                "clase",
                "figura 14",
                "% de r g b",
                "aporta",
                "= color propio * peso",
            ],
            nothing: "todavía no se conoce ninguna contribución",
        },
        so_far: |color| format!("El registro termina antes del color; hasta aquí {color}"),
        here: |class| format!(" - aquí {class}"),
        cases: |cases| match cases {
            "direct" => "directa",
            "for a" => "por a",
            _ => cases,
        },
        smaller: |count| format!("otras {count} menores en total"),
        brings_nothing: |count| format!("Lo que no aporta nada ({count}):"),
    },
    arithmetics: Arithmetics {
        list: List {
            title: |node| format!("{node} en tres aritméticas"),
            columns: ["", "a mano", "f32", "cifras", "f64"],
            nothing: "este nodo no calcula nada por sí mismo",
        },
        not_reached: "no se alcanza",
        decided_otherwise: "0: se decide otra cosa",
        names: ["a mano", "en f32", "en f64"],
        never_reached: |arithmetic| format!("{arithmetic} no se llega aquí: antes se decide otra cosa"),
        other_decisions: |arithmetic| format!("{arithmetic} se decide otra cosa en este nodo"),
    },
    to_come: ToCome {
        color: "el color no se ha calculado aún; t muestra el árbol entero",
        node: "este nodo no se ha calculado aún hasta el final; t muestra el árbol entero",
        uses: "lo que toma un valor viene después; t muestra el árbol entero",
    },
};
