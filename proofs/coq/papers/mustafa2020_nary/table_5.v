(** mustafa2020-nary, table table-5 (written by `subcert prove --coq`) *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition scheme_1 :=
  Scheme 1296 (-1) [[-55; 1155; 231; -35]; [-81; 729; 729; -81]; [-35; 231; 1155; -55]]%Z.

(* row 1, column 1: Table 5, c_0 = 1 prints nothing *)
(* It is this constant. *)
Theorem finding_1 :
  contraction_constant scheme_1 1 (143 # 324).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.

Definition difference_1 :=
  Scheme 1296 (-1) [[26; 452; -46; 0]; [-46; 452; 26; 0]; [-35; 251; 251; -35]]%Z.

(* row 1, column 2: Table 5, c_0 = 2 prints nothing *)
(* It is this constant. *)
Theorem finding_2 :
  backwards_constant scheme_1 difference_1 2 (18517 # 104976).
Proof. apply backwards_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 3: Table 5, c_0 = 3 prints nothing *)
(* It is this constant. *)
Theorem finding_3 :
  backwards_constant scheme_1 difference_1 3 (4590137 # 68024448).
Proof. apply backwards_constant_by. vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 4: Table 5, c_0 = 4 prints nothing *)
(* It is this constant. *)
Theorem finding_4 :
  backwards_constant scheme_1 difference_1 4 (1196159543 # 44079842304).
Proof. apply backwards_constant_by. vm_cast_no_check (eq_refl true). Qed.
