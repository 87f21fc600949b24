"""The fixtures that pytest finds by itself."""

import pytest


@pytest.fixture
def subcert_oracle():
    """Exact reference values: see ``subcert.testing.OracleValues``."""
    from .testing import OracleValues

    return OracleValues()
