(** Mustafa, Shahzad, Khan, Baleanu, Chu 2020: table-3. Written by `subcert prove --coq`. *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition scheme_1 :=
  Scheme 400 (-2) [[0; 0; 400; 0; 0; 0]; [3; -34; 231; 231; -34; 3]]%Z.

(* Table 3, c_0 = 1: a constant that the cell rests on *)
Theorem finding_1 :
  contraction_constant scheme_1 1 (67 # 100).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* Table 3, c_0 = 1: a constant that the cell rests on *)
Theorem finding_2 :
  scheme_norm scheme_1 1 (67 # 50).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* Table 3, c_0 = 2: a constant that the cell rests on *)
Theorem finding_3 :
  contraction_constant scheme_1 2 (2841 # 8000).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* Table 3, c_0 = 2: a constant that the cell rests on *)
Theorem finding_4 :
  scheme_norm scheme_1 2 (67 # 50).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* Table 3, c_0 = 3: a constant that the cell rests on *)
Theorem finding_5 :
  contraction_constant scheme_1 3 (2882753 # 16000000).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* Table 3, c_0 = 3: a constant that the cell rests on *)
Theorem finding_6 :
  scheme_norm scheme_1 3 (67 # 50).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* Table 3, c_0 = 4: a constant that the cell rests on *)
Theorem finding_7 :
  contraction_constant scheme_1 4 (578603213 # 6400000000).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* Table 3, c_0 = 4: a constant that the cell rests on *)
Theorem finding_8 :
  scheme_norm scheme_1 4 (67 # 50).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

