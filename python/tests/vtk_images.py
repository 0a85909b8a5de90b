# SPDX-License-Identifier: BSD-3-Clause
"""What VTK's own readers find in our files: the same readers as in ParaView."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

vtk = pytest.importorskip("vtk")
from vtk.util.numpy_support import vtk_to_numpy  # noqa: E402


@dataclass
class Image:
    """One vtkImageData; arrays [z][y][x] and, of a tensor, [component] behind."""

    dimensions: tuple[int, int, int]
    """Points along x, y, z."""
    origin: tuple[float, float, float]
    spacing: tuple[float, float, float]
    up: float
    """Where layers that follow each other lead: 1 up, -1 down; the other axes are never turned."""
    cell_data: dict[str, np.ndarray]
    point_data: dict[str, np.ndarray]


def image_of(data: "vtk.vtkImageData") -> Image:
    points = data.GetDimensions()
    cells = tuple(max(n - 1, 0) for n in points)

    def arrays(of: "vtk.vtkDataSetAttributes", shape: tuple[int, ...]) -> dict[str, np.ndarray]:
        found = {}
        for i in range(of.GetNumberOfArrays()):
            values = vtk_to_numpy(of.GetArray(i))
            found[of.GetArrayName(i)] = values.reshape(*shape[::-1], *values.shape[1:]).copy()
        return found

    direction = [data.GetDirectionMatrix().GetElement(i, j) for i in range(3) for j in range(3)]
    assert direction[:8] == [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]
    return Image(
        points,
        data.GetOrigin(),
        data.GetSpacing(),
        direction[8],
        arrays(data.GetCellData(), cells),
        arrays(data.GetPointData(), points),
    )


class VtkhdfFile:
    """A file opened by vtkHDFReader. Messages of VTK are errors."""

    def __init__(self, path: Path):
        self._complaints: list[str] = []
        self._reader = vtk.vtkHDFReader()
        for kind in ("ErrorEvent", "WarningEvent"):
            self._reader.AddObserver(kind, lambda _, event: self._complaints.append(event))
        assert self._reader.CanReadFile(str(path))
        self._reader.SetFileName(str(path))
        self._reader.UpdateInformation()
        information = self._reader.GetOutputInformation(0)
        self.times = information.Get(vtk.vtkStreamingDemandDrivenPipeline.TIME_STEPS())
        """None if there is only one state."""

    def blocks(self, time: float = 0.0) -> dict[str, Image]:
        return {name: image_of(data) for name, data in self.datasets(time).items()}

    def datasets(self, time: float = 0.0) -> "dict[str, vtk.vtkImageData]":
        """By the names that the assembly gives them: older readers know no others."""
        self._reader.UpdateTimeStep(time)
        output = self._reader.GetOutput()
        assert not self._complaints
        assembly = output.GetDataAssembly()
        found = {}
        for node in assembly.GetChildNodes(assembly.GetRootNode(), True):
            for index in assembly.GetDataSetIndices(node, False):
                found[assembly.GetNodeName(node)] = output.GetPartition(index, 0)
        return found


def vti_image(path: Path) -> Image:
    reader = vtk.vtkXMLImageDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    assert reader.GetErrorCode() == 0
    return image_of(reader.GetOutput())
