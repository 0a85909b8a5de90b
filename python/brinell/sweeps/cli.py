# SPDX-License-Identifier: BSD-3-Clause
"""The command ``brinell sweep``.

Exit code 0: all runs are done; 1: some have failed, or a file could not be written; 2: an error in the command line or
the case; 130: interrupted.
"""

from __future__ import annotations

import signal
from pathlib import Path
from typing import NoReturn

import click

from brinell import completion
from brinell.case import Case
from brinell.commands import reports_warnings
from brinell.errors import InputError

__all__ = ["command"]

_DESIGNS = {"grid": "grid", "list": "list", "latin-hypercube": "latin_hypercube"}


@click.command("sweep")
@click.argument("case", type=click.Path(path_type=Path), metavar="CASE.toml", shell_complete=completion.case_files)
@click.option(
    "--over",
    "over",
    multiple=True,
    required=True,
    metavar="KEY=VALUES",
    shell_complete=completion.schema_keys,
    help="A key and its values: 1:15:15 (start, stop, count; both ends are included), 200GPa:220GPa:3, log:1:100:5, "
    "or a,b,c. Of a key that is a list, its first entry: indentation.load=10:200:12. Once per key.",
)
@click.option(
    "-o", "--output", required=True, type=click.Path(path_type=Path), metavar="DIR", help="Folder of the sweep."
)
@click.option(
    "--design",
    type=click.Choice(list(_DESIGNS)),
    default="grid",
    show_default=True,
    help="grid: all combinations; list: the first values of all keys, then the second values, and so on; "
    "latin-hypercube: random points in ranges without a count.",
)
@click.option("--samples", type=click.IntRange(min=1), help="Number of points of a Latin hypercube.")
@click.option("--seed", type=click.IntRange(min=0), default=0, show_default=True, help="Seed of its random numbers.")
@click.option(
    "--set",
    "overrides",
    multiple=True,
    metavar="KEY=VALUE",
    shell_complete=completion.schema_keys,
    help="Replace or add a key of the case.",
)
@click.option("--workers", type=click.IntRange(min=1), help="Number of processes; default: the number of cores.")
@click.option(
    "--threads",
    type=click.IntRange(min=1),
    help="Number of threads of each run; default: the number with which all cores are used.",
)
@click.option(
    "--cluster", metavar="ADDRESS", help="Address or scheduler file of a Dask cluster on which the runs are computed."
)
@click.option("--retry-failed", is_flag=True, help="Repeat failed runs, also with other keys of grid and solver.")
@click.option(
    "--numbers",
    multiple=True,
    metavar="WHAT",
    help="Further columns of the table: residual_stress, or FILE.py:FUNCTION, a function of a run that returns numbers "
    "by their names.",
)
@click.option("--quiet", is_flag=True, help="Show no progress bar.")
def command(
    case: Path,
    over: tuple[str, ...],
    output: Path,
    design: str,
    samples: int | None,
    seed: int,
    overrides: tuple[str, ...],
    workers: int | None,
    threads: int | None,
    cluster: str | None,
    retry_failed: bool,
    numbers: tuple[str, ...],
    quiet: bool,
) -> None:
    """Compute a case for many values of some of its keys.

    The same command continues a sweep that was stopped. DIR/table.csv has one row per run.
    """
    # The signals by which a batch system or a closing terminal ends a job stop the sweep in the same way as Ctrl-C.
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    if signal.getsignal(signal.SIGHUP) != signal.SIG_IGN:  # SIGHUP is ignored under nohup
        signal.signal(signal.SIGHUP, signal.default_int_handler)
    try:
        from brinell.sweeps import sweep
        from brinell.sweeps.numbers import function_of

        with reports_warnings():
            result = sweep(
                Case.from_file(case, overrides),
                _axes(over),
                output=output,
                design=_DESIGNS[design],  # type: ignore[arg-type]
                samples=samples,
                seed=seed,
                workers=workers,
                threads=threads,
                cluster=cluster,
                progress=not quiet,
                retry_failed=retry_failed,
                numbers=[function_of(text) for text in numbers],
            )
    except KeyboardInterrupt:
        _end(f"brinell: interrupted; what is done is in {output / 'table.csv'}, and the same command goes on", 130)
    if not quiet:
        click.echo(f"{len(result.table)} runs, {len(result.failures)} failed: {output / 'table.csv'}")
    if len(result.failures) > 0:
        first = result.failures.iloc[0]
        _end(f"brinell: run {first['index']}: {first['reason']}\nbrinell: all reasons: {output / 'failures.json'}", 1)


def _axes(over: tuple[str, ...]) -> dict[str, str]:
    axes: dict[str, str] = {}
    for text in over:
        key, equals, values = text.partition("=")
        key = key.strip()
        if not equals or not key or not values.strip():
            raise InputError(f"--over {text}: allowed: KEY=VALUES, as in tugging.interference=1:15:15")
        if key in axes:
            raise InputError(f"--over {text}: {key} is already an axis; give all its values at once")
        axes[key] = values.strip()
    return axes


def _end(message: str, exit_code: int) -> NoReturn:
    click.echo(message, err=True)
    click.get_current_context().exit(exit_code)
