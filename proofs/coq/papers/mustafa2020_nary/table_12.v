(** mustafa2020-nary, table table-12 (written by `subcert prove --coq`) *)
(* Not stated: mu = 6/5, xi = 1/10 *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition scheme_1 :=
  Scheme 640 (-1) [[56; 446; 140; -2]; [15; 369; 257; -1]; [-1; 257; 369; 15]; [-2; 140; 446; 56]]%Z.

(* row 1, column 1: Table 12, c_0 = 1, ε = 1.51e-3 prints 4 *)
(* It rests on this constant. *)
Theorem finding_1 :
  contraction_constant scheme_1 1 (21 # 80).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 1: Table 12, c_0 = 1, ε = 1.51e-3 prints 4 *)
(* It rests on this constant. *)
Theorem finding_2 :
  scheme_norm scheme_1 1 (161 # 160).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 1: Table 12, c_0 = 2, ε = 1.51e-3 prints 2 *)
(* It rests on this constant. *)
Theorem finding_3 :
  contraction_constant scheme_1 2 (83 # 1280).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 1: Table 12, c_0 = 2, ε = 1.51e-3 prints 2 *)
(* It rests on this constant. *)
Theorem finding_4 :
  scheme_norm scheme_1 2 (103033 # 102400).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

Definition scheme_2 :=
  Scheme 640 0 [[56; 446; 140; -2]; [15; 369; 257; -1]; [-1; 257; 369; 15]; [-2; 140; 446; 56]]%Z.

(* row 2, column 1: Table 12, c_0 = 2, ε = 1.51e-3 prints 2 *)
(* Broken at level 2: 151/100000 for points of spread 1/10 *)
Theorem finding_5 :
  exceeds_net_distance scheme_2 scheme_2 0 0 2 1 (151 # 10000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 2 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (7 # 16) (7 # 16) 1 (151 # 10000)
  4 1 1 (1 # 64) 1 1 (1 # 64)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 2: Table 12, c_0 = 2, ε = 6.36e-6 prints 4 *)
(* Broken at level 4: 159/25000000 for points of spread 1/10 *)
Theorem finding_6 :
  exceeds_net_distance scheme_2 scheme_2 0 0 4 1 (159 # 2500000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 4 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (7 # 16) (7 # 16) 1 (159 # 2500000)
  5 1 1 (1 # 512) 1 1 (1 # 512)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 3: Table 12, c_0 = 2, ε = 2.68e-8 prints 6 *)
(* Broken at level 6: 67/2500000000 for points of spread 1/10 *)
Theorem finding_7 :
  exceeds_net_distance scheme_2 scheme_2 0 0 6 1 (67 # 250000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 6 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (7 # 16) (7 # 16) 1 (67 # 250000000)
  8 1 1 (1 # 8192) 1 1 (1 # 8192)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 4: Table 12, c_0 = 2, ε = 1.13e-10 prints 8 *)
(* Broken at level 8: 113/1000000000000 for points of spread 1/10 *)
Theorem finding_8 :
  exceeds_net_distance scheme_2 scheme_2 0 0 8 1 (113 # 100000000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 8 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (7 # 16) (7 # 16) 1 (113 # 100000000000)
  10 1 1 (1 # 131072) 1 1 (1 # 131072)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 5: Table 12, c_0 = 2, ε = 4.74e-13 prints 10 *)
(* Broken at level 10: 237/500000000000000 for points of spread 1/10 *)
Theorem finding_9 :
  exceeds_net_distance scheme_2 scheme_2 0 0 10 1 (237 # 50000000000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 10 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (7 # 16) (7 # 16) 1 (237 # 50000000000000)
  12 1 1 (1 # 2097152) 1 1 (1 # 2097152)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 6: Table 12, c_0 = 2, ε = 1.99e-15 prints 12 *)
(* Broken at level 12: 199/100000000000000000 for points of spread 1/10 *)
Theorem finding_10 :
  exceeds_net_distance scheme_2 scheme_2 0 0 12 1 (199 # 10000000000000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 12 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (7 # 16) (7 # 16) 1 (199 # 10000000000000000)
  14 1 1 (1 # 33554432) 1 1 (1 # 33554432)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 7: Table 12, c_0 = 2, ε = 8.4e-18 prints 14 *)
(* Broken at level 14: 21/2500000000000000000 for points of spread 1/10 *)
Theorem finding_11 :
  exceeds_net_distance scheme_2 scheme_2 0 0 14 1 (21 # 250000000000000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 14 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (7 # 16) (7 # 16) 1 (21 # 250000000000000000)
  16 1 1 (1 # 536870912) 1 1 (1 # 536870912)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 1: Table 12, c_0 = 3, ε = 1.51e-3 prints 1 *)
(* It rests on this constant. *)
Theorem finding_12 :
  contraction_constant scheme_1 3 (1327 # 81920).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 1: Table 12, c_0 = 3, ε = 1.51e-3 prints 1 *)
(* It rests on this constant. *)
Theorem finding_13 :
  scheme_norm scheme_1 3 (1648521 # 1638400).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 1: Table 12, c_0 = 3, ε = 1.51e-3 prints 1 *)
(* Broken at level 1: 151/100000 for points of spread 1/10 *)
Theorem finding_14 :
  exceeds_net_distance scheme_2 scheme_2 0 0 1 1 (151 # 10000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 1 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (3 # 4) (3 # 4) 1 (151 # 10000)
  2 1 1 (1 # 8) 1 1 (1 # 8)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 1: Table 12, c_0 = 3, ε = 1.51e-3 prints 1 *)
(* Broken at natural parameters at level 1: 151/100000 for points of spread 1/10 *)
Theorem finding_15 :
  exceeds_net_distance scheme_2 scheme_2 (-3 # 2) (-3 # 2) 1 1 (151 # 10000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 (-3 # 2) (-3 # 2) 1 0 [0; 1; 0; 1; 2]%Z 0 [0; 1; 0; 1; 2]%Z (5 # 8) (5 # 8) 1 (151 # 10000)
  5 1 1 (1 # 512) 1 1 (1 # 512)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 2: Table 12, c_0 = 3, ε = 6.36e-6 prints 3 *)
(* Broken at level 3: 159/25000000 for points of spread 1/10 *)
Theorem finding_16 :
  exceeds_net_distance scheme_2 scheme_2 0 0 3 1 (159 # 2500000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 3 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (7 # 16) (7 # 16) 1 (159 # 2500000)
  4 1 1 (1 # 128) 1 1 (1 # 128)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 2: Table 12, c_0 = 3, ε = 6.36e-6 prints 3 *)
(* Broken at natural parameters at level 3: 159/25000000 for points of spread 1/10 *)
Theorem finding_17 :
  exceeds_net_distance scheme_2 scheme_2 (-3 # 2) (-3 # 2) 3 1 (159 # 2500000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 (-3 # 2) (-3 # 2) 3 0 [0; 1; 0; 1; 2]%Z 0 [0; 1; 0; 1; 2]%Z (77 # 128) (77 # 128) 1 (159 # 2500000)
  9 1 1 (1 # 131072) 1 1 (1 # 131072)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 3: Table 12, c_0 = 3, ε = 2.68e-8 prints 4 *)
(* Broken at level 4: 67/2500000000 for points of spread 1/10 *)
Theorem finding_18 :
  exceeds_net_distance scheme_2 scheme_2 0 0 4 1 (67 # 250000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 4 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (7 # 16) (7 # 16) 1 (67 # 250000000)
  5 1 1 (1 # 512) 1 1 (1 # 512)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 3: Table 12, c_0 = 3, ε = 2.68e-8 prints 4 *)
(* Broken at natural parameters at level 4: 67/2500000000 for points of spread 1/10 *)
Theorem finding_19 :
  exceeds_net_distance scheme_2 scheme_2 (-3 # 2) (-3 # 2) 4 1 (67 # 250000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 (-3 # 2) (-3 # 2) 4 0 [0; -1; -2; -1; -2]%Z 0 [0; -1; -2; -1; -2]%Z (205 # 512) (205 # 512) 1 (67 # 250000000)
  10 1 1 (1 # 1048576) 1 1 (1 # 1048576)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 4: Table 12, c_0 = 3, ε = 1.13e-10 prints 5 *)
(* Broken at level 5: 113/1000000000000 for points of spread 1/10 *)
Theorem finding_20 :
  exceeds_net_distance scheme_2 scheme_2 0 0 5 1 (113 # 100000000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 5 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (7 # 16) (7 # 16) 1 (113 # 100000000000)
  7 1 1 (1 # 2048) 1 1 (1 # 2048)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 4: Table 12, c_0 = 3, ε = 1.13e-10 prints 5 *)
(* Broken at natural parameters at level 5: 113/1000000000000 for points of spread 1/10 *)
Theorem finding_21 :
  exceeds_net_distance scheme_2 scheme_2 (-3 # 2) (-3 # 2) 5 1 (113 # 100000000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 (-3 # 2) (-3 # 2) 5 0 [0; 1; 0; 1; 2]%Z 0 [0; 1; 0; 1; 2]%Z (1229 # 2048) (1229 # 2048) 1 (113 # 100000000000)
  12 1 1 (1 # 16777216) 1 1 (1 # 16777216)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 5: Table 12, c_0 = 3, ε = 4.74e-13 prints 7 *)
(* Broken at level 7: 237/500000000000000 for points of spread 1/10 *)
Theorem finding_22 :
  exceeds_net_distance scheme_2 scheme_2 0 0 7 1 (237 # 50000000000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 7 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (7 # 16) (7 # 16) 1 (237 # 50000000000000)
  9 1 1 (1 # 32768) 1 1 (1 # 32768)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 5: Table 12, c_0 = 3, ε = 4.74e-13 prints 7 *)
(* Broken at natural parameters at level 7: 237/500000000000000 for points of spread 1/10 *)
Theorem finding_23 :
  exceeds_net_distance scheme_2 scheme_2 (-3 # 2) (-3 # 2) 7 1 (237 # 50000000000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 (-3 # 2) (-3 # 2) 7 0 [0; 1; 0; 1; 2]%Z 0 [0; 1; 0; 1; 2]%Z (19661 # 32768) (19661 # 32768) 1 (237 # 50000000000000)
  16 1 1 (1 # 4294967296) 1 1 (1 # 4294967296)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 6: Table 12, c_0 = 3, ε = 1.99e-15 prints 8 *)
(* Broken at level 8: 199/100000000000000000 for points of spread 1/10 *)
Theorem finding_24 :
  exceeds_net_distance scheme_2 scheme_2 0 0 8 1 (199 # 10000000000000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 8 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (7 # 16) (7 # 16) 1 (199 # 10000000000000000)
  10 1 1 (1 # 131072) 1 1 (1 # 131072)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 6: Table 12, c_0 = 3, ε = 1.99e-15 prints 8 *)
(* Broken at natural parameters at level 8: 199/100000000000000000 for points of spread 1/10 *)
Theorem finding_25 :
  exceeds_net_distance scheme_2 scheme_2 (-3 # 2) (-3 # 2) 8 1 (199 # 10000000000000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 (-3 # 2) (-3 # 2) 8 0 [0; -1; -2; -1; -2]%Z 0 [0; -1; -2; -1; -2]%Z (52429 # 131072) (52429 # 131072) 1 (199 # 10000000000000000)
  18 1 1 (1 # 68719476736) 1 1 (1 # 68719476736)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 7: Table 12, c_0 = 3, ε = 8.4e-18 prints 9 *)
(* Broken at level 9: 21/2500000000000000000 for points of spread 1/10 *)
Theorem finding_26 :
  exceeds_net_distance scheme_2 scheme_2 0 0 9 1 (21 # 250000000000000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 9 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (7 # 16) (7 # 16) 1 (21 # 250000000000000000)
  11 1 1 (1 # 524288) 1 1 (1 # 524288)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 7: Table 12, c_0 = 3, ε = 8.4e-18 prints 9 *)
(* Broken at natural parameters at level 9: 21/2500000000000000000 for points of spread 1/10 *)
Theorem finding_27 :
  exceeds_net_distance scheme_2 scheme_2 (-3 # 2) (-3 # 2) 9 1 (21 # 250000000000000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 (-3 # 2) (-3 # 2) 9 0 [0; 1; 0; 1; 2]%Z 0 [0; 1; 0; 1; 2]%Z (314573 # 524288) (314573 # 524288) 1 (21 # 250000000000000000)
  21 1 1 (1 # 1099511627776) 1 1 (1 # 1099511627776)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 1: Table 12, c_0 = 4, ε = 1.51e-3 prints 1 *)
(* It rests on this constant. *)
Theorem finding_28 :
  contraction_constant scheme_1 4 (21231 # 5242880).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 1: Table 12, c_0 = 4, ε = 1.51e-3 prints 1 *)
(* It rests on this constant. *)
Theorem finding_29 :
  scheme_norm scheme_1 4 (26376329 # 26214400).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 1: Table 12, c_0 = 4, ε = 1.51e-3 prints 1 *)
(* Broken at level 1: 151/100000 for points of spread 1/10 *)
Theorem finding_30 :
  exceeds_net_distance scheme_2 scheme_2 0 0 1 1 (151 # 10000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 1 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (3 # 4) (3 # 4) 1 (151 # 10000)
  2 1 1 (1 # 8) 1 1 (1 # 8)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 1: Table 12, c_0 = 4, ε = 1.51e-3 prints 1 *)
(* Broken at natural parameters at level 1: 151/100000 for points of spread 1/10 *)
Theorem finding_31 :
  exceeds_net_distance scheme_2 scheme_2 (-3 # 2) (-3 # 2) 1 1 (151 # 10000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 (-3 # 2) (-3 # 2) 1 0 [0; 1; 0; 1; 2]%Z 0 [0; 1; 0; 1; 2]%Z (5 # 8) (5 # 8) 1 (151 # 10000)
  5 1 1 (1 # 512) 1 1 (1 # 512)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 2: Table 12, c_0 = 4, ε = 6.36e-6 prints 2 *)
(* Broken at level 2: 159/25000000 for points of spread 1/10 *)
Theorem finding_32 :
  exceeds_net_distance scheme_2 scheme_2 0 0 2 1 (159 # 2500000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 2 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (7 # 16) (7 # 16) 1 (159 # 2500000)
  3 1 1 (1 # 32) 1 1 (1 # 32)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 2: Table 12, c_0 = 4, ε = 6.36e-6 prints 2 *)
(* Broken at natural parameters at level 2: 159/25000000 for points of spread 1/10 *)
Theorem finding_33 :
  exceeds_net_distance scheme_2 scheme_2 (-3 # 2) (-3 # 2) 2 1 (159 # 2500000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 (-3 # 2) (-3 # 2) 2 0 [0; -1; -2; -1; -2]%Z 0 [0; -1; -2; -1; -2]%Z (13 # 32) (13 # 32) 1 (159 # 2500000)
  6 1 1 (1 # 4096) 1 1 (1 # 4096)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 3: Table 12, c_0 = 4, ε = 2.68e-8 prints 3 *)
(* Broken at level 3: 67/2500000000 for points of spread 1/10 *)
Theorem finding_34 :
  exceeds_net_distance scheme_2 scheme_2 0 0 3 1 (67 # 250000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 3 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (7 # 16) (7 # 16) 1 (67 # 250000000)
  4 1 1 (1 # 128) 1 1 (1 # 128)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 3: Table 12, c_0 = 4, ε = 2.68e-8 prints 3 *)
(* Broken at natural parameters at level 3: 67/2500000000 for points of spread 1/10 *)
Theorem finding_35 :
  exceeds_net_distance scheme_2 scheme_2 (-3 # 2) (-3 # 2) 3 1 (67 # 250000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 (-3 # 2) (-3 # 2) 3 0 [0; 1; 0; 1; 2]%Z 0 [0; 1; 0; 1; 2]%Z (77 # 128) (77 # 128) 1 (67 # 250000000)
  8 1 1 (1 # 65536) 1 1 (1 # 65536)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 4: Table 12, c_0 = 4, ε = 1.13e-10 prints 4 *)
(* Broken at level 4: 113/1000000000000 for points of spread 1/10 *)
Theorem finding_36 :
  exceeds_net_distance scheme_2 scheme_2 0 0 4 1 (113 # 100000000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 4 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (7 # 16) (7 # 16) 1 (113 # 100000000000)
  5 1 1 (1 # 512) 1 1 (1 # 512)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 4: Table 12, c_0 = 4, ε = 1.13e-10 prints 4 *)
(* Broken at natural parameters at level 4: 113/1000000000000 for points of spread 1/10 *)
Theorem finding_37 :
  exceeds_net_distance scheme_2 scheme_2 (-3 # 2) (-3 # 2) 4 1 (113 # 100000000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 (-3 # 2) (-3 # 2) 4 0 [0; -1; -2; -1; -2]%Z 0 [0; -1; -2; -1; -2]%Z (205 # 512) (205 # 512) 1 (113 # 100000000000)
  10 1 1 (1 # 1048576) 1 1 (1 # 1048576)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 5: Table 12, c_0 = 4, ε = 4.74e-13 prints 5 *)
(* Broken at level 5: 237/500000000000000 for points of spread 1/10 *)
Theorem finding_38 :
  exceeds_net_distance scheme_2 scheme_2 0 0 5 1 (237 # 50000000000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 5 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (7 # 16) (7 # 16) 1 (237 # 50000000000000)
  7 1 1 (1 # 2048) 1 1 (1 # 2048)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 5: Table 12, c_0 = 4, ε = 4.74e-13 prints 5 *)
(* Broken at natural parameters at level 5: 237/500000000000000 for points of spread 1/10 *)
Theorem finding_39 :
  exceeds_net_distance scheme_2 scheme_2 (-3 # 2) (-3 # 2) 5 1 (237 # 50000000000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 (-3 # 2) (-3 # 2) 5 0 [0; 1; 0; 1; 2]%Z 0 [0; 1; 0; 1; 2]%Z (1229 # 2048) (1229 # 2048) 1 (237 # 50000000000000)
  12 1 1 (1 # 16777216) 1 1 (1 # 16777216)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 6: Table 12, c_0 = 4, ε = 1.99e-15 prints 6 *)
(* Broken at level 6: 199/100000000000000000 for points of spread 1/10 *)
Theorem finding_40 :
  exceeds_net_distance scheme_2 scheme_2 0 0 6 1 (199 # 10000000000000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 6 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (7 # 16) (7 # 16) 1 (199 # 10000000000000000)
  8 1 1 (1 # 8192) 1 1 (1 # 8192)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 6: Table 12, c_0 = 4, ε = 1.99e-15 prints 6 *)
(* Broken at natural parameters at level 6: 199/100000000000000000 for points of spread 1/10 *)
Theorem finding_41 :
  exceeds_net_distance scheme_2 scheme_2 (-3 # 2) (-3 # 2) 6 1 (199 # 10000000000000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 (-3 # 2) (-3 # 2) 6 0 [0; -1; -2; -1; -2]%Z 0 [0; -1; -2; -1; -2]%Z (3277 # 8192) (3277 # 8192) 1 (199 # 10000000000000000)
  14 1 1 (1 # 268435456) 1 1 (1 # 268435456)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 7: Table 12, c_0 = 4, ε = 8.4e-18 prints 7 *)
(* Broken at level 7: 21/2500000000000000000 for points of spread 1/10 *)
Theorem finding_42 :
  exceeds_net_distance scheme_2 scheme_2 0 0 7 1 (21 # 250000000000000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 7 0 [0; -1; 0; 1; 0]%Z 0 [0; -1; 0; 1; 0]%Z (7 # 16) (7 # 16) 1 (21 # 250000000000000000)
  9 1 1 (1 # 32768) 1 1 (1 # 32768)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 7: Table 12, c_0 = 4, ε = 8.4e-18 prints 7 *)
(* Broken at natural parameters at level 7: 21/2500000000000000000 for points of spread 1/10 *)
Theorem finding_43 :
  exceeds_net_distance scheme_2 scheme_2 (-3 # 2) (-3 # 2) 7 1 (21 # 250000000000000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 (-3 # 2) (-3 # 2) 7 0 [0; 1; 0; 1; 2]%Z 0 [0; 1; 0; 1; 2]%Z (19661 # 32768) (19661 # 32768) 1 (21 # 250000000000000000)
  16 1 1 (1 # 4294967296) 1 1 (1 # 4294967296)). vm_cast_no_check (eq_refl true). Qed.
