(** khan2022-doo-sabin, theorem theorem-4 (written by `subcert prove --coq`) *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition ring_1 :=
  Ring 6 [[4; 1; 1]; [1; 4; 1]; [1; 1; 4]]%Z
    [(0, 1); (1, 2); (2, 0)]%nat.

Definition ring_2 :=
  Ring 1 [[1; 0; 0]; [0; 1; 0]; [0; 0; 1]]%Z
    [(0, 1); (1, 2); (2, 0)]%nat.

(* Theorem 4, (42), (68), (69): The step of two levels *)
(* Refuted for doo-sabin:n=n, c = 2, n = 3 at level 1; the bound is b*GH^k*beta *)
Theorem finding_1 :
  exceeds_ring_step ring_1 ring_2 1 1 (1 # 24).
Proof. apply (exceeds_ring_step_by ring_1 ring_2 1 [0; 1; 1]%Z 0). vm_cast_no_check (eq_refl true). Qed.
