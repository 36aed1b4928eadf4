"""Headings as the library's vocabulary reads them."""

from pam_cosim.catalogue import vocabulary_of
from pam_cosim.compiler import read_library
from pam_cosim.drafting.headings import Headings

HEADINGS = Headings(vocabulary_of(read_library()))
read_heading = HEADINGS.read
