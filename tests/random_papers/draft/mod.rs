//! Random papers.

mod by;
mod equation;
mod local_rules;
mod names;
mod parametric;
mod scheme;
mod shape;
mod table;
mod theorem;

pub use equation::Identity;
pub use names::{Mood, Names};
pub use parametric::Parametric;
pub use shape::{Instance, Shape, environment};
pub use theorem::Bound;

use crate::random_papers::choices::Choices;
use local_rules::LocalFamily;
use scheme::Family;
use std::fmt;

/// A claim of a paper, and what the tests know of it.
#[derive(Clone, Debug)]
pub struct Claim {
    pub kind: &'static str,
    pub id: String,
    /// Its table in the file.
    pub text: String,
    pub known: Known,
    /// Whether the program may refuse it, as long as the checker does not take it otherwise.
    pub doubtful: bool,
}

/// What a claim means, for the oracle.
#[derive(Clone, Debug)]
pub enum Known {
    Nothing,
    Bound(Box<Bound>),
    Identity(Box<Identity>),
    Parametric(Box<Parametric>),
}

/// A paper, part by part.
#[derive(Clone)]
pub struct Draft {
    pub names: Names,
    pub families: Vec<Family>,
    pub rings: Vec<LocalFamily>,
    pub claims: Vec<Claim>,
}

impl fmt::Debug for Draft {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a paper of {} claims", self.claims.len())
    }
}

impl Draft {
    /// A paper by these choices: those of its head, and those of each claim.
    pub fn new(head: Vec<usize>, claims: Vec<Vec<usize>>) -> Draft {
        let mut head = Choices::new(head);
        let names = Names::new(&mut head);
        let families = ["s", "t"].map(|name| Family::new(name, &mut head)).into();
        let ring = LocalFamily::new("ring", &mut head);
        let interpolants = ["flat", "bent"].map(|name| ring.interpolant(name, &mut head));
        let rings = std::iter::once(ring).chain(interpolants).collect();
        let mut draft = Draft { names, families, rings, claims: Vec::new() };
        for (place, numbers) in claims.into_iter().enumerate() {
            let mut choices = Choices::new(numbers);
            let claim = match choices.below(9) {
                0..=3 => theorem::claim(&draft, place, &mut choices),
                4 => Some(parametric::claim(place, &mut choices)),
                5 | 6 => Some(equation::claim(place, &mut choices)),
                _ => Some(table::claim(&draft, place, &mut choices)),
            };
            draft.claims.extend(claim);
        }
        draft
    }

    /// Everything but the claims.
    pub fn head(&self) -> String {
        let bibliography = "[paper]\nauthors = []\ntitle = ''\nvenue = ''\nyear = ''\n";
        let families: String = self.families.iter().map(Family::text).collect();
        let rings: String = self.rings.iter().map(LocalFamily::text).collect();
        let other = "[[scheme]]\nname = 'alias'\nuse = 's:w=w'\n";
        format!("key = 'random'\n{bibliography}{}{families}{rings}{other}", self.names.text())
    }

    /// The file with some of its claims, in this order.
    pub fn with<'c>(&self, claims: impl IntoIterator<Item = &'c Claim>) -> String {
        let claims = claims.into_iter().map(|claim| &claim.text[..]);
        std::iter::once(&self.head()[..]).chain(claims).collect()
    }

    pub fn text(&self) -> String {
        self.with(&self.claims)
    }

    /// Whether nothing in it may be refused.
    pub fn is_clear(&self) -> bool {
        self.names.mood == Mood::Clear && !self.claims.iter().any(|claim| claim.doubtful)
    }
}
