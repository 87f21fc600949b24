(** The norm of a power of the refinement, by the tree of digits; differences; contraction constants. *)

Require Import ZArith QArith Qabs Qround List Lia.
From Subcert Require Import Definitions.
Import ListNotations.
Local Open Scope Q_scope.

#[global] Arguments Qplus : simpl never.
#[global] Arguments Qmult : simpl never.
#[global] Arguments Qopp : simpl never.
#[global] Arguments Qminus : simpl never.
#[global] Arguments Qabs : simpl never.
#[global] Arguments inject_Z : simpl never.
#[global] Arguments Z.of_nat : simpl never.
#[global] Arguments Z.mul : simpl never.

(** * Combinations *)

Definition norm1 (row : list Z) : Z := fold_right (fun a s => Z.abs a + s)%Z 0%Z row.

Fixpoint add (u v : list Z) : list Z :=
  match u, v with
  | [], _ => v
  | _, [] => u
  | a :: u, b :: v => (a + b)%Z :: add u v
  end.

Definition scale (c : Z) (row : list Z) : list Z := map (Z.mul c) row.

Lemma combination_add u v x i : combination (add u v) x i == combination u x i + combination v x i.
Proof.
  revert v i; induction u as [|a u IH]; intros [|b v] i; simpl; try ring.
  rewrite IH, inject_Z_plus. ring.
Qed.

Lemma combination_scale c u x i : combination (scale c u) x i == inject_Z c * combination u x i.
Proof.
  revert i; induction u as [|a u IH]; intros i; simpl; [ring|].
  unfold scale in IH. rewrite IH, inject_Z_mult. ring.
Qed.

Lemma combination_zeros k u x i :
  combination (repeat 0%Z k ++ u) x i == combination u x (i + Z.of_nat k).
Proof.
  revert i; induction k as [|k IH]; intros i.
  - simpl. replace (i + Z.of_nat 0)%Z with i by lia. reflexivity.
  - simpl repeat. simpl app. cbn [combination]. rewrite IH.
    replace (i + 1 + Z.of_nat k)%Z with (i + Z.of_nat (S k))%Z by lia.
    change (inject_Z 0) with 0. ring.
Qed.

Lemma combination_ext u x y i : (forall j, x j == y j) -> combination u x i == combination u y i.
Proof.
  intros E; revert i; induction u as [|a u IH]; intros i; simpl; [reflexivity|].
  rewrite E, IH. reflexivity.
Qed.

Lemma inject_Z_abs a : Qabs (inject_Z a) = inject_Z (Z.abs a).
Proof. reflexivity. Qed.

Lemma at_most_nonneg x b : at_most x b -> 0 <= b.
Proof. intros H. eapply Qle_trans; [apply Qabs_nonneg | apply (H 0%Z)]. Qed.

Lemma norm1_nonneg u : (0 <= norm1 u)%Z.
Proof. induction u; simpl; lia. Qed.

Lemma inject_Z_nonneg z : (0 <= z)%Z -> 0 <= inject_Z z.
Proof. intros H. change 0 with (inject_Z 0). rewrite <- Zle_Qle. exact H. Qed.

Lemma Qmult_le_l' x y z : 0 <= z -> x <= y -> z * x <= z * y.
Proof. intros Hz H. rewrite (Qmult_comm z x), (Qmult_comm z y). now apply Qmult_le_compat_r. Qed.

Lemma combination_bound u x b i : at_most x b -> Qabs (combination u x i) <= inject_Z (norm1 u) * b.
Proof.
  intros H; revert i; induction u as [|a u IH]; intros i; simpl.
  - rewrite Qmult_0_l. apply Qle_refl.
  - eapply Qle_trans; [apply Qabs_triangle|].
    rewrite Qabs_Qmult, inject_Z_abs, inject_Z_plus, Qmult_plus_distr_l.
    apply Qplus_le_compat; [|apply IH].
    apply Qmult_le_l'; [apply inject_Z_nonneg; lia | apply H].
Qed.

(** The points that attain the norm: the signs of the coefficients, from the place i on. *)
Definition at_place (i : Z) (values : list Z) : points := fun j =>
  inject_Z (if (i <=? j)%Z then nth (Z.to_nat (j - i)) values 0%Z else 0%Z).

Lemma at_place_next i v values j : (i < j)%Z -> at_place i (v :: values) j == at_place (i + 1) values j.
Proof.
  intros L. unfold at_place.
  replace (i <=? j)%Z with true by (symmetry; apply Z.leb_le; lia).
  replace (i + 1 <=? j)%Z with true by (symmetry; apply Z.leb_le; lia).
  replace (Z.to_nat (j - i)) with (S (Z.to_nat (j - (i + 1)))) by lia. reflexivity.
Qed.

Lemma combination_local u x y i :
  (forall j, (i <= j)%Z -> x j == y j) -> combination u x i == combination u y i.
Proof.
  revert i; induction u as [|a u IH]; intros i E; simpl; [reflexivity|].
  rewrite (E i) by lia. rewrite (IH (i + 1)%Z); [reflexivity|]. intros j L; apply E; lia.
Qed.

Lemma combination_signs u i : combination u (at_place i (map Z.sgn u)) i == inject_Z (norm1 u).
Proof.
  revert i; induction u as [|a u IH]; intros i; [reflexivity|]. cbn [combination map].
  rewrite (combination_local u _ (at_place (i + 1) (map Z.sgn u)));
    [|intros j L; apply at_place_next; lia].
  rewrite IH. unfold at_place at 1. rewrite Z.leb_refl, Z.sub_diag. simpl nth.
  rewrite <- inject_Z_mult, <- inject_Z_plus. simpl norm1.
  replace (a * Z.sgn a)%Z with (Z.abs a) by lia. reflexivity.
Qed.

Lemma nth_small (values : list Z) k : Forall (fun a => Z.abs a <= 1)%Z values -> (Z.abs (nth k values 0) <= 1)%Z.
Proof.
  intros F. destruct (Nat.lt_ge_cases k (length values)) as [L|L].
  - rewrite Forall_forall in F. apply F, nth_In, L.
  - rewrite nth_overflow by exact L. simpl. lia.
Qed.

Lemma signs_small u : Forall (fun a => Z.abs a <= 1)%Z (map Z.sgn u).
Proof. rewrite Forall_map. apply Forall_forall. intros a _. lia. Qed.

Lemma at_place_small i values : Forall (fun a => Z.abs a <= 1)%Z values -> at_most (at_place i values) 1.
Proof.
  intros F j. unfold at_place. rewrite inject_Z_abs. change 1 with (inject_Z 1). rewrite <- Zle_Qle.
  destruct (i <=? j)%Z; [apply nth_small, F | simpl; lia].
Qed.

Definition greatest (values : list Z) : Z := fold_right Z.max 0%Z values.

Lemma greatest_ge (f : nat -> Z) k : forall a r, (a <= r < a + k)%nat -> (f r <= greatest (map f (seq a k)))%Z.
Proof. induction k; simpl; intros a r L; [lia|]. destruct (Nat.eq_dec a r) as [->|]; [lia|].
  specialize (IHk (S a) r ltac:(lia)). lia. Qed.

Lemma greatest_attained (f : nat -> Z) k : forall a, (forall r, 0 <= f r)%Z -> (0 < k)%nat ->
  exists r, (a <= r < a + k)%nat /\ greatest (map f (seq a k)) = f r.
Proof.
  induction k as [|k IH]; intros a P L; [lia|]. simpl.
  destruct k as [|k].
  - exists a. simpl. specialize (P a). split; lia.
  - destruct (IH (S a) P ltac:(lia)) as (r & R & E). rewrite E.
    destruct (Z.max_spec (f a) (f r)) as [[? ->]|[? ->]]; [exists r|exists a]; split; lia.
Qed.

(** * Pulling a combination back through one level *)

Section Pull.
  Variable s : scheme.
  Hypothesis two_rules : (2 <= arity s)%nat.

  (** The combination w of refined points at a place with the remainder r, as one of the points before. *)
  Fixpoint pull (r : nat) (w : list Z) : list Z :=
    match w with
    | [] => []
    | a :: w =>
        add (scale a (nth r (rules s) []))
          (if Nat.eqb (S r) (arity s) then 0%Z :: pull 0 w else pull (S r) w)
    end.

  Lemma refine_at x (q : Z) r : (r < arity s)%nat ->
    refine s x (arityZ s * q + Z.of_nat r)%Z =
      (1 # denominator s) * combination (nth r (rules s) []) x (q + offset s).
  Proof.
    intros L. unfold refine.
    assert (N : (0 < arityZ s)%Z) by (unfold arityZ; lia).
    replace ((arityZ s * q + Z.of_nat r) mod arityZ s)%Z with (Z.of_nat r)
      by (rewrite Z.add_comm, (Z.mul_comm (arityZ s)), Z.mod_add, Z.mod_small; unfold arityZ in *; lia).
    replace ((arityZ s * q + Z.of_nat r) / arityZ s)%Z with q
      by (rewrite Z.add_comm, (Z.mul_comm (arityZ s)), Z.div_add, Z.div_small; unfold arityZ in *; lia).
    rewrite Nat2Z.id. reflexivity.
  Qed.

  Lemma pull_correct w : forall r q x, (r < arity s)%nat ->
    combination w (refine s x) (arityZ s * q + Z.of_nat r) ==
      (1 # denominator s) * combination (pull r w) x (q + offset s).
  Proof.
    induction w as [|a w IH]; intros r q x L; cbn [combination pull]; [ring|].
    rewrite refine_at, combination_add, combination_scale by exact L.
    destruct (Nat.eqb_spec (S r) (arity s)) as [E|E].
    - replace (arityZ s * q + Z.of_nat r + 1)%Z with (arityZ s * (q + 1) + Z.of_nat 0)%Z
        by (unfold arityZ; lia).
      rewrite IH by lia. cbn [combination].
      replace (q + 1 + offset s)%Z with (q + offset s + 1)%Z by lia.
      change (inject_Z 0) with 0. ring.
    - replace (arityZ s * q + Z.of_nat r + 1)%Z with (arityZ s * q + Z.of_nat (S r))%Z by lia.
      rewrite IH by lia. ring.
  Qed.

  (** Every place is n·q + r. *)
  Lemma place p : exists q r, (r < arity s)%nat /\ p = (arityZ s * q + Z.of_nat r)%Z.
  Proof.
    exists (p / arityZ s)%Z, (Z.to_nat (p mod arityZ s)).
    assert (N : (0 < arityZ s)%Z) by (unfold arityZ; lia).
    pose proof (Z.mod_pos_bound p _ N). pose proof (Z.div_mod p (arityZ s)).
    unfold arityZ in *. split; lia.
  Qed.

  (** The tree of digits: the greatest sum of absolute coefficients of w, pulled back c levels. *)
  Fixpoint tree (c : nat) (w : list Z) : Z :=
    match c with
    | O => norm1 w
    | S c => greatest (map (fun r => tree c (pull r w)) (seq 0 (arity s)))
    end.

  Lemma tree_nonneg c w : (0 <= tree c w)%Z.
  Proof.
    clear two_rules. destruct c; simpl; [apply norm1_nonneg|].
    induction (map _ _); simpl; lia.
  Qed.

  Lemma unit_times d e (z : Z) : (1 # d) * (z # e) == z # (d * e).
  Proof. unfold Qmult. simpl. destruct z; reflexivity. Qed.

  Fixpoint power (d : positive) (c : nat) : positive :=
    match c with O => 1%positive | S c => (d * power d c)%positive end.

  Lemma tree_bounds c : forall w x b p, at_most x b ->
    Qabs (combination w (level s c x) p) <= (tree c w # power (denominator s) c) * b.
  Proof.
    induction c as [|c IH]; intros w x b p H.
    - apply combination_bound, H.
    - destruct (place p) as (q & r & L & ->). cbn [level].
      rewrite pull_correct by exact L. rewrite Qabs_Qmult.
      eapply Qle_trans; [apply Qmult_le_l'; [discriminate | apply (IH _ _ b); exact H]|].
      change (Qabs (1 # denominator s)) with (1 # denominator s).
      rewrite Qmult_assoc, unit_times. apply Qmult_le_compat_r; [|eapply at_most_nonneg, H].
      cbn [power]. unfold Qle. simpl Qnum. simpl Qden. apply Z.mul_le_mono_nonneg_r; [lia|].
      simpl. apply (greatest_ge (fun r => tree c (pull r w)) (arity s) 0 r). lia.
  Qed.

  Lemma tree_attained c : forall w, exists p x, at_most x 1 /\
    (exists i values, x = at_place i values /\ Forall (fun a => Z.abs a <= 1)%Z values) /\
    combination w (level s c x) p == tree c w # power (denominator s) c.
  Proof.
    induction c as [|c IH]; intros w.
    - exists 0%Z, (at_place 0 (map Z.sgn w)). split; [apply at_place_small, signs_small|].
      split; [exists 0%Z, (map Z.sgn w); split; [reflexivity|apply signs_small]|]. apply combination_signs.
    - destruct (greatest_attained (fun r => tree c (pull r w)) (arity s) 0) as (r & L & E);
        [intros; apply tree_nonneg | lia |].
      destruct (IH (pull r w)) as (p & x & H & S & A).
      exists (arityZ s * (p - offset s) + Z.of_nat r)%Z, x. split; [exact H|]. split; [exact S|].
      cbn [level]. rewrite pull_correct by lia.
      replace (p - offset s + offset s)%Z with p by lia.
      rewrite A, unit_times. cbn [tree power]. rewrite E. reflexivity.
  Qed.
End Pull.

(** * Differences *)

(** Summation by parts: the sums of all later coefficients. *)
Fixpoint parts (row : list Z) : list Z :=
  match row with
  | [] => []
  | _ :: rest => sum rest :: parts rest
  end.

Lemma by_parts u x i :
  combination u x i == inject_Z (sum u) * x i + combination (parts u) (difference x) i.
Proof.
  revert i; induction u as [|a u IH]; intros i; cbn [combination parts].
  - simpl. change (inject_Z 0) with 0. ring.
  - rewrite IH. unfold difference at 2. cbn [sum fold_right].
    fold (sum u). rewrite inject_Z_plus. ring.
Qed.

Lemma by_parts_zero u x i : sum u = 0%Z -> combination u x i == combination (parts u) (difference x) i.
Proof. intros E. rewrite by_parts, E. change (inject_Z 0) with 0. ring. Qed.

Lemma sum_add u v : sum (add u v) = (sum u + sum v)%Z.
Proof.
  revert v; induction u as [|a u IH]; intros [|b v]; simpl; try (unfold sum in *; lia).
  fold (sum (add u v)). rewrite IH. unfold sum. lia.
Qed.

Lemma sum_scale c u : sum (scale c u) = (c * sum u)%Z.
Proof. induction u as [|a u IH]; simpl; [lia|]. unfold sum, scale in *. rewrite IH. lia. Qed.

(** The rule of x'_(ni+r+1) - x'_(ni+r), as a combination of points. *)
Definition difference_row (s : scheme) (r : nat) : list Z :=
  add (if Nat.eqb (S r) (arity s) then 0%Z :: nth 0 (rules s) [] else nth (S r) (rules s) [])
    (scale (-1) (nth r (rules s) [])).

(** The scheme of the differences: its mask is the difference mask b. *)
Definition difference_scheme (s : scheme) : scheme :=
  Scheme (denominator s) (offset s) (map (fun r => parts (difference_row s r)) (seq 0 (arity s))).

Lemma difference_arity s : arity (difference_scheme s) = arity s.
Proof. unfold arity at 1, difference_scheme. simpl. now rewrite map_length, seq_length. Qed.

Lemma rule_sum s r : affine s -> (r < arity s)%nat -> sum (nth r (rules s) []) = Zpos (denominator s).
Proof. intros [_ F] L. rewrite Forall_forall in F. apply F, nth_In, L. Qed.

Lemma difference_row_sum s r : affine s -> (r < arity s)%nat -> sum (difference_row s r) = 0%Z.
Proof.
  intros A L. pose proof (proj1 A). unfold difference_row. rewrite sum_add, sum_scale, (rule_sum s r) by assumption.
  destruct (Nat.eqb_spec (S r) (arity s)).
  - simpl. fold (sum (nth 0 (rules s) [])). rewrite (rule_sum s 0) by (assumption || lia). lia.
  - rewrite rule_sum by (assumption || lia). lia.
Qed.

Lemma difference_refine s x i : affine s ->
  difference (refine s x) i == refine (difference_scheme s) (difference x) i.
Proof.
  intros A. pose proof (proj1 A) as two.
  destruct (place s two i) as (q & r & L & ->).
  assert (E : refine (difference_scheme s) (difference x) (arityZ s * q + Z.of_nat r)%Z =
    (1 # denominator s) * combination (parts (difference_row s r)) (difference x) (q + offset s)).
  { replace (arityZ s) with (arityZ (difference_scheme s)) by (unfold arityZ; now rewrite difference_arity).
    rewrite refine_at by (rewrite difference_arity; lia). simpl.
    rewrite (nth_indep _ _ (parts (difference_row s (arity s)))) by (rewrite map_length, seq_length; lia).
    rewrite (map_nth (fun r => parts (difference_row s r))), seq_nth by lia. reflexivity. }
  rewrite E, <- by_parts_zero by (apply difference_row_sum; assumption).
  unfold difference, difference_row. rewrite combination_add, combination_scale, refine_at by lia.
  destruct (Nat.eqb_spec (S r) (arity s)).
  - replace (arityZ s * q + Z.of_nat r + 1)%Z with (arityZ s * (q + 1) + Z.of_nat 0)%Z by (unfold arityZ; lia).
    rewrite refine_at by lia. cbn [combination].
    replace (q + 1 + offset s)%Z with (q + offset s + 1)%Z by lia.
    change (inject_Z 0) with 0. change (inject_Z (-1)) with (-(1)). ring.
  - replace (arityZ s * q + Z.of_nat r + 1)%Z with (arityZ s * q + Z.of_nat (S r))%Z by lia.
    rewrite refine_at by lia. change (inject_Z (-1)) with (-(1)). ring.
Qed.

Lemma refine_ext s x y i : (forall j, x j == y j) -> refine s x i == refine s y i.
Proof. intros E. unfold refine. now rewrite (combination_ext _ x y _ E). Qed.

Lemma level_ext s k x y : (forall j, x j == y j) -> forall i, level s k x i == level s k y i.
Proof. intros E; induction k as [|k IH]; intros i; simpl; [apply E | now apply refine_ext]. Qed.

Lemma difference_level s c x : affine s -> forall i,
  difference (level s c x) i == level (difference_scheme s) c (difference x) i.
Proof.
  intros A; induction c as [|c IH]; intros i; [reflexivity|].
  cbn [level]. rewrite difference_refine by exact A. now apply refine_ext.
Qed.

(** * Contraction constants *)

Definition is_affine (s : scheme) : bool :=
  Nat.leb 2 (arity s) && forallb (fun rule => Z.eqb (sum rule) (Zpos (denominator s))) (rules s).

Lemma is_affine_correct s : is_affine s = true -> affine s.
Proof.
  unfold is_affine. intros H. apply andb_prop in H. destruct H as [L F]. split.
  - now apply Nat.leb_le.
  - apply Forall_forall. rewrite forallb_forall in F. intros r I. now apply Z.eqb_eq, F.
Qed.

(** T_c, computed. *)
Definition contraction (s : scheme) (c : nat) : Q :=
  tree (difference_scheme s) c [1%Z] # power (denominator s) c.

Lemma combination_one x i : combination [1%Z] x i == x i.
Proof. simpl. change (inject_Z 1) with 1. ring. Qed.

Theorem contraction_bounds s c : affine s -> bounds_differences s c (contraction s c).
Proof.
  intros A x b H i. rewrite difference_level, <- combination_one by exact A.
  apply tree_bounds; [rewrite difference_arity; apply A | exact H].
Qed.

(** Points with given differences. *)
Definition summed (first : Z) (values : list Z) : points := fun i =>
  inject_Z (sum (firstn (Z.to_nat (i - first)) values)).

Lemma sum_firstn values : forall k, sum (firstn (S k) values) = (sum (firstn k values) + nth k values 0)%Z.
Proof.
  induction values as [|v values IH]; intros [|k]; try reflexivity; [simpl; lia|].
  change (firstn (S (S k)) (v :: values)) with (v :: firstn (S k) values).
  change (firstn (S k) (v :: values)) with (v :: firstn k values).
  change (sum (v :: firstn (S k) values)) with (v + sum (firstn (S k) values))%Z.
  rewrite IH. change (sum (v :: firstn k values)) with (v + sum (firstn k values))%Z. simpl. lia.
Qed.

Lemma difference_summed first values i : difference (summed first values) i == at_place first values i.
Proof.
  unfold difference, summed, at_place. destruct (Z.leb_spec first i).
  - replace (Z.to_nat (i + 1 - first)) with (S (Z.to_nat (i - first))) by lia.
    rewrite sum_firstn, inject_Z_plus. ring.
  - replace (Z.to_nat (i + 1 - first)) with O by lia. replace (Z.to_nat (i - first)) with O by lia.
    simpl. ring.
Qed.

Theorem contraction_attained s c : affine s -> attains_difference s c (contraction s c).
Proof.
  intros A.
  destruct (tree_attained (difference_scheme s)
    ltac:(rewrite difference_arity; apply A) c [1%Z]) as (p & x & H & (i & values & E & F) & T).
  exists (summed i values), p. split.
  - intros j. rewrite difference_summed, <- E. apply H.
  - rewrite difference_level by exact A.
    rewrite (level_ext _ c _ x) by (intros j; rewrite difference_summed, E; reflexivity).
    rewrite <- combination_one. exact T.
Qed.

(** What a generated file applies: one computation decides both conditions. *)
Definition contraction_is (s : scheme) (c : nat) (T : Q) : bool :=
  is_affine s && Qeq_bool (contraction s c) T.

Theorem contraction_constant_by s c T : contraction_is s c T = true -> contraction_constant s c T.
Proof.
  unfold contraction_is. intros H. apply andb_prop in H. destruct H as [A E].
  apply is_affine_correct in A. apply Qeq_bool_eq in E. split.
  - intros x b B i. rewrite <- E. now apply contraction_bounds.
  - destruct (contraction_attained s c A) as (x & i & B & V).
    exists x, i. split; [exact B | now rewrite <- E].
Qed.

(** The same for the norm of a scheme; its rules may have any sums. *)
Definition norm (s : scheme) (c : nat) : Q := tree s c [1%Z] # power (denominator s) c.

Definition norm_is (s : scheme) (c : nat) (L : Q) : bool := Nat.leb 2 (arity s) && Qeq_bool (norm s c) L.

Theorem scheme_norm_by s c L : norm_is s c L = true -> scheme_norm s c L.
Proof.
  unfold norm_is. intros H. apply andb_prop in H. destruct H as [A E].
  apply Nat.leb_le in A. apply Qeq_bool_eq in E. split.
  - intros x b B i. rewrite <- E, <- combination_one. now apply tree_bounds.
  - destruct (tree_attained s A c [1%Z]) as (p & x & B & _ & V).
    exists x, p. split; [exact B|]. now rewrite <- E, <- combination_one.
Qed.

(** * Difference masks, and the other order *)

Definition zeros (row : list Z) : bool := forallb (Z.eqb 0) row.

(** Equal, apart from zeros at the end. *)
Fixpoint same_row (u v : list Z) : bool :=
  match u, v with
  | [], _ => zeros v
  | _, [] => zeros u
  | a :: u, b :: v => Z.eqb a b && same_row u v
  end.

Lemma combination_all_zeros u x i : zeros u = true -> combination u x i == 0.
Proof.
  revert i; induction u as [|a u IH]; intros i H; [reflexivity|].
  cbn [zeros forallb] in H. apply andb_prop in H. destruct H as [E H]. apply Z.eqb_eq in E. subst a.
  cbn [combination]. rewrite IH by exact H. change (inject_Z 0) with 0. ring.
Qed.

Lemma same_row_correct u x : forall v i, same_row u v = true -> combination u x i == combination v x i.
Proof.
  induction u as [|a u IH]; intros [|b v] i H.
  - reflexivity.
  - symmetry. now apply combination_all_zeros.
  - now apply combination_all_zeros.
  - cbn [same_row] in H. apply andb_prop in H. destruct H as [E H]. apply Z.eqb_eq in E. subst b.
    cbn [combination]. now rewrite (IH v (i + 1)%Z H).
Qed.

Definition difference_mask_is (s D : scheme) : bool :=
  let E := difference_scheme s in
  is_affine s && Pos.eqb (denominator D) (denominator E) && Z.eqb (offset D) (offset E) &&
  Nat.eqb (arity D) (arity E) &&
  forallb (fun r => same_row (nth r (rules E) []) (nth r (rules D) [])) (seq 0 (arity E)).

Theorem difference_mask_by s D : difference_mask_is s D = true -> difference_mask s D.
Proof.
  unfold difference_mask_is. intros H.
  repeat match type of H with (_ && _)%bool = true =>
    let G := fresh "G" in apply andb_prop in H; destruct H as [H G] end.
  apply is_affine_correct in H. apply Pos.eqb_eq in G2. apply Z.eqb_eq in G1. apply Nat.eqb_eq in G0.
  intros x i. rewrite difference_refine by exact H. unfold refine.
  assert (Z : arityZ D = arityZ (difference_scheme s)) by (unfold arityZ; now rewrite G0).
  rewrite Z, G1, G2.
  rewrite (same_row_correct _ _ (nth (Z.to_nat (i mod arityZ (difference_scheme s))) (rules D) [])); [reflexivity|].
  rewrite forallb_forall in G. apply G, in_seq. split; [lia|].
  pose proof (difference_arity s). pose proof (proj1 H).
  pose proof (Z.mod_pos_bound i (arityZ (difference_scheme s)) ltac:(unfold arityZ; lia)).
  unfold arityZ in *. lia.
Qed.

Theorem backwards_constant_by s D c T :
  difference_mask_is s D && norm_is (backwards D) c T = true -> backwards_constant s D c T.
Proof.
  intros H. apply andb_prop in H. destruct H as [H G]. split; [now apply difference_mask_by | now apply scheme_norm_by].
Qed.
