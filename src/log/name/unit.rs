//! What quantities are measured in. A unit belongs to the key: whatever formula gives a quantity, it has the same unit.

/// What a quantity is measured in. The components of a triple have the same.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Unit {
    /// A number without a unit: a ratio, a cosine, a component of a unit vector, a coefficient of a material, a random number.
    One,
    /// So many of something, or which of several.
    Count,
    /// A length in the units of the scene.
    Length,
    /// A length times a length.
    Area,
    /// An area times a length.
    Volume,
    /// One over a length.
    PerLength,
    /// One over an area.
    PerArea,
    /// The intensity of light, in the unit in which the scene states its lights; linear, not clipped.
    Intensity,
    /// Columns and rows of the picture.
    Pixels,
    /// One over pixels.
    PerPixel,
    /// Time, in the unit of the objects' motions.
    Time,
    /// A length per time.
    LengthPerTime,
    /// An angle in degrees.
    Degrees,
    /// Degrees per time.
    DegreesPerTime,
}

impl Unit {
    /// How the unit is written in tables.
    pub fn text(self) -> &'static str {
        match self {
            Unit::One => "1",
            Unit::Count => "count",
            Unit::Length => "length",
            Unit::Area => "length²",
            Unit::Volume => "length³",
            Unit::PerLength => "1/length",
            Unit::PerArea => "1/length²",
            Unit::Intensity => "intensity",
            Unit::Pixels => "pixels",
            Unit::PerPixel => "1/pixels",
            Unit::Time => "time",
            Unit::LengthPerTime => "length/time",
            Unit::Degrees => "degrees",
            Unit::DegreesPerTime => "degrees/time",
        }
    }

    /// The exponents of length, intensity, time and angle. Counts and places in the picture are numbers.
    pub fn dimension(self) -> [i32; 4] {
        match self {
            Unit::One | Unit::Count | Unit::Pixels | Unit::PerPixel => [0; 4],
            Unit::Length => [1, 0, 0, 0],
            Unit::Area => [2, 0, 0, 0],
            Unit::Volume => [3, 0, 0, 0],
            Unit::PerLength => [-1, 0, 0, 0],
            Unit::PerArea => [-2, 0, 0, 0],
            Unit::Intensity => [0, 1, 0, 0],
            Unit::Time => [0, 0, 1, 0],
            Unit::LengthPerTime => [1, 0, -1, 0],
            Unit::Degrees => [0, 0, 0, 1],
            Unit::DegreesPerTime => [0, 0, -1, 1],
        }
    }
}
