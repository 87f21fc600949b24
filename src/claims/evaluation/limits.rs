//! The masks of claims about limits: at values of all parameters, and with one parameter left open.

use crate::claim::{LocatedReference, Paper};
use crate::diagnostic::Diagnostic;
use crate::evaluation::library::{Library, values};
use crate::evaluation::parametric::{one_piece, polynomial};
use crate::evaluation::reference::{Unresolved, located, scheme_error};
use crate::exact::{
    BivariatePolynomial, Parametric, Polynomial, Rational, RationalPolynomial, RealCyclotomic,
};
use crate::formula::{Context, LocatedFormula, Lookup, Scope, Value};
use crate::scheme::{Instance, LatticeMask, LocalRules, Mask, Rules, SchemeError, VALENCE_NAMES};
use crate::smoothness::plane_rules;
use std::collections::BTreeMap;
use std::hash::Hash;

/// The scheme of a claim about limits, in its paper.
pub(crate) struct LimitScheme<'a> {
    pub(crate) paper: &'a Paper,
    pub(crate) library: &'a Library<'a>,
    pub(crate) located: &'a LocatedReference,
    /// Values that the claim states itself; they hide those of the paper.
    pub(crate) given: &'a BTreeMap<String, LocatedFormula>,
}

impl LimitScheme<'_> {
    /// The mask, where the variables of a range, if there are any, have these values.
    pub(crate) fn mask(&self, variables: &[(&str, &Rational)]) -> Result<Mask, Diagnostic> {
        let mut scope: Scope<'_, RealCyclotomic> = self.scope()?;
        for (name, value) in variables.iter().copied() {
            scope = scope.with(name, RealCyclotomic::from(value.clone()));
        }
        self.check_one(&scope)?;
        let resolved = self.library.resolve(&self.located.reference, &scope);
        let resolved = resolved.map_err(|error| self.unresolved(&error))?;
        Ok(resolved.constants.first().mask().clone())
    }

    /// Whether the scheme is a ring: the rules around a vertex or on a face.
    pub(crate) fn is_ring<V: Value>(&self, instances: &[Instance<V>]) -> Result<bool, Diagnostic> {
        self.library.is_ring(instances).map_err(|error| scheme_error(self.located, &error))
    }

    /// The mask on Z^d that the scheme is, if it is one; its coefficients are rational.
    pub(crate) fn lattice<V: Value + PartialEq>(
        &self,
        instances: &[Instance<V>],
    ) -> Result<Option<LatticeMask>, Diagnostic> {
        let mask = self.library.lattice(instances);
        let Some(mask) = mask.map_err(|error| scheme_error(self.located, &error))? else {
            return Ok(None);
        };
        mask.rational().map(Some).ok_or_else(|| {
            self.error("a coefficient of this mask on Z^d is no rational number").with_help(
                "the limits of masks on Z^d are decided where all coefficients are rational",
            )
        })
    }

    /// The mask on Z^d that the scheme is, if it is one, with polynomials in the variable as coefficients.
    pub(crate) fn lattice_in(
        &self,
        variable: &str,
        instances: &[Instance<Parametric>],
    ) -> Result<Option<LatticeMask<RationalPolynomial>>, Diagnostic> {
        let mask = self.library.lattice(instances);
        let mask = mask.map_err(|error| self.not_open(&Unresolved::Scheme(error), variable))?;
        let Some(mask) = mask else { return Ok(None) };
        let coefficients = mask.coefficients().values();
        let polynomials = coefficients.map(one_piece).collect::<Option<Vec<RationalPolynomial>>>();
        let mut polynomials = polynomials.ok_or_else(|| self.not_polynomial(variable))?.into_iter();
        let zero = || RationalPolynomial::constant(Rational::zero());
        Ok(Some(mask.map(|_| polynomials.next().unwrap_or_else(zero))))
    }

    /// The ring at this valence; without one, as its parameters stand. The variable of a range, if there is one, has this value.
    pub(crate) fn ring<V: Value + Eq + Hash>(
        &self,
        variable: Option<(&str, V)>,
        valence: Option<usize>,
    ) -> Result<LocalRules<V>, Diagnostic> {
        let instances = self.instances(variable, valence)?;
        let ring = match valence {
            Some(valence) => self.library.ring_of_valence(&instances, valence),
            None => self.library.ring(&instances),
        };
        ring.map_err(|error| scheme_error(self.located, &error))
    }

    /// The scheme at this valence, with the values of its parameters. In their formulas the names of a valence that mean nothing else stand for it.
    pub(crate) fn instances<V: Value>(
        &self,
        variable: Option<(&str, V)>,
        valence: Option<usize>,
    ) -> Result<Vec<Instance<V>>, Diagnostic> {
        let mut scope: Scope<'_, V> = self.scope()?;
        if let Some((name, value)) = variable {
            scope = scope.with(name, value);
        }
        if let Some(valence) = valence {
            for name in VALENCE_NAMES {
                if matches!(scope.name(name, &[]), Ok(Lookup::Unknown)) {
                    scope = scope.with(name, V::from_rational(&Rational::from(valence)));
                }
            }
        }
        let instances = self.library.instances(&self.located.reference, &scope);
        instances.map_err(|error| self.unresolved(&error))
    }

    /// Refuses rules that have another number of sectors than this valence.
    pub(crate) fn check_valence(
        &self,
        valence: Option<usize>,
        sectors: usize,
    ) -> Result<(), Diagnostic> {
        let Some(valence) = valence.filter(|valence| *valence != sectors) else { return Ok(()) };
        Err(self.error(format!("at valence {valence} these rules have {sectors} sectors")).with_help(
            "the parameter `N` or `n` of rules is the number of their sectors, as of the catalogue's",
        ))
    }

    /// The rules, with polynomials in the variable as coefficients.
    pub(crate) fn rules(&self, variable: &str) -> Result<Rules<RationalPolynomial>, Diagnostic> {
        let scope = self.scope()?.with(variable, Parametric::variable());
        let mask = self.open_mask(&scope, variable)?;
        polynomial(mask.rules()).ok_or_else(|| self.not_polynomial(variable))
    }

    /// The rules, with polynomials in two variables as coefficients.
    pub(crate) fn rules_in_plane(
        &self,
        variables: [&str; 2],
    ) -> Result<Rules<BivariatePolynomial>, Diagnostic> {
        let mut scope = self.scope()?;
        for name in variables {
            scope = scope.with(name, Polynomial::variable(name));
        }
        let names = variables.join("` and `");
        let mask = self.open_mask(&scope, &names)?;
        plane_rules(mask.rules(), variables).map_err(|_| self.not_polynomial(&names))
    }

    /// The one mask, whose coefficients depend on the open variables.
    fn open_mask<V: Value + PartialEq>(
        &self,
        scope: &Scope<'_, V>,
        variable: &str,
    ) -> Result<Mask<V>, Diagnostic> {
        self.check_one(scope)?;
        let masks = self.library.instances(&self.located.reference, scope);
        let masks = masks.and_then(|instances| self.library.masks(&instances));
        let masks = masks.map_err(|error| self.not_open(&error, variable))?;
        Ok(masks.first().clone())
    }

    /// The error of a mask whose coefficients depend on open variables.
    fn not_open(&self, error: &Unresolved, variable: &str) -> Diagnostic {
        match error {
            // The rules of a scheme of the catalogue sum to 1, unless they are no polynomials.
            Unresolved::Scheme(SchemeError::File(inner))
                if inner.source != self.located.source && inner.cap.is_none() =>
            {
                self.not_polynomial(variable)
            }
            other => self.unresolved(other),
        }
    }

    fn not_polynomial(&self, variable: &str) -> Diagnostic {
        self.error(format!("the mask is not polynomial in `{variable}`")).with_help(
            "a range of smoothness needs a mask whose coefficients are polynomials in its `variable`; for \
             single values of a parameter write [[smoothness]]",
        )
    }

    pub(crate) fn scope<V: Value>(&self) -> Result<Scope<'_, V>, Diagnostic> {
        let mut scope = Scope::new(&self.paper.definitions, &());
        scope = scope.with_formulas(&self.paper.given).with_formulas(self.given);
        let given = values(&self.paper.given)?.into_iter();
        let own = values(self.given)?;
        for (name, value) in
            given.filter(|(name, _)| !self.given.contains_key(name)).chain(own.clone())
        {
            scope = scope.with(name, V::from_rational(&value));
        }
        Ok(scope)
    }

    /// A tensor product has two masks.
    fn check_one<V: Value>(&self, scope: &dyn Context<V>) -> Result<(), Diagnostic> {
        let instances = self.library.instances(&self.located.reference, scope);
        match instances.map_err(|error| self.unresolved(&error))?.len() {
            1 => Ok(()),
            _ => Err(self.error("smoothness is that of a scheme for curves").with_help(
                "the limits of a tensor product are as smooth as those of its factors: claim the smoothness \
                 of each",
            )),
        }
    }

    fn unresolved(&self, error: &Unresolved) -> Diagnostic {
        located(self.located, error)
    }

    pub(crate) fn error(&self, message: impl Into<String>) -> Diagnostic {
        Diagnostic::new(&self.located.source, self.located.span.clone(), message)
    }
}
