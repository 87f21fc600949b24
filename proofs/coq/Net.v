(** Promised bounds of tensor nets, refuted by nets x_(i,j) = a_i + b_j. *)

Require Import ZArith QArith Qabs List Lia Lqa.
From Subcert Require Import Definitions Core Error Refutation.
Import ListNotations.
Local Open Scope Q_scope.

Definition net_sum (a b : points) : net := fun i j => a i + b j.

Lemma combination_plus u f c : forall i,
  combination u (fun j => f j + c) i == combination u f i + inject_Z (sum u) * c.
Proof.
  induction u as [|a u IH]; intros i; cbn [combination].
  - change (inject_Z (sum [])) with 0. ring.
  - rewrite IH. change (sum (a :: u)) with (a + sum u)%Z. rewrite inject_Z_plus. ring.
Qed.

Lemma refine_plus s f c i : affine s -> refine s (fun j => f j + c) i == refine s f i + c.
Proof.
  intros A. pose proof (proj1 A) as two. destruct (place s two i) as (q & r & L & ->).
  rewrite !refine_at by lia. rewrite combination_plus, (rule_sum s r A L).
  assert (D : (1 # denominator s) * inject_Z (Zpos (denominator s)) == 1).
  { unfold Qeq, Qmult, inject_Z. simpl. lia. }
  set (e := 1 # denominator s) in *. set (d := inject_Z (Zpos (denominator s))) in *.
  transitivity (e * combination (nth r (rules s) []) f (q + offset s) + (e * d) * c); [ring | rewrite D; ring].
Qed.

Lemma net_level_sum s r a b : affine s -> affine r -> forall k i j,
  net_level s r k (net_sum a b) i j == level s k a i + level r k b j.
Proof.
  intros A B. induction k as [|k IH]; intros i j; [reflexivity|].
  cbn [net_level level]. unfold refine_net.
  rewrite (refine_ext s _ (fun p => level s k a p + refine r (level r k b) j)).
  - now apply refine_plus.
  - intros p. rewrite (refine_ext r _ (fun q => level r k b q + level s k a p)).
    + rewrite refine_plus by exact B. ring.
    + intros q. rewrite IH. ring.
Qed.

Lemma interpolant_plus x y c u : (forall i, x i == y i + c) -> interpolant x u == interpolant y u + c.
Proof. intros E. unfold interpolant. rewrite !E. ring. Qed.

Lemma surface_sum s r tau rho k a b t u : affine s -> affine r ->
  surface s r tau rho k (net_sum a b) t u == polygon s tau k a t + polygon r rho k b u.
Proof.
  intros A B. unfold surface, polygon. apply interpolant_plus. intros i.
  rewrite (interpolant_plus _ (level r k b) (level s k a i)); [ring|].
  intros j. rewrite net_level_sum by assumption. ring.
Qed.

Lemma net_sum_spread a b c : at_most (difference a) c -> at_most (difference b) c -> net_at_most (net_sum a b) c.
Proof.
  intros A B i j. unfold net_sum. split.
  - rewrite (Qabs_wd _ (difference a i)) by (unfold difference; ring). apply A.
  - rewrite (Qabs_wd _ (difference b j)) by (unfold difference; ring). apply B.
Qed.

(** * What a generated file applies *)

Definition net_step_exceeded (s r : scheme) (tau rho : Q) (k : nat) (first : Z) (values : list Z) (first' : Z) (values' : list Z)
    (t u b B : Q) : bool :=
  let x := data first values in let y := data first' values' in
  is_affine s && is_affine r && Qle_bool (inject_Z (spread values)) b && Qle_bool (inject_Z (spread values')) b &&
  below B (Qabs ((value_at s tau (S k) x t - value_at s tau k x t) + (value_at r rho (S k) y u - value_at r rho k y u))).

Theorem exceeds_net_step_by s r tau rho k first values first' values' t u b B :
  net_step_exceeded s r tau rho k first values first' values' t u b B = true -> exceeds_net_step s r tau rho k b B.
Proof.
  unfold net_step_exceeded. intros H. conditions H.
  apply is_affine_correct in H, G2. apply Qle_bool_iff in G1, G0. apply below_correct in G.
  rewrite !value_at_correct in G by (apply H || apply G2).
  exists (net_sum (data first values) (data first' values')), t, u. split.
  - apply net_sum_spread; (eapply at_most_more; [|apply data_spread]); assumption.
  - rewrite !surface_sum by assumption.
    eapply Qlt_le_trans; [exact G|]. apply Qle_lteq. right. apply Qabs_wd. ring.
Qed.

Definition net_distance_exceeded (s r : scheme) (tau rho : Q) (k : nat) (first : Z) (values : list Z) (first' : Z) (values' : list Z)
    (t u b B : Q) (l M c : nat) (tail : Q) (M' c' : nat) (tail' : Q) : bool :=
  let x := data first values in let y := data first' values' in
  is_affine s && is_affine r && Qle_bool (inject_Z (spread values)) b && Qle_bool (inject_Z (spread values')) b &&
  distance_bounded s tau M c l tail && distance_bounded r rho M' c' l tail' &&
  below (B + tail * b + tail' * b)
    (Qabs ((value_at s tau l x t - value_at s tau k x t) + (value_at r rho l y u - value_at r rho k y u))).

Theorem exceeds_net_distance_by s r tau rho k first values first' values' t u b B l M c tail M' c' tail' :
  net_distance_exceeded s r tau rho k first values first' values' t u b B l M c tail M' c' tail' = true ->
  exceeds_net_distance s r tau rho k b B.
Proof.
  unfold net_distance_exceeded. intros H. conditions H.
  apply is_affine_correct in H, G4. apply Qle_bool_iff in G3, G2. apply below_correct in G.
  apply bounds_distance_by in G1, G0.
  rewrite !value_at_correct in G by (apply H || apply G4).
  set (x := data first values) in *. set (y := data first' values') in *.
  assert (X : at_most (difference x) b) by (eapply at_most_more; [exact G3 | apply data_spread]).
  assert (Y : at_most (difference y) b) by (eapply at_most_more; [exact G2 | apply data_spread]).
  set (far := (polygon s tau l x t - polygon s tau k x t) + (polygon r rho l y u - polygon r rho k y u)) in *.
  exists (net_sum x y), t, u, l, (Qabs far - (B + tail * b + tail' * b)).
  split; [now apply net_sum_spread|]. split; [lra|]. intros m L.
  rewrite !surface_sum by assumption.
  pose proof (G1 x b t m X L) as D. pose proof (G0 y b u m Y L) as D'.
  set (near := polygon s tau m x t + polygon r rho m y u - (polygon s tau k x t + polygon r rho k y u)).
  pose proof (Qabs_triangle near ((polygon s tau l x t - polygon s tau m x t) + (polygon r rho l y u - polygon r rho m y u))) as T.
  rewrite (Qabs_wd (near + _) far) in T by (unfold near, far; ring).
  pose proof (Qabs_triangle (polygon s tau l x t - polygon s tau m x t) (polygon r rho l y u - polygon r rho m y u)) as T'.
  rewrite (Qabs_Qminus (polygon s tau l x t)) in T'. rewrite (Qabs_Qminus (polygon r rho l y u)) in T'. lra.
Qed.
