//! How the value of a table depends on a parameter, by the form of its formula.

use crate::evaluation::settings::Settings;
use crate::judge::reading::degree::Degrees;
use crate::judge::reading::space::ReadingSpace;

impl ReadingSpace<'_> {
    /// Whether the form of the value shows, under a reading, that it is proportional to a parameter.
    pub(crate) fn is_proportional(&self, name: &str, settings: &Settings) -> bool {
        let table = self.judge.table;
        let paper = self.judge.paper;
        let definitions = settings.definitions.as_deref().unwrap_or(&paper.definitions);
        let degrees = Degrees::new(paper, definitions, table, name);
        degrees.of(&table.value.expr) == Some(1)
    }

    /// Whether in every call of `levels(r, x)` that the value leads to, by the form of its
    /// arguments, x is inversely proportional to a parameter and r does not depend on it.
    pub(crate) fn is_inverse(&self, name: &str) -> bool {
        let (table, paper) = (self.judge.table, self.judge.paper);
        let degrees = Degrees::new(paper, &paper.definitions, table, name);
        let calls = degrees.levels(&table.value.expr);
        let any = !calls.is_empty();
        any && calls.into_iter().all(|call| match call {
            [ratio, of, rest @ ..] => {
                degrees.is_free(ratio)
                    && degrees.of(of) == Some(-1)
                    && rest.iter().all(|part| degrees.is_free(part))
            }
            _ => false,
        })
    }
}
