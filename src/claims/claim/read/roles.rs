//! The meaning of names in each claim: every name has one (`proofs/FORMAT.md`, Names).

use super::file::PaperFile;
use super::reader::Reader;
use crate::claim::THEOREM_NAMES;
use crate::diagnostic::Diagnostic;
use crate::scheme::Spanned;
use std::collections::BTreeMap;
use std::fmt;
use std::ops::Range;
use std::rc::Rc;

/// The role of a name in a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    /// A key of `[define]`.
    Definition,
    /// A key of `[given]`.
    Stated,
    /// A key of the claim's own `given`.
    Given,
    /// A key of the table's `unstated`.
    Unstated,
    /// The name of `rows`, or of `columns`, where the headers are numbers.
    Header,
    /// One of an equation's `symbols`.
    Symbol,
    /// The name of one of an equation's `indices`.
    Index,
    /// The `variable` of a function or a range.
    Variable,
    /// A key of a theorem's `values`.
    Open,
    /// One of [`THEOREM_NAMES`], in a theorem with a bound or a depth.
    OfTheorem,
}

impl fmt::Display for Role {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Role::Definition => "a definition",
            Role::Stated => "a value that the paper states",
            Role::Given => "a value that the claim states",
            Role::Unstated => "a parameter that is not stated",
            Role::Header => "the parameter of the headers",
            Role::Symbol => "a symbol",
            Role::Index => "an index of the equation",
            Role::Variable => "the free parameter",
            Role::Open => "a parameter of the theorem",
            Role::OfTheorem => "the spread, the level or the tolerance of this theorem",
        })
    }
}

/// The role of a name, and the place in the file that gives it this role.
#[derive(Clone, Debug)]
pub(super) struct Named {
    pub(super) role: Role,
    pub(super) span: Range<usize>,
}

/// The roles of names: those of a claim's own, and those that it shares with the others.
#[derive(Clone, Default)]
pub(super) struct Roles<'f> {
    own: BTreeMap<&'f str, Named>,
    shared: Rc<BTreeMap<&'f str, Named>>,
}

impl<'f> Roles<'f> {
    pub(super) fn get(&self, name: &str) -> Option<&Named> {
        self.own.get(name).or_else(|| self.shared.get(name))
    }

    /// The same roles, shared by all who get a copy.
    fn sharing(self) -> Roles<'f> {
        let mut all = Rc::unwrap_or_clone(self.shared);
        all.extend(self.own);
        Roles { own: BTreeMap::new(), shared: Rc::new(all) }
    }
}

/// The roles of names in the file, and in each claim by its id.
pub(super) struct AllRoles<'f> {
    pub(super) definitions: Roles<'f>,
    claims: BTreeMap<&'f str, Roles<'f>>,
}

impl<'f> AllRoles<'f> {
    /// The roles of names in a claim, including the file's definitions and, but for equations, its
    /// stated values.
    pub(super) fn of(&self, id: &str) -> &Roles<'f> {
        &self.claims[id]
    }
}

impl Reader<'_> {
    /// Finds the roles of names in each claim of a file.
    ///
    /// # Errors
    /// When a name has two roles; the error has both places. Only a value of `[given]` may share
    /// its name with an own name of a claim, which hides it there.
    pub(super) fn roles<'f>(&self, file: &'f PaperFile) -> Result<AllRoles<'f>, Diagnostic> {
        let mut definitions = Roles::default();
        for name in file.define.keys() {
            self.add(&mut definitions, name, Role::Definition)?;
        }
        let definitions = definitions.sharing();
        let mut common = definitions.clone();
        for name in file.given.keys() {
            self.add(&mut common, name, Role::Stated)?;
        }
        let common = common.sharing();
        let mut claims = BTreeMap::new();
        for table in &file.table {
            let mut roles = common.clone();
            for name in table.given.keys() {
                self.add(&mut roles, name, Role::Given)?;
            }
            for name in table.unstated.names() {
                self.add(&mut roles, name, Role::Unstated)?;
            }
            let axes = table.rows.iter().chain([&table.columns]);
            for name in axes.filter_map(|axis| axis.get_ref().name.as_ref()) {
                self.add(&mut roles, name, Role::Header)?;
            }
            claims.insert(table.common().id.get_ref().as_str(), roles);
        }
        for equation in &file.equation {
            // The values of `[given]` have no meaning in equations.
            let mut roles = definitions.clone();
            for symbol in &equation.symbols {
                self.add(&mut roles, symbol, Role::Symbol)?;
            }
            for name in equation.indices.iter().filter_map(|axis| axis.get_ref().name.as_ref()) {
                self.add(&mut roles, name, Role::Index)?;
            }
            claims.insert(equation.common().id.get_ref().as_str(), roles);
        }
        let functions = file.function.iter().map(|claim| (claim.common(), &claim.variable));
        let ranges = file.range.iter().map(|claim| (claim.common(), &claim.variable));
        for (claim, variable) in functions.chain(ranges) {
            let mut roles = common.clone();
            self.add(&mut roles, variable, Role::Variable)?;
            claims.insert(claim.id.get_ref().as_str(), roles);
        }
        let smoothness = file.smoothness.iter().map(|claim| (claim.common(), &claim.given));
        let exponents = file.exponent.iter().map(|claim| (claim.common(), &claim.given));
        for (claim, given) in smoothness.chain(exponents) {
            let mut roles = common.clone();
            for name in given.keys() {
                self.add(&mut roles, name, Role::Given)?;
            }
            claims.insert(claim.id.get_ref().as_str(), roles);
        }
        for theorem in &file.theorem {
            let mut roles = common.clone();
            for name in theorem.values.keys() {
                self.add(&mut roles, name, Role::Open)?;
            }
            for name in theorem.by.iter().flat_map(|by| THEOREM_NAMES.map(|name| (name, by))) {
                let ((name, by), role) = (name, Role::OfTheorem);
                self.insert(&mut roles, name, Named { role, span: by.span() })?;
            }
            claims.insert(theorem.common().id.get_ref().as_str(), roles);
        }
        Ok(AllRoles { definitions, claims })
    }

    fn add<'f>(
        &self,
        roles: &mut Roles<'f>,
        name: &'f Spanned<String>,
        role: Role,
    ) -> Result<(), Diagnostic> {
        self.insert(roles, name.get_ref(), Named { role, span: name.span() })
    }

    fn insert<'f>(
        &self,
        roles: &mut Roles<'f>,
        name: &'f str,
        named: Named,
    ) -> Result<(), Diagnostic> {
        let (role, span) = (named.role, named.span.clone());
        let other = roles.get(name).cloned();
        roles.own.insert(name, named);
        match other {
            Some(other) if other.role != Role::Stated || role == Role::Stated => {
                let message = format!("`{name}` has two meanings here");
                Err(self
                    .error(span, message)
                    .with_label(format!("{role}"))
                    .with_place(other.span, format!("{}", other.role))
                    .with_help("give one of the two another name"))
            }
            _ => Ok(()),
        }
    }
}
