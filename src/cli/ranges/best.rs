//! `subcert range --best`.

use super::sets::Set;
use super::smooth_map::region;
use super::special::write_special;
use crate::cli::arguments::{BOXES, BestArgument, RangeArguments};
use crate::cli::console::answer::{Answer, SCHEMA, show};
use crate::cli::console::output::{Failure, Outcome};
use crate::cli::console::progress::Progress;
use crate::cli::console::quantity::Text;
use serde::Serialize;
use std::ops::Bound;
use std::sync::Arc;
use std::sync::atomic::AtomicUsize;
use subcert::bound::{Order, norm_function, polynomial_rules};
use subcert::exact::{
    Enclosed as _, Interval, IntervalSet, LogSum, LogTerm, PiecewisePolynomial, Rational,
    format::short,
};
use subcert::report::json::SpecialForm;
use subcert::report::{Sheet, down, up};
use subcert::scheme::parse_in_parameters;
use subcert::smoothness::{BestExponent, MAX_BOXES, SpecialValues, best_exponent, plane_rules};

/// How often the interval of a least constant is halved.
const HALVINGS: u32 = 48;

/// The enclosures of logarithms.
const LEVEL: u32 = 1;

pub(crate) fn best(arguments: &RangeArguments, names: &[String], what: BestArgument) -> Outcome {
    let refuse = |message: String| Err(Failure::Input(message));
    if names.len() > 2 {
        return refuse("the best values of one parameter, or of two, are found".to_owned());
    }
    // A scheme in one parameter has a second one that nothing depends on.
    let second = names.get(1).cloned().unwrap_or_default();
    let both = [&names[0], &second];
    let mut sides = region(arguments.bounds.as_deref(), both).map_err(Failure::Input)?;
    if names.len() == 1 {
        sides[1] = [Rational::zero(), Rational::zero()];
    }
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let mask = parse_in_parameters(&arguments.scheme, &names)?;
    if what == BestArgument::Contraction {
        let [parameter] = names[..] else {
            return refuse(
                "the least T_c is that of one parameter: give values to the others".to_owned(),
            );
        };
        let difference = polynomial_rules(&mask.difference(), parameter);
        let difference = difference.map_err(|error| Failure::Input(error.to_string()))?;
        let levels = arguments.block.levels;
        let function = norm_function(&difference, levels, Order::Adjoint);
        let function = function.map_err(|error| Failure::Input(error.to_string()))?;
        let [low, high] = sides[0].clone().map(|end| Bound::Included(end.into()));
        let least = Least::of(&function, &IntervalSet::from(Interval { low, high }), &sides[0]);
        let answer = BestContraction {
            schema: SCHEMA,
            scheme: &arguments.scheme,
            parameter,
            levels,
            bounds: sides[0].clone().map(Text),
            least: least.bounds.map(Text),
            places: Set::of(&least.places, parameter),
        };
        return show(&arguments.output, &answer);
    }
    let most = arguments.boxes.unwrap_or(BOXES);
    if !(16..=MAX_BOXES).contains(&most) {
        return refuse(format!("`--boxes {most}`: from 16 to {MAX_BOXES} boxes can be examined"));
    }
    let rules = plane_rules(mask.rules(), both.map(String::as_str)).map_err(|entry| {
        Failure::Input(format!(
            "the coefficient {entry} is not a rational polynomial in these parameters"
        ))
    })?;
    let done = Arc::new(AtomicUsize::new(0));
    let progress = Progress::of_boxes(Arc::clone(&done), most, true);
    let found = best_exponent(&rules, &sides, most, &done);
    drop(progress);
    let found = found.map_err(|error| Failure::Input(error.to_string()))?;
    let [low, high] = exponents(&found);
    let special = match names[..] {
        [parameter] => {
            let rules = polynomial_rules(mask.rules(), parameter);
            let rules = rules.map_err(|error| Failure::Input(error.to_string()))?;
            SpecialForm::all(&SpecialValues::of(&rules), parameter)
        }
        _ => Vec::new(),
    };
    let with_names = |at: [Rational; 2]| names.iter().copied().zip(at);
    let [at, from, to] = [
        found.at.clone(),
        found.places.clone().map(|[low, _]| low),
        found.places.map(|[_, high]| high),
    ];
    let parameters = with_names(at).zip(with_names(from)).zip(with_names(to));
    let parameters = parameters.map(|(((name, at), (_, from)), (_, to))| BestParameter {
        name,
        at: Text(at),
        from: Text(from),
        to: Text(to),
    });
    let answer = BestExponentAnswer {
        schema: SCHEMA,
        scheme: &arguments.scheme,
        bounds: sides.into_iter().take(names.len()).map(|side| side.map(Text)).collect(),
        at_least: low,
        at_most: high,
        parameters: parameters.collect(),
        sum_rules: found.order,
        none_positive: found.least >= Rational::one(),
        but_exceptions: found.but_exceptions,
        special,
    };
    show(&arguments.output, &answer)
}

/// A decimal that is not above the greatest exponent, and one that is not below it.
fn exponents(found: &BestExponent) -> [String; 2] {
    let bound = |of: &Rational| {
        let term = LogTerm { factor: -Rational::one(), base: found.arity, of: of.clone() };
        let sum = LogSum { rational: Rational::zero(), terms: vec![term] };
        sum.enclosure(LEVEL)
    };
    let greatest = bound(&found.greatest);
    let most = match found.least.sign() {
        1 => bound(&found.least).upper().clone(),
        // Without a lower bound of the radius there is none.
        _ => Rational::from(found.order),
    };
    [down(greatest.lower()), up(&most.min(Rational::from(found.order)))]
}

/// The least value of a function in an interval.
struct Least {
    bounds: [Rational; 2],
    /// All points where it is taken are in this set.
    places: IntervalSet,
}

impl Least {
    fn of(function: &PiecewisePolynomial, domain: &IntervalSet, sides: &[Rational; 2]) -> Least {
        let below = |bound: &Rational| function.below(bound).intersection(domain);
        let rational =
            function.breakpoints().iter().filter_map(|place| place.as_rational().cloned());
        let inside = rational.filter(|place| domain.contains(place));
        let values = inside.chain(sides.iter().cloned()).map(|place| function.at(&place));
        let mut high = values.min().unwrap_or_else(Rational::one);
        if below(&high).is_empty() {
            let places = function.at_most(&high).intersection(domain);
            return Least { bounds: [high.clone(), high], places };
        }
        let mut low = Rational::zero();
        for _ in 0..HALVINGS {
            let middle = (&low + &high) * Rational::new(1, 2);
            if below(&middle).is_empty() {
                low = middle;
            } else {
                high = middle;
            }
        }
        let places = function.at_most(&high).intersection(domain);
        Least { bounds: [low, high], places }
    }
}

/// The least T_c in a parameter.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct BestContraction<'a> {
    /// The version of this form.
    schema: u32,
    /// The scheme as it was given.
    scheme: &'a str,
    /// The parameter.
    parameter: &'a str,
    /// c.
    levels: u32,
    /// The ends of the interval of the parameter.
    bounds: [Text<Rational>; 2],
    /// Bounds of the least T_c, which are equal if it is known exactly.
    least: [Text<Rational>; 2],
    /// All values of the parameter with the least T_c are here.
    places: Set,
}

impl Answer for BestContraction<'_> {
    const NAME: &'static str = "range-best-contraction";

    fn sheet(&self) -> Sheet {
        let BestContraction { scheme, parameter, levels, .. } = self;
        let mut sheet = Sheet::titled(format!("{scheme}: the least T_{levels}"));
        let [Text(low), Text(high)] = &self.bounds;
        let [Text(least), Text(greatest)] = &self.least;
        let value = if least == greatest {
            least.to_string()
        } else {
            format!("between {} and {}", down(least), up(greatest))
        };
        let fact = |name: &str, text: String| (name.to_owned(), text);
        sheet.facts(vec![
            fact(parameter, format!("from {low} to {high}")),
            fact(&format!("least T_{levels}"), value),
            fact("for", self.places.words()),
        ]);
        sheet
    }
}

/// The greatest Hölder exponent in one parameter or two.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct BestExponentAnswer<'a> {
    /// The version of this form.
    schema: u32,
    /// The scheme as it was given.
    scheme: &'a str,
    /// The ends of the intervals of the parameters.
    bounds: Vec<[Text<Rational>; 2]>,
    /// A decimal that is not above the greatest exponent.
    at_least: String,
    /// A decimal that is not below it, but where more sum rules hold than `sum_rules`.
    at_most: String,
    /// The order of the sum rules that hold for all values.
    sum_rules: usize,
    /// The parameters.
    parameters: Vec<BestParameter<'a>>,
    /// Whether the upper bound is 0 or less.
    #[serde(skip)]
    none_positive: bool,
    /// Whether single values may have a greater exponent: zeros of a polynomial.
    but_exceptions: bool,
    /// Of one parameter, the values at which the sum rules are of a higher order, or the support is shorter.
    special: Vec<SpecialForm>,
}

/// A parameter for which the exponent is greatest.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct BestParameter<'a> {
    /// Its name.
    name: &'a str,
    /// The value at which the exponent is at least `at_least`.
    at: Text<Rational>,
    /// No value with the greatest exponent is below this one.
    from: Text<Rational>,
    /// None is above this one.
    to: Text<Rational>,
}

impl Answer for BestExponentAnswer<'_> {
    const NAME: &'static str = "range-best-exponent";

    fn sheet(&self) -> Sheet {
        let mut sheet = Sheet::titled(format!("{}: the greatest Hölder exponent", self.scheme));
        let fact = |name: &str, text: String| (name.to_owned(), text);
        let most = format!(
            "at most {}, where no more sum rules hold than {}",
            self.at_most, self.sum_rules
        );
        let exponent = if self.none_positive {
            format!("no positive one: {most}")
        } else {
            format!("at least {}\n{most}", self.at_least)
        };
        let mut facts = vec![fact("exponent", exponent)];
        for (parameter, [Text(low), Text(high)]) in self.parameters.iter().zip(&self.bounds) {
            let BestParameter { name, at: Text(at), from: Text(from), to: Text(to) } = parameter;
            facts.push(fact(
                &format!("{name}, from {low} to {high}"),
                format!(
                    "the lower bound is that for {at}\nthe best values are between {} and {}",
                    short(from, 12),
                    short(to, 12)
                ),
            ));
        }
        sheet.facts(facts);
        if let [parameter] = &self.parameters[..] {
            write_special(&mut sheet, &self.special, parameter.name);
        }
        sheet.text(format!(
            "The lower bound is that of the values that are named: differences have a small spectral radius there. In \
             no other part of the box the radius is smaller, as products of matrices show. Where more sum rules hold \
             than {}, those of all values, the exponent may be greater.",
            self.sum_rules
        ));
        if self.but_exceptions {
            sheet.text(
                "Single values may have a greater exponent: those where the shifts of the basic limit function are \
                 linearly dependent.",
            );
        }
        sheet
    }
}
