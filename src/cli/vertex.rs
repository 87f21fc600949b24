//! `subcert smoothness` of rules around a vertex or on a face.

use super::arguments::{SmoothnessArguments, Valences};
use super::json::{SCHEMA, vertex as form};
use super::output::{Failure, Outcome, show, with_decimal};
use super::radius::{down, up};
use super::spectrum::failure;
use subcert::characteristic::{
    Family, Hypothesis, MAX_BISECTIONS, Reason, Refutation, RingPoint, Verdict, Vertex,
    regular_for_all_valences,
};
use subcert::exact::format::short;
use subcert::report::{Grid, Sheet, json::Exact};
use subcert::spectrum::Curvature;

const SCOPE: &str = "C^1 in Reif's sense: for generic data, at the vertex or on the face, where the surface around it has \
                     the smoothness of the regular part";

/// The schemes whose eigenvalues are known to be in order at all valences.
const ORDERED: [(&str, Family); 4] = [
    ("catmull-clark", Family::Bicubic),
    ("loop", Family::BoxSpline),
    ("loop-warren", Family::BoxSpline),
    ("doo-sabin", Family::Biquadratic),
];

pub(super) fn vertex(arguments: &SmoothnessArguments) -> Outcome {
    let scheme = &arguments.scheme;
    let (mut all, mut found) = (None, Vec::new());
    match arguments.valences {
        None => found.push(Vertex::of(scheme, None).map_err(failure)?),
        Some(Valences::Some(first, last)) => {
            for n in first..=last {
                found.push(Vertex::of(scheme, Some(n)).map_err(failure)?);
            }
        }
        Some(Valences::All) => {
            let known = ORDERED.iter().find(|(name, _)| name == scheme);
            let (_, family) = known.ok_or_else(|| {
                let names = ORDERED.map(|(name, _)| name).join(", ");
                Failure::Input(format!(
                    "all valences at once are known of {names}; of other rules, give a range such as 3..50"
                ))
            })?;
            all = Some((*family, regular_for_all_valences(*family)));
        }
    }
    show(
        arguments.output.format,
        || sheet(scheme, all, &found),
        || form::Vertices {
            schema: SCHEMA,
            scheme,
            scope: SCOPE,
            all_valences: all.map(|(_, holds)| holds),
            valences: found.iter().map(vertex_form).collect(),
        },
    )
}

fn sheet(scheme: &str, all: Option<(Family, bool)>, found: &[Vertex]) -> Sheet {
    let mut sheet = Sheet::default();
    sheet.heading(1, format!("{scheme}: smoothness at the vertex or on the face"));
    if let Some((family, holds)) = all {
        let verdict = if holds { "proved for all valences n >= 3" } else { "open" };
        let map = "all Bernstein coefficients of the Jacobian and of the half-plane are positive, as polynomials \
                   in one variable, by Sturm's theorem";
        let order = "0 < λ < 1, from the blocks 1 and n − 1, and above all others, for every n: theorem 135 of \
                     proofs/THEOREMS.md";
        let facts = [
            ("C^1", verdict),
            ("ring", family.pieces()),
            ("characteristic map", if holds { map } else { "not decided" }),
            ("eigenvalues", order),
        ];
        sheet.facts(facts.map(|(a, b)| (a.to_owned(), b.to_owned())).to_vec());
    } else if let [vertex] = found {
        sheet.facts(facts(vertex));
    } else {
        let header = ["n", "C^1", "λ", "least J", "Hölder α", "curvature"];
        let rows = found.iter().map(row).collect();
        let header = header.map(str::to_owned).to_vec();
        sheet.grid(Grid { header, rows, left_columns: 0 });
    }
    sheet.text(format!("{SCOPE}."));
    sheet
}

fn row(vertex: &Vertex) -> Vec<String> {
    let conditions = &vertex.spectrum.conditions;
    let decimal = conditions.subdominant.as_ref().map(|value| short(value, 10));
    let least = match &vertex.verdict {
        Verdict::Proved { least, .. } => down(least),
        _ => String::new(),
    };
    let exponent = vertex.exponent.as_ref();
    vec![
        vertex.spectrum.order.to_string(),
        name(&vertex.verdict).to_owned(),
        decimal.unwrap_or_default(),
        least,
        exponent.map(|found| down(found.value.lower())).unwrap_or_default(),
        exponent.map(|found| found.curvature.name().to_owned()).unwrap_or_default(),
    ]
}

fn facts(vertex: &Vertex) -> Vec<(String, String)> {
    let Vertex { family, spectrum, verdict, exponent } = vertex;
    let mut facts = vec![("C^1", format!("{}: {}", name(verdict), reason(verdict)))];
    facts.push(("valence", spectrum.order.to_string()));
    if let Some(value) = &spectrum.conditions.subdominant {
        let text = format!("{}, double, of the blocks 1 and n − 1", with_decimal(value));
        facts.push(("λ", text));
    }
    // Where it is open, the rules may have another regular part.
    if let Some(family) = family.as_ref().filter(|_| !matches!(verdict, Verdict::Open(_))) {
        facts.push(("ring", family.pieces().to_owned()));
    }
    match verdict {
        Verdict::Proved { bisections, least, near } => {
            let text = format!("{}, near {}", down(least), place(near));
            facts.push(("Jacobian at least", text));
            facts.push(("bisections", bisections.to_string()));
        }
        Verdict::Refuted(Refutation::Folds { points, values }) => {
            for (point, value) in points.iter().zip(values) {
                let text = format!("{} to {}", down(value.lower()), up(value.upper()));
                facts.push(("Jacobian", format!("{text} at {}", place(point))));
            }
        }
        _ => {}
    }
    if let Some(found) = exponent {
        let ends = [down(found.value.lower()), up(found.value.upper())];
        let text = if ends[0] == ends[1] { "1".to_owned() } else { ends.join(" to ") };
        let blocks = found.blocks.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
        let jordan = if found.curvature == Curvature::Bounded {
            "; any smaller one where μ has a Jordan block"
        } else {
            ""
        };
        facts.push(("Hölder exponent", format!("{text}, of the first derivatives{jordan}")));
        facts.push((
            "curvature",
            format!("{}; decided by the blocks {blocks}", found.curvature.name()),
        ));
    }
    facts.into_iter().map(|(a, b)| (a.to_owned(), b)).collect()
}

fn place(point: &RingPoint) -> String {
    format!("({}, {})", point.at[0], point.at[1])
}

fn name(verdict: &Verdict) -> &'static str {
    match verdict {
        Verdict::Proved { .. } => "proved",
        Verdict::Refuted(_) => "refuted",
        Verdict::Fails(_) => "a hypothesis fails",
        Verdict::Open(_) => "open",
    }
}

fn reason(verdict: &Verdict) -> String {
    let text = match verdict {
        Verdict::Proved { .. } => "the characteristic map is regular and injective",
        Verdict::Refuted(Refutation::Folds { .. }) => {
            "the Jacobian of the characteristic map has both signs"
        }
        Verdict::Refuted(Refutation::Block0 { value }) => {
            return format!(
                "the eigenvalue {} of block 0 is above all others but 1, and its eigenfunction has one sign",
                with_decimal(value)
            );
        }
        Verdict::Fails(hypothesis) => match hypothesis {
            Hypothesis::SimpleOne => "1 is not simple, or another eigenvalue is not below it",
            Hypothesis::Alone => {
                "the eigenvalues next to 1 are not alone of their absolute value; a Jordan block is not excluded"
            }
            Hypothesis::Real => "the eigenvalues next to 1 are not real",
            Hypothesis::Positive => "the eigenvalue next to 1 is negative",
            Hypothesis::Blocks => {
                "the eigenvalue next to 1 is not double, of the blocks 1 and n − 1"
            }
            Hypothesis::AboveOuter => "λ is not above 1/4",
        },
        Verdict::Open(reason) => match reason {
            Reason::RegularPart => {
                "the orbits declare no regular part that is known here, or there are too many points"
            }
            Reason::InnerRules => {
                "rules other than those of the vertex differ from the regular part"
            }
            Reason::Mirror => "the rules differ from their mirror image",
            Reason::Sign => {
                return format!(
                    "the Jacobian's sign is not decided by {MAX_BISECTIONS} bisections"
                );
            }
            Reason::HalfPlane => "the outer curve of a sector is not shown to be in a half-plane",
        },
    };
    text.to_owned()
}

fn vertex_form(vertex: &Vertex) -> form::Vertex {
    let texts = |point: &RingPoint| point.at.each_ref().map(ToString::to_string);
    let (bisections, least, points) = match &vertex.verdict {
        Verdict::Proved { bisections, least, near } => {
            (Some(*bisections), Some(down(least)), vec![texts(near)])
        }
        Verdict::Refuted(Refutation::Folds { points, .. }) => {
            (None, None, points.iter().map(texts).collect())
        }
        _ => (None, None, Vec::new()),
    };
    let exponent = vertex.exponent.as_ref();
    form::Vertex {
        valence: vertex.spectrum.order,
        verdict: match &vertex.verdict {
            Verdict::Fails(_) => "fails",
            other => name(other),
        },
        reason: reason(&vertex.verdict),
        subdominant: vertex.spectrum.conditions.subdominant.as_ref().map(Exact::of),
        bisections,
        least_jacobian: least,
        points,
        hoelder: exponent.map(|found| [down(found.value.lower()), up(found.value.upper())]),
        curvature: exponent.map(|found| found.curvature.name()),
        blocks: exponent.map(|found| found.blocks.clone()).unwrap_or_default(),
    }
}
