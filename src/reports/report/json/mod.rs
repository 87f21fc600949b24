//! Reports as JSON.
//!
//! The types here are the schema: a field has the same name in JSON, and an `Option` that is `None`
//! is null there, unless its documentation says that the field is missing then.

mod audit;
mod by_hand;
mod cell;
mod claim;
mod consistency;
mod coverage;
mod errata;
mod exact;
mod explain;
mod facts;
mod offset;
mod promise;
mod reading;
mod recovered;
mod sets;
mod shift;
mod shipped;
mod smoothness;
mod smoothness_claim;
mod summary;
mod theorem;
mod vertex;
mod witness;
mod working;

pub use audit::{AuditReport, Paper, PromiseTally, Table, UnstatedOffset};
pub use by_hand::{ByHand, Constant, HandMask, Level, Point, Side as HandSide, Weights};
pub use cell::{AsRead, CellSound, SoundValue};
pub use claim::{Certificate, Claim, Details, End, Failure, Sound};
pub use consistency::{Contradiction, Side, TablePart};
pub use coverage::{CoverageReport, CoveredPaper, CoveringClaim, NumberedItem};
pub use errata::{
    BeyondCap, Changes, Detail, ErrataReport, Erratum, OfTable, PaperErrata, Unchecked, WrongCell,
    WrongCells,
};
pub use exact::{Exact, Named};
pub use explain::Explained;
pub use facts::{
    CurveForm, DepthForm, Facts, FactsForm, OffsetForm, OpenForm, Order, Ranges, StencilForm,
    ValenceForm, WeightForm,
};
pub use offset::BetterOffset;
pub use promise::{Broken, ControlData, Natural as NaturalPromise, Promise};
pub use reading::{Explanation, Line, Reading, ReadingOfCell, Search, Shift, Solved};
pub use recovered::{Fitting, Recovered};
pub use sets::{Interval, Number as RootNumber, polynomial as root_polynomial};
pub use shift::{EveryShift, Greatest, Polygon};
pub use shipped::{
    Number, ProjectReport, ProjectsReport, ShippedTable, SplitValues, Sums,
    Tolerance as AcceptedError,
};
pub use smoothness::HoelderForm;
pub use summary::{Group, Outcome, Summary};
pub use theorem::{Case, Repair, Trial};
pub use vertex::{VertexForm, VerticesForm};
pub use witness::{Control, Exceeding, Natural as NaturalTheorem, Place, Supremum, Witness};
pub use working::Working;

/// The version of the JSON form.
const SCHEMA: u32 = 1;

/// How often each verdict occurs, by its word.
fn counts(tally: &crate::audit::Tally) -> std::collections::BTreeMap<&'static str, usize> {
    tally.iter().map(|(word, count)| (word.name(), count)).collect()
}
