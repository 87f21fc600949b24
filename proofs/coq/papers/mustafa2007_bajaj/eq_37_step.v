(** mustafa2007-bajaj, theorem eq-37-step (written by `subcert prove --coq`) *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition ring_1 :=
  Ring 48 [[27; 6; 6; 6; 1; 1; 1]; [18; 18; 3; 3; 3; 0; 3]; [18; 3; 18; 3; 3; 3; 0]; [18; 3; 3; 18; 0; 3; 3]; [12; 12; 12; 0; 12; 0; 0]; [12; 0; 12; 12; 0; 12; 0]; [12; 12; 0; 12; 0; 0; 12]]%Z
    [(0, 1); (0, 2); (0, 3); (1, 4); (2, 5); (3, 6); (4, 2); (5, 3); (6, 1)]%nat.

Definition ring_2 :=
  Ring 4 [[4; 0; 0; 0; 0; 0; 0]; [2; 2; 0; 0; 0; 0; 0]; [2; 0; 2; 0; 0; 0; 0]; [2; 0; 0; 2; 0; 0; 0]; [1; 1; 1; 0; 1; 0; 0]; [1; 0; 1; 1; 0; 1; 0]; [1; 1; 0; 1; 0; 0; 1]]%Z
    [(0, 1); (0, 2); (0, 3); (1, 4); (2, 5); (3, 6); (4, 2); (5, 3); (6, 1)]%nat.

(* (37): The step between two successive meshes *)
(* Refuted for bajaj:N=N, N = 3 at level 0; the bound is 23/48*(3/4)^k*beta *)
Theorem finding_1 :
  exceeds_ring_step ring_1 ring_2 0 1 (23 # 48).
Proof. apply (exceeds_ring_step_by ring_1 ring_2 0 [0; 1; 1; 1; 2; 2; 2]%Z 0). vm_cast_no_check (eq_refl true). Qed.
