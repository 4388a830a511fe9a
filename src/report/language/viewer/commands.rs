//! What is said of commands that are typed behind `:`.

texts! {
    /// What is said of commands.
    Commands;
    /// What represents the letter that a command takes.
    letter = "LETTER", "LETRA";
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
    /// All commands.
    expected(commands: &str) = "expected a step or a command: {commands}", "se espera un paso o una orden: {commands}";
    /// A beginning that several have.
    may_be(text: &str, commands: &str) = ":{text} may be {commands}", ":{text} puede ser {commands}";
    /// How many steps there are.
    steps(count: usize) = "there are steps 1 to {count}", "hay pasos del 1 al {count}";
    /// What represents a path and its value.
    path_and_value = "PATH VALUE", "RUTA VALOR";
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
    expected_letter = "expected one letter, such as :bookmark a", "se espera una letra, como :bookmark a";
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
