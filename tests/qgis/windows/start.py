"""What QGIS runs first: the script the environment names (TETRATRACK_SCRIPT), whose failure is told instead of waiting in a message box."""

import json
import os
import traceback
from pathlib import Path

script = Path(os.environ["TETRATRACK_SCRIPT"])
try:
    exec(compile(script.read_text(encoding="utf-8"), str(script), "exec"), {"__name__": "window_script", "__file__": str(script)})  # noqa: S102
except BaseException:
    answer = {"failed": traceback.format_exc(), "python_errors": []}
    (Path(os.environ["TETRATRACK_WINDOW"]) / "answer.json").write_text(json.dumps(answer), encoding="utf-8")
    os._exit(1)
