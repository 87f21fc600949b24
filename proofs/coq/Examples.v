(** Every definition at work: none of them is empty, and none holds of everything. *)

Require Import ZArith QArith Qabs Qround List Lia Lqa.
From Subcert Require Import Definitions Core Error Natural Depth Refutation Net NetBound Ring.
Import ListNotations.
Local Open Scope Q_scope.

(** * Schemes of arity 2, 3 and 5 *)

(** Chaikin's corner cutting. *)
Definition chaikin := Scheme 4 0 [[3; 1]; [1; 3]]%Z.

(** Dyn, Levin and Gregory's four-point scheme. *)
Definition four_point := Scheme 16 (-1) [[0; 16; 0; 0]; [-1; 9; 9; -1]]%Z.

(** The six-point scheme at w = 39/2000. *)
Definition six_point := Scheme 2000 (-2) [[0; 0; 2000; 0; 0; 0]; [39; -242; 1203; 1203; -242; 39]]%Z.

(** Quadratic interpolation at thirds, and at fifths. *)
Definition ternary := Scheme 9 (-1) [[2; 8; -1]; [0; 9; 0]; [-1; 8; 2]]%Z.
Definition quinary := Scheme 25 (-1) [[7; 21; -3]; [3; 24; -2]; [0; 25; 0]; [-2; 24; 3]; [-3; 21; 7]]%Z.

Example chaikin_is_affine : affine chaikin.
Proof. now apply is_affine_correct. Qed.

Example not_affine : ~ affine (Scheme 4 0 [[3; 2]; [1; 3]]%Z).
Proof. intros [_ F]. apply Forall_inv in F. discriminate. Qed.

(** One refinement, by hand: of …, 0, 4, 4, … the new point x'_0 is (3·0 + 4)/4. *)
Example refined : refine chaikin (data 0 [0; 4]%Z) 0%Z == 1.
Proof. reflexivity. Qed.

Example refined_twice : level chaikin 2 (data 0 [0; 16]%Z) 1%Z == 10.
Proof. reflexivity. Qed.

(** * Contraction constants *)

Example chaikin_8 : contraction_constant chaikin 8 (1 # 256).
Proof. apply contraction_constant_by. vm_compute. reflexivity. Qed.

Example four_point_12 : contraction_constant four_point 12 (22369621 # 68719476736).
Proof. apply contraction_constant_by. vm_compute. reflexivity. Qed.

Example six_point_12 : contraction_constant six_point 12 (418528457223011079601498756585881337 # 1024000000000000000000000000000000000000).
Proof. apply contraction_constant_by. vm_compute. reflexivity. Qed.

Example ternary_2 : contraction_constant ternary 2 (11 # 27).
Proof. apply contraction_constant_by. vm_compute. reflexivity. Qed.

Example quinary_3 : contraction_constant quinary 3 (1433 # 15625).
Proof. apply contraction_constant_by. vm_compute. reflexivity. Qed.

(** No other number is the constant. *)
Example one_constant s c T U : contraction_constant s c T -> contraction_constant s c U ->
  0 <= T -> 0 <= U -> T == U.
Proof.
  intros [A (x & i & X & VX)] [B (y & j & Y & VY)] P Q.
  pose proof (A y 1 Y j) as F. pose proof (B x 1 X i) as G.
  rewrite VX in G. rewrite VY in F. rewrite Qabs_pos in F, G by assumption. lra.
Qed.

Example chaikin_not_less : ~ bounds_differences chaikin 1 (49 # 100).
Proof.
  apply (difference_refuted chaikin 1 1). apply (exceeds_difference_by chaikin 1 0 [0; 1]%Z 0).
  vm_compute. reflexivity.
Qed.

Example four_point_norm : scheme_norm four_point 1 (5 # 4).
Proof. apply scheme_norm_by. vm_compute. reflexivity. Qed.

(** The difference mask, and the same read from its other end: from c = 2 on the constants differ. *)
Definition six_point_differences :=
  Scheme 2000 (-2) [[-39; 203; 1000; -203; 39; 0]; [39; -203; 1000; 203; -39; 0]]%Z.

Example six_point_forwards : contraction_constant six_point 2 (81069 # 200000).
Proof. apply contraction_constant_by. vm_compute. reflexivity. Qed.

Example six_point_backwards : backwards_constant six_point six_point_differences 2 (176871 # 400000).
Proof. apply backwards_constant_by. vm_compute. reflexivity. Qed.

(** * Rules that sum to 1, and points that grow beyond all bounds

    Khan, Omar, Mustafa 2019, (2.2), says that rules that sum to 1 are enough for convergence. *)

Definition diverging := Scheme 1 0 [[2; -1]; [2; -1]]%Z.

Definition edge : points := fun i => if Z.ltb i 0 then 0 else 1.

Lemma diverging_step x : refine diverging x 0%Z == 2 * x 0%Z - x 1%Z /\
  refine diverging x 1%Z == 2 * x 0%Z - x 1%Z /\ refine diverging x (-1)%Z == 2 * x (-1)%Z - x 0%Z.
Proof.
  change (refine diverging x 0%Z) with ((1 # 1) * (inject_Z 2 * x 0%Z + (inject_Z (-1) * x 1%Z + 0))).
  change (refine diverging x 1%Z) with ((1 # 1) * (inject_Z 2 * x 0%Z + (inject_Z (-1) * x 1%Z + 0))).
  change (refine diverging x (-1)%Z) with ((1 # 1) * (inject_Z 2 * x (-1)%Z + (inject_Z (-1) * x 0%Z + 0))).
  change (inject_Z 2) with 2. change (inject_Z (-1)) with (-(1)). change (1 # 1) with 1. repeat split; ring.
Qed.

Lemma diverging_levels k : level diverging k edge 0%Z == 1 /\ level diverging k edge 1%Z == 1 /\
  level diverging k edge (-1)%Z == inject_Z (1 - 2 ^ Z.of_nat k).
Proof.
  induction k as [|k (A & B & C)]; [repeat split; reflexivity|].
  cbn [level]. destruct (diverging_step (level diverging k edge)) as (-> & -> & ->). rewrite A, B, C.
  split; [reflexivity|]. split; [reflexivity|].
  rewrite Nat2Z.inj_succ, Z.pow_succ_r by lia. unfold Z.sub.
  rewrite !inject_Z_plus, !inject_Z_opp, !inject_Z_mult. change (inject_Z 1) with 1. change (inject_Z 2) with 2. ring.
Qed.

(** The difference of x_(-1) and x_0 doubles from level to level. *)
Theorem diverging_differences k : difference (level diverging k edge) (-1)%Z == inject_Z (2 ^ Z.of_nat k).
Proof.
  unfold difference. change (-1 + 1)%Z with 0%Z. destruct (diverging_levels k) as (-> & _ & ->).
  unfold Z.sub. rewrite inject_Z_plus, inject_Z_opp. change (inject_Z 1) with 1. ring.
Qed.

Theorem rules_that_sum_to_1_are_not_enough : affine diverging /\ at_most edge 1 /\
  forall B, exists k, B < Qabs (difference (level diverging k edge) (-1)%Z).
Proof.
  split; [now apply is_affine_correct|]. split.
  - intros i. unfold edge. destruct (Z.ltb i 0); discriminate.
  - intros B. set (n := Z.to_nat (Z.max 0 (Qround.Qceiling B))). exists n.
    rewrite (diverging_differences n), inject_Z_abs.
    pose proof (Z.pow_gt_lin_r 2 (Z.of_nat n) ltac:(lia) ltac:(lia)).
    apply Qle_lt_trans with (inject_Z (Qround.Qceiling B)); [apply Qround.Qle_ceiling|].
    rewrite <- Zlt_Qlt. lia.
Qed.

(** * Distances *)

(** Chaikin's polygon lies 1/4 apart from the polygon of the next level, at most. *)
Example chaikin_step : bounds_step chaikin 0 0 (1 # 4).
Proof.
  intros x b t H. eapply Qle_trans; [apply (bounds_step_by chaikin 0 0 1); [|apply bounds_differences_zero | exact H]|].
  - now apply is_affine_correct.
  - assert (E : displacement chaikin 0 * 1 == 1 # 4) by reflexivity. rewrite E. apply Qle_refl.
Qed.

Example chaikin_distance : bounds_distance chaikin 0 3 (1 # 16).
Proof. apply (bounds_distance_by chaikin 0 1 1). vm_compute. reflexivity. Qed.

(** Blocks of three levels, of the four constants T_1 to T_4. *)
Example four_point_distance : bounds_distance four_point 0 0 (125 # 427).
Proof. apply (bounds_distance_by four_point 0 4 3). vm_compute. reflexivity. Qed.

Example chaikin_depth : sufficient_depth chaikin 0 10 (1 # 100) 9.
Proof. apply (sufficient_depth_by chaikin 0 1 1). vm_compute. reflexivity. Qed.

Example chaikin_least_depth : sufficient_depth chaikin 0 10 (1 # 100) 9.
Proof. apply (least_depth_by chaikin 0 1 1). vm_compute. reflexivity. Qed.

Example chaikin_too_few_levels : ~ sufficient_depth chaikin 0 10 (1 # 100) 8.
Proof.
  apply depth_refuted. apply (exceeds_distance_by chaikin 0 8 0 [0; 10]%Z 0 10 (1 # 100) 20 1 1 (1 # 10000)).
  vm_compute. reflexivity.
Qed.

(** The same rules compared at another offset: the new point moves by 21/25. *)
Example quinary_step : exceeds_step (Scheme 25 0 (rules quinary)) 0 0 1 (20 # 25).
Proof. apply (exceeds_step_by (Scheme 25 0 (rules quinary)) 0 0 0 [0; 1; 0]%Z 0). vm_compute. reflexivity. Qed.

(** * Natural parameters, and the least constant *)

Example chaikin_keeps_lines : keeps_lines chaikin (-1 # 2).
Proof. apply keeps_lines_by. vm_compute. reflexivity. Qed.

Example ternary_keeps_lines : keeps_lines (Scheme 6 0 [[5; 1]; [3; 3]; [1; 5]]%Z) (-1 # 4).
Proof. apply keeps_lines_by. vm_compute. reflexivity. Qed.

Example quinary_keeps_lines : keeps_lines (Scheme 25 0 (rules quinary)) (-3 # 4).
Proof. apply keeps_lines_by. vm_compute. reflexivity. Qed.

(** At i/n^k the points of a line are not on it. *)
Example chaikin_indexed_lines : ~ keeps_lines chaikin 0.
Proof. intros H. specialize (H 0%Z). vm_compute in H. discriminate H. Qed.

(** With x^k_i at (i - 1/2)/2^k, Chaikin's new points are on the polygon before, and its own points are 1/4 off at most. *)
Example chaikin_natural_step : bounds_step chaikin (-1 # 2) 0 (1 # 4).
Proof.
  intros x b t H. eapply Qle_trans; [apply (bounds_step_by chaikin (-1 # 2) 0 1); [|apply bounds_differences_zero | exact H]|].
  - now apply is_affine_correct.
  - assert (E : displacement chaikin (-1 # 2) * 1 == 1 # 4) by reflexivity. rewrite E. apply Qle_refl.
Qed.

Example chaikin_natural_distance : bounds_distance chaikin (-1 # 2) 3 (1 # 16).
Proof. apply (bounds_distance_by chaikin (-1 # 2) 1 1). vm_compute. reflexivity. Qed.

(** C_0 = 1/2 at i/n^k, up to 2^-19. *)
Example chaikin_least_constant : least_constant chaikin 0 0 (262143 # 524288) (1 # 2).
Proof. apply (least_constant_by chaikin 0 1 1 0 0 [0; 1]%Z 0 19 1 1 (1 # 1048576)). vm_compute. reflexivity. Qed.

(** C_0 = 1/4 at natural parameters (THEOREMS.md, 84), which the bound of single steps does not reach. *)
Example chaikin_natural_least_constant : least_constant chaikin (-1 # 2) 0 (255 # 1024) (1 # 2).
Proof. apply (least_constant_by chaikin (-1 # 2) 1 1 0 0 [0; 1; 0]%Z (1 # 2) 11 1 1 (1 # 4096)). vm_compute. reflexivity. Qed.

(** * Nets *)

Example quinary_net_step : exceeds_net_step (Scheme 25 0 (rules quinary)) chaikin 0 0 0 1 1.
Proof.
  apply (exceeds_net_step_by (Scheme 25 0 (rules quinary)) chaikin 0 0 0 0 [0; 1; 0]%Z 0 [0; 1]%Z 0 0).
  vm_compute. reflexivity.
Qed.

Example chaikin_net_distance : exceeds_net_distance chaikin chaikin 0 0 0 1 (9 # 10).
Proof.
  apply (exceeds_net_distance_by chaikin chaikin 0 0 0 0 [0; 1]%Z 0 [0; 1]%Z 0 0 1 (9 # 10) 9 1 1 (1 # 100) 1 1 (1 # 100)).
  vm_compute. reflexivity.
Qed.

(** The bound of all nets is nearly attained: 9/10 is exceeded by the net above, so that the bound is not 9/10. *)
Example chaikin_net_bound : bounds_net_distance chaikin chaikin 0 0 0 1.
Proof. apply (bounds_net_distance_by chaikin chaikin 0 0 1). vm_compute. reflexivity. Qed.

Example chaikin_net_no_bound : ~ bounds_net_distance chaikin chaikin 0 0 0 (9 # 10).
Proof. apply (net_distance_refuted chaikin chaikin 0 0 0 1). exact chaikin_net_distance. Qed.

(** Arities 3 and 5, at level 3; negative weights make T_c Λ_c larger than T_c. *)
Example ternary_net_bound : bounds_net_distance ternary ternary 0 0 3 (92 # 100).
Proof. apply (bounds_net_distance_by ternary ternary 0 0 3). vm_compute. reflexivity. Qed.

Example quinary_net_bound : bounds_net_distance quinary quinary 0 0 3 (87 # 100).
Proof. apply (bounds_net_distance_by quinary quinary 0 0 2). vm_compute. reflexivity. Qed.

(** * Rings *)

(** Doo and Sabin's rules of a triangle. *)
Definition triangle := Ring 6 [[4; 1; 1]; [1; 4; 1]; [1; 1; 4]]%Z [(0, 1); (1, 2); (2, 0)]%nat.

Example triangle_refined : ring_level triangle 1 [6; 0; 0] = [24 # 6; 6 # 6; 6 # 6].
Proof. reflexivity. Qed.

Example triangle_limit : ring_tends_to triangle [1; 0; 0] (1 # 3).
Proof. apply (ring_limit triangle 3 [1; 1; 1]%Z [1; 0; 0]); reflexivity. Qed.

Example triangle_difference : exceeds_ring_difference triangle 1 1 (49 # 100).
Proof. apply (exceeds_ring_difference_by triangle 1 [1; 0; 0]%Z 0 1). vm_compute. reflexivity. Qed.

(** The points stay where they are, or move half the way to the next one. *)
Definition stay := Ring 1 [[1; 0; 0]; [0; 1; 0]; [0; 0; 1]]%Z (edges triangle).
Definition half := Ring 2 [[1; 1; 0]; [0; 1; 1]; [1; 0; 1]]%Z (edges triangle).

Example triangle_step : exceeds_ring_step triangle stay 0 1 (1 # 4).
Proof. apply (exceeds_ring_step_by triangle stay 0 [1; 0; 0]%Z 0). vm_compute. reflexivity. Qed.

(** Another rule for the points before says something else: the first point is 1/6 off, and not 1/3. *)
Example triangle_step_half :
  ring_step_exceeded triangle half 0 [1; 0; 0]%Z 0 1 (1 # 4) = false /\ exceeds_ring_step triangle half 0 1 (1 # 7).
Proof. split; [reflexivity|]. apply (exceeds_ring_step_by triangle half 0 [1; 0; 0]%Z 0). vm_compute. reflexivity. Qed.

Example triangle_distance : exceeds_ring_distance triangle 1 1 (2 # 9).
Proof. apply (exceeds_ring_distance_by triangle 1 [1; 0; 0]%Z 0 3 [1; 1; 1]%Z). vm_compute. reflexivity. Qed.
