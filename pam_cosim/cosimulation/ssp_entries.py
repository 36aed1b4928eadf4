"""The files in an archive of SSP, and XML documents among them that are valid by SSP 1.0 or 2.0."""

from __future__ import annotations

import posixpath
import zipfile
from collections import Counter
from functools import cache
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlsplit

from fmpy.ssp.ssd import validate_tree
from lxml import etree

from pam_cosim.cosimulation.ssp_names import NAMESPACES
from pam_cosim.errors import InputError
from pam_cosim.fmu.read import check_document
from pam_cosim.wording import shown

_MOST_BYTES = 2 << 30  # of one entry of an archive, unpacked


class SspEntries:
    """The files in an archive, by their names there."""

    def __init__(self, archive: zipfile.ZipFile, file: Path) -> None:
        self._archive, self.file = archive, file
        self._known = set(archive.namelist())
        if len(self._known) < len(archive.namelist()):
            twice = next(n for n, count in Counter(archive.namelist()).items() if count > 1)
            raise InputError(f"the archive has two files {shown(twice)}", file)

    def read(self, source: str, what: str) -> bytes:
        """The content of the entry that a relative URI names.

        Raises:
            InputError: it is not in the archive, or too large.
        """
        return self._archive.read(self._name(source, what))

    def _name(self, source: str, what: str) -> str:
        """The entry that a relative URI names."""
        parts = urlsplit(source)
        name = posixpath.normpath(unquote(parts.path))
        if parts.scheme or parts.netloc or name.startswith(("/", "..")) or name not in self._known:
            raise InputError(f"{what} is {shown(source)}, which is not in the archive", self.file)
        if self._archive.getinfo(name).file_size > _MOST_BYTES:
            raise InputError(f"{shown(name)} has more than {_MOST_BYTES >> 30} GiB", self.file)
        return name

    def tree(self, source: str, what: str, schema: str) -> Any:
        """An XML document, valid by the standard's schema.

        Raises:
            InputError: it is none, too large, or not valid.
        """
        check_document(self._archive, self._name(source, what), self.file)
        parser = etree.XMLParser(resolve_entities=False, no_network=True, load_dtd=False)
        try:
            root = etree.fromstring(self.read(source, what), parser)
        except etree.XMLSyntaxError as problem:
            raise InputError(f"{shown(source)} is not XML: {problem}", self.file) from problem
        if root.getroottree().docinfo.doctype:
            raise InputError(
                f"{shown(source)} declares a document type, which SSP does not have", self.file
            )
        version, fault_in = (
            ("2.0", _later_fault) if root.get("version") == "2.0" else ("1.0", _first_fault)
        )
        fault = fault_in(root, schema)
        if fault:
            raise InputError(f"{shown(source)} is not valid by SSP {version}: {fault}", self.file)
        if next(root.iter(f"{{{NAMESPACES['ssc']}}}Dimension"), None) is not None:
            raise InputError(f"{shown(source)} has arrays; only single numbers are read", self.file)
        return root


def _first_fault(root: Any, schema: str) -> str:
    """What is wrong by SSP 1.0; empty: nothing."""
    try:
        validate_tree(root, schema)
    except Exception as problem:  # FMPy raises it bare
        return str(problem).split("\n")[-1]
    return ""


def _later_fault(root: Any, schema: str) -> str:
    """What is wrong by SSP 2.0; empty: nothing."""
    read = _later_schema(schema)
    return "" if read.validate(root) else str(read.error_log[-1].message)


@cache
def _later_schema(name: str) -> etree.XMLSchema:
    """A schema of SSP 2.0.1, as the project published it under the 2-Clause BSD licence."""
    return etree.XMLSchema(file=str(Path(__file__).parent / "ssp_schema" / name))
