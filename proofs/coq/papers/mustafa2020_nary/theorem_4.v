(** mustafa2020-nary, theorem theorem-4 (written by `subcert prove --coq`) *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition scheme_1 :=
  Scheme 25 0 [[7; 21; -3]; [3; 24; -2]; [0; 25; 0]; [-2; 24; 3]; [-3; 21; 7]]%Z.

(* Theorem 4, (19): The step between two successive polygons, for every number c of convolutions *)
(* Refuted for quinary-three-point, c = 1 at level 0; the bound is sigma*beta*T^k *)
Theorem finding_1 :
  exceeds_step scheme_1 0 0 1 (3 # 5).
Proof. apply (exceeds_step_by scheme_1 0 0 0 [0; 1; 0]%Z 0). vm_cast_no_check (eq_refl true). Qed.

Definition scheme_2 :=
  Scheme 128 0 [[28; 58; 40; 2]; [15; 57; 49; 7]; [7; 49; 57; 15]; [2; 40; 58; 28]]%Z.

(* Theorem 4, (19): The step between two successive polygons, for every number c of convolutions *)
(* Refuted at natural parameters for quaternary-four-point:mu=0, c = 3 at level 1; the bound is sigma*beta*T^k *)
Theorem finding_2 :
  exceeds_step scheme_2 (-3 # 2) 1 1 (9 # 512).
Proof. apply (exceeds_step_by scheme_2 (-3 # 2) 1 0 [0; -1; 0; 1]%Z (-3 # 32)). vm_cast_no_check (eq_refl true). Qed.
