//! What the program certifies, the checker accepts; and both refuse the same files.

use crate::random_papers::draft::Draft;
use crate::random_papers::failure::{Checked, Failure};
use crate::random_papers::program::{blocks, checked, judged, left_open, read};
use subcert::certificate::certificate;
use subcert_check::Outcome;

pub fn accepted(draft: &Draft) -> Checked {
    let text = draft.text();
    let clear = draft.is_clear();
    let paper = match read(&text) {
        Ok(paper) => paper,
        Err(error) if clear => return Err(Failure::new("a clear file is refused", &text, error)),
        Err(error) => {
            // What a formula must not mention or hide, the checker sees when it comes to the claim: then
            // the formula has no value, and no certificate of the claim is valid.
            let of_formulas = ["has no meaning here", "hides another meaning"];
            if of_formulas.iter().any(|what| error.contains(what)) {
                return Ok(());
            }
            let taken = checked(&text, "subcert-certificate 4\npaper random\nend 0\n").is_ok();
            let what = "the program refuses a file that the checker takes";
            return if taken { Err(Failure::new(what, &text, error)) } else { Ok(()) };
        }
    };
    let audit = match judged(&paper) {
        Ok(audit) => audit,
        Err(error) if clear => {
            return Err(Failure::new("a clear formula is refused", &text, error));
        }
        Err(_) => return Ok(()),
    };
    let written = certificate(&audit);
    let outcomes = checked(&text, &written.text).map_err(|error| {
        Failure::new("the checker refuses a file that the program takes", &text, error)
    })?;
    for (id, outcome) in outcomes {
        if outcome != Outcome::Valid && !left_open(&outcome) {
            let file = draft.with(draft.claims.iter().filter(|claim| claim.id == id));
            let blocks = blocks(&written.text);
            let block = blocks.iter().find(|block| block.id == id).map(|block| &block.text[..]);
            let reason = match &outcome {
                Outcome::Invalid(_, why) | Outcome::Incomplete(Some(why)) => why.reason.to_string(),
                _ => String::new(),
            };
            let kind = id.split('-').next().unwrap_or_default();
            let what = format!("a {kind} is not accepted: {reason}");
            return Err(Failure::new(
                what,
                &file,
                format!("{outcome:?}\n{}", block.unwrap_or_default()),
            ));
        }
    }
    Ok(())
}
