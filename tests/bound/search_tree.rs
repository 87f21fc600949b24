//! Trees of searches, followed by definitions alone.

use super::row_bounds::{KnownLimits, Row, line_bound, moment, power_row, product_bound, size};
use crate::common::{affine, mask, r};
use proptest::prelude::*;
use subcert::bound::{
    Closed, JointSearch, Leaf, Order, PowerSearch, SearchTree, SearchedOperator, UniformBound,
    walked_joint_norm, walked_norm,
};
use subcert::exact::{Integer, Rational};
use subcert::scheme::Rules;

/// R at the offset of a tree, and what the tree says of it.
struct Operator<'a> {
    rules: Rules,
    data: &'a SearchedOperator,
}

impl Operator<'_> {
    fn row(&self, levels: u32, index: &Integer) -> Row {
        power_row(&self.rules, &self.data.factor, levels, index)
    }

    /// Whether 61 and 62 apply.
    fn has_lines(&self) -> bool {
        let sum = |beta| self.row(1, &Integer::from(beta)).into_values().sum::<Rational>();
        (0..self.rules.arity()).all(|beta| sum(beta) == r(1, 1))
    }

    /// φ and ρ of Theorem 61.
    fn shift(&self) -> [Rational; 2] {
        let n = i64::try_from(self.rules.arity()).unwrap();
        let shift = |beta: i64| moment(&self.row(1, &Integer::from(beta))) - r(beta, n);
        let shifts: Vec<Rational> = (0..n).map(shift).collect();
        let (least, most) = (shifts.iter().min().unwrap(), shifts.iter().max().unwrap());
        [(least + most) * r(1, 2), (most - least) * r(1, 2)]
    }

    /// Theorem 61 as it stands, and that it is true of every row.
    fn known(&self, m: u32) -> KnownLimits {
        let nth = Rational::new(1, self.rules.arity());
        assert!(self.has_lines());
        let ([phi, rho], totals) = (self.shift(), &self.data.totals);
        let powers = (0..m).map(|k| nth.pow((m - 1 - k).cast_signed()));
        let middle = phi * powers.clone().sum::<Rational>();
        let radius = rho * powers.zip(totals).map(|(x, tau)| x * tau).sum::<Rational>();
        let last = r(1, 1) - nth.pow(m.cast_signed());
        for (t, index) in indices(self.rules.arity(), m).enumerate() {
            let row = self.row(m, &index);
            let place = &middle + Rational::from(t) * nth.pow(m.cast_signed());
            assert!((moment(&row) - place).abs() <= radius);
            assert!(size(&row) <= totals[m as usize]);
        }
        let moments = [&middle - &radius, middle + last + &radius];
        KnownLimits { moments, radius, tau: totals[m as usize].clone() }
    }
}

fn indices(arity: usize, levels: u32) -> impl Iterator<Item = Integer> {
    (0..Integer::from(arity).pow(levels).to_i64().unwrap()).map(Integer::from)
}

/// The leaves cover all rows, and their bounds are at most the norm.
fn follow(rules: &[&Rules], levels: u32, tree: &SearchTree) {
    let at = |(rules, data): (&&Rules, _)| {
        let rules = rules.with_offset(tree.offset);
        Operator { rules, data }
    };
    let operators: Vec<Operator> = rules.iter().zip(&tree.operators).map(at).collect();
    assert_eq!(operators.len(), rules.len());
    let arity = rules[0].arity();
    let n = Integer::from(arity);
    let norm = |index: &Integer| {
        let sizes = operators.iter().map(|operator| size(&operator.row(levels, index)));
        sizes.reduce(|x, y| x * y).unwrap()
    };
    assert_eq!(indices(arity, levels).map(|index| norm(&index)).max().unwrap(), tree.norm);
    // The positions that any row needs.
    let rows = (0..=levels).flat_map(|m| {
        let of = |operator| indices(arity, m).map(move |t| Operator::row(operator, m, &t));
        operators.iter().flat_map(of).collect::<Vec<Row>>()
    });
    let supports = rows.flat_map(Row::into_keys).map(|p| p.to_i64().unwrap());
    let (first, last) = supports.fold((0, 0), |(low, high), p| (low.min(p), high.max(p)));
    for operator in &operators {
        if let Some(uniform) = &operator.data.uniform {
            follow_uniform(operator, (first, last), uniform);
        }
    }
    let mut next = Integer::zero();
    for leaf in &tree.leaves {
        let m = levels - leaf.level;
        assert_eq!(&leaf.index * n.pow(m), next);
        next += &n.pow(m);
        let bound = leaf_bound(&operators, (first, last), leaf, m);
        assert!(bound <= tree.norm, "{leaf:?} of {rules:?}");
    }
    assert_eq!(next, n.pow(levels));
}

fn leaf_bound(
    operators: &[Operator],
    (first, last): (i64, i64),
    leaf: &Leaf,
    left: u32,
) -> Rational {
    let row =
        |operator: &Operator, p: i64| operator.row(leaf.level, &(&leaf.index + Integer::from(p)));
    let rows =
        |operator: &Operator| -> Vec<Row> { (first..=last).map(|p| row(operator, p)).collect() };
    let each = |bound: &dyn Fn(&Operator) -> Rational| {
        operators.iter().map(bound).reduce(|x, y| x * y).unwrap()
    };
    let largest = |operator: &Operator| {
        rows(operator).iter().map(size).max().unwrap() * &operator.data.totals[left as usize]
    };
    let line = |operator: &Operator| line_bound(&rows(operator), first, &operator.known(left));
    match leaf.closed {
        Closed::Row => each(&|operator| size(&row(operator, 0))),
        Closed::Line if operators.len() == 1 => line(&operators[0]),
        Closed::Line => {
            let known: Vec<KnownLimits> =
                operators.iter().map(|operator| operator.known(left)).collect();
            product_bound(&operators.iter().map(rows).collect::<Vec<_>>(), first, &known)
        }
        Closed::Largest if operators.len() == 1 => largest(&operators[0]),
        Closed::Largest => each(&|operator| match largest(operator) {
            bound if operator.has_lines() && first < last => bound.min(line(operator)),
            bound => bound,
        }),
    }
}

/// The tree of Theorem 63 covers all rows, and shows the bound.
fn follow_uniform(operator: &Operator, (first, last): (i64, i64), uniform: &UniformBound) {
    assert!(operator.has_lines());
    let n = Integer::from(operator.rules.arity());
    let tau = &uniform.bound;
    let nth = Rational::new(1, operator.rules.arity());
    let [phi, rho] = operator.shift();
    let whole = (r(1, 1) - &nth).recip();
    let (limit, radius) = (&phi * &whole, rho * tau * &whole);
    let moments =
        [phi.clone().min(limit.clone()) - &radius, (phi - &nth).max(limit) + r(1, 1) + &radius];
    let known = KnownLimits { moments, radius, tau: tau.clone() };
    let mut next = Rational::zero();
    for (level, index) in &uniform.leaves {
        assert!(*level > 0);
        // The part of all rows that are below it.
        let part = n.pow(*level);
        assert_eq!(Rational::new(index.clone(), part.clone()), next);
        next += &Rational::new(1, part);
        let mut above = index.clone();
        for m in (0..=*level).rev() {
            assert!(size(&operator.row(m, &above)) <= *tau);
            above = above.div_floor(&n);
        }
        let row = |p: i64| operator.row(*level, &(index + Integer::from(p)));
        let rows: Vec<Row> = (first..=last).map(row).collect();
        assert!(line_bound(&rows, first, &known) <= *tau, "level {level}, {index}");
    }
    assert_eq!(next, r(1, 1));
}

fn follow_power(rules: &Rules, levels: u32) -> SearchTree {
    let tree = PowerSearch::new(rules, Order::Adjoint).tree(levels).unwrap();
    follow(&[rules], levels, &tree);
    let scale = tree.operators[0].factor.abs().pow(levels.cast_signed());
    let norm = walked_norm(rules, levels, Order::Adjoint).unwrap().value;
    assert_eq!(norm, &tree.norm * scale);
    tree
}

fn follow_joint(first: &Rules, second: &Rules, levels: u32) -> SearchTree {
    let tree = JointSearch::new(first, second, Order::Adjoint).tree(levels).unwrap();
    follow(&[first, second], levels, &tree);
    let factors = tree.operators.iter().map(|operator| operator.factor.abs());
    let scale = factors.reduce(|x, y| x * y).unwrap().pow(levels.cast_signed());
    let norm = walked_joint_norm(first, second, levels, Order::Adjoint).unwrap().value;
    assert_eq!(norm, &tree.norm * scale);
    tree
}

const SCHEMES: [(&str, u32); 6] = [
    ("four-point", 10),
    ("six-point:w=3/256", 7),
    ("chaikin", 6),
    ("ternary-four-point:mu=1/11", 5),
    ("quinary-three-point", 3),
    ("newton:j=1,n=3", 4),
];

#[test]
fn trees_can_be_followed() {
    for (scheme, levels) in SCHEMES {
        let mask = mask(scheme);
        let tree = follow_power(&mask.difference(), levels);
        assert_eq!(tree.operators[0].uniform.is_some(), levels == 10, "{scheme}");
        follow_power(mask.rules(), levels.min(5));
    }
}

#[test]
fn joint_trees_can_be_followed() {
    let mut closed = Vec::new();
    for (scheme, levels) in SCHEMES {
        let mask = mask(scheme);
        let tree = follow_joint(&mask.difference(), mask.rules(), levels.min(7));
        assert!(tree.leaves.len() < mask.rules().arity().pow(levels), "{scheme}");
        closed.extend(tree.leaves.into_iter().map(|leaf| leaf.closed));
    }
    for reason in [Closed::Row, Closed::Line, Closed::Largest] {
        assert!(closed.contains(&reason), "{reason:?}");
    }
}

proptest! {
    #![proptest_config(crate::common::cases(24))]

    #[test]
    fn joint_trees_of_random_masks(mask in affine(3, 4)) {
        follow_joint(&mask.difference(), mask.rules(), 50_usize.ilog(mask.rules().arity()));
    }
}
