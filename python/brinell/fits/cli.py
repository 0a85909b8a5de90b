# SPDX-License-Identifier: BSD-3-Clause
"""The command ``brinell fit``.

Exit code 0: done; 1: no run could be computed, or a file could not be written; 2: the request, a case or data are
wrong; 130: interrupted.
"""

from __future__ import annotations

from pathlib import Path

import click

from brinell.commands import reports_errors

__all__ = ["command"]


@click.command("fit")
@click.argument("file", type=click.Path(path_type=Path), metavar="FIT.toml")
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    metavar="DIR",
    help="Folder of the result; default: results/NAME.",
)
@click.option("--workers", type=click.IntRange(min=1), help="Number of runs at a time; default: the number of cores.")
@click.option(
    "--cluster", metavar="ADDRESS", help="Address or scheduler file of a Dask cluster on which the runs are computed."
)
@click.option("--no-figures", is_flag=True, help="Write no figures and no report.")
@click.option("-q", "--quiet", is_flag=True, help="Print nothing but the estimates and what is to be known of them.")
@reports_errors
def command(
    file: Path, output: Path | None, workers: int | None, cluster: str | None, no_figures: bool, quiet: bool
) -> None:
    """Find unknown keys of a case from measured curves.

    FIT.toml names the case, the unknown keys with their bounds, and the files of the curves. DIR gets fit.json, the
    fitted case as fitted.toml, figures and report.html.
    """
    import matplotlib

    from brinell.fits import fit

    matplotlib.use("Agg")
    result = fit(
        file, workers=workers, cluster=cluster, progress=False if quiet else lambda text: click.echo(text, err=True)
    )
    folder = output or Path("results") / (file.resolve().parent.name if file.stem == "fit" else file.stem)
    written = result.write(folder, figures=not no_figures)
    click.echo(result.table())
    for finding in result.findings:
        click.echo(f"brinell: warning: {finding}", err=True)
    if not quiet:
        click.echo(f"{result.runs} runs, {result.seconds:.0f} s: {written[0]}, {written[-1]}")
