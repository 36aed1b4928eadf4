"""As ``worker``, for the model-exchange interface of an FMU."""

from __future__ import annotations

import sys
from pathlib import Path

from pam_cosim.simulation.exchange_simulator import ExchangeSimulator
from pam_cosim.simulation.worker import main

if __name__ == "__main__":
    main(Path(sys.argv[1]), float(sys.argv[2]), sys.argv[3], ExchangeSimulator)
