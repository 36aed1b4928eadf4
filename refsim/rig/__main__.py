"""``python -m rig``: see ``rig.measurement``."""

import sys

from rig.measurement import main

sys.exit(main())
