//! The entry points of the fuzz targets, run for a bounded time on a stable toolchain: on
//! the inputs found so far, and on altered files of the project.

mod entry;

use std::path::Path;

/// A generator of numbers that look random, the same ones every time (xorshift).
struct Random(u64);

impl Random {
    fn below(&mut self, bound: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        usize::try_from(self.0 % (bound.max(1) as u64)).expect("below a usize")
    }
}

/// Pieces that mean something to one of the parsers.
const PIECES: [&str; 24] = [
    "(",
    ")",
    "[",
    "]",
    "-",
    "^",
    "/0",
    "..",
    "=",
    ",",
    "'",
    "\"",
    "1e9",
    "999999999999",
    "sum(",
    "max(j = 1..3, ",
    "cos(2*pi/7)",
    "\n",
    "  cell 1 1 ",
    "end 1\n",
    "\u{2212}",
    "µ",
    "\0",
    "{",
];

/// Numbers at the ends of machine integers, and that some would take for 0 or 1.
const EXTREMES: [&str; 14] = [
    "2147483647",
    "2147483648",
    "4294967295",
    "4294967296",
    "4294967297",
    "9007199254740993",
    "9223372036854775807",
    "9223372036854775808",
    "18446744073709551615",
    "18446744073709551616",
    "18446744073709551617",
    "170141183460469231731687303715884105727",
    "170141183460469231731687303715884105728",
    "340282366920938463463374607431768211457",
];

/// `text` with a few changes: pieces put in, taken out, repeated and moved, and numbers that are extreme.
fn altered(text: &[u8], random: &mut Random) -> Vec<u8> {
    let mut bytes = text.to_vec();
    for _ in 0..=random.below(3) {
        let at = random.below(bytes.len() + 1);
        let end = (at + random.below(12)).min(bytes.len());
        match random.below(6) {
            0 => drop(bytes.drain(at..end)),
            1 => {
                let piece = bytes[at..end].to_vec();
                let place = random.below(bytes.len() + 1);
                drop(bytes.splice(place..place, piece));
            }
            2 if at < bytes.len() => bytes[at] = u8::try_from(random.below(128)).expect("ASCII"),
            3 if at < bytes.len() => bytes[at] ^= 1,
            4 => {
                let digit = |at: &usize| bytes[*at].is_ascii_digit();
                let Some(start) = (at..bytes.len()).find(digit) else { continue };
                let end = (start..bytes.len()).find(|at| !digit(at)).unwrap_or(bytes.len());
                let number = EXTREMES[random.below(EXTREMES.len())].bytes();
                drop(bytes.splice(start..end, number));
            }
            _ => {
                let piece = PIECES[random.below(PIECES.len())].bytes();
                drop(bytes.splice(at..at, piece));
            }
        }
    }
    bytes
}

/// Runs an entry point on inputs, on alterations of them, and on what fuzzing has found.
fn run(name: &str, inputs: &[&str], rounds: usize, entry: fn(&[u8])) {
    let found = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fuzz/found").join(name);
    for file in std::fs::read_dir(&found).into_iter().flatten() {
        entry(&std::fs::read(file.expect("an entry").path()).expect("a file"));
    }
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    for input in inputs {
        entry(input.as_bytes());
        for _ in 0..rounds {
            let data = altered(input.as_bytes(), &mut random);
            // What fails is seen in the message: the input, made a file under `found`,
            // fails again.
            let caught = std::panic::catch_unwind(|| entry(&data));
            assert!(caught.is_ok(), "{name}: {:?}", String::from_utf8_lossy(&data));
        }
    }
}

const FORMULAS: [&str; 14] = [
    "x",
    "-x^2 + 3/4*half - 0.25e-1",
    "x^-2^2",
    "sum(j = 0..3, (-1)^j*binomial(3, j)*x^j)",
    "max(j = 1..3, abs(j - 2*x)) - min(x, 1/3, 0)",
    "floor(7*x/2) + ceil(x) - mod(5, 3) + kronecker(x, 1)",
    "3/20 + 1/10*cos(2*pi/5)",
    "cos(pi/3)*x",
    "contraction(2) + norm(1, order = forward)",
    "displacement(terms = total, offset = 0)",
    "levels(1/2, x/100 + 1/50, 2, rounded = down)",
    "tensor(1, suprema = joint)*mask(0, 1) - difference(1, 0)",
    "convolution(2, 1, 3, order = forward)",
    "q[2*i - 1, j] + a[0]",
];

#[test]
fn certificates() {
    run("certificate", &[entry::example("text")], 3_000, entry::certificate);
}

#[test]
fn claim_files_of_the_checker() {
    run("checked_claims", &[entry::example("toml")], 1_500, entry::checked_claims);
}

#[test]
fn claim_files() {
    let inputs = [entry::example("toml"), include_str!("../../examples/my-paper.toml")];
    run("claim_file", &inputs, 700, entry::claim_file);
}

/// A claim file of a project with numbers of every kind.
const PROJECT: &str = r#"key = "k"
[project]
name = "Program"
repository = "https://example.org/program"
commit = "0123456789012345678901234567890123456789"
licence = "MIT"
[define]
lambda = '3/8 + 1/4*cos(2*pi/n)'
t = 'root([-1, -1, 0, 1], 1)'
[[shipped]]
id = "weights"
locus = "f.c, weights"
title = "weights"
type = "f32"
indices = ["n = 3..5", "k = 0..1"]
equals = 'sqrt(5/8 - lambda^2)/(n + k)'
cells = [["0.25f", "0.1875f"], ["1.0f/7", "-.17e0f"], ["0x1p-3", "0.1"]]
tolerance = "1e-3"
[[shipped]]
id = "each"
locus = "f.c, each"
title = "each"
type = "decimal:4"
equals_cells = ["t*(1 + kronecker(1, 1))"]
cells = ["2.6494"]
[[shipped.convention]]
label = "other"
equals = "t"
"#;

#[test]
fn claim_files_of_projects() {
    run("project_file", &[PROJECT], 700, entry::project_file);
}

#[test]
fn source_files() {
    let inputs = [
        "static const float table[2][2] = { /* a */ { 1.0f, -.5e0 }, { 0x1p-2, (float)1 / 3 } }; // end",
        "const table = [[1, 0.25], [-2.5e-1, 1 / 3]]; let other = 1;",
        "table = [[1, .25],  # a\n [-2.5e-1, 1 / 3]]\n",
        "pub const table: [[f64; 2]; 2] = [[1.0, 0.25_f64], [-2.5e-1, 1.0 / 3.0]];",
    ];
    run("source_file", &inputs, 1_000, entry::source_file);
}

#[test]
fn formulas() {
    run("formula", &FORMULAS, 1_000, entry::formula);
}

#[test]
fn values() {
    run("value", &FORMULAS, 150, entry::value);
}
