/**
 * @file TestBytes.h
 * @brief Outputs as bytes, to be compared array by array.
 */
#ifndef TestBytes_h
#define TestBytes_h

#include "TestHelpers.h"

#include "vtkCellData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <map>
#include <set>

namespace remesh::test
{
/** Raw memory of an array, or the strings of a string array. */
inline std::string valuesOf(vtkAbstractArray* array)
{
  std::string bytes;
  if (auto* strings = vtkStringArray::SafeDownCast(array))
  {
    for (vtkIdType i = 0; i < strings->GetNumberOfValues(); ++i)
    {
      bytes += strings->GetValue(i) + '\0';
    }
    return bytes;
  }
  const auto size = static_cast<std::size_t>(array->GetNumberOfValues()) *
    static_cast<std::size_t>(array->GetDataTypeSize());
  if (size > 0)
  {
    bytes.append(static_cast<const char*>(array->GetVoidPointer(0)), size);
  }
  return bytes;
}

/** The same after type and size. */
inline std::string bytesOf(vtkAbstractArray* array)
{
  return std::string(array->GetDataTypeAsString()) + " " +
    std::to_string(array->GetNumberOfComponents()) + "x" +
    std::to_string(array->GetNumberOfTuples()) + ":" + valuesOf(array);
}

/** Offsets and ids of cells. VTK 9.6 has two types for them, of the same size. */
inline std::string bytesOf(vtkCellArray* cells)
{
  return std::to_string(cells->GetOffsetsArray()->GetDataTypeSize()) + "x" +
    std::to_string(cells->GetNumberOfCells()) + ":" + valuesOf(cells->GetOffsetsArray()) +
    valuesOf(cells->GetConnectivityArray());
}

using Content = std::map<std::string, std::string>;

/** All that a vtkPolyData or vtkTable holds, by name, but columns called `Seconds`. */
inline Content contentOf(vtkDataObject* data)
{
  Content content;
  const auto addArrays = [&](const char* prefix, vtkFieldData* arrays)
  {
    for (int k = 0; arrays && k < arrays->GetNumberOfArrays(); ++k)
    {
      vtkAbstractArray* array = arrays->GetAbstractArray(k);
      const std::string name = array->GetName() ? array->GetName() : "";
      if (name != "Seconds")
      {
        content[prefix + name] = bytesOf(array);
      }
    }
  };
  addArrays("field ", data->GetFieldData());
  addArrays("row ", data->GetAttributesAsFieldData(vtkDataObject::ROW));
  if (auto* surface = vtkPolyData::SafeDownCast(data))
  {
    addArrays("point ", surface->GetPointData());
    addArrays("cell ", surface->GetCellData());
    content["points"] = surface->GetPoints() ? bytesOf(surface->GetPoints()->GetData()) : "";
    content["verts"] = bytesOf(surface->GetVerts());
    content["lines"] = bytesOf(surface->GetLines());
    content["polys"] = bytesOf(surface->GetPolys());
    content["strips"] = bytesOf(surface->GetStrips());
  }
  return content;
}

/** The content of every output port. */
inline std::vector<Content> contentsOf(vtkAlgorithm* filter)
{
  std::vector<Content> contents;
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    contents.push_back(contentOf(filter->GetOutputDataObject(port)));
  }
  return contents;
}

/** Whether the contents agree to the byte; says what differs, and in which case. */
inline void checkSame(const Content& content, const Content& expected, const std::string& where)
{
  std::set<std::string> names;
  for (const Content* each : { &content, &expected })
  {
    for (const auto& entry : *each)
    {
      names.insert(entry.first);
    }
  }
  for (const std::string& name : names)
  {
    const auto a = content.find(name);
    const auto b = expected.find(name);
    check(a != content.end() && b != expected.end() && a->second == b->second, __FILE__, __LINE__,
      where + ": " + name + " differs");
  }
}

inline void checkSame(const std::vector<Content>& contents, const std::vector<Content>& expected,
  const std::string& where)
{
  CHECK_EQUAL(contents.size(), expected.size());
  for (std::size_t port = 0; port < std::min(contents.size(), expected.size()); ++port)
  {
    checkSame(contents[port], expected[port], where + ", port " + std::to_string(port));
  }
}
}

#endif
