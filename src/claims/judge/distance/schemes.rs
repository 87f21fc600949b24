//! The schemes whose distances one claim needs.

use crate::bound::Budget;
use crate::evaluation::library::Resolved;
use crate::finding::Reason;
use crate::judge::distance::known::KnownDistances;
use crate::scheme::{Instance, LocalRules};
use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::rc::Rc;

/// The most steps of all searches for the distances of one claim.
pub(crate) const MAX_STEPS: u64 = 1_000_000_000;

/// The greatest sum, over the rings of one claim, of the squares of their numbers of points.
pub(crate) const MAX_LOCAL_SIZE: usize = 600_000;

/// A scheme, and the offset at which it is compared with its limit, if not its own.
type SchemeAt = (Vec<Instance>, Option<i64>);

/// The distances that the cells of one table, or the cases of one theorem, need. Each claim has its
/// own: their work is limited, and what is spent on one claim must not change what is found for
/// another.
pub(crate) struct Schemes {
    budget: Budget,
    masks: RefCell<BTreeMap<SchemeAt, Rc<KnownDistances>>>,
    /// The distances with the points at their natural parameters; `None` where these are i/n^k.
    natural: RefCell<BTreeMap<SchemeAt, Option<Rc<KnownDistances>>>>,
    rings: RefCell<BTreeMap<Instance, Result<Rc<KnownDistances>, Reason>>>,
    rings_left: LocalCap,
}

impl Default for Schemes {
    fn default() -> Schemes {
        let (masks, natural, rings, rings_left) = Default::default();
        Schemes { budget: Budget::new(MAX_STEPS), masks, natural, rings, rings_left }
    }
}

/// The sum of the squares of the numbers of points of the rings so far.
#[derive(Default)]
pub(crate) struct LocalCap(Cell<usize>);

impl LocalCap {
    /// Whether the sum with one more ring is at most [`MAX_LOCAL_SIZE`]; if so, the ring is added.
    pub(crate) fn takes<S>(&self, ring: &LocalRules<S>) -> bool {
        let size = self.0.get().saturating_add(ring.point_count().pow(2));
        let fits = size <= MAX_LOCAL_SIZE;
        if fits {
            self.0.set(size);
        }
        fits
    }
}

impl Schemes {
    /// The distances of a scheme, at its own offset or at another.
    pub(crate) fn of(&self, scheme: &Resolved, offset: Option<i64>) -> Rc<KnownDistances> {
        let key = (scheme.instances.clone(), offset);
        let mut all = self.masks.borrow_mut();
        let known = all
            .entry(key)
            .or_insert_with(|| Rc::new(KnownDistances::new(scheme.at(offset), &self.budget)));
        Rc::clone(known)
    }

    /// As [`Schemes::of`], with the points at their natural parameters; `None` where these are
    /// i/n^k.
    pub(crate) fn naturally(
        &self,
        scheme: &Resolved,
        offset: Option<i64>,
    ) -> Option<Rc<KnownDistances>> {
        let natural = || Some(Rc::new(self.of(scheme, offset).natural()?));
        let key = (scheme.instances.clone(), offset);
        self.natural.borrow_mut().entry(key).or_insert_with(natural).clone()
    }

    /// The distances of a ring.
    ///
    /// # Errors
    /// When the rings of the claim have too many points.
    pub(crate) fn of_ring(
        &self,
        (instance, ring): &(Instance, LocalRules),
    ) -> Result<Rc<KnownDistances>, Reason> {
        let mut all = self.rings.borrow_mut();
        let new = || {
            if !self.rings_left.takes(ring) {
                return Err(Reason::Rings(MAX_LOCAL_SIZE));
            }
            Ok(Rc::new(KnownDistances::new(ring.clone(), &self.budget)))
        };
        all.entry(instance.clone()).or_insert_with(new).clone()
    }
}
