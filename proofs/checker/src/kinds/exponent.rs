//! The rule `exponent`: the Hölder exponent of the limits of a scheme.

use super::kind::{Kind, Proof};
use super::smoothness::{lacking, scope};
use crate::claims::{Paper, printed};
use crate::formulas::formula;
use crate::functions::exponent::LogSum;
use crate::lines::limits::{LimitProof, verdict};
use crate::numbers::{Decimal, int, is_one_unit};
use crate::text::{Block, Checked, Reason, Toml, Verdict, require};
use num_traits::Zero;

/// Claims about exponents.
pub const KIND: Kind = Kind {
    name: "exponent",
    fields: "exponent: claim value=text printed=number at_least=text at_most=text attained=flag \
 absent=text given=%text",
    names: |claim| claim.names("given").collect(),
    check: |paper, claim, block| check(paper, claim, block).map(|()| Proof::Other),
};

/// Checks a claim about the Hölder exponent.
fn check<'a>(paper: &'a Paper<'a>, claim: &'a Toml, block: &mut Block<'_>) -> Checked<()> {
    if lacking(claim, &["value", "printed", "at_least", "at_most", "attained"], block)? {
        return Ok(());
    }
    block.restates("scheme", claim.text("scheme"))?;
    for (word, key) in [("value", "value"), ("at-least", "at_least"), ("at-most", "at_most")] {
        block.may_restate(word, claim.text(key))?;
    }
    if let Some(field) = claim.get("printed") {
        block.restates("printed", printed(field).map(|(text, _)| text))?;
    }
    let has = |keys: &[&str]| keys.iter().any(|key| claim.get(key).is_some());
    let statements = [&["value"][..], &["printed"], &["at_least", "at_most"]];
    let one = statements.iter().filter(|keys| has(keys)).count() == 1;
    require(one, Reason::Malformed("one of `value`, `printed` and bounds"))?;
    let shown = LimitProof::read(paper, claim, &scope(paper, claim)?, block)?;
    let closed = paper.library.closed();
    let number = |key: &str| -> Checked<Option<LogSum>> {
        let text = claim.text(key).map(formula);
        Ok(text.transpose()?.map(|expr| LogSum::of(&expr, &closed)).transpose()?)
    };
    let of_value = number("value")?;
    let [lower, upper] = [number("at_least")?, number("at_most")?];
    block.look();
    let (found, way) = if shown.diverges() {
        (Verdict::Refuted, "")
    } else if let Some(field) = claim.get("printed") {
        let read = printed(field).and_then(|(_, read)| Decimal::read(read));
        decimal(&shown, &read.ok_or(Reason::Malformed("a decimal"))?)?
    } else {
        let (lower, upper) =
            (lower.as_ref().or(of_value.as_ref()), upper.as_ref().or(of_value.as_ref()));
        let part = |value: Option<&LogSum>, test: &dyn Fn(&LogSum) -> Checked<bool>, none: bool| {
            value.map_or(Ok(none), test)
        };
        let found = verdict(
            part(lower, &|value| shown.at_least(value, false), true)?
                && part(upper, &|value| shown.at_most(value, false), true)?,
            part(lower, &|value| shown.at_most(value, true), false)?
                || part(upper, &|value| shown.at_least(value, true), false)?,
        )?;
        (found, "")
    };
    // The certificate does not show whether an exponent is attained.
    require(claim.get("attained").is_none() || found == Verdict::Refuted, Reason::NotShown)?;
    block.verdict(format!("{found} {way}").trim_end())
}

/// How the decimal came from the exponent: the verdict, and the way in which it was rounded.
fn decimal(shown: &LimitProof, decimal: &Decimal) -> Checked<(Verdict, &'static str)> {
    let half = &decimal.unit / int(2);
    let place = |halves: i64| LogSum::from(&decimal.value + &half * int(halves));
    let between = |low: i64, high: i64, strictly: bool| -> Checked<bool> {
        Ok(shown.at_least(&place(low), strictly)? && shown.at_most(&place(high), strictly)?)
    };
    let below = if is_one_unit(decimal) { (-1, true) } else { (-2, false) };
    // Of an exponent that is cut some digit is left.
    let above = if decimal.digits.is_zero() { (1, true) } else { (2, false) };
    let far =
        shown.at_least(&place(above.0), above.1)? || shown.at_most(&place(below.0), below.1)?;
    if far {
        Ok((Verdict::Refuted, ""))
    } else if between(-1, 1, false)? {
        Ok((Verdict::Confirmed, ""))
    } else if between(1, 2, true)? {
        Ok((Verdict::Rounding, "cut"))
    } else if between(-2, -1, true)? {
        Ok((Verdict::Rounding, "away"))
    } else {
        Err(Reason::NotShown.into())
    }
}
