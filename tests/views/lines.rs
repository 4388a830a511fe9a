//! Rays as lines in space, as OBJ and as PLY.

use crate::calls::prints;
use crate::support::snapshots;
use insta::assert_snapshot;

/// The vertices of a file, and its groups with their lines.
struct Lines {
    vertices: Vec<[f64; 3]>,
    groups: Vec<(String, Vec<[usize; 2]>)>,
    length: f64,
}

#[track_caller]
fn read(text: &str) -> Lines {
    let mut lines = Lines { vertices: Vec::new(), groups: Vec::new(), length: f64::NAN };
    for line in text.lines() {
        let words: Vec<&str> = line.split(' ').collect();
        let number = |word: &str| word.parse::<f64>().expect(line);
        match words[..] {
            ["#", .., "drawn", length, "long"] => lines.length = number(length),
            ["#", ..] => {}
            ["g", name] => lines.groups.push((name.to_owned(), Vec::new())),
            ["v", x, y, z] => lines.vertices.push([x, y, z].map(number)),
            ["l", from, to] => {
                let ends = [from, to].map(|end| end.parse::<usize>().expect(line));
                assert!(ends.iter().all(|end| (1..=lines.vertices.len()).contains(end)), "{line}");
                lines.groups.last_mut().expect("a group").1.push(ends);
            }
            _ => panic!("{line}"),
        }
    }
    lines
}

fn length(lines: &Lines, [from, to]: [usize; 2]) -> f64 {
    let (from, to) = (lines.vertices[from - 1], lines.vertices[to - 1]);
    (0..3).map(|axis| (to[axis] - from[axis]) * (to[axis] - from[axis])).sum::<f64>().sqrt()
}

#[test]
fn the_numeric_example() {
    let text = prints(&["trace", "textbook", "--pixel", "160,120", "--arithmetic", "decimal:3", "--format", "obj"]);
    snapshots().bind(|| assert_snapshot!("rays_textbook_obj", text));
}

#[test]
fn rays_that_meet_nothing_have_the_length_that_is_stated() {
    let text = prints(&["trace", "figure-6", "--pixel", "160,120", "--format", "obj"]);
    let lines = read(&text);
    let names: Vec<_> = lines.groups.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["camera", "reflected", "transmitted", "shadow", "shadow_blocked"]);
    let is_long = |group: &str| {
        let (_, rays) = lines.groups.iter().find(|(name, _)| name == group).expect(group);
        rays.iter().filter(|ray| (length(&lines, **ray) / lines.length - 1.0).abs() < 1e-12).count()
    };
    // As the walk says: C R R R, C R R T and C T R T hit nothing.
    assert_eq!(["camera", "reflected", "transmitted"].map(is_long), [0, 1, 2]);
    assert_eq!(lines.vertices.len(), 2 * lines.groups.iter().map(|(_, rays)| rays.len()).sum::<usize>());
}

#[test]
fn of_a_ray_and_of_a_region() {
    let away = read(&prints(&["trace", "textbook", "--ray", "0,0,0,-3,0,-4", "--format", "obj"]));
    assert_eq!(away.vertices.len(), 2);
    assert!((length(&away, [1, 2]) - away.length).abs() < 1e-12 && away.length > 0.0);
    let region = read(&prints(&["trace", "textbook", "--region", "160,120,162,122", "--format", "obj"]));
    assert_eq!(region.groups[0].1.len(), 4, "a ray from the eye for each pixel");
    for ray in &region.groups[0].1 {
        assert_eq!(region.vertices[ray[0] - 1], [16.0, 2.0, 7.0]);
    }
}

/// A vertex of a PLY file and its colour.
type Vertex = ([f64; 3], [u8; 3]);

/// The vertices of a PLY file, and its edges.
#[track_caller]
fn read_ply(text: &str) -> (Vec<Vertex>, Vec<[usize; 2]>) {
    let (header, body) = text.split_once("end_header\n").expect("a header");
    let count = |element: &str| -> usize {
        let line = header.lines().find_map(|line| line.strip_prefix("element ")?.strip_prefix(element));
        line.expect(element).trim().parse().expect(element)
    };
    let vertices: Vec<_> = body.lines().take(count("vertex")).map(vertex).collect();
    let edges = body.lines().skip(count("vertex"));
    let edges: Vec<[usize; 2]> = edges
        .map(|line| {
            let (from, to) = line.split_once(' ').expect(line);
            [from, to].map(|end| end.parse().expect(line))
        })
        .collect();
    assert_eq!((vertices.len(), edges.len()), (count("vertex"), count("edge")));
    (vertices, edges)
}

fn vertex(line: &str) -> Vertex {
    let words: Vec<&str> = line.split(' ').collect();
    let [x, y, z, red, green, blue] = words[..] else { panic!("{line}") };
    ([x, y, z].map(|word| word.parse().expect(line)), [red, green, blue].map(|word| word.parse().expect(line)))
}

#[test]
fn both_formats_have_the_same_lines() {
    let calls: [&[&str]; 3] = [
        &["trace", "figure-6", "--pixel", "160,120"],
        &["trace", "textbook", "--region", "160,120,162,122"],
        &["trace", "textbook", "--ray", "0,0,0,-3,0,-4"],
    ];
    for call in calls {
        let obj = read(&prints(&[call, &["--format", "obj"]].concat()));
        let text = prints(&[call, &["--format", "ply"]].concat());
        let (vertices, edges) = read_ply(&text);
        assert_eq!(vertices.iter().map(|(place, _)| *place).collect::<Vec<_>>(), obj.vertices);
        let lines = obj.groups.iter().flat_map(|(_, lines)| lines);
        assert_eq!(edges, lines.map(|[from, to]| [from - 1, to - 1]).collect::<Vec<_>>());
        // A kind has a colour, which the header names.
        for (name, rays) in &obj.groups {
            for end in rays.iter().flatten() {
                let [red, green, blue] = vertices[end - 1].1;
                assert!(text.contains(&format!("comment color {red} {green} {blue}: {name}\n")), "{name}");
            }
        }
    }
}

#[test]
fn the_numeric_example_as_ply() {
    let text = prints(&["trace", "textbook", "--pixel", "160,120", "--arithmetic", "decimal:3", "--format", "ply"]);
    snapshots().bind(|| assert_snapshot!("rays_textbook_ply", text));
}
