//! Numbers from tokens, or what is in their place.

use super::mistake::{Mistake, no_number, quoted};
use super::records::Placed;
use super::tokens::{Token, Tokens};
use crate::scene::file::schema::Vec3;

/// Reads what an entity takes.
pub struct Reader<'t> {
    tokens: Tokens<'t>,
}

impl<'t> Reader<'t> {
    /// Reads this text from its beginning.
    pub fn new(text: &'t [u8]) -> Self {
        Self { tokens: Tokens::new(text) }
    }

    /// The next token.
    pub fn next(&mut self) -> Option<Token<'t>> {
        self.tokens.next()
    }

    /// The next token, which stays the next.
    pub fn peek(&self) -> Option<Token<'t>> {
        self.tokens.peek()
    }

    /// The next token if it is on the line of the latest one; it stays the next.
    pub fn peek_in_line(&self) -> Option<Token<'t>> {
        if self.tokens.goes_on_in_line() { self.peek() } else { None }
    }

    /// Whether a number comes next.
    pub fn has_number(&self) -> bool {
        self.peek().is_some_and(|token| token.number().is_some())
    }

    /// Just behind the latest token.
    pub fn end(&self) -> usize {
        self.tokens.end()
    }

    /// The next number, which is `what` of `entity`, and its token.
    pub fn number(&mut self, entity: &str, what: &str) -> Result<(f64, Token<'t>), Mistake> {
        let end = self.end();
        let token = self.tokens.next();
        match token.and_then(|token| Some((token.number()?, token))) {
            Some(found) => Ok(found),
            None => Err(no_number(token.as_ref(), end, entity, what)),
        }
    }

    /// The next number, which may be infinite or none: nobody asks how large it is.
    pub fn passed(&mut self, entity: &str, what: &str) -> Result<f64, Mistake> {
        let end = self.end();
        let token = self.tokens.next();
        let number = token.and_then(|token| token.any_number());
        number.ok_or_else(|| no_number(token.as_ref(), end, entity, what))
    }

    /// A normal, if all three of its numbers are finite.
    pub fn normal(&mut self, entity: &str) -> Result<Option<Vec3>, Mistake> {
        let mut next = || self.passed(entity, "a normal");
        let normal = [next()?, next()?, next()?];
        Ok(normal.iter().all(|number| number.is_finite()).then_some(normal))
    }

    /// Three numbers.
    pub fn triple(&mut self, entity: &str, what: &str) -> Result<Vec3, Mistake> {
        let mut next = || Ok(self.number(entity, what)?.0);
        Ok([next()?, next()?, next()?])
    }

    /// A whole number from `low` to `high`.
    pub fn whole(&mut self, entity: &str, what: &str, low: u32, high: u32) -> Result<u32, Mistake> {
        let (number, token) = self.number(entity, what)?;
        if number.fract() == 0.0 && (f64::from(low)..=f64::from(high)).contains(&number) {
            return Ok(number as u32);
        }
        let found = quoted(&token);
        Err(Mistake::at(
            &token,
            format!("{what} of `{entity}` must be a whole number from {low} to {high}, found {found}"),
        ))
    }

    /// The next token, a keyword, and the value behind it.
    pub fn placed<T>(&mut self, value: impl FnOnce(&mut Self) -> Result<T, Mistake>) -> Result<Placed<T>, Mistake> {
        let at = self.tokens.next().map_or(0, |token| token.start as u32);
        Ok(Placed { value: value(self)?, at })
    }
}
