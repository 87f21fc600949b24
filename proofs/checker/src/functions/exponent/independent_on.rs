//! Whether the shifts of φ are linearly independent on a piece, for masks with its symbol v. THEOREMS.md, 121.
//!
//! The parts of the symbol have a common zero for the roots of a polynomial in v, if n = 2. A finite set of z ≠ 1 that is closed under z ↦ z^n
//! contains a root of unity ζ of some order M without a common divisor with n, and all its ζ^{n^j}. Where the symbol is real, their conjugates
//! are roots too. If all primitive roots of the order M are among these, they are roots for the common roots of some polynomials in v. So most
//! pieces are cut only where shifts become dependent.

#![warn(clippy::arithmetic_side_effects)]

use super::euclid::{Coefficient, Euclid, Polynomial};
use super::norms::norm;
use crate::functions::masks::Mask;
use crate::numbers::{
    Meter, Piece, Q, Root, Value, at, cyclotomic, divide, gcd, int, steps_of_gcd, trimmed,
};
use crate::radius::has_independent_shifts_over;
use crate::schemes::{Conditions, Library};
use crate::text::Stop;
use num_integer::Integer as _;
use num_traits::Zero as _;

/// The greatest order of roots of unity.
const MAX_ORDER: u32 = 4_096;

/// Whether they are. The ends of the mask are not 0 on the piece.
pub fn has_independent_shifts_on(
    library: &Library<'_>,
    mask: &Mask,
    piece: &Piece<'_>,
) -> Result<bool, Stop> {
    let meter = library.meter;
    let coefficients = |value: &Value| {
        let found = value.univariate(piece.symbol()).map(trimmed);
        found.ok_or(Stop::Undecided("independence over irrational numbers on a piece"))
    };
    let symbol = mask.values.iter().map(coefficients).collect::<Result<Polynomial, Stop>>()?;
    let find = |(symbol, n): &(Polynomial, usize)| Shifts { meter, symbol, n: *n }.conditions();
    let conditions = library.limits.conditions((symbol.clone(), mask.arity), find)?;
    let mut open = false;
    for (p, dependent) in conditions.iter() {
        // The piece is cut at the roots.
        if Value::polynomial(piece.symbol(), p.clone()).is_zero_on(Some(piece))? {
            if *dependent {
                return Ok(false);
            }
            open = true;
        }
    }
    match piece.one() {
        _ if !open => Ok(true),
        Some(root) => at_root(meter, &symbol, mask.arity, &root),
        None => Euclid { meter, piece }.is_independent(&symbol, mask.arity),
    }
}

/// The symbol of a mask, of which the first and the last coefficient are not 0.
struct Shifts<'s> {
    meter: &'s Meter,
    symbol: &'s Polynomial,
    n: usize,
}

impl Shifts<'_> {
    /// All conditions for dependent shifts that some number fulfils.
    fn conditions(&self) -> Result<Conditions, Stop> {
        let mut conditions = self.of_roots_of_unity()?;
        conditions.extend(self.of_common_zeros()?);
        let mut found = Vec::new();
        for (p, dependent) in conditions.into_iter().filter(|(p, _)| p.len() != 1) {
            found.push((self.simple(p)?, dependent));
        }
        Ok(found)
    }

    /// A greatest common divisor of polynomials in v.
    fn divisor(&self, p: Coefficient, q: &Coefficient) -> Result<Coefficient, Stop> {
        if p.is_empty() || q.is_empty() {
            return Ok(if p.is_empty() { q.clone() } else { p });
        }
        self.meter.spend(steps_of_gcd(&p, q))?;
        Ok(gcd(&p, q))
    }

    /// The condition for a common zero z ≠ 0 of the parts. The part with the last coefficient keeps its degree, and the first one is not
    /// 0 at 0.
    fn of_common_zeros(&self) -> Result<Option<(Coefficient, bool)>, Stop> {
        let last = self.symbol.len().saturating_sub(1).checked_rem(self.n).unwrap_or(0);
        let part = |e: usize| -> Polynomial {
            self.symbol.iter().skip(e).step_by(self.n).cloned().collect()
        };
        let (whole, mut common) = (part(last), Vec::new());
        if whole.len() == 1 {
            return Ok(None);
        }
        for e in (0..self.n).filter(|e| *e != last) {
            let mut other = part(e);
            while other.last().is_some_and(Vec::is_empty) {
                other.pop();
            }
            common = self.divisor(common, &norm(self.meter, &whole, &other)?)?;
        }
        Ok(Some((common, self.n == 2)))
    }

    /// The polynomial with the same roots, all simple.
    fn simple(&self, p: Coefficient) -> Result<Coefficient, Stop> {
        if p.len() < 3 {
            return Ok(p);
        }
        let multiple = self.multiple(&p, 2)?;
        Ok(trimmed(divide(p, &multiple).0))
    }

    /// A polynomial with the roots of p ≠ 0 of this multiplicity and higher ones.
    fn multiple(&self, p: &Coefficient, least: usize) -> Result<Coefficient, Stop> {
        let mut found = p.clone();
        for _ in 1..least {
            let derivative = (1..).zip(found.iter().skip(1)).map(|(i, c)| c * int(i));
            let derivative: Coefficient = derivative.collect();
            found = self.divisor(found, &derivative)?;
            if found.len() < 2 {
                break;
            }
        }
        Ok(found)
    }

    /// The conditions for A(wω) = 0 for all w = ζ^{n^j} and all ω ≠ 1, ω^n = 1, for a root of unity ζ ≠ 1 of some order M without a
    /// common divisor with n. Each w has its own n − 1 zeros wω, which are none of σ.
    fn of_roots_of_unity(&self) -> Result<Conditions, Stop> {
        let n = u32::try_from(self.n).unwrap_or(u32::MAX);
        let zeros = self.symbol.len().saturating_sub(self.n);
        let most = zeros.checked_div(self.n.saturating_sub(1)).unwrap_or(0);
        // The order divides n^p − 1 for a cycle of p numbers, and n^{p/2} + 1 if it contains the conjugates.
        let half = u32::try_from(most / 2).unwrap_or(u32::MAX);
        let order = n.saturating_pow(half).saturating_add(1);
        if order > MAX_ORDER {
            return Ok(vec![(Vec::new(), false)]);
        }
        let mut found = Vec::new();
        for m in (2..=order).filter(|m| m.gcd(&n) == 1) {
            let size = cycle(n, m);
            if size <= most {
                self.meter.spend(u64::from(m).saturating_mul(u64::from(m)) / 16)?;
                found.push(self.of_order(m, size)?);
            }
        }
        Ok(found)
    }

    /// The condition for one order, of which so many roots are the powers and conjugates of one.
    fn of_order(&self, m: u32, size: usize) -> Result<(Coefficient, bool), Stop> {
        let minimal: Vec<Q> = cyclotomic(m).into_iter().map(Q::from_integer).collect();
        let all = size.saturating_add(1) == minimal.len();
        let mut common = Vec::new();
        for e in 0..self.n.saturating_sub(1) {
            let rest = self.reduced(e, m as usize, &minimal)?;
            if all {
                for c in &rest {
                    common = self.divisor(common, c)?;
                }
            } else if !rest.is_empty() {
                // Of the factors of the norm, so many are 0 together.
                let whole = minimal.iter().map(|c| trimmed(vec![c.clone()])).collect();
                let norm = norm(self.meter, &whole, &rest)?;
                if !norm.is_empty() {
                    common = self.divisor(common, &self.multiple(&norm, size)?)?;
                }
            }
        }
        Ok((common, all))
    }

    /// z^eA_e(z^n) − z^{e+1}A_{e+1}(z^n) modulo a cyclotomic polynomial of order m. A(wω) = 0 for all ω ≠ 1, ω^n = 1, if and only if all
    /// these are 0 at w.
    fn reduced(&self, e: usize, m: usize, minimal: &[Q]) -> Result<Polynomial, Stop> {
        let mut rest: Polynomial = vec![Vec::new(); m];
        for (i, a) in self.symbol.iter().enumerate() {
            let class = i.checked_rem(self.n).unwrap_or(0);
            let factor = match class.checked_sub(e) {
                Some(0) => int(1),
                Some(1) => int(-1),
                _ => continue,
            };
            self.meter.spend(a.len() as u64)?;
            add(&mut rest[i.checked_rem(m).unwrap_or(0)], &factor, a);
        }
        let (degree, lower) = (minimal.len().saturating_sub(1), minimal);
        while rest.len() > degree {
            let Some(top) = rest.pop() else { break };
            let from = rest.len().saturating_sub(degree);
            for (c, factor) in rest.iter_mut().skip(from).zip(lower) {
                self.meter.spend(top.len() as u64)?;
                add(c, &-factor, &top);
            }
        }
        while rest.last().is_some_and(Vec::is_empty) {
            rest.pop();
        }
        Ok(rest)
    }
}

/// Adds a multiple of a polynomial.
fn add(sum: &mut Coefficient, factor: &Q, p: &Coefficient) {
    sum.resize(sum.len().max(p.len()), Q::zero());
    for (x, y) in sum.iter_mut().zip(p) {
        *x += factor * y;
    }
    *sum = trimmed(std::mem::take(sum));
}

/// The number of the ζ^{±n^j}, for a root of unity ζ of the order m.
fn cycle(n: u32, m: u32) -> usize {
    let (n, m) = (u64::from(n), u64::from(m));
    let (mut power, mut size, mut conjugate) = (1, 0_usize, false);
    loop {
        power = n.saturating_mul(power).checked_rem(m).unwrap_or(0);
        size = size.saturating_add(1);
        conjugate = conjugate || power == m.saturating_sub(1);
        if power == 1 || power == 0 {
            return if conjugate { size } else { size.saturating_mul(2) };
        }
    }
}

/// The same for one number.
fn at_root(meter: &Meter, symbol: &Polynomial, n: usize, root: &Root) -> Result<bool, Stop> {
    let derivative = (1..).zip(root.polynomial().iter().skip(1)).map(|(i, c)| c * int(i));
    let derivative: Coefficient = derivative.collect();
    meter.spend(steps_of_gcd(root.polynomial(), &derivative))?;
    let multiple = gcd(root.polynomial(), &derivative);
    let simple = trimmed(divide(root.polynomial().to_vec(), &multiple).0);
    let rational = match (root.rational(), &simple[..]) {
        (Some(value), _) => Some(value.clone()),
        (None, [constant, factor]) => Some(-constant / factor),
        _ => None,
    };
    if let Some(value) = rational {
        let numbers: Polynomial = symbol.iter().map(|a| trimmed(vec![at(a, &value)])).collect();
        // Any field will do for fractions.
        let field = (vec![int(-2), int(0), int(1)], int(1), int(2));
        return has_independent_shifts_over(&numbers, n, field, meter);
    }
    let mut reduced = Vec::with_capacity(symbol.len());
    for a in symbol {
        meter.spend(steps_of_gcd(a, &simple))?;
        reduced.push(trimmed(divide(a.clone(), &simple).1));
    }
    let [low, high] = root.ends();
    has_independent_shifts_over(&reduced, n, (simple, low.clone(), high.clone()), meter)
}
