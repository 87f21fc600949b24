//! The smallest invariant hull of some rows under matrices of joint spectral radius 1 or less.

use super::{AbsoluteHull, Rows, row_times};

/// Where a row of the hull comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// It is the seed of this number.
    Seed(usize),
    /// It is the image of a row by a matrix.
    Image {
        /// The row.
        of: usize,
        /// The matrix.
        by: usize,
    },
}

/// Where the image of a row by a matrix lies.
#[derive(Clone, Debug, PartialEq)]
pub enum Image {
    /// It is this row itself, or its negative.
    Row(usize),
    /// It is a combination of these rows with these coefficients, Σ|c_j| at most 1 up to rounding.
    Combination(Vec<(usize, f64)>),
}

/// An invariant hull.
#[derive(Clone, Debug)]
pub struct Closure {
    /// The rows.
    pub rows: Vec<Vec<f64>>,
    /// Where each comes from.
    pub origins: Vec<Origin>,
    /// For each row, its image by each matrix.
    pub images: Vec<Vec<Image>>,
}

/// When the search gives up.
#[derive(Clone, Copy, Debug)]
pub struct SearchCaps {
    /// The most rows.
    pub rows: usize,
    /// How far a gauge may be above 1 and count as 1.
    pub slack: f64,
    /// The most work: exchanges of a row, each times the number of rows and the size.
    pub work: u64,
}

/// Adds to `seeds` the images that are not in the hull yet, until all are; `None` when that takes more
/// rows or work than the caps, or the seeds do not span the space.
///
/// `known` holds the images of seeds that are seeds themselves: (seed, matrix, seed).
#[must_use]
pub fn close(
    matrices: &[Rows],
    seeds: Vec<Vec<f64>>,
    known: &[(usize, usize, usize)],
    caps: SearchCaps,
) -> Option<Closure> {
    let mut origins: Vec<Origin> = (0..seeds.len()).map(Origin::Seed).collect();
    let mut hull = AbsoluteHull::new(seeds)?;
    let mut images: Vec<Vec<Image>> = Vec::new();
    while images.len() < hull.rows().len() {
        let of = images.len();
        let mut own = Vec::with_capacity(matrices.len());
        for (by, matrix) in matrices.iter().enumerate() {
            let seed = known.iter().find(|(from, through, _)| (*from, *through) == (of, by));
            if let Some((_, _, to)) = seed {
                own.push(Image::Row(*to));
                continue;
            }
            let image = row_times(&hull.rows()[of], matrix);
            let gauge = hull.gauge(&image, 1.0 - 1e-9);
            let each = u64::try_from(hull.rows().len() * image.len()).unwrap_or(u64::MAX);
            if hull.exchanges().saturating_mul(each) > caps.work {
                return None;
            }
            if gauge.value <= 1.0 + caps.slack {
                own.push(Image::Combination(gauge.combination));
                continue;
            }
            if hull.rows().len() == caps.rows {
                return None;
            }
            own.push(Image::Row(hull.rows().len()));
            origins.push(Origin::Image { of, by });
            hull.push(image);
        }
        images.push(own);
    }
    Some(Closure { rows: hull.rows().to_vec(), origins, images })
}
