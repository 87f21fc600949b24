//! Symbols that are made of the symbols of other schemes.

use super::error::SchemeError;
use super::lattice::dilation::Point;
use super::lattice::mask::LatticeMask;
use super::mask::Mask;
use crate::cap::Cap;
use crate::formula::{
    Call, CallError, Context, Expr, Functions, Laurent, MAX_SYMBOL_POWER, Node, Power, Value,
    differences, evaluate, parse,
};
use std::collections::{BTreeMap, BTreeSet};

/// The function whose value is the symbol of another scheme.
const SYMBOL: &str = "symbol";

/// The option that names the scheme.
const SCHEME: &str = "scheme";

/// The names of the schemes whose symbols a formula uses.
pub(super) fn composed_of(expr: &Expr) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    if let Node::Call { function, arguments, options } = &expr.node
        && function == SYMBOL
    {
        let option = options.iter().find(|option| option.name == SCHEME);
        let first = || Some(differences(arguments.first()?)?.join("-"));
        names.extend(option.map(|option| option.word.clone()).or_else(first));
    }
    names.extend(expr.parts().into_iter().flat_map(composed_of));
    names
}

/// The symbol of another scheme.
pub(super) enum SymbolOf<V> {
    /// That of a curve, in z.
    Curve(Laurent<V>),
    /// That of a mask on Z^d, in x, y and z.
    Lattice(Laurent<V, Point>),
}

impl<V: Value> SymbolOf<V> {
    /// Σ_k a_k z^k, with a_{α,j} at the power α − n(o + j).
    pub(super) fn curve(mask: &Mask<V>) -> SymbolOf<V> {
        let n = i64::try_from(mask.arity()).expect("a small arity");
        let rows = (0..).zip(mask.rules().rows());
        SymbolOf::Curve(Laurent::of(rows.flat_map(|(alpha, row)| {
            (mask.offset()..).zip(row).map(move |(place, a)| (alpha - n * place, a.clone()))
        })))
    }

    /// Σ_α a(α) (x, y, z)^α.
    pub(super) fn lattice(mask: &LatticeMask<V>) -> SymbolOf<V> {
        let terms = mask.coefficients().iter().map(|(place, c)| (*place, c.clone()));
        SymbolOf::Lattice(Laurent::of(terms))
    }
}

/// The powers of the symbols that may be made of others.
pub(super) trait Whole: Power {
    /// How a symbol at another place is written.
    const FORM: &'static str;

    /// The symbol of another scheme as it stands.
    fn whole<V>(symbol: SymbolOf<V>) -> Option<Laurent<V, Self>>;
}

impl Whole for i64 {
    const FORM: &'static str =
        "the place of a symbol is c*z^m, m not 0, as in symbol(NAME, z^2) or symbol(NAME, 1/z)";
    fn whole<V>(symbol: SymbolOf<V>) -> Option<Laurent<V>> {
        if let SymbolOf::Curve(symbol) = symbol { Some(symbol) } else { None }
    }
}

impl Whole for Point {
    const FORM: &'static str = "the symbol of a mask of curves stands at a power of the variables, as in symbol(NAME, x)*symbol(NAME, y) or \
         symbol(NAME, x*y); that of a mask on Z^d alone, as in symbol(NAME)";
    fn whole<V>(symbol: SymbolOf<V>) -> Option<Laurent<V, Point>> {
        if let SymbolOf::Lattice(symbol) = symbol { Some(symbol) } else { None }
    }
}

/// The symbols of other schemes at values of their parameters, by name.
pub(super) trait Symbols<V>:
    Fn(&str, &BTreeMap<String, V>) -> Result<SymbolOf<V>, SchemeError>
{
}

impl<V, F> Symbols<V> for F where
    F: Fn(&str, &BTreeMap<String, V>) -> Result<SymbolOf<V>, SchemeError>
{
}

/// The functions of a symbol: `symbol(NAME)` and `symbol(NAME, u)`, b(z) and b(u) of another scheme with the symbol b, u = c·z^m. Other options
/// are the values of parameters of this scheme.
pub(super) struct Composed<'a, F> {
    /// The names of the other schemes.
    pub(super) names: Vec<&'a str>,
    /// The symbol of another scheme at values of its parameters.
    pub(super) symbol: F,
}

impl<V, P, F> Functions<Laurent<V, P>> for Composed<'_, F>
where
    V: Value + PartialEq,
    P: Whole,
    F: Symbols<V>,
{
    fn call(
        &self,
        call: &Call<'_, Laurent<V, P>>,
        context: &dyn Context<Laurent<V, P>>,
    ) -> Result<Laurent<V, P>, CallError> {
        if call.function != SYMBOL {
            return Err(CallError::UnknownFunction(vec![SYMBOL.to_owned()]));
        }
        let misuse = |message: String| CallError::Misuse(message);
        let name = call.options.iter().find(|option| option.name == SCHEME);
        let name = name.ok_or_else(|| {
            misuse(
                "name a scheme of the catalogue, or one that stands before this: symbol(chaikin)"
                    .to_owned(),
            )
        })?;
        let mut parameters = BTreeMap::new();
        for option in call.options.iter().filter(|option| option.name != SCHEME) {
            let value = parse(&option.word).and_then(|expr| evaluate(&expr, context));
            let value = value.map_err(|error| CallError::Inner(error.kind))?;
            let value = value.as_constant().ok_or_else(|| {
                misuse(format!("the parameter `{}` is a number, without z in it", option.name))
            })?;
            parameters.insert(option.name.clone(), value);
        }
        let symbol = (self.symbol)(&name.word, &parameters).map_err(|error| match error.cap() {
            Some(cap) => CallError::BeyondCap(cap),
            None => misuse(error.to_string()),
        })?;
        let form = || misuse(P::FORM.to_owned());
        match (call.arguments, symbol) {
            ([], symbol) => P::whole(symbol).ok_or_else(form),
            ([place], SymbolOf::Curve(symbol)) => at(&symbol, place),
            _ => Err(form()),
        }
    }

    fn is_scheme(&self, function: &str, name: &str) -> bool {
        function == SYMBOL && self.names.contains(&name)
    }
}

/// b(c·u) for a power u of the variables.
fn at<V: Value, P: Whole>(
    symbol: &Laurent<V>,
    place: &Laurent<V, P>,
) -> Result<Laurent<V, P>, CallError> {
    let misuse = || CallError::Misuse(P::FORM.to_owned());
    let (Some((u, last)), Some((low, high))) = (place.powers(), symbol.powers()) else {
        return Err(misuse());
    };
    if u != last || u == P::ZERO {
        return Err(misuse());
    }
    let most = u.exponents().map(|(_, m)| m.unsigned_abs()).max().unwrap_or(0);
    let reach = low.unsigned_abs().max(high.unsigned_abs()).saturating_mul(most);
    if reach > MAX_SYMBOL_POWER {
        return Err(CallError::BeyondCap(Cap::new("the power of z", MAX_SYMBOL_POWER)));
    }
    let c = place.coefficient(u);
    let one = V::from_rational(&crate::exact::Rational::one());
    let inverse = one.divided(&c).map_err(CallError::Inner)?;
    let mut terms = Vec::new();
    for (sign, factor, last) in [(1, &c, high), (-1, &inverse, -low)] {
        // The coefficient of z^0 counts once.
        let mut power = one.clone();
        for step in 0..=last {
            if step > 0 {
                power = power.times(factor);
            }
            if step > 0 || sign > 0 {
                let place = u.with(P::ZERO, |m, _| sign * step * m);
                terms.push((place, symbol.coefficient(sign * step).times(&power)));
            }
        }
    }
    Ok(Laurent::of(terms))
}
