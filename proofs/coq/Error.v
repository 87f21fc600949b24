(** The displacement sigma of one level, and the sound bound of the distance from a level to all later ones. *)

Require Import ZArith QArith Qabs Qround Qminmax List Lia Lqa.
From Subcert Require Import Definitions Core.
Import ListNotations.
Local Open Scope Q_scope.

(** * The interpolant *)

Lemma interpolant_param x u v : u == v -> interpolant x u == interpolant x v.
Proof. intros E. unfold interpolant. rewrite (Qfloor_comp u v E), E. reflexivity. Qed.

Lemma interpolant_between x i u : 0 <= u - inject_Z i -> u - inject_Z i <= 1 ->
  interpolant x u == x i + (u - inject_Z i) * (x (i + 1)%Z - x i).
Proof.
  intros L H. unfold interpolant.
  pose proof (Qfloor_le u) as F. pose proof (Qlt_floor u) as G.
  rewrite inject_Z_plus in G. change (inject_Z 1) with 1 in G.
  set (f := Qfloor u) in *.
  assert (A : (i < f + 1)%Z) by (rewrite Zlt_Qlt, inject_Z_plus; change (inject_Z 1) with 1; lra).
  assert (B : (f <= i + 1)%Z) by (rewrite Zle_Qle, inject_Z_plus; change (inject_Z 1) with 1; lra).
  assert (C : f = i \/ f = (i + 1)%Z) by lia. destruct C as [-> | ->]; [reflexivity|].
  rewrite inject_Z_plus in *. change (inject_Z 1) with 1 in *.
  assert (E : u == inject_Z i + 1) by lra. rewrite E. ring.
Qed.

(** An interpolant is affine from one integer to the next. *)
Lemma interpolant_mix x i u v theta : 0 <= u - inject_Z i -> u - inject_Z i <= 1 -> 0 <= v - inject_Z i ->
  v - inject_Z i <= 1 -> 0 <= theta -> theta <= 1 ->
  interpolant x ((1 - theta) * u + theta * v) == (1 - theta) * interpolant x u + theta * interpolant x v.
Proof.
  intros U U' V V' T T'. rewrite (interpolant_between x i u U U'), (interpolant_between x i v V V').
  rewrite (interpolant_between x i) by nra. ring.
Qed.

(** * The displacement

    With sigma = (n - 1) tau = p/q, the polygons of levels 0 and 1 differ at the parameter u + tau by
    f(u) = interpolant (refine y) (n u + sigma) - interpolant y u. On the grid of step 1/(n q) both terms are affine from
    one grid point to the next, so that f is greatest at a grid point i + j/(n q), 0 <= j < n q. *)

Definition from (start : Z) (row : list Z) : list Z := repeat 0%Z (Z.to_nat start) ++ row.

Definition rule (s : scheme) (m : Z) : list Z := nth (Z.to_nat (m mod arityZ s)) (rules s) [].

(** The first index that f(i + j/(n q)) uses, less i. *)
Definition displacement_start (s : scheme) (p : Z) (q : positive) (j : Z) : Z :=
  Z.min 0 ((j + p) / Zpos q / arityZ s + offset s).

(** n·q·d times f(i + j/(n q)), as a combination of points. *)
Definition displacement_row (s : scheme) (p : Z) (q : positive) (j : Z) : list Z :=
  let n := arityZ s in
  let m := ((j + p) / Zpos q)%Z in
  let e := ((j + p) mod Zpos q)%Z in
  let start := displacement_start s p q j in
  add (from (m / n + offset s - start) (scale (n * (Zpos q - e)) (rule s m)))
    (add (from ((m + 1) / n + offset s - start) (scale (n * e) (rule s (m + 1))))
      (from (- start) (scale (- Zpos (denominator s)) [n * Zpos q - j; j]%Z))).

Definition displacement (s : scheme) (tau : Q) : Q :=
  let sigma := Qred (inject_Z (arityZ s - 1) * tau) in
  let p := Qnum sigma in
  let q := Qden sigma in
  greatest (map (fun j => norm1 (parts (displacement_row s p q (Z.of_nat j)))) (seq 0 (arity s * Pos.to_nat q)))
    # (Pos.of_nat (arity s) * q * denominator s).

Lemma sum_from k u : sum (from k u) = sum u.
Proof. unfold from. induction (Z.to_nat k) as [|m IH]; [reflexivity|]. simpl. exact IH. Qed.

Lemma combination_from k u x i : (0 <= k)%Z -> combination (from k u) x i == combination u x (i + k).
Proof. intros L. unfold from. rewrite combination_zeros, Z2Nat.id by exact L. reflexivity. Qed.

Lemma over_arity s r : affine s -> inject_Z (arityZ s) * (r # Pos.of_nat (arity s)) == inject_Z r.
Proof.
  intros [L _]. unfold Qeq, inject_Z, arityZ. simpl.
  replace (Zpos (Pos.of_nat (arity s))) with (Z.of_nat (arity s)) by lia. lia.
Qed.

Lemma over_unit q : inject_Z (Zpos q) * (1 # q) == 1.
Proof. unfold Qeq, inject_Z. simpl. lia. Qed.

Lemma refine_rule s y i m : (0 < arityZ s)%Z -> refine s y (arityZ s * i + m)%Z =
  (1 # denominator s) * combination (rule s m) y (i + (m / arityZ s + offset s)).
Proof.
  intros N. unfold refine, rule.
  assert (E : ((arityZ s * i + m) mod arityZ s = m mod arityZ s)%Z).
  { rewrite Z.add_comm, (Z.mul_comm (arityZ s)). apply Z.mod_add. lia. }
  assert (F : ((arityZ s * i + m) / arityZ s = i + m / arityZ s)%Z).
  { rewrite Z.add_comm, (Z.mul_comm (arityZ s)), Z.div_add; lia. }
  rewrite E, F. now rewrite Z.add_assoc.
Qed.

Section Grid.
  Variables (s : scheme) (p : Z) (q : positive).
  Hypothesis A : affine s.

  Let positive_arity : (0 < arityZ s)%Z.
  Proof. pose proof (proj1 A). unfold arityZ. lia. Qed.

  (** The step of the grid. *)
  Let h : Q := 1 # (Pos.of_nat (arity s) * q).

  Lemma grid_step : inject_Z (arityZ s) * inject_Z (Zpos q) * h == 1 /\ inject_Z (arityZ s) * h == 1 # q.
  Proof.
    assert (E : inject_Z (arityZ s) * h == 1 # q).
    { assert (W : h == (1 # Pos.of_nat (arity s)) * (1 # q)) by reflexivity. rewrite W, Qmult_assoc, over_arity by exact A.
      change (inject_Z 1) with 1. ring. }
    split; [|exact E]. rewrite <- (over_unit q), <- E. ring.
  Qed.

  Lemma rule_row_sum m : sum (rule s m) = Zpos (denominator s).
  Proof.
    apply rule_sum; [exact A|]. pose proof (Z.mod_pos_bound m (arityZ s) positive_arity). unfold arityZ in *. lia.
  Qed.

  Lemma displacement_row_sum j : sum (displacement_row s p q j) = 0%Z.
  Proof. unfold displacement_row. rewrite !sum_add, !sum_from, !sum_scale, !rule_row_sum. cbn [sum fold_right]. ring. Qed.

  (** f at a grid point; u and v are the places there of the two interpolants. *)
  Definition grid_point (y : points) (J : Z) : Q :=
    interpolant (refine s y) (inject_Z (J + p) * (1 # q)) - interpolant y (inject_Z J * h).

  Lemma grid_row y i j : (0 <= j < arityZ s * Zpos q)%Z ->
    grid_point y (arityZ s * Zpos q * i + j) == (1 # (Pos.of_nat (arity s) * q * denominator s)) *
      combination (displacement_row s p q j) y (i + displacement_start s p q j).
  Proof.
    intros J. destruct grid_step as [H1 H2]. unfold grid_point.
    pose proof (Z.mod_pos_bound (j + p) (Zpos q) ltac:(lia)) as E. pose proof (Z.div_mod (j + p) (Zpos q) ltac:(lia)) as M.
    unfold displacement_row.
    set (m := ((j + p) / Zpos q)%Z) in *. set (e := ((j + p) mod Zpos q)%Z) in *.
    set (start := displacement_start s p q j).
    assert (S : (start <= 0 /\ start <= m / arityZ s + offset s)%Z)
      by (unfold start, displacement_start; fold m; lia).
    assert (S' : (m / arityZ s <= (m + 1) / arityZ s)%Z) by (apply Z.div_le_mono; lia).
    rewrite !combination_add, !combination_from, !combination_scale by lia.
    pose proof (over_unit q) as U.
    assert (Hq : 0 < 1 # q) by reflexivity. assert (Hh : 0 < h) by reflexivity.
    assert (V : inject_Z (arityZ s * Zpos q * i + j + p) * (1 # q) ==
      inject_Z (arityZ s * i + m) + inject_Z e * (1 # q)).
    { replace (arityZ s * Zpos q * i + j + p)%Z with (Zpos q * (arityZ s * i + m) + e)%Z by lia.
      rewrite inject_Z_plus, inject_Z_mult.
      transitivity ((inject_Z (Zpos q) * (1 # q)) * inject_Z (arityZ s * i + m) + inject_Z e * (1 # q)); [ring|].
      rewrite U. ring. }
    assert (W : inject_Z (arityZ s * Zpos q * i + j) * h == inject_Z i + inject_Z j * h).
    { rewrite inject_Z_plus, !inject_Z_mult.
      transitivity ((inject_Z (arityZ s) * inject_Z (Zpos q) * h) * inject_Z i + inject_Z j * h); [ring|].
      rewrite H1. ring. }
    assert (E0 : 0 <= inject_Z e) by (apply inject_Z_nonneg; lia).
    assert (E1 : inject_Z e <= inject_Z (Zpos q)) by (rewrite <- Zle_Qle; lia).
    assert (J0 : 0 <= inject_Z j) by (apply inject_Z_nonneg; lia).
    assert (J1 : inject_Z j <= inject_Z (arityZ s) * inject_Z (Zpos q)) by (rewrite <- inject_Z_mult, <- Zle_Qle; lia).
    rewrite (interpolant_between _ (arityZ s * i + m)) by (rewrite V; nra).
    rewrite (interpolant_between y i) by (rewrite W; nra).
    rewrite V, W. replace (arityZ s * i + m + 1)%Z with (arityZ s * i + (m + 1))%Z by lia.
    rewrite !refine_rule by exact positive_arity.
    replace (i + start + (m / arityZ s + offset s - start))%Z with (i + (m / arityZ s + offset s))%Z by lia.
    replace (i + start + ((m + 1) / arityZ s + offset s - start))%Z with (i + ((m + 1) / arityZ s + offset s))%Z by lia.
    replace (i + start + - start)%Z with i by lia.
    set (X := combination (rule s m) y _). set (X' := combination (rule s (m + 1)) y _).
    cbn [combination]. unfold Zminus. rewrite ?inject_Z_opp, ?inject_Z_plus, ?inject_Z_opp, ?inject_Z_mult.
    rewrite ?inject_Z_plus, ?inject_Z_opp.
    pose proof (over_unit (denominator s)) as D.
    assert (P : (1 # (Pos.of_nat (arity s) * q * denominator s)) == h * (1 # denominator s)) by reflexivity.
    rewrite P. clear P.
    set (n := inject_Z (arityZ s)) in *. set (Z := inject_Z (Zpos q)) in *. set (d := inject_Z (Zpos (denominator s))) in *.
    set (g := 1 # denominator s) in *. set (k := 1 # q) in *. set (f := inject_Z e) in *. set (a := inject_Z j) in *.
    transitivity ((k * Z) * g * X - k * f * g * X + k * f * g * X' - (d * g) * ((n * Z * h) * y i - a * h * y i + a * h * y (i + 1)%Z)).
    - assert (U' : k * Z == 1) by (rewrite <- U; ring). assert (D' : d * g == 1) by exact D. rewrite U', D', H1. ring.
    - rewrite <- H2. ring.
  Qed.

  Lemma grid_bound y b J : at_most (difference y) b ->
    Qabs (grid_point y J) <=
      (greatest (map (fun j => norm1 (parts (displacement_row s p q (Z.of_nat j)))) (seq 0 (arity s * Pos.to_nat q)))
        # (Pos.of_nat (arity s) * q * denominator s)) * b.
  Proof.
    intros H. set (N := (arityZ s * Zpos q)%Z).
    assert (N0 : (0 < N)%Z) by (unfold N; lia).
    pose proof (Z.mod_pos_bound J N N0) as R. pose proof (Z.div_mod J N ltac:(lia)) as E.
    rewrite E. unfold N at 1. rewrite grid_row by exact R. fold N.
    rewrite by_parts_zero by apply displacement_row_sum.
    rewrite Qabs_Qmult. change (Qabs (1 # ?d)) with (1 # d).
    eapply Qle_trans; [apply Qmult_le_l'; [discriminate | apply combination_bound, H]|].
    rewrite Qmult_assoc. apply Qmult_le_compat_r; [|eapply at_most_nonneg, H].
    unfold Qle, Qmult, inject_Z. cbn -[Z.mul Pos.mul Pos.of_nat seq Nat.mul].
    pose proof (greatest_ge (fun j => norm1 (parts (displacement_row s p q (Z.of_nat j)))) (arity s * Pos.to_nat q) 0
      (Z.to_nat (J mod N)) ltac:(unfold N, arityZ in *; lia)) as G. cbv beta in G. rewrite Z2Nat.id in G by lia.
    rewrite Pos.mul_1_r, Z.mul_1_l. apply Z.mul_le_mono_nonneg_r; [lia | exact G].
  Qed.
End Grid.

(** * One step *)

Lemma mix a b theta B : 0 <= theta -> theta <= 1 -> Qabs a <= B -> Qabs b <= B ->
  Qabs ((1 - theta) * a + theta * b) <= B.
Proof.
  intros L H. rewrite !Qabs_Qle_condition. intros [? ?] [? ?]. split; nra.
Qed.

(** A multiple of a unit fraction is between two integers that the quotient gives, and so is the next one. *)
Lemma within_cell J q : 0 <= inject_Z J * (1 # q) - inject_Z (J / Zpos q) /\
  inject_Z (J + 1) * (1 # q) - inject_Z (J / Zpos q) <= 1.
Proof.
  pose proof (Z.mod_pos_bound J (Zpos q) ltac:(lia)) as R. pose proof (Z.div_mod J (Zpos q) ltac:(lia)) as E.
  set (i := (J / Zpos q)%Z) in *. set (e := (J mod Zpos q)%Z) in *.
  assert (X : forall z, inject_Z (Zpos q * i + z) * (1 # q) - inject_Z i == inject_Z z * (1 # q)).
  { intros z. rewrite inject_Z_plus, inject_Z_mult.
    transitivity (inject_Z i * (inject_Z (Zpos q) * (1 # q) - 1) + inject_Z z * (1 # q)); [ring|].
    rewrite over_unit. ring. }
  assert (Q0 : 0 < 1 # q) by reflexivity.
  split.
  - rewrite E, X. apply Qmult_le_0_compat; [apply inject_Z_nonneg; lia | lra].
  - replace (J + 1)%Z with (Zpos q * i + (e + 1))%Z by lia. rewrite X.
    rewrite <- (over_unit q). apply Qmult_le_compat_r; [rewrite <- Zle_Qle; lia | lra].
Qed.

Theorem step_bound s tau y b u : affine s -> at_most (difference y) b ->
  Qabs (interpolant (refine s y) (inject_Z (arityZ s) * u + inject_Z (arityZ s - 1) * tau) - interpolant y u)
    <= displacement s tau * b.
Proof.
  intros A H. unfold displacement. set (sigma := Qred _). set (p := Qnum sigma). set (q := Qden sigma).
  assert (S : inject_Z (arityZ s - 1) * tau == inject_Z p * (1 # q)).
  { unfold p, q. rewrite <- (Qred_correct (inject_Z (arityZ s - 1) * tau)). fold sigma. unfold Qeq, Qmult, inject_Z. simpl. lia. }
  set (h := 1 # (Pos.of_nat (arity s) * q)).
  destruct (grid_step s q A) as [H1 H2]. fold h in H1, H2.
  set (n := inject_Z (arityZ s)) in *.
  set (v := n * inject_Z (Zpos q) * u). set (J := Qfloor v). set (theta := v - inject_Z J).
  assert (0 <= theta /\ theta <= 1) as [T0 T1].
  { pose proof (Qfloor_le v). pose proof (Qlt_floor v). rewrite inject_Z_plus in *.
    change (inject_Z 1) with 1 in *. unfold theta, J. split; lra. }
  assert (U : u == (1 - theta) * (inject_Z J * h) + theta * (inject_Z (J + 1) * h)).
  { rewrite inject_Z_plus. change (inject_Z 1) with 1.
    transitivity (v * h); [unfold v; rewrite <- (Qmult_1_l u) at 1; rewrite <- H1; ring | unfold theta; ring]. }
  assert (V : n * u + inject_Z (arityZ s - 1) * tau ==
    (1 - theta) * (inject_Z (J + p) * (1 # q)) + theta * (inject_Z (J + 1 + p) * (1 # q))).
  { rewrite S, U, <- H2, !inject_Z_plus. change (inject_Z 1) with 1. ring. }
  rewrite (interpolant_param _ _ _ V), (interpolant_param y _ _ U).
  pose proof (within_cell (J + p) q) as [L1 L2]. pose proof (within_cell J (Pos.of_nat (arity s) * q)) as [L3 L4].
  fold h in L3, L4. replace (J + p + 1)%Z with (J + 1 + p)%Z in L2 by lia.
  assert (Q0 : 0 < 1 # q) by reflexivity. assert (h0 : 0 < h) by reflexivity.
  assert (M1 : inject_Z (J + 1 + p) * (1 # q) == inject_Z (J + p) * (1 # q) + (1 # q)).
  { rewrite !inject_Z_plus. change (inject_Z 1) with 1. ring. }
  assert (M2 : inject_Z (J + 1) * h == inject_Z J * h + h).
  { rewrite !inject_Z_plus. change (inject_Z 1) with 1. ring. }
  rewrite (interpolant_mix _ ((J + p) / Zpos q)) by lra.
  rewrite (interpolant_mix _ (J / Zpos (Pos.of_nat (arity s) * q))) by lra.
  pose proof (grid_bound s p q A y b J H) as G. pose proof (grid_bound s p q A y b (J + 1) H) as G'.
  pose proof (mix _ _ theta _ T0 T1 G G') as M. eapply Qle_trans; [|exact M]. apply Qle_lteq. right. apply Qabs_wd.
  unfold grid_point. fold h. ring.
Qed.

(** * Levels *)

Lemma level_add s k m x : level s (k + m) x = level s k (level s m x).
Proof. induction k as [|k IH]; [reflexivity|]. simpl. now rewrite IH. Qed.

Lemma scale_levels s k m : inject_Z (arityZ s ^ Z.of_nat (k + m)) ==
  inject_Z (arityZ s ^ Z.of_nat k) * inject_Z (arityZ s ^ Z.of_nat m).
Proof. rewrite <- inject_Z_mult, Nat2Z.inj_add, Z.pow_add_r by lia. reflexivity. Qed.

Lemma polygon_add s tau k m x t :
  polygon s tau (k + m) x t == polygon s tau k (level s m x) (inject_Z (arityZ s ^ Z.of_nat m) * t).
Proof. unfold polygon. rewrite level_add. apply interpolant_param. rewrite scale_levels. ring. Qed.

Lemma polygon_from s tau m x t :
  polygon s tau m x t == polygon s tau 0 (level s m x) (inject_Z (arityZ s ^ Z.of_nat m) * t).
Proof. exact (polygon_add s tau 0 m x t). Qed.

Lemma no_shift s tau t : inject_Z (arityZ s ^ Z.of_nat 0) * t - tau == t - tau.
Proof. change (arityZ s ^ Z.of_nat 0)%Z with 1%Z. change (inject_Z 1) with 1. ring. Qed.

(** The place in level 1 is n (t - tau) + (n - 1) tau. *)
Lemma first_shift s tau t : inject_Z (arityZ s ^ Z.of_nat 1) * t - tau ==
  inject_Z (arityZ s) * (t - tau) + inject_Z (arityZ s - 1) * tau.
Proof.
  change (Z.of_nat 1) with 1%Z. rewrite Z.pow_1_r.
  unfold Z.sub. rewrite inject_Z_plus, inject_Z_opp. change (inject_Z 1) with 1. ring.
Qed.

Lemma polygon_step s tau y b t : affine s -> at_most (difference y) b ->
  Qabs (polygon s tau 1 y t - polygon s tau 0 y t) <= displacement s tau * b.
Proof.
  intros A H. unfold polygon. rewrite (interpolant_param _ _ _ (first_shift s tau t)),
    (interpolant_param _ _ _ (no_shift s tau t)). now apply step_bound.
Qed.

Lemma bounds_step_by s tau k T : affine s -> bounds_differences s k T -> bounds_step s tau k (displacement s tau * T).
Proof.
  intros A H x b t B. change (S k) with (1 + k)%nat. rewrite (polygon_add s tau 1 k), (polygon_from s tau k).
  rewrite <- Qmult_assoc. apply polygon_step; [exact A | apply H, B].
Qed.

(** * A block of levels *)

Definition total (ts : list Q) : Q := fold_right Qplus 0 ts.

Definition nonneg (ts : list Q) : Prop := Forall (fun t => 0 <= t) ts.

Definition block (s : scheme) (y : points) (b : Q) (ts : list Q) : Prop :=
  forall i, (i < length ts)%nat -> at_most (difference (level s i y)) (nth i ts 0 * b).

Lemma displacement_nonneg s tau : 0 <= displacement s tau.
Proof.
  unfold displacement, Qle. simpl. rewrite Z.mul_1_r.
  induction (map _ _); simpl; lia.
Qed.

Lemma total_nonneg ts : nonneg ts -> 0 <= total ts.
Proof. induction 1; simpl; lra. Qed.

Lemma within_block s tau ts : affine s -> nonneg ts -> forall y b t L, 0 <= b -> block s y b ts ->
  (L <= length ts)%nat -> Qabs (polygon s tau L y t - polygon s tau 0 y t) <= displacement s tau * total ts * b.
Proof.
  intros A N. induction N as [|t0 ts P N IH]; intros y b t L Hb H Le.
  - assert (L = O) as -> by (simpl in Le; lia). rewrite (Qabs_wd _ 0) by ring.
    change (Qabs 0) with 0. simpl. lra.
  - pose proof (displacement_nonneg s tau) as S0. pose proof (total_nonneg ts N) as T0.
    destruct L as [|L].
    + rewrite (Qabs_wd _ 0) by ring. change (Qabs 0) with 0.
      apply Qmult_le_0_compat; [apply Qmult_le_0_compat; simpl; lra | exact Hb].
    + rewrite (Qabs_wd _ ((polygon s tau (L + 1) y t - polygon s tau 1 y t) + (polygon s tau 1 y t - polygon s tau 0 y t)))
        by (rewrite Nat.add_1_r; ring).
      eapply Qle_trans; [apply Qabs_triangle|]. simpl total.
      rewrite (polygon_add s tau L 1).
      rewrite (Qmult_plus_distr_r (displacement s tau)), (Qmult_plus_distr_l (displacement s tau * t0)), Qplus_comm.
      apply Qplus_le_compat.
      * rewrite <- Qmult_assoc. apply polygon_step; [exact A|]. apply (H O). simpl. lia.
      * rewrite (polygon_from s tau 1). apply IH; [exact Hb | | simpl in Le; lia].
        intros i I. rewrite <- level_add. rewrite Nat.add_1_r. apply (H (S i)). simpl. lia.
Qed.

(** All levels: one power of q pays for the levels of one block. *)
Lemma all_levels s tau ts q B : affine s -> nonneg ts -> (0 < length ts)%nat ->
  bounds_differences s (length ts) q -> 0 <= q -> q <= 1 -> 0 <= B ->
  displacement s tau * total ts <= B * (1 - q) ->
  forall fuel L y b t, (L < fuel)%nat -> 0 <= b -> block s y b ts ->
  Qabs (polygon s tau L y t - polygon s tau 0 y t) <= B * b.
Proof.
  intros A N C D Q0 Q1 B0 E. induction fuel as [|fuel IH]; intros L y b t F Hb H; [lia|].
  set (c := length ts) in *.
  destruct (Nat.le_gt_cases L c) as [G|G].
  - eapply Qle_trans; [apply (within_block s tau ts); eassumption|].
    apply Qmult_le_compat_r; [|exact Hb]. eapply Qle_trans; [exact E|]. nra.
  - assert (X : (L = (L - c) + c)%nat) by lia.
    rewrite (Qabs_wd _ ((polygon s tau ((L - c) + c) y t - polygon s tau c y t) + (polygon s tau c y t - polygon s tau 0 y t)))
      by (rewrite <- X; ring).
    eapply Qle_trans; [apply Qabs_triangle|].
    rewrite (polygon_add s tau (L - c) c).
    assert (H' : block s (level s c y) (q * b) ts).
    { intros i I j. rewrite <- level_add, Nat.add_comm, level_add.
      setoid_replace (nth i ts 0 * (q * b)) with (q * (nth i ts 0 * b)) by ring.
      apply D. apply H. exact I. }
    pose proof (IH (L - c)%nat (level s c y) (q * b) (inject_Z (arityZ s ^ Z.of_nat c) * t) ltac:(lia)
      ltac:(apply Qmult_le_0_compat; assumption) H') as I1.
    rewrite <- (polygon_from s tau c) in I1.
    pose proof (within_block s tau ts A N y b t c Hb H (le_n c)) as I2.
    assert (I3 : displacement s tau * total ts * b <= B * (1 - q) * b) by (apply Qmult_le_compat_r; assumption).
    eapply Qle_trans; [apply Qplus_le_compat; [exact I1 | eapply Qle_trans; [exact I2 | exact I3]]|].
    apply Qle_lteq. right. ring.
Qed.

(** The differences of the c levels k, …, k + c - 1. *)
Definition bounded_from (s : scheme) (k : nat) (ts : list Q) : Prop :=
  forall i, (i < length ts)%nat -> bounds_differences s (i + k) (nth i ts 0).

Theorem distance_bound s tau k ts q B : affine s -> nonneg ts -> (0 < length ts)%nat ->
  bounds_differences s (length ts) q -> 0 <= q -> q <= 1 -> 0 <= B ->
  bounded_from s k ts -> displacement s tau * total ts <= B * (1 - q) -> bounds_distance s tau k B.
Proof.
  intros A N C D Q0 Q1 B0 U E x b t l H L.
  assert (X : (l = (l - k) + k)%nat) by lia. rewrite X.
  rewrite (polygon_add s tau (l - k) k), (polygon_from s tau k).
  apply (all_levels s tau ts q B A N C D Q0 Q1 B0 E (S (l - k))); [lia | eapply at_most_nonneg, H |].
  intros i I. rewrite <- level_add. apply U; assumption.
Qed.

(** * Upper bounds of all T_m, from T_1, …, T_M *)

Lemma bounds_differences_zero s : bounds_differences s 0 1.
Proof. intros x b H i. rewrite Qmult_1_l. apply H. Qed.

Lemma bounds_differences_times s c d T U : bounds_differences s c T -> bounds_differences s d U ->
  bounds_differences s (c + d) (T * U).
Proof. intros H G x b B. rewrite level_add. intros i. rewrite <- Qmult_assoc. apply H, G, B. Qed.

(** T_M, …, T_1, 1. *)
Fixpoint constants (s : scheme) (M : nat) : list Q :=
  match M with O => [1] | S M => Qred (contraction s (S M)) :: constants s M end.

(** The least T_j U_(m-j): [ts] is T_1, T_2, …, and [us] is U_(m-1), U_(m-2), … *)
Fixpoint least (ts us : list Q) : option Q :=
  match ts, us with
  | t :: ts, u :: us =>
      match least ts us with
      | Some v => Some (if Qle_bool (t * u) v then t * u else v)
      | None => Some (t * u)
      end
  | _, _ => None
  end.

Fixpoint extend (ts : list Q) (us : list Q) (count : nat) : list Q :=
  match count with
  | O => us
  | S count => extend ts (match least ts us with Some u => Qred u :: us | None => us end) count
  end.

(** [us] is U_(m-1), …, U_0. *)
Definition descending (s : scheme) (us : list Q) : Prop :=
  forall j, (j < length us)%nat -> bounds_differences s (length us - 1 - j) (nth j us 0).

Definition ascending (s : scheme) (ts : list Q) : Prop :=
  forall j, (j < length ts)%nat -> bounds_differences s (S j) (nth j ts 0).

Lemma bounds_wd s c T U : T == U -> bounds_differences s c T -> bounds_differences s c U.
Proof. intros E H x b B i. rewrite <- E. now apply H. Qed.

Lemma descending_cons s us u : descending s us -> bounds_differences s (length us) u -> descending s (u :: us).
Proof.
  intros D B [|j] L.
  - replace (length (u :: us) - 1 - 0)%nat with (length us) by (simpl; lia). exact B.
  - replace (length (u :: us) - 1 - S j)%nat with (length us - 1 - j)%nat by (simpl; lia).
    apply (D j). simpl in L. lia.
Qed.

Lemma constants_length s M : length (constants s M) = S M.
Proof. induction M; simpl; congruence. Qed.

Lemma constants_correct s M : affine s -> descending s (constants s M).
Proof.
  intros A; induction M as [|M IH].
  - intros [|j] L; [|cbn in L; lia]. apply bounds_differences_zero.
  - cbn [constants]. apply descending_cons; [exact IH|]. rewrite constants_length.
    eapply bounds_wd; [symmetry; apply Qred_correct|]. now apply contraction_bounds.
Qed.

Lemma least_correct s : forall ts us j m v,
  (forall i, (i < length ts)%nat -> bounds_differences s (S (i + j)) (nth i ts 0)) ->
  (forall i, (i < length us)%nat -> (S (i + j) <= m)%nat /\ bounds_differences s (m - S (i + j)) (nth i us 0)) ->
  least ts us = Some v -> bounds_differences s m v.
Proof.
  induction ts as [|t ts IH]; intros us j m v HT HU E; [discriminate|].
  destruct us as [|u us]; [discriminate|]. simpl in E.
  assert (H : bounds_differences s m (t * u)).
  { pose proof (HT O ltac:(simpl; lia)) as a. destruct (HU O ltac:(simpl; lia)) as [le b]. simpl in a, b, le.
    replace m with (S j + (m - S j))%nat by lia. now apply bounds_differences_times. }
  destruct (least ts us) as [w|] eqn:F.
  - assert (G : bounds_differences s m w).
    { apply (IH us (S j) m w); [| |exact F].
      - intros i I. replace (i + S j)%nat with (S i + j)%nat by lia. apply (HT (S i)). simpl. lia.
      - intros i I. replace (i + S j)%nat with (S i + j)%nat by lia. apply (HU (S i)). simpl. lia. }
    destruct (Qle_bool (t * u) w); injection E as <-; assumption.
  - injection E as <-. exact H.
Qed.

Lemma extend_correct s ts : ascending s ts -> forall count us, descending s us -> descending s (extend ts us count).
Proof.
  intros T. induction count as [|count IH]; intros us D; [exact D|]. simpl. apply IH.
  destruct (least ts us) as [u|] eqn:E; [|exact D].
  apply descending_cons; [exact D|]. eapply bounds_wd; [symmetry; apply Qred_correct|].
  apply (least_correct s ts us 0 (length us) u); [| |exact E].
  - intros i I. rewrite Nat.add_0_r. now apply T.
  - intros i I. rewrite Nat.add_0_r. split; [lia|].
    replace (length us - S i)%nat with (length us - 1 - i)%nat by lia. now apply D.
Qed.

(** U_0, U_1, …, U_(M + count). *)
Definition uppers (s : scheme) (M count : nat) : list Q :=
  let us := constants s M in rev (extend (tl (rev us)) us count).

Lemma rev_bounds s us : descending s us -> forall j, (j < length us)%nat -> bounds_differences s j (nth j (rev us) 0).
Proof.
  intros D j L. rewrite rev_nth by exact L.
  pose proof (D (length us - S j)%nat ltac:(lia)) as H.
  now replace (length us - 1 - (length us - S j))%nat with j in H by lia.
Qed.

Lemma uppers_correct s M count : affine s ->
  forall m, (m < length (uppers s M count))%nat -> bounds_differences s m (nth m (uppers s M count) 0).
Proof.
  intros A m L. unfold uppers in *. rewrite rev_length in L.
  apply rev_bounds; [|exact L].
  apply extend_correct; [|now apply constants_correct].
  intros j J. pose proof (constants_correct s M A) as D.
  assert (LL : length (tl (rev (constants s M))) = M)
    by (pose proof (rev_length (constants s M)) as R; rewrite constants_length in R;
        destruct (rev (constants s M)); simpl in *; lia).
  rewrite LL in J.
  pose proof (rev_bounds s _ D (S j) ltac:(rewrite constants_length; lia)) as H.
  destruct (rev (constants s M)); [destruct j; exact H | exact H].
Qed.

(** * What a generated file applies *)

(** The bounds of T_k, …, T_(k+c-1). *)
Definition block_from (s : scheme) (M c k : nat) : list Q :=
  firstn c (skipn k (uppers s M (k + c))).

Definition distance_bounded (s : scheme) (tau : Q) (M c k : nat) (B : Q) : bool :=
  let us := uppers s M (k + c) in
  let ts := firstn c (skipn k us) in
  let q := Qred (contraction s c) in
  is_affine s && Nat.eqb (length ts) c && Nat.ltb 0 c && Nat.leb (k + c) (length us) &&
  forallb (fun t => Qle_bool 0 t) ts &&
  Qle_bool 0 q && Qle_bool q 1 && Qle_bool 0 B && Qle_bool (displacement s tau * total ts) (B * (1 - q)).

Lemma nth_firstn_skipn (us : list Q) : forall c k i, (i < c)%nat -> nth i (firstn c (skipn k us)) 0 = nth (k + i) us 0.
Proof.
  induction us as [|u us IH]; intros c k i L.
  - destruct k, c, i; reflexivity.
  - destruct k as [|k]; simpl.
    + destruct c as [|c]; [lia|]. destruct i as [|i]; [reflexivity|]. simpl.
      apply (IH c 0%nat i). lia.
    + now apply IH.
Qed.

Lemma window_bounded s M c k : affine s -> (k + c <= length (uppers s M (k + c)))%nat ->
  bounded_from s k (block_from s M c k).
Proof.
  intros A L i I. unfold block_from in *. rewrite firstn_length, skipn_length in I.
  rewrite nth_firstn_skipn by lia. rewrite (Nat.add_comm i k). apply uppers_correct; [exact A|lia].
Qed.

Theorem bounds_distance_by s tau M c k B : distance_bounded s tau M c k B = true -> bounds_distance s tau k B.
Proof.
  unfold distance_bounded. intros H.
  repeat match type of H with (_ && _)%bool = true =>
    apply andb_prop in H; let G := fresh "G" in destruct H as [H G] end.
  apply is_affine_correct in H. apply Nat.eqb_eq in G6. apply Nat.ltb_lt in G5. apply Nat.leb_le in G4.
  rewrite Qle_bool_iff in *.
  apply (distance_bound s tau k (block_from s M c k) (Qred (contraction s c)) B); unfold block_from; try assumption.
  - apply Forall_forall. rewrite forallb_forall in G3. intros t I. apply Qle_bool_iff, G3, I.
  - lia.
  - rewrite G6. eapply bounds_wd; [symmetry; apply Qred_correct|]. now apply contraction_bounds.
  - now apply window_bounded.
Qed.
