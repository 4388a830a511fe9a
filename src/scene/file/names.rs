//! Names that the file leaves out. A log names everything, so everything gets a name.

use std::collections::HashSet;
use std::path::Path;

use super::schema::SceneFile;
use crate::files::escape::escape_hidden;
use crate::files::unpacked_name;
use compact_str::{CompactString, format_compact};

/// Fills in the scene's name (the file's stem, without `.gz` or `.zst`) and the names of objects and lights (`object-3`, `light-1`).
pub fn fill_in_names(scene: &mut SceneFile, file_name: &str) {
    if scene.name.is_empty() {
        let stem = Path::new(unpacked_name(file_name)).file_stem().unwrap_or_default();
        let stem = stem.to_string_lossy();
        // A name in a file may not hold control characters; that of a file may.
        scene.name = escape_hidden(stem.trim_matches(['<', '>'])).into_owned();
    }
    fill_in("object", &mut scene.objects, |object| &mut object.name);
    fill_in("light", &mut scene.lights, |light| &mut light.name);
}

fn fill_in<T>(kind: &str, all: &mut [T], name_of: fn(&mut T) -> &mut CompactString) {
    // Of a million names only those matter that one may come to be called by.
    let is_like_ours = |name: &str| name.strip_prefix(kind).is_some_and(|rest| rest.starts_with('-'));
    let names = all.iter_mut().map(|each| &*name_of(each));
    let taken: HashSet<CompactString> = names.filter(|name| is_like_ours(name)).cloned().collect();
    for (index, name) in all.iter_mut().map(name_of).enumerate().filter(|(_, name)| name.is_empty()) {
        *name = format_compact!("{kind}-{}", index + 1);
        while taken.contains(name) {
            name.push('\'');
        }
    }
}
