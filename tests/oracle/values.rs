//! The collected reference values and their files.

use subcert::bound::{Constants, Operator, Order, surface_factor};
use subcert::exact::{Rational, parse_decimal, parse_rational};
use subcert::float::{nearest, parse_hexadecimal};
use subcert::oracle::{
    Boundary, Control, OracleError, OracleRequest, OracleValues, reference_values, refine_polygon,
    to_csv, to_json, write_csv, write_json,
};
use subcert::scheme::parse_scheme;

fn request(scheme: &str, control: Control) -> OracleRequest {
    let (max_block, level, boundary) = (3, 2, Boundary::Closed);
    OracleRequest { scheme: scheme.to_owned(), max_block, control, level, boundary }
}

fn answer(request: &OracleRequest) -> Result<OracleValues, OracleError> {
    reference_values(&parse_scheme(&request.scheme).expect("a scheme"), request)
}

fn exact(values: &OracleValues, quantity: &str) -> Vec<String> {
    let group = values.group(quantity).unwrap_or_else(|| panic!("no {quantity}"));
    group.values.iter().map(|value| value.exact.clone()).collect()
}

#[test]
fn chaikin_by_hand() {
    let square = Control::polygon([0, 4, 4, 0].map(Rational::from).to_vec());
    let values = answer(&OracleRequest { level: 1, ..request("chaikin", square) }).unwrap();
    assert_eq!(exact(&values, "mask"), ["3/4", "1/4", "1/4", "3/4"]);
    assert_eq!(exact(&values, "difference-mask"), ["1/2", "0", "1/4", "1/4"]);
    assert_eq!(exact(&values, "contraction-constant"), ["1/2", "1/4", "1/8"]);
    assert_eq!(exact(&values, "scheme-norm"), ["1", "1", "1"]);
    assert_eq!(exact(&values, "displacement"), ["1/4"]);
    assert_eq!(exact(&values, "control"), ["0", "4", "4", "0"]);
    assert_eq!(exact(&values, "refined"), ["1", "3", "4", "4", "3", "1", "0", "0"]);
    assert_eq!(values.header.seed, None);
    let c: Vec<_> =
        values.group("contraction-constant").unwrap().values.iter().map(|v| v.index[0]).collect();
    assert_eq!(c, [1, 2, 3]);
}

/// Every form of a value is the value: p/q by reading it, the decimal to half a
/// unit of its 17th digit, and both texts of the f64 by Rust's parser and ours.
#[test]
fn all_forms_agree() {
    let request = request("newton:j=1,n=3", Control::seeded_polygon(42, 7));
    let values = answer(&request).unwrap();
    let mut count = 0;
    for value in values.groups.iter().flat_map(|group| &group.values) {
        let exact = parse_rational(&value.exact).unwrap();
        assert_eq!(exact.to_string(), value.exact);
        let decimal = parse_decimal(&value.decimal).unwrap();
        let (low, high) = decimal.interval();
        assert!(low <= exact && exact <= high, "{value:?}");
        assert!(decimal.significant_digits() == 17 || exact.is_zero(), "{value:?}");
        let expected = nearest(&exact).to_bits();
        assert_eq!(value.f64.parse::<f64>().unwrap().to_bits(), expected);
        assert_eq!(parse_hexadecimal(&value.hex).unwrap().to_bits(), expected);
        count += 1;
    }
    assert_eq!(count, 3 * 4 * 2 + 3 + 3 + 1 + 7 + 63);
}

#[test]
fn values_are_those_of_the_library() {
    let request = request("quinary-three-point", Control::seeded_polygon(3, 5));
    let scheme = parse_scheme(&request.scheme).unwrap();
    let mask = scheme.masks()[0].clone();
    let values = answer(&request).unwrap();
    let constants = Constants::new(mask.clone());
    for (operator, quantity) in
        [(Operator::Difference, "contraction-constant"), (Operator::Scheme, "scheme-norm")]
    {
        let norm = |c| constants.norm(operator, c, Order::Adjoint).unwrap().to_string();
        assert_eq!(exact(&values, quantity), [norm(1), norm(2), norm(3)]);
    }
    let control = request.control.values();
    let refined = refine_polygon(mask.rules(), control, 2, Boundary::Closed).unwrap();
    let texts: Vec<String> = refined.iter().map(ToString::to_string).collect();
    assert_eq!(exact(&values, "refined"), texts);
    assert_eq!(values.header.seed.as_deref(), Some("3"));
}

#[test]
fn a_tensor_product_gives_both_directions() {
    let request = request("chaikin x quinary-three-point", Control::seeded_grid(9, 3, 4));
    let values = answer(&request).unwrap();
    assert_eq!(exact(&values, "first-contraction-constant"), ["1/2", "1/4", "1/8"]);
    assert_eq!(exact(&values, "second-contraction-constant")[..2], ["17/25", "169/625"]);
    assert_eq!(values.group("second-mask").unwrap().shape, [5, 3]);
    let refined = values.group("refined").unwrap();
    assert_eq!(refined.shape, [12, 100]);
    assert_eq!(refined.values[234].index, [2, 34]);
    assert_eq!(values.group("control").unwrap().shape, [3, 4]);
    let scheme = parse_scheme(&request.scheme).unwrap();
    let masks = scheme.masks();
    let factor = surface_factor(masks[0], masks[1]);
    assert_eq!(exact(&values, "surface-factor"), [factor.to_string()]);
}

/// The first value of an open polygon is the one that the scheme numbers so: with
/// x_i = i and a scheme that reproduces lines, y_m = m/n.
#[test]
fn the_first_index_of_an_open_polygon() {
    let line = Control::polygon((0..8).map(Rational::from).collect());
    let open = OracleRequest { boundary: Boundary::Open, ..request("four-point", line) };
    let values = answer(&open).unwrap();
    let first = parse_rational(&values.header.first_index[0]).unwrap();
    let at_first = parse_rational(&exact(&values, "refined")[0]).unwrap();
    assert_eq!(at_first, first / Rational::from(4));
    assert_eq!(values.header.first_index, ["6"]);
    assert_eq!(values.header.boundary, Some("open"));
}

#[test]
fn json_is_plain_data() {
    let values = answer(&request("four-point:w=1/17", Control::seeded_polygon(1, 4))).unwrap();
    let text = to_json(&values);
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(json["header"]["scheme"], "four-point:w=1/17");
    assert_eq!(json["header"]["masks"][0]["offset"], -1);
    assert_eq!(json["header"]["seed"], "1");
    assert_eq!(json["groups"][0]["quantity"], "mask");
    assert_eq!(json["groups"][0]["values"][5]["index"], serde_json::json!([1, 1]));
    assert_eq!(json["groups"][0]["values"][5]["exact"], "19/34");
    assert_eq!(json["groups"][0]["values"][5]["f64"], "0.5588235294117647");
    let keys: Vec<&String> = json["groups"][0]["values"][5].as_object().unwrap().keys().collect();
    assert_eq!(keys, ["index", "exact", "decimal", "f64", "hex"]);
    let mut written = Vec::new();
    write_json(&values, &mut written).unwrap();
    assert_eq!(written, text.into_bytes());
}

#[test]
fn csv_is_a_table() {
    let mut request = request("chaikin x four-point:w=1/17", Control::seeded_grid(1, 2, 3));
    let scheme = parse_scheme(&request.scheme).unwrap();
    request.scheme = "a name\nof two lines".to_owned();
    let values = reference_values(&scheme, &request).unwrap();
    let text = to_csv(&values);
    let (comments, table): (Vec<&str>, Vec<&str>) =
        text.lines().partition(|line| line.starts_with("# "));
    assert!(comments.contains(&"# shape: arity 2, width 2, offset 0; arity 2, width 4, offset -1"));
    assert!(comments.contains(&"# scheme: a name of two lines"));
    assert_eq!(table[0], "quantity,index,exact,decimal,f64,hex");
    let count: usize = values.groups.iter().map(|group| group.values.len()).sum();
    assert_eq!(table.len(), count + 1);
    assert!(table.iter().all(|line| line.split(',').count() == 6));
    assert!(
        table[1..].iter().any(|line| line.starts_with("second-mask,1:1,19/34,5.588235294117647"))
    );
    assert!(table[1..].iter().any(|line| line.starts_with("surface-factor,,")));
    let mut written = Vec::new();
    write_csv(&values, &mut written).unwrap();
    assert_eq!(written, text.into_bytes());
}

#[test]
fn what_is_refused() {
    let polygon = Control::seeded_polygon(1, 4);
    let grid = Control::seeded_grid(1, 4, 4);
    let refused = answer(&request("chaikin", grid)).unwrap_err();
    assert!(matches!(refused, OracleError::Shape { found: "grid", .. }));
    let refused = answer(&request("chaikin x chaikin", polygon.clone())).unwrap_err();
    assert!(matches!(refused, OracleError::Shape { found: "polygon", .. }));
    let many = OracleRequest { max_block: 300, ..request("chaikin", polygon.clone()) };
    assert!(matches!(answer(&many), Err(OracleError::Classes(_))));
    let none = OracleRequest { max_block: 0, level: 0, ..request("chaikin", polygon) };
    let values = answer(&none).unwrap();
    assert_eq!(exact(&values, "contraction-constant"), [""; 0]);
    assert_eq!(exact(&values, "refined"), exact(&values, "control"));
}
