(** mustafa2020-nary, table table-7 (written by `subcert prove --coq`) *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition scheme_1 :=
  Scheme 1296 (-1) [[-55; 1155; 231; -35]; [-81; 729; 729; -81]; [-35; 231; 1155; -55]]%Z.

(* row 1, column 1: Table 7, c_0 = 1 prints nothing *)
(* It rests on this constant. *)
Theorem finding_1 :
  contraction_constant scheme_1 1 (143 # 324).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 1: Table 7, c_0 = 1 prints nothing *)
(* It rests on this constant. *)
Theorem finding_2 :
  scheme_norm scheme_1 1 (5 # 4).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 2: Table 7, c_0 = 2 prints nothing *)
(* It rests on this constant. *)
Theorem finding_3 :
  contraction_constant scheme_1 2 (323 # 2187).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 2: Table 7, c_0 = 2 prints nothing *)
(* It rests on this constant. *)
Theorem finding_4 :
  scheme_norm scheme_1 2 (350281 # 279936).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 3: Table 7, c_0 = 3 prints nothing *)
(* It rests on this constant. *)
Theorem finding_5 :
  contraction_constant scheme_1 3 (11663 # 236196).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 3: Table 7, c_0 = 3 prints nothing *)
(* It rests on this constant. *)
Theorem finding_6 :
  scheme_norm scheme_1 3 (155975 # 124416).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 4: Table 7, c_0 = 4 prints nothing *)
(* It rests on this constant. *)
Theorem finding_7 :
  contraction_constant scheme_1 4 (26243 # 1594323).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 4: Table 7, c_0 = 4 prints nothing *)
(* It rests on this constant. *)
Theorem finding_8 :
  scheme_norm scheme_1 4 (294715967783 # 235092492288).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.
