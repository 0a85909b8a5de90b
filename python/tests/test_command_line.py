# SPDX-License-Identifier: BSD-3-Clause
"""The console script: the same as the C++ program where both have a command, and what only it has."""

import contextlib
import fcntl
import importlib.util
import json
import os
import pty
import re
import signal
import struct
import subprocess
import sys
import termios
import time
from collections.abc import Callable
from pathlib import Path

import click
import pytest
from click.shell_completion import ShellComplete

import brinell
from brinell import _core, cli, completion, python_commands
from brinell._toml import tomllib
from brinell.scenarios import SCENARIOS

ROOT = Path(__file__).parents[2]
SCRIPT = Path(sys.executable).with_name("brinell")
PROGRAM = ROOT / "build" / "release" / "bin" / "brinell"

CASE = """scenario = "tugging"
[lower]
shape = {type = "sphere", radius = "1 m"}
material = {young_modulus = "200 GPa", poisson_ratio = 0.3, hardening = {law = "perfect", yield_stress = "1 GPa"}}
[upper]
shape = {type = "sphere", radius = "1 m"}
material = {young_modulus = "200 GPa", poisson_ratio = 0.3}
[tugging]
interference = 3
[grid]
resolution = 3
"""

Outcome = subprocess.CompletedProcess[str]


def called(program: Path | str, *arguments: str, folder: Path, **environment: str) -> Outcome:
    return subprocess.run(
        [program, *arguments],
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=120,
        env={**os.environ, "OMP_NUM_THREADS": "1", **environment},
    )


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "case.toml").write_text(CASE)
    (tmp_path / "bad.toml").write_text(CASE.replace("0.3", "0.6").replace("= 3\n", '= "many"\n'))
    return tmp_path


@pytest.fixture(scope="session")
def program() -> Path:
    if not PROGRAM.is_file():
        pytest.skip(f"{PROGRAM} is not built (make build)")
    return PROGRAM


@pytest.mark.parametrize(
    "line",
    [
        "--help",
        "-h",
        "run --help",
        "cite -h",
        "check case.toml",
        "check --set tugging.passes=2 --set title=twice case.toml",
        "schema",
        "schema --markdown",
        "new rolling",
        "new tugging -o new.toml",
        "cite case.toml",
        "cite --bibtex case.toml --set lower.material.hardening.law=none --set tugging.normalised=false",
        "run case.toml -q",
        "",
        "--wrong",
        "walk",
        "run",
        "run case.toml --threads 0",
        "run nowhere.toml",
        "check bad.toml",
        "check case.toml --set",
        "check case.toml --set tugging.interference=-1",
        "check case.toml --set lower.colour=red",
        "cite bad.toml --bibtex",
        "new walking",
        "new tugging -o case.toml",
        "new tugging -o nowhere/case.toml",
    ],
)
def test_answers_are_those_of_the_program(line: str, program: Path, folder: Path) -> None:
    ours = called(SCRIPT, *line.split(), folder=folder)
    (folder / "new.toml").unlink(missing_ok=True)
    theirs = called(program, *line.split(), folder=folder)
    assert (ours.returncode, ours.stdout, ours.stderr) == (theirs.returncode, theirs.stdout, theirs.stderr)


def test_version_is_that_of_the_package(program: Path, tmp_path: Path) -> None:
    for one in (SCRIPT, program):  # they may be built at different commits
        version = called(one, "--version", folder=tmp_path).stdout
        assert re.fullmatch(rf"brinell {re.escape(brinell.__version__)} \(\S+\), HDF5 \S+, compiled for \S+\n", version)


def test_licences_name_the_libraries_of_both(program: Path, tmp_path: Path) -> None:
    for one in (SCRIPT, program):
        licences = called(one, "--licenses", folder=tmp_path)
        assert licences.returncode == 0
        assert licences.stdout.startswith((ROOT / "LICENSE").read_text(encoding="utf-8"))
        for library in ("HDF5", "zlib", "Eigen", "nanobind", "libgomp"):
            assert f"\n{library}" in licences.stdout
        assert "FFTW" not in licences.stdout


# Both are built for the processor at hand, with the same flags.
def test_a_run_gives_the_same_bytes(program: Path, folder: Path) -> None:
    assert called(SCRIPT, "run", "case.toml", "-q", "-o", "script", folder=folder).returncode == 0
    assert called(program, "run", "case.toml", "-q", "-o", "program", folder=folder).returncode == 0
    brinell.Case.from_file(folder / "case.toml").run(folder / "api", threads=1)
    history = (folder / "program" / "history.csv").read_bytes()
    assert history.count(b"\n") > 5
    assert (folder / "script" / "history.csv").read_bytes() == history
    assert (folder / "api" / "history.csv").read_bytes() == history


def test_python_says_the_same(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(folder)
    check = called(SCRIPT, "check", "case.toml", "--set", "tugging.passes=2", folder=folder)
    assert brinell.Case.from_file("case.toml", ["tugging.passes=2"]).check() == check.stdout
    with pytest.raises(brinell.InputError) as raised:
        brinell.Case.from_file("bad.toml")
    lines = called(SCRIPT, "check", "bad.toml", folder=folder).stderr.splitlines()
    assert len(lines) > 1
    assert [f"brinell: error: {line}" for line in str(raised.value).splitlines()] == lines


def test_citations_are_those_of_the_command(folder: Path) -> None:
    lines = brinell.Case.from_file(folder / "case.toml").citations()
    told = called(SCRIPT, "cite", "case.toml", folder=folder).stdout
    assert lines[0].startswith("The brinell authors (2026). brinell: ")
    assert len(lines) > 5
    for line in lines[1:]:
        reference, use = line.removesuffix("]").rsplit(" [", 1)
        assert f"\n{reference}\n    for: {use}\n" in told


def test_module_is_the_script(folder: Path) -> None:
    module = called(sys.executable, "-m", "brinell", "new", "tugging", folder=folder)
    assert module.stdout == called(SCRIPT, "new", "tugging", folder=folder).stdout


def test_commands_of_the_engine_load_nothing_else(folder: Path) -> None:
    code = """if True:
        import sys, brinell.cli
        try:
            brinell.cli.main(sys.argv[1:])
        finally:
            print([m for m in sys.modules if m.split(".")[0] in ("numpy", "h5py", "matplotlib", "click", "email")])
            print([m for m in sys.modules if m.startswith("brinell.")])"""
    for words in (["--version"], ["check", str(folder / "case.toml")], ["schema", "grid.extent"], ["walk"]):
        out = called(sys.executable, "-c", code, *words, folder=folder).stdout.splitlines()
        assert out[-2] == "[]", words
        needed = {"_processor", "_built_for", "cli", "_core", "errors"}
        assert {m.removeprefix("brinell.") for m in re.findall(r"'(.*?)'", out[-1])} <= needed, words


def test_help_lists_all_commands(folder: Path) -> None:
    listed = called(SCRIPT, "--help", folder=folder).stdout
    for command in _core.commands():
        assert re.search(rf"^  {command.name} +{re.escape(command.help)}$", listed, re.MULTILINE), command.name


@pytest.mark.parametrize("name", cli.COMMANDS)
def test_commands_of_the_package(name: str, folder: Path) -> None:
    assert name in [command.name for command in _core.commands()]
    command = python_commands.root.get_command(click.Context(python_commands.root), name)
    assert isinstance(command, click.Command)
    page = called(SCRIPT, name, "--help", folder=folder)
    assert page.returncode == 0
    assert page.stdout.startswith(f"Usage: brinell {name} ")


def raising(error: BaseException) -> Callable[[], object]:
    def command() -> object:
        raise error

    return command


@pytest.mark.parametrize(
    ("error", "code", "message"),
    [
        (
            brinell.InputError("a.toml:3: x\na.toml:4: y"),
            2,
            "brinell: error: a.toml:3: x\nbrinell: error: a.toml:4: y\n",
        ),
        (brinell.GridError("too fine"), 1, "brinell: error: too fine\n"),
        (brinell.ConvergenceError("step 3"), 1, "brinell: error: no convergence: step 3\n"),
        (brinell.DeviceError("no GPU is visible"), 1, "brinell: error: no GPU is visible\n"),
        (brinell.IoError("out: no space"), 1, "brinell: error: out: no space\n"),
        (PermissionError(13, "Permission denied", "out"), 1, "brinell: error: [Errno 13] Permission denied: 'out'\n"),
        (brinell.RunError("out: nothing there"), 2, "brinell: error: out: nothing there\n"),
        (brinell.InternalError("x"), 1, "brinell: error: internal error, a bug of brinell, please report it: x\n"),
        (KeyboardInterrupt(), 130, ""),
    ],
)
def test_errors(error: BaseException, code: int, message: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert python_commands.guarded(raising(error)) == code
    assert capsys.readouterr().err == message


def test_bad_options_of_the_package(folder: Path) -> None:
    bad = called(SCRIPT, "completion", "--loud", folder=folder)
    assert bad.returncode == 2
    assert bad.stderr.startswith("brinell: error: No such option")
    assert bad.stderr.endswith("Run brinell completion --help for more information.\n")


def test_interrupted_run_ends_as_in_the_program(folder: Path) -> None:
    with subprocess.Popen(
        [
            SCRIPT,
            "run",
            "case.toml",
            "-q",
            "-o",
            "out",
            "--set",
            "tugging.passes=10000",
            "--set",
            "output.snapshots=none",
        ],
        cwd=folder,
        stderr=subprocess.PIPE,
        text=True,
    ) as process:
        history = folder / "out" / "history.csv"
        until = time.monotonic() + 60
        while not (history.exists() and history.read_text().count("\n") > 3) and time.monotonic() < until:
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        _, told = process.communicate(timeout=60)
    assert process.returncode == 130
    assert told == "brinell: interrupted; the finished steps are in out, and --resume continues the run\n"


def test_a_closed_pipe_is_no_error(folder: Path) -> None:
    line = f"set -o pipefail; {SCRIPT} schema | true"
    done = subprocess.run(["bash", "-c", line], capture_output=True, text=True, cwd=folder, timeout=60)
    assert done.returncode in (0, 128 + signal.SIGPIPE)  # it may have written all before the pipe closed
    assert done.stderr == ""


# --- Completion -------------------------------------------------------------------------------------------------------


def offered(*words: str) -> list[str]:
    """What is offered for the last of the words."""
    shell = ShellComplete(python_commands.root, {}, "brinell", cli.COMPLETING)
    return [item.value for item in shell.get_completions(list(words[:-1]), words[-1])]


def test_commands_are_completed() -> None:
    assert offered("") == [command.name for command in _core.commands()]
    assert offered("s") == ["schema", "sweep", "surface"]
    assert offered("--v") == ["--version"]
    assert offered("--l") == ["--licenses"]


def test_options_are_completed() -> None:
    assert offered("run", "-") == [
        "-h",
        "--help",
        "--set",
        "-o",
        "--output",
        "--accuracy",
        "--device",
        "--threads",
        "--resume",
        "--keep",
        "-q",
        "--quiet",
    ]
    assert offered("run", "case.toml", "--th") == ["--threads"]
    assert offered("cite", "--b") == ["--bibtex"]
    assert offered("new", "--f") == ["--force"]


def test_keys_are_completed() -> None:
    assert offered("run", "--set", "tugging.in") == ["tugging.interference="]
    assert offered("check", "case.toml", "--set", "grid.s") == ["grid.size=", "grid.spacing="]
    assert offered("cite", "--set", "title=x", "--set", "solver.integration=b") == ["solver.integration=backward_euler"]
    shell = ShellComplete(python_commands.root, {}, "brinell", cli.COMPLETING)
    assert shell.get_completions(["run", "--set"], "tugging.passes")[0].help.startswith(
        "Number of passes of the upper body"
    )


def test_scenarios_are_completed() -> None:
    assert offered("new", "") == list(SCENARIOS)


def test_case_files_are_completed(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    deep = folder / "cases" / "mine"
    deep.mkdir(parents=True)
    (deep / "case.toml").write_text(CASE)
    (deep / "notes.txt").write_text("")
    monkeypatch.chdir(folder)
    assert offered("run", "") == ["bad.toml", "case.toml", "cases/mine/case.toml"]
    assert offered("check", "ca") == ["case.toml", "cases/mine/case.toml"]
    assert offered("check", "cases/") == ["cases/mine/case.toml"]
    assert offered("check", "cases/mi") == ["cases/mine/case.toml"]
    shell = ShellComplete(python_commands.root, {}, "brinell", cli.COMPLETING)
    assert [item.type for item in shell.get_completions(["run"], "elsewhere/")] == ["file"]


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_script_says_where_it_belongs(shell: str, folder: Path) -> None:
    script = called(SCRIPT, "completion", shell, folder=folder)
    assert script.returncode == 0
    assert f"_BRINELL_COMPLETE={shell}_complete" in script.stdout
    assert script.stdout.endswith(f"write it into\n#   {completion.PLACES[shell]}\n")
    assert script.stdout.startswith("#compdef brinell\n") == (shell == "zsh")


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("brinell s", ["schema", "sweep", "surface"]),
        ("brinell run case.toml --set tugging.in", ["tugging.interference="]),
        ("brinell check ca", ["case.toml"]),
        ("brinell new r", ["rolling"]),
    ],
)
def test_bash_completes(line: str, expected: list[str], folder: Path) -> None:
    words = line.split()
    (folder / "completion.bash").write_text(called(SCRIPT, "completion", "bash", folder=folder).stdout)
    script = f"""
compopt() {{ echo "compopt $*" >&2; }}  # is only allowed while a user presses the key
source ./completion.bash
complete -p brinell >/dev/null || exit 3
COMP_WORDS=({line}) COMP_CWORD={len(words) - 1}
_brinell_completion brinell
printf '%s\\n' "${{COMPREPLY[@]}}"
"""
    path = f"{SCRIPT.parent}:{os.environ['PATH']}"
    done = called("bash", "--norc", "-c", script, folder=folder, PATH=path)
    assert done.stdout.split() == expected
    # The value follows a key without a space.
    assert done.stderr.split() == (["compopt", "-o", "nospace"] if expected[0].endswith("=") else [])


# --- Reference page ---------------------------------------------------------------------------------------------------


def test_reference_page_is_up_to_date() -> None:
    tool = importlib.util.spec_from_file_location("render_command_line", ROOT / "tools" / "render_command_line.py")
    assert tool is not None
    assert tool.loader is not None
    module = importlib.util.module_from_spec(tool)
    tool.loader.exec_module(module)
    page = (ROOT / "docs" / "reference" / "command-line.md").read_text(encoding="utf-8")
    assert module.rendered(str(SCRIPT)) == page, "run tools/render_command_line.py (make docs does)"


def columns_on_a_terminal(width: int, folder: Path, *arguments: str) -> list[str]:
    """What each rewriting of the bar puts on a terminal of that width."""
    here, there = pty.openpty()
    fcntl.ioctl(there, termios.TIOCSWINSZ, struct.pack("HHHH", 24, width, 0, 0))
    with subprocess.Popen([SCRIPT, *arguments], cwd=folder, stdout=subprocess.DEVNULL, stderr=there) as process:
        os.close(there)
        shown = b""
        with contextlib.suppress(OSError):  # the end, on Linux
            while part := os.read(here, 4096):
                shown += part
    os.close(here)
    assert process.returncode == 0
    return [line.replace("\x1b[K", "") for line in re.split(r"[\r\n]+", shown.decode()) if line.startswith("[")]


@pytest.mark.parametrize("width", [40, 60, 100])
def test_the_bar_fits_the_terminal(folder: Path, width: int) -> None:
    if not SCRIPT.exists():
        pytest.skip("the command brinell is not installed beside this Python")
    bars = columns_on_a_terminal(width, folder, "run", "case.toml", "-o", "out")
    assert bars
    assert max(map(len, bars)) < width  # the last column would begin a new line
    assert bars[-1].startswith("[" + "#" * (24 if width == 100 else 8))
    if width == 100:
        assert bars[-1].endswith(" left")


def test_a_grid_that_outgrows_the_memory_is_no_bad_input(capsys: pytest.CaptureFixture[str]) -> None:
    def outgrow() -> None:
        raise brinell.GridError("larger grids would need 31 GB")

    assert python_commands.guarded(outgrow) == 1
    assert capsys.readouterr().err == "brinell: error: larger grids would need 31 GB\n"


@pytest.mark.parametrize("scenario", SCENARIOS)
def test_the_schema_of_editors_takes_the_cases_of_new(scenario: str, folder: Path) -> None:
    jsonschema = pytest.importorskip("jsonschema")
    schema = json.loads(called(SCRIPT, "schema", "--json", folder=folder).stdout)
    case = tomllib.loads(called(SCRIPT, "new", scenario, folder=folder).stdout)
    jsonschema.Draft202012Validator.check_schema(schema)
    jsonschema.validate(case, schema)
    case["lower"]["material"]["poisson_ratio"] = 0.7
    case["lower"]["shape"]["raduis"] = 1.0
    problems = {error.json_path for error in jsonschema.Draft202012Validator(schema).iter_errors(case)}
    assert problems == {"$.lower.material.poisson_ratio", "$.lower.shape"}


def test_the_readme_installs_what_its_commands_need() -> None:
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    (extras,) = re.findall(r'^pip install -v "\.\[([\w,]+)\]"', readme, re.MULTILINE)
    assert "brinell sweep" in readme
    assert "sweep" in extras.split(",")
