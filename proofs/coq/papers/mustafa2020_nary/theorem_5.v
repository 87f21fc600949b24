(** mustafa2020-nary, theorem theorem-5 (written by `subcert prove --coq`) *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition scheme_1 :=
  Scheme 25 0 [[7; 21; -3]; [3; 24; -2]; [0; 25; 0]; [-2; 24; 3]; [-3; 21; 7]]%Z.

(* Theorem 5, (20): The distance of the polygon after k steps to the limit, for every c with T < 1 *)
(* Refuted for quinary-three-point, c = 2 at level 0; the bound is sigma*beta*T^k/(1 - T) *)
Theorem finding_1 :
  exceeds_distance scheme_1 0 0 1 (125 # 144).
Proof. apply (exceeds_distance_by scheme_1 0 0 0 [0; 1; 0]%Z 0 1 (125 # 144)
  14 1 1 (1 # 64)). vm_cast_no_check (eq_refl true). Qed.

(* Theorem 5, (20): The distance of the polygon after k steps to the limit, for every c with T < 1 *)
(* Refuted at natural parameters for quinary-three-point, c = 4 at level 1; the bound is sigma*beta*T^k/(1 - T) *)
Theorem finding_2 :
  exceeds_distance scheme_1 (-3 # 4) 1 1 (20233 # 617320).
Proof. apply (exceeds_distance_by scheme_1 (-3 # 4) 1 0 [0; -1; 0; -1]%Z (23 # 25) 1 (20233 # 617320)
  12 1 1 (1 # 128)). vm_cast_no_check (eq_refl true). Qed.
