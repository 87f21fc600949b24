//! Flows of least cost, by shortest paths of the residual network.

use crate::exact::Real;
use std::cmp::Ordering;
use std::collections::VecDeque;

/// The norm ‖w‖_*, with a flow and heights that prove its value.
///
/// The flow has the divergence w and the cost Σ c_e|f_e|. The heights differ by at most c_e
/// along each edge e, and have the value Σ_a w_a P_a. All costs c_e are 1 for
/// [`transport`](super::transport()). By weak duality the value of any heights is at most
/// the cost of any flow; here the two are equal.
#[derive(Clone, Debug, PartialEq)]
pub struct Transport<S> {
    /// ‖w‖_*.
    pub value: S,
    /// f: one number for each edge (a, b), positive for a flow from a to b.
    pub flow: Vec<S>,
    /// P: a control ring that attains the norm. The least height is 0.
    pub heights: Vec<i64>,
}

/// The norm by shortest paths, in exact arithmetic; `None` when it is infinite.
pub(super) fn shortest<S: Real + Ord>(
    w: &[S],
    edges: &[(usize, usize)],
    costs: &[u32],
) -> Option<Transport<S>> {
    let mut network = Network::new(w, edges, costs);
    while network.unbalanced() {
        let sources = (0..w.len()).filter(|&a| network.excess_sign[a] == Ordering::Greater);
        let paths = network.shortest_paths(sources);
        let sinks = (0..w.len()).filter(|&a| network.excess_sign[a] == Ordering::Less);
        let nearest = sinks.filter_map(|sink| Some((paths.length[sink]?, sink))).min();
        let (_, sink) = nearest?;
        network.send(&paths.to(sink), sink);
    }
    Some(network.found(costs))
}

/// A step along an edge or against it.
#[derive(Clone, Copy)]
struct Step {
    to: usize,
    edge: usize,
    /// 1 along the edge, −1 against it.
    direction: i8,
    /// c_e.
    cost: i64,
}

/// A flow f, and the remaining excess_a = w_a − div(f)_a of each point a.
pub(super) struct Network<S> {
    steps: Vec<Vec<Step>>,
    flow: Vec<S>,
    flow_sign: Vec<i8>,
    excess: Vec<S>,
    excess_sign: Vec<Ordering>,
}

/// Shortest paths: of least cost, and of equal cost those with the fewest steps.
struct Paths {
    length: Vec<Option<(i64, usize)>>,
    /// For each point, the preceding point and the step from it.
    last: Vec<Option<(usize, Step)>>,
}

impl<S: Real + Ord> Network<S> {
    fn new(w: &[S], edges: &[(usize, usize)], costs: &[u32]) -> Network<S> {
        assert_eq!(edges.len(), costs.len(), "a cost for each edge");
        let mut steps = vec![Vec::new(); w.len()];
        for (edge, (&(a, b), &cost)) in edges.iter().zip(costs).enumerate() {
            let cost = i64::from(cost);
            steps[a].push(Step { to: b, edge, direction: 1, cost });
            steps[b].push(Step { to: a, edge, direction: -1, cost });
        }
        let zero = S::zero();
        Network {
            steps,
            flow: vec![zero.clone(); edges.len()],
            flow_sign: vec![0; edges.len()],
            excess: w.to_vec(),
            excess_sign: w.iter().map(|excess| excess.cmp(&zero)).collect(),
        }
    }

    /// The network with this flow, without any excess.
    pub(super) fn carrying(
        flow: Vec<S>,
        points: usize,
        edges: &[(usize, usize)],
        costs: &[u32],
    ) -> Network<S> {
        let zero = S::zero();
        let flow_sign = flow.iter().map(|f| f.cmp(&zero) as i8).collect();
        let network = Network::new(&vec![zero; points], edges, costs);
        Network { flow, flow_sign, ..network }
    }

    /// The result, for a flow of least cost. The heights do not depend on the choice of
    /// the flow (`proofs/THEOREMS.md`, 24).
    pub(super) fn found(self, costs: &[u32]) -> Transport<S> {
        // Distances from all points at once: d_b ≤ d_a + c along every edge, and d_b =
        // d_a + c where flow runs from a to b, since the residual network has no negative
        // cycle.
        let distances = self.shortest_paths(0..self.excess.len()).length;
        let heights = distances.into_iter().map(|d| d.map_or(0, |(cost, _)| -cost)).collect();
        let cost = |(f, cost): (&S, &u32)| match cost {
            1 => f.magnitude(),
            _ => f.magnitude().times(&S::from_rational(&(*cost).into())),
        };
        let costs: Vec<S> = self.flow.iter().zip(costs).map(cost).collect();
        Transport { value: S::total(&costs), flow: self.flow, heights }
    }

    fn unbalanced(&self) -> bool {
        self.excess_sign.iter().any(|sign| sign.is_ne())
    }

    /// Whether a step cancels flow in the opposite direction.
    fn cancels(&self, step: Step) -> bool {
        self.flow_sign[step.edge] * step.direction < 0
    }

    /// Shortest paths from the points `from`, by the algorithm of Bellman and Ford with a
    /// queue.
    fn shortest_paths(&self, from: impl Iterator<Item = usize>) -> Paths {
        let count = self.steps.len();
        let mut paths = Paths { length: vec![None; count], last: vec![None; count] };
        let mut queue: VecDeque<usize> = from.collect();
        let mut queued = vec![false; count];
        for &source in &queue {
            paths.length[source] = Some((0, 0));
            queued[source] = true;
        }
        while let Some(point) = queue.pop_front() {
            queued[point] = false;
            let Some((cost, steps)) = paths.length[point] else { continue };
            for &step in &self.steps[point] {
                let more = if self.cancels(step) { -step.cost } else { step.cost };
                let length = (cost + more, steps + 1);
                if paths.length[step.to].is_none_or(|known| length < known) {
                    paths.length[step.to] = Some(length);
                    paths.last[step.to] = Some((point, step));
                    if !std::mem::replace(&mut queued[step.to], true) {
                        queue.push_back(step.to);
                    }
                }
            }
        }
        paths
    }

    /// Sends as much flow as possible along a path.
    fn send(&mut self, (source, path): &(usize, Vec<Step>), sink: usize) {
        let cancelled = path.iter().filter(|step| self.cancels(**step));
        let cancelled = cancelled.map(|step| self.flow[step.edge].magnitude());
        let ends = [self.excess[*source].clone(), self.excess[sink].magnitude()];
        let amount = ends.into_iter().chain(cancelled).min().expect("two ends");
        let zero = S::zero();
        for step in path {
            let flow = &mut self.flow[step.edge];
            if step.direction > 0 {
                flow.accumulate(&amount);
            } else {
                flow.lessen(&amount);
            }
            self.flow_sign[step.edge] = (*flow).cmp(&zero) as i8;
        }
        self.excess[*source].lessen(&amount);
        self.excess[sink].accumulate(&amount);
        for end in [*source, sink] {
            self.excess_sign[end] = self.excess[end].cmp(&zero);
        }
    }
}

impl Paths {
    /// The first point of the path to `sink`, and the steps, last first.
    fn to(&self, sink: usize) -> (usize, Vec<Step>) {
        let (mut point, mut steps) = (sink, Vec::new());
        while let Some((before, step)) = self.last[point] {
            steps.push(step);
            point = before;
        }
        (point, steps)
    }
}
