//! The picture: its dots as far as they are there, the cursor pixel in it, and how it is looked at.

use crate::log::Value;
use crate::report::language::Language;
use std::fmt;
use std::sync::Arc;

/// A picture that may still be in the making. Of a very large one only every `step`-th pixel of a row and column is there.
#[derive(Clone)]
pub struct Image {
    /// Columns and rows of the picture.
    pub size: [u32; 2],
    /// How many pixels lie between neighbouring dots.
    pub step: u32,
    /// The dots row by row.
    pub dots: Vec<Option<Dot>>,
    /// What a file would hold of a colour that is brighter by this many stops.
    pub levels: Levels,
    /// The value that is shown as full white; infinite where no exposure may be chosen for it.
    pub white: f64,
    /// What of the pixels was asked for by name.
    pub named: Option<Named>,
}

/// What `:picture` asks for by name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Named {
    /// The name, safe to be shown.
    pub title: String,
    /// How it is shown.
    pub shows: Shows,
}

/// How the values of a name are shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shows {
    /// Numbers, in false colours.
    Numbers,
    /// Light, as the picture is.
    Light,
    /// Directions, points and other triples: x, y and z as red, green and blue.
    Triples,
}

/// From a colour and stops of exposure to three bytes.
pub type Levels = Arc<dyn Fn([f64; 3], f64) -> [u8; 3] + Send + Sync>;

/// A pixel of the picture.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Dot {
    /// The colour, in linear light.
    pub color: [f64; 3],
    /// The distance to what its first sample sees; `None` where that is the background.
    pub depth: Option<f64>,
    /// How many rays it took.
    pub rays: u32,
    /// How many samples.
    pub samples: u32,
    /// By how much single precision misses the colour, in the worst channel; `None` until that is known.
    pub error: Option<f64>,
    /// What was asked for by name; `None` where the pixel has no such value.
    pub named: Option<Value>,
    /// Whether it is only what one of its samples says, until the others are traced.
    pub is_rough: bool,
}

/// What of the pixels is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layer {
    /// The colours.
    Colors,
    /// How far away.
    Depth,
    /// How many rays.
    Rays,
    /// How many samples.
    Samples,
    /// How wrong single precision is.
    Error,
    /// What was asked for by name.
    Named,
}

/// How the picture is looked at.
#[derive(Clone, Debug)]
pub struct PictureView {
    /// The picture.
    pub image: Arc<Image>,
    /// The pixel that is walked through.
    pub cursor: [u32; 2],
    /// What is shown.
    pub layer: Layer,
    /// Half stops of exposure, on top of those that fit.
    pub exposure: i32,
    /// Half stops of exposure that fit the picture into what can be shown.
    pub fitting: i32,
    /// How often it is enlarged twofold, from the whole picture on.
    pub zoom: u32,
    /// Whether nothing more of it is to come.
    pub is_finished: bool,
}

impl fmt::Debug for Image {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Image {:?}, {} of {} dots", self.size, self.done(), self.dots.len())
    }
}

impl Image {
    /// The picture of this size without any dots; the step is the least with which it has no more than 2²⁰ dots.
    pub fn empty(size: [u32; 2], levels: Levels) -> Image {
        let step = (1..).find(|step| dots_of(size, *step) <= MOST_DOTS).unwrap_or(1);
        Image { size, step, dots: vec![None; dots_of(size, step)], levels, white: f64::INFINITY, named: None }
    }

    /// Columns of dots.
    pub fn columns(&self) -> u32 {
        self.size[0].div_ceil(self.step)
    }

    /// Rows of dots.
    pub fn rows(&self) -> u32 {
        self.size[1].div_ceil(self.step)
    }

    /// How many dots are there with all of their samples.
    pub fn done(&self) -> usize {
        self.dots.iter().flatten().filter(|dot| !dot.is_rough).count()
    }

    /// The number of a pixel's dot.
    pub fn index(&self, [x, y]: [u32; 2]) -> usize {
        (y / self.step) as usize * self.columns() as usize + (x / self.step) as usize
    }

    /// The dot of a pixel, or the nearest one up and to the left of a coarser grid while it isn't there.
    pub fn at(&self, [x, y]: [u32; 2]) -> Option<&Dot> {
        let (column, row) = ((x / self.step).min(self.columns() - 1), (y / self.step).min(self.rows() - 1));
        (0..=COARSEST).find_map(|coarse| {
            let [column, row] = [column, row].map(|number| number >> coarse << coarse);
            self.dots[row as usize * self.columns() as usize + column as usize].as_ref()
        })
    }

    /// The mean over the dots whose middles lie within an area, from its left to its right edge and from its upper to its lower one; the
    /// nearest dot where there is none.
    pub fn mean<const N: usize>(&self, area: [[f64; 2]; 2], of: impl Fn(&Dot) -> Option<[f64; N]>) -> Option<[f64; N]> {
        let step = f64::from(self.step);
        let counts = [self.columns(), self.rows()];
        let [columns, rows] = [0, 1].map(|axis| {
            let [from, to] = area[axis].map(|edge| (edge / step - 0.5).ceil().max(0.0) as u32);
            from.min(counts[axis])..to.min(counts[axis])
        });
        let (mut sum, mut count) = ([0.0; N], 0_u32);
        for row in rows {
            let start = row as usize * counts[0] as usize;
            let dots = &self.dots[start + columns.start as usize..start + columns.end.max(columns.start) as usize];
            for value in dots.iter().flatten().filter_map(&of) {
                sum = std::array::from_fn(|at| sum[at] + value[at]);
                count += 1;
            }
        }
        if count > 0 {
            return Some(sum.map(|sum| sum / f64::from(count)));
        }
        let middle = [0, 1].map(|axis| (area[axis][0] + area[axis][1]) / 2.0);
        let is_inside = (0..2).all(|axis| middle[axis] >= 0.0 && middle[axis] < self.size[axis].into());
        if is_inside { of(self.at(middle.map(|place| place as u32))?) } else { None }
    }

    /// The half stops of exposure with which no more than a fiftieth of the dots is above white; none for a picture that isn't above it.
    pub fn fitting_exposure(&self) -> i32 {
        let brightest = |dot: &Dot| dot.color.into_iter().fold(0.0, f64::max);
        let mut values: Vec<f64> = self.dots.iter().flatten().map(brightest).filter(|x| x.is_finite()).collect();
        let Some(last) = values.len().checked_sub(1) else { return 0 };
        let at = last - last / 50;
        let (_, value, _) = values.select_nth_unstable_by(at, f64::total_cmp);
        let above = libm::log2(*value / self.white);
        if above > 0.0 { -((2.0 * above).ceil().min(60.0) as i32) } else { 0 }
    }

    /// The pixels with a value, from the top left on.
    pub fn values(&self, of: impl Fn(&Dot) -> Option<f64>) -> impl Iterator<Item = ([u32; 2], f64)> {
        let columns = self.columns() as usize;
        let pixel = move |at: usize| [at % columns, at / columns].map(|place| place as u32 * self.step);
        self.dots.iter().enumerate().filter_map(move |(at, dot)| Some((pixel(at), of(dot.as_ref()?)?)))
    }

    /// The least and the greatest component of the triples that were asked for by name; from −1 to 1 where those are all within.
    pub fn range_of_triples(&self) -> Option<[f64; 2]> {
        let values = self.dots.iter().flatten().filter_map(|dot| triple(dot.named)).flatten();
        let found = values.fold(None, |range: Option<[f64; 2]>, value| {
            let [least, greatest] = range.unwrap_or([value; 2]);
            Some([least.min(value), greatest.max(value)])
        });
        found.map(|[least, greatest]| if least >= -1.0 && greatest <= 1.0 { [-1.0, 1.0] } else { [least, greatest] })
    }

    /// Whether no pixel has what was asked for by name, as far as one knows.
    pub fn lacks_named(&self) -> bool {
        self.dots.iter().flatten().all(|dot| dot.named.is_none())
    }

    /// The least and the greatest value of a layer.
    pub fn range(&self, layer: Layer) -> Option<[f64; 2]> {
        let values = self.dots.iter().flatten().filter_map(|dot| layer.of(dot));
        values.fold(None, |range, value| {
            let [least, greatest] = range.unwrap_or([value; 2]);
            Some([least.min(value), greatest.max(value)])
        })
    }
}

/// The components of a triple.
pub fn triple(value: Option<Value>) -> Option<[f64; 3]> {
    match value? {
        Value::Triple(triple) => Some(triple),
        Value::Number(_) => None,
    }
}

/// The first dots are those of every 2^5-th column and row.
pub const COARSEST: u32 = 5;

/// The most dots of a picture.
const MOST_DOTS: usize = 1 << 20;

fn dots_of([width, height]: [u32; 2], step: u32) -> usize {
    width.div_ceil(step) as usize * height.div_ceil(step) as usize
}

impl Layer {
    /// All layers in the order in which they are shown.
    pub const ALL: [Layer; 6] = [Layer::Colors, Layer::Depth, Layer::Rays, Layer::Samples, Layer::Error, Layer::Named];

    /// The words of those that every picture has, as they are typed.
    pub const WORDS: [(&'static str, Layer); 5] = [
        ("color", Layer::Colors),
        ("depth", Layer::Depth),
        ("rays", Layer::Rays),
        ("samples", Layer::Samples),
        ("error", Layer::Error),
    ];

    /// By what the pixels of a layer are ranked: its values, and the brightness of colours.
    pub fn rank(self, dot: &Dot) -> Option<f64> {
        match (self, dot.named) {
            (Layer::Colors, _) => Some(dot.color.iter().sum()),
            (Layer::Named, Some(Value::Triple(triple))) => Some(triple.iter().sum()),
            _ => self.of(dot),
        }
    }

    /// The value of a dot; `None` for a colour and for what isn't known.
    pub fn of(self, dot: &Dot) -> Option<f64> {
        match self {
            Layer::Colors => None,
            Layer::Depth => dot.depth,
            Layer::Rays => (!dot.is_rough).then(|| dot.rays.into()),
            Layer::Samples => (!dot.is_rough).then(|| dot.samples.into()),
            Layer::Error => dot.error,
            Layer::Named => dot.named.and_then(|value| value.number()),
        }
    }
}

impl PictureView {
    /// The whole picture, with the cursor at this pixel.
    pub fn new(image: Arc<Image>, cursor: [u32; 2]) -> PictureView {
        let fitting = image.fitting_exposure();
        PictureView { image, cursor, layer: Layer::Colors, exposure: 0, fitting, zoom: 0, is_finished: false }
    }

    /// Shows a picture with more dots.
    pub fn show(&mut self, image: Arc<Image>) {
        self.is_finished = image.dots.iter().all(|dot| dot.is_some_and(|dot| dot.error.is_some()));
        self.fitting = image.fitting_exposure();
        if image.named.is_none() && self.layer == Layer::Named {
            self.layer = Layer::Colors;
        }
        self.image = image;
    }

    /// What is shown.
    pub fn title(&self, language: Language) -> &str {
        match &self.image.named {
            Some(named) if self.layer == Layer::Named => &named.title,
            // Nothing was asked for by name.
            _ => language.texts().viewer.panes.picture.layers[(self.layer as usize).min(Layer::Error as usize)],
        }
    }

    /// How the values are shown that were asked for by name, if they are shown.
    pub fn shows_named(&self) -> Option<Shows> {
        self.image.named.as_ref().filter(|_| self.layer == Layer::Named).map(|named| named.shows)
    }

    /// What of the picture is seen on a screen of this many dots.
    pub fn seen(&self, screen: [u32; 2]) -> Wanted {
        let under = || (0..screen[1]).flat_map(|row| (0..screen[0]).map(move |column| [column, row]));
        match self.layer {
            Layer::Colors => {
                Wanted::Pixels(under().filter_map(|dot| self.pixel_under(screen, dot)).chain([self.cursor]).collect())
            }
            // The colours of the others reach from the least value of all dots to the greatest.
            Layer::Depth | Layer::Rays | Layer::Samples | Layer::Named => {
                let [width, height] = self.image.size;
                let lines = (0..height).step_by(self.image.step as usize);
                Wanted::Pixels(
                    lines.flat_map(|y| (0..width).step_by(self.image.step as usize).map(move |x| [x, y])).collect(),
                )
            }
            Layer::Error => Wanted::All,
        }
    }

    /// The stops of exposure with which the picture is shown.
    pub fn stops(&self) -> f64 {
        f64::from(self.exposure + self.fitting) / 2.0
    }

    /// The area of the picture under a dot of such a screen, along each axis; `None` beyond the picture.
    pub fn area_under(&self, screen: [u32; 2], dot: [u32; 2]) -> Option<[[f64; 2]; 2]> {
        self.pixel_under(screen, dot)?;
        let (scale, start) = self.window(screen);
        Some([0, 1].map(|axis| [0, 1].map(|side| start[axis] + scale * f64::from(dot[axis] + side))))
    }

    /// How many pixels a dot of the screen stands for, on a screen of this many dots, and where the first one lies.
    pub fn window(&self, [columns, rows]: [u32; 2]) -> (f64, [f64; 2]) {
        let [width, height] = self.image.size.map(f64::from);
        let whole = (width / f64::from(columns.max(1))).max(height / f64::from(rows.max(1)));
        let scale = whole / f64::from(1_u32 << self.zoom.min(MOST_ZOOM));
        let start = |cursor: u32, size: f64, dots: u32| {
            let shown = scale * f64::from(dots);
            let middle = f64::from(cursor) + 0.5 - shown / 2.0;
            if shown >= size { (size - shown) / 2.0 } else { middle.clamp(0.0, size - shown) }
        };
        let [x, y] = self.cursor;
        (scale, [start(x, width, columns), start(y, height, rows)])
    }

    /// The pixel under a dot of such a screen.
    pub fn pixel_under(&self, screen: [u32; 2], [column, row]: [u32; 2]) -> Option<[u32; 2]> {
        let (scale, [left, top]) = self.window(screen);
        let x = left + scale * (f64::from(column) + 0.5);
        let y = top + scale * (f64::from(row) + 0.5);
        let is_inside = x >= 0.0 && y >= 0.0 && x < self.image.size[0].into() && y < self.image.size[1].into();
        is_inside.then_some([x as u32, y as u32])
    }

    /// Another layer.
    pub fn next_layer(&mut self) {
        let count = Layer::ALL.len() - usize::from(self.image.named.is_none());
        self.layer = Layer::ALL[(self.layer as usize + 1) % count];
    }

    /// Brighter by these half stops.
    pub fn expose(&mut self, half_stops: i64) {
        self.exposure = (i64::from(self.exposure) + half_stops).clamp(-60, 60) as i32;
    }
}

/// What somebody wants to see of a picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Wanted {
    /// What there is already.
    Latest,
    /// These pixels, with all of their samples.
    Pixels(Vec<[u32; 2]>),
    /// Everything.
    All,
}

/// The most that the picture is enlarged, in powers of two.
pub const MOST_ZOOM: u32 = 12;
