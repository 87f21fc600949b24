//! Rings: all integer heights whose neighbours differ by at most 1 are tried.

use super::{Q, int};
use num_traits::{One, Signed, Zero};

#[derive(Clone, Debug)]
pub struct LocalRules {
    pub names: Vec<String>,
    /// The weights of each new point.
    pub weights: Vec<Vec<Q>>,
    pub edges: Vec<(usize, usize)>,
}

impl LocalRules {
    fn times(&self, rows: &[Vec<Q>]) -> Vec<Vec<Q>> {
        let entry = |row: &Vec<Q>, j: usize| {
            row.iter().enumerate().map(|(b, value)| value * &self.weights[b][j]).sum()
        };
        rows.iter().map(|row| (0..self.names.len()).map(|j| entry(row, j)).collect()).collect()
    }

    /// The points of a level as functionals of those of level 0.
    pub fn rows(&self, level: u32) -> Vec<Vec<Q>> {
        let count = self.names.len();
        let unit = |a: usize| (0..count).map(|b| int(i64::from(a == b))).collect();
        (0..level).fold((0..count).map(unit).collect(), |rows: Vec<Vec<Q>>, _| self.times(&rows))
    }

    pub fn place(&self, name: &str) -> Option<usize> {
        self.names.iter().position(|known| known == name)
    }

    /// This ring with its points in the order of another one; none if the points are others.
    pub fn ordered_as(&self, other: &LocalRules) -> Option<LocalRules> {
        let order: Option<Vec<usize>> = other.names.iter().map(|name| self.place(name)).collect();
        let order = order.filter(|order| order.len() == self.names.len())?;
        let row = |a: &usize| order.iter().map(|b| self.weights[*a][*b].clone()).collect();
        let weights = order.iter().map(row).collect();
        Some(LocalRules { names: other.names.clone(), weights, edges: other.edges.clone() })
    }

    pub fn spread(&self, points: &[i64]) -> i64 {
        self.edges.iter().map(|(a, b)| (points[*a] - points[*b]).abs()).max().unwrap_or(0)
    }

    pub fn of(row: &[Q], points: &[i64]) -> Q {
        row.iter().zip(points).map(|(value, x)| value * int(*x)).sum()
    }

    /// All heights of spread 1 with the first point at 0. Among them are those that attain the supremum
    /// of a functional: its constraints are totally unimodular (THEOREMS.md, 21).
    pub fn heights(&self) -> Vec<Vec<i64>> {
        let mut found = vec![vec![(0_usize, 0_i64)]];
        for _ in 1..self.names.len() {
            let known: Vec<usize> = found[0].iter().map(|(point, _)| *point).collect();
            let ends = self.edges.iter().flat_map(|&(a, b)| [(a, b), (b, a)]);
            let mut next = ends.filter(|(a, b)| known.contains(a) && !known.contains(b));
            let (_, point) = next.next().expect("a connected ring");
            let neighbours: Vec<usize> = self
                .edges
                .iter()
                .flat_map(|&(a, b)| [(a, b), (b, a)])
                .filter(|(a, b)| *a == point && known.contains(b))
                .map(|(_, b)| b)
                .collect();
            let longer = found.iter().flat_map(|heights| {
                let height = |b: usize| heights.iter().find(|(p, _)| *p == b).expect("known").1;
                let near: Vec<i64> = neighbours.iter().map(|b| height(*b)).collect();
                let fits = move |x: &i64| near.iter().all(|y| (x - y).abs() <= 1);
                let first = height(neighbours[0]);
                let values = (first - 1..=first + 1).filter(fits);
                values.map(|x| [&heights[..], &[(point, x)]].concat()).collect::<Vec<_>>()
            });
            found = longer.collect();
        }
        for heights in &mut found {
            heights.sort_unstable();
        }
        found.into_iter().map(|heights| heights.into_iter().map(|(_, x)| x).collect()).collect()
    }

    /// The greatest value of functionals for these heights.
    pub fn greatest(rows: &[Vec<Q>], heights: &[Vec<i64>]) -> Q {
        let values =
            rows.iter().flat_map(|row| heights.iter().map(|x| LocalRules::of(row, x).abs()));
        values.max().unwrap_or_default()
    }

    pub fn less(left: &[Q], right: &[Q]) -> Vec<Q> {
        left.iter().zip(right).map(|(a, b)| a - b).collect()
    }

    /// The differences along the edges at a level.
    pub fn differences(&self, level: u32) -> Vec<Vec<Q>> {
        let rows = self.rows(level);
        self.edges.iter().map(|(a, b)| LocalRules::less(&rows[*a], &rows[*b])).collect()
    }

    /// What each point of the next level is away from what `earlier` makes of this level, or from the
    /// point of the same name.
    pub fn steps(&self, level: u32, earlier: Option<&LocalRules>) -> Vec<Vec<Q>> {
        let rows = self.rows(level);
        let product = |weights: &Vec<Q>, j: usize| -> Q {
            weights.iter().zip(&rows).map(|(weight, row)| weight * &row[j]).sum()
        };
        let old: Vec<Vec<Q>> = match earlier {
            None => rows.clone(),
            Some(earlier) => {
                let row = |weights| (0..rows.len()).map(|j| product(weights, j)).collect();
                earlier.weights.iter().map(row).collect()
            }
        };
        let new = self.times(&rows);
        new.iter().zip(&old).map(|(new, old)| LocalRules::less(new, old)).collect()
    }

    /// A bound of the distance of the points of a level to the limit, for the spread 1, as for curves.
    pub fn remainder(&self, level: u32, heights: &[Vec<i64>]) -> Option<Q> {
        let most = 6;
        let known: Vec<Q> =
            (0..=most).map(|c| LocalRules::greatest(&self.differences(c), heights)).collect();
        let c = (1..=most).find(|c| known[*c as usize] < Q::one())?;
        let upper = |level: u32| {
            let blocks = if level > most { (level - most).div_ceil(c) } else { 0 };
            let power = num_traits::pow(known[c as usize].clone(), blocks as usize);
            &known[(level - blocks * c) as usize] * power
        };
        let sum: Q = (level..level + c).map(upper).sum();
        let step = LocalRules::greatest(&self.steps(0, None), heights);
        Some(step * sum / (Q::one() - &known[c as usize]))
    }

    pub fn is_affine(&self) -> bool {
        self.weights.iter().all(|row| (row.iter().sum::<Q>() - Q::one()).is_zero())
    }
}
