//! Prints a scene as people write it: what fits on a line is on one line, and 1 is `1`, not `1.0`.

use super::schema::{Materials, SceneFile};
use super::syntax::Reader;
use crate::files::escape::escape_hidden_json;
use serde::Serialize;
use std::io::{self, Write};

/// The longest line that is not broken up.
const WIDTH: usize = 100;

/// Lists of this many items are printed item by item, so that the text of a million objects isn't in memory as a whole. They never fit on a line.
const LONG: usize = 1 << 10;

impl SceneFile {
    /// The scene as `raywalk-scene/1`, every default written out but those that depend on the arithmetic; ends with a newline. Reading it
    /// gives an equal scene.
    pub fn to_json(&self) -> String {
        let mut printed = Vec::new();
        self.write_json(&mut printed).expect("memory takes all that is written to it");
        String::from_utf8(printed).expect("JSON is written as UTF-8")
    }

    /// Writes what [`SceneFile::to_json`] gives.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_json(&self, out: &mut impl Write) -> io::Result<()> {
        let are_long = [self.materials.len(), self.objects.len()].map(|count| count >= LONG);
        if are_long == [false; 2] {
            return out.write_all(self.printed().as_bytes());
        }
        let text = SceneFile {
            format: self.format.clone(),
            name: self.name.clone(),
            camera: self.camera.clone(),
            lights: self.lights.clone(),
            materials: if are_long[0] { Materials::default() } else { self.materials.clone() },
            objects: if are_long[1] { Vec::new() } else { self.objects.clone() },
            ..*self
        }
        .printed();
        // At the beginning of a line of this depth are keys of the scene alone: in strings there are no ends of lines.
        let (materials, objects) = ("\n  \"materials\": {", "\n  \"objects\": [");
        let mut rest = &text[..];
        if let (true, Some(at)) = (are_long[0], rest.find(materials)) {
            let (before, after) = rest.split_at(at + materials.len());
            out.write_all(before.as_bytes())?;
            for (number, (name, material)) in self.materials.iter().enumerate() {
                write_item(out, number, Some(name), material)?;
            }
            out.write_all(b"\n  ")?;
            rest = after;
        }
        if let (true, Some(at)) = (are_long[1], rest.find(objects)) {
            let (before, after) = rest.split_at(at + objects.len());
            out.write_all(before.as_bytes())?;
            for (number, object) in self.objects.iter().enumerate() {
                write_item(out, number, None, object)?;
            }
            out.write_all(b"\n  ")?;
            rest = after;
        }
        out.write_all(rest.as_bytes())
    }

    /// The same, at once.
    fn printed(&self) -> String {
        let mut compact = compact(self);
        if self.tracing.sphere_method.is_none() {
            // Written out, it would no longer follow the formulas. Inside a string the quotes would be escaped, so this is the key.
            compact = compact.replacen("\"sphere_method\":\"robust\",", "", 1);
        }
        let mut printer = Printer { text: &compact, reader: Reader::new(&compact), printed: String::new() };
        printer.value(0, 0, true);
        printer.printed.push('\n');
        // The path of a mesh may hold what drives a terminal; the names of a scene may not.
        escape_hidden_json(&printer.printed).into_owned()
    }
}

fn compact(part: &impl Serialize) -> String {
    serde_json::to_string(part).expect("a scene holds only strings, numbers, lists and string-keyed maps")
}

/// Writes one of a list of a scene, as [`Printer::container`] prints it there.
fn write_item(out: &mut impl Write, number: usize, key: Option<&str>, item: &impl Serialize) -> io::Result<()> {
    const INDENT: usize = 4;
    let compact = compact(item);
    let key = key.map(|key| format!("{}: ", self::compact(&key))).unwrap_or_default();
    let mut printer = Printer { text: &compact, reader: Reader::new(&compact), printed: String::new() };
    printer.value(INDENT, INDENT + 1 + key.len(), false);
    let separator = if number == 0 { "\n" } else { ",\n" };
    let (key, value) = (escape_hidden_json(&key), escape_hidden_json(&printer.printed));
    write!(out, "{separator}{:INDENT$}{key}{value}", "")
}

struct Printer<'t> {
    text: &'t str,
    reader: Reader<'t>,
    printed: String,
}

impl Printer<'_> {
    /// Prints the next value; `used` is what is already on its line.
    fn value(&mut self, indent: usize, used: usize, is_root: bool) {
        let is_container = matches!(self.reader.peek(), Some(b'{' | b'['));
        let start = self.reader.at;
        let compact = &self.text[self.reader.value().expect("serde_json writes JSON alone")];
        let may_fit = !is_container || (compact.len() <= 2 * WIDTH && !is_root);
        match may_fit.then(|| one_line(compact)).filter(|line| !is_container || line.len() + used <= WIDTH) {
            Some(line) => self.printed.push_str(&line),
            None => {
                self.reader.at = start;
                self.container(indent);
            }
        }
    }

    fn container(&mut self, indent: usize) {
        let is_object = self.reader.peek() == Some(b'{');
        let (open, close) = if is_object { ('{', '}') } else { ('[', ']') };
        self.reader.open().expect("serde_json writes JSON alone");
        self.printed.push(open);
        let inner = indent + 2;
        let mut separator = "\n";
        while self.reader.next(close as u8, separator == "\n").expect("serde_json writes JSON alone") {
            self.printed.push_str(separator);
            self.printed.push_str(&" ".repeat(inner));
            let mut used = inner + 1;
            if is_object {
                let key = &self.text[self.reader.key().expect("serde_json writes JSON alone")];
                self.printed.push_str(key);
                self.printed.push_str(": ");
                used += key.len() + 2;
            }
            self.value(inner, used, false);
            separator = ",\n";
        }
        self.printed.push('\n');
        self.printed.push_str(&" ".repeat(indent));
        self.printed.push(close);
    }
}

/// A compact value with a space after each comma and colon, and whole numbers without `.0`.
fn one_line(compact: &str) -> String {
    let mut reader = Reader::new(compact);
    let mut line = String::with_capacity(compact.len() + compact.len() / 4);
    while let Some(byte) = reader.peek() {
        match byte {
            b',' | b':' => {
                line.extend([char::from(byte), ' ']);
                reader.at += 1;
            }
            b'{' | b'[' | b'}' | b']' => {
                line.push(char::from(byte));
                reader.at += 1;
            }
            _ => {
                let word = &compact[reader.value().expect("serde_json writes JSON alone")];
                let whole = word.strip_suffix(".0").filter(|_| byte != b'"');
                line.push_str(whole.unwrap_or(word));
            }
        }
    }
    line
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Item by item the same is written as at once.
    #[test]
    fn long_lists_are_written_as_short_ones_are() {
        let text = r#"{"format": "raywalk-scene/1", "camera": {"position": [0, 0, 5], "direction": [0, 0, -1], "resolution": [4, 3]},
            "name": "\"objects\": [", "objects": [{"name": "a", "shape": {"mesh": {"path": "\u202ea.obj"}}}], "materials": {"m\u202e\"": {}}}"#;
        let mut scene = crate::scene::file::parse(text.as_bytes(), "a.json").expect("a scene");
        let (object, material) = (scene.objects[0].clone(), scene.materials.get("m\u{202e}\"").expect("it").clone());
        for [objects, materials] in [[1, LONG], [LONG, 1], [LONG, LONG + 3], [LONG, 0]] {
            scene.objects = vec![object.clone(); objects];
            scene.materials = Materials::default();
            for number in 0..materials {
                scene.materials.insert(&format!("\"\u{202e}{number}"), material.clone());
            }
            assert!(scene.to_json() == scene.printed(), "{objects} objects, {materials} materials");
        }
    }
}
