//! Reading the orbits, weights and edges of a ring from TOML.

use super::formulas::{EdgeFormulas, End, LocalFormulas};
use crate::diagnostic::{Diagnostic, SourceText};
use crate::formula::{LocatedFormula, Node};
use crate::scheme::fields::{formula, identifier};
use crate::scheme::spanned::Spanned;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Formulas under their names, all with their places.
type FormulaTable = BTreeMap<Spanned<String>, Spanned<String>>;

/// The number of points of each orbit.
pub(in crate::scheme) type OrbitTable = Spanned<FormulaTable>;

/// For each orbit of new points, the weights of the orbits of old points.
pub(in crate::scheme) type WeightTable = BTreeMap<Spanned<String>, FormulaTable>;

/// Pairs of points.
pub(in crate::scheme) type EdgeTable = Spanned<Vec<Spanned<Vec<Spanned<String>>>>>;

/// Reads a ring. Its orbits keep the order of the file.
pub(in crate::scheme) fn ring(
    source: &Arc<SourceText>,
    orbits: &OrbitTable,
    weights: &WeightTable,
    edges: &EdgeTable,
) -> Result<LocalFormulas, Diagnostic> {
    let mut entries: Vec<_> = orbits.get_ref().iter().collect();
    entries.sort_by_key(|(name, _)| name.span().start);
    if entries.is_empty() {
        return Err(Diagnostic::new(source, orbits.span(), "a ring needs at least one orbit")
            .with_help("write orbits = { vertex = '1', edge = 'N' }"));
    }
    let orbit = |(name, count): (&Spanned<String>, &Spanned<String>)| {
        Ok((identifier(source, name)?, formula(source, count)?))
    };
    let orbits = entries.into_iter().map(orbit).collect::<Result<Vec<_>, Diagnostic>>()?;
    let reader = Reader { source, names: orbits.iter().map(|(name, _)| name.as_str()).collect() };
    let weights = reader.weights(weights)?;
    if edges.get_ref().is_empty() {
        return Err(Diagnostic::new(source, edges.span(), "a ring needs edges").with_help(EDGES));
    }
    let edges = edges.get_ref().iter().map(|edge| reader.edge(edge)).collect::<Result<_, _>>()?;
    Ok(LocalFormulas { orbits, weights, edges })
}

const EDGES: &str = "write edges = [['vertex', 'edge[i]'], ['edge[i]', 'face[i]']]: pairs of \
                     points of the orbits, for every i";

struct Reader<'a> {
    source: &'a Arc<SourceText>,
    names: Vec<&'a str>,
}

impl Reader<'_> {
    /// The number of the orbit called `name`.
    fn orbit(&self, name: &str, place: std::ops::Range<usize>) -> Result<usize, Diagnostic> {
        self.names.iter().position(|known| *known == name).ok_or_else(|| {
            let message = format!("no orbit is called `{name}`");
            let known = format!("the orbits are {}", self.names.join(", "));
            Diagnostic::new(self.source, place, message).with_help(known)
        })
    }

    fn weights(&self, table: &WeightTable) -> Result<Vec<Vec<Option<LocatedFormula>>>, Diagnostic> {
        let mut weights = vec![vec![None; self.names.len()]; self.names.len()];
        for (new, row) in table {
            let at = self.orbit(new.get_ref(), new.span())?;
            for (old, text) in row {
                let old = self.orbit(old.get_ref(), old.span())?;
                weights[at][old] = Some(formula(self.source, text)?);
            }
            if row.is_empty() {
                return Err(self.no_weights(new.get_ref(), new.span()));
            }
        }
        let missing = weights.iter().position(|row| row.iter().all(Option::is_none));
        match (missing, table.keys().next()) {
            (Some(orbit), Some(key)) => Err(self.no_weights(self.names[orbit], key.span())),
            (Some(orbit), None) => Err(self.no_weights(self.names[orbit], 0..0)),
            (None, _) => Ok(weights),
        }
    }

    fn no_weights(&self, orbit: &str, place: std::ops::Range<usize>) -> Diagnostic {
        let message = format!("there are no weights of the new points `{orbit}`");
        let help = format!(
            "write [weights.{orbit}] and under it, for orbits of old points, a formula in i and j: \
             the weight of old point j in new point i"
        );
        Diagnostic::new(self.source, place, message).with_help(help)
    }

    fn edge(&self, edge: &Spanned<Vec<Spanned<String>>>) -> Result<EdgeFormulas, Diagnostic> {
        let [first, second] = &edge.get_ref()[..] else {
            let message = format!("an edge has two ends, and this has {}", edge.get_ref().len());
            return Err(Diagnostic::new(self.source, edge.span(), message).with_help(EDGES));
        };
        let ends = [self.end(first)?, self.end(second)?];
        Ok(EdgeFormulas { ends, source: Arc::clone(self.source), span: edge.span() })
    }

    /// An end of an edge, such as `vertex` or `edge[i + 1]`.
    fn end(&self, text: &Spanned<String>) -> Result<End, Diagnostic> {
        let whole = formula(self.source, text)?;
        match &whole.expr.node {
            Node::Name(name) => Ok(End { orbit: self.orbit(name, text.span())?, index: None }),
            Node::Indexed { name, indices } if indices.len() == 1 => {
                let orbit = self.orbit(name, text.span())?;
                let index = LocatedFormula { expr: indices[0].clone(), ..whole };
                Ok(End { orbit, index: Some(index) })
            }
            _ => {
                let message = "an end of an edge is a point: an orbit and an index in i";
                Err(Diagnostic::new(self.source, text.span(), message).with_help(EDGES))
            }
        }
    }
}
