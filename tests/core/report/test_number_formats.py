"""Names and probabilities in tables of the report."""

from __future__ import annotations

from jinja2 import Environment
from tetratrack.core.report.number_formats import number_formats


def written(template: str, value: object) -> str:
    environment = Environment(autoescape=True)
    environment.filters.update(number_formats(2.0))
    return environment.from_string(template).render(value=value)


def test_long_names_may_be_broken_and_lose_no_letter() -> None:
    long = "north_breakwater<3>_unit_0042"
    cell = written("{{ value|name }}", long)
    assert cell.replace("<wbr>", "") == long.replace("<", "&lt;").replace(">", "&gt;")
    assert max(len(part) for part in cell.replace("&lt;", "<").replace("&gt;", ">").split("<wbr>")) == 8
    assert written("{{ value|name }}", "2025-03-14 a<b") == "2025-03-14 a&lt;b"


def test_no_probability_is_certain() -> None:
    assert [written("{{ value|probability }}", p) for p in (None, 0.0001, 0.62, 0.99999)] == ["–", "&lt; 0.1 %", "62.0 %", "&gt; 99.9 %"]


def test_short_names_stay_on_one_line_of_their_cell() -> None:
    assert written("{{ value|name_cell }}", "2025-03 a<b") == '<td class="whole">2025-03 a&lt;b</td>'
    assert [written("{{ value|name_cell }}", n * "a").startswith('<td class="whole">') for n in (16, 17)] == [True, False]
    assert written("{{ value|name_cell }}", "north_breakwater_0042") == "<td>north_br<wbr>eakwater<wbr>_0042</td>"
