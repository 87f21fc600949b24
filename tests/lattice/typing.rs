//! How masks on Z^d are written, and what is wrong with those that are none.

use std::collections::BTreeMap;
use subcert::diagnostic::SourceText;
use subcert::exact::Rational;
use subcert::scheme::{AnyScheme, LatticeMask, parse_any_scheme, parse_lattice, read_scheme};

fn lattice(text: &str) -> LatticeMask {
    parse_lattice(text).unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn in_file(text: &str) -> Result<LatticeMask, String> {
    let scheme =
        read_scheme(&SourceText::new("own.toml", text)).map_err(|error| error.to_string())?;
    let none: BTreeMap<String, Rational> = BTreeMap::new();
    scheme.lattice(&none).map_err(|error| error.to_string())
}

#[test]
fn four_ways_to_write_one_mask() {
    let symbol = lattice("(1+x)*(1+y)*(1+x*y)/2");
    assert_eq!(lattice("box[[1,0],[0,1],[1,1]]"), symbol);
    assert_eq!(lattice("[[1,1,0],[1,2,1],[0,1,1]]/2:origin=[0,0]"), symbol);
    assert_eq!(lattice("1/2*(1 + x + y + 2*x*y + x*y*(x + y + x*y))"), symbol);
    for file in [
        "symbol = '(1+x)*(1+y)*(1+x*y)/2'",
        "box = [[1, 0], [0, 1], [1, 1]]",
        "mask = '[[1,1,0],[1,2,1],[0,1,1]]/2'\norigin = [0, 0]",
        "mask = [['1/2','1/2','0'],['1/2','1','1/2'],['0','1/2','1/2']]\norigin = [0, 0]",
        "symbol = '(1+x)*(1+y)*(1+x*y)/2'\ndilation = [[2, 0], [0, 2]]",
        "let.s = '1 + x'\nsymbol = 's*(1+y)*(1+x*y)/2'",
    ] {
        assert_eq!(in_file(&format!("name = \"own\"\n{file}")).as_ref(), Ok(&symbol), "{file}");
    }
    // The middle is the place of 1 where there is no origin.
    let centred = lattice("(1+x)*(1+y)*(1+x*y)/(2*x*y)");
    assert_eq!(lattice("[[1,1,0],[1,2,1],[0,1,1]]/2"), centred);
}

#[test]
fn products_and_other_matrices() {
    assert!(matches!(parse_any_scheme("chaikin x chaikin x chaikin"), Ok(AnyScheme::Lattice(_))));
    assert_eq!(lattice("[1,2,1]/2 x [1,2,1]/2 x [1,2,1]/2").dimension(), 3);
    let product = lattice("(1+z)^2/2 x (1+z)^3/4");
    assert_eq!(product, lattice("(1+x)^2*(1+y)^3/8"));
    let chaikin = lattice("symbol(chaikin, x)*symbol(chaikin, y)");
    assert_eq!(chaikin, lattice("chaikin x chaikin"));
    let quincunx = lattice("(1+x)*(1+y)/2:dilation=[[1,1],[1,-1]]");
    assert_eq!(quincunx.dilation().class_count(), 2);
    assert_eq!(
        lattice("box[[1,0],[0,1],[1,1],[1,-1]]:dilation=[[1,1],[1,-1]]"),
        lattice("(1+x)*(1+y)/2*1:dilation=[[1,1],[1,-1]]")
    );
    let weighted = lattice("[[w, 1/2, w], [1/2, 1, 1/2], [w, 1/2, w]]:w=1/4");
    assert_eq!(weighted, lattice("(1+x)^2*(1+y)^2/(4*x*y)"));
    // x is a parameter where it has a value.
    assert!(matches!(
        parse_any_scheme("(1+z)^2*(1-x+2*x*z-x*z^2+0*z)/2:x=0"),
        Ok(AnyScheme::Uniform(_))
    ));
}

#[test]
fn refusals() {
    for (text, part) in [
        ("(1+x)*(1+y)/2", "the class of [0, 0] sum"),
        ("(1+x)^2*(1+y)/4", "sum to"),
        ("(1+x)*(1+y)*(1+x*y)/2:dilation=[[2,0],[0,1]]", "modulus of 1 or less"),
        ("(1+x)*(1+y)*(1+x*y)/2:dilation=[[1,0],[0,1]]", "determinant"),
        (
            "(1+x)*(1+y)*(1+x*y)/2:dilation=[[9,0],[0,9]]",
            "determinant of the dilation matrix is 81",
        ),
        ("(1+x)*(1+y)*(1+x*y)/2:dilation=[[2,0]]", "2 rows of 2"),
        ("(1+x)*(1+y)*(1+x*y)/2:dilation=[[2,0],[0,99999999999999999999]]", "no integer"),
        ("(1+x)*(1+y)*(1+x*y)/2:dilation=[[65,0],[0,1]]", "beyond the cap"),
        ("(1+x)*(1+y)*(1+x*y)/2:edges=[[2,0],[0,1]]", "do not join"),
        ("(1+x)*(1+y)*(1+x*y)/2:edges=[[0,0],[0,1]]", "no direction"),
        ("(1+x)*(1+y)*(1+x*y)/2:edges=[[1,0,0],[0,1,0]]", "3 coordinates in 2"),
        ("(1+x)*(1+y)*(1+x*y)/2:origin=[0,0]", "origin"),
        ("(1+x)*(1+y)*(1+x*y)/2:dilation=[[2,0,0],[0,2,0],[0,0,2]]", "sum to"),
        ("[[1,1],[1]]", "another length"),
        ("[[1,1],1]", "beside a number"),
        ("[[[[1]]]]", "2 deep, or 3"),
        ("[[1,1],[1,]]", "ends with a comma"),
        ("box[[1,0],[0,0]]", "no direction"),
        ("box[[1,0],[0,1],[1,2]]:dilation=[[1,1],[1,-1]]", "multiples of directions"),
        ("(1+x)*(1+y)*(1+x*y)/(1+x^2)", "remainder"),
        ("loop:dilation=[[2,0],[0,2]]", "definition of others"),
        ("chaikin", "no mask on Z^d"),
        ("chaikin x chaikin x chaikin x chaikin", "two or three factors"),
        ("symbol(chaikin)*(1+x)", "symbol(NAME, x)"),
    ] {
        let Err(error) = parse_lattice(text) else { panic!("{text} is read") };
        let error = error.to_string();
        assert!(error.contains(part), "{text}: {error}");
    }
    for (text, part) in [
        ("symbol = '(1+x)*(1+y)*(1+x*y)/2'\noffset = '1'", "no `offset`"),
        ("symbol = '(1+x)*(1+y)*(1+x*y)/2'\nparameters.z = { default = '1' }", "variable"),
        ("box = [[1, 0], [0, 1]]\nsymbol = '(1+x)*(1+y)'", "either `symbol`"),
        ("dilation = [[2, 0], [0, 2]]", "either `symbol`"),
        ("box = []", "0 vectors"),
        ("box = [[1.5, 0], [0, 1]]", "1.5"),
        ("symbol = 'sum(x = 0..1, y^x)'", "no index"),
    ] {
        let error = in_file(&format!("name = \"own\"\n{text}")).unwrap_err();
        assert!(error.contains(part), "{text}: {error}");
    }
}
