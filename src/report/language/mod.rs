//! Every text that people read in a view of a log, each in both languages side by side: one that a language lacks doesn't compile.
//!
//! Names of a scene go into the texts as they are; whoever writes a format escapes the whole text. Spanish is that of the source
//! text (Ramos, "Trazado de rayos"), with its terms and its decimal commas.

/// Declares a table of texts and its two forms, English and Spanish. A row is a text, a text in which its parameters are put
/// (`ray(path: &str) = "ray {path}", "rayo {path}"`), a value of another type, or, without texts, a table of its own.
macro_rules! texts {
    ($(#[$about:meta])* $table:ident; $(
        $(#[$doc:meta])* $name:ident $(($($put_in:tt: $of:ty),*))? $(: $kind:ty)? $(= $english:expr, $spanish:expr)?;
    )*) => {
        $(#[$about])*
        pub struct $table {
            $($(#[$doc])* pub $name: kind_of!($(($($of),*))? $($kind)?),)*
        }

        impl $table {
            pub(in crate::report::language) const ENGLISH: $table =
                $table { $($name: in_language!(ENGLISH $(, ($($put_in: $of),*))? $(, $kind)? $(= $english)?),)* };
            pub(in crate::report::language) const SPANISH: $table =
                $table { $($name: in_language!(SPANISH $(, ($($put_in: $of),*))? $(, $kind)? $(= $spanish)?),)* };
        }
    };
}

/// The type of a row.
macro_rules! kind_of {
    () => { &'static str };
    (($($of:ty),*)) => { fn($($of),*) -> String };
    ($kind:ty) => { $kind };
}

/// What a row is in a language.
macro_rules! in_language {
    ($language:ident = $text:expr) => { $text };
    ($language:ident, ($($put_in:tt: $of:ty),*) = $text:expr) => { |$($put_in: $of),*| format!($text) };
    ($language:ident, $kind:ty = $value:expr) => { $value };
    ($language:ident, $table:ty) => { <$table>::$language };
}

pub(crate) mod close_up;
mod solution;
mod texts;
pub mod viewer;
mod words;

pub use solution::{Causes, Figure, Solution};
pub use texts::Texts;

use super::{Style, number};
use crate::log::{Parameter, Value};

/// The language of a view.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Language {
    /// English.
    #[default]
    English,
    /// Spanish.
    Spanish,
}

impl Language {
    /// Every language.
    pub const ALL: [Language; 2] = [Language::English, Language::Spanish];

    /// Its texts.
    pub fn texts(self) -> &'static Texts {
        match self {
            Language::English => &Texts::ENGLISH,
            Language::Spanish => &Texts::SPANISH,
        }
    }

    /// Its code, such as `en`.
    pub fn code(self) -> &'static str {
        match self {
            Language::English => "en",
            Language::Spanish => "es",
        }
    }

    /// A number as [`number::number`] writes it, with the language's decimal mark.
    pub fn number(self, x: f64, style: Style) -> String {
        self.marked(number::number(x, style))
    }

    /// A number or triple. Where the decimal mark is a comma, semicolons part the three: `(−0,946; 0,315; 0,079)`.
    pub fn value(self, value: &Value, style: Style) -> String {
        match value {
            Value::Number(x) => self.number(*x, style),
            Value::Triple(xyz) => format!("({})", xyz.map(|x| self.number(x, style)).join(self.texts().separator)),
        }
    }

    /// A parameter of sampling, as exactly as the scene states it.
    pub fn parameter(self, parameter: Parameter) -> String {
        self.marked(parameter.to_string())
    }

    /// A part of a whole, such as `12.5 %`.
    pub fn percent(self, share: f64) -> String {
        self.marked(format!("{:.1} %", 100.0 * share + 0.0))
    }

    /// A number or triple as a text in English prints it, such as `(4, 6, 8)`.
    pub fn paper(self, text: &str) -> String {
        self.marked(text.replace(", ", self.texts().separator))
    }

    /// Whether its decimal mark is a comma.
    pub fn has_decimal_comma(self) -> bool {
        self.texts().decimal_mark == ','
    }

    /// A number that is written already, with the language's decimal mark.
    pub fn marked(self, text: String) -> String {
        if self.texts().decimal_mark == '.' { text } else { text.replace('.', &self.texts().decimal_mark.to_string()) }
    }
}

/// A text without anything put in.
type Text = &'static str;
