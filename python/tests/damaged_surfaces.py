# SPDX-License-Identifier: BSD-3-Clause
"""Files of surfaces of many formats, damaged and renamed at random: each is read as it was or refused in one line.

`python damaged_surfaces.py FIRST LAST STEP` computes cases of these numbers and prints what went wrong as JSON; a case
depends on its number alone. The tests run it as a process of its own, with a limit of memory.
"""

from __future__ import annotations

import io
import json
import signal
import struct
import sys
import tempfile
import warnings
import zipfile
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

import brinell
from brinell import InputError, surfaces
from brinell._toml import tomllib

NX, NY = 12, 9
SECONDS = 30
"""A file that takes longer to read is a failure."""
ENDINGS = (".csv", ".txt", ".dat", ".asc", ".xyz", ".npy", ".npz", ".h5", ".opd", ".SUR", ".x3p", "")


@dataclass(frozen=True)
class Seed:
    """A file that is in order.

    Attributes:
        content: its bytes.
        ending: its usual ending.
        options: arguments of `surfaces.read` that it needs.
        announces_rows: whether the file says how many rows it has; otherwise lost rows cannot be seen.
        is_text: whether a case reads the file, too.
    """

    content: bytes
    ending: str
    options: dict[str, Any]
    announces_rows: bool = True
    is_text: bool = False


def heights() -> np.ndarray[Any, Any]:
    """[ny, nx] heights in um without any symmetry."""
    return np.round(np.random.default_rng(3).normal(size=(NY, NX)), 3)


def _rows(separator: str, decimal: str = ".") -> str:
    lines = [separator.join(f"{h:.3f}" for h in row).replace(".", decimal) for row in heights()]
    return "\n".join(lines) + "\n"


def _points(separator: str) -> str:
    h = heights()
    lines = [separator.join(map(str, (2 * i, 3 * j, h[j, i]))) for j in range(NY) for i in range(NX)]
    return "\n".join(lines) + "\n"


GWYDDION = f"# Channel: Topography\n# Width: {2 * NX} µm\n# Height: {3 * NY} µm\n# Value units: um\n"
SPIP = (
    f"# File Format = ASCII\n# x-pixels = {NX}\n# y-pixels = {NY}\n# x-length = 24\n# y-length = 27\n"
    "# x-unit = um\n# y-unit = um\n# z-unit = um\n"
)
WYKO = (
    f"Wyko ASCII Data File Format\t0\t1\nX Size\t{NY}\nY Size\t{NX}\nBlock Name\tType\tLength\tAttribute\n"
    f"RAW_DATA\t3\t{4 * NX * NY}\t0\nPixel_size\t7\t4\t0.002\nWavelength\t7\t4\t600\nRAW_DATA\t3\t{4 * NX * NY}\n"
)


def _written(write: Callable[[Path], None], ending: str) -> bytes:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, f"map{ending}")
        write(path)
        return path.read_bytes()


def _sdf(is_text: bool) -> bytes:
    counts: dict[str, Any] = {"NumPoints": NX, "NumProfiles": NY, "Xscale": 2e-6, "Yscale": 3e-6, "Zscale": 1e-6}
    if is_text:
        fields = {"ManufacID": "brinell", **counts, "Zresolution": -1, "Compression": 0, "DataType": 7, "CheckType": 0}
        head = "".join(f"{name} = {value}\n" for name, value in fields.items())
        return f"aISO-1.0\n{head}*\n{_rows(' ')}*\n".encode()
    head_bytes = struct.pack(
        "<8s10s12s12sHHddddBBB", b"bISO-1.0", b"brinell", b"", b"", NX, NY, 2e-6, 3e-6, 1e-6, -1, 0, 7, 0
    )
    return head_bytes + heights().astype("<f8").tobytes()


def _bcr() -> bytes:
    head = (
        f"fileformat = bcrf\nheadersize = 2048\nxpixels = {NX}\nypixels = {NY}\nxlength = 24\nylength = 27\n"
        "xunit = um\nyunit = um\nzunit = um\nintelmode = 1\n"
    )
    return head.ljust(2048).encode() + heights().astype("<f4").tobytes()


def _gwy() -> bytes:
    def item(name: str, kind: str, data: bytes) -> bytes:
        return name.encode() + b"\0" + kind.encode() + data

    def thing(name: str, content: bytes) -> bytes:
        return name.encode() + b"\0" + struct.pack("<L", len(content)) + content

    unit = thing("GwySIUnit", item("unitstr", "s", b"m\0"))
    values = (heights() * 1e-6).astype("<f8").tobytes()
    field = b"".join(
        [
            item("xres", "i", struct.pack("<i", NX)),
            item("yres", "i", struct.pack("<i", NY)),
            item("xreal", "d", struct.pack("<d", 2e-6 * NX)),
            item("yreal", "d", struct.pack("<d", 3e-6 * NY)),
            item("si_unit_xy", "o", unit),
            item("si_unit_z", "o", unit),
            item("data", "D", struct.pack("<L", NX * NY) + values),
        ]
    )
    title = item("/0/data/title", "s", b"Topography\0")
    return b"GWYP" + thing("GwyContainer", title + item("/0/data", "o", thing("GwyDataField", field)))


def _of_libraries() -> dict[str, Seed]:
    """Files that other packages write."""
    import h5py
    import scipy.io
    from SurfaceTopography import Topography
    from SurfaceTopography.IO.X3P import write_x3p

    topography = Topography(heights().T, (2.0 * NX, 3.0 * NY), unit="um")
    in_metres = Topography(1e-6 * heights().T, (2e-6 * NX, 3e-6 * NY), unit="m")

    def hdf5(path: Path) -> None:
        with h5py.File(path, "w") as file:
            file["surface"] = heights().T

    no_size = {"spacing": ("2 um", "3 um"), "unit": "um"}
    return {
        "netcdf": Seed(_written(lambda path: topography.to_netcdf(str(path)), ".nc"), ".nc", {}),
        "x3p": Seed(_written(lambda path: write_x3p(in_metres, str(path)), ".x3p"), ".x3p", {}),
        "hdf5": Seed(_written(hdf5, ".h5"), ".h5", no_size),
        "matlab": Seed(_written(lambda path: scipy.io.savemat(path, {"h": heights().T}), ".mat"), ".mat", no_size),
    }


def seeds() -> dict[str, Seed]:
    """The files by name."""
    spacing, um = ("2 um", "3 um"), "um"
    ours = surfaces.HeightMap(heights() * 1e-6, spacing)
    archive = io.BytesIO()
    with zipfile.ZipFile(archive, "w") as file:
        file.writestr("readme.txt", "no surface")
    plain = {"spacing": spacing, "unit": um}
    own: dict[str, Seed] = {
        "commas": Seed(_rows(",").encode(), ".csv", plain, False, True),
        "decimal commas": Seed(_rows(";", ",").encode(), ".csv", plain, False, True),
        "tabs": Seed(_rows("\t").encode(), ".txt", plain, False, True),
        "blanks": Seed(_rows(" ").encode(), ".asc", plain, False, True),
        "utf-16": Seed(_rows(",").encode("utf-16"), ".csv", plain, False, True),
        "gwyddion": Seed((GWYDDION + _rows("\t")).encode(), ".txt", {}, False, True),
        "gwyddion in latin-1": Seed((GWYDDION + _rows("\t")).encode("latin-1"), ".txt", {}, False, True),
        "spip": Seed((SPIP + _rows("\t")).encode(), ".asc", {}, True, True),
        "points": Seed(_points(" ").encode(), ".xyz", {"unit": um}, False, True),
        "titled points": Seed(f"x [um];y [um];z [um]\n{_points(';')}".encode(), ".csv", {}, False, True),
        "wyko": Seed(
            (WYKO + "\n".join("\t".join(f"{h:.3f}" for h in column) for column in heights()) + "\n").encode(),
            ".asc",
            {},
        ),
        "own text": Seed(_written(lambda path: surfaces.write(path, ours), ".csv"), ".csv", {}, False, True),
        "npz": Seed(_written(lambda path: surfaces.write(path, ours), ".npz"), ".npz", {}),
        "npy": Seed(_written(lambda path: surfaces.write(path, ours), ".npy"), ".npy", {"spacing": spacing}),
        "sdf": Seed(_sdf(False), ".sdf", {}),
        "sdf as text": Seed(_sdf(True), ".sdf", {}),
        "bcrf": Seed(_bcr(), ".bcrf", {}),
        "gwy": Seed(_gwy(), ".gwy", {}),
        "no surface": Seed(archive.getvalue(), ".zip", {}),
    }
    return own | _of_libraries()


def damaged(content: bytes, random: np.random.Generator) -> bytes:
    """The content with one kind of damage, or none."""
    data = bytearray(content)
    kind = random.integers(0, 7)
    at = int(random.integers(0, len(data)))
    if kind == 0:
        del data[at:]
    elif kind == 1:  # bits
        for place in random.integers(0, len(data), size=random.integers(1, 8)):
            data[place] ^= 1 << int(random.integers(0, 8))
    elif kind == 2:  # bytes, mostly in the header
        for place in random.integers(0, min(len(data), 400), size=random.integers(1, 4)):
            data[place] = int(random.integers(0, 256))
    elif kind == 3:  # a part is lost
        del data[at : at + int(random.integers(1, 40))]
    elif kind == 4:  # a part is there twice
        data[at:at] = data[at : at + int(random.integers(1, 40))]
    elif kind == 5:  # lines
        lines = bytes(data).split(b"\n")
        line = int(random.integers(0, len(lines)))
        lines[line] = lines[line][: len(lines[line]) // 2] if random.integers(0, 2) else b"\xb5;" + lines[line]
        data = bytearray(b"\n".join(lines))
    return bytes(data)


def outcome(seed: Seed, number: int, folder: Path) -> tuple[str, str]:
    """How reading of a damaged file ends, "read", "refused" or "wrong", and the message or the shape."""
    random = np.random.default_rng([number, 20261128])
    content = damaged(seed.content, random)
    ending = seed.ending if random.integers(0, 2) else str(random.choice(ENDINGS))
    path = folder / f"map{ending}"
    path.write_bytes(content)
    in_case = None
    signal.alarm(SECONDS)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            fills = bool(random.integers(0, 2))
            in_case = by_case(path, seed.options | {"fill": fills}) if seed.is_text else None
            found = surfaces.read(path, fill=fills, **seed.options).heights
    except (InputError, OSError) as error:
        text = str(error)
        if isinstance(in_case, np.ndarray):
            return "wrong", f"a case reads it, but: {text}"
        is_told = text.startswith(f"{path}: ") and len(text) > len(f"{path}: ") + 5 and len(text.splitlines()) == 1
        return ("refused" if is_told else "wrong"), text
    except BaseException as error:  # what a user would see as a traceback
        return "wrong", f"{type(error).__name__}: {error}"
    finally:
        signal.alarm(0)
        path.unlink()
    if isinstance(in_case, str) or (in_case is not None and not np.array_equal(in_case, found)):
        return "wrong", f"a case does not read it so: {str(in_case)[:200]}"
    ny, nx = found.shape
    is_cut = not seed.announces_rows and (nx == NX or ny == 1)  # nobody can see that
    is_whole = (nx, ny) == (NX, NY) or is_cut
    return ("read" if is_whole else "wrong"), f"{nx} x {ny}"


CASE = """scenario = "indentation"
[lower]
shape = {{ type = "flat" }}
material = {{ young_modulus = "210 GPa", poisson_ratio = 0.3 }}
texture = {{ type = "height_map", file = "{file}", {keys} }}
[upper]
shape = {{ type = "sphere", radius = "1 mm" }}
material = {{ rigid = true }}
[indentation]
load = ["1 N"]
"""


INSTRUMENT = "formats of instruments, with --channel"
"""In the refusal of a file that `surfaces.read` may read by another package."""


def by_case(path: Path, options: dict[str, Any]) -> np.ndarray[Any, Any] | str | None:
    """The heights that a case with the file has, or why it has none; None if the file may be of another format."""
    keys = ", ".join(f"{key} = {json.dumps(value)}" for key, value in options.items())
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            case = brinell.Case(CASE.format(file=path.name, keys=keys), file=path.parent / "case.toml")
        except InputError as error:
            return None if INSTRUMENT in str(error) else str(error)
    texture = tomllib.loads(case.to_toml())["lower"]["texture"]
    return np.reshape(texture["heights"], (-1, texture["columns"]))


def main(first: int, last: int, step: int) -> None:
    """Computes cases and prints how many ended how, and what is wrong."""

    def too_long(*_: object) -> None:
        raise TimeoutError

    signal.signal(signal.SIGALRM, too_long)
    all_seeds = seeds()
    names = sorted(all_seeds)
    count: Counter[str] = Counter()
    wrong = []
    with tempfile.TemporaryDirectory() as folder:
        for number in range(first, last, step):
            name = names[number % len(names)]
            how, text = outcome(all_seeds[name], number, Path(folder))
            count[how] += 1
            if how == "wrong":
                wrong.append(f"case {number}, {name}: {text}")
    print(json.dumps({"count": count, "wrong": wrong}))


if __name__ == "__main__":
    main(*map(int, sys.argv[1:4]))
