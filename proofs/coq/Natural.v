(** The natural parameters of the points, of schemes that take lines to lines (THEOREMS.md, 80). *)

Require Import ZArith QArith Qround Qabs List Lia Lqa.
From Subcert Require Import Definitions Core Error.
Import ListNotations.
Local Open Scope Q_scope.

(** The points i + tau of a line. *)
Definition line (tau : Q) : points := fun i => inject_Z i + tau.

(** x_i = i + tau is refined to (i + tau)/n: tau is the natural shift. *)
Definition keeps_lines (s : scheme) (tau : Q) : Prop :=
  forall m, inject_Z (arityZ s) * refine s (line tau) m == line tau m.

Lemma combination_line u tau i q :
  combination u (line tau) (i + q) == combination u (line tau) i + inject_Z (sum u) * inject_Z q.
Proof.
  revert i. induction u as [|a u IH]; intros i.
  - simpl. change (inject_Z 0) with 0. ring.
  - change (sum (a :: u)) with (a + sum u)%Z. cbn [combination]. unfold line at 1 3.
    replace (i + q + 1)%Z with (i + 1 + q)%Z by lia. rewrite IH, !inject_Z_plus. ring.
Qed.

(** It is enough that the first n points are those of the line. *)
Lemma keeps_lines_first s tau : affine s ->
  (forall r, (r < arity s)%nat -> inject_Z (arityZ s) * refine s (line tau) (Z.of_nat r) == line tau (Z.of_nat r)) ->
  keeps_lines s tau.
Proof.
  intros A H m. pose proof (proj1 A) as two. destruct (place s two m) as (q & r & L & ->).
  specialize (H r L). assert (Z0 : (Z.of_nat r = arityZ s * 0 + Z.of_nat r)%Z) by lia. rewrite Z0 in H at 1. clear Z0.
  rewrite refine_at in H by lia. rewrite refine_at by lia.
  replace (q + offset s)%Z with (0 + offset s + q)%Z by lia.
  rewrite combination_line, (rule_sum s r A L). unfold line in *.
  rewrite inject_Z_plus, inject_Z_mult. pose proof (over_unit (denominator s)) as D.
  set (d := inject_Z (Zpos (denominator s))) in *. set (e := 1 # denominator s) in *.
  transitivity (inject_Z (arityZ s) * (e * combination (nth r (rules s) []) (fun i => inject_Z i + tau) (0 + offset s)) +
    inject_Z (arityZ s) * (d * e) * inject_Z q); [ring|]. rewrite H, D. ring.
Qed.

Definition lines_kept (s : scheme) (tau : Q) : bool :=
  is_affine s && forallb (fun r => Qeq_bool (inject_Z (arityZ s) * refine s (line tau) (Z.of_nat r)) (line tau (Z.of_nat r)))
    (seq 0 (arity s)).

Theorem keeps_lines_by s tau : lines_kept s tau = true -> keeps_lines s tau.
Proof.
  unfold lines_kept. intros H. apply andb_prop in H. destruct H as [A H]. apply is_affine_correct in A.
  apply keeps_lines_first; [exact A|]. intros r L. rewrite forallb_forall in H. apply Qeq_bool_eq, H, in_seq. lia.
Qed.

Lemma refine_scaled s c x y : (forall i, c * x i == y i) -> forall m, c * refine s x m == refine s y m.
Proof.
  intros H m. unfold refine. generalize (nth (Z.to_nat (m mod arityZ s)) (rules s) []) (m / arityZ s + offset s)%Z.
  intros u. assert (E : forall j, c * combination u x j == combination u y j).
  { induction u as [|a u IH]; intros j; cbn [combination]; [ring|]. rewrite <- IH, <- H. ring. }
  intros z. rewrite <- E. ring.
Qed.

(** The points of level k are (i + tau)/n^k. *)
Theorem line_level s tau k : keeps_lines s tau -> forall m,
  inject_Z (arityZ s ^ Z.of_nat k) * level s k (line tau) m == line tau m.
Proof.
  intros H. induction k as [|k IH]; intros m.
  - change (arityZ s ^ Z.of_nat 0)%Z with 1%Z. change (inject_Z 1) with 1. cbn [level]. ring.
  - cbn [level]. rewrite Nat2Z.inj_succ, Z.pow_succ_r by lia. rewrite inject_Z_mult, <- Qmult_assoc.
    rewrite (refine_scaled s _ _ _ IH). apply H.
Qed.

(** Of a line, the polygon is the line itself, if the points are at their natural parameters, and (tau - sigma)/n^k off
    at the shift sigma: at most one shift is natural. *)
Theorem line_polygon s sigma tau k t : keeps_lines s tau ->
  inject_Z (arityZ s ^ Z.of_nat k) * polygon s sigma k (line tau) t ==
    inject_Z (arityZ s ^ Z.of_nat k) * t + (tau - sigma).
Proof.
  intros H. unfold polygon. set (N := inject_Z (arityZ s ^ Z.of_nat k)). set (u := N * t - sigma).
  unfold interpolant. set (i := Qfloor u).
  pose proof (line_level s tau k H i) as E. pose proof (line_level s tau k H (i + 1)%Z) as F. fold N in E, F.
  set (x := level s k (line tau)) in *. unfold line in E, F. rewrite inject_Z_plus in F. change (inject_Z 1) with 1 in F.
  transitivity (N * x i + (u - inject_Z i) * (N * x (i + 1)%Z - N * x i)); [ring|]. rewrite E, F. unfold u. ring.
Qed.

(** * Another shift *)

Lemma abs_scaled c z b : 0 <= c -> Qabs z <= b -> Qabs (c * z) <= c * b.
Proof. intros C Z. rewrite Qabs_Qmult, (Qabs_pos c) by exact C. now apply Qmult_le_l'. Qed.

(** The interpolant from one integer on: its steps are differences. *)
Lemma interpolant_steps x b i k : at_most (difference x) b ->
  Qabs (x (i + Z.of_nat k)%Z - x i) <= inject_Z (Z.of_nat k) * b.
Proof.
  intros H. induction k as [|k IH].
  - replace (i + Z.of_nat 0)%Z with i by lia. rewrite (Qabs_wd _ 0) by ring. change (Qabs 0) with 0.
    change (inject_Z (Z.of_nat 0)) with 0. lra.
  - rewrite (Qabs_wd _ (difference x (i + Z.of_nat k)%Z + (x (i + Z.of_nat k)%Z - x i))).
    + eapply Qle_trans; [apply Qabs_triangle|]. rewrite Nat2Z.inj_succ, <- Z.add_1_l, inject_Z_plus.
      change (inject_Z 1) with 1. specialize (H (i + Z.of_nat k)%Z). lra.
    + unfold difference. replace (i + Z.of_nat k + 1)%Z with (i + Z.of_nat (S k))%Z by lia. ring.
Qed.

Lemma interpolant_slope x b u v : at_most (difference x) b -> u <= v ->
  Qabs (interpolant x v - interpolant x u) <= (v - u) * b.
Proof.
  intros H L. pose proof (at_most_nonneg _ _ H) as B0.
  pose proof (Qfloor_le u) as U. pose proof (Qlt_floor u) as U'.
  pose proof (Qfloor_le v) as V. pose proof (Qlt_floor v) as V'.
  pose proof (Qfloor_resp_le u v L) as M. unfold interpolant.
  set (i := Qfloor u) in *. set (j := Qfloor v) in *. rewrite inject_Z_plus in U', V'. change (inject_Z 1) with 1 in U', V'.
  destruct (Z.eq_dec i j) as [<-|N].
  - rewrite (Qabs_wd _ ((v - u) * difference x i)) by (unfold difference; ring).
    apply abs_scaled; [lra | apply H].
  - assert (K : (j = i + 1 + Z.of_nat (Z.to_nat (j - i - 1)))%Z) by lia.
    rewrite (Qabs_wd _ ((v - inject_Z j) * difference x j + ((x j - x (i + 1)%Z) + (1 - (u - inject_Z i)) * difference x i)))
      by (unfold difference; ring).
    pose proof (interpolant_steps x b (i + 1) (Z.to_nat (j - i - 1)) H) as S. rewrite <- K in S.
    replace (Z.of_nat (Z.to_nat (j - i - 1))) with (j - i - 1)%Z in S by lia.
    unfold Z.sub in S. rewrite !inject_Z_plus, !inject_Z_opp in S. change (inject_Z 1) with 1 in S.
    eapply Qle_trans; [apply Qabs_triangle|]. eapply Qle_trans; [apply Qplus_le_r, Qabs_triangle|].
    pose proof (abs_scaled (v - inject_Z j) _ b ltac:(lra) (H j)) as X.
    pose proof (abs_scaled (1 - (u - inject_Z i)) _ b ltac:(lra) (H i)) as Y. lra.
Qed.

(** The shift moves polygons by |sigma - tau| times the largest difference of their level, which tends to 0 where they
    converge: the limit does not depend on the shift. *)
Theorem shift_moves s sigma tau k x b t : at_most (difference (level s k x)) b ->
  Qabs (polygon s sigma k x t - polygon s tau k x t) <= Qabs (sigma - tau) * b.
Proof.
  intros H. unfold polygon. set (N := inject_Z (arityZ s ^ Z.of_nat k)). set (y := level s k x) in *.
  destruct (Qlt_le_dec sigma tau) as [L|L].
  - rewrite (Qabs_neg (sigma - tau)) by lra. eapply Qle_trans; [apply (interpolant_slope y b); [exact H | lra]|]. lra.
  - rewrite (Qabs_pos (sigma - tau)) by lra. rewrite Qabs_Qminus.
    eapply Qle_trans; [apply (interpolant_slope y b); [exact H | lra]|]. lra.
Qed.
