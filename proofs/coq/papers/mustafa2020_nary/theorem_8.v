(** mustafa2020-nary, theorem theorem-8 (written by `subcert prove --coq`) *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition scheme_1 :=
  Scheme 128 0 [[28; 58; 40; 2]; [15; 57; 49; 7]; [7; 49; 57; 15]; [2; 40; 58; 28]]%Z.

(* Theorem 8, (32): The distance of the net after k steps to the limit, for every c with Y_c·Z_c < 1 *)
(* Refuted for quaternary-four-point:mu=0 x quaternary-four-point:mu=0, c = 2 at level 1; the bound is nu_bound*YZ^k/(1 - YZ) *)
Theorem finding_1 :
  exceeds_net_distance scheme_1 scheme_1 0 0 1 1 (1133 # 5120).
Proof. apply (exceeds_net_distance_by scheme_1 scheme_1 0 0 1 0 [0; 1; 2; 3; 4]%Z 0 [0; 1; 2; 3; 4]%Z (15 # 16) (15 # 16) 1 (1133 # 5120)
  3 1 1 (1 # 16) 1 1 (1 # 16)). vm_cast_no_check (eq_refl true). Qed.
