# SPDX-License-Identifier: BSD-3-Clause
# Written by tools/render_python.py from the engine's schema; do not edit.
"""Entries of the lists in a summary: indents, passes, cycles and strokes."""

from __future__ import annotations

import math
from dataclasses import dataclass

__all__ = ["FrettingCycle", "Indent", "RollingPass", "SlidingStroke"]


@dataclass(frozen=True)
class Indent:
    """Results of one loading and unloading at one place, at the largest load and where the contact opens.

    Attributes:
        place: Number of the place in the case, from 1.
        cycle: Number of the loading cycle at this place, from 1.
        x: Coordinate of the indenter's apex on the lower body [m].
        max_load: Largest load [N].
        max_approach: Approach at the largest load, from first touch of the undeformed smooth shapes [m].
        contact_area: Projected contact area at the largest load [m^2].
        hardness: Largest load over the projected contact area [Pa].
        loading_stiffness: Slope of load over approach during loading, at the largest load [N/m]; NaN if no step before
            it has a load.
        unloading_stiffness: Slope of load over approach at the beginning of unloading [N/m]; NaN if no step after it
            has a load.
        final_approach: Approach at which the contact opens [m]; NaN if it does not open.
        residual_depth: Largest residual displacement of the lower body after unloading, positive into the body [m].
        pile_up: Largest height of the lower body's residual surface after unloading, positive outwards [m].
        work: Net work of the drive in this indent [J].
        contact_fraction: Contact area over the area of the period at the largest load [-]; NaN unless both axes are
            periodic.
        mean_gap: Mean gap over the period at the largest load [m]; NaN unless both axes are periodic.
        contact_stiffness: Elastic stiffness at the largest load, change of nominal pressure over change of mean gap
            [Pa/m]; NaN unless both axes are periodic.
    """

    place: int
    cycle: int
    x: float
    max_load: float
    max_approach: float
    contact_area: float
    hardness: float
    loading_stiffness: float
    unloading_stiffness: float
    final_approach: float
    residual_depth: float
    pile_up: float
    work: float
    contact_fraction: float = math.nan
    mean_gap: float = math.nan
    contact_stiffness: float = math.nan


@dataclass(frozen=True)
class RollingPass:
    """Results of one pass, under and around the middle of the track.

    Attributes:
        pass_: Number of the pass, from 1.
        rut_depth: Residual displacement of the lower body at x = y = 0, positive into the body [m].
        shoulder_height: Largest height of the lower body's residual surface in the section x = 0, positive outwards
            [m].
        max_equivalent_plastic_strain: Largest equivalent plastic strain of both bodies [-].
        track_plastic_strain: Largest equivalent plastic strain of the lower body under x = y = 0 [-].
        track_plastic_increment: Largest increment of the equivalent plastic strain under x = y = 0 in this pass [-].
        dissipation: Plastic work in both bodies in this pass [J].
        resistance: Energy dissipated and locked in by both bodies per length, over the middle half of the track [N].
        max_pressure: Largest pressure, averaged over the middle half of the track [Pa].
        unsteadiness: Difference of the resistance between the two quarters of the middle half, over the larger of them
            [-]; up to 0.1 the resistance counts as steady.
        mean_F_X: Mean F_X over the middle half of the track, positive if it resists the motion [N].
        friction: Mean F_X over mean F_n in the middle half of the track [-].
        contact_area: Contact area, averaged over the middle half of the track [m^2].
        F_x: Force of the shear on the lower body along x, averaged over the last quarter of the track [N].
        F_y: Force of the shear on the lower body along y, averaged over the last quarter of the track [N].
        M_z: Moment of the shear about the contact normal, positive from x to y, averaged over the last quarter [N m].
        stick_share: Fraction of the contact area that sticks, averaged over the last quarter of the track [-]; 0
            without creepage.
        creep_unsteadiness: Difference of the force between both halves of the last quarter, over the larger of them
            [-]; up to 0.01 the force counts as steady.
        steady: Whether the resistance is steady, so that it does not depend on the length of the track.
        creep_steady: Whether the forces of the shear are steady, so that they are those of steady rolling.
    """

    pass_: int
    rut_depth: float
    shoulder_height: float
    max_equivalent_plastic_strain: float
    track_plastic_strain: float
    track_plastic_increment: float
    dissipation: float
    resistance: float
    max_pressure: float
    unsteadiness: float = math.nan
    mean_F_X: float = math.nan
    friction: float = math.nan
    contact_area: float = math.nan
    F_x: float = math.nan
    F_y: float = math.nan
    M_z: float = math.nan
    stick_share: float = math.nan
    creep_unsteadiness: float = math.nan
    steady: bool = False
    creep_steady: bool = False


@dataclass(frozen=True)
class FrettingCycle:
    """Results of one cycle, from the middle through both turning points back to the middle.

    Attributes:
        cycle: Number of the cycle, from 1.
        work: Work of the tangential force, the area of the hysteresis loop [J].
        dissipation_friction: Energy dissipated by friction in this cycle [J].
        dissipation_plastic: Plastic work in both bodies in this cycle [J].
        max_force: Largest magnitude of the tangential force [N].
        max_displacement: Largest magnitude of the displacement [m].
        slip_amplitude: A quarter of the largest local slip path of this cycle [m].
        stick_share: Smallest fraction of the contact area that sticks [-].
        max_equivalent_plastic_strain: Largest equivalent plastic strain of both bodies at the end of the cycle [-].
    """

    cycle: int
    work: float
    dissipation_friction: float
    dissipation_plastic: float
    max_force: float
    max_displacement: float
    slip_amplitude: float
    stick_share: float
    max_equivalent_plastic_strain: float


@dataclass(frozen=True)
class SlidingStroke:
    """Averages over one stroke, and the state of the surfaces at its end.

    Attributes:
        stroke: Number of the stroke, from 1.
        friction: Mean F_X over mean F_n [-].
        friction_ploughing: Part of the friction from pressure on the slopes of both surfaces (ploughing) [-].
        friction_interfacial: Part of the friction from the shear between the surfaces [-].
        mean_F_X: Mean F_X [N].
        contact_area: Mean contact area [m^2].
        max_pressure: Mean over the stroke of the largest pressure [Pa].
        dissipation_plastic: Plastic work in both bodies in this stroke, without pressing and parting [J].
        dissipation_friction: Energy dissipated by friction in this stroke, without pressing and parting [J].
        max_equivalent_plastic_strain: Largest equivalent plastic strain of both bodies at the end of the stroke [-].
        rms_height_lower: Sq of the lower surface (texture and residual displacement, over its grid) at the end of the
            stroke [m].
        rms_height_upper: Sq of the upper surface at the end of the stroke [m].
        mean_height_lower: Sa of the lower surface at the end of the stroke [m].
        mean_height_upper: Sa of the upper surface at the end of the stroke [m].
        contact_fraction: Mean contact area over the area of the period [-]; NaN unless both axes are periodic.
        mean_gap: Gap averaged over the period and the stroke [m]; NaN unless both axes are periodic.
        patches: Mean number of contact patches [-].
        largest_patch: Mean area of the largest patch [m^2].
        core_height_lower: Sk of the lower surface, the core height of the bearing-area curve, at the end of the stroke
            [m].
        core_height_upper: Sk of the upper surface at the end of the stroke [m].
        peak_height_lower: Spk of the lower surface, the reduced peak height, at the end of the stroke [m].
        peak_height_upper: Spk of the upper surface at the end of the stroke [m].
        valley_depth_lower: Svk of the lower surface, the reduced valley depth, at the end of the stroke [m].
        valley_depth_upper: Svk of the upper surface at the end of the stroke [m].
    """

    stroke: int
    friction: float
    friction_ploughing: float
    friction_interfacial: float
    mean_F_X: float
    contact_area: float
    max_pressure: float
    dissipation_plastic: float
    dissipation_friction: float
    max_equivalent_plastic_strain: float
    rms_height_lower: float
    rms_height_upper: float
    mean_height_lower: float
    mean_height_upper: float
    contact_fraction: float = math.nan
    mean_gap: float = math.nan
    patches: float = math.nan
    largest_patch: float = math.nan
    core_height_lower: float = math.nan
    core_height_upper: float = math.nan
    peak_height_lower: float = math.nan
    peak_height_upper: float = math.nan
    valley_depth_lower: float = math.nan
    valley_depth_upper: float = math.nan
