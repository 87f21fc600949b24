//! Whether two numbers can be compared.

use crate::exact::RealCyclotomic;
use crate::exact::common_conductor;

/// Whether both numbers lie in one field whose conductor is within the cap.
#[must_use]
pub fn comparable(left: &RealCyclotomic, right: &RealCyclotomic) -> bool {
    common_conductor(left.conductor(), right.conductor()).is_ok()
}
