(** khan2019-newton, table table-2 (written by `subcert prove --coq`) *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition scheme_1 :=
  Scheme 6 0 [[5; 1]; [3; 3]; [1; 5]]%Z.

(* row 1, column 1: Table 2, j = 0, κ = 1 prints 0.001666 *)
(* This bound holds. *)
Theorem finding_1 :
  bounds_distance scheme_1 0 1 (1 # 12).
Proof. apply (bounds_distance_by scheme_1 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 2: Table 2, j = 0, κ = 2 prints 0.000833 *)
(* This bound holds. *)
Theorem finding_2 :
  bounds_distance scheme_1 0 2 (1 # 36).
Proof. apply (bounds_distance_by scheme_1 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 3: Table 2, j = 0, κ = 3 prints 0.000416 *)
(* This bound holds. *)
Theorem finding_3 :
  bounds_distance scheme_1 0 3 (1 # 108).
Proof. apply (bounds_distance_by scheme_1 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 4: Table 2, j = 0, κ = 4 prints 0.000208 *)
(* This bound holds. *)
Theorem finding_4 :
  bounds_distance scheme_1 0 4 (1 # 324).
Proof. apply (bounds_distance_by scheme_1 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 5: Table 2, j = 0, κ = 5 prints 0.000104 *)
(* This bound holds. *)
Theorem finding_5 :
  bounds_distance scheme_1 0 5 (1 # 972).
Proof. apply (bounds_distance_by scheme_1 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 6: Table 2, j = 0, κ = 6 prints 0.000052 *)
(* This bound holds. *)
Theorem finding_6 :
  bounds_distance scheme_1 0 6 (1 # 2916).
Proof. apply (bounds_distance_by scheme_1 0 1 1). vm_cast_no_check (eq_refl true). Qed.

Definition scheme_2 :=
  Scheme 1296 0 [[-55; 1155; 231; -35]; [-81; 729; 729; -81]; [-35; 231; 1155; -55]]%Z.

(* row 2, column 1: Table 2, j = 1, κ = 1 prints 0.009217 *)
(* This bound holds. *)
Theorem finding_7 :
  bounds_distance scheme_2 0 1 (95437067573 # 111373027584).
Proof. apply (bounds_distance_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 2: Table 2, j = 1, κ = 2 prints 0.004068 *)
(* This bound holds. *)
Theorem finding_8 :
  bounds_distance scheme_2 0 2 (2587520897581 # 9021215234304).
Proof. apply (bounds_distance_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 3: Table 2, j = 1, κ = 3 prints 0.001795 *)
(* This bound holds. *)
Theorem finding_9 :
  bounds_distance scheme_2 0 3 (23397309018079 # 243572811326208).
Proof. apply (bounds_distance_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 4: Table 2, j = 1, κ = 4 prints 0.000792 *)
(* This bound holds. *)
Theorem finding_10 :
  bounds_distance scheme_2 0 4 (212276799299821 # 6576465905807616).
Proof. apply (bounds_distance_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 5: Table 2, j = 1, κ = 5 prints 0.000349 *)
(* This bound holds. *)
Theorem finding_11 :
  bounds_distance scheme_2 0 5 (1956238862366239 # 177564579456805632).
Proof. apply (bounds_distance_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 6: Table 2, j = 1, κ = 6 prints 0.000154 *)
(* This bound holds. *)
Theorem finding_12 :
  bounds_distance scheme_2 0 6 (18840078068089261 # 4794243645333752064).
Proof. apply (bounds_distance_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

Definition scheme_3 :=
  Scheme 186624 0 [[1309; -12155; 170170; 34034; -7735; 1001]; [2187; -18225; 109350; 109350; -18225; 2187]; [1001; -7735; 34034; 170170; -12155; 1309]]%Z.

(* row 3, column 1: Table 2, j = 2, κ = 1 prints 0.022168 *)
(* This bound holds. *)
Theorem finding_13 :
  bounds_distance scheme_3 0 1 (334980440926240305708198460577 # 188209617223002040977756536832).
Proof. apply (bounds_distance_by scheme_3 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 2: Table 2, j = 2, κ = 2 prints 0.011211 *)
(* This bound holds. *)
Theorem finding_14 :
  bounds_distance scheme_3 0 2 (27311655094535129436975464216071 # 45734936985189495957594838450176).
Proof. apply (bounds_distance_by scheme_3 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 3: Table 2, j = 2, κ = 3 prints 0.005669 *)
(* This bound holds. *)
Theorem finding_15 :
  bounds_distance scheme_3 0 3 (2229650100123026938063610641582501 # 11113589687401047517695545743392768).
Proof. apply (bounds_distance_by scheme_3 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 4: Table 2, j = 2, κ = 4 prints 0.002867 *)
(* This bound holds. *)
Theorem finding_16 :
  bounds_distance scheme_3 0 4 (40460825126180194722023749228840920787745 # 597330017804601530479415096298700397346816).
Proof. apply (bounds_distance_by scheme_3 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 5: Table 2, j = 2, κ = 5 prints 0.001450 *)
(* This bound holds. *)
Theorem finding_17 :
  bounds_distance scheme_3 0 5 (3401834778247186569769720957745395128352595 # 145151194326518171906497868400584196555276288).
Proof. apply (bounds_distance_by scheme_3 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 6: Table 2, j = 2, κ = 6 prints 0.000733 *)
(* This bound holds. *)
Theorem finding_18 :
  bounds_distance scheme_3 0 6 (180350117400829246873461774964761432858798929719649 # 20804118904313953777058502291756000075211685354274816).
Proof. apply (bounds_distance_by scheme_3 0 6 6). vm_cast_no_check (eq_refl true). Qed.
