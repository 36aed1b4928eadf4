"""``python -m pam_cosim``: the command ``pam-cosim``."""

from pam_cosim.command import run

if __name__ == "__main__":
    run()
