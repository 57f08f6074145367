"""Translation of everything the user reads: one context, English source, ``tr("...")`` around constant strings only.

``scripts/dev/translations.py`` collects the strings of every ``tr`` call with a constant argument into i18n/*.ts; placeholders are
named, as in ``tr("{legs} broken").format(legs=3)``. What agrees with a number in some language is written with ``%n`` and the number,
as in ``tr("%n lost", 3)``; the English words, which have no catalogue, must be right for one and for many.
"""

from __future__ import annotations

from pathlib import Path

from qgis.core import QgsApplication
from qgis.PyQt.QtCore import QCoreApplication, QTranslator

CONTEXT = "tetratrack"
LANGUAGES = ("ja", "ko", "zh-Hans", "fr", "pt", "es")
"""Languages shipped besides English, as QGIS names them; a region such as pt_BR uses its language."""


def tr(text: str, count: int | None = None) -> str:
    """Translate an English source string into QGIS's language, with a count in the form that agrees with ``count``, written for ``%n``."""
    if count is None:
        return QCoreApplication.translate(CONTEXT, text)
    return QCoreApplication.translate(CONTEXT, text, None, count)


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
