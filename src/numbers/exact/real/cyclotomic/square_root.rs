//! Square roots of rational numbers, by Gauss sums.

use super::error::{MAX_CONDUCTOR, common_conductor};
use super::number::RealCyclotomic;
use crate::exact::real::square::square_part;
use crate::exact::{Rational, Scalar as _};

impl RealCyclotomic {
    /// √x for a rational x ≥ 0; `None` if x is negative, or the field of the root is beyond the cap.
    ///
    /// With x = s²t and t a product of different primes, √x = s·Π √p, √2 = 2cos(π/4), and for odd p, with the Legendre symbol,
    /// √p = Σ_a (a/p) cos(2πa/p) if p ≡ 1 mod 4, and Σ_a (a/p) sin(2πa/p) if p ≡ 3 (Gauss).
    ///
    /// ```
    /// use subcert::exact::{Rational, RealCyclotomic};
    ///
    /// let root = |n: i64| RealCyclotomic::square_root(&Rational::from(n)).expect("a small number");
    /// assert_eq!(&root(6) * &root(15), &RealCyclotomic::from(3) * &root(10));
    /// assert_eq!(root(12), &RealCyclotomic::from(2) * &root(3));
    /// assert_eq!(RealCyclotomic::square_root(&Rational::from(-1)), None);
    /// ```
    #[must_use]
    pub fn square_root(x: &Rational) -> Option<RealCyclotomic> {
        match x.sign() {
            -1 => return None,
            0 => return Some(RealCyclotomic::zero()),
            _ => {}
        }
        let (factor, rest) = square_part(x);
        let mut rest = u32::try_from(rest.to_i64()?).ok()?;
        let mut root = RealCyclotomic::from(factor);
        // What is left has no divisor below p, so that p is prime if it divides it.
        for p in 2..=MAX_CONDUCTOR {
            if rest == 1 {
                break;
            }
            if rest % p == 0 {
                rest /= p;
                let next = root_of_prime(p)?;
                common_conductor(root.conductor(), next.conductor()).ok()?;
                root = &root * &next;
            }
        }
        (rest == 1).then_some(root)
    }
}

/// √p; `None` beyond the cap of the conductor.
fn root_of_prime(p: u32) -> Option<RealCyclotomic> {
    if p == 2 {
        return RealCyclotomic::cosine(&Rational::new(1, 8)).ok().map(|c| &c + &c);
    }
    let quarter = if p % 4 == 1 { Rational::zero() } else { Rational::new(1, 4) };
    let squares: std::collections::BTreeSet<u32> = (1..p).map(|a| a * a % p).collect();
    let mut sum = RealCyclotomic::zero();
    for a in 1..p {
        let cosine = RealCyclotomic::cosine(&(Rational::new(a, p) - &quarter)).ok()?;
        sum = if squares.contains(&a) { &sum + &cosine } else { &sum - &cosine };
    }
    Some(sum)
}
