// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkhelios._pcl: PCL clouds in Python, as numpy views without a copy. The public interface is
// vtkhelios/pcl.py.
#include "heliosPclCloud.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPythonUtil.h>

#include <pcl/common/io.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <memory>
#include <string>

namespace py = pybind11;

namespace
{

using Triple = std::array<double, 3>;

const char* GetFormat(std::uint8_t type)
{
  switch (type)
  {
    case pcl::PCLPointField::INT8:
      return "i1";
    case pcl::PCLPointField::UINT8:
      return "u1";
    case pcl::PCLPointField::INT16:
      return "i2";
    case pcl::PCLPointField::UINT16:
      return "u2";
    case pcl::PCLPointField::INT32:
      return "i4";
    case pcl::PCLPointField::UINT32:
      return "u4";
    case pcl::PCLPointField::INT64:
      return "i8";
    case pcl::PCLPointField::UINT64:
      return "u8";
    case pcl::PCLPointField::FLOAT64:
      return "f8";
    default:
      return "f4";
  }
}

vtkPolyData* GetPolyData(const py::object& object)
{
  auto* data =
    dynamic_cast<vtkPolyData*>(vtkPythonUtil::GetPointerFromObject(object.ptr(), "vtkPolyData"));
  if (!data)
  {
    PyErr_Clear();
    throw py::type_error("a cloud needs a vtkPolyData, not " +
      std::string(py::str(py::type::of(object).attr("__name__"))));
  }
  return data;
}

Triple ToTriple(const py::object& origin)
{
  const auto numbers = py::array_t<double>::ensure(origin);
  if (!numbers || numbers.ndim() != 1 || numbers.size() != 3)
  {
    PyErr_Clear();
    throw py::value_error("an origin is three numbers, x y z");
  }
  return { numbers.at(0), numbers.at(1), numbers.at(2) };
}

/// A cloud with its origin. Views share ownership of the cloud, so that it outlives this.
template <typename PointT>
class Cloud
{
public:
  using Points = pcl::PointCloud<PointT>;

  static std::unique_ptr<Cloud> FromPolyData(const py::object& object, const py::object& origin)
  {
    vtkPolyData* data = GetPolyData(object);
    auto cloud = std::make_unique<Cloud>();
    if (origin.is_none())
    {
      helios::ChooseOrigin(data, cloud->Origin.data());
    }
    else
    {
      cloud->Origin = ToTriple(origin);
    }
    const std::string problem = helios::ToPcl(data, cloud->Origin.data(), *cloud->Data);
    if (!problem.empty())
    {
      throw py::value_error(problem);
    }
    return cloud;
  }

  py::object ToPolyData() const
  {
    vtkNew<vtkPolyData> data;
    helios::FromPcl(*this->Data, this->Origin.data(), data);
    return py::reinterpret_steal<py::object>(vtkPythonUtil::GetObjectFromPointer(data));
  }

  /// Returns x y z.
  py::array GetPoints() const
  {
    const auto count = static_cast<py::ssize_t>(this->Data->size());
    return py::array(py::dtype("f4"), { count, py::ssize_t(3) },
      { static_cast<py::ssize_t>(sizeof(PointT)), py::ssize_t(sizeof(float)) },
      this->Data->points.data(), this->Hold());
  }

  /// Returns all fields.
  py::array GetArray() const
  {
    return py::array(MakeType(), { static_cast<py::ssize_t>(this->Data->size()) },
      { static_cast<py::ssize_t>(sizeof(PointT)) }, this->Data->points.data(), this->Hold());
  }

  std::size_t GetSize() const { return this->Data->size(); }
  py::array GetOrigin() const { return py::array(3, this->Origin.data()); }
  void SetOrigin(const py::object& origin) { this->Origin = ToTriple(origin); }

private:
  py::capsule Hold() const
  {
    return py::capsule(new std::shared_ptr<Points>(this->Data),
      [](void* held) { delete static_cast<std::shared_ptr<Points>*>(held); });
  }

  static py::dtype MakeType()
  {
    py::list names;
    py::list formats;
    py::list offsets;
    for (const pcl::PCLPointField& field : pcl::getFields<PointT>())
    {
      names.append(field.name);
      formats.append(GetFormat(field.datatype));
      offsets.append(field.offset);
    }
    return py::dtype(names, formats, offsets, sizeof(PointT));
  }

  std::shared_ptr<Points> Data = std::make_shared<Points>();
  Triple Origin = { 0.0, 0.0, 0.0 };
};

template <typename PointT>
void Define(py::module_& module, const char* name, const char* doc)
{
  using CloudT = Cloud<PointT>;
  py::class_<CloudT>(module, name, doc)
    .def_static("from_polydata", &CloudT::FromPolyData, py::arg("polydata"),
      py::arg("origin") = py::none(),
      "The points of a vtkPolyData, relative to an origin [m]: their centre by default.\n\n"
      "Raises ValueError if an array has the wrong shape.")
    .def("to_polydata", &CloudT::ToPolyData,
      "A vtkPolyData with double points (the origin added) and the arrays this type has.")
    .def_property_readonly("points", &CloudT::GetPoints,
      "x y z relative to the origin [m], float32, n x 3: a view, no copy.")
    .def_property_readonly(
      "array", &CloudT::GetArray, "All fields as a structured array: a view, no copy.")
    .def_property("origin", &CloudT::GetOrigin, &CloudT::SetOrigin,
      "The point that x y z are relative to [m]; float64, a copy.")
    .def(
      "__getitem__",
      [](const CloudT& cloud, const py::str& field)
      { return cloud.GetArray().attr("__getitem__")(field); },
      "A field by its name: a view, no copy.")
    .def("__len__", &CloudT::GetSize)
    .def("__repr__",
      [name](const CloudT& cloud)
      {
        return std::string("<") + name + " of " + std::to_string(cloud.GetSize()) +
          " points, origin " + std::string(py::str(cloud.GetOrigin())) + ">";
      });
}

} // namespace

PYBIND11_MODULE(_pcl, module)
{
  py::module_::import("vtkmodules.vtkCommonDataModel"); // registers vtkPolyData
  module.doc() = "Clouds of the Point Cloud Library, accessible to numpy without a copy.";
  Define<pcl::PointXYZ>(module, "CloudXYZ", "A pcl::PointCloud<pcl::PointXYZ>: x y z.");
  Define<pcl::PointXYZI>(module, "CloudXYZI",
    "A pcl::PointCloud<pcl::PointXYZI>: x y z and intensity, the Amplitude [W].");
  Define<pcl::PointXYZINormal>(module, "CloudXYZINormal",
    "A pcl::PointCloud<pcl::PointXYZINormal>: x y z, intensity, normal_x normal_y normal_z, "
    "curvature.");
  Define<helios::PointEcho>(module, "CloudEcho",
    "A pcl::PointCloud<helios::PointEcho>: x y z, intensity and the other values of an echo, under "
    "the names of its arrays: EchoWidth [ns], GpsTime [s], PulseIds, ClassificationIds, "
    "ReturnNumber, NumberOfReturns.");
}
