# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Errors of what is not covered, with what to use instead."""


class PyHeliosToolsException(Exception):
    """A value that is not valid: the method, the value and the valid ones."""


class NotCoveredError(AttributeError):
    """Something of pyhelios that vtkhelios.compat does not have: its name, and what to use."""


# By the name in pyhelios, in the spelling of version 1; of several classes.
INSTEAD = {
    "setZipOutput": "text is not compressed; give setLasOutput(True) for LAZ",
    "setFullwaveNoise": "the noise of waveforms is detectorNoise_nW of the scanner (Docs/dialect.md)",
    "setLegacyEnergyModel": "there is one model, the lidar equation (Docs/compatibility.md)",
    "dynSceneStep": "set dynStep of <scene> in the file of the scene",
    "newTriangle": "make the scene with vtkhelios.Scene(points, triangles)",
    "newDetailedVoxel": "name a .vox file in the file of the scene (detailedvoxels)",
    "getGroundPointAt": "set onGround of the platform settings",
    "getIntersection": "use vtkhelios.vtkHeliosBvhRayCaster",
    "setCallbackFunction": "use setCallback",
    "scene": "use vtkhelios.Scene and vtkhelios.make_survey",
    "survey": "use vtkhelios.read_survey and vtkhelios.make_survey",
    "util": "use vtkhelios.Scene, vtkhelios.make_survey and vtkhelios new",
}
_DEFAULT = (
    "Docs/from-helios.md lists what is covered; vtkhelios.read_survey() has the whole library"
)


def not_covered(owner, name):
    """The error of a name that the owner does not have."""
    error = NotCoveredError(
        f"{owner}.{name} is not covered by vtkhelios.compat.pyhelios: {INSTEAD.get(name, _DEFAULT)}"
    )
    error.name = ""  # else Python suggests another name
    return error


class Closed:
    """An object with the attributes of its class only: any other raises NotCoveredError."""

    OWNER = None  # its name in pyhelios; None: the name of the class

    def _refuse(self, name):
        return not_covered(self.OWNER or type(self).__name__, name)

    def __getattr__(self, name):
        raise self._refuse(name)

    def __setattr__(self, name, value):
        if not name.startswith("_") and not isinstance(getattr(type(self), name, None), property):
            raise self._refuse(name)
        object.__setattr__(self, name, value)
