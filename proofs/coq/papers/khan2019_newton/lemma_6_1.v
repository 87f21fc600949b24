(** khan2019-newton, theorem lemma-6.1 (written by `subcert prove --coq`) *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition scheme_1 :=
  Scheme 1024 0 [[-35; 945; 135; -21]; [-65; 715; 429; -55]; [-55; 429; 715; -65]; [-21; 135; 945; -35]]%Z.

(* Lemma 6.1, (6.26): The distance of the polygon after κ steps to the limit *)
(* Refuted for newton:j=1,n=4 at level 0; the bound is sigma*beta*xi^k/(1 - xi) *)
Theorem finding_1 :
  exceeds_distance scheme_1 0 0 1 (3 # 2).
Proof. apply (exceeds_distance_by scheme_1 0 0 0 [0; 1; 2; 1]%Z 0 1 (3 # 2)
  4 1 1 (1 # 32)). vm_cast_no_check (eq_refl true). Qed.
