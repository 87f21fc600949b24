//! Rings: points around an extraordinary vertex or face, with rules that depend on their number.

use crate::evaluate::Scope;
use crate::formula::{Expr, Head};
use crate::reject::Stop;
use crate::scheme::{Library, formula, formulas, total};
use crate::toml::Toml;
use crate::value::Value;
use std::cell::OnceCell;

/// The most points.
const MAX_POINTS: i64 = 100;

/// The most levels after which differences are looked at.
const MAX_BLOCK: usize = 32;

/// The greatest index of a point.
const MAX_INDEX: i64 = 1_000_000;

/// v points, and the v points of the next level.
pub struct Ring<'a> {
    library: &'a Library<'a>,
    /// `vertex`, `edge[0]`, `edge[1]`, …
    pub names: Vec<String>,
    /// m_{a,b}: x'_a = Σ_b m_{a,b} x_b.
    pub weights: Vec<Vec<Value>>,
    /// The edges of the mesh.
    pub edges: Vec<[usize; 2]>,
    contracts: OnceCell<Result<bool, Stop>>,
}

fn wrong(what: &str) -> Stop {
    Stop::Wrong(format!("a ring: {what}"))
}

impl<'a> Ring<'a> {
    /// The ring that a reference such as `doo-sabin:n=5` names.
    pub fn new(
        library: &'a Library<'a>,
        reference: &str,
        scope: &Scope<'_>,
    ) -> Result<Ring<'a>, Stop> {
        let (name, table, parameters) = library.entry(reference, scope)?;
        let definitions = formulas(table.entries("let"))?;
        let mut inner = Scope::new(&definitions, library, &library.as_printed);
        inner.values = library.complete(name, table, parameters)?;
        let orbits = Orbits::read(table, &inner)?;
        let edges = orbits.edges(table, &inner)?;
        let (names, weights) = (orbits.names(), orbits.weights(table, &inner)?);
        let ring = Ring { library, names, weights, edges, contracts: OnceCell::new() };
        for row in &ring.weights {
            if total(row)? != Value::int(1) {
                return Err(wrong("the weights of a point do not sum to 1"));
            }
        }
        if ring.tree().len() != ring.names.len() || ring.edges.iter().any(|[a, b]| a == b) {
            return Err(wrong("its edges do not connect it"));
        }
        Ok(ring)
    }

    /// Mx.
    pub fn refined(&self, points: &[Value]) -> Result<Vec<Value>, Stop> {
        self.weights.iter().map(|row| self.combined(row.iter().zip(points))).collect()
    }

    /// fM, the functional of the points that f is of those of the next level.
    pub fn before(&self, f: &[Value]) -> Result<Vec<Value>, Stop> {
        let column = |b: usize| self.combined(self.weights.iter().map(|row| &row[b]).zip(f));
        (0..f.len()).map(column).collect()
    }

    /// fM^k for each functional f.
    pub fn functionals_before(
        &self,
        functionals: Vec<Vec<Value>>,
        k: u32,
    ) -> Result<Vec<Vec<Value>>, Stop> {
        (0..k).try_fold(functionals, |functionals, _| {
            functionals.iter().map(|f| self.before(f)).collect()
        })
    }

    /// e_a for every point a.
    pub fn units(&self) -> Vec<Vec<Value>> {
        let points = 0..self.names.len();
        let unit = |a| points.clone().map(|b| Value::int(i64::from(a == b))).collect();
        points.clone().map(unit).collect()
    }

    /// e_a − e_b for every edge (a, b).
    pub fn differences(&self) -> Result<Vec<Vec<Value>>, Stop> {
        let units = self.units();
        self.edges.iter().map(|&[a, b]| less(&units[a], &units[b])).collect()
    }

    /// The sum of products.
    fn combined<'v>(
        &self,
        pairs: impl Iterator<Item = (&'v Value, &'v Value)>,
    ) -> Result<Value, Stop> {
        let term = |(weight, x): (&Value, &Value)| {
            self.library.spend(weight.cost(x))?;
            weight.times(x)
        };
        total(&pairs.map(term).collect::<Result<Vec<Value>, Stop>>()?)
    }

    /// Whether an edge joins these points.
    pub fn has_edge(&self, a: usize, b: usize) -> bool {
        self.edges.contains(&[a, b]) || self.edges.contains(&[b, a])
    }

    /// Whether the point a of a level is that of the level before.
    pub fn keeps(&self, a: usize) -> bool {
        let mut weights = self.weights[a].iter().enumerate();
        weights.all(|(b, weight)| *weight == Value::int(i64::from(a == b)))
    }

    /// Whether wM = w and Σw = 1.
    pub fn is_limit(&self, w: &[Value]) -> Result<bool, Stop> {
        if w.len() != self.names.len() || total(w)? != Value::int(1) {
            return Ok(false);
        }
        let same = self.before(w)?.into_iter().zip(w).map(|(new, old)| new.equals(old));
        Ok(!same.collect::<Result<Vec<bool>, Stop>>()?.contains(&false))
    }

    /// Of a flow along the edges, what it costs, and what it carries to the first end of each, away
    /// from the second: |Σ_b g_b x_b| is at most the cost, where it carries g and the differences
    /// along the edges are 1 at most.
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

    /// A tree of edges: each point but the first with one before it, from the first point on.
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
        // f with the sum 0 is a sum of differences along the edges of the tree, each times
        // what f has beyond that edge.
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

/// The kinds of points with their numbers.
struct Orbits<'t>(Vec<(&'t str, i64)>);

impl<'t> Orbits<'t> {
    fn read(table: &'t Toml, scope: &Scope<'_>) -> Result<Orbits<'t>, Stop> {
        let count = |(name, text): &'t (String, Toml)| {
            let count = scope.value(&formula(text.as_text().unwrap_or_default())?)?;
            Ok((name.as_str(), count.integer(MAX_POINTS)?))
        };
        let orbits: Vec<_> =
            table.entries("orbits").iter().map(count).collect::<Result<_, Stop>>()?;
        let points: i64 = orbits.iter().map(|(_, count)| *count).sum();
        if orbits.iter().any(|(_, count)| *count < 1) || !(2..=MAX_POINTS).contains(&points) {
            return Err(wrong("its orbits have from 2 to 100 points together, each one at least"));
        }
        Ok(Orbits(orbits))
    }

    fn points(&self) -> impl Iterator<Item = (&'t str, i64, i64)> {
        self.0.iter().flat_map(|&(name, count)| (0..count).map(move |i| (name, count, i)))
    }

    fn names(&self) -> Vec<String> {
        let name = |(name, count, i): (&str, i64, i64)| {
            if count == 1 { name.to_owned() } else { format!("{name}[{i}]") }
        };
        self.points().map(name).collect()
    }

    fn weights(&self, table: &Toml, scope: &Scope<'_>) -> Result<Vec<Vec<Value>>, Stop> {
        let nothing = Toml::Table(Vec::new());
        let of_new = table.get("weights").unwrap_or(&nothing);
        let mut rows = Vec::new();
        for (new, _, i) in self.points() {
            let mut row = Vec::new();
            for (old, _, j) in self.points() {
                let text = of_new.get(new).and_then(|of_old| of_old.text(old));
                row.push(match text {
                    Some(text) => at(scope, &formula(text)?, &[("i", i), ("j", j)])?,
                    None => Value::int(0),
                });
            }
            rows.push(row);
        }
        Ok(rows)
    }

    /// The edges of every family, i from 0 to the larger number of points less 1.
    fn edges(&self, table: &Toml, scope: &Scope<'_>) -> Result<Vec<[usize; 2]>, Stop> {
        let mut edges = Vec::new();
        for family in table.list("edges") {
            let Toml::List(ends) = family else { return Err(wrong("an edge has two ends")) };
            let end = |end: &Toml| self.end(end.as_text().unwrap_or_default());
            let ends = ends.iter().map(end).collect::<Result<Vec<_>, Stop>>()?;
            let [a, b] = &ends[..] else { return Err(wrong("an edge has two ends")) };
            for i in 0..a.count.max(b.count) {
                let edge @ [from, to] = [a.point(scope, i)?, b.point(scope, i)?];
                if !edges.contains(&edge) && !edges.contains(&[to, from]) {
                    edges.push(edge);
                }
            }
        }
        Ok(edges)
    }

    /// `vertex` or `edge[i + 1]`.
    fn end(&self, text: &str) -> Result<End, Stop> {
        let expr = formula(text)?;
        let (name, index) = match &expr {
            Expr::Name(name) => (name, None),
            Expr::Of(Head::Member(name), index) if index.len() == 1 => {
                (name, index.first().cloned())
            }
            _ => return Err(wrong("an end of an edge is a point")),
        };
        let mut first = 0;
        for (known, count) in &self.0 {
            if known == name {
                return Ok(End { first, count: *count, index });
            }
            first += count;
        }
        Err(wrong("an end of an edge is a point"))
    }
}

/// An end of a family of edges: indices count mod the number of points.
struct End {
    first: i64,
    count: i64,
    index: Option<Expr>,
}

impl End {
    fn point(&self, scope: &Scope<'_>, i: i64) -> Result<usize, Stop> {
        let index = match &self.index {
            Some(index) => at(scope, index, &[("i", i)])?.integer(MAX_INDEX)?,
            None => 0,
        };
        Ok(usize::try_from(self.first + index.rem_euclid(self.count)).unwrap_or(0))
    }
}

fn at(scope: &Scope<'_>, expr: &Expr, indices: &[(&str, i64)]) -> Result<Value, Stop> {
    let index = |(name, i): &(&str, i64)| ((*name).to_owned(), Value::int(*i));
    scope.evaluate(expr, &mut indices.iter().map(index).collect())
}
