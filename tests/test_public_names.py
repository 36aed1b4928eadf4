"""``dir``, completion and ``help`` show the public functions, each with a line."""

from __future__ import annotations

from types import ModuleType

import pytest

import pam_cosim as pam
from pam_cosim import study


@pytest.mark.parametrize("package", [pam, study])
def test_every_public_name_is_listed_with_a_line(package: ModuleType) -> None:
    assert dir(package) == sorted(package.__all__)
    listed = [line.split(maxsplit=1) for line in (package.__doc__ or "").splitlines()]
    lines = {parts[0]: parts[1] for parts in listed if len(parts) == 2 and parts[0] in dir(package)}
    assert sorted(lines) == dir(package) and all(len(line) > 10 for line in lines.values())


def test_every_public_name_is_loaded_from_its_module() -> None:
    for name in dir(pam):
        assert getattr(pam, name).__name__ == name
    with pytest.raises(AttributeError, match="module 'pam_cosim' has no attribute 'reed'"):
        _ = pam.reed
