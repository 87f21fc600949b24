//! Distances in Z^d along edges.

#![warn(clippy::arithmetic_side_effects)]

use crate::numbers::Meter;
use crate::schemes::{Vector, plus};
use crate::text::Stop;
use std::collections::HashMap;

/// The most vectors whose distances are found.
const MAX_VECTORS: usize = 1 << 20;

/// How many edges lead from 0 to vectors: their numbers are found on all of Z^d, ball by ball around 0, since the shortest way between two
/// points may leave each box around them.
pub(super) struct Distances<'m> {
    meter: &'m Meter,
    /// The edges with both signs.
    edges: Vec<Vector>,
    /// The distances up to that of the last ball.
    known: HashMap<Vector, i64>,
    /// The vectors at the greatest of these distances.
    last: Vec<Vector>,
}

impl<'m> Distances<'m> {
    /// The distances along these edges, of which all vectors are integer combinations.
    pub(super) fn new(meter: &'m Meter, edges: &[Vector]) -> Result<Distances<'m>, Stop> {
        let signed = |edge: &Vector| [Ok(*edge), plus([0; 3], -1, *edge)];
        let edges = edges.iter().flat_map(signed).collect::<Result<Vec<Vector>, Stop>>()?;
        Ok(Distances { meter, edges, known: HashMap::from([([0; 3], 0)]), last: vec![[0; 3]] })
    }

    /// The distance of a vector from 0.
    pub(super) fn of(&mut self, vector: Vector) -> Result<i64, Stop> {
        loop {
            if let Some(known) = self.known.get(&vector) {
                return Ok(*known);
            }
            self.grow()?;
        }
    }

    /// Finds the vectors at the next distance: those that one more edge leads to, and that are not known.
    fn grow(&mut self) -> Result<(), Stop> {
        let mut next = Vec::new();
        for from in &self.last {
            self.meter.spend(self.edges.len() as u64)?;
            let distance = self.known.get(from).map_or(0, |known| known.saturating_add(1));
            for edge in &self.edges {
                let to = plus(*from, 1, *edge)?;
                self.known.entry(to).or_insert_with(|| {
                    next.push(to);
                    distance
                });
            }
            if self.known.len() > MAX_VECTORS {
                return Err(Stop::Capped("the distances along edges"));
            }
        }
        self.last = next;
        Ok(())
    }
}
