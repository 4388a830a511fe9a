//! Worked solutions: what they say, in both languages and every arithmetic.

use crate::calls::{prints, says};
use crate::support::snapshots;
use crate::tags::read;
use crate::{log, nasty_log, solution};
use insta::assert_snapshot;
use raywalk::log::What;
use raywalk::record::Arithmetic;
use raywalk::report::language::Language;
use raywalk::report::solution::{html, latex, markdown};
use raywalk::scene::builtin;

const EXAMPLE: [&str; 6] = ["trace", "textbook", "--pixel", "160,120", "--arithmetic", "decimal:3"];

fn example(more: &[&str]) -> String {
    prints(&[&EXAMPLE, more].concat())
}

/// The lines from the one that contains `first` up to the one that contains `last`.
#[track_caller]
fn between<'t>(text: &'t str, first: &str, last: &str) -> &'t str {
    let start = text.find(first).unwrap_or_else(|| panic!("{first} in:\n{text}"));
    let end = start + text[start..].find(last).unwrap_or_else(|| panic!("{last} after {first}"));
    &text[start..end]
}

#[test]
fn the_numeric_example_in_markdown() {
    snapshots().bind(|| assert_snapshot!("solution_textbook_markdown", example(&["--format", "markdown"])));
}

#[test]
fn the_numeric_example_in_the_source_s_own_language() {
    let text = example(&["--format", "markdown", "--lang", "es"]);
    snapshots().bind(|| assert_snapshot!("solution_textbook_markdown_es", text));
    // Formulas have decimal commas only.
    let mut formulas = text.split("$$").skip(1).step_by(2);
    assert!(formulas.clone().any(|formula| formula.contains("12{,}689")));
    let is_decimal = |formula: &str| {
        let bytes = formula.as_bytes();
        bytes.windows(3).any(|three| three[1] == b'.' && three[0].is_ascii_digit() && three[2].is_ascii_digit())
    };
    assert_eq!(formulas.find(|formula| is_decimal(formula)), None);
}

#[test]
fn the_numeric_example_for_latex() {
    let text = example(&["--format", "latex", "--lang", "es"]);
    let steps = between(&text, "\\subsection*{Desarrollo}", "\\subsubsection*{Rayo C R, reflejado}");
    snapshots().bind(|| assert_snapshot!("solution_textbook_latex_es", steps));
}

#[test]
fn the_numeric_example_as_a_page() {
    let text = example(&["--format", "html"]);
    let steps = between(&text, "<h2>Steps</h2>", "4) Nearest");
    snapshots().bind(|| assert_snapshot!("solution_textbook_html", steps));
}

#[test]
fn figure_6_with_its_tree_schematic_and_contributions() {
    let text = prints(&["trace", "figure-6", "--pixel", "160,120", "--format", "markdown"]);
    let steps = between(&text, "## Steps", "## Result");
    snapshots().bind(|| assert_snapshot!("solution_figure_6_markdown", text.replace(steps, "[…]\n\n")));
    // Every ray has its heading.
    for path in ["Ray C, from the eye", "Ray C T R T, transmitted", "Ray C T T R, reflected"] {
        assert!(steps.contains(&format!("### {path}\n")), "{path}");
    }
}

#[test]
fn pages_of_every_scene_are_well_formed_and_their_links_lead_somewhere() {
    for name in builtin::names() {
        let log = log(name, Arithmetic::F64);
        let page = read(&solution(&log, Language::English, html));
        assert!(page.links.len() > 10, "{name}: {} links", page.links.len());
        let lost = page.links.iter().find(|link| !link.strip_prefix('#').is_some_and(|id| page.ids.contains(id)));
        assert_eq!(lost, None, "{name}");
        let notes = log.events.iter().filter(|event| matches!(event.what, What::Note { .. })).count();
        let steps = page.ids.iter().filter(|id| id.starts_with('e')).count();
        assert_eq!(steps, notes, "{name}: every computed value is there once");
    }
}

#[test]
fn solutions_for_latex_have_every_brace_closed() {
    for name in builtin::names() {
        let text = solution(&log(name, Arithmetic::F64), Language::Spanish, latex);
        let mut depth = 0;
        let mut is_escaped = false;
        for c in text.chars() {
            match c {
                '\\' => {
                    is_escaped = !is_escaped;
                    continue;
                }
                '{' if !is_escaped => depth += 1,
                '}' if !is_escaped => depth -= 1,
                _ => {}
            }
            is_escaped = false;
            assert!(depth >= 0, "{name}");
        }
        assert_eq!(depth, 0, "{name}");
        let [begins, ends] = ["\\begin{", "\\end{"].map(|word| text.matches(word).count());
        assert!(begins == ends && begins > 10, "{name}: {begins} begin, {ends} end");
        assert!(!text.contains("[U+"), "{name}: a character that LaTeX lacks");
    }
}

#[test]
fn every_arithmetic_has_its_solution() {
    for arithmetic in [Arithmetic::F64, Arithmetic::F32, Arithmetic::Decimal(8), Arithmetic::Printed] {
        let log = log("textbook", arithmetic);
        let text = solution(&log, Language::English, markdown);
        assert!(text.contains(&format!("Arithmetic {arithmetic}, algorithm recursive")), "{arithmetic}");
        assert!(text.contains("## Result\n\nThe intensity that reaches the eye is $(39"), "{arithmetic}");
    }
    let perturbed =
        prints(&["trace", "textbook", "--pixel", "160,120", "--arithmetic", "perturbed:1", "--format", "markdown"]);
    assert!(perturbed.contains("digits)}"), "{perturbed}");
}

#[test]
fn names_stay_text() {
    let log = nasty_log();
    for language in Language::ALL {
        let text = solution(&log, language, html);
        assert!(!text.contains("<b a="), "an element of a name's own");
        let page = read(&text);
        assert_eq!(page.names.iter().filter(|name| *name == "script").count(), 1);
        assert!(page.text.contains("&lt;/script&gt;&lt;b a=&quot;x&quot; &#39;&gt;&amp;amp;"));
        let text = solution(&log, language, markdown);
        assert!(text.contains(r"\</script\>\<b a="), "{text}");
        let text = solution(&log, language, latex);
        assert_eq!(text.matches("\\end{document}").count(), 1);
        assert!(text.ends_with("\\end{document}\n"));
        for view in [html, markdown, latex] {
            let text = solution(&log, language, view);
            assert!(!text.contains(['\u{1b}', '\u{202e}']), "a control character");
        }
    }
}

#[test]
fn digits_are_those_that_are_asked_for() {
    let text = example(&["--format", "markdown", "--digits", "1"]);
    assert!(text.contains("= 12.7\n") && !text.contains("12.689"), "{text}");
}

#[test]
fn a_page_is_of_one_pixel() {
    for format in ["markdown", "latex", "html", "dot", "svg", "mermaid"] {
        let call = ["trace", "textbook", "--region", "0,0,2,2", "--format", format];
        says(2, &call, &format!("--format {format}: expected a pixel or a ray, found a region"));
    }
    says(2, &["trace", "textbook", "--pixel", "0,0", "--format", "pdf"], "invalid value 'pdf'");
}
