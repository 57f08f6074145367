"""Types of the whole project, checked by mypy under the names by which modules import one another.

.venv/bin/python scripts/dev/types.py

The repository root is the plugin folder, and a checkout may have any name: mypy sees it through a link named as the package. QGIS has no
types to be had, so what comes from it is `Any`; what the plugin does with it is checked all the same.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PACKAGES = ("core", "algorithms", "plugin", "scripts")


def main() -> int:
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "tetratrack").symlink_to(ROOT, target_is_directory=True)
        names = [argument for package in PACKAGES for argument in ("--package", f"tetratrack.{package}")]
        options = ["--config-file", str(ROOT / "pyproject.toml"), "--cache-dir", str(ROOT / ".mypy_cache"), *names]
        environment = {**os.environ, "MYPYPATH": folder}
        return subprocess.run([sys.executable, "-m", "mypy", *options], cwd=folder, env=environment, check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
