//! Schemes: their masks and difference masks.

use crate::numbers::{Piece, Value};
use crate::text::Stop;
use std::cell::{OnceCell, RefCell};
use std::collections::BTreeMap;
use std::rc::Rc;

/// The most rules of a scheme.
pub const MAX_ARITY: u16 = 64;

/// The most points of a rule.
pub const MAX_WIDTH: u16 = 256;

/// The greatest offset.
pub const MAX_OFFSET: i64 = 10_000;

/// Values at the integers from the first one on. They are 0 at all others.
pub type Integrals = (i64, Rc<[Value]>);

/// The name of a ring, with the values of its parameters.
pub type Ring = (String, BTreeMap<String, Value>);

/// A mask with its difference mask.
pub struct Scheme {
    /// The mask a_{α,j}, with a row for each rule α.
    pub mask: Vec<Vec<Value>>,
    /// The difference mask b_{β,j}.
    pub difference: Vec<Vec<Value>>,
    /// The offset o.
    pub offset: i64,
    /// The values at the integers of the limit of 1 at 0, once they are known.
    pub limit: OnceCell<Rc<[Value]>>,
    /// The integrals of this limit with the shifts of the limits of other schemes, from the first shift on, by the addresses of these.
    /// The library keeps them.
    pub integrals: RefCell<BTreeMap<*const Scheme, Integrals>>,
    /// The schemes of the derivatives of this limit, by their orders.
    pub derived: RefCell<BTreeMap<usize, Rc<Scheme>>>,
    /// The scheme of its integrals over intervals of length 1.
    pub antiderivative: OnceCell<Rc<Scheme>>,
    /// The same scheme with other numbers of its points, by the number of the point that becomes
    /// number 0.
    numbered: RefCell<BTreeMap<usize, Rc<Scheme>>>,
    /// Whether a symbol gives the mask, so that its first and its last column are not 0.
    of_symbol: bool,
    /// Whether it is a filter, and no scheme with limits.
    filter: bool,
    /// The same scheme without columns at both ends, by the number of the first one and that behind the last one.
    shortened: RefCell<BTreeMap<(usize, usize), Rc<Scheme>>>,
}

impl Scheme {
    /// The scheme of a mask.
    pub fn new(mask: Vec<Vec<Value>>, offset: i64) -> Result<Scheme, Stop> {
        Scheme::on(mask, offset, None)
    }

    /// The scheme of a mask on a piece, where the rules have to sum to 1.
    pub fn on(
        mask: Vec<Vec<Value>>,
        offset: i64,
        piece: Option<&Piece<'_>>,
    ) -> Result<Scheme, Stop> {
        check_size(&mask)?;
        for row in &mask {
            if !Value::total(row)?.minus(&Value::int(1))?.is_zero_on(piece)? {
                return Err(wrong("a rule does not sum to 1"));
            }
        }
        Scheme::of(mask, offset)
    }

    /// A filter, whose rules may have any sums.
    pub fn filter(mask: Vec<Vec<Value>>, offset: i64) -> Result<Scheme, Stop> {
        check_size(&mask)?;
        Ok(Scheme { filter: true, ..Scheme::of(mask, offset)? })
    }

    /// As [`new`](Self::new) for a mask of which this has been checked.
    fn of(mask: Vec<Vec<Value>>, offset: i64) -> Result<Scheme, Stop> {
        // b_{n−1,j} = a_{0,j} − Σ_{β<n−1} b_{β,j}
        let (mut difference, mut last) = (Vec::new(), mask[0].clone());
        for pair in mask.windows(2) {
            // b_{β,j} = Σ_{h≤j} (a_{β,h} − a_{β+1,h})
            let (mut sum, mut row) = (Value::int(0), Vec::new());
            for (j, rest) in last.iter_mut().enumerate() {
                sum = sum.plus(1, &pair[0][j])?.minus(&pair[1][j])?;
                *rest = rest.minus(&sum)?;
                row.push(sum.clone());
            }
            difference.push(row);
        }
        difference.push(last);
        let (limit, integrals, derived) = Default::default();
        let (antiderivative, numbered, of_symbol, shortened, filter) = Default::default();
        Ok(Scheme {
            mask,
            difference,
            offset,
            limit,
            integrals,
            derived,
            antiderivative,
            numbered,
            of_symbol,
            filter,
            shortened,
        })
    }

    /// The same scheme, whose mask is that of a symbol.
    pub fn of_symbol(self) -> Scheme {
        Scheme { of_symbol: true, ..self }
    }

    /// The scheme on a piece: the mask of a symbol has no columns at its ends that are 0 there.
    pub fn shortened(self: &Rc<Scheme>, piece: &Piece<'_>) -> Result<Rc<Scheme>, Stop> {
        let (mut first, mut end) = (0, self.width());
        while self.of_symbol && first + 1 < end && self.is_zero_in(first, piece)? {
            first += 1;
        }
        while self.of_symbol && first + 1 < end && self.is_zero_in(end - 1, piece)? {
            end -= 1;
        }
        if self.filter && end - first == 1 && self.is_zero_in(first, piece)? {
            return Err(Stop::Wrong("the symbol of a filter is 0".into()));
        }
        if end - first == self.width() {
            return Ok(Rc::clone(self));
        }
        if let Some(known) = self.shortened.borrow().get(&(first, end)) {
            return Ok(Rc::clone(known));
        }
        let mask = self.mask.iter().map(|row| row[first..end].to_vec()).collect();
        let offset = i64::try_from(first).ok().and_then(|by| self.offset.checked_add(by));
        let offset = offset.ok_or(Stop::Capped("the size of an offset"))?;
        let scheme = Rc::new(Scheme { filter: self.filter, ..Scheme::of(mask, offset)? });
        self.shortened.borrow_mut().insert((first, end), Rc::clone(&scheme));
        Ok(scheme)
    }

    /// Whether a column is 0 on a piece. A number that is not 0 tells it without a cut.
    fn is_zero_in(&self, column: usize, piece: &Piece<'_>) -> Result<bool, Stop> {
        let column = || self.mask.iter().map(|row| &row[column]);
        if column().any(|a| a.number().is_ok_and(|a| !a.is_zero())) {
            return Ok(false);
        }
        for a in column() {
            if !a.is_zero_on(Some(piece))? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// The scheme whose point i is the point i + `first` of this one, 0 ≤ `first` < n: rule α is
    /// rule α + `first` or, one place later, α + `first` − n.
    pub fn numbered_from(self: &Rc<Scheme>, first: usize) -> Result<Rc<Scheme>, Stop> {
        if first == 0 {
            return Ok(Rc::clone(self));
        }
        if let Some(known) = self.numbered.borrow().get(&first) {
            return Ok(Rc::clone(known));
        }
        let zero = || Value::int(0);
        let row = |alpha: usize| {
            let own = self.mask[(alpha + first) % self.arity()].iter().cloned();
            if alpha + first < self.arity() {
                own.chain([zero()]).collect()
            } else {
                [zero()].into_iter().chain(own).collect()
            }
        };
        let mask = (0..self.arity()).map(row).collect();
        let scheme = Rc::new(Scheme::of(mask, self.offset)?);
        self.numbered.borrow_mut().insert(first, Rc::clone(&scheme));
        Ok(scheme)
    }

    /// Checks that the mask has no symbols.
    pub fn numeric(&self) -> Result<(), Stop> {
        self.mask.iter().flatten().try_for_each(|a| a.number().map(|_| ()))
    }

    /// Whether it is a filter: it stands in few functions.
    pub fn is_filter(&self) -> bool {
        self.filter
    }

    /// The coefficients that are not 0, by ascending powers: a_k is a_{α,j} for k = α − n(o + j).
    pub fn coefficients(&self) -> Vec<(i64, Value)> {
        let n = i64::try_from(self.arity()).unwrap_or(0);
        let columns = (self.offset..).take(self.width()).zip(0..);
        let of = |(point, j): (i64, usize)| {
            let entry =
                move |(alpha, rule): (i64, &Vec<Value>)| (alpha - n * point, rule[j].clone());
            (0..).zip(&self.mask).map(entry)
        };
        let mut all: Vec<(i64, Value)> = columns.flat_map(of).collect();
        all.retain(|(_, value)| !value.is_zero());
        all.sort_by_key(|(k, _)| *k);
        all
    }

    /// The arity n.
    pub fn arity(&self) -> usize {
        self.mask.len()
    }

    /// The width N.
    pub fn width(&self) -> usize {
        self.mask[0].len()
    }
}

/// Checks the number and the lengths of rules.
fn check_size(mask: &[Vec<Value>]) -> Result<(), Stop> {
    let width = mask.first().map_or(0, Vec::len);
    let even = mask.iter().all(|row| row.len() == width);
    if mask.len() > MAX_ARITY.into() || width > MAX_WIDTH.into() {
        return Err(Stop::Capped("the number or the lengths of the rules of a mask"));
    }
    if mask.len() < 2 || width < 1 || !even {
        return Err(wrong("the number or the lengths of its rules are wrong"));
    }
    Ok(())
}

fn wrong(what: &str) -> Stop {
    Stop::Wrong(format!("`mask`: {what}"))
}
