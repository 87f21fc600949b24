(** mustafa2020-nary, table table-10 (written by `subcert prove --coq`) *)
(* Not stated: mu = 0, tau = 1/10 *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition scheme_1 :=
  Scheme 128 (-1) [[28; 58; 40; 2]; [15; 57; 49; 7]; [7; 49; 57; 15]; [2; 40; 58; 28]]%Z.

(* row 1, column 1: Table 10, c_0 = 1, ε = 4.41e-4 prints 4 *)
(* It rests on this constant. *)
Theorem finding_1 :
  contraction_constant scheme_1 1 (1 # 4).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

Definition scheme_2 :=
  Scheme 128 0 [[28; 58; 40; 2]; [15; 57; 49; 7]; [7; 49; 57; 15]; [2; 40; 58; 28]]%Z.

(* row 1, column 1: Table 10, c_0 = 1, ε = 4.41e-4 prints 4 *)
(* This depth suffices. *)
Theorem finding_2 :
  sufficient_depth scheme_2 0 (1 # 10) (441 # 1000000) 5.
Proof. apply (sufficient_depth_by scheme_2 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 1: Table 10, c_0 = 1, ε = 4.41e-4 prints 4 *)
(* Broken at level 4: 441/1000000 for points of spread 1/10 *)
Theorem finding_3 :
  exceeds_distance scheme_2 0 4 1 (441 # 100000).
Proof. apply (exceeds_distance_by scheme_2 0 4 0 [0; 1; 2; 3]%Z 0 1 (441 # 100000)
  7 1 1 (1 # 4096)). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 2: Table 10, c_0 = 1, ε = 1.72e-6 prints 8 *)
(* This depth suffices. *)
Theorem finding_4 :
  sufficient_depth scheme_2 0 (1 # 10) (43 # 25000000) 9.
Proof. apply (sufficient_depth_by scheme_2 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 2: Table 10, c_0 = 1, ε = 1.72e-6 prints 8 *)
(* Broken at level 8: 43/25000000 for points of spread 1/10 *)
Theorem finding_5 :
  exceeds_distance scheme_2 0 8 1 (43 # 2500000).
Proof. apply (exceeds_distance_by scheme_2 0 8 0 [0; 1; 2; 3]%Z 0 1 (43 # 2500000)
  11 1 1 (1 # 1048576)). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 3: Table 10, c_0 = 1, ε = 6.73e-9 prints 12 *)
(* This depth suffices. *)
Theorem finding_6 :
  sufficient_depth scheme_2 0 (1 # 10) (673 # 100000000000) 13.
Proof. apply (sufficient_depth_by scheme_2 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 3: Table 10, c_0 = 1, ε = 6.73e-9 prints 12 *)
(* Broken at level 12: 673/100000000000 for points of spread 1/10 *)
Theorem finding_7 :
  exceeds_distance scheme_2 0 12 1 (673 # 10000000000).
Proof. apply (exceeds_distance_by scheme_2 0 12 0 [0; 1; 2; 3]%Z 0 1 (673 # 10000000000)
  15 1 1 (1 # 268435456)). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 4: Table 10, c_0 = 1, ε = 2.63e-11 prints 16 *)
(* This depth suffices. *)
Theorem finding_8 :
  sufficient_depth scheme_2 0 (1 # 10) (263 # 10000000000000) 17.
Proof. apply (sufficient_depth_by scheme_2 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 4: Table 10, c_0 = 1, ε = 2.63e-11 prints 16 *)
(* Broken at level 16: 263/10000000000000 for points of spread 1/10 *)
Theorem finding_9 :
  exceeds_distance scheme_2 0 16 1 (263 # 1000000000000).
Proof. apply (exceeds_distance_by scheme_2 0 16 0 [0; 1; 2; 3]%Z 0 1 (263 # 1000000000000)
  19 1 1 (1 # 68719476736)). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 5: Table 10, c_0 = 1, ε = 1.03e-13 prints 20 *)
(* This depth suffices. *)
Theorem finding_10 :
  sufficient_depth scheme_2 0 (1 # 10) (103 # 1000000000000000) 21.
Proof. apply (sufficient_depth_by scheme_2 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 5: Table 10, c_0 = 1, ε = 1.03e-13 prints 20 *)
(* Broken at level 20: 103/1000000000000000 for points of spread 1/10 *)
Theorem finding_11 :
  exceeds_distance scheme_2 0 20 1 (103 # 100000000000000).
Proof. apply (exceeds_distance_by scheme_2 0 20 0 [0; 1; 2; 3]%Z 0 1 (103 # 100000000000000)
  23 1 1 (1 # 17592186044416)). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 6: Table 10, c_0 = 1, ε = 4.01e-16 prints 24 *)
(* This depth suffices. *)
Theorem finding_12 :
  sufficient_depth scheme_2 0 (1 # 10) (401 # 1000000000000000000) 25.
Proof. apply (sufficient_depth_by scheme_2 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 6: Table 10, c_0 = 1, ε = 4.01e-16 prints 24 *)
(* Broken at level 24: 401/1000000000000000000 for points of spread 1/10 *)
Theorem finding_13 :
  exceeds_distance scheme_2 0 24 1 (401 # 100000000000000000).
Proof. apply (exceeds_distance_by scheme_2 0 24 0 [0; 1; 2; 3]%Z 0 1 (401 # 100000000000000000)
  27 1 1 (1 # 4503599627370496)). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 7: Table 10, c_0 = 1, ε = 1.57e-18 prints 28 *)
(* This depth suffices. *)
Theorem finding_14 :
  sufficient_depth scheme_2 0 (1 # 10) (157 # 100000000000000000000) 29.
Proof. apply (sufficient_depth_by scheme_2 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 7: Table 10, c_0 = 1, ε = 1.57e-18 prints 28 *)
(* Broken at level 28: 157/100000000000000000000 for points of spread 1/10 *)
Theorem finding_15 :
  exceeds_distance scheme_2 0 28 1 (157 # 10000000000000000000).
Proof. apply (exceeds_distance_by scheme_2 0 28 0 [0; 1; 2; 3]%Z 0 1 (157 # 10000000000000000000)
  31 1 1 (1 # 1152921504606846976)). vm_cast_no_check (eq_refl true). Qed.

Definition difference_1 :=
  Scheme 128 (-1) [[13; 14; 5; 0]; [8; 16; 8; 0]; [5; 14; 13; 0]; [2; 14; 14; 2]]%Z.

(* row 2, column 1: Table 10, c_0 = 2, ε = 4.41e-4 prints 2 *)
(* It rests on this constant. *)
Theorem finding_16 :
  backwards_constant scheme_1 difference_1 2 (1 # 16).
Proof. apply backwards_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 1: Table 10, c_0 = 2, ε = 4.41e-4 prints 2 *)
(* This depth suffices. *)
Theorem finding_17 :
  sufficient_depth scheme_2 0 (1 # 10) (441 # 1000000) 5.
Proof. apply (sufficient_depth_by scheme_2 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 1: Table 10, c_0 = 2, ε = 4.41e-4 prints 2 *)
(* Broken at level 2: 441/1000000 for points of spread 1/10 *)
Theorem finding_18 :
  exceeds_distance scheme_2 0 2 1 (441 # 100000).
Proof. apply (exceeds_distance_by scheme_2 0 2 0 [0; 1; 2; 3]%Z 0 1 (441 # 100000)
  4 1 1 (1 # 64)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 2: Table 10, c_0 = 2, ε = 1.72e-6 prints 4 *)
(* This depth suffices. *)
Theorem finding_19 :
  sufficient_depth scheme_2 0 (1 # 10) (43 # 25000000) 9.
Proof. apply (sufficient_depth_by scheme_2 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 2: Table 10, c_0 = 2, ε = 1.72e-6 prints 4 *)
(* Broken at level 4: 43/25000000 for points of spread 1/10 *)
Theorem finding_20 :
  exceeds_distance scheme_2 0 4 1 (43 # 2500000).
Proof. apply (exceeds_distance_by scheme_2 0 4 0 [0; 1; 2; 3]%Z 0 1 (43 # 2500000)
  6 1 1 (1 # 1024)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 3: Table 10, c_0 = 2, ε = 6.73e-9 prints 6 *)
(* This depth suffices. *)
Theorem finding_21 :
  sufficient_depth scheme_2 0 (1 # 10) (673 # 100000000000) 13.
Proof. apply (sufficient_depth_by scheme_2 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 3: Table 10, c_0 = 2, ε = 6.73e-9 prints 6 *)
(* Broken at level 6: 673/100000000000 for points of spread 1/10 *)
Theorem finding_22 :
  exceeds_distance scheme_2 0 6 1 (673 # 10000000000).
Proof. apply (exceeds_distance_by scheme_2 0 6 0 [0; 1; 2; 3]%Z 0 1 (673 # 10000000000)
  8 1 1 (1 # 16384)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 4: Table 10, c_0 = 2, ε = 2.63e-11 prints 8 *)
(* This depth suffices. *)
Theorem finding_23 :
  sufficient_depth scheme_2 0 (1 # 10) (263 # 10000000000000) 17.
Proof. apply (sufficient_depth_by scheme_2 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 4: Table 10, c_0 = 2, ε = 2.63e-11 prints 8 *)
(* Broken at level 8: 263/10000000000000 for points of spread 1/10 *)
Theorem finding_24 :
  exceeds_distance scheme_2 0 8 1 (263 # 1000000000000).
Proof. apply (exceeds_distance_by scheme_2 0 8 0 [0; 1; 2; 3]%Z 0 1 (263 # 1000000000000)
  10 1 1 (1 # 262144)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 5: Table 10, c_0 = 2, ε = 1.03e-13 prints 10 *)
(* This depth suffices. *)
Theorem finding_25 :
  sufficient_depth scheme_2 0 (1 # 10) (103 # 1000000000000000) 21.
Proof. apply (sufficient_depth_by scheme_2 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 5: Table 10, c_0 = 2, ε = 1.03e-13 prints 10 *)
(* Broken at level 10: 103/1000000000000000 for points of spread 1/10 *)
Theorem finding_26 :
  exceeds_distance scheme_2 0 10 1 (103 # 100000000000000).
Proof. apply (exceeds_distance_by scheme_2 0 10 0 [0; 1; 2; 3]%Z 0 1 (103 # 100000000000000)
  12 1 1 (1 # 4194304)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 6: Table 10, c_0 = 2, ε = 4.01e-16 prints 12 *)
(* This depth suffices. *)
Theorem finding_27 :
  sufficient_depth scheme_2 0 (1 # 10) (401 # 1000000000000000000) 25.
Proof. apply (sufficient_depth_by scheme_2 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 6: Table 10, c_0 = 2, ε = 4.01e-16 prints 12 *)
(* Broken at level 12: 401/1000000000000000000 for points of spread 1/10 *)
Theorem finding_28 :
  exceeds_distance scheme_2 0 12 1 (401 # 100000000000000000).
Proof. apply (exceeds_distance_by scheme_2 0 12 0 [0; 1; 2; 3]%Z 0 1 (401 # 100000000000000000)
  14 1 1 (1 # 67108864)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 7: Table 10, c_0 = 2, ε = 1.57e-18 prints 14 *)
(* This depth suffices. *)
Theorem finding_29 :
  sufficient_depth scheme_2 0 (1 # 10) (157 # 100000000000000000000) 29.
Proof. apply (sufficient_depth_by scheme_2 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 7: Table 10, c_0 = 2, ε = 1.57e-18 prints 14 *)
(* Broken at level 14: 157/100000000000000000000 for points of spread 1/10 *)
Theorem finding_30 :
  exceeds_distance scheme_2 0 14 1 (157 # 10000000000000000000).
Proof. apply (exceeds_distance_by scheme_2 0 14 0 [0; 1; 2; 3]%Z 0 1 (157 # 10000000000000000000)
  16 1 1 (1 # 1073741824)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 1: Table 10, c_0 = 3, ε = 4.41e-4 prints 1 *)
(* It rests on this constant. *)
Theorem finding_31 :
  backwards_constant scheme_1 difference_1 3 (1 # 64).
Proof. apply backwards_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 1: Table 10, c_0 = 3, ε = 4.41e-4 prints 1 *)
(* This depth suffices. *)
Theorem finding_32 :
  sufficient_depth scheme_2 0 (1 # 10) (441 # 1000000) 5.
Proof. apply (sufficient_depth_by scheme_2 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 1: Table 10, c_0 = 3, ε = 4.41e-4 prints 1 *)
(* Broken at level 1: 441/1000000 for points of spread 1/10 *)
Theorem finding_33 :
  exceeds_distance scheme_2 0 1 1 (441 # 100000).
Proof. apply (exceeds_distance_by scheme_2 0 1 0 [0; 1; 2; 3]%Z 0 1 (441 # 100000)
  3 1 1 (1 # 16)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 1: Table 10, c_0 = 3, ε = 4.41e-4 prints 1 *)
(* Broken at natural parameters at level 1: 441/1000000 for points of spread 1/10 *)
Theorem finding_34 :
  exceeds_distance scheme_2 (-3 # 2) 1 1 (441 # 100000).
Proof. apply (exceeds_distance_by scheme_2 (-3 # 2) 1 0 [0; -1; -2; -1; 0]%Z (1 # 8) 1 (441 # 100000)
  4 1 1 (1 # 256)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 2: Table 10, c_0 = 3, ε = 1.72e-6 prints 3 *)
(* This depth suffices. *)
Theorem finding_35 :
  sufficient_depth scheme_2 0 (1 # 10) (43 # 25000000) 9.
Proof. apply (sufficient_depth_by scheme_2 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 2: Table 10, c_0 = 3, ε = 1.72e-6 prints 3 *)
(* Broken at level 3: 43/25000000 for points of spread 1/10 *)
Theorem finding_36 :
  exceeds_distance scheme_2 0 3 1 (43 # 2500000).
Proof. apply (exceeds_distance_by scheme_2 0 3 0 [0; 1; 2; 3]%Z 0 1 (43 # 2500000)
  5 1 1 (1 # 256)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 2: Table 10, c_0 = 3, ε = 1.72e-6 prints 3 *)
(* Broken at natural parameters at level 3: 43/25000000 for points of spread 1/10 *)
Theorem finding_37 :
  exceeds_distance scheme_2 (-3 # 2) 3 1 (43 # 2500000).
Proof. apply (exceeds_distance_by scheme_2 (-3 # 2) 3 0 [0; -1; -2; -1; 0]%Z (1 # 128) 1 (43 # 2500000)
  8 1 1 (1 # 65536)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 3: Table 10, c_0 = 3, ε = 6.73e-9 prints 4 *)
(* This depth suffices. *)
Theorem finding_38 :
  sufficient_depth scheme_2 0 (1 # 10) (673 # 100000000000) 13.
Proof. apply (sufficient_depth_by scheme_2 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 3: Table 10, c_0 = 3, ε = 6.73e-9 prints 4 *)
(* Broken at level 4: 673/100000000000 for points of spread 1/10 *)
Theorem finding_39 :
  exceeds_distance scheme_2 0 4 1 (673 # 10000000000).
Proof. apply (exceeds_distance_by scheme_2 0 4 0 [0; 1; 2; 3]%Z 0 1 (673 # 10000000000)
  6 1 1 (1 # 1024)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 3: Table 10, c_0 = 3, ε = 6.73e-9 prints 4 *)
(* Broken at natural parameters at level 4: 673/100000000000 for points of spread 1/10 *)
Theorem finding_40 :
  exceeds_distance scheme_2 (-3 # 2) 4 1 (673 # 10000000000).
Proof. apply (exceeds_distance_by scheme_2 (-3 # 2) 4 0 [0; -1; -2; -1; 0]%Z (1 # 512) 1 (673 # 10000000000)
  10 1 1 (1 # 1048576)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 4: Table 10, c_0 = 3, ε = 2.63e-11 prints 5 *)
(* This depth suffices. *)
Theorem finding_41 :
  sufficient_depth scheme_2 0 (1 # 10) (263 # 10000000000000) 17.
Proof. apply (sufficient_depth_by scheme_2 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 4: Table 10, c_0 = 3, ε = 2.63e-11 prints 5 *)
(* Broken at level 5: 263/10000000000000 for points of spread 1/10 *)
Theorem finding_42 :
  exceeds_distance scheme_2 0 5 1 (263 # 1000000000000).
Proof. apply (exceeds_distance_by scheme_2 0 5 0 [0; 1; 2; 3]%Z 0 1 (263 # 1000000000000)
  7 1 1 (1 # 4096)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 4: Table 10, c_0 = 3, ε = 2.63e-11 prints 5 *)
(* Broken at natural parameters at level 5: 263/10000000000000 for points of spread 1/10 *)
Theorem finding_43 :
  exceeds_distance scheme_2 (-3 # 2) 5 1 (263 # 1000000000000).
Proof. apply (exceeds_distance_by scheme_2 (-3 # 2) 5 0 [0; -1; -2; -1; 0]%Z (1 # 2048) 1 (263 # 1000000000000)
  12 1 1 (1 # 16777216)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 5: Table 10, c_0 = 3, ε = 1.03e-13 prints 7 *)
(* This depth suffices. *)
Theorem finding_44 :
  sufficient_depth scheme_2 0 (1 # 10) (103 # 1000000000000000) 21.
Proof. apply (sufficient_depth_by scheme_2 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 5: Table 10, c_0 = 3, ε = 1.03e-13 prints 7 *)
(* Broken at level 7: 103/1000000000000000 for points of spread 1/10 *)
Theorem finding_45 :
  exceeds_distance scheme_2 0 7 1 (103 # 100000000000000).
Proof. apply (exceeds_distance_by scheme_2 0 7 0 [0; 1; 2; 3]%Z 0 1 (103 # 100000000000000)
  9 1 1 (1 # 65536)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 5: Table 10, c_0 = 3, ε = 1.03e-13 prints 7 *)
(* Broken at natural parameters at level 7: 103/1000000000000000 for points of spread 1/10 *)
Theorem finding_46 :
  exceeds_distance scheme_2 (-3 # 2) 7 1 (103 # 100000000000000).
Proof. apply (exceeds_distance_by scheme_2 (-3 # 2) 7 0 [0; -1; -2; -1; 0]%Z (1 # 32768) 1 (103 # 100000000000000)
  16 1 1 (1 # 4294967296)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 6: Table 10, c_0 = 3, ε = 4.01e-16 prints 8 *)
(* This depth suffices. *)
Theorem finding_47 :
  sufficient_depth scheme_2 0 (1 # 10) (401 # 1000000000000000000) 25.
Proof. apply (sufficient_depth_by scheme_2 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 6: Table 10, c_0 = 3, ε = 4.01e-16 prints 8 *)
(* Broken at level 8: 401/1000000000000000000 for points of spread 1/10 *)
Theorem finding_48 :
  exceeds_distance scheme_2 0 8 1 (401 # 100000000000000000).
Proof. apply (exceeds_distance_by scheme_2 0 8 0 [0; 1; 2; 3]%Z 0 1 (401 # 100000000000000000)
  10 1 1 (1 # 262144)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 6: Table 10, c_0 = 3, ε = 4.01e-16 prints 8 *)
(* Broken at natural parameters at level 8: 401/1000000000000000000 for points of spread 1/10 *)
Theorem finding_49 :
  exceeds_distance scheme_2 (-3 # 2) 8 1 (401 # 100000000000000000).
Proof. apply (exceeds_distance_by scheme_2 (-3 # 2) 8 0 [0; -1; -2; -1; 0]%Z (1 # 131072) 1 (401 # 100000000000000000)
  18 1 1 (1 # 68719476736)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 7: Table 10, c_0 = 3, ε = 1.57e-18 prints 9 *)
(* This depth suffices. *)
Theorem finding_50 :
  sufficient_depth scheme_2 0 (1 # 10) (157 # 100000000000000000000) 29.
Proof. apply (sufficient_depth_by scheme_2 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 7: Table 10, c_0 = 3, ε = 1.57e-18 prints 9 *)
(* Broken at level 9: 157/100000000000000000000 for points of spread 1/10 *)
Theorem finding_51 :
  exceeds_distance scheme_2 0 9 1 (157 # 10000000000000000000).
Proof. apply (exceeds_distance_by scheme_2 0 9 0 [0; 1; 2; 3]%Z 0 1 (157 # 10000000000000000000)
  11 1 1 (1 # 1048576)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 7: Table 10, c_0 = 3, ε = 1.57e-18 prints 9 *)
(* Broken at natural parameters at level 9: 157/100000000000000000000 for points of spread 1/10 *)
Theorem finding_52 :
  exceeds_distance scheme_2 (-3 # 2) 9 1 (157 # 10000000000000000000).
Proof. apply (exceeds_distance_by scheme_2 (-3 # 2) 9 0 [0; -1; -2; -1; 0]%Z (1 # 524288) 1 (157 # 10000000000000000000)
  20 1 1 (1 # 1099511627776)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 1: Table 10, c_0 = 4, ε = 4.41e-4 prints 1 *)
(* It rests on this constant. *)
Theorem finding_53 :
  backwards_constant scheme_1 difference_1 4 (1 # 256).
Proof. apply backwards_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 1: Table 10, c_0 = 4, ε = 4.41e-4 prints 1 *)
(* This depth suffices. *)
Theorem finding_54 :
  sufficient_depth scheme_2 0 (1 # 10) (441 # 1000000) 5.
Proof. apply (sufficient_depth_by scheme_2 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 1: Table 10, c_0 = 4, ε = 4.41e-4 prints 1 *)
(* Broken at level 1: 441/1000000 for points of spread 1/10 *)
Theorem finding_55 :
  exceeds_distance scheme_2 0 1 1 (441 # 100000).
Proof. apply (exceeds_distance_by scheme_2 0 1 0 [0; 1; 2; 3]%Z 0 1 (441 # 100000)
  3 1 1 (1 # 16)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 1: Table 10, c_0 = 4, ε = 4.41e-4 prints 1 *)
(* Broken at natural parameters at level 1: 441/1000000 for points of spread 1/10 *)
Theorem finding_56 :
  exceeds_distance scheme_2 (-3 # 2) 1 1 (441 # 100000).
Proof. apply (exceeds_distance_by scheme_2 (-3 # 2) 1 0 [0; -1; -2; -1; 0]%Z (1 # 8) 1 (441 # 100000)
  4 1 1 (1 # 256)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 2: Table 10, c_0 = 4, ε = 1.72e-6 prints 2 *)
(* This depth suffices. *)
Theorem finding_57 :
  sufficient_depth scheme_2 0 (1 # 10) (43 # 25000000) 9.
Proof. apply (sufficient_depth_by scheme_2 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 2: Table 10, c_0 = 4, ε = 1.72e-6 prints 2 *)
(* Broken at level 2: 43/25000000 for points of spread 1/10 *)
Theorem finding_58 :
  exceeds_distance scheme_2 0 2 1 (43 # 2500000).
Proof. apply (exceeds_distance_by scheme_2 0 2 0 [0; 1; 2; 3]%Z 0 1 (43 # 2500000)
  4 1 1 (1 # 64)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 2: Table 10, c_0 = 4, ε = 1.72e-6 prints 2 *)
(* Broken at natural parameters at level 2: 43/25000000 for points of spread 1/10 *)
Theorem finding_59 :
  exceeds_distance scheme_2 (-3 # 2) 2 1 (43 # 2500000).
Proof. apply (exceeds_distance_by scheme_2 (-3 # 2) 2 0 [0; -1; -2; -1; 0]%Z (1 # 32) 1 (43 # 2500000)
  6 1 1 (1 # 4096)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 3: Table 10, c_0 = 4, ε = 6.73e-9 prints 3 *)
(* This depth suffices. *)
Theorem finding_60 :
  sufficient_depth scheme_2 0 (1 # 10) (673 # 100000000000) 13.
Proof. apply (sufficient_depth_by scheme_2 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 3: Table 10, c_0 = 4, ε = 6.73e-9 prints 3 *)
(* Broken at level 3: 673/100000000000 for points of spread 1/10 *)
Theorem finding_61 :
  exceeds_distance scheme_2 0 3 1 (673 # 10000000000).
Proof. apply (exceeds_distance_by scheme_2 0 3 0 [0; 1; 2; 3]%Z 0 1 (673 # 10000000000)
  5 1 1 (1 # 256)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 3: Table 10, c_0 = 4, ε = 6.73e-9 prints 3 *)
(* Broken at natural parameters at level 3: 673/100000000000 for points of spread 1/10 *)
Theorem finding_62 :
  exceeds_distance scheme_2 (-3 # 2) 3 1 (673 # 10000000000).
Proof. apply (exceeds_distance_by scheme_2 (-3 # 2) 3 0 [0; -1; -2; -1; 0]%Z (1 # 128) 1 (673 # 10000000000)
  8 1 1 (1 # 65536)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 4: Table 10, c_0 = 4, ε = 2.63e-11 prints 4 *)
(* This depth suffices. *)
Theorem finding_63 :
  sufficient_depth scheme_2 0 (1 # 10) (263 # 10000000000000) 17.
Proof. apply (sufficient_depth_by scheme_2 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 4: Table 10, c_0 = 4, ε = 2.63e-11 prints 4 *)
(* Broken at level 4: 263/10000000000000 for points of spread 1/10 *)
Theorem finding_64 :
  exceeds_distance scheme_2 0 4 1 (263 # 1000000000000).
Proof. apply (exceeds_distance_by scheme_2 0 4 0 [0; 1; 2; 3]%Z 0 1 (263 # 1000000000000)
  6 1 1 (1 # 1024)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 4: Table 10, c_0 = 4, ε = 2.63e-11 prints 4 *)
(* Broken at natural parameters at level 4: 263/10000000000000 for points of spread 1/10 *)
Theorem finding_65 :
  exceeds_distance scheme_2 (-3 # 2) 4 1 (263 # 1000000000000).
Proof. apply (exceeds_distance_by scheme_2 (-3 # 2) 4 0 [0; -1; -2; -1; 0]%Z (1 # 512) 1 (263 # 1000000000000)
  10 1 1 (1 # 1048576)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 5: Table 10, c_0 = 4, ε = 1.03e-13 prints 5 *)
(* This depth suffices. *)
Theorem finding_66 :
  sufficient_depth scheme_2 0 (1 # 10) (103 # 1000000000000000) 21.
Proof. apply (sufficient_depth_by scheme_2 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 5: Table 10, c_0 = 4, ε = 1.03e-13 prints 5 *)
(* Broken at level 5: 103/1000000000000000 for points of spread 1/10 *)
Theorem finding_67 :
  exceeds_distance scheme_2 0 5 1 (103 # 100000000000000).
Proof. apply (exceeds_distance_by scheme_2 0 5 0 [0; 1; 2; 3]%Z 0 1 (103 # 100000000000000)
  7 1 1 (1 # 4096)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 5: Table 10, c_0 = 4, ε = 1.03e-13 prints 5 *)
(* Broken at natural parameters at level 5: 103/1000000000000000 for points of spread 1/10 *)
Theorem finding_68 :
  exceeds_distance scheme_2 (-3 # 2) 5 1 (103 # 100000000000000).
Proof. apply (exceeds_distance_by scheme_2 (-3 # 2) 5 0 [0; -1; -2; -1; 0]%Z (1 # 2048) 1 (103 # 100000000000000)
  12 1 1 (1 # 16777216)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 6: Table 10, c_0 = 4, ε = 4.01e-16 prints 6 *)
(* This depth suffices. *)
Theorem finding_69 :
  sufficient_depth scheme_2 0 (1 # 10) (401 # 1000000000000000000) 25.
Proof. apply (sufficient_depth_by scheme_2 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 6: Table 10, c_0 = 4, ε = 4.01e-16 prints 6 *)
(* Broken at level 6: 401/1000000000000000000 for points of spread 1/10 *)
Theorem finding_70 :
  exceeds_distance scheme_2 0 6 1 (401 # 100000000000000000).
Proof. apply (exceeds_distance_by scheme_2 0 6 0 [0; 1; 2; 3]%Z 0 1 (401 # 100000000000000000)
  8 1 1 (1 # 16384)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 6: Table 10, c_0 = 4, ε = 4.01e-16 prints 6 *)
(* Broken at natural parameters at level 6: 401/1000000000000000000 for points of spread 1/10 *)
Theorem finding_71 :
  exceeds_distance scheme_2 (-3 # 2) 6 1 (401 # 100000000000000000).
Proof. apply (exceeds_distance_by scheme_2 (-3 # 2) 6 0 [0; -1; -2; -1; 0]%Z (1 # 8192) 1 (401 # 100000000000000000)
  14 1 1 (1 # 268435456)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 7: Table 10, c_0 = 4, ε = 1.57e-18 prints 7 *)
(* This depth suffices. *)
Theorem finding_72 :
  sufficient_depth scheme_2 0 (1 # 10) (157 # 100000000000000000000) 29.
Proof. apply (sufficient_depth_by scheme_2 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 7: Table 10, c_0 = 4, ε = 1.57e-18 prints 7 *)
(* Broken at level 7: 157/100000000000000000000 for points of spread 1/10 *)
Theorem finding_73 :
  exceeds_distance scheme_2 0 7 1 (157 # 10000000000000000000).
Proof. apply (exceeds_distance_by scheme_2 0 7 0 [0; 1; 2; 3]%Z 0 1 (157 # 10000000000000000000)
  9 1 1 (1 # 65536)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 7: Table 10, c_0 = 4, ε = 1.57e-18 prints 7 *)
(* Broken at natural parameters at level 7: 157/100000000000000000000 for points of spread 1/10 *)
Theorem finding_74 :
  exceeds_distance scheme_2 (-3 # 2) 7 1 (157 # 10000000000000000000).
Proof. apply (exceeds_distance_by scheme_2 (-3 # 2) 7 0 [0; -1; -2; -1; 0]%Z (1 # 32768) 1 (157 # 10000000000000000000)
  16 1 1 (1 # 4294967296)). vm_cast_no_check (eq_refl true). Qed.
