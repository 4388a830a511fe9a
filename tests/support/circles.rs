//! Files that import each other, be it by way of others.

use super::source::SourceFile;
use std::collections::{BTreeMap, BTreeSet};

/// The circles of imports among these files: each is the files that reach one another, with the names that lead from one to the next.
///
/// A file may know the modules that it is a part of, as their parts may know it. A name that a module only hands on is that of the file
/// which has it, and a module that hands on a name without using it doesn't import it.
pub fn circles(files: &[SourceFile]) -> Vec<String> {
    let house = House::of(files);
    let arrows: Vec<_> = files.iter().map(|file| house.imported_by(file)).collect();
    let reached: Vec<_> = (0..files.len()).map(|file| reach(&arrows, file)).collect();
    let mut found = Vec::new();
    let mut known = BTreeSet::new();
    for file in 0..files.len() {
        let circle: Vec<usize> =
            reached[file].iter().copied().filter(|other| reached[*other].contains(&file)).collect();
        if circle.len() < 2 || !known.insert(circle.clone()) {
            continue;
        }
        let of_file = |from: &usize| {
            let to = arrows[*from].iter().filter(|(to, _)| circle.contains(to));
            to.map(|(to, names)| format!("{} -> {}: {}", files[*from].path, files[*to].path, names.join(", ")))
                .collect()
        };
        found.push(circle.iter().map(of_file).collect::<Vec<Vec<_>>>().concat().join("\n"));
    }
    found
}

/// By file, the names that another one takes from it.
type Arrows = BTreeMap<usize, Vec<String>>;

/// All files that lead on from one, and the file itself if they lead back to it.
fn reach(arrows: &[Arrows], from: usize) -> BTreeSet<usize> {
    let mut reached = BTreeSet::new();
    let mut next: Vec<usize> = arrows[from].keys().copied().collect();
    while let Some(file) = next.pop() {
        if reached.insert(file) {
            next.extend(arrows[file].keys());
        }
    }
    reached
}

/// The path of a module or of a name in it.
type Path = Vec<String>;

/// The files by their modules, and what each hands on.
struct House {
    modules: BTreeMap<Path, usize>,
    /// By module and name, the path that the name stands for.
    handed_on: BTreeMap<(Path, String), Path>,
}

impl House {
    fn of(files: &[SourceFile]) -> House {
        let mut house = House { modules: BTreeMap::new(), handed_on: BTreeMap::new() };
        for (number, file) in files.iter().enumerate().filter(|(_, file)| file.path != "main.rs") {
            house.modules.insert(path_of(file), number);
            for (at, path) in file.named_paths() {
                if let Some(name) = path.last().filter(|_| file.is_use(at)) {
                    house.handed_on.insert((path_of(file), name.clone()), path);
                }
            }
        }
        house
    }

    fn imported_by(&self, file: &SourceFile) -> Arrows {
        let module = path_of(file);
        let mut arrows = Arrows::new();
        for (at, path) in file.named_paths() {
            let is_handed_on_only =
                file.is_public_use(at) && path.last().is_some_and(|name| file.find(name).count() < 2);
            let Some((owner, name)) = self.owner_of(&path, 8).filter(|_| !is_handed_on_only) else { continue };
            if !module.starts_with(&owner) {
                let names = arrows.entry(self.modules[&owner]).or_default();
                if !names.contains(&name) {
                    names.push(name);
                }
            }
        }
        arrows
    }

    /// The module whose file has what a path names, and its name there.
    fn owner_of(&self, path: &[String], most: usize) -> Option<(Path, String)> {
        let length = (0..=path.len()).rev().find(|length| self.modules.contains_key(&path[..*length]))?;
        let (module, rest) = path.split_at(length);
        let name = rest.first().cloned().unwrap_or_default();
        match self.handed_on.get(&(module.to_vec(), name.clone())) {
            Some(other) if most > 0 && other[..] != path[..path.len().min(length + 1)] => {
                self.owner_of(&[other, &rest[1..]].concat(), most - 1)
            }
            _ => Some((module.to_vec(), name)),
        }
    }
}

fn path_of(file: &SourceFile) -> Path {
    file.module().into_iter().map(str::to_owned).collect()
}
