"""The page of a session and the socket to it, on this machine alone."""

from __future__ import annotations

import asyncio
import contextlib
import json
import logging
import socket
import sys
import webbrowser
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

import uvicorn
from starlette.applications import Starlette
from starlette.exceptions import HTTPException
from starlette.requests import ClientDisconnect, Request
from starlette.responses import FileResponse, JSONResponse, PlainTextResponse, Response
from starlette.routing import Mount, Route, WebSocketRoute
from starlette.staticfiles import StaticFiles
from starlette.types import ASGIApp
from starlette.websockets import WebSocket, WebSocketDisconnect
from uvicorn.protocols.http.auto import AutoHTTPProtocol

from pam_cosim.errors import InputError
from pam_cosim.workbench.authentication import Guard, new_token
from pam_cosim.workbench.documents import NAMES, document
from pam_cosim.workbench.drop import MOST_BYTES
from pam_cosim.workbench.frames import is_model
from pam_cosim.workbench.host import Workbench
from pam_cosim.workbench.job_process import Worker
from pam_cosim.workbench.protocol import answer, failure

PAGE = Path(__file__).parent / "page"
HOST = "127.0.0.1"
SWITCH = 0.0005  # [s] after which a message no longer waits for a computation
MOST_WAITING, MOST_WAITING_LETTERS = (
    20_000,
    100_000_000,
)  # that a window may be behind before it is given up
MOST_ASKED = 1000  # commands of a window that are not answered yet; further ones wait in its socket
MOST_AT_ONCE = 2  # files that are taken at the same time
MOST_FILES = 16_384  # open at the same time, connections among them
STALLED = 10.0  # [s] without a byte, after which a file or a request is given up
_PATIENCE = 1.0  # [s] for a window that is given up to hear of it


class Window:
    """One websocket: what it is to be told waits in a queue, of which curves that were overtaken are left out."""

    def __init__(self, socket: WebSocket, loop: asyncio.AbstractEventLoop) -> None:
        self.socket, self.loop = socket, loop
        self.waiting: asyncio.Queue[str | bytes | None] = asyncio.Queue()
        self.lost = asyncio.Event()  # set where no reader is left
        self._letters = 0  # that wait
        self._asked = asyncio.Semaphore(MOST_ASKED)
        self._newest: bytes | None = None  # of the model's curves, whose place in the queue is None

    def tell(self, message: str | bytes) -> None:
        """From any thread."""
        with contextlib.suppress(RuntimeError):  # the server has ended
            self.loop.call_soon_threadsafe(self._put, message)

    def _put(self, message: str | bytes) -> None:
        if self.lost.is_set():
            return
        if isinstance(message, str) or not is_model(message):
            self.waiting.put_nowait(message)
            self._letters += len(message)
        else:
            if self._newest is None:
                self.waiting.put_nowait(None)
            self._newest = message
        if self.waiting.qsize() > MOST_WAITING or self._letters > MOST_WAITING_LETTERS:
            self.lost.set()
            self.waiting = asyncio.Queue()

    async def send(self) -> None:
        """Sends what comes, as long as somebody listens."""
        while not self.lost.is_set():
            message = await self.waiting.get()
            if message is None:
                message, self._newest = self._newest or b"", None
            else:
                self._letters -= len(message)
            await _send(self.socket, message)

    async def receive(self, workbench: Workbench) -> None:
        """Takes commands and answers each when it is done."""
        while (message := await self.socket.receive())["type"] != "websocket.disconnect":
            try:
                command = json.loads(message.get("text") or "")
                if not isinstance(command, dict):
                    raise ValueError
            except (ValueError, RecursionError):
                self.tell(answer(None, failed={"text": "a command is a JSON object"}))
                continue
            number = command.get("id")
            number = number if isinstance(number, (int, str)) else None
            await self._asked.acquire()
            future = workbench.do(command)
            future.add_done_callback(lambda done, number=number: self._answer(done, number))  # type: ignore[misc]

    def _answer(self, answered: Any, number: Any) -> None:
        """From any thread."""
        self.tell(_answer(answered, number))
        with contextlib.suppress(RuntimeError):  # the server has ended
            self.loop.call_soon_threadsafe(self._asked.release)

    async def serve(self, workbench: Workbench) -> None:
        """Sends and receives until the window is closed, or given up."""
        work = [
            asyncio.create_task(part)
            for part in (self.send(), self.receive(workbench), self.lost.wait())
        ]
        try:
            done, _ = await asyncio.wait(work, return_when=asyncio.FIRST_COMPLETED)
        finally:
            for part in work:
                part.cancel()
        if self.lost.is_set():
            with contextlib.suppress(TimeoutError, RuntimeError, WebSocketDisconnect):
                await asyncio.wait_for(self.socket.close(1013, "too far behind"), _PATIENCE)
        for part in done:
            problem = part.exception()
            if problem is not None and not isinstance(problem, (WebSocketDisconnect, RuntimeError)):
                raise problem


def _answer(answered: Any, number: Any) -> str:
    if answered.cancelled():
        return answer(number, failed={"text": "the workbench is being closed"})
    problem = answered.exception()
    if problem is not None:
        return answer(number, failed=failure(problem))
    return answer(number, answered.result())


async def _send(socket: WebSocket, message: str | bytes) -> None:
    if isinstance(message, str):
        await socket.send_text(message)
    else:
        await socket.send_bytes(message)


async def _body(request: Request) -> bytearray:
    """A file that is sent.

    Raises:
        InputError: it is too large; one whose header states so is not read.
    """
    content = bytearray()
    announced = request.headers.get("content-length", "0")
    too_large = announced.isdecimal() and int(announced[:20]) > MOST_BYTES
    parts = request.stream()
    while not too_large:
        async with asyncio.timeout(STALLED):
            part = await anext(parts, None)
        if part is None:
            break
        content += part
        too_large = len(content) > MOST_BYTES
    if too_large:
        raise InputError(f"a file of more than {MOST_BYTES // 1_000_000} MB cannot be taken")
    return content


def application(workbench: Workbench, token: str, page: Path = PAGE) -> ASGIApp:
    """The server of a workbench, as an ASGI application."""
    open_requests = asyncio.Semaphore(MOST_AT_ONCE)

    async def index(request: Request) -> Response:
        return FileResponse(page / "index.html")

    async def download(request: Request) -> Response:
        name = request.path_params["name"]
        if name not in NAMES or workbench.session is None:
            raise HTTPException(404)
        try:
            text = await asyncio.to_thread(document, workbench.session, name)
        except InputError as problem:
            return PlainTextResponse(f"{problem.message}\n", 409)
        headers = {"Content-Disposition": f'attachment; filename="{name}"'}
        return Response(text, media_type=NAMES[name], headers=headers)

    async def drop(request: Request) -> Response:
        try:
            async with open_requests:
                content = await _body(request)
                result = await asyncio.wrap_future(
                    workbench.put(request.query_params.get("name", ""), content)
                )
        except ClientDisconnect:
            return Response(status_code=400)
        except TimeoutError:
            return Response(status_code=408, headers={"Connection": "close"})
        except InputError as problem:
            return JSONResponse({"failed": failure(problem)}, 409)
        return JSONResponse(result)

    async def connect(socket: WebSocket) -> None:
        await socket.accept()
        window = Window(socket, asyncio.get_running_loop())
        end = await asyncio.wrap_future(workbench.subscribe(window.tell))
        try:
            await window.serve(workbench)
        finally:
            end()

    async def missing(request: Request, problem: Exception) -> Response:
        return PlainTextResponse("there is no such page\n", 404)

    app = Starlette(
        routes=[
            Route("/", index),
            Route("/download/{name}", download),
            Route("/drop", drop, methods=["POST"]),
            Mount("/page", StaticFiles(directory=page)),
            WebSocketRoute("/socket", connect),
        ],
        exception_handlers={404: missing},
    )
    return Guard(app, token)


def serve(
    folder: Path,
    *,
    model: str | None = None,
    files: Sequence[Path] = (),
    port: int = 0,
    browser: bool = True,
    tell: Callable[[str], None] = print,
) -> None:
    """Opens a study and serves its page until it is interrupted.

    Args:
        folder: of the data set; a new one, where recordings are to be dropped.
        model: default: the bench of the data set.
        files: further Modelica files.
        port: 0: a free one.
        browser: whether to open the page.
        tell: gets the address, and other messages.

    Raises:
        InputError: the data set cannot be read, or the port is taken.
    """
    listener = _listener(port)
    token = new_token()
    address = f"http://{HOST}:{listener.getsockname()[1]}/?token={token}"
    with (
        listener,
        _awake() as worker,
        Workbench(folder, model=model, files=files, worker=worker) as workbench,
    ):
        workbench.wake()
        tell(f"the workbench is open at {address}")
        tell("end it with Ctrl-C; anyone who has the address can use it")
        config = uvicorn.Config(
            _opening(application(workbench, token), address if browser else None),
            log_level="warning",
            lifespan="on",
            server_header=False,
            ws_max_size=1 << 20,
            timeout_graceful_shutdown=1,
            http=Prompt,
            ws_per_message_deflate=False,
        )
        _allow_files()
        logging.getLogger("uvicorn.error").addFilter(_without_trace)
        sys.setswitchinterval(SWITCH)
        server = uvicorn.Server(config)
        with contextlib.suppress(KeyboardInterrupt):
            server.run(sockets=[listener])


class Prompt(AutoHTTPProtocol):  # type: ignore[misc, valid-type]
    """The protocol of uvicorn, which gives up connections that ask for nothing; it does so only after an answer."""

    def connection_made(self, transport: Any) -> None:
        """A connection, from which a request must come."""
        super().connection_made(transport)
        self.given_up = self.loop.call_later(STALLED, self._give_up)

    def _give_up(self) -> None:
        if self.cycle is None and self in self.connections:  # else it became a websocket
            self.transport.close()

    def connection_lost(self, problem: Exception | None) -> None:
        """The end."""
        self.given_up.cancel()
        super().connection_lost(problem)


def _allow_files() -> None:
    """Lets this process have as many connections as the system allows; some have 1024 if nobody asks for more."""
    with contextlib.suppress(ImportError, OSError, ValueError):  # Windows has no such limit
        import resource

        hard = resource.getrlimit(resource.RLIMIT_NOFILE)[1]
        resource.setrlimit(resource.RLIMIT_NOFILE, (min(hard, MOST_FILES), hard))


def _without_trace(record: logging.LogRecord) -> bool:
    """Says of a frame that is no text that it is none, and no more."""
    if record.exc_info and isinstance(record.exc_info[1], UnicodeDecodeError):
        record.exc_info = None
    return True


@contextlib.contextmanager
def _awake() -> Iterator[Worker]:
    """The process for fits, which loads while the data set is read."""
    worker = Worker()
    worker.wake()
    try:
        yield worker
    finally:
        worker.end()


def _listener(port: int) -> socket.socket:
    listener = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
    listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        listener.bind((HOST, port))
        listener.listen()  # a browser with the address may connect before the server begins
    except OSError as problem:
        listener.close()
        raise InputError(
            f"port {port} cannot be used: {problem.strerror}; choose another one with --port"
        ) from problem
    return listener


def _opening(app: ASGIApp, address: str | None) -> ASGIApp:
    """The application, which opens the page in a browser when it is ready."""

    async def opened(scope: Any, receive: Any, send: Any) -> None:
        if scope["type"] != "lifespan":
            await app(scope, receive, send)
            return
        await receive()
        if address is not None:
            asyncio.get_running_loop().run_in_executor(None, webbrowser.open, address)
        await send({"type": "lifespan.startup.complete"})
        await receive()
        await send({"type": "lifespan.shutdown.complete"})

    return opened
