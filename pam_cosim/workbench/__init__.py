"""A study that a person works on in a browser: one session, a server for its page, and what passes between them."""

from pam_cosim.workbench.host import Workbench
from pam_cosim.workbench.session import Session

__all__ = ["Session", "Workbench"]
