"""How results are told in the field of the project's own library."""

from __future__ import annotations

from pam_cosim.catalogue import domain_of
from pam_cosim.compiler import read_library

DOMAIN = domain_of(read_library(), "Isotonic")
