//! Judging relations for all real values of an index.
//!
//! The line is cut into open intervals and the points between them. A rational number of an interval stands for all of it if no
//! polynomial has a root there whose sign was asked for: then all formulas take the same course at all numbers of the interval. If
//! one has, the interval is cut at its roots. `proofs/THEOREMS.md`, 140.

mod bounds;

use crate::cap::Cap;
use crate::claim::{Comparison, Identity, Index, LocatedReference, Paper, Sign};
use crate::diagnostic::Diagnostic;
use crate::evaluation::library::Library;
use crate::evaluation::masks::{End, MAX_CLASSES};
use crate::evaluation::reals::Used;
use crate::evaluation::shape::{Coefficients, Own, Shapes, own_shape};
use crate::exact::{
    IntegerPolynomial, Interval, IntervalSet, Place, QuotientAt, Rational, RealAlgebraic,
    Scalar as _,
};
use crate::finding::{Counterexample, EquationVerdict, OnReals, RealCase, SideValue};
use crate::formula::{FormulaErrorKind, Functions, LocatedFormula, Scope, evaluate};
use crate::judge::cases::{Case, Unbounded, beyond, cases};
use crate::judge::comparison::Sides;
use crate::judge::relation::{self, states_nothing};
use bounds::{Bounded, decided, has_bounds, is_bounded};
use std::cell::Cell;
use std::collections::BTreeMap;
use std::ops::Bound;
use std::rc::Rc;

/// The most intervals into which the line is cut.
const MAX_CUTS: usize = 1_000;

/// Judges a relation with an index of real numbers, or one that is claimed for no other number.
pub(super) fn judge(
    paper: &Paper,
    identity: &Identity,
    (library, used): (&Library<'_>, &Used),
    given: &BTreeMap<String, Rational>,
) -> Result<EquationVerdict, Diagnostic> {
    let (place, name, stated) = match (identity.real_index(), &identity.indices[..]) {
        (Some((place, name, stated)), _) => (place, name, stated.clone()),
        (None, [Index::Listed { name, values, .. }]) => {
            let points =
                values.iter().map(|(value, _)| IntervalSet::from(point(value.clone().into())));
            (0, name.as_str(), points.fold(IntervalSet::default(), |all, one| all.union(&one)))
        }
        (None, _) => (0, "", IntervalSet::default()),
    };
    let others = match identity.real_index() {
        Some(_) => cases(identity, Unbounded::Tried)?,
        None => vec![Case::first()],
    };
    let found = others.into_iter().map(|case| {
        let roots = BTreeMap::new();
        let line = Line { paper, identity, library, used, given, name, case: &case, roots };
        let (truth, counterexample) = line.judged(&stated)?;
        let indices = case.values.iter().map(|(_, value)| value.clone()).collect();
        Ok(RealCase { at: case.text.clone(), indices, truth, counterexample })
    });
    let cases = found.collect::<Result<Vec<RealCase>, Diagnostic>>()?;
    Ok(EquationVerdict::Reals(OnReals { name: name.to_owned(), place, cases }))
}

fn point(at: RealAlgebraic) -> Interval {
    Interval { low: Bound::Included(at.clone()), high: Bound::Included(at) }
}

/// The truth of each comparison at a place, `None` where bounds do not decide it, and the polynomials on whose signs it rests.
type Truths = (Vec<Option<bool>>, Vec<IntegerPolynomial>);

/// The line of the values of the index, in one combination of the others.
struct Line<'a> {
    paper: &'a Paper,
    identity: &'a Identity,
    library: &'a Library<'a>,
    /// The limits that the truths rest on.
    used: &'a Used,
    given: &'a BTreeMap<String, Rational>,
    name: &'a str,
    case: &'a Case,
    /// The roots of the polynomials whose signs were asked for.
    roots: BTreeMap<String, Vec<RealAlgebraic>>,
}

impl Line<'_> {
    /// Where the relation is true, and a number that shows that the claim is false.
    fn judged(
        mut self,
        stated: &IntervalSet,
    ) -> Result<(Option<IntervalSet>, Option<Counterexample>), Diagnostic> {
        let everywhere = self.identity.only;
        let mut points: Vec<RealAlgebraic> = stated.ends().map(|(end, _)| end.clone()).collect();
        points.sort();
        points.dedup();
        let within = |set: &Interval| everywhere || stated.covers(set);
        // Open intervals by their ends, of which the first is taken next.
        let ends = |at: usize| points.get(at).cloned();
        let mut rest: Vec<[Option<RealAlgebraic>; 2]> =
            (0..=points.len()).rev().map(|i| [i.checked_sub(1).and_then(ends), ends(i)]).collect();
        let (mut cuts, mut cells, mut undecided) = (points.clone(), Vec::new(), None);
        while let Some(cell) = rest.pop() {
            let open = interval(&cell);
            let Some(at) = open.rational().filter(|_| within(&open)) else {
                cells.push((cell, Vec::new()));
                continue;
            };
            let (truths, asked) = self.truths(at.into(), false)?;
            let inside = self.roots_in(&asked, &cell);
            if inside.is_empty() {
                match self.all_decided(&truths) {
                    Ok(truths) => cells.push((cell, truths)),
                    Err(error) => {
                        // One number may show already that the claim is false.
                        if let Some(found) = self.refutes(&open, stated.covers(&open)) {
                            return Ok((None, Some(found)));
                        }
                        undecided = Some(error);
                        cells.push((cell, Vec::new()));
                    }
                }
                continue;
            }
            if cuts.len() + inside.len() > MAX_CUTS {
                let cap = Cap::new("the number of intervals of a parameter", MAX_CUTS as u64);
                return Err(beyond(self.identity.first().right(), cap));
            }
            let [low, high] = cell;
            let all = [low].into_iter().chain(inside.iter().cloned().map(Some)).chain([high]);
            let all: Vec<Option<RealAlgebraic>> = all.collect();
            rest.extend(all.windows(2).rev().map(|pair| [pair[0].clone(), pair[1].clone()]));
            cuts.extend(inside);
        }
        cuts.sort();
        let mut found = Vec::with_capacity(2 * cuts.len() + 1);
        for (i, (cell, truths)) in cells.into_iter().enumerate() {
            found.push((interval(&cell), truths));
            if let Some(cut) = cuts.get(i) {
                let alone = point(cut.clone());
                let mut truths = Vec::new();
                if within(&alone) {
                    match self.all_decided(&self.truths(cut.clone(), true)?.0) {
                        Ok(found) => truths = found,
                        Err(error) => undecided = Some(error),
                    }
                }
                found.push((alone, truths));
            }
        }
        let holds = |truths: &[bool]| !truths.is_empty() && truths.iter().all(|truth| *truth);
        let keep: Vec<bool> = found.iter().map(|(_, truths)| holds(truths)).collect();
        let truth = IntervalSet::of_cells(&cuts, &keep);
        let counterexample = found.iter().find_map(|(set, truths)| {
            let fails = truths.iter().position(|truth| !truth);
            (!truths.is_empty() && stated.covers(set) != holds(truths))
                .then(|| Counterexample { value: number_in(set), fails })
        });
        match (undecided, counterexample) {
            (None, counterexample) => Ok((Some(truth), counterexample)),
            (Some(_), Some(counterexample)) => Ok((None, Some(counterexample))),
            (Some(error), None) => Err(error),
        }
    }

    /// The truths, if all are known.
    fn all_decided(&self, truths: &[Option<bool>]) -> Result<Vec<bool>, Diagnostic> {
        let known = self.identity.comparisons.iter().zip(truths);
        known
            .map(|(comparison, truth)| {
                let what = "the smoothness of limits is not decided for all values of a parameter: the number of residue classes";
                truth.ok_or_else(|| beyond(comparison.right(), Cap::new(what, MAX_CLASSES as u64)))
            })
            .collect()
    }

    /// The roots of polynomials in an open interval, each once.
    fn roots_in(
        &mut self,
        polynomials: &[IntegerPolynomial],
        [low, high]: &[Option<RealAlgebraic>; 2],
    ) -> Vec<RealAlgebraic> {
        let mut inside = Vec::new();
        for polynomial in polynomials {
            let known = self.roots.entry(polynomial.to_string());
            let roots = known.or_insert_with(|| RealAlgebraic::roots_of(polynomial));
            let apart = |root: &&RealAlgebraic| {
                low.as_ref().is_none_or(|low| low < *root)
                    && high.as_ref().is_none_or(|high| *root < high)
            };
            inside.extend(roots.iter().filter(apart).cloned());
        }
        inside.sort();
        inside.dedup();
        inside
    }

    /// The truth of each comparison at a number. If it does not stand `alone`, it stands for an interval.
    fn truths(&self, at: RealAlgebraic, alone: bool) -> Result<Truths, Diagnostic> {
        let number = at.as_rational().filter(|_| alone).cloned();
        let place = Rc::new(Place::new(at));
        let shapes = Shapes::with_filters(self.library);
        let none = Coefficients { shapes: &shapes, own: None };
        let own = match &self.identity.scheme {
            None => None,
            Some(located) => Some(self.own(&shapes, located, &none, &place)?),
        };
        let functions = Coefficients { shapes: &shapes, own };
        let value = |formula: &LocatedFormula, functions: &dyn Functions<QuotientAt>| {
            let scope = self.scope(functions, &place);
            evaluate(&formula.expr, &scope).map_err(|error| {
                let of_number = matches!(error.kind, FormulaErrorKind::DivisionByZero);
                let error = formula.diagnostic(&error);
                if !of_number {
                    return error;
                }
                let message = format!("{} for {} = {}", error.message, self.name, place.number());
                Diagnostic { message, ..error }
            })
        };
        let exact = |formula: &LocatedFormula| value(formula, &functions);
        let end = |formula: &LocatedFormula, end: End| {
            let bounded = Bounded { coefficients: &functions, end };
            if is_bounded(formula) { value(formula, &bounded) } else { exact(formula) }
        };
        let comparisons = self.identity.comparisons.iter();
        let truths = comparisons.map(|comparison| {
            if !has_bounds(comparison) {
                return truth(comparison, exact).map(Some);
            }
            let found = decided(comparison, end)?;
            Ok(found.or_else(|| self.at_number(comparison, number.as_ref()?)))
        });
        let truths = truths.collect::<Result<Vec<Option<bool>>, Diagnostic>>()?;
        self.note(&shapes.used);
        Ok((truths, place.asked()))
    }

    /// A number of an interval that shows that the claim is false, if its first rational number does. The claim states that the interval is `inside`.
    fn refutes(&self, open: &Interval, inside: bool) -> Option<Counterexample> {
        let at = open.rational()?;
        let comparisons = self.identity.comparisons.iter();
        let truths: Vec<Option<bool>> =
            comparisons.map(|comparison| self.at_number(comparison, &at)).collect();
        let fails = truths.iter().position(|truth| *truth == Some(false));
        let refutes =
            if inside { fails.is_some() } else { truths.iter().all(|truth| *truth == Some(true)) };
        refutes.then(|| Counterexample { value: at.into(), fails })
    }

    /// The truth of a comparison at a rational number, as one of a listed index.
    fn at_number(&self, comparison: &Comparison, number: &Rational) -> Option<bool> {
        let (shapes, in_fields) =
            (Shapes::with_filters(self.library), Shapes::with_filters(self.library));
        let sides = Sides {
            paper: self.paper,
            identity: self.identity,
            shapes: &shapes,
            in_fields: &in_fields,
            given: self.given.clone(),
            spent: Cell::new(0),
        };
        let case = self.case.with(self.name, self.name, (number.clone(), &number.to_string()));
        let left = comparison.left.formula(0);
        let value = |formula: &LocatedFormula| sides.side(formula, &case).ok();
        let rights = comparison.rights.iter().map(value).collect::<Option<Vec<SideValue>>>()?;
        let truth = relation::decided(comparison, (left, &case.printed), &value(left)?, &rights);
        self.note(&shapes.used);
        truth.ok()?
    }

    /// Adds limits to those that the truths rest on, each once.
    fn note(&self, found: &Used) {
        let mut used = self.used.borrow_mut();
        for (name, limits) in found.take() {
            if used.iter().all(|(_, known)| known.mask != limits.mask) {
                used.push((name, limits));
            }
        }
    }

    fn own(
        &self,
        shapes: &Shapes<'_, QuotientAt>,
        located: &LocatedReference,
        functions: &Coefficients<'_, QuotientAt>,
        place: &Rc<Place>,
    ) -> Result<Own<QuotientAt>, Diagnostic> {
        own_shape(shapes, located, &self.scope(functions, place))
    }

    fn scope<'s>(
        &'s self,
        functions: &'s dyn Functions<QuotientAt>,
        place: &Rc<Place>,
    ) -> Scope<'s, QuotientAt> {
        let mut scope = Scope::new(&self.paper.definitions, functions);
        let others = self.case.values.iter().map(|(name, value)| (name, value));
        for (name, value) in self.given.iter().chain(others) {
            scope = scope.with(name, QuotientAt::from_rational(value));
        }
        scope.with(self.name, QuotientAt::variable(place))
    }
}

fn interval([low, high]: &[Option<RealAlgebraic>; 2]) -> Interval {
    let open = |end: &Option<RealAlgebraic>| {
        end.as_ref().map_or(Bound::Unbounded, |end| Bound::Excluded(end.clone()))
    };
    Interval { low: open(low), high: open(high) }
}

/// A number of a set, rational if there is a rational one.
fn number_in(set: &Interval) -> RealAlgebraic {
    match (set.rational(), &set.low) {
        (Some(number), _) => number.into(),
        (None, Bound::Included(only)) => only.clone(),
        (None, _) => Rational::zero().into(),
    }
}

/// Whether a comparison is true at the place of the values.
fn truth(
    comparison: &Comparison,
    value: impl Fn(&LocatedFormula) -> Result<QuotientAt, Diagnostic>,
) -> Result<bool, Diagnostic> {
    let left = value(comparison.left.formula(0))?;
    let rights = comparison.rights.iter().map(value).collect::<Result<Vec<_>, Diagnostic>>()?;
    let number = |value: i64| QuotientAt::from_rational(&Rational::from(value));
    Ok(match comparison.sign {
        Sign::True | Sign::False if ![0, 1].iter().any(|n| left == number(*n)) => {
            return Err(states_nothing(comparison.left.formula(0), &left));
        }
        Sign::OneOf => rights.contains(&left),
        sign => sign.fits(left.minus(&rights[0]).sign().cmp(&0)),
    })
}
