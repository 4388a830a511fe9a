//! The table of what adds to the colour, and the list of what doesn't.

use super::Task;
use crate::log::Value;
use crate::report::contributions::{self, Group, pixel_around};
use crate::report::words;

/// The most rows of a table: nobody reads more.
const MOST: usize = 40;

/// The rows and the list, each as text.
pub(super) struct Shares {
    /// Path, origin, class, what it brings, weight, what it adds, share.
    pub rows: Vec<[String; 7]>,
    /// Path and reason.
    pub ended: Vec<(String, String)>,
    /// How many of those were left out.
    pub more: usize,
}

impl Shares {
    pub(super) fn of(task: &Task) -> Shares {
        let (log, language) = (task.log, task.language);
        let texts = &language.texts().solution;
        let account = contributions::account(log, task.tree, pixel_around(task.tree, 0));
        let groups = contributions::groups(&account.contributions);
        let mut rows: Vec<_> = groups.iter().take(MOST).map(|group| row(task, group)).collect();
        if let Some(rest) = groups.get(MOST..).filter(|rest| !rest.is_empty()) {
            let color = |channel: usize| rest.iter().map(|group| group.sum.color[channel]).sum();
            let mut row = [const { String::new() }; 7];
            row[1] = (texts.smaller)(rest.len());
            row[5] = language.value(&Value::Triple([0, 1, 2].map(color)), task.style);
            row[6] = language.percent(rest.iter().map(|group| group.sum.share).sum());
            rows.push(row);
        }
        let mut sum = [const { String::new() }; 7];
        sum[1] = texts.sum.to_owned();
        sum[5] = language.value(&Value::Triple(account.color), task.style);
        sum[6] = language.percent(groups.iter().map(|group| group.sum.share).sum());
        rows.push(sum);
        let told = account.ended.iter().take(MOST);
        let ended = told.map(|ended| (ended.path.clone(), words::ended(language, log, ended, task.style)));
        Shares { rows, ended: ended.collect(), more: account.ended.len().saturating_sub(MOST) }
    }
}

fn row(task: &Task, Group { sum, count }: &Group) -> [String; 7] {
    let triple = |color: &[f64; 3]| task.language.value(&Value::Triple(*color), task.style);
    let times = if *count == 1 { String::new() } else { format!(" ×{count}") };
    let is_alone = *count == 1 && sum.event.is_some();
    let is_gray = sum.weight[0] == sum.weight[1] && sum.weight[1] == sum.weight[2];
    let weight = if is_gray { task.language.number(sum.weight[0], task.style) } else { triple(&sum.weight) };
    [
        format!("{}{times}", sum.path),
        words::origin(task.language, &task.log.header, sum.origin),
        sum.class.clone(),
        if is_alone { triple(&sum.own) } else { String::new() },
        if is_alone { weight } else { String::new() },
        triple(&sum.color),
        task.language.percent(sum.share),
    ]
}
