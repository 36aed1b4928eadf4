"""TDMS, the format of LabVIEW: the channels of a group."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from pam_cosim.errors import InputError
from pam_cosim.libraries import library
from pam_cosim.measurement.table import TIME, Layout, Table, check_count, reading, table_of
from pam_cosim.wording import listed, shown


def read_tdms(file: Path, stated: Layout) -> Table:
    """The channels of the group that is stated, or of the only one; time from their increment where none is a channel.

    Raises:
        InputError: the library is not installed, not such a file, several groups, channels of unlike length.
    """
    reader = library("nptdms", file).TdmsFile
    # The reader lets out whatever a broken file makes of it.
    with reading(file, "TDMS", Exception):
        declared = reader.read_metadata(file).groups()
        check_count(sum(len(channel) for group in declared for channel in group.channels()), file)
        groups = {group.name: group for group in reader.read(file).groups() if group.channels()}
    group_names = [stated.table] if stated.table is not None else list(groups)
    if len(group_names) != 1 or group_names[0] not in groups:
        reason = "" if stated.table is None else f"there is no group {shown(stated.table)}; "
        raise InputError(
            f"{reason}state one of {listed(groups)} under [recording], as table = ...", file
        )
    channels: list[Any] = groups[group_names[0]].channels()
    units = [str(channel.properties.get("unit_string", "") or "") for channel in channels]
    vectors = [
        (channel.name, unit, channel[:]) for channel, unit in zip(channels, units, strict=True)
    ]
    table = table_of(vectors, stated, file)
    increments = {
        float(channel.properties.get("wf_increment", 0.0) or 0.0) for channel in channels
    } - {0.0}
    is_timed = TIME in table.columns or len(increments) != 1
    return table if is_timed else table.with_time(increments.pop())
