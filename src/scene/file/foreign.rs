//! Numbers and ends of texts as other programs write them.

/// The longest way to write a number that is none: nobody needs to look further.
const LONGEST: usize = 40;

/// The number that a word is. It may be infinite or none (NaN), in the spellings of every C library: `nan`, `-nan(ind)`,
/// `inf`, `-1.#IND`.
pub fn number(word: &[u8]) -> Option<f64> {
    let text = std::str::from_utf8(word).ok()?;
    text.parse().ok().or_else(|| if is_none(text) { Some(f64::NAN) } else { None })
}

/// Whether a word is one of the spellings that Rust doesn't read.
fn is_none(text: &str) -> bool {
    if text.len() > LONGEST {
        return false;
    }
    let lower = text.to_ascii_lowercase();
    let unsigned = lower.strip_prefix(['-', '+']).unwrap_or(&lower);
    if let Some(payload) = unsigned.strip_prefix("nan(").and_then(|rest| rest.strip_suffix(')')) {
        return payload.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_');
    }
    let Some(digits) = unsigned.strip_prefix("1.") else { return false };
    let (digits, exponent) = digits.split_once('e').unwrap_or((digits, ""));
    // Microsoft's library rounded the letters as if they were digits: with three decimals `1.#INF` was `1.#IO`, with one `1.$`.
    let letters = digits.trim_end_matches('0');
    let is_known = matches!(
        letters,
        "$" | "#inf" | "#ind" | "#qnan" | "#snan" | "#j" | "#r" | "#t" | "#io" | "#qo" | "#so" | "#qnb" | "#snb"
    );
    is_known && exponent.bytes().all(|byte| byte.is_ascii_digit() || matches!(byte, b'-' | b'+'))
}

/// Whether the `#` at `hash` belongs to the word that begins at `start`, as in `1.#INF`, and begins no comment.
pub fn is_in_number(text: &[u8], start: usize, hash: usize) -> bool {
    if !text[start..hash].ends_with(b"1.") {
        return false;
    }
    let rest = &text[hash + 1..];
    let length = rest.iter().take(LONGEST).position(|byte| is_blank(*byte) || matches!(byte, b'\n' | b'\r' | b'#'));
    std::str::from_utf8(&text[start..hash + 1 + length.unwrap_or(rest.len().min(LONGEST))]).is_ok_and(is_none)
}

/// Whether a byte is between the words of a line.
pub fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\x0b' | b'\x0c')
}

/// The text before the characters ^Z that some programs end it with.
pub fn without_end_mark(mut text: &[u8]) -> &[u8] {
    while let Some(rest) = text.trim_ascii_end().strip_suffix(b"\x1a") {
        text = rest;
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_that_are_none() {
        let none = "nan -nan NaN nan(ind) -nan(ind) nan(snan) nan(0x7ff) inf -inf Infinity 1e999 1.#INF -1.#IND 1.#QNAN 1.#SNAN \
                    1.#INF00 -1.#IND00 1.#QNAN0 1.#J -1.#J 1.#R 1.#IO 1.#QO 1.#QNB 1.$ 1.#INF00e+000 1.#inf";
        for word in none.split(' ') {
            assert!(number(word.as_bytes()).is_some_and(|number| !number.is_finite()), "{word}");
        }
        for word in
            ["", "x", "1.#", "1.#c", "2.#INF", "1.#INFx", "1.#IND1", "nan(", "nan(a b)", "0x1", "1,5", "1.#INFe+x"]
        {
            assert_eq!(number(word.as_bytes()), None, "{word}");
        }
        assert_eq!(number(b"-1.5e3"), Some(-1500.0));
        assert_eq!(number(&b"1.#INF".repeat(1_000_000)), None);
    }

    #[test]
    fn a_hash_in_a_number_is_no_comment() {
        let is_inside = |text: &str| is_in_number(text.as_bytes(), 0, text.find('#').unwrap_or_default());
        for text in ["1.#INF", "-1.#IND00 2", "1.#QNAN\n", "1.#J\t", "1.#INF#c"] {
            assert!(is_inside(text), "{text}");
        }
        for text in ["1.0#c", "1.#", "1.# INF", "1.#c", "1.#infinite", "a#INF", "1.#\u{fc}"] {
            assert!(!is_inside(text), "{text}");
        }
    }

    #[test]
    fn the_end_mark_ends_a_text() {
        for text in ["f 1\n\u{1a}", "f 1\n\u{1a}\r\n", "f 1\n\u{1a}\u{1a}\n \u{1a}"] {
            assert_eq!(without_end_mark(text.as_bytes()), b"f 1\n", "{text:?}");
        }
        for text in ["f 1\n", "", "f \u{1a} 1"] {
            assert_eq!(without_end_mark(text.as_bytes()), text.as_bytes());
        }
    }
}
