(** mustafa2020-nary, table table-14 (written by `subcert prove --coq`) *)
(* Not stated: tau = 1/10 *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition scheme_1 :=
  Scheme 25 (-1) [[7; 21; -3]; [3; 24; -2]; [0; 25; 0]; [-2; 24; 3]; [-3; 21; 7]]%Z.

(* row 1, column 1: Table 14, c_0 = 1, ε = 3.27e-3 prints 10 *)
(* It rests on this constant. *)
Theorem finding_1 :
  contraction_constant scheme_1 1 (17 # 25).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

Definition scheme_2 :=
  Scheme 25 0 [[7; 21; -3]; [3; 24; -2]; [0; 25; 0]; [-2; 24; 3]; [-3; 21; 7]]%Z.

(* row 1, column 1: Table 14, c_0 = 1, ε = 3.27e-3 prints 10 *)
(* This depth suffices. *)
Theorem finding_2 :
  sufficient_depth scheme_2 0 (1 # 10) (327 # 100000) 5.
Proof. apply (sufficient_depth_by scheme_2 0 4 4). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 2: Table 14, c_0 = 1, ε = h1.69e-4 prints 18 *)
(* This depth suffices. *)
Theorem finding_3 :
  sufficient_depth scheme_2 0 (1 # 10) (169 # 1000000) 8.
Proof. apply (sufficient_depth_by scheme_2 0 4 4). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 3: Table 14, c_0 = 1, ε = 8.79e-6 prints 26 *)
(* This depth suffices. *)
Theorem finding_4 :
  sufficient_depth scheme_2 0 (1 # 10) (879 # 100000000) 11.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 4: Table 14, c_0 = 1, ε = 4.55e-7 prints 34 *)
(* This depth suffices. *)
Theorem finding_5 :
  sufficient_depth scheme_2 0 (1 # 10) (91 # 200000000) 14.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 5: Table 14, c_0 = 1, ε = 2.35e-8 prints 41 *)
(* This depth suffices. *)
Theorem finding_6 :
  sufficient_depth scheme_2 0 (1 # 10) (47 # 2000000000) 17.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 6: Table 14, c_0 = 1, ε = 1.22e-9 prints 49 *)
(* This depth suffices. *)
Theorem finding_7 :
  sufficient_depth scheme_2 0 (1 # 10) (61 # 50000000000) 20.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 7: Table 14, c_0 = 1, ε = 6.32e-11 prints 57 *)
(* This depth suffices. *)
Theorem finding_8 :
  sufficient_depth scheme_2 0 (1 # 10) (79 # 1250000000000) 24.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

Definition difference_1 :=
  Scheme 25 (-1) [[4; 1; 0]; [3; 2; 0]; [2; 3; 0]; [1; 4; 0]; [-3; 11; -3]]%Z.

(* row 2, column 1: Table 14, c_0 = 2, ε = 3.27e-3 prints 3 *)
(* It rests on this constant. *)
Theorem finding_9 :
  backwards_constant scheme_1 difference_1 2 (193 # 625).
Proof. apply backwards_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 1: Table 14, c_0 = 2, ε = 3.27e-3 prints 3 *)
(* This depth suffices. *)
Theorem finding_10 :
  sufficient_depth scheme_2 0 (1 # 10) (327 # 100000) 5.
Proof. apply (sufficient_depth_by scheme_2 0 4 4). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 1: Table 14, c_0 = 2, ε = 3.27e-3 prints 3 *)
(* Broken at level 3: 327/100000 for points of spread 1/10 *)
Theorem finding_11 :
  exceeds_distance scheme_2 0 3 1 (327 # 10000).
Proof. apply (exceeds_distance_by scheme_2 0 3 0 [0; -1; 0; -1]%Z (19 # 25) 1 (327 # 10000)
  21 1 1 (1 # 1024)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 2: Table 14, c_0 = 2, ε = h1.69e-4 prints 5 *)
(* This depth suffices. *)
Theorem finding_12 :
  sufficient_depth scheme_2 0 (1 # 10) (169 # 1000000) 8.
Proof. apply (sufficient_depth_by scheme_2 0 4 4). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 2: Table 14, c_0 = 2, ε = h1.69e-4 prints 5 *)
(* Broken at level 5: 169/1000000 for points of spread 1/10 *)
Theorem finding_13 :
  exceeds_distance scheme_2 0 5 1 (169 # 100000).
Proof. apply (exceeds_distance_by scheme_2 0 5 0 [0; 1; 0; 1]%Z (2969 # 3125) 1 (169 # 100000)
  25 1 1 (1 # 4096)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 3: Table 14, c_0 = 2, ε = 8.79e-6 prints 8 *)
(* This depth suffices. *)
Theorem finding_14 :
  sufficient_depth scheme_2 0 (1 # 10) (879 # 100000000) 11.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 3: Table 14, c_0 = 2, ε = 8.79e-6 prints 8 *)
(* Broken at level 8: 879/100000000 for points of spread 1/10 *)
Theorem finding_15 :
  exceeds_distance scheme_2 0 8 1 (879 # 10000000).
Proof. apply (exceeds_distance_by scheme_2 0 8 0 [0; -1; 0; -1]%Z (58594 # 78125) 1 (879 # 10000000)
  35 1 1 (1 # 262144)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 4: Table 14, c_0 = 2, ε = 4.55e-7 prints 10 *)
(* This depth suffices. *)
Theorem finding_16 :
  sufficient_depth scheme_2 0 (1 # 10) (91 # 200000000) 14.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 4: Table 14, c_0 = 2, ε = 4.55e-7 prints 10 *)
(* Broken at level 10: 91/200000000 for points of spread 1/10 *)
Theorem finding_17 :
  exceeds_distance scheme_2 0 10 1 (91 # 20000000).
Proof. apply (exceeds_distance_by scheme_2 0 10 0 [0; 1; 0; 1]%Z (9277344 # 9765625) 1 (91 # 20000000)
  43 1 1 (1 # 4194304)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 5: Table 14, c_0 = 2, ε = 2.35e-8 prints 13 *)
(* This depth suffices. *)
Theorem finding_18 :
  sufficient_depth scheme_2 0 (1 # 10) (47 # 2000000000) 17.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 5: Table 14, c_0 = 2, ε = 2.35e-8 prints 13 *)
(* Broken at level 13: 47/2000000000 for points of spread 1/10 *)
Theorem finding_19 :
  exceeds_distance scheme_2 0 13 1 (47 # 200000000).
Proof. apply (exceeds_distance_by scheme_2 0 13 0 [0; -1; 0; -1]%Z (915527344 # 1220703125) 1 (47 # 200000000)
  50 1 1 (1 # 67108864)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 6: Table 14, c_0 = 2, ε = 1.22e-9 prints 15 *)
(* This depth suffices. *)
Theorem finding_20 :
  sufficient_depth scheme_2 0 (1 # 10) (61 # 50000000000) 20.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 6: Table 14, c_0 = 2, ε = 1.22e-9 prints 15 *)
(* Broken at level 15: 61/50000000000 for points of spread 1/10 *)
Theorem finding_21 :
  exceeds_distance scheme_2 0 15 1 (61 # 5000000000).
Proof. apply (exceeds_distance_by scheme_2 0 15 0 [0; -1; 0; -1]%Z (22888183594 # 30517578125) 1 (61 # 5000000000)
  53 1 1 (1 # 268435456)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 7: Table 14, c_0 = 2, ε = 6.32e-11 prints 18 *)
(* This depth suffices. *)
Theorem finding_22 :
  sufficient_depth scheme_2 0 (1 # 10) (79 # 1250000000000) 24.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 1: Table 14, c_0 = 3, ε = 3.27e-3 prints 1 *)
(* It rests on this constant. *)
Theorem finding_23 :
  backwards_constant scheme_1 difference_1 3 (2009 # 15625).
Proof. apply backwards_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 1: Table 14, c_0 = 3, ε = 3.27e-3 prints 1 *)
(* This depth suffices. *)
Theorem finding_24 :
  sufficient_depth scheme_2 0 (1 # 10) (327 # 100000) 5.
Proof. apply (sufficient_depth_by scheme_2 0 4 4). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 1: Table 14, c_0 = 3, ε = 3.27e-3 prints 1 *)
(* Broken at level 1: 327/100000 for points of spread 1/10 *)
Theorem finding_25 :
  exceeds_distance scheme_2 0 1 1 (327 # 10000).
Proof. apply (exceeds_distance_by scheme_2 0 1 0 [0; 1; 2]%Z 0 1 (327 # 10000)
  12 1 1 (1 # 32)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 1: Table 14, c_0 = 3, ε = 3.27e-3 prints 1 *)
(* Broken at natural parameters at level 1: 327/100000 for points of spread 1/10 *)
Theorem finding_26 :
  exceeds_distance scheme_2 (-3 # 4) 1 1 (327 # 10000).
Proof. apply (exceeds_distance_by scheme_2 (-3 # 4) 1 0 [0; -1; 0; -1]%Z (23 # 25) 1 (327 # 10000)
  12 1 1 (1 # 128)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 2: Table 14, c_0 = 3, ε = h1.69e-4 prints 3 *)
(* This depth suffices. *)
Theorem finding_27 :
  sufficient_depth scheme_2 0 (1 # 10) (169 # 1000000) 8.
Proof. apply (sufficient_depth_by scheme_2 0 4 4). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 2: Table 14, c_0 = 3, ε = h1.69e-4 prints 3 *)
(* Broken at level 3: 169/1000000 for points of spread 1/10 *)
Theorem finding_28 :
  exceeds_distance scheme_2 0 3 1 (169 # 100000).
Proof. apply (exceeds_distance_by scheme_2 0 3 0 [0; -1; 0; -1]%Z (19 # 25) 1 (169 # 100000)
  16 1 1 (1 # 128)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 2: Table 14, c_0 = 3, ε = h1.69e-4 prints 3 *)
(* Broken at natural parameters at level 3: 169/1000000 for points of spread 1/10 *)
Theorem finding_29 :
  exceeds_distance scheme_2 (-3 # 4) 3 1 (169 # 100000).
Proof. apply (exceeds_distance_by scheme_2 (-3 # 4) 3 0 [0; 1; 0; 1]%Z (119 # 125) 1 (169 # 100000)
  30 1 1 (1 # 131072)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 3: Table 14, c_0 = 3, ε = 8.79e-6 prints 4 *)
(* This depth suffices. *)
Theorem finding_30 :
  sufficient_depth scheme_2 0 (1 # 10) (879 # 100000000) 11.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 3: Table 14, c_0 = 3, ε = 8.79e-6 prints 4 *)
(* Broken at level 4: 879/100000000 for points of spread 1/10 *)
Theorem finding_31 :
  exceeds_distance scheme_2 0 4 1 (879 # 10000000).
Proof. apply (exceeds_distance_by scheme_2 0 4 0 [0; 1; 2]%Z 0 1 (879 # 10000000)
  25 1 1 (1 # 4096)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 3: Table 14, c_0 = 3, ε = 8.79e-6 prints 4 *)
(* Broken at natural parameters at level 4: 879/100000000 for points of spread 1/10 *)
Theorem finding_32 :
  exceeds_distance scheme_2 (-3 # 4) 4 1 (879 # 10000000).
Proof. apply (exceeds_distance_by scheme_2 (-3 # 4) 4 0 [0; 1; 0; 1]%Z (594 # 625) 1 (879 # 10000000)
  23 1 1 (1 # 8192)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 4: Table 14, c_0 = 3, ε = 4.55e-7 prints 6 *)
(* This depth suffices. *)
Theorem finding_33 :
  sufficient_depth scheme_2 0 (1 # 10) (91 # 200000000) 14.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 4: Table 14, c_0 = 3, ε = 4.55e-7 prints 6 *)
(* Broken at level 6: 91/200000000 for points of spread 1/10 *)
Theorem finding_34 :
  exceeds_distance scheme_2 0 6 1 (91 # 20000000).
Proof. apply (exceeds_distance_by scheme_2 0 6 0 [0; 1; 2]%Z 0 1 (91 # 20000000)
  34 1 1 (1 # 131072)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 4: Table 14, c_0 = 3, ε = 4.55e-7 prints 6 *)
(* Broken at natural parameters at level 6: 91/200000000 for points of spread 1/10 *)
Theorem finding_35 :
  exceeds_distance scheme_2 (-3 # 4) 6 1 (91 # 20000000).
Proof. apply (exceeds_distance_by scheme_2 (-3 # 4) 6 0 [0; 1; 0; 1]%Z (14844 # 15625) 1 (91 # 20000000)
  30 1 1 (1 # 131072)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 5: Table 14, c_0 = 3, ε = 2.35e-8 prints 7 *)
(* This depth suffices. *)
Theorem finding_36 :
  sufficient_depth scheme_2 0 (1 # 10) (47 # 2000000000) 17.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 5: Table 14, c_0 = 3, ε = 2.35e-8 prints 7 *)
(* Broken at level 7: 47/2000000000 for points of spread 1/10 *)
Theorem finding_37 :
  exceeds_distance scheme_2 0 7 1 (47 # 200000000).
Proof. apply (exceeds_distance_by scheme_2 0 7 0 [0; 1; 2]%Z 0 1 (47 # 200000000)
  37 1 1 (1 # 524288)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 5: Table 14, c_0 = 3, ε = 2.35e-8 prints 7 *)
(* Broken at natural parameters at level 7: 47/2000000000 for points of spread 1/10 *)
Theorem finding_38 :
  exceeds_distance scheme_2 (-3 # 4) 7 1 (47 # 200000000).
Proof. apply (exceeds_distance_by scheme_2 (-3 # 4) 7 0 [0; 1; 0; 1]%Z (74219 # 78125) 1 (47 # 200000000)
  34 1 1 (1 # 524288)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 6: Table 14, c_0 = 3, ε = 1.22e-9 prints 9 *)
(* This depth suffices. *)
Theorem finding_39 :
  sufficient_depth scheme_2 0 (1 # 10) (61 # 50000000000) 20.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 6: Table 14, c_0 = 3, ε = 1.22e-9 prints 9 *)
(* Broken at level 9: 61/50000000000 for points of spread 1/10 *)
Theorem finding_40 :
  exceeds_distance scheme_2 0 9 1 (61 # 5000000000).
Proof. apply (exceeds_distance_by scheme_2 0 9 0 [0; 1; 2]%Z 0 1 (61 # 5000000000)
  44 1 1 (1 # 8388608)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 6: Table 14, c_0 = 3, ε = 1.22e-9 prints 9 *)
(* Broken at natural parameters at level 9: 61/50000000000 for points of spread 1/10 *)
Theorem finding_41 :
  exceeds_distance scheme_2 (-3 # 4) 9 1 (61 # 5000000000).
Proof. apply (exceeds_distance_by scheme_2 (-3 # 4) 9 0 [0; 1; 0; 1]%Z (1855469 # 1953125) 1 (61 # 5000000000)
  39 1 1 (1 # 4194304)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 7: Table 14, c_0 = 3, ε = 6.32e-11 prints 10 *)
(* This depth suffices. *)
Theorem finding_42 :
  sufficient_depth scheme_2 0 (1 # 10) (79 # 1250000000000) 24.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 7: Table 14, c_0 = 3, ε = 6.32e-11 prints 10 *)
(* Broken at level 10: 79/1250000000000 for points of spread 1/10 *)
Theorem finding_43 :
  exceeds_distance scheme_2 0 10 1 (79 # 125000000000).
Proof. apply (exceeds_distance_by scheme_2 0 10 0 [0; 1; 0; 1]%Z (9277344 # 9765625) 1 (79 # 125000000000)
  39 1 1 (1 # 1048576)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 7: Table 14, c_0 = 3, ε = 6.32e-11 prints 10 *)
(* Broken at natural parameters at level 10: 79/1250000000000 for points of spread 1/10 *)
Theorem finding_44 :
  exceeds_distance scheme_2 (-3 # 4) 10 1 (79 # 125000000000).
Proof. apply (exceeds_distance_by scheme_2 (-3 # 4) 10 0 [0; 1; 0; 1]%Z (9277344 # 9765625) 1 (79 # 125000000000)
  43 1 1 (1 # 16777216)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 1: Table 14, c_0 = 4, ε = 3.27e-3 prints 1 *)
(* It rests on this constant. *)
Theorem finding_45 :
  backwards_constant scheme_1 difference_1 4 (20233 # 390625).
Proof. apply backwards_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 1: Table 14, c_0 = 4, ε = 3.27e-3 prints 1 *)
(* This depth suffices. *)
Theorem finding_46 :
  sufficient_depth scheme_2 0 (1 # 10) (327 # 100000) 5.
Proof. apply (sufficient_depth_by scheme_2 0 4 4). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 1: Table 14, c_0 = 4, ε = 3.27e-3 prints 1 *)
(* Broken at level 1: 327/100000 for points of spread 1/10 *)
Theorem finding_47 :
  exceeds_distance scheme_2 0 1 1 (327 # 10000).
Proof. apply (exceeds_distance_by scheme_2 0 1 0 [0; 1; 2]%Z 0 1 (327 # 10000)
  12 1 1 (1 # 32)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 1: Table 14, c_0 = 4, ε = 3.27e-3 prints 1 *)
(* Broken at natural parameters at level 1: 327/100000 for points of spread 1/10 *)
Theorem finding_48 :
  exceeds_distance scheme_2 (-3 # 4) 1 1 (327 # 10000).
Proof. apply (exceeds_distance_by scheme_2 (-3 # 4) 1 0 [0; -1; 0; -1]%Z (23 # 25) 1 (327 # 10000)
  12 1 1 (1 # 128)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 2: Table 14, c_0 = 4, ε = h1.69e-4 prints 2 *)
(* This depth suffices. *)
Theorem finding_49 :
  sufficient_depth scheme_2 0 (1 # 10) (169 # 1000000) 8.
Proof. apply (sufficient_depth_by scheme_2 0 4 4). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 2: Table 14, c_0 = 4, ε = h1.69e-4 prints 2 *)
(* Broken at level 2: 169/1000000 for points of spread 1/10 *)
Theorem finding_50 :
  exceeds_distance scheme_2 0 2 1 (169 # 100000).
Proof. apply (exceeds_distance_by scheme_2 0 2 0 [0; 1; 2]%Z 0 1 (169 # 100000)
  16 1 1 (1 # 128)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 2: Table 14, c_0 = 4, ε = h1.69e-4 prints 2 *)
(* Broken at natural parameters at level 2: 169/1000000 for points of spread 1/10 *)
Theorem finding_51 :
  exceeds_distance scheme_2 (-3 # 4) 2 1 (169 # 100000).
Proof. apply (exceeds_distance_by scheme_2 (-3 # 4) 2 0 [0; 1; 0; 1]%Z (24 # 25) 1 (169 # 100000)
  18 1 1 (1 # 1024)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 3: Table 14, c_0 = 4, ε = 8.79e-6 prints 3 *)
(* This depth suffices. *)
Theorem finding_52 :
  sufficient_depth scheme_2 0 (1 # 10) (879 # 100000000) 11.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 3: Table 14, c_0 = 4, ε = 8.79e-6 prints 3 *)
(* Broken at level 3: 879/100000000 for points of spread 1/10 *)
Theorem finding_53 :
  exceeds_distance scheme_2 0 3 1 (879 # 10000000).
Proof. apply (exceeds_distance_by scheme_2 0 3 0 [0; -1; 0; -1]%Z (19 # 25) 1 (879 # 10000000)
  16 1 1 (1 # 128)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 3: Table 14, c_0 = 4, ε = 8.79e-6 prints 3 *)
(* Broken at natural parameters at level 3: 879/100000000 for points of spread 1/10 *)
Theorem finding_54 :
  exceeds_distance scheme_2 (-3 # 4) 3 1 (879 # 10000000).
Proof. apply (exceeds_distance_by scheme_2 (-3 # 4) 3 0 [0; 1; 0; 1]%Z (119 # 125) 1 (879 # 10000000)
  20 1 1 (1 # 2048)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 4: Table 14, c_0 = 4, ε = 4.55e-7 prints 4 *)
(* This depth suffices. *)
Theorem finding_55 :
  sufficient_depth scheme_2 0 (1 # 10) (91 # 200000000) 14.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 4: Table 14, c_0 = 4, ε = 4.55e-7 prints 4 *)
(* Broken at level 4: 91/200000000 for points of spread 1/10 *)
Theorem finding_56 :
  exceeds_distance scheme_2 0 4 1 (91 # 20000000).
Proof. apply (exceeds_distance_by scheme_2 0 4 0 [0; 1; 2]%Z 0 1 (91 # 20000000)
  25 1 1 (1 # 4096)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 4: Table 14, c_0 = 4, ε = 4.55e-7 prints 4 *)
(* Broken at natural parameters at level 4: 91/200000000 for points of spread 1/10 *)
Theorem finding_57 :
  exceeds_distance scheme_2 (-3 # 4) 4 1 (91 # 20000000).
Proof. apply (exceeds_distance_by scheme_2 (-3 # 4) 4 0 [0; 1; 0; 1]%Z (594 # 625) 1 (91 # 20000000)
  23 1 1 (1 # 8192)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 5: Table 14, c_0 = 4, ε = 2.35e-8 prints 5 *)
(* This depth suffices. *)
Theorem finding_58 :
  sufficient_depth scheme_2 0 (1 # 10) (47 # 2000000000) 17.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 5: Table 14, c_0 = 4, ε = 2.35e-8 prints 5 *)
(* Broken at level 5: 47/2000000000 for points of spread 1/10 *)
Theorem finding_59 :
  exceeds_distance scheme_2 0 5 1 (47 # 200000000).
Proof. apply (exceeds_distance_by scheme_2 0 5 0 [0; 1; 0; 1]%Z (2969 # 3125) 1 (47 # 200000000)
  23 1 1 (1 # 2048)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 5: Table 14, c_0 = 4, ε = 2.35e-8 prints 5 *)
(* Broken at natural parameters at level 5: 47/2000000000 for points of spread 1/10 *)
Theorem finding_60 :
  exceeds_distance scheme_2 (-3 # 4) 5 1 (47 # 200000000).
Proof. apply (exceeds_distance_by scheme_2 (-3 # 4) 5 0 [0; 1; 0; 1]%Z (2969 # 3125) 1 (47 # 200000000)
  27 1 1 (1 # 32768)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 6: Table 14, c_0 = 4, ε = 1.22e-9 prints 6 *)
(* This depth suffices. *)
Theorem finding_61 :
  sufficient_depth scheme_2 0 (1 # 10) (61 # 50000000000) 20.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 6: Table 14, c_0 = 4, ε = 1.22e-9 prints 6 *)
(* Broken at level 6: 61/50000000000 for points of spread 1/10 *)
Theorem finding_62 :
  exceeds_distance scheme_2 0 6 1 (61 # 5000000000).
Proof. apply (exceeds_distance_by scheme_2 0 6 0 [0; 1; 2]%Z 0 1 (61 # 5000000000)
  32 1 1 (1 # 65536)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 6: Table 14, c_0 = 4, ε = 1.22e-9 prints 6 *)
(* Broken at natural parameters at level 6: 61/50000000000 for points of spread 1/10 *)
Theorem finding_63 :
  exceeds_distance scheme_2 (-3 # 4) 6 1 (61 # 5000000000).
Proof. apply (exceeds_distance_by scheme_2 (-3 # 4) 6 0 [0; 1; 0; 1]%Z (14844 # 15625) 1 (61 # 5000000000)
  30 1 1 (1 # 131072)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 7: Table 14, c_0 = 4, ε = 6.32e-11 prints 7 *)
(* This depth suffices. *)
Theorem finding_64 :
  sufficient_depth scheme_2 0 (1 # 10) (79 # 1250000000000) 24.
Proof. apply (sufficient_depth_by scheme_2 0 5 5). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 7: Table 14, c_0 = 4, ε = 6.32e-11 prints 7 *)
(* Broken at level 7: 79/1250000000000 for points of spread 1/10 *)
Theorem finding_65 :
  exceeds_distance scheme_2 0 7 1 (79 # 125000000000).
Proof. apply (exceeds_distance_by scheme_2 0 7 0 [0; 1; 2]%Z 0 1 (79 # 125000000000)
  37 1 1 (1 # 524288)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 7: Table 14, c_0 = 4, ε = 6.32e-11 prints 7 *)
(* Broken at natural parameters at level 7: 79/1250000000000 for points of spread 1/10 *)
Theorem finding_66 :
  exceeds_distance scheme_2 (-3 # 4) 7 1 (79 # 125000000000).
Proof. apply (exceeds_distance_by scheme_2 (-3 # 4) 7 0 [0; 1; 0; 1]%Z (74219 # 78125) 1 (79 # 125000000000)
  34 1 1 (1 # 524288)). vm_cast_no_check (eq_refl true). Qed.
