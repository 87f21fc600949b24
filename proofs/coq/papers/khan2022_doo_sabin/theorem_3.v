(** khan2022-doo-sabin, theorem theorem-3 (written by `subcert prove --coq`) *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition ring_1 :=
  Ring 6 [[4; 1; 1]; [1; 4; 1]; [1; 1; 4]]%Z
    [(0, 1); (1, 2); (2, 0)]%nat.

(* Theorem 3, (14), (15): The differences fall by Σ|g_j| and by Σ|h_j| in a level *)
(* Refuted for doo-sabin:n=n, n = 3 at level 1; the bound is least_sum^k*beta *)
Theorem finding_1 :
  exceeds_ring_difference ring_1 1 1 0.
Proof. apply (exceeds_ring_difference_by ring_1 1 [1; 0; 0]%Z 0 1). vm_cast_no_check (eq_refl true). Qed.
