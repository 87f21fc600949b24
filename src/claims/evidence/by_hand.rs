//! The computation that refutes a theorem, as one checks it with paper and pencil.

use crate::claim::{Paper, Quantity, Table};
use crate::diagnostic::Diagnostic;
use crate::evaluation::context::{CellReading, Outcome};
use crate::evaluation::library::Library;
use crate::evaluation::settings::Settings;
use crate::evaluation::table::Evaluator;
use crate::exact::{Rational, Rounding};
use crate::finding::{
    ByHand, Control, HandCell, HandConstant, LeftOut, PaperAudit, Place, TheoremFinding, Violation,
};
use crate::judge::theorem::{Instance, instance};
use crate::limit::{ExtremalPolygon, Functional, Limit, LimitWeights, Points};
use crate::scheme::Mask;
use std::collections::{BTreeMap, BTreeSet};

/// The most refined points that one can compute by hand.
const MAX_POINTS: usize = 48;

/// The computation behind the data that refute a theorem with points at i/n^k; `None` if no data
/// refute it.
///
/// # Errors
/// When a formula of the claim file is wrong.
pub fn by_hand(
    audit: &PaperAudit<'_>,
    finding: &TheoremFinding<'_>,
) -> Result<Option<ByHand>, Diagnostic> {
    let Some(refutation) = &finding.refutation else { return Ok(None) };
    let violation = &refutation.violation;
    let at = (violation.level, &violation.bound);
    let found = instance(audit.paper, finding.theorem, &refutation.case, at)?;
    let Some(mut instance) = found else { return Ok(None) };
    let library = Library::new(audit.paper);
    let mut constants = std::mem::take(&mut instance.constants);
    for constant in &mut constants {
        constant.cell = printed(audit.paper, &instance, constant, &library)?;
    }
    let mut hand = ByHand {
        constants,
        bound: instance.bound,
        refiner: instance.refiner,
        interpolant: instance.interpolant,
        contraction: None,
        weights: None,
        refined: Vec::new(),
        sides: None,
        left_out: None,
    };
    match (hand.refiner.clone().masks(), &violation.attained.control) {
        ([mask], Control::Polygon(polygon)) => curve(&mut hand, mask, polygon, violation),
        ([], _) => hand.left_out = Some(LeftOut::Ring),
        _ => hand.left_out = Some(LeftOut::Net),
    }
    Ok(Some(hand))
}

/// Fills in the refined points, the limit and both sides of a violation by a curve.
fn curve(hand: &mut ByHand, mask: &Mask, polygon: &ExtremalPolygon, violation: &Violation) {
    let mut points = Points::new(mask, polygon);
    let k = violation.level;
    let one = Functional::point;
    hand.sides = match (violation.quantity, &violation.attained.place) {
        (Quantity::Distance, Place::Parameter(t)) => {
            let limit = Limit::new(mask).ok();
            let below = |limit: &Limit| {
                let at = limit.contraction().iter().position(|norm| *norm < Rational::one())?;
                Some((u32::try_from(at).ok()?, limit.contraction()[at].clone()))
            };
            hand.contraction = limit.as_ref().and_then(below);
            hand.weights = limit.as_ref().and_then(LimitWeights::of);
            let far = hand.weights.as_ref().and_then(|weights| points.limit(weights, t));
            far.map(|far| [far, points.polygon(k, t)])
        }
        (Quantity::Step, Place::Point(i)) => {
            // The parameter of the point, in units of level k.
            let place = Rational::from(*i) / Rational::from(mask.arity());
            Some([points.combination(k + 1, &one(*i)), points.at(k, &place)])
        }
        (Quantity::Difference, Place::Difference(i)) => {
            Some([points.combination(k, &one(i + 1)), points.combination(k, &one(*i))])
        }
        _ => None,
    };
    hand.refined = points.refined();
    let count: usize = hand.refined.iter().map(|(_, points)| points.len()).sum();
    if hand.sides.is_none() || count > MAX_POINTS {
        hand.left_out = Some(LeftOut::Points);
        (hand.refined, hand.sides) = (Vec::new(), None);
    }
}

/// The first cell of the paper that prints a constant correctly rounded, for the same formula, the
/// same scheme and the same values of parameters. Its parameters are all stated, so that no table
/// has to be judged.
fn printed(
    paper: &Paper,
    instance: &Instance,
    constant: &HandConstant,
    library: &Library<'_>,
) -> Result<Option<HandCell>, Diagnostic> {
    for table in &paper.tables {
        let text = table.value.text.trim();
        if text == constant.name || text == constant.formula {
            let found = in_table((paper, table), (instance, constant), library)?;
            if found.is_some() {
                return Ok(found);
            }
        }
    }
    Ok(None)
}

fn in_table(
    (paper, table): (&Paper, &Table),
    (instance, constant): (&Instance, &HandConstant),
    library: &Library<'_>,
) -> Result<Option<HandCell>, Diagnostic> {
    let judge = Evaluator::new(paper, table, library, &BTreeMap::new())?;
    let (nothing, settings) = (BTreeSet::new(), Settings::default());
    let scheme = instance.resolved.as_ref().map(|scheme| &scheme.instances);
    for (row, cells) in table.cells.iter().enumerate() {
        for (column, cell) in cells.iter().enumerate() {
            let Some(printed) = cell.printed() else { continue };
            if !matches!(
                printed.decimal.rounding_of(&constant.value),
                Rounding::Exact | Rounding::Nearest
            ) {
                continue;
            }
            let at = CellReading { row, column, assume: &nothing, settings: &settings };
            let Outcome::Value(value) = judge.evaluate(&table.value, at)? else { continue };
            let Ok(quantities) = judge.quantities(at)? else { continue };
            let of_scheme = quantities.scheme.as_ref().map(|scheme| &scheme.instances) == scheme;
            let headers: Vec<(&str, Rational)> = judge.header_values(at).collect();
            let here = |name: &String| {
                let header = headers.iter().find(|(header, _)| header == name);
                header.map(|(_, value)| value).or_else(|| judge.given.get(name))
            };
            let mut values = instance.values.iter();
            if value == constant.value
                && of_scheme
                && values.all(|(name, value)| here(name).is_none_or(|here| here == value))
            {
                return Ok(Some(HandCell {
                    id: format!("{}:{}:{}:{}", paper.key, table.id, row + 1, column + 1),
                    locus: judge.locus(row, column),
                    printed: printed.text.clone(),
                }));
            }
        }
    }
    Ok(None)
}
