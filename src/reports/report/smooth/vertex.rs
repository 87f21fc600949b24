//! Surfaces at a vertex or on a face in words.

use crate::audit::{Vertices, Word};
use crate::characteristic::{
    Exponent, Hypothesis, MAX_BISECTIONS, Reason, Refutation, RingPoint, Verdict, Vertex,
};
use crate::exact::{Enclosed, format::short};
use crate::report::words::numbers::{DIGITS, down, up};
use crate::spectrum::{Curvature, Eigenvalue};
use std::fmt::Display;

/// What is said, and what is not.
pub const SCOPE: &str = "C^1 in Reif's sense: for generic data, at the vertex or on the face, where the surface around it has \
                         the smoothness of the regular part";

/// The longest exact value that is shown.
const LONGEST: usize = 40;

fn with_decimal(value: &(impl Enclosed + Display)) -> String {
    let (exact, decimal) = (value.to_string(), short(value, DIGITS));
    match (decimal == exact, exact.len() > LONGEST) {
        (true, _) => exact,
        (false, false) => format!("{exact} = {decimal}"),
        (false, true) => format!("{decimal}  (exact in --format json)"),
    }
}

/// `proved`, `refuted`, `a hypothesis fails` or `open`.
#[must_use]
pub fn verdict_name(verdict: &Verdict) -> &'static str {
    match verdict {
        Verdict::Proved { .. } => Word::Proved.name(),
        Verdict::Refuted(_) => Word::Refuted.name(),
        Verdict::Fails(_) => "a hypothesis fails",
        Verdict::Open(_) => Word::Open.name(),
    }
}

/// Why this is said.
#[must_use]
pub fn verdict_reason(verdict: &Verdict) -> String {
    let text = match verdict {
        Verdict::Proved { .. } => "the characteristic map is regular and injective",
        Verdict::Refuted(Refutation::Folds { .. }) => {
            "the Jacobian of the characteristic map has both signs"
        }
        Verdict::Refuted(Refutation::Diverges { eigenvalue }) => return diverges(eigenvalue),
        Verdict::Refuted(Refutation::Block0 { value, size }) => {
            let above = if *size == 1 {
                "is above all others but 1".to_owned()
            } else {
                format!("has a Jordan block of size {size}, which outweighs all others but 1")
            };
            return format!(
                "the eigenvalue {} of block 0 {above}, and its eigenfunction has one sign",
                with_decimal(value)
            );
        }
        Verdict::Refuted(Refutation::Negative) => {
            "λ is negative, and the Jacobian of its map has one sign: other points of the ring are mapped to the vertex"
        }
        Verdict::Refuted(Refutation::Winds { number }) => {
            let times = number.map_or_else(
                || "more than once or backwards".to_owned(),
                |number| format!("{number} times"),
            );
            return format!(
                "the characteristic map winds around the vertex or the centre of the face {times}, and not once"
            );
        }
        Verdict::Fails(hypothesis) => failing(*hypothesis),
        Verdict::Open(reason) => match reason {
            Reason::RegularPart => {
                "the orbits declare no regular part whose limits are polynomials in pieces (bicubic, quartic box splines or biquadratic), \
                 or there are too many points"
            }
            Reason::InnerRules => {
                "rules other than those of the vertex differ from the regular part: declare the points around them, too"
            }
            Reason::OuterRules => {
                "the rules of the points around those next to the vertex are not those of the regular part"
            }
            Reason::Mirror => "the rules differ from their mirror image",
            Reason::Eigenvector => {
                "the eigenvector of the points next to the vertex is not decided by enclosures"
            }
            Reason::Sign => {
                return format!(
                    "the Jacobian's sign is not decided by {MAX_BISECTIONS} bisections"
                );
            }
            Reason::HalfPlane => {
                "the winding number of the outer curve is not found: a part of it may meet the vertex"
            }
        },
    };
    text.to_owned()
}

/// Why the surface is not continuous.
fn diverges(found: &Eigenvalue) -> String {
    let blocks = found.blocks.iter().map(ToString::to_string).collect::<Vec<_>>();
    let of = match &blocks[..] {
        [block] => format!("of block {block}"),
        _ => format!("of the blocks {}", blocks.join(", ")),
    };
    let value = match &found.imaginary {
        None => format!("the eigenvalue {}", with_decimal(&found.real)),
        Some(_) => {
            format!("a complex eigenvalue of absolute value {}", with_decimal(&found.modulus))
        }
    };
    format!(
        "{value} {of} is not below 1 in absolute value, besides the simple eigenvalue 1: the rings do not contract to a point, and the \
         surface is not continuous"
    )
}

/// What a failing hypothesis means.
fn failing(hypothesis: Hypothesis) -> &'static str {
    match hypothesis {
        Hypothesis::SimpleOne => "1 is not simple, or another eigenvalue is not below it",
        Hypothesis::Alone => {
            "the eigenvalues next to 1 are not alone of their absolute value; a Jordan block is not excluded"
        }
        Hypothesis::Real => "the eigenvalues next to 1 are not real",
        Hypothesis::Simple => {
            "λ is a multiple eigenvalue of one block, so that a Jordan block is not excluded"
        }
        Hypothesis::Blocks => "the eigenvalue next to 1 is not of two blocks k and n − k",
        Hypothesis::First => {
            "the eigenvalue next to 1 is not a positive one of the blocks 1 and n − 1"
        }
    }
}

/// Why surfaces are C².
const REGULAR: &str = "the rules are those of the regular part";

fn place(point: &RingPoint) -> String {
    format!("({}, {})", point.at[0], point.at[1])
}

/// All that is known of one valence.
#[must_use]
pub fn vertex_facts(vertex: &Vertex) -> Vec<(String, String)> {
    let Vertex { family, spectrum, second, verdict, exponent, .. } = vertex;
    let mut facts =
        vec![("C^1", format!("{}: {}", verdict_name(verdict), verdict_reason(verdict)))];
    if vertex.regular {
        facts.push(("C^2", format!("proved: {REGULAR}")));
    }
    facts.push(("valence", spectrum.order.to_string()));
    let subdominant = spectrum.conditions.subdominant.as_ref().map(|value| (value, 1));
    let lambda = second.as_ref().map(|second| (&second.value, second.block)).or(subdominant);
    if let Some((value, block)) = lambda {
        let blocks = match block {
            0 => "simple, of block 0".to_owned(),
            k => format!("double, of the blocks {k} and n − {k}"),
        };
        facts.push(("λ", format!("{}, {blocks}", with_decimal(value))));
    }
    if matches!(verdict, Verdict::Open(_)) {
        let text = match vertex.hypothesis {
            None => {
                "those of these points are in order for C^1; points further out may have others"
            }
            Some(hypothesis) => failing(hypothesis),
        };
        facts.push(("eigenvalues", text.to_owned()));
    }
    // Where it is open, the rules may have another regular part.
    if let Some(family) = family.as_ref().filter(|_| !matches!(verdict, Verdict::Open(_))) {
        let pieces = family.pieces();
        facts.push((
            "ring",
            if vertex.own { pieces.replacen('3', "12", 1) } else { pieces.to_owned() },
        ));
    }
    match verdict {
        Verdict::Proved { bisections, least, near } => {
            facts.push(("Jacobian at least", format!("{}, near {}", down(least), place(near))));
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
        facts.extend(exponent_facts(found));
    }
    facts.into_iter().map(|(a, b)| (a.to_owned(), b)).collect()
}

/// How smooth the first derivatives are, and what the curvature does.
fn exponent_facts(found: &Exponent) -> Vec<(&'static str, String)> {
    let ends = exponent_ends(found);
    let text = if ends[0] == ends[1] { "1".to_owned() } else { ends.join(" to ") };
    let blocks = found.blocks.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
    let jordan = match found.attained {
        Some(true) => "",
        Some(false) => "; any smaller one, as μ has a Jordan block",
        None => "; any smaller one where μ has a Jordan block",
    };
    let mut facts = vec![
        ("Hölder exponent", format!("{text}, of the first derivatives{jordan}")),
        (
            "curvature",
            format!("{}; decided by the blocks {blocks}", curvature_text(found.curvature)),
        ),
    ];
    let names = ["elliptic shapes", "hyperbolic shapes"];
    let blocks = ["block 0", "the blocks 2 and n − 2"];
    for ((name, of), shape) in names.into_iter().zip(blocks).zip(&found.shapes) {
        if let Some((modulus, curvature)) = shape {
            let text = format!(
                "|μ| = {} of {of}: curvature {}",
                with_decimal(modulus),
                curvature_text(*curvature)
            );
            facts.push((name, text));
        }
    }
    facts
}

/// What the curvature does, in words.
fn curvature_text(curvature: Curvature) -> &'static str {
    match curvature {
        Curvature::Growing => {
            "unbounded, growing like a power of the number of steps (μ = λ² with a Jordan block)"
        }
        other => other.name(),
    }
}

/// Decimals around the exponent of the first derivatives.
pub(crate) fn exponent_ends(found: &Exponent) -> [String; 2] {
    [down(found.value.lower()), up(found.value.upper())]
}

/// The columns of [`vertex_row`].
pub const VERTEX_HEADER: [&str; 6] = ["n", "C^1", "λ", "least J", "Hölder α", "curvature"];

/// One valence in a line of a table.
#[must_use]
pub fn vertex_row(vertex: &Vertex) -> Vec<String> {
    let decimal = vertex.second.as_ref().map(|second| short(&second.value, 10));
    let exponent = vertex.exponent.as_ref();
    vec![
        vertex.spectrum.order.to_string(),
        verdict_name(&vertex.verdict).to_owned(),
        decimal.unwrap_or_default(),
        least(vertex).unwrap_or_default(),
        exponent.map(|found| down(found.value.lower())).unwrap_or_default(),
        exponent.map(|found| found.curvature.name().to_owned()).unwrap_or_default(),
    ]
}

/// A decimal that is not above J.
pub(crate) fn least(vertex: &Vertex) -> Option<String> {
    match &vertex.verdict {
        Verdict::Proved { least, .. } => Some(down(least)),
        _ => None,
    }
}

/// What is found for a claim, in lines: the valences by their verdicts.
pub(crate) fn vertices_outcome(found: &Vertices) -> Vec<String> {
    if found.all.is_some() {
        return vec![
            "C^1 is proved for all valences N >= 3 at once: by the signs of polynomials in one variable, and theorem 135 of \
             proofs/THEOREMS.md"
                .to_owned(),
        ];
    }
    let mut groups: Vec<(String, Vec<&Vertex>)> = Vec::new();
    for vertex in &found.vertices {
        let said =
            format!("{}: {}", verdict_name(&vertex.verdict), verdict_reason(&vertex.verdict));
        match groups.iter_mut().find(|(known, _)| *known == said) {
            Some((_, group)) => group.push(vertex),
            None => groups.push((said, vec![vertex])),
        }
    }
    let line = |(said, group): (String, Vec<&Vertex>)| {
        let numbers: Vec<usize> = group.iter().map(|vertex| vertex.spectrum.order).collect();
        let exponents = group.iter().filter_map(|vertex| vertex.exponent.as_ref());
        let lowest = exponents.min_by(|a, b| a.value.lower().cmp(b.value.lower()));
        let smooth = lowest.map(|found| {
            format!(
                "; the first derivatives have a Hölder exponent of at least {}",
                down(found.value.lower())
            )
        });
        let regular = if group.iter().all(|vertex| vertex.regular) {
            format!("; C^2 is proved: {REGULAR}")
        } else {
            String::new()
        };
        let smooth = smooth.unwrap_or_default();
        format!("N = {}: C^1 is {said}{smooth}{regular}", ranges(&numbers))
    };
    groups.into_iter().map(line).collect()
}

/// `3 to 5, 7`.
fn ranges(numbers: &[usize]) -> String {
    let mut runs: Vec<(usize, usize)> = Vec::new();
    for &n in numbers {
        match runs.last_mut() {
            Some((_, last)) if *last + 1 == n => *last = n,
            _ => runs.push((n, n)),
        }
    }
    let text =
        |&(a, b): &(usize, usize)| if a == b { a.to_string() } else { format!("{a} to {b}") };
    runs.iter().map(text).collect::<Vec<_>>().join(", ")
}
