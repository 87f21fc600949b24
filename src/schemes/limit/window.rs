//! The points that one piece of a curve depends on, and what an open polygon determines.

use super::error::{LimitError, MAX_WINDOW};
use crate::exact::{Integer, Rational};
use crate::scheme::Mask;

/// The points x_{i+first}, …, x_{i+last}, which the curve and the polygons of all levels, with x^k_j at
/// (j + s)/n^k, depend on over the parameters from i to i + 1.
///
/// It holds the points of the polygon there, and with the points of the next level in the windows
/// of the n parts of a cell all points that these are made of (`proofs/THEOREMS.md`, 98).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Window {
    /// The first index for i = 0.
    pub first: i64,
    /// The last one.
    pub last: i64,
}

impl Window {
    /// That of a mask and a shift s.
    ///
    /// # Errors
    /// When there are more than [`MAX_WINDOW`] points.
    ///
    /// ```
    /// use subcert::exact::Rational;
    /// use subcert::limit::Window;
    /// use subcert::scheme::parse_scheme;
    ///
    /// let chaikin = parse_scheme("chaikin")?;
    /// let window = Window::of(chaikin.masks()[0], &Rational::new(-1, 2))?;
    /// assert_eq!(window, Window { first: 0, last: 2 });
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of(mask: &Mask, shift: &Rational) -> Result<Window, LimitError> {
        let [start, short] = ends(mask, shift);
        let whole = |x: Integer| x.to_i64().ok_or(LimitError::Offset(mask.offset()));
        let window = Window { first: whole((-start).floor())?, last: whole((-short).ceil())? };
        if window.size() > MAX_WINDOW {
            return Err(LimitError::Window(window.size()));
        }
        Ok(window)
    }

    /// How many points there are.
    #[must_use]
    pub fn size(self) -> usize {
        usize::try_from(self.last - self.first + 1).unwrap_or(usize::MAX)
    }

    /// How many cells have a window inside `count` points.
    #[must_use]
    pub fn cells(self, count: usize, closed: bool) -> usize {
        if closed { count } else { (count + 1).saturating_sub(self.size()) }
    }

    /// The index of the first cell.
    #[must_use]
    pub fn first_cell(self, closed: bool) -> i64 {
        if closed { 0 } else { -self.first }
    }
}

/// The parameters a and b between which `count` points of an open polygon, from x_0 on, determine P^∞ and all P^k, with
/// x^k_j at (j + s)/n^k: a = max(B − 1, s) and b = count + min(A, s − 1), where φ is 0 outside [A, B]
/// (`proofs/THEOREMS.md`, 98).
///
/// # Errors
/// When a is not less than b.
///
/// # Panics
/// Never: offsets are capped.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::limit::determined;
/// use subcert::scheme::parse_scheme;
///
/// let chaikin = parse_scheme("chaikin")?;
/// // Three points determine a parabola.
/// let [a, b] = determined(chaikin.masks()[0], &Rational::new(-1, 2), 3)?;
/// assert_eq!((a, b), (Rational::zero(), Rational::one()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn determined(
    mask: &Mask,
    shift: &Rational,
    count: usize,
) -> Result<[Rational; 2], LimitError> {
    let [start, short] = ends(mask, shift);
    let range = [start, Rational::from(count) + &short];
    if range[0] < range[1] {
        return Ok(range);
    }
    let more = (&range[0] - short).floor().to_i64().and_then(|most| usize::try_from(most).ok());
    Err(LimitError::TooFew { needed: more.map_or(usize::MAX, |most| most.saturating_add(1)) })
}

/// max(B − 1, s) and min(A, s − 1).
fn ends(mask: &Mask, shift: &Rational) -> [Rational; 2] {
    // y_{ni + α} has the coefficient a_m of x_{i + j} for m = α − nj, and φ(t) = Σ_m a_mφ(nt − m).
    let arity = i64::try_from(mask.arity()).expect("the arity is capped");
    let used = (0..).zip(mask.rules().rows()).flat_map(|(alpha, row)| {
        let entries = (mask.offset()..).zip(row).filter(|(_, entry)| !entry.is_zero());
        entries.map(move |(j, _)| alpha - arity * j)
    });
    let (least, greatest) =
        used.fold((i64::MAX, i64::MIN), |(least, greatest), m| (least.min(m), greatest.max(m)));
    let [a, b] = [least, greatest].map(|m| Rational::new(m, arity - 1));
    let one = Rational::one();
    [(b - &one).max(shift.clone()), a.min(shift - one)]
}
