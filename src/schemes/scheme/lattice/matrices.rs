//! Integer matrices of three rows.

/// Three integers.
type Row = [i64; 3];

/// Mα.
#[must_use]
pub fn apply(matrix: &[Row; 3], point: Row) -> Row {
    std::array::from_fn(|i| (0..3).map(|j| matrix[i][j] * point[j]).sum())
}

/// det(M)·M^{−1}.
#[must_use]
pub fn adjugate(m: &[Row; 3]) -> [Row; 3] {
    let minor = |i: usize, j: usize| {
        let [a, b] = [(i + 1) % 3, (i + 2) % 3];
        let [c, d] = [(j + 1) % 3, (j + 2) % 3];
        m[a][c] * m[b][d] - m[a][d] * m[b][c]
    };
    std::array::from_fn(|i| std::array::from_fn(|j| minor(j, i)))
}

/// det M.
#[must_use]
pub fn determinant(m: &[Row; 3]) -> i64 {
    let adjugate = adjugate(m);
    (0..3).map(|k| m[0][k] * adjugate[k][0]).sum()
}
