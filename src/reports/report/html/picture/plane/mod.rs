//! What pictures in the plane share: frames, scales, lines, panels.

pub(super) mod frame;
pub(super) mod graph;
pub(super) mod legend;
pub(super) mod line;
pub(super) mod panel;
pub(super) mod sample;
pub(super) mod scale;
