//! The walk along a text that is to be a scene: what is wrong about its form, and a copy in which that is mended.

use std::borrow::Cow;
use std::collections::HashSet;
use std::ops::Range;

use super::part::{Part, quoted};
use super::syntax::{Broken, Reader, decoded};
use crate::files::escape::{QUOTED, quoted as shown, shortened};
use crate::files::{KeyPath, Step, suggest, unknown};

/// How many mistakes of form are kept, of which the first are shown. Where there are more, the numbers aren't checked.
pub const MAX_MISTAKES: usize = 1 << 10;

/// Something wrong, and where.
#[derive(PartialEq)]
pub struct Mistake {
    pub span: Range<usize>,
    pub path: KeyPath,
    pub message: String,
}

/// The way along a text.
pub struct Walk<'t> {
    pub text: &'t str,
    pub reader: Reader<'t>,
    /// The way to where it is.
    pub path: KeyPath,
    /// What is wrong so far.
    pub mistakes: Vec<Mistake>,
    /// How much more there is.
    pub omitted: usize,
    /// A text without mistakes of form.
    pub mended: String,
    /// Where it holds something that the text doesn't say.
    pub stand_ins: Vec<KeyPath>,
    /// The reader accepted the form of the text up to here.
    accepted: usize,
}

/// Where a value begins, in the text and in the copy.
#[derive(Clone, Copy)]
struct Start {
    text: usize,
    copy: usize,
}

impl<'t> Walk<'t> {
    /// Begins at the first byte of a text of which the reader accepted so much.
    pub fn new(text: &'t str, accepted: usize) -> Self {
        let (mistakes, stand_ins) = (Vec::new(), Vec::new());
        let mended = String::with_capacity(text.len());
        Self {
            text,
            reader: Reader::new(text),
            path: KeyPath::default(),
            mistakes,
            omitted: 0,
            mended,
            stand_ins,
            accepted,
        }
    }

    /// Walks over the next value, which is to be as this part of the schema says.
    pub fn value(&mut self, part: &'static Part) -> Result<(), Broken> {
        let first = self.reader.peek();
        let start = Start { text: self.reader.at, copy: self.mended.len() };
        if part.is_of_words() {
            return self.word(part, start);
        }
        let of_type = part.of_type(first);
        match first {
            _ if !of_type.takes(first) => self.something_else(part, start),
            Some(b'[') => self.array(part, of_type, start),
            Some(b'{') => match &of_type.of_each_name {
                Some(of_each) => self.names(of_each),
                None => self.object(of_type, start),
            },
            _ => {
                let value = self.reader.value()?;
                self.mended.push_str(&self.text[value.clone()]);
                if !of_type.takes_number(&self.text[value]) {
                    self.replace(part, start, None);
                }
                Ok(())
            }
        }
    }

    /// Walks over a value of another type than may be there.
    fn something_else(&mut self, part: &'static Part, start: Start) -> Result<(), Broken> {
        self.reader.value()?;
        self.replace(part, start, None);
        Ok(())
    }

    /// A word of several, alone or as the only key of an object.
    fn word(&mut self, part: &'static Part, start: Start) -> Result<(), Broken> {
        let is_good = match self.reader.peek() {
            Some(b'"') => {
                let value = self.reader.value()?;
                let name = decoded(&self.text[value.clone()]);
                self.mended.push_str(&self.text[value.clone()]);
                match part.words().find(|(word, _)| *word == name) {
                    Some((_, None)) => true,
                    Some(_) => {
                        self.report(value, format!("expected an object, `{{\"{name}\": …}}`, found the word alone"))
                    }
                    None => self.report(value, unknown_word(&name, part)),
                }
            }
            Some(b'{') => self.key_of_several(part, start)?,
            _ => return self.something_else(part, start),
        };
        if !is_good {
            self.put_in(part, start.copy);
        }
        Ok(())
    }

    /// An object whose only key is a word of several; gives whether it is.
    fn key_of_several(&mut self, part: &'static Part, start: Start) -> Result<bool, Broken> {
        let mut count = 0;
        let mut is_good = true;
        self.reader.open()?;
        self.mended.push('{');
        while self.reader.next(b'}', count == 0)? {
            let key = self.reader.key()?;
            let name = decoded(&self.text[key.clone()]);
            count += 1;
            if count > 1 {
                let message = format!("expected an object with exactly one key, found a second one, {}", shown(&name));
                is_good = self.report(key, message);
                self.reader.value()?;
                continue;
            }
            if let Some((word, value)) = part.words().find(|(word, _)| *word == name) {
                self.path.push(word);
                if let Some(value) = value {
                    self.key(&self.text[key]);
                    self.value(value)?;
                } else {
                    let message = "expected the word alone, as a string, found it as a key";
                    is_good = self.report(key, message.to_owned());
                    self.reader.value()?;
                }
            } else {
                self.path.push(name.to_string());
                is_good = self.report(key, unknown_word(&name, part));
                self.reader.value()?;
            }
            self.path.pop();
        }
        self.mended.push('}');
        if count == 0 {
            let message = "expected an object with exactly one key, found none".to_owned();
            return Ok(self.report(start.text..self.reader.at, message));
        }
        Ok(is_good)
    }

    /// An object with the keys of a part.
    fn object(&mut self, part: &'static Part, start: Start) -> Result<(), Broken> {
        let mut there: Vec<Cow<str>> = Vec::new();
        let mut meant = Vec::new();
        let mut is_first = true;
        self.reader.open()?;
        self.mended.push('{');
        while self.reader.next(b'}', is_first)? {
            is_first = false;
            let key = self.reader.key()?;
            let name = decoded(&self.text[key.clone()]);
            let known = part.key(&name);
            self.path.push(known.map_or_else(|| name.to_string().into(), |(known, _)| Step::from(known)));
            if there.contains(&name) {
                self.repeated(key, &name)?;
            } else if let Some((_, value)) = known {
                self.key(&self.text[key]);
                there.push(name);
                self.value(value)?;
            } else {
                let keys = part.keys();
                self.report(key, unknown("key", &name, &keys));
                meant.extend(suggest(&name, keys.iter().copied()));
                self.reader.value()?;
            }
            self.path.pop();
        }
        let whole = start.text..self.reader.at;
        let misspelt = meant.len();
        let exclusive: Vec<&str> = part.exclusive().collect();
        // Where one of those that exclude each other is there, no other was meant.
        let has_one = exclusive.iter().any(|name| there.iter().any(|key| key == name));
        for (number, name) in meant.into_iter().chain(part.required()).enumerate() {
            if there.iter().any(|key| key == name) || (has_one && exclusive.contains(&name)) {
                continue;
            }
            if number >= misspelt {
                self.report(whole.clone(), format!("the key `{name}` is missing, expected it here"));
            }
            self.add(name, part);
            there.push(name.into());
        }
        self.mended.push('}');
        let given: Vec<&str> = exclusive.iter().copied().filter(|name| there.iter().any(|key| key == name)).collect();
        if !exclusive.is_empty() && given.len() != 1 {
            let found =
                if given.is_empty() { "none of them".to_owned() } else { quoted(given.iter().copied()).join(" and ") };
            self.report(
                whole,
                format!("expected exactly one of {}, found {found}", quoted(exclusive.iter().copied()).join(", ")),
            );
            self.put_in(part, start.copy);
        }
        Ok(())
    }

    /// An object whose keys are names.
    fn names(&mut self, of_each: &'static Part) -> Result<(), Broken> {
        let mut there = HashSet::new();
        self.reader.open()?;
        self.mended.push('{');
        while self.reader.next(b'}', there.is_empty())? {
            let key = self.reader.key()?;
            let name = decoded(&self.text[key.clone()]);
            self.path.push(name.to_string());
            if there.contains(&name) {
                self.repeated(key, &name)?;
            } else {
                self.key(&self.text[key]);
                there.insert(name);
                self.value(of_each)?;
            }
            self.path.pop();
        }
        self.mended.push('}');
        Ok(())
    }

    /// A key that was there before: the first counts.
    fn repeated(&mut self, key: Range<usize>, name: &str) -> Result<(), Broken> {
        self.report(key, format!("the key {} occurs twice, expected it once", shown(name)));
        self.reader.value().map(drop)
    }

    /// A list; `part` is what may be in its place, `of_type` the list.
    fn array(&mut self, part: &'static Part, of_type: &'static Part, start: Start) -> Result<(), Broken> {
        let mut count = 0;
        self.reader.open()?;
        self.mended.push('[');
        while self.reader.next(b']', count == 0)? {
            self.path.push(count);
            if of_type.length.is_some_and(|length| count >= length) {
                self.reader.value()?;
            } else {
                self.mended.push_str(if count == 0 { "" } else { "," });
                self.element(of_type.element())?;
            }
            self.path.pop();
            count += 1;
        }
        self.mended.push(']');
        if of_type.length.is_some_and(|length| count != length) {
            self.replace(part, start, Some(count));
        }
        Ok(())
    }

    /// An element of a list. If the reader went on to the next one it has no mistakes of form and is copied as it is.
    fn element(&mut self, part: &'static Part) -> Result<(), Broken> {
        let mut ahead = self.reader;
        if ahead.at < self.accepted
            && let Ok(value) = ahead.value()
        {
            let end = ahead;
            if matches!(ahead.next(b']', false), Ok(true)) && ahead.at <= self.accepted {
                self.mended.push_str(&self.text[value]);
                self.reader = end;
                return Ok(());
            }
        }
        self.value(part)
    }

    /// Reports that the value from `start` to here isn't what was expected, and puts what fits in its place. Of a list it may be the number of
    /// elements that is wrong.
    fn replace(&mut self, part: &'static Part, start: Start, elements: Option<usize>) {
        let value = start.text..self.reader.at;
        let found = match elements {
            Some(count) => format!("{count} elements"),
            None => described(&self.text[value.clone()]),
        };
        self.report(value, format!("expected {}, found {found}", part.in_words()));
        self.put_in(part, start.copy);
    }

    /// Keeps what is wrong at the place where the walk is; gives `false`.
    fn report(&mut self, span: Range<usize>, message: String) -> bool {
        if self.mistakes.len() < MAX_MISTAKES {
            self.mistakes.push(Mistake { span, path: self.path.clone(), message });
        } else {
            self.omitted += 1;
        }
        false
    }

    /// Writes a value that fits in the place of what the copy has from here on.
    fn put_in(&mut self, part: &'static Part, start: usize) {
        self.mended.truncate(start);
        self.mended.push_str(&part.fitting());
        if self.stand_ins.len() < MAX_MISTAKES {
            self.stand_ins.push(self.path.clone());
        }
    }

    /// Writes a key that an object of this part lacks, with a value that fits.
    fn add(&mut self, name: &str, object: &'static Part) {
        let Some((name, value)) = object.key(name) else { return };
        self.key(&format!("\"{name}\""));
        self.path.push(name);
        self.put_in(value, self.mended.len());
        self.path.pop();
    }

    /// Writes a key with its quotes.
    fn key(&mut self, key: &str) {
        self.mended.push_str(if self.mended.ends_with('{') { "" } else { "," });
        self.mended.push_str(key);
        self.mended.push(':');
    }
}

/// What is in the file, in words.
fn described(value: &str) -> String {
    match value.as_bytes().first() {
        Some(b'"') => format!("the string {}", shortened(value, QUOTED)),
        Some(b'[') => "an array".to_owned(),
        Some(b'{') => "an object".to_owned(),
        _ => shortened(value, QUOTED),
    }
}

fn unknown_word(name: &str, part: &Part) -> String {
    unknown("word", name, &part.words().map(|(word, _)| word).collect::<Vec<_>>())
}
