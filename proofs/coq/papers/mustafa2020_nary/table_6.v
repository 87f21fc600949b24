(** mustafa2020-nary, table table-6 (written by `subcert prove --coq`) *)
(* Not stated: tau = 1/10 *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition scheme_1 :=
  Scheme 1296 (-1) [[-55; 1155; 231; -35]; [-81; 729; 729; -81]; [-35; 231; 1155; -55]]%Z.

(* row 1, column 1: Table 6, c_0 = 1, ε = 1.26e-3 prints 6 *)
(* It rests on this constant. *)
Theorem finding_1 :
  contraction_constant scheme_1 1 (143 # 324).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

Definition scheme_2 :=
  Scheme 1296 0 [[-55; 1155; 231; -35]; [-81; 729; 729; -81]; [-35; 231; 1155; -55]]%Z.

(* row 1, column 1: Table 6, c_0 = 1, ε = 1.26e-3 prints 6 *)
(* This depth suffices. *)
Theorem finding_2 :
  sufficient_depth scheme_2 0 (1 # 10) (63 # 50000) 5.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 2: Table 6, c_0 = 1, ε = 1.35e-5 prints 12 *)
(* This depth suffices. *)
Theorem finding_3 :
  sufficient_depth scheme_2 0 (1 # 10) (27 # 2000000) 10.
Proof. apply (sufficient_depth_by scheme_2 0 3 3). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 3: Table 6, c_0 = 1, ε = 1.45e-7 prints 17 *)
(* This depth suffices. *)
Theorem finding_4 :
  sufficient_depth scheme_2 0 (1 # 10) (29 # 200000000) 14.
Proof. apply (sufficient_depth_by scheme_2 0 4 4). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 4: Table 6, c_0 = 1, ε = 1.56e-9 prints 23 *)
(* This depth suffices. *)
Theorem finding_5 :
  sufficient_depth scheme_2 0 (1 # 10) (39 # 25000000000) 18.
Proof. apply (sufficient_depth_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 5: Table 6, c_0 = 1, ε = 1.67e-11 prints 28 *)
(* This depth suffices. *)
Theorem finding_6 :
  sufficient_depth scheme_2 0 (1 # 10) (167 # 10000000000000) 23.
Proof. apply (sufficient_depth_by scheme_2 0 4 4). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 6: Table 6, c_0 = 1, ε = 1.79e-13 prints 34 *)
(* This depth suffices. *)
Theorem finding_7 :
  sufficient_depth scheme_2 0 (1 # 10) (179 # 1000000000000000) 27.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 7: Table 6, c_0 = 1, ε = 1.92e-15 prints 40 *)
(* This depth suffices. *)
Theorem finding_8 :
  sufficient_depth scheme_2 0 (1 # 10) (3 # 1562500000000000) 31.
Proof. apply (sufficient_depth_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

Definition difference_1 :=
  Scheme 1296 (-1) [[26; 452; -46; 0]; [-46; 452; 26; 0]; [-35; 251; 251; -35]]%Z.

(* row 2, column 1: Table 6, c_0 = 2, ε = 1.26e-3 prints 3 *)
(* It rests on this constant. *)
Theorem finding_9 :
  backwards_constant scheme_1 difference_1 2 (18517 # 104976).
Proof. apply backwards_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 1: Table 6, c_0 = 2, ε = 1.26e-3 prints 3 *)
(* This depth suffices. *)
Theorem finding_10 :
  sufficient_depth scheme_2 0 (1 # 10) (63 # 50000) 5.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 1: Table 6, c_0 = 2, ε = 1.26e-3 prints 3 *)
(* Broken at level 3: 63/50000 for points of spread 1/10 *)
Theorem finding_11 :
  exceeds_distance scheme_2 0 3 1 (63 # 5000).
Proof. apply (exceeds_distance_by scheme_2 0 3 0 [0; -1; 0; 1; 0]%Z 0 1 (63 # 5000)
  7 1 1 (1 # 64)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 2: Table 6, c_0 = 2, ε = 1.35e-5 prints 5 *)
(* This depth suffices. *)
Theorem finding_12 :
  sufficient_depth scheme_2 0 (1 # 10) (27 # 2000000) 10.
Proof. apply (sufficient_depth_by scheme_2 0 3 3). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 2: Table 6, c_0 = 2, ε = 1.35e-5 prints 5 *)
(* Broken at level 5: 27/2000000 for points of spread 1/10 *)
Theorem finding_13 :
  exceeds_distance scheme_2 0 5 1 (27 # 200000).
Proof. apply (exceeds_distance_by scheme_2 0 5 0 [0; -1; 0; 1; 0]%Z 0 1 (27 # 200000)
  9 1 1 (1 # 512)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 3: Table 6, c_0 = 2, ε = 1.45e-7 prints 8 *)
(* This depth suffices. *)
Theorem finding_14 :
  sufficient_depth scheme_2 0 (1 # 10) (29 # 200000000) 14.
Proof. apply (sufficient_depth_by scheme_2 0 4 4). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 3: Table 6, c_0 = 2, ε = 1.45e-7 prints 8 *)
(* Broken at level 8: 29/200000000 for points of spread 1/10 *)
Theorem finding_15 :
  exceeds_distance scheme_2 0 8 1 (29 # 20000000).
Proof. apply (exceeds_distance_by scheme_2 0 8 0 [0; -1; 0; 1; 0]%Z 0 1 (29 # 20000000)
  13 1 1 (1 # 16384)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 4: Table 6, c_0 = 2, ε = 1.56e-9 prints 11 *)
(* This depth suffices. *)
Theorem finding_16 :
  sufficient_depth scheme_2 0 (1 # 10) (39 # 25000000000) 18.
Proof. apply (sufficient_depth_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 4: Table 6, c_0 = 2, ε = 1.56e-9 prints 11 *)
(* Broken at level 11: 39/25000000000 for points of spread 1/10 *)
Theorem finding_17 :
  exceeds_distance scheme_2 0 11 1 (39 # 2500000000).
Proof. apply (exceeds_distance_by scheme_2 0 11 0 [0; -1; 0; 1; 0]%Z 0 1 (39 # 2500000000)
  17 1 1 (1 # 262144)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 5: Table 6, c_0 = 2, ε = 1.67e-11 prints 13 *)
(* This depth suffices. *)
Theorem finding_18 :
  sufficient_depth scheme_2 0 (1 # 10) (167 # 10000000000000) 23.
Proof. apply (sufficient_depth_by scheme_2 0 4 4). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 5: Table 6, c_0 = 2, ε = 1.67e-11 prints 13 *)
(* Broken at level 13: 167/10000000000000 for points of spread 1/10 *)
Theorem finding_19 :
  exceeds_distance scheme_2 0 13 1 (167 # 1000000000000).
Proof. apply (exceeds_distance_by scheme_2 0 13 0 [0; -1; 0; 1; 0]%Z 0 1 (167 # 1000000000000)
  20 1 1 (1 # 4194304)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 6: Table 6, c_0 = 2, ε = 1.79e-13 prints 16 *)
(* This depth suffices. *)
Theorem finding_20 :
  sufficient_depth scheme_2 0 (1 # 10) (179 # 1000000000000000) 27.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 6: Table 6, c_0 = 2, ε = 1.79e-13 prints 16 *)
(* Broken at level 16: 179/1000000000000000 for points of spread 1/10 *)
Theorem finding_21 :
  exceeds_distance scheme_2 0 16 1 (179 # 100000000000000).
Proof. apply (exceeds_distance_by scheme_2 0 16 0 [0; -1; 0; 1; 0]%Z 0 1 (179 # 100000000000000)
  24 1 1 (1 # 67108864)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 7: Table 6, c_0 = 2, ε = 1.92e-15 prints 18 *)
(* This depth suffices. *)
Theorem finding_22 :
  sufficient_depth scheme_2 0 (1 # 10) (3 # 1562500000000000) 31.
Proof. apply (sufficient_depth_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 7: Table 6, c_0 = 2, ε = 1.92e-15 prints 18 *)
(* Broken at level 18: 3/1562500000000000 for points of spread 1/10 *)
Theorem finding_23 :
  exceeds_distance scheme_2 0 18 1 (3 # 156250000000000).
Proof. apply (exceeds_distance_by scheme_2 0 18 0 [0; -1; 0; 1; 0]%Z 0 1 (3 # 156250000000000)
  26 1 1 (1 # 536870912)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 1: Table 6, c_0 = 3, ε = 1.26e-3 prints 2 *)
(* It rests on this constant. *)
Theorem finding_24 :
  backwards_constant scheme_1 difference_1 3 (4590137 # 68024448).
Proof. apply backwards_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 1: Table 6, c_0 = 3, ε = 1.26e-3 prints 2 *)
(* This depth suffices. *)
Theorem finding_25 :
  sufficient_depth scheme_2 0 (1 # 10) (63 # 50000) 5.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 1: Table 6, c_0 = 3, ε = 1.26e-3 prints 2 *)
(* Broken at level 2: 63/50000 for points of spread 1/10 *)
Theorem finding_26 :
  exceeds_distance scheme_2 0 2 1 (63 # 5000).
Proof. apply (exceeds_distance_by scheme_2 0 2 0 [0; -1; 0; 1; 2]%Z 0 1 (63 # 5000)
  5 1 1 (1 # 16)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 2: Table 6, c_0 = 3, ε = 1.35e-5 prints 3 *)
(* This depth suffices. *)
Theorem finding_27 :
  sufficient_depth scheme_2 0 (1 # 10) (27 # 2000000) 10.
Proof. apply (sufficient_depth_by scheme_2 0 3 3). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 2: Table 6, c_0 = 3, ε = 1.35e-5 prints 3 *)
(* Broken at level 3: 27/2000000 for points of spread 1/10 *)
Theorem finding_28 :
  exceeds_distance scheme_2 0 3 1 (27 # 200000).
Proof. apply (exceeds_distance_by scheme_2 0 3 0 [0; -1; 0; 1; 0]%Z 0 1 (27 # 200000)
  7 1 1 (1 # 64)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 2: Table 6, c_0 = 3, ε = 1.35e-5 prints 3 *)
(* Broken at natural parameters at level 3: 27/2000000 for points of spread 1/10 *)
Theorem finding_29 :
  exceeds_distance scheme_2 (-7 # 4) 3 1 (27 # 200000).
Proof. apply (exceeds_distance_by scheme_2 (-7 # 4) 3 1 [0; -1; 0; -1; 0]%Z 1 1 (27 # 200000)
  11 1 1 (1 # 16384)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 3: Table 6, c_0 = 3, ε = 1.45e-7 prints 5 *)
(* This depth suffices. *)
Theorem finding_30 :
  sufficient_depth scheme_2 0 (1 # 10) (29 # 200000000) 14.
Proof. apply (sufficient_depth_by scheme_2 0 4 4). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 3: Table 6, c_0 = 3, ε = 1.45e-7 prints 5 *)
(* Broken at level 5: 29/200000000 for points of spread 1/10 *)
Theorem finding_31 :
  exceeds_distance scheme_2 0 5 1 (29 # 20000000).
Proof. apply (exceeds_distance_by scheme_2 0 5 0 [0; -1; 0; 1; 0]%Z 0 1 (29 # 20000000)
  9 1 1 (1 # 512)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 3: Table 6, c_0 = 3, ε = 1.45e-7 prints 5 *)
(* Broken at natural parameters at level 5: 29/200000000 for points of spread 1/10 *)
Theorem finding_32 :
  exceeds_distance scheme_2 (-7 # 4) 5 1 (29 # 20000000).
Proof. apply (exceeds_distance_by scheme_2 (-7 # 4) 5 1 [0; -1; 0; -1; 0]%Z 1 1 (29 # 20000000)
  16 1 1 (1 # 1048576)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 4: Table 6, c_0 = 3, ε = 1.56e-9 prints 7 *)
(* This depth suffices. *)
Theorem finding_33 :
  sufficient_depth scheme_2 0 (1 # 10) (39 # 25000000000) 18.
Proof. apply (sufficient_depth_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 4: Table 6, c_0 = 3, ε = 1.56e-9 prints 7 *)
(* Broken at level 7: 39/25000000000 for points of spread 1/10 *)
Theorem finding_34 :
  exceeds_distance scheme_2 0 7 1 (39 # 2500000000).
Proof. apply (exceeds_distance_by scheme_2 0 7 0 [0; -1; 0; 1; 0]%Z 0 1 (39 # 2500000000)
  12 1 1 (1 # 4096)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 4: Table 6, c_0 = 3, ε = 1.56e-9 prints 7 *)
(* Broken at natural parameters at level 7: 39/25000000000 for points of spread 1/10 *)
Theorem finding_35 :
  exceeds_distance scheme_2 (-7 # 4) 7 1 (39 # 2500000000).
Proof. apply (exceeds_distance_by scheme_2 (-7 # 4) 7 1 [0; -1; 0; -1; 0]%Z 1 1 (39 # 2500000000)
  21 1 1 (1 # 67108864)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 5: Table 6, c_0 = 3, ε = 1.67e-11 prints 8 *)
(* This depth suffices. *)
Theorem finding_36 :
  sufficient_depth scheme_2 0 (1 # 10) (167 # 10000000000000) 23.
Proof. apply (sufficient_depth_by scheme_2 0 4 4). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 5: Table 6, c_0 = 3, ε = 1.67e-11 prints 8 *)
(* Broken at level 8: 167/10000000000000 for points of spread 1/10 *)
Theorem finding_37 :
  exceeds_distance scheme_2 0 8 1 (167 # 1000000000000).
Proof. apply (exceeds_distance_by scheme_2 0 8 0 [0; -1; 0; 1; 0]%Z 0 1 (167 # 1000000000000)
  13 1 1 (1 # 16384)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 5: Table 6, c_0 = 3, ε = 1.67e-11 prints 8 *)
(* Broken at natural parameters at level 8: 167/10000000000000 for points of spread 1/10 *)
Theorem finding_38 :
  exceeds_distance scheme_2 (-7 # 4) 8 1 (167 # 1000000000000).
Proof. apply (exceeds_distance_by scheme_2 (-7 # 4) 8 1 [0; -1; 0; -1; 0]%Z 1 1 (167 # 1000000000000)
  23 1 1 (1 # 536870912)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 6: Table 6, c_0 = 3, ε = 1.79e-13 prints 10 *)
(* This depth suffices. *)
Theorem finding_39 :
  sufficient_depth scheme_2 0 (1 # 10) (179 # 1000000000000000) 27.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 6: Table 6, c_0 = 3, ε = 1.79e-13 prints 10 *)
(* Broken at level 10: 179/1000000000000000 for points of spread 1/10 *)
Theorem finding_40 :
  exceeds_distance scheme_2 0 10 1 (179 # 100000000000000).
Proof. apply (exceeds_distance_by scheme_2 0 10 0 [0; -1; 0; 1; 0]%Z 0 1 (179 # 100000000000000)
  16 1 1 (1 # 131072)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 6: Table 6, c_0 = 3, ε = 1.79e-13 prints 10 *)
(* Broken at natural parameters at level 10: 179/1000000000000000 for points of spread 1/10 *)
Theorem finding_41 :
  exceeds_distance scheme_2 (-7 # 4) 10 1 (179 # 100000000000000).
Proof. apply (exceeds_distance_by scheme_2 (-7 # 4) 10 1 [0; -1; 0; -1; 0]%Z 1 1 (179 # 100000000000000)
  28 1 1 (1 # 34359738368)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 7: Table 6, c_0 = 3, ε = 1.92e-15 prints 12 *)
(* This depth suffices. *)
Theorem finding_42 :
  sufficient_depth scheme_2 0 (1 # 10) (3 # 1562500000000000) 31.
Proof. apply (sufficient_depth_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 7: Table 6, c_0 = 3, ε = 1.92e-15 prints 12 *)
(* Broken at level 12: 3/1562500000000000 for points of spread 1/10 *)
Theorem finding_43 :
  exceeds_distance scheme_2 0 12 1 (3 # 156250000000000).
Proof. apply (exceeds_distance_by scheme_2 0 12 0 [0; -1; 0; 1; 0]%Z 0 1 (3 # 156250000000000)
  18 1 1 (1 # 1048576)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 7: Table 6, c_0 = 3, ε = 1.92e-15 prints 12 *)
(* Broken at natural parameters at level 12: 3/1562500000000000 for points of spread 1/10 *)
Theorem finding_44 :
  exceeds_distance scheme_2 (-7 # 4) 12 1 (3 # 156250000000000).
Proof. apply (exceeds_distance_by scheme_2 (-7 # 4) 12 1 [0; -1; 0; -1; 0]%Z 1 1 (3 # 156250000000000)
  34 1 1 (1 # 4398046511104)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 1: Table 6, c_0 = 4, ε = 1.26e-3 prints 1 *)
(* It rests on this constant. *)
Theorem finding_45 :
  backwards_constant scheme_1 difference_1 4 (1196159543 # 44079842304).
Proof. apply backwards_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 1: Table 6, c_0 = 4, ε = 1.26e-3 prints 1 *)
(* This depth suffices. *)
Theorem finding_46 :
  sufficient_depth scheme_2 0 (1 # 10) (63 # 50000) 5.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 1: Table 6, c_0 = 4, ε = 1.26e-3 prints 1 *)
(* Broken at level 1: 63/50000 for points of spread 1/10 *)
Theorem finding_47 :
  exceeds_distance scheme_2 0 1 1 (63 # 5000).
Proof. apply (exceeds_distance_by scheme_2 0 1 0 [0; -1; 0; -1; 0]%Z 0 1 (63 # 5000)
  4 1 1 (1 # 8)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 1: Table 6, c_0 = 4, ε = 1.26e-3 prints 1 *)
(* Broken at natural parameters at level 1: 63/50000 for points of spread 1/10 *)
Theorem finding_48 :
  exceeds_distance scheme_2 (-7 # 4) 1 1 (63 # 5000).
Proof. apply (exceeds_distance_by scheme_2 (-7 # 4) 1 1 [0; 1; 2; 1; 2]%Z 1 1 (63 # 5000)
  6 1 1 (1 # 512)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 2: Table 6, c_0 = 4, ε = 1.35e-5 prints 3 *)
(* This depth suffices. *)
Theorem finding_49 :
  sufficient_depth scheme_2 0 (1 # 10) (27 # 2000000) 10.
Proof. apply (sufficient_depth_by scheme_2 0 3 3). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 2: Table 6, c_0 = 4, ε = 1.35e-5 prints 3 *)
(* Broken at level 3: 27/2000000 for points of spread 1/10 *)
Theorem finding_50 :
  exceeds_distance scheme_2 0 3 1 (27 # 200000).
Proof. apply (exceeds_distance_by scheme_2 0 3 0 [0; -1; 0; 1; 0]%Z 0 1 (27 # 200000)
  7 1 1 (1 # 64)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 2: Table 6, c_0 = 4, ε = 1.35e-5 prints 3 *)
(* Broken at natural parameters at level 3: 27/2000000 for points of spread 1/10 *)
Theorem finding_51 :
  exceeds_distance scheme_2 (-7 # 4) 3 1 (27 # 200000).
Proof. apply (exceeds_distance_by scheme_2 (-7 # 4) 3 1 [0; -1; 0; -1; 0]%Z 1 1 (27 # 200000)
  11 1 1 (1 # 16384)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 3: Table 6, c_0 = 4, ε = 1.45e-7 prints 4 *)
(* This depth suffices. *)
Theorem finding_52 :
  sufficient_depth scheme_2 0 (1 # 10) (29 # 200000000) 14.
Proof. apply (sufficient_depth_by scheme_2 0 4 4). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 3: Table 6, c_0 = 4, ε = 1.45e-7 prints 4 *)
(* Broken at level 4: 29/200000000 for points of spread 1/10 *)
Theorem finding_53 :
  exceeds_distance scheme_2 0 4 1 (29 # 20000000).
Proof. apply (exceeds_distance_by scheme_2 0 4 0 [0; -1; 0; 1; 0]%Z 0 1 (29 # 20000000)
  7 1 1 (1 # 128)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 3: Table 6, c_0 = 4, ε = 1.45e-7 prints 4 *)
(* Broken at natural parameters at level 4: 29/200000000 for points of spread 1/10 *)
Theorem finding_54 :
  exceeds_distance scheme_2 (-7 # 4) 4 1 (29 # 20000000).
Proof. apply (exceeds_distance_by scheme_2 (-7 # 4) 4 1 [0; -1; 0; -1; 0]%Z 1 1 (29 # 20000000)
  12 1 1 (1 # 65536)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 4: Table 6, c_0 = 4, ε = 1.56e-9 prints 5 *)
(* This depth suffices. *)
Theorem finding_55 :
  sufficient_depth scheme_2 0 (1 # 10) (39 # 25000000000) 18.
Proof. apply (sufficient_depth_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 4: Table 6, c_0 = 4, ε = 1.56e-9 prints 5 *)
(* Broken at level 5: 39/25000000000 for points of spread 1/10 *)
Theorem finding_56 :
  exceeds_distance scheme_2 0 5 1 (39 # 2500000000).
Proof. apply (exceeds_distance_by scheme_2 0 5 0 [0; -1; 0; 1; 0]%Z 0 1 (39 # 2500000000)
  9 1 1 (1 # 512)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 4: Table 6, c_0 = 4, ε = 1.56e-9 prints 5 *)
(* Broken at natural parameters at level 5: 39/25000000000 for points of spread 1/10 *)
Theorem finding_57 :
  exceeds_distance scheme_2 (-7 # 4) 5 1 (39 # 2500000000).
Proof. apply (exceeds_distance_by scheme_2 (-7 # 4) 5 1 [0; -1; 0; -1; 0]%Z 1 1 (39 # 2500000000)
  16 1 1 (1 # 1048576)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 5: Table 6, c_0 = 4, ε = 1.67e-11 prints 6 *)
(* This depth suffices. *)
Theorem finding_58 :
  sufficient_depth scheme_2 0 (1 # 10) (167 # 10000000000000) 23.
Proof. apply (sufficient_depth_by scheme_2 0 4 4). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 5: Table 6, c_0 = 4, ε = 1.67e-11 prints 6 *)
(* Broken at level 6: 167/10000000000000 for points of spread 1/10 *)
Theorem finding_59 :
  exceeds_distance scheme_2 0 6 1 (167 # 1000000000000).
Proof. apply (exceeds_distance_by scheme_2 0 6 0 [0; -1; 0; 1; 0]%Z 0 1 (167 # 1000000000000)
  10 1 1 (1 # 1024)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 5: Table 6, c_0 = 4, ε = 1.67e-11 prints 6 *)
(* Broken at natural parameters at level 6: 167/10000000000000 for points of spread 1/10 *)
Theorem finding_60 :
  exceeds_distance scheme_2 (-7 # 4) 6 1 (167 # 1000000000000).
Proof. apply (exceeds_distance_by scheme_2 (-7 # 4) 6 0 [0; -1; 0; -1; 0]%Z 0 1 (167 # 1000000000000)
  18 1 1 (1 # 8388608)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 6: Table 6, c_0 = 4, ε = 1.79e-13 prints 8 *)
(* This depth suffices. *)
Theorem finding_61 :
  sufficient_depth scheme_2 0 (1 # 10) (179 # 1000000000000000) 27.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 6: Table 6, c_0 = 4, ε = 1.79e-13 prints 8 *)
(* Broken at level 8: 179/1000000000000000 for points of spread 1/10 *)
Theorem finding_62 :
  exceeds_distance scheme_2 0 8 1 (179 # 100000000000000).
Proof. apply (exceeds_distance_by scheme_2 0 8 0 [0; -1; 0; 1; 0]%Z 0 1 (179 # 100000000000000)
  13 1 1 (1 # 16384)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 6: Table 6, c_0 = 4, ε = 1.79e-13 prints 8 *)
(* Broken at natural parameters at level 8: 179/1000000000000000 for points of spread 1/10 *)
Theorem finding_63 :
  exceeds_distance scheme_2 (-7 # 4) 8 1 (179 # 100000000000000).
Proof. apply (exceeds_distance_by scheme_2 (-7 # 4) 8 1 [0; -1; 0; -1; 0]%Z 1 1 (179 # 100000000000000)
  23 1 1 (1 # 536870912)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 7: Table 6, c_0 = 4, ε = 1.92e-15 prints 9 *)
(* This depth suffices. *)
Theorem finding_64 :
  sufficient_depth scheme_2 0 (1 # 10) (3 # 1562500000000000) 31.
Proof. apply (sufficient_depth_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 7: Table 6, c_0 = 4, ε = 1.92e-15 prints 9 *)
(* Broken at level 9: 3/1562500000000000 for points of spread 1/10 *)
Theorem finding_65 :
  exceeds_distance scheme_2 0 9 1 (3 # 156250000000000).
Proof. apply (exceeds_distance_by scheme_2 0 9 0 [0; -1; 0; 1; 0]%Z 0 1 (3 # 156250000000000)
  14 1 1 (1 # 32768)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 7: Table 6, c_0 = 4, ε = 1.92e-15 prints 9 *)
(* Broken at natural parameters at level 9: 3/1562500000000000 for points of spread 1/10 *)
Theorem finding_66 :
  exceeds_distance scheme_2 (-7 # 4) 9 1 (3 # 156250000000000).
Proof. apply (exceeds_distance_by scheme_2 (-7 # 4) 9 0 [0; -1; 0; -1; 0]%Z 0 1 (3 # 156250000000000)
  26 1 1 (1 # 4294967296)). vm_cast_no_check (eq_refl true). Qed.
