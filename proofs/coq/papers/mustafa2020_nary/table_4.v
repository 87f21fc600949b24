(** mustafa2020-nary, table table-4 (written by `subcert prove --coq`) *)
(* Not stated: w = 3/400, xi = 1/10 *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition scheme_1 :=
  Scheme 400 (-2) [[0; 0; 400; 0; 0; 0]; [3; -34; 231; 231; -34; 3]]%Z.

(* row 1, column 1: Table 4, c_0 = 1, ε = 0.0313 prints 47 *)
(* It rests on this constant. *)
Theorem finding_1 :
  contraction_constant scheme_1 1 (67 # 100).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 1: Table 4, c_0 = 1, ε = 0.0313 prints 47 *)
(* It rests on this constant. *)
Theorem finding_2 :
  scheme_norm scheme_1 1 (67 # 50).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 1: Table 4, c_0 = 2, ε = 0.0313 prints 4 *)
(* It rests on this constant. *)
Theorem finding_3 :
  contraction_constant scheme_1 2 (2841 # 8000).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 1: Table 4, c_0 = 2, ε = 0.0313 prints 4 *)
(* It rests on this constant. *)
Theorem finding_4 :
  scheme_norm scheme_1 2 (67 # 50).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

Definition scheme_2 :=
  Scheme 400 0 [[0; 0; 400; 0; 0; 0]; [3; -34; 231; 231; -34; 3]]%Z.

(* row 2, column 1: Table 4, c_0 = 2, ε = 0.0313 prints 4 *)
(* Broken at level 4: 313/10000 for points of spread 1/10 *)
Theorem finding_5 :
  exceeds_net_distance scheme_2 scheme_2 0 0 4 1 (313 # 1000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 4 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z (1 # 8) (1 # 8) 1 (313 # 1000)
  12 1 1 (1 # 16) 1 1 (1 # 16)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 2: Table 4, c_0 = 2, ε = 0.0018 prints 8 *)
(* Broken at level 8: 9/5000 for points of spread 1/10 *)
Theorem finding_6 :
  exceeds_net_distance scheme_2 scheme_2 0 0 8 1 (9 # 500).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 8 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z (1 # 128) (1 # 128) 1 (9 # 500)
  19 1 1 (1 # 256) 1 1 (1 # 256)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 3: Table 4, c_0 = 2, ε = 0.0001 prints 11 *)
(* Broken at level 11: 1/10000 for points of spread 1/10 *)
Theorem finding_7 :
  exceeds_net_distance scheme_2 scheme_2 0 0 11 1 (1 # 1000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 11 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z (1 # 1024) (1 # 1024) 1 (1 # 1000)
  24 1 1 (1 # 2048) 1 1 (1 # 2048)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 4: Table 4, c_0 = 2, ε = 6.44e-6 prints 15 *)
(* Broken at level 15: 161/25000000 for points of spread 1/10 *)
Theorem finding_8 :
  exceeds_net_distance scheme_2 scheme_2 0 0 15 1 (161 # 2500000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 15 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z (1 # 16384) (1 # 16384) 1 (161 # 2500000)
  31 1 1 (1 # 32768) 1 1 (1 # 32768)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 5: Table 4, c_0 = 2, ε = 3.80e-7 prints 18 *)
(* Broken at level 18: 19/50000000 for points of spread 1/10 *)
Theorem finding_9 :
  exceeds_net_distance scheme_2 scheme_2 0 0 18 1 (19 # 5000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 18 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z (1 # 131072) (1 # 131072) 1 (19 # 5000000)
  36 1 1 (1 # 262144) 1 1 (1 # 262144)). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 6: Table 4, c_0 = 2, ε = 2.24e-8 prints 22 *)
(* Broken at level 22: 7/312500000 for points of spread 1/10 *)
Theorem finding_10 :
  exceeds_net_distance scheme_2 scheme_2 0 0 22 1 (7 # 31250000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 22 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z (1 # 2097152) (1 # 2097152) 1 (7 # 31250000)
  43 1 1 (1 # 4194304) 1 1 (1 # 4194304)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 1: Table 4, c_0 = 3, ε = 0.0313 prints 2 *)
(* It rests on this constant. *)
Theorem finding_11 :
  contraction_constant scheme_1 3 (2882753 # 16000000).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 1: Table 4, c_0 = 3, ε = 0.0313 prints 2 *)
(* It rests on this constant. *)
Theorem finding_12 :
  scheme_norm scheme_1 3 (67 # 50).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 1: Table 4, c_0 = 3, ε = 0.0313 prints 2 *)
(* Broken at level 2: 313/10000 for points of spread 1/10 *)
Theorem finding_13 :
  exceeds_net_distance scheme_2 scheme_2 0 0 2 1 (313 # 1000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 2 1 [0; 1; 0; 1; 2; 1; 2]%Z 1 [0; 1; 0; 1; 2; 1; 2]%Z (1 # 2) (1 # 2) 1 (313 # 1000)
  9 1 1 (1 # 4) 1 1 (1 # 4)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 2: Table 4, c_0 = 3, ε = 0.0018 prints 4 *)
(* Broken at level 4: 9/5000 for points of spread 1/10 *)
Theorem finding_14 :
  exceeds_net_distance scheme_2 scheme_2 0 0 4 1 (9 # 500).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 4 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z (1 # 8) (1 # 8) 1 (9 # 500)
  12 1 1 (1 # 16) 1 1 (1 # 16)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 3: Table 4, c_0 = 3, ε = 0.0001 prints 6 *)
(* Broken at level 6: 1/10000 for points of spread 1/10 *)
Theorem finding_15 :
  exceeds_net_distance scheme_2 scheme_2 0 0 6 1 (1 # 1000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 6 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z (1 # 32) (1 # 32) 1 (1 # 1000)
  16 1 1 (1 # 64) 1 1 (1 # 64)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 4: Table 4, c_0 = 3, ε = 6.44e-6 prints 8 *)
(* Broken at level 8: 161/25000000 for points of spread 1/10 *)
Theorem finding_16 :
  exceeds_net_distance scheme_2 scheme_2 0 0 8 1 (161 # 2500000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 8 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z (1 # 128) (1 # 128) 1 (161 # 2500000)
  19 1 1 (1 # 256) 1 1 (1 # 256)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 5: Table 4, c_0 = 3, ε = 3.80e-7 prints 10 *)
(* Broken at level 10: 19/50000000 for points of spread 1/10 *)
Theorem finding_17 :
  exceeds_net_distance scheme_2 scheme_2 0 0 10 1 (19 # 5000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 10 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z (1 # 512) (1 # 512) 1 (19 # 5000000)
  22 1 1 (1 # 1024) 1 1 (1 # 1024)). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 6: Table 4, c_0 = 3, ε = 2.24e-8 prints 12 *)
(* Broken at level 12: 7/312500000 for points of spread 1/10 *)
Theorem finding_18 :
  exceeds_net_distance scheme_2 scheme_2 0 0 12 1 (7 # 31250000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 12 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z (1 # 2048) (1 # 2048) 1 (7 # 31250000)
  26 1 1 (1 # 4096) 1 1 (1 # 4096)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 1: Table 4, c_0 = 4, ε = 0.0313 prints 1 *)
(* It rests on this constant. *)
Theorem finding_19 :
  contraction_constant scheme_1 4 (578603213 # 6400000000).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 1: Table 4, c_0 = 4, ε = 0.0313 prints 1 *)
(* It rests on this constant. *)
Theorem finding_20 :
  scheme_norm scheme_1 4 (67 # 50).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 1: Table 4, c_0 = 4, ε = 0.0313 prints 1 *)
(* Broken at level 1: 313/10000 for points of spread 1/10 *)
Theorem finding_21 :
  exceeds_net_distance scheme_2 scheme_2 0 0 1 1 (313 # 1000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 1 0 [0; 1; 0; 1; 2; 3; 2; 3]%Z 0 [0; 1; 0; 1; 2; 3; 2; 3]%Z (1 # 2) (1 # 2) 1 (313 # 1000)
  7 1 1 (1 # 2) 1 1 (1 # 2)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 2: Table 4, c_0 = 4, ε = 0.0018 prints 3 *)
(* Broken at level 3: 9/5000 for points of spread 1/10 *)
Theorem finding_22 :
  exceeds_net_distance scheme_2 scheme_2 0 0 3 1 (9 # 500).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 3 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z (1 # 4) (1 # 4) 1 (9 # 500)
  10 1 1 (1 # 8) 1 1 (1 # 8)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 2: Table 4, c_0 = 4, ε = 0.0018 prints 3 *)
(* Broken at natural parameters at level 3: 9/5000 for points of spread 1/10 *)
Theorem finding_23 :
  exceeds_net_distance scheme_2 scheme_2 (-4 # 1) (-4 # 1) 3 1 (9 # 500).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 (-4 # 1) (-4 # 1) 3 1 [0; 1; 2; 1; 2; 1; 2; 1; 0]%Z 1 [0; 1; 2; 1; 2; 1; 2; 1; 0]%Z (15 # 16) (15 # 16) 1 (9 # 500)
  18 1 1 (1 # 2048) 1 1 (1 # 2048)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 3: Table 4, c_0 = 4, ε = 0.0001 prints 4 *)
(* Broken at level 4: 1/10000 for points of spread 1/10 *)
Theorem finding_24 :
  exceeds_net_distance scheme_2 scheme_2 0 0 4 1 (1 # 1000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 4 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z (1 # 8) (1 # 8) 1 (1 # 1000)
  12 1 1 (1 # 16) 1 1 (1 # 16)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 3: Table 4, c_0 = 4, ε = 0.0001 prints 4 *)
(* Broken at natural parameters at level 4: 1/10000 for points of spread 1/10 *)
Theorem finding_25 :
  exceeds_net_distance scheme_2 scheme_2 (-4 # 1) (-4 # 1) 4 1 (1 # 1000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 (-4 # 1) (-4 # 1) 4 1 [0; 1; 2; 1; 2; 1; 2; 1; 0]%Z 1 [0; 1; 2; 1; 2; 1; 2; 1; 0]%Z (31 # 32) (31 # 32) 1 (1 # 1000)
  18 1 1 (1 # 2048) 1 1 (1 # 2048)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 4: Table 4, c_0 = 4, ε = 6.44e-6 prints 5 *)
(* Broken at level 5: 161/25000000 for points of spread 1/10 *)
Theorem finding_26 :
  exceeds_net_distance scheme_2 scheme_2 0 0 5 1 (161 # 2500000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 5 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z (1 # 16) (1 # 16) 1 (161 # 2500000)
  14 1 1 (1 # 32) 1 1 (1 # 32)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 4: Table 4, c_0 = 4, ε = 6.44e-6 prints 5 *)
(* Broken at natural parameters at level 5: 161/25000000 for points of spread 1/10 *)
Theorem finding_27 :
  exceeds_net_distance scheme_2 scheme_2 (-4 # 1) (-4 # 1) 5 1 (161 # 2500000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 (-4 # 1) (-4 # 1) 5 1 [0; 1; 2; 1; 2; 1; 2; 1; 0]%Z 1 [0; 1; 2; 1; 2; 1; 2; 1; 0]%Z (63 # 64) (63 # 64) 1 (161 # 2500000)
  20 1 1 (1 # 4096) 1 1 (1 # 4096)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 5: Table 4, c_0 = 4, ε = 3.80e-7 prints 7 *)
(* Broken at level 7: 19/50000000 for points of spread 1/10 *)
Theorem finding_28 :
  exceeds_net_distance scheme_2 scheme_2 0 0 7 1 (19 # 5000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 7 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z (1 # 64) (1 # 64) 1 (19 # 5000000)
  17 1 1 (1 # 128) 1 1 (1 # 128)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 5: Table 4, c_0 = 4, ε = 3.80e-7 prints 7 *)
(* Broken at natural parameters at level 7: 19/50000000 for points of spread 1/10 *)
Theorem finding_29 :
  exceeds_net_distance scheme_2 scheme_2 (-4 # 1) (-4 # 1) 7 1 (19 # 5000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 (-4 # 1) (-4 # 1) 7 1 [0; 1; 2; 1; 2; 1; 2; 1; 0]%Z 1 [0; 1; 2; 1; 2; 1; 2; 1; 0]%Z (255 # 256) (255 # 256) 1 (19 # 5000000)
  27 1 1 (1 # 65536) 1 1 (1 # 65536)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 6: Table 4, c_0 = 4, ε = 2.24e-8 prints 8 *)
(* Broken at level 8: 7/312500000 for points of spread 1/10 *)
Theorem finding_30 :
  exceeds_net_distance scheme_2 scheme_2 0 0 8 1 (7 # 31250000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 0 0 8 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z (1 # 128) (1 # 128) 1 (7 # 31250000)
  19 1 1 (1 # 256) 1 1 (1 # 256)). vm_cast_no_check (eq_refl true). Qed.

(* row 4, column 6: Table 4, c_0 = 4, ε = 2.24e-8 prints 8 *)
(* Broken at natural parameters at level 8: 7/312500000 for points of spread 1/10 *)
Theorem finding_31 :
  exceeds_net_distance scheme_2 scheme_2 (-4 # 1) (-4 # 1) 8 1 (7 # 31250000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 (-4 # 1) (-4 # 1) 8 1 [0; 1; 2; 1; 2; 1; 2; 1; 0]%Z 1 [0; 1; 2; 1; 2; 1; 2; 1; 0]%Z (511 # 512) (511 # 512) 1 (7 # 31250000)
  30 1 1 (1 # 262144) 1 1 (1 # 262144)). vm_cast_no_check (eq_refl true). Qed.
