//! `--sampling SPEC`: a method of sampling in one word, `sobol:64` or `adaptive:threshold=0.1,depth=3`.

use super::unknown::unknown;
use raywalk::scene::file::schema::Sampling;
use raywalk::scene::file::validate;

/// How the methods are written.
const FORMS: &[(&str, &str)] = &[
    ("none", "none"),
    ("regular", "regular:N"),
    ("shared", "shared:N"),
    ("adaptive", "adaptive:threshold=T,depth=D"),
    ("stochastic", "stochastic:N"),
    ("random", "random:N"),
    ("sobol", "sobol:N"),
    ("statistical", "statistical:confidence=C,tolerance=T,min=M,max=N"),
    ("guided", "guided:tolerance=T,min=M,max=N"),
];

/// Reads a method; the error says what was expected.
pub fn sampling(text: &str) -> Result<Sampling, String> {
    sampling_or(&[], text)
}

/// The same where other words are allowed instead, which the caller reads and the error names, too.
pub fn sampling_or(others: &[&str], text: &str) -> Result<Sampling, String> {
    let (method, parameters) = text.split_once(':').map_or((text, None), |(method, rest)| (method, Some(rest)));
    let Some((_, form)) = FORMS.iter().find(|(word, _)| *word == method) else {
        let methods: Vec<_> = others.iter().copied().chain(FORMS.iter().map(|(word, _)| *word)).collect();
        return Err(unknown("sampling", method, &methods));
    };
    let parameters = Parameters { form, text: parameters };
    let sampling = match method {
        "none" => parameters.none().map(|()| Sampling::None {})?,
        "regular" => Sampling::Regular { n: parameters.count()? },
        "shared" => Sampling::Shared { n: parameters.count()? },
        "stochastic" => Sampling::Stochastic { n: parameters.count()? },
        "random" => Sampling::Random { n: parameters.count()? },
        "sobol" => Sampling::Sobol { n: parameters.count()? },
        "adaptive" => {
            let [threshold, depth] = parameters.named(["threshold", "depth"])?;
            Sampling::Adaptive { threshold: number("threshold", threshold)?, depth: whole("depth", depth)? }
        }
        "guided" => {
            let [tolerance, min, max] = parameters.named(["tolerance", "min", "max"])?;
            Sampling::Guided {
                tolerance: number("tolerance", tolerance)?,
                min: whole("min", min)?,
                max: whole("max", max)?,
            }
        }
        _ => {
            let [confidence, tolerance, min, max] = parameters.named(["confidence", "tolerance", "min", "max"])?;
            Sampling::Statistical {
                confidence: number("confidence", confidence)?,
                tolerance: number("tolerance", tolerance)?,
                min: whole("min", min)?,
                max: whole("max", max)?,
            }
        }
    };
    match validate::sampling(&sampling).into_iter().next() {
        None => Ok(sampling),
        Some(problem) => Err(format!("{}: {}", problem.path, problem.message)),
    }
}

/// What follows the method.
struct Parameters<'t> {
    form: &'static str,
    text: Option<&'t str>,
}

impl<'t> Parameters<'t> {
    fn none(&self) -> Result<(), String> {
        self.text.map_or(Ok(()), |found| Err(format!("expected `{}` alone, found `:{found}`", self.form)))
    }

    fn count(&self) -> Result<u64, String> {
        let text = self.text.ok_or_else(|| format!("expected {} with a number N", self.form))?;
        whole("N", text).map_err(|_| format!("expected {} with a whole number N, found `{text}`", self.form))
    }

    /// The values of these names, each given once in any order.
    fn named<const N: usize>(&self, names: [&str; N]) -> Result<[&'t str; N], String> {
        let mut values = [None; N];
        for part in self.text.unwrap_or_default().split(',').filter(|part| !part.is_empty()) {
            let Some((name, value)) = part.split_once('=') else {
                return Err(format!("expected {}, found `{part}` without a value", self.form));
            };
            let Some(index) = names.iter().position(|known| *known == name) else {
                return Err(unknown("parameter", name, &names));
            };
            if values[index].replace(value).is_some() {
                return Err(format!("`{name}` occurs twice, expected {}", self.form));
            }
        }
        let mut found = [""; N];
        for ((found, value), name) in found.iter_mut().zip(values).zip(names) {
            *found = value.ok_or_else(|| format!("`{name}` is missing, expected {}", self.form))?;
        }
        Ok(found)
    }
}

fn number(name: &str, text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|x: &f64| x.is_finite());
    number.ok_or_else(|| format!("{name}: expected a number, found `{text}`"))
}

fn whole<T: std::str::FromStr>(name: &str, text: &str) -> Result<T, String> {
    text.parse().map_err(|_| format!("{name}: expected a whole number, found `{text}`"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn reads(text: &str, expected: Sampling) {
        assert_eq!(sampling(text), Ok(expected));
    }

    #[track_caller]
    fn refuses(text: &str, expected: &str) {
        assert_eq!(sampling(text), Err(expected.to_owned()));
    }

    #[test]
    fn every_method_is_read() {
        reads("none", Sampling::None {});
        reads("regular:3", Sampling::Regular { n: 3 });
        reads("shared:1", Sampling::Shared { n: 1 });
        reads("stochastic:7", Sampling::Stochastic { n: 7 });
        reads("random:1048576", Sampling::Random { n: 1 << 20 });
        reads("sobol:64", Sampling::Sobol { n: 64 });
        reads("adaptive:depth=3,threshold=0.1", Sampling::Adaptive { threshold: 0.1, depth: 3 });
        let statistical = Sampling::Statistical { confidence: 0.95, tolerance: 0.05, min: 8, max: 4096 };
        reads("statistical:confidence=0.95,tolerance=0.05,min=8,max=4096", statistical);
        reads("guided:tolerance=0.02,min=4,max=64", Sampling::Guided { tolerance: 0.02, min: 4, max: 64 });
    }

    #[test]
    fn errors_say_what_was_expected() {
        refuses(
            "stocastic:4",
            "unknown sampling `stocastic`, expected none, regular, shared, adaptive, stochastic, random, sobol, statistical, guided; \
             did you mean `stochastic`?",
        );
        refuses("none:1", "expected `none` alone, found `:1`");
        refuses("regular", "expected regular:N with a number N");
        refuses("regular:x", "expected regular:N with a whole number N, found `x`");
        refuses("regular:0", "regular.n: must be from 1 to 1024, found 0");
        refuses("sobol:1048577", "sobol.n: must be from 1 to 1048576, found 1048577");
        refuses("adaptive", "`threshold` is missing, expected adaptive:threshold=T,depth=D");
        refuses("adaptive:threshold=0.1", "`depth` is missing, expected adaptive:threshold=T,depth=D");
        refuses("adaptive:3", "expected adaptive:threshold=T,depth=D, found `3` without a value");
        refuses(
            "adaptive:treshold=0.1,depth=3",
            "unknown parameter `treshold`, expected threshold, depth; did you mean `threshold`?",
        );
        refuses("adaptive:depth=1,depth=2,threshold=0", "`depth` occurs twice, expected adaptive:threshold=T,depth=D");
        refuses("adaptive:threshold=nan,depth=3", "threshold: expected a number, found `nan`");
        refuses("adaptive:threshold=0.1,depth=1.5", "depth: expected a whole number, found `1.5`");
        refuses("adaptive:threshold=-1,depth=3", "adaptive.threshold: must be 0 or more, found -1");
        refuses(
            "statistical:confidence=0.95,tolerance=0.05,min=8,max=4",
            "statistical.max: must be `min`, 8, or more, found 4",
        );
        refuses("guided:tolerance=0,min=4,max=8", "guided.tolerance: must be positive, found 0");
        refuses("guided:tolerance=1,min=1,max=1", "guided.max: must be from 2 to 1048576, found 1");
        refuses("guided:tolerance=1,min=4", "`max` is missing, expected guided:tolerance=T,min=M,max=N");
    }
}
