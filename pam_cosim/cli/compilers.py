"""The option --compiler of all commands that take a model: which program reads its Modelica."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import wraps
from inspect import Parameter, signature
from pathlib import Path
from typing import Annotated, Any

import typer

from pam_cosim.errors import InputError
from pam_cosim.model.references import is_fmu
from pam_cosim.wording import shown

_COMPILERS = ("own", "omc")
_OPTION = Annotated[
    str,
    typer.Option(
        "--compiler",
        help="Compiler that flattens a Modelica model: own (this program), or omc (OpenModelica, if it is installed).",
    ),
]


def with_compiler(command: Callable[..., None]) -> Callable[..., None]:
    """The command with that option, if it takes a model and Modelica files: it gets the flat model as a file."""
    stated = signature(command, eval_str=True)
    named = {"model", "models", "files"} & stated.parameters.keys()
    if "files" not in named or len(named) < 2:
        return command
    option = Parameter("compiler", Parameter.KEYWORD_ONLY, default="own", annotation=_OPTION)
    parameters = [*stated.parameters.values(), option]

    @wraps(command)
    def called(compiler: str = "own", **given: Any) -> None:
        if compiler not in _COMPILERS:
            raise InputError(f"there is no compiler {shown(compiler)}; write own or omc")
        if compiler == "omc":
            files = given["files"] or []
            if "models" in given:
                given["models"] = [_flat(model, files) for model in given["models"] or ()]
            else:
                given["model"] = _flat(given["model"] or _model_of(given.get("data")), files)
        command(**given)

    called.__signature__ = stated.replace(parameters=parameters)  # type: ignore[attr-defined]
    called.__annotations__ = {parameter.name: parameter.annotation for parameter in parameters}
    return called


def _flat(model: str, files: Sequence[Path]) -> str:
    from pam_cosim.catalogue import full_name
    from pam_cosim.compiler.openmodelica import flat_model

    return model if is_fmu(model) else str(flat_model(full_name(model, files), files))


def _model_of(data: Path | None) -> str:
    """The model that a data set states."""
    from pam_cosim.toml_text import parse_toml

    file = Path() if data is None else data / "experiment.toml"
    stated = parse_toml(file.read_text(encoding="utf-8"), file) if file.is_file() else {}
    model = stated.get("model")
    if not isinstance(model, str):
        raise InputError("--compiler omc needs the name of a model: add --model NAME")
    return str(file.parent / model) if (file.parent / model).is_file() else model
