(** mustafa2020-nary, table table-13 (written by `subcert prove --coq`) *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition scheme_1 :=
  Scheme 25 (-1) [[7; 21; -3]; [3; 24; -2]; [0; 25; 0]; [-2; 24; 3]; [-3; 21; 7]]%Z.

(* row 1, column 1: Table 13, c_0 = 1 prints 0.680000 *)
(* It is this constant. *)
Theorem finding_1 :
  contraction_constant scheme_1 1 (17 # 25).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

Definition difference_1 :=
  Scheme 25 (-1) [[4; 1; 0]; [3; 2; 0]; [2; 3; 0]; [1; 4; 0]; [-3; 11; -3]]%Z.

(* row 1, column 2: Table 13, c_0 = 2 prints 0.308800 *)
(* It is this constant. *)
Theorem finding_2 :
  backwards_constant scheme_1 difference_1 2 (193 # 625).
Proof. apply backwards_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 3: Table 13, c_0 = 3 prints 0.128576 *)
(* It is this constant. *)
Theorem finding_3 :
  backwards_constant scheme_1 difference_1 3 (2009 # 15625).
Proof. apply backwards_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 4: Table 13, c_0 = 4 prints 0.051796 *)
(* It is this constant. *)
Theorem finding_4 :
  backwards_constant scheme_1 difference_1 4 (20233 # 390625).
Proof. apply backwards_constant_by. vm_cast_no_check (eq_refl true). Qed.
