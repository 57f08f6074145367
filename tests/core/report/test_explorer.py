"""The web page of the report in a headless Chromium: choices in map, table and scene go together, and its console is quiet."""

from __future__ import annotations

import base64
import hashlib
import json
import re
import shutil
import subprocess
from pathlib import Path

import pytest
from synthetic_result import write_result
from tetratrack.core.report.report import ReportOptions, write_report
from tetratrack.core.results.geopackage_reader import EpochPair
from tetratrack.core.results.unit_rows import read_unit_rows

BROWSER = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
PAIR = EpochPair("2023-04-09", "2024-04-09")
WALK = """<script>
window.addEventListener("load", () => setTimeout(() => {
  const out = {}, find = (query) => document.querySelector(query);
  out.waits = find("#scene canvas").width === 300 && find("#scene-missing").hidden;
  find("#scene").scrollIntoView();
  setTimeout(() => {
  const units = JSON.parse(find("#explorer-data").textContent).units;
  const drawn = [...document.querySelectorAll(".map-units .unit")];
  out.drawn = drawn.length;
  const k = units.findIndex((u) => u.id === "UNIT");
  drawn[k].dispatchEvent(new PointerEvent("pointermove", { bubbles: true, clientX: 200, clientY: 300 }));
  out.tip = find(".tip").hidden ? null : find(".tip").textContent;
  drawn[k].dispatchEvent(new MouseEvent("click", { bubbles: true }));
  out.row = find("#units-table tr.chosen").cells[0].textContent;
  const before = find(".map-units").getAttribute("viewBox");
  find("[data-map=in]").click();
  out.zoomed = Number(find(".map-units").getAttribute("viewBox").split(" ")[2]) / Number(before.split(" ")[2]);
  // names of the lines along the lower edge, however far one zooms
  const gaps = [];
  for (let k = 0; k < 45; k++) {
    find("#map").dispatchEvent(new WheelEvent("wheel", { deltaY: -40, clientX: 300, clientY: 300, cancelable: true }));
    const names = [...document.querySelectorAll(".map-frame text[text-anchor]")].filter((t) => /^[0-9.]+$/.test(t.textContent));
    const boxes = names.map((t) => t.getBoundingClientRect()).sort((one, other) => one.left - other.left);
    for (let j = 1; j < boxes.length; j++) gaps.push(boxes[j].left - boxes[j - 1].right);
  }
  out.gaps = gaps.length;
  out.narrowest = Math.min(...gaps);
  find("[data-map=fit]").click();
  const least = find("#filter-least");
  least.value = "10";
  least.dispatchEvent(new Event("input"));
  out.count = find("#count").textContent;
  out.dimmed = document.querySelectorAll(".unit.dimmed").length;
  find("[data-key=id]").click();
  out.first = find("#units-table tbody tr").cells[0].textContent;
  find("[data-key=id]").click();
  out.last = find("#units-table tbody tr").cells[0].textContent;
  find("#units-table tbody tr").click();
  out.chosen = units[find(".unit.chosen").dataset.unit].id;
  // a busy machine draws the scene late, and the page's clock runs ahead of it: every look takes a little of true time
  const look = (tries) => {
    const canvas = find("#scene canvas"), gl = GL;
    out.missing = !find("#scene-missing").hidden;
    let waiting = !gl && !out.missing;
    if (gl) {
      const pixels = new Uint8Array(4 * 300 * 300);
      gl.readPixels(canvas.width / 2 - 150, canvas.height / 2 - 150, 300, 300, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
      const shades = new Set();
      for (let j = 0; j < pixels.length; j += 4) shades.add(pixels[j] + " " + pixels[j + 1] + " " + pixels[j + 2]);
      out.shades = shades.size;
      waiting = shades.size === 1;
    }
    if (waiting && tries > 0) {
      setTimeout(look, 250, tries - 1);
      return;
    }
    const told = document.createElement("pre");
    told.id = "outcome";
    told.textContent = JSON.stringify(out);
    document.body.appendChild(told);
  };
  setTimeout(look, 500, 1000);
  }, 1000);
}, 200));
</script></body>"""

pytestmark = pytest.mark.skipif(BROWSER is None, reason="needs a Chromium")


@pytest.fixture(scope="module")
def result(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("explorer") / "result.gpkg"
    write_result(path, 60, 2)
    write_report(path, path.with_suffix(".html"), ReportOptions(worst=1))
    return path


def _walk(result: Path, tmp_path: Path, unit: str, *, scene: bool) -> tuple[dict, list[str]]:
    """Outcome of a walk through the page, and what the browser's console said."""
    page = result.with_suffix(".html").read_text(encoding="utf-8")
    script = WALK.replace("UNIT", unit).replace("GL", 'canvas.getContext("webgl")' if scene else "null")
    copy = tmp_path / "walk.html"
    # the page's policy lets its own script run and no other: the walk is let in by its hash
    walk = script.removeprefix("<script>").split("</script>")[0]
    digest = base64.b64encode(hashlib.sha256(walk.encode("utf-8")).digest()).decode("ascii")
    assert page.count("script-src 'sha256-") == 1
    page = page.replace("script-src ", f"script-src 'sha256-{digest}' ")
    copy.write_text(page.replace("</body>", script), encoding="utf-8")
    graphics = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"] if scene else ["--disable-3d-apis", "--disable-gpu"]
    command = [str(BROWSER), "--headless", "--no-sandbox", *graphics, f"--user-data-dir={tmp_path / 'profile'}", "--enable-logging=stderr"]
    done = subprocess.run(
        [*command, "--virtual-time-budget=300000", "--dump-dom", copy.as_uri()], capture_output=True, text=True, timeout=300, check=True
    )
    found = re.search(r'<pre id="outcome">(.*?)</pre>', done.stdout, re.S)
    assert found, done.stderr[-2000:]
    text = found[1].replace("&lt;", "<").replace("&amp;", "&")
    return json.loads(text), [line for line in done.stderr.splitlines() if "CONSOLE" in line]


def test_map_table_and_scene_follow_each_other(result: Path, tmp_path: Path) -> None:
    rows = read_unit_rows(result, PAIR, "stable")
    moved = max((row for row in rows if row.d_3d is not None), key=lambda row: row.d_3d or 0)
    outcome, console = _walk(result, tmp_path, moved.unit_id, scene=True)
    assert console == []
    assert outcome["waits"]
    assert outcome["drawn"] == len(rows)
    assert moved.unit_id in outcome["tip"]
    assert f"{100 * moved.d_3d:.1f} ± {100 * moved.sd_3d:.1f} cm" in outcome["tip"]
    assert outcome["row"] == moved.unit_id
    assert outcome["zoomed"] == pytest.approx(1 / 1.5)
    assert outcome["gaps"] > 10
    assert outcome["narrowest"] > 2
    far = sum(row.d_3d is not None and row.d_3d >= 0.10 for row in rows)
    assert outcome["count"] == f"{far} of {len(rows)} units"
    assert outcome["dimmed"] == len(rows) - far
    names = sorted(row.unit_id for row in rows)
    assert (outcome["first"], outcome["last"], outcome["chosen"]) == (names[0], names[-1], names[-1])
    assert not outcome["missing"]
    assert outcome["shades"] > 50


@pytest.mark.parametrize("units", [200, pytest.param(1000, marks=pytest.mark.slow)])
def test_the_page_of_many_units_is_small_and_works(tmp_path: Path, units: int) -> None:
    path = tmp_path / "result.gpkg"
    write_result(path, units, 2)
    write_report(path, path.with_suffix(".html"), ReportOptions(worst=8))
    page = path.with_suffix(".html")
    assert page.stat().st_size < 15e6 * max(units / 1000, 0.5)
    middle = f"U{units // 2:05d}"
    outcome, console = _walk(path, tmp_path, middle, scene=True)
    assert console == []
    assert outcome["row"] == middle
    assert outcome["drawn"] > 0.9 * units


def test_without_webgl_the_picture_stands_for_the_scene(result: Path, tmp_path: Path) -> None:
    outcome, _ = _walk(result, tmp_path, "U00001", scene=False)
    assert outcome["missing"]
    assert outcome["row"] == "U00001"


def test_the_page_needs_nothing_from_outside(result: Path) -> None:
    page = result.with_suffix(".html").read_text(encoding="utf-8")
    assert not re.findall(r"""(?:src|href)\s*=\s*["'](?!data:|#)""", page)
    assert "fetch(" not in page
    assert "url(" not in page.replace("url(data:", "")
