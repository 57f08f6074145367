"""Start the engine as a process of its own, whatever this folder is called and whether or not it is installed.

QGIS starts ``python -I scripts/engine.py SUBCOMMAND ... --json-progress`` in the engine's own environment. Standard input is the
line to the parent: the word ``cancel`` or its end (QGIS closed or crashed) stops the engine with all its workers.
"""

from __future__ import annotations

import importlib.util
import json
import os
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
    for line in sys.stdin:
        if line.strip() == "cancel":
            break
    signal.raise_signal(signal.SIGINT)
    threading.Event().wait(GRACE_SECONDS)
    # compiled code does not see the interrupt; the results are still in a temporary folder that the parent removes
    if hasattr(os, "killpg"):
        os.killpg(0, signal.SIGKILL)
    os._exit(CANCELLED_EXIT)


def attach() -> None:
    """Make this process the head of its own group and tie its life to the parent's."""
    if hasattr(os, "setsid"):
        os.setsid()
    threading.Thread(target=stop_with_parent, daemon=True).start()


def main(arguments: list[str]) -> None:
    """Run a subcommand of the console command; a library that is missing is an error the user can act on."""
    if arguments[:1] == [ATTACHED]:
        arguments = arguments[1:]
        attach()
    sys.argv = [PACKAGE, *arguments]
    try:
        from tetratrack.scripts.cli import main as command
    except ModuleNotFoundError as error:
        report = {
            "event": "error",
            "message": f"The engine's Python environment ({sys.prefix}) lacks the library {error.name}.",
            "remedy": "Create the environment again in Settings > Options > Tetratrack, or choose another Python there.",
        }
        sys.stdout.write(json.dumps(report) + "\n")
        sys.exit(2)
    command()


# worker processes import this file under another name and need the package too
load_package()

if __name__ == "__main__":
    main(sys.argv[1:])
