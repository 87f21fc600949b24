//! How a table came about that is not what it is said to equal.

use super::claim::{Project, ShippedClaim};
use super::exact::Values;
use super::finding::{Early, Reading, ShippedCell, Verdict};
use super::verdict::{agreeing, verdict};

/// The most digits after the point that a definition is rounded to.
const MAX_PLACES: u32 = 17;

/// A table of unrelated numbers fits a reading with probability of about 10^−E, E the digits that it explains. This
/// and the number of readings have to leave a factor of 10 to this power.
const MARGIN: u32 = 3;

/// The reading that explains every number of the table, if there is one. A number that is open is not shown to be wrong, so
/// that nothing explains it.
pub(super) fn reading(
    project: &Project,
    claim: &ShippedClaim,
    cells: &[ShippedCell],
) -> Option<Reading> {
    if cells.iter().any(|cell| cell.verdict == Verdict::Open) {
        return None;
    }
    let convention = (0..claim.conventions.len()).find(|&number| {
        let values = Values::new(project, claim, None);
        let exact = &claim.conventions[number].exact;
        all_accepted(claim, cells, |place| values.at(exact, place).ok())
    });
    convention.map(Reading::Convention).or_else(|| early(project, claim, cells))
}

/// The definition that was rounded before it was used, with the most digits.
fn early(project: &Project, claim: &ShippedClaim, cells: &[ShippedCell]) -> Option<Reading> {
    let used = project.used_by(&claim.exact);
    let mut ways = vec![Early::Single];
    for places in (1..=MAX_PLACES).rev() {
        ways.extend([Early::Places(places), Early::Cut(places)]);
    }
    // `Single` keeps some 7 digits, and stands among those.
    ways.sort_by_key(|way| std::cmp::Reverse(kept(*way)));
    let tried = used.len() * ways.len();
    let explained = explained_digits(claim, cells);
    // 10^E ≥ 10^MARGIN · tried, where the number of readings has as many digits as its decimal text.
    if used.is_empty() || explained < MARGIN + u32::try_from(tried.to_string().len()).unwrap_or(0) {
        return None;
    }
    for way in ways {
        for &name in &used {
            let values = Values::new(project, claim, Some((name, way)));
            if all_accepted(claim, cells, |place| values.at(&claim.exact, place).ok()) {
                return Some(Reading::Early(name.to_owned(), way));
            }
        }
    }
    None
}

/// Twice the digits that are kept; one more where they are cut rather than rounded.
fn kept(way: Early) -> u32 {
    match way {
        Early::Places(places) => 2 * places + 1,
        Early::Cut(places) => 2 * places,
        Early::Single => 14,
    }
}

/// Whether a reading accepts all numbers, and one is better by it than as printed. Those that are wrong as printed come first: most readings fail there.
fn all_accepted(
    claim: &ShippedClaim,
    cells: &[ShippedCell],
    exact: impl Fn(usize) -> Option<crate::exact::RealExpression>,
) -> bool {
    let wrong = |place: &usize| !cells[*place].verdict.is_accepted();
    let (first, rest): (Vec<usize>, Vec<usize>) = (0..cells.len()).partition(wrong);
    let mut better = false;
    let all = first.into_iter().chain(rest).all(|place| {
        let number = &claim.numbers[place];
        exact(place).is_some_and(|x| {
            let found = verdict(&x, number, claim.kind);
            better |= found.outcome() < cells[place].verdict.outcome();
            found.is_accepted()
        })
    });
    all && better
}

/// How many digits a reading has to explain: of each number that is not accepted as printed, those that do not agree.
fn explained_digits(claim: &ShippedClaim, cells: &[ShippedCell]) -> u32 {
    let of_type = match claim.kind {
        super::NumberType::Single => 7,
        super::NumberType::Double => 15,
        super::NumberType::Decimal(digits) => digits,
    };
    let digits = |(place, cell): (usize, &ShippedCell)| {
        if cell.verdict.is_accepted() {
            return 0;
        }
        let number = &claim.numbers[place];
        let written = number.written.as_ref().and_then(|written| written.count);
        let typed = written.map_or(of_type, |(digits, _)| u32::try_from(digits).unwrap_or(of_type));
        let agree = cell.exact.as_ref().ok().and_then(|exact| agreeing(exact, &number.held));
        let agree = agree.unwrap_or(typed);
        typed.min(of_type).saturating_sub(agree)
    };
    cells.iter().enumerate().map(digits).sum()
}
