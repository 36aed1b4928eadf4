"""TDMS, the format of LabVIEW: the channels of a group."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from pam_cosim.errors import InputError
from pam_cosim.measurement.table import (
    TIME,
    Column,
    Layout,
    Table,
    check_count,
    headed,
    reading,
    same_length,
    since_first,
)
from pam_cosim.wording import listed, shown


def read_tdms(file: Path, stated: Layout) -> Table:
    """The channels of the group that is stated, or of the only one; time from their increment where none is a channel.

    Raises:
        InputError: the library is not installed, not such a file, several groups, channels of unlike length.
    """
    try:
        from nptdms import TdmsFile
    except ImportError:
        message = "reading TDMS needs npTDMS: pip install 'pam-cosim[tdms]', or export the recording as CSV"
        raise InputError(message, file) from None
    # The reader lets out whatever a broken file makes of it.
    with reading(file, "TDMS", Exception):
        declared = TdmsFile.read_metadata(file).groups()
        check_count(sum(len(one) for group in declared for one in group.channels()), file)
        groups = {group.name: group for group in TdmsFile.read(file).groups() if group.channels()}
    wanted = [stated.table] if stated.table is not None else list(groups)
    if len(wanted) != 1 or wanted[0] not in groups:
        said = "" if stated.table is None else f"there is no group {shown(stated.table)}; "
        raise InputError(
            f"{said}state one of {listed(groups)} under [recording], as table = ...", file
        )
    return Table(file, same_length(_columns(groups[wanted[0]].channels(), stated, file), file))


def _columns(channels: list[Any], stated: Layout, file: Path) -> Iterator[Column]:
    columns = [
        column for channel in channels if (column := _column(channel, stated, file)) is not None
    ]
    increments = {float(c.properties.get("wf_increment", 0.0) or 0.0) for c in channels} - {0.0}
    if len(increments) == 1 and columns and all(column.name != TIME for column in columns):
        yield Column(
            TIME, "s", increments.pop() * np.arange(len(columns[0].values), dtype=np.float64), TIME
        )
    yield from columns


def _column(channel: Any, stated: Layout, file: Path) -> Column | None:
    name, unit = headed(channel.name, str(channel.properties.get("unit_string", "") or ""), file)
    if not stated.keeps(channel.name, name):
        return None
    values = np.asarray(channel[:])
    if values.dtype.kind == "M":
        return Column(name, "s", since_first(values), channel.name)
    if values.dtype.kind not in "fiu":
        raise InputError(
            "it holds no numbers; leave it out: [recording] ignore = [...]", file, None, name
        )
    return Column(name, unit, values.astype(float), channel.name)
