# SPDX-License-Identifier: BSD-3-Clause
"""Command line of the HTML report: ``brinell report``."""

from __future__ import annotations

from pathlib import Path

import click
import matplotlib

from brinell.commands import folder_of, reports_errors
from brinell.report.page import write_report
from brinell.results import open_run

__all__ = ["report"]


@click.command()
@click.argument("run", type=click.Path(path_type=Path), metavar="RUN")
@click.option("-o", "--output", type=click.Path(path_type=Path), help="File of the page; default: RUN/report.html.")
@reports_errors
def report(run: Path, output: Path | None) -> None:
    """Write an HTML page on a run, which may be unfinished, or on a sweep, that opens without a network."""
    matplotlib.use("Agg")
    if (run / "sweep.json").is_file():
        from brinell.report.sweep_page import write_sweep_report
        from brinell.sweeps import open_sweep

        click.echo(write_sweep_report(open_sweep(run), output or run / "report.html"))
        return
    click.echo(write_report(open_run(run, allow_unfinished=True), output or folder_of(run) / "report.html"))
