(** mustafa2020-nary, table table-8 (written by `subcert prove --coq`) *)
(* Not stated: xi = 1/10 *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition scheme_1 :=
  Scheme 1296 (-1) [[-55; 1155; 231; -35]; [-81; 729; 729; -81]; [-35; 231; 1155; -55]]%Z.

(* row 1, column 1: Table 8, c_0 = 1, ε = 6.59e-3 prints 7 *)
(* It rests on this constant. *)
Theorem finding_1 :
  contraction_constant scheme_1 1 (143 # 324).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 1: Table 8, c_0 = 1, ε = 6.59e-3 prints 7 *)
(* It rests on this constant. *)
Theorem finding_2 :
  scheme_norm scheme_1 1 (5 # 4).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 1: Table 8, c_0 = 2, ε = 6.59e-3 prints 3 *)
(* It rests on this constant. *)
Theorem finding_3 :
  contraction_constant scheme_1 2 (323 # 2187).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 1: Table 8, c_0 = 2, ε = 6.59e-3 prints 3 *)
(* It rests on this constant. *)
Theorem finding_4 :
  scheme_norm scheme_1 2 (350281 # 279936).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

Definition scheme_2 :=
  Scheme 1296 0 [[-55; 1155; 231; -35]; [-81; 729; 729; -81]; [-35; 231; 1155; -55]]%Z.

(* row 2, column 1: Table 8, c_0 = 2, ε = 6.59e-3 prints 3 *)
(* Broken at level 3: 659/100000 for points of spread 1/10 *)
Theorem finding_5 :
  exceeds_net_distance scheme_2 scheme_2 0 0 3 1 (659 # 10000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 3 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (2 # 9) (2 # 9) 1 (659 # 10000)
  7 1 1 (1 # 64) 1 1 (1 # 64)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 2: Table 8, c_0 = 2, ε = 1.11e-4 prints 6 *)
(* Broken at level 6: 111/1000000 for points of spread 1/10 *)
Theorem finding_6 :
  exceeds_net_distance scheme_2 scheme_2 0 0 6 1 (111 # 100000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 6 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (2 # 9) (2 # 9) 1 (111 # 100000)
  11 1 1 (1 # 2048) 1 1 (1 # 2048)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 3: Table 8, c_0 = 2, ε = 1.18e-6 prints 9 *)
(* Broken at level 9: 59/50000000 for points of spread 1/10 *)
Theorem finding_7 :
  exceeds_net_distance scheme_2 scheme_2 0 0 9 1 (59 # 5000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 9 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (2 # 9) (2 # 9) 1 (59 # 5000000)
  14 1 1 (1 # 32768) 1 1 (1 # 32768)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 4: Table 8, c_0 = 2, ε = 3.21e-8 prints 11 *)
(* Broken at level 11: 321/10000000000 for points of spread 1/10 *)
Theorem finding_8 :
  exceeds_net_distance scheme_2 scheme_2 0 0 11 1 (321 # 1000000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 11 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (2 # 9) (2 # 9) 1 (321 # 1000000000)
  17 1 1 (1 # 262144) 1 1 (1 # 262144)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 5: Table 8, c_0 = 2, ε = 5.45e-10 prints 14 *)
(* Broken at level 14: 109/200000000000 for points of spread 1/10 *)
Theorem finding_9 :
  exceeds_net_distance scheme_2 scheme_2 0 0 14 1 (109 # 20000000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 14 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (2 # 9) (2 # 9) 1 (109 # 20000000000)
  21 1 1 (1 # 8388608) 1 1 (1 # 8388608)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 6: Table 8, c_0 = 2, ε = 9.24e-12 prints 17 *)
(* Broken at level 17: 231/25000000000000 for points of spread 1/10 *)
Theorem finding_10 :
  exceeds_net_distance scheme_2 scheme_2 0 0 17 1 (231 # 2500000000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 17 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (2 # 9) (2 # 9) 1 (231 # 2500000000000)
  25 1 1 (1 # 268435456) 1 1 (1 # 268435456)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 7: Table 8, c_0 = 2, ε = 1.56e-13 prints 20 *)
(* Broken at level 20: 39/250000000000000 for points of spread 1/10 *)
Theorem finding_11 :
  exceeds_net_distance scheme_2 scheme_2 0 0 20 1 (39 # 25000000000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 20 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (2 # 9) (2 # 9) 1 (39 # 25000000000000)
  29 1 1 (1 # 8589934592) 1 1 (1 # 8589934592)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 1: Table 8, c_0 = 3, ε = 6.59e-3 prints 2 *)
(* It rests on this constant. *)
Theorem finding_12 :
  contraction_constant scheme_1 3 (11663 # 236196).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 1: Table 8, c_0 = 3, ε = 6.59e-3 prints 2 *)
(* It rests on this constant. *)
Theorem finding_13 :
  scheme_norm scheme_1 3 (155975 # 124416).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 1: Table 8, c_0 = 3, ε = 6.59e-3 prints 2 *)
(* Broken at level 2: 659/100000 for points of spread 1/10 *)
Theorem finding_14 :
  exceeds_net_distance scheme_2 scheme_2 0 0 2 1 (659 # 10000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 2 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (2 # 9) (2 # 9) 1 (659 # 10000)
  5 1 1 (1 # 16) 1 1 (1 # 16)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 2: Table 8, c_0 = 3, ε = 1.11e-4 prints 4 *)
(* Broken at level 4: 111/1000000 for points of spread 1/10 *)
Theorem finding_15 :
  exceeds_net_distance scheme_2 scheme_2 0 0 4 1 (111 # 100000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 4 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (2 # 9) (2 # 9) 1 (111 # 100000)
  7 1 1 (1 # 128) 1 1 (1 # 128)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 3: Table 8, c_0 = 3, ε = 1.18e-6 prints 5 *)
(* Broken at level 5: 59/50000000 for points of spread 1/10 *)
Theorem finding_16 :
  exceeds_net_distance scheme_2 scheme_2 0 0 5 1 (59 # 5000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 5 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (2 # 9) (2 # 9) 1 (59 # 5000000)
  9 1 1 (1 # 512) 1 1 (1 # 512)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 4: Table 8, c_0 = 3, ε = 3.21e-8 prints 7 *)
(* Broken at level 7: 321/10000000000 for points of spread 1/10 *)
Theorem finding_17 :
  exceeds_net_distance scheme_2 scheme_2 0 0 7 1 (321 # 1000000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 7 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (2 # 9) (2 # 9) 1 (321 # 1000000000)
  12 1 1 (1 # 4096) 1 1 (1 # 4096)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 5: Table 8, c_0 = 3, ε = 5.45e-10 prints 9 *)
(* Broken at level 9: 109/200000000000 for points of spread 1/10 *)
Theorem finding_18 :
  exceeds_net_distance scheme_2 scheme_2 0 0 9 1 (109 # 20000000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 9 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (2 # 9) (2 # 9) 1 (109 # 20000000000)
  14 1 1 (1 # 32768) 1 1 (1 # 32768)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 6: Table 8, c_0 = 3, ε = 9.24e-12 prints 10 *)
(* Broken at level 10: 231/25000000000000 for points of spread 1/10 *)
Theorem finding_19 :
  exceeds_net_distance scheme_2 scheme_2 0 0 10 1 (231 # 2500000000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 10 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (2 # 9) (2 # 9) 1 (231 # 2500000000000)
  16 1 1 (1 # 131072) 1 1 (1 # 131072)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 7: Table 8, c_0 = 3, ε = 1.56e-13 prints 12 *)
(* Broken at level 12: 39/250000000000000 for points of spread 1/10 *)
Theorem finding_20 :
  exceeds_net_distance scheme_2 scheme_2 0 0 12 1 (39 # 25000000000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 12 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (2 # 9) (2 # 9) 1 (39 # 25000000000000)
  18 1 1 (1 # 1048576) 1 1 (1 # 1048576)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 1: Table 8, c_0 = 4, ε = 6.59e-3 prints 1 *)
(* It rests on this constant. *)
Theorem finding_21 :
  contraction_constant scheme_1 4 (26243 # 1594323).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 1: Table 8, c_0 = 4, ε = 6.59e-3 prints 1 *)
(* It rests on this constant. *)
Theorem finding_22 :
  scheme_norm scheme_1 4 (294715967783 # 235092492288).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 1: Table 8, c_0 = 4, ε = 6.59e-3 prints 1 *)
(* Broken at level 1: 659/100000 for points of spread 1/10 *)
Theorem finding_23 :
  exceeds_net_distance scheme_2 scheme_2 0 0 1 1 (659 # 10000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 1 0 [0; -1; 0; 1; 0; -1]%Z 0 [0; -1; 0; 1; 0; -1]%Z (2 # 3) (2 # 3) 1 (659 # 10000)
  4 1 1 (1 # 8) 1 1 (1 # 8)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 2: Table 8, c_0 = 4, ε = 1.11e-4 prints 3 *)
(* Broken at level 3: 111/1000000 for points of spread 1/10 *)
Theorem finding_24 :
  exceeds_net_distance scheme_2 scheme_2 0 0 3 1 (111 # 100000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 3 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (2 # 9) (2 # 9) 1 (111 # 100000)
  7 1 1 (1 # 64) 1 1 (1 # 64)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 3: Table 8, c_0 = 4, ε = 1.18e-6 prints 4 *)
(* Broken at level 4: 59/50000000 for points of spread 1/10 *)
Theorem finding_25 :
  exceeds_net_distance scheme_2 scheme_2 0 0 4 1 (59 # 5000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 4 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (2 # 9) (2 # 9) 1 (59 # 5000000)
  7 1 1 (1 # 128) 1 1 (1 # 128)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 4: Table 8, c_0 = 4, ε = 3.21e-8 prints 5 *)
(* Broken at level 5: 321/10000000000 for points of spread 1/10 *)
Theorem finding_26 :
  exceeds_net_distance scheme_2 scheme_2 0 0 5 1 (321 # 1000000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 5 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (2 # 9) (2 # 9) 1 (321 # 1000000000)
  9 1 1 (1 # 512) 1 1 (1 # 512)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 5: Table 8, c_0 = 4, ε = 5.45e-10 prints 6 *)
(* Broken at level 6: 109/200000000000 for points of spread 1/10 *)
Theorem finding_27 :
  exceeds_net_distance scheme_2 scheme_2 0 0 6 1 (109 # 20000000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 6 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (2 # 9) (2 # 9) 1 (109 # 20000000000)
  10 1 1 (1 # 1024) 1 1 (1 # 1024)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 6: Table 8, c_0 = 4, ε = 9.24e-12 prints 8 *)
(* Broken at level 8: 231/25000000000000 for points of spread 1/10 *)
Theorem finding_28 :
  exceeds_net_distance scheme_2 scheme_2 0 0 8 1 (231 # 2500000000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 8 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (2 # 9) (2 # 9) 1 (231 # 2500000000000)
  13 1 1 (1 # 16384) 1 1 (1 # 16384)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 7: Table 8, c_0 = 4, ε = 1.56e-13 prints 9 *)
(* Broken at level 9: 39/250000000000000 for points of spread 1/10 *)
Theorem finding_29 :
  exceeds_net_distance scheme_2 scheme_2 0 0 9 1 (39 # 25000000000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 9 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (2 # 9) (2 # 9) 1 (39 # 25000000000000)
  14 1 1 (1 # 32768) 1 1 (1 # 32768)). vm_cast_no_check (eq_refl true). Qed.
