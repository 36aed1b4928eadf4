"""Makes the virtual environment .venv with pam-cosim in it; does nothing when it is up to date.

Needs Python 3.11 or newer and a package index; neither pip nor the venv module's ensurepip, which a bare Debian
leaves out. Run it with the system's Python: ``python3 scripts/environment.py [EXTRA]``. A .venv that was moved or
copied with its checkout leads to the old one, and is made anew; so is one of another version of Python, or whose Python
is gone.

What is installed is what ``scripts/locks`` lists, with its hashes: ``base.txt`` for ./scripts/demo, ``test.txt`` for
./scripts/test. Other extras, and everything where PAM_COSIM_UNLOCKED is set, follow the ranges of ``pyproject.toml``.
A lock is made anew by ``uv pip compile pyproject.toml scripts/locks/build.in [--extra test] --universal
--python-version 3.11 --generate-hashes --no-annotate --no-header -o scripts/locks/test.txt``.
"""

import hashlib
import os
import re
import shutil
import subprocess
import sys
import tempfile
import urllib.request
import venv
from pathlib import Path
from urllib.error import URLError
from urllib.parse import urljoin

ROOT = Path(__file__).resolve().parent.parent
HOME = ROOT / ".venv"
UNLOCKED = "PAM_COSIM_UNLOCKED"
PYTHON = HOME / ("Scripts/python.exe" if os.name == "nt" else "bin/python")


def main(extra: str) -> int:
    if sys.version_info < (3, 11):  # noqa: UP036 - this script is what tells people
        print(
            f"pam-cosim needs Python 3.11 or newer; this is {sys.version.split()[0]}",
            file=sys.stderr,
        )
        return 2
    stamp = HOME / f"ready-{extra or 'base'}"
    wanted = f"{hashlib.sha256(asked_for()).hexdigest()}\n{ROOT}"
    try:
        if of_another_checkout() or of_another_python() or leads_nowhere():
            remove()
        if stamp.exists() and stamp.read_text(encoding="utf-8") == wanted:
            return 0
        print("setting up .venv (once, a minute or two) ...", file=sys.stderr, flush=True)
        if not PYTHON.exists():
            venv.create(HOME, with_pip=False)
        install_all(extra)
    except (subprocess.CalledProcessError, OSError) as problem:
        asked = "; is a Python package index within reach?" if is_of_the_index(problem) else ""
        print(f"setting up failed: {problem}{asked}", file=sys.stderr)
        return 1
    # an installed package has its bytecode; without it a command takes three times as long to start
    subprocess.run([str(PYTHON), "-m", "compileall", "-q", str(ROOT / "pam_cosim")])
    stamp.write_text(wanted, encoding="utf-8")
    return 0


def asked_for() -> bytes:
    """What decides what is installed."""
    locks = b"".join(
        file.read_bytes() for file in sorted((ROOT / "scripts" / "locks").glob("*.txt"))
    )
    unlocked = b"unlocked" if os.environ.get(UNLOCKED) else b""
    return (ROOT / "pyproject.toml").read_bytes() + locks + sys.version.encode() + unlocked


def install_all(extra: str) -> None:
    """Installs pam-cosim with what it needs: by the lock, or by the ranges of ``pyproject.toml``."""
    quiet = ["--quiet", "--disable-pip-version-check"]
    lock = ROOT / "scripts" / "locks" / f"{extra or 'base'}.txt"
    if lock.exists() and not os.environ.get(UNLOCKED):
        install([*quiet, "--require-hashes", "--requirement", str(lock)])
        install([*quiet, "--no-deps", "--no-build-isolation", "--editable", str(ROOT)])
    else:
        install([*quiet, "--editable", f"{ROOT}[{extra}]" if extra else str(ROOT)])


def is_of_the_index(problem: Exception) -> bool:
    """Whether pip failed, or could not be fetched; anything else has nothing to do with a package index."""
    return isinstance(
        problem, subprocess.CalledProcessError | URLError | ConnectionError | TimeoutError
    )


def of_another_checkout() -> bool:
    """Whether .venv was made for a checkout at another place."""
    stamps = [stamp.read_text(encoding="utf-8") for stamp in HOME.glob("ready-*")]
    roots = [root for _, _, root in (text.partition("\n") for text in stamps) if root]
    return any(root != str(ROOT) for root in roots)


def of_another_python() -> bool:
    """Whether .venv was made by another version of Python than this one, as far as it says."""
    about = HOME / "pyvenv.cfg"
    text = about.read_text(encoding="utf-8") if about.exists() else ""
    made_by = re.search(r"^version(?:_info)?\s*=\s*(\d+\.\d+\.\d+)", text, re.MULTILINE)
    return made_by is not None and made_by[1] != ".".join(map(str, sys.version_info[:3]))


def leads_nowhere() -> bool:
    """Whether .venv or its Python is a link to what is no longer there."""
    return any(link.is_symlink() and not link.exists() for link in (HOME, PYTHON))


def remove() -> None:
    """Removes .venv; where it is a link, the link alone, for what it leads to is another checkout's."""
    if HOME.is_symlink():
        HOME.unlink()
    else:
        shutil.rmtree(HOME)


def install(arguments: list[str]) -> None:
    """Runs ``pip install`` for .venv: with its own pip, ensurepip's, or one fetched from the package index."""
    python = str(PYTHON)
    has_pip = [python, "-m", "pip", "--version"]
    if subprocess.run(has_pip, capture_output=True).returncode:
        subprocess.run([python, "-m", "ensurepip", "--default-pip"], capture_output=True)
    if subprocess.run(has_pip, capture_output=True).returncode:
        with tempfile.TemporaryDirectory() as folder:
            wheel = fetch_pip(Path(folder))
            subprocess.run([python, f"{wheel}/pip", "install", "--quiet", "pip"], check=True)
    subprocess.run([python, "-m", "pip", "install", *arguments], check=True)


def fetch_pip(folder: Path) -> Path:
    """Downloads pip's wheel, which can run without being installed."""
    index = os.environ.get("PIP_INDEX_URL", "https://pypi.org/simple").rstrip("/") + "/pip/"
    with urllib.request.urlopen(index) as answer:
        page = answer.read().decode()
    links = re.findall(
        r'href="([^"#]*?/?(pip-(\d+)\.(\d+)(?:\.(\d+))?-py3-none-any\.whl))[#"]', page
    )
    if not links:
        raise SystemExit(f"no pip found at {index}; set PIP_INDEX_URL to a package index")
    newest = max(links, key=lambda link: [int(n or 0) for n in link[2:]])
    wheel = folder / newest[1]
    with urllib.request.urlopen(urljoin(index, newest[0])) as f:
        wheel.write_bytes(f.read())
    return wheel


if __name__ == "__main__":
    sys.exit(main(sys.argv[1] if len(sys.argv) > 1 else ""))
