//! How far tensor nets are from their limit surfaces, and how many levels they need.

mod attack;
mod exactness;
mod lattice;
mod laws;
mod sets;
mod tensor;

use subcert::exact::Rational;
use subcert::net::{Net, NetScheme};
use subcert::patch::{MeshDepth, NetDistances};

fn distances(net: &Net, scheme: &NetScheme) -> NetDistances {
    NetDistances::new(net.clone(), scheme).expect("a net within the caps")
}

/// The depth, without what few tests ask for and most of the time goes to.
fn depth(net: &Net, scheme: &NetScheme, tolerance: &Rational) -> MeshDepth {
    distances(net, scheme).without_apart().depth(tolerance).expect("a depth")
}

fn length(error: [f64; 3]) -> f64 {
    error.iter().map(|x| x * x).sum::<f64>().sqrt()
}
