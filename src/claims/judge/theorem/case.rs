//! The instances of a theorem: a scheme and values on which it is tried.

use crate::bound::Budget;
use crate::cap::Cap;
use crate::claim::{LocatedReference, Paper, THEOREM_NAMES, Theorem, Trial};
use crate::diagnostic::Diagnostic;
use crate::evaluation::library::{Library, Resolved, values};
use crate::evaluation::reference::{self, Unresolved};
use crate::evaluation::settings::Settings;
use crate::exact::{Rational, RealCyclotomic};
use crate::formula::{FormulaErrorKind, LocatedFormula};
use crate::judge::distance::{LocalCap, MAX_LOCAL_SIZE, MAX_STEPS};
use crate::judge::theorem::local_rules::AroundPoint;
use crate::judge::theorem::setting::Setting;
use crate::judge::theorem::uniform::Uniform;
use crate::limit::natural_shift;
use crate::scheme::{Instance, LocalRules, SchemeError};
use std::cell::{OnceCell, RefCell};
use std::collections::BTreeMap;
use std::rc::Rc;

/// Settings by the data that determine them.
type Kept<K, S> = RefCell<BTreeMap<K, Rc<S>>>;

/// The settings on which one theorem is tried. Each scheme at each offset is set up once, and keeps
/// its results.
pub(crate) struct Stage {
    uniform: Kept<(Vec<Instance>, Option<i64>), Uniform>,
    rings: Kept<LocalKey, AroundPoint>,
    ring_cap: LocalCap,
    /// The work that all searches for distances may take together.
    budget: Budget,
}

/// The schemes of a ring and of its interpolant.
type LocalKey = (LocalScheme, Option<LocalScheme>);

/// The scheme that a reference to a ring names.
type LocalScheme = Vec<Instance<RealCyclotomic>>;

impl Default for Stage {
    fn default() -> Stage {
        let (uniform, rings, ring_cap) = Default::default();
        Stage { uniform, rings, ring_cap, budget: Budget::new(MAX_STEPS) }
    }
}

impl Stage {
    fn uniform(&self, scheme: &Resolved, offset: Option<i64>) -> Rc<dyn Setting> {
        let key = (scheme.instances.clone(), offset);
        let new = || Rc::new(Uniform::new(scheme.at(offset), &self.budget));
        Rc::clone(self.uniform.borrow_mut().entry(key).or_insert_with(new)) as Rc<dyn Setting>
    }
}

/// An instance of a theorem: one scheme, and one value of each name that the theorem leaves open.
pub(crate) struct Case<'a> {
    pub(crate) label: String,
    /// The reference to the scheme, as the claim has it.
    pub(crate) scheme: String,
    /// The values that were chosen.
    pub(crate) chosen: Vec<(String, Rational)>,
    pub(crate) paper: &'a Paper,
    pub(crate) library: &'a Library<'a>,
    pub(crate) values: BTreeMap<String, Rational>,
    /// The stated values that are beyond a cap.
    pub(crate) stated: BTreeMap<String, LocatedFormula>,
    pub(crate) resolved: Option<Resolved>,
    /// Whether the bound is proportional to the spread, once this has been asked.
    pub(crate) linear: OnceCell<bool>,
    /// The cap that the scheme is beyond; then it has no setting.
    pub(crate) beyond: Option<Cap>,
    /// `None` where the program has no exact limits of this kind of scheme.
    pub(crate) setting: Option<Rc<dyn Setting>>,
}

impl<'a> Case<'a> {
    /// All different cases of a theorem; none when it names no scheme to be tried on.
    pub(crate) fn all(
        paper: &'a Paper,
        theorem: &'a Theorem,
        library: &'a Library<'a>,
        stage: &Stage,
    ) -> Result<Vec<Case<'a>>, Diagnostic> {
        let tried = &theorem.tried;
        let schemes: Vec<&LocatedReference> = match &theorem.scheme {
            Some(scheme) => vec![scheme],
            None => tried.schemes.iter().collect(),
        };
        let mut combinations = vec![Vec::new()];
        for (name, values) in &tried.values {
            let longer = combinations.iter().flat_map(|shorter| {
                values.iter().map(move |value| [shorter.clone(), vec![(name, value)]].concat())
            });
            combinations = longer.collect();
        }
        let mut given = values(&paper.given)?;
        // These names mean what the theorem says, not what the paper states for them.
        given.retain(|name, _| !THEOREM_NAMES.contains(&name.as_str()));
        let mut stated = paper.given.clone();
        stated
            .retain(|name, _| !given.contains_key(name) && !THEOREM_NAMES.contains(&name.as_str()));
        let mut cases = Vec::new();
        for scheme in schemes {
            for values in &combinations {
                let chosen = values.iter().map(|(name, value)| ((*name).clone(), (*value).clone()));
                let mut case = Case {
                    label: String::new(),
                    scheme: scheme.reference.to_string(),
                    chosen: chosen.collect(),
                    paper,
                    library,
                    values: given.clone(),
                    stated: stated.clone(),
                    resolved: None,
                    linear: OnceCell::new(),
                    beyond: None,
                    setting: None,
                };
                case.values.extend(case.chosen.iter().cloned());
                // A theorem about a scheme with parameters of which none has a value
                // is not tried.
                let name = match Diagnostic::or_cap(case.resolve(scheme, tried, stage))? {
                    Ok(name) => name,
                    Err(cap) => {
                        case.beyond = Some(cap);
                        Some(case.scheme.clone())
                    }
                };
                if let Some(name) = name {
                    // Values that the reference to the scheme uses are shown in its parameters
                    // already.
                    let text = scheme.reference.to_string();
                    let words: Vec<&str> =
                        text.split(|c: char| !c.is_alphanumeric() && c != '_').collect();
                    let free = values.iter().filter(|(name, _)| !words.contains(&name.as_str()));
                    let shown = free.map(|(name, value)| format!("{name} = {value}"));
                    case.label = std::iter::once(name).chain(shown).collect::<Vec<_>>().join(", ");
                    let is_new = |other: &Case<'_>| {
                        (&other.label, &other.chosen) != (&case.label, &case.chosen)
                    };
                    if cases.iter().all(is_new) {
                        cases.push(case);
                    }
                }
            }
        }
        Ok(cases)
    }

    /// Whether it is about a ring, which has no mask.
    pub(crate) fn is_ring(&self) -> bool {
        self.resolved.is_none() && self.beyond.is_none()
    }

    /// Whether the points have natural parameters: the points of a ring are there.
    pub(crate) fn has_natural_parameters(&self) -> bool {
        let keeps = |scheme: &Resolved| {
            scheme.constants.iter().all(|axis| natural_shift(axis.mask()).keeps_lines)
        };
        self.resolved.as_ref().is_none_or(keeps)
    }

    /// Finds the scheme, and gives its name; `None` when its parameters have no values.
    fn resolve(
        &mut self,
        located: &LocatedReference,
        tried: &Trial,
        stage: &Stage,
    ) -> Result<Option<String>, Diagnostic> {
        let Trial { offset, values, interpolant, .. } = tried;
        let (valued, interpolant) = (!values.is_empty(), interpolant.as_ref());
        let settings = Settings::default();
        let functions = self.functions(&settings);
        let scope = self.scope(&functions, &[]);
        match self.library.resolve(&located.reference, &scope) {
            Ok(resolved) => {
                if let Some(LocatedReference { source, span, .. }) = interpolant {
                    let message = "masks are compared at their offset, and have no interpolant";
                    return Err(Diagnostic::new(source, span.clone(), message));
                }
                self.setting = Some(stage.uniform(&resolved, *offset));
                let name = joined(&resolved.instances);
                self.resolved = Some(resolved);
                Ok(Some(name))
            }
            Err(Unresolved::Formula(error))
                if !valued && matches!(error.kind, FormulaErrorKind::UnknownName { .. }) =>
            {
                Ok(None)
            }
            Err(Unresolved::Scheme(SchemeError::LocalRules { .. })) => {
                if offset.is_some() {
                    let message = "this theorem has an `offset`, and a ring has none";
                    let LocatedReference { source, span, .. } = located;
                    return Err(Diagnostic::new(source, span.clone(), message).with_help(
                        "leave `offset` out, or state the theorem of masks apart from that of rings",
                    ));
                }
                let ring = |located: &LocatedReference| -> Result<_, Diagnostic> {
                    let failed = |error| reference::located(located, &error);
                    let instances = self.library.instances(&located.reference, &scope);
                    let instances = instances.map_err(failed)?;
                    let ring = self.library.ring(&instances).map_err(Unresolved::Scheme);
                    Ok((instances, ring.map_err(failed)?))
                };
                let (instances, own) = ring(located)?;
                let interpolant = interpolant.map(|located| {
                    let (instances, interpolant) = ring(located)?;
                    let names = |ring: &LocalRules<_>| {
                        (0..ring.point_count()).map(|a| ring.name(a)).collect::<Vec<String>>()
                    };
                    if names(&interpolant) == names(&own) {
                        return Ok((instances, interpolant));
                    }
                    let message = "an interpolant has the same points as the ring";
                    Err(Diagnostic::new(&located.source, located.span.clone(), message).with_help(
                        "list the same orbits with as many points each, in the same order",
                    ))
                });
                let name = joined(&instances);
                let (earlier, interpolant) = interpolant.transpose()?.unzip();
                let key = (instances, earlier);
                if !stage.ring_cap.takes(&own) {
                    let what = "the sum of the squares of the numbers of points of the rings";
                    let cap = Cap::new(what, MAX_LOCAL_SIZE as u64);
                    let LocatedReference { source, span, .. } = located;
                    return Err(
                        Diagnostic::new(source, span.clone(), cap.to_string()).with_cap(Some(cap))
                    );
                }
                let new = || Rc::new(AroundPoint::new(own, interpolant, &stage.budget));
                let found = Rc::clone(stage.rings.borrow_mut().entry(key).or_insert_with(new));
                self.setting = Some(found);
                Ok(Some(name))
            }
            Err(error) => Err(reference::located(located, &error)),
        }
    }
}

/// `six-point:w=3/256 x chaikin`.
fn joined<V: std::fmt::Display>(instances: &[Instance<V>]) -> String {
    instances.iter().map(ToString::to_string).collect::<Vec<String>>().join(" x ")
}
