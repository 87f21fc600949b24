//! The two sides of a refuted theorem: a quantity of control data, and the bound.

#![warn(clippy::arithmetic_side_effects)]

use super::instance::first_level;
use crate::claims::Paper;
use crate::data::violated;
use crate::formulas::{Scope, formula_of};
use crate::numbers::{Q, Value, read_rational};
use crate::text::{Block, Checked, Reason, Toml, require};
use num_traits::Signed;

/// The greatest level of a witness.
pub const MAX_LEVEL: u32 = 64;

/// The quantity that a theorem bounds, and the level of the witness.
pub struct Stated<'a> {
    /// `difference`, `step` or `distance`.
    pub quantity: &'a str,
    /// The level.
    pub level: u32,
    /// ε, if the theorem bounds the depth.
    pub tolerance: Option<Value>,
}

impl<'a> Stated<'a> {
    /// Reads `tolerance …`, if the theorem bounds the depth, and `level …`.
    pub fn read(claim: &'a Toml, block: &mut Block<'_>) -> Checked<Stated<'a>> {
        let (bounds, mut tolerance) = (claim.text("bounds").unwrap_or_default(), None);
        if bounds == "depth" {
            let number = read_rational(block.after("tolerance")?).filter(Q::is_positive);
            tolerance = Some(Value::from(number.ok_or(Reason::Malformed("a positive number"))?));
        }
        let said = block.after("level")?;
        let from = first_level(claim)?;
        let level: u32 = said.parse().map_err(|_| Reason::Malformed("a level"))?;
        require((from..=MAX_LEVEL).contains(&level), Reason::Level)?;
        let quantity = if tolerance.is_some() { "distance" } else { bounds };
        Ok(Stated { quantity, level, tolerance })
    }

    /// Reads `sides …`, and checks that this quantity of data of these spreads violates the bound.
    pub fn violated(
        self,
        (paper, claim): (&Paper<'_>, &Toml),
        scope: Scope<'_>,
        block: &mut Block<'_>,
        spreads: &[Q],
        left: &Value,
    ) -> Checked<()> {
        let said = block.after("sides")?;
        violated(paper, said, left, &self.bound(claim, scope, spreads)?)
    }

    /// What the theorem says that the quantity is at most, of data of these spreads.
    pub fn bound(self, claim: &Toml, mut scope: Scope<'_>, spreads: &[Q]) -> Checked<Value> {
        let mut name = |name: &str, value: Value| scope.values.insert(name.to_owned(), value);
        name("beta", spreads.iter().max().cloned().unwrap_or_default().into());
        if let [first, second] = spreads {
            name("beta_1", first.clone().into());
            name("beta_2", second.clone().into());
            name("beta_3", first.clone().into());
        }
        match &self.tolerance {
            Some(tolerance) => name("epsilon", tolerance.clone()),
            None => name("k", Value::int(self.level.into())),
        };
        let by = scope.value(&formula_of(claim, "by")?)?;
        if self.tolerance.is_some() {
            // The theorem calls this level deep enough.
            require(by.compare(&Value::int(self.level.into()))?.is_le(), Reason::Level)?;
        }
        // A negative bound presupposes something that does not hold, such as a constant below 1.
        require(by.sign(None)? >= 0, Reason::Negative)?;
        Ok(self.tolerance.unwrap_or(by))
    }
}
