//! Reading masks on Z^d: from files, and typed.

use super::dilation::{Dilation, Point};
use super::formulas::{LatticeCoefficients, LatticeFormulas};
use super::integers::{Vectors, padded};
use crate::diagnostic::{Diagnostic, SourceText};
use crate::formula::{FreeNames, LATTICE_VARIABLES, LocatedFormula};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::sync::Arc;

/// What is stated of a mask on Z^d beside its coefficients.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(in crate::scheme) struct Stated {
    /// M.
    pub(in crate::scheme) dilation: Option<Vectors>,
    /// The edges.
    pub(in crate::scheme) edges: Option<Vectors>,
    /// The indices of the coefficient at 0 in lists of lists.
    pub(in crate::scheme) origin: Option<Vectors>,
}

/// The names of what is stated.
pub(in crate::scheme) const DILATION: &str = "dilation";
pub(in crate::scheme) const EDGES: &str = "edges";
pub(in crate::scheme) const ORIGIN: &str = "origin";
pub(in crate::scheme) const STATED: [&str; 3] = [DILATION, EDGES, ORIGIN];

impl Stated {
    pub(in crate::scheme) fn is_empty(&self) -> bool {
        *self == Stated::default()
    }

    /// The dilation, 2I where none is stated, and the edges.
    fn common(
        &self,
        source: &Arc<SourceText>,
        span: &Range<usize>,
        dimension: usize,
    ) -> Result<(Dilation, Vec<Point>), Diagnostic> {
        let dilation = match &self.dilation {
            None => Dilation::scalar(2, dimension)
                .map_err(|error| Diagnostic::new(source, span.clone(), error.to_string()))?,
            Some(rows) => {
                Dilation::new(&rows.rows).map_err(|error| rows.error(error.to_string()))?
            }
        };
        if let Some(rows) = self.dilation.as_ref().filter(|rows| rows.rows.len() != dimension) {
            let found = rows.rows.len();
            return Err(rows.error(format!(
                "a dilation matrix of {found} rows for a mask in {dimension} dimensions"
            )));
        }
        let edges = self.edges.as_ref().map(|edges| edges.points(dimension));
        Ok((dilation, edges.transpose()?.unwrap_or_default()))
    }

    /// The mask with this symbol in x, y and z. It has three variables if z is among them.
    ///
    /// # Errors
    /// When the text is no formula, or the dilation or the edges have another dimension.
    pub(in crate::scheme) fn symbol(
        &self,
        source: &Arc<SourceText>,
        span: Range<usize>,
        text: &str,
        definitions: &BTreeMap<String, LocatedFormula>,
    ) -> Result<LatticeFormulas, Diagnostic> {
        let formula = LocatedFormula::read(source, span.clone(), text).map_err(|error| {
            error.with_help(
                "write products with `*` and powers with `^`: (1 + x)^2*(1 + y)^2*(1 + x*y)^2/16",
            )
        })?;
        let indices = formula.expr.indices();
        if let Some(name) = LATTICE_VARIABLES.into_iter().find(|name| indices.contains(*name)) {
            let message = format!("`{name}` is a variable of the symbol, and no index");
            return Err(Diagnostic::new(source, span, message)
                .with_help("take another name for the index of the sum"));
        }
        self.refuse_origin()?;
        let names = FreeNames::new(definitions).of(&formula.expr);
        let of_dilation = self.dilation.as_ref().map(|rows| rows.rows.len());
        let dimension =
            of_dilation.unwrap_or(if names.contains(LATTICE_VARIABLES[2]) { 3 } else { 2 });
        let (dilation, edges) = self.common(source, &span, dimension)?;
        let coefficients = LatticeCoefficients::Symbol(Box::new(formula));
        Ok(LatticeFormulas { dilation, edges, coefficients, source: Arc::clone(source), span })
    }

    /// The mask with these coefficients, whose indices are given. The coefficient at 0 is that at `origin`, or the one in the middle.
    ///
    /// # Errors
    /// When the dilation, the edges or the origin have another dimension.
    pub(in crate::scheme) fn listed(
        &self,
        source: &Arc<SourceText>,
        span: Range<usize>,
        list: Vec<(Vec<i64>, LocatedFormula)>,
    ) -> Result<LatticeFormulas, Diagnostic> {
        let dimension = list.first().map_or(0, |(at, _)| at.len());
        let (dilation, edges) = self.common(source, &span, dimension)?;
        let last = |axis: usize| list.iter().map(|(at, _)| at[axis]).max().unwrap_or(0);
        let middle = || (0..dimension).map(|axis| last(axis) / 2).collect();
        let stated = self.origin.as_ref().map(|stated| match &stated.rows[..] {
            [origin] if origin.len() == dimension => Ok(origin.clone()),
            _ => Err(stated
                .error(format!("the origin is one vector of {dimension} indices, counted from 0"))),
        });
        let origin: Vec<i64> = stated.transpose()?.unwrap_or_else(middle);
        let place = |at: &Vec<i64>| {
            padded(&at.iter().zip(&origin).map(|(i, o)| i - o).collect::<Vec<i64>>())
        };
        let all = list.into_iter().map(|(at, formula)| (place(&at), formula)).collect();
        let coefficients = LatticeCoefficients::Listed(all);
        Ok(LatticeFormulas { dilation, edges, coefficients, source: Arc::clone(source), span })
    }

    /// The box spline with these directions.
    ///
    /// # Errors
    /// When the dilation or the edges have another dimension.
    pub(in crate::scheme) fn box_spline(
        &self,
        source: &Arc<SourceText>,
        directions: &Vectors,
    ) -> Result<LatticeFormulas, Diagnostic> {
        self.refuse_origin()?;
        let (span, dimension) = (directions.span.clone(), directions.rows[0].len());
        let (dilation, edges) = self.common(source, &span, dimension)?;
        let coefficients = LatticeCoefficients::Directions(directions.points(dimension)?);
        Ok(LatticeFormulas { dilation, edges, coefficients, source: Arc::clone(source), span })
    }

    fn refuse_origin(&self) -> Result<(), Diagnostic> {
        self.origin.as_ref().map_or(Ok(()), |origin| {
            let message = "`origin` is the place of the coefficient at 0 in lists of lists";
            Err(origin
                .error(message)
                .with_help("leave it out; a factor such as x^-1*y^-1 shifts a symbol"))
        })
    }
}

/// Whether a formula has a variable that makes it the symbol of a mask on Z^d: x or y, unless this is `known` as another name.
pub(in crate::scheme) fn has_lattice_variable(
    names: &BTreeSet<String>,
    known: impl Fn(&str) -> bool,
) -> bool {
    LATTICE_VARIABLES[..2].iter().any(|name| names.contains(*name) && !known(name))
}
