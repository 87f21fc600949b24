"""The exception that this module raises."""

from __future__ import annotations

from typing import Optional


class SubcertError(ValueError):
    """Something that was given is not what it has to be, or is beyond a cap.

    ``message`` says what is wrong, ``place`` where (file, line and column), and ``remedy`` what would
    be right; the last two are None where there is none to tell.

    >>> from subcert import Scheme
    >>> try:
    ...     Scheme("chaikin").contraction(0)
    ... except SubcertError as error:
    ...     print(error.message)
    c is 0
    """

    def __init__(
        self, message: str, place: Optional[str] = None, remedy: Optional[str] = None
    ) -> None:
        self.message, self.place, self.remedy = message, place, remedy
        text = message if place is None else f"{place}: {message}"
        super().__init__(text if remedy is None else f"{text}; {remedy}")
