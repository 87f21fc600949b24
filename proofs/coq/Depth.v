(** Depths: a bound at level k bounds all later levels as well. *)

Require Import ZArith QArith Qabs List Lia Lqa Bool.
From Subcert Require Import Definitions Core Error.
Import ListNotations.
Local Open Scope Q_scope.

(** The bounds of the block that begins one level later. *)
Definition shifted (q : Q) (ts : list Q) : list Q := tl ts ++ [q * hd 0 ts].

Lemma total_app us vs : total (us ++ vs) == total us + total vs.
Proof. induction us as [|u us IH]; simpl; [ring|]. rewrite IH. ring. Qed.

Lemma shifted_total q ts : nonneg ts -> q <= 1 -> total (shifted q ts) <= total ts.
Proof.
  intros N H. unfold shifted. rewrite total_app. destruct N as [|t ts T N]; simpl; nra.
Qed.

Lemma shifted_nonneg q ts : 0 <= q -> nonneg ts -> nonneg (shifted q ts).
Proof.
  intros Q0 N. unfold shifted. apply Forall_app. destruct N as [|t ts T N]; simpl; split.
  - constructor.
  - constructor; [|constructor]. lra.
  - exact N.
  - constructor; [|constructor]. now apply Qmult_le_0_compat.
Qed.

Lemma shifted_length q ts : (0 < length ts)%nat -> length (shifted q ts) = length ts.
Proof. intros L. unfold shifted. rewrite app_length. destruct ts; simpl in *; lia. Qed.

Lemma shifted_bounded s k q ts : (0 < length ts)%nat -> bounds_differences s (length ts) q ->
  bounded_from s k ts -> bounded_from s (S k) (shifted q ts).
Proof.
  intros L D H i I. rewrite shifted_length in I by exact L. unfold shifted.
  destruct ts as [|t ts]; [simpl in L; lia|]. simpl tl. simpl hd. simpl in I.
  destruct (Nat.eq_dec i (length ts)) as [->|N].
  - rewrite app_nth2, Nat.sub_diag by lia. simpl nth.
    replace (length ts + S k)%nat with (length (t :: ts) + k)%nat by (simpl; lia).
    apply bounds_differences_times; [exact D|]. apply (H O). simpl. lia.
  - rewrite app_nth1 by lia. replace (i + S k)%nat with (S i + k)%nat by lia. apply (H (S i)). simpl. lia.
Qed.

Theorem later_distance_bound s tau ts q B : affine s -> nonneg ts -> (0 < length ts)%nat ->
  bounds_differences s (length ts) q -> 0 <= q -> q <= 1 -> 0 <= B ->
  displacement s tau * total ts <= B * (1 - q) ->
  forall k, bounded_from s k ts -> forall more, bounds_distance s tau (more + k) B.
Proof.
  intros A N C D Q0 Q1 B0 E k U more. revert ts k N C D E U.
  induction more as [|more IH]; intros ts k N C D E U.
  - now apply (distance_bound s tau k ts q B).
  - replace (S more + k)%nat with (more + S k)%nat by lia.
    apply (IH (shifted q ts)).
    + now apply shifted_nonneg.
    + now rewrite shifted_length.
    + now rewrite shifted_length.
    + eapply Qle_trans; [|exact E]. apply Qmult_le_l'; [apply displacement_nonneg|].
      now apply shifted_total.
    + now apply shifted_bounded.
Qed.

Theorem bounds_later_distances_by s tau M c k B : distance_bounded s tau M c k B = true ->
  forall m, (k <= m)%nat -> bounds_distance s tau m B.
Proof.
  unfold distance_bounded. intros H m L.
  repeat match type of H with (_ && _)%bool = true =>
    apply andb_prop in H; let G := fresh "G" in destruct H as [H G] end.
  apply is_affine_correct in H. apply Nat.eqb_eq in G6. apply Nat.ltb_lt in G5. apply Nat.leb_le in G4.
  rewrite Qle_bool_iff in *.
  replace m with ((m - k) + k)%nat by lia.
  apply (later_distance_bound s tau (block_from s M c k) (Qred (contraction s c)) B); unfold block_from; try assumption.
  - apply Forall_forall. rewrite forallb_forall in G3. intros t I. apply Qle_bool_iff, G3, I.
  - lia.
  - rewrite G6. eapply bounds_wd; [symmetry; apply Qred_correct|]. now apply contraction_bounds.
  - now apply window_bounded.
Qed.

(** The depth k keeps epsilon for points with differences of at most b. *)
Definition depth_suffices (s : scheme) (tau : Q) (M c k : nat) (b epsilon : Q) : bool :=
  negb (Qle_bool b 0) && distance_bounded s tau M c k (epsilon / b).

Theorem sufficient_depth_by s tau M c k b epsilon :
  depth_suffices s tau M c k b epsilon = true -> sufficient_depth s tau b epsilon k.
Proof.
  unfold depth_suffices. intros H. apply andb_prop in H. destruct H as [P H].
  assert (b0 : 0 < b).
  { apply Qnot_le_lt. intros F. apply Qle_bool_iff in F. rewrite F in P. discriminate. }
  intros x t m l X [L R].
  pose proof (bounds_later_distances_by s tau M c k _ H m L x b t l X R) as D.
  eapply Qle_trans; [exact D|]. apply Qle_lteq. right. field. lra.
Qed.

(** The least depth that the bound of [distance_bounded] shows: one level less does not suffice for this bound. *)
Definition least_depth (s : scheme) (tau : Q) (M c k : nat) (b epsilon : Q) : bool :=
  depth_suffices s tau M c k b epsilon &&
  match k with O => true | S k => negb (depth_suffices s tau M c k b epsilon) end.

Theorem least_depth_by s tau M c k b epsilon : least_depth s tau M c k b epsilon = true ->
  sufficient_depth s tau b epsilon k.
Proof. unfold least_depth. intros H. apply andb_prop in H. now apply (sufficient_depth_by s tau M c), H. Qed.
