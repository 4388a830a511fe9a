//! The program's source text as the architecture tests read it: without comments, strings and test modules.

// Each test file compiles this for itself and uses a part of it.
#![allow(dead_code)]

use std::fs;
use std::path::{Path, PathBuf};

/// A source file.
pub struct SourceFile {
    /// Its path below the folder that was read, such as `trace/bounce.rs`.
    pub path: String,
    /// Its lines as they are in the file.
    pub lines: usize,
    /// Its code: comments, the contents of strings and test modules are blank.
    pub code: String,
    /// The same, byte for byte, with the contents of strings.
    pub with_strings: String,
    /// The modules with files of their own that it declares for tests only.
    test_modules: Vec<String>,
}

/// The source files of the program itself, sorted by path: all below `src` but those of test modules.
pub fn program() -> Vec<SourceFile> {
    let mut files = files_below("src");
    let declared = |file: &SourceFile| {
        let module = file.module().join("/");
        file.test_modules.iter().map(|name| format!("{module}/{name}")).collect::<Vec<_>>()
    };
    let for_tests: Vec<_> = files.iter().flat_map(declared).collect();
    files.retain(|file| {
        let module = file.module().join("/");
        !for_tests
            .iter()
            .any(|test| module.strip_prefix(test).is_some_and(|rest| rest.is_empty() || rest.starts_with('/')))
    });
    files
}

/// All source files below a folder of the package, sorted by path.
pub fn files_below(folder: &str) -> Vec<SourceFile> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let mut found = Vec::new();
    find(&root, &mut found);
    found.sort();
    let read = |path: &PathBuf| {
        let text = fs::read_to_string(path).expect("a source file can be read");
        let below = path.strip_prefix(&root).expect("the file was found below the root");
        SourceFile::new(below.to_string_lossy().replace('\\', "/"), &text)
    };
    found.iter().map(read).collect()
}

fn find(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a source folder can be read") {
        let path = entry.expect("an entry of a source folder can be read").path();
        if path.is_dir() {
            find(&path, found);
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            found.push(path);
        }
    }
}

impl SourceFile {
    /// A file with this text.
    pub fn new(path: String, text: &str) -> SourceFile {
        let mut code = text.as_bytes().to_vec();
        let mut with_strings = code.clone();
        blank_comments_and_strings(&mut code, &mut with_strings);
        let test_modules = blank_tests(&mut code, &mut with_strings);
        let text_of = |bytes| String::from_utf8(bytes).expect("only whole characters were blanked");
        let (code, with_strings) = (text_of(code), text_of(with_strings));
        SourceFile { path, lines: text.lines().count(), code, with_strings, test_modules }
    }

    /// The module that the file is, such as `["trace", "bounce"]`.
    pub fn module(&self) -> Vec<&str> {
        let path = self.path.strip_suffix(".rs").unwrap_or(&self.path);
        let path = path.strip_suffix("mod").map_or(path, |folder| folder.trim_end_matches('/'));
        path.split('/').filter(|part| !part.is_empty() && *part != "lib" && *part != "main").collect()
    }

    /// Where each occurrence of `text` begins in the code. A `text` that begins or ends with a letter is not found inside
    /// longer words.
    pub fn find<'s>(&'s self, text: &'s str) -> impl Iterator<Item = usize> + 's {
        let is_word = |c: char| c.is_alphanumeric() || c == '_';
        let starts_word = text.starts_with(is_word);
        let ends_word = text.ends_with(is_word);
        self.code.match_indices(text).map(|(at, _)| at).filter(move |at| {
            let goes_on_before = starts_word && self.code[..*at].ends_with(is_word);
            let goes_on_behind = ends_word && self.code[at + text.len()..].starts_with(is_word);
            !goes_on_before && !goes_on_behind
        })
    }

    /// What is between the quotes of each string of the code, as it is written there, with its place.
    pub fn strings(&self) -> Vec<(usize, &str)> {
        // Of the contents of strings and characters the code keeps nothing, and so no quote but those around strings.
        let quotes: Vec<usize> = self.code.match_indices('"').map(|(at, _)| at).collect();
        let between = |ends: &[usize]| ends.get(1).map(|end| (ends[0], &self.with_strings[ends[0] + 1..*end]));
        quotes.chunks(2).filter_map(between).collect()
    }

    /// A place of the file for a message.
    pub fn place(&self, at: usize) -> String {
        let line = self.code[..at].matches('\n').count() + 1;
        format!("{}:{line}", self.path)
    }

    /// The absolute paths of everything that the code names through `crate`, `super` and the package's own name, each with
    /// its place. Groups in braces are resolved to each of their paths.
    pub fn imports(&self) -> Vec<(usize, Vec<String>)> {
        let module = self.module();
        let parent = &module[..module.len().saturating_sub(1)];
        self.paths_through(&[("crate", &[]), ("raywalk", &[]), ("super", parent)])
    }

    /// The same, and what the code names through the modules that it declares.
    pub fn named_paths(&self) -> Vec<(usize, Vec<String>)> {
        let mut paths = self.imports();
        for at in self.find("mod") {
            let declared = self.code[at + "mod".len()..].split_once(';').map_or("", |(name, _)| name.trim());
            if !declared.is_empty() && declared.chars().all(|c| c.is_alphanumeric() || c == '_') {
                let module = [&self.module()[..], &[declared]].concat();
                let is_path = |(at, _): &(usize, Vec<String>)| {
                    self.code[at + declared.len()..].starts_with("::") && !self.code[..*at].ends_with("::")
                };
                paths.extend(self.paths_through(&[(declared, &module)]).into_iter().filter(is_path));
            }
        }
        paths
    }

    /// Whether the path that begins here is that of a `use`.
    pub fn is_use(&self, at: usize) -> bool {
        self.code[..at].trim_end().ends_with("use")
    }

    /// The same of one that others may name, too.
    pub fn is_public_use(&self, at: usize) -> bool {
        let before = self.code[..at].trim_end().strip_suffix("use").map(str::trim_end);
        self.is_use(at) && before.is_some_and(|before| before.ends_with("pub") || before.ends_with(')'))
    }

    /// The paths that begin with one of these words, each of which stands for a module.
    fn paths_through(&self, roots: &[(&str, &[&str])]) -> Vec<(usize, Vec<String>)> {
        let of_root = |(root, base)| self.find(root).map(move |at| (at, root, base)).collect::<Vec<_>>();
        let mut starts: Vec<(usize, &str, &[&str])> = roots.iter().copied().flat_map(of_root).collect();
        starts.sort_unstable();
        let mut imports = Vec::new();
        let mut done = 0;
        for (at, root, base) in starts {
            // A path may have taken the next `super` already.
            if at >= done {
                let base: Vec<_> = base.iter().map(|part| (*part).to_owned()).collect();
                done = self.paths_from(at + root.len(), &base, at, &mut imports);
            }
        }
        imports
    }

    /// The paths that go on behind `from`, which is in the module `base`.
    fn paths_from(&self, from: usize, base: &[String], at: usize, imports: &mut Vec<(usize, Vec<String>)>) -> usize {
        let mut path = base.to_vec();
        let mut position = from;
        loop {
            let rest = &self.code[position..];
            let Some(behind) = rest.trim_start().strip_prefix("::") else {
                imports.push((at, path));
                return position;
            };
            let behind = behind.trim_start();
            position = self.code.len() - behind.len();
            if behind.starts_with('{') {
                return self.group_from(position + 1, &path, at, imports);
            }
            position = self.step(position, &mut path);
        }
    }

    /// The paths of a group in braces; gives the place behind the closing brace.
    fn group_from(&self, from: usize, base: &[String], at: usize, imports: &mut Vec<(usize, Vec<String>)>) -> usize {
        let mut position = from;
        loop {
            let rest = self.code[position..].trim_start_matches(|c: char| c.is_whitespace() || c == ',');
            position = self.code.len() - rest.len();
            if rest.is_empty() || rest.starts_with('}') {
                return self.code.len().min(position + 1);
            }
            let mut path = base.to_vec();
            position = self.step(position, &mut path);
            position = self.paths_from(position, &path, at, imports);
            // What is left of it, such as `as name` and `*`, is no path.
            position += self.code[position..].find([',', '}']).unwrap_or(self.code.len() - position);
        }
    }

    /// Takes one word of a path; gives the place behind it.
    fn step(&self, position: usize, path: &mut Vec<String>) -> usize {
        let rest = &self.code[position..];
        let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
        match &rest[..end] {
            "super" => {
                path.pop();
            }
            "self" | "" => {}
            word => path.push(word.to_owned()),
        }
        position + end
    }
}

/// Blanks comments in both texts, and the contents of strings in the code.
fn blank_comments_and_strings(code: &mut [u8], with_strings: &mut [u8]) {
    let mut at = 0;
    while at < code.len() {
        let rest = &code[at..];
        if rest.starts_with(b"//") {
            let end = at + rest.iter().position(|byte| *byte == b'\n').unwrap_or(rest.len());
            blank(&mut code[at..end]);
            blank(&mut with_strings[at..end]);
            at = end;
        } else if rest.starts_with(b"/*") {
            let end = at + end_of_block_comment(rest);
            blank(&mut code[at..end]);
            blank(&mut with_strings[at..end]);
            at = end;
        } else if let Some((open, close)) = string_ahead(rest, at.checked_sub(1).map(|before| code[before])) {
            blank(&mut code[at + open..at + close]);
            at += close + 1;
        } else {
            at += 1;
        }
    }
}

fn end_of_block_comment(text: &[u8]) -> usize {
    let (mut depth, mut at) = (0, 0);
    while at < text.len() {
        match &text[at..] {
            [b'/', b'*', ..] => (depth, at) = (depth + 1, at + 2),
            [b'*', b'/', ..] if depth == 1 => return at + 2,
            [b'*', b'/', ..] => (depth, at) = (depth - 1, at + 2),
            _ => at += 1,
        }
    }
    text.len()
}

/// Where the contents of a string or character begin and end that starts here. A lifetime is neither.
fn string_ahead(text: &[u8], before: Option<u8>) -> Option<(usize, usize)> {
    let is_inside_word = before.is_some_and(|byte| byte.is_ascii_alphanumeric() || byte == b'_');
    match text {
        [b'r', b'"' | b'#', ..] if !is_inside_word => {
            let hashes = text[1..].iter().take_while(|byte| **byte == b'#').count();
            let open = 2 + hashes;
            if text.get(open - 1) != Some(&b'"') {
                return None;
            }
            let close = [&b"\""[..], &b"#".repeat(hashes)].concat();
            let length = text[open..].windows(close.len()).position(|window| window == close)?;
            Some((open, open + length))
        }
        [b'"', ..] => Some((1, 1 + end_of_quoted(&text[1..], b'"')?)),
        [b'\'', b'\\', ..] => Some((1, 1 + end_of_quoted(&text[1..], b'\'')?)),
        [b'\'', first, ..] => {
            let length = match first.leading_ones() {
                0 => 1,
                ones => ones as usize,
            };
            (text.get(1 + length) == Some(&b'\'')).then_some((1, 1 + length))
        }
        _ => None,
    }
}

fn end_of_quoted(text: &[u8], quote: u8) -> Option<usize> {
    let mut at = 0;
    while *text.get(at)? != quote {
        at += if text[at] == b'\\' { 2 } else { 1 };
    }
    Some(at)
}

/// Blanks what follows `#[cfg(test)]` in both texts, up to its closing brace or its semicolon; gives the names of the
/// modules among it that have files of their own.
fn blank_tests(code: &mut [u8], with_strings: &mut [u8]) -> Vec<String> {
    const MARK: &[u8] = b"#[cfg(test)]";
    let mut modules = Vec::new();
    while let Some(start) = code.windows(MARK.len()).position(|window| window == MARK) {
        let mut depth = 0;
        let ends_here = |byte: &u8| {
            match byte {
                b'{' => depth += 1,
                b'}' => depth -= 1,
                _ => {}
            }
            depth == 0 && matches!(byte, b'}' | b';')
        };
        let end = code[start..].iter().position(ends_here).map_or(code.len(), |length| start + length + 1);
        let declaration = String::from_utf8_lossy(&code[start..end]).into_owned();
        let module = declaration.strip_suffix(';').and_then(|text| text.split_once("mod "));
        modules.extend(module.map(|(_, name)| name.trim().to_owned()));
        blank(&mut code[start..end]);
        blank(&mut with_strings[start..end]);
    }
    modules
}

fn blank(text: &mut [u8]) {
    for byte in text.iter_mut().filter(|byte| **byte != b'\n') {
        *byte = b' ';
    }
}
