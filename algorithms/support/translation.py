"""Translation of everything the user reads: one context, English source, ``tr("...")`` around constant strings only.

``scripts/dev/translations.py`` collects the strings of every ``tr`` call with a constant argument into i18n/*.ts; placeholders are
named, as in ``tr("{count} units").format(count=3)``.
"""

from __future__ import annotations

from pathlib import Path

from qgis.core import QgsApplication
from qgis.PyQt.QtCore import QCoreApplication, QTranslator

CONTEXT = "tetratrack"
LANGUAGES = ("ja", "ko", "zh-Hans", "fr", "pt", "es")
"""Languages shipped besides English, as QGIS names them; a region such as pt_BR uses its language."""


def tr(text: str) -> str:
    """Translate an English source string into QGIS's language."""
    return QCoreApplication.translate(CONTEXT, text)


def language_of(locale: str) -> str | None:
    """Shipped language for a locale name of QGIS, None for English and for languages that are not shipped."""
    name = locale.replace("-", "_")
    if name.lower() in ("zh", "zh_cn", "zh_sg") or name.lower().startswith("zh_hans"):
        return "zh-Hans"
    language = name.split("_")[0]
    return language if language in LANGUAGES else None


def user_locale() -> str:
    """Locale QGIS was started with: command line, the user's setting, or the system's."""
    return QgsApplication.instance().translation() or QgsApplication.locale()


def load_translator(folder: Path, locale: str) -> QTranslator | None:
    """Translator for a locale from ``folder``; None where no translation is shipped or built."""
    language = language_of(locale)
    if language is None:
        return None
    translator = QTranslator()
    return translator if translator.load(str(folder / f"tetratrack_{language}.qm")) else None
