(** What the statements mean. A reader who trusts Coq has to read this file, and the statement of a theorem. *)

Require Import ZArith QArith Qround Qabs List.
Import ListNotations.

(** * Schemes

    A mask has n rules of rational entries. All entries are integers over one denominator. *)

Record scheme := Scheme { denominator : positive; offset : Z; rules : list (list Z) }.

Definition arity (s : scheme) : nat := length (rules s).
Definition arityZ (s : scheme) : Z := Z.of_nat (arity s).

(** Points x_i for all integers i. Coordinates are rational numbers. *)
Definition points := Z -> Q.

(** combination [a_0; a_1; …] x i = a_0 x_i + a_1 x_(i+1) + … *)
Fixpoint combination (row : list Z) (x : points) (i : Z) : Q :=
  match row with
  | [] => 0
  | a :: rest => inject_Z a * x i + combination rest x (i + 1)
  end.

(** x'_(n i + alpha) = Σ_j a_(alpha,j) x_(i + offset + j), 0 <= alpha < n. *)
Definition refine (s : scheme) (x : points) : points := fun m =>
  let n := arityZ s in
  (1 # denominator s) * combination (nth (Z.to_nat (m mod n)) (rules s) []) x (m / n + offset s).

(** The points of level k; those of level 0 are x. *)
Fixpoint level (s : scheme) (k : nat) (x : points) : points :=
  match k with O => x | S k => refine s (level s k x) end.

Definition sum (row : list Z) : Z := fold_right Z.add 0%Z row.

(** A scheme has two rules or more, and every rule sums to 1. *)
Definition affine (s : scheme) : Prop :=
  (2 <= arity s)%nat /\ Forall (fun rule => sum rule = Zpos (denominator s)) (rules s).

(** * Differences *)

Definition difference (x : points) : points := fun i => x (i + 1)%Z - x i.

Definition at_most (x : points) (b : Q) : Prop := forall i, Qabs (x i) <= b.

(** The differences of level c are at most T times the largest difference of level 0, for all points. *)
Definition bounds_differences (s : scheme) (c : nat) (T : Q) : Prop :=
  forall x b, at_most (difference x) b -> at_most (difference (level s c x)) (T * b).

(** Some points have differences of at most 1 at level 0, and a difference T at level c. *)
Definition attains_difference (s : scheme) (c : nat) (T : Q) : Prop :=
  exists x i, at_most (difference x) 1 /\ difference (level s c x) i == T.

(** T is the contraction constant T_c: the least number that bounds the differences. *)
Definition contraction_constant (s : scheme) (c : nat) (T : Q) : Prop :=
  bounds_differences s c T /\ attains_difference s c T.

(** The same for the points: the norm Λ_c. *)
Definition scheme_norm (s : scheme) (c : nat) (L : Q) : Prop :=
  (forall x b, at_most x b -> at_most (level s c x) (L * b)) /\
  (exists x i, at_most x 1 /\ level s c x i == L).

(** D refines the differences as s refines the points: D is the difference mask of s. *)
Definition difference_mask (s D : scheme) : Prop :=
  forall x i, difference (refine s x) i == refine D (difference x) i.

(** Every rule read from its other end, as some papers read the difference mask. The greatest sum of absolute
    values after c levels, which they print, is then the norm of this mask, and need not bound differences. *)
Definition backwards (s : scheme) : scheme :=
  Scheme (denominator s) (offset s) (map (@rev Z) (rules s)).

Definition backwards_constant (s D : scheme) (c : nat) (T : Q) : Prop :=
  difference_mask s D /\ scheme_norm (backwards D) c T.

(** * Distances *)

(** The piecewise linear function with the value x_i at the integer i. *)
Definition interpolant (x : points) (u : Q) : Q :=
  let i := Qfloor u in x i + (u - inject_Z i) * (x (i + 1)%Z - x i).

(** P^k, the piecewise linear function with the value x^k_i at (i + tau)/n^k. Papers take tau = 0, if they do not say
    another number. The natural tau of a scheme that takes lines to lines makes P^k the limit, for lines. *)
Definition polygon (s : scheme) (tau : Q) (k : nat) (x : points) (t : Q) : Q :=
  interpolant (level s k x) (inject_Z (arityZ s ^ Z.of_nat k) * t - tau).

(** From level k to all later levels, polygons move by at most B times the largest difference of level 0. *)
Definition bounds_distance (s : scheme) (tau : Q) (k : nat) (B : Q) : Prop :=
  forall x b t l, at_most (difference x) b -> (k <= l)%nat ->
  Qabs (polygon s tau l x t - polygon s tau k x t) <= B * b.

(** The same from level k to level k + 1. *)
Definition bounds_step (s : scheme) (tau : Q) (k : nat) (B : Q) : Prop :=
  forall x b t, at_most (difference x) b ->
  Qabs (polygon s tau (S k) x t - polygon s tau k x t) <= B * b.

(** From level k on, polygons of points with differences of at most b move by at most epsilon. *)
Definition sufficient_depth (s : scheme) (tau b epsilon : Q) (k : nat) : Prop :=
  forall x t m l, at_most (difference x) b -> (k <= m <= l)%nat ->
  Qabs (polygon s tau l x t - polygon s tau m x t) <= epsilon.

(** C_k, the least constant of the distance from level k to the limit, lies between two numbers: the second bounds the
    distance, and some points with differences of at most 1 have the first at EVERY level from l on. *)
Definition least_constant (s : scheme) (tau : Q) (k : nat) (lower upper : Q) : Prop :=
  bounds_distance s tau k upper /\ exists x t l, at_most (difference x) 1 /\
  forall m, (l <= m)%nat -> lower <= Qabs (polygon s tau m x t - polygon s tau k x t).

(** * Data

    Points given by the integers from index [first] on; before and after them, the first and last are repeated. *)
Definition data (first : Z) (values : list Z) : points := fun i =>
  inject_Z (nth (Z.to_nat (Z.min (i - first) (Z.of_nat (length values) - 1))) values 0%Z).

(** Some points with differences of at most b move by more than B from level k to EVERY level from l on. *)
Definition exceeds_distance (s : scheme) (tau : Q) (k : nat) (b B : Q) : Prop :=
  exists x t l margin, at_most (difference x) b /\ 0 < margin /\
  forall m, (l <= m)%nat -> B + margin <= Qabs (polygon s tau m x t - polygon s tau k x t).

Definition exceeds_step (s : scheme) (tau : Q) (k : nat) (b B : Q) : Prop :=
  exists x t, at_most (difference x) b /\ B < Qabs (polygon s tau (S k) x t - polygon s tau k x t).

Definition exceeds_difference (s : scheme) (k : nat) (b B : Q) : Prop :=
  exists x i, at_most (difference x) b /\ B < Qabs (difference (level s k x) i).

(** * Tensor nets: refined by s along the first index, and by r along the second *)

Definition net := Z -> Z -> Q.

Definition refine_net (s r : scheme) (x : net) : net := fun i j => refine s (fun a => refine r (x a) j) i.

Fixpoint net_level (s r : scheme) (k : nat) (x : net) : net :=
  match k with O => x | S k => refine_net s r (net_level s r k x) end.

Definition net_at_most (x : net) (b : Q) : Prop := forall i j,
  Qabs (x (i + 1)%Z j - x i j) <= b /\ Qabs (x i (j + 1)%Z - x i j) <= b.

(** The piecewise bilinear function with the value x^k_(i,j) at ((i + tau)/n^k, (j + rho)/m^k). *)
Definition surface (s r : scheme) (tau rho : Q) (k : nat) (x : net) (t u : Q) : Q :=
  interpolant (fun i => interpolant (net_level s r k x i) (inject_Z (arityZ r ^ Z.of_nat k) * u - rho))
    (inject_Z (arityZ s ^ Z.of_nat k) * t - tau).

(** From level k to all later levels, surfaces move by at most B times the largest difference of level 0. *)
Definition bounds_net_distance (s r : scheme) (tau rho : Q) (k : nat) (B : Q) : Prop := forall x b t u l,
  net_at_most x b -> (k <= l)%nat -> Qabs (surface s r tau rho l x t u - surface s r tau rho k x t u) <= B * b.

Definition exceeds_net_step (s r : scheme) (tau rho : Q) (k : nat) (b B : Q) : Prop := exists x t u,
  net_at_most x b /\ B < Qabs (surface s r tau rho (S k) x t u - surface s r tau rho k x t u).

Definition exceeds_net_distance (s r : scheme) (tau rho : Q) (k : nat) (b B : Q) : Prop := exists x t u l margin,
  net_at_most x b /\ 0 < margin /\
  forall m, (l <= m)%nat -> B + margin <= Qabs (surface s r tau rho m x t u - surface s r tau rho k x t u).

(** * Rings

    The points around a vertex or of a face: x'_a = Σ_b m_(a,b) x_b, with all weights over one denominator.
    The edges join the points whose differences count. *)

Record ring := Ring { ring_denominator : positive; weights : list (list Z); edges : list (nat * nat) }.

Fixpoint dot (row : list Z) (x : list Q) : Q :=
  match row, x with
  | a :: row, v :: x => inject_Z a * v + dot row x
  | _, _ => 0
  end.

Definition refine_ring (r : ring) (x : list Q) : list Q :=
  map (fun row => (1 # ring_denominator r) * dot row x) (weights r).

Fixpoint ring_level (r : ring) (k : nat) (x : list Q) : list Q :=
  match k with O => x | S k => refine_ring r (ring_level r k x) end.

(** Every row has a weight for each point, and they sum to 1. *)
Definition affine_ring (r : ring) : Prop :=
  Forall (fun row => length row = length (weights r) /\ sum row = Zpos (ring_denominator r)) (weights r).

(** The differences of x along the edges are at most b; x has as many points as the ring, which is affine. *)
Definition ring_at_most (r : ring) (x : list Q) (b : Q) : Prop :=
  affine_ring r /\ length x = length (weights r) /\
  forall a c, In (a, c) (edges r) -> Qabs (nth a x 0 - nth c x 0) <= b.

Definition exceeds_ring_difference (r : ring) (k : nat) (b B : Q) : Prop :=
  exists x a c, ring_at_most r x b /\ (In (a, c) (edges r) \/ In (c, a) (edges r)) /\
  B < Qabs (nth a (ring_level r k x) 0 - nth c (ring_level r k x) 0).

(** A new point is farther than B from where the rules p put it; those of weights 0 and 1 leave it where it was. *)
Definition exceeds_ring_step (r p : ring) (k : nat) (b B : Q) : Prop :=
  exists x a, ring_at_most r x b /\ (a < length (weights r))%nat /\
  B < Qabs (nth a (ring_level r (S k) x) 0 - nth a (refine_ring p (ring_level r k x)) 0).

(** All points tend to the number p. *)
Definition ring_tends_to (r : ring) (x : list Q) (p : Q) : Prop :=
  forall epsilon, 0 < epsilon -> exists l, forall m a, (l <= m)%nat -> (a < length (weights r))%nat ->
  Qabs (nth a (ring_level r m x) 0 - p) <= epsilon.

(** Some points tend to a number, and one of them is farther than B from it at level k. *)
Definition exceeds_ring_distance (r : ring) (k : nat) (b B : Q) : Prop :=
  exists x a p, ring_at_most r x b /\ (a < length (weights r))%nat /\ ring_tends_to r x p /\
  B < Qabs (nth a (ring_level r k x) 0 - p).
