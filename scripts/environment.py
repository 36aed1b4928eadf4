"""Makes the virtual environment .venv with pam-cosim in it; does nothing when it is up to date.

Needs Python 3.11 or newer and a package index; neither pip nor the venv module's ensurepip, which a bare Debian
leaves out. Run it with the system's Python: ``python3 scripts/environment.py [EXTRA]``. A .venv that was moved or
copied with its checkout leads to the old one, and is made anew.

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
    locks = b"".join(
        file.read_bytes() for file in sorted((ROOT / "scripts" / "locks").glob("*.txt"))
    )
    content = (ROOT / "pyproject.toml").read_bytes() + locks + sys.version.encode()
    wanted = f"{hashlib.sha256(content).hexdigest()}\n{ROOT}"
    if of_another_checkout():
        remove()
    if stamp.exists() and stamp.read_text(encoding="utf-8") == wanted:
        return 0
    print("setting up .venv (once, a minute or two) ...", file=sys.stderr, flush=True)
    if not PYTHON.exists():
        venv.create(HOME, with_pip=False)
    quiet = ["--quiet", "--disable-pip-version-check"]
    lock = ROOT / "scripts" / "locks" / f"{extra or 'base'}.txt"
    try:
        if lock.exists() and not os.environ.get(UNLOCKED):
            install([*quiet, "--require-hashes", "--requirement", str(lock)])
            install([*quiet, "--no-deps", "--no-build-isolation", "--editable", str(ROOT)])
        else:
            install([*quiet, "--editable", f"{ROOT}[{extra}]" if extra else str(ROOT)])
    except (subprocess.CalledProcessError, OSError) as problem:
        print(
            f"setting up failed: {problem}; is a Python package index within reach?",
            file=sys.stderr,
        )
        return 1
    # an installed package has its bytecode; without it a command takes three times as long to start
    subprocess.run([str(PYTHON), "-m", "compileall", "-q", str(ROOT / "pam_cosim")])
    stamp.write_text(wanted, encoding="utf-8")
    return 0


def of_another_checkout() -> bool:
    """Whether .venv was made for a checkout at another place."""
    stamps = [stamp.read_text(encoding="utf-8") for stamp in HOME.glob("ready-*")]
    roots = [root for _, _, root in (text.partition("\n") for text in stamps) if root]
    return any(root != str(ROOT) for root in roots)


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
