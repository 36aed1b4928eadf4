"""Records in a file of SQLite that survive every stop; a record that was damaged does not count."""

from __future__ import annotations

import hashlib
import json
import sqlite3
import weakref
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from pam_cosim.errors import InputError
from pam_cosim.files import check_writable

_APPLICATION = 0x50414D43  # in the header of the file
_TABLE = "CREATE TABLE records (key BLOB PRIMARY KEY, content BLOB, digest BLOB) WITHOUT ROWID"
_HEAD = b""  # the key of what the records belong to
_CAREFULLY = (
    "PRAGMA trusted_schema = OFF",
    "PRAGMA cell_size_check = ON",
    "PRAGMA locking_mode = EXCLUSIVE",
)


class Store:
    """The records of one study by key, in a file for this process alone.

    Args:
        path: of the file: a file that is there is continued; None: a file that ends with this object.
        study: what is kept: "sweep", "fit".
        identity: what distinguishes the study from others, by names a person understands.

    Raises:
        InputError: the file keeps another study or something else, is in use, is damaged, or cannot be written.
    """

    def __init__(self, path: Path | None, study: str, identity: Mapping[str, Any]) -> None:
        self.path, self._study = path, study
        if path is not None:
            check_writable(path)
        is_new = path is not None and not path.exists()
        with self._readable():
            self._db = sqlite3.connect(
                path or "", timeout=0, isolation_level=None, check_same_thread=False
            )
        weakref.finalize(self, self._db.close)
        self._db.create_function("digest", 2, _digest, deterministic=True)
        try:
            with self._readable():
                self._begin({n: json.dumps(v) for n, v in {"study": study, **identity}.items()})
        except BaseException:
            self._db.close()
            if path is not None and is_new:
                path.unlink(missing_ok=True)
            raise

    def _begin(self, head: dict[str, str]) -> None:
        """Creates the table, or compares the identity and removes damaged records."""
        for pragma in _CAREFULLY:
            self._db.execute(pragma)
        if not self._one("PRAGMA page_count"):
            with self._transaction():
                self._db.execute(f"PRAGMA application_id = {_APPLICATION}")
                self._db.execute(_TABLE)
                self._insert([(_HEAD, json.dumps(head).encode())])
        self._compare(head)
        self._db.execute("PRAGMA journal_mode = WAL")
        self._db.execute("PRAGMA synchronous = NORMAL")
        self._db.execute("DELETE FROM records WHERE digest IS NOT digest(key, content)")

    def _compare(self, head: dict[str, str]) -> None:
        """Finds out whether the file keeps this study."""
        is_ours = (
            self._one("PRAGMA application_id") == _APPLICATION
            and self._one("SELECT group_concat(sql) FROM sqlite_schema") == _TABLE
            and self._one("PRAGMA quick_check(1)") == "ok"
        )
        content = self.get(_HEAD) if is_ours else None
        kept = {} if content is None else json.loads(content)
        if kept.get("study") != head["study"]:
            raise sqlite3.DatabaseError
        if other := [n for n in dict.fromkeys([*head, *kept]) if head.get(n) != kept.get(n)]:
            raise InputError(
                f"keeps another {self._study}: {', '.join(other)} differ; remove it or name another file",
                self.path,
            )

    def _one(self, query: str) -> Any:
        return self._db.execute(query).fetchone()[0]

    def add(self, records: Iterable[tuple[bytes, bytes]]) -> None:
        """Keeps records, all of them or none.

        Raises:
            InputError: the disk is full or missing; earlier records are kept.
        """
        with self._readable(), self._transaction():
            self._insert(records)

    def _insert(self, records: Iterable[tuple[bytes, bytes]]) -> None:
        rows = ((key, content, _digest(key, content)) for key, content in records)
        self._db.executemany("INSERT OR REPLACE INTO records VALUES (?, ?, ?)", rows)

    @contextmanager
    def _transaction(self) -> Iterator[None]:
        self._db.execute("BEGIN IMMEDIATE")
        try:
            yield
            self._db.execute("COMMIT")
        finally:
            if self._db.in_transaction:
                self._db.execute("ROLLBACK")

    def get(self, key: bytes) -> bytes | None:
        """The content of a record; None: there is none, or it was damaged."""
        query = "SELECT content FROM records WHERE key = ? AND digest = digest(key, content)"
        with self._readable():
            row = self._db.execute(query, (key,)).fetchone()
        return None if row is None else bytes(row[0])

    def items(self) -> Iterator[tuple[bytes, bytes]]:
        """All records, in the order of their keys."""
        with self._readable():
            yield from self._db.execute(
                "SELECT key, content FROM records WHERE key != ? ORDER BY key", (_HEAD,)
            )

    def release(self) -> None:
        """Lets other processes use the file; what is kept can still be read, also once the file is removed."""
        with self._readable():
            self._db.execute("PRAGMA journal_mode = DELETE")
            self._db.execute("PRAGMA locking_mode = NORMAL")
            self.get(_HEAD)

    def close(self) -> None:
        """Ends the use of the file, and removes it where it keeps nothing."""
        with self._readable():
            empty = next(iter(self.items()), None) is None
        self._db.close()
        if empty and self.path is not None:
            self.path.unlink(missing_ok=True)

    @contextmanager
    def _readable(self) -> Iterator[None]:
        try:
            yield
        except (sqlite3.Error, ValueError, AttributeError) as problem:
            raise InputError(
                self._reason(getattr(problem, "sqlite_errorcode", 0)), self.path
            ) from None

    def _reason(self, code: int) -> str:
        primary = code & 0xFF
        if primary in (sqlite3.SQLITE_BUSY, sqlite3.SQLITE_LOCKED):
            return f"another {self._study} is writing this; wait for its end or name another file"
        if primary == sqlite3.SQLITE_FULL:
            return "cannot be written: No space left on device"
        if primary in (sqlite3.SQLITE_IOERR, sqlite3.SQLITE_CANTOPEN, sqlite3.SQLITE_READONLY):
            return "cannot be written: the disk or its folder does not allow it"
        return f"keeps no {self._study} that can be continued, or was damaged; remove it or name another file"


def _digest(key: Any, content: Any) -> bytes | None:
    """The checksum that a record of these parts must have; None: they are no record."""
    if not isinstance(key, bytes) or not isinstance(content, bytes):
        return None
    head = len(key).to_bytes(8, "big") + key
    return hashlib.blake2b(head + content, digest_size=16).digest()
