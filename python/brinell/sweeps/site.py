# SPDX-License-Identifier: BSD-3-Clause
"""The options of a site for its batch system and its Dask clusters, kept in one file; docs/howto/clusters.md."""

from __future__ import annotations

import datetime
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from brinell import _core
from brinell._names import did_you_mean
from brinell._toml import line_of, tomllib
from brinell.errors import InputError
from brinell.sweeps.clusters import Cluster
from brinell.sweeps.slurm import Slurm

__all__ = ["Site", "option_of", "read_site"]

_TEXTS, _COUNT = "text, or a list of texts", "a whole number, 1 or more"
_TOP = {"slurm": "a table [slurm]", "cluster": "tables such as [cluster.SLURMCluster]"}
_SLURM = {"options": _TEXTS, "preamble": _TEXTS, "chunk": _COUNT, "at_once": _COUNT}
_CLUSTER = {"jobs": _COUNT, "chunk": _COUNT, "options": "a table of arguments of the class"}


@dataclass(frozen=True)
class Site:
    """Options of a site.

    Attributes:
        slurm: how a job array is submitted there.
        clusters: Dask clusters that can be started there, by the names of their classes.
    """

    slurm: Slurm = field(default_factory=Slurm)
    clusters: Mapping[str, Cluster] = field(default_factory=dict)

    def with_slurm(self, given: Slurm) -> Slurm:
        """Job arrays as they are given, and as the site has them where nothing is given; with the options of both."""
        return replace(
            given,
            options=[*self.slurm.words(), *given.words()],  # of one that is there twice, sbatch takes the last
            preamble=[*self.slurm.lines(), *given.lines()],
            chunk=given.chunk or self.slurm.chunk,
            at_once=given.at_once or self.slurm.at_once,
        )

    def with_cluster(self, given: Cluster) -> Cluster:
        """A cluster as it is given, and as the site has it where nothing is given."""
        own = self.clusters.get(given.name, Cluster(given.name))
        options = {**own.options, **given.options}
        return Cluster(given.name, options, given.jobs or own.jobs, given.chunk or own.chunk)


def read_site(path: str | Path) -> Site:
    """Reads the file of a site.

    Raises:
        InputError: a key or value is not allowed; the text names file, line and what is allowed.
    """
    path = Path(path)
    text = _core.case_file_text(path)
    try:
        content = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise InputError(f"{path}: {error}") from None
    _check(content, _TOP, path, text)
    slurm = content.get("slurm", {})
    _check(slurm, _SLURM, path, text, "slurm")
    try:
        own = Slurm(**slurm)
    except InputError as error:
        raise InputError(f"{path}:{line_of(text, 'slurm', 'options')}: {error}") from None
    return Site(own, {name: _cluster(name, table, path, text) for name, table in content.get("cluster", {}).items()})


def _cluster(name: str, table: object, path: Path, text: str) -> Cluster:
    if not Cluster.is_name(name) or not isinstance(table, Mapping):
        told = f"[cluster.{name}]" if isinstance(table, Mapping) else f"[cluster]: {name} = {table!r}"
        place = f"{path}:{line_of(text, 'cluster', name)}"
        raise InputError(f"{place}: {told}; allowed: a table for each class, such as [cluster.SLURMCluster]")
    _check(table, _CLUSTER, path, text, "cluster", name)
    options = {key: option_of(value) for key, value in table.get("options", {}).items()}
    return Cluster(name, options, table.get("jobs"), table.get("chunk"))


def option_of(value: Any) -> Any:
    """A value of TOML as an argument of a cluster: a time of day without quotation marks is meant as a text."""
    return str(value) if isinstance(value, datetime.time | datetime.date) else value


def _check(table: Mapping[str, Any], allowed: Mapping[str, str], path: Path, text: str, *names: str) -> None:
    within = f"[{'.'.join(names)}]: " if names else ""
    for key, value in table.items():
        place = f"{path}:{line_of(text, *names, key)}: {within}"
        if key not in allowed:
            raise InputError(f"{place}{key} is not known; {did_you_mean(key, allowed)}allowed: {', '.join(allowed)}")
        if not _fits(value, allowed[key]):
            raise InputError(f"{place}{key} = {value!r}; allowed: {allowed[key]}")


def _fits(value: object, allowed: str) -> bool:
    if allowed == _COUNT:
        return isinstance(value, int) and not isinstance(value, bool) and value >= 1
    if allowed == _TEXTS:
        texts = value if isinstance(value, list) else [value]
        return all(isinstance(one, str) for one in texts)
    return isinstance(value, Mapping)
