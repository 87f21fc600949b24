(** mustafa2020-nary, table table-1 (written by `subcert prove --coq`) *)
(* Not stated: w = 39/2000 *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition scheme_1 :=
  Scheme 2000 (-2) [[0; 0; 2000; 0; 0; 0]; [39; -242; 1203; 1203; -242; 39]]%Z.

(* row 1, column 1: Table 1, c_0 = 1 prints 0.742000 *)
(* It is this constant. *)
Theorem finding_1 :
  contraction_constant scheme_1 1 (371 # 500).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

Definition difference_1 :=
  Scheme 2000 (-2) [[-39; 203; 1000; -203; 39; 0]; [39; -203; 1000; 203; -39; 0]]%Z.

(* row 1, column 2: Table 1, c_0 = 2 prints 0.442177 *)
(* It is this constant. *)
Theorem finding_2 :
  backwards_constant scheme_1 difference_1 2 (176871 # 400000).
Proof. apply backwards_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 3: Table 1, c_0 = 3 prints 0.285892 *)
(* It is this constant. *)
Theorem finding_3 :
  backwards_constant scheme_1 difference_1 3 (228713351 # 800000000).
Proof. apply backwards_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 4: Table 1, c_0 = 4 prints 0.183215 *)
(* It is this constant. *)
Theorem finding_4 :
  backwards_constant scheme_1 difference_1 4 (293144306831 # 1600000000000).
Proof. apply backwards_constant_by. vm_cast_no_check (eq_refl true). Qed.
