//! The tags of a page or a picture, as far as the tests ask.

use std::collections::HashSet;

/// What is found in a page.
#[derive(Default)]
pub struct Page {
    /// Every `id`.
    pub ids: HashSet<String>,
    /// Where links within the page lead.
    pub links: Vec<String>,
    /// The names of all tags that open.
    pub names: Vec<String>,
    /// What is text.
    pub text: String,
}

/// Reads a page in which every tag is closed; what isn't well formed fails.
#[track_caller]
pub fn read(page: &str) -> Page {
    const VOID: [&str; 1] = ["meta"];
    let mut found = Page::default();
    let mut open: Vec<String> = Vec::new();
    let mut rest = page;
    while let Some(start) = rest.find('<') {
        found.text.push_str(&rest[..start]);
        let end = start + rest[start..].find('>').expect("a tag ends");
        let tag = &rest[start + 1..end];
        rest = &rest[end + 1..];
        if tag.starts_with(['!', '?']) {
            continue;
        }
        if let Some(name) = tag.strip_prefix('/') {
            assert_eq!(open.pop().as_deref(), Some(name), "closed before {}", &rest[..rest.len().min(80)]);
            continue;
        }
        let name = tag.split([' ', '\n', '/']).next().unwrap_or("").to_owned();
        attributes(tag, &mut found);
        if ["style", "script"].contains(&name.as_str()) {
            // Their text isn't markup.
            rest = &rest[rest.find(&format!("</{name}>")).expect("it ends")..];
        }
        if !tag.ends_with('/') && !VOID.contains(&name.as_str()) {
            open.push(name.clone());
        }
        found.names.push(name);
    }
    assert!(open.is_empty(), "left open: {open:?}");
    found
}

#[track_caller]
fn attributes(tag: &str, found: &mut Page) {
    let value = |key: &str| {
        let (_, rest) = tag.split_once(&format!(" {key}=\""))?;
        Some(rest.split('"').next().unwrap_or("").to_owned())
    };
    if let Some(id) = value("id") {
        assert!(found.ids.insert(id.clone()), "{id} is there twice");
    }
    found.links.extend(value("href"));
    assert_eq!(tag.matches('"').count() % 2, 0, "{tag}");
}
