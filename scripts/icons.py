"""Draws icons and diagrams of the Modelica library from its annotations (Modelica 3.6, chapter 18).

python -m scripts.icons picture.png PneumaticMuscle.Benches.Isotonic     # the diagram of one class
python -m scripts.icons picture.png PneumaticMuscle.Effects              # the icons of all classes of a package
python -m scripts.icons picture.png MyRig.mo                             # the diagram of a model in a file
"""

from __future__ import annotations

import sys
from pathlib import Path

from pam_cosim.fmu.drawing import Pictures, diagram, gallery
from pam_cosim.model.references import is_modelica


def main() -> None:
    """Writes one picture."""
    file, *names = sys.argv[1:]
    pictures = Pictures([Path(name) for name in names if is_modelica(name)])
    names = [Path(name).stem if is_modelica(name) else name for name in names]
    kinds = [pictures.of(name).definition for name in names]
    if len(kinds) == 1 and kinds[0].kind == "package":
        names = [node.qualified_name for node in kinds[0].classes.values()]
    figure = (
        diagram(pictures, names[0])
        if [k.kind for k in kinds] == ["model"]
        else gallery(pictures, names)
    )
    figure.savefig(file, dpi=110)


if __name__ == "__main__":
    main()
