"""Files that belong to an FMU and lie in it, each with its role: the layered standard FMI-LS-REF 1.0.0-alpha.1.

https://github.com/modelica/fmi-ls-ref: a folder of the archive, and a manifest that says what the files are.
"""

from __future__ import annotations

import io
import posixpath
import zipfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from urllib.parse import quote, unquote, urlsplit

from lxml import etree

from pam_cosim.errors import InputError
from pam_cosim.files import MOST_BYTES, read_file
from pam_cosim.fmu.build import archived
from pam_cosim.fmu.read import DAMAGED, check_document

FOLDER = "extra/org.fmi-standard.fmi-ls-ref/"
_MANIFEST = FOLDER + "fmi-ls-manifest.xml"
_SPACE = "http://fmi-standard.org/fmi-ls-manifest"
_ABOUT = {
    "name": "org.fmi-standard.fmi-ls-ref",
    "version": "1.0.0-alpha.1",
    "description": "Layered Standard providing information on related files included in an FMU.",
}
_ROOT, _RELATED = "fmiReferences", "Related"


@dataclass(frozen=True)
class RelatedFile:
    """A file in an FMU.

    Attributes:
        name: within the folder of the standard, with slashes.
        role: of the standard, such as "parameter" or "experiment/validation".
        type: its MIME type.
        description: for people.
        content: its bytes.
    """

    name: str
    role: str
    type: str
    description: str
    content: bytes


def with_related_files(fmu: bytes, files: Sequence[RelatedFile]) -> bytes:
    """The archive of an FMU with further files in it.

    Args:
        fmu: the archive, which has none of that standard yet.
        files: with names that are all different.
    """
    with zipfile.ZipFile(io.BytesIO(fmu)) as archive:
        content = {
            entry.filename: archive.read(entry)
            for entry in archive.infolist()
            if not entry.is_dir()
        }
    content |= {FOLDER + file.name: file.content for file in files}
    return archived(content | {_MANIFEST: _manifest(files)})


def _manifest(files: Sequence[RelatedFile]) -> bytes:
    root = etree.Element(_ROOT, nsmap={"fmi-ls": _SPACE})
    for key, text in _ABOUT.items():
        root.set(f"{{{_SPACE}}}fmi-ls-{key}", text)
    for file in files:
        described = {
            "type": file.type,
            "source": quote(file.name),
            "role": file.role,
            "description": file.description,
        }
        etree.SubElement(root, _RELATED, described)
    written: bytes = etree.tostring(root, xml_declaration=True, encoding="UTF-8", pretty_print=True)
    return written


def related_files(fmu: Path) -> list[RelatedFile]:
    """The files that an FMU's manifest names and that are in it; none where it has no manifest.

    Raises:
        InputError: no archive, a manifest that is none or too large, or files of more than 2 GB.
    """
    try:
        with zipfile.ZipFile(io.BytesIO(read_file(fmu))) as archive:
            if _MANIFEST not in archive.namelist():
                return []
            return _listed(archive, fmu)
    except OSError as problem:
        raise InputError(f"cannot be read: {problem.strerror or problem}", fmu) from problem
    except (*DAMAGED, ValueError) as problem:
        raise InputError(f"is no FMU that can be read: {problem}", fmu) from problem


def _listed(archive: zipfile.ZipFile, fmu: Path) -> list[RelatedFile]:
    if (
        sum(entry.file_size for entry in archive.infolist() if entry.filename.startswith(FOLDER))
        > MOST_BYTES
    ):
        raise InputError("the files that belong to it are larger than 2 GB", fmu)
    check_document(archive, _MANIFEST, fmu)
    parser = etree.XMLParser(resolve_entities=False, no_network=True, load_dtd=False)
    try:
        root = etree.fromstring(archive.read(_MANIFEST), parser)
    except etree.XMLSyntaxError as problem:
        raise InputError(f"{_MANIFEST} is not XML: {problem.msg}", fmu) from problem
    if root.tag != _ROOT:
        raise InputError(f"{_MANIFEST} is no manifest of {_ABOUT['name']}", fmu)
    found, held = [], set(archive.namelist())
    contents: dict[str, bytes] = {}  # read once, however often the manifest names it
    for element in root.iter(_RELATED):
        name = _name(element.get("source", ""))
        if (
            FOLDER + name in held
        ):  # the standard: a tool that knows nothing of it may have taken files away
            kind = element.get("type", "application/octet-stream")
            if name not in contents:
                contents[name] = archive.read(FOLDER + name)
            found.append(
                RelatedFile(
                    name,
                    element.get("role", ""),
                    kind,
                    element.get("description", ""),
                    contents[name],
                )
            )
    return found


def _name(source: str) -> str:
    """The name within the folder; empty for what lies elsewhere."""
    if urlsplit(source).scheme or "\\" in source or "\0" in source:
        return ""
    name = posixpath.normpath(unquote(source))
    leads_elsewhere = name.startswith(("/", "..")) or any(sign in name for sign in ":\\\0")
    return "" if leads_elsewhere else name
