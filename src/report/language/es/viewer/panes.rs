//! The panes and the bottom line in Spanish.

use crate::report::language::viewer::{Outcomes, Panes, Picture, Schematic, Status};

pub(super) const STATUS: Status = Status {
    step: |step, count| format!("paso {step}/{count}"),
    section: |section| format!("sección {section}"),
    hints: ["n siguiente valor  p anterior  ? ayuda  q salir", "n siguiente  ? ayuda  q salir", "? ayuda"],
    all_hints: |moves| format!("n siguiente valor  p anterior  {moves}  ? ayuda  q salir"),
    moves: ["j k mueven  Space pliega", "j k mueven  Tab árbol"],
    playing: |rate| format!("reproduce {rate}/s"),
    growing: "crece",
    filtered: "filtrado",
    mouse: "ratón",
    counting: "contando coincidencias",
    matches: |number, count| format!("coincidencia {number}/{count}"),
    quiz: |right, asked| format!("cuestionario {right} de {asked}"),
    filter: "filtro: ",
    break_at: "parar en: ",
    keys_with: "teclas con: ",
    answer: "su respuesta: ",
    warning: "aviso: ",
    too_small: ["pequeño:", "mínimo 20x6", "(q sale)"],
};

pub(super) const PANES: Panes = Panes {
    algorithm: |name| format!("algoritmo {name}"),
    calls: "llamadas",
    shadow_ray: |path| format!("rayo de sombra {path}"),
    end: "fin",
    end_of: |node| format!("fin de: {node}"),
    hidden_decision: "¿decisión?",
    hidden_result: "¿resultado?",
    not_computed: "no calculado aún",
    result: |color| format!("resultado {color}"),
    ray: |kind| format!("rayo {kind}"),
    hidden_rays: |count| if count == 1 { "1 rayo".to_owned() } else { format!("{count} rayos") },
    outcomes: Outcomes {
        lit: "llega la luz",
        hit: "interseca",
        miss: "no interseca",
        background: "fondo",
        blocked_by: |object| format!("bloqueado por {object}"),
        rejected: "rechazado",
        weakened_by: |object| format!("atenuado por {object}"),
        depth_limit: "profundidad máxima",
        total_reflection: "reflexión total",
    },
    samples: |count| match count {
        1 => "1 muestra en el píxel".to_owned(),
        _ => format!("{count} muestras en el píxel"),
    },
    picture: Picture {
        layers: ["imagen", "profundidad", "rayos por píxel", "muestras por píxel", "error de f32"],
        exposure: |stops| format!("exposición {stops}"),
        depth: |depth| format!("profundidad {depth}"),
        rays: |count| format!("rayos {count}"),
        levels: |[r, g, b]| format!("8 bits {r} {g} {b}"),
        ends: "la imagen termina aquí",
    },
    schematic: Schematic {
        views: ["esquema desde arriba", "esquema de frente", "esquema desde el ojo"],
        turns: "v gira",
        no_rays: "el registro no tiene rayos aquí",
        too_far: "los rayos llegan demasiado lejos para dibujarlos",
    },
};
