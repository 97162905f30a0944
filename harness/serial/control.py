"""The control socket: clients send commands, a line each, and get a line of JSON for each.

It never waits: `look` takes what has come and gives back what fits.
"""

import json
import socket
from collections.abc import Callable
from pathlib import Path
from typing import Protocol

from fbgen.diagnostics import DiagnosticError, error

_LONGEST = 4096
_CLIENTS = 8
_HIGHEST_PORT = 65_535


class _Client:
    def __init__(self, connection: socket.socket) -> None:
        connection.setblocking(False)
        self.connection = connection
        self.come = b""
        self.to_go = b""


class Control(Protocol):
    """What may be there or not: a control socket."""

    def look(self) -> None:
        """Serve whoever waits."""
        ...

    def close(self) -> None:
        """End it."""
        ...


class ControlSocket:
    """A socket at a path, or at HOST:PORT. `answer` carries a command out."""

    def __init__(self, place: str, answer: Callable[[str], dict[str, object]]) -> None:
        """Raises DiagnosticError FB9036 if nobody can listen there."""
        self._answer = answer
        self._clients: list[_Client] = []
        self._path: Path | None = None
        self._socket = self._listen(place)
        self._socket.setblocking(False)

    def _listen(self, place: str) -> socket.socket:
        host, colon, port = place.rpartition(":")
        try:
            if colon and port.isdecimal():
                if int(port) > _HIGHEST_PORT:
                    raise _unusable(place, f"ports go up to {_HIGHEST_PORT}")
                return socket.create_server((host or "127.0.0.1", int(port)))
            if not hasattr(socket, "AF_UNIX"):
                raise _unusable(place, "this system has no sockets at a path")
            return self._listen_at(Path(place))
        except OSError as problem:
            raise _unusable(place, problem.strerror or str(problem)) from None

    def _listen_at(self, path: Path) -> socket.socket:
        _remove_dead(path)
        listening = socket.socket(socket.AF_UNIX)
        try:
            listening.bind(str(path))
            listening.listen()
        except OSError:
            listening.close()
            raise
        self._path = path
        return listening

    @property
    def address(self) -> str:
        """Where it listens: the path, or HOST:PORT with the port that it got for 0."""
        if self._path is not None:
            return str(self._path)
        host, port = self._socket.getsockname()[:2]
        return f"{host}:{port}"

    def look(self) -> None:
        """As `Control.look`."""
        try:
            connection, _ = self._socket.accept()
        except BlockingIOError:
            pass
        else:
            self._clients.append(_Client(connection))
            if len(self._clients) > _CLIENTS:
                self._drop(self._clients[0])
        for client in list(self._clients):
            try:
                self._serve(client)
            except OSError:
                self._drop(client)

    def _serve(self, client: _Client) -> None:
        try:
            data = client.connection.recv(_LONGEST)
        except BlockingIOError:
            data = None
        if data == b"" or len(client.come) > _LONGEST:
            self._drop(client)
            return
        client.come += data or b""
        *lines, client.come = client.come.split(b"\n")
        for line in lines:
            told = self._answer(line.decode("utf-8", "replace").strip())
            client.to_go += json.dumps(told).encode("ascii") + b"\n"
        if client.to_go:
            try:
                sent = client.connection.send(client.to_go)
            except BlockingIOError:
                return
            client.to_go = client.to_go[sent:]

    def _drop(self, client: _Client) -> None:
        client.connection.close()
        self._clients.remove(client)

    def close(self) -> None:
        """As `Control.close`."""
        for client in list(self._clients):
            self._drop(client)
        self._socket.close()
        if self._path is not None:
            self._path.unlink(missing_ok=True)


def _remove_dead(path: Path) -> None:
    """Take away what a process has left that is gone."""
    if not path.is_socket():
        return
    with socket.socket(socket.AF_UNIX) as asking:
        try:
            asking.connect(str(path))
        except ConnectionRefusedError:
            path.unlink(missing_ok=True)


def _unusable(place: str, reason: str) -> DiagnosticError:
    return error(
        "FB9036",
        f"nobody can be heard at {place}: {reason}",
        None,
        "give a path in a folder that is yours, or HOST:PORT with a free port",
    )
