//! The checks of one of the `materials`, and of the names that objects call them by.

use crate::files::escape::quoted;
use crate::files::suggest;
use crate::scene::file::schema::{Material, Materials, Pattern, Weight};

use super::checker::{Checker, number};
use super::limits::MAX_SAMPLES;

/// How many names a message lists.
const LISTED: usize = 8;

/// Checks a material, all but its name.
pub fn material(check: &mut Checker<'_>, material: &Material) {
    check.color("ambient", material.ambient);
    check.color("diffuse", material.diffuse);
    check.color("specular", material.specular);
    check.color("transmission", material.transmission);
    check.not_negative("shininess", material.shininess);
    check.not_negative("transmission_exponent", material.transmission_exponent);
    check.ratio("ior", material.ior);
    refraction(check.at("ior"), material);
    let mut weights = check.at("weights");
    weight(&mut weights, "local", material.weights.local);
    weight(&mut weights, "reflected", material.weights.reflected);
    weight(&mut weights, "transmitted", material.weights.transmitted);
    drop(weights);
    if let Some(exponent) = material.gloss_exponent {
        check.not_negative("gloss_exponent", exponent);
    }
    if let Some(exponent) = material.translucency_exponent {
        check.not_negative("translucency_exponent", exponent);
    }
    check.count("samples", material.samples, 1, MAX_SAMPLES);
    if let Some(Pattern::Checker(checker)) = material.pattern.as_deref() {
        let mut check = check.at("pattern");
        let mut check = check.at("checker");
        check.color("a", checker.a);
        check.color("b", checker.b);
        check.positive("size", checker.size);
    }
}

/// Quotients of two media are what formulas have; a scene has the media.
fn refraction(mut check: Checker<'_>, material: &Material) {
    let of_light = material.weights.transmitted.rgb().into_iter().chain(material.transmission);
    let transmits = of_light.into_iter().any(|part| part > 0.0);
    if transmits && material.ior > 0.0 && material.ior < 1.0 {
        let message =
            "should be the index of the medium itself, 1 or more, and not its quotient with what is around it";
        check.warning(format!("{message}; found {}", number(material.ior)));
    }
}

fn weight(check: &mut Checker<'_>, key: &'static str, weight: Weight) {
    match weight {
        Weight::Scalar(weight) => check.not_negative(key, weight),
        Weight::Rgb(weights) => check.color(key, weights),
    }
}

/// Checks that an object's material is there.
pub fn reference(mut check: Checker<'_>, name: &str, materials: &Materials) {
    if materials.get(name).is_some() {
        return;
    }
    if check.is_full() {
        return check.error(String::new());
    }
    let names: Vec<&str> = materials.iter().map(|(name, _)| name).collect();
    let listed: Vec<String> = names.iter().take(LISTED).map(|name| quoted(name)).collect();
    let more = if names.len() > LISTED { ", …" } else { "" };
    let expected = match suggest(name, names.iter().copied()) {
        Some(meant) => format!("did you mean {}?", quoted(meant)),
        None if names.is_empty() => "the scene has no materials".to_string(),
        None => format!("expected one of {}{more}", listed.join(", ")),
    };
    check.error(format!("no material is named {}, {expected}", quoted(name)));
}
