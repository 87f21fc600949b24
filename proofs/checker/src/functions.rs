//! The functions of schemes and sequences, by their definitions.

use crate::convolution::{Convolution, classes, sums};
use crate::decimal::{Q, int};
use crate::evaluate::{Indices, Scope};
use crate::formula::Expr;
use crate::number::Number;
use crate::scheme::{Scheme, total};
use crate::value::{Stop, Value};
use std::rc::Rc;

/// The greatest depth that is looked for.
const MAX_LEVEL: i64 = 20_000;

/// The greatest index of a coefficient.
const MAX_INDEX: i64 = 1_000_000;

/// The options of a call that are not used yet.
struct Options<'c> {
    scope: &'c Scope<'c>,
    function: &'c str,
    left: Vec<&'c (String, String)>,
}

const ORDER: [&str; 2] = ["adjoint", "forward"];
const TERMS: [&str; 2] = ["each", "total"];
const SUPREMA: [&str; 2] = ["independent", "joint"];
const RECURSION: [&str; 2] = ["derived", "printed"];

impl Options<'_> {
    fn take(&mut self, name: &str) -> Option<String> {
        let at = self.left.iter().position(|(option, _)| option == name)?;
        Some(self.left.remove(at).1.clone())
    }

    /// The word of an option, as the reading has it.
    fn word(&mut self, name: &str, default: &str) -> String {
        let printed = self.take(name).unwrap_or_else(|| default.to_owned());
        self.scope.reading.word(self.function, name, &printed)
    }

    /// Which of these words an option has; the first one is the default.
    fn choose(&mut self, name: &str, words: &[&str]) -> Result<usize, Stop> {
        let word = self.word(name, words[0]);
        let place = words.iter().position(|known| *known == word);
        place.ok_or_else(|| Stop::Wrong(format!("`{name}` cannot be `{word}`")))
    }
}

/// The value of a function.
pub fn call(
    scope: &Scope<'_>,
    function: &str,
    arguments: &[Value],
    given: &[(String, String)],
    indices: &mut Indices,
) -> Result<Value, Stop> {
    let mut options = Options { scope, function, left: given.iter().collect() };
    let value = match (function, arguments) {
        ("levels", [ratio, x]) => levels(scope, ratio, x, &mut options)?,
        ("levels", [ratio, x, c]) => {
            let levels = levels(scope, ratio, x, &mut options)?;
            let block = options.choose("exponent", &["level", "block"])? == 1;
            if block { levels.times(c)? } else { levels }
        }
        ("convolved", [c, n, length, l, f]) => {
            let convolution = convolution(c, n, &mut options, 3)?;
            let sequences = sequences(scope, length, &mut options, indices)?;
            let f = f.integer(MAX_INDEX)?;
            let product = convolution.of(scope.library, &sequences[0], place(f + 1))?;
            coefficient(&product, convolution.stride(), l, f)?
        }
        ("convolution_norm" | "contraction" | "norm" | "tensor", _) => {
            let (_, lists, joint) = class_sums(scope, arguments, &mut options, indices)?;
            product_of_norms(scope, &lists, joint)?
        }
        _ => of_scheme(scope, function, arguments, &mut options)?,
    };
    match options.left.first() {
        None => Ok(value),
        Some((name, _)) => Err(Stop::Wrong(format!("`{function}` takes no option `{name}`"))),
    }
}

/// An integer as the index of a list; negative ones as 0.
fn place(value: i64) -> usize {
    usize::try_from(value).unwrap_or(0)
}

/// An integer from `least` to `most`.
fn within(value: &Value, least: i64, most: i64) -> Result<usize, Stop> {
    let integer = value.integer(most)?;
    if integer < least {
        return Err(Stop::Wrong(format!("an integer from {least} to {most} is needed")));
    }
    Ok(place(integer))
}

fn convolution(
    c: &Value,
    n: &Value,
    options: &mut Options<'_>,
    most: i64,
) -> Result<Convolution, Stop> {
    let (c, arity) = (within(c, 1, most)?, within(n, 2, 64)?);
    let printed = options.choose("recursion", &RECURSION)? == 1;
    Ok(Convolution { c: u32::try_from(c).unwrap_or(1), arity, printed })
}

/// The sequences that the options `sequence` and `with` name, at 0, …, length − 1.
fn sequences(
    scope: &Scope<'_>,
    length: &Value,
    options: &mut Options<'_>,
    indices: &mut Indices,
) -> Result<Vec<Vec<Value>>, Stop> {
    let length = within(length, 1, 1_000)?;
    let index = options.take("index").unwrap_or_else(|| "q".to_owned());
    let first = options.take("sequence");
    let first = first.ok_or_else(|| Stop::Wrong("`sequence` is missing".into()))?;
    let mut sequences = Vec::new();
    for name in [Some(first), options.take("with")].into_iter().flatten() {
        let mut sequence = Vec::new();
        for q in 0..length {
            indices.push((index.clone(), Value::from(Q::from_integer(q.into()))));
            let value = scope.name(&name, indices);
            indices.pop();
            sequence.push(value?);
        }
        sequences.push(sequence);
    }
    Ok(sequences)
}

/// E_{l,f} of a product of sequences.
fn coefficient(product: &[Value], stride: usize, l: &Value, f: i64) -> Result<Value, Stop> {
    // Sums of E stop at l = 0, so that another l would be another number.
    let l = within(l, 0, MAX_INDEX)?;
    let at =
        l.checked_mul(stride).and_then(|skipped| usize::try_from(f).ok()?.checked_sub(skipped));
    Ok(at.and_then(|at| product.get(at)).cloned().unwrap_or_else(|| Value::int(0)))
}

/// The greatest of these, and of 0.
pub fn greatest(scope: &Scope<'_>, values: &[Value]) -> Result<Value, Stop> {
    let zero = Value::int(0);
    values.iter().try_fold(zero, |best, value| best.max(value, scope.piece.as_ref()))
}

/// The product of the greatest numbers of the lists, or the greatest product of numbers
/// that stand in the same place.
fn product_of_norms(scope: &Scope<'_>, lists: &[Vec<Value>], joint: bool) -> Result<Value, Stop> {
    match lists {
        [first, second] if joint => {
            let products = first.iter().zip(second).map(|(a, b)| a.times(b));
            greatest(scope, &products.collect::<Result<Vec<_>, _>>()?)
        }
        [first, second] => greatest(scope, first)?.times(&greatest(scope, second)?),
        lists => greatest(scope, lists.first().map_or(&[], Vec::as_slice)),
    }
}

/// What `contraction`, `norm`, `tensor` and `convolution_norm` are the greatest of: the place
/// of the first sum, the sums of one or two sequences, and whether their suprema are joint.
fn class_sums(
    scope: &Scope<'_>,
    arguments: &[Value],
    options: &mut Options<'_>,
    indices: &mut Indices,
) -> Result<(usize, Vec<Vec<Value>>, bool), Stop> {
    let function = options.function;
    if let ("convolution_norm", [c, n, length, last]) = (function, arguments) {
        let convolution = convolution(c, n, options, 16)?;
        let joint = options.choose("suprema", &SUPREMA)? == 1;
        let sequences = sequences(scope, length, options, indices)?;
        let last = place(last.integer(MAX_INDEX)?);
        let sums = sequences.iter().map(|sequence| {
            let product = convolution.of(scope.library, sequence, last + 1)?;
            sums(scope, &product, &convolution, last)
        });
        let sums = sums.collect::<Result<Vec<_>, Stop>>()?;
        return Ok((last + 1 - sums.first().map_or(1, Vec::len), sums, joint));
    }
    let scheme = scheme_of(scope, options)?;
    let [c] = arguments else {
        return Err(Stop::Wrong(format!("`{function}` does not take so many arguments")));
    };
    let forward = options.choose("order", &ORDER)? == 1;
    let of = match function {
        "contraction" => &["b"][..],
        "norm" => &["a"],
        _ => &["b", "a"],
    };
    let joint = function == "tensor" && options.choose("suprema", &SUPREMA)? == 1;
    if function == "contraction" && options.choose("terms", &TERMS)? == 1 {
        if c.integer(1)? != 1 {
            return Err(Stop::Wrong("`terms = total` is defined for c = 1 only".into()));
        }
        let sums = scheme.difference.iter().map(|row| gather(scope, row, 1));
        return Ok((0, vec![sums.collect::<Result<_, _>>()?], false));
    }
    let lists = of.iter().map(|of| classes(scope, &scheme, of, forward, c));
    Ok((0, lists.collect::<Result<_, _>>()?, joint))
}

/// The sums that a call is the greatest of, and the place of the first one.
pub fn sums_of(scope: &Scope<'_>, expr: &Expr) -> Result<(usize, Vec<Value>), Stop> {
    let wrong = || Stop::Wrong("this is no constant that is attained in one class".into());
    let Expr::Call(function, arguments, given) = expr else { return Err(wrong()) };
    if !["contraction", "norm", "convolution_norm"].contains(&function.as_str()) {
        return Err(wrong());
    }
    let values = arguments.iter().map(|argument| scope.value(argument));
    let mut options = Options { scope, function, left: given.iter().collect() };
    let values = values.collect::<Result<Vec<Value>, Stop>>()?;
    let (first, mut lists, _) = class_sums(scope, &values, &mut options, &mut Vec::new())?;
    if lists.len() == 1 && options.left.is_empty() {
        Ok((first, lists.swap_remove(0)))
    } else {
        Err(wrong())
    }
}

/// The scheme that a call is about.
fn scheme_of(scope: &Scope<'_>, options: &mut Options<'_>) -> Result<Rc<Scheme>, Stop> {
    let scheme = match options.take("scheme") {
        None => scope.scheme.clone(),
        Some(name) => {
            let nothing = Scope::new(&scope.library.nothing, scope.library, scope.reading);
            scope.library.resolve(&name, &nothing)?.first().cloned()
        }
    };
    scheme.ok_or_else(|| Stop::Wrong(format!("`{}` needs a scheme", options.function)))
}

fn of_scheme(
    scope: &Scope<'_>,
    function: &str,
    arguments: &[Value],
    options: &mut Options<'_>,
) -> Result<Value, Stop> {
    let scheme = scheme_of(scope, options)?;
    match (function, arguments) {
        ("displacement", []) => {
            let terms = options.choose("terms", &TERMS)?;
            let offset = match options.word("offset", "own").as_str() {
                "own" => scheme.offset,
                word => word
                    .parse()
                    .ok()
                    .filter(|o: &i64| o.abs() <= 10_000)
                    .ok_or_else(|| Stop::Wrong(format!("`offset` cannot be `{word}`")))?,
            };
            let moved = |alpha| gather(scope, &displaced(&scheme, alpha, offset)?, terms);
            greatest(scope, &(0..scheme.arity()).map(moved).collect::<Result<Vec<_>, _>>()?)
        }
        ("surface_displacement", [x1, x2, x3]) => {
            let terms = options.choose("terms", &TERMS)?;
            surface_displacement(scope, &scheme, [x1, x2, x3], terms)
        }
        ("mask" | "difference", [rule, column]) => {
            let rules = if function == "mask" { &scheme.mask } else { &scheme.difference };
            let (rule, column) = (rule.integer(MAX_INDEX)?, column.integer(MAX_INDEX)?);
            let row = usize::try_from(rule).ok().and_then(|rule| rules.get(rule));
            let row = row.ok_or_else(|| Stop::Wrong(format!("there is no rule {rule}")))?;
            let entry = usize::try_from(column).ok().and_then(|column| row.get(column));
            Ok(entry.cloned().unwrap_or_else(|| Value::int(0)))
        }
        ("convolution", [c, l, f]) => {
            let forward = options.choose("order", &ORDER)? == 1;
            let convolution = convolution(c, &number(scheme.arity()), options, 4)?;
            let product = convolution.of_scheme(scope.library, &scheme, "b", forward)?;
            coefficient(&product, convolution.stride(), l, f.integer(MAX_INDEX)?)
        }
        ("arity", []) => Ok(number(scheme.arity())),
        ("width", []) => Ok(number(scheme.width())),
        _ => Err(Stop::Wrong(format!("there is no such function as `{function}`"))),
    }
}

fn number(value: usize) -> Value {
    Value::from(Q::from_integer(value.into()))
}

/// Σ|·| with terms 0, |Σ·| with terms 1.
pub fn gather(scope: &Scope<'_>, values: &[Value], terms: usize) -> Result<Value, Stop> {
    let piece = scope.piece.as_ref();
    if terms == 1 {
        return total(values)?.abs(piece);
    }
    values.iter().try_fold(Value::int(0), |sum, value| sum.plus(1, &value.abs(piece)?))
}

/// ã_{α,m} of x'_{ni+α} − ((1−α/n)x_i + (α/n)x_{i+1}) = Σ_m ã_{α,m} Δ_{i+m}, in the order
/// of m, from m = min(0, o) on.
pub fn displaced(scheme: &Scheme, alpha: usize, offset: i64) -> Result<Vec<Value>, Stop> {
    let row = &scheme.mask[alpha];
    let width = i64::try_from(row.len()).unwrap_or(0);
    let mut coefficients = Vec::new();
    for m in offset.min(0)..=(offset + width - 2).max(0) {
        // x_{i+s} − x_i is the sum of the Δ_{i+m}, 0 ≤ m < s, or minus that of those with
        // s ≤ m < 0: Δ_{i+m} has the weights of the s > m, or minus those of the s ≤ m.
        let cut = place((m + 1 - offset).clamp(0, width));
        let sum =
            if m < 0 { Value::int(0).plus(-1, &total(&row[..cut])?)? } else { total(&row[cut..])? };
        coefficients.push(if m == 0 {
            sum.plus(-1, &fraction(alpha, scheme.arity()))?
        } else {
            sum
        });
    }
    Ok(coefficients)
}

fn fraction(top: usize, bottom: usize) -> Value {
    Value::from(Q::new(top.into(), bottom.into()))
}

/// max over α, β of x1·η¹ + x2·η² + x3·η³, as FORMAT.md has it.
fn surface_displacement(
    scope: &Scope<'_>,
    scheme: &Scheme,
    spreads: [&Value; 3],
    terms: usize,
) -> Result<Value, Stop> {
    let (n, piece) = (scheme.arity(), scope.piece.as_ref());
    let mut best: Option<Value> = None;
    for alpha in 0..n {
        for beta in 0..n {
            // A_α = Σ_{h≥1} a_{α,h}, and s_α the sum of the ã_{α,m} with m ≥ 1.
            let (a, b) = (total(&scheme.mask[alpha][1..])?, total(&scheme.mask[beta][1..])?);
            let s_alpha = gather(scope, &displaced(scheme, alpha, 0)?[1..], terms)?;
            let s_beta = gather(scope, &displaced(scheme, beta, 0)?[1..], terms)?;
            let first = &scheme.mask[beta][0];
            let norm = gather(scope, &scheme.mask[alpha], terms)?;
            let near = |value: Value, top: usize, bottom: usize| {
                value.plus(-1, &fraction(top, bottom))?.abs(piece)
            };
            let eta = [
                near(first.times(&a)?, alpha * (n - beta), n * n)?
                    .plus(1, &first.abs(piece)?.times(&s_alpha)?)?,
                near(b.clone(), beta, n)?.plus(1, &norm.times(&s_beta)?)?,
                near(a.times(&b)?, alpha * beta, n * n)?
                    .plus(1, &b.abs(piece)?.times(&s_alpha)?)?,
            ];
            let mut sum = Value::int(0);
            for (eta, spread) in eta.iter().zip(spreads) {
                sum = sum.plus(1, &eta.times(spread)?)?;
            }
            best = Some(match best {
                None => sum,
                Some(best) => best.max(&sum, piece)?,
            });
        }
    }
    best.ok_or_else(|| Stop::Wrong("a scheme has rules".into()))
}

/// The logarithm of x to the base `ratio`, as an integer of at least 0.
fn levels(
    scope: &Scope<'_>,
    ratio: &Value,
    x: &Value,
    options: &mut Options<'_>,
) -> Result<Value, Stop> {
    let rounding = options.choose("rounded", &["up", "nearest", "down"])?;
    let one = Value::int(1);
    if ratio.sign(None)? <= 0 || x.sign(None)? <= 0 || ratio.plus(-1, &one)?.sign(None)? >= 0 {
        return Err(Stop::Undefined(
            "no depth: the ratio is not between 0 and 1, or x not positive",
        ));
    }
    let (ratio, x) = (ratio.number()?, x.number()?);
    let (r, y, mut power, mut k) = (ratio.rational(), x.rational(), Number::from(int(1)), 0);
    // left/right = r^k/y; up is the first k where that is at most 1.
    let ends = y.as_ref().map(|y| (y.denom().clone(), y.numer().clone()));
    let (mut left, mut right) = ends.unwrap_or_default();
    let field = Stop::Capped("the field of the cosines");
    // Whether ratio^k < x, and whether ratio^(2k−1) ≥ x².
    let (below, near) = loop {
        if let (Some(r), Some(_)) = (&r, &y) {
            if left <= right {
                let near = &left * &left * r.denom() >= &right * &right * r.numer();
                break (left < right, near);
            }
            left *= r.numer();
            right *= r.denom();
            scope.library.spend(1 + right.bits() / 1024)?;
        } else {
            let above = power.plus(-1, x).and_then(|d| d.sign()).ok_or(field.clone())?;
            if above <= 0 {
                let square = x.times(x).and_then(|square| square.times(ratio));
                let near =
                    square.zip(power.times(&power)).and_then(|(b, a)| a.plus(-1, &b)?.sign());
                break (above < 0, near.ok_or(field)? >= 0);
            }
            power = power.times(ratio).ok_or(field.clone())?;
            scope.library.spend(1 + power.bits() / 64)?;
        }
        k += 1;
        if k > MAX_LEVEL {
            return Err(Stop::Capped("the depth"));
        }
    };
    Ok(Value::int(match rounding {
        0 => k,
        // ⌊t + 1/2⌋ for t = log(x): k if ratio^(2k−1) ≥ x², that is t ≥ k − 1/2.
        1 if near || k == 0 => k,
        _ => k - i64::from(below && k > 0),
    }))
}
