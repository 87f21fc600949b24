//! The options of a function call in a claim.

use crate::bound::{Order, Recursion, Rounded, Suprema, Terms};
use crate::evaluation::choices::BEST_OFFSET;
use crate::evaluation::settings::Settings;
use crate::exact::within;
use crate::formula::{Call, CallError, OptionWord, is_identifier};
use crate::spectrum::CurvaturePart;

/// What the exponent of a constant of c levels counts: levels, or blocks of c levels.
#[derive(Clone, Copy)]
pub(crate) enum Exponent {
    Level,
    Block,
}

/// Where the points of a level are: at i/n^k, or at their natural parameters.
#[derive(Clone, Copy)]
pub(crate) enum Parameters {
    Natural,
    Indexed,
}

/// The data of which limits approximate a function: its values, or what is adapted to the scheme.
#[derive(Clone, Copy)]
pub(crate) enum Data {
    Sampled,
    Adapted,
}

/// The highest derivative of a limit.
const MAX_DERIVATIVE: i64 = 16;

/// The options of functions. All others are parameters of the scheme that is named.
const OWN: [&str; 16] = [
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

/// The options of a call; each can be used once.
pub(crate) struct Options<'a> {
    function: &'a str,
    left: Vec<&'a OptionWord>,
    /// The reading, whose words replace the printed ones.
    settings: Option<&'a Settings>,
}

/// Whether this may be the value of a parameter in an option: a name, an integer, a decimal, or a fraction of integers.
fn is_value(word: &str) -> bool {
    let is_digits = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
    let number = word.strip_prefix('-').unwrap_or(word);
    let parts = number.split_once('/').or_else(|| number.split_once('.'));
    let (first, second) = parts.unwrap_or((number, "0"));
    is_identifier(word) || is_digits(first) && is_digits(second)
}

impl<'a> Options<'a> {
    pub(crate) fn new<V>(call: &Call<'a, V>) -> Options<'a> {
        Options { function: call.function, left: call.options.iter().collect(), settings: None }
    }

    /// These options under a reading.
    pub(crate) fn read_as(self, settings: &'a Settings) -> Options<'a> {
        Options { settings: Some(settings), ..self }
    }

    pub(crate) fn take(&mut self, name: &str) -> Option<String> {
        let at = self.left.iter().position(|option| option.name == name)?;
        Some(self.left.remove(at).word.clone())
    }

    /// The scheme that the option `scheme` names, with the values of its parameters: `b-spline:degree=3` for `scheme = b-spline, degree = 3`.
    pub(crate) fn scheme(&mut self) -> Result<Option<String>, CallError> {
        let Some(name) = self.take("scheme") else { return Ok(None) };
        let is_own = |option: &&&OptionWord| !OWN.contains(&option.name.as_str());
        let given: Vec<&OptionWord> = self.left.iter().filter(is_own).copied().collect();
        self.left.retain(|option| OWN.contains(&option.name.as_str()));
        if let Some(other) = given.iter().find(|option| !is_value(&option.word)) {
            let OptionWord { name, word, .. } = other;
            return Err(CallError::Misuse(format!(
                "the value of the parameter `{name}` is a number or a name here, and not `{word}`; with `for = '({name}, …) = …'` or \
                 `scheme = \"NAME:{name}=…\"` it may be a formula"
            )));
        }
        let parameters: Vec<String> =
            given.iter().map(|option| format!("{}={}", option.name, option.word)).collect();
        let colon = if parameters.is_empty() { "" } else { ":" };
        Ok(Some(format!("{name}{colon}{}", parameters.join(","))))
    }

    fn choose<T: Copy>(&mut self, name: &str, choices: &[(&str, T)]) -> Result<T, CallError> {
        let printed = self.take(name).unwrap_or_else(|| choices[0].0.to_owned());
        let word = self.word(name, &printed);
        let found = choices.iter().find(|(choice, _)| *choice == word);
        found.map(|(_, value)| *value).ok_or_else(|| {
            let known: Vec<&str> = choices.iter().map(|(choice, _)| *choice).collect();
            CallError::Misuse(format!("`{name}` is one of {}, not `{word}`", known.join(", ")))
        })
    }

    /// The word of an option under the reading; `printed` is the word in the claim.
    fn word<'w>(&self, name: &str, printed: &'w str) -> &'w str {
        self.settings.map_or(printed, |settings| settings.option(self.function, name, printed))
    }

    pub(crate) fn exponent(&mut self) -> Result<Exponent, CallError> {
        self.choose("exponent", &[("level", Exponent::Level), ("block", Exponent::Block)])
    }

    pub(crate) fn parameters(&mut self) -> Result<Parameters, CallError> {
        let choices = [("natural", Parameters::Natural), ("indexed", Parameters::Indexed)];
        self.choose("parameters", &choices)
    }

    pub(crate) fn data(&mut self) -> Result<Data, CallError> {
        self.choose("data", &[("sampled", Data::Sampled), ("adapted", Data::Adapted)])
    }

    /// Whether the second of two tangents is meant, and not the first.
    pub(crate) fn is_second_tangent(&mut self) -> Result<bool, CallError> {
        self.choose("tangent", &[("first", false), ("second", true)])
    }

    pub(crate) fn part(&mut self) -> Result<CurvaturePart, CallError> {
        let choices = [
            ("both", CurvaturePart::Both),
            ("elliptic", CurvaturePart::Elliptic),
            ("hyperbolic", CurvaturePart::Hyperbolic),
        ];
        self.choose("part", &choices)
    }

    /// The order of a derivative.
    pub(crate) fn derivative(&mut self) -> Result<u32, CallError> {
        let Some(word) = self.take("derivative") else { return Ok(0) };
        let order = word.parse::<u32>().ok().filter(|order| i64::from(*order) <= MAX_DERIVATIVE);
        order.ok_or_else(|| {
            CallError::Misuse(format!(
                "`derivative` is an integer from 0 to {MAX_DERIVATIVE}, not `{word}`"
            ))
        })
    }

    pub(crate) fn order(&mut self) -> Result<Order, CallError> {
        self.choose("order", &[("adjoint", Order::Adjoint), ("forward", Order::Forward)])
    }

    pub(crate) fn terms(&mut self) -> Result<Terms, CallError> {
        self.choose("terms", &[("each", Terms::Each), ("total", Terms::Total)])
    }

    pub(crate) fn suprema(&mut self) -> Result<Suprema, CallError> {
        let choices = [("independent", Suprema::Independent), ("joint", Suprema::Joint)];
        self.choose("suprema", &choices)
    }

    pub(crate) fn recursion(&mut self) -> Result<Recursion, CallError> {
        let choices = [("derived", Recursion::Derived), ("printed", Recursion::Printed)];
        self.choose("recursion", &choices)
    }

    pub(crate) fn rounded(&mut self) -> Result<Rounded, CallError> {
        let choices = [("up", Rounded::Up), ("nearest", Rounded::Nearest), ("down", Rounded::Down)];
        self.choose("rounded", &choices)
    }

    /// `best` gives the offset at which σ is least, where that is computed.
    pub(crate) fn offset(
        &mut self,
        own: i64,
        best: impl Fn() -> Option<i64>,
    ) -> Result<i64, CallError> {
        let printed = self.take("offset").unwrap_or_else(|| "own".to_owned());
        match self.word("offset", &printed) {
            "own" => Ok(own),
            BEST_OFFSET => best().ok_or_else(|| {
                CallError::Misuse("the best offset is not that of one mask here".to_owned())
            }),
            word => word.parse().ok().and_then(|o| within(o, 10_000)).ok_or_else(|| {
                let range = "an integer from -10000 to 10000";
                CallError::Misuse(format!("`offset` is `own`, `best` or {range}, not `{word}`"))
            }),
        }
    }

    /// `value`; an error if some option has not been used.
    pub(crate) fn finished<V>(&self, value: V) -> Result<V, CallError> {
        self.left.first().map_or(Ok(value), |option| {
            let (name, function) = (&option.name, self.function);
            Err(CallError::Misuse(format!("`{function}` takes no option `{name}`")))
        })
    }
}
