(** mustafa2020-nary, table table-16 (written by `subcert prove --coq`) *)
(* Not stated: xi = 1/10 *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition scheme_1 :=
  Scheme 25 (-1) [[7; 21; -3]; [3; 24; -2]; [0; 25; 0]; [-2; 24; 3]; [-3; 21; 7]]%Z.

(* row 1, column 1: Table 16, c_0 = 1, ε = 3.21e-2 prints 23 *)
(* It rests on this constant. *)
Theorem finding_1 :
  contraction_constant scheme_1 1 (17 # 25).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 1: Table 16, c_0 = 1, ε = 3.21e-2 prints 23 *)
(* It rests on this constant. *)
Theorem finding_2 :
  scheme_norm scheme_1 1 (31 # 25).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 1: Table 16, c_0 = 2, ε = 3.21e-2 prints 3 *)
(* It rests on this constant. *)
Theorem finding_3 :
  contraction_constant scheme_1 2 (169 # 625).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 1: Table 16, c_0 = 2, ε = 3.21e-2 prints 3 *)
(* It rests on this constant. *)
Theorem finding_4 :
  scheme_norm scheme_1 2 (781 # 625).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 1: Table 16, c_0 = 3, ε = 3.21e-2 prints 2 *)
(* It rests on this constant. *)
Theorem finding_5 :
  contraction_constant scheme_1 3 (1433 # 15625).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 1: Table 16, c_0 = 3, ε = 3.21e-2 prints 2 *)
(* It rests on this constant. *)
Theorem finding_6 :
  scheme_norm scheme_1 3 (19573 # 15625).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

Definition scheme_2 :=
  Scheme 25 0 [[7; 21; -3]; [3; 24; -2]; [0; 25; 0]; [-2; 24; 3]; [-3; 21; 7]]%Z.

(* row 3, column 1: Table 16, c_0 = 3, ε = 3.21e-2 prints 2 *)
(* Broken at level 2: 321/10000 for points of spread 1/10 *)
Theorem finding_7 :
  exceeds_net_distance scheme_2 scheme_2 0 0 2 1 (321 # 1000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 2 0 [0; -1; 0; -1]%Z 0 [0; -1; 0; -1]%Z (19 # 25) (19 # 25) 1 (321 # 1000)
  14 1 1 (1 # 64) 1 1 (1 # 64)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 2: Table 16, c_0 = 3, ε = h3.77e - 3 prints 3 *)
(* Broken at level 3: 377/100000 for points of spread 1/10 *)
Theorem finding_8 :
  exceeds_net_distance scheme_2 scheme_2 0 0 3 1 (377 # 10000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 3 0 [0; -1; 0; -1]%Z 0 [0; -1; 0; -1]%Z (94 # 125) (94 # 125) 1 (377 # 10000)
  14 1 1 (1 # 64) 1 1 (1 # 64)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 3: Table 16, c_0 = 3, ε = 4.44e-4 prints 5 *)
(* Broken at level 5: 111/250000 for points of spread 1/10 *)
Theorem finding_9 :
  exceeds_net_distance scheme_2 scheme_2 0 0 5 1 (111 # 25000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 5 0 [0; -1; 0; -1]%Z 0 [0; -1; 0; -1]%Z (2344 # 3125) (2344 # 3125) 1 (111 # 25000)
  21 1 1 (1 # 1024) 1 1 (1 # 1024)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 4: Table 16, c_0 = 3, ε = 5.22e-5 prints 6 *)
(* Broken at level 6: 261/5000000 for points of spread 1/10 *)
Theorem finding_10 :
  exceeds_net_distance scheme_2 scheme_2 0 0 6 1 (261 # 500000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 6 0 [0; -1; 0; -1]%Z 0 [0; -1; 0; -1]%Z (11719 # 15625) (11719 # 15625) 1 (261 # 500000)
  23 1 1 (1 # 2048) 1 1 (1 # 2048)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 5: Table 16, c_0 = 3, ε = 6.14e-6 prints 8 *)
(* Broken at level 8: 307/50000000 for points of spread 1/10 *)
Theorem finding_11 :
  exceeds_net_distance scheme_2 scheme_2 0 0 8 1 (307 # 5000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 8 0 [0; -1; 0; -1]%Z 0 [0; -1; 0; -1]%Z (292969 # 390625) (292969 # 390625) 1 (307 # 5000000)
  30 1 1 (1 # 32768) 1 1 (1 # 32768)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 6: Table 16, c_0 = 3, ε = 7.21e-7 prints 9 *)
(* Broken at level 9: 721/1000000000 for points of spread 1/10 *)
Theorem finding_12 :
  exceeds_net_distance scheme_2 scheme_2 0 0 9 1 (721 # 100000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 9 0 [0; -1; 0; -1]%Z 0 [0; -1; 0; -1]%Z (1464844 # 1953125) (1464844 # 1953125) 1 (721 # 100000000)
  34 1 1 (1 # 131072) 1 1 (1 # 131072)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 7: Table 16, c_0 = 3, ε = 8.48 - 8 prints 11 *)
(* Broken at level 11: 53/625000000 for points of spread 1/10 *)
Theorem finding_13 :
  exceeds_net_distance scheme_2 scheme_2 0 0 11 1 (53 # 62500000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 11 0 [0; -1; 0; -1]%Z 0 [0; -1; 0; -1]%Z (36621094 # 48828125) (36621094 # 48828125) 1 (53 # 62500000)
  39 1 1 (1 # 1048576) 1 1 (1 # 1048576)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 1: Table 16, c_0 = 4, ε = 3.21e-2 prints 1 *)
(* It rests on this constant. *)
Theorem finding_14 :
  contraction_constant scheme_1 4 (11281 # 390625).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 1: Table 16, c_0 = 4, ε = 3.21e-2 prints 1 *)
(* It rests on this constant. *)
Theorem finding_15 :
  scheme_norm scheme_1 4 (19573 # 15625).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 1: Table 16, c_0 = 4, ε = 3.21e-2 prints 1 *)
(* Broken at level 1: 321/10000 for points of spread 1/10 *)
Theorem finding_16 :
  exceeds_net_distance scheme_2 scheme_2 0 0 1 1 (321 # 1000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 1 0 [0; -1; 0; -1]%Z 0 [0; -1; 0; -1]%Z (4 # 5) (4 # 5) 1 (321 # 1000)
  8 1 1 (1 # 8) 1 1 (1 # 8)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 2: Table 16, c_0 = 4, ε = h3.77e - 3 prints 2 *)
(* Broken at level 2: 377/100000 for points of spread 1/10 *)
Theorem finding_17 :
  exceeds_net_distance scheme_2 scheme_2 0 0 2 1 (377 # 10000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 2 0 [0; -1; 0; -1]%Z 0 [0; -1; 0; -1]%Z (19 # 25) (19 # 25) 1 (377 # 10000)
  10 1 1 (1 # 16) 1 1 (1 # 16)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 3: Table 16, c_0 = 4, ε = 4.44e-4 prints 3 *)
(* Broken at level 3: 111/250000 for points of spread 1/10 *)
Theorem finding_18 :
  exceeds_net_distance scheme_2 scheme_2 0 0 3 1 (111 # 25000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 3 0 [0; -1; 0; -1]%Z 0 [0; -1; 0; -1]%Z (94 # 125) (94 # 125) 1 (111 # 25000)
  14 1 1 (1 # 64) 1 1 (1 # 64)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 4: Table 16, c_0 = 4, ε = 5.22e-5 prints 4 *)
(* Broken at level 4: 261/5000000 for points of spread 1/10 *)
Theorem finding_19 :
  exceeds_net_distance scheme_2 scheme_2 0 0 4 1 (261 # 500000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 4 0 [0; -1; 0; -1]%Z 0 [0; -1; 0; -1]%Z (469 # 625) (469 # 625) 1 (261 # 500000)
  17 1 1 (1 # 256) 1 1 (1 # 256)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 5: Table 16, c_0 = 4, ε = 6.14e-6 prints 5 *)
(* Broken at level 5: 307/50000000 for points of spread 1/10 *)
Theorem finding_20 :
  exceeds_net_distance scheme_2 scheme_2 0 0 5 1 (307 # 5000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 5 0 [0; -1; 0; -1]%Z 0 [0; -1; 0; -1]%Z (2344 # 3125) (2344 # 3125) 1 (307 # 5000000)
  19 1 1 (1 # 512) 1 1 (1 # 512)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 6: Table 16, c_0 = 4, ε = 7.21e-7 prints 6 *)
(* Broken at level 6: 721/1000000000 for points of spread 1/10 *)
Theorem finding_21 :
  exceeds_net_distance scheme_2 scheme_2 0 0 6 1 (721 # 100000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 6 0 [0; -1; 0; -1]%Z 0 [0; -1; 0; -1]%Z (11719 # 15625) (11719 # 15625) 1 (721 # 100000000)
  23 1 1 (1 # 2048) 1 1 (1 # 2048)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 7: Table 16, c_0 = 4, ε = 8.48 - 8 prints 7 *)
(* Broken at level 7: 53/625000000 for points of spread 1/10 *)
Theorem finding_22 :
  exceeds_net_distance scheme_2 scheme_2 0 0 7 1 (53 # 62500000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 7 0 [0; -1; 0; -1]%Z 0 [0; -1; 0; -1]%Z (58594 # 78125) (58594 # 78125) 1 (53 # 62500000)
  26 1 1 (1 # 8192) 1 1 (1 # 8192)). vm_cast_no_check (eq_refl true). Qed.
