"""The words of a field: of the library that a model is made from, and kept by what they were read from."""

from __future__ import annotations

from pathlib import Path

import pytest

from pam_cosim.catalogue import domain_of, known_domain
from pam_cosim.compiler import read_library
from pam_cosim.errors import ModelError

ANOTHER = """within;
package Motors "Motors"
  record Domain
    constant String balances[:] = {"torque"};
    constant String confused[:, 3] = {{"torque", "voltage", "Both will do."}};
  end Domain;
  model Bench
    Real x(start = 1);
  equation
    der(x) = -x;
  end Bench;
end Motors;
"""


@pytest.fixture
def file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr("pam_cosim.cache.cache_dir", lambda: tmp_path / "cache")
    file = tmp_path / "Motors.mo"
    file.write_text(ANOTHER)
    return file


@pytest.mark.parametrize("model", ["Isotonic", "TankFilling", "nobody's"])
def test_what_is_kept_is_what_was_read(file: Path, model: str) -> None:
    expected = domain_of(read_library(), model)
    assert [known_domain(model), known_domain(model)] == [expected, expected]
    assert expected.balances and all(len(row) == 4 for row in expected.phases)


def test_the_library_is_read_once_until_a_file_changes(
    file: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first = known_domain("Motors.Bench", [file])
    assert first.balances == ("torque",) and first.confused[0][2] == "Both will do."
    with monkeypatch.context() as without:
        without.setattr("pam_cosim.catalogue.domain.read_library", None)
        assert known_domain("Motors.Bench", [file]) == first
    file.write_text(ANOTHER.replace('{"torque"}', '{"torque", "heat"}'))
    assert known_domain("Motors.Bench", [file]).balances == ("torque", "heat")


def test_a_faulty_record_is_named_each_time(file: Path) -> None:
    file.write_text(ANOTHER.replace('{{"torque", "voltage", "Both will do."}}', '{{"torque"}}'))
    for _ in range(2):
        with pytest.raises(ModelError, match="confused must be rows of 3 texts"):
            known_domain("Motors.Bench", [file])


def test_what_an_fmu_calls_itself_is_no_file(file: Path, tmp_path: Path) -> None:
    other = tmp_path / "Other.mo"
    other.write_text("faulty")
    assert known_domain(str(other)) == known_domain("nobody's")
