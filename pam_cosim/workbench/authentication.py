"""Who may talk to the server: a browser of this machine that was given the token."""

from __future__ import annotations

import hmac
import secrets
from urllib.parse import parse_qs, urlsplit

from starlette.datastructures import Headers
from starlette.requests import cookie_parser
from starlette.responses import PlainTextResponse, RedirectResponse, Response
from starlette.types import ASGIApp, Message, Receive, Scope, Send

COOKIE = "pam_cosim_token"
NAMES = ("127.0.0.1", "localhost")
POLICY = "; ".join(
    [
        "default-src 'self'",
        "img-src 'self' data: blob:",
        "connect-src 'self' {sockets}",
        "object-src 'none'",
        "base-uri 'none'",
        "form-action 'none'",
        "frame-ancestors 'none'",
    ]
)


class Guard:
    """Lets a request through that comes to this server by its name, from its own page, with its token.

    The name of the host is checked against DNS rebinding (another site that resolves to 127.0.0.1), the origin against
    pages of other sites, and the token against other users of the machine. The address that is opened first carries the
    token; from there on a cookie does, that no script can read and that is sent to this server alone.

    Args:
        app: what is guarded.
        token: of this server.
    """

    def __init__(self, app: ASGIApp, token: str) -> None:
        self.app, self.token = app, token

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """One request, or one websocket."""
        if scope["type"] not in ("http", "websocket"):
            await self.app(scope, receive, send)
            return
        headers = Headers(scope=scope)
        host = headers.get("host", "")
        refused = self._refused(scope, headers, host)
        if refused is not None:
            await _refuse(scope, receive, send, refused)
            return
        token = parse_qs(scope.get("query_string", b"").decode("latin-1")).get("token", [""])[0]
        if scope["type"] == "http" and scope["path"] == "/" and self._is_token(token):
            response: Response = RedirectResponse("/", 303)
            response.set_cookie(
                self.cookie(host), self.token, httponly=True, samesite="strict", path="/"
            )
            response.headers["Referrer-Policy"] = "no-referrer"
            await response(scope, receive, send)
            return
        if not self._is_token(cookie_parser(headers.get("cookie", "")).get(self.cookie(host), "")):
            await _refuse(
                scope,
                receive,
                send,
                "open the address that 'pam-cosim workbench' printed: it has a token",
            )
            return
        await self.app(scope, receive, _with_headers(send, host))

    @staticmethod
    def cookie(host: str) -> str:
        """Name of the cookie: servers on other ports have others, and cookies know of no ports."""
        return f"{COOKIE}_{urlsplit('//' + host).port or 80}"

    def _is_token(self, text: str) -> bool:
        return hmac.compare_digest(text.encode(), self.token.encode())

    def _refused(self, scope: Scope, headers: Headers, host: str) -> str | None:
        try:
            place = urlsplit(f"//{host}")
            name, port = place.hostname, place.port
        except ValueError:
            return "the request names no host"
        server = scope.get("server")
        own_port = server[1] if server else None
        is_other_port = bool(own_port) and port is not None and port != own_port
        if name not in NAMES or is_other_port:
            return "the request is for another host"
        origin = headers.get("origin")
        if origin is None:
            if scope["type"] == "websocket" or scope.get("method") not in ("GET", "HEAD"):
                return "the request does not state from which page it comes"
            return None
        if origin != f"http://{host}":
            return "the request comes from the page of another site"
        return None


def new_token() -> str:
    """A random token of a session."""
    return secrets.token_urlsafe(32)


async def _refuse(scope: Scope, receive: Receive, send: Send, words: str) -> None:
    if scope["type"] == "websocket":
        await receive()
        await send({"type": "websocket.close", "code": 4403, "reason": words})
        return
    await PlainTextResponse(f"{words}\n", 403)(scope, receive, send)


def _with_headers(send: Send, host: str) -> Send:
    async def sent(message: Message) -> None:
        if message["type"] == "http.response.start":
            policy = POLICY.format(sockets=f"ws://{host}")
            headers = [
                (b"content-security-policy", policy.encode("latin-1")),
                (b"x-content-type-options", b"nosniff"),
                (b"referrer-policy", b"no-referrer"),
                (b"cache-control", b"no-store"),
                (b"cross-origin-opener-policy", b"same-origin"),
                (b"cross-origin-resource-policy", b"same-origin"),
            ]
            message = {**message, "headers": [*message.get("headers", []), *headers]}
        await send(message)

    return sent
