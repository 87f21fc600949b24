//! Functions of masks whose coefficients lie in no field of cosines. Bounds of their sizes tell which numbers are 0.

#![warn(clippy::arithmetic_side_effects)]

use super::evaluate::Reals;
use super::known::{Digits, Known, is_zero};
use crate::formulas::{Asked, MAX_INTEGER, formula, formulas};
use crate::functions::call::{index, wrong};
use crate::numbers::{Q, Value};
use crate::schemes::{MAX_OFFSET, ROOTS, is_lattice};
use crate::text::Stop;

/// The most coefficients.
const MAX_COEFFICIENTS: usize = 64;

/// The greatest m of a moment.
const MAX_MOMENT: i64 = 64;

/// The coefficients a_l, …, a_K of a mask; neither a_l nor a_K is 0.
struct Mask<'m> {
    digits: Digits<'m>,
    arity: usize,
    first: i64,
    values: Vec<Known>,
}

const PLACE: Stop = Stop::Capped("the places of the coefficients of a mask");

fn signed(place: usize) -> Result<i64, Stop> {
    i64::try_from(place).map_err(|_| PLACE)
}

/// The value of such a function of a mask with such roots; `None` if it is none of them.
pub fn of(
    reals: &Reals<'_>,
    (function, arguments, options): Asked<'_>,
) -> Result<Option<Known>, Stop> {
    let [(word, name), others @ ..] = options else { return Ok(None) };
    let other = match others {
        [] => None,
        [(word, other)] if word == "with" => Some(other),
        _ => return Ok(None),
    };
    let has_roots = |name: &str| {
        let found = reals.library.resolve_any(name, reals.scope);
        matches!(found, Err(stop) if stop == ROOTS)
    };
    if word != "scheme" || !(has_roots(name) || other.is_some_and(|other| has_roots(other))) {
        return Ok(None);
    }
    let one = Mask::read(reals, name)?;
    let digits = one.digits;
    let truth = |is: bool| digits.integer(is.into());
    Ok(Some(match (function, arguments, other) {
        ("arity", [], None) => digits.integer(signed(one.arity)?)?,
        ("coefficient", [k], None) => match one.at(k.integer(MAX_INTEGER)?) {
            Some(a) => a.clone(),
            None => digits.integer(0)?,
        },
        ("symbol_at", [z], None) => one.symbol_at(z)?,
        ("support_start", [], None) => one.part(one.first)?,
        ("support_end", [], None) => one.part(one.last()?)?,
        ("support", [], None) => one.part(one.last()?.saturating_sub(one.first))?,
        ("symmetric", [], None) => truth(one.is_symmetric()?)?,
        ("interpolating", [], None) => truth(one.is_interpolating()?)?,
        ("sum_rules", [], None) => digits.integer(one.sum_rules()?)?,
        ("generation", [], None) => digits.integer(one.sum_rules()?.saturating_sub(1))?,
        ("vanishing_moments", [], None) => digits.integer(one.vanishing_moments()?)?,
        ("moment", [m], None) => one.moment(index(m, 0, MAX_MOMENT)?)?,
        ("orthogonal", [], None) => truth(one.is_dual_to(&one)?)?,
        ("biorthogonal", [], Some(other)) => truth(one.is_dual_to(&Mask::read(reals, other)?)?)?,
        ("same", [], Some(other)) => truth(one.is(&Mask::read(reals, other)?)?)?,
        _ => return Ok(None),
    }))
}

impl<'m> Mask<'m> {
    /// That of a scheme that is given entry by entry.
    fn read(reals: &Reals<'m>, name: &str) -> Result<Mask<'m>, Stop> {
        let library = reals.library;
        let (name, table, parameters) = library.entry(name, reals.scope)?;
        let rows = table.list("mask");
        if rows.is_empty() || table.is_set("filter") || is_lattice(table) {
            return Err(ROOTS);
        }
        let definitions = formulas(table.entries("let"))?;
        let mut scope = library.scope(&definitions);
        scope.values = library.complete(name, table, parameters)?;
        let offset = match table.text("offset") {
            Some(text) => scope.value(&formula(text)?)?.integer(MAX_OFFSET)?,
            None => 0,
        };
        let digits = reals.digits();
        let inner = Reals::new(library, &scope, digits.bits, of);
        let own = format!("{name} {:?}", scope.values);
        let mut rules: Vec<Vec<Known>> = Vec::new();
        for row in rows {
            let entries = row.as_list().iter();
            let entry = |text: &str| inner.value(&formula(text)?);
            let rule = entries.map(|text| entry(text.as_text().unwrap_or("")));
            let rule = rule.collect::<Result<Vec<Known>, Stop>>()?;
            let sum = rule.iter().try_fold(digits.integer(-1)?, |sum, a| digits.sum(&sum, 1, a))?;
            if !is_zero(&sum)? {
                return wrong("a rule does not sum to 1");
            }
            // What formulas make of the entries names them shortly.
            let place = rules.len();
            let named = |(j, a): (usize, Known)| a.named(format!("@{own}[{place},{j}]"));
            rules.push(rule.into_iter().enumerate().map(named).collect());
        }
        let (arity, width) = (rules.len(), rules.first().map_or(0, Vec::len));
        if arity < 2 || width < 1 || rules.iter().any(|rule| rule.len() != width) {
            return wrong("the number or the lengths of the rules of a mask are wrong");
        }
        if arity.saturating_mul(width) > MAX_COEFFICIENTS {
            return Err(ROOTS);
        }
        let columns = (0..width).rev();
        let all = columns.flat_map(|j| rules.iter().filter_map(move |rule| rule.get(j)));
        let mut values: Vec<Known> = all.cloned().collect();
        let last = offset.saturating_add(signed(width)?).saturating_sub(1);
        let mut first = last.saturating_mul(signed(arity)?).saturating_neg();
        while values.last().map_or(Ok(false), is_zero)? {
            values.pop();
        }
        while values.first().map_or(Ok(false), is_zero)? {
            values.remove(0);
            first = first.saturating_add(1);
        }
        Ok(Mask { digits, arity, first, values })
    }

    /// K.
    fn last(&self) -> Result<i64, Stop> {
        Ok(self.first.saturating_add(signed(self.values.len())?).saturating_sub(1))
    }

    /// a_k, if it is not beyond l and K.
    fn at(&self, k: i64) -> Option<&Known> {
        self.values.get(usize::try_from(k.checked_sub(self.first)?).ok()?)
    }

    /// The coefficients with their places.
    fn terms(&self) -> impl Iterator<Item = (i64, &Known)> {
        (self.first..).zip(&self.values)
    }

    fn rational(&self, value: Q) -> Result<Known, Stop> {
        self.digits.exact(&value.into())
    }

    /// A place over n − 1.
    fn part(&self, place: i64) -> Result<Known, Stop> {
        let below = signed(self.arity)?.saturating_sub(1).max(1);
        self.rational(Q::new(place.into(), below.into()))
    }

    /// The sum of multiples of numbers.
    fn combined<'k>(&self, terms: impl Iterator<Item = (&'k Known, Q)>) -> Result<Known, Stop> {
        let mut sum = self.digits.integer(0)?;
        for (a, factor) in terms {
            let term = self.digits.product(a, &self.rational(factor)?)?;
            sum = self.digits.sum(&sum, 1, &term)?;
        }
        Ok(sum)
    }

    /// a(z).
    fn symbol_at(&self, z: &Value) -> Result<Known, Stop> {
        let mut sum = self.digits.integer(0)?;
        for (k, a) in self.terms() {
            let power = z.power(k)?;
            let power = self.digits.exact(power.number()?)?;
            sum = self.digits.sum(&sum, 1, &self.digits.product(a, &power)?)?;
        }
        Ok(sum)
    }

    fn equal(&self, one: &Known, other: &Known) -> Result<bool, Stop> {
        Ok(one.is_made_as(other) || is_zero(&self.digits.sum(one, -1, other)?)?)
    }

    fn is_symmetric(&self) -> Result<bool, Stop> {
        for (a, b) in self.values.iter().zip(self.values.iter().rev()) {
            if !self.equal(a, b)? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Whether both are of one arity and have the same coefficients.
    fn is(&self, other: &Mask<'_>) -> Result<bool, Stop> {
        let places = |mask: &Mask<'_>| (mask.arity, mask.first, mask.values.len());
        if places(self) != places(other) {
            return Ok(false);
        }
        for (a, b) in self.values.iter().zip(&other.values) {
            if !self.equal(a, b)? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Whether a rule has an entry 1 and no other that is not 0.
    fn is_interpolating(&self) -> Result<bool, Stop> {
        for class in 0..signed(self.arity)? {
            let mut others = Vec::new();
            for (_, a) in self.of_class(class)? {
                if !is_zero(a)? {
                    others.push(a);
                }
            }
            if let [only] = others[..]
                && self.equal(only, &self.digits.integer(1)?)?
            {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// The coefficients of a rule, with their places.
    fn of_class(&self, class: i64) -> Result<Vec<(i64, &Known)>, Stop> {
        let n = signed(self.arity)?;
        let is = |(k, _): &(i64, &Known)| k.checked_rem_euclid(n) == Some(class);
        Ok(self.terms().filter(is).collect())
    }

    /// How often 1 + z + … + z^{n−1} divides a(z): m times if for all e < m the sums of (k − l)^e a_k over the classes of k mod n are equal.
    fn sum_rules(&self) -> Result<i64, Stop> {
        for e in 0..signed(self.values.len())? {
            let mut first: Option<Known> = None;
            for class in 0..signed(self.arity)? {
                let sum = self.power_sum(self.of_class(class)?, e)?;
                match &first {
                    Some(first) if !self.equal(first, &sum)? => return Ok(e),
                    Some(_) => {}
                    None => first = Some(sum),
                }
            }
        }
        wrong("the symbol is 0")
    }

    /// How often 1 − z divides a(z): p times if the sums of (k − l)^e a_k are 0 for e < p.
    fn vanishing_moments(&self) -> Result<i64, Stop> {
        for e in 0..signed(self.values.len())? {
            if !is_zero(&self.power_sum(self.terms().collect(), e)?)? {
                return Ok(e);
            }
        }
        wrong("the symbol is 0")
    }

    /// Σ (k − l)^e a_k over some k.
    fn power_sum(&self, terms: Vec<(i64, &Known)>, e: i64) -> Result<Known, Stop> {
        self.combined(terms.into_iter().map(|(k, a)| (a, power(k.saturating_sub(self.first), e))))
    }

    /// M_m by M_0 = 1 and n^{m+1}M_m = Σ_k a_k Σ_{i≤m} binomial(m, i) k^{m−i} M_i, where Σ_k a_k = n.
    fn moment(&self, m: usize) -> Result<Known, Stop> {
        let n = signed(self.arity)?;
        let mut moments = vec![self.digits.integer(1)?];
        for of in 1..=signed(m)? {
            let (mut sum, mut binomial) = (self.digits.integer(0)?, Q::from_integer(1.into()));
            for (i, moment) in (0_i64..).zip(&moments) {
                let e = of.saturating_sub(i);
                let terms = self.terms().map(|(k, a)| (a, power(k, e) * &binomial));
                let term = self.digits.product(&self.combined(terms)?, moment)?;
                sum = self.digits.sum(&sum, 1, &term)?;
                binomial *= Q::new(e.into(), i.saturating_add(1).into());
            }
            let least = power(n, of.saturating_add(1)) - power(n, 1);
            moments.push(self.digits.product(&sum, &self.rational(least.recip())?)?);
        }
        moments.pop().ok_or(PLACE)
    }

    /// Whether Σ_k a_k b_{k+nm} is n for m = 0, and 0 for all other m.
    fn is_dual_to(&self, other: &Mask<'_>) -> Result<bool, Stop> {
        if self.arity != other.arity {
            return wrong("the two masks are of two arities");
        }
        let n = signed(self.arity)?;
        let least = other.first.saturating_sub(self.last()?).checked_div_euclid(n).unwrap_or(0);
        let most = other.last()?.saturating_sub(self.first).checked_div_euclid(n).unwrap_or(0);
        if least > 0 || most < 0 {
            return Ok(false);
        }
        for m in least..=most {
            let mut sum = self.digits.integer(if m == 0 { n.saturating_neg() } else { 0 })?;
            for (k, a) in self.terms() {
                if let Some(b) = other.at(k.saturating_add(n.saturating_mul(m))) {
                    sum = self.digits.sum(&sum, 1, &self.digits.product(a, b)?)?;
                }
            }
            if !is_zero(&sum)? {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

/// k^e.
fn power(k: i64, e: i64) -> Q {
    let power = num_bigint::BigInt::from(k).pow(u32::try_from(e).unwrap_or(0));
    Q::from_integer(power)
}
