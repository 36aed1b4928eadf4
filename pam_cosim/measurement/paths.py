"""Files that a data set names: relative, and inside its folder even after symbolic links."""

from __future__ import annotations

from pathlib import Path, PureWindowsPath

from pam_cosim.measurement.experiment import ExperimentFile
from pam_cosim.wording import shown


def file_inside(document: ExperimentFile, name: str, *path: str | int) -> Path:
    """The file called ``name`` in the document at the key ``path``.

    Raises:
        InputError: the path leaves the folder, or no file is there.
    """
    folder = document.file.parent
    windows = PureWindowsPath(name)  # Also refuses C:\\x and ..\\x, wherever the data set is read.
    try:
        root, target = folder.resolve(), (folder / name).resolve()
        leaves = (
            windows.anchor
            or ".." in windows.parts
            or not target.is_relative_to(root)
            or target == root
        )
        exists, is_file = target.exists(), target.is_file()
    except (OSError, ValueError, RuntimeError) as error:
        reason = getattr(error, "strerror", None) or "its name cannot be used"
        raise document.error(f"the file {shown(name)} cannot be found: {reason}", *path) from None
    if leaves:
        message = f"the path {shown(name)} leaves the folder of the data set; name a file inside"
        raise document.error(message, *path)
    if not is_file:
        reason = "is not a file" if exists else "does not exist"
        raise document.error(f"the file {shown(name)} {reason} in {folder}", *path)
    return folder / name
