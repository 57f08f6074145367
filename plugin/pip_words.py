"""What pip and venv say when they give up, in words a user can act on."""

from __future__ import annotations

from ..algorithms.support.translation import tr


def what_failed(output: str) -> str:
    """Why a program gave up, from all it said: a known cause with its remedy, otherwise the first error, not the last words."""
    for words, meaning in _causes():
        if any(word.lower() in output.lower() for word in words):
            return meaning
    lines = [line.strip() for line in output.splitlines() if line.strip()]
    errors = [line for line in lines if line.lower().startswith(("error:", "error "))]
    return (errors or lines or ["?"])[0 if errors else -1]


def _causes() -> list[tuple[tuple[str, ...], str]]:
    """Words that tell a cause, and the cause; the first that fits counts, since one failure causes others."""
    return [
        (("No space left on device", "[Errno 28]", "[WinError 112]", "Disk quota exceeded"), tr("the disk is full")),
        (
            ("ensurepip is not available", "No module named ensurepip", "No module named venv"),
            tr("this Python cannot make environments; on Debian and Ubuntu install python3-venv first"),
        ),
        (
            ("407 Proxy Authentication", "Tunnel connection failed: 407"),
            tr("the proxy wants a user name and password: state them in Settings > Options > Network"),
        ),
        (
            ("Missing dependencies for SOCKS",),
            tr("the proxy is of the kind SOCKS, which the installer does not know; choose a folder of wheels"),
        ),
        (
            ("CERTIFICATE_VERIFY_FAILED", "SSLCertVerificationError", "certificate verify failed"),
            tr("the registry's certificate is not trusted: import your network's authority in Settings > Options > Authentication"),
        ),
        (("Cannot connect to proxy", "ProxyError"), tr("the proxy cannot be reached: see Settings > Options > Network")),
        (
            ("DO NOT MATCH THE HASHES", "Hashes are required", "is not a zip file", "has an invalid wheel", "wheel is invalid"),
            tr("a file is not the one that this version of the plugin needs: it was damaged or changed on its way; try again"),
        ),
        (
            (
                "ReadTimeoutError",
                "IncompleteRead",
                "Connection broken",
                "ConnectionResetError",
                "Connection aborted",
                "Read timed out",
                "incomplete-download",
            ),
            tr("the connection broke while a file was fetched; try again, what is complete is not fetched twice"),
        ),
        # where nothing can be reached pip says so in a warning, and only then that it found no version
        (
            ("NewConnectionError", "name resolution", "getaddrinfo failed", "Name or service not known", "Network is unreachable"),
            tr("no package registry can be reached from this computer; without a network choose a folder of wheels"),
        ),
        (
            ("ImportError: lib", "cannot open shared object file"),
            tr("a library of the system is missing; on Debian and Ubuntu install libegl1 libgl1 libgomp1"),
        ),
    ]
