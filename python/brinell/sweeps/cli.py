# SPDX-License-Identifier: BSD-3-Clause
"""The command ``brinell sweep``.

Exit code 0: all runs are done; 1: some have failed, or a file could not be written; 2: an error in the command line or
the case; 130: interrupted.
"""

from __future__ import annotations

import signal
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

import click

from brinell import completion
from brinell._toml import tomllib
from brinell.case import Case
from brinell.commands import reports_warnings
from brinell.errors import InputError

if TYPE_CHECKING:
    from brinell.sweeps import Site

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
    "--cluster",
    metavar="ADDRESS",
    help="Address or scheduler file of a Dask cluster on which the runs are computed, or the class of one that is "
    "started: SLURMCluster, PBSCluster, ... of dask_jobqueue, LocalCluster.",
)
@click.option(
    "--cluster-option",
    "cluster_options",
    multiple=True,
    metavar="NAME=VALUE",
    help="Argument of the class of the cluster: cores=8, memory='16 GB', walltime='04:00:00'.",
)
@click.option(
    "--site",
    type=click.Path(path_type=Path),
    envvar="BRINELL_SITE",
    metavar="FILE.toml",
    help="File with the options of this site for --submit and --cluster, to which those of the command are added. "
    "Default: the file that the environment variable BRINELL_SITE names.",
)
@click.option("--jobs", type=click.IntRange(min=1), help="Number of jobs of a cluster that is started.")
@click.option(
    "--submit",
    type=click.Choice(["slurm"]),
    help="Compute the runs by a job array of Slurm, and wait for it. The same command finds an array that still runs.",
)
@click.option(
    "--slurm",
    "options",
    multiple=True,
    metavar="OPTIONS",
    help='Options of sbatch for the array: "--partition=short --time=02:00:00".',
)
@click.option(
    "--preamble", multiple=True, metavar="LINE", help="Line of the job's script before the runs: 'module load python'."
)
@click.option(
    "--chunk", type=click.IntRange(min=1), help="Number of runs of a task of a job array, or of a portion for Dask."
)
@click.option("--at-once", type=click.IntRange(min=1), help="Largest number of tasks that compute at a time.")
@click.option("--no-wait", is_flag=True, help="Return when the array is submitted; the same command collects.")
@click.option(
    "--keep",
    metavar="WHICH",
    help="Runs that write a folder: all, none, or numbers such as 0,10-19. The others are computed in memory and leave "
    "their row of the table. Default: all; with --submit none.",
)
@click.option("--dry-run", is_flag=True, help="Check all cases, print what would be submitted, write nothing.")
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
    cluster_options: tuple[str, ...],
    site: Path | None,
    jobs: int | None,
    submit: str | None,
    options: tuple[str, ...],
    preamble: tuple[str, ...],
    chunk: int | None,
    at_once: int | None,
    no_wait: bool,
    keep: str | None,
    dry_run: bool,
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
    # A pipe to a worker that was killed must not end this process, too.
    signal.signal(signal.SIGPIPE, signal.SIG_IGN)
    try:
        from brinell.sweeps import Site, Slurm, read_site, sweep
        from brinell.sweeps.driver import dry_run as planned

        given = {"--slurm": options, "--preamble": preamble, "--at-once": at_once, "--no-wait": no_wait}
        if submit is None and (needless := [name for name, value in given.items() if value]):
            raise InputError(f"{needless[0]} has no meaning without --submit slurm")
        of_site = Site() if site is None else read_site(site)
        wanted = None
        if submit is not None:
            wanted = of_site.with_slurm(Slurm(options, preamble, chunk, at_once, wait=not no_wait))
        varied: dict[str, Any] = {"design": _DESIGNS[design], "samples": samples, "seed": seed}
        with reports_warnings():
            base = Case.from_file(case, overrides)
            if dry_run:
                click.echo(planned(base, _axes(over), output=output, submit=wanted, **varied))
                return
            result = sweep(
                base,
                _axes(over),
                output=output,
                workers=workers,
                threads=threads,
                cluster=_cluster(cluster, cluster_options, jobs, of_site),
                submit=wanted,
                chunk=chunk if wanted is None else None,
                keep=keep,
                progress=not quiet,
                retry_failed=retry_failed,
                numbers=numbers,
                **varied,
            )
    except KeyboardInterrupt as interrupt:
        if submit is not None and str(interrupt):
            _end(f"brinell: {str(interrupt).replace('the same call', 'the same command')}", 130)
        _end(f"brinell: interrupted; what is done is in {output / 'table.csv'}, and the same command goes on", 130)
    if no_wait and (waiting := result.awaited):
        click.echo(f"{len(result.table)} runs are done, {waiting} are with Slurm; the same command collects them")
        return
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


def _cluster(cluster: str | None, options: tuple[str, ...], jobs: int | None, site: Site) -> Any:
    """The cluster of the command line: an address or a file, or one that is started."""
    from brinell.sweeps import Cluster

    if cluster is not None and Cluster.is_name(cluster) and not Path(cluster).exists():
        return site.with_cluster(Cluster(cluster, dict(_option(text) for text in options), jobs))
    if options or jobs:
        what = "--cluster-option" if options else "--jobs"
        raise InputError(f"{what} has no meaning without --cluster CLASS, such as --cluster SLURMCluster")
    return cluster


def _option(text: str) -> tuple[str, Any]:
    from brinell.sweeps.site import option_of

    name, equals, value = text.partition("=")
    if not equals or not name.isidentifier():
        raise InputError(f"--cluster-option {text}: allowed: NAME=VALUE, as in cores=8")
    try:
        return name, option_of(tomllib.loads(f"value = {value}")["value"])
    except tomllib.TOMLDecodeError:
        return name, value


def _end(message: str, exit_code: int) -> NoReturn:
    click.echo(message, err=True)
    click.get_current_context().exit(exit_code)
