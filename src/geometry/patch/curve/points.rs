//! Refined points of a control polygon in f64, with a bound of their errors.

use crate::exact::Rational;
use crate::float::nearest;
use crate::limit::Functional;
use crate::scheme::Rules;
use std::collections::HashMap;

/// A unit of rounding, with room for sums of up to 2^8 terms and rounded coefficients.
const UNIT: f64 = 600.0 * f64::EPSILON;

/// The number of a point that is known.
pub(super) type Number = usize;

/// A linear combination: indices from the first on, and coefficients.
#[derive(Clone, Debug)]
struct Row {
    first: i64,
    coefficients: Vec<f64>,
}

/// The points x^k_i of all levels k. An open polygon is continued by lines beyond both ends.
pub(super) struct RefinedPoints {
    pub(super) dimensions: usize,
    /// How many control points there are.
    pub(super) count: i64,
    pub(super) closed: bool,
    arity: i64,
    rules: Vec<Row>,
    limit: Row,
    control: Vec<f64>,
    known: HashMap<(u32, i64), Number>,
    limits: HashMap<(u32, i64), Number>,
    values: Vec<f64>,
    /// A bound of the norms of all powers of the scheme.
    growth: f64,
    /// For each level a bound of the rounding of one step to it, and last the same of steps to limits.
    rounding: Vec<f64>,
    limit_rounding: f64,
    /// A bound of the error of any point that is known, in any coordinate.
    greatest: f64,
}

impl RefinedPoints {
    /// `control` has the control points one after the other, `at_zero` is the value of the limit at 0, and no power of the
    /// scheme has a norm above `growth`.
    pub(super) fn new(
        rules: &Rules<Rational>,
        at_zero: &Functional,
        control: Vec<f64>,
        dimensions: usize,
        closed: bool,
        growth: f64,
    ) -> RefinedPoints {
        let row = |coefficients: &Vec<Rational>| Row {
            first: rules.offset(),
            coefficients: coefficients.iter().map(nearest).collect(),
        };
        let first = at_zero.terms().map(|(p, _)| p).min().unwrap_or(0);
        let last = at_zero.terms().map(|(p, _)| p).max().unwrap_or(0);
        let mut coefficients =
            vec![Rational::zero(); usize::try_from(last - first + 1).unwrap_or(1)];
        for (p, weight) in at_zero.terms() {
            coefficients[usize::try_from(p - first).unwrap_or(0)] = weight.clone();
        }
        RefinedPoints {
            dimensions,
            count: i64::try_from(control.len() / dimensions).unwrap_or(i64::MAX),
            closed,
            arity: i64::try_from(rules.arity()).unwrap_or(i64::MAX),
            rules: rules.rows().iter().map(row).collect(),
            limit: Row { first, coefficients: coefficients.iter().map(nearest).collect() },
            control,
            known: HashMap::new(),
            limits: HashMap::new(),
            values: Vec::new(),
            growth,
            rounding: Vec::new(),
            limit_rounding: 0.0,
            greatest: 0.0,
        }
    }

    pub(super) fn point(&self, number: Number) -> &[f64] {
        &self.values[number * self.dimensions..(number + 1) * self.dimensions]
    }

    /// How far any point that is known may be from its true place, in the Euclidean norm.
    pub(super) fn slack(&self) -> f64 {
        let dimensions = f64::from(u32::try_from(self.dimensions).unwrap_or(u32::MAX));
        self.greatest * dimensions.sqrt()
    }

    /// Forgets all points, and not how far any may be off.
    pub(super) fn forget(&mut self) {
        self.known.clear();
        self.limits.clear();
        self.values.clear();
    }

    /// How many points are known.
    pub(super) fn len(&self) -> usize {
        self.values.len() / self.dimensions
    }

    /// i, or for a closed polygon its remainder by the number of points of the level.
    pub(super) fn wrapped(&self, level: u32, i: i64) -> i64 {
        if self.closed { i.rem_euclid(self.count * self.arity.pow(level)) } else { i }
    }

    /// x^k_i.
    pub(super) fn at(&mut self, level: u32, i: i64) -> Number {
        let i = self.wrapped(level, i);
        if let Some(&number) = self.known.get(&(level, i)) {
            return number;
        }
        let number = if level == 0 {
            self.control_point(i)
        } else {
            let alpha = usize::try_from(i.rem_euclid(self.arity)).unwrap_or(0);
            let row = self.rules[alpha].clone();
            let (point, rounding) = self.combined(level - 1, i.div_euclid(self.arity), &row);
            self.rounded(level, rounding);
            self.push(point)
        };
        self.known.insert((level, i), number);
        number
    }

    /// The value of the limit at i/n^k.
    pub(super) fn limit(&mut self, level: u32, i: i64) -> Number {
        let i = self.wrapped(level, i);
        if let Some(&number) = self.limits.get(&(level, i)) {
            return number;
        }
        let row = self.limit.clone();
        let (point, rounding) = self.combined(level, i, &row);
        if rounding > self.limit_rounding {
            self.limit_rounding = rounding;
            self.add_up();
        }
        let number = self.push(point);
        self.limits.insert((level, i), number);
        number
    }

    /// Σ_j c_j x^k_{i + first + j}, and a bound of its rounding.
    fn combined(&mut self, level: u32, i: i64, row: &Row) -> (Vec<f64>, f64) {
        let mut sum = vec![0.0; self.dimensions];
        let mut sizes = vec![0.0; self.dimensions];
        for (index, &coefficient) in (i + row.first..).zip(&row.coefficients) {
            if coefficient == 0.0 {
                continue;
            }
            let number = self.at(level, index);
            for (j, &x) in self.point(number).iter().enumerate() {
                sum[j] += coefficient * x;
                sizes[j] += (coefficient * x).abs();
            }
        }
        let size = sizes.into_iter().fold(0.0, f64::max);
        (sum, size * UNIT)
    }

    /// Takes in the rounding of one point of a level.
    fn rounded(&mut self, level: u32, rounding: f64) {
        let level = level as usize;
        if self.rounding.len() <= level {
            self.rounding.resize(level + 1, 0.0);
        }
        if rounding > self.rounding[level] {
            self.rounding[level] = rounding;
            self.add_up();
        }
    }

    /// The greatest error: that of a level is the sum of the roundings of all levels before, each refined since.
    fn add_up(&mut self) {
        let points = self.growth * self.rounding.iter().sum::<f64>();
        let weight: f64 = self.limit.coefficients.iter().map(|x| x.abs()).sum();
        self.greatest = points.max(weight * points + self.limit_rounding) * (1.0 + UNIT);
    }

    fn control_point(&mut self, i: i64) -> Number {
        let last = self.count - 1;
        let at =
            |i: i64, j: usize| self.control[usize::try_from(i).unwrap_or(0) * self.dimensions + j];
        let coordinate = |j: usize| {
            let line = |from: i64, next: i64, steps: i64| {
                #[expect(clippy::cast_precision_loss, reason = "a few steps beyond the ends")]
                let steps = steps as f64;
                at(from, j) + steps * (at(from, j) - at(next, j))
            };
            match i {
                _ if last == 0 => at(0, j),
                _ if i < 0 => line(0, 1, -i),
                _ if i > last => line(last, last - 1, i - last),
                _ => at(i, j),
            }
        };
        let point: Vec<f64> = (0..self.dimensions).map(coordinate).collect();
        // Of a point beyond the ends nothing depends but the size of bounds.
        let size = point.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        self.rounded(0, size * f64::EPSILON);
        self.push(point)
    }

    fn push(&mut self, point: Vec<f64>) -> Number {
        self.values.extend(point);
        self.len() - 1
    }
}
