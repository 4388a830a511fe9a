//! Values of quantities.

/// The value of a quantity: a number, or a triple (a point, a vector, a colour).
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Value {
    /// A number.
    Number(f64),
    /// A triple.
    Triple([f64; 3]),
}

impl Value {
    /// The components: one or three.
    pub fn components(&self) -> &[f64] {
        match self {
            Value::Number(number) => std::slice::from_ref(number),
            Value::Triple(triple) => triple,
        }
    }

    /// The number, if it is one.
    pub fn number(self) -> Option<f64> {
        match self {
            Value::Number(number) => Some(number),
            Value::Triple(_) => None,
        }
    }

    /// The triple, if it is one.
    pub fn triple(self) -> Option<[f64; 3]> {
        match self {
            Value::Number(_) => None,
            Value::Triple(triple) => Some(triple),
        }
    }

    /// Whether the two have the same bits.
    pub fn same_bits(&self, other: &Value) -> bool {
        let (ours, theirs) = (self.components(), other.components());
        ours.len() == theirs.len() && ours.iter().zip(theirs).all(|(a, b)| a.to_bits() == b.to_bits())
    }

    /// The value with a function of each component.
    pub fn map(self, f: impl Fn(f64) -> f64) -> Value {
        match self {
            Value::Number(number) => Value::Number(f(number)),
            Value::Triple(triple) => Value::Triple(triple.map(f)),
        }
    }
}
