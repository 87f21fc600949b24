(** mustafa2020-nary, table table-2 (written by `subcert prove --coq`) *)
(* Not stated: tau = 1/10, w = 39/2000 *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition scheme_1 :=
  Scheme 2000 (-2) [[0; 0; 2000; 0; 0; 0]; [39; -242; 1203; 1203; -242; 39]]%Z.

(* row 1, column 1: Table 2, c_0 = 1, ε = 0.0266 prints 11 *)
(* It rests on this constant. *)
Theorem finding_1 :
  contraction_constant scheme_1 1 (371 # 500).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

Definition scheme_2 :=
  Scheme 2000 0 [[0; 0; 2000; 0; 0; 0]; [39; -242; 1203; 1203; -242; 39]]%Z.

(* row 1, column 1: Table 2, c_0 = 1, ε = 0.0266 prints 11 *)
(* This depth suffices. *)
Theorem finding_2 :
  sufficient_depth scheme_2 0 (1 # 10) (133 # 5000) 5.
Proof. apply (sufficient_depth_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 2: Table 2, c_0 = 1, ε = 0.0031 prints 18 *)
(* This depth suffices. *)
Theorem finding_3 :
  sufficient_depth scheme_2 0 (1 # 10) (31 # 10000) 9.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 3: Table 2, c_0 = 1, ε = 0.0003 prints 26 *)
(* This depth suffices. *)
Theorem finding_4 :
  sufficient_depth scheme_2 0 (1 # 10) (3 # 10000) 13.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 4: Table 2, c_0 = 1, ε = 4.35e-5 prints 33 *)
(* This depth suffices. *)
Theorem finding_5 :
  sufficient_depth scheme_2 0 (1 # 10) (87 # 2000000) 16.
Proof. apply (sufficient_depth_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 5: Table 2, c_0 = 1, ε = 5.12e-6 prints 40 *)
(* This depth suffices. *)
Theorem finding_6 :
  sufficient_depth scheme_2 0 (1 # 10) (2 # 390625) 20.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 6: Table 2, c_0 = 1, ε = 6.02 - 7 prints 47 *)
(* This depth suffices. *)
Theorem finding_7 :
  sufficient_depth scheme_2 0 (1 # 10) (301 # 500000000) 23.
Proof. apply (sufficient_depth_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 7: Table 2, c_0 = 1, ε = 7.09e-8 prints 54 *)
(* This depth suffices. *)
Theorem finding_8 :
  sufficient_depth scheme_2 0 (1 # 10) (709 # 10000000000) 27.
Proof. apply (sufficient_depth_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

Definition difference_1 :=
  Scheme 2000 (-2) [[-39; 203; 1000; -203; 39; 0]; [39; -203; 1000; 203; -39; 0]]%Z.

(* row 2, column 1: Table 2, c_0 = 2, ε = 0.0266 prints 3 *)
(* It rests on this constant. *)
Theorem finding_9 :
  backwards_constant scheme_1 difference_1 2 (176871 # 400000).
Proof. apply backwards_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 1: Table 2, c_0 = 2, ε = 0.0266 prints 3 *)
(* This depth suffices. *)
Theorem finding_10 :
  sufficient_depth scheme_2 0 (1 # 10) (133 # 5000) 5.
Proof. apply (sufficient_depth_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 1: Table 2, c_0 = 2, ε = 0.0266 prints 3 *)
(* Broken at level 3: 133/5000 for points of spread 1/10 *)
Theorem finding_11 :
  exceeds_distance scheme_2 0 3 1 (133 # 500).
Proof. apply (exceeds_distance_by scheme_2 0 3 1 [0; 1; 0; 1; 2; 1]%Z 0 1 (133 # 500)
  15 1 1 (1 # 8)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 2: Table 2, c_0 = 2, ε = 0.0031 prints 6 *)
(* This depth suffices. *)
Theorem finding_12 :
  sufficient_depth scheme_2 0 (1 # 10) (31 # 10000) 9.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 2: Table 2, c_0 = 2, ε = 0.0031 prints 6 *)
(* Broken at level 6: 31/10000 for points of spread 1/10 *)
Theorem finding_13 :
  exceeds_distance scheme_2 0 6 1 (31 # 1000).
Proof. apply (exceeds_distance_by scheme_2 0 6 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 1 (31 # 1000)
  22 1 1 (1 # 64)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 3: Table 2, c_0 = 2, ε = 0.0003 prints 8 *)
(* This depth suffices. *)
Theorem finding_14 :
  sufficient_depth scheme_2 0 (1 # 10) (3 # 10000) 13.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 3: Table 2, c_0 = 2, ε = 0.0003 prints 8 *)
(* Broken at level 8: 3/10000 for points of spread 1/10 *)
Theorem finding_15 :
  exceeds_distance scheme_2 0 8 1 (3 # 1000).
Proof. apply (exceeds_distance_by scheme_2 0 8 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 1 (3 # 1000)
  26 1 1 (1 # 256)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 4: Table 2, c_0 = 2, ε = 4.35e-5 prints 11 *)
(* This depth suffices. *)
Theorem finding_16 :
  sufficient_depth scheme_2 0 (1 # 10) (87 # 2000000) 16.
Proof. apply (sufficient_depth_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 4: Table 2, c_0 = 2, ε = 4.35e-5 prints 11 *)
(* Broken at level 11: 87/2000000 for points of spread 1/10 *)
Theorem finding_17 :
  exceeds_distance scheme_2 0 11 1 (87 # 200000).
Proof. apply (exceeds_distance_by scheme_2 0 11 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 1 (87 # 200000)
  33 1 1 (1 # 2048)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 5: Table 2, c_0 = 2, ε = 5.12e-6 prints 14 *)
(* This depth suffices. *)
Theorem finding_18 :
  sufficient_depth scheme_2 0 (1 # 10) (2 # 390625) 20.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 5: Table 2, c_0 = 2, ε = 5.12e-6 prints 14 *)
(* Broken at level 14: 2/390625 for points of spread 1/10 *)
Theorem finding_19 :
  exceeds_distance scheme_2 0 14 1 (4 # 78125).
Proof. apply (exceeds_distance_by scheme_2 0 14 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 1 (4 # 78125)
  40 1 1 (1 # 16384)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 6: Table 2, c_0 = 2, ε = 6.02 - 7 prints 16 *)
(* This depth suffices. *)
Theorem finding_20 :
  sufficient_depth scheme_2 0 (1 # 10) (301 # 500000000) 23.
Proof. apply (sufficient_depth_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 6: Table 2, c_0 = 2, ε = 6.02 - 7 prints 16 *)
(* Broken at level 16: 301/500000000 for points of spread 1/10 *)
Theorem finding_21 :
  exceeds_distance scheme_2 0 16 1 (301 # 50000000).
Proof. apply (exceeds_distance_by scheme_2 0 16 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 1 (301 # 50000000)
  43 1 1 (1 # 32768)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 7: Table 2, c_0 = 2, ε = 7.09e-8 prints 19 *)
(* This depth suffices. *)
Theorem finding_22 :
  sufficient_depth scheme_2 0 (1 # 10) (709 # 10000000000) 27.
Proof. apply (sufficient_depth_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 7: Table 2, c_0 = 2, ε = 7.09e-8 prints 19 *)
(* Broken at level 19: 709/10000000000 for points of spread 1/10 *)
Theorem finding_23 :
  exceeds_distance scheme_2 0 19 1 (709 # 1000000000).
Proof. apply (exceeds_distance_by scheme_2 0 19 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 1 (709 # 1000000000)
  49 1 1 (1 # 262144)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 1: Table 2, c_0 = 3, ε = 0.0266 prints 2 *)
(* It rests on this constant. *)
Theorem finding_24 :
  backwards_constant scheme_1 difference_1 3 (228713351 # 800000000).
Proof. apply backwards_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 1: Table 2, c_0 = 3, ε = 0.0266 prints 2 *)
(* This depth suffices. *)
Theorem finding_25 :
  sufficient_depth scheme_2 0 (1 # 10) (133 # 5000) 5.
Proof. apply (sufficient_depth_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 1: Table 2, c_0 = 3, ε = 0.0266 prints 2 *)
(* Broken at level 2: 133/5000 for points of spread 1/10 *)
Theorem finding_26 :
  exceeds_distance scheme_2 0 2 1 (133 # 500).
Proof. apply (exceeds_distance_by scheme_2 0 2 3 [0; 1]%Z 0 1 (133 # 500)
  15 1 1 (1 # 8)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 2: Table 2, c_0 = 3, ε = 0.0031 prints 4 *)
(* This depth suffices. *)
Theorem finding_27 :
  sufficient_depth scheme_2 0 (1 # 10) (31 # 10000) 9.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 2: Table 2, c_0 = 3, ε = 0.0031 prints 4 *)
(* Broken at level 4: 31/10000 for points of spread 1/10 *)
Theorem finding_28 :
  exceeds_distance scheme_2 0 4 1 (31 # 1000).
Proof. apply (exceeds_distance_by scheme_2 0 4 0 [0; 1; 2; 1; 2; 3; 2; 3]%Z 0 1 (31 # 1000)
  17 1 1 (1 # 16)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 3: Table 2, c_0 = 3, ε = 0.0003 prints 5 *)
(* This depth suffices. *)
Theorem finding_29 :
  sufficient_depth scheme_2 0 (1 # 10) (3 # 10000) 13.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 3: Table 2, c_0 = 3, ε = 0.0003 prints 5 *)
(* Broken at level 5: 3/10000 for points of spread 1/10 *)
Theorem finding_30 :
  exceeds_distance scheme_2 0 5 1 (3 # 1000).
Proof. apply (exceeds_distance_by scheme_2 0 5 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 1 (3 # 1000)
  17 1 1 (1 # 16)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 4: Table 2, c_0 = 3, ε = 4.35e-5 prints 7 *)
(* This depth suffices. *)
Theorem finding_31 :
  sufficient_depth scheme_2 0 (1 # 10) (87 # 2000000) 16.
Proof. apply (sufficient_depth_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 4: Table 2, c_0 = 3, ε = 4.35e-5 prints 7 *)
(* Broken at level 7: 87/2000000 for points of spread 1/10 *)
Theorem finding_32 :
  exceeds_distance scheme_2 0 7 1 (87 # 200000).
Proof. apply (exceeds_distance_by scheme_2 0 7 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 1 (87 # 200000)
  22 1 1 (1 # 64)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 5: Table 2, c_0 = 3, ε = 5.12e-6 prints 9 *)
(* This depth suffices. *)
Theorem finding_33 :
  sufficient_depth scheme_2 0 (1 # 10) (2 # 390625) 20.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 5: Table 2, c_0 = 3, ε = 5.12e-6 prints 9 *)
(* Broken at level 9: 2/390625 for points of spread 1/10 *)
Theorem finding_34 :
  exceeds_distance scheme_2 0 9 1 (4 # 78125).
Proof. apply (exceeds_distance_by scheme_2 0 9 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 1 (4 # 78125)
  26 1 1 (1 # 256)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 6: Table 2, c_0 = 3, ε = 6.02 - 7 prints 10 *)
(* This depth suffices. *)
Theorem finding_35 :
  sufficient_depth scheme_2 0 (1 # 10) (301 # 500000000) 23.
Proof. apply (sufficient_depth_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 6: Table 2, c_0 = 3, ε = 6.02 - 7 prints 10 *)
(* Broken at level 10: 301/500000000 for points of spread 1/10 *)
Theorem finding_36 :
  exceeds_distance scheme_2 0 10 1 (301 # 50000000).
Proof. apply (exceeds_distance_by scheme_2 0 10 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 1 (301 # 50000000)
  29 1 1 (1 # 512)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 7: Table 2, c_0 = 3, ε = 7.09e-8 prints 12 *)
(* This depth suffices. *)
Theorem finding_37 :
  sufficient_depth scheme_2 0 (1 # 10) (709 # 10000000000) 27.
Proof. apply (sufficient_depth_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 7: Table 2, c_0 = 3, ε = 7.09e-8 prints 12 *)
(* Broken at level 12: 709/10000000000 for points of spread 1/10 *)
Theorem finding_38 :
  exceeds_distance scheme_2 0 12 1 (709 # 1000000000).
Proof. apply (exceeds_distance_by scheme_2 0 12 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 1 (709 # 1000000000)
  33 1 1 (1 # 2048)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 1: Table 2, c_0 = 4, ε = 0.0266 prints 1 *)
(* It rests on this constant. *)
Theorem finding_39 :
  backwards_constant scheme_1 difference_1 4 (293144306831 # 1600000000000).
Proof. apply backwards_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 1: Table 2, c_0 = 4, ε = 0.0266 prints 1 *)
(* This depth suffices. *)
Theorem finding_40 :
  sufficient_depth scheme_2 0 (1 # 10) (133 # 5000) 5.
Proof. apply (sufficient_depth_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 1: Table 2, c_0 = 4, ε = 0.0266 prints 1 *)
(* Broken at level 1: 133/5000 for points of spread 1/10 *)
Theorem finding_41 :
  exceeds_distance scheme_2 0 1 1 (133 # 500).
Proof. apply (exceeds_distance_by scheme_2 0 1 2 [0; 1; 2]%Z 0 1 (133 # 500)
  10 1 1 (1 # 2)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 2: Table 2, c_0 = 4, ε = 0.0031 prints 3 *)
(* This depth suffices. *)
Theorem finding_42 :
  sufficient_depth scheme_2 0 (1 # 10) (31 # 10000) 9.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 2: Table 2, c_0 = 4, ε = 0.0031 prints 3 *)
(* Broken at level 3: 31/10000 for points of spread 1/10 *)
Theorem finding_43 :
  exceeds_distance scheme_2 0 3 1 (31 # 1000).
Proof. apply (exceeds_distance_by scheme_2 0 3 1 [0; 1; 0; 1; 2; 1]%Z 0 1 (31 # 1000)
  15 1 1 (1 # 8)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 3: Table 2, c_0 = 4, ε = 0.0003 prints 4 *)
(* This depth suffices. *)
Theorem finding_44 :
  sufficient_depth scheme_2 0 (1 # 10) (3 # 10000) 13.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 3: Table 2, c_0 = 4, ε = 0.0003 prints 4 *)
(* Broken at level 4: 3/10000 for points of spread 1/10 *)
Theorem finding_45 :
  exceeds_distance scheme_2 0 4 1 (3 # 1000).
Proof. apply (exceeds_distance_by scheme_2 0 4 0 [0; 1; 2; 1; 2; 3; 2; 3]%Z 0 1 (3 # 1000)
  15 1 1 (1 # 8)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 4: Table 2, c_0 = 4, ε = 4.35e-5 prints 5 *)
(* This depth suffices. *)
Theorem finding_46 :
  sufficient_depth scheme_2 0 (1 # 10) (87 # 2000000) 16.
Proof. apply (sufficient_depth_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 4: Table 2, c_0 = 4, ε = 4.35e-5 prints 5 *)
(* Broken at level 5: 87/2000000 for points of spread 1/10 *)
Theorem finding_47 :
  exceeds_distance scheme_2 0 5 1 (87 # 200000).
Proof. apply (exceeds_distance_by scheme_2 0 5 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 1 (87 # 200000)
  17 1 1 (1 # 16)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 4: Table 2, c_0 = 4, ε = 4.35e-5 prints 5 *)
(* Broken at natural parameters at level 5: 87/2000000 for points of spread 1/10 *)
Theorem finding_48 :
  exceeds_distance scheme_2 (-4 # 1) 5 1 (87 # 200000).
Proof. apply (exceeds_distance_by scheme_2 (-4 # 1) 5 1 [0; 1; 2; 1; 2; 1; 2; 1; 0]%Z (63 # 64) 1 (87 # 200000)
  35 1 1 (1 # 32768)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 5: Table 2, c_0 = 4, ε = 5.12e-6 prints 6 *)
(* This depth suffices. *)
Theorem finding_49 :
  sufficient_depth scheme_2 0 (1 # 10) (2 # 390625) 20.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 5: Table 2, c_0 = 4, ε = 5.12e-6 prints 6 *)
(* Broken at level 6: 2/390625 for points of spread 1/10 *)
Theorem finding_50 :
  exceeds_distance scheme_2 0 6 1 (4 # 78125).
Proof. apply (exceeds_distance_by scheme_2 0 6 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 1 (4 # 78125)
  19 1 1 (1 # 32)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 5: Table 2, c_0 = 4, ε = 5.12e-6 prints 6 *)
(* Broken at natural parameters at level 6: 2/390625 for points of spread 1/10 *)
Theorem finding_51 :
  exceeds_distance scheme_2 (-4 # 1) 6 1 (4 # 78125).
Proof. apply (exceeds_distance_by scheme_2 (-4 # 1) 6 1 [0; 1; 2; 1; 2; 1; 2; 1; 0]%Z (127 # 128) 1 (4 # 78125)
  37 1 1 (1 # 65536)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 6: Table 2, c_0 = 4, ε = 6.02 - 7 prints 8 *)
(* This depth suffices. *)
Theorem finding_52 :
  sufficient_depth scheme_2 0 (1 # 10) (301 # 500000000) 23.
Proof. apply (sufficient_depth_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 6: Table 2, c_0 = 4, ε = 6.02 - 7 prints 8 *)
(* Broken at level 8: 301/500000000 for points of spread 1/10 *)
Theorem finding_53 :
  exceeds_distance scheme_2 0 8 1 (301 # 50000000).
Proof. apply (exceeds_distance_by scheme_2 0 8 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 1 (301 # 50000000)
  24 1 1 (1 # 128)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 6: Table 2, c_0 = 4, ε = 6.02 - 7 prints 8 *)
(* Broken at natural parameters at level 8: 301/500000000 for points of spread 1/10 *)
Theorem finding_54 :
  exceeds_distance scheme_2 (-4 # 1) 8 1 (301 # 50000000).
Proof. apply (exceeds_distance_by scheme_2 (-4 # 1) 8 1 [0; 1; 2; 1; 2; 1; 2; 1; 0]%Z (511 # 512) 1 (301 # 50000000)
  49 1 1 (1 # 2097152)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 7: Table 2, c_0 = 4, ε = 7.09e-8 prints 9 *)
(* This depth suffices. *)
Theorem finding_55 :
  sufficient_depth scheme_2 0 (1 # 10) (709 # 10000000000) 27.
Proof. apply (sufficient_depth_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 7: Table 2, c_0 = 4, ε = 7.09e-8 prints 9 *)
(* Broken at level 9: 709/10000000000 for points of spread 1/10 *)
Theorem finding_56 :
  exceeds_distance scheme_2 0 9 1 (709 # 1000000000).
Proof. apply (exceeds_distance_by scheme_2 0 9 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 1 (709 # 1000000000)
  26 1 1 (1 # 256)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 7: Table 2, c_0 = 4, ε = 7.09e-8 prints 9 *)
(* Broken at natural parameters at level 9: 709/10000000000 for points of spread 1/10 *)
Theorem finding_57 :
  exceeds_distance scheme_2 (-4 # 1) 9 1 (709 # 1000000000).
Proof. apply (exceeds_distance_by scheme_2 (-4 # 1) 9 1 [0; 1; 2; 1; 2; 1; 2; 1; 0]%Z (1023 # 1024) 1 (709 # 1000000000)
  51 1 1 (1 # 4194304)). vm_cast_no_check (eq_refl true). Qed.
