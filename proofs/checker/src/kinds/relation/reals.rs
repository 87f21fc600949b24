//! Relations for real values of an index, by the pieces of the line of its values.

#![warn(clippy::arithmetic_side_effects)]

use super::bounds::{has_call, judged_on};
use super::compare::{judged, judged_reals};
use super::ranges::{Real, index, ranges, real};
use super::states::{Comparison, Rest, Sign};
use crate::claims::Paper;
use crate::formulas::{Scope, formula};
use crate::kinds::equation::cases::{Case, Index, Values, cases};
use crate::kinds::equation::scopes::{scope, scope_on};
use crate::lines::pieces::on_parts;
use crate::numbers::{Ends, Meter, Piece, Q, Root, read_rational};
use crate::text::{Block, Checked, Reason, Stop, Toml, compare, require};
use std::cmp::Ordering;
use std::rc::Rc;

/// The most ends of pieces.
const MAX_BREAKS: usize = 1_000;

/// What follows `fails reals`.
const WITNESS: &str = "false INDEX…, or true INDEX… of a claim with `only`";

/// Whether an index has real values, or the claim says that it has no others than it should.
pub fn concern(claim: &Toml) -> bool {
    claim.is_set("only") || ranges(claim).any(|text| real(text).is_some())
}

/// Checks the verdict on a claim about real values of an index.
pub fn check<'a>(
    paper: &'a Paper<'a>,
    claim: &'a Toml,
    stated: &[Comparison],
    block: &mut Block<'_>,
) -> Checked<()> {
    let lines = block.lines().iter().map(|line| line.word().0);
    let constants = lines.into_iter().any(|word| word == "constant");
    require(!constants, Reason::Malformed("no constants beside real values"))?;
    let claim = Claim::read(paper, claim, stated)?;
    let (verdict, reals) = block.any()?;
    require(reals == "reals", Reason::Malformed("a verdict on real values"))?;
    match verdict {
        "holds" => claim.holds(),
        "fails" => match block.any()? {
            ("false", said) => claim.is_false(said),
            ("true", said) if claim.only => claim.is_true(said),
            _ => Err(Reason::Malformed(WITNESS).into()),
        },
        _ => Err(Reason::Malformed("holds reals, or fails reals").into()),
    }
}

/// A claim about real values of an index.
struct Claim<'c, 'a> {
    paper: &'a Paper<'a>,
    table: &'a Toml,
    stated: &'c [Comparison],
    /// The name of the index.
    name: &'a str,
    /// The number of the names of indices before it.
    place: usize,
    /// The other indices.
    others: Vec<Index<'a>>,
    /// The values of the index.
    line: Line,
    /// Whether some comparison is false for all other real numbers.
    only: bool,
}

fn wrong<T>(what: &str) -> Checked<T> {
    Err(Stop::Wrong(what.to_owned()).into())
}

/// Why a claim is open if a comparison has no value. What is beyond a cap stays so.
fn open(stop: Stop) -> Reason {
    match stop {
        Stop::Capped(_) | Stop::Undecided(_) | Stop::Family(_) | Stop::Integers(_) => {
            Reason::Stopped(stop)
        }
        Stop::Wrong(_) | Stop::OtherRoot | Stop::Undefined(_) | Stop::Unstated(_) => {
            Reason::Valueless(stop)
        }
    }
}

impl<'c, 'a> Claim<'c, 'a> {
    fn read(
        paper: &'a Paper<'a>,
        claim: &'a Toml,
        stated: &'c [Comparison],
    ) -> Checked<Claim<'c, 'a>> {
        let near = |of: &Comparison| matches!(of.rest, Rest::Sign(Sign::Near, _));
        let beside = claim.texts("symbols").chain(claim.texts("hypotheses")).next().is_some();
        if beside || stated.iter().any(near) {
            return wrong("symbols, hypotheses and ≈ stand beside no real values");
        }
        let (mut found, mut others, mut place) = (None, Vec::new(), 0_usize);
        for text in ranges(claim) {
            match real(text).transpose()? {
                Some(real) if found.is_none() => found = Some(real),
                Some(_) => return wrong("two indices have real values"),
                None => {
                    let index = index(text)?;
                    let before = if found.is_none() { index.names().len() } else { 0 };
                    place = place.saturating_add(before);
                    others.push(index);
                }
            }
        }
        if others.iter().any(Index::is_all) {
            return wrong("an index has all integers beside real values");
        }
        let only = claim.is_set("only");
        let (name, line) = match (found, &others[..]) {
            (Some(real), _) if !only || others.is_empty() => (real.name, Line::of(paper, &real)?),
            (None, [Index { name, values: Values::Listed(values) }]) => {
                let line = Line::listed(values)?;
                let name = *name;
                others.clear();
                place = 0;
                (name, line)
            }
            _ => return wrong("`only` is said of one index: real values, or listed numbers"),
        };
        Ok(Claim { paper, table: claim, stated, name, place, others, line, only })
    }

    /// The scope of a case on a piece, or of a number if both ends are the same.
    fn scope(&self, case: &Case<'a>, ends: Ends) -> Result<Scope<'a>, Stop> {
        let [low, high] = &ends;
        if let Some(value) = low.as_ref().filter(|_| low == high).and_then(Root::rational) {
            let case = [&case[..], &[(self.name, value.clone())]].concat();
            return scope(self.paper, self.table, &case, &Rc::default());
        }
        self.scope_on(case, ends)
    }

    /// The scope in which the index is a symbol.
    fn scope_on(&self, case: &Case<'a>, ends: Ends) -> Result<Scope<'a>, Stop> {
        let piece = Piece::new(self.name, ends, self.paper.library.meter);
        scope_on(self.paper, self.table, case, (self.name, piece))
    }

    /// Whether a comparison is false on a piece. For a rational number, all ways to see it count.
    fn fails(
        &self,
        comparison: &Comparison,
        (scope, case): (&Scope<'_>, &Case<'a>),
        ends: &Ends,
    ) -> Result<bool, Stop> {
        let library = self.paper.library;
        if scope.piece.is_some() {
            return judged_on(library, comparison, scope);
        }
        let stop = match judged(comparison, scope) {
            Ok((fails, _)) => return Ok(fails),
            Err(stop) => stop,
        };
        let reals = judged_reals(library, comparison, scope);
        if let Some(fails) = reals.ok().and_then(|found| found.fails) {
            return Ok(fails);
        }
        if !has_call(comparison) {
            return Err(stop);
        }
        judged_on(library, comparison, &self.scope_on(case, ends.clone())?)
    }

    /// Whether all comparisons are true on a piece, or for a number. All of them need a value.
    fn all_true(&self, of: (&Scope<'_>, &Case<'a>), ends: &Ends) -> Result<bool, Stop> {
        self.stated.iter().try_fold(true, |all, comparison| {
            let fails = self.fails(comparison, of, ends)?;
            Ok(all && !fails)
        })
    }

    /// Checks that all comparisons are true for all values, and with `only` not all for any other.
    fn holds(&self) -> Checked<()> {
        let cases = cases(self.paper, &self.others)?;
        require(!cases.is_empty(), Reason::NoCase)?;
        for case in &cases {
            for (ends, belongs) in self.line.parts() {
                if !belongs && !self.only {
                    continue;
                }
                let found = on_parts(ends, |ends| {
                    let scope = self.scope(case, ends.clone())?;
                    let found = self.all_true((&scope, case), &ends);
                    Ok((found, scope.piece.map_or(Vec::new(), |piece| piece.cuts())))
                });
                let right = found.map_err(open)? == Some(belongs);
                compare(right, "holds", "fails", Reason::Verdict)?;
            }
        }
        Ok(())
    }

    /// Checks a value of each index for which a comparison is false.
    fn is_false(&self, said: &str) -> Checked<()> {
        let meter = self.paper.library.meter;
        let mut words: Vec<&str> = said.split_whitespace().collect();
        require(self.place < words.len(), Reason::Malformed(WITNESS))?;
        let at = Root::read(words.remove(self.place), meter)?.ok_or(Reason::Malformed(WITNESS))?;
        require(self.line.has(&at, meter)?, Reason::Case)?;
        let (mut words, mut case) = (words.into_iter(), Vec::new());
        for index in &self.others {
            let names = index.names();
            let values = names.iter().map(|_| words.next().and_then(written));
            let values = values.collect::<Option<Vec<Q>>>().ok_or(Reason::Case)?;
            require(index.has(self.paper, &case, &values)?, Reason::Case)?;
            case.extend(names.into_iter().zip(values));
        }
        let number = if self.stated.len() > 1 { words.next().unwrap_or_default() } else { "1" };
        let found =
            (1..).zip(self.stated).find(|(place, _): &(usize, _)| place.to_string() == number);
        let (_, comparison) = found.ok_or(Reason::Case)?;
        require(words.next().is_none(), Reason::Malformed(WITNESS))?;
        let ends = [Some(at.clone()), Some(at)];
        let scope = self.scope(&case, ends.clone()).map_err(open)?;
        let fails = self.fails(comparison, (&scope, &case), &ends).map_err(open)?;
        require(fails, Reason::NotFalse(said.to_owned()))
    }

    /// Checks that all comparisons are true for a number which is none of the values.
    fn is_true(&self, said: &str) -> Checked<()> {
        let meter = self.paper.library.meter;
        let at = Root::read(said, meter)?.ok_or(Reason::Malformed(WITNESS))?;
        require(!self.line.has(&at, meter)?, Reason::Case)?;
        let (case, ends) = (Vec::new(), [Some(at.clone()), Some(at)]);
        let scope = self.scope(&case, ends.clone()).map_err(open)?;
        let holds = self.all_true((&scope, &case), &ends).map_err(open)?;
        compare(holds, "true", "false", Reason::Said)
    }
}

/// A number as cases are written.
fn written(word: &str) -> Option<Q> {
    read_rational(word).filter(|value| value.to_string() == word)
}

/// The real numbers, with those that are values of an index.
struct Line {
    /// The ends of pieces, increasing.
    breaks: Vec<Root>,
    /// Whether the breaks are values.
    at: Vec<bool>,
    /// Whether the pieces before, between and behind them consist of values.
    pieces: Vec<bool>,
}

impl Line {
    /// The values of an index that is real.
    fn of(paper: &Paper<'_>, real: &Real<'_>) -> Checked<Line> {
        let meter = paper.library.meter;
        let (mut lower, mut upper) = (None, None);
        for (sign, end) in &real.ends {
            let mut closed = paper.library.closed();
            closed.filters = true;
            let value = closed.value(&formula(end)?)?;
            let end = Root::of(value.number()?, meter)?;
            let side = match sign {
                Sign::Greater | Sign::AtLeast => &mut lower,
                Sign::Less | Sign::AtMost => &mut upper,
                _ => {
                    return Ok(Line {
                        breaks: vec![end],
                        at: vec![false],
                        pieces: vec![true, true],
                    });
                }
            };
            let belongs = matches!(sign, Sign::AtLeast | Sign::AtMost);
            if side.replace((end, belongs)).is_some() {
                return wrong("the signs of an index have two directions");
            }
        }
        let (breaks, pieces) = match (lower, upper) {
            (None, None) => (Vec::new(), vec![true]),
            (Some(low), None) => (vec![low], vec![false, true]),
            (None, Some(high)) => (vec![high], vec![true, false]),
            (Some(low), Some(high)) => match low.0.compare(&high.0, meter)? {
                Ordering::Less => (vec![low, high], vec![false, true, false]),
                Ordering::Equal if low.1 && high.1 => (vec![low], vec![false, false]),
                _ => return wrong("an index has no values"),
            },
        };
        let (breaks, at) = breaks.into_iter().unzip();
        Ok(Line { breaks, at, pieces })
    }

    /// These numbers.
    fn listed(values: &[Q]) -> Checked<Line> {
        let mut values = values.to_vec();
        values.sort();
        values.dedup();
        let count = values.len();
        if count > MAX_BREAKS {
            return Err(Stop::Capped("the number of pieces").into());
        }
        let breaks = values.into_iter().map(Root::from).collect();
        Ok(Line { breaks, at: vec![true; count], pieces: vec![false; count.saturating_add(1)] })
    }

    /// Whether a number is one of the values.
    fn has(&self, at: &Root, meter: &Meter) -> Result<bool, Stop> {
        for ((place, piece), is) in self.breaks.iter().zip(&self.pieces).zip(&self.at) {
            match at.compare(place, meter)? {
                Ordering::Less => return Ok(*piece),
                Ordering::Equal => return Ok(*is),
                Ordering::Greater => {}
            }
        }
        Ok(self.pieces.last().copied().unwrap_or(false))
    }

    /// The pieces and breaks, and whether they consist of values.
    fn parts(&self) -> impl Iterator<Item = (Ends, bool)> {
        let ends = |i: usize| {
            let low = i.checked_sub(1).and_then(|i| self.breaks.get(i));
            [low.cloned(), self.breaks.get(i).cloned()]
        };
        let pieces = self.pieces.iter().enumerate().map(move |(i, is)| (ends(i), *is));
        let one = |at: &Root| [Some(at.clone()), Some(at.clone())];
        pieces.chain(self.breaks.iter().map(one).zip(self.at.iter().copied()))
    }
}
