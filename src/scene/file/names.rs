//! Names that the file leaves out. A log names everything, so everything gets a name.

use std::collections::HashSet;
use std::path::Path;

use super::escape::visible;
use super::packed::unpacked_name;
use super::schema::SceneFile;

/// Fills in the scene's name (the file's stem, without `.gz` or `.zst`) and the names of objects and lights (`object-3`, `light-1`).
pub fn fill_in_names(scene: &mut SceneFile, file_name: &str) {
    if scene.name.is_empty() {
        let stem = Path::new(unpacked_name(file_name)).file_stem().unwrap_or_default();
        let stem = stem.to_string_lossy();
        // A name in a file may not hold control characters; that of a file may.
        scene.name = visible(stem.trim_matches(['<', '>'])).into_owned();
    }
    fill_in("object", scene.objects.iter_mut().map(|object| &mut object.name).collect());
    fill_in("light", scene.lights.iter_mut().map(|light| &mut light.name).collect());
}

fn fill_in(kind: &str, names: Vec<&mut String>) {
    if names.iter().all(|name| !name.is_empty()) {
        return;
    }
    let taken: HashSet<String> = names.iter().map(|name| name.to_string()).filter(|name| !name.is_empty()).collect();
    for (index, name) in names.into_iter().enumerate().filter(|(_, name)| name.is_empty()) {
        *name = format!("{kind}-{}", index + 1);
        while taken.contains(name) {
            name.push('\'');
        }
    }
}
