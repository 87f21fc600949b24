(** mustafa2020-nary, table table-11 (written by `subcert prove --coq`) *)
(* Not stated: mu = 6/5 *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition scheme_1 :=
  Scheme 640 (-1) [[56; 446; 140; -2]; [15; 369; 257; -1]; [-1; 257; 369; 15]; [-2; 140; 446; 56]]%Z.

(* row 1, column 1: Table 11, c_0 = 1 prints 0.264140 *)
(* It rests on this constant. *)
Theorem finding_1 :
  contraction_constant scheme_1 1 (21 # 80).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 1: Table 11, c_0 = 1 prints 0.264140 *)
(* It rests on this constant. *)
Theorem finding_2 :
  scheme_norm scheme_1 1 (161 # 160).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 2: Table 11, c_0 = 2 prints 0.065694 *)
(* It rests on this constant. *)
Theorem finding_3 :
  contraction_constant scheme_1 2 (83 # 1280).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 2: Table 11, c_0 = 2 prints 0.065694 *)
(* It rests on this constant. *)
Theorem finding_4 :
  scheme_norm scheme_1 2 (103033 # 102400).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 3: Table 11, c_0 = 3 prints 0.016672 *)
(* It rests on this constant. *)
Theorem finding_5 :
  contraction_constant scheme_1 3 (1327 # 81920).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 3: Table 11, c_0 = 3 prints 0.016672 *)
(* It rests on this constant. *)
Theorem finding_6 :
  scheme_norm scheme_1 3 (1648521 # 1638400).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 4: Table 11, c_0 = 4 prints 0.004209 *)
(* It rests on this constant. *)
Theorem finding_7 :
  contraction_constant scheme_1 4 (21231 # 5242880).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 4: Table 11, c_0 = 4 prints 0.004209 *)
(* It rests on this constant. *)
Theorem finding_8 :
  scheme_norm scheme_1 4 (26376329 # 26214400).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.
