//! Rows of fractions in echelon form.

#![warn(clippy::arithmetic_side_effects)]

use super::decimal::{Q, bits};
use super::meter::{Meter, product_steps};
use crate::text::Stop;
use num_traits::{One as _, Zero as _};
use std::collections::BTreeMap;

/// The entries of a row that are not 0, by their columns.
pub type Row<K> = BTreeMap<K, Q>;

/// Independent rows. Each begins with a 1, and no two in the same column.
pub struct Echelon<'m, K> {
    meter: &'m Meter,
    rows: BTreeMap<K, Row<K>>,
}

impl<'m, K: Ord + Clone> Echelon<'m, K> {
    /// No rows.
    pub fn new(meter: &'m Meter) -> Echelon<'m, K> {
        Echelon { meter, rows: BTreeMap::new() }
    }

    /// Adds a row, if it is no combination of those that are there; says whether this is so.
    pub fn add(&mut self, mut row: Row<K>) -> Result<bool, Stop> {
        row.retain(|_, x| !x.is_zero());
        self.meter.spend((self.rows.len() as u64 / 16).saturating_add(1))?;
        for (first, other) in &self.rows {
            self.clear(&mut row, first, other)?;
        }
        let Some((first, leading)) = row.first_key_value() else { return Ok(false) };
        let (first, scale) = (first.clone(), leading.recip());
        if !scale.is_one() {
            for x in row.values_mut() {
                self.meter.spend(product_steps(bits(x).saturating_add(bits(&scale))))?;
                *x *= &scale;
            }
        }
        self.rows.insert(first, row);
        Ok(true)
    }

    /// Subtracts the multiple of another row that leaves nothing in the column of its first entry.
    fn clear(&self, row: &mut Row<K>, first: &K, other: &Row<K>) -> Result<(), Stop> {
        let Some(factor) = row.get(first).cloned() else { return Ok(()) };
        for (column, x) in other {
            let entry = row.entry(column.clone()).or_insert_with(Q::zero);
            let bits = [&*entry, x, &factor].map(bits).into_iter().fold(0, u64::saturating_add);
            // The entries are looked up too.
            self.meter.spend(product_steps(bits).saturating_mul(2))?;
            *entry -= x * &factor;
            if entry.is_zero() {
                row.remove(column);
            }
        }
        Ok(())
    }

    /// The columns in which rows begin.
    pub fn firsts(&self) -> impl ExactSizeIterator<Item = &K> {
        self.rows.keys()
    }

    /// The reduced rows by the columns in which they begin: no other one has an entry there.
    pub fn reduced(mut self) -> Result<BTreeMap<K, Row<K>>, Stop> {
        let mut reduced = BTreeMap::new();
        while let Some((first, mut row)) = self.rows.pop_last() {
            for (column, other) in &reduced {
                self.clear(&mut row, column, other)?;
            }
            reduced.insert(first, row);
        }
        Ok(reduced)
    }
}
