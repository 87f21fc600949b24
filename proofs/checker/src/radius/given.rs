//! The matrices that a certificate is about.

use super::element::Element;
use super::matrices::Matrix;
use super::read::{Certificate, Coordinates};
use crate::numbers::{Meter, count};
use crate::text::{At, RadiusChecked as Checked, RadiusReason, RadiusRejection, Stop, require};

/// The most rows of a matrix, and the most matrices.
const MAX_SIZE: usize = 64;

/// The coefficients a_0, a_1, … of the symbol of these rules: the last column comes first.
pub fn symbol(rules: &[Vec<Element>]) -> Vec<Element> {
    let width = rules.first().map_or(0, Vec::len);
    let columns = (0..width).rev();
    columns.flat_map(|j| rules.iter().map(move |rule| rule[j].clone())).collect()
}

impl Certificate {
    fn number(&self, coordinates: &Coordinates) -> Element {
        Element::of(coordinates, self.field.as_ref())
    }

    /// The symbol of the mask.
    pub fn symbol(&self) -> Vec<Element> {
        let rule = |rule: &[Coordinates]| rule.iter().map(|x| self.number(x)).collect();
        let rules: Vec<Vec<Element>> = self.rules.iter().map(|(_, of)| rule(of)).collect();
        symbol(&rules)
    }

    fn given_matrices(&self) -> Checked<Vec<Matrix>> {
        if let Some((line, _)) = self.rules.first() {
            let order = RadiusReason::Malformed("the order of the sum rules, after the rules");
            return Err(RadiusRejection { line: *line, reason: order });
        }
        let size = self.given.first().map_or(0, |(_, matrix)| matrix.len());
        for (line, matrix) in &self.given {
            let square = matrix.len() == size && matrix.iter().all(|row| row.len() == size);
            require(square, RadiusReason::Size).at(*line)?;
        }
        let sizes = 1..=MAX_SIZE;
        let fits = sizes.contains(&size) && sizes.contains(&self.given.len());
        require(fits, RadiusReason::Size).at(self.end)?;
        let row = |row: &Vec<Coordinates>| row.iter().map(|x| self.number(x)).collect();
        let matrices = self.given.iter().map(|(_, matrix)| matrix.iter().map(row).collect());
        Ok(matrices.collect())
    }

    /// The matrices that the certificate is about.
    pub fn matrices(&self, meter: &Meter) -> Checked<Vec<Matrix>> {
        let Some((line, order)) = self.order else { return self.given_matrices() };
        if let Some((line, _)) = self.given.first() {
            let both = RadiusReason::Malformed("rules of a mask or matrices, but not both");
            return Err(RadiusRejection { line: *line, reason: both });
        }
        let n = self.rules.len();
        let width = self.rules.first().map_or(0, |(_, rule)| rule.len());
        for (line, rule) in &self.rules {
            let (one, mut sum) = (Element::whole(1), Element::whole(-1));
            for x in rule {
                sum.add_product(&self.number(x), &one, meter).map_err(Into::into).at(*line)?;
            }
            let one = rule.len() == width && sum.sign() == 0;
            require(one, RadiusReason::Rule).at(*line)?;
        }
        let fits = (2..=MAX_SIZE).contains(&n) && width * n <= 4 * MAX_SIZE && order <= width * n;
        require(fits, RadiusReason::Size).at(line)?;
        let mut rest = self.symbol();
        for _ in 0..order {
            let quotient = over_sigma(rest, n, meter).map_err(Into::into).at(line)?;
            rest = quotient.ok_or(RadiusRejection { line, reason: RadiusReason::SumRules })?;
        }
        // With a smaller order the radius of the differences is 1 or more, whatever the limits are.
        let next = over_sigma(rest.clone(), n, meter).map_err(Into::into).at(line)?;
        let greatest = next.is_none();
        require(greatest, RadiusReason::NotGreatest).at(line)?;
        Ok(windows(&rest, n))
    }
}

/// n·p/σ, σ(z) = 1 + z + … + z^{n−1}, if σ divides p.
fn over_sigma(
    mut rest: Vec<Element>,
    n: usize,
    meter: &Meter,
) -> Result<Option<Vec<Element>>, Stop> {
    let (one, factor) = (Element::whole(1), Element::fraction(&count(n)));
    let Some(count) = (rest.len() + 1).checked_sub(n) else { return Ok(None) };
    let mut quotient = Vec::with_capacity(count);
    for i in 0..count {
        let c = rest[i].clone();
        let less = c.negated();
        for x in &mut rest[i..i + n] {
            x.add_product(&less, &one, meter)?;
        }
        quotient.push(c.metered_times(&factor, meter)?);
    }
    Ok(rest.iter().all(|x| x.sign() == 0).then_some(quotient))
}

/// The matrices of a scheme with this symbol and n rules on windows: b_{L−n+1+e+i−nj}.
fn windows(symbol: &[Element], n: usize) -> Vec<Matrix> {
    let start = symbol.iter().position(|b| b.sign() != 0).unwrap_or(0);
    let last = symbol.iter().rposition(|b| b.sign() != 0).unwrap_or(0);
    let b = &symbol[start..=last];
    let degree = b.len() - 1;
    let width = if degree == 0 { 1 } else { (degree - 1).div_ceil(n - 1) + 1 };
    let entry = |e: usize, i: usize, j: usize| {
        let place = (degree + 1 + e + i).checked_sub(n * (j + 1));
        place.and_then(|place| b.get(place)).cloned().unwrap_or_else(|| Element::whole(0))
    };
    let row = |e, i| (0..width).map(|j| entry(e, i, j)).collect();
    (0..n).map(|e| (0..width).map(|i| row(e, i)).collect()).collect()
}
