//! Schemes of the tables that give their masks, also by symbols in which other schemes stand.

use super::lattice::is_lattice;
use super::library::{Library, MAX_ALIASES, is_filter, wrong};
use super::scheme::{MAX_ARITY, MAX_OFFSET, MAX_WIDTH, Scheme};
use super::symbol::Other;
use super::{symbol, typed};
use crate::formulas::{Indices, Scope, formula, formulas};
use crate::numbers::Value;
use crate::text::{Stop, Toml};
use std::cell::Cell;
use std::collections::BTreeMap;
use std::rc::Rc;

/// Masks with such roots.
pub const ROOTS: Stop = Stop::Capped("a mask with roots that lie in no field of cosines");

/// What finds another scheme for a symbol, with its address.
pub(super) type Find<'f, P> = dyn Fn(&str, &Scope<'_>) -> Result<(Other<P>, *const ()), Stop> + 'f;

impl Library<'_> {
    /// The scheme, with these parameters, whose symbol stands in that of the scheme `of`. Chains of such schemes are as short as those of names,
    /// whatever schemes are known already.
    pub(super) fn other<P>(
        &self,
        (of, name): (&str, &str),
        parameters: Indices,
        longest: &Cell<usize>,
        find: &Find<'_, P>,
    ) -> Result<Other<P>, Stop> {
        let place = |name: &str| self.own.get(name);
        if place(name).is_some_and(|other| place(of).is_none_or(|own| own <= other)) {
            return wrong(of, "a scheme in its symbol does not stand before it");
        }
        let chain = Stop::Capped("the schemes in whose symbols others stand");
        let depth = self.composing.get();
        if depth == MAX_ALIASES {
            return Err(chain);
        }
        self.composing.set(depth + 1);
        let mut scope = self.closed();
        let given = parameters.iter().map(|(name, _)| format!("{name}={name}"));
        let given = given.collect::<Vec<String>>().join(",");
        scope.values.extend(parameters);
        let found = find(&format!("{name}:{given}"), &scope);
        self.composing.set(depth);
        let (found, address) = found?;
        let length = 1 + self.composed.borrow().get(&address).copied().unwrap_or(0);
        if length > MAX_ALIASES {
            return Err(chain);
        }
        longest.set(longest.get().max(length));
        Ok(found)
    }

    /// Another scheme that is a mask of curves.
    pub(super) fn curve<P>(
        &self,
        reference: &str,
        scope: &Scope<'_>,
    ) -> Result<(Other<P>, *const ()), Stop> {
        match self.resolve_any(reference, scope)?.into_iter().next() {
            Some(scheme) => {
                let address = Rc::as_ptr(&scheme).cast();
                Ok((Other::Curve(scheme), address))
            }
            None => wrong(reference, "there is no such scheme"),
        }
    }

    /// The scheme of a table, with these parameters.
    pub(super) fn scheme(
        &self,
        name: &str,
        table: &Toml,
        parameters: BTreeMap<String, Value>,
    ) -> Result<Rc<Scheme>, Stop> {
        self.of_table(name, table, parameters).map_err(|stop| match stop {
            Stop::OtherRoot => ROOTS,
            stop => stop,
        })
    }

    fn of_table(
        &self,
        name: &str,
        table: &Toml,
        parameters: BTreeMap<String, Value>,
    ) -> Result<Rc<Scheme>, Stop> {
        if is_lattice(table) {
            return wrong(name, "a mask on Z^d stands in few functions, and not here");
        }
        let parameters = self.complete(name, table, parameters)?;
        let key = format!("{name} {parameters:?}");
        if let Some(known) = self.schemes.borrow().get(&key) {
            return Ok(Rc::clone(known));
        }
        let (longest, filter) = (Cell::new(0), is_filter(name, table)?);
        let definitions = formulas(table.entries("let"))?;
        let mut scope = self.scope(&definitions);
        scope.values = parameters;
        let integer = |key: &str, most: i64| match table.text(key) {
            Some(text) => scope.value(&formula(text)?)?.integer(most),
            None => wrong(name, "`mask` or `entry` is missing"),
        };
        let offset = if table.get("offset").is_some() { integer("offset", MAX_OFFSET)? } else { 0 };
        let whole = match (table.text("mask"), table.text("symbol")) {
            (None, None) => None,
            _ if table.get("offset").is_some() => {
                return wrong(name, "a mask in one text has its offset");
            }
            (Some(text), None) => Some(typed::mask(text, &scope)?),
            (None, Some(text))
                if ["mask", "width", "entry"].iter().all(|key| table.get(key).is_none()) =>
            {
                let other = |other: &str, with: Indices| {
                    self.other((name, other), with, &longest, &|reference, scope| {
                        self.curve(reference, scope)
                    })
                };
                let arity = table.text("arity").or(filter.then_some("2"));
                Some(symbol::mask(text, arity, &scope, &other)?)
            }
            _ => return wrong(name, "its mask is given twice"),
        };
        if let Some((offset, mask)) = whole {
            let scheme =
                if filter { Scheme::filter(mask, offset)? } else { Scheme::new(mask, offset)? };
            let of_symbol = table.get("symbol").is_some();
            let scheme = Rc::new(if of_symbol { scheme.of_symbol() } else { scheme });
            self.composed.borrow_mut().insert(Rc::as_ptr(&scheme).cast(), longest.get());
            self.schemes.borrow_mut().insert(key, Rc::clone(&scheme));
            return Ok(scheme);
        }
        let mask: Result<Vec<Vec<Value>>, Stop> = if table.get("mask").is_some() {
            let entry = |entry: &Toml| scope.value(&formula(entry.as_text().unwrap_or(""))?);
            let rows = table.list("mask").iter();
            rows.map(|row| row.as_list().iter().map(entry).collect()).collect()
        } else {
            let (arity, width) =
                (integer("arity", MAX_ARITY.into())?, integer("width", MAX_WIDTH.into())?);
            let entry = formula(table.text("entry").unwrap_or(""))?;
            let at = |alpha, r| {
                let indices = [("alpha", alpha), ("r", r)];
                let indices = indices.map(|(name, i)| (name.to_owned(), Value::int(i)));
                scope.evaluate(&entry, &mut indices.to_vec())
            };
            (0..arity).map(|alpha| (0..width).map(|r| at(alpha, r)).collect()).collect()
        };
        let scheme = Rc::new(Scheme::new(mask?, offset)?);
        self.schemes.borrow_mut().insert(key, Rc::clone(&scheme));
        Ok(scheme)
    }
}
