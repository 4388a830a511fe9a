//! Shards and what is made of them: the bytes of the run that wasn't divided, or a refusal that says what is wrong.

#![allow(clippy::unwrap_used)]

use crate::calls::{prints, raywalk, says};
use proptest::prelude::*;
use std::fs;
use tempfile::TempDir;

/// A folder with results of calls.
struct Folder(TempDir);

impl Folder {
    fn new() -> Folder {
        Folder(tempfile::tempdir().unwrap())
    }

    fn path(&self, name: &str) -> String {
        self.0.path().join(name).to_str().unwrap().to_owned()
    }

    fn bytes(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).unwrap()
    }

    /// Makes a file by a call; gives its path.
    fn made(&self, name: &str, call: &[&str]) -> String {
        let path = self.path(name);
        prints(&[call, &["-q", "-o", &path]].concat());
        path
    }

    /// Makes all shards of a call; gives their paths.
    fn shards(&self, call: &[&str], of: u32, ending: &str) -> Vec<String> {
        let shard = |number| {
            let shard = format!("{number}/{of}");
            self.made(&format!("{number}-{of}{ending}"), &[call, &["--shard", &shard]].concat())
        };
        (1..=of).map(shard).collect()
    }

    fn merged(&self, name: &str, parts: &[String], options: &[&str]) -> Vec<u8> {
        let parts: Vec<&str> = parts.iter().map(String::as_str).collect();
        prints(&[&["merge", "-q", "-o", &self.path(name)], &parts[..], options].concat());
        self.bytes(name)
    }
}

/// What is refused, and why.
#[track_caller]
fn refused(parts: &[&str], output: &str, why: &str) {
    says(2, &[&["merge", "-o", output], parts].concat(), why);
    assert!(!fs::exists(output).unwrap(), "{output}");
}

/// Ways to make a picture: the options, and the format.
const WAYS: [(&[&str], &str); 9] = [
    (&[], "out.png"),
    (&["--png16"], "out.png"),
    (&["--sampling", "sobol:3", "--seed", "7"], "out.pfm"),
    (&["--sampling", "shared:2"], "out.exr"),
    (&["--sampling", "adaptive:threshold=0.02,depth=2"], "out.ppm"),
    (&["--arithmetic", "decimal:3", "--max-depth", "2"], "out.pfm"),
    (&["--digits"], "out.pfm"),
    (&["--digits"], "out.png"),
    (&["--layers", "rays,tests,depth,normal,object,samples,error", "--sampling", "stochastic:2"], "out.exr"),
];

proptest! {
    #![proptest_config(ProptestConfig { cases: 16, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn parts_in_any_order_are_the_picture(
        way in 0..WAYS.len(),
        of in 1_u32..9,
        // Left and top, and how far it is to the right and to the bottom.
        [left, top, across, down] in [0_u32..60, 0_u32..40, 1_u32..40, 1_u32..40],
        keys in prop::collection::vec(any::<u32>(), 9),
        threads in 1_u32..4,
    ) {
        let folder = Folder::new();
        let (options, name) = WAYS[way];
        let [right, bottom] = [(left + across).min(100), (top + down).min(80)];
        let (crop, threads) = (format!("{left},{top},{right},{bottom}"), threads.to_string());
        let call = ["render", "glass-and-mirror", "--size", "100x80", "--crop", &crop, "--threads", &threads];
        let whole = folder.made(name, &[&call, options].concat());
        let whole = fs::read(whole).unwrap();
        let bits = options.contains(&"--png16");
        let options: Vec<&str> = options.iter().copied().filter(|option| *option != "--png16").collect();
        let mut parts = folder.shards(&[&call[..], &options].concat(), of, ".part");
        let mut keyed: Vec<_> = parts.drain(..).zip(keys).collect();
        keyed.sort_by_key(|(_, key)| *key);
        let parts: Vec<String> = keyed.into_iter().map(|(part, _)| part).collect();
        let format = if bits { &["--png16"][..] } else { &[] };
        let merged = folder.merged(&format!("merged-{name}"), &parts, format);
        prop_assert!(merged == whole);
    }

    #[test]
    fn logs_in_any_order_are_the_log_of_the_region(
        of in 1_u32..8,
        [left, top, across, down] in [150_u32..170, 110_u32..130, 1_u32..5, 1_u32..4],
        keys in prop::collection::vec(any::<u32>(), 8),
        ending in prop::sample::select(vec![".ndjson", ".ndjson.gz", ".ndjson.zst"]),
    ) {
        let folder = Folder::new();
        let region = format!("{left},{top},{},{}", left + across, top + down);
        let call = ["trace", "glass-and-mirror", "--region", &region];
        let name = format!("whole{ending}");
        folder.made(&name, &call);
        let parts = folder.shards(&call, of, ending);
        let mut keyed: Vec<_> = parts.into_iter().zip(keys).collect();
        keyed.sort_by_key(|(_, key)| *key);
        let parts: Vec<String> = keyed.into_iter().map(|(part, _)| part).collect();
        let merged = folder.merged(&format!("merged{ending}"), &parts, &[]);
        prop_assert!(merged == folder.bytes(&name));
    }
}

const SMALL: [&str; 4] = ["render", "textbook", "--size", "70x40"];

#[test]
fn layers_beside_a_png_are_merged_too() {
    let folder = Folder::new();
    let call = [&SMALL[..], &["--layers", "rays,object"]].concat();
    folder.made("whole.png", &call);
    let parts = folder.shards(&call, 2, ".part");
    folder.merged("merged.png", &parts, &[]);
    for name in ["png", "rays.png", "object.png"] {
        assert!(folder.bytes(&format!("merged.{name}")) == folder.bytes(&format!("whole.{name}")), "{name}");
    }
    let parts: Vec<&str> = parts.iter().map(String::as_str).collect();
    refused(&parts, &folder.path("a.pfm"), "layers: expected a picture in .exr");
}

#[test]
fn a_division_can_be_divided_further() {
    let folder = Folder::new();
    folder.made("whole.pfm", &SMALL);
    let part = |shard: &str| folder.made(&shard.replace('/', "-"), &[&SMALL[..], &["--shard", shard]].concat());
    let parts = ["2/4", "1/2", "8/8", "4/8"].map(part);
    assert!(folder.merged("merged.pfm", &parts, &[]) == folder.bytes("whole.pfm"));
    let [quarter, half, ..] = &parts;
    refused(&[quarter, half], &folder.path("a.pfm"), "shards are missing: 4/4");
    // More shards than there are pieces: some have nothing to do.
    let many = folder.shards(&SMALL, 9, ".part");
    assert!(folder.merged("again.pfm", &many, &[]) == folder.bytes("whole.pfm"));
}

#[test]
fn frames_have_parts_of_their_own() {
    let folder = Folder::new();
    let call = ["render", "spoked-wheel", "--size", "40x40", "--frames", "2-4"];
    folder.made("whole-##.png", &call);
    let shards = ["1/2", "2/2"];
    for (name, shard) in ["a-##.part", "b-##.part"].into_iter().zip(shards) {
        folder.made(name, &[&call[..], &["--shard", shard]].concat());
    }
    let names = ["b-03", "a-02", "a-04", "b-02", "a-03", "b-04"].map(|name| folder.path(&format!("{name}.part")));
    prints(&[&["merge", "-o", &folder.path("m-###.png")][..], &names.each_ref().map(String::as_str)].concat());
    for frame in 2..=4 {
        assert!(folder.bytes(&format!("m-00{frame}.png")) == folder.bytes(&format!("whole-0{frame}.png")), "{frame}");
    }
    // One frame alone needs no number.
    prints(&["merge", "-o", &folder.path("one.png"), &names[1], &names[3]]);
    assert!(folder.bytes("one.png") == folder.bytes("whole-02.png"));
    let all = names.each_ref().map(String::as_str);
    refused(&all, &folder.path("m.png"), "of several frames (2, 3, 4)");
    refused(&all[1..], &folder.path("n-#.png"), "shards are missing: 2/2");
    assert!(!fs::exists(folder.path("n-2.png")).unwrap(), "nothing is written before all is known to be there");
    let still = folder.made("still.part", &["render", "textbook", "--size", "40x40", "--shard", "1/2"]);
    let other = ["render", "spoked-wheel-open-shutter", "--size", "40x40", "--frames", "5", "--shard", "1/2"];
    let smaller = ["render", "spoked-wheel", "--size", "20x20", "--frames", "5", "--shard", "1/2"];
    let (other, smaller) = (folder.made("other.part", &other), folder.made("smaller.part", &smaller));
    for (stranger, difference) in [
        (&still, "are of different pictures, scene: textbook against spoked-wheel"),
        (&other, "are of different pictures, scene: spoked-wheel against spoked-wheel-open-shutter"),
        (&smaller, "are of different pictures, crop: 0,0,40,40 against 0,0,20,20"),
    ] {
        refused(&[&all[..], &[stranger.as_str()]].concat(), &folder.path("n-#.png"), difference);
    }
    for call in [&["render", &still, "-o", "x.png"][..], &["walk", &still], &["scene", "check", &still]] {
        says(2, call, "expected a scene, found a part of a picture; `raywalk merge` joins parts");
    }
    says(
        2,
        &["diff", &still, &still],
        "expected a log or a picture, found a part of a picture; `raywalk merge` joins parts",
    );
    says(2, &["walk", &folder.path("one.png")], "expected a scene, found a picture");
}

#[test]
fn what_is_no_whole_of_one_picture_is_refused() {
    let folder = Folder::new();
    let parts = folder.shards(&SMALL, 3, ".part");
    let [one, two, three] = [&*parts[0], &*parts[1], &*parts[2]];
    let out = folder.path("out.png");
    refused(&[one, three], &out, "shards are missing: 2/3");
    refused(&[one, two, one, three], &out, "overlap");
    let foreign: [(&str, &[&str], &str); 7] = [
        ("scene", &["render", "figure-6", "--size", "70x40"], "scene: textbook against figure-6"),
        ("size", &["render", "textbook", "--size", "70x41"], "crop: 0,0,70,40 against 0,0,70,41"),
        ("crop", &["render", "textbook", "--size", "70x40", "--crop", "0,0,70,39"], "crop: "),
        ("hand", &["render", "textbook", "--size", "70x40", "--arithmetic", "f32"], "arithmetic: f64 against f32"),
        ("depth", &["render", "textbook", "--size", "70x40", "--max-depth", "0"], "the scene with its options: "),
        (
            "digits",
            &["render", "textbook", "--size", "70x40", "--digits"],
            "what of each pixel: its colour against its digits",
        ),
        ("layers", &["render", "textbook", "--size", "70x40", "--layers", "rays"], "its colour and the layers rays"),
    ];
    for (name, call, why) in foreign {
        let other = folder.made(name, &[call, &["--shard", "2/3"]].concat());
        refused(&[one, &other, three], &out, why);
    }
    // What no scene file says, and yet may change a colour or a count.
    for (option, value, why) in
        [("--skip", "none", "--skip: all against none"), ("--tests", "all", "--tests: visited against all")]
    {
        let other = folder.made("otherwise", &[&SMALL[..], &[option, value, "--shard", "2/3"]].concat());
        refused(&[one, &other, three], &out, why);
        let log = ["trace", "textbook", "--region", "158,119,161,121", "--shard"];
        let first = folder.made("log-1", &[&log[..], &["1/2"]].concat());
        let second = folder.made("log-2", &[&log[..], &["2/2", option, value]].concat());
        refused(&[&first, &second], &folder.path("out.ndjson"), &format!("tracing.{}", &option[2..]));
    }
    let version = folder.path("version");
    let text = folder.bytes("2-3.part");
    let older = text.windows(5).position(|word| word == b"0.1.0").unwrap();
    fs::write(&version, [&text[..older], b"0.0.9", &text[older + 5..]].concat()).unwrap();
    refused(&[one, &version, three], &out, "version: 0.1.0 against 0.0.9");
    let log = folder.made("log", &["trace", "textbook", "--pixel", "160,120"]);
    refused(&[one, &log], &out, "a part of a picture and a log");
    refused(&[&log, &log], &out, "is no shard");
    refused(&["scenes/textbook.json"], &out, "expected a part that `render --shard` wrote");
    refused(&[&folder.path("none")], &out, "no such file");
    refused(&[one, two, three], &folder.path("out.gif"), "unknown picture format");
    says(2, &["merge", "-o", one, one, two, three], "unknown picture format");
    says(2, &["merge", "-o", &out], "required");
    says(2, &["render", "textbook", "-o", &out, "--shard", "4/3"], "expected I/N");
    says(2, &["trace", "textbook", "--pixel", "1,1", "--shard", "1/3"], "expected --region");
}

/// A part that was cut off anywhere, or has another byte anywhere, is refused; never a wrong picture.
#[test]
fn a_damaged_part_is_refused() {
    let folder = Folder::new();
    let [one, two] =
        ["1/2", "2/2"].map(|shard| folder.made(&shard.replace('/', "-"), &[&SMALL[..], &["--shard", shard]].concat()));
    let text = fs::read(&two).unwrap();
    let [bad, out] = [folder.path("bad"), folder.path("out.pfm")];
    let step = text.len() / 40;
    for place in (0..40).map(|part| part * step + part).chain([text.len() - 1]) {
        fs::write(&bad, &text[..place]).unwrap();
        let cut = raywalk(&["merge", "-o", &out, &one, &bad]).output().unwrap();
        assert_eq!(cut.status.code(), Some(2), "cut off at {place}");
        let mut changed = text.clone();
        changed[place] ^= 0x20;
        fs::write(&bad, changed).unwrap();
        let changed = raywalk(&["merge", "-o", &out, &one, &bad]).output().unwrap();
        assert_eq!(changed.status.code(), Some(2), "changed at {place}");
        assert!(!fs::exists(&out).unwrap());
    }
    fs::write(&bad, [&text[..], b"x"].concat()).unwrap();
    refused(&[&one, &bad], &out, "was cut off or damaged");
    let packed = folder.made("2.part.gz", &[&SMALL[..], &["--shard", "2/2"]].concat());
    fs::write(&bad, [&fs::read(packed).unwrap()[..], b"junk"].concat()).unwrap();
    refused(&[&one, &bad], &out, "was cut off or damaged");
    fs::write(&bad, "{\"part\":\"raywalk-part/2\",\"new\":1}\n").unwrap();
    refused(&[&one, &bad], &out, "found raywalk-part/2");
}

#[test]
fn logs_that_are_not_the_whole_of_one_region_are_refused() {
    let folder = Folder::new();
    let call = ["trace", "textbook", "--region", "158,119,161,121"];
    let parts = folder.shards(&call, 3, ".ndjson");
    let [one, two, three] = [&*parts[0], &*parts[1], &*parts[2]];
    let out = folder.path("out.ndjson");
    refused(&[one, three], &out, "shards are missing: 2/3");
    refused(&[one, two, two, three], &out, "are both shard 2/3");
    let half = folder.made("half", &[&call[..], &["--shard", "1/2"]].concat());
    refused(&[one, two, &half], &out, "of different divisions, shard 1/3 and shard 1/2");
    let other = folder.made("other", &["trace", "textbook", "--region", "158,119,161,122", "--shard", "2/3"]);
    refused(&[one, &other, three], &out, "of different regions, subject");
    let text = folder.bytes("2-3.ndjson");
    let bad = folder.path("bad");
    fs::write(&bad, &text[..text.len() / 2]).unwrap();
    refused(&[one, &bad, three], &out, "bad:1:1: the log was cut off");
    let text = String::from_utf8(text).unwrap();
    fs::write(&bad, text.replacen("\"hit\"", "\"hut\"", 1)).unwrap();
    refused(&[one, &bad, three], &out, "bad:1:1: the log is damaged: ");
    fs::write(&bad, text.replacen("\"outside\"", "\"inside\"", 1)).unwrap();
    refused(&[one, &bad, three], &out, "was changed after it was written");
    says(2, &["merge", "-o", one, one, two, three], "would be overwritten");
    let both = "--shard: expected --region and the format ndjson";
    says(2, &["trace", "textbook", "--region", "0,0,2,2", "--shard", "1/2", "--format", "json"], both);
    // A shard is a log by itself: it is walked, compared and queried as any other.
    let text = prints(&["walk", two, "--plain"]);
    assert!(text.starts_with("textbook · region 158,119 to 161,121 · f64"), "{text:.100}");
}

/// What another program has rewritten is joined as it was: its keys in order, blanks between them, another end of lines, one document.
#[test]
fn logs_in_other_spellings_are_joined_to_the_same_bytes() {
    let folder = Folder::new();
    let call = ["trace", "penumbra", "--region", "100,100,102,102"];
    let whole = fs::read(folder.made("whole.ndjson", &call)).unwrap();
    let parts = folder.shards(&call, 3, ".ndjson");
    let out = folder.path("out.ndjson");
    let lines = String::from_utf8(fs::read(&parts[0]).unwrap()).unwrap();
    let sorted = |line: &str| serde_json::from_str::<serde_json::Value>(line).unwrap().to_string() + "\r\n";
    fs::write(&parts[0], lines.lines().map(sorted).collect::<String>()).unwrap();
    let document = folder.path("2.json");
    fs::write(&document, prints(&["trace", &parts[1], "--format", "json"])).unwrap();
    // Standard output can't be begun again.
    for parts in [[&parts[0], &document, &parts[2]], [&parts[2], &parts[0], &parts[1]]] {
        prints(&["merge", parts[0], parts[1], parts[2], "-o", &out]);
        assert!(fs::read(&out).unwrap() == whole);
        assert!(prints(&["merge", parts[0], parts[1], parts[2], "-o", "-"]).as_bytes() == whole);
    }
}

/// Whoever runs all shards again after some failed loses no time.
#[test]
fn what_is_there_and_whole_is_not_made_again() {
    let folder = Folder::new();
    let picture = [&SMALL[..], &["--shard", "2/3"]].concat();
    let log = vec!["trace", "textbook", "--region", "158,119,161,121", "--shard", "2/3"];
    for (name, call) in [("a.part", picture), ("a.ndjson.gz", log)] {
        let path = folder.made(name, &call);
        let good = folder.bytes(name);
        let again = || {
            let answer = raywalk(&[&call[..], &["-o", &path]].concat()).output().unwrap();
            assert!(answer.status.success());
            String::from_utf8(answer.stderr).unwrap()
        };
        assert!(again().contains("exists already and is complete"));
        // Of another call, cut off, or something else altogether: it is made.
        for other in [&good[..good.len() - 3], b"something else"] {
            fs::write(&path, other).unwrap();
            assert!(!again().contains("exists already"));
            assert!(folder.bytes(name) == good);
        }
        let other: Vec<&str> = call.iter().map(|word| if *word == "2/3" { "3/3" } else { word }).collect();
        folder.made(name, &other);
        assert!(folder.bytes(name) != good);
    }
}
