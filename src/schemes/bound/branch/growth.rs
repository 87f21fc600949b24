//! The norms ‖E^m‖, or bounds of them, that a search needs.

use super::entries::Entries;
use super::problem::{Greatest, Problem, Reach, threads};
use super::reach::{Moments, place, rounded_up};
use super::scaled::Scaled;
use super::search_tree::{Leaf, SearchTree, SearchedOperator};
use super::uniform::{self, UniformBound};
use crate::bound::budget::Budget;
use crate::cores::together;
use crate::exact::{Integer, Rational};
use crate::scheme::Rules;
use std::collections::BTreeMap;

/// ‖E^m‖ is computed for m up to this number before a bound of all norms is sought.
const FIRST: u32 = 8;

/// From this m on, two norms are computed at the same time.
const PAIRED: u32 = 16;

/// The known facts about the powers of one operator.
#[derive(Clone, Debug)]
pub(super) struct Growth {
    operator: Scaled,
    /// q^m·‖E^m‖ and its class, for some m.
    known: BTreeMap<u32, Greatest>,
    /// A bound of all ‖E^m‖, if one was found.
    uniform: Option<UniformBound>,
    sought: bool,
    reach: Vec<Reach>,
    /// The moments of E^m, where m is the length of `reach`.
    moments: Moments,
    /// Searches end when this is stopped.
    budget: Budget,
    /// Whether bounds of single entries are wanted by the next search.
    sharp: bool,
    /// Bounds of single entries, if they are used.
    entries: Option<Entries>,
}

impl Growth {
    /// Operators of the same arity, width and offset.
    pub(super) fn of<const K: usize>(rules: [&Rules; K]) -> [Growth; K] {
        Scaled::of(rules).map(|operator| Growth {
            operator,
            known: BTreeMap::new(),
            uniform: None,
            sought: false,
            reach: Vec::new(),
            moments: Moments::start(),
            budget: Budget::unlimited(),
            sharp: false,
            entries: None,
        })
    }

    /// From now on, searches use bounds of single entries. Trees that prove norms do not.
    pub(super) fn sharpen(&mut self) {
        self.sharp = self.entries.is_none() && self.operator.shift.is_some();
    }

    /// Finds the bounds of single entries, if they are wanted and not known: where no search is needed, nor are they.
    fn find_entries(&mut self) {
        if std::mem::take(&mut self.sharp) {
            self.entries = Entries::new(&self.operator);
            // The bounds so far have none.
            for m in 0..self.reach.len() {
                self.add_entries(m);
            }
        }
    }

    /// Adds the bounds of single entries of E^m.
    fn add_entries(&mut self, m: usize) {
        let Growth { entries: Some(entries), operator, reach, .. } = self else { return };
        let total = |i: usize| {
            let power = operator.denominator.pow(u32::try_from(i).expect("at most 256 levels"));
            Rational::new(reach[i].total.clone(), power * &operator.fraction)
        };
        let Some(bounds) = entries.of(m, total).map(<[i64]>::to_vec) else { return };
        let place = reach[m].place.take();
        reach[m].place = place.map(|place| place.with_entries(&bounds));
    }

    /// Searches end from now on when this budget is stopped.
    pub(super) fn watch(&mut self, budget: Budget) {
        self.budget = budget;
    }

    pub(super) fn operator(&self) -> &Scaled {
        &self.operator
    }

    pub(super) fn reach(&self) -> &[Reach] {
        &self.reach
    }

    /// The greatest row of the c-th power, or `None` if the work does not suffice.
    pub(super) fn greatest(&mut self, levels: u32, work: &mut u64) -> Option<Greatest> {
        if let Some(known) = self.known.get(&levels) {
            return Some(known.clone());
        }
        self.prepare(levels, work)?;
        self.search(levels, work)
    }

    /// As `greatest`, after `prepare`.
    fn search(&mut self, levels: u32, work: &mut u64) -> Option<Greatest> {
        let found = self.problem(levels, threads()).greatest(work)?;
        self.known.insert(levels, found.clone());
        Some(found)
    }

    fn problem(&self, levels: u32, threads: usize) -> Problem<'_, 1> {
        let (operators, reach) = ([&self.operator], [&self.reach[..]]);
        Problem { operators, reach, levels, threads, budget: &self.budget }
    }

    /// A tree that proves the norm of the c-th power.
    pub(super) fn tree(&mut self, levels: u32, work: &mut u64) -> Option<SearchTree> {
        let greatest = self.greatest(levels, work)?;
        let plain: Vec<Reach> = self.reach.iter().map(Reach::without_entries).collect();
        let problem = Problem { reach: [&plain], ..self.problem(levels, 1) };
        let leaves = problem.leaves(&greatest, work)?;
        Some(Growth::search_tree([self], levels, greatest, leaves))
    }

    /// The tree with these leaves, which prove that `greatest` is the greatest row of the
    /// c-th powers.
    pub(super) fn search_tree<const K: usize>(
        growths: [&Growth; K],
        levels: u32,
        greatest: Greatest,
        leaves: Vec<Leaf>,
    ) -> SearchTree {
        let operators = growths.map(Growth::operator);
        let denominators = operators.iter().map(|operator| &operator.denominator);
        let scale = denominators.fold(Integer::one(), |product, q| product * q);
        SearchTree {
            // The offset of R with all its columns, also the first ones that are 0.
            offset: operators[0].offset - i64::try_from(operators[0].skipped).expect("few columns"),
            norm: Rational::new(greatest.value, scale.pow(levels)),
            operators: growths.map(|growth| growth.operand(levels)).into(),
            leaves,
        }
    }

    /// The bounds of lower powers on which bounds of the c-th power rest.
    fn operand(&self, levels: u32) -> SearchedOperator {
        let total = |(m, reach): (u32, &Reach)| {
            let scale = self.operator.denominator.pow(m) * &self.operator.fraction;
            Rational::new(reach.total.clone(), scale)
        };
        SearchedOperator {
            factor: self.operator.factor.clone(),
            totals: (0..levels).zip(&self.reach).map(total).collect(),
            uniform: self.uniform.clone(),
        }
    }

    /// Bounds of ‖E^m‖ for all m < c. They are exact for m up to [`FIRST`], and for every m if no
    /// bound of all norms is found. `None` when the work does not suffice.
    pub(super) fn prepare(&mut self, levels: u32, work: &mut u64) -> Option<()> {
        self.find_entries();
        for m in 0..levels {
            let known = self.known.contains_key(&m);
            if !known && (m <= FIRST || self.uniform().is_none()) {
                if m < PAIRED || m + 1 == levels {
                    self.search(m, work)?;
                } else {
                    self.search_two(m, work)?;
                }
            }
            if self.reach.len() == m as usize {
                self.extend(m);
            }
        }
        Some(())
    }

    /// The greatest rows of the powers m and m + 1, searched at the same time. The second
    /// search needs ‖E^m‖ at its first level, and uses a product of two norms as its bound.
    fn search_two(&mut self, m: u32, work: &mut u64) -> Option<()> {
        let (reach, moments) = (self.reach.len(), self.moments.clone());
        self.extend(m);
        let share = *work / 2;
        let search = |levels| {
            let mut work = share;
            let found = self.problem(levels, 1).greatest(&mut work);
            (found, work)
        };
        let found = together([m, m + 1].map(|levels| move || search(levels)));
        self.reach.truncate(reach);
        self.moments = moments;
        *work = found.iter().map(|(_, left)| left).sum();
        for (levels, (greatest, _)) in (m..).zip(found) {
            self.known.insert(levels, greatest?);
        }
        Some(())
    }

    /// Appends the entry for m to `reach`.
    fn extend(&mut self, m: u32) {
        let power = self.operator.denominator.pow(m);
        let scale = &power * &self.operator.fraction;
        let total = match (self.known.get(&m), &self.uniform) {
            (Some(known), _) => &known.value * &self.operator.fraction,
            (None, Some(all)) => (&all.bound * Rational::from(scale.clone())).ceil(),
            (None, None) => self.product(m),
        };
        let place = self.operator.shift.as_ref().and_then(|shift| {
            let tau = Rational::new(total.clone(), scale);
            let (ends, radius) = self.moments.ends();
            let place = place(&self.operator, (&ends, radius), &power, &tau);
            self.moments.advance(self.operator.arity, shift, &rounded_up(&tau));
            place
        });
        self.reach.push(Reach { total, place });
        self.add_entries(self.reach.len() - 1);
    }

    /// The least product of the bounds of ‖E^a‖ and ‖E^{m−a}‖ over 0 < a < m, for m ≥ 2.
    fn product(&self, m: u32) -> Integer {
        let lower = &self.reach[1..m as usize];
        let products = lower.iter().zip(lower.iter().rev()).map(|(x, y)| &x.total * &y.total);
        let least = products.min().expect("a bound of ‖E^1‖ is known");
        // Rounded up.
        -(-least).div_floor(&self.operator.fraction)
    }

    fn uniform(&mut self) -> Option<&UniformBound> {
        if !self.sought {
            self.sought = true;
            let norms = self.known.iter().map(|(&m, known)| {
                Rational::new(known.value.clone(), self.operator.denominator.pow(m))
            });
            let largest = norms.max().expect("the norm for m = 0 is known");
            self.uniform = uniform::bound(&self.operator, &largest);
        }
        self.uniform.as_ref()
    }
}
