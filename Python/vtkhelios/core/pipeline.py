# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Errors and warnings of a pipeline as exceptions and Python warnings."""

import os
import re
import warnings

from vtkmodules.vtkCommonCore import vtkObject, vtkOutputWindow

from .. import _native

SECONDS_BETWEEN_SIGNS = 0.1

# "ERROR: In file, line n\nvtkClass (0x1234): the message"
_HEAD = re.compile(
    r"\s*(?:Generic )?(?:ERROR|Warning): In .*?, line \d+\s+(?:(\w+) \(\w+\): )?", re.I
)
_ADDRESS = re.compile(r" ?\(0x[0-9a-f]+\)")
# Added by an executive when a filter has already failed.
_EXECUTIVE = re.compile(
    r"returned failure for request|No update piece number has been set|Failure when calling method"
)
# Parts in which similar messages differ: "scanner vlp16, channel 3", "scene.xml:12: part oak_07".
_MEMBER = re.compile(r"\b(channel|part) (\"[^\"]*\"|[^\s,:;()]+)")
_LINE = re.compile(r"^([^\s:]+):\d+(?::\d+)?: ")
# The strategies of an algorithm report their own errors.
_STRATEGIES = ("RayCaster", "BeamDeflector", "BeamSampler", "EchoDetector")


class PipelineError(RuntimeError):
    """Failure of an algorithm. ``messages`` holds every error, ``str()`` joins them."""

    def __init__(self, messages):
        super().__init__("\n".join(messages))
        self.messages = list(messages)

    def __reduce__(self):
        return PipelineError, (self.messages,), self.__dict__


def clean_message(text):
    """Returns the message of a VTK error event, without source locations and addresses."""
    head = _HEAD.match(text)
    return _ADDRESS.sub("", text[head.end() :] if head else text).strip()


def is_executive_message(message):
    """Returns whether a message only repeats that a filter has failed."""
    return bool(_EXECUTIVE.search(message))


class SimilarMessages:
    """Messages that differ only by a channel or part, and its line, as one with their count."""

    def __init__(self, text):
        self._first = text
        self._texts = {text}
        self._key = self._make_key(text)

    @staticmethod
    def _make_key(text):
        """Returns the text without channels, parts and line; None if it names neither channel nor
        part."""
        without, count = _MEMBER.subn(r"\1", text)
        return _LINE.sub(r"\1: ", without) if count else None

    @property
    def can_grow(self):
        """Whether other texts can be similar, and not only the same."""
        return self._key is not None

    def __contains__(self, text):
        return text in self._texts

    def add(self, text):
        """Returns whether a text is one of these messages, which counts it."""
        is_similar = text in self._texts or (self._key and self._make_key(text) == self._key)
        if is_similar:
            self._texts.add(text)
        return bool(is_similar)

    def __str__(self):
        more = len(self._texts) - 1
        if not more:
            return self._first
        return f"{self._first} (and {more} more {_MEMBER.search(self._first)[1]}{'s'[: more != 1]})"

    @classmethod
    def merge(cls, texts):
        """Returns the texts, each once, those that are similar as one."""
        found = []
        for text in texts:
            if not any(each.add(text) for each in found):
                found.append(cls(text))
        return [str(each) for each in found]


def observe_messages(vtk_object, on_error, on_warning):
    """Calls functions with the clean text of every error and warning of an object, for any bytes.

    Returns the argument of remove_observers().
    """
    observers = []
    for event, say in (("ErrorEvent", on_error), ("WarningEvent", on_warning)):

        def report(text, say=say):
            say(clean_message(text) or f"{vtk_object.GetClassName()}: a message without text")

        observers.append((vtk_object, _native.observe(vtk_object, event, report)))
    return observers


def remove_observers(observers):
    """Removes those observers again."""
    for vtk_object, tag in observers:
        vtk_object.RemoveObserver(tag)
    observers.clear()


def report_error(algorithm, message):
    """Reports an error of an algorithm written in Python, as vtkErrorMacro does."""
    text = os.fsencode(message)  # file names in it may not be UTF-8
    if algorithm.HasObserver("ErrorEvent"):
        algorithm.InvokeEvent("ErrorEvent", text)
    else:
        vtkOutputWindow.GetInstance().DisplayErrorText(text)


class MessageLog:
    """Collects errors and warnings of the watched objects, as a context manager."""

    def __init__(self):
        self.errors = []
        self.warnings = []
        self._observers = []

    def watch(self, vtk_object):
        self._observers += observe_messages(vtk_object, self.errors.append, self.warnings.append)

    def watch_with_strategies(self, algorithm):
        self.watch(algorithm)
        self.watch(algorithm.GetExecutive())
        for strategy in _STRATEGIES:
            held = getattr(algorithm, f"Get{strategy}", lambda: None)()
            if isinstance(held, vtkObject):
                self.watch(held)

    def root_errors(self):
        """Returns the errors without repeats by an executive, each once, similar ones as one."""
        roots = [error for error in self.errors if not is_executive_message(error)]
        return SimilarMessages.merge(roots or self.errors)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        remove_observers(self._observers)


def upstream(algorithm):
    """Returns the algorithm and everything upstream of it, each once."""
    found, queue = [], [algorithm]
    while queue:
        current = queue.pop()
        if current is None or current in found:
            continue
        found.append(current)
        for port in range(current.GetNumberOfInputPorts()):
            for index in range(current.GetNumberOfInputConnections(port)):
                queue.append(current.GetInputAlgorithm(port, index))
    return found


def update(algorithm, port=0, progress=None):
    """Brings an algorithm up to date and returns the data of an output port.

    Raises PipelineError, with the message, if it or anything upstream reports an error; the
    warnings of the pipeline become Python's RuntimeWarning.

    Other Python threads continue meanwhile. Ctrl-C stops the pipeline at its next progress event
    and raises KeyboardInterrupt; exceptions of the function progress also stop it: it is called
    with an algorithm and its fraction of work done (0 to 1), about ten times a second.

    >>> echoes = vtkhelios.update(scanner)
    """
    with MessageLog() as log:
        members = upstream(algorithm)
        for member in members:
            log.watch_with_strategies(member)
        _, raised = _native.run(algorithm, port, members, progress, SECONDS_BETWEEN_SIGNS)
    conclude(log, raised)
    return algorithm.GetOutputDataObject(port)


def perform(vtk_object, action, failure=None, stacklevel=3, warn=None):
    """Calls a function, usually a method of the object, and returns what it returns.

    Raises PipelineError if the object reports an error meanwhile, and with the text of failure if the
    function returns False without one.
    """
    with MessageLog() as log:
        log.watch(vtk_object)
        result = action()
    conclude(log, stacklevel=stacklevel + 1, warn=warn)
    if failure and not result:
        raise PipelineError([failure])
    return result


def conclude(log, exceptions=(), stacklevel=3, warn=None):
    """Issues the logged warnings, by warnings.warn or another function, and raises errors."""
    for exception in exceptions:
        if not isinstance(exception, Exception):
            raise exception  # KeyboardInterrupt, SystemExit
    for message in SimilarMessages.merge(log.warnings):
        (warn or warnings.warn)(message, RuntimeWarning, stacklevel=stacklevel)
    if exceptions:
        told = [_as_text(exception) for exception in exceptions]
        roots = [error for error in log.root_errors() if not is_executive_message(error)]
        raise PipelineError(told + roots) from exceptions[0]
    if log.errors:
        raise PipelineError(log.root_errors())


def _as_text(exception):
    """Its class and its message; a KeyError's would have quotes around it."""
    message = exception.args[0] if isinstance(exception, KeyError) else exception
    return f"{type(exception).__name__}: {message}"
