//! What the silent probe costs: the program's tracer against one written by hand without any probe.
//!
//! Both must first give the same bits in every pixel. Then whole pictures are timed in pairs, one right after the other
//! and in turns, so that a machine that slows down slows both; what counts is the median of the pairs' ratios. Where
//! valgrind is installed, the instructions of a small picture are counted too: they don't depend on the machine's mood.
//!
//! ```text
//! cargo bench --bench silent
//! ```

mod yardstick;

use raywalk::probe::Silent;
use raywalk::sampling;
use raywalk::scene::{Scene, build, builtin, file};
use std::hint::black_box;
use std::process::Command;
use std::time::{Duration, Instant};
use yardstick::Yardstick;

/// How many pairs of pictures are timed.
const PAIRS: usize = 41;

/// The size of the timed pictures.
const TIMED: [u32; 2] = [320, 240];

/// The size of the pictures whose instructions are counted.
const COUNTED: [u32; 2] = [80, 60];

/// The most that the silent probe may cost.
const ALLOWED: f64 = 1.02;

fn main() {
    let arguments: Vec<_> = std::env::args().collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        // How the bench calls itself to have its instructions counted.
        [_, "--paint", tracer, scene] => paint(tracer, &Contest::new(scene, COUNTED)),
        // Cargo says whether it is measuring or, among the tests, only asks whether the bench works.
        [_, ref options @ ..] if options.contains(&"--bench") => scenes().for_each(report),
        _ => scenes().for_each(|scene| Contest::new(scene, COUNTED).assert_same_bits()),
    }
}

/// The scenes of the contest: the numeric example, and glass in a room with every kind of light.
fn scenes() -> impl Iterator<Item = &'static str> {
    ["textbook", "glass"].into_iter()
}

fn report(scene: &str) {
    let contest = Contest::new(scene, TIMED);
    contest.assert_same_bits();
    let (silent, by_hand, mut ratios) = contest.times();
    ratios.sort_by(f64::total_cmp);
    let quartile = |part: usize| ratios[(ratios.len() - 1) * part / 4];
    let verdict = if quartile(2) <= ALLOWED { "within" } else { "ABOVE" };
    println!("{scene}: {} × {} pixels, the same bits in each", TIMED[0], TIMED[1]);
    println!("  median time   silent {silent:.2?}   by hand {by_hand:.2?}");
    println!(
        "  ratio         {:.4} (quartiles {:.4} and {:.4} of {PAIRS} pairs), {verdict} {ALLOWED}",
        quartile(2),
        quartile(1),
        quartile(3)
    );
    match instructions(scene) {
        Some((silent, by_hand)) => {
            println!(
                "  instructions  silent {silent}   by hand {by_hand}   ratio {:.4}",
                silent as f64 / by_hand as f64
            );
        }
        None => println!("  instructions  not counted: valgrind can't be run"),
    }
}

/// The two tracers on one scene.
struct Contest {
    scene: Scene,
    yardstick: Yardstick,
}

impl Contest {
    fn new(scene: &str, resolution: [u32; 2]) -> Contest {
        let text = if scene == "glass" { Some(include_str!("glass.json")) } else { builtin::text(scene) };
        let text = text.unwrap_or_else(|| panic!("no scene `{scene}`"));
        let loaded = file::check(text.as_bytes(), scene).map_err(|error| error.report(false));
        let mut file = loaded.unwrap_or_else(|report| panic!("{report}")).scene;
        file.camera.resolution = resolution;
        let scene = build(&file, &Default::default()).unwrap_or_else(|unsupported| panic!("{unsupported}"));
        Contest { scene, yardstick: Yardstick::new(&file) }
    }

    fn assert_same_bits(&self) {
        for pixel in self.pixels() {
            let silent = sampling::pixel(&self.scene, pixel, &mut Silent).to_array();
            let by_hand = self.yardstick.pixel(pixel).to_array();
            assert_eq!(
                silent.map(f64::to_bits),
                by_hand.map(f64::to_bits),
                "{pixel:?}: {silent:?}, by hand {by_hand:?}"
            );
        }
    }

    /// The median times of a picture by the one and by the other, and the ratio of each pair.
    fn times(&self) -> (Duration, Duration, Vec<f64>) {
        let silent = || self.time(|pixel| sampling::pixel(&self.scene, pixel, &mut Silent));
        let by_hand = || self.time(|pixel| self.yardstick.pixel(pixel));
        // The first picture warms up caches and clock.
        let _ = (silent(), by_hand());
        let pair = |number: usize| {
            if number.is_multiple_of(2) {
                (silent(), by_hand())
            } else {
                let by_hand = by_hand();
                (silent(), by_hand)
            }
        };
        let pairs: Vec<_> = (0..PAIRS).map(pair).collect();
        let ratios = pairs.iter().map(|(silent, by_hand)| silent.as_secs_f64() / by_hand.as_secs_f64()).collect();
        let (silent, by_hand): (Vec<_>, Vec<_>) = pairs.into_iter().unzip();
        (median(silent), median(by_hand), ratios)
    }

    fn time<C>(&self, color: impl Fn([u32; 2]) -> C) -> Duration {
        let start = Instant::now();
        for pixel in self.pixels() {
            black_box(color(black_box(pixel)));
        }
        start.elapsed()
    }

    fn pixels(&self) -> impl Iterator<Item = [u32; 2]> + use<> {
        let [width, height] = self.scene.camera.resolution;
        (0..height).flat_map(move |y| (0..width).map(move |x| [x, y]))
    }
}

fn median(mut times: Vec<Duration>) -> Duration {
    times.sort();
    times[times.len() / 2]
}

/// Paints a picture by one of the tracers, or does everything but.
fn paint(tracer: &str, contest: &Contest) {
    for pixel in contest.pixels() {
        match tracer {
            "silent" => drop(black_box(sampling::pixel(&contest.scene, black_box(pixel), &mut Silent))),
            "by_hand" => drop(black_box(contest.yardstick.pixel(black_box(pixel)))),
            _ => drop(black_box(pixel)),
        }
    }
}

/// The instructions of a picture by the program and by hand, without those of getting ready.
fn instructions(scene: &str) -> Option<(u64, u64)> {
    let nothing = instructions_of("nothing", scene)?;
    let silent = instructions_of("silent", scene)?;
    let by_hand = instructions_of("by_hand", scene)?;
    Some((silent - nothing, by_hand - nothing))
}

fn instructions_of(tracer: &str, scene: &str) -> Option<u64> {
    let this = std::env::current_exe().ok()?;
    let mut valgrind = Command::new("valgrind");
    valgrind.args(["--tool=callgrind", "--callgrind-out-file=/dev/null"]).arg(this).args(["--paint", tracer, scene]);
    let output = valgrind.output().ok()?;
    let messages = String::from_utf8_lossy(&output.stderr);
    let collected = messages.lines().find_map(|line| line.split_once("Collected : "))?.1;
    collected.trim().parse().ok()
}
