"""A sweep of 1,000 masks over the processes of a cluster: which 4-point rules shrink differences most?

    pip install ./python pandas 'dask[distributed]'
    python python/examples/sweep.py [ADDRESS]

Without the address of a scheduler, a local cluster of processes is started. With one, the same code runs there; its
workers need the module. Schemes go to the workers, and answers come back, as they are.
"""

import sys
from fractions import Fraction

import pandas
from dask.distributed import Client, LocalCluster

from subcert import Scheme


def four_point(left, right):
    """Interpolating rules with a tension on each side, in units of 1/200; they need not be symmetric."""
    w, v = Fraction(left, 200), Fraction(right, 200)
    half = Fraction(1, 2)
    return Scheme(mask=[[0, 1, 0, 0], [-w, half + w, half + v, -v]], offset=-1)


def constants(scheme):
    """What is computed of each mask: exact constants."""
    return scheme, scheme.constants(3)


def smoothness(scheme):
    """What is computed of the best ones: how smooth the limits are."""
    return scheme, scheme.smoothness()


def swept(client, work, schemes, size):
    """The work on each scheme, by the workers. Many small tasks cost more than they do: each has several masks."""
    parts = [schemes[i : i + size] for i in range(0, len(schemes), size)]
    futures = client.map(lambda part: [work(scheme) for scheme in part], parts)
    return dict(answer for part in client.gather(futures) for answer in part)


def main(address=None):
    schemes = [four_point(i, j) for i in range(40) for j in range(25)]
    cluster = None if address else LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None)
    with Client(address or cluster) as client:
        # The keys are schemes that came back: they are equal to those that were sent.
        found = swept(client, constants, schemes, 50)
        rows = [{"scheme": scheme, **found[scheme].rows()[-1]} for scheme in schemes]
        table = pandas.DataFrame(rows).sort_values("contraction", kind="stable")
        best = table.head(20).copy()
        smooth = swept(client, smoothness, list(best.scheme), 5)
        best["continuity"] = [smooth[scheme].continuity for scheme in best.scheme]
    if cluster is not None:
        cluster.close()

    print(f"{len(table)} masks. The least T_3:")
    for row in best.head(5).itertuples():
        print(f"  {row.contraction}, C^{row.continuity}: {row.scheme}")
    return table


if __name__ == "__main__":
    main(*sys.argv[1:])
