# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pipelines with >>, as in VTK 9.4 and newer.

>>> pipeline = scene >> vtkhelios.vtkHeliosSceneTransform(scale=2) >> writer
>>> cloud = ((scene, trajectory) >> scanner)()
"""

import html

from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkAlgorithmOutput

from .pipeline import update, upstream
from .views import data_of

__all__ = ["Pipeline", "select_ports"]


class Pipeline:
    """Connected algorithms, from ``first`` to ``last``.

    ``pipeline()`` updates it and returns the data of the last one (a tuple if several outputs have
    data), unaffected by later updates; ``pipeline(data)`` first sets the input of the first one.
    ``pipeline.update().output`` is the output itself, which later updates change.
    """

    def __init__(self, first, last, port=None):
        self.first, self.last, self.port = first, last, port

    def __rshift__(self, right):
        return compose(self, right)

    def __rrshift__(self, left):
        return compose(left, self)

    def __call__(self, data=None):
        if data is not None:
            connect(data, self.first)
        return _kept(self.update().output)

    def update(self):
        """Updates the last algorithm; raises PipelineError. Returns the pipeline."""
        update(self.last, self.port or 0)
        return self

    @property
    def output(self):
        """The data of the last algorithm, not updated."""
        if self.port is not None:
            return self.last.GetOutputDataObject(self.port)
        return _output(self.last)

    def __repr__(self):
        names = [member.GetClassName() for member in reversed(upstream(self.last))]
        return f"Pipeline({' >> '.join(names)})"

    def _repr_html_(self):
        """The algorithms in the order of the data, each with the properties that are set."""
        members = [html.escape(_describe(each)) for each in reversed(upstream(self.last))]
        return f"<b>Pipeline</b><ol>{''.join(f'<li>{each}</li>' for each in members)}</ol>"


class _Ports:
    """An algorithm with selected ports; see select_ports()."""

    def __init__(self, algorithm, input_port, output_port):
        self.algorithm, self.input_port, self.output_port = algorithm, input_port, output_port

    def __rshift__(self, right):
        return compose(self, right)

    def __rrshift__(self, left):
        return compose(left, self)


def _describe(algorithm):
    """Returns the line of an algorithm; of VTK's own, whose text is long, the name of its class."""
    text = repr(algorithm)
    return algorithm.GetClassName() if "\n" in text or text.startswith("<") else text


def select_ports(*arguments):
    """Returns an algorithm with ports other than 0, for use with >>.

    select_ports(algorithm, output), select_ports(input, algorithm), or select_ports(input,
    algorithm, output):

    >>> vtkhelios.select_ports(scanner, 1) >> vtkhelios.vtkHeliosEchoDetection()
    >>> trajectory >> vtkhelios.select_ports(1, scanner)
    """
    found = [index for index, item in enumerate(arguments) if isinstance(item, vtkAlgorithm)]
    ports = [item for item in arguments if isinstance(item, int)]
    if len(found) != 1 or len(arguments) not in (2, 3) or len(ports) != len(arguments) - 1:
        raise TypeError("select_ports() takes (algorithm, port), (port, algorithm) or all three")
    algorithm, at = arguments[found[0]], found[0]
    input_port = arguments[0] if at == 1 else 0
    output_port = arguments[-1] if at < len(arguments) - 1 else None
    _check_port(algorithm, "input", input_port, algorithm.GetNumberOfInputPorts())
    _check_port(algorithm, "output", output_port or 0, algorithm.GetNumberOfOutputPorts())
    return _Ports(algorithm, input_port, output_port)


def _check_port(algorithm, kind, port, count):
    if port and not 0 <= port < count:
        last = f"the last one is {count - 1}" if count else "it has none"
        raise ValueError(f"{algorithm.GetClassName()} has no {kind} port {port}; {last}")


def compose(left, right):
    """``left >> right``: connects them and returns the Pipeline, or NotImplemented."""
    left, right = (
        side.make_algorithm() if hasattr(side, "make_algorithm") else side for side in (left, right)
    )  # functions that are filters
    if isinstance(right, Pipeline):
        target, port, last, output = right.first, 0, right.last, right.port
    elif isinstance(right, _Ports):
        target, port, last, output = right.algorithm, right.input_port, None, right.output_port
    elif isinstance(right, vtkAlgorithm):
        target, port, last, output = right, 0, None, None
    else:
        return NotImplemented
    if not _is_source(left):
        return NotImplemented
    connect(left, target, port)
    return Pipeline(_first(left) or target, last or target, output)


def connect(source, algorithm, port=0):
    """Sets the input of an algorithm: a source, or a tuple of them for its ports from port on.

    A repeatable port, or the only one, gets the whole tuple.
    """
    sources = source if isinstance(source, (tuple, list)) else (source,)
    count = algorithm.GetNumberOfInputPorts()
    takes_many = len(sources) > 1 and (count == 1 or _is_repeatable(algorithm, port))
    if port + (1 if takes_many else len(sources)) > count:
        raise TypeError(
            f"{algorithm.GetClassName()} takes {count} inputs, not {port + len(sources)}"
            if count
            else f"{algorithm.GetClassName()} takes no input"
        )
    if takes_many:
        algorithm.RemoveAllInputConnections(port)
    for index, item in enumerate(sources):
        _connect_one(item, algorithm, port if takes_many else port + index, takes_many)


def _is_repeatable(algorithm, port):
    information = (
        algorithm.GetInputPortInformation(port) if algorithm.GetNumberOfInputPorts() else None
    )
    return bool(information and information.Get(vtkAlgorithm.INPUT_IS_REPEATABLE()))


def _connect_one(source, algorithm, port, add):
    if source is None:
        return
    output = _output_port(source)
    if output is None:
        data = data_of(source)
        (algorithm.AddInputDataObject if add else algorithm.SetInputDataObject)(port, data)
    else:
        (algorithm.AddInputConnection if add else algorithm.SetInputConnection)(port, output)


def _output_port(source):
    """Returns the connection of a source, None for data."""
    if isinstance(source, vtkAlgorithmOutput):
        return source
    if isinstance(source, Pipeline):
        return source.last.GetOutputPort(source.port or 0)
    if isinstance(source, _Ports):
        return source.algorithm.GetOutputPort(source.output_port or 0)
    if hasattr(source, "make_algorithm"):
        return source.make_algorithm().GetOutputPort()
    return source.GetOutputPort() if isinstance(source, vtkAlgorithm) else None


def _is_source(item):
    if isinstance(item, (tuple, list)):
        return all(part is None or _is_source(part) for part in item)
    kinds = (vtkAlgorithm, vtkAlgorithmOutput, vtkDataObject, Pipeline, _Ports)
    return isinstance(data_of(item), kinds) or hasattr(item, "make_algorithm")


def _first(source):
    """First algorithm of a pipeline with this source; None for data and tuples."""
    if isinstance(source, Pipeline):
        return source.first
    if isinstance(source, _Ports):
        return source.algorithm
    return source if isinstance(source, vtkAlgorithm) else None


def _output(algorithm):
    """The data of the ports that have any: a single object, or a tuple."""
    outputs = [algorithm.GetOutputDataObject(i) for i in range(algorithm.GetNumberOfOutputPorts())]
    outputs = outputs[:1] + [output for output in outputs[1:] if output and not _is_empty(output)]
    return outputs[0] if len(outputs) == 1 else tuple(outputs)


def _is_empty(data):
    rows = getattr(data, "GetNumberOfRows", getattr(data, "GetNumberOfPoints", lambda: 1))
    return rows() == 0


def _update(algorithm):
    """Updates the algorithm; raises PipelineError. Returns the algorithm."""
    update(algorithm)
    return algorithm


def _call(algorithm, data=None):
    """Returns the updated output; with data as the input, if set."""
    if data is not None:
        connect(data, algorithm)
    return _kept(_output(_update(algorithm)))


def _kept(output):
    """Returns the current data: shallow copies, which share all arrays."""
    if isinstance(output, tuple):
        return tuple(map(_kept, output))
    copy = output.NewInstance()
    copy.ShallowCopy(output)
    return copy


# Added to algorithms; newer versions of VTK have it.
METHODS = {
    "update": _update,
    "__call__": _call,
    "output": property(_output, doc="The data of the outputs that have any, as it is."),
}
