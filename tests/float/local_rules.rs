//! Rings in f64: errors within bounds that are of the size of rounding errors.

use crate::common::{any_ring, ring};
use proptest::prelude::*;
use subcert::bound::LocalConstants;
use subcert::exact::RealCyclotomic;
use subcert::float::{certify_local_rules, nearest};

#[test]
fn rings_of_the_catalogue() {
    for scheme in ["doo-sabin:n=5", "doo-sabin:n=8", "bajaj:N=3", "catmull-clark:N=7"] {
        let found = certify_local_rules(&ring(scheme), 3).unwrap();
        assert_eq!(found.tracked_block, 3, "{scheme}");
        for quantity in &found.quantities {
            assert_eq!(quantity.encloses(), Some(true), "{scheme}: {quantity:?}");
            assert!(quantity.bound.unwrap() < 1e-13, "{scheme}: {quantity:?}");
        }
        let constants = LocalConstants::new(&ring(scheme), 3).unwrap();
        let known = |name: &str| &found.quantity(name).unwrap().exact;
        assert_eq!(*known("T_3"), constants.contraction(3).unwrap().1.value);
        assert_eq!(*known("Lambda_2"), constants.levels[1].norm);
        assert_eq!(*known("sigma"), constants.displacement().1.value);
    }
    let weight = certify_local_rules(&ring("doo-sabin:n=5"), 1).unwrap();
    let weight = weight.quantity("m[face[0]][face[1]]").unwrap();
    assert_eq!(weight.value.to_bits(), nearest(&weight.exact).to_bits());
    assert_eq!(weight.exact.to_string(), "3/20 + 1/10*cos(2*pi/5)");
    // Beyond the cap of steps there are values, and no bounds.
    let large = certify_local_rules(&ring("doo-sabin:n=60"), 3).unwrap();
    assert_eq!(large.tracked_block, 1);
    assert!(large.quantity("T_1").unwrap().bound.is_some());
    assert_eq!(large.quantity("T_3").unwrap().bound, None);
    assert!(large.quantity("T_3").unwrap().error.as_ref().unwrap() < &RealCyclotomic::from(1));
}

proptest! {
    #![proptest_config(crate::common::cases(32))]
    #[test]
    fn every_error_is_within_its_bound(ring in any_ring(5)) {
        let found = certify_local_rules(&ring.map(|weight| RealCyclotomic::from(weight)), 3).unwrap();
        for quantity in &found.quantities {
            prop_assert_eq!(quantity.encloses(), Some(true), "{:?}", quantity);
        }
    }
}
