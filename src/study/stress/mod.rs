//! Numerical stability, measured: cases with exact answers go through the program's own kernels, scenes and tracing, and
//! errors are counted in units of the last place or of the case's condition.
//!
//! There is no second implementation here of anything that is measured: the module turns numbers into shapes, scenes and rays,
//! and answers back into numbers.

mod case;
mod decimal;
mod invalid;
mod judge;
mod optics;
mod question;
mod requirement;
mod same;
mod samples;
mod shots;
mod stage;
mod table;
mod watch;
mod way;

pub use case::{Case, Family, parse};
pub use judge::Outcome;
pub use requirement::{Requirement, Unit, requirement};
pub use samples::samples;
pub use table::{Column, Row, Table};
pub use way::Way;

use serde_json::{Map, Value};

/// The answers to the cases of a family, in its order: objects with the keys of the cases' `out`, or the message of an error,
/// which names the case.
///
/// # Errors
/// Where the family's own mesh can't be used.
pub fn answers(family: &Family) -> Result<Vec<Result<Value, String>>, String> {
    answers_by(&Way::OWN, family)
}

/// The same in another arithmetic, by other formulas.
///
/// # Errors
/// Where the family's own mesh can't be used.
pub fn answers_by(way: &Way, family: &Family) -> Result<Vec<Result<Value, String>>, String> {
    let scene = |mesh| shots::mesh_scene(way, mesh);
    let mesh = family.mesh.as_ref().map(scene).transpose().map_err(|error| format!("mesh: {error}"))?;
    let answer = |case: &Case| {
        let input = &case.input;
        let answer = match family.op.as_str() {
            "sphere" | "plane" | "triangle" | "ellipsoid" => shots::one_shape(way, input),
            "spheres" => shots::spheres(way, input),
            "nearest" => shots::nearest(way, input),
            "mesh" => match &mesh {
                Some(scene) => shots::mesh(way, input, scene),
                None => Err("expected a `mesh` beside the cases".to_owned()),
            },
            "visible" => shots::visible(way, input),
            "spawn" => shots::spawn(way, input),
            "refract" => optics::refraction(way, input),
            "refract_hprime" => optics::refraction_and_half(way, input),
            "power" => optics::power_of(way, input),
            "stack" => optics::stack(way, input),
            "local" => optics::local(way, input),
            "scene" => optics::colors(way, input),
            "mean" => optics::mean(input),
            "invalid" => invalid::verdict(input),
            other => Err(format!("unknown operation `{other}`")),
        };
        answer.map(|answer| as_asked(answer, &case.out)).map_err(|error| format!("case `{}`: {error}", case.id))
    };
    Ok(family.cases.iter().map(answer).collect())
}

/// What of an answer is asked for; `id` stands for `ids`.
fn as_asked(answer: Value, out: &Map<String, Value>) -> Value {
    let Value::Object(answer) = answer else { return answer };
    // Beside the hit itself, what a miss or a total reflection has no more than the exact answer.
    let is_asked = |key: &String| out.contains_key(key) || (key == "id" && out.contains_key("ids")) || is_decision(key);
    Value::Object(answer.into_iter().filter(|(key, _)| is_asked(key)).collect())
}

/// What every answer has that can have it.
fn is_decision(key: &str) -> bool {
    matches!(key, "hit" | "tir")
}

/// Answers and judges every case of these families: in the program's own way, which is what is required, and in the others.
pub fn table(families: &[Family], others: &[Way]) -> Result<Table, String> {
    let mut rows = Vec::new();
    for family in families {
        let mut own = judged(&Way::OWN, family)?;
        let mut columns = vec![Vec::new(); own.len()];
        for way in others {
            // Operations come in the order of their first case, whatever the way.
            for (columns, (op, outcomes)) in columns.iter_mut().zip(judged(way, family)?) {
                columns.push(Column::of(way, way.has_a_say_in(op).then_some(&outcomes)));
            }
        }
        rows.extend(
            own.drain(..).zip(columns).map(|((op, outcomes), columns)| Row::of(family, op, &outcomes, columns)),
        );
    }
    Ok(Table { rows })
}

/// What became of the cases of a family in this way, by operation: powers have two, for a number and for an angle.
fn judged<'f>(way: &Way, family: &'f Family) -> Result<Vec<(&'f str, Vec<Outcome>)>, String> {
    let answers = answers_by(way, family).and_then(|answers| answers.into_iter().collect::<Result<Vec<_>, _>>());
    let answers = answers.map_err(|error| format!("{}: {error}", family.family))?;
    let differs = same::different_from_base(family, &answers);
    let mut by_op: Vec<(&str, Vec<Outcome>)> = Vec::new();
    for ((case, answer), differs) in family.cases.iter().zip(&answers).zip(differs) {
        let op = if case.input.contains_key("x") && family.op == "power" { "power of a number" } else { &family.op };
        let mut outcome = judge::judge(case, answer, &requirement(&family.family, op));
        outcome.is_wrong |= differs;
        match by_op.iter_mut().find(|(known, _)| *known == op) {
            Some((_, outcomes)) => outcomes.push(outcome),
            None => by_op.push((op, vec![outcome])),
        }
    }
    Ok(by_op)
}
