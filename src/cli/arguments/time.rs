//! How long commands may take.

use super::{Command, SECONDS};

impl Command {
    /// The seconds that it has unless others are asked for; none without an end.
    pub(in crate::cli) fn seconds(&self) -> Option<u32> {
        match self {
            Command::Constants(_)
            | Command::Depth(_)
            | Command::Range(_)
            | Command::Smoothness(_)
            | Command::Spectrum(_)
            | Command::Table(_)
            | Command::Jsr(_)
            | Command::Certify(_)
            | Command::Refine(_)
            | Command::Limit(_)
            | Command::Scheme(_)
            | Command::Plot(_) => Some(SECONDS),
            _ => None,
        }
    }

    /// What takes it less time.
    pub(in crate::cli) fn takes_less(&self) -> &'static str {
        match self {
            Command::Depth(depth) if depth.mesh.is_some() => {
                "a smaller mesh, a greater tolerance, or --a-priori"
            }
            Command::Depth(_) => "a smaller -c, a greater tolerance, or fewer points",
            Command::Constants(_) | Command::Certify(_) => {
                "a smaller -c, or shorter numbers in the mask"
            }
            Command::Range(range) if range.smoothness.is_some() => {
                "a smaller M, fewer --boxes or valences, or a mask with fewer coefficients"
            }
            Command::Range(_) => "a smaller -c, or a mask with fewer coefficients",
            Command::Smoothness(_) => {
                "fewer valences, or a mask with fewer coefficients or shorter numbers"
            }
            Command::Jsr(_) => "smaller matrices, or shorter numbers in them",
            Command::Spectrum(_) | Command::Table(_) => {
                "smaller valences, or shorter numbers in the rules"
            }
            Command::Refine(_) | Command::Limit(_) | Command::Oracle(_) => {
                "a lower --level, fewer points, or shorter numbers"
            }
            Command::Scheme(_) | Command::Plot(_) | Command::Atlas(_) => {
                "fewer schemes, or shorter numbers in them"
            }
            _ => "fewer claims in a file",
        }
    }
}
