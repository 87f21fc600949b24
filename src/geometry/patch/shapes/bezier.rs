//! The polynomials of regular pieces (`proofs/THEOREMS.md`, 93).

use super::regular::{Layout, Place, number, weighted};
use crate::mesh::MeshScheme;
use crate::patch::number::{Number, Row};

/// The Bézier coefficients of a piece, each with the weights, over the corners of the piece, of the
/// linear or bilinear interpolant there.
pub(in crate::patch) type Bezier<W> = Vec<(Row<W>, Row<W>)>;

/// The Bézier coefficients of the quartic triangle of 12 points with the corners (0, 0), (1, 0),
/// (0, 1), times 24: for each place the coefficients B_{i,j}, in the order i = 0, …, 4, j = 0, …, 4 − i.
/// The exponent i belongs to (1, 0), and j to (0, 1).
const QUARTIC: [(Place, [i32; 15]); 12] = [
    ((-1, 0), [2, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]),
    ((-1, 1), [2, 3, 4, 3, 2, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0]),
    ((-1, 2), [0, 0, 0, 1, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]),
    ((0, -1), [2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0]),
    ((0, 0), [12, 12, 8, 4, 2, 12, 10, 6, 3, 8, 6, 4, 4, 3, 2]),
    ((0, 1), [2, 4, 8, 12, 12, 3, 6, 10, 12, 4, 6, 8, 3, 4, 2]),
    ((0, 2), [0, 0, 0, 0, 2, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0]),
    ((1, -1), [2, 1, 0, 0, 0, 3, 1, 0, 0, 4, 1, 0, 3, 1, 2]),
    ((1, 0), [2, 3, 4, 3, 2, 4, 6, 6, 4, 8, 10, 8, 12, 12, 12]),
    ((1, 1), [0, 0, 0, 1, 2, 0, 0, 1, 3, 0, 1, 4, 1, 3, 2]),
    ((2, -1), [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 2]),
    ((2, 0), [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 2]),
];

impl<W: Number> Layout<W> {
    /// The Bézier coefficients. The first ones are at the corners of the piece.
    pub(in crate::patch) fn bezier(&self) -> Bezier<W> {
        match self.scheme {
            MeshScheme::CatmullClark | MeshScheme::Bajaj => self.tensor(
                &[[1, 4, 1, 0], [0, 4, 2, 0], [0, 2, 4, 0], [0, 1, 4, 1]].map(|row| row.to_vec()),
                6,
            ),
            MeshScheme::DooSabin => {
                self.tensor(&[[1, 1, 0], [0, 2, 0], [0, 1, 1]].map(|row| row.to_vec()), 2)
            }
            MeshScheme::Loop | MeshScheme::LoopWarren => self.quartic(),
        }
    }

    fn tensor(&self, masks: &[Vec<i64>], unit: i64) -> Bezier<W> {
        let last = masks.len() - 1;
        let index = |i: usize| i32::try_from(i).unwrap_or(i32::MAX);
        let mut all = Vec::new();
        for i in 0..=last {
            for j in 0..=last {
                let mut terms = Vec::new();
                for (a, x) in masks[i].iter().enumerate() {
                    for (b, y) in masks[j].iter().enumerate() {
                        if x * y != 0 {
                            let row = &self.at[&(index(a), index(b))];
                            terms.push((number::<W>(x * y, unit * unit), row));
                        }
                    }
                }
                let [s, t] = [i, j].map(|i| i64::try_from(i).unwrap_or(0));
                let n = i64::try_from(last).unwrap_or(1);
                let corners = [(n - s) * (n - t), s * (n - t), s * t, (n - s) * t];
                let plain = (0..4_u32).zip(corners).filter(|(_, weight)| *weight != 0);
                let plain = plain.map(|(corner, weight)| (corner, number(weight, n * n)));
                all.push((weighted(&terms), plain.collect()));
            }
        }
        all
    }

    fn quartic(&self) -> Bezier<W> {
        let places = (0..5).flat_map(|i| (0..5 - i).map(move |j| (i, j)));
        let coefficient = |(index, (i, j)): (usize, (i64, i64))| {
            let terms: Vec<(W, &Row<W>)> = QUARTIC
                .iter()
                .filter(|(_, weights)| weights[index] != 0)
                .map(|(place, weights)| (number(i64::from(weights[index]), 24), &self.at[place]))
                .collect();
            let plain = (0..3_u32).zip([4 - i - j, i, j]).filter(|(_, weight)| *weight != 0);
            let plain = plain.map(|(corner, weight)| (corner, number(weight, 4)));
            (weighted(&terms), plain.collect())
        };
        places.enumerate().map(coefficient).collect()
    }
}
