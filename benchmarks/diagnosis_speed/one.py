"""One diagnosis in this process: where its processor time goes, as a line of JSON.

python -m benchmarks.diagnosis_speed.one DATA CACHE
"""

from __future__ import annotations

import json
import os
import resource
import sys
from collections import defaultdict
from collections.abc import Callable
from typing import Any

spent: defaultdict[str, float] = defaultdict(float)
_inside: list[float] = []


def processor_time() -> float:
    """Of this process and the compilers that it waited for [s]."""
    use = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(one.ru_utime + one.ru_stime for one in use)


def timed(part: str, function: Callable[..., Any]) -> Callable[..., Any]:
    """The function, whose own time is counted under a name."""

    def call(*arguments: Any, **options: Any) -> Any:
        begin = processor_time()
        _inside.append(0.0)
        try:
            return function(*arguments, **options)
        finally:
            whole, others = processor_time() - begin, _inside.pop()
            spent[part] += whole - others
            if _inside:
                _inside[-1] += whole

    return call


def main(data: str, cache: str) -> None:
    """Diagnoses and prints."""
    os.environ["PAM_COSIM_CACHE"] = cache
    import pam_cosim as pam
    from pam_cosim.diagnosis import diagnose
    from pam_cosim.diagnosis.description import explanation
    from pam_cosim.diagnosis.search import searches, subject, trial

    spent["start"] = processor_time()
    trial.build_source = timed("building", trial.build_source)
    subject.build_model = timed("building", subject.build_model)
    trial._probe = timed("predicting", trial._probe)
    trial._fitted = timed("fitting", trial._fitted)
    searches.fit = timed("fitting", searches.fit)
    explanation.keep_ledger = timed("ledger", explanation.keep_ledger)
    read = timed("building", pam.read)(data)
    found = timed("choosing and judging", diagnose)(read, workers=0)
    print(
        json.dumps(
            {"parts": dict(spent), "total": processor_time(), "verdict": found.verdict.as_dict()}
        )
    )


if __name__ == "__main__":
    main(*sys.argv[1:])
