(** mustafa2007-bajaj, theorem eq-32-differences (written by `subcert prove --coq`) *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition ring_1 :=
  Ring 112 [[63; 6; 6; 6; 6; 6; 6; 6; 1; 1; 1; 1; 1; 1; 1]; [42; 42; 7; 0; 0; 0; 0; 7; 7; 0; 0; 0; 0; 0; 7]; [42; 7; 42; 7; 0; 0; 0; 0; 7; 7; 0; 0; 0; 0; 0]; [42; 0; 7; 42; 7; 0; 0; 0; 0; 7; 7; 0; 0; 0; 0]; [42; 0; 0; 7; 42; 7; 0; 0; 0; 0; 7; 7; 0; 0; 0]; [42; 0; 0; 0; 7; 42; 7; 0; 0; 0; 0; 7; 7; 0; 0]; [42; 0; 0; 0; 0; 7; 42; 7; 0; 0; 0; 0; 7; 7; 0]; [42; 7; 0; 0; 0; 0; 7; 42; 0; 0; 0; 0; 0; 7; 7]; [28; 28; 28; 0; 0; 0; 0; 0; 28; 0; 0; 0; 0; 0; 0]; [28; 0; 28; 28; 0; 0; 0; 0; 0; 28; 0; 0; 0; 0; 0]; [28; 0; 0; 28; 28; 0; 0; 0; 0; 0; 28; 0; 0; 0; 0]; [28; 0; 0; 0; 28; 28; 0; 0; 0; 0; 0; 28; 0; 0; 0]; [28; 0; 0; 0; 0; 28; 28; 0; 0; 0; 0; 0; 28; 0; 0]; [28; 0; 0; 0; 0; 0; 28; 28; 0; 0; 0; 0; 0; 28; 0]; [28; 28; 0; 0; 0; 0; 0; 28; 0; 0; 0; 0; 0; 0; 28]]%Z
    [(0, 1); (0, 2); (0, 3); (0, 4); (0, 5); (0, 6); (0, 7); (1, 8); (2, 9); (3, 10); (4, 11); (5, 12); (6, 13); (7, 14); (8, 2); (9, 3); (10, 4); (11, 5); (12, 6); (13, 7); (14, 1)]%nat.

(* (32): The larger of Λ_1 and Λ_2 falls by 3/4 at each level *)
(* Refuted for bajaj:N=N, N = 7 at level 1; the bound is (3/4)^k*beta *)
Theorem finding_1 :
  exceeds_ring_difference ring_1 1 1 (3 # 4).
Proof. apply (exceeds_ring_difference_by ring_1 1 [2; 1; 1; 3; 3; 3; 3; 1; 0; 2; 4; 4; 4; 2; 0]%Z 0 1). vm_cast_no_check (eq_refl true). Qed.
