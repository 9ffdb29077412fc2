# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Functions on data as filters in a pipeline."""

import functools
import inspect

import numpy as np
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonDataModel import vtkDataObject

from ..core.compose import METHODS, compose
from ..core.views import data_of
from ..core.words import no_attribute
from .cloud import Cloud

__all__ = ["FunctionAlgorithm", "filter"]


def filter(function=None, *, output="vtkPolyData"):  # named for use as a decorator
    """Makes a filter from a function on data.

    >>> @vtkhelios.filter
    ... def within(cloud, distance=50.0):
    ...     return cloud["Range"] < distance
    ...
    >>> near = (scanner >> within(distance=20))()

    Each parameter without a default is an input (without any it is a source), the others are
    properties of the filter: keywords and attributes. Inputs are Clouds if they are vtkPolyData,
    else data objects. The function returns the output of the filter: a Cloud or a data object of
    the type output; a boolean array, one value per point, of the points to keep; or None, to output
    its first input, a shallow copy, with what was added to it. Exceptions become a PipelineError.

    ``within`` itself can be used with ``>>``, with its defaults; ``within.function`` is the
    function.
    """
    if function is None:
        return functools.partial(filter, output=output)
    return _FilterFunction(function, output)


class _FilterFunction:
    """Makes algorithms that call a function."""

    def __init__(self, function, output):
        functools.update_wrapper(self, function)
        self.function, self._output = function, output
        parameters = inspect.signature(function).parameters.values()
        self.inputs = [item.name for item in parameters if item.default is item.empty]
        self.defaults = {
            item.name: item.default for item in parameters if item.default is not item.empty
        }

    def __call__(self, **properties):
        return FunctionAlgorithm(self, properties)

    def make_algorithm(self):
        return FunctionAlgorithm(self, {})

    def __rshift__(self, right):
        return compose(self, right)

    def __rrshift__(self, left):
        return compose(left, self)


class FunctionAlgorithm(VTKPythonAlgorithmBase):
    """A filter that calls a function; see filter()."""

    def __init__(self, maker, properties):
        self._maker, self._values = maker, dict(maker.defaults)
        super().__init__(
            nInputPorts=len(maker.inputs),
            inputType="vtkDataObject",
            nOutputPorts=1,
            outputType=maker._output,
        )
        for name, value in properties.items():
            setattr(self, name, value)

    def RequestData(self, _request, inputs, outputs):
        given = [_input_view(vector.GetInformationObject(0)) for vector in inputs]
        result = self._maker.function(*given, **self._values)
        target = outputs.GetInformationObject(0).Get(vtkDataObject.DATA_OBJECT())
        target.ShallowCopy(self._as_data(result, given, target))
        return 1

    def _as_data(self, result, given, target):
        name = self._maker.function.__name__
        if result is None and given:
            result = given[0]
        if isinstance(result, np.ndarray):
            if not (given and isinstance(given[0], Cloud)):
                raise TypeError(f"{name}() returns an array, but its first input is not a cloud")
            result = given[0].filter(result)
        result = data_of(result)
        if not isinstance(result, vtkDataObject) or not result.IsA(target.GetClassName()):
            raise TypeError(
                f"{name}() returns {type(result).__name__}; return a Cloud, a "
                f"{target.GetClassName()}, an array of true and false, or None"
            )
        return result

    def __getattr__(self, name):
        values = self.__dict__.get("_values", {})
        if name in values:
            return values[name]
        raise AttributeError(f"{type(self).__name__} has no attribute {name}")

    def __setattr__(self, name, value):
        if name[0] == "_" or name[0].isupper():  # ours, VTK's
            super().__setattr__(name, value)
        elif name in self._values:
            self._values[name] = value
            self.Modified()
        else:
            has = ", ".join(self._values) or "none"
            raise no_attribute(
                self,
                name,
                f"{self._maker.function.__name__}() has no property {name}; it has: {has}",
            )

    def __rshift__(self, right):
        return compose(self, right)

    def __rrshift__(self, left):
        return compose(left, self)

    __call__ = METHODS["__call__"]
    update = METHODS["update"]
    output = METHODS["output"]

    def __repr__(self):
        told = ", ".join(f"{name}={value!r}" for name, value in self._values.items())
        return f"{self._maker.function.__name__}({told})"


def _input_view(info):
    """Returns a shallow copy of an input: a Cloud of vtkPolyData, else the data object."""
    data = info.Get(vtkDataObject.DATA_OBJECT())
    copy = data.NewInstance()
    copy.ShallowCopy(data)
    return Cloud(copy) if copy.IsA("vtkPolyData") else copy
