# SPDX-License-Identifier: BSD-3-Clause
"""Export of results to VTK image files, for programs that cannot open result.vtkhdf, such as older ParaViews."""

from __future__ import annotations

from collections.abc import Mapping, Sequence, Set
from pathlib import Path
from typing import Literal

import click
import numpy as np
from numpy.typing import NDArray
from pyevtk.vtk import VtkFile, VtkGroup, VtkImageData

from brinell.errors import InputError
from brinell.results import Labelled, Run, open_run
from brinell.results.blocks import layer_thickness
from brinell.results.snapshots import component_of

__all__ = ["export", "export_vti"]

Body = Literal["lower", "upper"]

_BODIES: tuple[Body, ...] = ("lower", "upper")


def export_vti(run: Run, folder: str | Path, *, fields: Sequence[str] | None = None) -> list[Path]:
    """Writes the stored states as VTK image files.

    The lower body is below z = 0, the upper one above it. A volume has one value per cell. A surface is a sheet of
    points at the cell centres, which can be warped by its values. A tensor is written as six scalars (``stress_xx``,
    ...) in the body's own axes, with z into the body.

    Args:
        run: run with stored fields.
        folder: output folder, which is made if it does not exist.
        fields: names of fields as in `Run.field`; None: all.

    Returns:
        Paths of the collections over time (.pvd), one for each volume and surface, which can be opened in ParaView. The
        time is the step number; the final state has the number after the last step.

    Raises:
        RunError: the run holds no fields.
        InputError: no body has a field of that name.
        OSError: a file cannot be written.
    """
    folder = Path(folder)
    wanted = {body: _wanted(run, body, fields) for body in _BODIES}
    exported = {field.name for chosen in wanted.values() for field in chosen}
    unknown = sorted(name for name in set(fields or ()) - exported if not _is_part_of(exported, name))
    if unknown:
        known = sorted({name for body in _BODIES for name in run.field_names(body)})
        raise InputError(
            f"{run.path}: no field {unknown[0]!r} to export; allowed: {', '.join(known)}, and components as stress_xx"
        )
    folder.mkdir(parents=True, exist_ok=True)
    written = []
    for body, chosen in wanted.items():
        for name, is_volume in (("volume", True), ("surface", False)):
            part = [field for field in chosen if ("z" in field.dims) == is_volume]
            if part:
                written.append(_write_collection(folder, f"{body}_{name}", part, below=body == "lower"))
    return written


def _is_part_of(names: Set[str], name: str) -> bool:
    """Whether a name is a component of one of the tensors in `names`."""
    component = component_of(name)
    return component is not None and component[0] in names


def _wanted(run: Run, body: Body, fields: Sequence[str] | None) -> list[Labelled]:
    """Requested fields of a body; a component is not repeated if its whole tensor is requested."""
    stored = run.field_names(body)
    if fields is None:
        return [run.field(body, name) for name in stored]
    chosen = [name for name in stored if name in fields]
    for name in dict.fromkeys(fields):
        if _is_part_of(set(stored), name) and not _is_part_of(set(chosen), name):
            chosen.append(name)
    return [run.field(body, name) for name in chosen]


def _write_collection(folder: Path, name: str, fields: Sequence[Labelled], *, below: bool) -> Path:
    """Writes all states of one grid, which is below or above z = 0."""
    collection = VtkGroup(str(folder / name))
    for index, step in enumerate(fields[0].coords["step"]):
        states = [field.isel(step=index) for field in fields]
        arrays = {key: values for state in states for key, values in _scalars(state).items()}
        file = _write_image(folder / f"{name}_{step:06d}", fields[0].coords, arrays, below=below)
        collection.addFile(file, float(step))
    collection.save()
    return folder / f"{name}.pvd"


def _scalars(state: Labelled) -> dict[str, NDArray[np.float64]]:
    """Components of a field by name, with x as the first and fastest index."""
    if "component" in state.dims:
        names = [f"{state.name}_{component}" for component in state.coords["component"]]
        return dict(zip(names, (values.T for values in state.values), strict=True))
    values = state.values if "z" in state.dims else state.values[np.newaxis]
    return {state.name: values.T}


def _write_image(
    path: Path, coords: Mapping[str, NDArray[np.float64]], arrays: Mapping[str, NDArray[np.float64]], *, below: bool
) -> str:
    """Writes one image file and returns its name with the extension."""
    first = tuple(float(coords[axis][0]) if axis in coords else 0.0 for axis in "xyz")
    spacing = _spacing(coords)
    shape = next(iter(arrays.values())).shape
    if "z" not in coords:
        return _write_vti(path, "Point", tuple(n - 1 for n in shape), first, spacing, arrays)
    left, front, top = (x - 0.5 * dx for x, dx in zip(first, spacing, strict=True))
    if below:  # the last index is the depth, which points down
        arrays = {name: np.asfortranarray(values[:, :, ::-1]) for name, values in arrays.items()}
        top = -float(coords["z"][-1]) - 0.5 * spacing[2]
    return _write_vti(path, "Cell", shape, (left, front, top), spacing, arrays)


def _spacing(coords: Mapping[str, NDArray[np.float64]]) -> tuple[float, float, float]:
    """Cell sizes [m]. A single row is drawn as wide as its cells are long, because its period may be a metre."""
    dx = float(np.ptp(coords["x"][:2]))
    dy = float(np.ptp(coords["y"][:2])) if len(coords["y"]) > 1 else dx
    return dx, dy, layer_thickness(coords["z"], dx) if "z" in coords else 1.0


def _write_vti(
    path: Path,
    kind: Literal["Cell", "Point"],
    end: tuple[int, ...],
    origin: tuple[float, ...],
    spacing: tuple[float, ...],
    arrays: Mapping[str, NDArray[np.float64]],
) -> str:
    """Replacement of pyevtk's imageToVTK, which mistakes cells of a few nanometres for a missing dimension."""
    file = VtkFile(str(path), VtkImageData)
    file.openGrid(start=(0, 0, 0), end=end, origin=origin, spacing=spacing)
    file.openPiece(start=(0, 0, 0), end=end)
    file.openData(kind, scalars=next(iter(arrays)))
    for name, values in arrays.items():
        file.addData(name, values)
    file.closeData(kind)
    file.closePiece()
    file.closeGrid()
    for values in arrays.values():
        file.appendData(values)
    file.save()
    return str(file.getFileName())


@click.command(name="export")
@click.argument("run", type=click.Path(path_type=Path))
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    default=Path("export"),
    help="Folder of the files; default: export.",
)
@click.option(
    "--field", "fields", multiple=True, help="Only this field, as stress or stress_xx; may be given several times."
)
def export(run: Path, output: Path, fields: tuple[str, ...]) -> None:
    """Write RUN, a result folder or file, as .vti and .pvd files.

    Open the .pvd files. ParaView from 6.0 on opens result.vtkhdf itself.
    """
    for path in export_vti(open_run(run, allow_unfinished=True), output, fields=fields or None):
        click.echo(path)
