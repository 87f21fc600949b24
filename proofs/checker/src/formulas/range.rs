//! The terms of `sum`, `product`, `max` and `min` over an index.

#![warn(clippy::arithmetic_side_effects)]

use super::formula::Expr;
use crate::text::Stop;

/// The first and the last value of an index, and the formula of its terms.
pub fn range(parts: &[Expr]) -> Result<&[Expr; 3], Stop> {
    parts.try_into().map_err(|_| Stop::Wrong("a range is missing".into()))
}

/// What a fold over an empty range gives, if it has a value there.
pub fn of_nothing(fold: &str) -> Option<i64> {
    match fold {
        "sum" => Some(0),
        "product" => Some(1),
        _ => None,
    }
}

/// The values of an index, with those of other indices.
pub struct Range<'r, I> {
    /// Its name.
    pub index: &'r str,
    /// The first and the last value.
    pub ends: [i64; 2],
    /// The indices around it.
    pub others: &'r mut Vec<(String, I)>,
    /// An integer as a value of an index.
    pub value: fn(i64) -> I,
}

impl<I> Range<'_, I> {
    /// What all terms give together. Without terms it is `none`, if there is such a value.
    pub fn total<T>(
        self,
        none: Option<T>,
        term: impl Fn(&mut Vec<(String, I)>) -> Result<T, Stop>,
        join: impl Fn(&T, &T) -> Result<T, Stop>,
    ) -> Result<T, Stop> {
        let ([first, last], mut total) = (self.ends, none);
        for i in first..=last {
            self.others.push((self.index.to_owned(), (self.value)(i)));
            let term = term(self.others);
            self.others.pop();
            total = Some(match total {
                None => term?,
                Some(total) => join(&total, &term?)?,
            });
        }
        total.ok_or_else(|| Stop::Wrong("a maximum or minimum has an empty range".into()))
    }
}
