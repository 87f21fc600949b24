(** mustafa2020-nary, table table-3 (written by `subcert prove --coq`) *)
(* Not stated: w = 3/400 *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition scheme_1 :=
  Scheme 400 (-2) [[0; 0; 400; 0; 0; 0]; [3; -34; 231; 231; -34; 3]]%Z.

(* row 1, column 1: Table 3, c_0 = 1 prints 0.897800 *)
(* It rests on this constant. *)
Theorem finding_1 :
  contraction_constant scheme_1 1 (67 # 100).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 1: Table 3, c_0 = 1 prints 0.897800 *)
(* It rests on this constant. *)
Theorem finding_2 :
  scheme_norm scheme_1 1 (67 # 50).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 2: Table 3, c_0 = 2 prints 0.452181 *)
(* It rests on this constant. *)
Theorem finding_3 :
  contraction_constant scheme_1 2 (2841 # 8000).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 2: Table 3, c_0 = 2 prints 0.452181 *)
(* It rests on this constant. *)
Theorem finding_4 :
  scheme_norm scheme_1 2 (67 # 50).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 3: Table 3, c_0 = 3 prints 0.232054 *)
(* It rests on this constant. *)
Theorem finding_5 :
  contraction_constant scheme_1 3 (2882753 # 16000000).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 3: Table 3, c_0 = 3 prints 0.232054 *)
(* It rests on this constant. *)
Theorem finding_6 :
  scheme_norm scheme_1 3 (67 # 50).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 4: Table 3, c_0 = 4 prints 0.117641 *)
(* It rests on this constant. *)
Theorem finding_7 :
  contraction_constant scheme_1 4 (578603213 # 6400000000).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 4: Table 3, c_0 = 4 prints 0.117641 *)
(* It rests on this constant. *)
Theorem finding_8 :
  scheme_norm scheme_1 4 (67 # 50).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.
