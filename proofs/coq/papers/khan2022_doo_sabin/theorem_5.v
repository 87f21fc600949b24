(** khan2022-doo-sabin, theorem theorem-5 (written by `subcert prove --coq`) *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition ring_1 :=
  Ring 6 [[4; 1; 1]; [1; 4; 1]; [1; 1; 4]]%Z
    [(0, 1); (1, 2); (2, 0)]%nat.

(* Theorem 5, (70), (71), (73): The distance to the limit *)
(* Refuted for doo-sabin:n=n, c = 1, n = 3 at level 1; the bound is b*GH^k/(1 - GH)*beta *)
Theorem finding_1 :
  exceeds_ring_distance ring_1 1 1 (2 # 9).
Proof. apply (exceeds_ring_distance_by ring_1 1 [1; 0; 0]%Z 0 3 [1; 1; 1]%Z). vm_cast_no_check (eq_refl true). Qed.
