//! Ctrl-C while constants are computed: what was found is printed.

use std::sync::{Mutex, Once};
use subcert::bound::Budget;

static STOPPED: Mutex<Vec<Budget>> = Mutex::new(Vec::new());
static HANDLER: Once = Once::new();

/// While this lives, an interrupt takes all steps from some budgets; at any other time, and at the second
/// interrupt, it ends the program.
pub(super) struct Interrupt;

impl Interrupt {
    pub(super) fn stops(budgets: &[Budget]) -> Interrupt {
        set(budgets.to_vec());
        HANDLER.call_once(|| {
            // Where no handler can be set, an interrupt ends the program as usual.
            let _ = ctrlc::set_handler(|| {
                let budgets = set(Vec::new());
                if budgets.is_empty() {
                    std::process::exit(130);
                }
                budgets.iter().for_each(Budget::stop);
            });
        });
        Interrupt
    }
}

impl Drop for Interrupt {
    fn drop(&mut self) {
        set(Vec::new());
    }
}

/// The budgets before.
fn set(budgets: Vec<Budget>) -> Vec<Budget> {
    let mut stopped = STOPPED.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    std::mem::replace(&mut *stopped, budgets)
}
