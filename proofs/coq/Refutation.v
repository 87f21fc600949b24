(** Promised bounds refuted: explicit points exceed them at a level. *)

Require Import ZArith QArith Qabs Qround List Lia Lqa Bool.
From Subcert Require Import Definitions Core Error.
Import ListNotations.
Local Open Scope Q_scope.

(** * Values of a level, along the digits of the place *)

Fixpoint value (s : scheme) (l : nat) (w : list Z) (p : Z) (x : points) : Q :=
  match l with
  | O => combination w x p
  | S l => (1 # denominator s) *
      value s l (pull s (Z.to_nat (p mod arityZ s)) w) (p / arityZ s + offset s) x
  end.

Lemma value_correct s x : (2 <= arity s)%nat -> forall l w p,
  value s l w p x == combination w (level s l x) p.
Proof.
  intros two. induction l as [|l IH]; intros w p; [reflexivity|]. cbn [value level].
  rewrite IH. assert (N : (0 < arityZ s)%Z) by (unfold arityZ; lia).
  pose proof (Z.mod_pos_bound p _ N). pose proof (Z.div_mod p (arityZ s) ltac:(lia)) as E.
  replace p with (arityZ s * (p / arityZ s) + Z.of_nat (Z.to_nat (p mod arityZ s)))%Z at 3 by lia.
  rewrite pull_correct; [reflexivity | exact two | unfold arityZ in *; lia].
Qed.

Definition value_at (s : scheme) (tau : Q) (k : nat) (x : points) (t : Q) : Q :=
  let u := Qred (inject_Z (arityZ s ^ Z.of_nat k) * t - tau) in
  let i := Qfloor u in
  value s k [1%Z] i x + (u - inject_Z i) * value s k [(-1)%Z; 1%Z] i x.

Lemma value_at_correct s tau k x t : (2 <= arity s)%nat -> value_at s tau k x t == polygon s tau k x t.
Proof.
  intros two. unfold polygon.
  rewrite (interpolant_param _ _ (Qred (inject_Z (arityZ s ^ Z.of_nat k) * t - tau))) by (symmetry; apply Qred_correct).
  unfold value_at, interpolant. rewrite !value_correct by exact two. cbn [combination].
  change (inject_Z 1) with 1. change (inject_Z (-1)) with (-(1)). ring.
Qed.

(** * The spread of data *)

Fixpoint spread (values : list Z) : Z :=
  match values with
  | a :: (b :: _) as rest => Z.max (Z.abs (b - a)) (spread rest)
  | _ => 0
  end.

Lemma spread_nonneg values : (0 <= spread values)%Z.
Proof. induction values as [|a [|b values] IH]; simpl in *; lia. Qed.

Lemma spread_correct values : forall j, (S j < length values)%nat ->
  (Z.abs (nth (S j) values 0 - nth j values 0) <= spread values)%Z.
Proof.
  induction values as [|a [|b values] IH]; intros j L; try (simpl in L; lia).
  destruct j as [|j]; [simpl; lia|].
  assert (H : (Z.abs (nth (S j) (b :: values) 0 - nth j (b :: values) 0) <= spread (b :: values))%Z)
    by (apply IH; simpl in *; lia).
  change (spread (a :: b :: values)) with (Z.max (Z.abs (b - a)) (spread (b :: values))).
  change (nth (S (S j)) (a :: b :: values) 0)%Z with (nth (S j) (b :: values) 0)%Z.
  change (nth (S j) (a :: b :: values) 0)%Z with (nth j (b :: values) 0)%Z. lia.
Qed.

Lemma data_spread first values : at_most (difference (data first values)) (inject_Z (spread values)).
Proof.
  intros i. unfold difference, data. unfold Qminus. rewrite <- inject_Z_opp, <- inject_Z_plus, inject_Z_abs, <- Zle_Qle.
  set (n := Z.of_nat (length values)).
  set (j := Z.to_nat (Z.min (i - first) (n - 1))).
  set (j' := Z.to_nat (Z.min (i + 1 - first) (n - 1))).
  pose proof (spread_nonneg values).
  destruct (Nat.eq_dec j' j) as [->|N]; [rewrite Z.add_opp_diag_r; simpl; lia|].
  assert (j' = S j /\ (S j < length values)%nat) as [-> L] by lia.
  apply (spread_correct values j L).
Qed.

Lemma at_most_more x b c : b <= c -> at_most x b -> at_most x c.
Proof. intros L H i. eapply Qle_trans; [apply H | exact L]. Qed.

(** * What a generated file applies *)

(** A strict comparison. *)
Definition below (a b : Q) : bool := negb (Qle_bool b a).

Lemma below_correct a b : below a b = true -> a < b.
Proof.
  unfold below. intros H. apply Qnot_le_lt. intros F. apply Qle_bool_iff in F. rewrite F in H. discriminate.
Qed.

Ltac conditions H :=
  repeat match type of H with (_ && _)%bool = true =>
    let G := fresh "G" in apply andb_prop in H; destruct H as [H G] end.

Definition difference_exceeded (s : scheme) (k : nat) (first : Z) (values : list Z) (i : Z) (b B : Q) : bool :=
  is_affine s && Qle_bool (inject_Z (spread values)) b &&
  below B (Qabs (value s k [(-1)%Z; 1%Z] i (data first values))).

Theorem exceeds_difference_by s k first values i b B :
  difference_exceeded s k first values i b B = true -> exceeds_difference s k b B.
Proof.
  unfold difference_exceeded. intros H. conditions H.
  apply is_affine_correct in H. apply below_correct in G. apply Qle_bool_iff in G0.
  exists (data first values), i. split; [eapply at_most_more; [exact G0 | apply data_spread]|].
  eapply Qlt_le_trans; [exact G|]. apply Qle_lteq. right. apply Qabs_wd.
  rewrite value_correct by apply H. unfold difference. simpl combination.
  change (inject_Z 1) with 1. change (inject_Z (-1)) with (-(1)). ring.
Qed.

Definition step_exceeded (s : scheme) (tau : Q) (k : nat) (first : Z) (values : list Z) (t b B : Q) : bool :=
  is_affine s && Qle_bool (inject_Z (spread values)) b &&
  below B (Qabs (value_at s tau (S k) (data first values) t - value_at s tau k (data first values) t)).

Theorem exceeds_step_by s tau k first values t b B :
  step_exceeded s tau k first values t b B = true -> exceeds_step s tau k b B.
Proof.
  unfold step_exceeded. intros H. conditions H.
  apply is_affine_correct in H. apply below_correct in G. apply Qle_bool_iff in G0.
  exists (data first values), t. split; [eapply at_most_more; [exact G0 | apply data_spread]|].
  eapply Qlt_le_trans; [exact G|]. apply Qle_lteq. right. apply Qabs_wd.
  now rewrite !value_at_correct by apply H.
Qed.

(** At level l the distance exceeds B by more than all later levels can undo: [tail] bounds them, by
    [distance_bounded] for the block c and T_1, …, T_M. *)
Definition distance_exceeded (s : scheme) (tau : Q) (k : nat) (first : Z) (values : list Z) (t b B : Q)
    (l M c : nat) (tail : Q) : bool :=
  is_affine s && Qle_bool (inject_Z (spread values)) b && distance_bounded s tau M c l tail &&
  below (B + tail * b) (Qabs (value_at s tau l (data first values) t - value_at s tau k (data first values) t)).

(** What later levels leave of the distance at level l. *)
Lemma distance_kept s tau k l tail x b t : bounds_distance s tau l tail -> at_most (difference x) b ->
  forall m, (l <= m)%nat -> Qabs (polygon s tau l x t - polygon s tau k x t) - tail * b <=
    Qabs (polygon s tau m x t - polygon s tau k x t).
Proof.
  intros H S m L. pose proof (H x b t m S L) as D.
  pose proof (Qabs_triangle (polygon s tau m x t - polygon s tau k x t) (polygon s tau l x t - polygon s tau m x t)) as T.
  rewrite (Qabs_wd (_ + _) (polygon s tau l x t - polygon s tau k x t)) in T by ring.
  rewrite (Qabs_Qminus (polygon s tau l x t) (polygon s tau m x t)) in T. lra.
Qed.

Theorem exceeds_distance_by s tau k first values t b B l M c tail :
  distance_exceeded s tau k first values t b B l M c tail = true -> exceeds_distance s tau k b B.
Proof.
  unfold distance_exceeded. intros H. conditions H.
  apply is_affine_correct in H. apply below_correct in G. apply Qle_bool_iff in G1.
  apply bounds_distance_by in G0.
  set (x := data first values) in *.
  assert (S : at_most (difference x) b) by (eapply at_most_more; [exact G1 | apply data_spread]).
  rewrite !value_at_correct in G by apply H.
  exists x, t, l, (Qabs (polygon s tau l x t - polygon s tau k x t) - (B + tail * b)).
  split; [exact S|]. split; [lra|]. intros m L. pose proof (distance_kept s tau k l tail x b t G0 S m L). lra.
Qed.

(** C_k from both sides: the sound bound of the block c and T_1, …, T_M, and data of spread 1 whose distance at level l
    is [lower] and more than later levels undo. *)
Definition least_constant_between (s : scheme) (tau : Q) (M c k : nat) (first : Z) (values : list Z) (t : Q)
    (l M' c' : nat) (tail lower upper : Q) : bool :=
  distance_bounded s tau M c k upper && Z.leb (spread values) 1 && distance_bounded s tau M' c' l tail &&
  Qle_bool (lower + tail) (Qabs (value_at s tau l (data first values) t - value_at s tau k (data first values) t)).

Theorem least_constant_by s tau M c k first values t l M' c' tail lower upper :
  least_constant_between s tau M c k first values t l M' c' tail lower upper = true ->
  least_constant s tau k lower upper.
Proof.
  unfold least_constant_between. intros H. conditions H.
  assert (A : affine s) by (unfold distance_bounded in H; conditions H; now apply is_affine_correct).
  apply bounds_distance_by in H, G0. apply Z.leb_le in G1. apply Qle_bool_iff in G.
  rewrite !value_at_correct in G by apply A. split; [exact H|].
  set (x := data first values) in *. exists x, t, l.
  assert (S : at_most (difference x) 1).
  { eapply at_most_more; [|apply data_spread]. change 1 with (inject_Z 1). rewrite <- Zle_Qle. exact G1. }
  split; [exact S|]. intros m L. pose proof (distance_kept s tau k l tail x 1 t G0 S m L). lra.
Qed.

(** A depth k does not suffice. *)
Theorem depth_refuted s tau k b epsilon : exceeds_distance s tau k b epsilon -> ~ sufficient_depth s tau b epsilon k.
Proof.
  intros (x & t & l & margin & S & P & E) H.
  pose proof (E (max l k) ltac:(lia)) as A. pose proof (H x t k (max l k) S ltac:(lia)) as B. lra.
Qed.

Theorem distance_refuted s tau k b B : exceeds_distance s tau k b (B * b) -> ~ bounds_distance s tau k B.
Proof.
  intros (x & t & l & margin & S & P & E) H.
  pose proof (E (max l k) ltac:(lia)) as A. pose proof (H x b t (max l k) S ltac:(lia)) as D. lra.
Qed.

Theorem step_refuted s tau k b B : exceeds_step s tau k b (B * b) -> ~ bounds_step s tau k B.
Proof. intros (x & t & S & E) H. pose proof (H x b t S) as D. lra. Qed.

Theorem difference_refuted s k b B : exceeds_difference s k b (B * b) -> ~ bounds_differences s k B.
Proof. intros (x & i & S & E) H. pose proof (H x b S i) as D. lra. Qed.
