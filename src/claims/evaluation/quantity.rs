//! The functions that claims can use: constants of the scheme they are about.

use crate::bound::{Constants, Operator, Order};
use crate::evaluation::functions::check_name;
use crate::evaluation::library::{Library, Resolved};
use crate::evaluation::masks::constants::{OfMask, constant, no_level};
use crate::evaluation::masks::rules::shape;
use crate::evaluation::options::{Exponent, Options};
use crate::evaluation::reals::{About, Used, about, as_value};
use crate::evaluation::reference::{reference, unresolved};
use crate::evaluation::series;
use crate::evaluation::settings::Settings;
use crate::evaluation::trace::{LevelCall, Noted, NotedConstant};
use crate::exact::RealCyclotomic;
use crate::formula::{Call, CallError, Context, Functions, Parameters};
use crate::scheme::{Mask, Rules};
use std::cell::RefCell;
use std::rc::Rc;

/// The quantities of one scheme, in exact numbers.
pub(crate) struct Quantities<'a> {
    pub(crate) library: &'a Library<'a>,
    pub(crate) scheme: Option<Resolved>,
    /// How the formula is read.
    pub(crate) settings: &'a Settings,
    /// The constants that formulas have used so far, if they are noted.
    pub(crate) noted: Option<RefCell<Noted>>,
    /// The last call of `levels`.
    pub(crate) last_levels: RefCell<Option<LevelCall>>,
}

impl Functions<RealCyclotomic> for Quantities<'_> {
    fn call(
        &self,
        call: &Call<'_, RealCyclotomic>,
        context: &dyn Context<RealCyclotomic>,
    ) -> Result<RealCyclotomic, CallError> {
        check_name(call.function)?;
        let mut options = Options::new(call).read_as(self.settings);
        let value = match (call.function, call.arguments) {
            ("levels", [ratio, x]) => self.levels(ratio, x, &mut options)?,
            ("levels", [ratio, x, c]) => {
                let levels = self.levels(ratio, x, &mut options)?;
                match options.exponent()? {
                    Exponent::Level => levels,
                    Exponent::Block => &levels * c,
                }
            }
            _ => {
                let noted = self.noted.as_ref();
                let note = noted.map(|noted| |norm| noted.borrow_mut().norms.push(norm));
                let note = note.as_ref().map(|note| note as series::Note<'_, RealCyclotomic>);
                match series::call(call, context, &mut options, &self.library.norms, note) {
                    Some(value) => value?,
                    None => self.of_scheme(call, &mut options)?,
                }
            }
        };
        options.finished(value)
    }

    fn is_scheme(&self, function: &str, name: &str) -> bool {
        self.library.is_scheme(function, name)
    }
}

impl Quantities<'_> {
    /// A constant or a coefficient of a scheme.
    fn of_scheme(
        &self,
        call: &Call<'_, RealCyclotomic>,
        options: &mut Options<'_>,
    ) -> Result<RealCyclotomic, CallError> {
        let other;
        let named = options.scheme()?;
        let scheme = match &named {
            None => self.scheme.as_ref(),
            Some(name) => {
                other = self.other_scheme(name)?;
                Some(&other)
            }
        };
        let missing = || CallError::Misuse("this needs a scheme: give the table one".to_owned());
        let scheme = scheme.ok_or_else(missing)?;
        if let Some(about) = about(call.function) {
            if about == About::Ring {
                let message = "around a vertex or on a face, write this as a [[relation]]";
                return Err(CallError::Misuse(message.to_owned()));
            }
            let (mask, none) = (scheme.constants.first().mask(), Used::default());
            let mask = mask.map(|value| RealCyclotomic::from(value.clone()));
            let reals = &self.library.reals;
            let value = reals.of_mask(&mask, call, &self.library.limits, (&None, &none))?;
            return as_value(call.function, &value);
        }
        if let Some(value) = constant(call, options, &InScheme { of: self, scheme, named: &named })?
        {
            return Ok(value);
        }
        let constants: &Constants = scheme.constants.first();
        let rules = |rules: &Rules| rules.map(|value| RealCyclotomic::from(value.clone()));
        let irrational = |mask: &Mask| mask.map(|value| RealCyclotomic::from(value.clone()));
        let other = |name: &str| Ok(irrational(self.other_scheme(name)?.constants.first().mask()));
        let mask = irrational(constants.mask());
        let known = &self.library.limits;
        shape(&mask, || rules(constants.difference()), call, options, (other, known))
    }

    /// The constants of a scheme's first mask in this order. Those of a mask that is read forwards
    /// depend on the numbers of the points.
    fn in_order(&self, scheme: &Resolved, order: Order) -> Rc<Constants> {
        let own = scheme.constants.first();
        match (order, self.settings.first % own.mask().arity()) {
            (Order::Adjoint, _) | (_, 0) => Rc::clone(own),
            (Order::Forward, first) => {
                self.library.numbered_from(&scheme.instances[0], own.mask(), first)
            }
        }
    }

    fn levels(
        &self,
        ratio: &RealCyclotomic,
        x: &RealCyclotomic,
        options: &mut Options<'_>,
    ) -> Result<RealCyclotomic, CallError> {
        let rounded = options.rounded()?;
        let level = self.library.log_level(ratio, x, rounded);
        let call =
            LevelCall { ratio: ratio.clone(), x: x.clone(), rounded, level: level.clone().ok() };
        self.last_levels.replace(Some(call));
        level.map(RealCyclotomic::from).map_err(|error| no_level(&error))
    }

    fn other_scheme(&self, name: &str) -> Result<Resolved, CallError> {
        let reference = reference(name)?;
        let resolved = self.library.resolve(&reference, &Parameters::<RealCyclotomic>::default());
        resolved.map_err(|error| unresolved(name, error))
    }
}

/// The scheme of a call, whose constants may be noted.
struct InScheme<'a> {
    of: &'a Quantities<'a>,
    scheme: &'a Resolved,
    /// The name in the option `scheme`.
    named: &'a Option<String>,
}

impl OfMask for InScheme<'_> {
    fn in_order(&self, order: Order) -> Rc<Constants> {
        self.of.in_order(self.scheme, order)
    }

    fn note(&self, operator: Operator, levels: u32, order: Order) {
        let Some(noted) = &self.of.noted else { return };
        noted.borrow_mut().constants.push(NotedConstant {
            instance: self.scheme.instances[0].clone(),
            constants: Rc::clone(self.scheme.constants.first()),
            operator,
            levels,
            order,
            named: self.named.clone(),
        });
    }
}
