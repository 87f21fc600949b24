(** Mustafa, Shahzad, Khan, Baleanu, Chu 2020: table-11. Written by `subcert prove --coq`. *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition scheme_1 :=
  Scheme 640 (-1) [[56; 446; 140; -2]; [15; 369; 257; -1]; [-1; 257; 369; 15]; [-2; 140; 446; 56]]%Z.

(* Table 11, c_0 = 1: a constant that the cell rests on *)
Theorem finding_1 :
  contraction_constant scheme_1 1 (21 # 80).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* Table 11, c_0 = 1: a constant that the cell rests on *)
Theorem finding_2 :
  scheme_norm scheme_1 1 (161 # 160).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* Table 11, c_0 = 2: a constant that the cell rests on *)
Theorem finding_3 :
  contraction_constant scheme_1 2 (83 # 1280).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* Table 11, c_0 = 2: a constant that the cell rests on *)
Theorem finding_4 :
  scheme_norm scheme_1 2 (103033 # 102400).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* Table 11, c_0 = 3: a constant that the cell rests on *)
Theorem finding_5 :
  contraction_constant scheme_1 3 (1327 # 81920).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* Table 11, c_0 = 3: a constant that the cell rests on *)
Theorem finding_6 :
  scheme_norm scheme_1 3 (1648521 # 1638400).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

(* Table 11, c_0 = 4: a constant that the cell rests on *)
Theorem finding_7 :
  contraction_constant scheme_1 4 (21231 # 5242880).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* Table 11, c_0 = 4: a constant that the cell rests on *)
Theorem finding_8 :
  scheme_norm scheme_1 4 (26376329 # 26214400).
Proof. apply scheme_norm_by. vm_cast_no_check (eq_refl true). Qed.

