(** Mustafa, Shahzad, Khan, Baleanu, Chu 2020: table-4. Written by `subcert prove --coq`. *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition scheme_1 :=
  Scheme 400 (-2) [[0; 0; 400; 0; 0; 0]; [3; -34; 231; 231; -34; 3]]%Z.

(* Table 4, c_0 = 1, ε = 0.0313: a constant that the cell rests on *)
Theorem finding_1 :
  contraction_constant scheme_1 1 (67 # 100).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* Table 4, c_0 = 1, ε = 0.0313: a constant that the cell rests on *)
Theorem finding_2 :
  scheme_norm scheme_1 1 (67 # 50).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* Table 4, c_0 = 2, ε = 0.0313: a constant that the cell rests on *)
Theorem finding_3 :
  contraction_constant scheme_1 2 (2841 # 8000).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* Table 4, c_0 = 2, ε = 0.0313: a constant that the cell rests on *)
Theorem finding_4 :
  scheme_norm scheme_1 2 (67 # 50).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

Definition scheme_2 :=
  Scheme 400 0 [[0; 0; 400; 0; 0; 0]; [3; -34; 231; 231; -34; 3]]%Z.

(* Table 4, c_0 = 2, ε = 0.0313 prints 4 *)
(* It does not keep its promise: 313/10000 at level 4, for points of spread 1/10 *)
Theorem finding_5 :
  exceeds_net_distance scheme_2 scheme_2 4 1 (313 # 1000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 4 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z (1 # 8) (1 # 8) 1 (313 # 1000)
  12 1 1 (1 # 16) 1 1 (1 # 16)). vm_cast_no_check (eq_refl true). Qed.

(* Table 4, c_0 = 2, ε = 0.0018 prints 8 *)
(* It does not keep its promise: 9/5000 at level 8, for points of spread 1/10 *)
Theorem finding_6 :
  exceeds_net_distance scheme_2 scheme_2 8 1 (9 # 500).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 8 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z (1 # 128) (1 # 128) 1 (9 # 500)
  19 1 1 (1 # 256) 1 1 (1 # 256)). vm_cast_no_check (eq_refl true). Qed.

(* Table 4, c_0 = 2, ε = 0.0001 prints 11 *)
(* It does not keep its promise: 1/10000 at level 11, for points of spread 1/10 *)
Theorem finding_7 :
  exceeds_net_distance scheme_2 scheme_2 11 1 (1 # 1000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 11 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z (1 # 1024) (1 # 1024) 1 (1 # 1000)
  24 1 1 (1 # 2048) 1 1 (1 # 2048)). vm_cast_no_check (eq_refl true). Qed.

(* Table 4, c_0 = 2, ε = 6.44e-6 prints 15 *)
(* It does not keep its promise: 161/25000000 at level 15, for points of spread 1/10 *)
Theorem finding_8 :
  exceeds_net_distance scheme_2 scheme_2 15 1 (161 # 2500000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 15 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z (1 # 16384) (1 # 16384) 1 (161 # 2500000)
  31 1 1 (1 # 32768) 1 1 (1 # 32768)). vm_cast_no_check (eq_refl true). Qed.

(* Table 4, c_0 = 2, ε = 3.80e-7 prints 18 *)
(* It does not keep its promise: 19/50000000 at level 18, for points of spread 1/10 *)
Theorem finding_9 :
  exceeds_net_distance scheme_2 scheme_2 18 1 (19 # 5000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 18 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z (1 # 131072) (1 # 131072) 1 (19 # 5000000)
  36 1 1 (1 # 262144) 1 1 (1 # 262144)). vm_cast_no_check (eq_refl true). Qed.

(* Table 4, c_0 = 2, ε = 2.24e-8 prints 22 *)
(* It does not keep its promise: 7/312500000 at level 22, for points of spread 1/10 *)
Theorem finding_10 :
  exceeds_net_distance scheme_2 scheme_2 22 1 (7 # 31250000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 22 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z (1 # 2097152) (1 # 2097152) 1 (7 # 31250000)
  43 1 1 (1 # 4194304) 1 1 (1 # 4194304)). vm_cast_no_check (eq_refl true). Qed.

(* Table 4, c_0 = 3, ε = 0.0313: a constant that the cell rests on *)
Theorem finding_11 :
  contraction_constant scheme_1 3 (2882753 # 16000000).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* Table 4, c_0 = 3, ε = 0.0313: a constant that the cell rests on *)
Theorem finding_12 :
  scheme_norm scheme_1 3 (67 # 50).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* Table 4, c_0 = 3, ε = 0.0313 prints 2 *)
(* It does not keep its promise: 313/10000 at level 2, for points of spread 1/10 *)
Theorem finding_13 :
  exceeds_net_distance scheme_2 scheme_2 2 1 (313 # 1000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 2 1 [0; 1; 0; 1; 2; 1; 2]%Z 1 [0; 1; 0; 1; 2; 1; 2]%Z (1 # 2) (1 # 2) 1 (313 # 1000)
  9 1 1 (1 # 4) 1 1 (1 # 4)). vm_cast_no_check (eq_refl true). Qed.

(* Table 4, c_0 = 3, ε = 0.0018 prints 4 *)
(* It does not keep its promise: 9/5000 at level 4, for points of spread 1/10 *)
Theorem finding_14 :
  exceeds_net_distance scheme_2 scheme_2 4 1 (9 # 500).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 4 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z (1 # 8) (1 # 8) 1 (9 # 500)
  12 1 1 (1 # 16) 1 1 (1 # 16)). vm_cast_no_check (eq_refl true). Qed.

(* Table 4, c_0 = 3, ε = 0.0001 prints 6 *)
(* It does not keep its promise: 1/10000 at level 6, for points of spread 1/10 *)
Theorem finding_15 :
  exceeds_net_distance scheme_2 scheme_2 6 1 (1 # 1000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 6 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z (1 # 32) (1 # 32) 1 (1 # 1000)
  16 1 1 (1 # 64) 1 1 (1 # 64)). vm_cast_no_check (eq_refl true). Qed.

(* Table 4, c_0 = 3, ε = 6.44e-6 prints 8 *)
(* It does not keep its promise: 161/25000000 at level 8, for points of spread 1/10 *)
Theorem finding_16 :
  exceeds_net_distance scheme_2 scheme_2 8 1 (161 # 2500000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 8 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z (1 # 128) (1 # 128) 1 (161 # 2500000)
  19 1 1 (1 # 256) 1 1 (1 # 256)). vm_cast_no_check (eq_refl true). Qed.

(* Table 4, c_0 = 3, ε = 3.80e-7 prints 10 *)
(* It does not keep its promise: 19/50000000 at level 10, for points of spread 1/10 *)
Theorem finding_17 :
  exceeds_net_distance scheme_2 scheme_2 10 1 (19 # 5000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 10 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z (1 # 512) (1 # 512) 1 (19 # 5000000)
  22 1 1 (1 # 1024) 1 1 (1 # 1024)). vm_cast_no_check (eq_refl true). Qed.

(* Table 4, c_0 = 3, ε = 2.24e-8 prints 12 *)
(* It does not keep its promise: 7/312500000 at level 12, for points of spread 1/10 *)
Theorem finding_18 :
  exceeds_net_distance scheme_2 scheme_2 12 1 (7 # 31250000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 12 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z (1 # 2048) (1 # 2048) 1 (7 # 31250000)
  26 1 1 (1 # 4096) 1 1 (1 # 4096)). vm_cast_no_check (eq_refl true). Qed.

(* Table 4, c_0 = 4, ε = 0.0313: a constant that the cell rests on *)
Theorem finding_19 :
  contraction_constant scheme_1 4 (578603213 # 6400000000).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* Table 4, c_0 = 4, ε = 0.0313: a constant that the cell rests on *)
Theorem finding_20 :
  scheme_norm scheme_1 4 (67 # 50).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* Table 4, c_0 = 4, ε = 0.0313 prints 1 *)
(* It does not keep its promise: 313/10000 at level 1, for points of spread 1/10 *)
Theorem finding_21 :
  exceeds_net_distance scheme_2 scheme_2 1 1 (313 # 1000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 1 0 [0; 1; 0; 1; 2; 3; 2; 3]%Z 0 [0; 1; 0; 1; 2; 3; 2; 3]%Z (1 # 2) (1 # 2) 1 (313 # 1000)
  7 1 1 (1 # 2) 1 1 (1 # 2)). vm_cast_no_check (eq_refl true). Qed.

(* Table 4, c_0 = 4, ε = 0.0018 prints 3 *)
(* It does not keep its promise: 9/5000 at level 3, for points of spread 1/10 *)
Theorem finding_22 :
  exceeds_net_distance scheme_2 scheme_2 3 1 (9 # 500).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 3 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z (1 # 4) (1 # 4) 1 (9 # 500)
  10 1 1 (1 # 8) 1 1 (1 # 8)). vm_cast_no_check (eq_refl true). Qed.

(* Table 4, c_0 = 4, ε = 0.0001 prints 4 *)
(* It does not keep its promise: 1/10000 at level 4, for points of spread 1/10 *)
Theorem finding_23 :
  exceeds_net_distance scheme_2 scheme_2 4 1 (1 # 1000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 4 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z (1 # 8) (1 # 8) 1 (1 # 1000)
  12 1 1 (1 # 16) 1 1 (1 # 16)). vm_cast_no_check (eq_refl true). Qed.

(* Table 4, c_0 = 4, ε = 6.44e-6 prints 5 *)
(* It does not keep its promise: 161/25000000 at level 5, for points of spread 1/10 *)
Theorem finding_24 :
  exceeds_net_distance scheme_2 scheme_2 5 1 (161 # 2500000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 5 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z (1 # 16) (1 # 16) 1 (161 # 2500000)
  14 1 1 (1 # 32) 1 1 (1 # 32)). vm_cast_no_check (eq_refl true). Qed.

(* Table 4, c_0 = 4, ε = 3.80e-7 prints 7 *)
(* It does not keep its promise: 19/50000000 at level 7, for points of spread 1/10 *)
Theorem finding_25 :
  exceeds_net_distance scheme_2 scheme_2 7 1 (19 # 5000000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 7 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z (1 # 64) (1 # 64) 1 (19 # 5000000)
  17 1 1 (1 # 128) 1 1 (1 # 128)). vm_cast_no_check (eq_refl true). Qed.

(* Table 4, c_0 = 4, ε = 2.24e-8 prints 8 *)
(* It does not keep its promise: 7/312500000 at level 8, for points of spread 1/10 *)
Theorem finding_26 :
  exceeds_net_distance scheme_2 scheme_2 8 1 (7 # 31250000).
Proof. apply (exceeds_net_distance_by scheme_2 scheme_2 8 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z (1 # 128) (1 # 128) 1 (7 # 31250000)
  19 1 1 (1 # 256) 1 1 (1 # 256)). vm_cast_no_check (eq_refl true). Qed.

