(** khan2019-newton, table table-1 (written by `subcert prove --coq`) *)

From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition scheme_1 :=
  Scheme 4 0 [[3; 1]; [1; 3]]%Z.

(* row 1, column 1: Table 1, j = 0, κ = 1 prints 0.002500 *)
(* This bound holds. *)
Theorem finding_1 :
  bounds_distance scheme_1 0 1 (1 # 4).
Proof. apply (bounds_distance_by scheme_1 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 2: Table 1, j = 0, κ = 2 prints 0.001250 *)
(* This bound holds. *)
Theorem finding_2 :
  bounds_distance scheme_1 0 2 (1 # 8).
Proof. apply (bounds_distance_by scheme_1 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 3: Table 1, j = 0, κ = 3 prints 0.000625 *)
(* This bound holds. *)
Theorem finding_3 :
  bounds_distance scheme_1 0 3 (1 # 16).
Proof. apply (bounds_distance_by scheme_1 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 4: Table 1, j = 0, κ = 4 prints 0.000312 *)
(* This bound holds. *)
Theorem finding_4 :
  bounds_distance scheme_1 0 4 (1 # 32).
Proof. apply (bounds_distance_by scheme_1 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 4: Table 1, j = 0, κ = 4 prints 0.000312 *)
(* Broken at level 4: 39/125000 for points of spread 1/100 *)
Theorem finding_5 :
  exceeds_distance scheme_1 0 4 1 (39 # 1250).
Proof. apply (exceeds_distance_by scheme_1 0 4 0 [0; 1]%Z 0 1 (39 # 1250)
  15 1 1 (1 # 65536)). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 5: Table 1, j = 0, κ = 5 prints 0.000156 *)
(* This bound holds. *)
Theorem finding_6 :
  bounds_distance scheme_1 0 5 (1 # 64).
Proof. apply (bounds_distance_by scheme_1 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 5: Table 1, j = 0, κ = 5 prints 0.000156 *)
(* Broken at level 5: 39/250000 for points of spread 1/100 *)
Theorem finding_7 :
  exceeds_distance scheme_1 0 5 1 (39 # 2500).
Proof. apply (exceeds_distance_by scheme_1 0 5 0 [0; 1]%Z 0 1 (39 # 2500)
  16 1 1 (1 # 131072)). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 6: Table 1, j = 0, κ = 6 prints 0.000078 *)
(* This bound holds. *)
Theorem finding_8 :
  bounds_distance scheme_1 0 6 (1 # 128).
Proof. apply (bounds_distance_by scheme_1 0 1 1). vm_cast_no_check (eq_refl true). Qed.

(* row 1, column 6: Table 1, j = 0, κ = 6 prints 0.000078 *)
(* Broken at level 6: 39/500000 for points of spread 1/100 *)
Theorem finding_9 :
  exceeds_distance scheme_1 0 6 1 (39 # 5000).
Proof. apply (exceeds_distance_by scheme_1 0 6 0 [0; 1]%Z 0 1 (39 # 5000)
  17 1 1 (1 # 262144)). vm_cast_no_check (eq_refl true). Qed.

Definition scheme_2 :=
  Scheme 128 0 [[-7; 105; 35; -5]; [-5; 35; 105; -7]]%Z.

(* row 2, column 1: Table 1, j = 1, κ = 1 prints 0.023863 *)
(* This bound holds. *)
Theorem finding_10 :
  bounds_distance scheme_2 0 1 (124469395379109 # 68899464795968).
Proof. apply (bounds_distance_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 2: Table 1, j = 1, κ = 2 prints 0.015660 *)
(* This bound holds. *)
Theorem finding_11 :
  bounds_distance scheme_2 0 2 (2016156243034089 # 2204782873470976).
Proof. apply (bounds_distance_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 3: Table 1, j = 1, κ = 3 prints 0.010277 *)
(* This bound holds. *)
Theorem finding_12 :
  bounds_distance scheme_2 0 3 (8168132097926097 # 17638262987767808).
Proof. apply (bounds_distance_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 4: Table 1, j = 1, κ = 4 prints 0.006744 *)
(* This bound holds. *)
Theorem finding_13 :
  bounds_distance scheme_2 0 4 (17073718807633486851 # 72246325197896941568).
Proof. apply (bounds_distance_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 5: Table 1, j = 1, κ = 5 prints 0.004426 *)
(* This bound holds. *)
Theorem finding_14 :
  bounds_distance scheme_2 0 5 (71010463672732460331 # 577970601583175532544).
Proof. apply (bounds_distance_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 2, column 6: Table 1, j = 1, κ = 6 prints 0.002904 *)
(* This bound holds. *)
Theorem finding_15 :
  bounds_distance scheme_2 0 6 (78245442299281896994803 # 1183683792042343490650112).
Proof. apply (bounds_distance_by scheme_2 0 6 6). vm_cast_no_check (eq_refl true). Qed.

Definition scheme_3 :=
  Scheme 8192 0 [[77; -693; 6930; 2310; -495; 63]; [63; -495; 2310; 6930; -693; 77]]%Z.

(* row 3, column 1: Table 1, j = 2, κ = 1 prints 0.066975 *)
(* This bound holds. *)
Theorem finding_16 :
  bounds_distance scheme_3 0 1 (8630035479399405492882069 # 2360152556894312328474112).
Proof. apply (bounds_distance_by scheme_3 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 2: Table 1, j = 2, κ = 2 prints 0.050133 *)
(* This bound holds. *)
Theorem finding_17 :
  bounds_distance scheme_3 0 2 (8989426048754069553625699905 # 4833592436519551648714981376).
Proof. apply (bounds_distance_by scheme_3 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 3: Table 1, j = 2, κ = 3 prints 0.037526 *)
(* This bound holds. *)
Theorem finding_18 :
  bounds_distance scheme_3 0 3 (18733832031980438550295096014955 # 19798394619984083553136563716096).
Proof. apply (bounds_distance_by scheme_3 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 4: Table 1, j = 2, κ = 4 prints 0.028090 *)
(* This bound holds. *)
Theorem finding_19 :
  bounds_distance scheme_3 0 4 (9897864916323663224157499450122449 # 20273556090863701558411841245282304).
Proof. apply (bounds_distance_by scheme_3 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 5: Table 1, j = 2, κ = 5 prints 0.021026 *)
(* This bound holds. *)
Theorem finding_20 :
  bounds_distance scheme_3 0 5 (172129759832316143773275821218411944409 # 664323885985421772666039213925410537472).
Proof. apply (bounds_distance_by scheme_3 0 6 6). vm_cast_no_check (eq_refl true). Qed.

(* row 3, column 6: Table 1, j = 2, κ = 6 prints 0.015739 *)
(* This bound holds. *)
Theorem finding_21 :
  bounds_distance scheme_3 0 6 (393308186791993041526501723803745735619135 # 2721070636996287580840096620238481561485312).
Proof. apply (bounds_distance_by scheme_3 0 6 6). vm_cast_no_check (eq_refl true). Qed.
