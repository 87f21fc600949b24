//! The syntax tree of a formula.

use crate::exact::Rational;
use std::collections::BTreeSet;

/// The option that names the index of a sequence.
pub(super) const INDEX_OPTION: &str = "index";
/// The name of the index of a sequence that a function takes, unless an option gives
/// another name.
pub const SEQUENCE_INDEX: &str = "q";

/// A range of bytes of the formula's text.
pub type Span = std::ops::Range<usize>;

/// An expression and its place in the text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Expr {
    /// The root node.
    pub node: Node,
    /// Where it stands in the formula's text.
    pub span: Span,
}

impl Expr {
    /// The names of parameters, indices and definitions in the expression, and of the
    /// definitions that options of functions name. The names of families and functions
    /// are not included.
    ///
    /// ```
    /// let formula = subcert::formula::parse("sum(h = 1..m, a[0, h]*abs(w))")?;
    /// assert_eq!(formula.names().into_iter().collect::<Vec<_>>(), ["h", "m", "w"]);
    /// # Ok::<(), subcert::formula::FormulaError>(())
    /// ```
    #[must_use]
    pub fn names(&self) -> BTreeSet<&str> {
        let mut names = BTreeSet::new();
        let mut waiting = vec![self];
        while let Some(expr) = waiting.pop() {
            match &expr.node {
                Node::Name(name) => {
                    names.insert(name.as_str());
                }
                Node::Call { options, .. } => {
                    names.extend(options.iter().filter_map(OptionWord::definition));
                }
                _ => {}
            }
            waiting.extend(expr.parts());
        }
        names
    }

    /// The names of the functions that the expression calls.
    #[must_use]
    pub fn functions(&self) -> BTreeSet<&str> {
        let (mut functions, mut waiting) = (BTreeSet::new(), vec![self]);
        while let Some(expr) = waiting.pop() {
            if let Node::Call { function, .. } = &expr.node {
                functions.insert(function.as_str());
            }
            waiting.extend(expr.parts());
        }
        functions
    }

    /// The names of the indices of sums, maxima and minima in the expression, and of the indices of
    /// the sequences that its functions take.
    ///
    /// ```
    /// let formula = subcert::formula::parse("sum(h = 1..m, max(j = 0..h, a[h, j]))")?;
    /// assert_eq!(formula.indices().into_iter().collect::<Vec<_>>(), ["h", "j"]);
    /// # Ok::<(), subcert::formula::FormulaError>(())
    /// ```
    #[must_use]
    pub fn indices(&self) -> BTreeSet<&str> {
        let (mut indices, mut waiting) = (BTreeSet::new(), vec![self]);
        while let Some(expr) = waiting.pop() {
            match &expr.node {
                Node::Fold { index, .. } => {
                    indices.insert(index.as_str());
                }
                // `with` alone names a scheme.
                Node::Call { options, .. }
                    if options.iter().any(|option| option.name == "sequence") =>
                {
                    let named = options.iter().find(|option| option.name == INDEX_OPTION);
                    indices.insert(named.map_or(SEQUENCE_INDEX, |option| &option.word));
                }
                _ => {}
            }
            waiting.extend(expr.parts());
        }
        indices
    }

    /// The direct subexpressions.
    #[must_use]
    pub fn parts(&self) -> Vec<&Expr> {
        match &self.node {
            Node::Number(_) | Node::Name(_) => Vec::new(),
            Node::Indexed { indices: parts, .. } | Node::Call { arguments: parts, .. } => {
                parts.iter().collect()
            }
            Node::Negate(operand) => vec![operand],
            Node::Chain(first, rest) => {
                std::iter::once(&**first).chain(rest.iter().map(|(_, operand)| operand)).collect()
            }
            Node::Power(base, exponent) => vec![base, exponent],
            Node::Fold { from, to, body, .. } => vec![from, to, body],
        }
    }
}

/// A node of the tree. The depth of the tree is the nesting of the text: a chain of
/// operators of one precedence is one node, whatever its length.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Node {
    /// An exact number.
    Number(Rational),
    /// A parameter or an index.
    Name(String),
    /// A member of a family: q[2*i − 1], a[0, j].
    Indexed {
        /// The family's name.
        name: String,
        /// The expressions between the brackets.
        indices: Vec<Expr>,
    },
    /// −x.
    Negate(Box<Expr>),
    /// Operators of one precedence, applied from left to right.
    Chain(Box<Expr>, Vec<(Operator, Expr)>),
    /// base^exponent.
    Power(Box<Expr>, Box<Expr>),
    /// A function of the language or of the context.
    Call {
        /// The function's name.
        function: String,
        /// The arguments between the parentheses.
        arguments: Vec<Expr>,
        /// The options after the arguments, such as `order = forward`.
        options: Vec<OptionWord>,
    },
    /// The sum, product, maximum or minimum of `body` over `index` = `from`, …, `to`.
    Fold {
        /// Sum, product, maximum or minimum.
        fold: Fold,
        /// The name of the index, which `body` may use.
        index: String,
        /// The first index.
        from: Box<Expr>,
        /// The last index.
        to: Box<Expr>,
        /// The expression that is summed or compared.
        body: Box<Expr>,
    },
}

/// How the values of an expression over a range of an index are combined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fold {
    /// Their sum; 0 for an empty range.
    Sum,
    /// Their product; 1 for an empty range.
    Product,
    /// Their maximum; undefined for an empty range.
    Max,
    /// Their minimum; undefined for an empty range.
    Min,
}

impl Fold {
    /// The fold with this name, if there is one.
    pub(super) fn named(name: &str) -> Option<Fold> {
        [Fold::Sum, Fold::Product, Fold::Max, Fold::Min]
            .into_iter()
            .find(|fold| fold.name() == name)
    }

    /// Its name in formulas.
    pub(super) fn name(self) -> &'static str {
        match self {
            Fold::Sum => "sum",
            Fold::Product => "product",
            Fold::Max => "max",
            Fold::Min => "min",
        }
    }
}

/// An operator between two expressions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operator {
    /// +
    Add,
    /// −
    Subtract,
    /// ·
    Multiply,
    /// /
    Divide,
}

/// An option of a function call, such as `order = forward`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OptionWord {
    /// The name of the option.
    pub name: String,
    /// The word that is chosen.
    pub word: String,
    /// The place in the formula's text.
    pub span: Span,
}

impl OptionWord {
    /// The name of a definition, if this option refers to one.
    #[must_use]
    pub fn definition(&self) -> Option<&str> {
        ["sequence", "with"].contains(&self.name.as_str()).then_some(&self.word)
    }
}
