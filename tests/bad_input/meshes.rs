//! The rows b44 to b49: paths of meshes that are not followed.

use crate::run::{answer, names_in, raywalk};
use std::fs;
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::Command;

/// A folder with a scene whose second object is the mesh `path`.
pub fn folder_with_mesh(path: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = format!(
        "{{\"format\": \"raywalk-scene/1\",\n \"camera\": {{\"position\": [0.3, 0.2, 5], \"direction\": [0, 0, -1]}},\n \
         \"objects\": [\n  {{\"name\": \"ball\", \"shape\": {{\"sphere\": {{\"center\": [50, 0, -9], \"radius\": 1}}}}}},\n  \
         {{\"name\": \"mesh\", \"shape\": {{\"mesh\": {{\"path\": \"{path}\"}}}}}}]}}\n"
    );
    fs::write(folder.path().join("t.json"), scene).expect("written");
    folder
}

/// The scene is refused at the path of its mesh, checked or rendered, and nothing is left behind. Gives the message.
#[track_caller]
fn refuses(path: &str, prepare: impl FnOnce(&Path), expected: &str) -> String {
    let folder = folder_with_mesh(path);
    prepare(folder.path());
    let before = names_in(folder.path());
    let checked = answer(&mut raywalk(folder.path(), &["scene", "check", "t.json"])).fails(2, "");
    let first = checked.message.lines().next().unwrap_or_default();
    assert_eq!(first, format!("error: t.json:5:47: objects[1].shape.mesh.path: {expected}"), "{}", checked.message);
    let rendered = answer(&mut raywalk(folder.path(), &["render", "t.json", "-o", "new.png"])).fails(2, "");
    assert_eq!(rendered.message, checked.message);
    assert_eq!(names_in(folder.path()), before);
    checked.message
}

fn nothing(_: &Path) {}

#[test]
fn b44_mesh_missing() {
    refuses("no.obj", nothing, "no such file, `no.obj`, expected a mesh");
}

#[test]
fn b45_mesh_traversal() {
    let expected = "must stay inside the scene's folder, found `../../../../etc/passwd`";
    let message = refuses("../../../../etc/passwd", nothing, expected);
    assert!(!message.contains("root:"), "{message}");
}

#[test]
fn b46_mesh_absolute() {
    let expected = "must be relative to the scene file, found the absolute path `/etc/passwd`";
    refuses("/etc/passwd", nothing, expected);
}

#[test]
fn b47_mesh_device() {
    refuses("/dev/zero", nothing, "must be relative to the scene file, found the absolute path `/dev/zero`");
    let device = |folder: &Path| symlink("/dev/zero", folder.join("zero.obj")).expect("a link");
    refuses("zero.obj", device, "expected a regular file at `zero.obj`, found a device");
}

#[test]
fn b48_mesh_fifo() {
    let fifo = |folder: &Path| make_fifo(&folder.join("fifo.obj"));
    refuses("fifo.obj", fifo, "expected a regular file at `fifo.obj`, found a FIFO");
}

#[test]
fn b49_mesh_self() {
    refuses("t.json", nothing, "`t.json` is the scene file itself, expected an OBJ or PLY file");
    let link = |folder: &Path| symlink("t.json", folder.join("link.obj")).expect("a link");
    refuses("link.obj", link, "`link.obj` is the scene file itself, expected an OBJ or PLY file");
}

/// Makes a pipe with a name.
pub fn make_fifo(path: &Path) {
    assert!(Command::new("mkfifo").arg(path).status().expect("mkfifo runs").success());
}
