//! Branch and bound against the walk over all rows.

use super::common::{affine, mask, r, rules};
use proptest::prelude::*;
use std::collections::BTreeMap;
use subcert::bound::{
    Closed, Order, PowerSearch, UniformBound, joint_norm, power_norm, power_norm_generic,
    walked_joint_norm, walked_norm,
};
use subcert::exact::{Integer, Rational};
use subcert::scheme::{Rules, lagrange_mask};

const ORDERS: [Order; 2] = [Order::Adjoint, Order::Forward];

/// The most levels with at most so many classes.
fn levels(rules: &Rules, classes: usize) -> u32 {
    classes.ilog(rules.arity())
}

/// Coefficients over denominators of up to 64 bits.
fn wide(arity: usize, width: usize) -> impl Strategy<Value = Rules> {
    let entry = (any::<i64>(), 1..=u64::MAX).prop_map(|(p, q)| Rational::new(p, q));
    (2..=arity, 1..=width, -3_i64..4).prop_flat_map(move |(arity, width, offset)| {
        let rows = prop::collection::vec(prop::collection::vec(entry.clone(), width), arity);
        rows.prop_map(move |rows| Rules::new(rows, offset).unwrap())
    })
}

/// The value and the least row of the walk, for every c up to `most`.
fn agree(rules: &Rules, most: u32) -> Result<(), TestCaseError> {
    for order in ORDERS {
        let mut search = PowerSearch::new(rules, order);
        for c in 0..=most {
            let found = search.search(c).expect("the work suffices").norm;
            prop_assert_eq!(&found, &walked_norm(rules, c, order).unwrap(), "c = {}", c);
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    // Difference masks: those of Lagrange's schemes keep lines, those of random masks do not.
    #[test]
    fn difference_masks(mask in affine(6, 10)) {
        let rules = mask.difference();
        agree(&rules, levels(&rules, 300))?;
        // The rows of the mask itself sum to 1.
        agree(mask.rules(), levels(&rules, 300))?;
    }

    #[test]
    fn any_rules(rules in rules(6, 10)) {
        agree(&rules, levels(&rules, 300))?;
    }

    // Beyond 128 bits, and beyond what words hold.
    #[test]
    fn large_denominators(rules in wide(4, 4)) {
        agree(&rules, levels(&rules, 70))?;
        let most = levels(&rules, 20);
        let norm = power_norm(&rules, most, Order::Adjoint).unwrap();
        prop_assert_eq!(norm.value, power_norm_generic(&rules, most, Order::Adjoint).unwrap());
    }

    #[test]
    fn joint_suprema(mask in affine(4, 6)) {
        let difference = mask.difference();
        let most = levels(&difference, 2000);
        for order in ORDERS {
            for c in most - 1..=most {
                let joint = joint_norm(&difference, mask.rules(), c, order).unwrap();
                let read = |rules: &Rules| match order {
                    Order::Adjoint => rules.with_offset(0),
                    Order::Forward => rules.reversed().with_offset(0),
                };
                let (first, second) = (read(&difference), read(mask.rules()));
                let walked = walked_joint_norm(&first, &second, c, Order::Adjoint).unwrap();
                prop_assert_eq!(joint, walked);
            }
        }
    }

    // Every width of integers: a factor of 2^-bits in one mask that is an average of two.
    #[test]
    fn every_width(bits in 1_u32..120, numerator in 1_i64..1000) {
        let weight = Rational::from(numerator) / Rational::from(2).pow(bits.cast_signed() + 10);
        let [first, second] = ["four-point", "b-spline:degree=5"].map(mask);
        let rows = first.rules().rows().iter().zip(second.rules().rows()).map(|(x, y)| {
            let pad = |row: &Vec<Rational>| {
                let mut row = row.clone();
                row.resize(4, Rational::zero());
                row
            };
            let mixed = pad(x).into_iter().zip(pad(y));
            mixed.map(|(x, y)| &x + (y - &x) * &weight).collect()
        });
        let mixed = Rules::new(rows.collect(), 0).unwrap();
        agree(&mixed, 9)?;
    }
}

// Interpolating, for several arities: lines are kept, and more.
#[test]
fn lagrange_schemes() {
    for (points, arity, most) in
        [(1, 2, 12), (2, 2, 12), (1, 3, 8), (2, 3, 7), (1, 4, 6), (1, 6, 5)]
    {
        let mask = lagrange_mask(points, arity).unwrap();
        agree(&mask.difference(), most).unwrap();
        agree(mask.rules(), most).unwrap();
    }
}

// The differences of the four-point scheme: 2^c·T_c = (4 − 4^{−c})/3.
#[test]
fn the_four_point_scheme_in_closed_form() {
    let mut search = PowerSearch::new(&mask("four-point").difference(), Order::Adjoint);
    for c in [1, 2, 3, 10, 17, 64, 100] {
        let found = search.search(c).unwrap();
        let scaled = (Rational::from(4) - Rational::from(4).pow(-c.cast_signed())) / r(3, 1);
        assert_eq!(found.norm.value, scaled * r(1, 2).pow(c.cast_signed()), "c = {c}");
        assert!(found.nodes < 20 * u64::from(c) + 20, "{} nodes for c = {c}", found.nodes);
    }
}

// 5^c·T_c of the quinary three-point scheme is 6·(7/5)^c − 5: it grows, so that every T_m is needed.
#[test]
fn growing_norms_in_closed_form() {
    let mut search = PowerSearch::new(&mask("quinary-three-point").difference(), Order::Adjoint);
    for c in [1, 5, 40, 41, 17, 64] {
        let found = search.search(c).unwrap();
        let scaled = r(6, 1) * r(7, 5).pow(c.cast_signed()) - r(5, 1);
        assert_eq!(found.norm.value, scaled * r(1, 5).pow(c.cast_signed()), "c = {c}");
    }
}

// Long searches, which find greater rows again and again.
#[test]
fn a_quarter_of_a_million_rows() {
    for (scheme, c) in
        [("four-point", 18), ("quaternary-four-point:mu=0", 9), ("six-point:w=3/256", 17)]
    {
        let mask = mask(scheme);
        let difference = mask.difference();
        let joint = joint_norm(&difference, mask.rules(), c - 2, Order::Adjoint).unwrap();
        let [first, second] = [&difference, mask.rules()].map(|rules| rules.with_offset(0));
        let walked = walked_joint_norm(&first, &second, c - 2, Order::Adjoint).unwrap();
        assert_eq!(joint, walked, "{scheme}");
        for rules in [&difference, mask.rules()] {
            for order in ORDERS {
                let found = PowerSearch::new(rules, order).search(c).expect("the work suffices");
                assert_eq!(found.norm, walked_norm(rules, c, order).unwrap(), "{scheme}");
            }
        }
    }
}

// Their product has its maximum where one norm grows and the other falls.
#[test]
fn joint_suprema_of_64_levels() {
    for scheme in ["four-point", "ternary-four-point:mu=1/11"] {
        let mask = mask(scheme);
        let difference = mask.difference();
        let joint = joint_norm(&difference, mask.rules(), 64, Order::Adjoint).unwrap();
        let norm = |rules: &Rules| power_norm(rules, 64, Order::Adjoint).unwrap().value;
        assert!(joint.value <= norm(&difference) * norm(mask.rules()));
        let row =
            |rules: &Rules| size(&power_row(&rules.with_offset(0), &r(1, 1), 64, &joint.class));
        assert_eq!(joint.value, row(&difference) * row(mask.rules()));
    }
}

// All rows of a B-spline scheme have the same sum: the least is named.
#[test]
fn ties_go_to_the_least_row() {
    for degree in 1..6 {
        let rules = mask(&format!("b-spline:degree={degree}")).difference();
        let norm = power_norm(&rules, 40, Order::Adjoint).unwrap();
        assert_eq!((norm.value, norm.class), (r(1, 2).pow(40), Integer::zero()));
    }
}

/// Row i of E^m, from the definition, for all i asked for.
fn power_row(rules: &Rules, factor: &Rational, levels: u32, index: &Integer) -> Row {
    let n = Integer::from(rules.arity());
    let mut row: Row = BTreeMap::from([(index.clone(), Rational::one())]);
    for _ in 0..levels {
        let mut coarse = Row::new();
        for (fine, x) in row {
            let (base, rule) = fine.div_rem_floor(&n);
            let rule = usize::try_from(rule.to_i64().unwrap()).unwrap();
            for (j, y) in (rules.offset()..).zip(&rules.rows()[rule]).filter(|(_, y)| !y.is_zero())
            {
                let entry = coarse.entry(&base + Integer::from(j)).or_insert_with(Rational::zero);
                *entry += &(&x * y / factor);
            }
        }
        row = coarse;
    }
    row
}

type Row = BTreeMap<Integer, Rational>;

fn size(row: &Row) -> Rational {
    row.values().map(Rational::abs).sum()
}

/// Σ c·row.
fn combined(terms: &[(Rational, &Row)]) -> Row {
    let mut sum = Row::new();
    for (c, row) in terms {
        for (index, x) in *row {
            *sum.entry(index.clone()).or_insert_with(Rational::zero) += &(c * x);
        }
    }
    sum
}

/// Theorem 62 as it stands, for the line through positions a and a + 1 that gives the least.
fn line_bound(rows: &[Row], first: i64, [u, v]: &[Rational; 2], tau: &Rational) -> Rational {
    let bound = |a: usize| {
        let at = |w: &Rational| {
            let t = w - Rational::from(first + i64::try_from(a).unwrap());
            combined(&[(Rational::one() - &t, &rows[a]), (t, &rows[a + 1])])
        };
        let position = |p: usize| Rational::from(first + i64::try_from(p).unwrap());
        let off: Vec<Row> = (0..rows.len())
            .map(|p| combined(&[(r(1, 1), &rows[p]), (r(-1, 1), &at(&position(p)))]))
            .collect();
        let (low, high) = (at(u), at(v));
        let value = |row: &Row, k: &Integer| row.get(k).cloned().unwrap_or_else(Rational::zero);
        let sign = |k: &Integer| {
            let radius = off.iter().map(|row| value(row, k).abs()).max().unwrap() * tau;
            let ends = [value(&low, k), value(&high, k)];
            [1, -1].into_iter().find(|&s| ends.iter().all(|x| x * Rational::from(s) >= radius))
        };
        let rest = |row: &Row| {
            let (mut signed, mut others) = (Rational::zero(), Rational::zero());
            for (k, x) in row {
                match sign(k) {
                    Some(s) => signed += &(x * Rational::from(s)),
                    None => others += &x.abs(),
                }
            }
            signed.abs() + others
        };
        size(&low).max(size(&high)) + tau * off.iter().map(rest).max().unwrap()
    };
    (0..rows.len() - 1).map(bound).min().unwrap()
}

/// The leaves cover all rows, and their bounds are at most the norm, by definitions alone; whether
/// a bound of all powers was used, and followed.
fn follow(rules: &Rules, levels: u32) -> bool {
    let tree = PowerSearch::new(rules, Order::Adjoint).tree(levels).unwrap();
    let at = rules.with_offset(tree.offset);
    let n = Integer::from(rules.arity());
    let norm = walked_norm(rules, levels, Order::Adjoint).unwrap().value;
    assert_eq!(norm, tree.norm.clone() * tree.factor.abs().pow(levels.cast_signed()));
    for (m, total) in (0..).zip(&tree.totals) {
        let exact = walked_norm(rules, m, Order::Adjoint).unwrap().value;
        assert!(total * tree.factor.abs().pow(m.cast_signed()) >= exact);
    }
    // The positions that any row needs.
    let rows_of = |m: u32| {
        let last = n.pow(m).to_i64().unwrap();
        (0..last).map(Integer::from)
    };
    let supports = (0..=levels).flat_map(|m| rows_of(m).map(move |t| (m, t))).flat_map(|(m, t)| {
        power_row(&at, &tree.factor, m, &t).into_keys().collect::<Vec<Integer>>()
    });
    let window = supports.fold((0, 0), |(low, high), p| {
        let p = p.to_i64().unwrap();
        (low.min(p), high.max(p))
    });
    if let Some(uniform) = &tree.uniform {
        follow_uniform(&at, &tree.factor, window, uniform);
    }
    let mut next = Integer::zero();
    for leaf in &tree.leaves {
        let m = levels - leaf.level;
        assert_eq!(&leaf.index * n.pow(m), next);
        next += &n.pow(m);
        let row =
            |p: i64| power_row(&at, &tree.factor, leaf.level, &(&leaf.index + Integer::from(p)));
        let rows: Vec<Row> = (window.0..=window.1).map(row).collect();
        let bound = match leaf.closed {
            Closed::Row => size(&row(0)),
            Closed::Largest => rows.iter().map(size).max().unwrap() * &tree.totals[m as usize],
            Closed::Line => {
                let moment = |t: Integer| -> Rational {
                    let row = power_row(&at, &tree.factor, m, &t);
                    row.iter().map(|(p, x)| Rational::from(p.clone()) * x).sum()
                };
                let moments: Vec<Rational> = rows_of(m).map(moment).collect();
                let ends = [moments.iter().min().unwrap(), moments.iter().max().unwrap()];
                line_bound(&rows, window.0, &ends.map(Clone::clone), &tree.totals[m as usize])
            }
        };
        assert!(bound <= tree.norm, "{leaf:?} of {rules:?}");
    }
    assert_eq!(next, n.pow(levels));
    tree.uniform.is_some()
}

/// The tree of Theorem 63 covers all rows, and shows the bound, by definitions alone.
fn follow_uniform(at: &Rules, factor: &Rational, window: (i64, i64), uniform: &UniformBound) {
    let n = Integer::from(at.arity());
    let tau = &uniform.bound;
    let nth = r(1, n.to_i64().unwrap());
    let shifts: Vec<Rational> = (0..n.to_i64().unwrap())
        .map(|beta| {
            let row = power_row(at, factor, 1, &Integer::from(beta));
            assert_eq!(row.values().sum::<Rational>(), r(1, 1));
            let moment: Rational = row.iter().map(|(p, x)| Rational::from(p.clone()) * x).sum();
            moment - Rational::from(beta) * &nth
        })
        .collect();
    let (least, most) = (shifts.iter().min().unwrap(), shifts.iter().max().unwrap());
    let (phi, rho) = ((least + most) * r(1, 2), (most - least) * r(1, 2));
    let whole = (r(1, 1) - &nth).recip();
    let (limit, radius) = (&phi * &whole, rho * tau * &whole);
    let ends =
        [phi.clone().min(limit.clone()) - &radius, (phi - &nth).max(limit) + r(1, 1) + &radius];
    let mut next = Rational::zero();
    for (level, index) in &uniform.leaves {
        assert!(*level > 0);
        // The part of all rows that are below it.
        let part = n.pow(*level);
        assert_eq!(Rational::new(index.clone(), part.clone()), next);
        next += &Rational::new(1, part);
        let mut above = index.clone();
        for m in (0..=*level).rev() {
            assert!(size(&power_row(at, factor, m, &above)) <= *tau);
            above = above.div_floor(&n);
        }
        let row = |p: i64| power_row(at, factor, *level, &(index + Integer::from(p)));
        let rows: Vec<Row> = (window.0..=window.1).map(row).collect();
        assert!(line_bound(&rows, window.0, &ends, tau) <= *tau, "level {level}, {index}");
    }
    assert_eq!(next, r(1, 1));
}

#[test]
fn trees_can_be_followed() {
    for (scheme, levels) in [
        ("four-point", 10),
        ("six-point:w=3/256", 7),
        ("chaikin", 6),
        ("ternary-four-point:mu=1/11", 5),
        ("quinary-three-point", 3),
        ("newton:j=1,n=3", 4),
    ] {
        let mask = mask(scheme);
        let uniform = follow(&mask.difference(), levels);
        assert_eq!(uniform, levels == 10, "{scheme}");
        follow(mask.rules(), levels.min(5));
    }
}
