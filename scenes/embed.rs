//! Build script: embeds every scene of this folder, so that a scene file is all that a new built-in scene needs.

use std::path::Path;
use std::{env, fs, io};

fn main() -> io::Result<()> {
    println!("cargo:rerun-if-changed=scenes");
    let mut names = Vec::new();
    for entry in fs::read_dir("scenes")? {
        let path = entry?.path();
        if path.extension().is_some_and(|ending| ending == "json") {
            names.extend(path.file_stem().map(|stem| stem.to_string_lossy().into_owned()));
        }
    }
    // The order of a folder's entries differs between machines.
    names.sort();
    let root = env::var("CARGO_MANIFEST_DIR").map_err(io::Error::other)?;
    let rows = names.iter().map(|name| {
        let path = Path::new(&root).join("scenes").join(format!("{name}.json"));
        format!("    ({name:?}, include_str!({path:?})),\n")
    });
    let table = format!("&[\n{}]\n", rows.collect::<String>());
    let out = env::var("OUT_DIR").map_err(io::Error::other)?;
    fs::write(Path::new(&out).join("built_in_scenes.rs"), table)
}
