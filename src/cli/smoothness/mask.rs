//! `subcert smoothness`.

use super::curve::{Curve, curve};
use super::radius::{
    apart, between, down, ends, product_text, radius_form, root_text, up, upper_text,
    write_certificate,
};
use super::vertex;
use crate::cli::arguments::SmoothnessArguments;
use crate::cli::console::destination::{Destination, command};
use crate::cli::console::output::{Failure, Outcome, with_decimal};
use crate::cli::console::progress::Progress;
use crate::cli::json::{SCHEMA, smoothness as form};
use subcert::certificate::smoothness_certificate;
use subcert::exact::{Integer, Rational, RationalPolynomial, format::short};
use subcert::report::{Sheet, html::FindingPage, json::Exact};
use subcert::scheme::{Mask, names_ring};
use subcert::smoothness::{Coefficient, Hoelder, Smoothness, Symbol, contractions};

pub(crate) fn smoothness(arguments: &SmoothnessArguments) -> Outcome {
    let to = Destination::of(&arguments.output, &format!("smoothness-{}", arguments.scheme))?;
    let ring = || names_ring(&arguments.scheme).unwrap_or(false);
    if arguments.valences.is_some() || (arguments.certificate.is_none() && ring()) {
        return vertex::vertex(arguments, &to);
    }
    match curve(&arguments.scheme)? {
        Curve::Rational(mask) => answer(arguments, &mask, &to),
        Curve::Algebraic(mask) => answer(arguments, &mask, &to),
    }
}

fn answer<F: Coefficient>(
    arguments: &SmoothnessArguments,
    mask: &Mask<F>,
    to: &Destination,
) -> Outcome {
    let name = &arguments.scheme;
    let progress = Progress::of_search(true);
    let smoothness = Smoothness::of(mask).map_err(|error| Failure::Input(error.to_string()))?;
    drop(progress);
    if let Some(path) = &arguments.certificate {
        write_certificate(path, smoothness_certificate(mask, &smoothness))?;
    }
    let most = smoothness.continuity;
    let contractions = most.map_or_else(Vec::new, |most| contractions(&smoothness.symbol, most));
    let report = Report { name, generator: generator(mask), smoothness, contractions };
    let page = || {
        let (sheet, command) = (report.sheet(), command());
        let facts = report.continuity().into_iter().map(|(name, text)| format!("{name}: {text}"));
        let sentence = facts.collect::<Vec<String>>().join("; ");
        Ok(FindingPage { sentence: &sentence, sheet: &sheet, pictures: &[], command: &command }
            .to_html())
    };
    to.deliver(|| report.sheet(), || report.form(), page)
}

/// The number t in which irrational coefficients are polynomials: its value, and its minimal polynomial.
fn generator<F: Coefficient>(mask: &Mask<F>) -> Option<(String, RationalPolynomial)> {
    let mut all = mask.rules().rows().iter().flatten();
    let (root, minimal) = all.find_map(Coefficient::generator)?;
    Some((short(root, 12), RationalPolynomial::over(minimal, &Integer::one())))
}

struct Report<'a, F> {
    name: &'a str,
    generator: Option<(String, RationalPolynomial)>,
    smoothness: Smoothness<F>,
    contractions: Vec<Option<(u32, Rational)>>,
}

impl<F: Coefficient> Report<'_, F> {
    fn sheet(&self) -> Sheet {
        let mut sheet = Sheet::default();
        sheet.heading(1, format!("{}: smoothness", self.name));
        sheet.facts(self.polynomials());
        sheet.heading(2, "Limits");
        let mut facts = self.continuity();
        if let Some(hoelder) = &self.smoothness.hoelder {
            facts.push(("Hölder exponent".to_owned(), exponent(hoelder)));
            if let Some(attained) = hoelder.attained {
                let text = if attained { "yes" } else { "no: powers of a logarithm enter" };
                facts.push(("attained".to_owned(), text.to_owned()));
            }
        }
        sheet.facts(facts);
        sheet.heading(2, "Joint spectral radius");
        sheet.facts(self.radius());
        self.remarks(&mut sheet);
        sheet
    }

    fn polynomials(&self) -> Vec<(String, String)> {
        let Smoothness { symbol, sum_rules, reproduction, shift, .. } = &self.smoothness;
        let (low, high) = symbol.support();
        let generated = format!("up to degree {}", sum_rules - 1);
        let reproduced = if shift.keeps_lines {
            format!("up to degree {reproduction}, at the natural shift {}", shift.shift)
        } else {
            "only constants: lines are not kept".to_owned()
        };
        let field = self.generator.as_ref().map(|(value, minimal)| {
            let minimal = minimal.describe("t");
            ("coefficients", format!("polynomials in t, t = {value} a root of {minimal}"))
        });
        let facts = [
            ("arity n", symbol.arity().to_string()),
            ("support", format!("of the basic limit function: from {low} to {high}")),
            ("sum rules", format!("of order {sum_rules}")),
            ("polynomials generated", generated),
            ("reproduced", reproduced),
            ("approximation order", (reproduction + 1).to_string()),
        ];
        let facts = field.into_iter().chain(facts);
        facts.map(|(name, text)| (name.to_owned(), text)).collect()
    }

    fn continuity(&self) -> Vec<(String, String)> {
        let mut facts = Vec::new();
        for (m, found) in self.contractions.iter().enumerate() {
            let by = match found {
                Some((c, norm)) => format!(
                    "the differences of {} contract, by {} in {c} level{}",
                    if m == 0 { "the scheme".to_owned() } else { format!("derived scheme {m}") },
                    with_decimal(norm),
                    if *c == 1 { "" } else { "s" }
                ),
                None => "by the bounds of the joint spectral radius".to_owned(),
            };
            facts.push((format!("C^{m}"), format!("proven: {by}")));
        }
        match (self.smoothness.continuity_fails, self.smoothness.continuity) {
            (Some(0), _) => facts.push((
                "convergence".to_owned(),
                "refuted: the differences do not tend to 0".to_owned(),
            )),
            (Some(m), _) => facts.push((format!("C^{m}"), "refuted".to_owned())),
            (None, None) => facts.push(("convergence".to_owned(), "open".to_owned())),
            (None, Some(m)) => facts.push((format!("C^{}", m + 1), "open".to_owned())),
        }
        facts
    }

    fn radius(&self) -> Vec<(String, String)> {
        let deciding = self.smoothness.deciding();
        let (n, radius) = (deciding.symbol.arity(), &deciding.radius);
        let size = deciding.matrices.size();
        let low = radius.root_enclosure();
        let mut facts = vec![
            (
                "matrices".to_owned(),
                format!(
                    "{n}, {size}×{size}, of {n}^{} times the differences of order {0}",
                    deciding.order
                ),
            ),
            ("ϱ".to_owned(), between(low.lower(), &radius.upper())),
            (
                "at least".to_owned(),
                format!("{}: of the product {}", root_text(radius), product_text(radius, "T")),
            ),
        ];
        if let Some(hull) = &radius.hull {
            facts.push(("at most".to_owned(), upper_text(size, radius, hull)));
        }
        facts
    }

    fn remarks(&self, sheet: &mut Sheet) {
        let Smoothness { reduced, hoelder, .. } = &self.smoothness;
        if let Some(reduced) = reduced {
            sheet.text(format!(
                "The shifts of the basic limit function are linearly dependent. It is a combination of \
                 shifts of another, with the symbol {}, which is as smooth; its radius decides.",
                polynomial(&reduced.symbol)
            ));
        }
        if hoelder.as_ref().is_some_and(|hoelder| hoelder.formula.is_none()) {
            sheet.text(apart(" of the exponent"));
        }
    }

    fn form(&self) -> form::Smoothness<'_> {
        let Smoothness { symbol, sum_rules, reproduction, shift, .. } = &self.smoothness;
        let (low, high) = symbol.support();
        let deciding = self.smoothness.deciding();
        let contraction = |found: &Option<(u32, Rational)>| {
            found.as_ref().map(|(c, norm)| form::Contraction { c: *c, norm: Exact::of(norm) })
        };
        let converges = self.smoothness.continuity.is_some();
        form::Smoothness {
            schema: SCHEMA,
            scheme: self.name,
            field: self.generator.as_ref().map(|(value, minimal)| form::Field {
                minimal_polynomial: minimal.describe("t"),
                decimal: value.clone(),
            }),
            arity: symbol.arity(),
            support: [Exact::of(&low), Exact::of(&high)],
            sum_rules: *sum_rules,
            generation: sum_rules - 1,
            reproduction: *reproduction,
            natural_shift: shift.keeps_lines.then(|| Exact::of(&shift.shift)),
            approximation_order: reproduction + 1,
            independent: converges.then_some(self.smoothness.reduced.is_none()),
            continuity: self.smoothness.continuity,
            continuity_fails: self.smoothness.continuity_fails,
            contractions: self.contractions.iter().map(contraction).collect(),
            radius: radius_form(&deciding.matrices, Some(deciding.order), &deciding.radius),
            hoelder: self.smoothness.hoelder.as_ref().map(hoelder_form),
        }
    }
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

/// The ends of the exponent.
fn exponent_ends(hoelder: &Hoelder) -> (Rational, Rational) {
    match &hoelder.formula {
        Some(formula) => ends(formula),
        None => (hoelder.lower.clone(), hoelder.upper.clone()),
    }
}

fn exponent(hoelder: &Hoelder) -> String {
    let (low, high) = exponent_ends(hoelder);
    match &hoelder.formula {
        Some(formula) if formula.as_rational().is_some() => formula.to_string(),
        Some(formula) => format!("{formula}\n{}", between(&low, &high)),
        None => between(&low, &high),
    }
}

fn hoelder_form(hoelder: &Hoelder) -> form::Hoelder {
    let (low, high) = exponent_ends(hoelder);
    form::Hoelder {
        lower: down(&low),
        upper: up(&high),
        exact: hoelder.formula.as_ref().map(ToString::to_string),
        attained: hoelder.attained,
    }
}
