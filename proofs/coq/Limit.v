(** Limits: what is proved of all levels holds in the limit. Only here are real numbers, with the axioms of the
    standard library for them. *)

Require Import ZArith QArith Qabs Qreals Reals List Lia Lra.
From Subcert Require Import Definitions Core Error Refutation.
Import ListNotations.
Local Open Scope R_scope.

(** P^∞(t) = L: the polygons tend to L at t. *)
Definition tends_to (s : scheme) (tau : Q) (x : points) (t : Q) (L : R) : Prop :=
  Un_cv (fun l => Q2R (polygon s tau l x t)) L.

Lemma Q2R_abs q : Q2R (Qabs q) = Rabs (Q2R q).
Proof.
  apply (Qabs_case q (fun a => Q2R a = Rabs (Q2R q))); intros H.
  - rewrite Rabs_right; [reflexivity|]. apply Rle_ge. apply Qle_Rle in H. lra.
  - rewrite Q2R_opp, Rabs_left1; [reflexivity|]. apply Qle_Rle in H. lra.
Qed.

Lemma limit_within u L a C k : Un_cv u L -> (forall l, (k <= l)%nat -> Rabs (u l - a) <= C) -> Rabs (L - a) <= C.
Proof.
  intros H B. apply Rnot_lt_le. intros F.
  destruct (H (Rabs (L - a) - C)) as [N E]; [lra|].
  specialize (E (max N k) ltac:(lia)). specialize (B (max N k) ltac:(lia)). unfold R_dist in E.
  pose proof (Rabs_triang (L - u (max N k)) (u (max N k) - a)) as T.
  rewrite (Rabs_minus_sym L) in T. replace (L - u (max N k) + (u (max N k) - a)) with (L - a) in T by ring. lra.
Qed.

Theorem distance_in_the_limit s tau k B : bounds_distance s tau k B ->
  forall x b t L, at_most (difference x) b -> tends_to s tau x t L ->
  Rabs (L - Q2R (polygon s tau k x t)) <= Q2R (B * b).
Proof.
  intros H x b t L S C. apply (limit_within _ _ _ _ k C). intros l G.
  rewrite <- Q2R_minus, <- Q2R_abs. apply Qle_Rle. now apply H.
Qed.

Theorem depth_in_the_limit s tau b epsilon k : sufficient_depth s tau b epsilon k ->
  forall x t m L, at_most (difference x) b -> (k <= m)%nat -> tends_to s tau x t L ->
  Rabs (L - Q2R (polygon s tau m x t)) <= Q2R epsilon.
Proof.
  intros H x t m L S G C. apply (limit_within _ _ _ _ m C). intros l F.
  rewrite <- Q2R_minus, <- Q2R_abs. apply Qle_Rle. apply H; [exact S | lia].
Qed.

Theorem exceeded_in_the_limit s tau k b B : exceeds_distance s tau k b B ->
  exists x t, at_most (difference x) b /\
  forall L, tends_to s tau x t L -> Q2R B < Rabs (L - Q2R (polygon s tau k x t)).
Proof.
  intros (x & t & l & margin & S & P & E). exists x, t. split; [exact S|]. intros L C.
  apply Qlt_Rlt in P. replace (Q2R 0) with 0 in P by (unfold Q2R; simpl; lra).
  destruct (C (Q2R margin) P) as [N F].
  specialize (F (max N l) ltac:(lia)). specialize (E (max N l) ltac:(lia)). unfold R_dist in F.
  apply Qle_Rle in E. rewrite Q2R_plus, Q2R_abs, Q2R_minus in E.
  set (u := Q2R (polygon s tau (max N l) x t)) in *. set (a := Q2R (polygon s tau k x t)) in *.
  pose proof (Rabs_triang (u - L) (L - a)) as T. replace (u - L + (L - a)) with (u - a) in T by ring. lra.
Qed.

(** * The limit exists where some T_c < 1 *)

Fixpoint q_power (q : Q) (j : nat) : Q := match j with O => 1%Q | S j => (q * q_power q j)%Q end.

Lemma q_power_bounds s c q j : bounds_differences s c q -> bounds_differences s (j * c) (q_power q j).
Proof.
  intros H. induction j as [|j IH]; [apply bounds_differences_zero|].
  simpl. now apply bounds_differences_times.
Qed.

Lemma Q2R_power q j : Q2R (q_power q j) = (Q2R q) ^ j.
Proof.
  induction j as [|j IH]; simpl; [unfold Q2R; simpl; lra|]. now rewrite Q2R_mult, IH.
Qed.

Lemma contraction_nonneg s c : (0 <= contraction s c)%Q.
Proof. unfold contraction, Qle. simpl. rewrite Z.mul_1_r. apply tree_nonneg. Qed.

Lemma uniform_bound s tau c : affine s -> (0 < c)%nat -> (contraction s c < 1)%Q ->
  exists B, (0 <= B)%Q /\ bounds_distance s tau 0 B.
Proof.
  intros A P L. set (q := contraction s c) in *.
  set (ts := map (contraction s) (seq 0 c)).
  assert (N : nonneg ts) by (apply Forall_map, Forall_forall; intros; apply contraction_nonneg).
  assert (Z : (0 < 1 - q)%Q) by (apply Qlt_minus_iff in L; exact L).
  set (B := (displacement s tau * total ts / (1 - q))%Q).
  assert (B0 : (0 <= B)%Q).
  { unfold B. apply Qle_shift_div_l; [exact Z|]. rewrite Qmult_0_l.
    apply Qmult_le_0_compat; [apply displacement_nonneg | now apply total_nonneg]. }
  exists B. split; [exact B0|].
  assert (Len : length ts = c) by (unfold ts; now rewrite map_length, seq_length).
  apply (distance_bound s tau 0 ts q B A N); try rewrite Len.
  - exact P.
  - now apply contraction_bounds.
  - apply contraction_nonneg.
  - now apply Qlt_le_weak.
  - exact B0.
  - intros i I. rewrite Len in I. rewrite Nat.add_0_r. unfold ts.
    rewrite (nth_indep _ _ (contraction s 0)) by (rewrite map_length, seq_length; exact I).
    rewrite map_nth, seq_nth by exact I. now apply contraction_bounds.
  - apply Qle_lteq. right. unfold B. field. intros E. rewrite E in Z. discriminate.
Qed.

Theorem limit_exists s tau c : affine s -> (0 < c)%nat -> (contraction s c < 1)%Q ->
  forall x b t, at_most (difference x) b -> exists L, tends_to s tau x t L.
Proof.
  intros A P H x b t S.
  destruct (uniform_bound s tau c A P H) as (B & B0 & D).
  set (q := contraction s c) in *.
  assert (C : Cauchy_crit (fun l => Q2R (polygon s tau l x t))).
  { intros epsilon E.
    assert (q1 : Rabs (Q2R q) < 1).
    { rewrite Rabs_right.
      - apply Qlt_Rlt in H. replace (Q2R 1) with 1 in H by (unfold Q2R; simpl; lra). exact H.
      - apply Rle_ge. replace 0 with (Q2R 0) by (unfold Q2R; simpl; lra). apply Qle_Rle, contraction_nonneg. }
    set (K := Q2R (B * b)).
    assert (K0 : 0 <= K).
    { unfold K. replace 0 with (Q2R 0) by (unfold Q2R; simpl; lra). apply Qle_Rle.
      apply Qmult_le_0_compat; [exact B0 | eapply at_most_nonneg, S]. }
    destruct (pow_lt_1_zero (Q2R q) q1 (epsilon / (2 * (K + 1)))) as [j J].
    { apply Rdiv_lt_0_compat; lra. }
    specialize (J j (le_n j)).
    assert (Near : forall l, (j * c <= l)%nat ->
      Rabs (Q2R (polygon s tau l x t) - Q2R (polygon s tau (j * c) x t)) < epsilon / 2).
    { intros l G.
      assert (X : (Qabs (polygon s tau l x t - polygon s tau (j * c) x t) <= B * (q_power q j * b))%Q).
      { replace l with ((l - j * c) + j * c)%nat by lia.
        rewrite (polygon_add s tau (l - j * c) (j * c)), (polygon_from s tau (j * c)).
        apply D; [|lia]. apply q_power_bounds; [now apply contraction_bounds | exact S]. }
      apply Qle_Rle in X. rewrite Q2R_abs, Q2R_minus, Q2R_mult, Q2R_mult, Q2R_power in X.
      eapply Rle_lt_trans; [exact X|].
      replace (Q2R B * (Q2R q ^ j * Q2R b)) with (K * Q2R q ^ j) by (unfold K; rewrite Q2R_mult; ring).
      apply Rle_lt_trans with (K * Rabs (Q2R q ^ j)).
      - apply Rmult_le_compat_l; [exact K0 | apply Rle_abs].
      - apply Rle_lt_trans with (K * (epsilon / (2 * (K + 1)))).
        + apply Rmult_le_compat_l; [exact K0 | now left].
        + apply Rlt_le_trans with ((K + 1) * (epsilon / (2 * (K + 1)))).
          * apply Rmult_lt_compat_r; [|lra]. apply Rdiv_lt_0_compat; lra.
          * right. field. lra. }
    exists (j * c)%nat. intros l m Gl Gm. unfold R_dist.
    pose proof (Near l Gl). pose proof (Near m Gm) as M. rewrite Rabs_minus_sym in M.
    pose proof (Rabs_triang (Q2R (polygon s tau l x t) - Q2R (polygon s tau (j * c) x t))
      (Q2R (polygon s tau (j * c) x t) - Q2R (polygon s tau m x t))) as T.
    replace (Q2R (polygon s tau l x t) - Q2R (polygon s tau (j * c) x t) +
      (Q2R (polygon s tau (j * c) x t) - Q2R (polygon s tau m x t)))
      with (Q2R (polygon s tau l x t) - Q2R (polygon s tau m x t)) in T by ring. lra. }
  destruct (R_complete _ C) as [L U]. now exists L.
Qed.

(** * Chaikin's scheme *)

Definition chaikin := Scheme 4 0 [[3; 1]; [1; 3]]%Z.

Example chaikin_limit x b t : at_most (difference x) b -> exists L, tends_to chaikin 0 x t L.
Proof. apply (limit_exists chaikin 0 1); [now apply is_affine_correct | lia | reflexivity]. Qed.

Example chaikin_in_the_limit x b t L : at_most (difference x) b -> tends_to chaikin 0 x t L ->
  Rabs (L - Q2R (polygon chaikin 0 3 x t)) <= Q2R ((1 # 16) * b).
Proof. apply distance_in_the_limit, (bounds_distance_by chaikin 0 1 1). vm_compute. reflexivity. Qed.
