//! The meaning of names in each claim: every name has one (`proofs/FORMAT.md`, Names).

use super::file::PaperFile;
use super::kind::{Named, Role};
use super::reader::Reader;
use crate::diagnostic::Diagnostic;
use crate::scheme::Spanned;
use std::collections::BTreeMap;
use std::rc::Rc;

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
        for (fields, claim) in file.claims() {
            let mut roles = if claim.takes_given() { common.clone() } else { definitions.clone() };
            for (name, named) in claim.names() {
                self.insert(&mut roles, name, named)?;
            }
            claims.insert(fields.id.get_ref().as_str(), roles);
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
