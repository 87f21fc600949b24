//! Eigenvalues as roots of the characteristic polynomial, and stencils as left eigenvectors.

use super::super::number;
use super::{Row, expressions, matrix, sector, sectors};
use crate::common::r;
use std::cmp::Ordering;
use subcert::exact::{Rational, RealCyclotomic, RealExpression, Scalar};

/// det(x − M) from the constant term upwards, by Hessenberg's form and its recurrence.
fn characteristic(mut m: Vec<Row>) -> Row {
    let n = m.len();
    for step in 1..n.saturating_sub(1) {
        let Some(pivot) = (step..n).find(|&i| !m[i][step - 1].is_zero()) else { continue };
        m.swap(step, pivot);
        for row in &mut m {
            row.swap(step, pivot);
        }
        for i in step + 1..n {
            let factor = &m[i][step - 1] / &m[step][step - 1];
            let pivot = m[step].clone();
            for (x, y) in m[i].iter_mut().zip(&pivot) {
                *x = &*x - &(&factor * y);
            }
            for row in &mut m {
                row[step] = &row[step] + &(&factor * &row[i]);
            }
        }
    }
    // p_k = (x − h_kk) p_{k−1} − Σ_i h_{i,k} (h_{i+1,i} … h_{k,k−1}) p_{i−1}.
    let mut found: Vec<Row> = vec![vec![r(1, 1)]];
    for k in 0..n {
        let mut next = vec![r(0, 1)];
        next.extend(found[k].clone());
        let mut product = r(1, 1);
        for i in (0..=k).rev() {
            let factor = &product * &m[i][k];
            for (target, c) in next.iter_mut().zip(&found[i]) {
                *target = &*target - &(&factor * c);
            }
            if i > 0 {
                product = &product * &m[i][i - 1];
            }
        }
        found.push(next);
    }
    found.pop().expect("the last")
}

// Every printed number is a root as often as it is said to be, and there are as many as points.
#[test]
fn eigenvalues_are_the_roots() {
    for (scheme, faces, corner) in sectors() {
        let found = sector(scheme, faces, corner);
        let mut polynomial = characteristic(matrix(scheme, faces, corner));
        let points = polynomial.len() - 1;
        assert_eq!(found.orbits.iter().map(|orbit| orbit.count).sum::<usize>(), points);
        assert_eq!(found.eigenvalues.iter().map(|one| one.multiplicity).sum::<usize>(), points);
        let most = found.eigenvalues.iter().map(|one| one.multiplicity).max().expect("one");
        for derivative in 0..=most {
            for one in found.eigenvalues.iter().filter(|one| derivative <= one.multiplicity) {
                let terms = polynomial.iter().rev();
                let value = terms
                    .fold(number(r(0, 1)), |sum, c| sum.times(&one.real).plus(&number(c.clone())));
                assert_eq!(
                    value.sign() == 0,
                    derivative < one.multiplicity,
                    "{scheme} {faces} {corner}: {} in derivative {derivative}",
                    one.real
                );
            }
            let factors = polynomial.iter().enumerate().skip(1);
            polynomial = factors.map(|(k, c)| &Rational::from(k) * c).collect();
        }
        let mut blocks: Vec<usize> =
            found.eigenvalues.iter().flat_map(|one| one.blocks.clone()).collect();
        blocks.sort_unstable();
        let each = if scheme == "loop" { 1 } else { 2 };
        let mut expected = vec![0; 3];
        expected.extend((1..faces).flat_map(|j| std::iter::repeat_n(j, each)));
        if scheme != "loop" {
            expected.push(faces);
        }
        assert_eq!(blocks, expected);
    }
}

/// wM for a row w.
fn pulled_back(matrix: &[Row], weights: &[RealExpression]) -> Vec<RealExpression> {
    let entry = |b: usize| {
        let terms = weights.iter().zip(matrix);
        terms.fold(number(r(0, 1)), |sum, (w, row)| sum.plus(&w.times(&number(row[b].clone()))))
    };
    (0..matrix.len()).map(entry).collect()
}

#[test]
fn stencils_are_left_eigenvectors() {
    for (scheme, faces, corner) in sectors() {
        let (found, matrix) = (sector(scheme, faces, corner), matrix(scheme, faces, corner));
        let check = |weights: &[RealExpression], value: &RealExpression, total: i8| {
            let expected: Vec<RealExpression> = weights.iter().map(|w| w.times(value)).collect();
            assert_eq!(pulled_back(&matrix, weights), expected, "{scheme} {faces} {corner}");
            assert_eq!(RealExpression::total(weights).sign(), total);
        };
        check(&expressions(&found.limit), &number(r(1, 1)), 1);
        assert_eq!(RealCyclotomic::total(&found.limit), RealCyclotomic::from(1));
        assert_eq!(found.along.len(), if corner { 2 } else { 1 });
        for along in &found.along {
            check(&expressions(along), &number(r(1, 2)), 0);
        }
        let Some(across) = found.across else {
            assert_eq!((faces, corner), (1, true));
            continue;
        };
        // The sign of cos(π/F), and of cos(π/F) − 1/2.
        let regular = if scheme == "loop" { 3 } else { 2 };
        assert_eq!(across.side, faces.cmp(&regular), "{scheme} {faces}");
        assert_eq!(across.side, across.eigenvalue.cmp(&number(r(1, 2))));
        match across.stencil {
            None => assert!(corner && across.side == Ordering::Equal),
            Some(stencil) => {
                check(&stencil, &across.eigenvalue, 0);
                // It goes into the sector.
                let inner = if faces == 1 { &stencil[1] } else { &stencil[2] };
                assert_eq!(inner.sign(), 1);
            }
        }
    }
}
