//! Schemes: their masks and difference masks.

use crate::reject::Stop;
use crate::value::Value;

/// The most rules of a scheme.
pub const MAX_ARITY: usize = 64;

/// The most points of a rule.
pub const MAX_WIDTH: usize = 256;

/// A mask with its difference mask.
pub struct Scheme {
    /// The mask a_{α,j}, with a row for each rule α.
    pub mask: Vec<Vec<Value>>,
    /// The difference mask b_{β,j}.
    pub difference: Vec<Vec<Value>>,
    /// The offset o.
    pub offset: i64,
}

impl Scheme {
    /// The scheme of a mask.
    pub fn new(mask: Vec<Vec<Value>>, offset: i64) -> Result<Scheme, Stop> {
        let width = mask.first().map_or(0, Vec::len);
        let even = mask.iter().all(|row| row.len() == width);
        if !(2..=MAX_ARITY).contains(&mask.len()) || !(1..=MAX_WIDTH).contains(&width) || !even {
            return Err(wrong("the number or the lengths of its rules are wrong"));
        }
        for row in &mask {
            if Value::total(row)? != Value::int(1) {
                return Err(wrong("a rule does not sum to 1"));
            }
        }
        // b_{n−1,j} = a_{0,j} − Σ_{β<n−1} b_{β,j}
        let (mut difference, mut last) = (Vec::new(), mask[0].clone());
        for pair in mask.windows(2) {
            // b_{β,j} = Σ_{h≤j} (a_{β,h} − a_{β+1,h})
            let (mut sum, mut row) = (Value::int(0), Vec::new());
            for (j, rest) in last.iter_mut().enumerate() {
                sum = sum.plus(1, &pair[0][j])?.minus(&pair[1][j])?;
                *rest = rest.minus(&sum)?;
                row.push(sum.clone());
            }
            difference.push(row);
        }
        difference.push(last);
        Ok(Scheme { mask, difference, offset })
    }

    /// The arity n.
    pub fn arity(&self) -> usize {
        self.mask.len()
    }

    /// The width N.
    pub fn width(&self) -> usize {
        self.mask[0].len()
    }
}

fn wrong(what: &str) -> Stop {
    Stop::Wrong(format!("`mask`: {what}"))
}
