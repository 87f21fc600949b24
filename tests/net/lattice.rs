//! Nets with a mask on Z².

use super::{CLOSED, nets, scheme};
use proptest::prelude::*;
use subcert::net::{
    Closed, lattice_net_limits, net_limits, net_of_limits, refine_lattice_net, refine_net,
};
use subcert::scheme::{LatticeMask, parse_lattice};

/// Tensor products, the first also as it is typed as a symbol.
const PRODUCTS: [[&str; 2]; 4] = [
    ["bicubic", "(1+x)^4*(1+y)^4/64"],
    ["chaikin x b-spline:degree=4", "chaikin x b-spline:degree=4"],
    ["four-point:w=1/16 x chaikin", "four-point:w=1/16 x chaikin"],
    ["quaternary-four-point:mu=1/50 x chaikin", "quaternary-four-point:mu=1/50 x chaikin"],
];

pub fn mask(text: &str) -> LatticeMask {
    parse_lattice(text).expect("a mask")
}

proptest! {
    #![proptest_config(crate::common::cases(12))]

    /// The same points as those of the product, which may be at other indices; of open nets the lattice keeps all that are determined.
    #[test]
    fn products_are_as_those_of_curves(net in nets(7, 7), which in 0..PRODUCTS.len()) {
        let [product, typed] = PRODUCTS[which];
        let (product, mask) = (scheme(product), mask(typed));
        let level = if which == 3 { 1 } else { 2 };
        let expected = refine_net(&net, &product, level).expect("a net");
        let found = refine_lattice_net(&net, &mask, level).expect("a net");
        for point in expected.points() {
            prop_assert!(found.points().contains(point));
        }
        if net.closed() == (Closed { u: true, v: true }) {
            prop_assert_eq!(found.sizes(), expected.sizes());
        }
        let expected = net_of_limits(&net, net_limits(&net, &product).expect("limits"));
        let found = lattice_net_limits(&net, &mask).expect("limits");
        // At integers, and at natural parameters: these agree where the shift is an integer.
        if which == 0 {
            let found = net_of_limits(&net, found).expect("a net");
            let expected = expected.expect("a net");
            for point in expected.points() {
                prop_assert!(found.points().contains(point));
            }
        }
    }

    /// Two steps are one step twice, and limits stay.
    #[test]
    fn steps_follow_each_other(net in nets(6, 8), which in 0_usize..3) {
        let mask = mask(["loop-regular", "butterfly-regular:w=1/16", "ternary-loop-regular"][which]);
        let net = if net.closed() == CLOSED[0] { net } else { subcert::net::Net::new(net.points().to_vec(), 8, CLOSED[3]).expect("a net") };
        let once = refine_lattice_net(&net, &mask, 1).expect("a net");
        prop_assert_eq!(
            refine_lattice_net(&once, &mask, 1).expect("a net"),
            refine_lattice_net(&net, &mask, 2).expect("a net")
        );
        let limits = lattice_net_limits(&net, &mask).expect("limits");
        let later = lattice_net_limits(&once, &mask).expect("limits");
        for limit in limits.into_iter().flatten() {
            prop_assert!(later.contains(&Some(limit)));
        }
    }
}

#[test]
fn what_is_no_net_is_refused() {
    let net = super::bumpy(6, 6, CLOSED[0]);
    let error = |text: &str| refine_lattice_net(&net, &mask(text), 1).expect_err(text).to_string();
    assert!(error("quincunx-five-point").contains("diagonal"));
    assert!(error("trilinear").contains("in the plane"));
    let small = super::bumpy(3, 6, CLOSED[0]);
    let error =
        refine_lattice_net(&small, &mask("butterfly-regular:w=1/16"), 1).expect_err("small");
    assert!(error.to_string().contains("3 rows"), "{error}");
    let error = lattice_net_limits(&net, &mask("butterfly-regular:w=4")).expect_err("divergent");
    assert!(error.to_string().contains("not shown to converge"), "{error}");
}
