//! The entities, one method each: from numbers to records.

use super::MAX_PRIMITIVES;
use super::mistake::{Mistake, no_entity, quoted};
use super::reader::Reader;
use super::records::{Fill, Ignored, Light, Primitive, Records, View};
use super::shapes;
use super::tokens::Token;
use crate::scene::file::schema::MAX_LIGHTS;
use crate::scene::file::schema::{Shape, Vec3};
use crate::scene::file::validate::limits::MAX_SIDE;

/// Whether a file that begins with this token is NFF, or at least calls itself so.
pub fn may_begin_file(token: &[u8]) -> bool {
    token == b"nff" || ENTITIES.iter().any(|(entity, _)| entity.as_bytes() == token)
}

/// The entities and what they take.
const ENTITIES: &[(&str, &str)] = &[
    ("v", "`from`, `at`, `up`, `angle`, `hither` and `resolution`"),
    ("b", "3 numbers"),
    ("l", "3 or 6 numbers"),
    ("f", "8 numbers"),
    ("s", "4 numbers"),
    ("c", "8 numbers"),
    ("p", "the number of corners and 3 numbers for each"),
    ("pp", "the number of corners and 6 numbers for each"),
    ("tpp", "the number of corners and 8 numbers for each"),
    ("tess", "1 number"),
    ("shader", "a name"),
    ("number", "1 number"),
    ("g", "6 numbers"),
];

/// Reads a whole file.
pub fn read(text: &[u8]) -> Result<Records, Mistake> {
    let mut file = File { reader: Reader::new(text), view: None, records: Records::default() };
    let mut latest = None;
    while let Some(token) = file.reader.next() {
        if token.text == b"nff" && latest.is_none() {
            let message = "a file of Sense8 WorldToolKit, which begins with `nff`, expected the Neutral File Format of \
                           ray tracers";
            return Err(Mistake::at(&token, message));
        }
        let Some(entity) = ENTITIES.iter().find(|(entity, _)| entity.as_bytes() == token.text) else {
            return Err(no_entity(&token, latest));
        };
        file.entity(entity.0, token)?;
        latest = Some(*entity);
    }
    let end = file.reader.end();
    match file.view {
        Some(view) => Ok(Records { view, ..file.records }),
        None => Err(Mistake { span: end..end, message: "the file has no view, expected `v`".to_string() }),
    }
}

struct File<'t> {
    reader: Reader<'t>,
    view: Option<View>,
    records: Records,
}

impl File<'_> {
    fn entity(&mut self, name: &'static str, token: Token) -> Result<(), Mistake> {
        match name {
            "v" => self.view(token),
            "b" => self.background(token),
            "l" => self.light(token),
            "f" => self.fill(token),
            "s" => self.sphere(token),
            "c" => self.cone(token),
            "tess" => {
                // How finely other programs cut curved surfaces; here they stay curved.
                self.reader.passed(name, "the level").map(|_| ())
            }
            "number" | "g" => {
                self.pass_over(&token, "`number` and `g` count and bound what follows, and are ignored");
                let numbers = if name == "g" { 6 } else { 1 };
                (0..numbers).try_for_each(|_| self.reader.passed(name, "what follows").map(|_| ()))
            }
            "shader" => {
                self.pass_over(&token, "textures are not supported, `shader` is ignored");
                let missing = || Mistake::at(&token, "expected a name after `shader`, found the end of the file");
                self.reader.next().map(|_| ()).ok_or_else(missing)
            }
            _ => self.polygon(name, token),
        }
    }

    fn view(&mut self, entity: Token) -> Result<(), Mistake> {
        if self.view.is_some() {
            return Err(Mistake::at(&entity, "a second view `v`, expected one"));
        }
        let (mut from, mut at, mut up, mut angle, mut resolution) = (None, None, None, None, None);
        let reader = &mut self.reader;
        while let Some(token) = reader.peek() {
            let is_repeated = match token.text {
                b"from" => from.replace(reader.placed(|r| r.triple("from", "the eye"))?).is_some(),
                b"at" => at.replace(reader.placed(|r| r.triple("at", "the point"))?).is_some(),
                b"up" => up.replace(reader.placed(|r| r.triple("up", "the direction"))?).is_some(),
                b"angle" => angle.replace(reader.placed(view_angle)?).is_some(),
                b"resolution" => resolution.replace(reader.placed(view_resolution)?).is_some(),
                b"hither" => {
                    reader.placed(|r| r.passed("hither", "the distance"))?;
                    false
                }
                _ => break,
            };
            if is_repeated {
                return Err(Mistake::at(&token, format!("a second {} in the view, expected one", quoted(&token))));
            }
        }
        let lacks = |key: &str| Mistake::at(&entity, format!("the view lacks `{key}`, expected it after `v`"));
        self.view = Some(View {
            from: from.ok_or_else(|| lacks("from"))?,
            at: at.ok_or_else(|| lacks("at"))?,
            up: up.ok_or_else(|| lacks("up"))?,
            angle: angle.ok_or_else(|| lacks("angle"))?,
            resolution: resolution.ok_or_else(|| lacks("resolution"))?,
        });
        Ok(())
    }

    fn background(&mut self, entity: Token) -> Result<(), Mistake> {
        let color = self.reader.triple("b", "the colour")?;
        if self.records.background.replace((color, entity.start as u32)).is_some() {
            return Err(Mistake::at(&entity, "a second background `b`, expected one"));
        }
        Ok(())
    }

    fn light(&mut self, entity: Token) -> Result<(), Mistake> {
        let position = self.reader.triple("l", "the position")?;
        let has_color = self.reader.has_number();
        let color = if has_color { Some(self.reader.triple("l", "the colour")?) } else { None };
        if self.records.lights.len() == MAX_LIGHTS {
            return Err(Mistake::at(&entity, format!("too many lights, expected at most {MAX_LIGHTS}")));
        }
        self.records.lights.push(Light { position, color, at: entity.start as u32 });
        Ok(())
    }

    fn fill(&mut self, entity: Token) -> Result<(), Mistake> {
        let reader = &mut self.reader;
        let color = reader.triple("f", "the colour")?;
        let mut number = |what| reader.number("f", what);
        let [diffuse, specular, shine, transmittance] =
            [number("Kd")?, number("Ks")?, number("Shine")?, number("T")?].map(|(number, _)| number);
        let (ior, place) = number("the refractive index")?;
        if ior <= 0.0 && transmittance > 0.0 {
            let message = "the refractive index of a transmitting fill must be positive";
            return Err(Mistake::at(&place, format!("{message}, found {}", quoted(&place))));
        }
        // Opaque fills carry any index.
        let ior = if ior > 0.0 { ior } else { 1.0 };
        self.records.fills.push(Fill { color, diffuse, specular, shine, transmittance, ior, at: entity.start as u32 });
        self.after_fill();
        Ok(())
    }

    /// Some programs write an ambient factor, or the name of a texture, behind a fill.
    fn after_fill(&mut self) {
        if let Some(token) = self.reader.peek().filter(|token| token.number().is_some()) {
            self.reader.next();
            self.pass_over(&token, "NFF has no ambient light, a ninth number after `f` is ignored");
        } else if let Some(token) = self.reader.peek_in_line().filter(|token| !may_begin_file(token.text)) {
            self.reader.next();
            self.pass_over(&token, "textures are not supported, the name after `f` is ignored");
        }
    }

    fn sphere(&mut self, entity: Token) -> Result<(), Mistake> {
        let center = self.reader.triple("s", "the centre")?;
        let (radius, place) = self.reader.number("s", "the radius")?;
        let shape = shapes::sphere(center, radius).map_err(|message| Mistake::at(&place, message))?;
        self.primitive(entity, shape)
    }

    fn cone(&mut self, entity: Token) -> Result<(), Mistake> {
        let base = self.reader.triple("c", "the base")?;
        let (base_radius, _) = self.reader.number("c", "the base radius")?;
        let apex = self.reader.triple("c", "the apex")?;
        let (apex_radius, _) = self.reader.number("c", "the apex radius")?;
        let shape = shapes::cone(base, base_radius, apex, apex_radius);
        self.primitive(entity, shape.map_err(|message| Mistake::at(&entity, message))?)
    }

    /// `p`, `pp` or `tpp`.
    fn polygon(&mut self, name: &str, entity: Token) -> Result<(), Mistake> {
        let corners = self.reader.whole(name, "the number of corners", 3, u32::MAX)?;
        // The file may promise more corners than it has, so that nothing is reserved for them.
        let mut vertices: Vec<Vec3> = Vec::new();
        let mut normals: Vec<Vec3> = Vec::new();
        let mut has_all_normals = name != "p";
        for _ in 0..corners {
            vertices.push(self.reader.triple(name, "a corner")?);
            if name != "p" {
                let normal = self.reader.normal(name)?;
                has_all_normals &= normal.is_some();
                normals.extend(normal);
            }
            if name == "tpp" {
                self.reader.passed(name, "a texture coordinate")?;
                self.reader.passed(name, "a texture coordinate")?;
            }
        }
        if name == "tpp" {
            self.pass_over(&entity, "textures are not supported, the texture coordinates of `tpp` are ignored");
        }
        if name != "p" && !has_all_normals {
            self.pass_over(&entity, "a normal that is no number counts as none, its polygon is taken without normals");
        }
        match shapes::polygon(vertices, has_all_normals.then_some(normals)) {
            Some(shape) => self.primitive(entity, shape),
            None => {
                self.pass_over(&entity, "a polygon without area can't be hit and is left out");
                Ok(())
            }
        }
    }

    fn primitive(&mut self, entity: Token, shape: Shape) -> Result<(), Mistake> {
        let fills = self.records.fills.len() as u32;
        if fills == 0 {
            let message = format!("{} comes before the first fill, expected `f` before it", quoted(&entity));
            return Err(Mistake::at(&entity, message));
        }
        if self.records.primitives.len() == MAX_PRIMITIVES {
            return Err(Mistake::at(&entity, format!("too many primitives, expected at most {MAX_PRIMITIVES}")));
        }
        self.records.primitives.push(Primitive { shape, fill: fills - 1, at: entity.start as u32 });
        Ok(())
    }

    /// Remarks that something has no effect.
    fn pass_over(&mut self, token: &Token, what: &'static str) {
        match self.records.passed_over.iter_mut().find(|known| known.what == what) {
            Some(known) => known.count += 1,
            None => self.records.passed_over.push(Ignored { what, first: token.span(), count: 1 }),
        }
    }
}

fn view_angle(reader: &mut Reader) -> Result<f64, Mistake> {
    let (angle, place) = reader.number("angle", "the degrees")?;
    if 0.0 < angle && angle < 180.0 {
        return Ok(angle);
    }
    let found = quoted(&place);
    Err(Mistake::at(&place, format!("the angle must be between 0 and 180 degrees, both excluded, found {found}")))
}

fn view_resolution(reader: &mut Reader) -> Result<[u32; 2], Mistake> {
    let mut side = |what| reader.whole("resolution", what, 1, MAX_SIDE);
    Ok([side("the width")?, side("the height")?])
}
