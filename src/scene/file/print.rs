//! Prints a scene as people write it: what fits on a line stands on one line, and 1 is `1`, not `1.0`.

use super::escape::visible_json;
use super::scan::Scanner;
use super::schema::SceneFile;

/// The longest line that is not broken up.
const WIDTH: usize = 100;

impl SceneFile {
    /// The scene as `raywalk-scene/1`, every default written out but those that hang on the arithmetic; ends with a newline. Reading it
    /// gives an equal scene.
    pub fn to_json(&self) -> String {
        let mut compact =
            serde_json::to_string(self).expect("a scene holds only strings, numbers, lists and string-keyed maps");
        if self.tracing.sphere_method.is_none() {
            // Written out, it would no longer follow the formulas. Inside a string the quotes would be escaped, so this is the key.
            compact = compact.replacen("\"sphere_method\":\"robust\",", "", 1);
        }
        let mut printer = Printer { text: &compact, scanner: Scanner::new(&compact), printed: String::new() };
        printer.value(0, 0, true);
        printer.printed.push('\n');
        // The path of a mesh may hold what drives a terminal; the names of a scene may not.
        visible_json(&printer.printed).into_owned()
    }
}

struct Printer<'t> {
    text: &'t str,
    scanner: Scanner<'t>,
    printed: String,
}

impl Printer<'_> {
    /// Prints the next value; `used` is what already stands on its line.
    fn value(&mut self, indent: usize, used: usize, is_root: bool) {
        let start = self.scanner.at;
        match self.scanner.peek() {
            Some(b'{' | b'[') => {
                let compact = &self.text[self.scanner.skip_value()];
                let may_fit = compact.len() <= 2 * WIDTH && !is_root;
                match may_fit.then(|| one_line(compact)).filter(|line| line.len() + used <= WIDTH) {
                    Some(line) => self.printed.push_str(&line),
                    None => {
                        self.scanner.at = start;
                        self.container(indent);
                    }
                }
            }
            _ => {
                let range = self.scanner.skip_value();
                self.printed.push_str(&one_line(&self.text[range]));
            }
        }
    }

    fn container(&mut self, indent: usize) {
        let is_object = self.scanner.take(b'{');
        let (open, close) = if is_object { ('{', '}') } else { ('[', ']') };
        self.scanner.take(b'[');
        self.printed.push(open);
        let inner = indent + 2;
        let mut separator = "\n";
        while !matches!(self.scanner.peek(), None | Some(b'}' | b']')) {
            self.printed.push_str(separator);
            self.printed.push_str(&" ".repeat(inner));
            let mut used = inner + 1;
            if is_object {
                let start = self.scanner.at;
                self.scanner.skip_string();
                let key = &self.text[start..self.scanner.at];
                self.scanner.take(b':');
                self.printed.push_str(key);
                self.printed.push_str(": ");
                used += key.len() + 2;
            }
            self.value(inner, used, false);
            self.scanner.take(b',');
            separator = ",\n";
        }
        self.scanner.take(close as u8);
        self.printed.push('\n');
        self.printed.push_str(&" ".repeat(indent));
        self.printed.push(close);
    }
}

/// A compact value with a space after each comma and colon, and whole numbers without `.0`.
fn one_line(compact: &str) -> String {
    let mut scanner = Scanner::new(compact);
    let mut line = String::with_capacity(compact.len() + compact.len() / 4);
    while let Some(byte) = scanner.peek() {
        let start = scanner.at;
        match byte {
            b',' | b':' => {
                line.push(char::from(byte));
                line.push(' ');
                scanner.at += 1;
            }
            b'{' | b'[' | b'}' | b']' => {
                line.push(char::from(byte));
                scanner.at += 1;
            }
            _ => {
                scanner.skip_value();
                let word = &compact[start..scanner.at];
                let is_string = byte == b'"';
                let whole = word.strip_suffix(".0").filter(|_| !is_string);
                line.push_str(whole.unwrap_or(word));
            }
        }
    }
    line
}
