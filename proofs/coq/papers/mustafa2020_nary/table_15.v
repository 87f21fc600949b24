(** mustafa2020-nary, table table-15 (written by `subcert prove --coq`) *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition scheme_1 :=
  Scheme 25 (-1) [[7; 21; -3]; [3; 24; -2]; [0; 25; 0]; [-2; 24; 3]; [-3; 21; 7]]%Z.

(* row 1, column 1: Table 15, c_0 = 1 prints 0.843200 *)
(* It rests on this constant. *)
Theorem finding_1 :
  contraction_constant scheme_1 1 (17 # 25).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 1: Table 15, c_0 = 1 prints 0.843200 *)
(* It rests on this constant. *)
Theorem finding_2 :
  scheme_norm scheme_1 1 (31 # 25).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 2: Table 15, c_0 = 2 prints 0.467894 *)
(* It rests on this constant. *)
Theorem finding_3 :
  contraction_constant scheme_1 2 (169 # 625).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 2: Table 15, c_0 = 2 prints 0.467894 *)
(* It rests on this constant. *)
Theorem finding_4 :
  scheme_norm scheme_1 2 (781 # 625).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 3: Table 15, c_0 = 3 prints 0.238464 *)
(* It rests on this constant. *)
Theorem finding_5 :
  contraction_constant scheme_1 3 (1433 # 15625).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 3: Table 15, c_0 = 3 prints 0.238464 *)
(* It rests on this constant. *)
Theorem finding_6 :
  scheme_norm scheme_1 3 (19573 # 15625).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 4: Table 15, c_0 = 4 prints 0.117563 *)
(* It rests on this constant. *)
Theorem finding_7 :
  contraction_constant scheme_1 4 (11281 # 390625).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 4: Table 15, c_0 = 4 prints 0.117563 *)
(* It rests on this constant. *)
Theorem finding_8 :
  scheme_norm scheme_1 4 (19573 # 15625).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.
