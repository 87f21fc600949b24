//! Reports as JSON.
//!
//! The types here are the schema: a field has the same name in JSON, and an `Option` that is `None`
//! is null there, unless its documentation says that the field is missing then.

mod audit;
mod claim;
mod consistency;
mod coverage;
mod errata;
pub(crate) mod exact;
mod explain;
mod facts;
mod lattice;
mod offset;
mod open;
mod sets;
mod shipped;
pub(crate) mod smooth;
mod summary;
pub(crate) mod tables;
mod theorems;

pub use audit::{AuditReport, Paper, PromiseTally, Table, UnstatedOffset};
pub use claim::{Certificate, Claim, Details, End, Failure, Sound};
pub(crate) use claim::{joined, names};
pub use consistency::{Contradiction, Side, TablePart};
pub use coverage::{CoverageReport, CoveredPaper, CoveringClaim, NumberedItem};
pub use errata::{
    BeyondCap, Changes, Detail, ErrataReport, Erratum, OfTable, PaperErrata, Unchecked, WrongCell,
    WrongCells,
};
pub use exact::{Exact, Named};
pub use explain::Explained;
pub use facts::{
    CurveForm, DepthForm, Facts, FactsForm, OffsetForm, Order, Ranges, SpecialForm, StencilForm,
    ValenceForm, WeightForm,
};
pub use lattice::{LatticeForm, LatticeSmoothnessForm, ValueForm, vectors};
pub use offset::BetterOffset;
pub use open::OpenForm;
pub use sets::{Interval, Number as RootNumber};
pub use shipped::{
    ExplainedTable, Number, ProjectReport, ProjectsReport, ShippedTable, SplitValues, Sums,
    Tolerance as AcceptedError,
};
pub use smooth::exponent::HoelderForm;
pub use smooth::vertex::{VertexForm, VerticesForm};
pub use summary::{Group, Outcome, Summary};
pub use tables::cell::{AsRead, CellSound, SoundValue};
pub use tables::promise::{Broken, ControlData, Natural as NaturalPromise, Promise};
pub use tables::reading::{Explanation, Line, Reading, ReadingOfCell, Search, Shift, Solved};
pub use tables::recovered::{Fitting, Recovered};
pub use tables::working::Working;
pub use theorems::by_hand::{ByHand, Constant, HandMask, Level, Point, Side as HandSide, Weights};
pub use theorems::shift::{EveryShift, Greatest, Polygon};
pub use theorems::theorem::{Case, Repair, Trial};
pub use theorems::witness::{
    Control, Exceeding, Natural as NaturalTheorem, Place, Supremum, Witness,
};

/// The version of the JSON form.
pub const SCHEMA: u32 = 1;

/// How often each verdict occurs, by its word.
fn counts(tally: &crate::audit::Tally) -> std::collections::BTreeMap<&'static str, usize> {
    tally.iter().map(|(word, count)| (word.name(), count)).collect()
}
