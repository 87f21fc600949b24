//! The functions that claims can use: constants of the scheme they are about.

use crate::bound::{
    ClassCap, Constants, DepthError, MAX_DEPTH, Operator, Order, Suprema, Terms, best_offset,
    surface_displacement,
};
use crate::cap::Cap;
use crate::evaluation::arguments::level;
use crate::evaluation::constants::{moved, total_contraction};
use crate::evaluation::functions::check_name;
use crate::evaluation::library::{Library, Resolved};
use crate::evaluation::options::{Exponent, Options};
use crate::evaluation::reference::{reference, unresolved};
use crate::evaluation::series;
use crate::evaluation::settings::Settings;
use crate::evaluation::shape::shape;
use crate::evaluation::trace::{LevelCall, Noted, NotedConstant};
use crate::exact::{Rational, RealCyclotomic};
use crate::formula::{Call, CallError, Context, Functions, Parameters};
use crate::scheme::Rules;
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
}

impl Quantities<'_> {
    /// A constant or a coefficient of a scheme.
    fn of_scheme(
        &self,
        call: &Call<'_, RealCyclotomic>,
        options: &mut Options<'_>,
    ) -> Result<RealCyclotomic, CallError> {
        let other;
        let named = options.take("scheme");
        let scheme = match &named {
            None => self.scheme.as_ref(),
            Some(name) => {
                other = self.other_scheme(name)?;
                Some(&other)
            }
        };
        let missing = || CallError::Misuse("this needs a scheme: give the table one".to_owned());
        let scheme = scheme.ok_or_else(missing)?;
        let constants: &Constants = scheme.constants.first();
        let in_order = |order| self.in_order(scheme, order);
        let note = |operator, levels, order| {
            let Some(noted) = &self.noted else { return };
            noted.borrow_mut().constants.push(NotedConstant {
                instance: scheme.instances[0].clone(),
                constants: Rc::clone(scheme.constants.first()),
                operator,
                levels,
                order,
                named: named.clone(),
            });
        };
        let value = match (call.function, call.arguments) {
            ("contraction", [c]) => {
                let (c, order) = (level(c)?, options.order()?);
                match options.terms()? {
                    Terms::Each => {
                        note(Operator::Difference, c, order);
                        capped(in_order(order).norm(Operator::Difference, c, order))
                    }
                    Terms::Total if c == 1 => Ok(total_contraction(constants.difference())),
                    Terms::Total => {
                        let message = "`terms = total` is defined for c = 1 only";
                        return Err(CallError::Misuse(message.to_owned()));
                    }
                }
            }
            ("norm", [c]) => {
                let (c, order) = (level(c)?, options.order()?);
                note(Operator::Scheme, c, order);
                capped(in_order(order).norm(Operator::Scheme, c, order))
            }
            ("tensor", [c]) => {
                let (c, order, suprema) = (level(c)?, options.order()?, options.suprema()?);
                if suprema == Suprema::Independent {
                    note(Operator::Difference, c, order);
                    note(Operator::Scheme, c, order);
                }
                capped(in_order(order).tensor(c, order, suprema))
            }
            ("displacement", []) => {
                let mask = constants.mask();
                moved(mask, options, || Some(best_offset(mask).0))
            }
            ("surface_displacement", [x1, x2, x3]) => {
                let spreads = [rational(x1)?, rational(x2)?, rational(x3)?];
                let terms = options.terms()?;
                Ok(surface_displacement(constants.mask(), spreads, terms))
            }
            _ => {
                let rules = |rules: &Rules| rules.map(|value| RealCyclotomic::from(value.clone()));
                let mask = constants.mask().map(|value| RealCyclotomic::from(value.clone()));
                return shape(&mask, || rules(constants.difference()), call, options);
            }
        };
        value.map(RealCyclotomic::from)
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
        let (ratio, x) = (ratio.clone(), x.clone());
        let call = LevelCall { ratio, x, rounded, level: level.clone().ok() };
        self.last_levels.replace(Some(call));
        level.map(RealCyclotomic::from).map_err(|error| match error {
            DepthError::TooDeep => {
                let what = "the number of levels, or a number that decides it,";
                CallError::BeyondCap(Cap::new(what, MAX_DEPTH.into()))
            }
            _ => CallError::Undefined(error.to_string()),
        })
    }

    fn other_scheme(&self, name: &str) -> Result<Resolved, CallError> {
        let reference = reference(name)?;
        let resolved = self.library.resolve(&reference, &Parameters::<RealCyclotomic>::default());
        resolved.map_err(|error| unresolved(name, error))
    }
}

fn capped(value: Result<Rational, ClassCap>) -> Result<Rational, CallError> {
    value.map_err(|error| CallError::BeyondCap(error.cap()))
}

/// The value as a rational number; an error if it is irrational.
fn rational(value: &RealCyclotomic) -> Result<&Rational, CallError> {
    value.as_rational().ok_or_else(|| {
        CallError::Misuse(format!("this is computed at rational numbers only, and not at {value}"))
    })
}
