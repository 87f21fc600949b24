//! Symbols that are made of the symbols of other schemes.

use super::error::SchemeError;
use super::mask::Mask;
use crate::cap::Cap;
use crate::formula::{
    Call, CallError, Context, Expr, Functions, Laurent, MAX_SYMBOL_POWER, Node, Value, differences,
    evaluate, parse,
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

/// The functions of a symbol: `symbol(NAME)` and `symbol(NAME, u)`, b(z) and b(u) of another scheme with the symbol b, u = c·z^m. Other options
/// are the values of parameters of this scheme.
pub(super) struct Composed<'a, F> {
    /// The names of the other schemes.
    pub(super) names: Vec<&'a str>,
    /// The mask of another scheme at values of its parameters.
    pub(super) mask: F,
}

impl<V, F> Functions<Laurent<V>> for Composed<'_, F>
where
    V: Value + PartialEq,
    F: Fn(&str, &BTreeMap<String, V>) -> Result<Mask<V>, SchemeError>,
{
    fn call(
        &self,
        call: &Call<'_, Laurent<V>>,
        context: &dyn Context<Laurent<V>>,
    ) -> Result<Laurent<V>, CallError> {
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
        let mask = (self.mask)(&name.word, &parameters).map_err(|error| match error.cap() {
            Some(cap) => CallError::BeyondCap(cap),
            None => misuse(error.to_string()),
        })?;
        let symbol = symbol_of(&mask);
        match call.arguments {
            [] => Ok(symbol),
            [place] => at(&symbol, place),
            _ => Err(misuse(
                "the form is symbol(NAME), or symbol(NAME, u) with u = c*z^m".to_owned(),
            )),
        }
    }

    fn is_scheme(&self, function: &str, name: &str) -> bool {
        function == SYMBOL && self.names.contains(&name)
    }
}

/// Σ_k a_k z^k, with a_{α,j} at the power α − n(o + j).
fn symbol_of<V: Value>(mask: &Mask<V>) -> Laurent<V> {
    let n = i64::try_from(mask.arity()).expect("a small arity");
    let rows = (0..).zip(mask.rules().rows());
    Laurent::of(rows.flat_map(|(alpha, row)| {
        (mask.offset()..).zip(row).map(move |(place, a)| (alpha - n * place, a.clone()))
    }))
}

/// b(c·z^m).
fn at<V: Value>(symbol: &Laurent<V>, place: &Laurent<V>) -> Result<Laurent<V>, CallError> {
    let misuse = || {
        let form =
            "the place of a symbol is c*z^m, m not 0, as in symbol(NAME, z^2) or symbol(NAME, 1/z)";
        CallError::Misuse(form.to_owned())
    };
    let (Some((m, last)), Some((low, high))) = (place.powers(), symbol.powers()) else {
        return Err(misuse());
    };
    if m != last || m == 0 {
        return Err(misuse());
    }
    let reach = low.unsigned_abs().max(high.unsigned_abs()).saturating_mul(m.unsigned_abs());
    if reach > MAX_SYMBOL_POWER {
        return Err(CallError::BeyondCap(Cap::new("the power of z", MAX_SYMBOL_POWER)));
    }
    let c = place.coefficient(m);
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
                terms.push((sign * step * m, symbol.coefficient(sign * step).times(&power)));
            }
        }
    }
    Ok(Laurent::of(terms))
}
