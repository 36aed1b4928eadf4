"""As ``simulation.worker``, for work on the equations of an FMU for model exchange."""

from __future__ import annotations

import sys
from pathlib import Path

from pam_cosim.analysis.exchange import ExchangeModel
from pam_cosim.simulation.worker import main

if __name__ == "__main__":
    main(Path(sys.argv[1]), float(sys.argv[2]), sys.argv[3], ExchangeModel)
