//! docs/refraction.md: every number of the page is one of the sheet, of the walk by hand, or of the exact column; every line of the walk in it
//! is in the walk.

use crate::calls::{prints, says};
use glam::DVec3;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// The ray that hits the bubble and the normal there, by hand.
const T_1: DVec3 = DVec3::new(0.793, -0.116, 0.598);
const N_2: DVec3 = DVec3::new(0.075, 0.077, -0.995);

/// The numbers of a text that have three decimals, with their signs.
fn numbers(text: &str) -> BTreeSet<String> {
    let text = text.replace('−', "-");
    let is_part = |c: char| c.is_ascii_digit() || c == '.' || c == '-';
    let words = text.split(|c: char| !is_part(c)).filter(|word| word.trim_start_matches('-').contains('.'));
    let words = words.map(|word| word.trim_end_matches(['.', '-']).to_owned());
    words.filter(|word| word.rsplit_once('.').is_some_and(|(_, decimals)| decimals.len() == 3)).collect()
}

#[test]
fn every_number_of_the_page_is_right() {
    let page = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/refraction.md")).expect("a page");
    let walk = prints(&["trace", "refraction", "--pixel", "160,120", "--arithmetic", "decimal:3", "--format", "text"]);
    let table = prints(&["textbook", "--example", "refraction"]);
    let known: BTreeSet<_> = numbers(&walk).union(&numbers(&table)).cloned().collect();
    // 1 − cos²φ₁ over η² is an expression within the formula of cosφ₂, which has no value there.
    let under_the_root = (1.0 - 0.544 * 0.544) / (0.625 * 0.625);
    // Step 5: what the unrounded product gives, and what the rounded one would.
    let mirrored_at = |cosine: f64| (T_1 + N_2 * (2.0 * cosine)).normalize();
    let product = T_1.dot(N_2);
    assert!(page.contains(&format!("T₁·N₂ = −{:.6}", -product)), "{product}");
    assert_eq!(format!("{:.3} {:.3}", mirrored_at(-product).z, mirrored_at(0.544).z), "-0.485 -0.484");
    let found = numbers(&page);
    assert!(found.len() > 90, "{} numbers", found.len());
    for number in &found {
        let is_known = known.contains(number) || known.contains(&format!("-{number}"));
        let is_computed_here = [under_the_root, -mirrored_at(0.544).z].map(|value| format!("{value:.3}"));
        assert!(
            is_known || is_computed_here.contains(&number.trim_start_matches('-').to_owned()),
            "{number} is neither in the sheet nor in the walk"
        );
    }
    let mut lines = 0;
    for block in page.split("```text\n").skip(1) {
        for line in block.split("```").next().unwrap_or_default().lines() {
            lines += 1;
            assert!(walk.lines().any(|known| known.trim() == line), "{line}");
        }
    }
    assert_eq!(lines, 2);
    // Every value of the sheet that isn't whole is on the page, too.
    let sheet = prints(&["textbook", "--example", "refraction", "--format", "json"]);
    let sheet: serde_json::Value = serde_json::from_str(&sheet).expect("JSON");
    for row in sheet["steps"].as_array().expect("rows") {
        // Of colours the page has red alone.
        let values: Vec<f64> = match &row["printed"] {
            serde_json::Value::Array(values) if row["quantity"] != "shadow.transmittance" => {
                values.iter().filter_map(serde_json::Value::as_f64).collect()
            }
            serde_json::Value::Array(values) => values.iter().take(1).filter_map(serde_json::Value::as_f64).collect(),
            value => value.as_f64().into_iter().collect(),
        };
        for value in values {
            let text = format!("{value:.3}");
            assert!(text.ends_with(".000") || found.contains(&text), "{} {text}", row["quantity"]);
        }
    }
}

#[test]
fn the_sheet_is_checked_as_anybody_elses() {
    let checked = prints(&["textbook", "--example", "refraction", "--with", "scenes/refraction.csv"]);
    assert!(checked.contains("62 values checked, 0 depart"), "{checked}");
    // A wrong number departs.
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("own.csv");
    fs::write(&file, "quantity,printed,path\nrefract.cos_2,0.961,C\n").expect("a file");
    let arguments = ["textbook", "--example", "refraction", "--with", file.to_str().expect("a plain name")];
    let output = crate::calls::raywalk(&arguments).output().expect("it runs");
    assert_eq!(output.status.code(), Some(1), "{}", String::from_utf8_lossy(&output.stdout));
    // The numeric example has no refraction.
    says(2, &["textbook", "--with", file.to_str().expect("a plain name")], "the walk has 0 of `refract.cos_2`");
    // A sheet of the other example is recognised, either way round; a sheet of neither isn't.
    says(2, &["textbook", "--with", "scenes/refraction.csv"], "; the table fits another example: --example refraction");
    fs::write(&file, "quantity,printed,path\nsphere.t2_a,6.380,C R\n").expect("a file");
    let arguments = ["textbook", "--example", "refraction", "--with", file.to_str().expect("a plain name")];
    says(2, &arguments, "; the table fits another example: --example textbook");
    fs::write(&file, "quantity,printed,path\nplane.t,12.685,C T T T T R\n").expect("a file");
    let output = crate::calls::raywalk(&arguments).output().expect("it runs");
    assert!(!String::from_utf8_lossy(&output.stderr).contains("--example"), "{output:?}");
}

/// What the footer names can be called, and prints the result that the footer has.
#[test]
fn the_call_with_rounded_products_gives_the_result_of_the_footer() {
    for (example, result) in [("textbook", "394.024"), ("refraction", "90.342")] {
        let table = prints(&["textbook", "--example", example]);
        let (_, footer) = table.split_once("rounded too (`raywalk ").expect("a call");
        let (call, footer) = footer.split_once("`)").expect("the end of the call");
        assert!(footer.contains(result), "{footer}");
        let call: Vec<&str> = call.split(' ').chain(["--format", "text"]).collect();
        let walk = prints(&call);
        assert!(walk.contains("--round-products") && walk.contains(&format!("({result}")), "{call:?}");
    }
}

#[test]
fn both_examples_have_json_and_markdown() {
    for example in ["textbook", "refraction"] {
        let json = prints(&["textbook", "--example", example, "--format", "json"]);
        let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
        let expected = if example == "textbook" { 394.028 } else { 90.285 };
        assert_eq!(json["result"]["printed"], serde_json::json!(expected));
        assert!(prints(&["textbook", "--example", example, "--format", "markdown"]).starts_with("| step |"));
    }
    assert_eq!(prints(&["textbook"]), prints(&["textbook", "--example", "textbook"]));
    says(2, &["textbook", "--example", "other"], "refraction");
}
