//! `subcert smoothness`.

use super::curve::{Curve, curve};
use super::lattice;
use super::radius::{Radius, apart, write_certificate};
use super::vertex;
use crate::cli::arguments::SmoothnessArguments;
use crate::cli::console::answer::{Answer, SCHEMA, deliver};
use crate::cli::console::destination::Destination;
use crate::cli::console::interrupt::{Interrupt, reason};
use crate::cli::console::output::{Failure, Outcome};
use crate::cli::console::progress::Progress;
use crate::cli::console::quantity::{Number, exponent, misplaced_rows};
use serde::Serialize;
use subcert::certificate::smoothness_certificate;
use subcert::exact::{Integer, Rational, RationalPolynomial, format::short};
use subcert::report::Sheet;
use subcert::report::json::{Exact, HoelderForm};
use subcert::scheme::{Mask, names_ring};
use subcert::smoothness::{self, Coefficient, Symbol, contractions};
use subcert::stop::Stop;

pub(crate) fn smoothness(arguments: &SmoothnessArguments) -> Outcome {
    let to = Destination::of(&arguments.output, &format!("smoothness-{}", arguments.scheme))?;
    let ring = || names_ring(&arguments.scheme).unwrap_or(false);
    if arguments.valences.is_some() || (arguments.certificate.is_none() && ring()) {
        return vertex::vertex(arguments, &to);
    }
    match curve(&arguments.scheme)? {
        Curve::Rational(mask) => answer(arguments, &mask, &to),
        Curve::Algebraic(mask) => answer(arguments, &mask, &to),
        Curve::Lattice(mask) => lattice::smoothness(arguments, &mask, &to),
    }
}

fn answer<F: Coefficient>(
    arguments: &SmoothnessArguments,
    mask: &Mask<F>,
    to: &Destination,
) -> Outcome {
    let progress = Progress::of_search(true);
    let stop = Stop::default();
    let interrupt = Interrupt::stops_search(&stop);
    let found = smoothness::Smoothness::until(mask, &stop)
        .map_err(|error| Failure::Input(error.to_string()))?;
    let by = found.continuity.map(|most| contractions(&found.symbol, most, &stop));
    drop((interrupt, progress));
    if let Some(path) = &arguments.certificate {
        write_certificate(path, smoothness_certificate(mask, &found))?;
    }
    let ended = stop.is_stopped().then(reason);
    let by = by.unwrap_or_default();
    deliver(to, &Smoothness { ended, ..Smoothness::of(&arguments.scheme, mask, &found, by) })
}

/// How smooth the limits of a scheme are.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct Smoothness<'a> {
    /// The version of this form.
    schema: u32,
    /// The scheme as it was given.
    scheme: &'a str,
    /// The number t in which the coefficients are polynomials; absent where all are rational.
    #[serde(skip_serializing_if = "Option::is_none")]
    field: Option<Field>,
    /// The arity.
    arity: usize,
    /// The ends of the support of the basic limit function, when x^k_i belongs to i/n^k.
    support: [Exact; 2],
    /// The order of the sum rules.
    sum_rules: usize,
    /// The degree up to which polynomials are generated.
    generation: usize,
    /// The degree up to which polynomials are reproduced.
    reproduction: usize,
    /// The natural shift s: the point x^k_i belongs to (i + s)/n^k. Null where lines are not kept.
    natural_shift: Option<Exact>,
    /// The rows that belong so many places further.
    #[serde(skip)]
    misplaced: Vec<(usize, i64)>,
    /// The order of approximation of smooth functions by limits of their values.
    approximation_order: usize,
    /// Whether the shifts of the basic limit function are linearly independent; null where the scheme is
    /// not shown to converge.
    independent: Option<bool>,
    /// The largest m for which the limits are proven to be C^m; null where convergence is not proven.
    continuity: Option<usize>,
    /// The least m for which it is proven that not all limits are C^m; null where there is none.
    continuity_fails: Option<usize>,
    /// Why the searches ended early, with what they had proven; absent where they did not.
    #[serde(skip_serializing_if = "Option::is_none")]
    ended: Option<String>,
    /// For m = 0, 1, … up to `continuity` the proof by contraction; null where none is found.
    contractions: Vec<Option<Contraction>>,
    /// The radius of which the exponent is made.
    radius: Radius,
    /// The Hölder exponent; null where convergence is not proven.
    hoelder: Option<HoelderForm>,
    /// The symbol that decides, where the shifts of the basic limit function are linearly dependent.
    #[serde(skip)]
    reduced: Option<String>,
}

/// The field of irrational coefficients.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Field {
    /// The minimal polynomial of t.
    minimal_polynomial: String,
    /// t.
    decimal: String,
}

/// That the differences of a derived scheme contract.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Contraction {
    /// The number c of levels.
    c: u32,
    /// The norm, below 1.
    norm: Number,
}

impl<'a> Smoothness<'a> {
    fn of<F: Coefficient>(
        scheme: &'a str,
        mask: &Mask<F>,
        found: &smoothness::Smoothness<F>,
        contractions: Vec<Option<(u32, Rational)>>,
    ) -> Smoothness<'a> {
        let smoothness::Smoothness { symbol, sum_rules, reproduction, shift, continuity, .. } =
            found;
        let (low, high) = symbol.support();
        let deciding = found.deciding();
        let contraction = |found: Option<(u32, Rational)>| {
            found.map(|(c, norm)| Contraction { c, norm: Number::Rational(norm) })
        };
        Smoothness {
            schema: SCHEMA,
            scheme,
            field: field(mask),
            arity: symbol.arity(),
            support: [Exact::of(&low), Exact::of(&high)],
            sum_rules: *sum_rules,
            generation: sum_rules - 1,
            reproduction: *reproduction,
            misplaced: shift.misplaced(),
            natural_shift: shift.keeps_lines.then(|| Exact::of(&shift.shift)),
            approximation_order: reproduction + 1,
            independent: continuity.map(|_| found.reduced.is_none()),
            continuity: *continuity,
            continuity_fails: found.continuity_fails,
            ended: None,
            contractions: contractions.into_iter().map(contraction).collect(),
            radius: Radius::of(&deciding.matrices, 'T', Some(deciding.order), &deciding.radius),
            hoelder: found.hoelder.as_ref().map(HoelderForm::of),
            reduced: found.reduced.as_ref().map(|reduced| polynomial(&reduced.symbol)),
        }
    }

    fn polynomials(&self) -> Vec<(String, String)> {
        let [low, high] = &self.support;
        let reproduced = match &self.natural_shift {
            Some(shift) => {
                format!("up to degree {}, at the natural shift {}", self.reproduction, shift.exact)
            }
            None => match misplaced_rows(&self.misplaced) {
                Some(rows) => format!("only constants: lines are not kept, unless {rows}"),
                None => "only constants: lines are not kept".to_owned(),
            },
        };
        let field = self.field.as_ref().map(|Field { minimal_polynomial, decimal }| {
            let text = format!("polynomials in t, t = {decimal} a root of {minimal_polynomial}");
            ("coefficients", text)
        });
        let support = format!("of the basic limit function: from {} to {}", low.exact, high.exact);
        let facts = [
            ("arity n", self.arity.to_string()),
            ("support", support),
            ("sum rules", format!("of order {}", self.sum_rules)),
            ("polynomials generated", format!("up to degree {}", self.generation)),
            ("reproduced", reproduced),
            ("approximation order", self.approximation_order.to_string()),
        ];
        let facts = field.into_iter().chain(facts);
        facts.map(|(name, text)| (name.to_owned(), text)).collect()
    }

    fn continuity(&self) -> Vec<(String, String)> {
        let mut facts = Vec::new();
        for (m, found) in self.contractions.iter().enumerate() {
            let by = match found {
                Some(Contraction { c, norm }) => format!(
                    "the differences of {} contract, by {} in {c} level{}",
                    if m == 0 { "the scheme".to_owned() } else { format!("derived scheme {m}") },
                    norm.words(),
                    if *c == 1 { "" } else { "s" }
                ),
                None if self.ended.is_some() => "before the search was stopped".to_owned(),
                None => "by the bounds of the joint spectral radius".to_owned(),
            };
            facts.push((format!("C^{m}"), format!("proven: {by}")));
        }
        let ended = self.ended.as_ref().map(|why| format!(": {why}")).unwrap_or_default();
        let open = format!("open{ended}");
        let first = self.continuity.map_or(0, |m| m + 1);
        let last = self.continuity_fails.map(|m| m.saturating_sub(1));
        match (self.continuity, last) {
            (None, None) => facts.push(("convergence".to_owned(), open)),
            (_, None) => facts.push((format!("C^{first}"), open)),
            (_, Some(last)) if last == first && self.continuity_fails != Some(0) => {
                facts.push((format!("C^{first}"), open));
            }
            (_, Some(last)) if last > first => {
                facts.push((format!("C^{first} to C^{last}"), open));
            }
            _ => {}
        }
        facts.extend(self.continuity_fails.map(|m| match m {
            0 => ("convergence".to_owned(), "refuted: the differences do not tend to 0".to_owned()),
            _ => (format!("C^{m}"), "refuted".to_owned()),
        }));
        facts
    }
}

impl Answer for Smoothness<'_> {
    const NAME: &'static str = "smoothness";

    fn sheet(&self) -> Sheet {
        let mut sheet = Sheet::titled(format!("{}: smoothness", self.scheme));
        sheet.facts(self.polynomials());
        sheet.heading(2, "Limits");
        let mut facts = self.continuity();
        if let Some(hoelder) = &self.hoelder {
            facts.push(("Hölder exponent".to_owned(), exponent(hoelder)));
            if let Some(attained) = hoelder.attained {
                let text = if attained { "yes" } else { "no: powers of a logarithm enter" };
                facts.push(("attained".to_owned(), text.to_owned()));
            }
        }
        sheet.facts(facts);
        sheet.heading(2, "Joint spectral radius");
        let (n, size, order) = (self.arity, self.radius.size, self.radius.order.unwrap_or(0));
        let matrices =
            format!("{n}, {size}×{size}, of {n}^{order} times the differences of order {order}");
        let mut facts = vec![("matrices".to_owned(), matrices)];
        facts.extend(self.radius.facts());
        sheet.facts(facts);
        if let Some(reduced) = &self.reduced {
            sheet.text(format!(
                "The shifts of the basic limit function are linearly dependent. It is a combination of \
                 shifts of another, with the symbol {reduced}, which is as smooth; its radius decides.",
            ));
        }
        if self.hoelder.as_ref().is_some_and(|hoelder| hoelder.exact.is_none()) {
            sheet.text(apart(" of the exponent", &self.radius));
        }
        sheet
    }

    fn sentence(&self) -> String {
        let facts = self.continuity().into_iter().map(|(name, text)| format!("{name}: {text}"));
        facts.collect::<Vec<String>>().join("; ")
    }
}

/// The number t in which irrational coefficients are polynomials: its value, and its minimal polynomial.
fn field<F: Coefficient>(mask: &Mask<F>) -> Option<Field> {
    let mut all = mask.rules().rows().iter().flatten();
    let (root, minimal) = all.find_map(Coefficient::generator)?;
    let minimal_polynomial = RationalPolynomial::over(minimal, &Integer::one()).describe("t");
    Some(Field { minimal_polynomial, decimal: short(root, 12) })
}

/// A symbol up to a power of z.
fn polynomial<F: Coefficient>(symbol: &Symbol<F>) -> String {
    let rational = symbol.coefficients().iter().map(|c| match &c.coordinates()[..] {
        [value] => Some(value.clone()),
        _ => None,
    });
    if let Some(rational) = rational.collect::<Option<Vec<Rational>>>() {
        return RationalPolynomial::new(&rational).describe("z");
    }
    let terms = symbol.coefficients().iter().enumerate();
    terms.map(|(i, c)| format!("({c})*z^{i}")).collect::<Vec<String>>().join(" + ")
}
