(** khan2019-newton, table table-3 (written by `subcert prove --coq`) *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition scheme_1 :=
  Scheme 8 0 [[7; 1]; [5; 3]; [3; 5]; [1; 7]]%Z.

(* row 1, column 1: Table 3, j = 0, κ = 1 prints 0.004167 *)
(* This bound holds. *)
Theorem finding_1 :
  bounds_distance scheme_1 0 1 (1 # 24).
Proof. apply (bounds_distance_by scheme_1 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 2: Table 3, j = 0, κ = 2 prints 0.001042 *)
(* This bound holds. *)
Theorem finding_2 :
  bounds_distance scheme_1 0 2 (1 # 96).
Proof. apply (bounds_distance_by scheme_1 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 3: Table 3, j = 0, κ = 3 prints 0.000260 *)
(* This bound holds. *)
Theorem finding_3 :
  bounds_distance scheme_1 0 3 (1 # 384).
Proof. apply (bounds_distance_by scheme_1 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 4: Table 3, j = 0, κ = 4 prints 0.000065 *)
(* This bound holds. *)
Theorem finding_4 :
  bounds_distance scheme_1 0 4 (1 # 1536).
Proof. apply (bounds_distance_by scheme_1 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 5: Table 3, j = 0, κ = 5 prints 0.000016 *)
(* This bound holds. *)
Theorem finding_5 :
  bounds_distance scheme_1 0 5 (1 # 6144).
Proof. apply (bounds_distance_by scheme_1 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 6: Table 3, j = 0, κ = 6 prints 0.000004 *)
(* This bound holds. *)
Theorem finding_6 :
  bounds_distance scheme_1 0 6 (1 # 24576).
Proof. apply (bounds_distance_by scheme_1 0 1 1). vm_cast_no_check (eq_refl true). Qed.

Definition scheme_2 :=
  Scheme 1024 0 [[-35; 945; 135; -21]; [-65; 715; 429; -55]; [-55; 429; 715; -65]; [-21; 135; 945; -35]]%Z.

(* row 2, column 1: Table 3, j = 1, κ = 1 prints 0.055921 *)
(* This bound holds. *)
Theorem finding_7 :
  bounds_distance scheme_2 0 1 (78057478450965 # 140691675371008).
Proof. apply (bounds_distance_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 2: Table 3, j = 1, κ = 2 prints 0.018567 *)
(* This bound holds. *)
Theorem finding_8 :
  bounds_distance scheme_2 0 2 (5010866958858425 # 36017068894978048).
Proof. apply (bounds_distance_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 3: Table 3, j = 1, κ = 3 prints 0.006165 *)
(* This bound holds. *)
Theorem finding_9 :
  bounds_distance scheme_2 0 3 (80265228060310265 # 2305092409278595072).
Proof. apply (bounds_distance_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 4: Table 3, j = 1, κ = 4 prints 0.002047 *)
(* This bound holds. *)
Theorem finding_10 :
  bounds_distance scheme_2 0 4 (1289209782040582905 # 147525914193830084608).
Proof. apply (bounds_distance_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 5: Table 3, j = 1, κ = 5 prints 0.000679 *)
(* This bound holds. *)
Theorem finding_11 :
  bounds_distance scheme_2 0 5 (20944308332575709945 # 9441658508405125414912).
Proof. apply (bounds_distance_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 6: Table 3, j = 1, κ = 6 prints 0.000226 *)
(* This bound holds. *)
Theorem finding_12 :
  bounds_distance scheme_2 0 6 (355392969099586689785 # 604266144537928026554368).
Proof. apply (bounds_distance_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

Definition scheme_3 :=
  Scheme 262144 0 [[1449; -13685; 246330; 35190; -8211; 1071]; [3003; -25935; 190190; 114114; -21945; 2717]; [2717; -21945; 114114; 190190; -25935; 3003]; [1071; -8211; 35190; 246330; -13685; 1449]]%Z.

(* row 3, column 1: Table 3, j = 2, κ = 1 prints 0.130828 *)
(* This bound holds. *)
Theorem finding_13 :
  bounds_distance scheme_3 0 1 (2828716620870965127790305 # 2416946518991839388336128).
Proof. apply (bounds_distance_by scheme_3 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 2: Table 3, j = 2, κ = 2 prints 0.049853 *)
(* This bound holds. *)
Theorem finding_14 :
  bounds_distance scheme_3 0 2 (46561018791492214407277096685 # 158397007068649186153996484608).
Proof. apply (bounds_distance_by scheme_3 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 3: Table 3, j = 2, κ = 3 prints 0.018997 *)
(* This bound holds. *)
Theorem finding_15 :
  bounds_distance scheme_3 0 3 (11941167770023826117350315389485 # 162198535238296766621692400238592).
Proof. apply (bounds_distance_by scheme_3 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 4: Table 3, j = 2, κ = 4 prints 0.007239 *)
(* This bound holds. *)
Theorem finding_16 :
  bounds_distance scheme_3 0 4 (3075815638504055786907518741767725 # 166091300084015889020613017844318208).
Proof. apply (bounds_distance_by scheme_3 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 5: Table 3, j = 2, κ = 5 prints 0.002758 *)
(* This bound holds. *)
Theorem finding_17 :
  bounds_distance scheme_3 0 5 (806687530774735024201654011802887725 # 170077491286032270357107730272581844992).
Proof. apply (bounds_distance_by scheme_3 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 6: Table 3, j = 2, κ = 6 prints 0.001051 *)
(* This bound holds. *)
Theorem finding_18 :
  bounds_distance scheme_3 0 6 (226252608605715804221802144965934917165 # 174159351076897044845678315799123809271808).
Proof. apply (bounds_distance_by scheme_3 0 6 6). vm_cast_no_check (eq_refl true). Qed.
