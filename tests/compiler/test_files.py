"""Files of the user's."""

from pathlib import Path

import pytest

from pam_cosim.catalogue import benches, full_name
from pam_cosim.compiler import compile_model, flat_hash, read_library
from pam_cosim.errors import ModelError
from tests.compiler.run import MODELS


def test_a_file_named_twice_or_in_two_ways_is_one_file(tmp_path: Path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    file = tmp_path / "Own.mo"
    file.write_text(
        "model Own\n  Real x(start=1, fixed=true);\nequation\n  der(x) = -x;\nend Own;\n"
    )
    (tmp_path / "link.mo").symlink_to(file)
    ways = [Path("Own.mo"), file, Path("./Own.mo"), Path("link.mo"), Path("Own.mo")]
    assert "Own" in read_library(MODELS, ways).classes
    for model in ("Own", "Own.mo", str(file), "./Own.mo", "link.mo"):
        assert compile_model(model, files=ways, root=MODELS).interface.model == "Own"


def make_package(folder: Path, start: int = 1) -> Path:
    """A library with a bench, in the folder Own: as Modelica keeps packages in folders."""
    for sub, text in {
        "package.mo": "package Own\nend Own;\n",
        "Interfaces/package.mo": "within Own;\npackage Interfaces\nend Interfaces;\n",
        "Interfaces/Effect.mo": "within Own.Interfaces;\npartial model Effect\nend Effect;\n",
        "Benches/package.mo": "within Own;\npackage Benches\nend Benches;\n",
        "Benches/Fall.mo": f"within Own.Benches;\nmodel Fall\n  output Real x(start={start}, fixed=true);\n"
        "equation\n  der(x) = -x;\nend Fall;\n",
    }.items():
        file = folder / "Own" / sub
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    return folder / "Own"


@pytest.mark.parametrize("way", ("folder", "package.mo"))
def test_a_package_is_named_by_its_folder_or_its_package_file(
    tmp_path: Path, monkeypatch, way: str
) -> None:
    package = make_package(tmp_path)
    monkeypatch.chdir(package)
    files = (
        [package, Path(".")] if way == "folder" else [package / "package.mo", Path("package.mo")]
    )
    tree = read_library(files=files)
    assert benches(tree)[-1] == "Own.Benches.Fall" and benches(tree)[0] != benches(tree)[-1]
    for name in ("Fall", "Benches.Fall", "Own.Benches.Fall"):
        assert full_name(name, files) == "Own.Benches.Fall"
    assert compile_model("Own.Benches.Fall", files=files).states[0].start == 1


def test_a_change_in_a_package_is_seen(tmp_path: Path) -> None:
    package = make_package(tmp_path)
    before = flat_hash("Own.Benches.Fall", files=[package])
    assert compile_model("Own.Benches.Fall", files=[package]).states[0].start == 1
    make_package(tmp_path, start=27)
    assert compile_model("Own.Benches.Fall", files=[package]).states[0].start == 27
    assert flat_hash("Own.Benches.Fall", files=[package]) != before
    make_package(tmp_path / "elsewhere", start=27)
    same = flat_hash("Own.Benches.Fall", files=[tmp_path / "elsewhere" / "Own"])
    assert same == flat_hash("Own.Benches.Fall", files=[package]), (
        "where a package lies makes no difference"
    )


def test_a_folder_that_is_no_package_and_a_name_that_is_taken(tmp_path: Path) -> None:
    with pytest.raises(ModelError, match="no Modelica package"):
        read_library(files=[tmp_path])
    package = make_package(tmp_path)
    (tmp_path / "Own.mo").write_text("model Own\nend Own;\n")
    with pytest.raises(ModelError, match="exists already"):
        read_library(files=[tmp_path / "Own.mo", package])
    with pytest.raises(ModelError, match="within"):
        read_library(files=[package / "Benches"])


@pytest.mark.parametrize("name", ["Real", "String", "StateSelect"])
def test_names_of_the_language_are_taken(tmp_path: Path, name: str) -> None:
    file = tmp_path / f"{name}.mo"
    file.write_text(f"\nmodel {name}\n  parameter Integer n = 1;\nend {name};\n")
    with pytest.raises(ModelError, match=f"a class '{name}' exists already") as raised:
        read_library(files=[file])
    assert (raised.value.file, raised.value.line) == (file, 2)


def test_two_classes_of_one_name_are_refused_wherever_they_stand(tmp_path: Path) -> None:
    """The last one used to be taken, without a word."""
    (tmp_path / "Two.mo").write_text("model Two\nend Two;\nmodel Two\n  Real x = 1;\nend Two;\n")
    with pytest.raises(ModelError, match="'Two' is declared twice") as raised:
        read_library(files=[tmp_path / "Two.mo"])
    assert raised.value.line == 3
    package = make_package(tmp_path)
    other = package / "Benches" / "Other.mo"
    other.write_text("within Own.Benches;\nmodel Fall\nend Fall;\n")
    with pytest.raises(ModelError, match="a class 'Own.Benches.Fall' exists already"):
        read_library(files=[package])
    other.rename(tmp_path / "Other.mo")
    with pytest.raises(ModelError, match="a class 'Own.Benches.Fall' exists already"):
        read_library(files=[package, tmp_path / "Other.mo"])
    assert read_library(files=[package, package / "Benches" / "Fall.mo"])  # the same file once more
