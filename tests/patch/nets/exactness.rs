//! Tolerances that are too near to the distance for f64.

use super::depth;
use crate::common::r;
use crate::net::{heights, scheme};
use subcert::exact::Rational;

/// A second difference −2 at the top of a ridge: a sixth of it for cubic splines, an eighth for quadratic ones,
/// and a quarter at each later level. With the distance as tolerance the level is sufficient, and by however little
/// less it is not.
#[test]
fn a_tolerance_that_is_the_distance() {
    for (name, first) in [("bicubic", r(1, 3)), ("chaikin", r(1, 4))] {
        let net = heights(9, 9, |_, j| Rational::from(i64::from(j == 4)));
        for level in 0..2_u32 {
            let distance = &first * r(1, 4).pow(level.cast_signed());
            let found = depth(&net, &scheme(name), &distance);
            assert_eq!(found.level, level, "{name}: {found:?}");
            assert!(found.exact_pieces > 0, "{name}: {found:?}");
            let less = &distance - Rational::new(1, 10).pow(30);
            let found = depth(&net, &scheme(name), &less);
            assert_eq!((found.level, found.too_few), (level + 1, Some(level)), "{name}: {found:?}");
            assert!(found.exact_pieces > 0, "{name}: {found:?}");
        }
    }
}

/// A scheme whose limit is no polynomial: a tie is left open, and said to be.
#[test]
fn a_tie_without_polynomials_is_open() {
    // The 4-point scheme puts the point between 0, 1, 1, 0 at 9/8: 1/8 above the net of level 0.
    let net = heights(10, 10, |_, j| Rational::from(i64::from(j == 4 || j == 5)));
    let found =
        depth(&net, &scheme("four-point:w=1/16"), &(r(1, 8) - Rational::new(1, 10).pow(30)));
    assert!(found.too_few == Some(0) && found.level == 1, "{found:?}");
}

/// Nets far away, tiny and huge.
#[test]
fn nets_of_any_size() {
    let unit = Rational::from(2).pow(700);
    for unit in [unit.clone(), unit.recip()] {
        let net = heights(6, 6, |i, j| Rational::from((i * i + 3 * j) % 5)).map(|x| x * &unit);
        let found = depth(&net, &scheme("bicubic"), &(&unit / Rational::from(100)));
        let plain = depth(&net.map(|x| x / &unit), &scheme("bicubic"), &r(1, 100));
        assert_eq!((found.level, found.too_few), (plain.level, plain.too_few));
    }
    let far = Rational::power_of_ten(400);
    let net = heights(6, 6, |_, _| Rational::zero()).map(|x| x * &far);
    assert!(subcert::patch::NetDistances::new(net, &scheme("bicubic")).is_err());
    // All points are one: so is the limit.
    let net = heights(6, 6, |_, _| Rational::zero()).map(|_| r(1, 3));
    let found = depth(&net, &scheme("four-point:w=1/16"), &r(1, 1_000_000));
    assert_eq!((found.level, found.too_few), (0, None));
}
