"""Files of the user's."""

from pathlib import Path

from pam_cosim.compiler import compile_model, read_library
from tests.compiler.run import MODELS


def test_a_file_named_twice_or_in_two_ways_is_one_file(tmp_path: Path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    file = tmp_path / "Own.mo"
    file.write_text("model Own\n  Real x(start=1, fixed=true);\nequation\n  der(x) = -x;\nend Own;\n")
    (tmp_path / "link.mo").symlink_to(file)
    ways = [Path("Own.mo"), file, Path("./Own.mo"), Path("link.mo"), Path("Own.mo")]
    assert "Own" in read_library(MODELS, ways).classes
    for model in ("Own", "Own.mo", str(file), "./Own.mo", "link.mo"):
        assert compile_model(model, files=ways, root=MODELS).interface.model == "Own"
