//! Ranges of smoothness, of one mask and of tensor products.

use super::masks::{Mask, Q, int, spline_times};
use super::mutator::Random;
use super::smooth::{MARGIN, falsehood, lines};
use super::suite::{Claim, Pair, Suite};
use std::fmt::Write as _;

/// Ranges of the tension of the four-point scheme, of one mask and of tensor products with it.
pub fn suite(random: &mut Random) -> Suite {
    let mut claims = "key = 'ranges'\n".to_owned();
    let rough = Mask::new(2, spline_times(2, 1, &[int(1)]));
    let linear = Mask::new(2, spline_times(2, 2, &[int(1)]));
    for (name, mask) in [("rough", &rough), ("linear", &linear)] {
        let _ = writeln!(claims, "[[scheme]]\nname = '{name}'\n{}", mask.toml());
    }
    let at = |w: i64| four_point(&Q::new(w.into(), 1000.into()));
    let contraction = |levels: &str, rest: &[&str]| {
        [&[levels], rest].concat().iter().map(|&text| text.to_owned()).collect::<Vec<String>>()
    };
    let mut pairs = Vec::new();
    for (place, (from, to)) in
        [(10, 100), (0, 125), (-100, 100), (20, 400), (30, 140)].into_iter().enumerate()
    {
        for (which, scheme) in [
            "four-point:w=w",
            "four-point:w=w x linear",
            "rough x four-point:w=w",
            "four-point:w=w x rough",
        ]
        .into_iter()
        .enumerate()
        {
            let factor = match which {
                0 => f64::INFINITY,
                1 => 1.0,
                _ => 0.0,
            };
            let mut claim = |kind: &str, m: i64, only: bool| {
                let id = format!("{kind}-{place}-{which}");
                let _ = writeln!(
                    claims,
                    "[[range]]\nid = '{id}'\nvariable = 'w'\nscheme = '{scheme}'\nsmoothness = '{m}'\nfrom = '{from}/1000'\nto = '{to}/1000'\nonly = {only}"
                );
                let m = m as f64;
                let exponent = |w: i64| at(w).exponent.map(|x| x.min(factor));
                let inside: Vec<[f64; 2]> =
                    (1..8).map(|i| exponent(from + (to - from) * i / 8)).collect();
                let fails = |[_, high]: &[f64; 2]| *high < m - MARGIN;
                let holds = |[low, _]: &[f64; 2]| *low > m + MARGIN;
                let wrong = inside.iter().any(fails) || factor < m;
                // Only where all of a grid holds, it is nearly sure that the claim is true.
                let right = !only && inside.iter().all(holds);
                let mut seeds = vec![
                    contraction(
                        "contraction 1",
                        &["breaks -1/4 1/4", "signs + 0 - 0 +", "confirmed"],
                    ),
                    contraction(
                        "contraction 2",
                        &["breaks 0 root:-1,4,16:1/8:5/32", "signs + 0 - 0 +", "confirmed"],
                    ),
                ];
                for w in [from - 30, i64::midpoint(from, to), to - 1, to + 30] {
                    let mask = at(w);
                    for order in [1, mask.order] {
                        let mut lines = vec![format!("at {w}/1000")];
                        lines.extend(mask.radius(random, order));
                        lines.push("refuted".to_owned());
                        seeds.push(lines);
                    }
                }
                Claim {
                    head: format!("range {id}"),
                    restated: vec![
                        "variable w".to_owned(),
                        format!("scheme {scheme}"),
                        format!("smoothness {m}"),
                    ],
                    seeds,
                    lies: lines(&["confirmed", "refuted"]),
                    replaced: Default::default(),
                    falsehood: falsehood(
                        &[if wrong { Some(false) } else { right.then_some(true) }],
                        Vec::new(),
                    ),
                }
            };
            for kinds in [
                [("all", 1, false), ("only", 1, true)],
                [("continuous", 0, false), ("smoother", 2, false)],
            ] {
                let claims = kinds.map(|(kind, m, only)| claim(kind, m, only));
                pairs.push(Pair { claims, exclusive: false, complementary: false });
            }
        }
    }
    Suite { about: "paper ranges", claims, pairs }
}

/// The four-point scheme of Dyn, Gregory and Levin: −w(1 + z^6) + (1/2 + w)(z² + z⁴) + z³.
fn four_point(w: &Q) -> Mask {
    let side = Q::new(1.into(), 2.into()) + w;
    let zero = int(0);
    Mask::new(2, vec![-w, zero.clone(), side.clone(), int(1), side, zero, -w])
}
