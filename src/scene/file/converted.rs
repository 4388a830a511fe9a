//! From one long list to another, without having both at once.

use std::hint::black_box;

/// After this many items the memory that they took is given back.
const GIVEN_BACK: usize = 1 << 12;

/// Converts each item of a list, with its number. The memory of the one list is given back while the other grows.
///
/// # Errors
/// The first that `convert` gives.
pub fn converted<T, U, E>(mut from: Vec<T>, mut convert: impl FnMut(usize, T) -> Result<U, E>) -> Result<Vec<U>, E> {
    let mut made = Vec::with_capacity(from.len());
    // A list gives room back at its end.
    from.reverse();
    while let Some(each) = from.pop() {
        made.push(convert(made.len(), each)?);
        if from.len().is_multiple_of(GIVEN_BACK) {
            from.shrink_to_fit();
            // Allocators keep small pieces that are free one by one. To be asked for something larger makes them join those that are neighbours, and what
            // is made next may be larger than what it was made of.
            drop(black_box(Vec::<u8>::with_capacity(1 << 16)));
        }
    }
    Ok(made)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn everything_is_converted_in_its_order() {
        let numbers: Vec<usize> = (0..3 * GIVEN_BACK + 5).collect();
        let doubled = converted(numbers, |at, number| if at == number { Ok(2 * number) } else { Err(at) });
        assert_eq!(doubled, Ok((0..3 * GIVEN_BACK + 5).map(|number| 2 * number).collect()));
    }

    #[test]
    fn the_first_error_ends_it() {
        let refused = converted(vec![1, 2, 3], |_, number| if number == 1 { Ok(()) } else { Err(number) });
        assert_eq!(refused, Err(2));
    }
}
