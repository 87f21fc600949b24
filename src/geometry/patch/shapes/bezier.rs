//! The polynomials of regular pieces (`proofs/THEOREMS.md`, 93).

use super::regular::{Layout, number, weighted};
use crate::characteristic::{BOX_SPLINE_BEZIER, BOX_SPLINE_POINTS, CUBIC_BEZIER, QUADRATIC_BEZIER};
use crate::mesh::MeshScheme;
use crate::patch::number::{Number, Row};

/// The Bézier coefficients of a piece, each with the weights, over the corners of the piece, of the
/// linear or bilinear interpolant there.
pub(crate) type Bezier<W> = Vec<(Row<W>, Row<W>)>;

impl<W: Number> Layout<W> {
    /// The Bézier coefficients. The first ones are at the corners of the piece.
    pub(super) fn bezier(&self) -> Bezier<W> {
        match self.scheme {
            MeshScheme::CatmullClark | MeshScheme::Bajaj => self.tensor(&CUBIC_BEZIER, 6),
            MeshScheme::DooSabin => self.tensor(&QUADRATIC_BEZIER, 2),
            MeshScheme::Loop | MeshScheme::LoopWarren => self.quartic(),
        }
    }

    fn tensor<const N: usize>(&self, masks: &[[i64; N]], unit: i64) -> Bezier<W> {
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
            let weights = BOX_SPLINE_POINTS.iter().zip(BOX_SPLINE_BEZIER[index]);
            let terms: Vec<(W, &Row<W>)> = weights
                .filter(|(_, weight)| *weight != 0)
                .map(|(place, weight)| (number(weight, 24), &self.at[place]))
                .collect();
            let plain = (0..3_u32).zip([4 - i - j, i, j]).filter(|(_, weight)| *weight != 0);
            let plain = plain.map(|(corner, weight)| (corner, number(weight, 4)));
            (weighted(&terms), plain.collect())
        };
        places.enumerate().map(coefficient).collect()
    }
}
