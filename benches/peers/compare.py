"""Computes the quantities of subcert.json by other systems, checks that every value is the same,
and prints how many times as long as subcert each of them takes."""

import json
import math
import shutil
import subprocess
import sys
import time
from fractions import Fraction

TOO_LONG = 10.0  # seconds; larger arguments of the same kind are then left out


def timed(run):
    """The value, and the least time of up to three runs within a second."""
    best, begin = math.inf, time.perf_counter()
    for _ in range(3):
        start = time.perf_counter()
        value = run()
        best = min(best, time.perf_counter() - start)
        if time.perf_counter() - begin > 1:
            break
    return value, best


def integer_mask(record):
    """The difference mask over one denominator."""
    rows = [[Fraction(x) for x in row] for row in record["mask"]]
    denominator = math.lcm(*(x.denominator for row in rows for x in row))
    return [[int(x * denominator) for x in row] for row in rows], denominator


def symbol(rows):
    """t with t[n*u + beta] = b[beta][N - 1 - u]."""
    width = len(rows[0])
    return [row[width - 1 - u] for u in range(width) for row in rows]


def largest_class(coefficients, classes):
    sums = [0] * classes
    for at, x in enumerate(coefficients):
        sums[at % classes] += abs(x)
    return max(sums)


def two_digits(x):
    """Rounded to two significant digits, without an exponent."""
    return f"{round(x, 1 - math.floor(math.log10(x))):.10f}".rstrip("0").rstrip(".")


def duration(seconds):
    """In a unit that fits."""
    for unit, size in (("s", 1), ("ms", 1e-3), ("µs", 1e-6)):
        if seconds >= size:
            return f"{two_digits(seconds / size)} {unit}"
    return f"{two_digits(seconds / 1e-9)} ns"


class PlainPython:
    """Integers of Python, every row of the power."""

    def contraction(self, record):
        rows, denominator = integer_mask(record)
        levels, arity, width = int(record["argument"]), len(rows), len(rows[0])
        length = 1
        while (reach := (arity + length - 2) // arity + width) > length:
            length = reach
        best, stack = 0, [(levels, [1] + [0] * (length - 1))]
        while stack:
            left, row = stack.pop()
            if not left:
                best = max(best, sum(map(abs, row)))
                continue
            for digit in range(arity):
                coarse = [0] * length
                for at, x in enumerate(row):
                    if x:
                        carry, rule = divmod(digit + at, arity)
                        for column, y in enumerate(rows[rule], carry):
                            coarse[column] += x * y
                stack.append((left - 1, coarse))
        return str(Fraction(best, denominator**levels))


class Flint:
    """python-flint: products of polynomials, arb enclosures, root isolation."""

    def __init__(self):
        import flint

        self.flint = flint
        self.name = f"python-flint {flint.__version__}"

    def contraction(self, record):
        rows, denominator = integer_mask(record)
        levels, arity = int(record["argument"]), len(rows)
        t, product = symbol(rows), self.flint.fmpz_poly([1])
        for level in range(levels):
            step = arity**level
            spread = [0] * (step * (len(t) - 1) + 1)
            spread[::step] = t
            product *= self.flint.fmpz_poly(spread)
        best = largest_class(map(int, product.coeffs()), arity**levels)
        return str(Fraction(best, denominator**levels))

    def minimal_polynomial(self, record):
        polynomial = self.flint.fmpz_poly.cos_minpoly(int(record["argument"]))
        return [str(x) for x in polynomial.coeffs()]

    def sign(self, record):
        flint, near = self.flint, Fraction(record["near"])
        precision = 64
        while True:
            with flint.ctx.workprec(precision):
                turn = flint.fmpq(2, record["n"])
                cosine = flint.arb.cos_pi_fmpq(turn)
                off = cosine - flint.arb(flint.fmpq(near.numerator, near.denominator))
                if off > 0 or off < 0:
                    return 1 if off > 0 else -1
            precision *= 2

    def range(self, record):
        count = 0
        for coefficients in record["polynomials"]:
            roots = self.flint.fmpz_poly([int(x) for x in coefficients]).complex_roots()
            for root, _ in roots:
                real = root.real
                count += root.imag == 0 and real >= 0 and real <= self.flint.arb("0.25")
        return count


class SymPy:
    """SymPy: minimal_polynomial, evaluation to a guaranteed number of digits, count_roots."""

    def __init__(self):
        import sympy

        self.sympy = sympy
        self.name = f"SymPy {sympy.__version__}"

    def contraction(self, record):
        sympy = self.sympy
        rows, denominator = integer_mask(record)
        levels, arity, x = int(record["argument"]), len(rows), sympy.Symbol("x")
        t, product = symbol(rows), sympy.Poly(1, x)
        for level in range(levels):
            terms = {(at * arity**level,): y for at, y in enumerate(t) if y}
            product *= sympy.Poly.from_dict(terms, x)
        coefficients = [int(y) for y in reversed(product.all_coeffs())]
        best = largest_class(coefficients, arity**levels)
        return str(Fraction(best, denominator**levels))

    def minimal_polynomial(self, record):
        sympy, x = self.sympy, self.sympy.Symbol("x")
        number = 2 * sympy.cos(2 * sympy.pi / int(record["argument"]))
        polynomial = sympy.minimal_polynomial(number, x, polys=True)
        return [str(y) for y in reversed(polynomial.all_coeffs())]

    def sign(self, record):
        sympy = self.sympy
        off = sympy.cos(2 * sympy.pi / record["n"]) - sympy.Rational(record["near"])
        return int(sympy.sign(off.evalf(20, maxn=1000)))

    def range(self, record):
        sympy, x = self.sympy, self.sympy.Symbol("x")
        polynomials = (sympy.Poly([int(y) for y in reversed(p)], x) for p in record["polynomials"])
        return sum(p.count_roots(0, sympy.Rational(1, 4)) for p in polynomials)


class Pari:
    """PARI/GP, timed inside one process by getwalltime."""

    def __init__(self):
        if not shutil.which("gp"):
            raise ImportError
        version = subprocess.run(["gp", "--version-short"], capture_output=True, text=True)
        self.name = f"PARI/GP {version.stdout.strip()}"

    def run(self, setup, expression):
        """The value, and the time in seconds of enough runs."""
        script = f"""default(parisizemax, 4000000000);
{setup}
run() = {expression};
{{ my(count = 1, start, spent = 0, value);
  while (1, start = getwalltime(); for (i = 1, count, value = run());
    spent = getwalltime() - start; if (spent > 50, break); count *= 4);
  print(value); print(spent / count / 1000.); }}
quit
"""
        done = subprocess.run(["gp", "-q", "-f"], input=script, capture_output=True, text=True)
        value, seconds = done.stdout.split("\n")[:2]
        return value.strip(), float(seconds.replace(" E", "e"))

    def contraction(self, record):
        rows, denominator = integer_mask(record)
        levels, arity = int(record["argument"]), len(rows)
        setup = f"""t = Polrev({symbol(rows)});
largest(c) = {{ my(p = 1, v, s = vector({arity}^c));
  for (k = 0, c - 1, p *= subst(t, x, x^({arity}^k)));
  v = Vecrev(p);
  for (i = 1, #v, s[(i - 1) % {arity}^c + 1] += abs(v[i]));
  vecmax(s) / {denominator}^c; }}"""
        return self.run(setup, f"largest({levels})")

    def minimal_polynomial(self, record):
        n = int(record["argument"])
        # t^(d/2)·psi(t + 1/t) is the cyclotomic polynomial: its coefficients by elimination
        # against (t^2 + 1)^i.
        setup = """cosine(n) = { my(p = polcyclo(n, x), d = poldegree(p) / 2, q = vector(d + 1), c);
  my(v = Vecrev(p), b, w = vector(d + 1, i, v[d + i]));
  forstep (k = d, 0, -1, c = w[k + 1]; q[k + 1] = c;
    if (c, b = 1; for (i = 0, k \\ 2, w[k - 2*i + 1] -= c * b; b = b * (k - i) / (i + 1))));
  q; }"""
        value, seconds = self.run(setup, f"cosine({n})")
        return value.strip("[]").split(", "), seconds

    def sign(self, record):
        # Enough digits for these arguments; PARI gives no enclosure.
        value, seconds = self.run(
            "default(realprecision, 150);", f"sign(cos(2*Pi/{record['n']}) - {record['near']})"
        )
        return int(value), seconds

    def range(self, record):
        polynomials = ", ".join(f"Polrev([{', '.join(p)}])" for p in record["polynomials"])
        setup = f"P = [{polynomials}];"
        once = "polrootsreal(P[i] / gcd(P[i], P[i]'), [0, 1/4])"
        value, seconds = self.run(setup, f"sum(i = 1, #P, #{once})")
        return int(value), seconds


def peers():
    python = PlainPython()
    python.name = f"Python {sys.version.split()[0]}"
    found = [python]
    for peer in (Flint, Pari, SymPy):
        try:
            found.append(peer())
        except ImportError:
            print(f"missing: {peer.__doc__}", file=sys.stderr)
    return found


def main():
    records = json.load(open(sys.argv[1]))
    found, stopped, wrong = peers(), set(), 0
    header = ["quantity", "argument", "subcert"] + [peer.name for peer in found]
    print("| " + " | ".join(header) + " |")
    print("|---|--:" + "|--:" * (len(found) + 1) + "|")
    for record in records:
        kind, own = record["kind"], record["seconds"]
        cells = []
        for peer in found:
            method = getattr(peer, kind.replace(" ", "_"), None)
            if method is None or (peer.name, kind) in stopped:
                cells.append("")
                continue
            begin = time.perf_counter()
            if isinstance(peer, Pari):
                value, seconds = method(record)
            else:
                value, seconds = timed(lambda: method(record))
            if value != record["value"]:
                print(f"{peer.name} differs: {kind} {record['argument']}", file=sys.stderr)
                wrong += 1
            if time.perf_counter() - begin > TOO_LONG:
                stopped.add((peer.name, kind))
            cells.append(two_digits(seconds / own))
        if "walk_seconds" in record:
            cells[0] += f" (our walk of every row: {two_digits(record['walk_seconds'] / own)})"
        print("| " + " | ".join([kind, record["argument"], duration(own), *cells]) + " |")
    if wrong:
        sys.exit(f"{wrong} values differ")
    print(f"\nAll values agree. Times of the peers as multiples of ours; empty: not offered, or"
          f" a smaller argument took more than {TOO_LONG:.0f} s.")


main()
