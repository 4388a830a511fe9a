//! How long the viewer takes to open a log and to show a frame, by the size of the log; and to trace another pixel.
//!
//! ```text
//! cargo bench --bench viewer
//! ```

use raywalk::log::Log;
use raywalk::log::file::{read_from, to_ndjson};
use raywalk::record::{self, Arithmetic};
use raywalk::report::Style;
use raywalk::scene::{Sampling, Scene, build, builtin, file};
use raywalk::tui::{Model, Options, Palette, Theme, frame, keys, opened, show_log, update};
use std::fs::File;
use std::io;
use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};
use support::Extent;
use tempfile::NamedTempFile;

const SCREEN: (u16, u16) = (200, 60);

/// What is typed before the frames of a row.
const WALKS: [(&str, &str); 6] = [
    ("step by value", "n"),
    ("step by ray", "}"),
    ("scroll by row", "j"),
    ("scroll by page", "PgDn"),
    ("go to the end", "G"),
    ("go to the beginning", "g"),
];

/// What is searched for: a name, a decision and a value, of which there are many; a value and a text that are nowhere.
const SEARCHES: [(&str, &str); 5] = [
    ("search for a name", "/n_dot_l<Enter>"),
    ("search for a decision", "/blocked<Enter>"),
    ("search for a value", "/0.5<Enter>"),
    ("search for no value", "/13.24680<Enter><Esc>"),
    ("search for no text", "/nowhere<Enter><Esc>"),
];

fn main() -> io::Result<()> {
    let arguments: Vec<_> = std::env::args().collect();
    if let [_, option, file, frames] = &arguments[..]
        && option == "--open"
    {
        return measure(Path::new(file), frames.parse().unwrap_or(1));
    }
    let (sizes, frames): (&[usize], usize) = match Extent::asked() {
        Extent::Whole => (&[1_000, 100_000, 1_000_000], 60),
        Extent::Short => (&[1_000], 2),
    };
    for size in sizes {
        let file = NamedTempFile::new()?;
        std::fs::write(&file, log_of(*size))?;
        // In a process of its own, so that its memory is that of the log.
        let mut child = Command::new(std::env::current_exe()?);
        let status = child.arg("--open").arg(file.path()).arg(frames.to_string()).status()?;
        assert!(status.success(), "the log can't be opened");
    }
    println!("another pixel: traced, opened and shown, ms");
    for name in builtin::names() {
        let Some(scene) = scene(name) else { continue };
        let mut model = opened(record::pixel(&scene, [1, 1], Arithmetic::F64), &options());
        let [width, height] = scene.camera.resolution;
        let pixels = (1..8).flat_map(|row| (1..8).map(move |column| [column * width / 8, row * height / 8]));
        let times = pixels.map(|pixel| {
            let start = Instant::now();
            show_log(&mut model, record::pixel(&scene, pixel, Arithmetic::F64));
            let shown = frame(&model, SCREEN.0, SCREEN.1, &options().theme);
            assert_eq!(shown.area.width, SCREEN.0);
            start.elapsed()
        });
        println!("  {name:<28} {}", Times::of(times.collect()));
    }
    Ok(())
}

/// Opens a log and walks in it.
fn measure(file: &Path, frames: usize) -> io::Result<()> {
    let before = memory("VmRSS:");
    let start = Instant::now();
    let log = read_from(File::open(file)?).map_err(io::Error::other)?.log;
    let read_in = start.elapsed();
    let size = log.events.len();
    let mut model = opened(log, &options());
    let opened_in = start.elapsed();
    let bytes_an_event = |memory: f64| (memory - before) / size as f64;
    println!(
        "{size} events: opened in {:.1} ms (read {:.1} ms), {:.0} bytes an event, {:.0} at most",
        milliseconds(opened_in),
        milliseconds(read_in),
        bytes_an_event(memory("VmRSS:")),
        bytes_an_event(memory("VmHWM:")),
    );
    update(&mut model, raywalk::tui::Action::Resize(SCREEN.0, SCREEN.1));
    for (words, keys) in WALKS {
        let times = (0..frames).map(|_| timed(&mut model, keys)).collect();
        println!("  {words:<28} {}", Times::of(times));
    }
    for (words, keys) in SEARCHES {
        timed(&mut model, "g");
        println!("  {words:<28} {:8.3} ms", milliseconds(timed(&mut model, keys)));
    }
    Ok(())
}

/// How long it takes until the screen shows what these keys do.
fn timed(model: &mut Model, typed: &str) -> Duration {
    let start = Instant::now();
    for key in keys::sequence(typed) {
        if let Some(action) = keys::meant(model, key) {
            update(model, action);
        }
    }
    let shown = frame(model, SCREEN.0, SCREEN.1, &options().theme);
    assert_eq!(shown.area.width, SCREEN.0);
    start.elapsed()
}

/// A log of at least this many events: samples of one pixel, cut off where it is long enough, as a log that breaks off is.
fn log_of(size: usize) -> Vec<u8> {
    let Some(mut scene) = scene("glass-and-mirror") else { return Vec::new() };
    let pixel = [200, 150];
    let of_one = record::pixel(&scene, pixel, Arithmetic::F64).events.len();
    let across = (1..).find(|n| n * n * of_one > size + of_one).unwrap_or(1);
    scene.sampling = Sampling::Regular { n: across as u32 };
    let Log { header, mut events } = record::pixel(&scene, pixel, Arithmetic::F64);
    events.truncate(size);
    to_ndjson(&Log { header, events }).unwrap_or_default()
}

fn scene(name: &str) -> Option<Scene> {
    let loaded = file::check(builtin::text(name)?.as_bytes(), name).ok()?;
    build(&loaded.scene, &Default::default()).ok()
}

fn options() -> Options {
    let theme = Theme::new(Palette::True, false);
    Options {
        theme,
        start: None,
        warning: None,
        note: None,
        numbers: Style::default(),
        language: Default::default(),
        controls: Default::default(),
    }
}

/// The bytes that the process holds (`VmRSS:`) or has held at most (`VmHWM:`); 0 where the system doesn't say.
fn memory(which: &str) -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix(which));
    let kilobytes = line.and_then(|rest| rest.split_whitespace().next()?.parse::<f64>().ok());
    kilobytes.unwrap_or(0.0) * 1024.0
}

fn milliseconds(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}

/// The median and the longest.
struct Times([f64; 2]);

impl Times {
    fn of(mut times: Vec<Duration>) -> Times {
        times.sort();
        let at = |index: usize| times.get(index).map_or(0.0, |time| milliseconds(*time));
        Times([at(times.len() / 2), at(times.len().saturating_sub(1))])
    }
}

impl std::fmt::Display for Times {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Times([median, longest]) = self;
        write!(f, "median {median:8.3} ms   longest {longest:8.3} ms")
    }
}
