"""``python -m pam_cosim``: the command ``pam-cosim``."""

from pam_cosim.cli.process import run

if __name__ == "__main__":
    run()
