(** Mustafa, Shahzad, Khan, Baleanu, Chu 2020: table-2. Written by `subcert prove --coq`. *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition scheme_1 :=
  Scheme 2000 (-2) [[0; 0; 2000; 0; 0; 0]; [39; -242; 1203; 1203; -242; 39]]%Z.

(* Table 2, c_0 = 1, ε = 0.0266: a constant that the cell rests on *)
Theorem finding_1 :
  contraction_constant scheme_1 1 (371 # 500).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

Definition scheme_2 :=
  Scheme 2000 0 [[0; 0; 2000; 0; 0; 0]; [39; -242; 1203; 1203; -242; 39]]%Z.

(* Table 2, c_0 = 1, ε = 0.0266 prints 11 *)
(* What holds: *)
Theorem finding_2 :
  sufficient_depth scheme_2 (1 # 10) (133 # 5000) 5.
Proof. apply (sufficient_depth_by scheme_2 6 6). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 1, ε = 0.0031 prints 18 *)
(* What holds: *)
Theorem finding_3 :
  sufficient_depth scheme_2 (1 # 10) (31 # 10000) 9.
Proof. apply (sufficient_depth_by scheme_2 5 5). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 1, ε = 0.0003 prints 26 *)
(* What holds: *)
Theorem finding_4 :
  sufficient_depth scheme_2 (1 # 10) (3 # 10000) 13.
Proof. apply (sufficient_depth_by scheme_2 5 5). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 1, ε = 4.35e-5 prints 33 *)
(* What holds: *)
Theorem finding_5 :
  sufficient_depth scheme_2 (1 # 10) (87 # 2000000) 16.
Proof. apply (sufficient_depth_by scheme_2 6 6). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 1, ε = 5.12e-6 prints 40 *)
(* What holds: *)
Theorem finding_6 :
  sufficient_depth scheme_2 (1 # 10) (2 # 390625) 20.
Proof. apply (sufficient_depth_by scheme_2 5 5). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 1, ε = 6.02 - 7 prints 47 *)
(* What holds: *)
Theorem finding_7 :
  sufficient_depth scheme_2 (1 # 10) (301 # 500000000) 23.
Proof. apply (sufficient_depth_by scheme_2 6 6). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 1, ε = 7.09e-8 prints 54 *)
(* What holds: *)
Theorem finding_8 :
  sufficient_depth scheme_2 (1 # 10) (709 # 10000000000) 27.
Proof. apply (sufficient_depth_by scheme_2 6 6). vm_cast_no_check (eq_refl true). Qed.

Definition difference_1 :=
  Scheme 2000 (-2) [[-39; 203; 1000; -203; 39; 0]; [39; -203; 1000; 203; -39; 0]]%Z.

(* Table 2, c_0 = 2, ε = 0.0266: a constant that the cell rests on *)
Theorem finding_9 :
  backwards_constant scheme_1 difference_1 2 (176871 # 400000).
Proof. apply backwards_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 2, ε = 0.0266 prints 3 *)
(* What holds: *)
Theorem finding_10 :
  sufficient_depth scheme_2 (1 # 10) (133 # 5000) 5.
Proof. apply (sufficient_depth_by scheme_2 6 6). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 2, ε = 0.0266 prints 3 *)
(* It does not keep its promise: 133/5000 at level 3, for points of spread 1/10 *)
Theorem finding_11 :
  exceeds_distance scheme_2 3 1 (133 # 500).
Proof. apply (exceeds_distance_by scheme_2 3 1 [0; 1; 0; 1; 2; 1]%Z 0 1 (133 # 500)
  15 1 1 (1 # 8)). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 2, ε = 0.0031 prints 6 *)
(* What holds: *)
Theorem finding_12 :
  sufficient_depth scheme_2 (1 # 10) (31 # 10000) 9.
Proof. apply (sufficient_depth_by scheme_2 5 5). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 2, ε = 0.0031 prints 6 *)
(* It does not keep its promise: 31/10000 at level 6, for points of spread 1/10 *)
Theorem finding_13 :
  exceeds_distance scheme_2 6 1 (31 # 1000).
Proof. apply (exceeds_distance_by scheme_2 6 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 1 (31 # 1000)
  22 1 1 (1 # 64)). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 2, ε = 0.0003 prints 8 *)
(* What holds: *)
Theorem finding_14 :
  sufficient_depth scheme_2 (1 # 10) (3 # 10000) 13.
Proof. apply (sufficient_depth_by scheme_2 5 5). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 2, ε = 0.0003 prints 8 *)
(* It does not keep its promise: 3/10000 at level 8, for points of spread 1/10 *)
Theorem finding_15 :
  exceeds_distance scheme_2 8 1 (3 # 1000).
Proof. apply (exceeds_distance_by scheme_2 8 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 1 (3 # 1000)
  26 1 1 (1 # 256)). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 2, ε = 4.35e-5 prints 11 *)
(* What holds: *)
Theorem finding_16 :
  sufficient_depth scheme_2 (1 # 10) (87 # 2000000) 16.
Proof. apply (sufficient_depth_by scheme_2 6 6). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 2, ε = 4.35e-5 prints 11 *)
(* It does not keep its promise: 87/2000000 at level 11, for points of spread 1/10 *)
Theorem finding_17 :
  exceeds_distance scheme_2 11 1 (87 # 200000).
Proof. apply (exceeds_distance_by scheme_2 11 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 1 (87 # 200000)
  33 1 1 (1 # 2048)). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 2, ε = 5.12e-6 prints 14 *)
(* What holds: *)
Theorem finding_18 :
  sufficient_depth scheme_2 (1 # 10) (2 # 390625) 20.
Proof. apply (sufficient_depth_by scheme_2 5 5). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 2, ε = 5.12e-6 prints 14 *)
(* It does not keep its promise: 2/390625 at level 14, for points of spread 1/10 *)
Theorem finding_19 :
  exceeds_distance scheme_2 14 1 (4 # 78125).
Proof. apply (exceeds_distance_by scheme_2 14 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 1 (4 # 78125)
  40 1 1 (1 # 16384)). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 2, ε = 6.02 - 7 prints 16 *)
(* What holds: *)
Theorem finding_20 :
  sufficient_depth scheme_2 (1 # 10) (301 # 500000000) 23.
Proof. apply (sufficient_depth_by scheme_2 6 6). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 2, ε = 6.02 - 7 prints 16 *)
(* It does not keep its promise: 301/500000000 at level 16, for points of spread 1/10 *)
Theorem finding_21 :
  exceeds_distance scheme_2 16 1 (301 # 50000000).
Proof. apply (exceeds_distance_by scheme_2 16 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 1 (301 # 50000000)
  43 1 1 (1 # 32768)). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 2, ε = 7.09e-8 prints 19 *)
(* What holds: *)
Theorem finding_22 :
  sufficient_depth scheme_2 (1 # 10) (709 # 10000000000) 27.
Proof. apply (sufficient_depth_by scheme_2 6 6). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 2, ε = 7.09e-8 prints 19 *)
(* It does not keep its promise: 709/10000000000 at level 19, for points of spread 1/10 *)
Theorem finding_23 :
  exceeds_distance scheme_2 19 1 (709 # 1000000000).
Proof. apply (exceeds_distance_by scheme_2 19 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 1 (709 # 1000000000)
  49 1 1 (1 # 262144)). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 3, ε = 0.0266: a constant that the cell rests on *)
Theorem finding_24 :
  backwards_constant scheme_1 difference_1 3 (228713351 # 800000000).
Proof. apply backwards_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 3, ε = 0.0266 prints 2 *)
(* What holds: *)
Theorem finding_25 :
  sufficient_depth scheme_2 (1 # 10) (133 # 5000) 5.
Proof. apply (sufficient_depth_by scheme_2 6 6). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 3, ε = 0.0266 prints 2 *)
(* It does not keep its promise: 133/5000 at level 2, for points of spread 1/10 *)
Theorem finding_26 :
  exceeds_distance scheme_2 2 1 (133 # 500).
Proof. apply (exceeds_distance_by scheme_2 2 3 [0; 1]%Z 0 1 (133 # 500)
  15 1 1 (1 # 8)). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 3, ε = 0.0031 prints 4 *)
(* What holds: *)
Theorem finding_27 :
  sufficient_depth scheme_2 (1 # 10) (31 # 10000) 9.
Proof. apply (sufficient_depth_by scheme_2 5 5). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 3, ε = 0.0031 prints 4 *)
(* It does not keep its promise: 31/10000 at level 4, for points of spread 1/10 *)
Theorem finding_28 :
  exceeds_distance scheme_2 4 1 (31 # 1000).
Proof. apply (exceeds_distance_by scheme_2 4 0 [0; 1; 2; 1; 2; 3; 2; 3]%Z 0 1 (31 # 1000)
  17 1 1 (1 # 16)). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 3, ε = 0.0003 prints 5 *)
(* What holds: *)
Theorem finding_29 :
  sufficient_depth scheme_2 (1 # 10) (3 # 10000) 13.
Proof. apply (sufficient_depth_by scheme_2 5 5). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 3, ε = 0.0003 prints 5 *)
(* It does not keep its promise: 3/10000 at level 5, for points of spread 1/10 *)
Theorem finding_30 :
  exceeds_distance scheme_2 5 1 (3 # 1000).
Proof. apply (exceeds_distance_by scheme_2 5 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 1 (3 # 1000)
  17 1 1 (1 # 16)). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 3, ε = 4.35e-5 prints 7 *)
(* What holds: *)
Theorem finding_31 :
  sufficient_depth scheme_2 (1 # 10) (87 # 2000000) 16.
Proof. apply (sufficient_depth_by scheme_2 6 6). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 3, ε = 4.35e-5 prints 7 *)
(* It does not keep its promise: 87/2000000 at level 7, for points of spread 1/10 *)
Theorem finding_32 :
  exceeds_distance scheme_2 7 1 (87 # 200000).
Proof. apply (exceeds_distance_by scheme_2 7 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 1 (87 # 200000)
  22 1 1 (1 # 64)). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 3, ε = 5.12e-6 prints 9 *)
(* What holds: *)
Theorem finding_33 :
  sufficient_depth scheme_2 (1 # 10) (2 # 390625) 20.
Proof. apply (sufficient_depth_by scheme_2 5 5). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 3, ε = 5.12e-6 prints 9 *)
(* It does not keep its promise: 2/390625 at level 9, for points of spread 1/10 *)
Theorem finding_34 :
  exceeds_distance scheme_2 9 1 (4 # 78125).
Proof. apply (exceeds_distance_by scheme_2 9 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 1 (4 # 78125)
  26 1 1 (1 # 256)). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 3, ε = 6.02 - 7 prints 10 *)
(* What holds: *)
Theorem finding_35 :
  sufficient_depth scheme_2 (1 # 10) (301 # 500000000) 23.
Proof. apply (sufficient_depth_by scheme_2 6 6). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 3, ε = 6.02 - 7 prints 10 *)
(* It does not keep its promise: 301/500000000 at level 10, for points of spread 1/10 *)
Theorem finding_36 :
  exceeds_distance scheme_2 10 1 (301 # 50000000).
Proof. apply (exceeds_distance_by scheme_2 10 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 1 (301 # 50000000)
  29 1 1 (1 # 512)). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 3, ε = 7.09e-8 prints 12 *)
(* What holds: *)
Theorem finding_37 :
  sufficient_depth scheme_2 (1 # 10) (709 # 10000000000) 27.
Proof. apply (sufficient_depth_by scheme_2 6 6). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 3, ε = 7.09e-8 prints 12 *)
(* It does not keep its promise: 709/10000000000 at level 12, for points of spread 1/10 *)
Theorem finding_38 :
  exceeds_distance scheme_2 12 1 (709 # 1000000000).
Proof. apply (exceeds_distance_by scheme_2 12 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 1 (709 # 1000000000)
  33 1 1 (1 # 2048)). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 4, ε = 0.0266: a constant that the cell rests on *)
Theorem finding_39 :
  backwards_constant scheme_1 difference_1 4 (293144306831 # 1600000000000).
Proof. apply backwards_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 4, ε = 0.0266 prints 1 *)
(* What holds: *)
Theorem finding_40 :
  sufficient_depth scheme_2 (1 # 10) (133 # 5000) 5.
Proof. apply (sufficient_depth_by scheme_2 6 6). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 4, ε = 0.0266 prints 1 *)
(* It does not keep its promise: 133/5000 at level 1, for points of spread 1/10 *)
Theorem finding_41 :
  exceeds_distance scheme_2 1 1 (133 # 500).
Proof. apply (exceeds_distance_by scheme_2 1 2 [0; 1; 2]%Z 0 1 (133 # 500)
  10 1 1 (1 # 2)). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 4, ε = 0.0031 prints 3 *)
(* What holds: *)
Theorem finding_42 :
  sufficient_depth scheme_2 (1 # 10) (31 # 10000) 9.
Proof. apply (sufficient_depth_by scheme_2 5 5). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 4, ε = 0.0031 prints 3 *)
(* It does not keep its promise: 31/10000 at level 3, for points of spread 1/10 *)
Theorem finding_43 :
  exceeds_distance scheme_2 3 1 (31 # 1000).
Proof. apply (exceeds_distance_by scheme_2 3 1 [0; 1; 0; 1; 2; 1]%Z 0 1 (31 # 1000)
  15 1 1 (1 # 8)). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 4, ε = 0.0003 prints 4 *)
(* What holds: *)
Theorem finding_44 :
  sufficient_depth scheme_2 (1 # 10) (3 # 10000) 13.
Proof. apply (sufficient_depth_by scheme_2 5 5). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 4, ε = 0.0003 prints 4 *)
(* It does not keep its promise: 3/10000 at level 4, for points of spread 1/10 *)
Theorem finding_45 :
  exceeds_distance scheme_2 4 1 (3 # 1000).
Proof. apply (exceeds_distance_by scheme_2 4 0 [0; 1; 2; 1; 2; 3; 2; 3]%Z 0 1 (3 # 1000)
  15 1 1 (1 # 8)). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 4, ε = 4.35e-5 prints 5 *)
(* What holds: *)
Theorem finding_46 :
  sufficient_depth scheme_2 (1 # 10) (87 # 2000000) 16.
Proof. apply (sufficient_depth_by scheme_2 6 6). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 4, ε = 4.35e-5 prints 5 *)
(* It does not keep its promise: 87/2000000 at level 5, for points of spread 1/10 *)
Theorem finding_47 :
  exceeds_distance scheme_2 5 1 (87 # 200000).
Proof. apply (exceeds_distance_by scheme_2 5 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 1 (87 # 200000)
  17 1 1 (1 # 16)). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 4, ε = 5.12e-6 prints 6 *)
(* What holds: *)
Theorem finding_48 :
  sufficient_depth scheme_2 (1 # 10) (2 # 390625) 20.
Proof. apply (sufficient_depth_by scheme_2 5 5). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 4, ε = 5.12e-6 prints 6 *)
(* It does not keep its promise: 2/390625 at level 6, for points of spread 1/10 *)
Theorem finding_49 :
  exceeds_distance scheme_2 6 1 (4 # 78125).
Proof. apply (exceeds_distance_by scheme_2 6 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 1 (4 # 78125)
  19 1 1 (1 # 32)). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 4, ε = 6.02 - 7 prints 8 *)
(* What holds: *)
Theorem finding_50 :
  sufficient_depth scheme_2 (1 # 10) (301 # 500000000) 23.
Proof. apply (sufficient_depth_by scheme_2 6 6). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 4, ε = 6.02 - 7 prints 8 *)
(* It does not keep its promise: 301/500000000 at level 8, for points of spread 1/10 *)
Theorem finding_51 :
  exceeds_distance scheme_2 8 1 (301 # 50000000).
Proof. apply (exceeds_distance_by scheme_2 8 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 1 (301 # 50000000)
  24 1 1 (1 # 128)). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 4, ε = 7.09e-8 prints 9 *)
(* What holds: *)
Theorem finding_52 :
  sufficient_depth scheme_2 (1 # 10) (709 # 10000000000) 27.
Proof. apply (sufficient_depth_by scheme_2 6 6). vm_cast_no_check (eq_refl true). Qed.

(* Table 2, c_0 = 4, ε = 7.09e-8 prints 9 *)
(* It does not keep its promise: 709/10000000000 at level 9, for points of spread 1/10 *)
Theorem finding_53 :
  exceeds_distance scheme_2 9 1 (709 # 1000000000).
Proof. apply (exceeds_distance_by scheme_2 9 0 [0; 1; 2; 1; 2; 3; 2; 3; 4]%Z 0 1 (709 # 1000000000)
  26 1 1 (1 # 256)). vm_cast_no_check (eq_refl true). Qed.

