//! Paths in a scene as people type them: `objects.sphere.shape.sphere.radius`. What a list holds is named by its `name`, or counted from 0.

use serde_json::Value;

/// Why a value can't be set.
#[derive(Debug, PartialEq, Eq)]
pub enum PathError {
    /// There is no path.
    NoPath,
    /// A step leads nowhere: the path up to it, and what is there instead.
    Unknown { step: String, known: Vec<String> },
}

/// The most paths in a list.
const MAX_LISTED: usize = 1000;

/// Sets the value at a path. Steps may be left out where what is left means one place only: `objects.ball.radius`. A key that is missing is
/// added: whether a scene may have it is the reader's to say.
pub fn set(scene: &mut Value, path: &str, text: &str) -> Result<(), PathError> {
    let whole = if leads(scene, path) { None } else { completed(scene, path) };
    let path = whole.as_deref().unwrap_or(path);
    let mut at = scene;
    let mut rest = path;
    if rest.is_empty() {
        return Err(PathError::NoPath);
    }
    loop {
        let (step, behind) = step(at, rest);
        let unknown =
            || PathError::Unknown { step: path[..path.len() - rest.len() + step.len()].to_owned(), known: names(at) };
        let is_last = behind.is_empty();
        let index = index_of(at, step);
        if index.is_none() && !(is_last && at.is_object()) {
            return Err(unknown());
        }
        let next = match (&mut *at, index) {
            (Value::Object(map), _) => map.entry(step).or_insert(Value::Null),
            (Value::Array(list), Some(index)) => &mut list[index],
            _ => return Err(PathError::NoPath),
        };
        if is_last {
            *next = value(text);
            return Ok(());
        }
        (at, rest) = (next, behind);
    }
}

/// Whether something is at a path.
fn leads(scene: &Value, path: &str) -> bool {
    let (mut at, mut rest) = (scene, path);
    while !rest.is_empty() {
        let (step, behind) = step(at, rest);
        let next = index_of(at, step).and_then(|index| match at {
            Value::Object(map) => map.values().nth(index),
            Value::Array(list) => list.get(index),
            _ => None,
        });
        let Some(next) = next else { return false };
        (at, rest) = (next, behind);
    }
    true
}

/// The only path that has these steps, with others in between.
fn completed(scene: &Value, path: &str) -> Option<String> {
    let only = |path: &str| {
        let is_meant = |found: &str| {
            let mut own = found.split('.');
            path.split('.').all(|step| own.any(|own| own == step)) && own.next().is_none()
        };
        let mut found = list(scene, path).into_iter().map(|(found, _)| found).filter(|found| is_meant(found));
        found.next().filter(|_| found.next().is_none())
    };
    // Paths end at vectors, of which a component may be meant.
    let of_component = || {
        let (vector, letter) = path.rsplit_once('.')?;
        let whole = only(vector)?;
        Some(format!("{whole}.{letter}")).filter(|whole| leads(scene, whole))
    };
    only(path).or_else(of_component)
}

/// The first step of a path and the rest behind its dot. Names may have dots, so the longest that is there counts.
fn step<'p>(at: &Value, path: &'p str) -> (&'p str, &'p str) {
    let ends = path.match_indices('.').map(|(end, _)| end).chain([path.len()]);
    let end = ends.clone().rfind(|end| index_of(at, &path[..*end]).is_some());
    let end = end.or_else(|| ends.clone().next()).unwrap_or(path.len());
    (&path[..end], path.get(end + 1..).unwrap_or_default())
}

/// Where in an object or a list something is.
fn index_of(at: &Value, step: &str) -> Option<usize> {
    match at {
        Value::Object(map) => map.keys().position(|key| key == step),
        Value::Array(list) => {
            let named = list.iter().position(|item| name(item) == Some(step));
            let index = || step.parse().ok().or_else(|| component(list, step));
            named.or_else(|| index().filter(|index| *index < list.len()))
        }
        _ => None,
    }
}

/// The component of a point or colour that a letter stands for.
fn component(list: &[Value], letter: &str) -> Option<usize> {
    let is_vector = list.len() == 3 && list.iter().all(Value::is_number);
    ["x", "y", "z"].iter().zip(["r", "g", "b"]).position(|(x, r)| is_vector && (*x == letter || r == letter))
}

fn name(item: &Value) -> Option<&str> {
    item.get("name")?.as_str()
}

/// What an object or a list has.
fn names(at: &Value) -> Vec<String> {
    match at {
        Value::Object(map) => map.keys().cloned().collect(),
        Value::Array(list) => list.iter().enumerate().map(|(index, item)| label(index, item)).collect(),
        _ => Vec::new(),
    }
}

fn label(index: usize, item: &Value) -> String {
    name(item).map_or_else(|| index.to_string(), str::to_owned)
}

/// The value in a text: JSON, numbers with blanks, commas or semicolons between them (these in languages with decimal commas), or a word.
fn value(text: &str) -> Value {
    if let Ok(value) = serde_json::from_str(text) {
        return value;
    }
    let text = &if text.contains(';') { text.replace(',', ".").replace(';', " ") } else { text.to_owned() };
    let numbers: Option<Vec<f64>> = text
        .trim_matches(['(', ')', '[', ']'])
        .split([',', ' '])
        .filter(|part| !part.is_empty())
        .map(|part| part.parse().ok().filter(|number: &f64| number.is_finite()))
        .collect();
    match numbers {
        Some(numbers) if numbers.len() > 1 => numbers.into(),
        _ => text.as_str().into(),
    }
}

/// The paths that begin so, with their values, at most [`MAX_LISTED`]. Where none does, those that have the same steps with others in
/// between: `objects.sphere.ra` for `objects.sphere.shape.sphere.radius`.
pub fn list(scene: &Value, beginning: &str) -> Vec<(String, String)> {
    let mut found = Vec::new();
    collect(scene, String::new(), beginning, &mut found);
    if found.is_empty() {
        let (first, _) = beginning.split_once('.').unwrap_or((beginning, ""));
        collect(scene, String::new(), first, &mut found);
        found.retain(|(path, _)| has_steps(path, beginning));
    }
    found
}

/// Whether a path has steps that begin as these do, in this order.
fn has_steps(path: &str, steps: &str) -> bool {
    let mut own = path.split('.');
    steps.split('.').all(|step| own.any(|own| own.starts_with(step)))
}

fn collect(at: &Value, path: String, beginning: &str, found: &mut Vec<(String, String)>) {
    let common = path.len().min(beginning.len());
    if found.len() == MAX_LISTED || path.as_bytes()[..common] != beginning.as_bytes()[..common] {
        return;
    }
    let inside = |step: &str| if path.is_empty() { step.to_owned() } else { format!("{path}.{step}") };
    match at {
        Value::Object(map) if !map.is_empty() => {
            map.iter()
                .filter(|(key, _)| *key != "format")
                .for_each(|(key, item)| collect(item, inside(key), beginning, found));
        }
        Value::Array(list) if list.iter().any(|item| item.is_object()) => {
            for (index, item) in list.iter().enumerate() {
                collect(item, inside(&label(index, item)), beginning, found);
            }
        }
        leaf if path.starts_with(beginning) => found.push((path, leaf.to_string())),
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn scene() -> Value {
        json!({
            "format": "raywalk-scene/1",
            "objects": [
                {"name": "ball", "shape": {"sphere": {"center": [1, 2, 3], "radius": 2}}},
                {"name": "a.b", "shape": {"plane": {"coefficients": [0, 1, 0, 0]}}},
            ],
            "tracing": {"algorithm": "recursive"},
        })
    }

    #[track_caller]
    fn sets(path: &str, text: &str, place: &str, expected: Value) {
        let mut changed = scene();
        assert_eq!(set(&mut changed, path, text), Ok(()), "{path}");
        assert_eq!(changed.pointer(place), Some(&expected), "{path}");
    }

    #[test]
    fn values_are_set_by_names_and_by_numbers() {
        sets("objects.ball.shape.sphere.radius", "2.5", "/objects/0/shape/sphere/radius", json!(2.5));
        sets("objects.0.shape.sphere.radius", "2.5", "/objects/0/shape/sphere/radius", json!(2.5));
        sets("objects.ball.shape.sphere.center.1", "7", "/objects/0/shape/sphere/center/1", json!(7));
        sets(
            "objects.ball.shape.sphere.center",
            "(1, 2.5, -3)",
            "/objects/0/shape/sphere/center",
            json!([1.0, 2.5, -3.0]),
        );
        sets(
            "objects.a.b.shape.plane.coefficients",
            "0 0 1 4",
            "/objects/1/shape/plane/coefficients",
            json!([0.0, 0.0, 1.0, 4.0]),
        );
        // A vector as it is shown in Spanish, a component by its letter, and paths with steps left out.
        sets(
            "objects.ball.shape.sphere.center",
            "(1; 2,5; -3)",
            "/objects/0/shape/sphere/center",
            json!([1.0, 2.5, -3.0]),
        );
        sets("objects.ball.shape.sphere.center.y", "7", "/objects/0/shape/sphere/center/1", json!(7));
        sets("objects.ball.center.z", "7", "/objects/0/shape/sphere/center/2", json!(7));
        sets("objects.ball.radius", "7", "/objects/0/shape/sphere/radius", json!(7));
        sets("objects.ball.material", "glass", "/objects/0/material", json!("glass"));
        sets("tracing.algorithm", "foley", "/tracing/algorithm", json!("foley"));
        sets("tracing.max_depth", "3", "/tracing/max_depth", json!(3));
        sets("sampling", r#"{"regular": {"n": 3}}"#, "/sampling/regular/n", json!(3));
    }

    #[test]
    fn a_step_that_leads_nowhere_says_what_is_there() {
        let known = |path: &str| match set(&mut scene(), path, "1") {
            Err(PathError::Unknown { step, known }) => (step, known.join(" ")),
            other => panic!("{path}: {other:?}"),
        };
        assert_eq!(known("objects.bal.shape"), ("objects.bal".to_owned(), "ball a.b".to_owned()));
        assert_eq!(known("objects.2"), ("objects.2".to_owned(), "ball a.b".to_owned()));
        assert_eq!(known("object.ball.x"), ("object".to_owned(), "format objects tracing".to_owned()));
        assert_eq!(known("tracing.algorithm.x").1, "");
        assert_eq!(set(&mut scene(), "", "1"), Err(PathError::NoPath));
    }

    #[test]
    fn paths_are_listed_with_their_values() {
        let listed = list(&scene(), "objects.b");
        assert_eq!(
            listed,
            [
                ("objects.ball.name", "\"ball\""),
                ("objects.ball.shape.sphere.center", "[1,2,3]"),
                ("objects.ball.shape.sphere.radius", "2")
            ]
            .map(|(path, value)| (path.to_owned(), value.to_owned()))
        );
        // Steps in between may be left out.
        let paths = |beginning: &str| list(&scene(), beginning).into_iter().map(|(path, _)| path).collect::<Vec<_>>();
        assert_eq!(paths("objects.ball.ra"), ["objects.ball.shape.sphere.radius"]);
        assert_eq!(paths("obj.center"), ["objects.ball.shape.sphere.center"]);
        assert!(paths("objects.ball.x").is_empty());
        // Each of them leads to its value.
        for (path, value) in list(&scene(), "") {
            let mut same = scene();
            set(&mut same, &path, &value).expect("a path that was listed");
            assert_eq!(same, scene(), "{path}");
        }
    }
}
