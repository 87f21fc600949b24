//! Eigenvalues and curvatures of rings for all valences from one on.

#![warn(clippy::arithmetic_side_effects)]

use super::blocks::{Block, Rest, are_below, at, ends};
use super::function::{Function, Functions};
use super::ring::{NEAR, Ring};
use crate::text::Stop;

const NOT_SIMPLE: Stop = Stop::Integers("1 is not shown to be a simple root of block 0");
const NO_LAMBDA: Stop = Stop::Integers("λ is not shown to be a simple positive root of block 1");
const NOT_LESS: Stop = Stop::Integers("another root is not shown to be less than λ");
const GREATEST: Stop = Stop::Integers("no real root is shown to be the greatest one");

/// The j-th greatest real root of block k.
pub fn eigenvalue(
    functions: &Functions<'_>,
    ring: &Ring,
    k: u64,
    j: usize,
) -> Result<Function, Stop> {
    let rest = Rest::new(functions, ring, if k == 0 { Block::Still } else { Block::At(k) })?;
    let mut roots = vec![Function::default(); rest.zeros];
    roots.extend((k == 0).then(|| Function::int(1)));
    roots.extend(rest.real(functions)?);
    // The greatest one comes first.
    let mut sorted: Vec<Function> = Vec::new();
    for root in roots {
        let mut place = 0_usize;
        for known in &sorted {
            if functions.compare(&root, known)? < 0 {
                place = place.saturating_add(1);
            }
        }
        sorted.insert(place, root);
    }
    let root = j.checked_sub(1).and_then(|j| sorted.get(j)).cloned();
    root.ok_or_else(|| Stop::Wrong("there are not so many real roots".into()))
}

/// λ, and the other roots of all blocks.
pub struct Spectrum<'s> {
    functions: &'s Functions<'s>,
    /// λ.
    pub lambda: Function,
    /// Those of block 0 without 1, of block 1 without λ, and of the blocks 2, …, 6.
    others: Vec<Rest>,
    /// Those of the later blocks.
    later: Rest,
}

impl<'s> Spectrum<'s> {
    /// The roots of all blocks, if 1 and λ > 0 are simple ones.
    pub fn new(functions: &'s Functions<'s>, ring: &Ring) -> Result<Spectrum<'s>, Stop> {
        let still = Rest::new(functions, ring, Block::Still)?;
        if functions.sign(&at(functions, &still.p, &Function::int(1))?)? == 0 {
            return Err(NOT_SIMPLE);
        }
        let mut first = Rest::new(functions, ring, Block::At(1))?;
        let lambda = match &first.real(functions)?[..] {
            // Two that are equal are not simple.
            [one, other] if functions.compare(one, other)? <= 0 => return Err(NO_LAMBDA),
            [one, ..] => one.clone(),
            [] => return Err(NO_LAMBDA),
        };
        if functions.sign(&lambda)? <= 0 || functions.compare(&lambda, &Function::int(1))? >= 0 {
            return Err(NO_LAMBDA);
        }
        // The quotient of x² + ax + b by x − λ is x + (a + λ), and that of x + a is 1.
        first.p.remove(0);
        if let [a, _] = &mut first.p[..] {
            *a = functions.sum(a, 1, &lambda)?;
        }
        let mut others = vec![still, first];
        for k in 2..=NEAR.unsigned_abs() {
            others.push(Rest::new(functions, ring, Block::At(k))?);
        }
        let later = Rest::new(functions, ring, Block::Later)?;
        Ok(Spectrum { functions, lambda, others, later })
    }

    /// Whether roots of these blocks, and with `later` of all later ones, are less than λ in absolute value, or not greater.
    fn dominates(
        &self,
        limit: &Function,
        (blocks, later): (&[Rest], bool),
        or_equal: bool,
    ) -> Result<bool, Stop> {
        for rest in blocks {
            if !are_below(self.functions, &rest.p, limit, or_equal)? {
                return Ok(false);
            }
        }
        if later {
            for end in ends(self.functions, &self.later.p)? {
                if !are_below(self.functions, &end, limit, or_equal)? {
                    return Ok(false);
                }
            }
        }
        Ok(true)
    }

    /// λ, if all other roots are less than it in absolute value.
    pub fn subdominant(&self) -> Result<Function, Stop> {
        let all = (&self.others[..], true);
        if self.dominates(&self.lambda, all, false)? {
            Ok(self.lambda.clone())
        } else {
            Err(NOT_LESS)
        }
    }

    /// The greatest absolute value of the other roots of all blocks, of block 0 or of block 2, over λ².
    pub fn curvature(&self, part: usize) -> Result<Function, Stop> {
        let functions = self.functions;
        self.subdominant()?;
        let (blocks, later) = match (part, &self.others[..]) {
            (1, [still, ..]) => (std::slice::from_ref(still), false),
            (2, [_, _, second, ..]) => (std::slice::from_ref(second), false),
            (_, all) => (all, true),
        };
        let is_zero = |rest: &Rest| rest.p.len() <= 1;
        if blocks.iter().all(is_zero) && (!later || is_zero(&self.later)) {
            let some = blocks.iter().any(|rest| rest.zeros > 0) || later && self.later.zeros > 0;
            return if some { Ok(Function::default()) } else { Err(GREATEST) };
        }
        for rest in blocks {
            let known = functions.roots();
            match self.greatest(rest, (blocks, later)) {
                Ok(Some(greatest)) => {
                    let square = functions.product(&self.lambda, &self.lambda)?;
                    return functions.quotient(&greatest, &square);
                }
                // What is not decided of one root may be decided of another.
                Ok(None) | Err(Stop::Integers(_)) => functions.forget(known),
                Err(stop) => return Err(stop),
            }
        }
        Err(GREATEST)
    }

    /// The greatest absolute value of the roots of a block, if those of other blocks are not greater.
    fn greatest(&self, rest: &Rest, counted: (&[Rest], bool)) -> Result<Option<Function>, Stop> {
        let Some(greatest) = rest.greatest(self.functions)? else { return Ok(None) };
        let positive = self.functions.sign(&greatest)? > 0;
        let is = positive && self.dominates(&greatest, counted, true)?;
        Ok(is.then_some(greatest))
    }
}
