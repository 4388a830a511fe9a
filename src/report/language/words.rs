//! Words that are put into other texts, each in English and in Spanish.

use super::{Language, Text};
use crate::log::{Acceptance, Miss, SkipReason, Term};

impl Language {
    /// Why a test finds no hit.
    pub(in crate::report) fn miss(self, why: Miss) -> Text {
        let both = match why {
            Miss::Parallel => ["the ray runs parallel to it", "el rayo es paralelo"],
            Miss::Behind => ["it lies behind the ray", "queda detrás del origen del rayo"],
            Miss::Beside => ["the ray passes beside it", "el rayo pasa de largo"],
            Miss::Beyond => ["it lies beyond the light", "queda más allá de la fuente"],
            Miss::FacesAway => ["it turns its back to the ray", "da la espalda al rayo"],
            Miss::BeginsThere => ["the ray begins on it", "el rayo empieza en él"],
        };
        both[self as usize]
    }

    /// What may be left out; in Spanish with its article.
    pub(in crate::report) fn term(self, what: Term) -> Text {
        let both = match what {
            Term::Reflected => ["reflected ray", "el rayo reflejado"],
            Term::Transmitted => ["transmitted ray", "el rayo transmitido"],
            Term::Shadow => ["shadow ray", "el rayo de sombra"],
            Term::Local => ["local model", "el modelo local"],
            Term::Specular => ["specular term", "la componente especular"],
        };
        both[self as usize]
    }

    /// Why it is left out.
    pub(in crate::report) fn skip_reason(self, why: SkipReason) -> Text {
        let both = match why {
            SkipReason::ZeroWeight => ["its weight is zero", "su peso es cero"],
            SkipReason::NoLocalTerm => ["no coefficient could use the light", "ningún coeficiente usaría la luz"],
            SkipReason::Blocked => ["already fully blocked", "ya está totalmente bloqueado"],
            SkipReason::Cutoff => ["its weight is below the cutoff", "su peso está por debajo del límite"],
            SkipReason::ZeroPath => [
                "the weights on its path leave nothing of any channel",
                "los pesos de su camino no dejan nada de ningún color",
            ],
            SkipReason::ZeroLocal => ["its weight is zero", "su peso es cero"],
            SkipReason::ZeroTerm => ["its coefficient is zero", "su coeficiente es cero"],
            SkipReason::Behind => ["the light is behind the surface", "la fuente está detrás de la superficie"],
            SkipReason::ZeroLight => [
                "the light's colour and the coefficients leave nothing of any channel",
                "el color de la fuente y los coeficientes no dejan nada de ningún color",
            ],
            SkipReason::ZeroPathLocal => [
                "its weight and those on its path leave nothing of any channel",
                "su peso y los de su camino no dejan nada de ningún color",
            ],
            SkipReason::ZeroPathLight => [
                "the weights on its path, the light's colour and the coefficients leave nothing of any channel",
                "los pesos de su camino, el color de la fuente y los coeficientes no dejan nada de ningún color",
            ],
        };
        both[self as usize]
    }

    /// Why samples are enough.
    pub(in crate::report) fn acceptance(self, why: Acceptance) -> Text {
        let both = match why {
            Acceptance::Alike => ["the samples agree", "las muestras coinciden"],
            Acceptance::Depth => ["it may not be cut further", "no se puede dividir más"],
            Acceptance::Interval => ["its interval is narrow enough", "su intervalo es bastante estrecho"],
            Acceptance::Max => ["there may be no more samples", "no puede haber más muestras"],
            Acceptance::Guided => [
                "its samples are as many as the first samples of the pixels around it ask for",
                "sus muestras son tantas como piden las primeras muestras de los píxeles de alrededor",
            ],
        };
        both[self as usize]
    }

    /// How many more there are, behind a list of some.
    pub(super) fn and_more(self, count: usize) -> String {
        match self {
            _ if count == 0 => String::new(),
            Language::English => format!(" and {count} more"),
            Language::Spanish => format!(" y {count} más"),
        }
    }
}
