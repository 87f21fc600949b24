//! Irreducible factors of integer polynomials.

mod modular;
mod square_free;

use crate::exact::{Integer, IntegerPolynomial};
use modular::Modular;

/// The number of primes that are tried. The prime with the fewest modular factors is
/// used.
const PRIMES_TRIED: usize = 4;

/// The search for primes starts at this number.
const FIRST_PRIME: u32 = 10_007;

/// The most combinations of modular factors that are tried.
const MAX_COMBINATIONS: u32 = 1 << 16;

impl IntegerPolynomial {
    /// The distinct non-constant irreducible factors over Q, each primitive. `None` when
    /// more than 2^16 combinations of factors modulo a prime would have to be tried.
    ///
    /// The polynomial is factored modulo a prime p. The factors are lifted to a power of
    /// p that exceeds twice the coefficients of all factors over Q, and then combined
    /// (Zassenhaus 1969).
    ///
    /// # Panics
    /// When this is 0.
    ///
    /// ```
    /// use subcert::exact::IntegerPolynomial;
    ///
    /// let f = IntegerPolynomial::from([-4, 0, 0, 0, 1]);
    /// let factors = f.irreducible_factors().expect("few combinations");
    /// let texts: Vec<String> = factors.iter().map(ToString::to_string).collect();
    /// assert_eq!(texts, ["x^2 - 2", "x^2 + 2"]);
    /// ```
    #[must_use]
    pub fn irreducible_factors(&self) -> Option<Vec<IntegerPolynomial>> {
        assert!(!self.is_zero(), "every polynomial divides 0");
        let f = self.square_free();
        let mut factors = match f.degree() {
            None | Some(0) => Vec::new(),
            Some(1) => vec![f],
            Some(_) => {
                let (p, modular) = best_prime(&f);
                if modular.len() == 1 { vec![f] } else { combined(f, &modular, p)? }
            }
        };
        factors.sort_by_cached_key(|f| (f.degree(), f.coefficients().to_vec()));
        Some(factors)
    }
}

fn reduced(f: &IntegerPolynomial, p: u32) -> Modular {
    f.coefficients().iter().map(|c| u64::from(c.residue(p))).collect()
}

/// A prime modulo which f keeps its degree and stays square-free, with the monic
/// irreducible factors of f modulo this prime. All but finitely many primes have this
/// property.
fn best_prime(f: &IntegerPolynomial) -> (u32, Vec<Modular>) {
    let is_prime = |n: &u32| (2..=n.isqrt()).all(|d| !n.is_multiple_of(d));
    let factors = |p: u32| {
        let (modular, modulus) = (reduced(f, p), u64::from(p));
        let good = modular.last() != Some(&0) && modular::is_square_free(&modular, modulus);
        good.then(|| (p, modular::factors(&modular::monic(&modular, modulus), modulus)))
    };
    let primes = (FIRST_PRIME..).filter(is_prime);
    let tried = primes.filter_map(factors).take(PRIMES_TRIED);
    tried.min_by_key(|(_, factors)| factors.len()).expect("there are infinitely many primes")
}

/// The factors over Q, found by combining the factors modulo p.
fn combined(f: IntegerPolynomial, modular: &[Modular], p: u32) -> Option<Vec<IntegerPolynomial>> {
    let (mut lifted, modulus) = lifted(&f, modular, p);
    let (mut rest, mut found, mut tried) = (f, Vec::new(), 0);
    let mut size = 1;
    while 2 * size <= lifted.len() {
        let mut factor = None;
        for choice in choices(lifted.len(), size) {
            tried += 1;
            if tried > MAX_COMBINATIONS {
                return None;
            }
            let leading = IntegerPolynomial::new(vec![rest.leading()]);
            let product = choice
                .iter()
                .fold(leading, |product, &i| centred(&(&product * &lifted[i]), &modulus));
            let candidate = product.primitive();
            if rest.div_rem(&candidate).2.is_zero() {
                factor = Some((choice, candidate));
                break;
            }
        }
        let Some((choice, candidate)) = factor else {
            size += 1;
            continue;
        };
        rest = rest.div_rem(&candidate).1.primitive();
        found.push(candidate);
        for i in choice.into_iter().rev() {
            lifted.swap_remove(i);
        }
    }
    if rest.degree().unwrap_or(0) > 0 {
        found.push(rest);
    }
    Some(found)
}

/// The subsets of {0, …, n − 1} with `size` elements, each in increasing order.
fn choices(n: usize, size: usize) -> impl Iterator<Item = Vec<usize>> {
    let mut next = (size <= n).then(|| (0..size).collect::<Vec<usize>>());
    std::iter::from_fn(move || {
        let current = next.clone()?;
        next = (0..size).rev().find(|&i| current[i] < n - size + i).map(|i| {
            let mut following = current.clone();
            for (step, place) in (i..size).enumerate() {
                following[place] = current[i] + 1 + step;
            }
            following
        });
        Some(current)
    })
}

/// f with every coefficient replaced by its residue mod m of least absolute value.
fn centred(f: &IntegerPolynomial, m: &Integer) -> IntegerPolynomial {
    let half = m.shifted_right(1);
    let centre = |c: &Integer| {
        let residue = c.div_rem_floor(m).1;
        if residue > half { residue - m } else { residue }
    };
    IntegerPolynomial::new(f.coefficients().iter().map(centre).collect())
}

/// The monic factors lifted modulo p^e, with l·Π g_i ≡ f, and p^e. A factor of f of
/// degree d has coefficients of at most 2^d·‖f‖ in absolute value (Mignotte 1974); p^e
/// exceeds 2l times this bound, where l is the leading coefficient.
fn lifted(f: &IntegerPolynomial, modular: &[Modular], p: u32) -> (Vec<IntegerPolynomial>, Integer) {
    let modulus = u64::from(p);
    let degree = u32::try_from(f.coefficients().len()).expect("a polynomial fits in memory");
    let norm = f.coefficients().iter().map(Integer::abs).sum::<Integer>();
    let bound = (norm * f.leading()).shifted_left(degree + 1);
    let leading = u64::from(f.leading().residue(p));
    // s_i with Σ_i s_i Π_{j≠i} g_j = 1/l. For an error e, the correction of g_i is e·s_i
    // mod g_i.
    let cofactor = |i: usize| {
        let others = modular.iter().enumerate().filter(|(j, _)| *j != i);
        let product = others.fold(vec![1], |product, (_, g)| modular::times(&product, g, modulus));
        let inverse = modular::inverse_mod(&product, &modular[i], modulus);
        modular::scaled(&inverse, modular::inverse(leading, modulus), modulus)
    };
    let cofactors: Vec<Modular> = (0..modular.len()).map(cofactor).collect();
    let whole = |g: &Modular| IntegerPolynomial::new(g.iter().map(|&c| Integer::from(c)).collect());
    let mut lifted: Vec<IntegerPolynomial> = modular.iter().map(whole).collect();
    let mut power = Integer::from(u64::from(p));
    while power <= bound {
        let start = IntegerPolynomial::new(vec![f.leading()]);
        let error = f - &lifted.iter().fold(start, |product, g| &product * g);
        let error: Vec<Integer> =
            error.coefficients().iter().map(|c| c.div_floor(&power)).collect();
        let error = reduced(&IntegerPolynomial::new(error), p);
        let scale = IntegerPolynomial::new(vec![power.clone()]);
        for ((g, s), old) in lifted.iter_mut().zip(&cofactors).zip(modular) {
            let lack = modular::remainder(&modular::times(&error, s, modulus), old, modulus);
            *g = &*g + &(&scale * &whole(&lack));
        }
        power *= &Integer::from(u64::from(p));
    }
    (lifted, power)
}
