(** mustafa2020-nary, theorem theorem-6 (written by `subcert prove --coq`) *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition scheme_1 :=
  Scheme 128 0 [[28; 58; 40; 2]; [15; 57; 49; 7]; [7; 49; 57; 15]; [2; 40; 58; 28]]%Z.

(* Theorem 6, (21): The subdivision depth for a tolerance ε, curve *)
(* Refuted for quaternary-four-point:mu=0, c = 2 at level 0 and tolerance 130/87; the depth is levels(T, epsilon*(1 - T)/(sigma*beta)) *)
Theorem finding_1 :
  exceeds_distance scheme_1 0 0 1 (130 # 87).
Proof. apply (exceeds_distance_by scheme_1 0 0 0 [0; 1; 2; 3]%Z 0 1 (130 # 87)
  6 1 1 (1 # 1024)). vm_cast_no_check (eq_refl true). Qed.

Definition scheme_2 :=
  Scheme 25 0 [[7; 21; -3]; [3; 24; -2]; [0; 25; 0]; [-2; 24; 3]; [-3; 21; 7]]%Z.

(* Theorem 6, (21): The subdivision depth for a tolerance ε, curve *)
(* Refuted at natural parameters for quinary-three-point, c = 4 at level 1 and tolerance 1/13; the depth is levels(T, epsilon*(1 - T)/(sigma*beta)) *)
Theorem finding_2 :
  exceeds_distance scheme_2 (-3 # 4) 1 1 (1 # 13).
Proof. apply (exceeds_distance_by scheme_2 (-3 # 4) 1 0 [0; -1; 0; -1]%Z (98 # 125) 1 (1 # 13)
  20 1 1 (1 # 2048)). vm_cast_no_check (eq_refl true). Qed.
