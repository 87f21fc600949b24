// The examples of examples/, word for word, and the keys of the papers that are part of the program.

/** Claim files to begin with: the same texts as in the folder `examples`. */
export const PAPER_EXAMPLES = {
  first: {
    title: "Example 1: a wrong number",
    text: `# A claim file for an invented paper with two tables: the smallest that shows a finding.
key = "roe2026"

[paper]
authors = ["Richard Roe"]
title = "Depths of the 4-point scheme"
venue = "Journal of Examples 2"
year = "2026"

# The definitions that the paper prints, as formulas.
[define]
T = 'contraction(c)'
sigma = 'displacement()'
depth = 'levels(T, epsilon*(1 - T)/(sigma*beta), c)'

# The values that the paper states for everything.
[given]
beta = '1'

[[table]]
id = "table-1"
locus = "Table 1"
title = "Contraction constants"
scheme = "four-point:w=1/16"
value = 'T'
columns = { name = "c", values = ['1', '2', '3', '4'] }
cells = [['0.625000', '0.375000', '0.226563', '0.136719']]

[[table]]
id = "table-2"
locus = "Table 2"
title = "Subdivision depths"
scheme = "four-point:w=1/16"
value = 'depth'
promise = { tolerance = 'epsilon', spread = 'beta' }
rows = { name = "c", values = ['1', '3'] }
columns = { name = "epsilon", label = "ε", values = ['0.1', '0.01', '0.001'] }
cells = [
    ['3', '8', '13'],
    ['1', '2', '4'],
]
`,
  },
  mine: {
    title: "Example 2: a whole paper",
    text: `# A claim file for an invented paper, as an author or referee would write it.
key = "doe2026-corner"

[paper]
authors = ["Jane Doe"]
title = "A corner cutting scheme with tension"
venue = "Journal of Examples 1"
year = "2026"
# What the paper numbers: \`subcert coverage\` says what of it is claimed.
numbered = ["(1)-(4)", "Table 1-3", "Theorem 1", "Remark 1"]

# A scheme of the paper's own, with a parameter. Every rule must sum to 1.
[[scheme]]
name = "corner"
parameters.w = { about = "tension" }
mask = [
    ['1 - w', 'w'],
    ['w', '1 - w'],
]

# The paper's definitions, in its own notation.
[define]
delta = 'contraction(c, order = adjoint)'
bound = 'displacement(offset = 0)*beta*delta^k/(1 - delta)'

# What the paper says its numbers are computed with.
[given]
beta = '1'

[[table]]
id = "table-1"
locus = "Table 1"
title = "Contraction constants"
scheme = "corner:w=w"
value = 'delta'
given = { c = '1' }
columns = { name = "w", values = ['1/5', '1/4', '1/3'] }
cells = [['0.60', '0.50', '0.66']]

[[table]]
id = "table-2"
locus = "Table 2"
title = "Error bounds after k steps"
scheme = "corner:w=w"
value = 'bound'
promise = { level = 'k', spread = 'beta', offset = '0' }
given = { c = '1' }
rows = { name = "w", values = ['1/5', '1/4'] }
columns = { name = "k", values = ['1', '2', '3'] }
cells = [
    ['0.4500', '0.2700', '0.1260'],
    ['0.2500', '0.1250', '0.0625'],
]

[[table]]
id = "table-3"
locus = "Table 3"
title = "Subdivision depths at w = 1/4"
scheme = "corner:w=1/4"
value = 'levels(delta, epsilon*(1 - delta)/(displacement(offset = 0)*spread), rounded = up)'
promise = { tolerance = 'epsilon', spread = 'spread', offset = '0' }
given = { c = '1' }
unstated = ["spread"]
columns = { name = "epsilon", label = "ε", values = ['0.1', '0.01', '1e-3'] }
cells = [['3', '6', '8']]

[[equation]]
id = "eq-3"
locus = "(3)"
title = "The difference mask"
scheme = "corner:w=w"
symbols = ["w"]
indices = [
    { name = "beta", values = ['0', '1'] },
    { name = "j", values = ['0', '1'] },
]
left = ['1 - 2*w', '0', 'w', 'w']
right = 'difference(beta, j)'

# A closed form in a free parameter, and the range of the parameter.
[[function]]
id = "eq-4"
locus = "(4)"
title = "The contraction constant"
variable = "w"
scheme = "corner:w=w"
left = 'max(abs(1 - 2*w), 2*abs(w))'
right = 'contraction(1)'

[[range]]
id = "remark-1"
locus = "Remark 1"
title = "The differences contract for these w"
variable = "w"
scheme = "corner:w=w"
value = 'contraction(1)'
below = '1'
from = '0'
to = '0.5'
closed = false

# A theorem: what it bounds, by what, and the claims that it uses.
[[theorem]]
id = "theorem-1"
locus = "Theorem 1, (2)"
title = "The distance to the limit after k steps"
scheme = "corner:w=w"
bounds = "distance"
by = 'bound'
from = '0'
rests = ["eq-3", "eq-4"]

[[unclaimed]]
locus = "(1)"
reason = "the rules of the scheme"
`,
  },
};

/** The papers that are part of the program. */
export const PAPER_KEYS = {
  "mustafa2007-bajaj": "Mustafa, Hashmi, Akhtar 2007",
  "mustafa2007-ternary": "Mustafa, Deng 2007",
  "khan2019-newton": "Khan, Omar, Mustafa 2019",
  "mustafa2020-nary": "Mustafa et al. 2020",
  "khan2022-doo-sabin": "Khan et al. 2022",
};
