"""The server: who may talk to it, what it gives away, and that what files contain stays text."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

pytest.importorskip("starlette", reason="the extra 'workbench' is not installed")

from starlette.testclient import TestClient
from starlette.websockets import WebSocketDisconnect

from pam_cosim.workbench import Workbench
from pam_cosim.workbench.server import application

TOKEN = "a-token-of-a-test"
HOME = "http://127.0.0.1:8123"
SOCKET = "ws://127.0.0.1:8123/socket"
TITLE = '<img src=x onerror="alert(1)">'


@pytest.fixture(scope="module")
def workbench(recorded: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Workbench]:
    import shutil

    folder = Path(shutil.copytree(recorded, tmp_path_factory.mktemp("served") / "rig"))
    experiment = folder / "experiment.toml"
    experiment.write_text(
        re.sub(r"^title.*$", f"title = '{TITLE}'", experiment.read_text(), flags=re.M)
    )
    (folder.parent / "secret.txt").write_text("secret")
    with Workbench(folder) as made:
        yield made


@pytest.fixture
def client(workbench: Workbench) -> Iterator[TestClient]:
    """A browser that was given the address with the token."""
    with TestClient(application(workbench, TOKEN), base_url=HOME) as client:
        answer = client.get(f"/?token={TOKEN}")
        assert answer.status_code == 200 and str(answer.url) == f"{HOME}/"
        yield client


def stranger(workbench: Workbench, **options: str) -> TestClient:
    return TestClient(application(workbench, TOKEN), base_url=options.get("base_url", HOME))


def test_without_the_token_there_is_nothing(workbench: Workbench) -> None:
    client = stranger(workbench)
    for path in ("/", "/page/index.html", "/page/main.js", "/download/script.py", f"/?token={TOKEN}x", "/?token=",
                 f"/page/index.html?token={TOKEN}"):  # fmt: skip
        answer = client.get(path, follow_redirects=False)
        assert (
            answer.status_code == 403
            and TITLE not in answer.text
            and "set-cookie" not in answer.headers
        ), path
    client.cookies.set("pam_cosim_token_8123", "guess")
    assert client.get("/").status_code == 403
    assert (
        client.post("/drop?name=a.csv", content=b"x", headers={"Origin": HOME}).status_code == 403
    )


def test_the_token_becomes_a_cookie_that_no_script_reads_and_leaves_the_address(
    workbench: Workbench,
) -> None:
    answer = stranger(workbench).get(f"/?token={TOKEN}", follow_redirects=False)
    assert answer.status_code == 303 and answer.headers["location"] == "/"
    cookie = answer.headers["set-cookie"].lower()
    assert "httponly" in cookie and "samesite=strict" in cookie and "pam_cosim_token_8123" in cookie
    assert answer.headers["referrer-policy"] == "no-referrer"


def test_the_page_may_load_nothing_from_outside(client: TestClient) -> None:
    for path in ("/", "/page/index.html"):
        policy = client.get(path).headers["content-security-policy"]
        assert "default-src 'self'" in policy and "unsafe" not in policy and "*" not in policy
        assert (
            "connect-src 'self' ws://127.0.0.1:8123" in policy
            and "frame-ancestors 'none'" in policy
        )
    assert client.get("/").headers["x-content-type-options"] == "nosniff"
    for name in ("style.css", "main.js"):
        assert client.get(f"/page/{name}").status_code == 200


@pytest.mark.parametrize(
    "host", ["evil.example", "evil.example:8123", "127.0.0.1.evil.example", "127.0.0.1:9999", ""]
)
def test_another_name_of_the_host_is_refused(client: TestClient, host: str) -> None:
    """As after DNS rebinding: the browser believes that it talks to another site."""
    assert client.get("/", headers={"Host": host}).status_code == 403
    with (
        pytest.raises(WebSocketDisconnect),
        client.websocket_connect(SOCKET, headers={"Host": host}),
    ):
        pass


@pytest.mark.parametrize(
    "origin",
    ["http://evil.example", "null", "http://127.0.0.1:9999", "https://127.0.0.1:8123", None],
)
def test_a_page_of_another_site_is_refused(client: TestClient, origin: str | None) -> None:
    headers = {} if origin is None else {"Origin": origin}
    with pytest.raises(WebSocketDisconnect), client.websocket_connect(SOCKET, headers=headers):
        pass
    assert client.post("/drop?name=a.csv", content=b"x", headers=headers).status_code == 403


@pytest.mark.parametrize(
    "path",
    ["/page/../session.py", "/page/%2e%2e/session.py", "/page/..%2fsession.py", "/page//etc/passwd",
     "/page/%2fetc/passwd", "/download/../../secret.txt", "/download/..%2fexperiment.toml", "/download/secret.txt",
     "/download/", "/../secret.txt", "/page/%00", "/page/....//session.py", "/experiment.toml", "/page/"],
)  # fmt: skip
def test_no_other_file_is_given_away(client: TestClient, path: str) -> None:
    answer = client.get(path)
    assert (
        answer.status_code in (400, 404)
        and "secret" not in answer.text
        and "import" not in answer.text
    )


def hello(client: TestClient):  # noqa: ANN201 - a context manager of the test client
    return client.websocket_connect(SOCKET, headers={"Origin": HOME})


def until(socket, event: str) -> dict:  # noqa: ANN001
    while True:
        message = socket.receive()
        told = json.loads(message["text"]) if message.get("text") is not None else {}
        if told.get("event") == event:
            return told


def test_a_window_is_told_the_study_and_answered(client: TestClient) -> None:
    with hello(client) as socket:
        study = until(socket, "study")
        assert (
            study["title"] == TITLE and study["state"] == "open"
        )  # text; the page shows it as such
        socket.send_text(json.dumps({"id": 7, "do": "set", "values": {"valve.C_A": 0.7}}))
        answer = until(socket, "answer")
        assert answer["id"] == 7 and answer["failed"] is None and answer["version"] >= 1
        socket.send_text(json.dumps({"id": "x", "do": "set", "values": {"no.such": 1}}))
        failed = until(socket, "answer")
        assert failed["id"] == "x" and "no.such" in failed["failed"]["text"]
    assert TITLE not in client.get("/").text


@pytest.mark.parametrize(
    "text",
    ["", "{", "[]", "7", '"set"', "{}", '{"do": {}}', '{"do": "set"}', "[" * 5000, '{"id": {}, "do": "undo", "x": 1}',
     '{"do": "set", "values": {"valve.C_A": 1e999}}'],
)  # fmt: skip
def test_nonsense_is_answered_in_words(client: TestClient, text: str) -> None:
    with hello(client) as socket:
        socket.send_text(text)
        assert until(socket, "answer")["failed"]["text"]
        socket.send_text('{"id": 1, "do": "reset"}')
        assert until(socket, "answer")["failed"] is None


def test_two_windows_see_the_same_move(client: TestClient) -> None:
    with hello(client) as one, hello(client) as other:
        until(one, "where"), until(other, "study")
        one.send_text(json.dumps({"id": 1, "do": "set", "values": {"valve.C_A": 0.77}}))
        while until(other, "scores")["values"]["valve.C_A"] != 0.77:
            pass
        assert until(one, "answer")["id"] == 1


@pytest.mark.full
def test_downloads(client: TestClient) -> None:
    script = client.get("/download/script.py")
    assert script.status_code == 200 and "import pam_cosim as pam" in script.text
    assert script.headers["content-disposition"] == 'attachment; filename="script.py"'
    report = client.get("/download/report.html").text
    assert TITLE not in report and "&lt;img src=x" in report
    answer = client.get("/download/next.csv")
    assert answer.status_code == 409 and answer.text.strip()


def test_nothing_is_dropped_on_a_study(client: TestClient, workbench: Workbench) -> None:
    before = sorted(workbench.folder.iterdir())
    answer = client.post("/drop?name=../x.csv", content=b"time,p\n", headers={"Origin": HOME})
    assert answer.status_code == 409 and "another" in answer.json()["failed"]["text"]
    assert sorted(workbench.folder.iterdir()) == before


@pytest.mark.full
def test_the_command_serves_this_machine_alone_and_ends_with_an_interrupt(recorded: Path) -> None:
    import signal
    import urllib.error
    import urllib.request

    command = [sys.executable, "-m", "pam_cosim", "workbench", str(recorded), "--no-browser"]
    with subprocess.Popen(
        command, stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as server:
        assert server.stderr is not None
        line = next(line for line in server.stderr if "http://" in line)
        address = re.search(r"http://127\.0\.0\.1:(\d+)/\?token=\S+", line)
        assert address is not None
        with pytest.raises(urllib.error.HTTPError) as refused:
            urllib.request.urlopen(f"http://127.0.0.1:{address.group(1)}/", timeout=30)
        assert refused.value.code == 403
        listening = Path(f"/proc/{server.pid}/net/tcp").read_text()
        port = f"{int(address.group(1)):04X}"
        places = [
            row.split()[1]
            for row in listening.splitlines()[1:]
            if row.split()[1].endswith(f":{port}")
        ]
        assert places and all(place.startswith("0100007F") for place in places)
        server.send_signal(signal.SIGINT)
        assert server.wait(60) in (0, 130)
