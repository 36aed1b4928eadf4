"""An FMU that carries the recordings it was judged by: written, read by others' tools, damaged, judged again."""

from __future__ import annotations

import json
import shutil
import zipfile
from collections.abc import Callable
from pathlib import Path

import fmpy
import numpy as np
import pytest
from fmpy import simulate_fmu
from fmpy.ssp.ssd import read_ssv
from fmpy.validation import validate_fmu
from lxml import etree

import pam_cosim as pam
from pam_cosim.fmu.related_files import FOLDER, related_files
from tests.cli.conftest import ROOT, Outcome
from tests.cli.test_commands import done

Command = Callable[..., Outcome]
SCHEMA = ROOT / "tests" / "fmu" / "schemas" / "fmi3LayeredStandardReferenceManifest.xsd"
MANIFEST = FOLDER + "fmi-ls-manifest.xml"
VESSEL = ROOT / "examples" / "tank-discharge"


class _Local(etree.Resolver):
    """The schemas that the manifest's includes, which it names by an address, are those that FMPy brings."""

    def resolve(self, url: str, public_id: str, context: object) -> object:
        if url.startswith("https:"):
            here = Path(fmpy.__file__).parent / "schema" / "fmi3" / url.rpartition("/")[2]
            return self.resolve_filename(str(here), context)
        return None


def schema() -> etree.XMLSchema:
    parser = etree.XMLParser()
    parser.resolvers.add(_Local())
    return etree.XMLSchema(etree.parse(str(SCHEMA), parser))


@pytest.fixture(scope="module")
def judged(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The vessel with the values of a fit."""
    folder = tmp_path_factory.mktemp("judged")
    pam.save(pam.fit(pam.read(VESSEL)), folder / "fit.npz")
    pam.build_with_data(VESSEL, folder / "Vessel.fmu", fit=folder / "fit.npz")
    return folder / "Vessel.fmu"


def rewritten(
    source: Path, target: Path, change: Callable[[str, bytes], tuple[str, bytes] | None]
) -> Path:
    with zipfile.ZipFile(source) as old, zipfile.ZipFile(target, "w") as new:
        for name in old.namelist():
            kept = change(name, old.read(name))
            if kept is not None:
                new.writestr(*kept)
    return target


def test_others_read_it(judged: Path, tmp_path: Path) -> None:
    assert validate_fmu(str(judged)) == []
    with zipfile.ZipFile(judged) as archive:
        manifest = etree.fromstring(archive.read(MANIFEST))
        values = read_ssv(archive.extract(FOLDER + "fitted.ssv", tmp_path))
        schema().assertValid(manifest)
        sources = {one.get("source"): one.get("role") for one in manifest.iter("Related")}
        assert {FOLDER + source for source in sources} <= set(archive.namelist())
    assert sources["fitted.ssv"] == "parameter"
    assert (
        sources["recordings/experiment.toml"]
        == sources["recordings/discharge.csv"]
        == "experiment/validation"
    )
    fitted = {one.name: float(one.value) for one in values.parameters}
    assert {"orifice.C_d", "tank.n"} < set(fitted)
    assert fitted["tank.V"] == pytest.approx(0.01618), (
        "what the data set states of the rig goes along"
    )
    alone, applied = (
        simulate_fmu(str(judged), start_values=start, stop_time=20.0) for start in ({}, fitted)
    )
    other = simulate_fmu(str(judged), start_values={"orifice.C_d": 0.6}, stop_time=20.0)
    np.testing.assert_array_equal(alone["p"], applied["p"])
    assert np.abs(other["p"] - alone["p"]).max() > 1e3


def test_the_judgement_is_repeated_from_what_is_inside(
    judged: Path, command: Command, place: Path
) -> None:
    shutil.copy(judged, place / "thing.fmu")
    said = done(command("compare", "thing.fmu", "--json", "again.json"))
    assert "The judgement is repeated" in said.out
    again = json.loads((place / "again.json").read_text())["signals"]["p"]["rmse"]
    fitted = pam.load(judged.with_name("fit.npz")).comparison
    assert again == pytest.approx(fitted.scores["fit"]["p"].rmse, rel=1e-4)
    assert "p 8.41 kPa" in str(pam.evidence(place / "thing.fmu"))


@pytest.mark.full
def test_other_recordings_are_noticed(judged: Path, command: Command, place: Path) -> None:
    """A judgement that says it is repeated whatever is inside would be none."""

    def change(name: str, content: bytes) -> tuple[str, bytes]:
        return name, content.replace(b"2.71 mm", b"2.91 mm") if name.endswith(
            "experiment.toml"
        ) else content

    rewritten(judged, place / "thing.fmu", change)
    said = command("compare", "thing.fmu")
    assert said.status == 1 and "The judgement is NOT repeated" in said.out


def test_files_that_lie_elsewhere_are_not_taken(judged: Path, tmp_path: Path) -> None:
    """A manifest is data: what it names never becomes a path outside."""

    def change(name: str, content: bytes) -> tuple[str, bytes]:
        moved = content.replace(
            b'"recordings/discharge.csv"', b'"recordings/../../../../outside.csv"'
        )
        return name, moved if name == MANIFEST else content

    damaged = rewritten(judged, tmp_path / "a.fmu", change)
    assert not [file.name for file in related_files(damaged) if "outside" in file.name]
    with pytest.raises(pam.InputError, match="discharge.csv"):
        pam.evidence(damaged)


@pytest.mark.parametrize(
    ("damage", "message"),
    [
        (
            lambda name, content: None if "fmi-ls-ref" in name else (name, content),
            "carries no recordings",
        ),
        (lambda name, content: (name, b"<no" if name == MANIFEST else content), "is not XML"),
        (
            lambda name, content: (name, b"{}" if name.endswith("judgement.json") else content),
            "model",
        ),
    ],
)
def test_what_is_damaged_is_said(
    judged: Path, damage: object, message: str, command: Command, place: Path
) -> None:
    rewritten(judged, place / "thing.fmu", damage)  # type: ignore[arg-type]
    outcome = command("compare", "thing.fmu")
    assert outcome.status == 2 and message in outcome.err and "thing.fmu" in outcome.err


def test_what_cannot_be_asked_for(command: Command, place: Path) -> None:
    for words, message in {
        ("--fit", "fitted.json", "-o", "a.fmu"): "--with-data",
        ("--with-data", str(VESSEL), "-o", "folder"): "one FMU",
        ("--with-data", str(VESSEL), "-o", "a.fmu", "--diagnosis", "none.npz"): "none.npz",
    }.items():
        outcome = command("build", *words)
        assert outcome.status == 2 and message in outcome.err
    assert list(place.iterdir()) == []


@pytest.mark.full
def test_a_diagnosis_goes_along(command: Command, place: Path) -> None:
    done(command("diagnose", str(VESSEL), "--save", "d.npz"))
    written = done(
        command("build", "--with-data", str(VESSEL), "--diagnosis", "d.npz", "-o", "thing.fmu")
    )
    assert "identified: gas_energy (EnergyGas)" in written.out
    said = done(command("compare", "thing.fmu")).out
    assert "The judgement is repeated" in said and "1.96 kPa" in said
    assert "EnergyGas" in pam.evidence("thing.fmu").effects
