//! Why a text gives no scheme.

use super::axes::MAX_AXES;
use crate::cap::Cap;
use crate::diagnostic::Diagnostic;
use crate::formula::{FormulaError, Value};
use crate::suggestion::known as names;
use std::collections::BTreeMap;

/// Why a text is not a scheme reference.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ReferenceError {
    /// The text does not have the form `name:parameter=value,…`.
    #[error(
        "`{text}` is not a scheme: {reason}; write `six-point:w=3/256`, `newton:j=1,n=3`, or \
             two of these with ` x ` between them for a tensor product"
    )]
    Form {
        /// The text.
        text: String,
        /// What is wrong with it.
        reason: String,
    },
    /// A value without the name of its parameter.
    #[error("`{text}`: a parameter is given as name=value; write `{write}`")]
    Unnamed {
        /// The text.
        text: String,
        /// The text with the name.
        write: String,
    },
    /// A parameter's value is not a formula.
    #[error("in `{text}`: {error}")]
    Formula {
        /// The value's text.
        text: String,
        /// What is wrong with it.
        error: FormulaError,
    },
}

impl ReferenceError {
    /// That a text has another form.
    pub(super) fn form(text: &str, reason: &str) -> ReferenceError {
        let (text, reason) = (text.chars().take(80).collect(), reason.to_owned());
        ReferenceError::Form { text, reason }
    }

    /// Checks the number of the factors that a text stands for.
    ///
    /// # Errors
    /// When there are more than two.
    pub fn check_factors(text: &str, count: usize) -> Result<(), ReferenceError> {
        if count > MAX_AXES {
            return Err(ReferenceError::form(text, "here a tensor product has two factors"));
        }
        Ok(())
    }
}

/// Why a reference gives no scheme.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SchemeError {
    /// The text is not a reference.
    #[error(transparent)]
    Reference(#[from] ReferenceError),
    /// There is no scheme of this name.
    #[error(
        "unknown scheme `{name}`{}; a scheme may also be the path of a .toml file, or a mask such as `[1, 3, 3, 1]/4`",
        names_or_described(.name, .described, .known)
    )]
    Unknown {
        /// The name.
        name: String,
        /// Those whose description has all words of the name.
        described: Vec<String>,
        /// The names that exist.
        known: Vec<String>,
    },
    /// A symbol is made of that of a scheme that is not there.
    #[error(
        "there is no scheme `{name}` whose symbol could be used here: it is one of the catalogue, or has a mask and stands before this \
         one in the same file"
    )]
    NoOther {
        /// The name.
        name: String,
    },
    /// There is none in a claim file, nor in the catalogue.
    #[error(
        "unknown scheme `{name}`{}; a scheme of the paper's own stands in the claim file as [[scheme]], with a `name` and \
         mask = '[1, 3, 3, 1]/4'",
        names(.name, .known.iter().map(String::as_str))
    )]
    UnknownInPaper {
        /// The name.
        name: String,
        /// The names that exist.
        known: Vec<String>,
    },
    /// A parameter has neither a value nor a default. The scheme may have values of others.
    #[error(
        "`{scheme}` needs its parameter `{parameter}`: write `{scheme}{}{parameter}=…`",
        if .scheme.contains('=') { "," } else { ":" }
    )]
    MissingParameter {
        /// The scheme.
        scheme: String,
        /// The parameter.
        parameter: String,
    },
    /// A parameter that the scheme does not have.
    #[error("`{scheme}` has no parameter `{parameter}`{}", parameters(.known))]
    UnknownParameter {
        /// The scheme.
        scheme: String,
        /// The parameter.
        parameter: String,
        /// The parameters that exist.
        known: Vec<String>,
    },
    /// A parameter given to an alias of a scheme, which does not occur in what the alias
    /// stands for.
    #[error(
        "`{scheme}` stands for `{stands_for}`, and hands on no parameter `{parameter}`{}; a \
         parameter is a name in what it stands for, such as w in `use = \"six-point:w=w\"`",
        parameters(.known)
    )]
    NotHandedOn {
        /// The name.
        scheme: String,
        /// The scheme, with its parameters, that the name stands for.
        stands_for: String,
        /// The parameter.
        parameter: String,
        /// The parameters that exist.
        known: Vec<String>,
    },
    /// An irrational parameter where only rational values are supported.
    #[error("`{scheme}` is computed for rational `{parameter}` only here, and not for {value}")]
    IrrationalParameter {
        /// The scheme.
        scheme: String,
        /// The parameter.
        parameter: String,
        /// Its value.
        value: String,
    },
    /// A ring, where a mask is needed.
    #[error(
        "`{scheme}` is a ring of points around an extraordinary vertex or face, and this needs a \
         mask; commands such as `subcert constants`, `depth` and `smoothness` take it alone"
    )]
    LocalRules {
        /// The scheme.
        scheme: String,
    },
    /// A mask on Z^d, where the mask of a curve is needed.
    #[error(
        "`{scheme}` is a mask on Z^d or a product of three, and this needs the mask of curves, or a product of two; `subcert scheme`, \
         `constants` and `smoothness` take it alone"
    )]
    Lattice {
        /// The scheme.
        scheme: String,
    },
    /// No mask on Z^d, where one is needed.
    #[error(
        "`{scheme}` is no mask on Z^d; one is typed by its symbol, as `(1+x)*(1+y)*(1+x*y)/2`, with `:dilation=[[1,1],[1,-1]]` behind it for other \
         dilation matrices than 2I"
    )]
    NotLattice {
        /// The scheme.
        scheme: String,
    },
    /// A filter, where a scheme is needed.
    #[error(
        "`{scheme}` is a filter, whose rules may have any sums, and this needs a scheme; a filter stands in the functions of relations \
         and equations, and in `symbol(NAME)`"
    )]
    Filter {
        /// Its name.
        scheme: String,
    },
    /// A name that stands for a name, and so on, beyond a cap.
    #[error(
        "`{name}` stands at the end of {cap} names of schemes, of which each stands for the next; at most {cap} are followed"
    )]
    TooManyNames {
        /// The last name.
        name: String,
        /// The cap.
        cap: usize,
    },
    /// A mask, where a ring is needed.
    #[error("`{scheme}` is not a ring of points; `doo-sabin:n=5` and `catmull-clark:N=5` are")]
    NotRing {
        /// The scheme.
        scheme: String,
    },
    /// A valence for a ring that leaves no parameter for it open.
    #[error(
        "`{scheme}` leaves no parameter `N` or `n` open, which a valence could be the value of; give it no \
         valence, or leave that parameter out"
    )]
    NoValence {
        /// The scheme.
        scheme: String,
    },
    /// A coefficient that is no rational polynomial in the parameter that is left open.
    #[error(
        "the coefficient {coefficient} is no polynomial in `{parameter}` with rational coefficients"
    )]
    NotPolynomial {
        /// The coefficient.
        coefficient: String,
        /// The parameter.
        parameter: String,
    },
    /// A mask that does not depend on the parameter that is left open.
    #[error(
        "the mask of `{scheme}` does not depend on `{parameter}`: name a parameter of the scheme \
         that it gives no value{}", parameters(.known)
    )]
    Independent {
        /// The scheme.
        scheme: String,
        /// The parameter.
        parameter: String,
        /// The parameters that exist.
        known: Vec<String>,
    },
    /// A tensor product, where one mask is needed.
    #[error("`{scheme}` is a tensor product, and this needs the mask of one of its factors")]
    TensorProduct {
        /// The scheme.
        scheme: String,
    },
    /// A path of a directory, or of a file that is not a scheme.
    #[error(
        "`{path}` is {what}, and no scheme: write the path of a .toml file, or a name of the catalogue"
    )]
    OtherFile {
        /// The path.
        path: String,
        /// What is there.
        what: &'static str,
    },
    /// A parameter below its least value.
    #[error("`{scheme}` needs {parameter} >= {least}, and {parameter} is {value}{}", which_is(.about))]
    TooSmall {
        /// The scheme.
        scheme: String,
        /// The parameter.
        parameter: String,
        /// Its least value.
        least: String,
        /// Its value.
        value: String,
        /// What the parameter is.
        about: String,
    },
    /// A file that cannot be read.
    #[error("cannot read `{path}`: {reason}")]
    Unreadable {
        /// The path.
        path: String,
        /// The reason that the system gives.
        reason: String,
    },
    /// An error in the scheme's file.
    #[error("{}", .0.in_words())]
    File(Box<Diagnostic>),
}

impl SchemeError {
    /// The same error, with all that is typed for the scheme where a parameter is missing: so one can go on from there.
    pub(super) fn of_scheme(self, text: &str) -> SchemeError {
        match self {
            SchemeError::MissingParameter { parameter, .. } => {
                SchemeError::MissingParameter { scheme: text.to_owned(), parameter }
            }
            other => other,
        }
    }

    /// The cap that the scheme is beyond, if nothing else is wrong.
    #[must_use]
    pub fn cap(&self) -> Option<Cap> {
        match self {
            SchemeError::File(error) => error.cap.as_deref().cloned(),
            SchemeError::TooManyNames { cap, .. } => {
                Some(Cap::new("the number of names that stand for one another", *cap as u64))
            }
            _ => None,
        }
    }
}

/// The schemes that are described by a name, or else the names that are like it.
fn names_or_described(name: &str, described: &[String], known: &[String]) -> String {
    if name.contains('=') {
        return "; a value of a parameter stands behind its scheme and a colon, as in `four-point:w=1/16`".to_owned();
    }
    if described.is_empty() {
        return names(name, known.iter().map(String::as_str));
    }
    let listed: Vec<String> = described.iter().map(|name| format!("`{name}`")).collect();
    format!("; did you mean {}? `subcert schemes` lists all", listed.join(" or "))
}

fn parameters(known: &[String]) -> String {
    if known.is_empty() {
        "; it has none".to_owned()
    } else {
        format!("; it has: {}", known.join(", "))
    }
}

fn which_is(text: &str) -> String {
    if text.is_empty() { String::new() } else { format!("; its meaning: {text}") }
}

/// `error` with a label that states the values of the parameters.
pub(super) fn at_values<V: Value>(
    error: Diagnostic,
    parameters: &BTreeMap<String, V>,
) -> Diagnostic {
    // An open parameter has its own name as value, which is not stated.
    let stated = parameters.iter().map(|(name, value)| (name, value.to_string()));
    let stated = stated.filter(|(name, value)| *name != value);
    let stated: Vec<String> = stated.map(|(name, value)| format!("{name} = {value}")).collect();
    if stated.is_empty() { error } else { error.with_label(format!("at {}", stated.join(", "))) }
}
