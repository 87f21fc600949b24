//! Texts: certificates by lines and blocks, claim files in TOML, and the reasons to reject them.

mod certificate;
mod cursor;
mod reject;
mod toml;
mod verdict;

pub use certificate::{About, Block, Line, MAX_LINE, alone, blocks, words};
pub use cursor::{Cursor, Parsed};
pub use reject::{
    At, Checked, Compared, DepthChecked, DepthReason, DepthRejection, RadiusChecked, RadiusReason,
    RadiusRejection, Reason, Rejection, Stop, Text, agree, compare, require,
};
pub use toml::Toml;
pub use verdict::{Outcome, Promise, Verdict};
