//! `subcert spectrum`.

use super::parts::{Eigenvalue, Weight, blocks_text, eigenvalue_grid, orbit_facts, weights};
use crate::cli::arguments::SpectrumArguments;
use crate::cli::console::answer::{Answer, SCHEMA, show};
use crate::cli::console::output::{Failure, Outcome, with_decimal};
use crate::cli::console::progress::Progress;
use crate::cli::console::quantity::{Number, Orbit};
use serde::Serialize;
use std::sync::Arc;
use std::sync::atomic::AtomicU64;
use subcert::exact::{Scalar as _, format::short};
use subcert::report::Sheet;
use subcert::scheme::notes;
use subcert::spectrum::{
    self, ComplexEigenvalues, Curvature, SpectrumError, Surroundings, surroundings,
};

/// What the conditions leave open.
const NECESSARY: &str = "These conditions on eigenvalues are necessary only: for a C^1 surface the characteristic map must be \
     regular and injective too, which `subcert smoothness` decides.";

pub(crate) fn spectrum(arguments: &SpectrumArguments) -> Outcome {
    let rings = surroundings(&arguments.scheme, arguments.valence)
        .map_err(|error| failure_without_valence(error, "--valence 5"))?;
    let progress = Progress::of_spectra(Arc::new(AtomicU64::new(0)), 1, true);
    let found = rings.known_spectrum().map_err(failure)?;
    drop(progress);
    show(&arguments.output, &Spectrum::of(&arguments.scheme, &rings, &found))
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

/// The spectrum of a ring and its stencils.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct Spectrum<'a> {
    /// The version of this form.
    schema: u32,
    /// The scheme as it was given.
    scheme: &'a str,
    /// What is to be told of the numbers, such as that they are those of several steps; missing where there is nothing.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    notes: Vec<String>,
    /// The order n of the rotation.
    valence: usize,
    /// The orbits of the ring of the stencils.
    orbits: Vec<Orbit>,
    /// The orbits of the ring whose eigenvalues these are.
    neighbourhood: Vec<Orbit>,
    /// All eigenvalues, in descending order of the absolute value, but for those of `complex`.
    eigenvalues: Vec<Eigenvalue>,
    /// Complex eigenvalues that are not computed.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    complex: Vec<Complex>,
    /// The conditions on them.
    conditions: Conditions,
    /// The weights of the points in their limit; null where 1 is no simple eigenvalue.
    limit: Option<Vec<Weight>>,
    /// The weights of the points in two tangents, whose cross product in this order is a normal; null
    /// without a subdominant eigenvalue.
    tangents: Option<[Vec<Weight>; 2]>,
    /// What a curvature does, in words.
    #[serde(skip)]
    curvature: Option<String>,
}

/// Complex eigenvalues of which only their greatest absolute value is known from both sides.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Complex {
    /// How many there are, with multiplicities.
    count: usize,
    /// The Fourier blocks, each as often as it has one.
    block: Vec<usize>,
    /// The greatest of their absolute values is at least this.
    lower: Number,
    /// It is at most this.
    upper: Number,
}

impl Complex {
    fn of(found: &ComplexEigenvalues) -> Complex {
        let ComplexEigenvalues { blocks, greatest } = found;
        let [lower, upper] = greatest.each_ref().map(Number::from);
        Complex { count: blocks.len(), block: blocks.clone(), lower, upper }
    }

    fn words(&self) -> (String, String) {
        let name = format!("{} complex ones, blocks {}", self.count, blocks_text(&self.block));
        let [lower, upper] = [&self.lower, &self.upper].map(|one| one.short(9));
        (name, format!("not computed; the greatest absolute value is from {lower} to {upper}"))
    }
}

/// What the literature asks of the eigenvalues: necessary conditions only. C¹ also needs a regular and
/// injective characteristic map, which `smoothness` decides.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Conditions {
    /// Whether 1 is simple, and all others are below 1 in absolute value.
    simple_one: bool,
    /// λ, if it is positive, double, from blocks 1 and n − 1, and exceeds all later ones; or null.
    subdominant: Option<Number>,
    /// λ².
    square: Option<Number>,
    /// The greatest absolute value μ after λ.
    next: Option<Number>,
    /// `bounded` where μ = λ² without a Jordan block, `growing` with one, `vanishing` where μ is less, `unbounded` where it is
    /// greater.
    curvature: Option<&'static str>,
}

impl<'a> Spectrum<'a> {
    fn of(scheme: &'a str, rings: &Surroundings, found: &spectrum::Spectrum) -> Spectrum<'a> {
        let spectrum::Spectrum { order, eigenvalues, complex, conditions, limit, tangents } = found;
        let subdominant = conditions.subdominant.as_ref();
        let name = |point| rings.ring.name(point);
        Spectrum {
            schema: SCHEMA,
            scheme,
            notes: notes(scheme),
            valence: *order,
            orbits: Orbit::all(rings.ring.orbits()),
            neighbourhood: Orbit::all(rings.wider.as_ref().unwrap_or(&rings.ring).orbits()),
            eigenvalues: Eigenvalue::all(eigenvalues),
            complex: complex.iter().map(Complex::of).collect(),
            conditions: Conditions {
                simple_one: conditions.simple_one,
                subdominant: subdominant.map(Number::from),
                square: subdominant.map(|value| Number::from(&value.times(value))),
                next: conditions.next.as_ref().map(Number::from),
                curvature: conditions.curvature.map(Curvature::name),
            },
            limit: limit.as_ref().map(|one| weights(one, name)),
            tangents: tangents.as_ref().map(|both| both.each_ref().map(|one| weights(one, name))),
            curvature: curvature(conditions, rings.wider.is_some()),
        }
    }

    fn conditions(&self) -> Vec<(String, String)> {
        let found = &self.conditions;
        let yes = |holds: bool| if holds { "yes" } else { "no" }.to_owned();
        let value = found.subdominant.as_ref();
        let value = value.map_or_else(|| yes(false), |value| format!("yes: λ = {}", value.words()));
        let what = "λ is double, from blocks 1 and n − 1, and exceeds all later ones";
        let facts = [("1 is simple and dominant", yes(found.simple_one)), (what, value)];
        let curvature = self.curvature.iter().map(|text| ("curvature", text.clone()));
        facts.into_iter().chain(curvature).map(|(name, text)| (name.to_owned(), text)).collect()
    }

    fn stencils(&self) -> Vec<(String, String)> {
        let mut facts = Vec::new();
        let orbits = &self.orbits;
        match &self.limit {
            Some(limit) => orbit_facts(orbits, "limit", limit, &mut facts),
            None => facts.push(("limit".to_owned(), "none: 1 is not simple".to_owned())),
        }
        match &self.tangents {
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
}

/// What a curvature does, in words; `is_whole` says whether these are the points on which it depends.
fn curvature(found: &spectrum::Conditions, is_whole: bool) -> Option<String> {
    let text = of_points(found)?;
    if is_whole || found.curvature?.is_unbounded() {
        return Some(text);
    }
    Some(format!("{text}, if the points farther out have no greater eigenvalues"))
}

/// What it does by the eigenvalues of these points.
fn of_points(found: &spectrum::Conditions) -> Option<String> {
    let value = found.subdominant.as_ref()?;
    let square = value.times(value);
    let Some(next) = &found.next else {
        let square = short(&square, 12);
        return Some(match found.curvature? {
            Curvature::Vanishing => format!("tends to 0: all others are below λ² = {square}"),
            _ => format!("unbounded in general: an eigenvalue is above λ² = {square}"),
        });
    };
    Some(match found.curvature? {
        Curvature::Bounded => format!("bounded: μ = λ² = {}", with_decimal(next)),
        Curvature::Growing => format!(
            "unbounded in general, slowly: μ = λ² = {} has a Jordan block of size {}",
            with_decimal(next),
            found.longest(|_| true, next).unwrap_or(2)
        ),
        Curvature::Vanishing => {
            format!("tends to 0: μ = {} is below λ² = {}", short(next, 12), short(&square, 12))
        }
        Curvature::Unbounded => format!(
            "unbounded in general: μ = {} is above λ² = {}",
            short(next, 12),
            short(&square, 12)
        ),
    })
}

impl Answer for Spectrum<'_> {
    const NAME: &'static str = "spectrum";

    fn sheet(&self) -> Sheet {
        let mut sheet = Sheet::titled(format!("{}, valence {}", self.scheme, self.valence));
        sheet.notes(&self.notes);
        sheet.heading(2, "Eigenvalues");
        sheet.facts(vec![("of the points".to_owned(), Orbit::words(&self.neighbourhood))]);
        sheet.grid(eigenvalue_grid(&self.eigenvalues));
        sheet.facts(self.complex.iter().map(Complex::words).collect());
        sheet.heading(2, "Conditions");
        sheet.facts(self.conditions());
        sheet.text(NECESSARY);
        sheet.heading(2, "Stencils");
        sheet.facts(self.stencils());
        if self.tangents.is_some() {
            sheet.text("The cross product of tangent 1 and tangent 2 is a normal.");
        }
        sheet
    }
}
