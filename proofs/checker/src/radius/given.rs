//! The matrices that a certificate is about.

use super::matrices::Matrix;
use super::number::Number;
use super::read::{Certificate, Coordinates};
use crate::decimal::int;
use crate::reject::{RadiusReason, RadiusRejection};

/// The most rows of a matrix, and the most matrices.
const MAX_SIZE: usize = 64;

impl Certificate {
    fn number<N: Number>(&self, coordinates: &Coordinates) -> N {
        N::of(coordinates, self.field.as_ref())
    }

    /// The coefficients a_0, a_1, … of the symbol of the mask, from the lowest power.
    pub fn symbol<N: Number>(&self) -> Vec<N> {
        let width = self.rules.first().map_or(0, |(_, rule)| rule.len());
        let places = (0..width).rev().flat_map(|j| self.rules.iter().map(move |rule| (j, rule)));
        places.map(|(j, (_, rule))| self.number(&rule[j])).collect()
    }

    fn given_matrices<N: Number>(&self) -> Result<Vec<Matrix<N>>, RadiusRejection> {
        if let Some((line, _)) = self.rules.first() {
            let reason = RadiusReason::Malformed("the order of the sum rules, after the rules");
            return Err(RadiusRejection { line: *line, reason });
        }
        let size = self.given.first().map_or(0, |(_, matrix)| matrix.len());
        let square = |matrix: &Vec<Vec<Coordinates>>| {
            matrix.len() == size && matrix.iter().all(|row| row.len() == size)
        };
        let wrong = self.given.iter().find(|(_, matrix)| !square(matrix));
        let beyond = size == 0 || size > MAX_SIZE || self.given.len() > MAX_SIZE;
        let reason = RadiusReason::Size;
        if let Some((line, _)) = wrong {
            return Err(RadiusRejection { line: *line, reason });
        }
        if beyond {
            return Err(RadiusRejection { line: self.end, reason });
        }
        let row = |row: &Vec<Coordinates>| row.iter().map(|x| self.number(x)).collect();
        let matrices = self.given.iter().map(|(_, matrix)| matrix.iter().map(row).collect());
        Ok(matrices.collect())
    }

    /// The matrices that the certificate is about.
    pub fn matrices<N: Number>(&self) -> Result<Vec<Matrix<N>>, RadiusRejection> {
        let Some((line, order)) = self.order else { return self.given_matrices() };
        if let Some((line, _)) = self.given.first() {
            let reason = RadiusReason::Malformed("rules of a mask or matrices, but not both");
            return Err(RadiusRejection { line: *line, reason });
        }
        let n = self.rules.len();
        let width = self.rules.first().map_or(0, |(_, rule)| rule.len());
        for (line, rule) in &self.rules {
            let sum = rule.iter().fold(N::whole(0), |sum, x| sum.plus(&self.number(x)));
            if rule.len() != width || sum.minus(&N::whole(1)).sign() != 0 {
                return Err(RadiusRejection { line: *line, reason: RadiusReason::Rule });
            }
        }
        if !(2..=MAX_SIZE).contains(&n) || width * n > 4 * MAX_SIZE || order > width * n {
            return Err(RadiusRejection { line, reason: RadiusReason::Size });
        }
        let mut rest = self.symbol();
        for _ in 0..order {
            rest = over_sigma(rest, n)
                .ok_or(RadiusRejection { line, reason: RadiusReason::SumRules })?;
        }
        // With a smaller order the radius of the differences is 1 or more, whatever the limits are.
        if over_sigma(rest.clone(), n).is_some() {
            return Err(RadiusRejection { line, reason: RadiusReason::NotGreatest });
        }
        Ok(windows(&rest, n))
    }
}

/// n·p/σ, σ(z) = 1 + z + … + z^{n−1}, if σ divides p.
fn over_sigma<N: Number>(mut rest: Vec<N>, n: usize) -> Option<Vec<N>> {
    let factor = int(i64::try_from(n).ok()?);
    let count = (rest.len() + 1).checked_sub(n)?;
    let mut quotient = Vec::with_capacity(count);
    for i in 0..count {
        let c = rest[i].clone();
        for x in &mut rest[i..i + n] {
            *x = x.minus(&c);
        }
        quotient.push(c.scaled(&factor));
    }
    rest.iter().all(|x| x.sign() == 0).then_some(quotient)
}

/// The matrices of a scheme with this symbol and n rules on windows: b_{L−n+1+e+i−nj}.
fn windows<N: Number>(symbol: &[N], n: usize) -> Vec<Matrix<N>> {
    let start = symbol.iter().position(|b| b.sign() != 0).unwrap_or(0);
    let last = symbol.iter().rposition(|b| b.sign() != 0).unwrap_or(0);
    let b = &symbol[start..=last];
    let degree = b.len() - 1;
    let width = if degree == 0 { 1 } else { (degree - 1).div_ceil(n - 1) + 1 };
    let entry = |e: usize, i: usize, j: usize| {
        let place = (degree + 1 + e + i).checked_sub(n * (j + 1));
        place.and_then(|place| b.get(place)).cloned().unwrap_or_else(|| N::whole(0))
    };
    let row = |e, i| (0..width).map(|j| entry(e, i, j)).collect();
    (0..n).map(|e| (0..width).map(|i| row(e, i)).collect()).collect()
}
