//! A call of a function, with its options.

#![warn(clippy::arithmetic_side_effects)]

use crate::formulas::{Asked, Indices, MAX_INTEGER, Scope, is_name, number_of};
use crate::numbers::{Piece, Value, count};
use crate::schemes::{Convolution, Family, Library, LocalRules, Scheme, Sequence};
use crate::text::Stop;
use std::rc::Rc;

/// The words that these options may have. The default is the first.
pub const TERMS: [&str; 2] = ["each", "total"];
pub const SUPREMA: [&str; 2] = ["independent", "joint"];
/// The options of functions. Others are parameters of a scheme that is named.
const WORDS: [&str; 16] = [
    "data",
    "derivative",
    "exponent",
    "index",
    "offset",
    "orbit",
    "order",
    "parameters",
    "part",
    "recursion",
    "rounded",
    "sequence",
    "suprema",
    "tangent",
    "terms",
    "with",
];

/// The functions in which filters stand.
const OF_FILTERS: [&str; 12] = [
    "arity",
    "biorthogonal",
    "coefficient",
    "hurwitz",
    "modulus",
    "modulus_lower",
    "modulus_upper",
    "orthogonal",
    "same",
    "symbol_at",
    "symmetric",
    "vanishing_moments",
];

const ORDER: [&str; 2] = ["adjoint", "forward"];
const RECURSION: [&str; 2] = ["derived", "printed"];

/// A call of a function. It keeps the options that are not used yet.
pub struct Call<'c> {
    /// The schemes, with caches of their constants.
    pub library: &'c Library<'c>,
    /// The meanings of names.
    pub scope: &'c Scope<'c>,
    /// The name of the function.
    pub function: &'c str,
    /// The values of the arguments.
    pub arguments: &'c [Value],
    options: Vec<&'c (String, String)>,
    /// The scheme that the call is about, once it has been asked for.
    subject: Option<Subject>,
}

/// What a call is about.
#[derive(Clone)]
enum Subject {
    Scheme(Rc<Scheme>),
    Family(Rc<Family>),
}

pub const NO_FUNCTION: Stop = Stop::Family("this function of a scheme that depends on the index");

pub fn wrong<T>(what: impl Into<String>) -> Result<T, Stop> {
    Err(Stop::Wrong(what.into()))
}

/// Reads an integer from `least` to `most` as an index. A greater one is beyond a cap.
pub fn within(value: &Value, least: i64, most: i64) -> Result<usize, Stop> {
    between(value.integer(most)?, least, most)
}

/// The same where a greater one is no index at all.
pub fn index(value: &Value, least: i64, most: i64) -> Result<usize, Stop> {
    between(value.integer(MAX_INTEGER)?, least, most)
}

fn between(integer: i64, least: i64, most: i64) -> Result<usize, Stop> {
    let index = usize::try_from(integer).ok().filter(|_| (least..=most).contains(&integer));
    index.ok_or_else(|| Stop::Wrong(format!("an integer from {least} to {most} is needed")))
}

/// A count as a value.
pub fn number(value: usize) -> Value {
    count(value).into()
}

impl<'c> Call<'c> {
    /// A call with all of its options.
    pub fn new(library: &'c Library<'c>, scope: &'c Scope<'c>, of: Asked<'c>) -> Call<'c> {
        let (function, arguments, options) = of;
        Call {
            library,
            scope,
            function,
            arguments,
            options: options.iter().collect(),
            subject: None,
        }
    }

    /// Checks that every option has been used.
    pub fn finished(&self) -> Result<(), Stop> {
        match self.options.first() {
            None => Ok(()),
            Some((name, _)) => wrong(format!("`{}` takes no option `{name}`", self.function)),
        }
    }

    /// The word that names a scheme, which the call keeps.
    pub fn names(&self) -> Option<&'c str> {
        let named = self.options.iter().find(|(option, _)| option == "scheme");
        named.map(|(_, name)| &name[..])
    }

    /// Takes an option.
    pub fn option(&mut self, name: &str) -> Option<&'c str> {
        let at = self.options.iter().position(|(option, _)| option == name)?;
        Some(&self.options.remove(at).1)
    }

    /// The word that an option has under the reading.
    pub fn word(&mut self, name: &str, default: &str) -> String {
        let printed = self.option(name).unwrap_or(default);
        self.scope.reading.word(self.function, name, printed)
    }

    /// The position of the word that an option has, in a list of the possible ones.
    pub fn choose(&mut self, name: &str, words: &[&str]) -> Result<usize, Stop> {
        let word = self.word(name, words[0]);
        let place = words.iter().position(|known| *known == word);
        place.ok_or_else(|| Stop::Wrong(format!("`{name}` cannot be `{word}`")))
    }

    /// The scheme that the call names. Options give values to its parameters.
    pub fn reference(&mut self) -> Result<Option<String>, Stop> {
        let Some(name) = self.option("scheme") else { return Ok(None) };
        let (own, parameters): (Vec<_>, Vec<_>) =
            self.options.iter().partition(|(name, _)| WORDS.contains(&name.as_str()));
        self.options = own;
        if !parameters.iter().all(|(_, word)| number_of(word).is_some() || is_name(word)) {
            return wrong("the value of a parameter is a number or a name");
        }
        let parameters: Vec<String> =
            parameters.iter().map(|(name, word)| format!("{name}={word}")).collect();
        Ok(Some(format!("{name}:{}", parameters.join(","))))
    }

    /// The piece on which functions of masks take masks with its symbol, if there is one.
    pub fn piece(&self) -> Option<&'c Piece<'c>> {
        self.scope.piece.as_ref().filter(|piece| piece.is_of_masks())
    }

    /// The family that the call is about, if its scheme depends on an index with all values.
    pub fn family(&mut self) -> Result<Option<Rc<Family>>, Stop> {
        let subject = self.subject()?;
        self.subject = Some(subject.clone());
        Ok(if let Subject::Family(family) = subject { Some(family) } else { None })
    }

    /// Makes the call one about this scheme.
    pub fn set_scheme(&mut self, scheme: Rc<Scheme>) {
        self.subject = Some(Subject::Scheme(scheme));
    }

    /// The scheme that the call is about.
    pub fn scheme(&mut self) -> Result<Rc<Scheme>, Stop> {
        match self.subject()? {
            Subject::Scheme(scheme) => Ok(scheme),
            Subject::Family(_) => Err(NO_FUNCTION),
        }
    }

    fn subject(&mut self) -> Result<Subject, Stop> {
        if let Some(known) = self.subject.take() {
            return Ok(known);
        }
        let reference = self.reference()?;
        if let Some(every) = &self.scope.every {
            let own = reference.as_ref().map(|reference| {
                let found = self.library.depending(reference, self.scope)?;
                found.map(|entries| self.library.family(entries, every)).transpose()
            });
            let family = match own {
                Some(found) => found?.map(Rc::new),
                None => every.family.clone(),
            };
            if let Some(family) = family {
                return Ok(Subject::Family(family));
            }
        }
        self.one_scheme(reference).map(Subject::Scheme)
    }

    /// The scheme that the call is about, and whether its mask has the symbol of the piece. It is shorter where this is not so at
    /// the ends.
    pub fn scheme_on(&mut self) -> Result<(Rc<Scheme>, bool), Stop> {
        let reference = self.reference()?;
        let whole = self.whole_scheme(reference)?;
        let depends = whole.numeric().is_err();
        Ok((self.on_piece(&whole)?, depends))
    }

    fn one_scheme(&self, reference: Option<String>) -> Result<Rc<Scheme>, Stop> {
        self.on_piece(&self.whole_scheme(reference)?)
    }

    /// A scheme, without the ends of its mask that are 0 on the piece.
    fn on_piece(&self, scheme: &Rc<Scheme>) -> Result<Rc<Scheme>, Stop> {
        self.piece().map_or(Ok(Rc::clone(scheme)), |piece| scheme.shortened(piece))
    }

    fn whole_scheme(&self, reference: Option<String>) -> Result<Rc<Scheme>, Stop> {
        let scheme = match reference {
            None => self.scope.scheme.clone(),
            Some(reference) => self.library.resolve_any(&reference, self.scope)?.first().cloned(),
        };
        let curves = self.scope.ring.is_some() || self.scope.lattice.is_some();
        let what = if curves { "mask of curves" } else { "scheme" };
        let scheme =
            scheme.ok_or_else(|| Stop::Wrong(format!("`{}` needs a {what}", self.function)))?;
        self.admits(&scheme)?;
        Ok(scheme)
    }

    /// Checks that a scheme is no filter, or the function one of filters.
    fn admits(&self, scheme: &Scheme) -> Result<(), Stop> {
        let filters = self.scope.filters && OF_FILTERS.contains(&self.function);
        if !scheme.is_filter() || filters {
            return Ok(());
        }
        wrong(format!("a filter does not stand in `{}` here", self.function))
    }

    /// The ring that the call is about, at a valence.
    pub fn ring(&mut self, valence: i64) -> Result<LocalRules<'c>, Stop> {
        let entry = match (self.reference()?, &self.scope.ring) {
            (Some(reference), _) if self.library.is_ring(&reference) => {
                if self.library.depending(&reference, self.scope)?.is_some() {
                    return Err(NO_FUNCTION);
                }
                Some(self.library.entry(&reference, self.scope)?)
            }
            (None, Some(ring)) => self.library.of_ring(ring),
            _ => None,
        };
        let entry =
            entry.ok_or_else(|| Stop::Wrong(format!("`{}` needs a ring", self.function)))?;
        let ring = LocalRules::of_entry(self.library, entry, Some(valence))?;
        if self.piece().is_some() {
            // Whether polynomials are 0 is not looked for on the piece.
            ring.weights.iter().flatten().try_for_each(|weight| weight.number().map(|_| ()))?;
        }
        Ok(ring)
    }

    /// The scheme that an option names.
    pub fn named(&mut self, option: &str) -> Result<Option<Rc<Scheme>>, Stop> {
        let Some(name) = self.option(option) else { return Ok(None) };
        let mut closed = self.library.closed();
        closed.reading = self.scope.reading;
        let scheme = self.library.resolve_any(name, &closed)?.first().cloned();
        scheme.iter().try_for_each(|scheme| self.admits(scheme))?;
        Ok(scheme)
    }

    /// Whether masks are read forwards, by the order that the call chooses.
    pub fn is_forward(&mut self) -> Result<bool, Stop> {
        Ok(self.choose("order", &ORDER)? == 1)
    }

    /// The sequence of a mask in the order that the call chooses.
    pub fn sequence<'s>(&mut self, rules: &'s [Vec<Value>]) -> Result<Sequence<'s>, Stop> {
        Ok(Sequence { rules, forward: self.is_forward()? })
    }

    /// The convolution of level c ≤ `most` and arity n, by the recursion that the call chooses.
    pub fn convolution(&mut self, c: &Value, n: &Value, most: i64) -> Result<Convolution, Stop> {
        let (c, arity) = (within(c, 1, most)?, within(n, 2, 64)?);
        let printed = self.choose("recursion", &RECURSION)? == 1;
        Ok(Convolution { c: u32::try_from(c).unwrap_or(1), arity, printed })
    }

    /// The values at 0, …, length − 1 of the sequences that the options `sequence` and `with` name.
    pub fn sequences(
        &mut self,
        length: &Value,
        indices: &mut Indices,
    ) -> Result<Vec<Vec<Value>>, Stop> {
        let length = within(length, 1, 1_000)?;
        let index = self.option("index").unwrap_or("q");
        self.scope.index(index)?;
        let Some(first) = self.option("sequence") else {
            return wrong("the option `sequence` is missing");
        };
        let (scope, second) = (self.scope, self.option("with"));
        let mut value = |name: &str, q: usize| {
            indices.push((index.to_owned(), number(q)));
            let value = scope.name(name, indices);
            indices.pop();
            value
        };
        let names = [first].into_iter().chain(second);
        names.map(|name| (0..length).map(|q| value(name, q)).collect()).collect()
    }
}

/// The entry of a mask at a place that a formula names.
pub fn entry(rules: &[Vec<Value>], rule: &Value, column: &Value) -> Result<Value, Stop> {
    let (rule, column) = (rule.integer(MAX_INTEGER)?, column.integer(MAX_INTEGER)?);
    let row = usize::try_from(rule).ok().and_then(|rule| rules.get(rule));
    let row = row.ok_or_else(|| Stop::Wrong(format!("there is no rule {rule}")))?;
    let entry = usize::try_from(column).ok().and_then(|column| row.get(column));
    Ok(entry.cloned().unwrap_or_else(|| Value::int(0)))
}
