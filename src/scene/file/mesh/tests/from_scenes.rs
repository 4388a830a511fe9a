//! Meshes that scenes name, with the catalogue of bad inputs, b44 to b49.

use std::fs;
use std::path::Path;

use super::super::{Folder, Meshes, load};
use super::SQUARE;
use crate::files::{FileError, Problem, Source};
use crate::scene::file::check;

/// A folder with a mesh, and the text of a scene in it that names these.
pub(super) fn folder_and_scene(paths: &[&str]) -> (tempfile::TempDir, String) {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("square.obj"), SQUARE).unwrap();
    let object = |path: &&str| format!("\n    {{\"shape\": {{\"mesh\": {{\"path\": \"{path}\"}}}}}}");
    let objects: Vec<_> = paths.iter().map(object).collect();
    let scene = format!(
        "{{\"format\": \"raywalk-scene/1\",\n  \"camera\": {{\"position\": [0, 0, 9], \"direction\": [0, 0, -1]}},\n  \
         \"objects\": [{}]}}",
        objects.join(",")
    );
    fs::write(folder.path().join("scene.json"), &scene).unwrap();
    (folder, scene)
}

pub(super) fn load_in(folder: &Path, text: &str) -> Result<(Meshes, Vec<Problem>), FileError> {
    let scene = check(text.as_bytes(), "scene.json").unwrap().scene;
    let source = Source { name: "scene.json", text: text.as_bytes() };
    load(&scene, &source, Folder::OfScene(&folder.join("scene.json"))).map(|(meshes, warnings)| (meshes, warnings.told))
}

/// The message, with the folder's name left out.
#[track_caller]
fn refuses(path: &str, prepare: impl FnOnce(&Path), expected: &str) {
    let (folder, text) = folder_and_scene(&["square.obj", path]);
    prepare(folder.path());
    let error = load_in(folder.path(), &text).unwrap_err();
    assert_eq!(error.exit_code(), 2);
    let found = error.to_string().replace(&format!("{}/", folder.path().display()), "");
    assert_eq!(found, expected);
}

#[test]
fn each_mesh_is_read_once() {
    let (folder, text) = folder_and_scene(&["square.obj", "./square.obj", "square.obj"]);
    let (meshes, warnings) = load_in(folder.path(), &text).unwrap();
    assert_eq!(meshes.digests().count(), 2);
    assert_eq!(meshes.get("square.obj").unwrap().faces.len(), 2);
    assert!(warnings.is_empty());
}

#[test]
fn b44_mesh_missing() {
    let at = "scene.json:5:33: objects[1].shape.mesh.path:";
    refuses("no.obj", |_| {}, &format!("{at} no such file, `no.obj`, expected a mesh"));
}

#[test]
fn every_path_that_leads_nowhere_is_said() {
    let (folder, text) = folder_and_scene(&["a.obj", "square.obj", "b.obj"]);
    let error = load_in(folder.path(), &text).unwrap_err();
    assert_eq!(error.problems().len(), 2);
}

#[test]
fn b45_mesh_through_a_link() {
    let link = |folder: &Path| {
        #[cfg(unix)]
        std::os::unix::fs::symlink("/etc/passwd", folder.join("link.obj")).unwrap();
    };
    let expected = "`link.obj` is a link out of the scene's folder, expected a file inside it";
    refuses("link.obj", link, &format!("scene.json:5:33: objects[1].shape.mesh.path: {expected}"));
}

#[test]
fn b47_mesh_device_and_folder() {
    let make = |folder: &Path| fs::create_dir(folder.join("folder.obj")).unwrap();
    let expected = "expected a regular file at `folder.obj`, found a directory";
    refuses("folder.obj", make, &format!("scene.json:5:33: objects[1].shape.mesh.path: {expected}"));
}

#[test]
fn b49_mesh_self() {
    let expected = "`scene.json` is the scene file itself, expected an OBJ or PLY file";
    refuses("scene.json", |_| {}, &format!("scene.json:5:33: objects[1].shape.mesh.path: {expected}"));
}

#[test]
fn a_file_of_another_kind() {
    let make = |folder: &Path| fs::write(folder.join("a.stl"), "solid").unwrap();
    let expected = "unknown kind of mesh, expected a name that ends in .obj or .ply";
    refuses("a.stl", make, &format!("scene.json:5:33: objects[1].shape.mesh.path: {expected}"));
}

#[test]
fn a_bad_mesh_is_named_with_its_line() {
    let make = |folder: &Path| fs::write(folder.join("bad.obj"), "v 0 0 0\nf 1 1 2\n").unwrap();
    refuses("bad.obj", make, "bad.obj:2:7: there is no vertex 2, the file has one vertex");
}

#[test]
fn warnings_name_the_mesh() {
    let (folder, text) = folder_and_scene(&["thin.obj"]);
    fs::write(folder.path().join("thin.obj"), "v 0 0 0\nf 1 1 1\n").unwrap();
    let (_, warnings) = load_in(folder.path(), &text).unwrap();
    assert!(warnings[0].to_string().ends_with("thin.obj: 1 of 1 triangles has no area and is skipped"));
}

#[test]
fn built_in_meshes_are_not_looked_for_on_the_disk() {
    let (_folder, text) = folder_and_scene(&["square.obj"]);
    let scene = check(text.as_bytes(), "scene.json").unwrap().scene;
    let source = Source { name: "scene.json", text: text.as_bytes() };
    let error = load(&scene, &source, Folder::BuiltIn(|_| None)).unwrap_err();
    assert!(error.to_string().ends_with("no such built-in mesh, `square.obj`"), "{error}");
}
