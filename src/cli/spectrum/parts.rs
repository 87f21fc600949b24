//! Eigenvalues, and the weights of stencils.

use crate::cli::console::quantity::{Number, Orbit};
use serde::Serialize;
use std::collections::BTreeMap;
use subcert::report::Grid;
use subcert::spectrum;

/// The most weights of an orbit that the text shows.
const SHOWN_WEIGHTS: usize = 12;

/// An eigenvalue.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct Eigenvalue {
    /// The value; the real part of a pair of complex eigenvalues.
    #[serde(flatten)]
    value: Number,
    /// The positive imaginary part y of a pair x ± iy; absent for a real eigenvalue.
    #[serde(skip_serializing_if = "Option::is_none")]
    imaginary: Option<Number>,
    /// The algebraic multiplicity, of each of a pair.
    multiplicity: usize,
    /// The Fourier blocks, each as often as it has the eigenvalue.
    block: Vec<usize>,
}

/// The weight of a point.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct Weight {
    /// The point, such as `edge[3]`.
    point: String,
    /// The weight.
    #[serde(flatten)]
    weight: Number,
}

impl Eigenvalue {
    pub(crate) fn all(eigenvalues: &[spectrum::Eigenvalue]) -> Vec<Eigenvalue> {
        let eigenvalue = |one: &spectrum::Eigenvalue| Eigenvalue {
            value: (&one.real).into(),
            imaginary: one.imaginary.as_ref().map(Number::from),
            multiplicity: one.multiplicity,
            block: one.blocks.clone(),
        };
        eigenvalues.iter().map(eigenvalue).collect()
    }
}

/// The weights of points by their names.
pub(crate) fn weights<'v, V>(weights: &'v [V], name: impl Fn(usize) -> String) -> Vec<Weight>
where
    Number: From<&'v V>,
{
    let weight = |(point, weight)| Weight { point: name(point), weight: Number::from(weight) };
    weights.iter().enumerate().map(weight).collect()
}

/// A line for each orbit whose weights are not all 0; one weight where all are equal.
pub(crate) fn orbit_facts(
    orbits: &[Orbit],
    what: &str,
    weights: &[Weight],
    facts: &mut Vec<(String, String)>,
) {
    let mut rest = weights;
    for orbit in orbits {
        let (these, others) = rest.split_at(orbit.count);
        rest = others;
        if these.iter().all(|one| one.weight.is_zero()) {
            continue;
        }
        let text = if these.windows(2).all(|pair| pair[0].weight == pair[1].weight) {
            let each = if orbit.count > 1 { "each " } else { "" };
            format!("{each}{}", these[0].weight.words())
        } else {
            let shown = these.iter().take(SHOWN_WEIGHTS).map(|one| one.weight.short(8));
            let shown = shown.collect::<Vec<String>>().join("  ");
            let more = if orbit.count > SHOWN_WEIGHTS { "  …" } else { "" };
            format!("{shown}{more}")
        };
        facts.push((format!("{what}, {}", orbit.name), text));
    }
}

pub(crate) fn eigenvalue_grid(eigenvalues: &[Eigenvalue]) -> Grid {
    let rows = eigenvalues.iter().map(|one| {
        let [decimal, exact] = eigenvalue_texts(one);
        vec![decimal, exact, one.multiplicity.to_string(), blocks_text(&one.block)]
    });
    Grid::of(["value", "exact", "multiplicity", "blocks"], rows, 2)
}

/// The decimal and the exact value; the latter is empty where it is the decimal or long.
fn eigenvalue_texts(one: &Eigenvalue) -> [String; 2] {
    let Some(imaginary) = &one.imaginary else {
        let (decimal, exact) = (one.value.short(12), one.value.to_string());
        let exact = if exact.len() > 60 { "in --format json".to_owned() } else { exact };
        return [decimal, exact];
    };
    let decimal = format!("{} ± {}i", one.value.short(12), imaginary.short(12));
    [decimal, "in --format json".to_owned()]
}

/// The blocks: runs of neighbours that have the eigenvalue equally often, as `0–4 (2 each), 7`.
pub(super) fn blocks_text(blocks: &[usize]) -> String {
    let mut counts: BTreeMap<usize, usize> = BTreeMap::new();
    for block in blocks {
        *counts.entry(*block).or_default() += 1;
    }
    let mut runs: Vec<(usize, usize, usize)> = Vec::new();
    for (block, count) in counts {
        match runs.last_mut().filter(|(_, last, times)| last + 1 == block && *times == count) {
            Some((_, last, _)) => *last = block,
            None => runs.push((block, block, count)),
        }
    }
    let text = |(first, last, count): &(usize, usize, usize)| {
        let times = match (count, first == last) {
            (1, _) => String::new(),
            (count, true) => format!(" ({count})"),
            (count, false) => format!(" ({count} each)"),
        };
        match last - first {
            0 => format!("{first}{times}"),
            1 if *count == 1 => format!("{first}, {last}"),
            _ => format!("{first}–{last}{times}"),
        }
    };
    runs.iter().map(text).collect::<Vec<String>>().join(", ")
}
