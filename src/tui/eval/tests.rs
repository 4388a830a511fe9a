//! What expressions come to, against numbers computed here.

use super::*;
use crate::log::What as Happening;
use crate::record::Arithmetic;
use crate::report::language::Language;
use crate::tui::testing::{glass, log_of, nested, sized, textbook, typed};
use proptest::prelude::*;

/// The numeric example at the first light, at the last of its cosines.
fn at_light() -> Model {
    let mut model = sized(log_of("textbook", Arithmetic::F64), 100, 30);
    let is_n_dot_h = |event: &crate::log::Event| event.noted().is_some_and(|(name, _)| name == Name::ShadeNDotH);
    let event = model.log.events.iter().position(is_n_dot_h).expect("the plane is lit from the front");
    model.go_to_event(event);
    model
}

/// The latest value of a symbol before the current step, by going back over the events. Nothing else has computed it between.
fn noted(model: &Model, symbol: &str) -> Value {
    let mut before = model.log.events[..=model.event].iter().rev();
    let found = before.find_map(|event| match event.what {
        Happening::Note { name, value } if name.symbol() == symbol => Some(value),
        _ => None,
    });
    found.unwrap_or_else(|| panic!("no {symbol}"))
}

#[track_caller]
fn gives(model: &Model, text: &str, expected: Value) {
    let (_, value) = computed(model, text).unwrap_or_else(|why| panic!("{text}: {why}"));
    assert!(value.same_bits(&expected), "{text}: {value:?} is not {expected:?}");
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[test]
fn names_are_values_here() {
    let model = at_light();
    let [n, l] = ["N", "L"].map(|symbol| noted(&model, symbol));
    let (Value::Triple(n3), Value::Triple(l3)) = (n, l) else { panic!("two directions") };
    for text in ["N", "hit.normal", " N "] {
        gives(&model, text, n);
    }
    for text in
        ["dot(N, L)", "N·L", "N*L", "N · L", "N * L", "dot (hit.normal; light.direction)", "shade.n_dot_l", "(N)·(L)"]
    {
        gives(&model, text, Value::Number(dot(n3, l3)));
    }
    for (text, index) in [("N.x", 0), ("N.g", 1), ("hit.normal.z", 2), ("hit.normal.b", 2)] {
        gives(&model, text, Value::Number(n3[index]));
    }
    let crossed = [n3[1] * l3[2] - l3[1] * n3[2], n3[2] * l3[0] - l3[2] * n3[0], n3[0] * l3[1] - l3[0] * n3[1]];
    for text in ["cross(N, L)", "N × L", "N x L"] {
        gives(&model, text, Value::Triple(crossed));
    }
    gives(&model, "|N|", Value::Number(dot(n3, n3).sqrt()));
    let sum = [0, 1, 2].map(|i| n3[i] + l3[i]);
    gives(&model, "length(N + L)", Value::Number(dot(sum, sum).sqrt()));
    let length = dot(sum, sum).sqrt();
    gives(&model, "unit(N + L)", Value::Triple(sum.map(|x| x / length)));
}

#[test]
fn signs_and_functions() {
    let model = sized(textbook(), 100, 30);
    let number = |text: &str, expected: f64| gives(&model, text, Value::Number(expected));
    number("1 + 2*3", 7.0);
    number("-2^2", -4.0);
    number("2^-1", 0.5);
    number("2^3^2", 512.0);
    number("(1 - 2) - 3", -4.0);
    number("1 − 2·3/4", -0.5);
    number("1e-3 + .5", 0.501);
    number("2.5·10⁻³", 2.5 * libm::pow(10.0, -3.0));
    number("3²", 9.0);
    number("max(1, 2) + min(1; 2)", 3.0);
    refuses(&model, "0,5 + 1", "column 2: ");
    refuses(&model, "min(1,2,3)", "column 8: ");
    refuses(&model, "(1,2)*(3,4)", "column 5: ");
    number("clamp(7, 0, 1) + clamp(-7, 0, 1)", 1.0);
    number("abs(-1e200)", 1e200);
    number("|-3|", 3.0);
    number("sqrt(2)", 2.0_f64.sqrt());
    number("sin(rad(90)) + cos(180°)", 0.0);
    number("asin(1)", libm::asin(1.0));
    number("acos(0) + atan(1)", libm::acos(0.0) + libm::atan(1.0));
    number("deg(pi)", 180.0);
    number("2π", std::f64::consts::TAU);
    number("exp(1) + ln(2) + tan(0)", libm::exp(1.0) + libm::log(2.0));
    number("1/0", f64::INFINITY);
    number("dot((1, 2, 3), (4; 5; 6))", 32.0);
    gives(&model, "(1, 2, 3)/2", Value::Triple([0.5, 1.0, 1.5]));
    gives(&model, "(1, 2, 3) ∘ (2, 2, 2)", Value::Triple([2.0, 4.0, 6.0]));
    gives(&model, "unit((0, 3, 4))", Value::Triple([0.0, 0.6, 0.8]));
}

/// With decimal commas, where that makes sense.
#[test]
fn spanish_numbers() {
    let model = Model { language: Language::Spanish, ..sized(textbook(), 100, 30) };
    let number = |text: &str, expected: f64| gives(&model, text, Value::Number(expected));
    number("0,5 + 1", 1.5);
    number("min(0,5; 1)", 0.5);
    number("max(1, 2)", 2.0);
    number("dot((1,5; 2; 3), (4, 5, 6))", 34.0);
}

#[test]
fn what_was_put_in_is_shown() {
    let mut model = at_light();
    let [n, l] = ["N", "L"].map(|symbol| model.value(&noted(&model, symbol)));
    let answer = model.value(&noted(&model, "N·L"));
    assert_eq!(evaluated(&model, "dot(N, L)").as_deref(), Ok(format!("dot(N, L) = {n}·{l} = {answer}").as_str()));
    assert_eq!(evaluated(&model, "N·L"), Ok(format!("N·L = {answer}")));
    assert_eq!(evaluated(&model, "1/8").as_deref(), Ok("1/8 = 0.125"));
    model.language = Language::Spanish;
    assert_eq!(evaluated(&model, "1/8").as_deref(), Ok("1/8 = 0,125"));
    assert!(evaluated(&model, "2*N").is_ok_and(|said| said.contains("; ")));
}

#[test]
fn a_product_that_is_not_computed_yet_is_one_of_its_factors() {
    let mut model = sized(glass(), 100, 30);
    let is_l = |event: &crate::log::Event| event.noted().is_some_and(|(name, _)| name == Name::LightDirection);
    model.go_to_event(model.log.events.iter().position(is_l).expect("a light"));
    let (Value::Triple(n), Value::Triple(l)) = (noted(&model, "N"), noted(&model, "L")) else { panic!("directions") };
    gives(&model, "N·L", Value::Number(dot(n, l)));
}

#[track_caller]
fn refuses(model: &Model, text: &str, expected: &str) {
    let said = evaluated(model, text).err().unwrap_or_default();
    assert!(said.contains(expected), "{text}: {said}");
}

#[test]
fn mistakes_have_columns() {
    let model = at_light();
    refuses(&model, "1 + ", "column 4: expected a number, a name");
    refuses(&model, "dot(N, K_q)", "column 8: nothing is called `K_q`");
    refuses(&model, "1 + shade.n_dot_k", "column 5: nothing is called `shade.n_dot_k`; did you mean `shade.n_dot_l`?");
    refuses(&model, "sqr(2)", "did you mean `sqrt`?");
    refuses(&model, "zzzzzzzzz", "known here: N·H, ");
    refuses(&model, "N L", "column 3: expected an operator");
    refuses(&model, "dot(N)", "column 6: expected `,`, found `)`");
    refuses(&model, "(1 + 2", "column 7: expected `)`");
    refuses(&model, "N·L.x", "column 1: N·L is a number and has no components");
    refuses(&model, "1 + N", "column 1: can't compute 1 + (");
    refuses(&model, "2*(N + 1)", "column 4: can't compute (");
    refuses(&model, "N/L", "column 1: can't compute (");
    refuses(&model, "I_local", "has no value here; known are N·H, ");
    refuses(&model, "\x1b[2J", "column 1: expected a number");
    refuses(&model, &"(".repeat(100_000), "too many operations");
    refuses(&model, &"-".repeat(100_000), "too many operations");
    refuses(&model, &"1+".repeat(100_000), "too many operations");
    refuses(&model, &format!("{}N{}", "unit(".repeat(60), ")".repeat(60)), "too many operations");
    refuses(&sized(nested(""), 100, 30), "N", "nor has anything else");
}

#[test]
fn what_comes_later_in_the_node_is_said_where_it_is() {
    let mut model = at_light();
    let step = model.step();
    typed(&mut model, "p");
    refuses(&model, "shade.n_dot_h", &format!("before step {step}; :{step} goes there"));
    // A tree that grows doesn't say what is to come.
    typed(&mut model, "t");
    refuses(&model, "shade.n_dot_h", "N·H has no value here; known are ");
}

#[test]
fn a_quiz_keeps_its_answers() {
    let mut model = at_light();
    let answer = model.value(&noted(&model, "N·H"));
    assert_eq!(evaluated(&model, "N·H"), Ok(format!("N·H = {answer}")));
    typed(&mut model, "Q");
    for text in ["shade.n_dot_h", "N·H", "dot(N, H)", "1 + 0*N.x", "N"] {
        refuses(&model, text, "in a quiz with numbers only");
    }
    // It still calculates.
    assert_eq!(evaluated(&model, "3*4").as_deref(), Ok("3*4 = 12"));
    typed(&mut model, "Q");
    assert_eq!(evaluated(&model, "shade.n_dot_h"), Ok(format!("shade.n_dot_h = {answer}")));
}

#[test]
fn names_are_completed_from_what_is_known() {
    let model = at_light();
    let has = |text: &str, way: &str| completions(&model, text).contains(&way.to_owned());
    assert!(has("1 + sq", "1 + sqrt("));
    assert!(has("dot(hit.no", "dot(hit.normal"));
    assert!(!has("combine.c", "combine.color"));
    assert!(completions(&model, "1 + ").is_empty());
}

/// An expression as it is typed, and what it comes to.
fn expression() -> impl Strategy<Value = (String, f64)> {
    let number = (0.0_f64..1000.0).prop_map(|x| (format!("{x:?}"), x));
    let small = (0_u32..20).prop_map(|x| (x.to_string(), f64::from(x)));
    let name = prop_oneof![Just("N·H"), Just("shade.n_dot_l"), Just("N.x"), Just("light.direction.y"), Just("L.z")];
    let name = name.prop_map(|name| (name.to_owned(), NAMED.with(|named| named[name])));
    prop_oneof![number, small, name].prop_recursive(4, 24, 3, |inner| {
        let one = inner.clone();
        let call = prop::sample::select(vec![
            "sin", "cos", "tan", "exp", "sqrt", "ln", "asin", "acos", "atan", "abs", "deg", "-",
        ]);
        let called = (call, one).prop_map(|(name, (text, x))| {
            let value = match name {
                "sin" => libm::sin(x),
                "cos" => libm::cos(x),
                "tan" => libm::tan(x),
                "exp" => libm::exp(x),
                "sqrt" => x.sqrt(),
                "ln" => libm::log(x),
                "asin" => libm::asin(x),
                "acos" => libm::acos(x),
                "atan" => libm::atan(x),
                "abs" => x.abs(),
                "deg" => x.to_degrees(),
                _ => -x,
            };
            (format!("{name}({text})"), value)
        });
        let sign = prop::sample::select(vec!["+", "-", "−", "*", "·", "/", "^", "min", "max"]);
        let joined = (sign, inner.clone(), inner).prop_map(|(sign, (left, a), (right, b))| match sign {
            "+" => (format!("({left}) + ({right})"), a + b),
            "-" | "−" => (format!("({left}) {sign} ({right})"), a - b),
            "*" | "·" => (format!("({left}){sign}({right})"), a * b),
            "/" => (format!("({left})/({right})"), a / b),
            "^" => (format!("({left})^({right})"), libm::pow(a, b)),
            "min" => (format!("min({left}, {right})"), if a < b { a } else { b }),
            _ => (format!("max({left}; {right})"), if a > b { a } else { b }),
        });
        prop_oneof![called, joined]
    })
}

thread_local! {
    static MODEL: Model = at_light();
    static NAMED: std::collections::HashMap<&'static str, f64> = MODEL.with(|model| {
        let number = |symbol| noted(model, symbol).number().unwrap_or(f64::NAN);
        let part = |symbol, index: usize| noted(model, symbol).triple().map_or(f64::NAN, |triple| triple[index]);
        [
            ("N·H", number("N·H")),
            ("shade.n_dot_l", number("N·L")),
            ("N.x", part("N", 0)),
            ("light.direction.y", part("L", 1)),
            ("L.z", part("L", 2)),
        ]
        .into()
    });
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 500, failure_persistence: None, ..ProptestConfig::default() })]

    /// The arithmetic is that of f64, operation by operation.
    #[test]
    fn random_expressions_are_what_f64_gives((text, expected) in expression()) {
        MODEL.with(|model| {
            let (_, value) = computed(model, &text).unwrap_or_else(|why| panic!("{text}: {why}"));
            let value = value.number().unwrap_or(f64::NAN);
            let same = value.to_bits() == expected.to_bits() || (value.is_nan() && expected.is_nan());
            assert!(same, "{text}: {value:e} is not {expected:e}");
            assert!(evaluated(model, &text).is_ok());
        });
    }

    /// Nothing that is typed panics.
    #[test]
    fn any_text_is_answered(text in "[-+*/^().,;|·×°²⁺⁻¹π0-9a-zNLHd_ e]{0,40}") {
        MODEL.with(|model| _ = evaluated(model, &text));
    }
}
