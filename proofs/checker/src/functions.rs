//! The functions of formulas, by their definitions.

use crate::convolution::{Convolution, MAX_LENGTH, Product, Sums, classes, large};
use crate::decimal::Q;
use crate::displacement::{displaced, gather, surface};
use crate::evaluate::{Indices, MAX_INTEGER, Scope};
use crate::formula::{Expr, Head};
use crate::number::Number;
use crate::reject::Stop;
use crate::scheme::Scheme;
use crate::value::Value;
use num_traits::ToPrimitive;
use std::cmp::Ordering;
use std::rc::Rc;

/// A depth that is looked for is at most two to the power of this.
const MAX_LEVEL_BITS: usize = 14;

/// A call, with the options that are not used yet.
struct Call<'c> {
    scope: &'c Scope<'c>,
    function: &'c str,
    arguments: &'c [Value],
    options: Vec<&'c (String, String)>,
    /// Whether it is not only the greatest sum that is asked for.
    every_sum: bool,
}

/// What is asked of the options of functions: which words there are, the default first.
const ORDER: [&str; 2] = ["adjoint", "forward"];
const TERMS: [&str; 2] = ["each", "total"];
const SUPREMA: [&str; 2] = ["independent", "joint"];
const RECURSION: [&str; 2] = ["derived", "printed"];

fn wrong<T>(what: impl Into<String>) -> Result<T, Stop> {
    Err(Stop::Wrong(what.into()))
}

/// The value of a function.
pub fn call(
    scope: &Scope<'_>,
    function: &str,
    arguments: &[Value],
    options: &[(String, String)],
    indices: &mut Indices,
) -> Result<Value, Stop> {
    let options = options.iter().collect();
    let mut call = Call { scope, function, arguments, options, every_sum: false };
    let value = call.value(indices)?;
    match call.options.first() {
        None => Ok(value),
        Some((name, _)) => wrong(format!("`{function}` takes no option `{name}`")),
    }
}

/// The sums that a call is the greatest of.
pub fn sums_of(scope: &Scope<'_>, expr: &Expr) -> Result<Sums, Stop> {
    let Expr::Of(Head::Call(function, options), arguments) = expr else {
        return wrong("this is no constant");
    };
    let arguments = arguments.iter().map(|argument| scope.value(argument));
    let arguments = &arguments.collect::<Result<Vec<Value>, Stop>>()?;
    let options = options.iter().collect();
    let mut call = Call { scope, function, arguments, options, every_sum: true };
    let (mut lists, _) = call.sums(&mut Vec::new())?;
    match lists.pop() {
        Some(sums) if lists.is_empty() && call.options.is_empty() => Ok(sums),
        _ => wrong("this is no constant that is attained in one class"),
    }
}

/// An integer from `least` to `most`, as an index.
fn within(value: &Value, least: i64, most: i64) -> Result<usize, Stop> {
    let integer = Some(value.integer(most)?).filter(|integer| *integer >= least);
    let index = integer.and_then(|integer| usize::try_from(integer).ok());
    index.ok_or_else(|| Stop::Wrong(format!("an integer from {least} to {most} is needed")))
}

fn whole(value: &Value) -> Result<Value, Stop> {
    Ok(Q::from_integer(value.floor()?).into())
}

fn number(value: usize) -> Value {
    Q::from_integer(value.into()).into()
}

impl Call<'_> {
    fn option(&mut self, name: &str) -> Option<String> {
        let at = self.options.iter().position(|(option, _)| option == name)?;
        Some(self.options.remove(at).1.clone())
    }

    /// The word of an option, as the reading has it.
    fn word(&mut self, name: &str, default: &str) -> String {
        let printed = self.option(name).unwrap_or_else(|| default.to_owned());
        self.scope.reading.word(self.function, name, &printed)
    }

    /// Which of these words an option has.
    fn choose(&mut self, name: &str, words: &[&str]) -> Result<usize, Stop> {
        let word = self.word(name, words[0]);
        let place = words.iter().position(|known| *known == word);
        place.ok_or_else(|| Stop::Wrong(format!("`{name}` cannot be `{word}`")))
    }

    /// The scheme that the call is about.
    fn scheme(&mut self) -> Result<Rc<Scheme>, Stop> {
        let scheme = match self.option("scheme") {
            None => self.scope.scheme.clone(),
            Some(name) => {
                let library = self.scope.library;
                let nothing = Scope::new(&library.nothing, library, self.scope.reading);
                library.resolve(&name, &nothing)?.first().cloned()
            }
        };
        scheme.ok_or_else(|| Stop::Wrong(format!("`{}` needs a scheme", self.function)))
    }

    fn value(&mut self, indices: &mut Indices) -> Result<Value, Stop> {
        let (scope, function) = (self.scope, self.function);
        let piece = scope.piece.as_ref();
        match (function, self.arguments) {
            ("cos", [angle]) => match angle.multiple_of("pi") {
                Some(multiple) => {
                    Ok(Number::cosine(&(multiple / Q::from_integer(2.into())))?.into())
                }
                None => wrong("`cos` takes one rational multiple of pi"),
            },
            ("abs", [x]) => x.abs(piece),
            ("max" | "min", [first, rest @ ..]) => {
                rest.iter().try_fold(first.clone(), |best, x| scope.join(function, &best, x))
            }
            ("floor", [x]) => whole(x),
            ("ceil", [x]) => whole(&x.negated()?)?.negated(),
            ("mod", [x, m]) => x.minus(&m.times(&whole(&x.over(m)?)?)?),
            ("kronecker", [a, b]) => {
                let difference = a.minus(b)?;
                Ok(Value::int(difference.number()?.is_zero().into()))
            }
            ("binomial", [top, bottom]) => binomial(scope, top, bottom.integer(10_000)?),
            ("levels", [ratio, x]) => self.levels(ratio, x),
            ("levels", [ratio, x, c]) => {
                let levels = self.levels(ratio, x)?;
                let block = self.choose("exponent", &["level", "block"])? == 1;
                if block { levels.times(c) } else { Ok(levels) }
            }
            ("arity", []) => Ok(number(self.scheme()?.arity())),
            ("width", []) => Ok(number(self.scheme()?.width())),
            ("mask" | "difference", [rule, column]) => {
                let scheme = self.scheme()?;
                let rules = if function == "mask" { &scheme.mask } else { &scheme.difference };
                let (rule, column) = (rule.integer(MAX_INTEGER)?, column.integer(MAX_INTEGER)?);
                let row = usize::try_from(rule).ok().and_then(|rule| rules.get(rule));
                let row = row.ok_or_else(|| Stop::Wrong(format!("there is no rule {rule}")))?;
                let entry = usize::try_from(column).ok().and_then(|column| row.get(column));
                Ok(entry.cloned().unwrap_or_else(|| Value::int(0)))
            }
            ("contraction" | "norm" | "tensor" | "convolution_norm", _) => {
                match self.sums(indices)? {
                    (lists, true) if lists.len() == 2 => {
                        let [one, other] = [&lists[0], &lists[1]];
                        let pairs = one.units.iter().zip(&*other.units);
                        let units = pairs.map(|(a, b)| a.times(b)).collect::<Result<_, _>>()?;
                        let scale = one.scale.times(&other.scale)?;
                        Sums { first: 0, units, scale }.greatest(scope)
                    }
                    (lists, _) => lists.iter().try_fold(Value::int(1), |product, list| {
                        product.times(&list.greatest(scope)?)
                    }),
                }
            }
            ("convolution", [c, l, f]) => {
                let (scheme, forward) = (self.scheme()?, self.choose("order", &ORDER)? == 1);
                let convolution = self.convolution(c, &number(scheme.arity()), 4)?;
                let product = convolution.of_scheme(scope.library, &scheme, "b", forward)?;
                coefficient(&product, l, f.integer(MAX_INTEGER)?)
            }
            ("convolved", [c, n, length, l, f]) => {
                let convolution = self.convolution(c, n, 3)?;
                let (sequences, f) = (self.sequences(length, indices)?, f.integer(MAX_INTEGER)?);
                let length = usize::try_from(f + 1).unwrap_or(0);
                let product = convolution.of(scope.library, &sequences[0], length)?;
                coefficient(&product, l, f)
            }
            ("displacement", []) => {
                let (scheme, terms) = (self.scheme()?, self.choose("terms", &TERMS)?);
                let word = self.word("offset", "own");
                let offset = if word == "own" { Some(scheme.offset) } else { word.parse().ok() };
                let offset = offset.filter(|o: &i64| o.abs() <= 10_000);
                let Some(o) = offset else { return wrong(format!("no offset: `{word}`")) };
                let moved = |alpha| gather(scope, &displaced(&scheme, alpha, o)?, terms);
                scope.greatest(&(0..scheme.arity()).map(moved).collect::<Result<Vec<_>, _>>()?)
            }
            ("surface_displacement", [x1, x2, x3]) => {
                let (scheme, terms) = (self.scheme()?, self.choose("terms", &TERMS)?);
                let sums = surface(scope, &scheme, [x1, x2, x3], terms)?;
                sums[1..].iter().try_fold(sums[0].clone(), |best, sum| best.max(sum, piece))
            }
            (_, arguments) => {
                wrong(format!("there is no `{function}` of {} arguments", arguments.len()))
            }
        }
    }

    fn convolution(&mut self, c: &Value, n: &Value, most: i64) -> Result<Convolution, Stop> {
        let (c, arity) = (within(c, 1, most)?, within(n, 2, 64)?);
        let printed = self.choose("recursion", &RECURSION)? == 1;
        Ok(Convolution { c: u32::try_from(c).unwrap_or(1), arity, printed })
    }

    /// The sequences that the options `sequence` and `with` name, at 0, …, length − 1.
    fn sequences(
        &mut self,
        length: &Value,
        indices: &mut Indices,
    ) -> Result<Vec<Vec<Value>>, Stop> {
        let length = within(length, 1, 1_000)?;
        let index = self.option("index").unwrap_or_else(|| "q".to_owned());
        self.scope.index(&index)?;
        let Some(first) = self.option("sequence") else { return wrong("no `sequence`") };
        let mut value = |name: &str, q: usize| {
            indices.push((index.clone(), number(q)));
            let value = self.scope.name(name, indices);
            indices.pop();
            value
        };
        let second = self.options.iter().position(|(option, _)| option == "with");
        let second = second.map(|at| self.options.remove(at).1.clone());
        let names = [first].into_iter().chain(second);
        names.map(|name| (0..length).map(|q| value(&name, q)).collect()).collect()
    }

    /// What `contraction`, `norm`, `tensor` and `convolution_norm` are the greatest of: the sums of
    /// one or two sequences, and whether their suprema are joint.
    fn sums(&mut self, indices: &mut Indices) -> Result<(Vec<Sums>, bool), Stop> {
        let scope = self.scope;
        let lists = match (self.function, self.arguments) {
            ("convolution_norm", [c, n, length, last]) => {
                let convolution = self.convolution(c, n, 16)?;
                let joint = self.choose("suprema", &SUPREMA)? == 1;
                let last = usize::try_from(last.integer(MAX_INTEGER)?).unwrap_or(0);
                if last > MAX_LENGTH {
                    return Err(Stop::Capped("the length of a product of sequences"));
                }
                let first = (last + 1).saturating_sub(convolution.classes());
                let sums = self.sequences(length, indices)?.into_iter().map(|sequence| {
                    let product = convolution.of(scope.library, &sequence, last + 1)?;
                    product.sums(scope, first, last)
                });
                return Ok((sums.collect::<Result<_, Stop>>()?, joint));
            }
            ("contraction", [_]) => &["b"][..],
            ("norm", [_]) => &["a"],
            ("tensor", [_]) => &["b", "a"],
            (function, _) => return wrong(format!("`{function}` is no constant of this kind")),
        };
        let (scheme, c) = (self.scheme()?, &self.arguments[0]);
        let forward = self.choose("order", &ORDER)? == 1;
        if self.function == "contraction" && self.choose("terms", &TERMS)? == 1 {
            if *c != Value::int(1) {
                return Err(Stop::Undefined("`terms = total` is defined for c = 1 only"));
            }
            let sums = scheme.difference.iter().map(|row| gather(scope, row, 1));
            return Ok((vec![Sums::new(sums.collect::<Result<_, _>>()?)], false));
        }
        let joint = self.function == "tensor" && self.choose("suprema", &SUPREMA)? == 1;
        let sums = lists.iter().map(|of| match large(scope, &scheme, of, forward, c) {
            Some(value) if !joint && !self.every_sum => Ok(Sums::new(vec![value])),
            _ => classes(scope, &scheme, of, forward, c),
        });
        Ok((sums.collect::<Result<_, _>>()?, joint))
    }

    /// The logarithm of x to the base `ratio`, as an integer of at least 0.
    fn levels(&mut self, ratio: &Value, x: &Value) -> Result<Value, Stop> {
        let rounding = self.choose("rounded", &["up", "nearest", "down"])?;
        let one = Value::int(1);
        let between = ratio.sign(None)? > 0 && ratio.compare(&one)?.is_lt();
        if !between || x.sign(None)? <= 0 {
            let why = "no depth: the ratio is not between 0 and 1, or x not positive";
            return Err(Stop::Undefined(why));
        }
        // Without fractions: pairs of a top and a bottom.
        let pair = |value: &Value| {
            let bottom = Value::denominator([value])?;
            Ok::<_, Stop>((value.times(&bottom)?, bottom))
        };
        let times = |(a, b): &(Value, Value), (c, d): &(Value, Value)| {
            Ok::<_, Stop>((a.times(c)?, b.times(d)?))
        };
        let compare =
            |(a, b): &(Value, Value), (c, d): &(Value, Value)| a.times(d)?.compare(&b.times(c)?);
        let (ratio, x) = (pair(ratio)?, pair(x)?);
        // ratio to the powers 1, 2, 4, …, as long as they are above x.
        let mut powers = vec![ratio.clone()];
        while let Some(last) = powers.last()
            && compare(last, &x)?.is_gt()
        {
            if powers.len() > MAX_LEVEL_BITS {
                return Err(Stop::Capped("the depth"));
            }
            self.scope.library.spend(last.0.cost(&last.0) + last.1.cost(&last.1))?;
            powers.push(times(last, last)?);
        }
        // The greatest k with ratio^k > x, digit by digit, and then the next.
        let (mut k, mut power) = (0_i64, (one.clone(), one));
        if compare(&power, &x)?.is_gt() {
            for (i, next) in powers.iter().enumerate().rev() {
                let next = times(&power, next)?;
                if compare(&next, &x)?.is_gt() {
                    (k, power) = (k + (1 << i), next);
                }
            }
            (k, power) = (k + 1, times(&power, &ratio)?);
        }
        // ⌊t + 1/2⌋ for t = log(x): k if ratio^(2k−1) ≥ x², that is t ≥ k − 1/2.
        let near = || {
            compare(&times(&times(&x, &x)?, &ratio)?, &times(&power, &power)?).map(Ordering::is_le)
        };
        let kept =
            k == 0 || rounding == 0 || compare(&power, &x)?.is_eq() || rounding == 1 && near()?;
        Ok(Value::int(if kept { k } else { k - 1 }))
    }
}

/// E^c_{l,f}.
fn coefficient(product: &Product, l: &Value, f: i64) -> Result<Value, Stop> {
    // Sums of E stop at l = 0, so that another l would be another number.
    let l = within(l, 0, MAX_INTEGER)?;
    usize::try_from(f).map_or(Ok(Value::int(0)), |f| product.at(l, f))
}

/// top(top − 1)…(top − bottom + 1)/bottom!, and 0 for bottom < 0.
fn binomial(scope: &Scope<'_>, top: &Value, bottom: i64) -> Result<Value, Stop> {
    scope.library.spend(bottom.to_u64().unwrap_or(0))?;
    (0..bottom).try_fold(Value::int((bottom >= 0).into()), |product, i| {
        product.times(&top.minus(&Value::int(i))?)?.over(&Value::int(i + 1))
    })
}
