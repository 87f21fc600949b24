//! Checks of names in formulas: the index of a sum must not hide another name, and a formula
//! mentions a name of theorems only where this has a meaning.

use super::kind::{Formulas, Placed, Role, of_reference, placed};
use super::reader::Reader;
use super::roles::{AllRoles, Roles};
use crate::claim::{
    Claim, Comparison, Equation, EquationBody, FunctionClaim, Index, LocatedReference, Paper,
    Promise, RangeClaim, SmoothnessBody, SmoothnessClaim, Statement, THEOREM_NAMES, Table, Theorem,
    with_kinds,
};
use crate::diagnostic::Diagnostic;
use crate::formula::LocatedFormula;
use std::collections::BTreeSet;

macro_rules! formulas {
    ($($(#[$doc:meta])* $kind:ident $name:literal $field:ident $c:ident $f:ident $own:ident,)*) => {
        /// The formulas of a claim.
        fn formulas(claim: Claim<'_>) -> Vec<Placed<'_>> {
            match claim { $(Claim::$kind(claim) => claim.formulas(),)* }
        }
    };
}

with_kinds!(formulas);

impl Reader<'_> {
    /// Checks the names in the formulas of a paper.
    ///
    /// # Errors
    /// When the index of a sum is also the name of a definition or of something that has a value in
    /// the claim, since a definition that is used in the sum would be ambiguous; only the indices
    /// of an equation may be hidden. When a formula of a theorem mentions a name of theorems that
    /// has no meaning there, such as `k` in a hypothesis.
    pub(super) fn formulas(&self, paper: &Paper, all: &AllRoles<'_>) -> Result<(), Diagnostic> {
        for claim in paper.claims() {
            self.claim(paper, formulas(claim), all.of(claim.id()), all)?;
            let Claim::Theorem(theorem) = claim else { continue };
            let known: &[&str] = match &theorem.statement {
                Statement::Bound { .. } => &["k", "beta", "beta_1", "beta_2", "beta_3"],
                Statement::Depth(_) => &["epsilon", "beta", "beta_1", "beta_2", "beta_3"],
                Statement::Other(_) => continue,
            };
            let (bound, others) = of_theorem(theorem);
            self.mentions(paper, &bound, known)?;
            self.mentions(paper, &others, &[])?;
        }
        Ok(())
    }

    /// Checks the indices of sums in the formulas of a claim, and in the definitions that these
    /// use.
    fn claim(
        &self,
        paper: &Paper,
        formulas: Vec<Placed<'_>>,
        roles: &Roles<'_>,
        all: &AllRoles<'_>,
    ) -> Result<(), Diagnostic> {
        for (expr, span) in reached(paper, formulas) {
            for index in expr.indices() {
                let hidden = roles.get(index).or_else(|| all.definitions.get(index));
                if let Some(hidden) = hidden.filter(|hidden| hidden.role != Role::Index) {
                    let message = format!("the index `{index}` hides another meaning of this name");
                    return Err(self
                        .error(span, message)
                        .with_label("it is an index here")
                        .with_place(hidden.span.clone(), hidden.role.to_string())
                        .with_help("give the index another name"));
                }
            }
        }
        Ok(())
    }

    /// Checks that formulas, and the definitions that they use, mention no names of theorems but
    /// the `known` ones.
    fn mentions(
        &self,
        paper: &Paper,
        formulas: &[Placed<'_>],
        known: &[&str],
    ) -> Result<(), Diagnostic> {
        for formula in formulas {
            for (expr, span) in reached(paper, vec![formula.clone()]) {
                let mut names = expr.names().into_iter();
                let unknown = |name: &&str| THEOREM_NAMES.contains(name) && !known.contains(name);
                if let Some(name) = names.find(unknown) {
                    let message = format!("`{name}` has no meaning here");
                    return Err(self
                        .error(span, message)
                        .with_place(formula.1.clone(), "for this formula")
                        .with_help(
                            "a bound is a formula in `k` and `beta` (of nets also in `beta_1`, \
                             `beta_2` and `beta_3`), a depth in `epsilon` and these spreads; \
                             hypotheses and parameters of schemes have none of them",
                        ));
                }
            }
        }
        Ok(())
    }
}

/// These formulas, and the definitions and alternatives that they use, directly or not.
fn reached<'p>(paper: &'p Paper, formulas: Vec<Placed<'p>>) -> Vec<Placed<'p>> {
    let (mut met, mut waiting) = (BTreeSet::new(), formulas);
    let mut found = Vec::new();
    while let Some((expr, span)) = waiting.pop() {
        for name in expr.names() {
            if met.insert(name) {
                waiting.extend(paper.definitions.get(name).map(placed));
                let others = paper.alternatives.iter().filter(|other| other.of == name);
                waiting.extend(others.map(|other| placed(&other.value)));
            }
        }
        found.push((expr, span));
    }
    found
}

/// Of a claim about a free parameter.
fn of_parameter<'p, const N: usize>(
    formulas: [&'p LocatedFormula; N],
    scheme: Option<&'p LocatedReference>,
) -> Vec<Placed<'p>> {
    formulas.into_iter().map(placed).chain(scheme.into_iter().flat_map(of_reference)).collect()
}

impl Formulas for Table {
    fn formulas(&self) -> Vec<Placed<'_>> {
        let mut formulas = vec![placed(&self.value)];
        formulas.extend(self.schemes().flat_map(of_reference));
        if let Some(promise) = &self.promise {
            let (Promise::Depth { tolerance: first, spread, offset, ring }
            | Promise::Bound { level: first, spread, offset, ring }) = promise;
            formulas.extend([first, spread].into_iter().chain(offset).map(placed));
            formulas.extend(ring.iter().flat_map(of_reference));
        }
        formulas
    }
}

impl Formulas for Equation {
    fn formulas(&self) -> Vec<Placed<'_>> {
        let EquationBody::Identity(identity) = &self.body else { return Vec::new() };
        let sides = identity.comparisons.iter().flat_map(Comparison::formulas);
        let mut formulas: Vec<Placed<'_>> = sides.map(placed).collect();
        formulas.extend(identity.scheme.iter().flat_map(of_reference));
        let sides = identity.hypotheses.iter().flat_map(|one| [&one.member, &one.value]);
        formulas.extend(sides.map(placed));
        for index in &identity.indices {
            if let Index::Range { from, to, .. } = index {
                formulas.extend([placed(from), placed(to)]);
            }
        }
        formulas
    }
}

impl Formulas for FunctionClaim {
    fn formulas(&self) -> Vec<Placed<'_>> {
        of_parameter([&self.left, &self.right], self.scheme.as_ref())
    }
}

impl Formulas for RangeClaim {
    fn formulas(&self) -> Vec<Placed<'_>> {
        of_parameter([&self.value], self.scheme.as_ref())
    }
}

impl Formulas for SmoothnessClaim {
    fn formulas(&self) -> Vec<Placed<'_>> {
        match &self.body {
            SmoothnessBody::Statement(scheme, _) => of_reference(scheme).collect(),
            SmoothnessBody::NotCheckable(_) => Vec::new(),
        }
    }
}

impl Formulas for Theorem {
    fn formulas(&self) -> Vec<Placed<'_>> {
        let (bound, others) = of_theorem(self);
        [bound, others].concat()
    }
}

/// The formulas of a theorem in which names of theorems have a meaning, which are its bound or its
/// depth and its corrections; and its other formulas.
fn of_theorem(theorem: &Theorem) -> (Vec<Placed<'_>>, Vec<Placed<'_>>) {
    let tried = &theorem.tried;
    let mut bound: Vec<Placed<'_>> = match &theorem.statement {
        Statement::Bound { by, .. } | Statement::Depth(by) => vec![placed(by)],
        Statement::Other(_) => Vec::new(),
    };
    bound.extend(tried.rewritings.iter().map(|rewriting| placed(&rewriting.value)));
    let supposed = tried.supposes.iter().flat_map(|(value, below)| [value, below]);
    let others = supposed.chain(&tried.block).map(placed);
    let schemes = theorem.scheme.iter().chain(&tried.schemes).chain(&tried.interpolant);
    (bound, others.chain(schemes.flat_map(of_reference)).collect())
}
