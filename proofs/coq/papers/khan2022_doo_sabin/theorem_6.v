(** khan2022-doo-sabin, theorem theorem-6 (written by `subcert prove --coq`) *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition ring_1 :=
  Ring 6 [[4; 1; 1]; [1; 4; 1]; [1; 1; 4]]%Z
    [(0, 1); (1, 2); (2, 0)]%nat.

(* Theorem 6, (74): The subdivision depth *)
(* Refuted for doo-sabin:n=n, c = 1, n = 3 at level 1 and tolerance 85/256; the depth is levels(GH, epsilon*(1 - GH)/(b*beta)) *)
Theorem finding_1 :
  exceeds_ring_distance ring_1 1 1 (85 # 256).
Proof. apply (exceeds_ring_distance_by ring_1 1 [1; 0; 0]%Z 0 3 [1; 1; 1]%Z). vm_cast_no_check (eq_refl true). Qed.
