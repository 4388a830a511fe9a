//! Why a pixel has its colour: the list of its paths, what they come to by light, object and ray, and what brings nothing.

use super::model::Model;
use super::model::list::{Entry, Listing, MOST, cells};
use super::theme::Role;
use crate::log::Value;
use crate::report::contributions::totals::{self, Common, Total};
use crate::report::contributions::{self, Account, Color, Ended, Group, Origin};
use crate::report::{path_class, words};

/// The account of the pixel's colour: its paths, their totals, what brings nothing, and a legend.
pub(super) fn listing(model: &Model) -> Listing {
    let account = contributions::account(&model.log, &model.tree, model.cursor);
    let (texts, color) = (&model.texts().lists.account, model.color(account.color));
    let of_rounding = |group: &Group| group.sum.origin == Origin::Rounding;
    let (rounding, groups): (Vec<_>, Vec<_>) =
        contributions::groups(&account.contributions).into_iter().partition(of_rounding);
    let (shown, small) = folded(&groups);
    let mut entries: Vec<_> = shown.iter().map(|group| contribution(model, &account, group)).collect();
    if !small.is_empty() {
        let share: f64 = small.iter().map(|group| group.sum.share).sum();
        let mut row: [String; 9] = Default::default();
        (row[0], row[3]) = (model.language.percent(share), (texts.smaller)(small.len()));
        let rest = cells(row);
        entries.push(Entry::plain(rest, Role::Faint));
    }
    for part in &rounding {
        entries.push(remark((texts.rounding)(&model.color(part.sum.color))));
        entries.push(remark(texts.not_in_this_sum.to_owned()));
    }
    let totals = [
        totals::by_light(&account.contributions),
        totals::by_object(&account.contributions),
        totals::by_ray(&model.tree, &account.contributions),
    ];
    for (heading, totals) in texts.totals.into_iter().zip(totals) {
        // The roundings have a line already.
        let totals = totals.iter().filter(|total| total.of != Common::Other(Origin::Rounding));
        let rows: Vec<_> = totals.take(MOST).map(|total| self::total(model, &account, total)).collect();
        if !rows.is_empty() {
            entries.push(Entry::heading(heading.to_owned()));
            entries.extend(rows);
        }
    }
    if !account.ended.is_empty() {
        entries.push(Entry::heading((texts.brings_nothing)(account.ended.len())));
    }
    entries.extend(account.ended.iter().take(MOST).map(|ended| self::ended(model, ended)));
    if !account.contributions.is_empty() {
        entries.push(Entry::heading(texts.legend_title.to_owned()));
        entries.extend(texts.legend.iter().map(|line| remark(format!("  {line}"))));
    }
    let class = path_class::of_ray(&model.log, &model.tree, model.cursor);
    let class = class.map_or(String::new(), |class| (texts.here)(&class));
    let title = match account.is_whole {
        true => (texts.title)(&color),
        false => (texts.so_far)(&color),
    };
    // What matters most comes first: the share.
    Listing::of(&texts.list, title + &class, &[0], entries)
}

/// So much of the colour, and of each of its channels, and where it comes from.
fn contribution(model: &Model, account: &Account, Group { sum: part, count }: &Group) -> Entry {
    let header = &model.log.header;
    let origin = words::origin(model.language, header, part.origin);
    let color = model.color(part.color);
    let times = if *count == 1 { String::new() } else { format!("×{count}") };
    let weight = (part.weight != [1.0; 3] && *count == 1)
        .then(|| format!("= {} * {}", model.color(part.own), triple(model, &part.weight)));
    let channels = channels(&part.color, account);
    let (share, cases) =
        (model.language.percent(part.share), (model.texts().lists.account.cases)(part.cases).to_owned());
    let weight = weight.unwrap_or_default();
    let text = cells([share, part.path.clone(), times, origin, part.class.clone(), cases, channels, color, weight]);
    Entry { target: part.event, ..Entry::plain(text, Role::Text) }
}

/// A line that is no row.
fn remark(text: String) -> Entry {
    Entry { role: Role::Faint, ..Entry::heading(text) }
}

/// Shares of less than this are shown as 0.0 %.
const SMALLEST_SHOWN: f64 = 0.0005;

/// The groups that are shown, and those that are too small or too many to be; a single one isn't folded.
fn folded(groups: &[Group]) -> (&[Group], &[Group]) {
    // They fall.
    let shown = groups.iter().take(MOST).take_while(|group| group.sum.share.abs() >= SMALLEST_SHOWN).count();
    groups.split_at(if shown + 1 == groups.len() { groups.len() } else { shown })
}

/// So much of each channel, in percent.
fn channels(color: &Color, account: &Account) -> String {
    let channel = |channel: usize| match account.color[channel] {
        0.0 => "-".to_owned(),
        whole => format!("{:.0}", (100.0 * color[channel] / whole).round() + 0.0),
    };
    format!("[{}]", [0, 1, 2].map(channel).join(" "))
}

/// What contributions with something in common come to.
fn total(model: &Model, account: &Account, total: &Total) -> Entry {
    let (header, language) = (&model.log.header, model.language);
    let of = match total.of {
        Common::Light(light) => words::plain(header.light(light)),
        Common::Ambient => model.texts().lists.account.ambient.to_owned(),
        Common::Object(object) => words::plain(header.object(object)),
        Common::Ray(kind) => words::ray_kind(language, header, kind),
        Common::Other(origin) => words::origin(language, header, origin),
    };
    let mut row: [String; 9] = Default::default();
    (row[0], row[3]) = (language.percent(total.share), of);
    (row[6], row[7]) = (channels(&total.color, account), model.color(total.color));
    let text = cells(row);
    Entry { target: total.event, ..Entry::plain(text, Role::Text) }
}

/// A weight, as one number where the channels have the same.
fn triple(model: &Model, weight: &[f64; 3]) -> String {
    let is_gray = weight[0] == weight[1] && weight[1] == weight[2];
    let value = if is_gray { Value::Number(weight[0]) } else { Value::Triple(*weight) };
    model.value(&value)
}

fn ended(model: &Model, ended: &Ended) -> Entry {
    let why = words::ended(model.language, &model.log, ended, model.numbers);
    Entry { role: Role::Blocked, ..Entry::to(ended.event, format!("  {}  {why}", ended.path)) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::contributions::{Contribution, LightPath};

    /// Of these shares so many are rows; the others are one together.
    #[track_caller]
    fn rows(shares: &[f64], expected: usize) {
        let group = |share: &f64| {
            let sum = Contribution {
                origin: Origin::Background,
                path: String::new(),
                way: LightPath::default(),
                weight: [1.0; 3],
                own: [*share; 3],
                color: [*share; 3],
                share: *share,
                class: String::new(),
                cases: "",
                event: None,
            };
            Group { sum, count: 1 }
        };
        let groups: Vec<_> = shares.iter().map(group).collect();
        let (shown, small) = folded(&groups);
        assert_eq!((shown.len(), small.len()), (expected, shares.len() - expected), "{shares:?}");
    }

    #[test]
    fn what_would_be_0_percent_is_one_row_together() {
        rows(&[0.6, 0.3, 0.0005], 3);
        rows(&[0.6, 0.3, 0.0004, -0.0003], 2);
        rows(&[0.6, 0.0004], 2);
        rows(&[0.0, 0.0, 0.0], 0);
        rows(&[0.9; 600], MOST);
        rows(&[], 0);
    }
}
