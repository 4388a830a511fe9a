//! `--sampling SPEC`: a method of sampling in one word, `sobol:64` or `adaptive:threshold=0.1,depth=3`. The methods and their forms are those
//! of [`FORMS`].

use raywalk::files::{one_of, unknown};
use raywalk::scene::Sampling;
use raywalk::scene::file::schema::FORMS;
use raywalk::scene::file::validate;
use serde_json::{Map, Value, json};

/// What `--sampling` does, with the parameters that a method has by default.
pub fn sampling_help() -> String {
    let forms = FORMS.iter().map(|(form, what)| match sampling(word(form)) {
        Ok(default) if default.key() != *form => format!("{form} ({what}; `{}` alone is {default})", default.key()),
        _ => format!("{form} ({what})"),
    });
    format!("Which rays make a pixel: {}", one_of(forms))
}

/// Reads a method; the error says what was expected.
pub fn sampling(text: &str) -> Result<Sampling, String> {
    sampling_or(&[], text)
}

/// The same where other words are allowed instead, which the caller reads and the error names, too.
pub fn sampling_or(others: &[&str], text: &str) -> Result<Sampling, String> {
    let (method, parameters) = text.split_once(':').map_or((text, None), |(method, rest)| (method, Some(rest)));
    let mut forms = FORMS.iter().map(|(form, _)| *form);
    let Some(form) = forms.clone().find(|form| word(form) == method) else {
        let methods: Vec<_> = others.iter().copied().chain(forms.by_ref().map(word)).collect();
        return Err(unknown("sampling", method, &methods));
    };
    // A scene file has the same parameters.
    let keys = match (form.strip_prefix(method).and_then(|rest| rest.strip_prefix(':')), parameters) {
        (None, None) => Map::new(),
        (None, Some(found)) => return Err(format!("expected `{form}` alone, found `:{found}`")),
        (Some("N"), found) => {
            let found = found.ok_or_else(|| format!("expected {form} with a number N"))?;
            let n = value("N", "N", found);
            let n = n.map_err(|_| format!("expected {form} with a whole number N, found `{found}`"))?;
            Map::from_iter([("n".to_owned(), n)])
        }
        (Some(named), found) => self::named(form, named, found.unwrap_or_default())?,
    };
    let sampling: Sampling =
        serde_json::from_value(json!({method: keys})).map_err(|error| format!("{error}, expected {form}"))?;
    match validate::sampling(&sampling).into_iter().next() {
        None => Ok(sampling),
        Some(problem) => Err(format!("{}: {}", problem.path, problem.message)),
    }
}

fn word(form: &str) -> &str {
    form.split(':').next().unwrap_or(form)
}

/// The values of these parameters, `threshold=T,depth=D`, each given at most once in any order.
fn named(form: &str, named: &str, text: &str) -> Result<Map<String, Value>, String> {
    let known: Vec<(&str, &str)> = named.split(',').filter_map(|one| one.split_once('=')).collect();
    let names: Vec<&str> = known.iter().map(|(name, _)| *name).collect();
    let mut values = Map::new();
    for part in text.split(',').filter(|part| !part.is_empty()) {
        let Some((name, given)) = part.split_once('=') else {
            return Err(format!("expected {form}, found `{part}` without a value"));
        };
        let Some((_, letter)) = known.iter().find(|(known, _)| *known == name) else {
            return Err(unknown("parameter", name, &names));
        };
        if values.insert(name.to_owned(), value(name, letter, given)?).is_some() {
            return Err(format!("`{name}` occurs twice, expected {form}"));
        }
    }
    Ok(values)
}

/// A value for the letter of a form: C and T stand for any numbers, the others for whole ones.
fn value(name: &str, letter: &str, text: &str) -> Result<Value, String> {
    if matches!(letter, "C" | "T") {
        let number = text.parse().ok().filter(|x: &f64| x.is_finite());
        return number.map(Value::from).ok_or_else(|| format!("{name}: expected a number, found `{text}`"));
    }
    let whole = text.parse::<u32>().map(Value::from);
    whole.map_err(|_| format!("{name}: expected a whole number, found `{text}`"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use raywalk::scene::{Guided, Statistical};

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
        reads("none", Sampling::Center {});
        reads("regular:3", Sampling::Regular { n: 3 });
        reads("shared:1", Sampling::Shared { n: 1 });
        reads("stochastic:7", Sampling::Stochastic { n: 7 });
        reads("random:1048576", Sampling::Random { n: 1 << 20 });
        reads("sobol:64", Sampling::Sobol { n: 64 });
        reads("adaptive:depth=3,threshold=0.1", Sampling::Adaptive { threshold: 0.1, depth: 3 });
        let statistical = Sampling::Statistical(Statistical { confidence: 0.95, tolerance: 0.05, min: 8, max: 4096 });
        reads("statistical:confidence=0.95,tolerance=0.05,min=8,max=4096", statistical);
        reads("guided:tolerance=0.02,min=4,max=64", Sampling::Guided(Guided { tolerance: 0.02, min: 4, max: 64 }));
    }

    /// As a scene file has them: `{"guided": {"min": 2}}`.
    #[test]
    fn what_is_left_out_is_as_in_a_scene() {
        let default: Guided = serde_json::from_str("{}").expect("every key has a default");
        reads("guided", Sampling::Guided(default));
        reads("guided:tolerance=0.01", Sampling::Guided(Guided { tolerance: 0.01, ..default }));
        reads("guided:max=64,min=2", Sampling::Guided(Guided { min: 2, max: 64, ..default }));
        reads(&Sampling::Guided(default).to_string(), Sampling::Guided(default));
        let alone = format!("`guided` alone is {})", Sampling::Guided(default));
        assert!(sampling_help().ends_with(&alone), "{}", sampling_help());
        let page = include_str!("../../docs/sampling.md");
        assert!(page.contains(&format!("`guided`, which is `{}`", Sampling::Guided(default))));
        assert!(sampling_help().contains(") or guided:"), "{}", sampling_help());
    }

    #[test]
    fn errors_say_what_was_expected() {
        refuses(
            "stocastic:4",
            "unknown sampling `stocastic`, did you mean `stochastic`? expected `none`, `regular`, `shared`, `adaptive`, `stochastic`, \
             `random`, `sobol`, `statistical` or `guided`",
        );
        refuses("none:1", "expected `none` alone, found `:1`");
        refuses("regular", "expected regular:N with a number N");
        refuses("regular:x", "expected regular:N with a whole number N, found `x`");
        refuses("regular:0", "regular.n: must be from 1 to 1024, found 0");
        refuses("sobol:1048577", "sobol.n: must be from 1 to 1048576, found 1048577");
        refuses("adaptive", "missing field `threshold`, expected adaptive:threshold=T,depth=D");
        refuses("adaptive:threshold=0.1", "missing field `depth`, expected adaptive:threshold=T,depth=D");
        refuses("adaptive:3", "expected adaptive:threshold=T,depth=D, found `3` without a value");
        refuses(
            "adaptive:treshold=0.1,depth=3",
            "unknown parameter `treshold`, did you mean `threshold`? expected `threshold` or `depth`",
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
        refuses("guided:min=5000", "guided.max: must be `min`, 5000, or more, found 4096");
        refuses("guided:tolerance", "expected guided:tolerance=T,min=M,max=N, found `tolerance` without a value");
    }
}
