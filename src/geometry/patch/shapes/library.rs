//! The shapes of pieces: all pieces with the same faces around them have the same weights.

use super::convergence::convergence;
use super::neighbourhood::Neighbourhood;
use super::rules::Rules;
use super::scheme::PieceScheme;
use super::shape::{Convergence, Part, Shape};
use super::surroundings::Surroundings;
use std::collections::HashMap;
use std::sync::OnceLock;

/// All shapes that have been met.
pub(crate) struct Shapes {
    pub(crate) scheme: PieceScheme,
    known: HashMap<Vec<u32>, usize>,
    all: Vec<Shape>,
}

impl Shapes {
    pub(crate) fn new(scheme: PieceScheme) -> Shapes {
        Shapes { scheme, known: HashMap::new(), all: Vec::new() }
    }

    pub(crate) fn get(&self, shape: usize) -> &Shape {
        &self.all[shape]
    }

    /// The shape of a neighbourhood, with those of its parts, of their parts, and so on.
    pub(crate) fn shape(&mut self, neighbourhood: &Neighbourhood) -> usize {
        if let Some(&shape) = self.known.get(&neighbourhood.key) {
            return shape;
        }
        let first = self.all.len();
        self.add(neighbourhood);
        let mut next = first;
        while next < self.all.len() {
            let mut wanted: Vec<usize> = Vec::new();
            let mut parts = Vec::new();
            for part in self.all[next].surroundings.parts() {
                let shape = match self.known.get(&part.key) {
                    Some(&shape) => shape,
                    None => self.add(&part),
                };
                let mut place = |point: &usize| {
                    let known = wanted.iter().position(|x| x == point);
                    known.unwrap_or_else(|| {
                        wanted.push(*point);
                        wanted.len() - 1
                    })
                };
                let points = part.points.iter().map(&mut place).collect();
                parts.push(Part { shape, points });
            }
            let shape = &mut self.all[next];
            shape.wanted = wanted;
            shape.parts = parts;
            shape.rules = shape.surroundings.rules(&shape.wanted, &shape.part_points());
            next += 1;
        }
        self.settle(first);
        first
    }

    /// Computes the growth of the shapes from `first` on: of each after that of its parts.
    fn settle(&mut self, first: usize) {
        let mut open: Vec<usize> = (first..self.all.len()).collect();
        while !open.is_empty() {
            let ready = |shape: &usize| {
                let own = &self.all[*shape];
                let known = |part: &Part| {
                    part.shape == *shape
                        || self.all[part.shape].is_regular()
                        || self.all[part.shape].convergence.is_known()
                };
                own.is_regular() || own.parts.iter().all(known)
            };
            let (now, later): (Vec<usize>, Vec<usize>) = open.iter().partition(|x| ready(x));
            assert!(!now.is_empty(), "parts of irregular shapes are regular sooner or later");
            for shape in now {
                self.all[shape].convergence = convergence(&self.all, shape);
            }
            open = later;
        }
    }

    fn add(&mut self, neighbourhood: &Neighbourhood) -> usize {
        let count = neighbourhood.points.len();
        let surroundings = Surroundings::new(self.scheme, neighbourhood);
        self.all.push(Shape {
            points: count,
            parts: Vec::new(),
            rules: Rules::default(),
            convergence: Convergence::default(),
            scheme: self.scheme,
            surroundings,
            wanted: Vec::new(),
            exact: OnceLock::new(),
        });
        self.known.insert(neighbourhood.key.clone(), self.all.len() - 1);
        self.all.len() - 1
    }

    /// How many there are.
    pub(crate) fn count(&self) -> usize {
        self.all.len()
    }

    /// The longest row of weights of all shapes.
    pub(crate) fn longest(&self) -> usize {
        self.all.iter().map(Shape::longest).max().unwrap_or(0)
    }
}
