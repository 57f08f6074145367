"""Wheels of a few bytes, a lock that pins them, and a registry on this machine that serves them whole or breaks off."""

from __future__ import annotations

import hashlib
import http.server
import threading
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


def write_wheel(folder: Path, name: str, version: str = "1.0", tag: str = "py3-none-any", content: bytes = b"") -> Path:
    """A wheel with one module, which holds ``content`` as a comment."""
    wheel = folder / f"{name}-{version}-{tag}.whl"
    info = f"{name}-{version}.dist-info"
    members = {
        f"{name}.py": b"VALUE = 1\n#" + content,
        f"{info}/METADATA": f"Metadata-Version: 2.1\nName: {name}\nVersion: {version}\n".encode(),
        f"{info}/WHEEL": f"Wheel-Version: 1.0\nGenerator: tests\nRoot-Is-Purelib: true\nTag: {tag}\n".encode(),
    }
    record = "".join(f"{member},,\n" for member in [*members, f"{info}/RECORD"])
    folder.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(wheel, "w") as packed:
        for member, text in {**members, f"{info}/RECORD": record.encode()}.items():
            packed.writestr(member, text)
    return wheel


def write_lock(lock: Path, wheels: list[Path], extra: str = "") -> Path:
    """A lock of some wheels."""
    lines = []
    for wheel in wheels:
        name, version = wheel.name.split("-")[:2]
        lines.append(f"{name}=={version} --hash=sha256:{hashlib.sha256(wheel.read_bytes()).hexdigest()}")
    lock.write_text("# a lock\n" + "\n".join(lines) + f"\n{extra}", encoding="utf-8")
    return lock


class Registry(http.server.BaseHTTPRequestHandler):
    """Serves wheels of a folder in the simple form of package registries; ``broken`` ends a file in its middle."""

    folder = Path()
    broken = False

    def do_GET(self) -> None:  # the name that http.server calls
        name = self.path.strip("/").split("/")[-1]
        wheel = self.folder / name
        if wheel.suffix == ".whl":
            content, kind = wheel.read_bytes(), "application/octet-stream"
        else:
            links = "".join(f'<a href="/files/{path.name}">{path.name}</a>' for path in self.folder.glob(f"{name.replace('-', '_')}-*"))
            content, kind = f"<html><body>{links}</body></html>".encode(), "text/html"
        self.send_response(200)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(content)))
        self.end_headers()
        self.wfile.write(content[: len(content) // 2] if self.broken and wheel.suffix == ".whl" else content)

    def log_message(self, *arguments: object) -> None:
        """Say nothing."""


@contextmanager
def registry(folder: Path, *, broken: bool = False) -> Iterator[str]:
    """Address of a registry of the wheels of a folder, on this machine alone."""
    handler = type("Handler", (Registry,), {"folder": folder, "broken": broken})
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    try:
        yield f"http://127.0.0.1:{server.server_port}/simple"
    finally:
        server.shutdown()
        thread.join()
        server.server_close()
