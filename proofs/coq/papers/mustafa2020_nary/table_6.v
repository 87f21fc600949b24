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
  sufficient_depth scheme_2 (1 # 10) (63 # 50000) 5.
Proof. apply (sufficient_depth_by scheme_2 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 2: Table 6, c_0 = 1, ε = 1.35e-5 prints 12 *)
(* This depth suffices. *)
Theorem finding_3 :
  sufficient_depth scheme_2 (1 # 10) (27 # 2000000) 10.
Proof. apply (sufficient_depth_by scheme_2 3 3). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 3: Table 6, c_0 = 1, ε = 1.45e-7 prints 17 *)
(* This depth suffices. *)
Theorem finding_4 :
  sufficient_depth scheme_2 (1 # 10) (29 # 200000000) 14.
Proof. apply (sufficient_depth_by scheme_2 4 4). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 4: Table 6, c_0 = 1, ε = 1.56e-9 prints 23 *)
(* This depth suffices. *)
Theorem finding_5 :
  sufficient_depth scheme_2 (1 # 10) (39 # 25000000000) 18.
Proof. apply (sufficient_depth_by scheme_2 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 5: Table 6, c_0 = 1, ε = 1.67e-11 prints 28 *)
(* This depth suffices. *)
Theorem finding_6 :
  sufficient_depth scheme_2 (1 # 10) (167 # 10000000000000) 23.
Proof. apply (sufficient_depth_by scheme_2 4 4). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 6: Table 6, c_0 = 1, ε = 1.79e-13 prints 34 *)
(* This depth suffices. *)
Theorem finding_7 :
  sufficient_depth scheme_2 (1 # 10) (179 # 1000000000000000) 27.
Proof. apply (sufficient_depth_by scheme_2 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 7: Table 6, c_0 = 1, ε = 1.92e-15 prints 40 *)
(* This depth suffices. *)
Theorem finding_8 :
  sufficient_depth scheme_2 (1 # 10) (3 # 1562500000000000) 31.
Proof. apply (sufficient_depth_by scheme_2 6 6). vm_cast_no_check (eq_refl true). Qed.

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
  sufficient_depth scheme_2 (1 # 10) (63 # 50000) 5.
Proof. apply (sufficient_depth_by scheme_2 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 1: Table 6, c_0 = 2, ε = 1.26e-3 prints 3 *)
(* Broken at level 3: 63/50000 for points of spread 1/10 *)
Theorem finding_11 :
  exceeds_distance scheme_2 3 1 (63 # 5000).
Proof. apply (exceeds_distance_by scheme_2 3 0 [0; -1; 0; 1; 0]%Z 0 1 (63 # 5000)
  7 1 1 (1 # 64)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 2: Table 6, c_0 = 2, ε = 1.35e-5 prints 5 *)
(* This depth suffices. *)
Theorem finding_12 :
  sufficient_depth scheme_2 (1 # 10) (27 # 2000000) 10.
Proof. apply (sufficient_depth_by scheme_2 3 3). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 2: Table 6, c_0 = 2, ε = 1.35e-5 prints 5 *)
(* Broken at level 5: 27/2000000 for points of spread 1/10 *)
Theorem finding_13 :
  exceeds_distance scheme_2 5 1 (27 # 200000).
Proof. apply (exceeds_distance_by scheme_2 5 0 [0; -1; 0; 1; 0]%Z 0 1 (27 # 200000)
  9 1 1 (1 # 512)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 3: Table 6, c_0 = 2, ε = 1.45e-7 prints 8 *)
(* This depth suffices. *)
Theorem finding_14 :
  sufficient_depth scheme_2 (1 # 10) (29 # 200000000) 14.
Proof. apply (sufficient_depth_by scheme_2 4 4). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 3: Table 6, c_0 = 2, ε = 1.45e-7 prints 8 *)
(* Broken at level 8: 29/200000000 for points of spread 1/10 *)
Theorem finding_15 :
  exceeds_distance scheme_2 8 1 (29 # 20000000).
Proof. apply (exceeds_distance_by scheme_2 8 0 [0; -1; 0; 1; 0]%Z 0 1 (29 # 20000000)
  13 1 1 (1 # 16384)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 4: Table 6, c_0 = 2, ε = 1.56e-9 prints 11 *)
(* This depth suffices. *)
Theorem finding_16 :
  sufficient_depth scheme_2 (1 # 10) (39 # 25000000000) 18.
Proof. apply (sufficient_depth_by scheme_2 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 4: Table 6, c_0 = 2, ε = 1.56e-9 prints 11 *)
(* Broken at level 11: 39/25000000000 for points of spread 1/10 *)
Theorem finding_17 :
  exceeds_distance scheme_2 11 1 (39 # 2500000000).
Proof. apply (exceeds_distance_by scheme_2 11 0 [0; -1; 0; 1; 0]%Z 0 1 (39 # 2500000000)
  17 1 1 (1 # 262144)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 5: Table 6, c_0 = 2, ε = 1.67e-11 prints 13 *)
(* This depth suffices. *)
Theorem finding_18 :
  sufficient_depth scheme_2 (1 # 10) (167 # 10000000000000) 23.
Proof. apply (sufficient_depth_by scheme_2 4 4). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 5: Table 6, c_0 = 2, ε = 1.67e-11 prints 13 *)
(* Broken at level 13: 167/10000000000000 for points of spread 1/10 *)
Theorem finding_19 :
  exceeds_distance scheme_2 13 1 (167 # 1000000000000).
Proof. apply (exceeds_distance_by scheme_2 13 0 [0; -1; 0; 1; 0]%Z 0 1 (167 # 1000000000000)
  20 1 1 (1 # 4194304)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 6: Table 6, c_0 = 2, ε = 1.79e-13 prints 16 *)
(* This depth suffices. *)
Theorem finding_20 :
  sufficient_depth scheme_2 (1 # 10) (179 # 1000000000000000) 27.
Proof. apply (sufficient_depth_by scheme_2 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 6: Table 6, c_0 = 2, ε = 1.79e-13 prints 16 *)
(* Broken at level 16: 179/1000000000000000 for points of spread 1/10 *)
Theorem finding_21 :
  exceeds_distance scheme_2 16 1 (179 # 100000000000000).
Proof. apply (exceeds_distance_by scheme_2 16 0 [0; -1; 0; 1; 0]%Z 0 1 (179 # 100000000000000)
  24 1 1 (1 # 67108864)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 7: Table 6, c_0 = 2, ε = 1.92e-15 prints 18 *)
(* This depth suffices. *)
Theorem finding_22 :
  sufficient_depth scheme_2 (1 # 10) (3 # 1562500000000000) 31.
Proof. apply (sufficient_depth_by scheme_2 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 7: Table 6, c_0 = 2, ε = 1.92e-15 prints 18 *)
(* Broken at level 18: 3/1562500000000000 for points of spread 1/10 *)
Theorem finding_23 :
  exceeds_distance scheme_2 18 1 (3 # 156250000000000).
Proof. apply (exceeds_distance_by scheme_2 18 0 [0; -1; 0; 1; 0]%Z 0 1 (3 # 156250000000000)
  26 1 1 (1 # 536870912)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 1: Table 6, c_0 = 3, ε = 1.26e-3 prints 2 *)
(* It rests on this constant. *)
Theorem finding_24 :
  backwards_constant scheme_1 difference_1 3 (4590137 # 68024448).
Proof. apply backwards_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 1: Table 6, c_0 = 3, ε = 1.26e-3 prints 2 *)
(* This depth suffices. *)
Theorem finding_25 :
  sufficient_depth scheme_2 (1 # 10) (63 # 50000) 5.
Proof. apply (sufficient_depth_by scheme_2 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 1: Table 6, c_0 = 3, ε = 1.26e-3 prints 2 *)
(* Broken at level 2: 63/50000 for points of spread 1/10 *)
Theorem finding_26 :
  exceeds_distance scheme_2 2 1 (63 # 5000).
Proof. apply (exceeds_distance_by scheme_2 2 0 [0; -1; 0; 1; 2]%Z 0 1 (63 # 5000)
  5 1 1 (1 # 16)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 2: Table 6, c_0 = 3, ε = 1.35e-5 prints 3 *)
(* This depth suffices. *)
Theorem finding_27 :
  sufficient_depth scheme_2 (1 # 10) (27 # 2000000) 10.
Proof. apply (sufficient_depth_by scheme_2 3 3). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 2: Table 6, c_0 = 3, ε = 1.35e-5 prints 3 *)
(* Broken at level 3: 27/2000000 for points of spread 1/10 *)
Theorem finding_28 :
  exceeds_distance scheme_2 3 1 (27 # 200000).
Proof. apply (exceeds_distance_by scheme_2 3 0 [0; -1; 0; 1; 0]%Z 0 1 (27 # 200000)
  7 1 1 (1 # 64)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 3: Table 6, c_0 = 3, ε = 1.45e-7 prints 5 *)
(* This depth suffices. *)
Theorem finding_29 :
  sufficient_depth scheme_2 (1 # 10) (29 # 200000000) 14.
Proof. apply (sufficient_depth_by scheme_2 4 4). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 3: Table 6, c_0 = 3, ε = 1.45e-7 prints 5 *)
(* Broken at level 5: 29/200000000 for points of spread 1/10 *)
Theorem finding_30 :
  exceeds_distance scheme_2 5 1 (29 # 20000000).
Proof. apply (exceeds_distance_by scheme_2 5 0 [0; -1; 0; 1; 0]%Z 0 1 (29 # 20000000)
  9 1 1 (1 # 512)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 4: Table 6, c_0 = 3, ε = 1.56e-9 prints 7 *)
(* This depth suffices. *)
Theorem finding_31 :
  sufficient_depth scheme_2 (1 # 10) (39 # 25000000000) 18.
Proof. apply (sufficient_depth_by scheme_2 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 4: Table 6, c_0 = 3, ε = 1.56e-9 prints 7 *)
(* Broken at level 7: 39/25000000000 for points of spread 1/10 *)
Theorem finding_32 :
  exceeds_distance scheme_2 7 1 (39 # 2500000000).
Proof. apply (exceeds_distance_by scheme_2 7 0 [0; -1; 0; 1; 0]%Z 0 1 (39 # 2500000000)
  12 1 1 (1 # 4096)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 5: Table 6, c_0 = 3, ε = 1.67e-11 prints 8 *)
(* This depth suffices. *)
Theorem finding_33 :
  sufficient_depth scheme_2 (1 # 10) (167 # 10000000000000) 23.
Proof. apply (sufficient_depth_by scheme_2 4 4). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 5: Table 6, c_0 = 3, ε = 1.67e-11 prints 8 *)
(* Broken at level 8: 167/10000000000000 for points of spread 1/10 *)
Theorem finding_34 :
  exceeds_distance scheme_2 8 1 (167 # 1000000000000).
Proof. apply (exceeds_distance_by scheme_2 8 0 [0; -1; 0; 1; 0]%Z 0 1 (167 # 1000000000000)
  13 1 1 (1 # 16384)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 6: Table 6, c_0 = 3, ε = 1.79e-13 prints 10 *)
(* This depth suffices. *)
Theorem finding_35 :
  sufficient_depth scheme_2 (1 # 10) (179 # 1000000000000000) 27.
Proof. apply (sufficient_depth_by scheme_2 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 6: Table 6, c_0 = 3, ε = 1.79e-13 prints 10 *)
(* Broken at level 10: 179/1000000000000000 for points of spread 1/10 *)
Theorem finding_36 :
  exceeds_distance scheme_2 10 1 (179 # 100000000000000).
Proof. apply (exceeds_distance_by scheme_2 10 0 [0; -1; 0; 1; 0]%Z 0 1 (179 # 100000000000000)
  16 1 1 (1 # 131072)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 7: Table 6, c_0 = 3, ε = 1.92e-15 prints 12 *)
(* This depth suffices. *)
Theorem finding_37 :
  sufficient_depth scheme_2 (1 # 10) (3 # 1562500000000000) 31.
Proof. apply (sufficient_depth_by scheme_2 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 7: Table 6, c_0 = 3, ε = 1.92e-15 prints 12 *)
(* Broken at level 12: 3/1562500000000000 for points of spread 1/10 *)
Theorem finding_38 :
  exceeds_distance scheme_2 12 1 (3 # 156250000000000).
Proof. apply (exceeds_distance_by scheme_2 12 0 [0; -1; 0; 1; 0]%Z 0 1 (3 # 156250000000000)
  18 1 1 (1 # 1048576)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 1: Table 6, c_0 = 4, ε = 1.26e-3 prints 1 *)
(* It rests on this constant. *)
Theorem finding_39 :
  backwards_constant scheme_1 difference_1 4 (1196159543 # 44079842304).
Proof. apply backwards_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 1: Table 6, c_0 = 4, ε = 1.26e-3 prints 1 *)
(* This depth suffices. *)
Theorem finding_40 :
  sufficient_depth scheme_2 (1 # 10) (63 # 50000) 5.
Proof. apply (sufficient_depth_by scheme_2 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 1: Table 6, c_0 = 4, ε = 1.26e-3 prints 1 *)
(* Broken at level 1: 63/50000 for points of spread 1/10 *)
Theorem finding_41 :
  exceeds_distance scheme_2 1 1 (63 # 5000).
Proof. apply (exceeds_distance_by scheme_2 1 0 [0; -1; 0; -1; 0]%Z 0 1 (63 # 5000)
  4 1 1 (1 # 8)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 2: Table 6, c_0 = 4, ε = 1.35e-5 prints 3 *)
(* This depth suffices. *)
Theorem finding_42 :
  sufficient_depth scheme_2 (1 # 10) (27 # 2000000) 10.
Proof. apply (sufficient_depth_by scheme_2 3 3). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 2: Table 6, c_0 = 4, ε = 1.35e-5 prints 3 *)
(* Broken at level 3: 27/2000000 for points of spread 1/10 *)
Theorem finding_43 :
  exceeds_distance scheme_2 3 1 (27 # 200000).
Proof. apply (exceeds_distance_by scheme_2 3 0 [0; -1; 0; 1; 0]%Z 0 1 (27 # 200000)
  7 1 1 (1 # 64)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 3: Table 6, c_0 = 4, ε = 1.45e-7 prints 4 *)
(* This depth suffices. *)
Theorem finding_44 :
  sufficient_depth scheme_2 (1 # 10) (29 # 200000000) 14.
Proof. apply (sufficient_depth_by scheme_2 4 4). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 3: Table 6, c_0 = 4, ε = 1.45e-7 prints 4 *)
(* Broken at level 4: 29/200000000 for points of spread 1/10 *)
Theorem finding_45 :
  exceeds_distance scheme_2 4 1 (29 # 20000000).
Proof. apply (exceeds_distance_by scheme_2 4 0 [0; -1; 0; 1; 0]%Z 0 1 (29 # 20000000)
  7 1 1 (1 # 128)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 4: Table 6, c_0 = 4, ε = 1.56e-9 prints 5 *)
(* This depth suffices. *)
Theorem finding_46 :
  sufficient_depth scheme_2 (1 # 10) (39 # 25000000000) 18.
Proof. apply (sufficient_depth_by scheme_2 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 4: Table 6, c_0 = 4, ε = 1.56e-9 prints 5 *)
(* Broken at level 5: 39/25000000000 for points of spread 1/10 *)
Theorem finding_47 :
  exceeds_distance scheme_2 5 1 (39 # 2500000000).
Proof. apply (exceeds_distance_by scheme_2 5 0 [0; -1; 0; 1; 0]%Z 0 1 (39 # 2500000000)
  9 1 1 (1 # 512)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 5: Table 6, c_0 = 4, ε = 1.67e-11 prints 6 *)
(* This depth suffices. *)
Theorem finding_48 :
  sufficient_depth scheme_2 (1 # 10) (167 # 10000000000000) 23.
Proof. apply (sufficient_depth_by scheme_2 4 4). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 5: Table 6, c_0 = 4, ε = 1.67e-11 prints 6 *)
(* Broken at level 6: 167/10000000000000 for points of spread 1/10 *)
Theorem finding_49 :
  exceeds_distance scheme_2 6 1 (167 # 1000000000000).
Proof. apply (exceeds_distance_by scheme_2 6 0 [0; -1; 0; 1; 0]%Z 0 1 (167 # 1000000000000)
  10 1 1 (1 # 1024)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 6: Table 6, c_0 = 4, ε = 1.79e-13 prints 8 *)
(* This depth suffices. *)
Theorem finding_50 :
  sufficient_depth scheme_2 (1 # 10) (179 # 1000000000000000) 27.
Proof. apply (sufficient_depth_by scheme_2 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 6: Table 6, c_0 = 4, ε = 1.79e-13 prints 8 *)
(* Broken at level 8: 179/1000000000000000 for points of spread 1/10 *)
Theorem finding_51 :
  exceeds_distance scheme_2 8 1 (179 # 100000000000000).
Proof. apply (exceeds_distance_by scheme_2 8 0 [0; -1; 0; 1; 0]%Z 0 1 (179 # 100000000000000)
  13 1 1 (1 # 16384)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 7: Table 6, c_0 = 4, ε = 1.92e-15 prints 9 *)
(* This depth suffices. *)
Theorem finding_52 :
  sufficient_depth scheme_2 (1 # 10) (3 # 1562500000000000) 31.
Proof. apply (sufficient_depth_by scheme_2 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 7: Table 6, c_0 = 4, ε = 1.92e-15 prints 9 *)
(* Broken at level 9: 3/1562500000000000 for points of spread 1/10 *)
Theorem finding_53 :
  exceeds_distance scheme_2 9 1 (3 # 156250000000000).
Proof. apply (exceeds_distance_by scheme_2 9 0 [0; -1; 0; 1; 0]%Z 0 1 (3 # 156250000000000)
  14 1 1 (1 # 32768)). vm_cast_no_check (eq_refl true). Qed.
