//! What is said of commands that are typed behind `:`.

texts! {
    /// What is said of commands.
    Commands;
    /// What represents the letter that a command takes.
    letter = "LETTER", "LETRA";
    /// What represents a letter and perhaps a text.
    letter_and_note = "LETTER [NOTE]", "LETRA [NOTA]";
    /// What represents the condition.
    condition = "CONDITION", "CONDICIÓN";
    /// What represents the text.
    text = "TEXT", "TEXTO";
    /// That a number is one, too.
    step = ":42 (a step)", ":42 (un paso)";
    /// A command takes nothing.
    nothing_behind(command: &str) = "nothing may follow :{command}", "detrás de :{command} no va nada";
    /// No command is called so, but so.
    like(text: &str, near: &str) =
        "no command :{text}; did you mean :{near}?",
        "no hay orden :{text}; ¿quiso decir :{near}?";
    /// No command is called so.
    unknown(word: &str) =
        "no command :{word}; Tab completes commands, ? lists them",
        "no hay orden :{word}; Tab las completa, ? las enumera";
    /// A beginning that several have.
    may_be(text: &str, commands: &str) = ":{text} may be {commands}", ":{text} puede ser {commands}";
    /// How many steps there are.
    steps(count: usize) = "there are steps 1 to {count}", "hay pasos del 1 al {count}";
    /// What represents a path and its value.
    path_and_value = "PATH VALUE", "RUTA VALOR";
    /// What represents what a picture may show.
    plane = "KEY@PATH|light:NAME|class:LDE", "CLAVE@RUTA|light:NOMBRE|class:LDE";
    /// There is no such quantity; what may have been meant.
    no_quantity: fn(&str, &str) -> String =
        |key, near| match near {
            "" => format!("no quantity `{key}`; Tab lists them: :picture shade.n_dot_l@C R"),
            near => format!("no quantity `{key}`; did you mean `{near}`?"),
        },
        |key, near| match near {
            "" => format!("no hay magnitud `{key}`; Tab las enumera: :picture shade.n_dot_l@C R"),
            near => format!("no hay magnitud `{key}`; ¿quiso decir `{near}`?"),
        };
    /// A number has no components.
    no_components(key: &str) = "{key} is a number, it has no components", "{key} es un número, no tiene componentes";
    /// What is no path of rays.
    no_ray_path(path: &str) =
        "`{path}` is no path: C, then R or T for each bounce, at last S and the number of a light, such as C R S1",
        "`{path}` no es un camino: C, luego R o T por cada rebote, al final S y el número de una luz, como C R S1";
    /// What is no class of paths.
    no_class(class: &str) =
        "`{class}` is no class of paths, such as LDSE, L(D|S)E, LDS*E, AE or BSE",
        "`{class}` no es una clase de caminos, como LDSE, L(D|S)E, LDS*E, AE o BSE";
    /// No light was named.
    expected_light = "expected the name of a light: :picture light:NAME", "se espera el nombre de una luz: :picture light:NOMBRE";
    /// What represents a file.
    file = "FILE", "ARCHIVO";
    /// What represents a number.
    number = "N", "N";
    /// What represents a name.
    name = "NAME", "NOMBRE";
    /// What represents an expression.
    expression = "EXPRESSION", "EXPRESIÓN";
    /// What represents a quantity, which may be left out.
    quantity = "[KEY]", "[CLAVE]";
    /// What represents a quantity.
    key = "KEY", "CLAVE";
    /// Nothing follows a command that needs something.
    expected_more(command: &str, what: &str) = "expected :{command} {what}", "se espera :{command} {what}";
    /// What follows `bookmark`.
    expected_letter = "expected one letter, and perhaps a note: :bookmark a too dark here", "se espera una letra, y quizá una nota: :bookmark a aquí falta luz";
    /// What follows `pixel`.
    expected_pixel =
        "expected a column and a row, such as :pixel 160,120",
        "se esperan una columna y una fila, como :pixel 160,120";
    /// What follows `digits`.
    expected_decimals(most: u32) =
        "expected the decimals of numbers, 0 to {most}: :digits 6",
        "se esperan los decimales de los números, de 0 a {most}: :digits 6";
    /// Numbers have so many decimals now.
    decimals: fn(u32) -> String =
        |count| if count == 1 { "1 decimal".to_owned() } else { format!("{count} decimals") },
        |count| if count == 1 { "1 decimal".to_owned() } else { format!("{count} decimales") };
    /// What represents what the schematic shows, or the side from which it is seen.
    what_or_side = "WHAT|SIDE", "QUÉ|LADO";
    /// What follows `schematic`.
    unknown_schematic: fn(&str, Option<&str>, &str) -> String =
        |word, near, words| match near {
            Some(near) => format!("no schematic {word}; did you mean {near}? There are {words}"),
            None => format!("no schematic {word}; there are {words}"),
        },
        |word, near, words| match near {
            Some(near) => format!("no hay esquema {word}; ¿quiso decir {near}? Hay {words}"),
            None => format!("no hay esquema {word}; hay {words}"),
        };
    /// What follows `lang`.
    expected_language = "expected a language: :lang en or :lang es", "se espera un idioma: :lang en o :lang es";
    /// The first and last columns and rows of the log.
    log_has([left, top, right, bottom]: [u32; 4]) =
        "the log has columns {left} to {right} and rows {top} to {bottom}",
        "el registro tiene las columnas {left} a {right} y las filas {top} a {bottom}";
    /// The last column and row of the picture.
    picture_has([column, row]: [u32; 2]) =
        "the picture has columns 0 to {column} and rows 0 to {row}",
        "la imagen tiene las columnas 0 a {column} y las filas 0 a {row}";
}
