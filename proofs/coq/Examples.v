(** Every definition at work, with numbers known from elsewhere. *)

Require Import ZArith QArith List.
From Subcert Require Import Definitions Core.
Import ListNotations.
Local Open Scope Z_scope.

(** Chaikin's corner cutting: (3 x_i + x_(i+1))/4, (x_i + 3 x_(i+1))/4. *)
Definition chaikin := Scheme 4 0 [[3; 1]; [1; 3]].

(** Dyn, Levin and Gregory's four-point scheme at w = 1/16. *)
Definition four_point := Scheme 16 (-1) [[0; 16; 0; 0]; [-1; 9; 9; -1]].

(** Hassan and Dodgson's ternary 3-point scheme at a = 1/4: 2 of its 3 rules have negative weights elsewhere. *)
Definition ternary := Scheme 27 (-1) [[10; 16; 1]; [4; 19; 4]; [1; 16; 10]].

(** The quadratic through three points, five new points for each. *)
Definition quinary := Scheme 25 (-1) [[7; 21; -3]; [3; 24; -2]; [0; 25; 0]; [-2; 24; 3]; [-3; 21; 7]].

Example chaikin_1 : contraction_constant chaikin 1 (1 # 2).
Proof. apply contraction_constant_by. vm_compute. reflexivity. Qed.

Example chaikin_8 : contraction_constant chaikin 8 (1 # 256).
Proof. apply contraction_constant_by. vm_compute. reflexivity. Qed.

Eval vm_compute in contraction four_point 12.
Eval vm_compute in Qred (contraction ternary 3).
Eval vm_compute in Qred (contraction quinary 3).
