(** mustafa2020-nary, theorem theorem-7 (written by `subcert prove --coq`) *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition scheme_1 :=
  Scheme 128 0 [[28; 58; 40; 2]; [15; 57; 49; 7]; [7; 49; 57; 15]; [2; 40; 58; 28]]%Z.

(* Theorem 7, (31): The step between two successive nets, for every number c of convolutions *)
(* Refuted for quaternary-four-point:mu=0 x quaternary-four-point:mu=0, c = 2 at level 1; the bound is nu_bound*YZ^k *)
Theorem finding_1 :
  exceeds_net_step scheme_1 scheme_1 0 0 1 1 (3399 # 16384).
Proof. apply (exceeds_net_step_by scheme_1 scheme_1 0 0 1 0 [0; 1; 2; 3]%Z 0 [0; 1; 2; 3]%Z 0 0). vm_cast_no_check (eq_refl true). Qed.
