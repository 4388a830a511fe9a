//! The language that the viewer speaks: its texts, numbers and titles.

use super::model::Model;
use super::search;
use crate::log::{Decision, Value};
use crate::report::language::Language;
use crate::report::language::viewer::Viewer;
use crate::report::words;

impl Model {
    /// The viewer's texts.
    pub fn texts(&self) -> &'static Viewer {
        &self.language.texts().viewer
    }

    /// A value as it is shown.
    pub fn value(&self, value: &Value) -> String {
        self.language.value(value, self.numbers)
    }

    /// A colour as it is shown.
    pub fn color(&self, color: [f64; 3]) -> String {
        self.value(&Value::Triple(color))
    }

    /// What a node is.
    pub fn title(&self, node: usize) -> String {
        words::title(self.language, &self.log, &self.tree, node)
    }

    /// A decision as a sentence.
    pub fn decision(&self, decision: &Decision) -> String {
        words::decision(self.language, &self.log.header, decision, self.numbers)
    }

    /// Speaks another language. What is searched for is looked for in its words and numbers.
    pub fn speak(&mut self, language: Language) {
        self.language = language;
        search::renew(self);
    }
}
