//! A basis in which all matrices are block triangular. proofs/format/radius.md, Blocks.

use super::element::Element;
use super::matrices::{Matrix, multiplied};
use crate::numbers::{Meter, Q, unit};
use crate::text::{At, RadiusChecked as Checked, RadiusReason, require};
use std::ops::Range;

/// What a certificate says of it, with the lines.
#[derive(Default)]
pub struct Blocks {
    pub basis: Option<(usize, Vec<Vec<Q>>)>,
    pub inverse: Option<(usize, Vec<Vec<Q>>)>,
    pub sizes: Option<(usize, Vec<usize>)>,
}

impl Blocks {
    /// The matrices with the blocks alone, in the basis, and the places of the blocks; of one block, where there are no
    /// lines of a basis.
    pub fn applied(
        &self,
        matrices: Vec<Matrix>,
        end: usize,
        meter: &Meter,
    ) -> Checked<(Vec<Matrix>, Vec<Range<usize>>)> {
        let size = matrices[0].len();
        let (basis, inverse, (line, sizes)) = match (&self.basis, &self.inverse, &self.sizes) {
            (None, None, None) => return Ok((matrices, std::iter::once(0..size).collect())),
            (Some(basis), Some(inverse), Some(sizes)) => (basis, inverse, sizes),
            _ => {
                let all = RadiusReason::Malformed("`basis`, `inverse` and `blocks` together");
                return Err(all.into()).at(end);
            }
        };
        let square = |(line, rows): &(usize, Vec<Vec<Q>>)| -> Checked<Matrix> {
            let fits = rows.len() == size && rows.iter().all(|row| row.len() == size);
            require(fits, RadiusReason::Size).at(*line)?;
            Ok(rows.iter().map(|row| row.iter().map(Element::fraction).collect()).collect())
        };
        let (from, to) = (square(basis)?, square(inverse)?);
        let product = multiplied(&from, &to, meter).map_err(Into::into).at(inverse.0)?;
        let one = unit(size, [0, 1].map(Element::whole));
        let pairs = product.iter().flatten().zip(one.iter().flatten());
        let is_inverse = pairs.into_iter().all(|(x, y)| x.minus(y).sign() == 0);
        require(is_inverse, RadiusReason::Inverse).at(inverse.0)?;
        let (mut places, mut start) = (Vec::new(), 0_usize);
        for &block in sizes {
            let stop = start.checked_add(block).filter(|stop| start < *stop && *stop <= size);
            let stop = stop.ok_or(RadiusReason::Size.into()).at(*line)?;
            places.push(start..stop);
            start = stop;
        }
        require(start == size, RadiusReason::Size).at(*line)?;
        let mut diagonal = Vec::with_capacity(matrices.len());
        for matrix in &matrices {
            let moved = multiplied(&from, matrix, meter).map_err(Into::into).at(*line)?;
            let mut moved = multiplied(&moved, &to, meter).map_err(Into::into).at(*line)?;
            for place in &places {
                for row in &mut moved[place.clone()] {
                    let triangular = row[place.end..].iter().all(|x| x.sign() == 0);
                    require(triangular, RadiusReason::Triangular).at(*line)?;
                    row[..place.start].fill(Element::whole(0));
                }
            }
            diagonal.push(moved);
        }
        Ok((diagonal, places))
    }
}
