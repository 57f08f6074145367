"""As-built model of a result in the format that the ending of the file names."""

from __future__ import annotations

from pathlib import Path

from ..armour.as_built import AsBuilt, read_as_built
from ..common.atomic_files import write_whole
from ..common.errors import InputError, OutputError
from ..common.output_files import check_own
from .model_dxf import DXF_MARK, dxf
from .model_glb import GLB_MARK, glb
from .model_ifc import IFC_MARK, ifc
from .model_text import OBJ_MARK, POSES_MARK, obj, poses

MARKS = {".glb": GLB_MARK, ".obj": OBJ_MARK, ".dxf": DXF_MARK, ".ifc": IFC_MARK, ".json": POSES_MARK}
"""By ending, what every model begins with: other programs that write a model again leave it out, or name themselves."""
ENDINGS = tuple(MARKS)


def write_model(result: Path, output: Path, epoch: str | None = None) -> AsBuilt:
    """Write the units of one epoch, by default the latest with units.

    Raises
    ------
    InputError
        The result cannot be read or has no such epoch, or the ending is unknown.
    OutputError
        The file cannot be written, is another one than an earlier model, or a library that its format needs is missing.
    """
    kind = output.suffix.lower()
    if kind not in ENDINGS:
        wrong = kind or "a file without ending"
        raise InputError(f"cannot be written as {wrong}", source=output, remedy=f"End the name in one of {', '.join(ENDINGS)}.")
    if not output.parent.is_dir():
        raise OutputError("cannot be written (its folder does not exist)", source=output, remedy="Choose a folder that exists.")
    check_own(output, (MARKS[kind],))
    model = read_as_built(result, epoch)
    writers = {".obj": obj, ".dxf": dxf, ".ifc": ifc, ".json": poses}
    write_whole(output, glb(model) if kind == ".glb" else writers[kind](model).encode("utf-8"))
    return model
