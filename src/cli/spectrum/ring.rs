//! `subcert spectrum`.

use crate::cli::arguments::SpectrumArguments;
use crate::cli::console::output::{Failure, Outcome, show, with_decimal};
use crate::cli::console::progress::Progress;
use crate::cli::json::{SCHEMA, spectrum as form};
use std::collections::BTreeMap;
use std::fmt::Display;
use std::sync::Arc;
use std::sync::atomic::AtomicU64;
use subcert::exact::{Enclosed, Scalar as _, format::short};
use subcert::report::{Grid, Sheet, json::Exact};
use subcert::scheme::{LocalRules, Orbit};
use subcert::spectrum::{
    Curvature, Eigenvalue, Spectrum, SpectrumError, Surroundings, surroundings,
};

/// What the conditions leave open.
const NECESSARY: &str = "These conditions on eigenvalues are necessary only: for a C^1 surface the characteristic map must be \
     regular and injective too, which `subcert smoothness` decides.";

/// The most weights of an orbit that the text shows.
const SHOWN_WEIGHTS: usize = 12;

pub(crate) fn spectrum(arguments: &SpectrumArguments) -> Outcome {
    let rings = surroundings(&arguments.scheme, arguments.valence)
        .map_err(|error| failure_without_valence(error, "--valence 5"))?;
    let progress = Progress::of_spectra(Arc::new(AtomicU64::new(0)), 1, true);
    let spectrum = rings.spectrum().map_err(failure)?;
    drop(progress);
    let report = Report { name: &arguments.scheme, rings, spectrum };
    show(&arguments.output, || report.sheet(), || report.form())
}

pub(crate) fn failure(error: SpectrumError) -> Failure {
    match error {
        SpectrumError::Scheme(error) => Failure::from(error),
        other => Failure::Input(other.to_string()),
    }
}

/// The failure, with the flag that gives a valence, if that is what is missing.
pub(crate) fn failure_without_valence(error: SpectrumError, flag: &str) -> Failure {
    match error {
        SpectrumError::Scheme(error) if error.asks_for_valence() => {
            Failure::Input(format!("{error}, or give the valence apart: `{flag}`"))
        }
        other => failure(other),
    }
}

struct Report<'a> {
    name: &'a str,
    rings: Surroundings,
    spectrum: Spectrum,
}

impl Report<'_> {
    fn neighbourhood(&self) -> &LocalRules {
        self.rings.wider.as_ref().unwrap_or(&self.rings.ring)
    }

    fn sheet(&self) -> Sheet {
        let mut sheet = Sheet::default();
        let Spectrum { order, .. } = self.spectrum;
        sheet.heading(1, format!("{}, valence {order}", self.name));
        sheet.heading(2, "Eigenvalues");
        let points = orbits_text(self.neighbourhood().orbits());
        sheet.facts(vec![("of the points".to_owned(), points)]);
        sheet.grid(eigenvalue_grid(&self.spectrum.eigenvalues));
        sheet.heading(2, "Conditions");
        sheet.facts(self.conditions());
        sheet.text(NECESSARY);
        sheet.heading(2, "Stencils");
        sheet.facts(self.stencils());
        if self.spectrum.tangents.is_some() {
            sheet.text("The cross product of tangent 1 and tangent 2 is a normal.");
        }
        sheet
    }

    fn conditions(&self) -> Vec<(String, String)> {
        let found = &self.spectrum.conditions;
        let yes = |holds: bool| if holds { "yes" } else { "no" }.to_owned();
        let mut facts = vec![("1 is simple and dominant".to_owned(), yes(found.simple_one))];
        let what = "λ is double, of the blocks 1 and n − 1, and above all that follow".to_owned();
        match &found.subdominant {
            Some(value) => facts.push((what, format!("yes: λ = {}", with_decimal(value)))),
            None => facts.push((what, yes(false))),
        }
        if let (Some(next), Some(curvature), Some(value)) =
            (&found.next, found.curvature, &found.subdominant)
        {
            let square = value.times(value);
            let text = match curvature {
                Curvature::Bounded => format!("bounded: μ = λ² = {}", with_decimal(next)),
                Curvature::Growing => format!(
                    "unbounded in general, slowly: μ = λ² = {} has a Jordan block of size {}",
                    with_decimal(next),
                    found.longest(|_| true, next).unwrap_or(2)
                ),
                Curvature::Vanishing => format!(
                    "tends to 0: μ = {} is below λ² = {}",
                    short(next, 12),
                    short(&square, 12)
                ),
                Curvature::Unbounded => format!(
                    "unbounded in general: μ = {} is above λ² = {}",
                    short(next, 12),
                    short(&square, 12)
                ),
            };
            facts.push(("curvature".to_owned(), text));
        }
        facts
    }

    fn stencils(&self) -> Vec<(String, String)> {
        let mut facts = Vec::new();
        let orbits = self.rings.ring.orbits();
        match &self.spectrum.limit {
            Some(limit) => orbit_facts(orbits, "limit", limit, &mut facts),
            None => facts.push(("limit".to_owned(), "none: 1 is not simple".to_owned())),
        }
        match &self.spectrum.tangents {
            Some(tangents) => {
                for (number, tangent) in tangents.iter().enumerate() {
                    let name = format!("tangent {}", number + 1);
                    orbit_facts(orbits, &name, tangent, &mut facts);
                }
            }
            None => facts.push(("tangents".to_owned(), "none: there is no such λ".to_owned())),
        }
        facts
    }

    fn form(&self) -> form::Spectrum<'_> {
        let Spectrum { order, eigenvalues, conditions, limit, tangents } = &self.spectrum;
        let subdominant = conditions.subdominant.as_ref();
        let name = |point| self.rings.ring.name(point);
        form::Spectrum {
            schema: SCHEMA,
            scheme: self.name,
            valence: *order,
            orbits: orbits(self.rings.ring.orbits()),
            neighbourhood: orbits(self.neighbourhood().orbits()),
            eigenvalues: eigenvalues.iter().map(eigenvalue_form).collect(),
            conditions: form::Conditions {
                simple_one: conditions.simple_one,
                subdominant: subdominant.map(Exact::of),
                square: subdominant.map(|value| Exact::of(&value.times(value))),
                next: conditions.next.as_ref().map(Exact::of),
                curvature: conditions.curvature.map(Curvature::name),
            },
            limit: limit.as_ref().map(|one| weights(one, name)),
            tangents: tangents.as_ref().map(|both| both.each_ref().map(|one| weights(one, name))),
        }
    }
}

pub(crate) fn eigenvalue_form(one: &Eigenvalue) -> form::Eigenvalue {
    form::Eigenvalue {
        value: Exact::of(&one.real),
        imaginary: one.imaginary.as_ref().map(Exact::of),
        multiplicity: one.multiplicity,
        block: one.blocks.clone(),
    }
}

pub(crate) fn weights<V: Enclosed + Display>(
    weights: &[V],
    name: impl Fn(usize) -> String,
) -> Vec<form::Weight> {
    let weight = |(point, weight): (usize, &V)| form::Weight {
        point: name(point),
        weight: Exact::of(weight),
    };
    weights.iter().enumerate().map(weight).collect()
}

pub(crate) fn orbits(orbits: &[Orbit]) -> Vec<form::Orbit<'_>> {
    orbits.iter().map(|one| form::Orbit { name: &one.name, count: one.count }).collect()
}

pub(crate) fn orbits_text(orbits: &[Orbit]) -> String {
    let orbits = orbits.iter().map(|orbit| format!("{} {}", orbit.count, orbit.name));
    orbits.collect::<Vec<String>>().join(", ")
}

/// A line for each orbit whose weights are not all 0; one weight where all are equal.
pub(crate) fn orbit_facts<V: Enclosed + Display + PartialEq + subcert::exact::Scalar>(
    orbits: &[Orbit],
    what: &str,
    weights: &[V],
    facts: &mut Vec<(String, String)>,
) {
    let mut rest = weights;
    for orbit in orbits {
        let (these, others) = rest.split_at(orbit.count);
        rest = others;
        if these.iter().all(|weight| *weight == V::zero()) {
            continue;
        }
        let text = if these.windows(2).all(|pair| pair[0] == pair[1]) {
            let each = if orbit.count > 1 { "each " } else { "" };
            format!("{each}{}", with_decimal(&these[0]))
        } else {
            let shown = these.iter().take(SHOWN_WEIGHTS).map(|weight| short(weight, 8));
            let shown = shown.collect::<Vec<String>>().join("  ");
            let more = if orbit.count > SHOWN_WEIGHTS { "  …" } else { "" };
            format!("{shown}{more}")
        };
        facts.push((format!("{what}, {}", orbit.name), text));
    }
}

pub(crate) fn eigenvalue_grid(eigenvalues: &[Eigenvalue]) -> Grid {
    let header = ["value", "exact", "multiplicity", "blocks"].map(str::to_owned).to_vec();
    let rows = eigenvalues.iter().map(|one| {
        let [decimal, exact] = eigenvalue_texts(one);
        vec![decimal, exact, one.multiplicity.to_string(), blocks_text(&one.blocks)]
    });
    Grid { header, rows: rows.collect(), left_columns: 2 }
}

/// The decimal and the exact value; the latter is empty where it is the decimal or long.
fn eigenvalue_texts(one: &Eigenvalue) -> [String; 2] {
    let Some(imaginary) = &one.imaginary else {
        let (decimal, exact) = (short(&one.real, 12), one.real.to_string());
        let exact = if exact.len() > 60 { "in --format json".to_owned() } else { exact };
        return [decimal, exact];
    };
    let decimal = format!("{} ± {}i", short(&one.real, 12), short(imaginary, 12));
    [decimal, "in --format json".to_owned()]
}

/// The blocks: runs of neighbours that have the eigenvalue equally often, as `0–4 (2 each), 7`.
fn blocks_text(blocks: &[usize]) -> String {
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
