//! What is no table of numbers, with the place.

use super::read;
use subcert::literal::Language::{C, Hlsl, JavaScript, Matlab, Python, Rust, Shader, Wgsl};

#[test]
fn what_is_no_number() {
    for (language, text, line, words) in [
        (C, "int other = 1;", 1, "does not occur"),
        (C, "x(table);\nif (table == 3) {}", 1, "no value is assigned"),
        (C, "f table[2] = {1, 2};\nf table[2] = {1, 2};", 1, "in 2 places"),
        (C, "f table[2] = {\n1,\nHALF };", 3, "`HALF` is no number"),
        (C, "f table[2] = {\n1, sqrt(3.0) };", 2, "a call of `sqrt`"),
        (C, "f table[2] = {\n1,\n#ifdef X\n2\n#endif\n};", 3, "preprocessor"),
        (C, "f table[2] = {\n1, 2.0q };", 2, "the suffix `q`"),
        (C, "f table[2] = { 1, 010 };", 1, "octal"),
        (C, "f table[2] = { 1, 0x1.8 };", 1, "exponent"),
        (C, "f table[2] = { 1, 1e99999 };", 1, "exponent beyond"),
        (C, "f table[2] = { 1, 2, 3 };", 1, "3 numbers"),
        (C, "f table[2] = { 1 };", 1, "1 number,"),
        (Matlab, "x = 1;\ntable = [1 2]';", 2, "`'` stands where"),
        (Matlab, "table = [[1; 2] [3; 4]];", 1, "several rows within a matrix"),
        (Matlab, "table = [[1\n2] 3];", 1, "within a matrix"),
        (Matlab, "table = 1:2;", 1, "`:` stands where"),
        (Matlab, "table = [1 2].*3;", 1, "`.` stands where"),
        (Matlab, "table = [1 2]; table(2) = 3;", 1, "is changed here"),
        (Matlab, "table = [1 2];\n[x, table] = f();", 2, "is changed here"),
        (Matlab, "for table = [1 2]\nend", 1, "no value is assigned"),
        (Matlab, "table = [1 0x2];", 1, "hexadecimal"),
        (Matlab, "table = int8([1 2]);", 1, "a call of `int8`"),
        (Matlab, "table = [1 (2, 3)];", 1, "one number here"),
        (Wgsl, "const table = vec2f(1);", 1, "1 numbers, where 2"),
        (Wgsl, "const table = array<f16, 2>(1, 2);", 1, "no type of numbers with 32 or 64 bits"),
        (Wgsl, "const table = array<f32, 2(1, 2);", 1, "`array` is no number"),
        (Wgsl, "const table = array<f32, 2>(1i, 2);", 1, "the suffix `i`"),
        (Hlsl, "min16float table[2] = { 1, 2 };", 1, "`min16float`"),
        (C, "f table[2] = { 1, 1/0 };", 1, "a division by zero"),
        (C, "f table[2] = { 1,\n100000*100000 };", 2, "overflows"),
        (C, "f table[2] = { 1, -2147483647 - 2 };", 1, "overflows"),
        (C, "f table[2] = { 1, 9223372036854775808 };", 1, "no integer type"),
        (C, "f table[2] = { 1, 1.0L*2 };", 1, "long doubles"),
        (Shader, "f table[2] = { 1, 0x80000000 };", 1, "no integer type"),
        (Python, "table = [1, 7/(1 - 1)]", 1, "a division by zero"),
        (C, "f table[2] = { 1 2 };", 1, "where a comma is expected"),
        (C, "f table[2] = { 1, -};", 1, "is no number"),
        (C, "f table[2] = { 1, (2};", 1, "`)` is missing"),
        (C, "f table[2] = { 1, [2};", 1, "not closed"),
        (C, "f table[2] = { 1, 2", 1, "not closed"),
        (C, "/* f table[2] = { 1, 2 };", 1, "has no end"),
        (C, "x = \"f table[2] = { 1, 2 };", 1, "has no end"),
        (C, "f table[2] = ivec2(1.5, 2.5);", 1, "`ivec2`, the type of the table"),
        (Python, "table = np.int32([1.5, 2.5])", 1, "a call of `np.int32`"),
        (JavaScript, "const table = [1, 2n]", 1, "the suffix `n`"),
        (JavaScript, "const table = [1, 2**3]", 1, "`**`"),
        (Python, "table = [1, 2j]", 1, "the suffix `j`"),
        (Python, "table = [1, 7//2]", 1, "`//`"),
        (Python, "table = [1, [x for x in y]]", 1, "the name `x`"),
        (Rust, "const table: [f32; 2] = [1.0, 2.0.sqrt()];", 1, "comma is expected"),
        (Rust, "const table: [f32; 2] = [1.0, f32::consts::PI];", 1, "`f32` is no number"),
    ] {
        let error = read(language, text, &[2]).expect_err(text);
        assert!(error.message.contains(words), "{text}: {}", error.message);
        assert_eq!(error.line_and_column().0, line, "{text}: {error}");
    }
}

#[test]
fn caps() {
    let deep = format!("f table = {}1{};", "{".repeat(100), "}".repeat(100));
    assert!(read(C, &deep, &[]).expect_err("deep").message.contains("64 brackets"));
    let signs = format!("f table = {}1;", "- ".repeat(100));
    assert!(read(C, &signs, &[]).expect_err("deep").message.contains("64 signs"));
    let brackets = format!("f table = {}1{};", "(".repeat(100_000), ")".repeat(100_000));
    assert!(read(C, &brackets, &[]).is_err());
    let long = format!("f table = 0.{};", "1".repeat(3000));
    assert!(read(C, &long, &[]).expect_err("long").message.contains("2000 characters"));
    let many = format!("f table = {{{}}};", "1,".repeat(100_001));
    assert!(read(C, &many, &[100_000]).expect_err("many").message.contains("more than 100000"));
    assert!(read(C, "f table = 1;", &[1000, 1000]).expect_err("large").message.contains("shape"));
    assert!(read(C, "f table = 1;", &[3, 0]).expect_err("empty").message.contains("shape"));
}
