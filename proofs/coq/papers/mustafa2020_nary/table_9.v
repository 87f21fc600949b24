(** mustafa2020-nary, table table-9 (written by `subcert prove --coq`) *)
(* Not stated: mu = 0 *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition scheme_1 :=
  Scheme 128 (-1) [[28; 58; 40; 2]; [15; 57; 49; 7]; [7; 49; 57; 15]; [2; 40; 58; 28]]%Z.

(* row 1, column 1: Table 9, c_0 = 1 prints nothing *)
(* It is this constant. *)
Theorem finding_1 :
  contraction_constant scheme_1 1 (1 # 4).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

Definition difference_1 :=
  Scheme 128 (-1) [[13; 14; 5; 0]; [8; 16; 8; 0]; [5; 14; 13; 0]; [2; 14; 14; 2]]%Z.

(* row 1, column 2: Table 9, c_0 = 2 prints nothing *)
(* It is this constant. *)
Theorem finding_2 :
  backwards_constant scheme_1 difference_1 2 (1 # 16).
Proof. apply backwards_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 3: Table 9, c_0 = 3 prints nothing *)
(* It is this constant. *)
Theorem finding_3 :
  backwards_constant scheme_1 difference_1 3 (1 # 64).
Proof. apply backwards_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 4: Table 9, c_0 = 4 prints nothing *)
(* It is this constant. *)
Theorem finding_4 :
  backwards_constant scheme_1 difference_1 4 (1 # 256).
Proof. apply backwards_constant_by. vm_cast_no_check (eq_refl true). Qed.
