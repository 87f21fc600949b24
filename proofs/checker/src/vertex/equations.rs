//! Linear equations with coefficients of which enclosures are known.

use super::ball::Ball;

/// The solution of equations; `None` where enclosures do not show that there is just one. The right side comes last.
pub fn solve(mut rows: Vec<Vec<Ball>>) -> Option<Vec<Ball>> {
    let d = rows.len();
    for j in 0..d {
        // The pivot that is certainly largest, or nearly so.
        let mut best: Option<usize> = None;
        for i in (j..d).filter(|&i| rows[i][j].sign().is_some()) {
            let larger = |at: usize| rows[at][j].least_size().is_below(&rows[i][j].least_size());
            if best.is_none_or(larger) {
                best = Some(i);
            }
        }
        rows.swap(j, best?);
        let inverse = rows[j][j].inverse()?;
        let top: Vec<Ball> = rows[j].iter().map(|x| x.times(&inverse)).collect();
        for (i, row) in rows.iter_mut().enumerate() {
            if i != j {
                let factor = row[j].clone();
                for (x, y) in row.iter_mut().zip(&top) {
                    *x = x.minus(&factor.times(y));
                }
            }
        }
        rows[j] = top;
    }
    Some(rows.into_iter().map(|mut row| row.swap_remove(d)).collect())
}

/// A vector with Mv = 0 and one entry 1, for a square matrix of which it is known that it is singular; `None` where
/// enclosures do not show that there are no others.
pub fn kernel(matrix: &[Vec<Ball>]) -> Option<Vec<Ball>> {
    let d = matrix.len();
    for unit in 0..d {
        for left_out in 0..d {
            let rows = matrix.iter().enumerate().filter(|(i, _)| *i != left_out);
            let equation = |(_, row): (usize, &Vec<Ball>)| {
                let others = row.iter().enumerate().filter(|(j, _)| *j != unit);
                let mut equation: Vec<Ball> = others.map(|(_, x)| x.clone()).collect();
                equation.push(Ball::from(0).minus(&row[unit]));
                equation
            };
            if let Some(mut vector) = solve(rows.map(equation).collect()) {
                vector.insert(unit, Ball::from(1));
                return Some(vector);
            }
        }
    }
    None
}
