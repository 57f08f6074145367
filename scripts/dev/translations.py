"""Collect the interface's strings into i18n/*.ts and build the .qm files: run after any change of a string.

``collect`` reads every ``tr("...")`` call with a constant argument and keeps existing translations; ``build`` calls lrelease. Texts with
``%n`` have a translation for every form that the language's numbers ask for.
"""

from __future__ import annotations

import ast
import re
import shutil
import subprocess  # nosec B404 - lrelease is started with a fixed list of arguments
import sys
import xml.etree.ElementTree as ET  # nosec B405 - reads the repository's own files
from collections.abc import Iterator
from pathlib import Path
from string import Formatter

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / "i18n"
CONTEXT = "tetratrack"
LANGUAGES = {"ja": "ja_JP", "ko": "ko_KR", "zh-Hans": "zh_CN", "fr": "fr_FR", "pt": "pt_PT", "es": "es_ES"}
"""Languages as QGIS names them, and as Qt's tools do."""
COUNT = "%n"
"""Where a number stands in a text whose words agree with it."""
FORMS = {"ja": 1, "ko": 1, "zh-Hans": 1}
"""Forms of a text with a number, two where a language is not named: for one, which in French is for none as well, and for more."""
SOURCES = ("algorithms", "plugin", "core")
REPORT_TEXT = re.compile(r'(?<![\w.])_\("([^"\\]*)"\)')
"""The report's texts: constant arguments of ``_`` in its templates and figures."""


def strings_of(path: Path) -> Iterator[str]:
    """Constant arguments of ``tr`` calls in a module.

    Raises
    ------
    ValueError
        A ``tr`` call whose argument is not a constant string: it could not be translated.
    """
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "tr":
            argument = node.args[0]
            if not (isinstance(argument, ast.Constant) and isinstance(argument.value, str)):
                raise ValueError(f"{path.name}, line {node.lineno}: tr() needs a constant string")
            yield argument.value


def source_strings() -> dict[str, str]:
    """All strings of the interface with the module they come from, in order of modules."""
    found: dict[str, str] = {}
    for folder in SOURCES:
        for path in sorted((ROOT / folder).rglob("*.py")):
            for text in strings_of(path):
                found.setdefault(text, path.relative_to(ROOT).as_posix())
    report = ROOT / "core" / "report"
    for path in [*sorted((report / "templates").glob("*.html")), *sorted(report.glob("*figures.py"))]:
        for text in REPORT_TEXT.findall(path.read_text(encoding="utf-8")):
            found.setdefault(text, path.relative_to(ROOT).as_posix())
    return found


def translations(language: str) -> dict[str, tuple[str, ...]]:
    """Finished translations of a language by source string: one, or with a number one for each form."""
    path = ts_path(language)
    if not path.exists():
        return {}
    messages = ET.parse(path).getroot().iter("message")  # noqa: S314  # nosec B314 - the repository's own file
    pairs = ((m.findtext("source") or "", m.find("translation")) for m in messages)
    finished = {source: node for source, node in pairs if node is not None and node.get("type") is None}
    found = {source: tuple(form.text or "" for form in node.findall("numerusform") or [node]) for source, node in finished.items()}
    return {source: texts for source, texts in found.items() if len(texts) == forms_of(source, language) and all(texts)}


def forms_of(source: str, language: str) -> int:
    """How many translations a string has."""
    return FORMS.get(language, 2) if COUNT in source else 1


def ts_path(language: str) -> Path:
    """File of a language."""
    return FOLDER / f"tetratrack_{language}.ts"


def placeholders(text: str) -> list[str]:
    """Sorted names of the placeholders of a format string."""
    return sorted(name for _, name, _, _ in Formatter().parse(text) if name is not None)


def write(language: str, known: dict[str, tuple[str, ...]]) -> None:
    """Write a .ts file with the current strings; those without a translation are marked unfinished."""
    root = ET.Element("TS", version="2.1", language=LANGUAGES[language], sourcelanguage="en")
    context = ET.SubElement(root, "context")
    ET.SubElement(context, "name").text = CONTEXT
    for source, module in source_strings().items():
        message = ET.SubElement(context, "message")
        ET.SubElement(message, "location", filename=f"../{module}")
        ET.SubElement(message, "source").text = source
        translation = ET.SubElement(message, "translation")
        texts = known.get(source, ("",) * forms_of(source, language))
        if source not in known:
            translation.set("type", "unfinished")
        if COUNT not in source:
            translation.text = texts[0]
            continue
        message.set("numerus", "yes")
        for text in texts:
            ET.SubElement(translation, "numerusform").text = text
    ET.indent(root)
    text = '<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n' + ET.tostring(root, encoding="unicode") + "\n"
    ts_path(language).write_text(text, encoding="utf-8")


def collect() -> None:
    """Bring all .ts files up to date."""
    for language in LANGUAGES:
        known = translations(language)
        write(language, known)
        missing = [source for source in source_strings() if source not in known]
        print(f"{language}: {len(missing)} without translation")


def build(target: Path) -> list[Path]:
    """Build the .qm files into a folder with lrelease.

    Raises
    ------
    FileNotFoundError
        lrelease is not installed.
    """
    tool = shutil.which("lrelease") or shutil.which("lrelease-qt5") or shutil.which("lrelease-qt6")
    if tool is None:
        raise FileNotFoundError("lrelease is not installed; on Debian: apt-get install qttools5-dev-tools")
    target.mkdir(parents=True, exist_ok=True)
    built = []
    for language in LANGUAGES:
        path = target / f"tetratrack_{language}.qm"
        subprocess.run([tool, "-silent", str(ts_path(language)), "-qm", str(path)], check=True)  # nosec B603
        built.append(path)
    return built


if __name__ == "__main__":
    if sys.argv[1:] == ["build"]:
        build(FOLDER)
    else:
        collect()
