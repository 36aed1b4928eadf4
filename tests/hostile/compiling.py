"""Compiles hostile models one after another within a limit of memory, and says in lines of JSON what came of each.

``python -m tests.hostile.compiling FOLDER``: every ``.mo`` file in it.
"""

from __future__ import annotations

import json
import resource
import sys
import time
from pathlib import Path

from pam_cosim.compiler import compile_model
from pam_cosim.errors import InputError, ModelError

MEMORY = 2_000_000_000  # bytes of address space beyond what is loaded


def outcome(file: Path) -> dict[str, object]:
    """What compiling a file comes to."""
    before = time.process_time()
    try:
        compile_model(str(file))
        told: dict[str, object] = {"end": "compiled"}
    except ModelError as error:
        told = {
            "end": "refused",
            "message": error.message,
            "file": str(error.file),
            "line": error.line,
        }
    except InputError as error:
        told = {"end": "input", "message": error.message}
    except BaseException as defect:
        told = {"end": "defect", "message": f"{type(defect).__name__}: {str(defect)[:300]}"}
    return {
        "name": file.stem,
        "seconds": time.process_time() - before,
        "peak": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1000,
        **told,
    }


def main() -> None:
    """Tells every outcome as it comes."""
    pages = (
        int(Path("/proc/self/statm").read_text().split()[0])
        if Path("/proc/self/statm").exists()
        else 0
    )
    most = pages * resource.getpagesize() + MEMORY
    resource.setrlimit(resource.RLIMIT_AS, (most, most))
    for file in sorted(Path(sys.argv[1]).glob("*.mo")):
        print(json.dumps(outcome(file)), flush=True)


if __name__ == "__main__":
    main()
