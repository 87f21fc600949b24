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

(** * The displacement *)

(** n·d times the distance of a new point to the polygon before, as a combination of points from [start] on. *)
Definition displacement_row (s : scheme) (r : nat) : list Z :=
  add (repeat 0%Z (Z.to_nat (offset s)) ++ scale (arityZ s) (nth r (rules s) []))
    (repeat 0%Z (Z.to_nat (- offset s)) ++
      scale (- Zpos (denominator s)) [(arityZ s - Z.of_nat r)%Z; Z.of_nat r]).

Definition displacement (s : scheme) : Q :=
  greatest (map (fun r => norm1 (parts (displacement_row s r))) (seq 0 (arity s)))
    # (Pos.of_nat (arity s) * denominator s).

Lemma sum_zeros k u : sum (repeat 0%Z k ++ u) = sum u.
Proof. induction k; [reflexivity|]. change (sum (0%Z :: (repeat 0%Z k ++ u)) = sum u). simpl. exact IHk. Qed.

Lemma displacement_row_sum s r : affine s -> (r < arity s)%nat -> sum (displacement_row s r) = 0%Z.
Proof.
  intros A L. unfold displacement_row. rewrite sum_add, !sum_zeros, !sum_scale, rule_sum by assumption.
  unfold sum. simpl. lia.
Qed.

Definition deviation (s : scheme) (y : points) (q : Z) (r : nat) : Q :=
  refine s y (arityZ s * q + Z.of_nat r)%Z - (y q + (Z.of_nat r # Pos.of_nat (arity s)) * (y (q + 1)%Z - y q)).

Lemma over_arity s r : affine s -> inject_Z (arityZ s) * (r # Pos.of_nat (arity s)) == inject_Z r.
Proof.
  intros [L _]. unfold Qeq, inject_Z, arityZ. simpl.
  replace (Zpos (Pos.of_nat (arity s))) with (Z.of_nat (arity s)) by lia. lia.
Qed.

Lemma deviation_row s y q r : affine s -> (r < arity s)%nat ->
  deviation s y q r ==
  (1 # (Pos.of_nat (arity s) * denominator s)) *
    combination (displacement_row s r) y (q + Z.min 0 (offset s)).
Proof.
  intros A L. pose proof (proj1 A) as two. unfold deviation. rewrite refine_at by lia.
  unfold displacement_row.
  rewrite combination_add, !combination_zeros, !combination_scale.
  replace (q + Z.min 0 (offset s) + Z.of_nat (Z.to_nat (offset s)))%Z with (q + offset s)%Z by lia.
  replace (q + Z.min 0 (offset s) + Z.of_nat (Z.to_nat (- offset s)))%Z with q by lia.
  cbn [combination]. rewrite inject_Z_opp.
  set (X := combination (nth r (rules s) []) y (q + offset s)).
  pose proof (over_arity s (Z.of_nat r) A) as R. pose proof (over_arity s 1 A) as O.
  change (inject_Z 1) with 1 in O.
  set (n := inject_Z (arityZ s)) in *.
  assert (D : (1 # denominator s) * inject_Z (Zpos (denominator s)) == 1).
  { unfold Qeq, Qmult, inject_Z. simpl. lia. }
  set (d := inject_Z (Zpos (denominator s))) in *.
  assert (P : (1 # (Pos.of_nat (arity s) * denominator s)) == (1 # Pos.of_nat (arity s)) * (1 # denominator s))
    by reflexivity.
  rewrite P. clear P.
  assert (Rr : (Z.of_nat r # Pos.of_nat (arity s)) == inject_Z (Z.of_nat r) * (1 # Pos.of_nat (arity s))).
  { unfold Qeq, Qmult, inject_Z. simpl. lia. }
  rewrite Rr. unfold Zminus. rewrite inject_Z_plus, inject_Z_opp. fold n.
  set (w := 1 # Pos.of_nat (arity s)) in *. set (e := 1 # denominator s) in *. set (k := inject_Z (Z.of_nat r)) in *.
  transitivity ((n * w) * (e * X) - (e * d) * ((n * w) * y q - w * k * y q + w * k * y (q + 1)%Z)).
  - rewrite O, D. ring.
  - ring.
Qed.

Lemma deviation_bound s y b q r : affine s -> (r < arity s)%nat -> at_most (difference y) b ->
  Qabs (deviation s y q r) <= displacement s * b.
Proof.
  intros A L H. rewrite deviation_row, by_parts_zero by (try apply displacement_row_sum; assumption).
  rewrite Qabs_Qmult. change (Qabs (1 # ?d)) with (1 # d).
  eapply Qle_trans; [apply Qmult_le_l'; [discriminate | apply combination_bound, H]|].
  rewrite Qmult_assoc. apply Qmult_le_compat_r; [|eapply at_most_nonneg, H].
  unfold displacement. unfold Qle, Qmult, inject_Z. cbn -[Z.mul Pos.mul Pos.of_nat seq].
  assert (norm1 (parts (displacement_row s r)) <=
    greatest (map (fun r => norm1 (parts (displacement_row s r))) (seq 0 (arity s))))%Z
    by (apply (greatest_ge (fun r => norm1 (parts (displacement_row s r)))); lia).
  rewrite Pos.mul_1_r, Z.mul_1_l. apply Z.mul_le_mono_nonneg_r; [lia | assumption].
Qed.

(** * One step *)

Lemma mix a b theta B : 0 <= theta -> theta <= 1 -> Qabs a <= B -> Qabs b <= B ->
  Qabs ((1 - theta) * a + theta * b) <= B.
Proof.
  intros L H. rewrite !Qabs_Qle_condition. intros [? ?] [? ?]. split; nra.
Qed.

Theorem step_bound s y b u : affine s -> at_most (difference y) b ->
  Qabs (interpolant (refine s y) (inject_Z (arityZ s) * u) - interpolant y u) <= displacement s * b.
Proof.
  intros A H. pose proof (proj1 A) as two.
  set (v := inject_Z (arityZ s) * u). set (j := Qfloor v).
  destruct (place s two j) as (q & r & L & E).
  set (theta := v - inject_Z j).
  assert (T : 0 <= theta /\ theta <= 1).
  { pose proof (Qfloor_le v). pose proof (Qlt_floor v). rewrite inject_Z_plus in *.
    change (inject_Z 1) with 1 in *. unfold theta, j. split; lra. }
  set (w := 1 # Pos.of_nat (arity s)).
  assert (W : inject_Z (arityZ s) * w == 1) by (apply (over_arity s 1 A)).
  assert (U : u == inject_Z q + w * (inject_Z (Z.of_nat r) + theta)).
  { unfold theta. rewrite E, inject_Z_plus, inject_Z_mult. unfold v.
    transitivity ((inject_Z (arityZ s) * w) * u + (1 - inject_Z (arityZ s) * w) * inject_Z q); [rewrite W; ring|ring]. }
  assert (Wp : 0 < w) by (unfold w; reflexivity).
  assert (Rn : inject_Z (Z.of_nat r) + 1 <= inject_Z (arityZ s)).
  { change 1 with (inject_Z 1). rewrite <- inject_Z_plus, <- Zle_Qle. unfold arityZ. lia. }
  assert (R0 : 0 <= inject_Z (Z.of_nat r)) by (apply inject_Z_nonneg; lia).
  rewrite (interpolant_between y q u).
  2:{ rewrite U. assert (0 <= w * (inject_Z (Z.of_nat r) + theta)) by (apply Qmult_le_0_compat; lra). lra. }
  2:{ rewrite U. assert (w * (inject_Z (Z.of_nat r) + theta) <= w * inject_Z (arityZ s))
        by (apply Qmult_le_l'; lra). lra. }
  unfold interpolant. fold j. fold theta.
  assert (Rw : (Z.of_nat r # Pos.of_nat (arity s)) == inject_Z (Z.of_nat r) * w).
  { unfold Qeq, Qmult, inject_Z, w. simpl. lia. }
  destruct T as [T0 T1].
  assert (D1 : Qabs (refine s y j - (y q + inject_Z (Z.of_nat r) * w * (y (q + 1)%Z - y q))) <= displacement s * b).
  { rewrite <- Rw, E. apply (deviation_bound s y b q r); assumption. }
  assert (D2 : Qabs (refine s y (j + 1)%Z - (y q + (inject_Z (Z.of_nat r) + 1) * w * (y (q + 1)%Z - y q)))
      <= displacement s * b).
  { destruct (Nat.eq_dec (S r) (arity s)) as [F|F].
    - assert (G : inject_Z (Z.of_nat r) + 1 == inject_Z (arityZ s)).
      { change 1 with (inject_Z 1). rewrite <- inject_Z_plus. unfold arityZ. now replace (Z.of_nat r + 1)%Z with (Z.of_nat (arity s)) by lia. }
      rewrite G, W.
      replace (j + 1)%Z with (arityZ s * (q + 1) + Z.of_nat 0)%Z by (unfold arityZ in *; lia).
      pose proof (deviation_bound s y b (q + 1) 0 A ltac:(lia) H) as V. unfold deviation in V.
      eapply Qle_trans; [|exact V]. apply Qle_lteq. right. apply Qabs_wd.
      assert (Z0 : (Z.of_nat 0 # Pos.of_nat (arity s)) == 0) by reflexivity. rewrite Z0. ring.
    - assert (G : (Z.of_nat (S r) # Pos.of_nat (arity s)) == (inject_Z (Z.of_nat r) + 1) * w).
      { change 1 with (inject_Z 1). rewrite <- inject_Z_plus. unfold Qeq, Qmult, inject_Z, w. simpl. lia. }
      rewrite <- G. replace (j + 1)%Z with (arityZ s * q + Z.of_nat (S r))%Z by lia.
      apply (deviation_bound s y b q (S r)); [assumption|lia|assumption]. }
  pose proof (mix _ _ theta _ T0 T1 D1 D2) as M. eapply Qle_trans; [|exact M]. apply Qle_lteq. right. apply Qabs_wd.
  rewrite U at 1. ring.
Qed.

(** * Levels *)

Lemma level_add s k m x : level s (k + m) x = level s k (level s m x).
Proof. induction k as [|k IH]; [reflexivity|]. simpl. now rewrite IH. Qed.

Lemma scale_levels s k m : inject_Z (arityZ s ^ Z.of_nat (k + m)) ==
  inject_Z (arityZ s ^ Z.of_nat k) * inject_Z (arityZ s ^ Z.of_nat m).
Proof. rewrite <- inject_Z_mult, Nat2Z.inj_add, Z.pow_add_r by lia. reflexivity. Qed.

Lemma polygon_add s k m x t :
  polygon s (k + m) x t == polygon s k (level s m x) (inject_Z (arityZ s ^ Z.of_nat m) * t).
Proof. unfold polygon. rewrite level_add. apply interpolant_param. rewrite scale_levels. ring. Qed.

Lemma polygon_from s m x t :
  polygon s m x t == polygon s 0 (level s m x) (inject_Z (arityZ s ^ Z.of_nat m) * t).
Proof. exact (polygon_add s 0 m x t). Qed.

Lemma polygon_step s y b t : affine s -> at_most (difference y) b ->
  Qabs (polygon s 1 y t - polygon s 0 y t) <= displacement s * b.
Proof.
  intros A H. unfold polygon. cbn [level].
  rewrite (interpolant_param _ (inject_Z (arityZ s ^ Z.of_nat 1) * t) (inject_Z (arityZ s) * t))
    by (change (Z.of_nat 1) with 1%Z; rewrite Z.pow_1_r; reflexivity).
  rewrite (interpolant_param _ (inject_Z (arityZ s ^ Z.of_nat 0) * t) t)
    by (change (arityZ s ^ Z.of_nat 0)%Z with 1%Z; change (inject_Z 1) with 1; ring).
  now apply step_bound.
Qed.

Lemma bounds_step_by s k T : affine s -> bounds_differences s k T -> bounds_step s k (displacement s * T).
Proof.
  intros A H x b t B. change (S k) with (1 + k)%nat. rewrite (polygon_add s 1 k), (polygon_from s k).
  rewrite <- Qmult_assoc. apply polygon_step; [exact A | apply H, B].
Qed.

(** * A block of levels *)

Definition total (ts : list Q) : Q := fold_right Qplus 0 ts.

Definition nonneg (ts : list Q) : Prop := Forall (fun t => 0 <= t) ts.

Definition block (s : scheme) (y : points) (b : Q) (ts : list Q) : Prop :=
  forall i, (i < length ts)%nat -> at_most (difference (level s i y)) (nth i ts 0 * b).

Lemma displacement_nonneg s : 0 <= displacement s.
Proof.
  unfold displacement, Qle. simpl. rewrite Z.mul_1_r.
  induction (map _ _); simpl; lia.
Qed.

Lemma total_nonneg ts : nonneg ts -> 0 <= total ts.
Proof. induction 1; simpl; lra. Qed.

Lemma within_block s ts : affine s -> nonneg ts -> forall y b t L, 0 <= b -> block s y b ts ->
  (L <= length ts)%nat -> Qabs (polygon s L y t - polygon s 0 y t) <= displacement s * total ts * b.
Proof.
  intros A N. induction N as [|t0 ts P N IH]; intros y b t L Hb H Le.
  - assert (L = O) as -> by (simpl in Le; lia). rewrite (Qabs_wd _ 0) by ring.
    change (Qabs 0) with 0. simpl. lra.
  - pose proof (displacement_nonneg s) as S0. pose proof (total_nonneg ts N) as T0.
    destruct L as [|L].
    + rewrite (Qabs_wd _ 0) by ring. change (Qabs 0) with 0.
      apply Qmult_le_0_compat; [apply Qmult_le_0_compat; simpl; lra | exact Hb].
    + rewrite (Qabs_wd _ ((polygon s (L + 1) y t - polygon s 1 y t) + (polygon s 1 y t - polygon s 0 y t)))
        by (rewrite Nat.add_1_r; ring).
      eapply Qle_trans; [apply Qabs_triangle|]. simpl total.
      rewrite (polygon_add s L 1).
      rewrite (Qmult_plus_distr_r (displacement s)), (Qmult_plus_distr_l (displacement s * t0)), Qplus_comm.
      apply Qplus_le_compat.
      * rewrite <- Qmult_assoc. apply polygon_step; [exact A|]. apply (H O). simpl. lia.
      * rewrite (polygon_from s 1). apply IH; [exact Hb | | simpl in Le; lia].
        intros i I. rewrite <- level_add. rewrite Nat.add_1_r. apply (H (S i)). simpl. lia.
Qed.

(** All levels: one power of q pays for the levels of one block. *)
Lemma all_levels s ts q B : affine s -> nonneg ts -> (0 < length ts)%nat ->
  bounds_differences s (length ts) q -> 0 <= q -> q <= 1 -> 0 <= B ->
  displacement s * total ts <= B * (1 - q) ->
  forall fuel L y b t, (L < fuel)%nat -> 0 <= b -> block s y b ts ->
  Qabs (polygon s L y t - polygon s 0 y t) <= B * b.
Proof.
  intros A N C D Q0 Q1 B0 E. induction fuel as [|fuel IH]; intros L y b t F Hb H; [lia|].
  set (c := length ts) in *.
  destruct (Nat.le_gt_cases L c) as [G|G].
  - eapply Qle_trans; [apply (within_block s ts); eassumption|].
    apply Qmult_le_compat_r; [|exact Hb]. eapply Qle_trans; [exact E|]. nra.
  - assert (X : (L = (L - c) + c)%nat) by lia.
    rewrite (Qabs_wd _ ((polygon s ((L - c) + c) y t - polygon s c y t) + (polygon s c y t - polygon s 0 y t)))
      by (rewrite <- X; ring).
    eapply Qle_trans; [apply Qabs_triangle|].
    rewrite (polygon_add s (L - c) c).
    assert (H' : block s (level s c y) (q * b) ts).
    { intros i I j. rewrite <- level_add, Nat.add_comm, level_add.
      setoid_replace (nth i ts 0 * (q * b)) with (q * (nth i ts 0 * b)) by ring.
      apply D. apply H. exact I. }
    pose proof (IH (L - c)%nat (level s c y) (q * b) (inject_Z (arityZ s ^ Z.of_nat c) * t) ltac:(lia)
      ltac:(apply Qmult_le_0_compat; assumption) H') as I1.
    rewrite <- (polygon_from s c) in I1.
    pose proof (within_block s ts A N y b t c Hb H (le_n c)) as I2.
    assert (I3 : displacement s * total ts * b <= B * (1 - q) * b) by (apply Qmult_le_compat_r; assumption).
    eapply Qle_trans; [apply Qplus_le_compat; [exact I1 | eapply Qle_trans; [exact I2 | exact I3]]|].
    apply Qle_lteq. right. ring.
Qed.

(** The differences of the c levels k, …, k + c - 1. *)
Definition bounded_from (s : scheme) (k : nat) (ts : list Q) : Prop :=
  forall i, (i < length ts)%nat -> bounds_differences s (i + k) (nth i ts 0).

Theorem distance_bound s k ts q B : affine s -> nonneg ts -> (0 < length ts)%nat ->
  bounds_differences s (length ts) q -> 0 <= q -> q <= 1 -> 0 <= B ->
  bounded_from s k ts -> displacement s * total ts <= B * (1 - q) -> bounds_distance s k B.
Proof.
  intros A N C D Q0 Q1 B0 U E x b t l H L.
  assert (X : (l = (l - k) + k)%nat) by lia. rewrite X.
  rewrite (polygon_add s (l - k) k), (polygon_from s k).
  apply (all_levels s ts q B A N C D Q0 Q1 B0 E (S (l - k))); [lia | eapply at_most_nonneg, H |].
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

Definition distance_bounded (s : scheme) (M c k : nat) (B : Q) : bool :=
  let us := uppers s M (k + c) in
  let ts := firstn c (skipn k us) in
  let q := Qred (contraction s c) in
  is_affine s && Nat.eqb (length ts) c && Nat.ltb 0 c && Nat.leb (k + c) (length us) &&
  forallb (fun t => Qle_bool 0 t) ts &&
  Qle_bool 0 q && Qle_bool q 1 && Qle_bool 0 B && Qle_bool (displacement s * total ts) (B * (1 - q)).

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

Theorem bounds_distance_by s M c k B : distance_bounded s M c k B = true -> bounds_distance s k B.
Proof.
  unfold distance_bounded. intros H.
  repeat match type of H with (_ && _)%bool = true =>
    apply andb_prop in H; let G := fresh "G" in destruct H as [H G] end.
  apply is_affine_correct in H. apply Nat.eqb_eq in G6. apply Nat.ltb_lt in G5. apply Nat.leb_le in G4.
  rewrite Qle_bool_iff in *.
  apply (distance_bound s k (block_from s M c k) (Qred (contraction s c)) B); unfold block_from; try assumption.
  - apply Forall_forall. rewrite forallb_forall in G3. intros t I. apply Qle_bool_iff, G3, I.
  - lia.
  - rewrite G6. eapply bounds_wd; [symmetry; apply Qred_correct|]. now apply contraction_bounds.
  - now apply window_bounded.
Qed.
