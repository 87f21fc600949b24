"""Audits as Python objects."""

from fractions import Fraction

import pytest

import subcert
from subcert import SubcertError

CLAIMS = '''
[paper]
key = "mine"
'''


def test_papers():
    assert "khan2019-newton" in subcert.papers()
    found = subcert.audit("khan2019-newton")
    assert sum(found.summary.values()) == len(found) == len(found.findings)
    cells = [x for x in found if x.kind == "number"]
    assert cells[0].exact == Fraction(1, 400) and cells[0].verdict == "confirmed"
    frame = found.to_pandas()
    assert list(frame.index) == [x.id for x in found]
    assert (frame.verdict == "confirmed").sum() == found.summary["confirmed"]
    page = found._repr_html_()
    assert page.count("<tr>") == len(found) + 1 and "<script" not in page


def test_a_wrong_file_has_a_place(tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text(CLAIMS)
    with pytest.raises(SubcertError) as caught:
        subcert.audit(path)
    error = caught.value
    assert error.place.startswith(f"{path}:") and error.message
    with pytest.raises(SubcertError, match="no claim file"):
        subcert.audit("nowhere.toml")
