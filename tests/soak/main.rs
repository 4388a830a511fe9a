//! Random scenes for as long as one likes: rendered, traced, written, read, replayed in the viewer. Nothing panics, no colour is no
//! number, the picture is its pixels' logs bit by bit, and memory doesn't grow.
//!
//! `.ci/soak MINUTES` runs it for longer than the few scenes of a plain `cargo test`.

#[path = "../support/random.rs"]
mod random;
mod scenes;

use random::Random;
use raywalk::log::file::{self, Ending};
use raywalk::log::{Log, What};
use raywalk::record::{self, Arithmetic, Part};
use raywalk::render::{Settings, render};
use raywalk::report::diff::{self, Numbering, Tolerance};
use raywalk::report::language::Language;
use raywalk::report::side_by_side::Run;
use raywalk::report::{Style, text};
use raywalk::scene::file::{check, mesh::Meshes};
use raywalk::scene::{Scene, build};
use raywalk::tui::{self, Options, Palette, Theme};
use std::collections::BTreeMap;
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

/// What was done.
#[derive(Debug, Default)]
struct Tally {
    scenes: u64,
    /// By what the first line of the refusal says without its place.
    refused: BTreeMap<String, u64>,
    pixels: u64,
    events: u64,
}

/// Resident memory in KiB; 0 where the system doesn't tell.
fn memory() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let resident = status.lines().find_map(|line| line.strip_prefix("VmRSS:"));
    resident.and_then(|line| line.trim().trim_end_matches(" kB").parse().ok()).unwrap_or(0)
}

fn scene_of(random: &mut Random, tally: &mut Tally) -> Option<Scene> {
    let text = scenes::scene(random);
    tally.scenes += 1;
    match check(&text, "soak.json") {
        Ok(loaded) => Some(build(&loaded.scene, &Meshes::default()).expect("nothing that isn't there")),
        Err(error) => {
            let report = error.report(false);
            let reason = report.lines().next().unwrap_or_default().rsplit(": ").next().unwrap_or_default().to_owned();
            *tally.refused.entry(reason).or_default() += 1;
            None
        }
    }
}

fn soak(seed: u64, tally: &mut Tally) {
    let mut random = Random::new(seed);
    let Some(scene) = scene_of(&mut random, tally) else { return };
    let arithmetic = [Arithmetic::F64, Arithmetic::F64, Arithmetic::F32, Arithmetic::Decimal(4)][random.below(4)];
    let [width, height] = scene.camera.resolution;
    let settings = Settings {
        arithmetic,
        threads: 1 + random.below(2),
        counts_rays: random.below(2) == 0,
        ..Settings::whole(&scene)
    };
    let rendered = render(&scene, &settings, |_| (), &AtomicBool::new(false)).expect("a picture");
    tally.pixels += rendered.film.pixels().len() as u64;
    for (number, color) in rendered.film.pixels().iter().enumerate() {
        let is_color = color.is_finite() && color.min_element() >= 0.0;
        assert!(is_color || arithmetic != Arithmetic::F64, "seed {seed}: pixel {number} is {color}");
        assert!(!color.is_nan(), "seed {seed}: pixel {number} is {color}");
    }
    let pixel = [random.below(width as usize) as u32, random.below(height as usize) as u32];
    // What is too long for memory is refused, which is a good answer.
    let Ok(log) = record::bounded(&scene, Part::Pixel(pixel), arithmetic) else { return };
    tally.events += log.events.len() as u64;
    let color = rendered.film.pixels()[(pixel[1] * width + pixel[0]) as usize];
    let result = log.events.iter().rev().find_map(|event| match event.what {
        What::Result { color } => Some(color),
        _ => None,
    });
    assert_eq!(result, Some(color.to_array()), "seed {seed}: pixel {pixel:?}");
    replay(seed, log, &mut random);
}

/// Writes a log and reads it back; looks at it in the viewer after keys that nobody chose.
fn replay(seed: u64, log: Log, random: &mut Random) {
    let written = file::to_ndjson(&log).expect("memory");
    let read = file::read(&written).expect("a log");
    assert_eq!(read.ending, Ending::Complete, "seed {seed}");
    assert!(read.log == log, "seed {seed}: the log changed on its way");
    assert!(text::text(Language::English, &log, Style::default()).lines().count() > 1);
    let trees = [&log, &read.log].map(|log| raywalk::log::Tree::of(&log.events));
    let mut other = read.log.clone();
    Numbering::unify(&log.header, &mut other.header).apply(&mut other.events);
    let (a, b) = (Run { log: &log, tree: &trees[0] }, Run { log: &other, tree: &trees[1] });
    assert!(diff::compare(a, b, &Tolerance::default()).differences.is_empty(), "seed {seed}");
    if log.events.len() > 20_000 {
        return;
    }
    // Without `N`: what is typed into a line may otherwise be "NaN".
    const KEYS: [&str; 17] = [
        "n", "p", "<Down>", "<Up>", "<Right>", "<Left>", "<Tab>", "<Space>", "d", "D", "w", "a", "u", "g", "G", "f",
        "x",
    ];
    let keys: String = (0..random.below(40)).map(|_| KEYS[random.below(KEYS.len())]).collect();
    let options = Options {
        theme: Theme::new(Palette::True, random.below(2) == 0),
        language: Language::ALL[random.below(2)],
        start: None,
        warning: None,
        controls: Default::default(),
        note: None,
        numbers: Style::default(),
    };
    let picture =
        tui::picture(read.log, &options, None, &keys, (40 + random.below(100) as u16, 10 + random.below(40) as u16));
    assert!(picture.starts_with("<svg") && !picture.contains("NaN"), "seed {seed}, keys {keys}");
}

/// Runs for so long; gives the tally, and the memory after each twentieth of the time.
fn soak_for(time: Duration, first_seed: u64) -> (Tally, Vec<u64>) {
    let (start, mut tally, mut memories) = (Instant::now(), Tally::default(), Vec::new());
    for seed in first_seed.. {
        soak(seed, &mut tally);
        let done = start.elapsed();
        if done.as_secs_f64() >= time.as_secs_f64() * (memories.len() + 1) as f64 / 20.0 {
            memories.push(memory());
        }
        if done >= time {
            break;
        }
    }
    (tally, memories)
}

#[test]
fn some_random_scenes() {
    let mut tally = Tally::default();
    (0..300).for_each(|seed| soak(seed, &mut tally));
    let refused: u64 = tally.refused.values().sum();
    assert!(refused * 4 < tally.scenes, "{tally:?}");
    assert!(tally.pixels > 10_000 && tally.events > 10_000, "{tally:?}");
}

/// `RAYWALK_SOAK_SECONDS` long, from the scene `RAYWALK_SOAK_SEED` on.
#[test]
#[ignore = "takes as long as it is told to: .ci/soak"]
fn random_scenes_for_a_long_time() {
    let number = |name: &str, otherwise: u64| {
        std::env::var(name)
            .map_or(otherwise, |text| text.parse().unwrap_or_else(|_| panic!("{name}: expected a number")))
    };
    let time = Duration::from_secs(number("RAYWALK_SOAK_SECONDS", 60));
    let (tally, memories) = soak_for(time, number("RAYWALK_SOAK_SEED", 1_000_000));
    println!("{tally:#?}\nmemory in KiB: {memories:?}");
    // A large log now and then leaves room behind that the allocator keeps; a leak of 5 KiB a scene is more in half an hour.
    let quarter = memories.len() / 4;
    let median = |part: &[u64]| {
        let mut part = part.to_vec();
        part.sort_unstable();
        part[part.len() / 2]
    };
    let (early, late) = (median(&memories[quarter..2 * quarter]), median(&memories[3 * quarter..]));
    assert!(late <= early + (256 << 10), "memory grew from {early} to {late} KiB");
}
