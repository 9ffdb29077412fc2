// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPythonDetector.h"

#include "vtkHeliosEchoDetection.h"
#include "vtkHeliosEchoDetector.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace
{

using Waveforms = std::vector<vtkHeliosWaveform>;

constexpr vtkIdType ManySamples = 1 << 22; // samples of a block, with its padding

/// The function, which outlives the detectors of a registry that ends after Python.
struct Function
{
  PyObject* Call;

  explicit Function(PyObject* call)
    : Call(call)
  {
    Py_INCREF(call);
  }
  ~Function()
  {
    if (Py_IsInitialized())
    {
      const vtkPythonScopeGilEnsurer lock(true);
      Py_DECREF(this->Call);
    }
  }
  Function(const Function&) = delete;
  void operator=(const Function&) = delete;
};

/// Releases the interpreter lock of a thread that waits for others, which acquire it.
struct Unlocked
{
  PyThreadState* State = PyEval_SaveThread();

  ~Unlocked() { PyEval_RestoreThread(this->State); }
};

/// Returns bytes of values, which a function sets.
template <typename ValueT, typename SetT>
PyObject* MakeBytes(std::size_t count, SetT set)
{
  PyObject* bytes =
    PyBytes_FromStringAndSize(nullptr, static_cast<Py_ssize_t>(count * sizeof(ValueT)));
  if (bytes)
  {
    set(reinterpret_cast<ValueT*>(PyBytes_AS_STRING(bytes)));
  }
  return bytes;
}

/// A detector that calls a function in Python.
class PythonDetector : public vtkHeliosEchoDetector
{
public:
  vtkAbstractTypeMacro(PythonDetector, vtkHeliosEchoDetector);

  static PythonDetector* New(std::shared_ptr<Function> function)
  {
    auto* made = new PythonDetector;
    made->Detector = std::move(function);
    made->InitializeObjectBase();
    return made;
  }

  bool PrefersBlocks() const override { return true; }

  void Detect(const vtkHeliosWaveform& waveform, Echoes& echoes) const override
  {
    std::vector<Echoes> found(1);
    if (std::string error; this->DetectAll({ waveform }, found, error))
    {
      echoes.insert(echoes.end(), found[0].begin(), found[0].end());
    }
  }

  bool DetectAll(
    const Waveforms& waveforms, std::vector<Echoes>& echoes, std::string& error) const override
  {
    const vtkPythonScopeGilEnsurer lock(true);
    for (std::size_t first = 0, last = 0; first < waveforms.size(); first = last)
    {
      last = FindEnd(waveforms, first);
      if (!this->DetectBlock(waveforms, first, last, echoes, error))
      {
        return false;
      }
    }
    return true;
  }

  std::shared_ptr<void> PrepareThreads() const override
  {
    return PyGILState_Check() ? std::make_shared<Unlocked>() : nullptr;
  }

protected:
  PythonDetector() = default;

  vtkObjectBase* NewInstanceInternal() const override { return New(this->Detector); }

private:
  /// Returns the end of waveforms from one on that are alike, and not too many for a block.
  static std::size_t FindEnd(const Waveforms& waveforms, std::size_t first)
  {
    const vtkHeliosWaveform& like = waveforms[first];
    vtkIdType longest = 0;
    std::size_t last = first;
    for (; last < waveforms.size(); ++last)
    {
      const vtkHeliosWaveform& wave = waveforms[last];
      longest = std::max(longest, wave.Count);
      const bool isAlike = wave.BinSize == like.BinSize && wave.PulseLength == like.PulseLength &&
        wave.Seed == like.Seed;
      const auto rows = static_cast<vtkIdType>(last - first + 1);
      if (!isAlike || (rows > 1 && rows * longest > ManySamples))
      {
        break;
      }
    }
    return last;
  }

  bool DetectBlock(const Waveforms& waveforms, std::size_t first, std::size_t last,
    std::vector<Echoes>& echoes, std::string& error) const
  {
    PyObject* result = this->Call(&waveforms[first], last - first);
    const bool isRead = result && Read(result, last - first, &echoes[first]);
    error = isRead ? error : GetError(result);
    Py_XDECREF(result);
    for (std::size_t i = first; i < last && isRead; ++i)
    {
      this->RemoveDead(echoes[i], 0);
    }
    return isRead;
  }

  PyObject* Call(const vtkHeliosWaveform* waves, std::size_t count) const
  {
    const auto isShorter = [](const vtkHeliosWaveform& a, const vtkHeliosWaveform& b)
    { return a.Count < b.Count; };
    const auto width =
      static_cast<std::size_t>(std::max_element(waves, waves + count, isShorter)->Count);
    PyObject* samples = MakeBytes<float>(count * width,
      [waves, count, width](float* row)
      {
        std::fill_n(row, count * width, 0.0f);
        for (std::size_t i = 0; i < count; ++i, row += width)
        {
          std::copy_n(waves[i].Samples, waves[i].Count, row);
        }
      });
    PyObject* counts = MakeBytes<long long>(count,
      [waves, count](long long* values)
      { std::transform(waves, waves + count, values, [](const auto& w) { return w.Count; }); });
    PyObject* ids = MakeBytes<long long>(count,
      [waves, count](long long* values)
      {
        std::transform(waves, waves + count, values,
          [](const auto& w) { return static_cast<long long>(w.PulseId); });
      });
    const bool isMade = samples && counts && ids;
    PyObject* result = isMade ? PyObject_CallFunction(this->Detector->Call, "OOOKddd", samples,
                                  counts, ids, static_cast<unsigned long long>(waves->Seed),
                                  waves->BinSize, waves->PulseLength, this->DetectionThreshold)
                              : nullptr;
    Py_XDECREF(samples);
    Py_XDECREF(counts);
    Py_XDECREF(ids);
    return result;
  }

  /// Reads the echoes of some waveforms; false if the result is the text of an error.
  static bool Read(PyObject* result, std::size_t count, Echoes* echoes)
  {
    using Row = std::array<double, 4>;
    if (!PyBytes_Check(result))
    {
      return false;
    }
    const auto rows = static_cast<std::size_t>(PyBytes_GET_SIZE(result)) / sizeof(Row);
    for (std::size_t i = 0; i < rows; ++i)
    {
      Row row;
      std::memcpy(row.data(), PyBytes_AS_STRING(result) + i * sizeof(Row), sizeof(Row));
      const auto index = static_cast<std::size_t>(row[0]);
      if (index < count)
      {
        echoes[index].push_back({ row[1], row[2], row[3] });
      }
    }
    return true;
  }

  /// Returns the text of an error, or the exception of a call without a result.
  static std::string GetError(PyObject* result)
  {
    const bool isText = result && PyUnicode_Check(result);
    const char* text = isText ? PyUnicode_AsUTF8(result) : nullptr;
    return text ? text : GetException();
  }

  /// Returns the exception as a text, and clears it; Ctrl-C is raised again where it is awaited.
  static std::string GetException()
  {
    const bool isInterrupt = PyErr_ExceptionMatches(PyExc_KeyboardInterrupt);
    PyObject* type;
    PyObject* value;
    PyObject* trace;
    PyErr_Fetch(&type, &value, &trace);
    PyObject* shown = value ? PyObject_Str(value) : nullptr;
    const char* text = shown ? PyUnicode_AsUTF8(shown) : nullptr;
    std::string message = text && *text ? text : "the echo detector was interrupted";
    Py_XDECREF(shown);
    Py_XDECREF(type);
    Py_XDECREF(value);
    Py_XDECREF(trace);
    PyErr_Clear();
    if (isInterrupt)
    {
      PyErr_SetInterrupt();
    }
    return message;
  }

  std::shared_ptr<Function> Detector;
};

} // namespace

//------------------------------------------------------------------------------
PyObject* heliosAddDetector(PyObject*, PyObject* args)
{
  const char* name;
  PyObject* call;
  if (!PyArg_ParseTuple(args, "sO:add_detector", &name, &call))
  {
    return nullptr;
  }
  const auto detector =
    vtkSmartPointer<PythonDetector>::Take(PythonDetector::New(std::make_shared<Function>(call)));
  return PyBool_FromLong(vtkHeliosEchoDetection::AddDetector(name, detector));
}
