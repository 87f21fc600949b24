//! Random formulas, printed with as few parentheses as the grammar allows, and
//! their values by a naive evaluator over num-rational.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One as _, Signed as _, Zero as _};
use proptest::prelude::*;
use subcert::exact::{Polynomial, Rational};
use subcert::formula::{Parameters, evaluate, parse};

#[derive(Clone, Debug)]
enum Tree {
    Number(u32),
    Decimal(u32, u32),
    Name(usize),
    /// The index of the sum so many sums outside.
    Index(usize),
    Negate(Box<Tree>),
    Add(Box<Tree>, Box<Tree>),
    Subtract(Box<Tree>, Box<Tree>),
    Multiply(Box<Tree>, Box<Tree>),
    Divide(Box<Tree>, Box<Tree>),
    Power(Box<Tree>, i32),
    Abs(Box<Tree>),
    Floor(Box<Tree>),
    Ceil(Box<Tree>),
    Least(Vec<Tree>),
    Greatest(Vec<Tree>),
    Binomial(Box<Tree>, i32),
    Sum(i32, i32, Box<Tree>),
}

const NAMES: [&str; 2] = ["w", "μ_1"];

/// Trees of ring operations, which symbols have too; or all trees.
fn tree(ring_only: bool) -> impl Strategy<Value = Tree> {
    let leaf = prop_oneof![
        (0_u32..30).prop_map(Tree::Number),
        (0_u32..3000, 1_u32..4).prop_map(|(digits, places)| Tree::Decimal(digits, places)),
        (0..NAMES.len()).prop_map(Tree::Name),
        (0_usize..2).prop_map(Tree::Index),
    ];
    leaf.prop_recursive(4, 24, 3, move |inner| {
        let one = || inner.clone().prop_map(Box::new);
        let some = || prop::collection::vec(inner.clone(), 1..3);
        let ring = prop_oneof![
            one().prop_map(Tree::Negate),
            (one(), one()).prop_map(|(a, b)| Tree::Add(a, b)),
            (one(), one()).prop_map(|(a, b)| Tree::Subtract(a, b)),
            (one(), one()).prop_map(|(a, b)| Tree::Multiply(a, b)),
            (one(), 0_i32..4).prop_map(|(a, k)| Tree::Power(a, k)),
            (one(), -1_i32..4).prop_map(|(a, k)| Tree::Binomial(a, k)),
            (-2_i32..2, -2_i32..4, one()).prop_map(|(from, to, body)| Tree::Sum(from, to, body)),
        ];
        if ring_only {
            return ring.boxed();
        }
        let field = prop_oneof![
            (one(), one()).prop_map(|(a, b)| Tree::Divide(a, b)),
            (one(), -3_i32..0).prop_map(|(a, k)| Tree::Power(a, k)),
            one().prop_map(Tree::Abs),
            one().prop_map(Tree::Floor),
            one().prop_map(Tree::Ceil),
            some().prop_map(Tree::Least),
            some().prop_map(Tree::Greatest),
        ];
        prop_oneof![ring, field].boxed()
    })
}

/// How tightly a form binds: sums 0, products 1, signs 2, powers 3, the rest 4.
fn print(tree: &Tree, binding: u8, sums: usize) -> String {
    let at = |tree: &Tree, binding| print(tree, binding, sums);
    let list = |trees: &[Tree]| trees.iter().map(|tree| at(tree, 0)).collect::<Vec<_>>().join(", ");
    let (own, text) = match tree {
        Tree::Number(n) => (4, n.to_string()),
        Tree::Decimal(digits, places) => {
            (4, format!("{digits}.{digits:0>width$}e-1", width = *places as usize))
        }
        Tree::Name(at) => (4, NAMES[*at].to_owned()),
        Tree::Index(out) if *out < sums => (4, format!("h{}", sums - 1 - out)),
        Tree::Index(_) => (4, "7".to_owned()),
        Tree::Negate(a) => (2, format!("-{}", at(a, 2))),
        Tree::Add(a, b) => (0, format!("{}+{}", at(a, 0), at(b, 1))),
        Tree::Subtract(a, b) => (0, format!("{} − {}", at(a, 0), at(b, 1))),
        Tree::Multiply(a, b) => (1, format!("{}*{}", at(a, 1), at(b, 2))),
        Tree::Divide(a, b) => (1, format!("{} / {}", at(a, 1), at(b, 2))),
        Tree::Power(a, k) => (3, format!("{}^{k}", at(a, 4))),
        Tree::Abs(a) => (4, format!("abs({})", at(a, 0))),
        Tree::Floor(a) => (4, format!("floor({})", at(a, 0))),
        Tree::Ceil(a) => (4, format!("ceil({})", at(a, 0))),
        Tree::Least(trees) => (4, format!("min({})", list(trees))),
        Tree::Greatest(trees) => (4, format!("max({})", list(trees))),
        Tree::Binomial(a, k) => (4, format!("binomial({}, {k})", at(a, 0))),
        Tree::Sum(from, to, body) => {
            (4, format!("sum(h{sums}={from}..{to}, {})", print(body, 0, sums + 1)))
        }
    };
    if own < binding { format!("({text})") } else { text }
}

fn integer(value: i32) -> BigRational {
    BigRational::from(BigInt::from(value))
}

/// The value, or `None` where something is divided by 0.
fn naive(tree: &Tree, names: &[BigRational; 2], sums: &mut Vec<i32>) -> Option<BigRational> {
    let mut at = |tree: &Tree| naive(tree, names, sums);
    Some(match tree {
        Tree::Number(n) => BigRational::from(BigInt::from(*n)),
        Tree::Decimal(digits, places) => {
            // digits.digits, the second padded to the places, over 10.
            let width = digits.to_string().len().max(*places as usize);
            let fraction = BigRational::new(
                (*digits).into(),
                BigInt::from(10).pow(u32::try_from(width).ok()?),
            );
            (BigRational::from(BigInt::from(*digits)) + fraction) / integer(10)
        }
        Tree::Name(at) => names[*at].clone(),
        Tree::Index(out) => integer(sums.iter().rev().nth(*out).copied().unwrap_or(7)),
        Tree::Negate(a) => -at(a)?,
        Tree::Add(a, b) => at(a)? + at(b)?,
        Tree::Subtract(a, b) => at(a)? - at(b)?,
        Tree::Multiply(a, b) => at(a)? * at(b)?,
        Tree::Divide(a, b) => {
            let (a, b) = (at(a)?, at(b)?);
            if b.is_zero() {
                return None;
            }
            a / b
        }
        Tree::Power(a, k) => {
            let a = at(a)?;
            if a.is_zero() && *k < 0 {
                return None;
            }
            let power = (0..k.abs()).fold(BigRational::one(), |power, _| power * &a);
            if *k < 0 { power.recip() } else { power }
        }
        Tree::Abs(a) => at(a)?.abs(),
        Tree::Floor(a) => at(a)?.floor(),
        Tree::Ceil(a) => at(a)?.ceil(),
        Tree::Least(trees) => {
            trees.iter().map(at).collect::<Option<Vec<_>>>()?.into_iter().min()?
        }
        Tree::Greatest(trees) => {
            trees.iter().map(at).collect::<Option<Vec<_>>>()?.into_iter().max()?
        }
        Tree::Binomial(_, k) if *k < 0 => {
            if let Tree::Binomial(a, _) = tree {
                at(a)?;
            }
            BigRational::zero()
        }
        Tree::Binomial(a, k) => {
            let a = at(a)?;
            (0..*k)
                .fold(BigRational::one(), |product, i| product * (&a - integer(i)) / integer(i + 1))
        }
        Tree::Sum(from, to, body) => {
            let mut total = BigRational::zero();
            for h in *from..=*to {
                sums.push(h);
                let term = naive(body, names, sums);
                sums.pop();
                total += term?;
            }
            total
        }
    })
}

fn value() -> impl Strategy<Value = (i64, i64)> {
    (-9_i64..10, 1_i64..8)
}

fn big((p, q): (i64, i64)) -> BigRational {
    BigRational::new(p.into(), q.into())
}

proptest! {
    #![proptest_config(crate::common::cases(1_500))]

    #[test]
    fn printed_trees_have_their_naive_values(tree in tree(false), w in value(), mu in value()) {
        let text = print(&tree, 0, 0);
        let parameters = Parameters::from(
            [("w", Rational::new(w.0, w.1)), ("μ_1", Rational::new(mu.0, mu.1))],
        );
        let ours = evaluate(&parse(&text).unwrap(), &parameters);
        match naive(&tree, &[big(w), big(mu)], &mut Vec::new()) {
            Some(value) => prop_assert_eq!(ours.unwrap().to_string(), value.to_string(), "{}", text),
            None => prop_assert!(ours.is_err(), "{text} divides by zero"),
        }
    }

    // The same formula over symbols, and then over numbers.
    #[test]
    fn symbols_and_numbers_agree(tree in tree(true), w in value(), mu in value()) {
        let formula = parse(&print(&tree, 0, 0)).unwrap();
        let numbers = Parameters::from(
            [("w", Rational::new(w.0, w.1)), ("μ_1", Rational::new(mu.0, mu.1))],
        );
        let symbols = Parameters::from(
            [("w", Polynomial::variable("w")), ("μ_1", Polynomial::variable("μ_1"))],
        );
        let symbolic = evaluate(&formula, &symbols).unwrap();
        let printed = parse(&symbolic.to_string());
        // What is too long to read back was still evaluated without a panic.
        if let Ok(printed) = printed {
            prop_assert_eq!(evaluate(&printed, &numbers), evaluate(&formula, &numbers));
        }
    }
}
