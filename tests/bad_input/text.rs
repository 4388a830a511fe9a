//! The rows b01 to b28: texts that are no scene.

use crate::scenes::{TEXTBOOK, error_of, loads, refuses, refuses_value, textbook_with};

#[test]
fn b01_empty() {
    refuses("", "1:1: the file is empty, expected a scene, `{…}`");
}

#[test]
fn b02_whitespace() {
    refuses(" \n\n ", "1:1: the file is empty, expected a scene, `{…}`");
}

#[test]
fn b03_truncated_half() {
    let (half, _) = TEXTBOOK.split_once(", 4, 1]").expect("the text");
    refuses(half, "6:22: camera.direction: the file ends too early, expected `]`");
}

#[test]
fn b04_truncated_last() {
    let text = TEXTBOOK.trim_end().strip_suffix('}').expect("the text");
    refuses(text, "38:49: the file ends too early, expected `}`");
}

#[test]
fn b05_trailing_garbage() {
    refuses(format!("{TEXTBOOK}{TEXTBOOK}"), "40:1: expected the end of the file after the scene, found `{`");
}

#[test]
fn b06_trailing_comma() {
    let text = textbook_with("\"linear\"}\n", "\"linear\"},\n");
    refuses(text, "38:49: a comma before the closing bracket, expected none (JSON has no trailing commas)");
}

#[test]
fn b07_comment() {
    let comment = "comments are not part of JSON, expected none";
    refuses(format!("// mine\n{TEXTBOOK}"), &format!("1:1: {comment}"));
    refuses(textbook_with(" \"name\"", " // mine\n\"name\""), &format!("3:3: {comment}"));
    refuses(textbook_with("45", "45 /* degrees */"), &format!("8:24: camera: {comment}"));
}

#[test]
fn b08_duplicate_key() {
    let text = textbook_with("\"name\": \"textbook\"", "\"format\": \"raywalk-scene/1\"");
    refuses(text, "3:3: format: the key `format` occurs twice, expected it once");
}

#[test]
fn b08_duplicate_deep_key() {
    let text = textbook_with("\"radius\": 3", "\"radius\": 3, \"radius\": 4");
    refuses(text, "34:80: objects[1].shape.sphere.radius: the key `radius` occurs twice, expected it once");
}

#[test]
fn b08_duplicate_material() {
    let text = textbook_with("\"ball\": {", "\"wall\": {");
    refuses(text, "24:5: materials.wall: the key `wall` occurs twice, expected it once");
}

#[test]
fn b08_duplicate_object() {
    let text = textbook_with("\"name\": \"sphere\"", "\"name\": \"plane\"");
    refuses(text, "34:14: objects[1].name: names must be unique, found `plane` a second time");
}

#[test]
fn b09_unknown_key() {
    let error = error_of(textbook_with("\"background\"", "\"backgruond\""));
    let start =
        "error: t.json:12:3: backgruond: unknown key `backgruond`, did you mean `background`? expected `format`, ";
    assert!(error.starts_with(start), "{error}");
}

#[test]
fn b09_unknown_shape() {
    let error = error_of(textbook_with("{\"sphere\":", "{\"shpere\":"));
    assert!(error.contains("objects[1].shape.shpere: unknown word `shpere`, did you mean `sphere`?"), "{error}");
}

#[test]
fn b10_nan() {
    refuses(
        textbook_with("\"radius\": 3", "\"radius\": NaN"),
        "34:77: objects[1].shape.sphere.radius: `NaN` is no number in JSON, expected a finite number",
    );
}

#[test]
fn b11_infinity() {
    refuses(
        textbook_with("[16, 2, 7]", "[16, -Infinity, 7]"),
        "5:22: camera.position[1]: `-Infinity` is no number in JSON, expected a finite number",
    );
}

#[test]
fn b12_too_large_number() {
    refuses_value(
        textbook_with("\"radius\": 3", "\"radius\": 1e999"),
        "objects[1].shape.sphere.radius: the number is too large, expected at most 1.797e308 in size",
    );
}

#[test]
fn b13_underflow_is_zero() {
    refuses(
        textbook_with("\"radius\": 3", "\"radius\": 1e-999"),
        "34:77: objects[1].shape.sphere.radius: must be positive, found 0",
    );
}

#[test]
fn b14_long_number() {
    let digits = "1".repeat(1_000_000);
    loads(textbook_with("\"radius\": 3", &format!("\"radius\": 0.{digits}")));
    let error = error_of(textbook_with("\"radius\": 3", &format!("\"radius\": {digits}")));
    assert!(error.len() < 600);
}

#[test]
fn b15_string_for_number() {
    refuses(
        textbook_with("\"radius\": 3", "\"radius\": \"1.0\""),
        "34:77: objects[1].shape.sphere.radius: expected a number, found the string \"1.0\"",
    );
}

#[test]
fn b16_null() {
    refuses_value(
        textbook_with("\"radius\": 3", "\"radius\": null"),
        "objects[1].shape.sphere.radius: expected a number, found null",
    );
}

#[test]
fn b16_null_for_what_may_be_left_out() {
    refuses_value(textbook_with("\"ball\"}", "null}"), "objects[1].material: expected a string, found null");
    refuses_value(textbook_with("{\"none\": {}}", "null"), NO_SAMPLING_NULL);
}

const NO_SAMPLING_NULL: &str = "sampling: expected one of `none`, `regular`, `shared`, `adaptive`, `stochastic`, `random`, `sobol`, `statistical`, `guided`, found null";

#[test]
fn b17_bool() {
    refuses_value(
        textbook_with("\"radius\": 3", "\"radius\": true"),
        "objects[1].shape.sphere.radius: expected a number, found true",
    );
}

#[test]
fn b18_array_top() {
    refuses(format!("[{TEXTBOOK}]"), "1:1: expected an object, found an array");
}

#[test]
fn b18_array_for_a_struct() {
    refuses_value(
        textbook_with("{\"center\": [17, 9, 8], \"radius\": 3}", "[[17, 9, 8], 3]"),
        "objects[1].shape.sphere: expected an object, found an array",
    );
    refuses_value(
        textbook_with("{\"none\": {}}", "{\"none\": []}"),
        "sampling.none: expected an object, found an array",
    );
}

#[test]
fn b19_short_vector() {
    refuses(
        textbook_with("[17, 9, 8]", "[17, 9]"),
        "34:55: objects[1].shape.sphere.center: expected an array of 3 elements, found 2 elements",
    );
}

#[test]
fn b20_long_vector() {
    refuses(
        textbook_with("[17, 9, 8]", "[17, 9, 8, 1]"),
        "34:55: objects[1].shape.sphere.center: expected an array of 3 elements, found 4 elements",
    );
}

#[test]
fn b21_byte_order_mark_is_skipped() {
    loads(format!("\u{feff}{TEXTBOOK}"));
    refuses("\u{feff}[]", "1:1: expected an object, found an array");
}

#[test]
fn b22_utf16() {
    let little: Vec<u8> = TEXTBOOK.encode_utf16().flat_map(u16::to_le_bytes).collect();
    let marked: Vec<u8> = [0xff, 0xfe].into_iter().chain(little.iter().copied()).collect();
    refuses(little, "1:1: the text is UTF-16, expected UTF-8");
    refuses(marked, "1:1: the text is UTF-16, expected UTF-8");
}

#[test]
fn b23_latin1() {
    let mut bytes = TEXTBOOK.as_bytes().to_vec();
    let at = TEXTBOOK.find("extbook").expect("the text");
    bytes[at] = 0xff;
    refuses(bytes, "3:13: not UTF-8: byte 0xff at offset 45, expected UTF-8 text");
}

#[test]
fn b23_stray_bytes() {
    refuses([0x80], "1:1: not UTF-8: byte 0x80 at offset 0, expected UTF-8 text");
}

#[test]
fn b24_nul_bytes() {
    refuses([0; 4096], "1:1: found a NUL byte, expected JSON text");
}

#[test]
fn b25_escape_codes() {
    refuses(
        textbook_with("\"name\": \"sphere\"", "\"name\": \"\\u001b[2J\""),
        "34:14: objects[1].name: a name must not hold control characters, found \\u{1b}",
    );
    refuses_value(
        textbook_with("\"name\": \"sphere\"", "\"name\": \"\u{1b}[2J\""),
        "objects[1].name: found \\u{1b} in a string, expected it as an escape (\\n, \\t, \\u001b)",
    );
    for (raw, shown) in [('\n', "\\n"), ('\t', "\\t"), ('\r', "\\r")] {
        refuses_value(
            textbook_with("\"name\": \"sphere\"", &format!("\"name\": \"{raw}\"")),
            &format!("objects[1].name: found {shown} in a string, expected it as an escape (\\n, \\t, \\u001b)"),
        );
    }
    refuses_value(
        textbook_with("\"ball\"}", "\"\\u001b[2J\"}"),
        "objects[1].material: no material is named `\\u{1b}[2J`, expected one of `wall`, `ball`",
    );
    error_of(textbook_with("\"radius\": 3", "\"\\u001b[2J\": 3"));
}

#[test]
fn b25_invisible_characters() {
    let with_name = |name: &str| textbook_with("\"name\": \"sphere\"", &format!("\"name\": \"{name}\""));
    let marks = [
        "ad", "34f", "61c", "115f", "1160", "17b4", "180b", "180e", "200b", "200c", "200d", "200e", "200f", "2028",
        "202a", "202e", "2060", "2061", "2064", "2065", "2066", "206f", "3164", "fe00", "fe0f", "feff", "ffa0", "fff9",
        "fffb", "e0001", "e0041", "e007f", "e0100",
    ];
    for mark in marks {
        let character = u32::from_str_radix(mark, 16).ok().and_then(char::from_u32).expect("a character");
        let expected = format!(
            "34:14: objects[1].name: a name must not hold invisible characters, found \\u{{{mark}}} behind `ba`"
        );
        refuses(with_name(&format!("ba{character}ll")), &expected);
    }
    refuses_value(with_name("\u{3164}"), "objects[1].name: a name must not hold invisible characters, found \\u{3164}");
    refuses_value(
        textbook_with("\"name\": \"F\"", "\"name\": \"F\u{2060}\""),
        "lights[0].name: a name must not hold invisible characters, found \\u{2060} behind `F`",
    );
    refuses_value(
        textbook_with("\"name\": \"textbook\"", "\"name\": \"\u{e0074}ext\""),
        "name: a name must not hold invisible characters, found \\u{e0074}",
    );
    let material = textbook_with("\"ball\": {", "\"b\u{ad}all\": {");
    assert!(error_of(material).contains(": a name must not hold invisible characters, found \\u{ad} behind `b`"));
}

#[test]
fn b25_names_that_look_alike() {
    let with_name = |name: &str| textbook_with("\"name\": \"plane\"", &format!("\"name\": \"{name}\""));
    for name in ["sphere ", " sphere", "\u{a0}sphere", "sphere\u{3000}", "sphere\u{2800}"] {
        let expected = format!("34:14: objects[1].name: names must not look alike, found `sphere` beside `{name}`");
        refuses(with_name(name), &expected);
    }
    loads(with_name("Sphere"));
    loads(with_name("sphere 2"));
    refuses_value(with_name(" \u{2003}"), "objects[0].name: a name must not be blank");
    let both = with_name("\u{e9}tang").replace("\"sphere\",", "\"e\u{301}tang\",");
    refuses_value(both, "objects[1].name: names must not look alike, found `e\u{301}tang` beside `\u{e9}tang`");
    let error = error_of(textbook_with("\"wall\": {", "\"ball \": {"));
    assert!(error.contains(": names must not look alike, found `ball` beside `ball `"), "{error}");
}

#[test]
fn b25_names_of_all_scripts_are_read() {
    for name in [
        "गेंद",
        "क्\u{200d}ष",
        "अवन्\u{200c}",
        "می\u{200c}خواهم",
        "کره\u{200c}ی قرمز",
        "ลูกบอลสีแดง",
        "e\u{301}toile",
        "Å",
        "بيت",
        "ക\u{d4d}\u{200d}",
        "한글",
        "球",
        "👩\u{200d}🔬",
        "❤\u{fe0f}",
        "❤\u{fe0f}\u{200d}🔥",
        "1\u{fe0f}\u{20e3}",
        "🇪🇸",
        "👍🏽",
        "מַיִם",
        "ကြယ်",
    ] {
        loads(textbook_with("\"name\": \"sphere\"", &format!("\"name\": \"{name}\"")));
    }
}

#[test]
fn b26_deep_arrays() {
    error_of("[".repeat(100_000));
    let (open, close) = ("[".repeat(100_000), "]".repeat(100_000));
    refuses_value(
        textbook_with("[17, 9, 8]", &format!("[17, 9, {open}{close}]")),
        "objects[1].shape.sphere.center[2]: expected a number, found an array",
    );
    error_of(textbook_with("[17, 9, 8]", &format!("[17, 9, 8, {open}{close}]")));
}

#[test]
fn b27_deep_objects() {
    error_of("{\"a\":".repeat(100_000));
    error_of(textbook_with("\"radius\": 3", &"{\"a\":".repeat(100_000)));
}

#[test]
fn b28_lone_surrogate() {
    refuses_value(
        textbook_with("\"textbook\"", "\"\\ud800\""),
        "name: half a surrogate pair (\\ud800 to \\udfff) in a string, expected both halves",
    );
}
