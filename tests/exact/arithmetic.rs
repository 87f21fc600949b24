//! Integer, Rational and CommonDenominator.

use super::{integer, nonzero, our_ratio, ours, ratio, theirs};
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_rational::BigRational;
use num_traits::{One as _, Signed as _, ToPrimitive as _};
use proptest::prelude::*;
use subcert::exact::{CommonDenominator, Integer, Rational};

/// The product by the schoolbook, digit by digit.
fn naive_product(a: &str, b: &str) -> String {
    let digits = |text: &str| text.bytes().rev().map(|byte| u32::from(byte - b'0')).collect();
    let (a, b): (Vec<u32>, Vec<u32>) = (digits(a), digits(b));
    let mut product = vec![0; a.len() + b.len()];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            product[i + j] += x * y;
        }
        for at in 0..product.len() - 1 {
            product[at + 1] += product[at] / 10;
            product[at] %= 10;
        }
    }
    let text: String = product.iter().rev().map(ToString::to_string).collect();
    let trimmed = text.trim_start_matches('0');
    if trimmed.is_empty() { "0".to_owned() } else { trimmed.to_owned() }
}

proptest! {
    #[test]
    fn integers_agree_with_num_bigint(a in integer(), b in nonzero(), exponent in 0_u32..5) {
        let (x, y) = (ours(&a), ours(&b));
        prop_assert_eq!((&x + &y).to_string(), (&a + &b).to_string());
        prop_assert_eq!((&x - &y).to_string(), (&a - &b).to_string());
        prop_assert_eq!((&x * &y).to_string(), (&a * &b).to_string());
        prop_assert_eq!((-&x).to_string(), (-&a).to_string());
        prop_assert_eq!(x.div_floor(&y).to_string(), a.div_floor(&b).to_string());
        let (quotient, remainder) = a.div_mod_floor(&b);
        prop_assert_eq!(x.div_rem_floor(&y), (ours(&quotient), ours(&remainder)));
        prop_assert_eq!(x.gcd(&y), ours(&a.gcd(&b)));
        prop_assert_eq!(x.lcm(&y), ours(&a.lcm(&b)));
        prop_assert_eq!(x.pow(exponent), ours(&a.pow(exponent)));
        prop_assert_eq!(x.abs(), ours(&a.abs()));
        prop_assert_eq!(x.cmp(&y), a.cmp(&b));
        prop_assert_eq!(x.bits(), a.bits());
        prop_assert_eq!(x.is_even(), a.is_even());
        prop_assert_eq!(x.shifted_left(exponent * 20), ours(&(&a << (exponent * 20))));
        prop_assert_eq!(x.shifted_right(exponent * 20), ours(&(&a >> (exponent * 20))));
        prop_assert_eq!(BigInt::from(x.residue(6)), a.mod_floor(&BigInt::from(6)));
        prop_assert_eq!(i64::from(x.sign()), a.signum().to_i64().unwrap());
        prop_assert_eq!(x.to_i128(), a.to_i128());
        prop_assert_eq!(x.to_i64(), a.to_i64());
    }

    /// Also where the product, or the sum alone, is beyond a word.
    #[test]
    fn added_products_are_products_added(a in integer(), b in integer(), c in integer()) {
        let (half, word) = (BigInt::from(1_i64 << 31), BigInt::from(i64::MAX));
        for [a, b, c] in [[&a, &b, &c], [&word, &half, &b], [&a, &word, &BigInt::from(1)], [&word, &half, &half]] {
            let mut sum = ours(a);
            sum.add_product(&ours(b), &ours(c));
            prop_assert_eq!(sum, ours(&(a + b * c)));
        }
    }

    #[test]
    fn assigning_forms_agree_with_the_others(a in integer(), b in integer(), p in ratio(), q in ratio()) {
        let (x, y) = (ours(&a), ours(&b));
        let by = |assign: fn(&mut Integer, &Integer)| {
            let mut value = x.clone();
            assign(&mut value, &y);
            value
        };
        prop_assert_eq!(by(|x, y| *x += y), ours(&(&a + &b)));
        prop_assert_eq!(by(|x, y| *x -= y), ours(&(&a - &b)));
        prop_assert_eq!(by(|x, y| *x *= y), ours(&(&a * &b)));
        prop_assert_eq!(x.clone() + y.clone() - x.clone(), y.clone());
        // Equal values have one form, whatever made them.
        prop_assert_eq!(&x - &x, Integer::zero());
        prop_assert_eq!((&x * &y) - (&x * &y) + &x, x);
        let mut value = our_ratio(&p);
        value += &our_ratio(&q);
        prop_assert_eq!(theirs(&value), &p + &q);
        value -= &our_ratio(&q);
        prop_assert_eq!(value, our_ratio(&p));
    }

    #[test]
    fn common_divisors_agree_with_num_bigint(a in integer(), b in integer(), k in integer()) {
        let (a, b) = (a * &k, b * k);
        prop_assert_eq!(ours(&a).gcd(&ours(&b)), ours(&a.gcd(&b)));
    }

    // Fractions of few denominators, so that sums and products cancel.
    #[test]
    fn rationals_that_cancel_agree_with_num_rational(
        p in integer(), q in prop::sample::select(&[1, 2, 6, 30, 210, 1 << 30]),
        r in integer(), s in prop::sample::select(&[1, 3, 6, 15, 7, 1 << 31]),
        large in any::<bool>(),
    ) {
        let factor = if large { BigInt::from(i64::MAX) } else { BigInt::one() };
        let (a, b) = (BigRational::new(p, factor.clone() * q), BigRational::new(r, factor * s));
        let (x, y) = (our_ratio(&a), our_ratio(&b));
        prop_assert_eq!(theirs(&(&x + &y)), &a + &b);
        prop_assert_eq!(theirs(&(&x - &y)), &a - &b);
        prop_assert_eq!(theirs(&(&x * &y)), &a * &b);
        prop_assert_eq!(x.cmp(&y), a.cmp(&b));
        prop_assert_eq!(x.cmp(&y), (&x - &y).sign().cmp(&0));
    }

    #[test]
    fn products_agree_with_the_schoolbook(a in "[0-9]{1,60}", b in "[0-9]{1,60}") {
        let (x, y) = (Integer::from_digits(&a).unwrap(), Integer::from_digits(&b).unwrap());
        prop_assert_eq!((x * y).to_string(), naive_product(&a, &b));
    }

    #[test]
    fn machine_integers_keep_their_value(a in any::<i128>(), b in any::<i64>()) {
        prop_assert_eq!(Integer::from(a).to_string(), a.to_string());
        prop_assert_eq!(Integer::from(a).to_i128(), Some(a));
        prop_assert_eq!(Integer::from(b).to_i64(), Some(b));
        prop_assert_eq!((Integer::from(i128::MAX) + Integer::one()).to_i128(), None);
        prop_assert_eq!((Integer::from(i128::MIN) - Integer::one()).to_i128(), None);
        prop_assert_eq!(Integer::from(i128::MIN).to_i128(), Some(i128::MIN));
    }

    #[test]
    fn rationals_agree_with_num_rational(a in ratio(), b in ratio(), exponent in -3_i32..4) {
        let (x, y) = (our_ratio(&a), our_ratio(&b));
        prop_assert_eq!(theirs(&(&x + &y)), &a + &b);
        prop_assert_eq!(theirs(&(&x - &y)), &a - &b);
        prop_assert_eq!(theirs(&(&x * &y)), &a * &b);
        if !y.is_zero() {
            prop_assert_eq!(theirs(&(&x / &y)), &a / &b);
            prop_assert_eq!(theirs(&y.recip()), b.recip());
            prop_assert_eq!(theirs(&y.pow(exponent)), b.pow(exponent));
        }
        prop_assert_eq!(theirs(&x.abs()), a.abs());
        prop_assert_eq!(x.cmp(&y), a.cmp(&b));
        prop_assert_eq!(x.floor(), ours(&a.floor().to_integer()));
        prop_assert_eq!(x.ceil(), ours(&a.ceil().to_integer()));
        prop_assert_eq!(x.is_integer(), a.is_integer());
        prop_assert_eq!(x.bits(), a.numer().bits() + a.denom().bits());
        prop_assert_eq!(x.to_string(), a.to_string());
    }

    // (p/q)·k is reduced, and its sign stands above.
    #[test]
    fn rationals_are_in_lowest_terms(p in integer(), q in nonzero(), k in nonzero()) {
        let value = Rational::new(ours(&(&p * &k)), ours(&(&q * &k)));
        prop_assert_eq!(&value, &Rational::new(ours(&p), ours(&q)));
        prop_assert_eq!(value.denominator().sign(), 1);
        prop_assert_eq!(value.numerator().gcd(&value.denominator()), Integer::one());
    }

    // |x − r| ≤ 1/2, and r is even when that is an equality.
    #[test]
    fn rounding_to_integers(p in any::<i32>(), q in 1..9_i32) {
        let x = BigRational::new(p.into(), q.into());
        let rounded = theirs(&Rational::from(Rational::new(p, q).round_half_even()));
        let off = (&x - &rounded).abs() * BigInt::from(2);
        prop_assert!(off <= BigRational::one());
        prop_assert!(off < BigRational::one() || rounded.to_integer().is_even());
    }

    // q·x is the numerator, and no smaller q gives integers.
    #[test]
    fn common_denominators_are_common_and_least(
        rows in prop::collection::vec(prop::collection::vec((any::<i16>(), 1..400_i32), 0..5), 0..4),
    ) {
        let rows: Vec<Vec<Rational>> =
            rows.iter().map(|row| row.iter().map(|&(p, q)| Rational::new(i64::from(p), q)).collect()).collect();
        let common = CommonDenominator::of(&rows);
        let q = Rational::from(common.denominator.clone());
        prop_assert_eq!(q.sign(), 1);
        prop_assert_eq!(rows.len(), common.numerators.len());
        let mut divisor = common.denominator.clone();
        for (row, numerators) in rows.iter().zip(&common.numerators) {
            let scaled: Vec<Rational> = numerators.iter().cloned().map(Rational::from).collect();
            prop_assert_eq!(row.iter().map(|x| x * &q).collect::<Vec<_>>(), scaled);
            divisor = numerators.iter().fold(divisor, |gcd, numerator| gcd.gcd(numerator));
        }
        prop_assert_eq!(divisor, Integer::one());
    }
}

#[test]
fn binomials_are_pascals_triangle() {
    let mut row = vec![Integer::one()];
    for top in 0..40_u32 {
        let ours: Vec<Integer> = (0..=top).map(|bottom| Integer::binomial(top, bottom)).collect();
        assert_eq!(ours, row);
        assert_eq!(Integer::binomial(top, top + 1), Integer::zero());
        let inner = row.windows(2).map(|pair| &pair[0] + &pair[1]);
        row = [Integer::one()].into_iter().chain(inner).chain([Integer::one()]).collect();
    }
    assert_eq!(Integer::binomial(100, 50).to_string(), "100891344545564193334812497256");
}

/// All quotients of Euclid's algorithm are 1 for Fibonacci numbers, and many bits long for
/// a^3 and a.
#[test]
fn common_divisors_of_extreme_quotients() {
    let mut pair = (Integer::one(), Integer::one());
    for _ in 0..1000 {
        assert_eq!(pair.0.gcd(&pair.1), Integer::one());
        pair = (pair.1.clone(), &pair.0 + &pair.1);
    }
    let a = pair.0;
    assert_eq!((a.pow(3) + &a).gcd(&a), a);
    assert_eq!((a.pow(3) + Integer::one()).gcd(&a), Integer::one());
}

#[test]
fn edges() {
    assert_eq!(Integer::zero().gcd(&Integer::from(-6)), Integer::from(6));
    assert_eq!(Integer::zero().lcm(&Integer::from(-6)), Integer::zero());
    assert_eq!(Integer::zero().bits(), 0);
    assert_eq!(Rational::zero().pow(0), Rational::one());
    assert_eq!(Rational::new(-2, 3).pow(-3), Rational::new(-27, 8));
    for text in ["", "+1", "-1", "1_0", "0x1", " 1", "1 ", "١"] {
        assert_eq!(Integer::from_digits(text), None, "{text:?}");
    }
    assert_eq!(Integer::from_digits("007"), Some(Integer::from(7)));
}

#[test]
fn divisions_by_zero_panic() {
    let panics = |f: fn()| std::panic::catch_unwind(f).is_err();
    assert!(panics(|| drop(Rational::new(1, 0))));
    assert!(panics(|| drop(Rational::one() / Rational::zero())));
    assert!(panics(|| drop(Rational::zero().recip())));
    assert!(panics(|| drop(Rational::zero().pow(-1))));
    assert!(panics(|| drop(Integer::one().div_floor(&Integer::zero()))));
    assert_eq!(Rational::zero(), Rational::new(0, -5));
}
