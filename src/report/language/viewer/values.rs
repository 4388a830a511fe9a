//! What is said of values: those that are watched, and those of expressions.

texts! {
    /// What is said of quantities that are watched.
    Watch;
    /// The title of what is watched, below the computation.
    title = "watched", "vigilado";
    /// One was pinned; how many values of it the log has, if that may be told.
    pinned: fn(&str, Option<usize>) -> String =
        |key, count| match count {
            Some(0) => format!("watching {key}, which this log doesn't have; :watch lists all"),
            Some(1) => format!("watching {key}: 1 value; :watch lists all"),
            Some(count) => format!("watching {key}: {count} values; :watch lists all"),
            None => format!("watching {key}; :watch lists all"),
        },
        |key, count| match count {
            Some(0) => format!("se vigila {key}, que no está en este registro; :watch los enumera"),
            Some(1) => format!("se vigila {key}: 1 valor; :watch los enumera"),
            Some(count) => format!("se vigila {key}: {count} valores; :watch los enumera"),
            None => format!("se vigila {key}; :watch los enumera"),
        };
    /// One is no longer pinned.
    unpinned(key: &str) = "no longer watching {key}", "ya no se vigila {key}";
    /// What was typed isn't pinned, but these.
    not_pinned: fn(&str, &str) -> String =
        |text, keys| match keys {
            "" => format!("`{text}` isn't watched; nothing is"),
            keys => format!("`{text}` isn't watched, but {keys}"),
        },
        |text, keys| match keys {
            "" => format!("`{text}` no se vigila; no se vigila nada"),
            keys => format!("`{text}` no se vigila, sino {keys}"),
        };
    /// The step computes no quantity.
    nothing_here =
        "this step computes no quantity; n goes to one, :watch KEY watches any",
        "este paso no calcula ninguna magnitud; n va a una, :watch CLAVE vigila cualquiera";
    /// So that it has no history either.
    no_history =
        "this step computes no quantity; n goes to one, :history KEY shows any",
        "este paso no calcula ninguna magnitud; n va a una, :history CLAVE muestra cualquiera";
    /// Nothing is called so, but so.
    name_like(text: &str, near: &str) =
        "no quantity is called `{text}`; did you mean `{near}`?",
        "ninguna magnitud se llama `{text}`; ¿quiso decir `{near}`?";
    /// Nothing is called so.
    no_name(text: &str) =
        "no quantity is called `{text}`: expected a key such as shade.n_dot_l (Tab completes it) or a symbol such as N·L",
        "ninguna magnitud se llama `{text}`: se espera una clave como shade.n_dot_l (Tab la completa) o un símbolo como N·L";
    /// A symbol that several quantities have.
    may_be(text: &str, keys: &str) = "`{text}` may be {keys}", "`{text}` puede ser {keys}";
    /// It has no value at the current step.
    not_here(name: &str) = "{name}: no value here", "{name}: sin valor aquí";
    /// How many values there are.
    values: fn(usize) -> String =
        |count| if count == 1 { "1 value".to_owned() } else { format!("{count} values") },
        |count| if count == 1 { "1 valor".to_owned() } else { format!("{count} valores") };
    /// From the least to the greatest.
    from_to(least: &str, greatest: &str) = "{least} to {greatest}", "de {least} a {greatest}";
    /// So many aren't listed, before or after those that are.
    more: fn(usize, bool) -> String =
        |count, is_before| format!("... {count} {}", if is_before { "earlier" } else { "later" }),
        |count, is_before| format!("... {count} {}", if is_before { "anteriores" } else { "posteriores" });
    /// It is an input.
    given = "given", "dato";
    /// More is watched than there is room for.
    others(count: usize) = "{count} more: :watch", "{count} más: :watch";
}

texts! {
    /// What is said of expressions that are evaluated.
    Eval;
    /// A mistake with its column, from 1.
    at(column: usize, what: &str) = "column {column}: {what}", "columna {column}: {what}";
    /// An operand is missing.
    expected_operand(found: &str) =
        "expected a number, a name such as N·L or shade.n_dot_l, or a function such as dot(N, L){found}",
        "se espera un número, un nombre como N·L o shade.n_dot_l, o una función como dot(N; L){found}";
    /// A sign is missing.
    expected_sign(sign: &str, found: &str) = "expected `{sign}`{found}", "se espera `{sign}`{found}";
    /// Something goes on without an operator.
    expected_end(found: &str) = "expected an operator (+ - * / ^) or the end{found}", "se espera un operador (+ - * / ^) o el final{found}";
    /// It is too long.
    too_long = "too many operations in one expression", "demasiadas operaciones en una expresión";
    /// What is there instead.
    found(text: &str) = ", found `{text}`", ", no `{text}`";
    /// Nothing is called so, but so.
    name_like(text: &str, near: &str) =
        "nothing is called `{text}`; did you mean `{near}`?",
        "nada se llama `{text}`; ¿quiso decir `{near}`?";
    /// Nothing is called so; what is known here.
    no_name: fn(&str, &str) -> String =
        |text, known| match known {
            "" => format!("nothing is called `{text}`, and no value is known here"),
            known => format!("nothing is called `{text}`; known here: {known}"),
        },
        |text, known| match known {
            "" => format!("nada se llama `{text}`, y aquí no se conoce ningún valor"),
            known => format!("nada se llama `{text}`; aquí se conocen {known}"),
        };
    /// A quantity has no value here; what is known instead.
    not_known: fn(&str, &str) -> String =
        |name, known| match known {
            "" => format!("{name} has no value here, nor has anything else"),
            known => format!("{name} has no value here; known are {known}"),
        },
        |name, known| match known {
            "" => format!("{name} no tiene valor aquí, ni lo tiene nada"),
            known => format!("{name} no tiene valor aquí; se conocen {known}"),
        };
    /// A quantity has no value yet: the node computes it at this step.
    not_yet(name: &str, step: usize) =
        "{name} has no value before step {step}; :{step} goes there",
        "{name} no tiene valor antes del paso {step}; :{step} va allí";
    /// In a quiz names would tell the results.
    only_numbers =
        "in a quiz with numbers only: names would tell the results; Q ends the quiz",
        "en un cuestionario solo con números: los nombres dirían los resultados; Q termina el cuestionario";
    /// An operation can't be done with such operands.
    impossible(operation: &str) =
        "can't compute {operation}: one of the operands is a triple where a number is needed, or a number where a triple is",
        "no se puede calcular {operation}: un operando es una terna donde hace falta un número, o un número donde hace falta una terna";
}
