(** A sound bound of the distance of a tensor net from a level to all later ones. *)

Require Import ZArith QArith Qabs Qround Qminmax List Lia Lqa.
From Subcert Require Import Definitions Core Error Net Refutation.
Import ListNotations.
Local Open Scope Q_scope.

(** * Refinement is linear, and both directions commute *)

Lemma combination_times u c f : forall i, combination u (fun j => c * f j) i == c * combination u f i.
Proof. induction u as [|a u IH]; intros i; cbn [combination]; [ring|]. rewrite IH. ring. Qed.

Lemma combination_minus u f g : forall i,
  combination u (fun j => f j - g j) i == combination u f i - combination u g i.
Proof. induction u as [|a u IH]; intros i; cbn [combination]; [ring|]. rewrite IH. ring. Qed.

Lemma combination_sum u f g : forall i,
  combination u (fun j => f j + g j) i == combination u f i + combination u g i.
Proof. induction u as [|a u IH]; intros i; cbn [combination]; [ring|]. rewrite IH. ring. Qed.

Lemma combination_zero u : forall i, combination u (fun _ => 0) i == 0.
Proof. induction u as [|a u IH]; intros i; cbn [combination]; [reflexivity|]. rewrite IH. ring. Qed.

Lemma combination_swap u v (y : net) : forall i j,
  combination u (fun q => combination v (fun p => y p q) i) j == combination v (fun p => combination u (y p) j) i.
Proof.
  induction u as [|a u IH]; intros i j; cbn [combination].
  - symmetry. apply combination_zero.
  - rewrite IH, <- combination_times, <- combination_sum. reflexivity.
Qed.

Lemma refine_minus s f g i : refine s (fun j => f j - g j) i == refine s f i - refine s g i.
Proof. unfold refine. rewrite combination_minus. ring. Qed.

Lemma refine_swap s r (y : net) i j :
  refine r (fun q => refine s (fun p => y p q) i) j == refine s (fun p => refine r (y p) j) i.
Proof. unfold refine. rewrite !combination_times, combination_swap. ring. Qed.

Lemma level_minus s k f g : forall i, level s k (fun j => f j - g j) i == level s k f i - level s k g i.
Proof.
  induction k as [|k IH]; intros i; [reflexivity|]. cbn [level].
  rewrite <- refine_minus. apply refine_ext. exact IH.
Qed.

Lemma level_swap s r k (y : net) j : forall i,
  refine r (fun q => level s k (fun p => y p q) i) j == level s k (fun p => refine r (y p) j) i.
Proof.
  induction k as [|k IH]; intros i; [reflexivity|]. cbn [level].
  rewrite (refine_swap s r (fun p q => level s k (fun p => y p q) p) i j).
  apply refine_ext. exact IH.
Qed.

Lemma levels_swap s r k m (y : net) i : forall j,
  level r m (fun q => level s k (fun p => y p q) i) j == level s k (fun p => level r m (y p) j) i.
Proof.
  induction m as [|m IH]; intros j; [reflexivity|]. cbn [level].
  rewrite (refine_ext r _ (fun q => level s k (fun p => level r m (y p) q) i)) by exact IH.
  apply (level_swap s r k (fun p => level r m (y p))).
Qed.

(** A net is refined along its first index, and then along its second. *)
Lemma net_level_rows s r k x : forall i j, net_level s r k x i j == level s k (fun p => level r k (x p) j) i.
Proof.
  induction k as [|k IH]; intros i j; [reflexivity|]. cbn [net_level level]. unfold refine_net.
  apply refine_ext. intros a.
  rewrite (refine_ext r _ (fun q => level s k (fun p => level r k (x p) q) a)) by (intros q; apply IH).
  apply (level_swap s r k (fun p => level r k (x p))).
Qed.

Lemma net_level_columns s r k x i j : net_level s r k x i j == level r k (fun q => level s k (fun p => x p q) i) j.
Proof. rewrite net_level_rows. symmetry. apply levels_swap. Qed.

(** * Differences of a net *)

Definition bounds_points (s : scheme) (c : nat) (L : Q) : Prop :=
  forall x b, at_most x b -> at_most (level s c x) (L * b).

Definition bounds_net_differences (s r : scheme) (c : nat) (T : Q) : Prop :=
  forall x b, net_at_most x b -> net_at_most (net_level s r c x) (T * b).

Lemma net_at_most_nonneg x b : net_at_most x b -> 0 <= b.
Proof. intros H. destruct (H 0%Z 0%Z) as [A _]. pose proof (Qabs_nonneg (x (0 + 1)%Z 0%Z - x 0%Z 0%Z)). lra. Qed.

Lemma net_differences s r c T L T' L' C :
  bounds_differences s c T -> bounds_points r c L -> bounds_differences r c T' -> bounds_points s c L' ->
  T * L <= C -> T' * L' <= C -> bounds_net_differences s r c C.
Proof.
  intros D N D' N' LE LE' x b H. pose proof (net_at_most_nonneg x b H) as B. intros i j. split.
  - rewrite !net_level_rows.
    assert (A : at_most (difference (fun p => level r c (x p) j)) (L * b)).
    { intros p. unfold difference. rewrite <- level_minus. apply N. intros q. apply (H p q). }
    pose proof (D _ _ A i) as F. unfold difference in F. eapply Qle_trans; [exact F|].
    rewrite Qmult_assoc. now apply Qmult_le_compat_r.
  - rewrite !net_level_columns.
    assert (A : at_most (difference (fun q => level s c (fun p => x p q) i)) (L' * b)).
    { intros q. unfold difference. rewrite <- level_minus. apply N'. intros p. apply (H p q). }
    pose proof (D' _ _ A j) as F. unfold difference in F. eapply Qle_trans; [exact F|].
    rewrite Qmult_assoc. now apply Qmult_le_compat_r.
Qed.

(** * One step *)

Lemma interpolant_ext x y u : (forall i, x i == y i) -> interpolant x u == interpolant y u.
Proof. intros E. unfold interpolant. now rewrite !E. Qed.

Lemma interpolant_minus x y u : interpolant (fun i => x i - y i) u == interpolant x u - interpolant y u.
Proof. unfold interpolant. ring. Qed.

Lemma interpolant_at_most x b u : at_most x b -> Qabs (interpolant x u) <= b.
Proof.
  intros H. unfold interpolant. set (i := Qfloor u). set (theta := u - inject_Z i).
  assert (0 <= theta /\ theta <= 1) as [T0 T1].
  { pose proof (Qfloor_le u). pose proof (Qlt_floor u). rewrite inject_Z_plus in *.
    change (inject_Z 1) with 1 in *. unfold theta, i. split; lra. }
  rewrite (Qabs_wd _ ((1 - theta) * x i + theta * x (i + 1)%Z)) by ring.
  apply mix; try assumption; apply H.
Qed.

(** A combination of interpolants is the interpolant of combinations. *)
Lemma interpolant_refine s (z : net) v i :
  interpolant (fun j => refine s (fun a => z a j) i) v == refine s (fun a => interpolant (z a) v) i.
Proof.
  unfold interpolant. set (j := Qfloor v). set (theta := v - inject_Z j).
  unfold refine. set (row := nth _ _ _). set (q := (_ + _)%Z).
  assert (E : combination row (fun a => z a j + theta * (z a (j + 1)%Z - z a j)) q ==
    combination row (fun a => z a j) q +
    theta * (combination row (fun a => z a (j + 1)%Z) q - combination row (fun a => z a j) q)).
  { rewrite combination_sum, combination_times, combination_minus. reflexivity. }
  rewrite E. ring.
Qed.

Definition net_factor (s r : scheme) (tau rho L : Q) : Q := displacement s tau * L + displacement r rho.

Theorem net_step_bound s r tau rho L y b t u : affine s -> affine r -> bounds_points r 1 L -> net_at_most y b ->
  Qabs (surface s r tau rho 1 y t u - surface s r tau rho 0 y t u) <= net_factor s r tau rho L * b.
Proof.
  intros A A' N H.
  set (v := inject_Z (arityZ r) * (u - rho) + inject_Z (arityZ r - 1) * rho).
  set (w := inject_Z (arityZ s) * (t - tau) + inject_Z (arityZ s - 1) * tau).
  set (g := fun a => interpolant (refine r (y a)) v). set (h := fun a => interpolant (y a) (u - rho)).
  assert (E1 : surface s r tau rho 1 y t u == interpolant (refine s g) w).
  { unfold surface. rewrite (interpolant_param _ _ w) by apply first_shift.
    apply interpolant_ext. intros i. rewrite (interpolant_param _ _ v) by apply first_shift.
    apply (interpolant_refine s (fun a => refine r (y a)) v i). }
  assert (E0 : surface s r tau rho 0 y t u == interpolant h (t - tau)).
  { unfold surface. rewrite (interpolant_param _ _ (t - tau)) by apply no_shift.
    apply interpolant_ext. intros i. apply interpolant_param, no_shift. }
  rewrite E1, E0.
  rewrite (Qabs_wd _ ((interpolant (refine s g) w - interpolant g (t - tau)) +
    (interpolant g (t - tau) - interpolant h (t - tau)))) by ring.
  eapply Qle_trans; [apply Qabs_triangle|]. unfold net_factor. rewrite Qmult_plus_distr_l.
  apply Qplus_le_compat.
  - rewrite <- Qmult_assoc. apply step_bound; [exact A|]. intros a. unfold difference, g.
    rewrite <- interpolant_minus.
    rewrite (Qabs_wd _ (interpolant (refine r (fun q => y (a + 1)%Z q - y a q)) v)).
    + apply interpolant_at_most. apply (N (fun q => y (a + 1)%Z q - y a q)). intros q. apply (H a q).
    + apply interpolant_ext. intros q. symmetry. apply refine_minus.
  - rewrite <- interpolant_minus. apply interpolant_at_most. intros a. unfold g, h, v.
    apply step_bound; [exact A'|]. intros q. apply (H a q).
Qed.

(** * Levels *)

Lemma net_level_add s r k m x : net_level s r (k + m) x = net_level s r k (net_level s r m x).
Proof. induction k as [|k IH]; [reflexivity|]. simpl. now rewrite IH. Qed.

Lemma surface_add s r tau rho k m x t u : surface s r tau rho (k + m) x t u == surface s r tau rho k
  (net_level s r m x) (inject_Z (arityZ s ^ Z.of_nat m) * t) (inject_Z (arityZ r ^ Z.of_nat m) * u).
Proof.
  unfold surface. rewrite net_level_add.
  rewrite (interpolant_param _ _ (inject_Z (arityZ s ^ Z.of_nat k) * (inject_Z (arityZ s ^ Z.of_nat m) * t) - tau))
    by (rewrite scale_levels; ring).
  apply interpolant_ext. intros i. apply interpolant_param. rewrite scale_levels. ring.
Qed.

Section Block.
  Variables (s r : scheme) (tau rho sigma : Q).
  Hypothesis sigma_nonneg : 0 <= sigma.
  Hypothesis step : forall y b t u, net_at_most y b -> Qabs (surface s r tau rho 1 y t u - surface s r tau rho 0 y t u) <= sigma * b.

  Definition net_block (y : net) (b : Q) (ts : list Q) : Prop :=
    forall i, (i < length ts)%nat -> net_at_most (net_level s r i y) (nth i ts 0 * b).

  Lemma net_within_block ts : nonneg ts -> forall y b t u L, 0 <= b -> net_block y b ts ->
    (L <= length ts)%nat -> Qabs (surface s r tau rho L y t u - surface s r tau rho 0 y t u) <= sigma * total ts * b.
  Proof.
    intros N. induction N as [|t0 ts P N IH]; intros y b t u L Hb H Le.
    - assert (L = O) as -> by (simpl in Le; lia). rewrite (Qabs_wd _ 0) by ring.
      change (Qabs 0) with 0. simpl. lra.
    - pose proof (total_nonneg ts N) as T0. destruct L as [|L].
      + rewrite (Qabs_wd _ 0) by ring. change (Qabs 0) with 0.
        apply Qmult_le_0_compat; [apply Qmult_le_0_compat; simpl; lra | exact Hb].
      + rewrite (Qabs_wd _ ((surface s r tau rho (L + 1) y t u - surface s r tau rho 1 y t u) +
            (surface s r tau rho 1 y t u - surface s r tau rho 0 y t u))) by (rewrite Nat.add_1_r; ring).
        eapply Qle_trans; [apply Qabs_triangle|]. simpl total.
        rewrite (surface_add s r tau rho L 1), (surface_add s r tau rho 0 1 y t u).
        rewrite (Qmult_plus_distr_r sigma), (Qmult_plus_distr_l (sigma * t0)), Qplus_comm.
        apply Qplus_le_compat.
        * rewrite <- Qmult_assoc. rewrite <- (surface_add s r tau rho 0 1 y t u). apply step. apply (H O). simpl. lia.
        * apply IH; [exact Hb | | simpl in Le; lia].
          intros i I. rewrite <- net_level_add. rewrite Nat.add_1_r. apply (H (S i)). simpl. lia.
  Qed.

  Lemma net_all_levels ts q B : nonneg ts -> (0 < length ts)%nat ->
    bounds_net_differences s r (length ts) q -> 0 <= q -> q <= 1 -> 0 <= B ->
    sigma * total ts <= B * (1 - q) ->
    forall fuel L y b t u, (L < fuel)%nat -> 0 <= b -> net_block y b ts ->
    Qabs (surface s r tau rho L y t u - surface s r tau rho 0 y t u) <= B * b.
  Proof.
    intros N C D Q0 Q1 B0 E. induction fuel as [|fuel IH]; intros L y b t u F Hb H; [lia|].
    set (c := length ts) in *.
    destruct (Nat.le_gt_cases L c) as [G|G].
    - eapply Qle_trans; [apply (net_within_block ts); eassumption|].
      apply Qmult_le_compat_r; [|exact Hb]. eapply Qle_trans; [exact E|]. nra.
    - assert (X : (L = (L - c) + c)%nat) by lia.
      rewrite (Qabs_wd _ ((surface s r tau rho ((L - c) + c) y t u - surface s r tau rho c y t u) +
          (surface s r tau rho c y t u - surface s r tau rho 0 y t u))) by (rewrite <- X; ring).
      eapply Qle_trans; [apply Qabs_triangle|].
      pose proof (net_within_block ts N y b t u c Hb H (le_n c)) as I2.
      assert (H' : net_block (net_level s r c y) (q * b) ts).
      { intros i I. rewrite <- net_level_add, Nat.add_comm, net_level_add.
        pose proof (D _ _ (H i I)) as K. intros j j'. destruct (K j j') as [K1 K2].
        assert (W : q * (nth i ts 0 * b) == nth i ts 0 * (q * b)) by ring.
        split; (eapply Qle_trans; [eassumption|]); rewrite W; apply Qle_refl. }
      pose proof (IH (L - c)%nat (net_level s r c y) (q * b) (inject_Z (arityZ s ^ Z.of_nat c) * t)
        (inject_Z (arityZ r ^ Z.of_nat c) * u) ltac:(lia) ltac:(apply Qmult_le_0_compat; assumption) H') as I1.
      rewrite <- (surface_add s r tau rho (L - c) c), <- (surface_add s r tau rho 0 c) in I1.
      assert (I3 : sigma * total ts * b <= B * (1 - q) * b) by (apply Qmult_le_compat_r; assumption).
      eapply Qle_trans; [apply Qplus_le_compat; [exact I1 | eapply Qle_trans; [exact I2 | exact I3]]|].
      apply Qle_lteq. right. ring.
  Qed.

  Theorem net_distance_bound k ts q B : nonneg ts -> (0 < length ts)%nat ->
    bounds_net_differences s r (length ts) q -> 0 <= q -> q <= 1 -> 0 <= B ->
    (forall i, (i < length ts)%nat -> bounds_net_differences s r (i + k) (nth i ts 0)) ->
    sigma * total ts <= B * (1 - q) -> bounds_net_distance s r tau rho k B.
  Proof.
    intros N C D Q0 Q1 B0 U E x b t u l H L.
    assert (X : (l = (l - k) + k)%nat) by lia. rewrite X.
    rewrite (surface_add s r tau rho (l - k) k), (surface_add s r tau rho 0 k).
    apply (net_all_levels ts q B N C D Q0 Q1 B0 E (S (l - k))); [lia | eapply net_at_most_nonneg, H |].
    intros i I. rewrite <- net_level_add. apply U; assumption.
  Qed.
End Block.

(** * A bound by one computation *)

Definition larger (p q : Q) : Q := if Qle_bool p q then q else p.

Lemma larger_left p q : p <= larger p q.
Proof. unfold larger. destruct (Qle_bool p q) eqn:E; [now apply Qle_bool_iff | apply Qle_refl]. Qed.

Lemma larger_right p q : q <= larger p q.
Proof.
  unfold larger. destruct (Qle_bool p q) eqn:E; [apply Qle_refl|]. apply Qlt_le_weak, Qnot_le_lt.
  intros F. apply Qle_bool_iff in F. rewrite F in E. discriminate.
Qed.

Lemma norm_bounds s c : affine s -> bounds_points s c (norm s c).
Proof. intros A x b H i. rewrite <- combination_one. apply tree_bounds; [apply A | exact H]. Qed.

(** max (T_c Λ_c, Λ_c T_c): no difference of level c is larger, if those of level 0 are at most 1. *)
Definition net_constant (s r : scheme) (c : nat) : Q :=
  Qred (larger (contraction s c * norm r c) (contraction r c * norm s c)).

Theorem net_constant_bounds s r c : affine s -> affine r -> bounds_net_differences s r c (net_constant s r c).
Proof.
  intros A A'. unfold net_constant.
  eapply net_differences; [apply contraction_bounds, A | apply norm_bounds, A' | apply contraction_bounds, A' |
    apply norm_bounds, A | |]; rewrite Qred_correct; [apply larger_left | apply larger_right].
Qed.

Lemma net_zero s r : bounds_net_differences s r 0 1.
Proof. intros x b H i j. rewrite Qmult_1_l. apply H. Qed.

Lemma net_times s r c d T U : bounds_net_differences s r c T -> bounds_net_differences s r d U ->
  bounds_net_differences s r (c + d) (T * U).
Proof.
  intros H G x b B. rewrite net_level_add. intros i j. rewrite <- !Qmult_assoc. exact (H _ _ (G _ _ B) i j).
Qed.

Lemma net_wd s r c T U : T == U -> bounds_net_differences s r c T -> bounds_net_differences s r c U.
Proof. intros E H x b B i j. rewrite <- !E. exact (H x b B i j). Qed.

(** C_c^j C_i bounds level cj + i. *)
Fixpoint net_upper (s r : scheme) (c j i : nat) : Q :=
  match j with
  | O => match i with O => 1 | _ => net_constant s r i end
  | S j => Qred (net_constant s r c * net_upper s r c j i)
  end.

Lemma net_upper_bounds s r c j i : affine s -> affine r -> bounds_net_differences s r (j * c + i) (net_upper s r c j i).
Proof.
  intros A A'. induction j as [|j IH]; cbn [net_upper Nat.mul Nat.add].
  - destruct i; [apply net_zero | now apply net_constant_bounds].
  - eapply net_wd; [symmetry; apply Qred_correct|]. rewrite <- Nat.add_assoc.
    apply net_times; [now apply net_constant_bounds | exact IH].
Qed.

Definition net_distance_bounded (s r : scheme) (tau rho : Q) (c k : nat) (B : Q) : bool :=
  let q := net_constant s r c in
  let ts := map (fun i => net_upper s r c ((i + k) / c) ((i + k) mod c)) (seq 0 c) in
  is_affine s && is_affine r && Nat.ltb 0 c && forallb (fun t => Qle_bool 0 t) ts &&
  Qle_bool 0 q && Qle_bool q 1 && Qle_bool 0 B && Qle_bool 0 (norm r 1) &&
  Qle_bool (net_factor s r tau rho (norm r 1) * total ts) (B * (1 - q)).

Theorem bounds_net_distance_by s r tau rho c k B : net_distance_bounded s r tau rho c k B = true -> bounds_net_distance s r tau rho k B.
Proof.
  unfold net_distance_bounded. intros H. conditions H.
  apply is_affine_correct in H, G6. apply Nat.ltb_lt in G5. rewrite Qle_bool_iff in *.
  set (ts := map _ _) in *.
  assert (LEN : length ts = c) by (unfold ts; now rewrite map_length, seq_length).
  apply (net_distance_bound s r tau rho (net_factor s r tau rho (norm r 1))) with (ts := ts) (q := net_constant s r c); try assumption.
  - unfold net_factor. pose proof (displacement_nonneg s tau). pose proof (displacement_nonneg r rho).
    assert (0 <= displacement s tau * norm r 1) by (apply Qmult_le_0_compat; assumption). lra.
  - intros y b t u N. apply net_step_bound; try assumption. now apply norm_bounds.
  - apply Forall_forall. rewrite forallb_forall in G4. intros t I. apply Qle_bool_iff, G4, I.
  - now rewrite LEN.
  - rewrite LEN. now apply net_constant_bounds.
  - intros i I. rewrite LEN in I. unfold ts.
    rewrite (nth_indep _ 0 (net_upper s r c ((0 + k) / c) ((0 + k) mod c))) by (now rewrite map_length, seq_length).
    rewrite (map_nth (fun i => net_upper s r c ((i + k) / c) ((i + k) mod c)) (seq 0 c) 0%nat), seq_nth by exact I.
    rewrite Nat.add_0_l. pose proof (Nat.div_mod (i + k) c ltac:(lia)) as E.
    rewrite E at 1. rewrite (Nat.mul_comm c). now apply net_upper_bounds.
Qed.

Theorem net_distance_refuted s r tau rho k b B : exceeds_net_distance s r tau rho k b (B * b) -> ~ bounds_net_distance s r tau rho k B.
Proof.
  intros (x & t & u & l & margin & X & P & E) H.
  pose proof (E (max l k) ltac:(lia)) as A. pose proof (H x b t u (max l k) X ltac:(lia)) as D. lra.
Qed.
