//! The files of cases: `{"family": …, "op": …, "cases": [{"id", "in", "out", "cond"?}, …]}`, with a `mesh` that all cases share
//! where the operation is `mesh`.

use super::question::MeshData;
use serde::Deserialize;
use serde_json::{Map, Value};

/// A family of cases.
#[derive(Clone, Debug, Deserialize)]
pub struct Family {
    /// Its name; what precedes the first `_` picks what is required of it.
    pub family: String,
    /// What is to be done with each case, unless the case says so itself.
    pub op: String,
    /// The mesh that all cases share.
    #[serde(default)]
    pub(super) mesh: Option<MeshData>,
    /// The cases.
    pub cases: Vec<Case>,
}

/// A case: numbers that go in, and the exact answers.
#[derive(Clone, Debug, Deserialize)]
pub struct Case {
    /// Its name, unique in its family.
    pub id: String,
    /// What goes in.
    #[serde(rename = "in")]
    pub input: Map<String, Value>,
    /// The exact answers, decimal numbers as strings.
    pub out: Map<String, Value>,
    /// The condition number: by how much relative errors of the input are magnified.
    #[serde(default)]
    pub cond: Option<f64>,
}

/// Reads a file of cases. The message of an error has the place in the file.
pub fn parse(text: &[u8]) -> Result<Family, String> {
    let mut reader = serde_json::Deserializer::from_slice(text);
    let family: Family = serde_path_to_error::deserialize(&mut reader).map_err(|error| {
        let path = error.path().to_string();
        let inner = error.into_inner();
        format!("{path}: {inner}")
    })?;
    reader.end().map_err(|error| error.to_string())?;
    Ok(family)
}
