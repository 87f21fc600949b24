(** Rings: promised bounds refuted by explicit points; the limit of a ring. *)

Require Import ZArith QArith Qabs List Lia Lqa Bool.
From Subcert Require Import Definitions Core Error Refutation.
Import ListNotations.
Local Open Scope Q_scope.

(** * Sums *)

Lemma dot_add u : forall v x, dot (add u v) x == dot u x + dot v x.
Proof.
  induction u as [|a u IH]; intros [|b v] [|y x]; simpl; try ring.
  rewrite IH, inject_Z_plus. ring.
Qed.

Lemma dot_scale c u : forall x, dot (scale c u) x == inject_Z c * dot u x.
Proof.
  induction u as [|a u IH]; intros [|y x]; simpl; try ring.
  unfold scale in IH. rewrite IH, inject_Z_mult. ring.
Qed.

Lemma dot_zeros u : forall x, zeros u = true -> dot u x == 0.
Proof.
  induction u as [|a u IH]; intros [|y x] H; try reflexivity.
  cbn [zeros forallb] in H. apply andb_prop in H. destruct H as [E H]. apply Z.eqb_eq in E. subst a.
  cbn [dot]. rewrite IH by exact H. change (inject_Z 0) with 0. ring.
Qed.

Lemma dot_same u : forall v x, same_row u v = true -> dot u x == dot v x.
Proof.
  induction u as [|a u IH]; intros [|b v] x H.
  - reflexivity.
  - symmetry. now apply dot_zeros.
  - now apply dot_zeros.
  - cbn [same_row] in H. apply andb_prop in H. destruct H as [E H]. apply Z.eqb_eq in E. subst b.
    destruct x as [|y x]; [reflexivity|]. cbn [dot]. now rewrite (IH v x H).
Qed.

Lemma dot_centred u z : forall x, (length u <= length x)%nat ->
  dot u (map (fun v => v - z) x) == dot u x - inject_Z (sum u) * z.
Proof.
  induction u as [|a u IH]; intros [|y x] L; simpl in L; try lia.
  - simpl. change (inject_Z 0) with 0. ring.
  - simpl. change (inject_Z 0) with 0. ring.
  - cbn [dot map]. rewrite IH by lia. change (sum (a :: u)) with (a + sum u)%Z. rewrite inject_Z_plus. ring.
Qed.

(** All points are within h of z. *)
Definition within (x : list Q) (z h : Q) : Prop := Forall (fun v => Qabs (v - z) <= h) x.

Lemma dot_within u z h : forall x, 0 <= h -> within x z h ->
  Qabs (dot u (map (fun v => v - z) x)) <= inject_Z (norm1 u) * h.
Proof.
  induction u as [|a u IH]; intros x H W.
  - simpl. change (Qabs 0) with 0. change (inject_Z 0) with 0. lra.
  - destruct W as [|y x Y W].
    + simpl. change (Qabs 0) with 0. apply Qmult_le_0_compat; [|exact H]. apply inject_Z_nonneg.
      pose proof (norm1_nonneg u). lia.
    + cbn [dot map]. eapply Qle_trans; [apply Qabs_triangle|].
      change (norm1 (a :: u)) with (Z.abs a + norm1 u)%Z.
      rewrite Qabs_Qmult, inject_Z_abs, inject_Z_plus, Qmult_plus_distr_l.
      apply Qplus_le_compat; [|now apply IH].
      apply Qmult_le_l'; [apply inject_Z_nonneg; lia | exact Y].
Qed.

(** * The limit of a ring *)

(** The weights w over the denominator e give the limit; the row v shows that it exists: the rows of M - 1v have
    absolute sums of at most 1/2. *)
Fixpoint mixture (w : list Z) (rows : list (list Z)) : list Z :=
  match w, rows with
  | a :: w, row :: rows => add (scale a row) (mixture w rows)
  | _, _ => []
  end.

Lemma dot_mixture e x : forall w rows,
  dot w (map (fun row => e * dot row x) rows) == e * dot (mixture w rows) x.
Proof.
  induction w as [|a w IH]; intros [|row rows]; simpl; try ring.
  rewrite IH, dot_add, dot_scale. ring.
Qed.

Definition least_entries (rows : list (list Z)) : list Z :=
  match rows with
  | [] => []
  | row :: rows => fold_right (fun u v => map (fun p => Z.min (fst p) (snd p)) (combine u v)) row rows
  end.

Definition converges (r : ring) (e : positive) (w : list Z) : bool :=
  let n := length (weights r) in
  let v := least_entries (weights r) in
  let d := Zpos (ring_denominator r) in
  forallb (fun row => Nat.eqb (length row) n && Z.eqb (sum row) d &&
    Z.leb (2 * norm1 (add row (scale (-1) v))) d) (weights r) &&
  Nat.leb (length v) n &&
  Nat.eqb (length w) n && Z.eqb (sum w) (Zpos e) && same_row (mixture w (weights r)) (scale d w).

Lemma over_itself d : (1 # d) * inject_Z (Zpos d) == 1.
Proof. unfold Qeq, Qmult, inject_Z. simpl. lia. Qed.

Lemma length_add u v : length (add u v) = max (length u) (length v).
Proof. revert v; induction u as [|a u IH]; intros [|b v]; simpl; try rewrite IH; lia. Qed.

Section Limit.
  Variables (r : ring) (e : positive) (w : list Z) (x : list Q).
  Hypothesis good : converges r e w = true.
  Hypothesis long : length x = length (weights r).

  Let n := length (weights r).
  Let v := least_entries (weights r).
  Let d := ring_denominator r.
  Let p := (1 # e) * dot w x.

  Lemma facts :
    (forall row, In row (weights r) -> length row = n /\ sum row = Zpos d /\
      (2 * norm1 (add row (scale (-1) v)) <= Zpos d)%Z) /\
    (length v <= n)%nat /\ length w = n /\ sum w = Zpos e /\
    same_row (mixture w (weights r)) (scale (Zpos d) w) = true.
  Proof.
    unfold converges in good. pose proof good as H. conditions H.
    apply Nat.leb_le in G2. apply Nat.eqb_eq in G1. apply Z.eqb_eq in G0.
    repeat split; try assumption.
    all: rewrite forallb_forall in H; specialize (H row H0); conditions H.
    - now apply Nat.eqb_eq.
    - now apply Z.eqb_eq.
    - now apply Z.leb_le.
  Qed.

  Lemma level_length m : length (ring_level r m x) = n.
  Proof. destruct m; [exact long|]. simpl. apply map_length. Qed.

  Lemma invariant m : (1 # e) * dot w (ring_level r m x) == p.
  Proof.
    induction m as [|m IH]; [reflexivity|]. destruct facts as (_ & _ & _ & _ & M).
    cbn [ring_level]. unfold refine_ring.
    rewrite dot_mixture, (dot_same _ _ _ M), dot_scale. rewrite <- IH. fold d.
    setoid_replace ((1 # d) * (inject_Z (Zpos d) * dot w (ring_level r m x)))
      with (((1 # d) * inject_Z (Zpos d)) * dot w (ring_level r m x)) by ring.
    rewrite over_itself. ring.
  Qed.

  Definition size : Q := fold_right (fun v s => Qabs v + s) 0 x.

  Lemma size_nonneg : 0 <= size.
  Proof. unfold size. induction x as [|y ys IH] in |- *; simpl; [lra|]. pose proof (Qabs_nonneg y). lra. Qed.

  Lemma size_within : within x 0 size.
  Proof.
    unfold size, within. apply Forall_forall. intros y I.
    induction x as [|u ys IH] in I |- *; [destruct I|]. simpl.
    assert (0 <= fold_right (fun v s => Qabs v + s) 0 ys).
    { clear. induction ys as [|y ys IH]; simpl; [lra|]. pose proof (Qabs_nonneg y). lra. }
    pose proof (Qabs_nonneg u).
    destruct I as [->|I].
    - rewrite (Qabs_wd (y - 0) y) by ring. lra.
    - specialize (IH I). lra.
  Qed.

  Lemma shrinks m : exists z, within (ring_level r m x) z (size * (1 # Pos.of_succ_nat m)).
  Proof.
    pose proof size_nonneg as S0.
    induction m as [|m [z W]].
    - exists 0. simpl. unfold within. eapply Forall_impl; [|apply size_within].
      intros y H. simpl in H. change (1 # 1) with 1. rewrite Qmult_1_r. exact H.
    - destruct facts as (R & V & _ & _ & _).
      set (y := ring_level r m x) in *.
      exists ((1 # d) * dot v y + (1 - (1 # d) * inject_Z (sum v)) * z).
      cbn [ring_level]. fold y. unfold refine_ring, within. apply Forall_map, Forall_forall. intros row I.
      destruct (R row I) as (L & S & N).
      set (rest := add row (scale (-1) v)) in *.
      assert (E : (1 # d) * dot row y - ((1 # d) * dot v y + (1 - (1 # d) * inject_Z (sum v)) * z)
        == (1 # d) * dot rest (map (fun u => u - z) y)).
      { rewrite dot_centred.
        2:{ unfold rest. rewrite length_add. unfold scale. rewrite map_length. unfold y.
            rewrite level_length. lia. }
        unfold rest. rewrite dot_add, dot_scale, sum_add, sum_scale, S, inject_Z_plus, inject_Z_mult.
        change (inject_Z (-1)) with (-(1)).
        pose proof (over_itself d) as O.
        set (a := 1 # d) in *. set (b := inject_Z (Zpos d)) in *.
        transitivity (a * dot row y - a * dot v y - (a * b) * z + a * inject_Z (sum v) * z); [rewrite O; ring|ring]. }
      fold d. rewrite E, Qabs_Qmult. change (Qabs (1 # d)) with (1 # d).
      set (h := size * (1 # Pos.of_succ_nat m)) in *.
      assert (H0 : 0 <= h) by (apply Qmult_le_0_compat; [exact S0 | discriminate]).
      eapply Qle_trans; [apply Qmult_le_l'; [discriminate | apply (dot_within rest z h); assumption]|].
      assert (Q2 : (1 # d) * inject_Z (norm1 rest) <= 1 # 2).
      { unfold Qle, Qmult, inject_Z. simpl. lia. }
      rewrite Qmult_assoc. eapply Qle_trans; [apply Qmult_le_compat_r; [exact Q2 | exact H0]|].
      unfold h. setoid_replace ((1 # 2) * (size * (1 # Pos.of_succ_nat m)))
        with (size * ((1 # 2) * (1 # Pos.of_succ_nat m))) by ring.
      apply Qmult_le_l'; [exact S0|]. unfold Qle, Qmult. simpl. lia.
  Qed.

  Theorem ring_limit : ring_tends_to r x p.
  Proof.
    intros epsilon P. destruct facts as (_ & _ & LW & SW & _).
    set (C := (1 + (1 # e) * inject_Z (norm1 w)) * size).
    assert (C0 : 0 <= C).
    { apply Qmult_le_0_compat; [|apply size_nonneg].
      assert (0 <= (1 # e) * inject_Z (norm1 w))
        by (apply Qmult_le_0_compat; [discriminate | apply inject_Z_nonneg, norm1_nonneg]). lra. }
    exists (Z.to_nat (Qround.Qceiling (C / epsilon))). intros m a L A.
    destruct (shrinks m) as [z W].
    set (h := size * (1 # Pos.of_succ_nat m)) in *.
    assert (H0 : 0 <= h) by (apply Qmult_le_0_compat; [apply size_nonneg | discriminate]).
    set (y := ring_level r m x) in *.
    assert (X : Qabs (nth a y 0 - z) <= h).
    { unfold within in W. rewrite Forall_forall in W. apply W, nth_In. unfold y. now rewrite level_length. }
    assert (Y : Qabs (p - z) <= (1 # e) * inject_Z (norm1 w) * h).
    { rewrite <- (invariant m). fold y.
      assert (E : (1 # e) * dot w y - z == (1 # e) * dot w (map (fun u => u - z) y)).
      { rewrite dot_centred by (unfold y; rewrite level_length; lia). rewrite SW.
        pose proof (over_itself e) as O. set (b := 1 # e) in *. set (g := inject_Z (Zpos e)) in *.
        transitivity (b * dot w y - (b * g) * z); [rewrite O; ring | ring]. }
      rewrite E, Qabs_Qmult. change (Qabs (1 # e)) with (1 # e). rewrite <- Qmult_assoc.
      apply Qmult_le_l'; [discriminate | now apply dot_within]. }
    rewrite (Qabs_wd _ ((nth a y 0 - z) + - (p - z))) by ring.
    eapply Qle_trans; [apply Qabs_triangle|]. rewrite Qabs_opp.
    apply Qle_trans with (C * (1 # Pos.of_succ_nat m)).
    { unfold C. setoid_replace ((1 + (1 # e) * inject_Z (norm1 w)) * size * (1 # Pos.of_succ_nat m))
        with (h + (1 # e) * inject_Z (norm1 w) * h) by (unfold h; ring).
      now apply Qplus_le_compat. }
    assert (M : C / epsilon <= inject_Z (Zpos (Pos.of_succ_nat m))).
    { eapply Qle_trans; [apply Qround.Qle_ceiling|]. rewrite <- Zle_Qle. lia. }
    assert (D : C <= inject_Z (Zpos (Pos.of_succ_nat m)) * epsilon).
    { setoid_replace C with (C / epsilon * epsilon) by (field; lra).
      apply Qmult_le_compat_r; [exact M | lra]. }
    pose proof (over_itself (Pos.of_succ_nat m)) as O.
    set (b := 1 # Pos.of_succ_nat m) in *. set (g := inject_Z (Zpos (Pos.of_succ_nat m))) in *.
    assert (B0 : 0 <= b) by (unfold b; discriminate).
    setoid_replace epsilon with ((b * g) * epsilon) by (rewrite O; ring).
    setoid_replace (b * g * epsilon) with ((g * epsilon) * b) by ring.
    now apply Qmult_le_compat_r.
  Qed.
End Limit.

(** * What a generated file applies *)

Definition ring_data (values : list Z) : list Q := map inject_Z values.

Definition is_affine_ring (r : ring) : bool :=
  forallb (fun row => Nat.eqb (length row) (length (weights r)) && Z.eqb (sum row) (Zpos (ring_denominator r)))
    (weights r).

Lemma is_affine_ring_correct r : is_affine_ring r = true -> affine_ring r.
Proof.
  unfold is_affine_ring. intros H. apply Forall_forall. intros row I.
  rewrite forallb_forall in H. specialize (H row I). apply andb_prop in H. destruct H as [L S].
  split; [now apply Nat.eqb_eq | now apply Z.eqb_eq].
Qed.

Definition ring_spread (r : ring) (x : list Q) (b : Q) : bool :=
  is_affine_ring r && Nat.eqb (length x) (length (weights r)) &&
  forallb (fun p => Qle_bool (Qabs (nth (fst p) x 0 - nth (snd p) x 0)) b) (edges r).

Lemma ring_spread_correct r x b : ring_spread r x b = true -> ring_at_most r x b.
Proof.
  unfold ring_spread. intros H. conditions H. rename G into F. apply is_affine_ring_correct in H.
  split; [exact H|]. split; [now apply Nat.eqb_eq|]. intros a c I. rewrite forallb_forall in F. specialize (F _ I). now apply Qle_bool_iff in F.
Qed.

Definition is_edge (r : ring) (a c : nat) : bool :=
  existsb (fun p => Nat.eqb (fst p) a && Nat.eqb (snd p) c || Nat.eqb (fst p) c && Nat.eqb (snd p) a) (edges r).

Lemma is_edge_correct r a c : is_edge r a c = true -> In (a, c) (edges r) \/ In (c, a) (edges r).
Proof.
  unfold is_edge. intros H. apply existsb_exists in H. destruct H as ([u v] & I & E). simpl in E.
  apply orb_prop in E. destruct E as [E|E]; apply andb_prop in E; destruct E as [A C];
    apply Nat.eqb_eq in A, C; subst; [left|right]; exact I.
Qed.

Definition ring_difference_exceeded (r : ring) (k : nat) (values : list Z) (a c : nat) (b B : Q) : bool :=
  let x := ring_data values in let y := ring_level r k x in
  ring_spread r x b && is_edge r a c && below B (Qabs (nth a y 0 - nth c y 0)).

Theorem exceeds_ring_difference_by r k values a c b B :
  ring_difference_exceeded r k values a c b B = true -> exceeds_ring_difference r k b B.
Proof.
  unfold ring_difference_exceeded. intros H. conditions H.
  exists (ring_data values), a, c.
  split; [now apply ring_spread_correct|]. split; [now apply is_edge_correct | now apply below_correct].
Qed.

Definition ring_step_exceeded (r p : ring) (k : nat) (values : list Z) (a : nat) (b B : Q) : bool :=
  let x := ring_data values in
  ring_spread r x b && Nat.ltb a (length (weights r)) &&
  below B (Qabs (nth a (ring_level r (S k) x) 0 - nth a (refine_ring p (ring_level r k x)) 0)).

Theorem exceeds_ring_step_by r p k values a b B :
  ring_step_exceeded r p k values a b B = true -> exceeds_ring_step r p k b B.
Proof.
  unfold ring_step_exceeded. intros H. conditions H.
  exists (ring_data values), a.
  split; [now apply ring_spread_correct|]. split; [now apply Nat.ltb_lt | now apply below_correct].
Qed.

Definition ring_distance_exceeded (r : ring) (k : nat) (values : list Z) (a : nat) (e : positive) (w : list Z)
    (b B : Q) : bool :=
  let x := ring_data values in
  ring_spread r x b && Nat.ltb a (length (weights r)) && converges r e w &&
  below B (Qabs (nth a (ring_level r k x) 0 - (1 # e) * dot w x)).

Theorem exceeds_ring_distance_by r k values a e w b B :
  ring_distance_exceeded r k values a e w b B = true -> exceeds_ring_distance r k b B.
Proof.
  unfold ring_distance_exceeded. intros H. conditions H. apply ring_spread_correct in H.
  exists (ring_data values), a, ((1 # e) * dot w (ring_data values)).
  split; [exact H|]. split; [now apply Nat.ltb_lt|]. split; [|now apply below_correct].
  apply ring_limit; [exact G0 | apply H].
Qed.
