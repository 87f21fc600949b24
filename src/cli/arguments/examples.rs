//! What `--help` shows after the arguments of each command.

pub(super) const AUDIT: &str = "\
Without files, three findings of each embedded paper are shown, those that do most harm; with --full, all.

A promise is what a printed depth or error bound asserts: that every control polygon is so near to its
limit. It is kept, broken or open, whatever the digits of the number are. Of the digits, and of other claims:
  confirmed, holds, exact, proved  right
  reproduced                       right at a value that the paper does not state
  rounding, misprint               rounded differently; one slip of the pen away
  other-reading                    what another reading of the printed definition gives
  refuted, fails, inexact          wrong
  not-checkable, open              neither is shown
Of constants that programs ship: nearest (of its type), cut (to the digits written), ulps (units in the last
place away), otherwise (another table than the file says). docs/verdicts.md and docs/programs.md have the rest.

Examples:
  subcert audit
  subcert audit --full
  subcert audit --paper khan2019-newton --all
  subcert audit examples/my-paper.toml --certified --deny refuted,broken
  subcert audit --format html -o pages";

pub(super) const EXPLAIN: &str = "\
Examples:
  subcert explain khan2019-newton
  subcert explain mustafa2020-nary:table-2:4:7
  subcert explain eq-3 examples/my-paper.toml
  subcert explain khan2022-doo-sabin:theorem-3 --format html -o theorem-3.html";

pub(super) const ERRATA: &str = "\
Examples:
  subcert errata --paper khan2019-newton
  subcert errata examples/my-paper.toml --format text
  subcert errata -o errata";

pub(super) const COVERAGE: &str = "\
Examples:
  subcert coverage
  subcert coverage examples/my-paper.toml --deny missing";

pub(super) const CONSTANTS: &str = "\
Examples:
  subcert constants chaikin
  subcert constants six-point:w=3/256 -c 8 --format csv
  subcert constants 'four-point x chaikin' -c 2";

pub(super) const DEPTH: &str = "\
Examples:
  subcert depth six-point:w=3/256 --tolerance 1/1000 --spread 1/10
  subcert depth chaikin --tolerance 0.01 --polygon examples/polygon.csv
  subcert depth catmull-clark --mesh examples/cube.obj --tolerance 1/100 --format html -o cube.html
  subcert depth bajaj --mesh examples/star.vtk --tolerance 1/20";

pub(super) const RANGE: &str = "\
Examples:
  subcert range six-point --param w -c 5
  subcert range four-point --param w -c 2 --function
  subcert range four-point --param w --smoothness 1
  subcert range four-point --param w --best exponent --bounds w=0..1/8";

pub(super) const SMOOTHNESS: &str = "\
For rules around a vertex or on a face it says whether the surface is C¹ there in Reif's sense,
for generic data. The names of the orbits declare the regular part: vertex, edge and face are
bicubic; vertex and edge the quartic box spline; face is biquadratic. Edge and face points may
have weights of their own if the points around them are declared too: outer, left, right and
corner for bicubic rules, outer and corner for the box spline.

Examples:
  subcert smoothness four-point:w=1/16
  subcert smoothness catmull-clark:N=7
  subcert smoothness loop --valences 3..50
  subcert smoothness doo-sabin --valences all";

pub(super) const SPECTRUM: &str = "\
The conditions on eigenvalues are necessary only: C¹ also needs a regular and injective
characteristic map, which `subcert smoothness` decides.

A sector is the part of the surface between two infinitely sharp edges at a vertex, or at a
boundary vertex. Sectors are analysed for catmull-clark, loop and loop-warren.

Examples:
  subcert spectrum catmull-clark --valence 5
  subcert spectrum examples/loop.toml --valence 6
  subcert spectrum catmull-clark --sector 3
  subcert spectrum loop --sector 2 --corner";

pub(super) const TABLE: &str = "\
Examples:
  subcert table loop --valences 3..12 --format c --type f32
  subcert table catmull-clark --valences 3..50 --format rust
  subcert table catmull-clark --sectors 1..8 --format cpp";

pub(super) const JSR: &str = "\
Examples:
  subcert jsr examples/pair.txt
  subcert jsr examples/pair.txt --below 4
  subcert jsr examples/pair.txt --format json";

pub(super) const CERTIFY: &str = "\
Examples:
  subcert certify quinary-three-point -c 2
  subcert certify chaikin --tolerance 1e-3 --tolerance 1e-6";

pub(super) const PROVE: &str = "\
Examples:
  subcert prove examples/my-paper.toml -o -
  subcert prove khan2019-newton -o certificates";

pub(super) const NEW: &str = "\
Examples:
  subcert new doe2026-corner
  subcert new doe2026-corner -o -";

pub(super) const ORACLE: &str = "\
Examples:
  subcert oracle chaikin --level 3
  subcert oracle four-point:w=1/17 --polygon examples/polygon.csv --format csv
  subcert oracle 'chaikin x chaikin' --points 4 --boundary open
  subcert oracle chaikin --level 5 -o oracle_chaikin.h
  subcert oracle catmull-clark --mesh examples/cube.obj --level 2 --format rust";

pub(super) const REFINE: &str = "\
Examples:
  subcert refine catmull-clark --mesh examples/cube.obj --level 2 -o cube2.obj
  subcert refine doo-sabin --mesh examples/cube.obj --format json
  subcert refine 'chaikin x four-point:w=1/9' --mesh examples/roof.csv --closed u -o fine.csv
  subcert refine bajaj --mesh examples/star.vtk -o refined.vtk";

pub(super) const LIMIT: &str = "\
Examples:
  subcert limit catmull-clark --mesh examples/cube.obj
  subcert limit catmull-clark --mesh examples/tent.obj --level 2 -o limit.obj
  subcert limit bicubic --mesh examples/vase.json -o vase.csv";

pub(super) const SCHEMES: &str = "\
Examples:
  subcert schemes
  subcert schemes --format json";

pub(super) const SCHEME: &str = "\
Examples:
  subcert scheme six-point:w=3/256
  subcert scheme '[1, 3, 3, 1]/4' --format json
  subcert scheme loop
  subcert scheme examples/my-scheme.toml four-point:w=1/8
  subcert scheme chaikin corner-cutting:w=1/5 --format html -o both.html";

pub(super) const ATLAS: &str = "\
Examples:
  subcert atlas
  subcert atlas chaikin four-point
  subcert atlas examples/my-scheme.toml '[1, 3, 3, 1]/4' --format html -o pages
  subcert atlas --format json -o atlas.json";

pub(super) const PLOT: &str = "\
Examples:
  subcert plot four-point:w=1/16 -o four-point.svg
  subcert plot '[1, 4, 6, 4, 1]/8' -o cubic.svg
  subcert plot colella-heil -o region.svg
  subcert plot examples/my-scheme.toml:w=1/8 -o mine.svg
  subcert plot doo-sabin:n=5 -o ring.svg";

#[cfg(not(target_family = "wasm"))]
pub(super) const SERVE: &str = "\
The page listens on 127.0.0.1 only, below a path that is drawn at random. Its commands run on
this machine, with all cores, in folders of their own.

Examples:
  subcert serve
  subcert serve --port 8000 --no-open";

pub(super) const COMPLETIONS: &str = "\
Examples:
  subcert completions bash
  subcert completions zsh";

pub(super) const MAN: &str = "\
Examples:
  subcert man man/man1
  subcert man ~/.local/share/man/man1";
