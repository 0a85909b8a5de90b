# SPDX-License-Identifier: BSD-3-Clause

"""The file with a site's options for batch systems and clusters."""

import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

import brinell
from brinell import Case, InputError
from brinell._toml import line_of, tomllib

pytest.importorskip("pandas")
pytest.importorskip("pyarrow")
pytest.importorskip("scipy")

from brinell.sweeps import Cluster, Site, Slurm, read_site
from sweep_case import CASE

SITE = """
# of the cluster in the cellar
[slurm]
options = "--partition=short --time=10"
preamble = ["module load python"]
chunk = 2

[cluster.SLURMCluster]
jobs = 20
options = { cores = 8, memory = "16 GB", walltime = 04:00:00 }

[cluster."distributed:LocalCluster"]
chunk = 3
options.n_workers = 1
options.threads_per_worker = 1
options.dashboard_address = ":0"
"""


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "site.toml"
    path.write_text(SITE)
    return path


def test_a_site_is_read(file: Path) -> None:
    options = {"cores": 8, "memory": "16 GB", "walltime": "04:00:00"}
    own = {"n_workers": 1, "threads_per_worker": 1, "dashboard_address": ":0"}
    assert read_site(file) == Site(
        Slurm("--partition=short --time=10", ["module load python"], 2),
        {
            "SLURMCluster": Cluster("SLURMCluster", options, 20),
            "distributed:LocalCluster": Cluster("distributed:LocalCluster", own, None, 3),
        },
    )


def test_what_is_given_precedes(file: Path) -> None:
    site = read_site(file)
    merged = site.with_slurm(Slurm("--partition=long", "module load other", at_once=3, wait=False))
    assert merged.words() == ["--partition=short", "--time=10", "--partition=long"]
    assert merged.lines() == ["module load python", "module load other"]
    assert (merged.chunk, merged.at_once, merged.wait) == (2, 3, False)
    assert site.with_slurm(Slurm(chunk=5)).chunk == 5
    cluster = site.with_cluster(Cluster("SLURMCluster", {"cores": 4, "queue": "long"}))
    assert cluster.options == {"cores": 4, "memory": "16 GB", "walltime": "04:00:00", "queue": "long"}
    assert cluster.jobs == 20
    assert site.with_cluster(Cluster("PBSCluster", {"cores": 4}, 2)) == Cluster("PBSCluster", {"cores": 4}, 2)


@pytest.mark.parametrize(
    ("before", "after", "message"),
    [
        ("chunk = 2", "chunk = 0", r":6: \[slurm\]: chunk = 0; allowed: a whole number, 1 or more"),
        ("chunk = 3", "chunk = true", r":13: \[cluster.distributed:LocalCluster\]: chunk = True; allowed: a whole"),
        ('["module load python"]', "7", r":5: \[slurm\]: preamble = 7; allowed: text, or a list of texts"),
        ("--time=10", "--array=10", r":4: slurm: the option --array=10 is the sweep's own"),
        ("[slurm]", "[slrum]", r":3: slrum is not known; did you mean slurm\? allowed: slurm, cluster"),
        ("jobs = 20", "job = 20", r":9: \[cluster.SLURMCluster\]: job is not known; did you mean jobs\?"),
        ("options = {", "options = 3 #", r":10: \[cluster.SLURMCluster\]: options = 3; allowed: a table of arg"),
        ("[cluster.SLURMCluster]", "[cluster]", r":9: \[cluster\]: jobs = 20; allowed: a table for each class"),
        ("SLURMCluster", "Slurm", r":8: \[cluster.Slurm\]; allowed: a table for each class, such as \[cluster.SLURMC"),
        ("[slurm]", "cluster = 3\n[slurm]", r"site.toml: Cannot overwrite a value \(at line 9"),
    ],
)
def test_errors_have_file_and_line(file: Path, before: str, after: str, message: str) -> None:
    assert before in SITE
    file.write_text(SITE.replace(before, after))
    with pytest.raises(InputError, match=message):
        read_site(file)


def test_a_file_that_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(brinell.BrinellError, match=r"none\.toml"):
        read_site(tmp_path / "none.toml")


def test_lines_of_all_keys(file: Path) -> None:
    lines = SITE.splitlines()

    def check(table: dict[str, Any], *above: str) -> None:
        for key, value in table.items():
            line = lines[line_of(SITE, *above, key) - 1]
            assert key in line or "options = {" in line
            if isinstance(value, dict):
                check(value, *above, key)

    check(tomllib.loads(SITE))
    assert line_of(SITE, "slurm", "none") == 3
    assert line_of(SITE, "none") == 1


def command(folder: Path, site: Path | None, *words: str, **variables: str) -> subprocess.CompletedProcess[str]:
    """`brinell sweep` with a stand-in for scontrol, which tells the largest array."""
    (folder / "case.toml").write_text(CASE)
    stand_in = folder / "scontrol"
    stand_in.write_text("#!/bin/sh\necho 'MaxArraySize = 1001'\n")
    stand_in.chmod(0o755)
    given = ["sweep", "case.toml", "--over", "tugging.interference=1,1.5,2", "-o", "sweep", "--quiet", *words]
    given += [] if site is None else ["--site", str(site)]
    environment = {"PATH": f"{folder}:/usr/bin:/bin", **variables}
    line = [sys.executable, "-m", "brinell", *given]
    return subprocess.run(line, cwd=folder, env=environment, capture_output=True, text=True, check=False)


def test_the_command_takes_a_site_or_the_variable(tmp_path: Path, file: Path) -> None:
    words = ["--submit", "slurm", "--dry-run", "--slurm", "--partition=long"]
    by_option = command(tmp_path, file, *words)
    assert by_option.returncode == 0, by_option.stderr
    lines = by_option.stdout.splitlines()
    assert lines[0] == "# 3 runs in 2 tasks of 2"
    wanted = ["#SBATCH --partition=short", "#SBATCH --time=10", "#SBATCH --partition=long", "module load python"]
    assert [line for line in lines if line in wanted] == wanted
    by_variable = command(tmp_path, None, *words, BRINELL_SITE=str(file))
    assert by_variable.stdout == by_option.stdout
    assert "--time=10" not in command(tmp_path, None, *words).stdout
    # Without --submit and --cluster it is only checked.
    assert command(tmp_path, file, "--dry-run").stdout == "3 runs; all cases are valid\n"
    file.write_text("[slurm]\nchunk = 0\n")
    wrong = command(tmp_path, file, "--dry-run")
    assert wrong.returncode == 2
    assert f"{file}:2: [slurm]: chunk = 0" in wrong.stderr


def test_a_cluster_of_the_site(tmp_path: Path, file: Path) -> None:
    pytest.importorskip("distributed")
    site = read_site(file)
    result = brinell.sweep(
        Case(CASE),
        {"tugging.interference": [0.5, 0.6]},
        output=tmp_path / "sweep",
        cluster=site.clusters["distributed:LocalCluster"],
        keep="none",
        progress=False,
    )
    assert result.table["status"].tolist() == ["done"] * 2
