# SPDX-License-Identifier: BSD-3-Clause
"""Command line of the figures: ``brinell-plot`` or ``python -m brinell.plot``.

Exit code 0: all figures are written (their paths are printed); 2: something about the request or a folder is wrong,
with one line on the standard error stream that says what.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

import matplotlib
from matplotlib.figure import Figure

from brinell.plot import fields, history, indentation, paper, rolling, style
from brinell.results import Run, RunError, Snapshot, open_run

__all__ = ["main"]


_OF_SEVERAL_RUNS: Mapping[str, tuple[str, Mapping[str, Callable[[Sequence[Run]], Figure | None]]]] = {
    "paper": (
        "Figs. 11 to 15 of Boucly, Nelias, Green (2006) and an overview, from one run per interference.",
        paper.FIGURES,
    ),
    "indentation": (
        "Load over depth, imprint and contact pressure of one indentation or several.",
        indentation.FIGURES,
    ),
    "rolling": (
        "Rut, strain and dissipation by pass, residual stress in depth, the track across, forces along it.",
        rolling.FIGURES,
    ),
}
"""Commands that take several runs: what they draw, and their figures by file name."""


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="brinell-plot", description="Draws the results of 'brinell run'.")
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")

    def command(name: str, text: str) -> argparse.ArgumentParser:
        sub = commands.add_parser(name, help=text, description=text)
        sub.add_argument(
            "--format",
            default="png",
            metavar="LIST",
            type=_formats,
            help=f"file formats, separated by commas, out of {', '.join(style.FORMATS)} (default: png)",
        )
        return sub

    for name, (text, _) in _OF_SEVERAL_RUNS.items():
        several = command(name, text)
        several.add_argument("runs", nargs="+", type=Path, metavar="RUN_DIR", help="result folders")
        several.add_argument(
            "-o", "--output", type=Path, default=Path("figures"), metavar="DIR", help="default: figures"
        )

    state = command("fields", "Contact pressure, residual surfaces, stress and plastic strain of one state.")
    state.add_argument("run", type=Path, metavar="RUN_DIR", help="result folder, may be of a run not yet finished")
    state.add_argument(
        "--step",
        action="append",
        type=_step,
        metavar="N|aligned|final",
        help="a stored step; aligned (default): the one in the middle of the first pass, or under the largest load of "
        "the first indent; or the final state; may be given several times",
    )
    state.add_argument("--cells", action="store_true", help="one colour per cell instead of interpolation")
    state.add_argument("-o", "--output", type=Path, metavar="DIR", help="default: RUN_DIR/figures")

    course = command("history", "Forces, energies, deformation and cost of one run, step by step.")
    course.add_argument("run", type=Path, metavar="RUN_DIR", help="result folder, may be of a run not yet finished")
    course.add_argument("-o", "--output", type=Path, metavar="DIR", help="default: RUN_DIR/figures")
    return parser


def _formats(text: str) -> list[str]:
    formats = [item.strip() for item in text.split(",")]
    for item in formats:
        if item not in style.FORMATS:
            raise argparse.ArgumentTypeError(f"{item!r} is not one of {', '.join(style.FORMATS)}")
    return formats


def _step(text: str) -> int | str:
    if text in ("aligned", "final"):
        return text
    if text.isdecimal():
        return int(text)
    raise argparse.ArgumentTypeError(f"{text!r} is neither a step number nor 'aligned' nor 'final'")


def _draw_several_runs(arguments: argparse.Namespace) -> list[Path]:
    runs = [open_run(path) for path in arguments.runs]
    written = []
    for name, draw in _OF_SEVERAL_RUNS[arguments.command][1].items():
        figure = draw(runs)
        if figure is not None:
            written += style.save(figure, arguments.output, name, arguments.format)
    return written


def _draw_fields(arguments: argparse.Namespace) -> list[Path]:
    run = open_run(arguments.run, allow_unfinished=True)
    folder = arguments.output or arguments.run / "figures"
    written = []
    for which in arguments.step or ["aligned"]:
        snapshot: Snapshot = run.snapshot(which)
        prefix = which if isinstance(which, str) else f"step-{which:06d}"
        for name, draw in fields.FIGURES.items():
            if draw is fields.pressure_map and not snapshot.in_contact:
                continue
            written += style.save(
                draw(run, snapshot, cells=arguments.cells), folder, f"{prefix}-{name}", arguments.format
            )
    return written


def _draw_history(arguments: argparse.Namespace) -> list[Path]:
    run = open_run(arguments.run, allow_unfinished=True)
    return style.save(
        history.run_history(run), arguments.output or arguments.run / "figures", "history", arguments.format
    )


def main(argv: Sequence[str] | None = None) -> int:
    """Runs the command.

    Args:
        argv: arguments without the program's name; those of the process if None.

    Returns:
        The exit code.
    """
    arguments = _parser().parse_args(argv)
    matplotlib.use("Agg")
    draw = {"fields": _draw_fields, "history": _draw_history}.get(arguments.command, _draw_several_runs)
    try:
        for path in draw(arguments):
            print(path)
    except (RunError, OSError) as error:
        print(f"brinell-plot: error: {error}", file=sys.stderr)
        return 2
    return 0
