use super::*;
use crate::files::FileError;

/// A file of these letters and numbers.
fn file(letters: &str, head: &[u64], floats: &[f32], whole: &[u32]) -> Vec<u8> {
    let mut bytes = letters.as_bytes().to_vec();
    bytes.extend(head.iter().flat_map(|number| number.to_le_bytes()));
    bytes.extend(floats.iter().flat_map(|number| number.to_le_bytes()));
    bytes.extend(whole.iter().flat_map(|number| number.to_le_bytes()));
    bytes
}

fn rays(question: u32, reserved: u32, count: u64, numbers: &[f32]) -> Vec<u8> {
    let mut bytes = b"RWRAYS01".to_vec();
    bytes.extend([question, 2, 1, reserved].iter().flat_map(|number| number.to_le_bytes()));
    bytes.extend(count.to_le_bytes());
    bytes.extend(numbers.iter().flat_map(|number| number.to_le_bytes()));
    bytes
}

const CORNERS: [f32; 9] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
const RAY: [f32; 8] = [0.25, 0.25, 1.0, 0.0, 0.0, 0.0, -1.0, f32::INFINITY];

#[track_caller]
fn refuses<T>(read: Result<T, FileError>, expected: &str) {
    match read {
        Ok(_) => panic!("read, expected {expected}"),
        Err(error) => {
            assert_eq!(error.exit_code(), 2);
            assert_eq!(error.to_string(), format!("x: {expected}"));
        }
    }
}

#[test]
fn good_files_are_read() {
    let mesh = parse_mesh(&file("RWMESH01", &[3, 1], &CORNERS, &[0, 1, 2]), "x").map_err(|error| error.to_string());
    let mesh = mesh.unwrap_or_else(|message| panic!("{message}"));
    assert_eq!((mesh.positions.len(), &mesh.faces[..]), (3, &[[0, 1, 2]][..]));
    let spheres = parse_spheres(&file("RWSPHR01", &[1], &[1.0, 2.0, 3.0, 0.5], &[]), "x").map_err(|e| e.to_string());
    assert_eq!(spheres, Ok(vec![RawSphere { center: [1.0, 2.0, 3.0], radius: 0.5 }]));
    let read = parse_rays(&rays(1, 0, 1, &RAY), "x").map_err(|error| error.to_string());
    let ray = RawRay { origin: [0.25, 0.25, 1.0], t_min: 0.0, direction: [0.0, 0.0, -1.0], t_max: f32::INFINITY };
    assert_eq!(read, Ok(RayFile { question: Question::Occlusion, resolution: [2, 1], rays: vec![ray] }));
}

#[test]
fn foreign_empty_and_short_files() {
    refuses(parse_mesh(b"", "x"), "is empty, expected it to begin with `RWMESH01`");
    refuses(parse_rays(b"RWMESH01", "x"), "expected it to begin with `RWRAYS01`, found `RWMESH01`");
    refuses(parse_spheres(b"\x1b[2J", "x"), "expected it to begin with `RWSPHR01`, found `\\u{1b}[2J`");
    refuses(parse_rays(b"RWRAYS01ab", "x"), "ends within its head, expected 32 bytes, found 10");
}

#[test]
fn counts_that_do_not_fit_the_length() {
    let short = file("RWMESH01", &[3, 2], &CORNERS, &[0, 1, 2]);
    refuses(
        parse_mesh(&short, "x"),
        "its head says 3 vertices and 2 triangles, which are 84 bytes in all, found 72 bytes",
    );
    let long = file("RWSPHR01", &[0], &[0.0], &[]);
    refuses(parse_spheres(&long, "x"), "its head says 0 spheres, which are 16 bytes in all, found 20 bytes");
    refuses(parse_rays(&rays(0, 0, 0, &[]), "x"), "holds no rays");
    let huge = file("RWSPHR01", &[u64::MAX], &[], &[]);
    let most = "too many spheres, expected at most 4194304, found 18446744073709551615";
    refuses(parse_spheres(&huge, "x"), most);
}

#[test]
fn numbers_that_mean_nothing() {
    let mut corners = CORNERS;
    corners[4] = f32::NAN;
    let mesh = file("RWMESH01", &[3, 1], &corners, &[0, 1, 2]);
    refuses(parse_mesh(&mesh, "x"), "vertex 1: expected finite numbers, found NaN (at byte 40)");
    let mesh = file("RWMESH01", &[3, 1], &CORNERS, &[0, 1, 3]);
    refuses(parse_mesh(&mesh, "x"), "triangle 0: expected vertices by their numbers below 3, found 3");
    let flat = file("RWSPHR01", &[1], &[0.0, 0.0, 0.0, -1.0], &[]);
    refuses(parse_spheres(&flat, "x"), "sphere 0: the radius must be positive, found -1");
    refuses(parse_rays(&rays(2, 0, 1, &RAY), "x"), "expected the question 0 (nearest hit) or 1 (any hit), found 2");
    refuses(parse_rays(&rays(0, 7, 1, &RAY), "x"), "expected 0 behind width and height, found 7");
    let changed = |k: usize, value| {
        let mut ray = RAY;
        ray[k] = value;
        rays(0, 0, 1, &ray)
    };
    refuses(parse_rays(&changed(6, 0.0), "x"), "ray 0: expected a direction that is not zero");
    refuses(parse_rays(&changed(7, f32::NAN), "x"), "ray 0: expected a number as t_max, found NaN");
    refuses(parse_rays(&changed(3, f32::INFINITY), "x"), "ray 0: expected finite numbers, found inf (at byte 44)");
}
