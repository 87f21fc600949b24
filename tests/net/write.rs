//! Nets as CSV and as meshes.

use super::{CLOSED, bumpy};
use subcert::diagnostic::SourceText;
use subcert::exact::Rational;
use subcert::net::{Net, NetFormat, read_net, to_csv};

#[test]
fn what_is_written_is_read_again() {
    let net = bumpy(3, 4, CLOSED[0]).map(|x| x / Rational::from(8));
    let text = to_csv(&net, "two\nlines").expect("small numbers");
    assert!(text.starts_with("# two lines\n"), "{text}");
    let again = read_net(&SourceText::new("net", text), NetFormat::Csv, None).expect("a net");
    assert_eq!(again, net);
}

#[test]
fn numbers_beyond_f64_are_refused() {
    let large = [Rational::power_of_ten(400), Rational::zero(), Rational::zero()];
    let net = Net::new(vec![large; 4], 2, CLOSED[0]).expect("a net");
    assert!(to_csv(&net, "").is_err());
}

#[test]
fn faces_have_one_sense_and_close_the_seams() {
    for (closed, edges) in CLOSED.into_iter().zip([17, 21, 20, 24]) {
        let net = bumpy(3, 4, closed);
        let mesh = net.mesh().expect("an oriented surface");
        assert_eq!(mesh.faces().len(), net.faces()[0] * net.faces()[1]);
        assert_eq!(mesh.connectivity().edges().len(), edges);
    }
    // Rows up, columns to the right: seen from above, the first face is counter-clockwise.
    let flat = super::heights(2, 2, |_, _| Rational::zero());
    assert_eq!(flat.mesh().expect("a surface").faces(), [[0, 1, 3, 2]]);
}
