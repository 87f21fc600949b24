mod known;
mod laws;
