# SPDX-License-Identifier: BSD-3-Clause
"""Results of one pass of two asperities of a material pair: computed nodes, and interpolation between them.

An offset across the motion needs no nodes of its own: by symmetry of the spheres about the plane through the direction
of motion and the line of centres (docs/theory/asperities.md), it only reduces the interference and tilts the forces.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import h5py
import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.interpolate import PchipInterpolator

from brinell import _core
from brinell.asperities.pairs import QUANTITIES, Quantity, UnitRadius, closest
from brinell.errors import InputError, IoError, MissingExtraError
from brinell.materials import Material
from brinell.settings import Interface

if TYPE_CHECKING:
    import xarray

__all__ = ["AsperityMap", "Interpolated"]

FloatArray = NDArray[np.float64]

_FORMAT = "brinell-asperity-map"
_FORMAT_VERSION = 1
_DEFAULT_INTERFERENCES = (0.5, 1.0, 1.5, 2.2, 3.2, 4.5, 6.3, 9.0, 13.0)


@dataclass(frozen=True)
class Interpolated:
    """Interpolated values of a map, in SI units.

    Attributes:
        value: interpolated values.
        mesh: discretisation error from the cells of the runs, >= 0.
        interpolation: interpolation error from the distance of the nodes; the full value beyond the last node.
    """

    value: FloatArray
    mesh: FloatArray
    interpolation: FloatArray


@dataclass(frozen=True, eq=False)
class AsperityMap:
    """Results of passes of two spheres of a material pair, over the interference and the ratio of the radii.

    Attributes:
        case: case of the first node, as TOML.
        pair: critical values of the materials.
        interferences: (n,) interferences alpha/alpha_c of the nodes, ascending [-].
        ratios: (k,) ratios R1/R2 of the nodes, ascending [-].
        nodes: (k, n) values by name of the quantity, divided by its unit and by (alpha/alpha_c)^power, for
            interpolation.
        mesh_errors: (k, n) discretisation errors of the nodes, scaled in the same way.
        resolutions: cells per contact radius of the two meshes; the values are those of the finer one.
    """

    case: str
    pair: UnitRadius
    interferences: FloatArray
    ratios: FloatArray
    nodes: Mapping[str, FloatArray]
    mesh_errors: Mapping[str, FloatArray]
    resolutions: tuple[float, float]

    @classmethod
    def compute(
        cls,
        lower: Material,
        upper: Material | None = None,
        *,
        interferences: Sequence[float] = _DEFAULT_INTERFERENCES,
        ratios: Sequence[float] = (1.0,),
        interface: Interface | Mapping[str, Any] | None = None,
        resolutions: tuple[float, float] = (6.0, 9.0),
        output: str | Path | None = None,
        workers: int | None = None,
        cluster: Any = None,
        progress: bool = True,
    ) -> AsperityMap:
        """Computes the nodes by a sweep of tugging runs, each on two meshes.

        A script needs ``if __name__ == "__main__":`` before the call, as for `brinell.sweep`.

        Args:
            lower: material of the lower surface.
            upper: material of the upper surface; None: the same.
            interferences: interferences alpha/alpha_c of the nodes, three or more, ascending; the lowest must not
                exceed 1, so that elastic passes can be scaled from it.
            ratios: ratios R1/R2 of the nodes. In units of the pair the results depend weakly on the ratio. Outside the
                range the map is constant, and no error is reported for that.
            interface: friction between the surfaces.
            resolutions: cells per contact radius of the coarse and the fine mesh, whose difference gives the mesh
                error.
            output: folder of the sweep, which resumes what is there; None: a temporary folder.
            workers: number of processes, as in `brinell.sweep`.
            cluster: Dask cluster, as in `brinell.sweep`.
            progress: show a progress bar.

        Raises:
            InputError: nodes or materials are not suitable.
            BrinellError: a run has failed.
        """
        from brinell.asperities.nodes import computed_nodes  # sweeps are imported when they are needed

        return cls(
            *computed_nodes(
                lower,
                upper if upper is not None else lower,
                _ascending("interferences", interferences, 3),
                _ascending("ratios", ratios, 1),
                interface,
                resolutions,
                output,
                {"workers": workers, "cluster": cluster, "progress": progress},
            )
        )

    def at(
        self,
        quantity: str,
        interference: ArrayLike,
        offset: ArrayLike = 0.0,
        *,
        lower_radius: ArrayLike,
        upper_radius: ArrayLike,
    ) -> Interpolated:
        """Result of one pass; 0 where the asperities do not touch. Array arguments are broadcast.

        Args:
            quantity: one of `QUANTITIES`, or "lateral", the integral of F_Y along the pass [N m].
            interference: overlap of the tops in height [m].
            offset: distance of the upper centre from the lower one along y [m].
            lower_radius: radius R1 of the lower asperity [m].
            upper_radius: radius R2 of the upper asperity [m].

        Raises:
            InputError: the quantity is unknown.
        """
        R1, R2 = np.asarray(lower_radius, dtype=np.float64), np.asarray(upper_radius, dtype=np.float64)
        alpha, tilt = closest(interference, offset, R1 + R2)
        of = _known("normal" if quantity == "lateral" else quantity)
        scaled = self.scaled(of.name, alpha / (self.pair.interference * R1 * R2 / (R1 + R2)), R1 / R2)
        unit = of.unit(self.pair, R1, R2) * turned(quantity, tilt)
        return Interpolated(scaled.value * unit, scaled.mesh * np.abs(unit), scaled.interpolation * np.abs(unit))

    def scaled(self, quantity: str, interference: ArrayLike, ratio: ArrayLike = 1.0) -> Interpolated:
        """Result of one pass without offset, divided by the unit of the quantity.

        Args:
            quantity: one of `QUANTITIES`.
            interference: alpha/alpha_c [-].
            ratio: R1/R2 [-]; outside the nodes the value of the last node is used.
        """
        a, kappa = np.broadcast_arrays(np.asarray(interference, dtype=np.float64), np.asarray(ratio, dtype=np.float64))
        power = np.maximum(a, 0.0) ** _known(quantity).power
        x = np.log(np.clip(a, self.interferences[0], self.interferences[-1]))
        value, mesh, between = (
            self.between_ratios([curve(x) for curve in curves], kappa) * power for curves in self._curves[quantity]
        )
        beyond = a > self.interferences[-1]
        return Interpolated(value, mesh, np.where(beyond, np.abs(value), between))

    @cached_property
    def interpolation_errors(self) -> dict[str, FloatArray]:
        """(k, n) interpolation errors of the nodes by quantity: error at each node if it is left out.

        This overestimates the error between the nodes, because the gap is twice as wide; the outermost nodes take the
        error of their neighbours.
        """
        x = np.log(self.interferences)
        errors = {}
        for name, values in self.nodes.items():
            error = np.zeros_like(values)
            for n in range(1, x.size - 1):
                rest = np.delete(np.arange(x.size), n)
                for k, row in enumerate(values):
                    error[k, n] = abs(float(_shape_preserving(x[rest], row[rest])(x[n])) - row[n])
            error[:, 0], error[:, -1] = error[:, 1], error[:, -2]
            errors[name] = error
        return errors

    @cached_property
    def _curves(self) -> dict[str, tuple[list[Any], list[Any], list[Any]]]:
        """Interpolants of values, mesh and interpolation errors by quantity, per ratio over ln(alpha/alpha_c)."""
        x = np.log(self.interferences)

        def broken_lines(rows: FloatArray) -> list[Any]:
            return [lambda at, row=row: np.interp(at, x, row) for row in rows]

        return {
            name: (
                [_shape_preserving(x, row) for row in values],
                broken_lines(self.mesh_errors[name]),
                broken_lines(self.interpolation_errors[name]),
            )
            for name, values in self.nodes.items()
        }

    def between_ratios(self, values: Sequence[FloatArray], ratio: FloatArray) -> FloatArray:
        """Interpolates values at the ratios of the nodes: linear in the logarithm of the ratio, constant outside."""
        if len(values) == 1:
            return np.asarray(values[0], dtype=np.float64)
        nodes = np.log(self.ratios)
        x = np.clip(np.log(ratio), nodes[0], nodes[-1])
        k = np.clip(np.searchsorted(nodes, x, side="right") - 1, 0, nodes.size - 2)
        t = (x - nodes[k]) / (nodes[k + 1] - nodes[k])
        stacked = np.stack(np.broadcast_arrays(*values))
        low = np.take_along_axis(stacked, k[None], axis=0)[0]
        high = np.take_along_axis(stacked, k[None] + 1, axis=0)[0]
        return np.asarray((1.0 - t) * low + t * high)

    def write(self, file: str | Path) -> None:
        """Writes the map to an HDF5 file for `read`.

        Raises:
            IoError: the file cannot be written.
        """
        try:
            with h5py.File(file, "w") as out:
                out.attrs.update(
                    format=_FORMAT,
                    format_version=_FORMAT_VERSION,
                    case=self.case,
                    resolutions=self.resolutions,
                    versions=str(_core.library_versions()),
                    **{f"critical_{name}": value for name, value in vars(self.pair).items()},
                )
                out["interference"] = self.interferences
                out["ratio"] = self.ratios
                for name, values in self.nodes.items():
                    out[f"nodes/{name}"] = values
                    out[f"mesh_errors/{name}"] = self.mesh_errors[name]
                    out[f"nodes/{name}"].attrs["meaning"] = QUANTITIES[name].text
        except OSError as error:
            raise IoError(f"{file}: cannot be written: {error}") from error

    @classmethod
    def read(cls, file: str | Path) -> AsperityMap:
        """Reads a map from a file of `write`.

        Raises:
            InputError: the file is not a map, is damaged or has another format version.
            IoError: the file cannot be read.
        """
        try:
            with h5py.File(file) as found:
                if found.attrs.get("format") != _FORMAT or found.attrs.get("format_version") != _FORMAT_VERSION:
                    raise InputError(f"{file}: is no map of asperities of format version {_FORMAT_VERSION}")
                return cls(
                    str(found.attrs["case"]),
                    UnitRadius(*(float(found.attrs[f"critical_{name}"]) for name in UnitRadius.__annotations__)),
                    found["interference"][:],
                    found["ratio"][:],
                    {name: found[f"nodes/{name}"][:] for name in QUANTITIES},
                    {name: found[f"mesh_errors/{name}"][:] for name in QUANTITIES},
                    tuple(float(value) for value in found.attrs["resolutions"]),  # type: ignore[arg-type]
                )
        except KeyError as error:
            raise InputError(f"{file}: is damaged, {error}") from error
        except OSError as error:
            raise IoError(f"{file}: cannot be read: {error}") from error

    def to_xarray(self) -> xarray.Dataset:
        """Nodes as an xarray dataset in units of each quantity: NAME, `NAME_mesh_error`, `NAME_interpolation_error`.

        Raises:
            MissingExtraError: xarray is not installed.
        """
        try:
            import xarray
        except ModuleNotFoundError as error:
            raise MissingExtraError("to_xarray", "xarray", "xarray") from error
        axes = ("ratio", "interference")
        power = {name: self.interferences ** QUANTITIES[name].power for name in self.nodes}
        parts = {}
        for name, values in self.nodes.items():
            about = {"long_name": QUANTITIES[name].text, "units": "1"}
            parts[name] = (axes, values * power[name], about)
            parts[f"{name}_mesh_error"] = (axes, self.mesh_errors[name] * power[name], {"units": "1"})
            parts[f"{name}_interpolation_error"] = (axes, self.interpolation_errors[name] * power[name], {"units": "1"})
        return xarray.Dataset(
            parts, {"ratio": self.ratios, "interference": self.interferences}, {**vars(self.pair), "case": self.case}
        )

    def __repr__(self) -> str:
        return (
            f"<AsperityMap {self.interferences.size} interferences from {self.interferences[0]:g} to "
            f"{self.interferences[-1]:g} alpha_c, ratios {', '.join(f'{ratio:g}' for ratio in self.ratios)}>"
        )


def turned(quantity: str, tilt: FloatArray) -> FloatArray:
    """Factor on a quantity for a tilted line of centres; for "lateral" the factor on the normal force."""
    if quantity in ("normal", "peak_F_Z"):
        return np.asarray(np.cos(tilt))
    return np.asarray(np.sin(tilt)) if quantity == "lateral" else np.ones_like(tilt)


def _known(name: str) -> Quantity:
    if name not in QUANTITIES:
        raise InputError(f"quantity = {name!r}; allowed: {', '.join(QUANTITIES)}")
    return QUANTITIES[name]


def _shape_preserving(x: FloatArray, values: FloatArray) -> Any:
    """Interpolant that is monotone where the values are (Fritsch and Carlson 1980), so that it does not overshoot."""
    return PchipInterpolator(x, values)


def _ascending(name: str, values: Sequence[float], least: int) -> FloatArray:
    numbers = np.asarray(values, dtype=np.float64).reshape(-1)
    if numbers.size < least or not (numbers > 0).all() or not (np.diff(numbers) > 0).all():
        raise InputError(f"{name} = {list(values)}; allowed: {least} or more numbers > 0, ascending")
    return numbers
