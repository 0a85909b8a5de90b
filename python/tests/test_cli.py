# SPDX-License-Identifier: BSD-3-Clause
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from PIL import Image

from brinell.plot.cli import plot

MakeRun = Callable[..., Path]
PNG = b"\x89PNG\r\n\x1a\n"


def main(arguments: list[str]) -> int:
    """Exit code of the command."""
    with pytest.raises(SystemExit) as end:
        plot(arguments, prog_name="brinell plot")
    return int(end.value.code or 0)


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
        "aligned-gap.png",
        "aligned-pressure.png",
        "aligned-residual-surfaces.png",
        "aligned-section.png",
    ]
    output = tmp_path / "out"
    assert main(["fields", str(folder), "--step", "6", "--step", "final", "--cells", "-o", str(output)]) == 0
    assert names(output) == [
        "final-residual-surfaces.png",  # no contact, hence no pressure
        "final-section.png",
        "step-000006-gap.png",
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


def test_a_result_may_be_given_by_its_file(make_run: MakeRun) -> None:
    folder = make_run(4.0)
    assert main(["history", str(folder / "result.vtkhdf")]) == 0
    assert names(folder / "figures") == ["history.png"]


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
        f"brinell: error: {folder}: is of scenario 'tugging', this figure needs 'rolling'\n"
    )


def test_fields_under_a_rigid_indenter(make_indentation: MakeRun) -> None:
    folder = make_indentation()
    assert main(["fields", str(folder), "--step", "aligned", "--step", "final"]) == 0
    assert names(folder / "figures") == [
        "aligned-gap.png",
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
    assert printed.err.splitlines() == [f"brinell: error: {tmp_path / 'nowhere'}: no such folder"]
    assert not (tmp_path / "out").exists()


def test_unfinished_run_has_no_place_in_the_papers_figures(
    make_run: MakeRun, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    good, bad = make_run(4.0), make_run(9.0, finished=False)
    assert main(["paper", str(good), str(bad), "-o", str(tmp_path / "out")]) == 2
    assert capsys.readouterr().err.startswith(f"brinell: error: {bad}: no summary.json, the run has not finished")
    assert not (tmp_path / "out").exists()


def test_step_that_is_not_stored(make_run: MakeRun, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["fields", str(make_run()), "--step", "7"]) == 2
    assert "step 7 is not stored" in capsys.readouterr().err


def test_output_that_cannot_be_written(make_run: MakeRun, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "file").write_text("")
    assert main(["history", str(make_run()), "-o", str(tmp_path / "file")]) == 1
    assert len(capsys.readouterr().err.splitlines()) == 1


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["paper"], "Missing argument"),
        (["fields", "x", "--step", "last"], "'last' is neither a step number"),
        (["history", "x", "--format", "gif"], "'gif' is not one of png, pdf, svg"),
        (["section", "x", "--plane", "y=1 furlong"], "is not a plane; allowed: 'y=0'"),
        (["section", "x", "--field", "stress_xy_"], "did you mean stress_xy?"),
        (["section", "x", "--body", "middle"], "'middle' is not one of"),
        (["first"], "'first' is no folder or file of a result, and no command; there are all, paper"),
        (["secton", "x"], "did you mean section?"),
        (["all", "x", "y"], "unexpected extra argument"),
    ],
)
def test_wrong_usage(arguments: list[str], message: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(arguments) == 2
    told = capsys.readouterr().err
    assert "Usage: brinell plot" in told
    assert message in told


@pytest.mark.parametrize("words", [["all"], []])
def test_all_is_what_a_folder_alone_means(words: list[str], make_run: MakeRun, tmp_path: Path) -> None:
    assert main([*words, str(make_run(4.0)), "--format", "svg", "-o", str(tmp_path / "out")]) == 0
    assert names(tmp_path / "out") == [
        "energy-balance.svg",
        "history.svg",
        "loaded-gap.svg",
        "loaded-pressure.svg",
        "loaded-section.svg",
        "residual-depth.svg",
        "residual-section.svg",
        "residual-surfaces.svg",
    ]


def test_options_may_come_before_the_folder(make_run: MakeRun, tmp_path: Path) -> None:
    assert main(["-o", str(tmp_path / "out"), str(make_run(4.0, finished=False))]) == 0
    assert names(tmp_path / "out") == [
        "energy-balance.png",
        "history.png",
        "loaded-gap.png",
        "loaded-pressure.png",
        "loaded-section.png",
    ]


def test_all_of_a_folder_that_is_not_there(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([str(tmp_path / "nowhere")]) == 2
    assert capsys.readouterr().err == f"brinell: error: {tmp_path / 'nowhere'}: no such folder\n"


def test_section(make_run: MakeRun, tmp_path: Path) -> None:
    options = ["--plane", "x = 2 mm", "--field", "stress_xx", "--field", "von_mises_stress", "--step", "final"]
    assert main(["section", str(make_run(9.0)), *options, "-o", str(tmp_path / "out")]) == 0
    assert names(tmp_path / "out") == ["final-section-x-2000um-stress_xx-von_mises_stress.png"]


def test_section_of_a_rigid_body(make_indentation: MakeRun, capsys: pytest.CaptureFixture[str]) -> None:
    folder = make_indentation()
    assert main(["section", str(folder), "--body", "upper"]) == 2
    assert capsys.readouterr().err == f"brinell: error: {folder}: the upper body is rigid, so it has no fields\n"


def test_animate(make_run: MakeRun, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder, path = make_run(9.0), tmp_path / "new" / "pass.gif"
    assert main(["animate", str(folder), "--plane", "x=0", "--body", "lower", "-o", str(path)]) == 0
    with Image.open(path) as picture:
        assert picture.n_frames == 2  # type: ignore[attr-defined]
    assert "brinell: 2 frames: of " in capsys.readouterr().err
    assert main(["animate", str(folder), "--field", "stress_zz"]) == 0
    assert names(folder / "figures") == ["stress_zz.gif"]


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--pass", "2"], "0 stored states in pass 2, an animation needs two or more"),
        (["--plane", "z=1 mm"], "an animation needs a plane normal to x or y"),
        (["--follow", "body"], "follow = 'body' needs a single body"),
        (["-o", "pass.avi"], "an animation is saved as .gif or .mp4"),
    ],
)
def test_animations_that_cannot_be(
    options: list[str], message: str, make_run: MakeRun, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["animate", str(make_run()), *options]) == 2
    assert message in capsys.readouterr().err


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
    assert result.stderr.splitlines() == [f"brinell: error: {tmp_path / 'nowhere'}: no such folder"]
