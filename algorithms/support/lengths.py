"""Lengths in the one unit that the user chose for the project: in tables and plots, on the map and in its legend."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from qgis.core import Qgis, QgsExpressionContextUtils, QgsProject, QgsSettings, QgsUnitTypes
from qgis.PyQt.QtCore import QLocale

SENSIBLE_DECIMALS = {
    Qgis.DistanceUnit.Meters: 4,
    Qgis.DistanceUnit.Centimeters: 2,
    Qgis.DistanceUnit.Millimeters: 1,
    Qgis.DistanceUnit.Feet: 4,
    Qgis.DistanceUnit.Inches: 3,
}
"""Units that displacements are stated in, and the most decimals that mean anything in them."""
MOST_DECIMALS = 7
"""Of a length that :meth:`LengthFormat.telling` writes."""
UNKNOWN = "–"
"""Stands for a length that is not known."""
FACTOR, UNIT, DECIMALS = "tetratrack_factor", "tetratrack_unit", "tetratrack_decimals"
"""Variables of the project by which labels and map tips of the shipped styles write lengths."""


@dataclass(frozen=True)
class LengthFormat:
    """How lengths are written: factor from metres, unit and decimals."""

    factor: float
    suffix: str
    decimals: int

    def number(self, metres: float | None) -> str:
        """The bare number; a dash where a length is not known."""
        if metres is None:
            return UNKNOWN
        return decimal(metres * self.factor, self.decimals)

    def signed(self, metres: float) -> str:
        """The bare number with its sign."""
        return decimal(metres * self.factor, self.decimals, signed=True)

    def telling(self, smallest: float | None) -> LengthFormat:
        """The same with as many decimals more as a length of ``smallest`` metres needs to be told from none."""
        if not smallest or not math.isfinite(smallest):
            return self
        needed = next((n for n in range(self.decimals, MOST_DECIMALS) if round(abs(smallest) * self.factor, n) > 0), MOST_DECIMALS)
        return replace(self, decimals=needed)

    def text(self, metres: float | None) -> str:
        """Number and unit; a dash where a length is not known."""
        return UNKNOWN if metres is None else f"{self.number(metres)} {self.suffix}"


def decimal(value: float, decimals: int, *, signed: bool = False) -> str:
    """A number with the decimal sign of the user's country, as QGIS writes it beside on the map and in its own fields."""
    locale = QLocale()
    locale.setNumberOptions(QLocale.NumberOption.OmitGroupSeparator)
    # adding zero turns the negative zero of small values into zero
    rounded = round(value, decimals) + 0.0
    return ("+" if signed and rounded >= 0 else "") + str(locale.toString(float(rounded), "f", decimals))


def length_format() -> LengthFormat:
    """Lengths as the project's distance unit and QGIS's measurement decimals ask; metres where that unit is none for a displacement."""
    unit = QgsProject.instance().distanceUnits()
    if unit not in SENSIBLE_DECIMALS:
        unit = Qgis.DistanceUnit.Meters
    factor = QgsUnitTypes.fromUnitToUnitFactor(Qgis.DistanceUnit.Meters, unit)
    decimals = QgsSettings().value("qgis/measure/decimalplaces", 3, type=int)
    return LengthFormat(factor, QgsUnitTypes.toAbbreviatedString(unit), max(0, min(int(decimals), SENSIBLE_DECIMALS[unit])))


def write_project_lengths(project: QgsProject) -> None:
    """Tell the project's labels and map tips in which unit it states lengths."""
    lengths = length_format()
    for name, value in ((FACTOR, lengths.factor), (UNIT, lengths.suffix), (DECIMALS, lengths.decimals)):
        if QgsExpressionContextUtils.projectScope(project).variable(name) != value:
            QgsExpressionContextUtils.setProjectVariable(project, name, value)


def round_below(value: float) -> float:
    """Largest of 1, 2 or 5 times a power of ten not above a positive value."""
    power = 10.0 ** math.floor(math.log10(max(value, 1e-9)))
    return next(step * power for step in (5, 2, 1) if step * power <= value * (1 + 1e-9))
