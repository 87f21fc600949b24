//! Schemes without a limit, and questions without an answer.

use crate::common::{mask, r};
use subcert::bound::{Order, power_norm};
use subcert::exact::Rational;
use subcert::limit::{Limit, LimitError};
use subcert::scheme::Mask;

fn refusal(mask: &Mask) -> LimitError {
    Limit::new(mask).expect_err("no limit")
}

#[test]
fn schemes_that_do_not_converge() {
    // x'_{2i} = x'_{2i+1} = x_i: x_{−1} and x_0 both stay where they are, next to
    // each other, for ever.
    let copies = Mask::new(vec![vec![r(1, 1)], vec![r(1, 1)]], 0).unwrap();
    assert_eq!(refusal(&copies), LimitError::NoLimit { first: -1, last: 0 });
    // Δ'_{2i} = −Δ_i, Δ'_{2i+1} = 2Δ_i.
    let wild = Mask::new(vec![vec![r(1, 1), r(0, 1)], vec![r(2, 1), r(-1, 1)]], 0).unwrap();
    let LimitError::NotShown { blocks, least } = refusal(&wild) else { panic!("{wild:?}") };
    assert_eq!((blocks, least.as_str()), (16, "2"));
    let message = refusal(&mask("four-point:w=1")).to_string();
    assert!(message.starts_with("not shown to converge: the least"), "{message}");
    assert!(message.contains("for c from 1 to 16"), "{message}");
}

// The four-point scheme converges for |w| < 1/2; the nearer w is to the ends, the later T_c < 1.
#[test]
fn schemes_that_contract_late() {
    for (w, c) in [("9/20", 8), ("12/25", 19), ("49/100", 36)] {
        let scheme = mask(&format!("four-point:w={w}"));
        let limit = Limit::new(&scheme).unwrap();
        let constants = limit.contraction();
        let first = constants.iter().position(|constant| *constant < r(1, 1));
        assert_eq!(first, Some(c), "w = {w}");
        let norm = power_norm(&scheme.difference(), 19, Order::Adjoint).unwrap();
        assert!(constants.get(19).is_none_or(|constant| *constant == norm.value), "w = {w}");
    }
}

#[test]
fn windows_that_are_too_large() {
    let message = refusal(&mask("b-spline:degree=200")).to_string();
    assert!(message.starts_with("a window of "), "{message}");
    let far = mask("chaikin").with_offset(i64::MIN);
    assert_eq!(refusal(&far), LimitError::Offset(i64::MIN));
    assert!(Limit::new(&mask("chaikin").with_offset(-10_000)).is_ok());
}

#[test]
fn parameters_and_levels() {
    let limit = Limit::new(&mask("ternary-four-point:mu=1/11")).unwrap();
    // 3 has order 100 modulo 101.
    for t in [r(1, 101), Rational::from(3).pow(-257), r(2, 1).pow(60), r(-2, 1).pow(61)] {
        let error = limit.at(&t).unwrap_err();
        assert!(matches!(error, LimitError::Parameter { arity: 3, .. }), "{t}: {error}");
    }
    assert!(limit.at(&Rational::from(3).pow(-256)).is_ok());
    assert!(limit.at(&(r(2, 1).pow(60) - r(1, 9))).is_ok());
    assert_eq!(limit.error(129, &r(1, 3)), Err(LimitError::Level(129)));
    assert!(limit.error(128, &r(1, 3)).is_ok());
}
