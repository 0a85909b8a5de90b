# SPDX-License-Identifier: BSD-3-Clause
"""Command line of the figures: ``brinell plot``, or ``python -m brinell.plot``.

Exit code 0: all figures are written, and their paths are printed; 2: the request or a folder is wrong, and one line on
the standard error stream describes the error.
"""

from __future__ import annotations

import contextlib
import functools
import os
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, Literal, get_args

import click
import matplotlib

from brinell._names import did_you_mean
from brinell.commands import folder_of, reports_errors
from brinell.plot import animation as moving
from brinell.plot import fields as state
from brinell.plot import history as course
from brinell.plot import style
from brinell.plot.fatigue import fatigue_under_surface
from brinell.plot.interfaces import interface_tractions
from brinell.plot.planes import Plane, plane_of
from brinell.plot.points import point_histories
from brinell.plot.quantities import QUANTITIES, needs_tensors, quantity_of
from brinell.plot.scales import in_si
from brinell.plot.sections import section as draw_section
from brinell.plot.standard import standard_figures
from brinell.plot.states import Bodies, Follow, chosen_sides
from brinell.plot.where import section_of
from brinell.results import RunError, open_run
from brinell.scenarios import SCENARIOS
from brinell.scenarios.traits import Drawings

__all__ = ["plot"]


class _PlotGroup(click.Group):
    """The group of commands, in which ``brinell plot RUN`` means ``brinell plot all RUN``."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Adds the command `all` if the arguments begin with a result or an option of this command."""
        if args and args[0] not in (*self.commands, "--help"):
            word = args[0]
            if word.startswith("-") or os.sep in word or Path(word).exists():
                args = ["all", *args]
        return super().parse_args(ctx, args)

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Reports a word that is neither a command nor an existing result."""
        if args and args[0] not in self.commands:
            ctx.fail(
                f"{args[0]!r} is no folder or file of a result, and no command; "
                f"{did_you_mean(args[0], self.commands)}there are {', '.join(self.commands)}"
            )
        return super().resolve_command(ctx, args)


def _checked(convert: Callable[[str], Any]) -> Callable[[click.Context, click.Parameter, Any], Any]:
    """Callback of an option: turns its text, or each of its texts, into a value; a ValueError is wrong usage."""

    def callback(_context: click.Context, _parameter: click.Parameter, value: Any) -> Any:
        if value is None:
            return None
        try:
            return tuple(convert(text) for text in value) if isinstance(value, tuple) else convert(value)
        except ValueError as error:
            raise click.BadParameter(str(error)) from error

    return callback


def _step(text: str) -> int | str:
    if text in ("aligned", "final"):
        return text
    if text.isdecimal():
        return int(text)
    raise ValueError(f"{text!r} is neither a step number nor 'aligned' nor 'final'")


def _file_endings(text: str) -> list[str]:
    formats = [item.strip() for item in text.split(",")]
    for item in formats:
        if item not in style.FORMATS:
            raise ValueError(f"{item!r} is not one of {', '.join(style.FORMATS)}")
    return formats


def _field(text: str) -> str:
    return quantity_of(text).name


def _moving_field(text: str) -> str:
    return text if text == "pressure" else _field(text)


_run_folder = click.argument("run", type=click.Path(path_type=Path), metavar="RUN")
_run_folders = click.argument("runs", type=click.Path(path_type=Path), metavar="RUN...", nargs=-1, required=True)
_into_run = click.option(
    "-o", "--output", type=click.Path(path_type=Path), help="Folder of the figures; default: RUN/figures."
)
_into_figures = click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    default=Path("figures"),
    help="Folder of the figures; default: figures.",
)
_formats = click.option(
    "--format",
    "formats",
    metavar="LIST",
    callback=_checked(_file_endings),
    default="png",
    help=f"File types, separated by commas: {', '.join(style.FORMATS)}; default: png.",
)
_cells = click.option("--cells", is_flag=True, help="Show each cell in one colour, without interpolation.")


def _takes_si(command: Callable[..., None]) -> Callable[..., None]:
    """Adds --si to a command."""

    @click.option(
        "--si",
        "si",
        is_flag=True,
        help="Use units such as µm and MPa instead of normalising by the values at first yield.",
    )
    @functools.wraps(command)
    def wrapper(*args: Any, si: bool, **kwargs: Any) -> None:
        with in_si() if si else contextlib.nullcontext():
            command(*args, **kwargs)

    return wrapper


_plane = click.option(
    "--plane",
    callback=_checked(plane_of),
    metavar="PLANE",
    help="Plane of the section, such as 'y=0', 'x = 0.1 mm' or 'z = 20 um'; default: y=0, or through the largest "
    "plastic strain if little has yielded there.",
)
_bodies = click.option(
    "--body", "bodies", type=click.Choice(get_args(Bodies)), default="both", help="Bodies to draw; default: both."
)
_steps = click.option(
    "--step",
    "steps",
    callback=_checked(_step),
    metavar="N|aligned|final",
    multiple=True,
    default=["aligned"],
    help="State to draw: the number of a stored step; 'aligned' (default), the step in the middle of the first pass or "
    "at the largest load of the first indent; or 'final'. May be given several times.",
)


@click.group(cls=_PlotGroup)
def plot() -> None:
    """Draw figures of the results of 'brinell run'.

    'brinell plot RUN' draws all figures that suit the run; each command below draws one kind of figure.
    """
    matplotlib.use("Agg")


def _print(paths: Sequence[Path]) -> None:
    for path in paths:
        click.echo(path)


@plot.command("all")
@_run_folder
@_into_run
@_formats
@_takes_si
@reports_errors
def _all(run: Path, output: Path | None, formats: list[str]) -> None:
    """Draw all figures that suit a run, which may be unfinished."""
    for named in standard_figures(open_run(run, allow_unfinished=True)):
        _print(style.save(named.figure, output or folder_of(run) / "figures", named.name, formats))


def _several(drawings: Drawings) -> click.Command:
    """The command of a scenario, whose figures show one run or several."""

    @_run_folders
    @_into_figures
    @_formats
    @reports_errors
    def draw_them(runs: Sequence[Path], output: Path, formats: list[str]) -> None:
        opened = [open_run(path) for path in runs]
        for name, drawing in drawings.figures.items():
            figure = drawing.draw(opened)
            if figure is not None:
                _print(style.save(figure, output, name, formats))

    return click.command(name=drawings.command, help=drawings.help)(draw_them)


for _traits in SCENARIOS.values():
    if _traits.drawings is not None:
        plot.add_command(_several(_traits.drawings()))


def _state_name(which: int | str) -> str:
    return which if isinstance(which, str) else f"step-{which:06d}"


@plot.command("fields")
@_run_folder
@_steps
@_cells
@_into_run
@_formats
@_takes_si
@reports_errors
def _fields(run: Path, steps: Sequence[Any], cells: bool, output: Path | None, formats: list[str]) -> None:
    """Draw contact pressure, gap, residual surfaces, stress, plastic strain, stick and slip, and heat of one state."""
    opened = open_run(run, allow_unfinished=True)
    for which in steps:
        snapshot = opened.snapshot(which)
        for name, draw in state.FIGURES.items():
            if not state.suits(name, snapshot):
                continue
            figure = draw(opened, snapshot, cells=cells)
            _print(style.save(figure, output or folder_of(run) / "figures", f"{_state_name(which)}-{name}", formats))


@plot.command("section")
@_run_folder
@click.option(
    "--field",
    "names",
    callback=_checked(_field),
    metavar="FIELD",
    multiple=True,
    help=f"Field to draw: {', '.join(QUANTITIES)}. May be given several times; default: von Mises stress and "
    "equivalent plastic strain.",
)
@_plane
@_bodies
@_steps
@_cells
@_into_run
@_formats
@_takes_si
@reports_errors
def _section(
    run: Path,
    names: Sequence[str],
    plane: Plane | None,
    bodies: Bodies,
    steps: Sequence[Any],
    cells: bool,
    output: Path | None,
    formats: list[str],
) -> None:
    """Draw fields of the bodies on a plane."""
    opened = open_run(run, allow_unfinished=True)
    for which in steps:
        snapshot = opened.snapshot(which, tensors=needs_tensors([quantity_of(name) for name in names]))
        figure = draw_section(opened, snapshot, field=names or None, plane=plane, bodies=bodies, cells=cells)
        cut = plane or section_of(snapshot, chosen_sides(opened, snapshot, bodies)).plane
        name = "-".join([_state_name(which), "section", cut.axis, f"{1e6 * cut.value:.6g}um", *names])
        _print(style.save(figure, output or folder_of(run) / "figures", name, formats))


@plot.command("animate")
@_run_folder
@click.option(
    "--field",
    callback=_checked(_moving_field),
    metavar="FIELD",
    default="von_mises_stress",
    help="Field to draw: one of those of section, or pressure, seen from above; default: von_mises_stress.",
)
@_plane
@_bodies
@click.option(
    "--pass", "pass_", type=click.IntRange(min=1), default=1, help="Number of the pass, counted from 1; default: 1."
)
@click.option(
    "--follow",
    type=click.Choice(get_args(Follow)),
    help="Keep the contact in the middle (default for both bodies), or the body in place (default for one body).",
)
@_cells
@click.option("--fps", type=click.IntRange(min=1), default=8, help="Frames per second; default: 8.")
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    help="File of type .gif, or .mp4 (needs ffmpeg); default: RUN/figures/FIELD.gif.",
)
@_takes_si
@reports_errors
def _animate(
    run: Path,
    field: str,
    plane: Plane | None,
    bodies: Bodies,
    pass_: int,
    follow: Follow | None,
    cells: bool,
    fps: int,
    output: Path | None,
) -> None:
    """Make a moving picture of one pass from its stored states.

    With snapshots = "all" in the table [output] of the case, all states are stored.
    """
    opened = open_run(run, allow_unfinished=True)
    path = output or folder_of(run) / "figures" / f"{field}.gif"
    moving.writer_of(path)
    animation = moving.animate(opened, field=field, plane=plane, pass_=pass_, bodies=bodies, follow=follow, cells=cells)
    click.echo(moving.save_animation(animation, path, frames_per_second=fps))
    if remark := moving.remark_on(opened, pass_):
        click.echo(f"brinell: {remark}", err=True)


@plot.command("history")
@_run_folder
@_into_run
@_formats
@_takes_si
@reports_errors
def _history(run: Path, output: Path | None, formats: list[str]) -> None:
    """Draw forces, energies, deformation and cost of one run, step by step."""
    opened = open_run(run, allow_unfinished=True)
    _print(style.save(course.run_history(opened), output or folder_of(run) / "figures", "history", formats))


@plot.command("fatigue")
@_run_folder
@click.option("--body", type=click.Choice(["lower", "upper"]), default="lower", help="Body; default: lower.")
@_into_run
@_formats
@_takes_si
@reports_errors
def _fatigue(run: Path, body: Literal["lower", "upper"], output: Path | None, formats: list[str]) -> None:
    """Draw the fatigue of a body in the section through its worst point, and over the depth."""
    opened = open_run(run)
    figure = fatigue_under_surface(opened, opened.fatigue(body))
    _print(style.save(figure, output or folder_of(run) / "figures", f"fatigue-{body}", formats))


@plot.command("interfaces")
@_run_folder
@click.option(
    "--body", type=click.Choice(["lower", "upper"]), help="Coated body; default: the one with layers, first the lower."
)
@_steps
@_into_run
@_formats
@_takes_si
@reports_errors
def _interfaces(
    run: Path, body: Literal["lower", "upper"] | None, steps: Sequence[Any], output: Path | None, formats: list[str]
) -> None:
    """Draw shear and normal traction on the interfaces of a coated body."""
    opened = open_run(run, allow_unfinished=True)
    for which in steps:
        figure = interface_tractions(opened, opened.snapshot(which), body=body)
        if figure is None:
            raise RunError(f"{run}: no interfaces between stored cells of the {body or 'lower or upper'} body")
        name = f"{_state_name(which)}-interfaces{f'-{body}' if body else ''}"
        _print(style.save(figure, output or folder_of(run) / "figures", name, formats))


@plot.command("points")
@_run_folder
@_into_run
@_formats
@_takes_si
@reports_errors
def _points(run: Path, output: Path | None, formats: list[str]) -> None:
    """Draw stress, plastic strain and temperature at the points of [output] points, step by step."""
    opened = open_run(run, allow_unfinished=True)
    figure = point_histories(opened)
    if figure is None:
        raise RunError(f"{run}: no histories at points; name some within the bodies in [[output.points]] of the case")
    _print(style.save(figure, output or folder_of(run) / "figures", "point-histories", formats))
