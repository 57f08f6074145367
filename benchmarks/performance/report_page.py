"""What the web page of a report asks of a browser: processor time from its start to a window's picture, beside that of an empty page.

    python benchmarks/performance/report_page.py [UNITS...]

A headless Chromium without a graphics processor; all its processes count. The least of three: what else the machine does only adds.
"""

from __future__ import annotations

import argparse
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests/helpers"))

from synthetic_result import write_result
from tetratrack.core.report.report import ReportOptions, write_report

REPEAT = 3
COUNTED = """
import ctypes, os, resource, subprocess, sys
ctypes.CDLL(None).prctl(36, 1, 0, 0, 0)  # PR_SET_CHILD_SUBREAPER: what the browser leaves behind comes to this process and counts
subprocess.run(sys.argv[1:], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
try:
    while True:
        os.wait()
except ChildProcessError:
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    print(used.ru_utime + used.ru_stime)
"""


def processor_seconds(browser: str, page: Path) -> float:
    """Least processor time of all processes of a browser that shows a page, in seconds."""
    return min(_once(browser, page) for _ in range(REPEAT))


def _once(browser: str, page: Path) -> float:
    with tempfile.TemporaryDirectory() as folder:
        command = [browser, "--headless", "--no-sandbox", "--disable-gpu-rasterization", "--enable-unsafe-swiftshader"]
        command += [f"--user-data-dir={folder}", "--window-size=1200,900", f"--screenshot={folder}/window.png", page.as_uri()]
        counted = subprocess.run([sys.executable, "-c", COUNTED, *command], capture_output=True, text=True, timeout=300, check=True)
        return float(counted.stdout)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("units", nargs="*", type=int, default=[100, 1000])
    options = parser.parse_args()
    browser = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    if browser is None:
        parser.error("needs a Chromium: apt-get install chromium")
    print("| units | MB | CPU s | x empty page |\n| --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as name:
        empty = Path(name) / "empty.html"
        empty.write_text("<p>", encoding="utf-8")
        floor = processor_seconds(browser, empty)
        print(f"| 0 | 0.0 | {floor:.2f} | 1.0 |")
        for units in options.units:
            result = Path(name) / f"{units}.gpkg"
            write_result(result, units, 2)
            page = result.with_suffix(".html")
            write_report(result, page, ReportOptions(worst=8))
            seconds = processor_seconds(browser, page)
            print(f"| {units} | {page.stat().st_size / 1e6:.1f} | {seconds:.2f} | {seconds / floor:.1f} |", flush=True)


if __name__ == "__main__":
    main()
