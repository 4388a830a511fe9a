//! `render --resume`: whatever ends a rendering, what it had is kept, and the picture has the bytes of one run.

use crate::run::{answer, names_in, raywalk, raywalk_after, unlimited_answer};
use std::fs;
use std::path::Path;
use std::process::{Child, Stdio};
use std::thread::sleep;
use std::time::Duration;

/// Numbers that look random and are the same in every run.
struct Random(u32);

impl Random {
    fn below(&mut self, end: u64) -> u64 {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (u64::from(self.0 >> 8) * end) >> 24
    }
}

fn start(folder: &Path, call: &[&str]) -> Child {
    let mut command = raywalk(folder, call);
    command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("it starts")
}

fn size_of(folder: &Path, name: &str) -> u64 {
    fs::metadata(folder.join(name)).map_or(0, |metadata| metadata.len())
}

/// Ends a call again and again until it was in the middle this many times of the work, each time in a new folder when the result is there;
/// every result has these bytes.
fn is_killed(times: u32, call: &[&str], name: &str, expected: &[u8]) {
    let checkpoint = format!("{name}.checkpoint");
    let mut random = Random(1);
    let (mut killed, mut results) = (0, 0);
    while killed < times || results == 0 {
        let folder = tempfile::tempdir().expect("a folder");
        fs::write(folder.path().join(name), "old").expect("written");
        let mut kept = 0;
        loop {
            let mut child = start(folder.path(), call);
            sleep(Duration::from_millis(random.below(120)));
            child.kill().expect("it is killed");
            let status = child.wait().expect("it ends");
            let found = fs::read(folder.path().join(name)).expect("a picture");
            assert!(found == b"old" || found == expected, "{} bytes of a picture", found.len());
            if status.success() {
                break;
            }
            killed += 1;
            // A record in the middle of which it was ended may go again, and nothing else: the longest has 32 * 32 pixels.
            let keeps = size_of(folder.path(), &checkpoint);
            assert!(found == expected || keeps + (32 * 32 * 24 + 12) > kept, "{keeps} of {kept} bytes are kept");
            kept = keeps;
        }
        results += 1;
        assert!(fs::read(folder.path().join(name)).expect("a picture") == expected);
        assert!(!folder.path().join(checkpoint.as_str()).exists());
    }
}

fn made(call: &[&str], name: &str) -> Vec<u8> {
    let folder = tempfile::tempdir().expect("a folder");
    assert!(start(folder.path(), call).wait().expect("it ends").success());
    fs::read(folder.path().join(name)).expect("a picture")
}

#[test]
fn fifty_kills_lose_nothing() {
    let call = ["render", "figure-6", "--size", "200x150", "--max-depth", "6", "-q", "-o", "a.png"];
    is_killed(50, &[&call[..], &["--resume"]].concat(), "a.png", &made(&call, "a.png"));
}

#[test]
fn kills_lose_nothing_of_a_shard_and_of_layers() {
    let call = ["render", "figure-6", "--size", "160x120", "--max-depth", "5", "--shard", "2/3", "-q", "-o", "a.part"];
    is_killed(5, &[&call[..], &["--resume"]].concat(), "a.part", &made(&call, "a.part"));
    let call =
        ["render", "figure-6", "--size", "90x70", "--max-depth", "5", "--layers", "rays,normal", "-q", "-o", "a.exr"];
    is_killed(5, &[&call[..], &["--resume"]].concat(), "a.exr", &made(&call, "a.exr"));
}

#[test]
fn a_checkpoint_left_beside_a_whole_shard_goes() {
    let folder = tempfile::tempdir().expect("a folder");
    let call = ["render", "textbook", "--size", "100x70", "-q", "--resume", "--shard", "1/1", "-o", "a.part"];
    assert!(start(folder.path(), &call).wait().expect("it ends").success());
    let left = folder.path().join("a.part.checkpoint");
    // Also in a run that keeps none itself.
    let without: Vec<_> = call.iter().copied().filter(|word| *word != "--resume").collect();
    for call in [&call[..], &without] {
        fs::write(&left, checkpoint()).expect("written");
        assert!(start(folder.path(), call).wait().expect("it ends").success());
        assert!(!left.exists(), "{call:?}");
    }
    // One of something else isn't ours to remove, and does no harm.
    let other = checkpoint().windows(2).position(|pair| pair == b"70").expect("the height");
    let mut other = {
        let mut text = checkpoint();
        text[other] = b'8';
        text
    };
    other.truncate(2000);
    for call in [&call[..], &without] {
        fs::write(&left, &other).expect("written");
        assert!(start(folder.path(), call).wait().expect("it ends").success());
        assert!(fs::read(&left).expect("it is there") == other, "{call:?}");
    }
}

#[test]
fn a_checkpoint_left_beside_a_picture_goes() {
    let folder = tempfile::tempdir().expect("a folder");
    let without: Vec<_> = CALL.iter().copied().filter(|word| *word != "--resume").collect();
    for call in [&CALL[..], &without] {
        fs::write(folder.path().join("a.pfm.checkpoint"), checkpoint()).expect("written");
        assert!(start(folder.path(), call).wait().expect("it ends").success());
        assert_eq!(names_in(folder.path()), ["a.pfm"], "{call:?}");
    }
}

const CALL: [&str; 8] = ["render", "textbook", "--size", "100x70", "-q", "--resume", "-o", "a.pfm"];

/// A checkpoint of a rendering that was ended, with all its pieces.
fn checkpoint() -> Vec<u8> {
    let folder = tempfile::tempdir().expect("a folder");
    // The part of the only shard has the same records, and an end behind them.
    let call = ["render", "textbook", "--size", "100x70", "-q", "--shard", "1/1", "-o", "a.part"];
    assert_eq!(answer(&mut raywalk(folder.path(), &call)).code, Some(0));
    let part = fs::read(folder.path().join("a.part")).expect("a part");
    part[..part.len() - 36].to_vec()
}

#[test]
fn a_checkpoint_is_good_up_to_where_it_was_cut_off_or_damaged() {
    let expected = made(&["render", "textbook", "--size", "100x70", "-q", "-o", "a.pfm"], "a.pfm");
    let whole = checkpoint();
    let mut random = Random(7);
    for round in 0..30 {
        let folder = tempfile::tempdir().expect("a folder");
        let place = random.below(whole.len() as u64) as usize;
        let mut text = whole.clone();
        if round % 2 == 0 {
            text.truncate(place);
        } else {
            // Behind the header: what is damaged there says that it is of another picture.
            let header = whole.iter().position(|byte| *byte == b'\n').expect("a header") + 1;
            text[place.max(header)] ^= 1;
        }
        fs::write(folder.path().join("a.pfm.checkpoint"), text).expect("written");
        let answer = answer(&mut raywalk(folder.path(), &CALL));
        assert_eq!(answer.code, Some(0), "{round} {place}: {}", answer.message);
        assert!(fs::read(folder.path().join("a.pfm")).expect("a picture") == expected, "{round} {place}");
        assert_eq!(names_in(folder.path()), ["a.pfm"]);
    }
}

#[test]
fn a_checkpoint_of_something_else_is_left_alone() {
    let folder = tempfile::tempdir().expect("a folder");
    let place = folder.path().join("a.pfm.checkpoint");
    let whole = checkpoint();
    let others: [(&[&str], &str); 3] = [
        (&["--size", "100x71"], "crop: 0,0,100,70 there, 0,0,100,71 here"),
        (&["--size", "100x70", "--arithmetic", "f32"], "arithmetic: f64 there, f32 here"),
        (&["--size", "100x70", "--max-depth", "0"], "the scene with its options"),
    ];
    for (options, why) in others {
        fs::write(&place, &whole).expect("written");
        let call = ["render", "textbook", "-q", "--resume", "-o", "a.pfm"];
        let answer = answer(&mut raywalk(folder.path(), &[&call[..], options].concat()));
        assert_eq!(answer.code, Some(2));
        assert!(answer.message.contains(why) && answer.message.contains("is of another picture"), "{}", answer.message);
        assert!(fs::read(&place).expect("the checkpoint") == whole);
    }
    fs::write(&place, "my notes").expect("written");
    let told = answer(&mut raywalk(folder.path(), &CALL));
    assert!(told.code == Some(2) && told.message.contains("expected a part"), "{}", told.message);
    assert_eq!(fs::read(&place).expect("the notes"), b"my notes");
    fs::remove_file(&place).expect("removed");
    fs::create_dir(&place).expect("a folder");
    assert_eq!(answer(&mut raywalk(folder.path(), &CALL)).code, Some(2));
    let told = answer(&mut raywalk(folder.path(), &["render", "textbook", "--resume", "--shard", "1/2", "-o", "-"]));
    assert!(told.code == Some(2) && told.message.contains("expected the name of a file"), "{}", told.message);
}

/// Finished frames aren't rendered again, unless somebody changed them.
#[test]
fn frames_go_on_where_they_were_ended() {
    let call = ["render", "spoked-wheel", "--size", "60x60", "--frames", "1-3", "-q", "-o", "f#.png"];
    let whole = tempfile::tempdir().expect("a folder");
    assert!(start(whole.path(), &call).wait().expect("it ends").success());
    let resumed = [&call[..], &["--resume"]].concat();
    let folder = tempfile::tempdir().expect("a folder");
    // It is ended as soon as the second frame is begun.
    let mut child = start(folder.path(), &resumed);
    while !folder.path().join("f2.png.checkpoint").exists() && !folder.path().join("f3.png").exists() {
        sleep(Duration::from_millis(1));
    }
    child.kill().expect("it is killed");
    child.wait().expect("it ends");
    let is_done = !folder.path().join("f1.png.checkpoint").exists();
    fs::write(folder.path().join("f2.png"), "somebody else's").expect("written");
    let loud: Vec<&str> = resumed.iter().copied().filter(|word| *word != "-q").collect();
    let told = unlimited_answer(&mut raywalk(folder.path(), &loud));
    assert_eq!(told.code, Some(0), "{}", told.message);
    // Unless it was too quick to be caught, the first frame is known.
    assert!(is_done || told.message.contains("f1.png: exists already"), "{}", told.message);
    for name in ["f1.png", "f2.png", "f3.png"] {
        assert!(
            fs::read(folder.path().join(name)).expect("ours") == fs::read(whole.path().join(name)).expect("theirs")
        );
    }
    assert_eq!(names_in(folder.path()).iter().filter(|name| !name.ends_with(".part")).count(), 3);
}

/// A finished frame is one of the same call, with all its files, and however many there are.
#[test]
fn finished_frames_are_of_the_same_call() {
    let folder = tempfile::tempdir().expect("a folder");
    let call = |more: &[&str]| {
        let call = ["render", "spoked-wheel", "--size", "8x8", "--frames", "1-2", "--resume", "-o", "a#.png"];
        unlimited_answer(&mut raywalk(folder.path(), &[&call[..], more].concat()))
    };
    // The second frame can't be written, so that the first one waits.
    let stop = || fs::create_dir(folder.path().join("a2.png")).expect("a folder");
    let go_on = || fs::remove_dir(folder.path().join("a2.png")).expect("removed");
    let depth = || fs::read(folder.path().join("a1.png")).expect("a picture")[24];
    stop();
    assert_eq!((call(&[]).code, depth()), (Some(2), 8));
    go_on();
    assert_eq!((call(&["--png16"]).code, depth()), (Some(0), 16));
    fs::remove_file(folder.path().join("a2.png")).expect("removed");
    stop();
    assert_eq!(call(&["--layers", "depth"]).code, Some(2));
    fs::remove_file(folder.path().join("a1.depth.png")).expect("the layer was there");
    go_on();
    assert_eq!(call(&["--layers", "depth"]).code, Some(0));
    assert_eq!(names_in(folder.path()), ["a1.depth.png", "a1.png", "a2.depth.png", "a2.png"]);
}

#[test]
fn many_frames_need_few_files_at_a_time() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene =
        raywalk::scene::builtin::text("spoked-wheel").expect("a scene").replace("\"count\": 12", "\"count\": 300");
    assert!(scene.contains("300"));
    fs::write(folder.path().join("wheel.json"), scene).expect("written");
    let call = ["render", "wheel.json", "--size", "1x1", "--frames", "1-300", "--resume", "-q", "-o", "f###.ppm"];
    let told = unlimited_answer(&mut raywalk_after("ulimit -n 64", folder.path(), &call));
    assert_eq!(told.code, Some(0), "{}", told.message);
    assert_eq!(names_in(folder.path()).len(), 301);
}

#[test]
fn two_at_a_time_are_not_let() {
    let folder = tempfile::tempdir().expect("a folder");
    let endless = ["render", "figure-6", "--max-depth", "256", "--size", "400x300", "-q", "--resume", "-o", "a.pfm"];
    let mut first = start(folder.path(), &endless);
    while !folder.path().join("a.pfm.checkpoint").exists() {
        sleep(Duration::from_millis(1));
    }
    sleep(Duration::from_millis(50));
    let second = answer(&mut raywalk(folder.path(), &endless));
    first.kill().expect("it is killed");
    first.wait().expect("it ends");
    assert!(second.code == Some(3) && second.message.contains("another raywalk is at work"), "{}", second.message);
}

#[test]
fn an_empty_file_beside_a_picture_is_left_alone() {
    let folder = tempfile::tempdir().expect("a folder");
    for (result, call) in [("a.ppm", &["-o", "a.ppm"][..]), ("a.part", &["--shard", "1/2", "-o", "a.part"])] {
        let left = folder.path().join(format!("{result}.checkpoint"));
        fs::write(&left, "").expect("a file");
        for _ in 0..2 {
            let call = [&["render", "textbook", "--size", "4x4", "-q"], call].concat();
            answer(&mut raywalk(folder.path(), &call)).ends_with(0);
            assert_eq!(fs::read(&left).expect("it is there"), b"", "{result}");
        }
    }
}
