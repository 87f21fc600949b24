//! Rings: the points around an extraordinary vertex or face. Their rules depend on the valence.

use super::library::{Entry, Library};
use super::orbits::{Orbits, wrong};
use crate::formulas::{Scope, formulas};
use crate::numbers::{Meter, Value, unit};
use crate::text::Stop;
use std::cell::OnceCell;

/// The greatest level at which a contraction is looked for.
const MAX_BLOCK: usize = 32;

/// The names of a parameter that is a valence.
pub const VALENCE_NAMES: [&str; 2] = ["N", "n"];

/// A linear map of the points of a ring to the points of the next level.
pub struct LocalRules<'a> {
    meter: &'a Meter,
    /// The names `vertex`, `edge[0]`, `edge[1]`, … of the points.
    pub names: Vec<String>,
    /// The names of the orbits, with the numbers of their points.
    pub orbits: Vec<(String, usize)>,
    /// The matrix M of the m_{a,b} with `x'_a = Σ_b m_{a,b} x_b`.
    pub weights: Vec<Vec<Value>>,
    /// The edges of the mesh.
    pub edges: Vec<[usize; 2]>,
    contracts: OnceCell<Result<bool, Stop>>,
}

impl<'a> LocalRules<'a> {
    /// The ring that a reference such as `doo-sabin:n=5` names.
    pub fn new(
        library: &'a Library<'a>,
        reference: &str,
        scope: &Scope<'_>,
    ) -> Result<LocalRules<'a>, Stop> {
        LocalRules::of_valence(library, reference, scope, None)
    }

    /// The same; a valence is the value of the parameter `N`, or else `n`, that has none.
    pub fn of_valence(
        library: &'a Library<'a>,
        reference: &str,
        scope: &Scope<'_>,
        valence: Option<i64>,
    ) -> Result<LocalRules<'a>, Stop> {
        LocalRules::of_entry(library, library.entry(reference, scope)?, valence)
    }

    /// The same of a table with its parameters.
    pub fn of_entry(
        library: &'a Library<'a>,
        (name, table, mut parameters): Entry<'a>,
        valence: Option<i64>,
    ) -> Result<LocalRules<'a>, Stop> {
        if let Some(valence) = valence {
            let known = table.entries("parameters");
            let open = |name: &&str| {
                known.iter().any(|(known, _)| known == name) && !parameters.contains_key(*name)
            };
            let open = VALENCE_NAMES.into_iter().find(open);
            let open = open.ok_or_else(|| wrong("no parameter is its valence"))?;
            parameters.insert(open.to_owned(), Value::int(valence));
        }
        let definitions = formulas(table.entries("let"))?;
        let mut inner = library.scope(&definitions);
        inner.values = library.complete(name, table, parameters)?;
        let orbits = Orbits::read(table, &inner)?;
        let edges = orbits.edges(table, &inner)?;
        let (names, weights) = (orbits.names(), orbits.weights(table, &inner)?);
        let (meter, orbits) = (library.meter, orbits.counts());
        let contracts = OnceCell::new();
        let ring = LocalRules { meter, names, orbits, weights, edges, contracts };
        for row in &ring.weights {
            if Value::total(row)? != Value::int(1) {
                return Err(wrong("the weights of a point do not sum to 1"));
            }
        }
        if ring.tree().len() != ring.names.len() || ring.edges.iter().any(|[a, b]| a == b) {
            return Err(wrong("its edges do not connect all points, or an edge has one end"));
        }
        Ok(ring)
    }

    /// The refined points Mx.
    pub fn refined(&self, points: &[Value]) -> Result<Vec<Value>, Stop> {
        self.weights.iter().map(|row| self.combined(row.iter().zip(points))).collect()
    }

    /// The functional fM: f of the points of the next level, as a functional of the points.
    pub fn before(&self, f: &[Value]) -> Result<Vec<Value>, Stop> {
        let column = |b: usize| self.combined(self.weights.iter().map(|row| &row[b]).zip(f));
        (0..f.len()).map(column).collect()
    }

    /// The functional fM^k for each functional f.
    pub fn functionals_before(
        &self,
        functionals: Vec<Vec<Value>>,
        k: u32,
    ) -> Result<Vec<Vec<Value>>, Stop> {
        (0..k).try_fold(functionals, |functionals, _| {
            functionals.iter().map(|f| self.before(f)).collect()
        })
    }

    /// The functional e_a for every point a.
    pub fn units(&self) -> Vec<Vec<Value>> {
        unit(self.names.len(), [0, 1].map(Value::int))
    }

    /// The functional e_a − e_b for every edge (a, b).
    pub fn differences(&self) -> Result<Vec<Vec<Value>>, Stop> {
        let units = self.units();
        self.edges.iter().map(|&[a, b]| less(&units[a], &units[b])).collect()
    }

    /// The sum of the products of pairs.
    fn combined<'v>(
        &self,
        pairs: impl Iterator<Item = (&'v Value, &'v Value)>,
    ) -> Result<Value, Stop> {
        let term = |(weight, x): (&Value, &Value)| {
            self.meter.spend(weight.cost(x))?;
            weight.times(x)
        };
        Value::total(&pairs.map(term).collect::<Result<Vec<Value>, Stop>>()?)
    }

    /// Whether no weight is negative.
    pub fn averages(&self) -> Result<bool, Stop> {
        let zero = Value::int(0);
        for weight in self.weights.iter().flatten() {
            if weight.compare(&zero)?.is_lt() {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Whether an edge joins these points.
    pub fn has_edge(&self, a: usize, b: usize) -> bool {
        self.edges.contains(&[a, b]) || self.edges.contains(&[b, a])
    }

    /// Whether the point a of the next level is the point a itself.
    pub fn keeps(&self, a: usize) -> bool {
        let mut weights = self.weights[a].iter().enumerate();
        weights.all(|(b, weight)| *weight == Value::int(i64::from(a == b)))
    }

    /// Whether wM = w and Σw = 1.
    pub fn is_limit(&self, w: &[Value]) -> Result<bool, Stop> {
        if w.len() != self.names.len() || Value::total(w)? != Value::int(1) {
            return Ok(false);
        }
        let same = self.before(w)?.into_iter().zip(w).map(|(new, old)| new.equals(old));
        Ok(!same.collect::<Result<Vec<bool>, Stop>>()?.contains(&false))
    }

    /// The cost of a flow along the edges, and the functional g that it carries: each edge carries
    /// its flow from its second end to its first. If the differences along the edges are at most 1,
    /// |Σ_b g_b x_b| is at most the cost.
    pub fn carried(&self, flow: &[Value]) -> Result<(Value, Vec<Value>), Stop> {
        let mut carried = vec![Value::int(0); self.names.len()];
        let mut cost = Value::int(0);
        for (&[a, b], f) in self.edges.iter().zip(flow) {
            carried[a].add(1, f)?;
            carried[b].add(-1, f)?;
            cost.add(1, &f.abs(None)?)?;
        }
        Ok((cost, carried))
    }

    /// A spanning tree, from the first point on. Every other point comes with its predecessor.
    fn tree(&self) -> Vec<(usize, usize)> {
        let mut tree = vec![(0, 0)];
        let mut at = 0;
        while let Some(&(point, _)) = tree.get(at) {
            for &[a, b] in &self.edges {
                for (from, to) in [(a, b), (b, a)] {
                    if from == point && !tree.iter().any(|(known, _)| *known == to) {
                        tree.push((to, from));
                    }
                }
            }
            at += 1;
        }
        tree
    }

    /// Whether the largest difference along an edge is smaller c levels later than at first, for
    /// some c. Then all points of every ring tend to one number (THEOREMS.md, 20).
    pub fn contracts(&self) -> Result<bool, Stop> {
        self.contracts.get_or_init(|| self.contracts_once()).clone()
    }

    fn contracts_once(&self) -> Result<bool, Stop> {
        let tree = self.tree();
        // A functional f with the sum 0 is a sum of differences along the edges of the tree. The
        // factor of an edge is the sum of f beyond it.
        let bound = |f: &Vec<Value>| {
            let (mut beyond, mut sum) = (f.clone(), Value::int(0));
            for &(point, before) in tree[1..].iter().rev() {
                let flow = beyond[point].clone();
                sum = sum.plus(1, &flow.abs(None)?)?;
                beyond[before] = beyond[before].plus(1, &flow)?;
            }
            Ok(sum.compare(&Value::int(1))?.is_lt())
        };
        let mut differences = self.differences()?;
        for _ in 0..MAX_BLOCK {
            differences = self.functionals_before(differences, 1)?;
            if !differences.iter().map(bound).collect::<Result<Vec<bool>, Stop>>()?.contains(&false)
            {
                return Ok(true);
            }
        }
        Ok(false)
    }
}

/// f − g.
pub fn less(f: &[Value], g: &[Value]) -> Result<Vec<Value>, Stop> {
    f.iter().zip(g).map(|(x, y)| x.minus(y)).collect()
}
