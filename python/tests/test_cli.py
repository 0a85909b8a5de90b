# SPDX-License-Identifier: BSD-3-Clause
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from brinell.plot.cli import main

MakeRun = Callable[..., Path]
PNG = b"\x89PNG\r\n\x1a\n"


def names(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.iterdir())


def test_paper(make_run: MakeRun, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folders = [str(make_run(alpha)) for alpha in (1.0, 4.0, 9.0)]
    output = tmp_path / "new" / "figures"
    assert main(["paper", *folders, "-o", str(output), "--format", "png,svg"]) == 0
    stems = [
        "fig11-tangential-force",
        "fig12-normal-force",
        "fig13-net-energy",
        "fig14-load-ratio",
        "fig15-residual-displacement",
        "overview",
    ]
    assert names(output) == [f"{stem}.{ending}" for stem in stems for ending in ("png", "svg")]
    assert all(path.read_bytes().startswith(PNG) for path in output.glob("*.png"))
    printed = capsys.readouterr()
    assert printed.out.splitlines() == [str(output / f"{s}.{e}") for s in stems for e in ("png", "svg")]
    assert printed.err == ""


def test_fields(make_run: MakeRun, tmp_path: Path) -> None:
    folder = make_run(9.0)
    assert main(["fields", str(folder)]) == 0
    assert names(folder / "figures") == [
        "aligned-pressure.png",
        "aligned-residual-surfaces.png",
        "aligned-section.png",
    ]
    output = tmp_path / "out"
    assert main(["fields", str(folder), "--step", "6", "--step", "final", "--cells", "-o", str(output)]) == 0
    assert names(output) == [
        "final-residual-surfaces.png",  # no contact, hence no pressure
        "final-section.png",
        "step-000006-pressure.png",
        "step-000006-residual-surfaces.png",
        "step-000006-section.png",
    ]


def test_unfinished_run(make_run: MakeRun) -> None:
    folder = make_run(4.0, finished=False)
    assert main(["fields", str(folder)]) == 0
    assert main(["history", str(folder)]) == 0
    assert "history.png" in names(folder / "figures")


def test_history(make_run: MakeRun, tmp_path: Path) -> None:
    assert main(["history", str(make_run(4.0)), "-o", str(tmp_path / "out")]) == 0
    assert names(tmp_path / "out") == ["history.png"]


def test_indentation(make_indentation: MakeRun, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folders = [str(make_indentation(load, name=f"load{load:g}")) for load in (2e6, 3e6)]
    assert main(["indentation", *folders, "-o", str(tmp_path / "out"), "--format", "pdf"]) == 0
    assert names(tmp_path / "out") == ["contact-pressure.pdf", "imprint.pdf", "load-depth.pdf"]
    assert len(capsys.readouterr().out.splitlines()) == 3


def test_figures_that_would_be_empty_are_left_out(make_indentation: MakeRun, tmp_path: Path) -> None:
    assert main(["indentation", str(make_indentation(yields=False)), "-o", str(tmp_path / "out")]) == 0
    assert names(tmp_path / "out") == ["contact-pressure.png", "load-depth.png"]


def test_rolling(make_rolling: MakeRun, tmp_path: Path) -> None:
    assert main(["rolling", str(make_rolling()), "-o", str(tmp_path / "out")]) == 0
    assert names(tmp_path / "out") == ["along-track.png", "depth-profiles.png", "passes.png", "track-profile.png"]


def test_run_of_another_scenario(make_run: MakeRun, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = make_run()
    assert main(["rolling", str(folder), "-o", str(tmp_path / "out")]) == 2
    assert capsys.readouterr().err == (
        f"brinell-plot: error: {folder}: is of scenario 'tugging', this figure needs 'rolling'\n"
    )


def test_fields_under_a_rigid_indenter(make_indentation: MakeRun) -> None:
    folder = make_indentation()
    assert main(["fields", str(folder), "--step", "aligned", "--step", "final"]) == 0
    assert names(folder / "figures") == [
        "aligned-pressure.png",
        "aligned-residual-surfaces.png",
        "aligned-section.png",
        "final-residual-surfaces.png",
        "final-section.png",
    ]


@pytest.mark.parametrize("command", ["paper", "indentation", "rolling", "fields", "history"])
def test_bad_folder(command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([command, str(tmp_path / "nowhere"), "-o", str(tmp_path / "out")]) == 2
    printed = capsys.readouterr()
    assert printed.out == ""
    assert printed.err.splitlines() == [f"brinell-plot: error: {tmp_path / 'nowhere'}: no such folder"]
    assert not (tmp_path / "out").exists()


def test_unfinished_run_has_no_place_in_the_papers_figures(
    make_run: MakeRun, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    good, bad = make_run(4.0), make_run(9.0, finished=False)
    assert main(["paper", str(good), str(bad), "-o", str(tmp_path / "out")]) == 2
    assert capsys.readouterr().err.startswith(f"brinell-plot: error: {bad}: no summary.json, the run has not finished")
    assert not (tmp_path / "out").exists()


def test_step_that_is_not_stored(make_run: MakeRun, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["fields", str(make_run()), "--step", "7"]) == 2
    assert "step 7 is not stored" in capsys.readouterr().err


def test_output_that_cannot_be_written(make_run: MakeRun, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "file").write_text("")
    assert main(["history", str(make_run()), "-o", str(tmp_path / "file")]) == 2
    assert len(capsys.readouterr().err.splitlines()) == 1


@pytest.mark.parametrize(
    "arguments", [[], ["paper"], ["fields", "x", "--step", "last"], ["history", "x", "--format", "gif"]]
)
def test_wrong_usage(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as error:
        main(arguments)
    assert error.value.code == 2
    assert "usage" in capsys.readouterr().err


def test_as_a_module(tmp_path: Path) -> None:
    """As a user calls it: exit code 2, one line, no traceback."""
    result = subprocess.run(
        [sys.executable, "-m", "brinell.plot", "paper", str(tmp_path / "nowhere")],
        capture_output=True,
        text=True,
        check=False,
        cwd=Path(__file__).parents[1],
    )
    assert result.returncode == 2
    assert result.stdout == ""
    assert result.stderr.splitlines() == [f"brinell-plot: error: {tmp_path / 'nowhere'}: no such folder"]
