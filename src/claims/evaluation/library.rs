//! The schemes of a paper's claims; the constants of each scheme are computed once.

use crate::bound::{
    Budget, ClassCap, Constants, DepthError, Rounded, SoundBound, log_level_algebraic,
};
use crate::claim::{Paper, SchemeSource};
use crate::diagnostic::Diagnostic;
use crate::evaluation::functions::is_about_scheme;
use crate::evaluation::masks::KnownLimits;
use crate::evaluation::reals::KnownReals;
use crate::evaluation::reference::Unresolved;
use crate::evaluation::series::Norms;
use crate::exact::{Rational, RealCyclotomic, StoredForm};
use crate::formula::{Context, LocatedFormula, Parameters, Value, evaluate};
use crate::scheme::{
    Axes, Instance, LatticeMask, LocalRules, Mask, Reference, ReferenceError, Scheme,
    SchemeDefinition, SchemeError, find_in_catalogue,
};
use std::cell::RefCell;
use std::collections::{BTreeMap, HashMap};
use std::hash::Hash;
use std::rc::Rc;

/// The greatest block length of a sound bound.
const MAX_SOUND_BLOCK: u32 = 6;

/// The most residue classes over which a sound bound takes a maximum.
const MAX_SOUND_CLASSES: u64 = 4_096;

/// The most steps of all searches for the constants of one claim.
const MAX_STEPS: u64 = 2_000_000_000;

/// The greatest length of a chain of names, each of which stands for the next one.
const MAX_ALIAS_DEPTH: usize = 8;

/// A scheme, and the offset at which its displacement is taken, if not its own.
type SoundKey = (Vec<Instance>, Option<i64>);

/// The base of a logarithm, its argument, and its rounding.
type LogLevel = (StoredForm, StoredForm, Rounded);

/// The schemes of one claim. Each claim has its own library, so that the work spent on one claim
/// does not decide what is found for another.
pub(crate) struct Library<'a> {
    paper: &'a Paper,
    constants: RefCell<BTreeMap<Instance, Rc<Constants>>>,
    /// The constants of masks with other numbers of the points.
    numbered: RefCell<BTreeMap<(Instance, usize), Rc<Constants>>>,
    /// The work that all searches for constants may take together.
    budget: Budget,
    sound: RefCell<BTreeMap<SoundKey, Rc<SoundBound>>>,
    pub(crate) norms: Norms<RealCyclotomic>,
    log_levels: RefCell<HashMap<LogLevel, Result<u32, DepthError>>>,
    pub(crate) limits: KnownLimits,
    pub(crate) reals: KnownReals,
}

/// A scheme with the constants of its masks, one per direction.
#[derive(Clone)]
pub(crate) struct Resolved {
    pub(crate) instances: Vec<Instance>,
    pub(crate) constants: Axes<Rc<Constants>>,
}

impl Resolved {
    /// The masks, at this offset if one is given.
    pub(crate) fn at(&self, offset: Option<i64>) -> Scheme {
        self.constants.map(|axis| {
            let mask = axis.mask();
            mask.with_offset(offset.unwrap_or(mask.offset()))
        })
    }
}

impl<'a> Library<'a> {
    pub(crate) fn new(paper: &'a Paper) -> Library<'a> {
        let (constants, sound) = Default::default();
        let budget = Budget::new(MAX_STEPS);
        let (norms, log_levels, numbered, limits, reals) = Default::default();
        Library { paper, constants, numbered, budget, sound, norms, log_levels, limits, reals }
    }

    /// Whether the function may be about a scheme, and one of the claim file or of the catalogue has this name.
    pub(crate) fn is_scheme(&self, function: &str, name: &str) -> bool {
        let has = || self.paper.schemes.contains_key(name) || find_in_catalogue(name).is_ok();
        is_about_scheme(function) && has()
    }

    /// The constants of a rational mask.
    pub(crate) fn constants_of(&self, mask: Mask) -> Rc<Constants> {
        Rc::new(Constants::new(mask).with_budget(self.budget.clone()))
    }

    /// The scheme that `reference` means in `context`.
    pub(crate) fn resolve(
        &self,
        reference: &Reference,
        context: &dyn Context<RealCyclotomic>,
    ) -> Result<Resolved, Unresolved> {
        let instances = self.instances(reference, context)?;
        let instances = instances.into_iter().map(rational).collect::<Result<Vec<Instance>, _>>();
        let instances = instances.map_err(Unresolved::Scheme)?;
        let constants = instances.iter().map(|instance| self.constants(instance));
        let constants = constants.collect::<Result<_, _>>().map_err(Unresolved::Scheme)?;
        Ok(Resolved { instances, constants: Axes::of(constants) })
    }

    /// The ring of this scheme, one name with parameters.
    pub(crate) fn ring<V: Value + Eq + Hash>(
        &self,
        scheme: &[Instance<V>],
    ) -> Result<LocalRules<V>, SchemeError> {
        match scheme {
            [instance] => self.define(&instance.name)?.ring(&instance.parameters),
            _ => Err(SchemeError::NotRing { scheme: "a tensor product".to_owned() }),
        }
    }

    /// Whether this scheme is one ring.
    pub(crate) fn is_ring<V>(&self, scheme: &[Instance<V>]) -> Result<bool, SchemeError> {
        match scheme {
            [instance] => Ok(self.define(&instance.name)?.is_ring()),
            _ => Ok(false),
        }
    }

    /// The ring of this scheme at a valence, which is the value of its parameter `N` or `n`.
    pub(crate) fn ring_of_valence<V: Value + Eq + Hash>(
        &self,
        scheme: &[Instance<V>],
        valence: usize,
    ) -> Result<LocalRules<V>, SchemeError> {
        let [instance] = scheme else { return self.ring(scheme) };
        let definition = self.define(&instance.name)?;
        let mut parameters = instance.parameters.clone();
        definition.set_valence(&instance.name, &instance.parameters, &mut parameters, valence)?;
        definition.ring(&parameters)
    }

    /// The name in the catalogue of a scheme without parameters.
    pub(crate) fn in_catalogue<'i, V>(&self, scheme: &'i [Instance<V>]) -> Option<&'i str> {
        match scheme {
            [instance]
                if instance.parameters.is_empty()
                    && !self.paper.schemes.contains_key(&instance.name) =>
            {
                Some(&instance.name)
            }
            _ => None,
        }
    }

    /// The masks of these schemes, over numbers of any kind.
    pub(crate) fn masks<V: Value + PartialEq>(
        &self,
        instances: &[Instance<V>],
    ) -> Result<Scheme<V>, Unresolved> {
        let mask = |instance: &Instance<V>| self.define(&instance.name)?.mask(&instance.parameters);
        let masks = instances.iter().map(mask).collect::<Result<_, _>>();
        masks.map(Scheme::of).map_err(Unresolved::Scheme)
    }

    /// The mask on Z^d that this names, if it is one.
    pub(crate) fn lattice<V: Value + PartialEq>(
        &self,
        scheme: &[Instance<V>],
    ) -> Result<Option<LatticeMask<V>>, SchemeError> {
        let [instance] = scheme else { return Ok(None) };
        let definition = self.define(&instance.name)?;
        definition.is_lattice().then(|| definition.lattice(&instance.parameters)).transpose()
    }

    /// The filter that this names, if it is one.
    pub(crate) fn filter<V: Value + PartialEq>(
        &self,
        scheme: &[Instance<V>],
    ) -> Result<Option<Mask<V>>, SchemeError> {
        let [instance] = scheme else { return Ok(None) };
        let definition = self.define(&instance.name)?;
        let filter =
            definition.is_filter().then(|| definition.mask_or_filter(&instance.parameters));
        filter.transpose()
    }

    /// The schemes behind the names of `reference`, their parameters evaluated in
    /// `context`.
    pub(crate) fn instances<V: Value>(
        &self,
        reference: &Reference,
        context: &dyn Context<V>,
    ) -> Result<Vec<Instance<V>>, Unresolved> {
        let instances = self.followed(reference, context, &[], 0)?;
        ReferenceError::check_factors(&reference.to_string(), instances.len())
            .map_err(|error| Unresolved::Scheme(error.into()))?;
        Ok(instances)
    }

    /// As [`Library::instances`], with values for the parameters of the name that is followed. A
    /// name of the claim file may stand for another scheme, whose parameters are evaluated where
    /// the name is used; there the parameters of the name have these `values`.
    fn followed<V: Value>(
        &self,
        reference: &Reference,
        context: &dyn Context<V>,
        values: &[(String, V)],
        depth: usize,
    ) -> Result<Vec<Instance<V>>, Unresolved> {
        let mut instances = Vec::new();
        let named = reference.instances_with(context, values).map_err(Unresolved::Formula)?;
        for instance in named {
            match self.paper.schemes.get(&instance.name) {
                Some(SchemeSource::Alias(other)) => {
                    self.check_handed_on(&instance, other).map_err(Unresolved::Scheme)?;
                    if depth >= MAX_ALIAS_DEPTH {
                        let (name, cap) = (instance.name, MAX_ALIAS_DEPTH);
                        return Err(Unresolved::Scheme(SchemeError::TooManyNames { name, cap }));
                    }
                    let inner = instance.parameters.into_iter().chain(values.iter().cloned());
                    let inner: Vec<(String, V)> = inner.collect();
                    instances.extend(self.followed(other, context, &inner, depth + 1)?);
                }
                _ => instances.push(instance),
            }
        }
        Ok(instances)
    }

    /// Checks that every parameter given to a name of the claim file occurs in the formulas of the
    /// scheme that the name stands for.
    fn check_handed_on<V>(
        &self,
        instance: &Instance<V>,
        stands_for: &Reference,
    ) -> Result<(), SchemeError> {
        let mut known = stands_for.parameters();
        known.retain(|name| !self.paper.definitions.contains_key(name));
        match instance.parameters.keys().find(|name| !known.contains(*name)) {
            None => Ok(()),
            Some(parameter) => Err(SchemeError::NotHandedOn {
                scheme: instance.name.clone(),
                stands_for: stands_for.to_string(),
                parameter: parameter.clone(),
                known: known.into_iter().collect(),
            }),
        }
    }

    pub(crate) fn define(&self, name: &str) -> Result<&SchemeDefinition, SchemeError> {
        match self.paper.schemes.get(name) {
            Some(SchemeSource::Own(definition)) => Ok(definition),
            _ => find_in_catalogue(name).map_err(|error| match error {
                SchemeError::Unknown { name, mut known, .. } => {
                    known.splice(0..0, self.paper.schemes.keys().cloned());
                    SchemeError::UnknownInPaper { name, known }
                }
                other => other,
            }),
        }
    }

    fn constants(&self, instance: &Instance) -> Result<Rc<Constants>, SchemeError> {
        if let Some(known) = self.constants.borrow().get(instance) {
            return Ok(Rc::clone(known));
        }
        let mask = self.define(&instance.name)?.mask(&instance.parameters)?;
        let constants = self.constants_of(mask);
        self.constants.borrow_mut().insert(instance.clone(), Rc::clone(&constants));
        Ok(constants)
    }

    /// The constants of a mask with other numbers of its points.
    pub(crate) fn numbered_from(
        &self,
        instance: &Instance,
        mask: &Mask,
        first: usize,
    ) -> Rc<Constants> {
        let key = (instance.clone(), first);
        let new = || self.constants_of(mask.numbered_from(first));
        Rc::clone(self.numbered.borrow_mut().entry(key).or_insert_with(new))
    }

    /// As [`log_level_algebraic`]; a logarithm is computed once for all cells and readings.
    pub(crate) fn log_level(
        &self,
        ratio: &RealCyclotomic,
        x: &RealCyclotomic,
        rounded: Rounded,
    ) -> Result<u32, DepthError> {
        let compute = || log_level_algebraic(ratio, x, rounded);
        let key = (ratio.stored(), x.stored(), rounded);
        self.log_levels.borrow_mut().entry(key).or_insert_with(compute).clone()
    }

    /// The sound bound of a scheme, at the given offset or at its own.
    pub(crate) fn sound_bound(
        &self,
        scheme: &Resolved,
        offset: Option<i64>,
    ) -> Result<Rc<SoundBound>, ClassCap> {
        let key = (scheme.instances.clone(), offset);
        if let Some(known) = self.sound.borrow().get(&key) {
            return Ok(Rc::clone(known));
        }
        let shifted = match offset {
            None => scheme.constants.clone(),
            Some(_) => scheme.at(offset).map(|mask| Rc::new(Constants::new(mask.clone()))),
        };
        let block = block_length(&shifted);
        let bound = Rc::new(match &shifted {
            Axes::Curve(curve) => SoundBound::curve(curve, block)?,
            Axes::Tensor(first, second) => SoundBound::surface(first, second, block)?,
        });
        self.sound.borrow_mut().insert(key, Rc::clone(&bound));
        Ok(bound)
    }

    /// The ring that `reference` means in `context`, with its scheme, whose parameters are
    /// rational.
    pub(crate) fn ring_at(
        &self,
        reference: &Reference,
        context: &dyn Context<RealCyclotomic>,
    ) -> Result<(Instance, LocalRules), Unresolved> {
        let instances = self.instances(reference, context)?;
        let ring = self.ring(&instances).map_err(Unresolved::Scheme)?;
        let instance = instances.into_iter().next().expect("a ring has one name");
        Ok((rational(instance).map_err(Unresolved::Scheme)?, ring))
    }
}

/// The scheme with rational parameters; an error if one is irrational.
fn rational(instance: Instance<RealCyclotomic>) -> Result<Instance, SchemeError> {
    let Instance { name, parameters } = instance;
    let parameter = |(parameter, value): (String, RealCyclotomic)| match value.as_rational() {
        Some(rational) => Ok((parameter, rational.clone())),
        None => Err(SchemeError::IrrationalParameter {
            scheme: name.clone(),
            parameter,
            value: value.to_string(),
        }),
    };
    let parameters = parameters.into_iter().map(parameter).collect::<Result<_, _>>()?;
    Ok(Instance { name, parameters })
}

/// The greatest block length with at most [`MAX_SOUND_CLASSES`] residue classes.
fn block_length(constants: &Axes<Rc<Constants>>) -> u32 {
    let arity = constants.iter().map(|axis| axis.mask().arity() as u64).max().unwrap_or(2);
    (1..=MAX_SOUND_BLOCK).rev().find(|&c| arity.pow(c) <= MAX_SOUND_CLASSES).unwrap_or(1)
}

/// The values of formulas without parameters.
pub(crate) fn values<'f>(
    formulas: impl IntoIterator<Item = (&'f String, &'f LocatedFormula)>,
) -> Result<BTreeMap<String, Rational>, Diagnostic> {
    let value = |(name, formula): (&String, &LocatedFormula)| {
        let value = evaluate(&formula.expr, &Parameters::<Rational>::default());
        match value {
            Ok(value) => Some(Ok((name.clone(), value))),
            Err(error) if error.kind.cap().is_some() => None,
            Err(error) => Some(Err(formula.diagnostic(&error))),
        }
    };
    formulas.into_iter().filter_map(value).collect()
}
