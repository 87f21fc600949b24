//! Schemes of the paper's own with a parameter, and those of the catalogue.

use crate::random_papers::choices::Choices;
use crate::random_papers::naive::{Curve, Q, int};
use num_traits::{One, Zero};

/// A mask whose entries are a + b·w.
#[derive(Clone, Debug)]
pub struct Family {
    pub name: String,
    rules: Vec<Vec<[Q; 2]>>,
    offset: i64,
    /// The value of w where a reference gives none.
    pub default: Option<Q>,
}

impl Family {
    pub fn new(name: &str, choices: &mut Choices) -> Family {
        let (arity, width) = (2 + usize::from(choices.once_in(3)), 2 + choices.below(3));
        let slopes = [int(0), int(1), Q::new((-1).into(), 2.into())];
        let rule = |_| {
            let mut parts: Vec<i64> =
                (0..width).map(|_| [0, 1, 2, 3, -1][choices.below(5)]).collect();
            // Most rules are near to means, so that most schemes converge.
            parts[choices.below(width)] += 2;
            let total: i64 = parts.iter().sum();
            let (parts, total) =
                if total > 0 { (parts, total) } else { (vec![1; width], int_of(width)) };
            let mut rule: Vec<[Q; 2]> =
                parts.iter().map(|a| [Q::new((*a).into(), total.into()), Q::zero()]).collect();
            let slope = choices.of(&slopes);
            rule[0][1] += &slope;
            rule[width - 1][1] -= &slope;
            rule
        };
        let rules = (0..arity).map(rule).collect();
        let offset = choices.of(&[0, -1, 1, -2]);
        let default = choices.once_in(3).then(|| Q::new(1.into(), 8.into()));
        Family { name: name.to_owned(), rules, offset, default }
    }

    pub fn at(&self, w: &Q) -> Curve {
        let rule = |rule: &Vec<[Q; 2]>| rule.iter().map(|[a, b]| a + b * w).collect();
        Curve::new(self.rules.iter().map(rule).collect(), self.offset)
    }

    pub fn text(&self) -> String {
        let entry = |[a, b]: &[Q; 2]| {
            if b.is_zero() { format!("'{a}'") } else { format!("'{a} + ({b})*w'") }
        };
        let rule = |rule: &Vec<[Q; 2]>| {
            format!("[{}]", rule.iter().map(entry).collect::<Vec<_>>().join(", "))
        };
        let rules: Vec<String> = self.rules.iter().map(rule).collect();
        let default = self.default.as_ref().map(|w| format!("default = '{w}', "));
        format!(
            "[[scheme]]\nname = '{}'\nparameters.w = {{ {}about = '' }}\noffset = '{}'\nmask = [{}]\n",
            self.name,
            default.unwrap_or_default(),
            self.offset,
            rules.join(", ")
        )
    }
}

fn int_of(count: usize) -> i64 {
    i64::try_from(count).expect("few")
}

/// Schemes of the catalogue, as the papers that they are from state them.
pub const CATALOGUE: [&str; 4] =
    ["chaikin", "four-point", "b-spline:degree=3", "ternary-four-point:mu=1/10"];

pub fn catalogue(reference: &str) -> Curve {
    let q = |p: i64, q: i64| Q::new(p.into(), q.into());
    let (rules, offset) = match reference {
        "chaikin" => (vec![vec![q(3, 4), q(1, 4)], vec![q(1, 4), q(3, 4)]], 0),
        "four-point" => {
            let w = q(1, 16);
            let inner = q(1, 2) + &w;
            let odd = vec![-w.clone(), inner.clone(), inner, -w];
            (vec![vec![Q::zero(), Q::one(), Q::zero(), Q::zero()], odd], -1)
        }
        "b-spline:degree=3" => {
            let even = vec![q(1, 8), q(6, 8), q(1, 8)];
            (vec![even, vec![Q::zero(), q(1, 2), q(1, 2)]], -1)
        }
        _ => {
            let mu = q(1, 10);
            let one = [
                -q(1, 18) - &mu / int(6),
                q(13, 18) + &mu / int(2),
                q(7, 18) - &mu / int(2),
                -q(1, 18) + &mu / int(6),
            ];
            let other = one.iter().rev().cloned().collect();
            let first = vec![Q::zero(), Q::one(), Q::zero(), Q::zero()];
            (vec![first, one.to_vec(), other], -1)
        }
    };
    Curve::new(rules, offset)
}
