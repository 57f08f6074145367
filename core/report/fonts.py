"""Fonts of this machine for the characters of a figure: nothing is drawn as an empty box while a font for it is installed."""

from __future__ import annotations

import unicodedata
from collections.abc import Callable, Iterable
from functools import lru_cache
from pathlib import Path

from matplotlib import font_manager
from matplotlib.ft2font import FT2Font

STANDARD = "DejaVu Sans"
"""Comes with matplotlib and covers Latin, Greek and Cyrillic."""
UNLIKE_IT = ("serif", "mincho", "ming", "song", "mono", "bold", "black", "thin", "light", "italic", "oblique")
"""Words in the names of files whose letters stand out beside the standard font's; taken only where nothing else covers as much."""


def families_for(texts: Iterable[str]) -> list[str]:
    """Font families that together cover the characters of some texts, the standard one first."""
    return [STANDARD, *covering(_beyond_standard(texts))[0]]


def is_drawable(text: str) -> bool:
    """Whether some font of this machine has every letter of a text."""
    return not covering(_beyond_standard([text]))[1]


def drawable(text: str) -> str:
    """A text with the letters that no font has written in Latin ones after their Unicode names: Bom for 봄, U+6625 for 春."""
    lacking = covering(_beyond_standard([text]))[1]
    return "".join(_in_latin(letter) if ord(letter) in lacking else letter for letter in text)


def drawable_words(translate: Callable[[str], str]) -> Callable[[str], str]:
    """Translation that stays in English where no font has the letters."""

    def words(text: str) -> str:
        translated = translate(text)
        return translated if is_drawable(translated) else text

    return words


def _in_latin(letter: str) -> str:
    name = unicodedata.name(letter, "")
    return f"U+{ord(letter):04X}" if not name or "IDEOGRAPH" in name else name.split()[-1].capitalize()


def _beyond_standard(texts: Iterable[str]) -> frozenset[int]:
    standard = _standard_letters()
    return frozenset(ord(letter) for text in texts for letter in text if ord(letter) not in standard and not letter.isspace())


@lru_cache(maxsize=1)
def _standard_letters() -> frozenset[int]:
    return frozenset(FT2Font(font_manager.findfont(STANDARD)).get_charmap())


@lru_cache(maxsize=256)
def covering(missing: frozenset[int]) -> tuple[tuple[str, ...], frozenset[int]]:
    """Families of installed fonts for characters (code points), the one that covers most first; and the characters that none has."""
    if not missing:
        return (), frozenset()
    covers: dict[str, frozenset[int]] = {}
    # matplotlib's own list is made once and knows no font installed later
    for path in sorted(font_manager.findSystemFonts()):
        try:
            found = missing.intersection(FT2Font(path).get_charmap())
        except (OSError, RuntimeError):
            continue
        if found:
            covers[path] = found
    chosen: list[str] = []
    left = set(missing)
    while left and covers:
        best = min(covers, key=lambda path: (-len(left & covers[path]), sum(word in Path(path).name.lower() for word in UNLIKE_IT), path))
        if not left & covers[best]:
            break
        font_manager.fontManager.addfont(best)
        chosen.append(FT2Font(best).family_name)
        left -= covers.pop(best)
    return tuple(chosen), frozenset(left)
