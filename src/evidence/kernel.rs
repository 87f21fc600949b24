//! The findings that the Coq library of `proofs/coq` covers, as statements about numbers.

use crate::bound::{Constants, Operator, Order, SoundBound};
use crate::claim::{Paper, Promise, Quantity};
use crate::diagnostic::Diagnostic;
use crate::evaluation::context::At;
use crate::evaluation::library::Library;
use crate::evaluation::settings::Settings;
use crate::evaluation::table::Evaluator;
use crate::evaluation::trace::NotedConstant;
use crate::evidence::by_hand::by_hand;
use crate::evidence::drawn::promise_refiner;
use crate::evidence::table::{integer, number};
use crate::exact::{Rational, RealCyclotomic};
use crate::finding::{
    Attained, CellFinding, Control, Kept, PaperAudit, Place, Refiner, TableFinding,
};
use crate::scheme::{LocalRules, Mask, Rules};
use std::collections::BTreeSet;

/// Constants with more residue classes are left out: `coqc` computes every class.
const MAX_CLASSES: u64 = 1 << 14;

/// The most levels that are computed for the bound of all later ones.
const MAX_LEVELS: u32 = 200;

/// A finding as a statement about numbers.
#[derive(Clone, Debug)]
pub struct KernelFinding {
    /// The id of the claim within its paper.
    pub claim: String,
    /// Where it stands in the paper, and what it prints there.
    pub about: Vec<String>,
    /// What is true.
    pub statement: KernelStatement,
}

/// A statement about a scheme and numbers.
#[derive(Clone, Debug)]
pub enum KernelStatement {
    /// T_c of a mask, or Λ_c.
    Constant {
        /// The mask.
        mask: Mask,
        /// Whether it is T_c or Λ_c.
        operator: Operator,
        /// If the rules are read from their other end, the rules that are read so.
        backwards: Option<Rules>,
        /// c.
        levels: u32,
        /// The constant.
        value: Rational,
    },
    /// The distance of level k to all later levels is at most the bound times the spread.
    Distance {
        /// The mask.
        mask: Mask,
        /// k.
        level: u32,
        /// The bound.
        bound: Rational,
        /// M and c.
        block: (usize, u32),
    },
    /// From level k on, polygons of a spread keep a tolerance.
    Depth {
        /// The mask.
        mask: Mask,
        /// k.
        level: u32,
        /// The spread.
        spread: Rational,
        /// The tolerance.
        tolerance: Rational,
        /// M and c.
        block: (usize, u32),
    },
    /// Data of spread 1 exceed a bound.
    Exceeds {
        /// The mask.
        mask: Mask,
        /// k.
        level: u32,
        /// The index of the first point.
        first: i64,
        /// The points.
        points: Vec<i64>,
        /// Where.
        excess: Excess,
        /// The bound.
        bound: Rational,
    },
    /// A ring of rational weights exceeds a bound.
    Ring {
        /// The weights, row by row.
        weights: Vec<Vec<Rational>>,
        /// The edges.
        edges: Vec<(usize, usize)>,
        /// k.
        level: u32,
        /// The points.
        points: Vec<i64>,
        /// Where.
        excess: RingExcess,
        /// The bound.
        bound: Rational,
    },
}

/// A quantity of a curve that exceeds a bound, and its place.
#[derive(Clone, Debug)]
pub enum Excess {
    /// x^k_{i+1} − x^k_i at this i.
    Difference(i64),
    /// P^{k+1} − P^k at this t.
    Step(Rational),
    /// P^m − P^k at this t, for all m from a level on.
    Distance {
        /// t.
        place: Rational,
        /// The level.
        later: u32,
        /// A bound of the distance of this level to all later ones.
        tail: Rational,
        /// M and c that show the bound.
        block: (usize, u32),
    },
}

/// A quantity of a ring that exceeds a bound, and its place.
#[derive(Clone, Debug)]
pub enum RingExcess {
    /// The difference of two points.
    Difference(usize, usize),
    /// The step of a point to the next level.
    Step(usize),
    /// The distance of a point to the limit of the ring, with the weights of the limit.
    Distance(usize, Vec<Rational>),
}

/// The findings of a paper that the Coq library covers, claim by claim.
///
/// # Errors
/// When a formula of the claim file is wrong.
pub fn kernel_findings(audit: &PaperAudit<'_>) -> Result<Vec<KernelFinding>, Diagnostic> {
    let mut found = Vec::new();
    for table in &audit.tables {
        of_table(audit.paper, table, &mut found)?;
    }
    for finding in &audit.theorems {
        let Some(refutation) = &finding.refutation else { continue };
        let Some(hand) = by_hand(audit, finding)? else { continue };
        let violation = &refutation.violation;
        let Some(bound) = violation.bound.as_rational() else { continue };
        let (theorem, level) = (finding.theorem, violation.level);
        let limit = rationals(&refutation.limit);
        let excess = exceeds(
            &hand.refiner,
            (violation.quantity, level),
            &violation.attained,
            (bound, limit.as_deref()),
        );
        let Some(statement) = excess else { continue };
        let about = vec![
            format!("{}: {}", theorem.locus, theorem.title),
            format!("Refuted: {}, at level {level}; the bound is {}", refutation.case, hand.bound),
        ];
        found.push(KernelFinding { claim: theorem.id.clone(), about, statement });
    }
    Ok(found)
}

fn rationals<'n>(numbers: impl IntoIterator<Item = &'n RealCyclotomic>) -> Option<Vec<Rational>> {
    numbers.into_iter().map(|number| number.as_rational().cloned()).collect()
}

fn of_table(
    paper: &Paper,
    finding: &TableFinding<'_>,
    found: &mut Vec<KernelFinding>,
) -> Result<(), Diagnostic> {
    let (library, table) = (Library::new(paper), finding.table);
    let judge = Evaluator::new(paper, table, &library, &finding.values())?;
    let assume: BTreeSet<String> = judge.assumed.keys().cloned().collect();
    let settings = Settings::default();
    let new =
        |about: Vec<String>, statement| KernelFinding { claim: table.id.clone(), about, statement };
    let mut known = BTreeSet::new();
    for (row, cells) in finding.cells.iter().enumerate() {
        for (column, cell) in cells.iter().enumerate() {
            let at = At { row, column, assume: &assume, settings: &settings };
            for noted in judge.constants(at)?.constants {
                let key = (noted.instance.clone(), noted.operator, noted.order, noted.levels);
                if known.contains(&key) {
                    continue;
                }
                if let Some((statement, value)) = constant(&noted) {
                    known.insert(key);
                    let rests = format!("{}: a constant that the cell rests on", cell.locus);
                    let about = if cell.exact.as_ref() == Some(&value.into()) {
                        printed(cell)
                    } else {
                        rests
                    };
                    found.push(new(vec![about], statement));
                }
            }
            if let Some(promise) = &table.promise
                && let Some(statement) = sound(&judge, promise, at)?
            {
                found.push(new(vec![printed(cell), "What holds:".to_owned()], statement));
            }
            if let Some(Kept::No(broken)) = &cell.kept
                && let Some(refiner) = promise_refiner(paper, finding, (row, column))?
            {
                let bound = &broken.most / &broken.spread;
                let of = (Quantity::Distance, broken.level);
                if let Some(statement) = exceeds(&refiner, of, &broken.attained, (&bound, None)) {
                    let scaled = format!(
                        "It does not keep its promise: {} at level {}, for points of spread {}",
                        broken.most, broken.level, broken.spread
                    );
                    found.push(new(vec![printed(cell), scaled], statement));
                }
            }
        }
    }
    Ok(())
}

fn printed(cell: &CellFinding) -> String {
    let text = cell.printed.as_deref().unwrap_or("nothing");
    format!("{} prints {text}", cell.locus)
}

fn constant(noted: &NotedConstant) -> Option<(KernelStatement, Rational)> {
    let NotedConstant { constants, operator, levels, order, .. } = noted;
    let mask = constants.mask().clone();
    let classes = (mask.arity() as u64).checked_pow(*levels)?;
    if *levels == 0 || classes > MAX_CLASSES {
        return None;
    }
    let value = constants.norm(*operator, *levels, *order).ok()?;
    // For c = 1 the order does not matter.
    let backwards = (*order == Order::Forward && *levels > 1).then(|| match operator {
        Operator::Difference => constants.difference().clone(),
        Operator::Scheme => mask.rules().clone(),
    });
    let (operator, levels) = (*operator, *levels);
    Some((
        KernelStatement::Constant { mask, operator, backwards, levels, value: value.clone() },
        value,
    ))
}

/// The sound bound of a cell about a curve, by as few constants as give it.
fn sound(
    judge: &Evaluator<'_>,
    promise: &Promise,
    at: At<'_>,
) -> Result<Option<KernelStatement>, Diagnostic> {
    let Ok(quantities) = judge.quantities(at)? else { return Ok(None) };
    let Some(scheme) = quantities.scheme else { return Ok(None) };
    let [axis] = &scheme.constants[..] else { return Ok(None) };
    let (Promise::Depth { spread, offset, .. } | Promise::Bound { spread, offset, .. }) = promise;
    let offset = offset.as_ref().map(|offset| integer(judge, offset, at)).transpose()?.flatten();
    let mask = axis.mask().with_offset(offset.unwrap_or(axis.mask().offset()));
    let Ok(bound) = judge.library.sound_bound(&scheme, offset) else { return Ok(None) };
    let Some(spread) = number(judge, spread, at)? else { return Ok(None) };
    match promise {
        Promise::Depth { tolerance, .. } => {
            let Some(tolerance) = number(judge, tolerance, at)? else { return Ok(None) };
            let Ok(depth) = bound.depth(&spread, &tolerance) else { return Ok(None) };
            let found = fewest(&bound, |bound| {
                let less = bound.depth(&spread, &tolerance).ok()?;
                (less.level == depth.level).then_some(less.block)
            });
            let level = depth.level;
            Ok(found.map(|block| KernelStatement::Depth { mask, level, spread, tolerance, block }))
        }
        Promise::Bound { level, .. } => {
            let level = integer(judge, level, at)?.and_then(|level| u32::try_from(level).ok());
            let Some(level) = level.filter(|level| *level <= MAX_LEVELS) else { return Ok(None) };
            let Some((value, _)) = bound.level(level) else { return Ok(None) };
            let found = fewest(&bound, |bound| {
                bound.level(level).filter(|(less, _)| *less == value).map(|(_, block)| block)
            });
            let bound = value;
            Ok(found.map(|block| KernelStatement::Distance { mask, level, bound, block }))
        }
    }
}

/// The least M whose constants T_1, …, T_M serve, with the block length.
fn fewest(bound: &SoundBound, serves: impl Fn(&SoundBound) -> Option<u32>) -> Option<(usize, u32)> {
    (1..bound.constants().len()).find_map(|most| {
        let less = SoundBound::of(bound.factor().clone(), bound.constants()[..=most].to_vec());
        Some((most, serves(&less)?))
    })
}

fn exceeds(
    refiner: &Refiner,
    (quantity, level): (Quantity, u32),
    attained: &Attained,
    (bound, limit): (&Rational, Option<&[Rational]>),
) -> Option<KernelStatement> {
    match (refiner, &attained.control) {
        (Refiner::Masks(masks), Control::Polygon(polygon)) => {
            let [mask] = &masks[..] else { return None };
            let excess = match (quantity, &attained.place) {
                (Quantity::Difference, Place::Difference(i)) => Excess::Difference(*i),
                (Quantity::Step, Place::Point(i)) => {
                    let points = Rational::from(mask.arity() as u64).pow((level + 1).cast_signed());
                    Excess::Step(Rational::from(*i) / points)
                }
                (Quantity::Distance, Place::Parameter(t)) => {
                    far(mask, t, &(attained.value.as_rational()? - bound))?
                }
                _ => return None,
            };
            let (first, points) = (polygon.first, polygon.points.clone());
            let (mask, bound) = (mask.clone(), bound.clone());
            Some(KernelStatement::Exceeds { mask, level, first, points, excess, bound })
        }
        (Refiner::Ring(ring), Control::Points(points)) => {
            let place = |name: &String| points.iter().position(|(known, _)| known == name);
            let excess = match (quantity, &attained.place) {
                (Quantity::Difference, Place::Edge([a, b])) => {
                    RingExcess::Difference(place(a)?, place(b)?)
                }
                (Quantity::Step, Place::Named(a)) => RingExcess::Step(place(a)?),
                (Quantity::Distance, Place::Named(a)) => {
                    RingExcess::Distance(place(a)?, limit?.to_vec())
                }
                _ => return None,
            };
            let points = points.iter().map(|(_, height)| *height).collect();
            let (weights, edges) = (weights(ring)?, ring.edges().to_vec());
            let bound = bound.clone();
            Some(KernelStatement::Ring { weights, edges, level, points, excess, bound })
        }
        _ => None,
    }
}

fn weights(ring: &LocalRules) -> Option<Vec<Vec<Rational>>> {
    let weights = ring.weights();
    (0..ring.point_count()).map(|row| rationals(weights.row(row))).collect()
}

/// A later level whose distance to all levels beyond is so small that what exceeds a bound by `gap`
/// in the limit exceeds it from there on.
fn far(mask: &Mask, place: &Rational, gap: &Rational) -> Option<Excess> {
    let mut tail = Rational::one();
    while &tail + &tail + &tail > *gap {
        tail = tail / Rational::from(2);
    }
    let constants = Constants::new(mask.clone());
    let most = (1..=8).take_while(|c| (mask.arity() as u64).pow(*c) <= 1 << 11).last()?;
    let bound = SoundBound::curve(&constants, most).ok()?;
    let one = Rational::one();
    let least = bound.constants().iter().skip(1).position(|constant| *constant < one)? + 1;
    let bound = SoundBound::of(bound.factor().clone(), bound.constants()[..=least].to_vec());
    let later =
        (0..MAX_LEVELS).find(|level| bound.level(*level).is_some_and(|(b, _)| b <= tail))?;
    let block = (least, bound.level(later)?.1);
    Some(Excess::Distance { place: place.clone(), later, tail, block })
}
