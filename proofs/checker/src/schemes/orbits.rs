//! The orbits of the points of a ring, and the weights and edges between points.

use crate::formulas::{Expr, Head, Scope, formula};
use crate::numbers::Value;
use crate::text::{Stop, Toml};

/// The most points.
const MAX_POINTS: i64 = 201;

/// The greatest index of a point.
const MAX_INDEX: i64 = 1_000_000;

pub fn wrong(what: &str) -> Stop {
    Stop::Wrong(format!("a ring: {what}"))
}

/// The names of the orbits with the numbers of their points.
pub struct Orbits<'t>(Vec<(&'t str, i64)>);

impl<'t> Orbits<'t> {
    /// Reads `orbits`.
    pub fn read(table: &'t Toml, scope: &Scope<'_>) -> Result<Orbits<'t>, Stop> {
        let count = |(name, text): &'t (String, Toml)| {
            let count = scope.value(&formula(text.as_text().unwrap_or_default())?)?;
            Ok((name.as_str(), count.integer(MAX_POINTS)?))
        };
        let orbits: Vec<_> =
            table.entries("orbits").iter().map(count).collect::<Result<_, Stop>>()?;
        let points: i64 = orbits.iter().map(|(_, count)| *count).sum();
        if orbits.iter().any(|(_, count)| *count < 1) || !(2..=MAX_POINTS).contains(&points) {
            return Err(wrong("it does not have 2 to 201 points, or an orbit has none"));
        }
        Ok(Orbits(orbits))
    }

    fn points(&self) -> impl Iterator<Item = (&'t str, i64, i64)> {
        self.0.iter().flat_map(|&(name, count)| (0..count).map(move |i| (name, count, i)))
    }

    /// The names, with the numbers of points.
    pub fn counts(&self) -> Vec<(String, usize)> {
        let count = |(name, count): &(&str, i64)| {
            ((*name).to_owned(), usize::try_from(*count).unwrap_or(0))
        };
        self.0.iter().map(count).collect()
    }

    /// The names of all points.
    pub fn names(&self) -> Vec<String> {
        let name = |(name, count, i): (&str, i64, i64)| {
            if count == 1 { name.to_owned() } else { format!("{name}[{i}]") }
        };
        self.points().map(name).collect()
    }

    /// Reads `weights`. There is a row for each new point.
    pub fn weights(&self, table: &Toml, scope: &Scope<'_>) -> Result<Vec<Vec<Value>>, Stop> {
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

    /// Reads `edges`. In every family, i runs from 0 to the larger number of points less 1.
    pub fn edges(&self, table: &Toml, scope: &Scope<'_>) -> Result<Vec<[usize; 2]>, Stop> {
        let mut edges = Vec::new();
        for family in table.list("edges") {
            let Toml::List(ends) = family else {
                return Err(wrong("an edge does not have two ends"));
            };
            let end = |end: &Toml| self.end(end.as_text().unwrap_or_default());
            let ends = ends.iter().map(end).collect::<Result<Vec<_>, Stop>>()?;
            let [a, b] = &ends[..] else { return Err(wrong("an edge does not have two ends")) };
            for i in 0..a.count.max(b.count) {
                let edge @ [from, to] = [a.point(scope, i)?, b.point(scope, i)?];
                if !edges.contains(&edge) && !edges.contains(&[to, from]) {
                    edges.push(edge);
                }
            }
        }
        Ok(edges)
    }

    /// Reads an end such as `vertex` or `edge[i + 1]`.
    fn end(&self, text: &str) -> Result<End, Stop> {
        let expr = formula(text)?;
        let (name, index) = match &expr {
            Expr::Name(name) => (name, None),
            Expr::Of(Head::Member(name), index) if index.len() == 1 => {
                (name, index.first().cloned())
            }
            _ => return Err(wrong("an end of an edge is no point")),
        };
        let mut first = 0;
        for (known, count) in &self.0 {
            if known == name {
                return Ok(End { first, count: *count, index });
            }
            first += count;
        }
        Err(wrong("an end of an edge is no point"))
    }
}

/// An end of a family of edges. Its indices count modulo the number of points.
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
