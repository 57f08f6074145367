"""Start the engine as a process of its own, whatever this folder is called and whether or not it is installed.

QGIS starts ``python -I scripts/engine.py SUBCOMMAND ... --json-progress`` in the engine's own environment. Standard input is the
line to the parent: the word ``cancel`` or its end (QGIS closed or crashed) stops the engine with all its workers. The first line on
standard output states the engine's version; the plugin's, given by ``--of-plugin``, must be the same.
"""

from __future__ import annotations

import importlib.util
import json
import os
import re
import signal
import sys
import threading
from pathlib import Path

PACKAGE = "tetratrack"
PLUGIN_FOLDER = Path(__file__).resolve().parents[1]
GRACE_SECONDS = 0.8
CANCELLED_EXIT = 130
ATTACHED = "--attached"
"""First argument that ties the engine to its parent through standard input."""

OF_PLUGIN = "--of-plugin"
"""Before the version of the plugin that started this process."""


def load_package() -> None:
    """Import this folder under the package's name, so that ``tetratrack.core`` is found here and in worker processes."""
    if PACKAGE in sys.modules:
        return
    spec = importlib.util.spec_from_file_location(PACKAGE, PLUGIN_FOLDER / "__init__.py", submodule_search_locations=[str(PLUGIN_FOLDER)])
    if spec is None or spec.loader is None:
        raise ImportError(f"{PLUGIN_FOLDER} does not hold the package {PACKAGE}")
    module = importlib.util.module_from_spec(spec)
    sys.modules[PACKAGE] = module
    spec.loader.exec_module(module)


def stop_with_parent() -> None:
    """Read standard input until it ends or says ``cancel``; then interrupt the run, and end it if it does not heed."""
    # not the buffer of sys.stdin, which would stay locked in copies of this process
    with open(0, "rb", buffering=0, closefd=False) as parent:
        for line in parent:
            if line.strip() == b"cancel":
                break
    signal.raise_signal(signal.SIGINT)
    threading.Event().wait(GRACE_SECONDS)
    # compiled code does not see the interrupt; the results are still in a temporary folder that the parent removes
    if hasattr(os, "killpg"):
        os.killpg(0, signal.SIGKILL)
    os._exit(CANCELLED_EXIT)


def attach() -> None:
    """Make this process the head of its own group and tie its life to the parent's."""
    from tetratrack.core.common.lifeline import PARENT_WATCH

    if hasattr(os, "setsid"):
        os.setsid()
    threading.Thread(target=stop_with_parent, name=PARENT_WATCH, daemon=True).start()


def say(**event: str) -> None:
    """One line for the plugin."""
    sys.stdout.write(json.dumps(event) + "\n")
    sys.stdout.flush()


def agree(plugin: str) -> None:
    """State the version of these files, and refuse a plugin of another one: they were exchanged while QGIS ran."""
    stated = re.search(r"^version=(.+)$", (PLUGIN_FOLDER / "metadata.txt").read_text(encoding="utf-8"), re.MULTILINE)
    version = stated[1].strip() if stated else ""
    say(event="hello", version=version)
    if plugin != version:
        message = f"QGIS runs version {plugin} of the plugin, but its files are of version {version}."
        say(event="error", message=message, remedy="Restart QGIS.")
        sys.exit(2)


def main(arguments: list[str]) -> None:
    """Run a subcommand of the console command; a library that is missing is an error the user can act on."""
    if arguments[:1] == [ATTACHED]:
        arguments = arguments[1:]
        attach()
    if arguments[:1] == [OF_PLUGIN]:
        agree(arguments[1])
        arguments = arguments[2:]
    sys.argv = [PACKAGE, *arguments]
    try:
        from tetratrack.scripts.cli import main as command
    except ModuleNotFoundError as error:
        say(
            event="error",
            message=f"The engine's Python environment ({sys.prefix}) lacks the library {error.name}.",
            remedy="Create the environment again in Settings > Options > Tetratrack, or choose another Python there.",
        )
        sys.exit(2)
    command()


# worker processes import this file under another name and need the package too
load_package()

if __name__ == "__main__":
    main(sys.argv[1:])
