//! Build script: embeds every scene of this folder and its meshes, so that a scene file is all that a new built-in scene
//! needs.

use std::path::Path;
use std::{env, fs, io};

fn main() -> io::Result<()> {
    println!("cargo:rerun-if-changed=scenes");
    let mut scenes = String::new();
    let mut meshes = String::new();
    for file in files()? {
        let path = Path::new(&env::var("CARGO_MANIFEST_DIR").map_err(io::Error::other)?).join("scenes").join(&file);
        match file.rsplit_once('.') {
            Some((name, "json")) => scenes += &format!("    ({name:?}, include_str!({path:?})),\n"),
            Some((_, "obj" | "ply")) => meshes += &format!("    ({file:?}, include_bytes!({path:?})),\n"),
            _ => {}
        }
    }
    let out = env::var("OUT_DIR").map_err(io::Error::other)?;
    fs::write(Path::new(&out).join("built_in_scenes.rs"), format!("&[\n{scenes}]\n"))?;
    fs::write(Path::new(&out).join("built_in_meshes.rs"), format!("&[\n{meshes}]\n"))
}

/// The names of the folder's files, in order: that of a folder's entries differs between machines.
fn files() -> io::Result<Vec<String>> {
    let mut names = Vec::new();
    for entry in fs::read_dir("scenes")? {
        names.push(entry?.file_name().to_string_lossy().into_owned());
    }
    names.sort_by(|a, b| a.rsplit_once('.').cmp(&b.rsplit_once('.')));
    Ok(names)
}
