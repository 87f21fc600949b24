(** mustafa2020-nary, theorem theorem-9 (written by `subcert prove --coq`) *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition scheme_1 :=
  Scheme 128 0 [[28; 58; 40; 2]; [15; 57; 49; 7]; [7; 49; 57; 15]; [2; 40; 58; 28]]%Z.

(* Theorem 9, (33): The subdivision depth for a tolerance ε, surface *)
(* Refuted for quaternary-four-point:mu=0 x quaternary-four-point:mu=0, c = 2 at level 1 and tolerance 65/87; the depth is levels(YZ, epsilon*(1 - YZ)/nu_bound) *)
Theorem finding_1 :
  exceeds_net_distance scheme_1 scheme_1 0 0 1 1 (65 # 87).
Proof. apply (exceeds_net_distance_by scheme_1 scheme_1 0 0 1 0 [0; 1; 2; 3; 4]%Z 0 [0; 1; 2; 3; 4]%Z (15 # 16) (15 # 16) 1 (65 # 87)
  7 1 1 (1 # 4096) 1 1 (1 # 4096)). vm_cast_no_check (eq_refl true). Qed.
