//! σ: a bound on how far one refinement moves the polygon.

use crate::exact::{Rational, Real};
use crate::scheme::Mask;

/// How coefficients are combined to a bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Terms {
    /// Σ|·|: a sound bound.
    Each,
    /// |Σ·|, as printed in some papers; it is not a bound.
    Total,
}

impl Terms {
    /// Σ|t| or |Σt| over `terms`.
    #[must_use]
    pub fn gather<'a, S: Real + 'a>(self, terms: impl IntoIterator<Item = &'a S>) -> S {
        match self {
            Terms::Each => S::sum_of_magnitudes(terms),
            Terms::Total => S::total(terms).magnitude(),
        }
    }
}

/// The displacement `σ = max_α Σ_m |ã_{α,m}|` of a scheme at the offset o of its mask,
/// where `x'_{ni+α} − ((1−α/n) x_i + (α/n) x_{i+1}) = Σ_m ã_{α,m} Δ_{i+m}`, so that
/// `‖P^{k+1} − P^k‖_∞ ≤ σ max|Δ^k|` for the piecewise linear interpolants P^k of
/// level k at the parameters i/n^k. With [`Terms::Total`], |Σ ã| in place of Σ|ã|.
///
/// At o = 0: ã_{α,0} = Σ_{h≥1} a_{α,h} − α/n and ã_{α,m} = Σ_{h>m} a_{α,h} for m ≥ 1.
///
/// Source: Mustafa and Deng 2007, (2.6); Mustafa et al. 2020, Theorem 4.
///
/// ```
/// use subcert::bound::{Terms, displacement};
/// use subcert::exact::Rational;
/// use subcert::scheme::parse_scheme;
///
/// let scheme = parse_scheme("quinary-three-point")?;
/// let mask = scheme.masks()[0];
/// assert_eq!(displacement(&mask.with_offset(0), Terms::Each), Rational::new(21, 25));
/// assert_eq!(displacement(&mask.with_offset(0), Terms::Total), Rational::new(3, 5));
/// assert_eq!(displacement(mask, Terms::Each), Rational::new(16, 25));
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
#[must_use]
pub fn displacement<S: Real>(mask: &Mask<S>, terms: Terms) -> S {
    S::maximum((0..mask.arity()).map(|alpha| terms.gather(&displaced(mask, alpha))))
}

/// ã_{α,m} for every m where it can differ from 0, in the order of m.
pub(super) fn displaced<S: Real>(mask: &Mask<S>, alpha: usize) -> Vec<S> {
    let row = &mask.rules().rows()[alpha];
    let offset = mask.offset();
    let width = i64::try_from(mask.width()).expect("the width is capped");
    let from = offset.min(0);
    let to = (offset + width - 2).max(0);
    let shift = S::from_rational(&Rational::new(alpha, mask.arity()));
    (from..=to)
        .map(|m| {
            // x_{i+s} − x_i is a sum of differences Δ between the two points. So the
            // coefficient of Δ_m is the sum over the points to its right if m ≥ 0, and
            // minus the sum over the points to its left if m < 0.
            let cut = usize::try_from((m + 1 - offset).clamp(0, width)).expect("clamped to 0…N");
            let coefficient =
                if m < 0 { S::zero().minus(&S::total(&row[..cut])) } else { S::total(&row[cut..]) };
            if m == 0 { coefficient.minus(&shift) } else { coefficient }
        })
        .collect()
}

/// The offset o at which σ is least, and the least σ. Of several such offsets, the one
/// nearest to 0.
///
/// A change of the offset shifts all indices of the refined points by the same multiple
/// of n. The polygons and the limit stay the same point sets; they are compared at other
/// parameters. Outside −N ≤ o ≤ 1, σ only increases, so only these offsets are tried.
///
/// # Panics
/// Never: the width of a mask is capped.
#[must_use]
pub fn best_offset(mask: &Mask) -> (i64, Rational) {
    let width = i64::try_from(mask.width()).expect("the width is capped");
    let rules = mask.rules().rows().iter().enumerate();
    let rules: Vec<Sums> = rules.map(|(alpha, row)| Sums::of(row, alpha, mask.arity())).collect();
    let mut offsets: Vec<i64> = (-width..=1).collect();
    offsets.sort_by_key(|offset| offset.abs());
    let sigma = |offset: i64| (offset, Rational::maximum(rules.iter().map(|rule| rule.at(offset))));
    let candidates = offsets.into_iter().map(sigma);
    candidates
        .reduce(|best, next| if next.1 < best.1 { next } else { best })
        .expect("there is at least one offset")
}

/// An offset with a smaller σ than that of offset 0, which is taken where a file states none.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BetterOffset {
    /// The offset, as [`best_offset`] gives it.
    pub offset: i64,
    /// σ at that offset.
    pub least: Rational,
    /// σ at offset 0.
    pub at_zero: Rational,
}

impl BetterOffset {
    /// That of the coefficients of a mask, if 0 is not as good.
    ///
    /// ```
    /// use subcert::bound::BetterOffset;
    /// use subcert::scheme::parse_scheme;
    ///
    /// let (four_point, chaikin) = (parse_scheme("four-point")?, parse_scheme("chaikin")?);
    /// let better = BetterOffset::of(four_point.masks()[0]);
    /// assert_eq!(better.map(|better| better.offset), Some(-1));
    /// assert_eq!(BetterOffset::of(chaikin.masks()[0]), None);
    /// # Ok::<(), subcert::scheme::SchemeError>(())
    /// ```
    #[must_use]
    pub fn of(mask: &Mask) -> Option<BetterOffset> {
        let at_zero = displacement(&mask.with_offset(0), Terms::Each);
        let (offset, least) = best_offset(mask);
        (least < at_zero).then_some(BetterOffset { offset, least, at_zero })
    }
}

/// The sums that give Σ_m |ã_{α,m}| at any offset −N ≤ o ≤ 1. With c = m + 1 − o, ã_{α,m} is
/// Σ_{h≥c} a_{α,h} for m > 0, minus Σ_{h<c} a_{α,h} for m < 0, and Σ_{h≥c} a_{α,h} − α/n for
/// m = 0.
struct Sums {
    /// Σ_{h≥c} a_{α,h}, for c = 0, …, N.
    tails: Vec<Rational>,
    /// The sum of |Σ_{h≥d} a_{α,h}| over d ≥ c, for c = 0, …, N + 1.
    from: Vec<Rational>,
    /// The sum of |Σ_{h<d} a_{α,h}| over d ≤ c, for c = 0, …, N.
    up_to: Vec<Rational>,
    /// α/n.
    shift: Rational,
}

impl Sums {
    fn of(row: &[Rational], alpha: usize, arity: usize) -> Sums {
        let magnitudes = |sums: &[Rational]| sums.iter().map(Rational::abs).collect::<Vec<_>>();
        let mut tails = sums(row.iter().rev());
        let mut from = sums(magnitudes(&tails).iter());
        tails.reverse();
        from.reverse();
        let heads = sums(row.iter());
        let up_to = sums(magnitudes(&heads[1..]).iter());
        Sums { tails, from, up_to, shift: Rational::new(alpha, arity) }
    }

    /// Σ_m |ã_{α,m}| at the offset `offset`.
    fn at(&self, offset: i64) -> Rational {
        let place = |c: i64| usize::try_from(c).expect("offsets from -N to 1 are asked for");
        let width = self.tails.len() - 1;
        let above = &self.from[place(2 - offset).min(width + 1)];
        let below = &self.up_to[place((-offset).max(0))];
        above + below + (&self.tails[place(1 - offset).min(width)] - &self.shift).abs()
    }
}

/// The partial sums: the sums of the first 0, 1, 2, … terms.
fn sums<'a>(terms: impl Iterator<Item = &'a Rational>) -> Vec<Rational> {
    let mut sums = vec![Rational::zero()];
    for term in terms {
        sums.push(&sums[sums.len() - 1] + term);
    }
    sums
}
