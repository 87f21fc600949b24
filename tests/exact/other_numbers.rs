//! Numbers of num-rational, num-bigint and rug, the traits of num-traits, and numbers as text: against num-rational and num-bigint.

use super::{integer, nonzero, our_ratio, ours, ratio, theirs};
use num_bigint::BigInt;
use num_rational::{BigRational, Ratio};
use num_traits::{
    FromPrimitive, Num, NumAssignRef, NumRef, One, RefNum, Signed, ToPrimitive, Zero,
};
use proptest::prelude::*;
use subcert::exact::{Integer, MAX_DIGITS, NumberError, Rational};
use subcert::float::{exact, nearest};

/// What generic code computes, by all operators and their assigning forms, by value and by reference.
fn generic<T>(a: &T, b: &T) -> Vec<T>
where
    T: NumRef + NumAssignRef + Signed + Clone + std::iter::Sum + std::iter::Product,
    for<'a> T: std::iter::Sum<&'a T> + std::iter::Product<&'a T>,
    for<'a> &'a T: RefNum<T>,
{
    let assigned = |assign: fn(&mut T, T, &T)| {
        let mut value = a.clone();
        assign(&mut value, b.clone(), b);
        value
    };
    let pair = [a.clone(), b.clone()];
    vec![
        a + b,
        a - b,
        a * b,
        a / b,
        a % b,
        a.clone() % b.clone(),
        a.clone() / b,
        a / b.clone(),
        assigned(|x, y, z| {
            *x += y;
            *x += z;
        }),
        assigned(|x, y, z| {
            *x -= y;
            *x -= z;
        }),
        assigned(|x, y, z| {
            *x *= y;
            *x *= z;
        }),
        assigned(|x, y, z| {
            *x /= y;
            *x /= z;
        }),
        assigned(|x, y, _| *x %= y),
        assigned(|x, _, z| *x %= z),
        a.abs(),
        a.abs_sub(b),
        b.abs_sub(a),
        a.signum(),
        pair.iter().sum(),
        pair.iter().product(),
        pair.clone().into_iter().sum::<T>() + pair.into_iter().product::<T>(),
        T::zero() + T::one(),
    ]
}

/// The machine integers of generic code.
fn machine<T: ToPrimitive>(value: &T) -> (Option<i128>, Option<u128>, [Option<i128>; 3]) {
    let narrow = [
        value.to_i64().map(i128::from),
        value.to_u64().map(i128::from),
        value.to_u8().map(i128::from),
    ];
    (value.to_i128(), value.to_u128(), narrow)
}

fn word() -> impl Strategy<Value = i64> {
    let ends = prop::sample::select(&[i64::MIN, i64::MIN + 1, -1, 0, 1, i64::MAX - 1, i64::MAX]);
    prop_oneof![any::<i64>(), ends, -9_i64..9]
}

proptest! {
    #[test]
    fn numbers_of_other_crates_there_and_back(a in integer(), r in ratio()) {
        let (x, y) = (ours(&a), our_ratio(&r));
        prop_assert_eq!(Integer::from(&a), x.clone());
        prop_assert_eq!(BigInt::from(&x), a.clone());
        prop_assert_eq!(BigInt::from(Integer::from(a.clone())), a.clone());
        prop_assert_eq!(Rational::from(&r), y.clone());
        prop_assert_eq!(BigRational::from(&y), r.clone());
        prop_assert_eq!(BigRational::from(Rational::from(r.clone())), r.clone());
        // Neither lowest terms nor a positive denominator are asked for.
        let raw = BigRational::new_raw(r.numer() * -6, r.denom() * -6);
        prop_assert_eq!(Rational::from(&raw), y.clone());
        prop_assert_eq!(Rational::from(raw), y.clone());
        prop_assert_eq!(Integer::try_from(&y).ok(), r.is_integer().then(|| ours(r.numer())));
        prop_assert_eq!(i64::try_from(&x).ok(), i64::try_from(&a).ok());
        prop_assert_eq!(u64::try_from(&x).ok(), u64::try_from(&a).ok());
        prop_assert_eq!(u128::try_from(&x).ok(), u128::try_from(&a).ok());
        prop_assert_eq!(i128::try_from(x.clone()).ok(), i128::try_from(&a).ok());
        prop_assert_eq!(i8::try_from(x).ok(), i8::try_from(&a).ok());
    }

    #[test]
    fn ratios_of_words(p in word(), q in word().prop_filter("not 0", |q| *q != 0)) {
        let wide = Ratio::new(i128::from(p), i128::from(q));
        let ours = Rational::from(Ratio::new_raw(p, q));
        prop_assert_eq!(&ours, &Rational::new(p, q));
        prop_assert_eq!(Ratio::<i128>::try_from(&ours), Ok(wide));
        let narrow = (i64::try_from(*wide.numer()), i64::try_from(*wide.denom()));
        let narrow = if let (Ok(p), Ok(q)) = narrow { Some(Ratio::new_raw(p, q)) } else { None };
        prop_assert_eq!(Ratio::<i64>::try_from(ours.clone()).ok(), narrow);
        let small = i32::try_from(*wide.numer()).is_ok() && i32::try_from(*wide.denom()).is_ok();
        prop_assert_eq!(Ratio::<i32>::try_from(ours).is_ok(), small);
    }

    #[test]
    fn generic_code_computes_the_same(a in integer(), b in nonzero(), r in ratio(), s in ratio()) {
        let found: Vec<BigInt> = generic(&ours(&a), &ours(&b)).iter().map(BigInt::from).collect();
        prop_assert_eq!(found, generic(&a, &b));
        if !s.is_zero() {
            let found: Vec<BigRational> = generic(&our_ratio(&r), &our_ratio(&s)).iter().map(theirs).collect();
            prop_assert_eq!(found, generic(&r, &s));
        }
        let (x, y) = (ours(&a), our_ratio(&r));
        prop_assert_eq!(machine(&x), machine(&a));
        prop_assert_eq!(machine(&y), machine(&r.trunc().to_integer()));
        prop_assert_eq!((Signed::is_positive(&x), Signed::is_negative(&y)), (a.is_positive(), r.is_negative()));
        prop_assert_eq!((Zero::is_zero(&x), One::is_one(&y)), (a.is_zero(), r.is_one()));
        prop_assert_eq!(y.to_f64(), Some(nearest(&y)));
        prop_assert_eq!(x.to_f64(), Some(nearest(&Rational::from(x))));
    }

    #[test]
    fn floats_there_and_back(bits in any::<u64>(), single in any::<u32>()) {
        let value = f64::from_bits(bits);
        prop_assert_eq!(Rational::from_f64(value), exact(value));
        prop_assert_eq!(Rational::from_f64(value).map(|x| theirs(&x)), BigRational::from_float(value));
        prop_assert_eq!(Integer::from_f64(value).map(|x| BigInt::from(&x)), BigInt::from_f64(value));
        let single = f32::from_bits(single);
        prop_assert_eq!(Rational::from_f32(single).map(|x| theirs(&x)), BigRational::from_float(single));
        if value.is_finite() {
            prop_assert_eq!(Rational::from_f64(value).unwrap().to_f64(), Some(value));
        }
        if single.is_finite() {
            prop_assert_eq!(Rational::from_f32(single).unwrap().to_f32(), Some(single));
        }
    }

    #[test]
    fn texts_in_every_base(r in ratio(), radix in 2_u32..37) {
        let y = our_ratio(&r);
        let whole = r.numer().to_str_radix(radix);
        let text = format!("{whole}/{}", r.denom().to_str_radix(radix));
        prop_assert_eq!(Rational::from_str_radix(&text, radix), Ok(y.clone()));
        prop_assert_eq!(Rational::from_str_radix(&text.to_uppercase(), radix), Ok(y.clone()));
        prop_assert_eq!(Integer::from_str_radix(&whole, radix), Ok(y.numerator()));
        prop_assert_eq!(Rational::from_str_radix(&whole, radix), Ok(y.numerator().into()));
        prop_assert_eq!(y.to_string().parse::<Rational>(), Ok(y.clone()));
        prop_assert_eq!(y.numerator().to_string().parse::<Integer>(), Ok(y.numerator()));
    }

    #[test]
    fn json_there_and_back(r in ratio()) {
        let y = our_ratio(&r);
        let text = serde_json::to_string(&y).unwrap();
        prop_assert_eq!(&text, &format!("\"{y}\""));
        prop_assert_eq!(serde_json::from_str::<Rational>(&text).unwrap(), y.clone());
        let integers = vec![y.numerator(), y.denominator()];
        let text = serde_json::to_string(&integers).unwrap();
        prop_assert_eq!(serde_json::from_str::<Vec<Integer>>(&text).unwrap(), integers);
    }
}

#[test]
fn ends_of_words() {
    let two_to_63 = BigInt::from(1_u64 << 63);
    assert_eq!(Integer::from(&two_to_63), -Integer::from(i64::MIN));
    assert_eq!(BigInt::from(Integer::from(i64::MIN)), -&two_to_63);
    assert_eq!(Integer::from(i64::MIN) / Integer::from(-1), Integer::from(two_to_63));
    assert_eq!(Integer::from(i64::MIN) % Integer::from(-1), Integer::zero());
    assert_eq!(Integer::from(u128::MAX).to_u128(), Some(u128::MAX));
    assert_eq!((Integer::from(u128::MAX) + Integer::one()).to_u128(), None);
    assert_eq!(Rational::new(-1, 2).to_u64(), Some(0));
    // −2^63/−1 and 1/−2^63, as machine integers have them.
    assert_eq!(Rational::from(Ratio::new_raw(i64::MIN, -1)).to_string(), "9223372036854775808");
    let reciprocal = Rational::from(Ratio::new_raw(1, i64::MIN));
    assert_eq!(reciprocal.to_string(), "-1/9223372036854775808");
    let error = Ratio::<i64>::try_from(reciprocal).unwrap_err();
    assert_eq!(error.to_string(), "-1/9223372036854775808 does not fit into Ratio<i64>");
    assert_eq!(u8::try_from(Integer::from(-1)).unwrap_err().to_string(), "-1 does not fit into u8");
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!((Rational::from_f64(value), Integer::from_f64(value)), (None, None));
    }
    assert_eq!(Rational::power_of_ten(400).to_f64(), Some(f64::INFINITY));
    // Rounded once: by way of an f64 it would be 1.
    let above = Rational::one() + Rational::from(2).pow(-24) + Rational::from(2).pow(-60);
    assert_eq!(above.to_f32(), Some(1.0 + f32::EPSILON));
}

#[test]
fn texts_that_are_refused() {
    for text in ["1/2", "1.0", "+-1", "1 1", "1e3", "-", "1_000", "٣"] {
        let error = NumberError::NotAnInteger { text: text.to_owned(), radix: 10 };
        assert_eq!(text.parse::<Integer>(), Err(error));
    }
    assert_eq!("".parse::<Integer>(), Err(NumberError::Empty));
    for text in ["1.5", "12", "1/+1", "-1/-1", "1/", "0b1"] {
        let error = NumberError::NotAFraction { text: text.to_owned(), radix: 2 };
        assert_eq!(Rational::from_str_radix(text, 2), Err(error));
    }
    let error = Integer::from_str_radix("z", 35).unwrap_err().to_string();
    assert!(error.starts_with("`z` is not an integer in base 35: write its digits"), "{error}");
    for radix in [0, 1, 37, u32::MAX] {
        assert_eq!(Rational::from_str_radix("1", radix), Err(NumberError::Base { radix }));
    }
    let zero = NumberError::ZeroDenominator { text: "1/000".to_owned() };
    assert_eq!(Rational::from_str_radix("1/000", 7), Err(zero));
    let long = "1".repeat(MAX_DIGITS + 1);
    let too_long = NumberError::TooLong { digits: MAX_DIGITS + 1 };
    assert_eq!(Integer::from_str_radix(&long, 2), Err(too_long.clone()));
    assert_eq!(long.parse::<Integer>(), Err(too_long));
}

#[test]
fn json_that_is_refused() {
    let refused = |text: &str| serde_json::from_str::<Rational>(text).unwrap_err().to_string();
    assert!(refused("\"1/0\"").starts_with("`1/0` has denominator 0"));
    assert!(refused("\"1 1\"").contains("unexpected `1` at character 3"));
    assert!(refused("\"\"").starts_with("a number is missing"));
    for text in ["0.5", "1", "null", "[1, 2]"] {
        let error = refused(text);
        assert!(error.contains("expected a number in quotes, such as \"-35/1296\""), "{error}");
    }
    let error = serde_json::from_str::<Integer>("\"1/2\"").unwrap_err().to_string();
    assert!(error.starts_with("`1/2` is not an integer in base 10"), "{error}");
    // What would not be read is not written.
    let long = Rational::from(2).pow(40_000);
    let error = serde_json::to_string(&long).unwrap_err().to_string();
    assert_eq!(error, "a number of 12042 digits; at most 10000 are read");
}

#[test]
#[should_panic(expected = "division by zero")]
fn an_integer_divided_by_zero() {
    let _ = Integer::one() / Integer::zero();
}

#[test]
#[should_panic(expected = "a fraction with denominator 0")]
fn a_remainder_by_zero() {
    let _ = Rational::one() % Rational::zero();
}

#[test]
#[should_panic(expected = "a fraction with denominator 0")]
fn a_ratio_without_a_denominator() {
    let _ = Rational::from(Ratio::new_raw(1_i64, 0));
}

#[cfg(feature = "gmp")]
mod gmp {
    use super::*;
    use subcert::exact::crates::rug;

    proptest! {
        #[test]
        fn numbers_of_rug_there_and_back(r in ratio()) {
            let y = our_ratio(&r);
            let text: rug::Rational = r.to_string().parse().unwrap();
            prop_assert_eq!(rug::Rational::from(&y), text.clone());
            prop_assert_eq!(Rational::from(&text), y.clone());
            prop_assert_eq!(Rational::from(rug::Rational::from(y.clone())), y.clone());
            let whole = y.numerator();
            prop_assert_eq!(rug::Integer::from(&whole), text.numer().clone());
            prop_assert_eq!(Integer::from(text.numer()), whole.clone());
            prop_assert_eq!(Integer::from(rug::Integer::from(whole.clone())), whole);
        }
    }
}
