// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The Python module vtkhelios._native: functions that Python cannot provide.

#include "heliosInput.h"
#include "heliosLazRecords.h"
#include "heliosLegTrajectory.h"
#include "heliosObserve.h"
#include "heliosPythonDetector.h"
#include "heliosRun.h"
#include "heliosSignals.h"
#include "heliosTypes.h"

namespace
{

PyMethodDef Methods[] = {
  { "run", heliosRun, METH_VARARGS, "run(target, argument, watched, on_progress, interval)" },
  { "observe", heliosObserve, METH_VARARGS, "observe(object, event, callback): returns the tag" },
  { "guard", heliosGuard, METH_NOARGS, "guard(): Python filters take the interpreter lock" },
  { "trajectory", heliosGetTrajectory, METH_VARARGS, "trajectory(source, leg, interval)" },
  { "end_after", heliosEndAfter, METH_VARARGS, "end_after(signals, seconds)" },
  { "set_end_line", heliosSetEndLine, METH_VARARGS, "set_end_line(text)" },
  { "claim_end_line", heliosClaimEndLine, METH_NOARGS,
    "claim_end_line(): whether it is the first" },
  { "remove_at_end", heliosRemoveAtEnd, METH_VARARGS, "remove_at_end(path, is_unfinished)" },
  { "set_hooks", heliosSetHooks, METH_VARARGS, "set_hooks(configure, refuse, compose, describe)" },
  { "check_input_file", heliosCheckInputFile, METH_VARARGS, "check_input_file(path): a text" },
  { "read_las_records", heliosReadLasRecords, METH_VARARGS,
    "read_las_records(path, first, buffer): a text" },
  { "laz_record", heliosLazRecord, METH_VARARGS, "laz_record(format, length): bytes" },
  { "encode_laz", heliosEncodeLaz, METH_VARARGS, "encode_laz(format, length, points): chunks" },
  { "encode_laz_table", heliosEncodeLazTable, METH_VARARGS, "encode_laz_table(chunks): bytes" },
  { "add_detector", heliosAddDetector, METH_VARARGS,
    "add_detector(name, detect): whether it is new" },
  { "extend", heliosExtend, METH_VARARGS, "extend(cls, attributes, is_algorithm)" },
  { nullptr, nullptr, 0, nullptr },
};

PyModuleDef Module = { PyModuleDef_HEAD_INIT, "_native",
  "Wrapped classes extended, and run without the interpreter lock.", -1, Methods, nullptr, nullptr,
  nullptr, nullptr };

} // namespace

//------------------------------------------------------------------------------
PyMODINIT_FUNC PyInit__native()
{
  return PyModule_Create(&Module);
}
