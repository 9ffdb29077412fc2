// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLazRecords.h"

#include "heliosLasFile.h"
#include "heliosLazCodec.h"

#include <algorithm>
#include <new>
#include <string>
#include <vector>

namespace
{

/// Reads points that fill a buffer.
std::string ReadRecords(const char* path, std::uint64_t first, const Py_buffer& buffer)
{
  try
  {
    helios::LasFile file;
    helios::Status status = file.Open(path);
    const auto length = static_cast<std::uint64_t>(file.GetHeader().PointLength);
    const auto end = first + static_cast<std::uint64_t>(buffer.len) / length;
    if (status.IsOk() && end > file.GetHeader().Points.Count)
    {
      return std::string(path) + ": ends before its points " + std::to_string(end);
    }
    const std::uint64_t round = file.GetPointsPerRound();
    for (std::uint64_t next = first; next < end && status.IsOk(); next += round)
    {
      auto* bytes = static_cast<char*>(buffer.buf) + (next - first) * length;
      status = file.Read(next, std::min(round, end - next), bytes);
    }
    return status.Message();
  }
  catch (const std::bad_alloc&)
  {
    return std::string(path) + ": not enough memory for its points; free some, or split it";
  }
}

/// Checks the point format and length of points that are compressed.
bool CheckForm(int format, int length)
{
  const bool isKnown = helios::GetLasPointForm(format).IsKnown() &&
    length >= helios::GetLasPointForm(format).Length && length < 65536;
  if (!isKnown)
  {
    PyErr_Format(PyExc_ValueError, "points of format %d have no %d bytes", format, length);
  }
  return isKnown;
}

PyObject* ToBytes(const std::string& text)
{
  return PyBytes_FromStringAndSize(text.data(), static_cast<Py_ssize_t>(text.size()));
}

} // namespace

//------------------------------------------------------------------------------
PyObject* heliosReadLasRecords(PyObject*, PyObject* args)
{
  const char* path = nullptr;
  unsigned long long first = 0;
  Py_buffer buffer;
  if (!PyArg_ParseTuple(args, "yKw*:read_las_records", &path, &first, &buffer))
  {
    return nullptr;
  }
  std::string problem;
  Py_BEGIN_ALLOW_THREADS;
  problem = ReadRecords(path, first, buffer);
  Py_END_ALLOW_THREADS;
  PyBuffer_Release(&buffer);
  return PyUnicode_DecodeFSDefaultAndSize(problem.data(), static_cast<Py_ssize_t>(problem.size()));
}

//------------------------------------------------------------------------------
PyObject* heliosLazRecord(PyObject*, PyObject* args)
{
  int format = 0;
  int length = 0;
  return PyArg_ParseTuple(args, "ii:laz_record", &format, &length) && CheckForm(format, length)
    ? ToBytes(helios::LazForm::Make(format, length).Encode().Data)
    : nullptr;
}

//------------------------------------------------------------------------------
PyObject* heliosEncodeLaz(PyObject*, PyObject* args)
{
  int format = 0;
  int length = 0;
  Py_buffer buffer;
  if (!PyArg_ParseTuple(args, "iiy*:encode_laz", &format, &length, &buffer))
  {
    return nullptr;
  }
  if (!CheckForm(format, length))
  {
    PyBuffer_Release(&buffer);
    return nullptr;
  }
  std::vector<helios::LazBytes> chunks;
  helios::Status status;
  Py_BEGIN_ALLOW_THREADS;
  const auto count = static_cast<std::uint64_t>(buffer.len / length);
  status = helios::EncodeLazChunks(
    helios::LazForm::Make(format, length), static_cast<const char*>(buffer.buf), count, chunks);
  Py_END_ALLOW_THREADS;
  PyBuffer_Release(&buffer);
  if (!status.IsOk())
  {
    PyErr_SetString(PyExc_ValueError, status.Message().c_str());
    return nullptr;
  }
  PyObject* list = PyList_New(0);
  for (const helios::LazBytes& chunk : chunks)
  {
    PyObject* pair =
      Py_BuildValue("(KN)", static_cast<unsigned long long>(chunk.Points), ToBytes(chunk.Bytes));
    const bool isAdded = pair && PyList_Append(list, pair) == 0;
    Py_XDECREF(pair);
    if (!isAdded)
    {
      Py_DECREF(list);
      return nullptr;
    }
  }
  return list;
}

//------------------------------------------------------------------------------
PyObject* heliosEncodeLazTable(PyObject*, PyObject* args)
{
  PyObject* list = nullptr;
  if (!PyArg_ParseTuple(args, "O!:encode_laz_table", &PyList_Type, &list))
  {
    return nullptr;
  }
  std::vector<helios::LazChunk> chunks;
  for (Py_ssize_t i = 0; i < PyList_Size(list); ++i)
  {
    unsigned long long points = 0;
    unsigned long long bytes = 0;
    if (!PyArg_ParseTuple(PyList_GetItem(list, i), "KK", &points, &bytes))
    {
      return nullptr;
    }
    chunks.push_back({ points, bytes });
  }
  return ToBytes(helios::EncodeLazTable(chunks));
}
