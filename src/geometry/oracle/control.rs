//! Control polygons and control grids to refine.

use super::refine::MAX_VALUES;
use crate::exact::Rational;

/// A control polygon of numbers x_0, …, x_{m−1} or of points, or a control grid x_{i,j} of numbers,
/// row by row.
///
/// ```
/// use subcert::oracle::Control;
///
/// let control = Control::seeded_polygon(7, 4);
/// assert_eq!(control, Control::seeded_polygon(7, 4));
/// assert_eq!((control.rows(), control.columns()), (4, 1));
/// assert_eq!(control.seed(), Some(7));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Control {
    values: Vec<Rational>,
    /// The second and further coordinates of points; the first one is `values`.
    others: Vec<Vec<Rational>>,
    columns: usize,
    seed: Option<u64>,
    grid: bool,
}

impl Control {
    /// The polygon with these values: numbers of any type that converts into a [`Rational`].
    #[must_use]
    pub fn polygon(values: Vec<impl Into<Rational>>) -> Control {
        Control::points(vec![values])
    }

    /// The polygon of points with these coordinates: the list of all x, the list of all y, and so
    /// on, all of the same length.
    ///
    /// # Panics
    /// When the lists have different lengths.
    ///
    /// ```
    /// use subcert::oracle::Control;
    ///
    /// let control = Control::points(vec![vec![0, 4, 4], vec![0, 0, 5]]);
    /// assert_eq!((control.rows(), control.coordinates().count()), (3, 2));
    /// ```
    #[must_use]
    pub fn points(coordinates: Vec<Vec<impl Into<Rational>>>) -> Control {
        let mut coordinates: Vec<Vec<Rational>> = coordinates.into_iter().map(converted).collect();
        let others = coordinates.split_off(coordinates.len().min(1));
        let values = coordinates.pop().unwrap_or_default();
        let same = others.iter().all(|other| other.len() == values.len());
        assert!(same, "each point has as many coordinates as the others");
        Control { values, others, columns: 1, seed: None, grid: false }
    }

    /// The grid with these values, row by row, of `columns` each; `None` when the last
    /// row would be incomplete, or `columns` is 0.
    #[must_use]
    pub fn grid(values: Vec<impl Into<Rational>>, columns: usize) -> Option<Control> {
        let values = converted(values);
        let whole = columns > 0 && values.len().is_multiple_of(columns);
        let others = Vec::new();
        whole.then_some(Control { values, others, columns, seed: None, grid: true })
    }

    /// The polygon of `count` integers from −100 to 100, drawn by [`SplitMix64`] from
    /// this seed: (r mod 201) − 100 for each output r.
    #[must_use]
    pub fn seeded_polygon(seed: u64, count: usize) -> Control {
        let values = SplitMix64::new(seed).small_integers(count);
        Control { seed: Some(seed), ..Control::polygon(values) }
    }

    /// The grid of `rows` × `columns` integers, drawn like those of
    /// [`Control::seeded_polygon`], row by row.
    #[must_use]
    pub fn seeded_grid(seed: u64, rows: usize, columns: usize) -> Control {
        let values = SplitMix64::new(seed).small_integers(rows.saturating_mul(columns));
        Control { values, others: Vec::new(), columns, seed: Some(seed), grid: true }
    }

    /// The values, row by row; for points, the first coordinates.
    #[must_use]
    pub fn values(&self) -> &[Rational] {
        &self.values
    }

    /// The values of each coordinate; for numbers there is only one.
    pub fn coordinates(&self) -> impl Iterator<Item = &[Rational]> {
        std::iter::once(&self.values).chain(&self.others).map(Vec::as_slice)
    }

    /// The coordinates, each with the suffix of the names of its groups: `-1`, `-2`, …, or an
    /// empty suffix if there is only one coordinate.
    pub(super) fn named_coordinates(&self) -> impl Iterator<Item = (String, &[Rational])> {
        let several = !self.others.is_empty();
        let name = move |number: usize| if several { format!("-{number}") } else { String::new() };
        (1..).map(name).zip(self.coordinates())
    }

    /// The number of rows; for a polygon, the number of points.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.values.len().checked_div(self.columns).unwrap_or(0)
    }

    /// The number of columns; 1 for a polygon.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// The seed, if the values were drawn from one.
    #[must_use]
    pub fn seed(&self) -> Option<u64> {
        self.seed
    }

    /// Whether this is a grid.
    #[must_use]
    pub fn is_grid(&self) -> bool {
        self.grid
    }
}

fn converted(values: Vec<impl Into<Rational>>) -> Vec<Rational> {
    values.into_iter().map(Into::into).collect()
}

/// The generator SplitMix64, all arithmetic mod 2^64: the state grows by
/// 0x9e3779b97f4a7c15, and the output is the new state z mixed by
/// z ← (z ⊕ z≫30)·0xbf58476d1ce4e5b9, z ← (z ⊕ z≫27)·0x94d049bb133111eb, z ⊕ z≫31.
///
/// Source: Steele, Lea and Flood 2014, as Vigna writes it in C.
///
/// ```
/// use subcert::oracle::SplitMix64;
///
/// assert_eq!(SplitMix64::new(0).next(), Some(0xe220_a839_7b1d_cdaf));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SplitMix64 {
    state: u64,
}

impl SplitMix64 {
    /// The generator with this initial state.
    #[must_use]
    pub fn new(seed: u64) -> SplitMix64 {
        SplitMix64 { state: seed }
    }

    /// `count` integers from −100 to 100, but at most [`MAX_VALUES`] + 1 of them: that is
    /// enough for the error that there are too many.
    fn small_integers(&mut self, count: usize) -> Vec<Rational> {
        // Residues mod 201 of uniform 64-bit outputs are practically uniform.
        self.take(count.min(MAX_VALUES + 1))
            .map(|r| Rational::from(r % 201) - Rational::from(100))
            .collect()
    }
}

impl Iterator for SplitMix64 {
    type Item = u64;

    /// The next output; never `None`.
    fn next(&mut self) -> Option<u64> {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        Some(z ^ (z >> 31))
    }
}
