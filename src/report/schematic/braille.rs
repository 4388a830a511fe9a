//! The schematic as text: lines of braille dots, letters and names over them.

use super::{Plan, Point};
use crate::files::escape::{cells, escape_hidden};

/// The size of a character, in units of the plan: labels that don't cover each other there don't here.
const CELL: [f64; 2] = [7.4, 15.4];

/// The figure as lines of text.
pub fn braille(plan: &Plan) -> String {
    let [columns, rows] = [0, 1].map(|axis| (plan.size[axis] / CELL[axis]).ceil().max(1.0) as usize);
    let mut grid = vec![vec![0_u8; columns]; rows];
    for ray in &plan.rays {
        draw(&mut grid, ray.from, ray.to, ray.is_blocked);
    }
    let dots = |dots: &u8| if *dots == 0 { ' ' } else { char::from_u32(0x2800 + u32::from(*dots)).unwrap_or(' ') };
    let mut text: Vec<Vec<String>> =
        grid.iter().map(|row| row.iter().map(|cell| dots(cell).to_string()).collect()).collect();
    let mut put = |[x, y]: Point, label: &str| {
        let label = escape_hidden(label);
        // A wide letter takes the place of two.
        let mut label_cells: Vec<&str> = Vec::new();
        for (cell, width) in cells(&label) {
            label_cells.push(cell);
            label_cells.resize(label_cells.len() + width.saturating_sub(1), "");
        }
        let label = label_cells;
        let row = ((y / CELL[1]) as usize).min(rows - 1);
        let middle = (x / CELL[0]) as usize;
        let first = middle.saturating_sub(label.len() / 2).min(columns.saturating_sub(label.len()));
        for (cell, character) in text[row].iter_mut().skip(first).zip(&label) {
            *cell = (*character).to_owned();
        }
    };
    plan.points.iter().for_each(|place| put(*place, "●"));
    plan.lights.iter().for_each(|place| put(*place, "☼"));
    plan.eye.iter().for_each(|place| put(*place, "◉"));
    plan.labels.iter().for_each(|label| put(label.at, &label.text));
    let lines: Vec<String> = text.iter().map(|row| row.concat().trim_end().to_owned()).collect();
    let first = lines.iter().position(|line| !line.is_empty()).unwrap_or(0);
    lines[first..].join("\n").trim_end().to_owned()
}

/// Draws a line of dots, four rows and two columns of which are a character.
fn draw(grid: &mut [Vec<u8>], from: Point, to: Point, is_dashed: bool) {
    const DOTS: [[u8; 2]; 4] = [[0x01, 0x08], [0x02, 0x10], [0x04, 0x20], [0x40, 0x80]];
    let dot = |place: Point| [place[0] / CELL[0] * 2.0, place[1] / CELL[1] * 4.0];
    let ([x1, y1], [x2, y2]) = (dot(from), dot(to));
    let steps = (x2 - x1).abs().max((y2 - y1).abs()).ceil().clamp(1.0, 4000.0) as u32;
    for step in 0..=steps {
        if is_dashed && step % 4 > 1 {
            continue;
        }
        let part = f64::from(step) / f64::from(steps);
        let (x, y) = (x1 + (x2 - x1) * part, y1 + (y2 - y1) * part);
        if x < 0.0 || y < 0.0 {
            continue;
        }
        let (x, y) = (x as usize, y as usize);
        if let Some(cell) = grid.get_mut(y / 4).and_then(|row| row.get_mut(x / 2)) {
            *cell |= DOTS[y % 4][x % 2];
        }
    }
}
