#include "SurfaceWriter.h"

#include "Failure.h"
#include "InputBytes.h"
#include "MeshWriter.h"
#include "Messages.h"
#include "OutputFiles.h"
#include "Polygons.h"
#include "ProgressBar.h"
#include "VtpWriter.h"

#include <vtkErrorCode.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkTable.h>
#include <vtkTriangle.h>
#include <vtkVariant.h>

#include <cstdint>
#include <cstdio>
#include <cstring>

const std::vector<std::string> writableExtensions = { ".vtp", ".vtk", ".ply", ".stl", ".obj",
  ".off", ".mesh", ".meshb" };
const std::vector<std::string> arrayExtensions = { ".vtp", ".vtk" };

namespace
{
void GetTriangle(vtkPolyData* surface, const vtkIdType* ids, double corners[3][3])
{
  for (int i = 0; i < 3; ++i)
  {
    surface->GetPoint(ids[i], corners[i]);
  }
}

/** How many triangles turn by more than five degrees in single precision, or lose their area. */
vtkIdType CountTurned(vtkPolyData* surface)
{
  constexpr double limit = 0.996; // cosine
  vtkIdType count = 0;
  ForEachPolygon(surface,
    [&](vtkIdType size, const vtkIdType* ids)
    {
      double corners[3][3];
      double before[3];
      double after[3];
      GetTriangle(surface, ids, corners);
      vtkTriangle::ComputeNormal(corners[0], corners[1], corners[2], before);
      for (auto& corner : corners)
      {
        for (double& x : corner)
        {
          x = static_cast<float>(x);
        }
      }
      vtkTriangle::ComputeNormal(corners[0], corners[1], corners[2], after);
      const bool hasArea = vtkMath::Norm(before) > 0.5;
      count += size == 3 && hasArea && vtkMath::Dot(before, after) < limit ? 1 : 0;
    });
  return count;
}

/** The number's bytes, the lowest first. */
template <typename Number, typename Bits>
void AppendNumber(std::string& bytes, Number number)
{
  static_assert(sizeof(Number) == sizeof(Bits));
  Bits bits;
  std::memcpy(&bits, &number, sizeof(bits));
  for (std::size_t i = 0; i < sizeof(bits); ++i)
  {
    bytes += static_cast<char>(static_cast<std::uint64_t>(bits) >> (8 * i) & 0xffU);
  }
}

void AppendFloat(std::string& bytes, double number)
{
  AppendNumber<float, std::uint32_t>(bytes, static_cast<float>(number));
}

std::string PlyBytes(vtkPolyData* surface, bool isDouble)
{
  const std::string type = isDouble ? "double" : "float";
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " +
    std::to_string(surface->GetNumberOfPoints()) + "\nproperty " + type + " x\nproperty " + type +
    " y\nproperty " + type + " z\nelement face " + std::to_string(surface->GetNumberOfPolys()) +
    "\nproperty list uchar int vertex_indices\nend_header\n";
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      const double x = surface->GetPoint(i)[c];
      isDouble ? AppendNumber<double, std::uint64_t>(bytes, x) : AppendFloat(bytes, x);
    }
  }
  ForEachPolygon(surface,
    [&bytes](vtkIdType size, const vtkIdType* ids)
    {
      bytes += static_cast<char>(size); // of a mesh, 3
      for (vtkIdType i = 0; i < size; ++i)
      {
        AppendNumber<int, std::uint32_t>(bytes, static_cast<int>(ids[i]));
      }
    });
  return bytes;
}

std::string StlBytes(vtkPolyData* surface)
{
  std::string bytes = "written by remesh_surface";
  bytes.resize(80, ' ');
  AppendNumber<int, std::uint32_t>(bytes, static_cast<int>(surface->GetNumberOfPolys()));
  ForEachPolygon(surface,
    [&](vtkIdType, const vtkIdType* ids)
    {
      double corners[3][3];
      double normal[3];
      GetTriangle(surface, ids, corners);
      vtkTriangle::ComputeNormal(corners[0], corners[1], corners[2], normal);
      for (const double* numbers : { normal, corners[0], corners[1], corners[2] })
      {
        for (int c = 0; c < 3; ++c)
        {
          AppendFloat(bytes, numbers[c]);
        }
      }
      bytes.append(2, '\0');
    });
  return bytes;
}

/** Wavefront OBJ or OFF. */
std::string PolygonText(vtkPolyData* surface, bool isObj)
{
  std::string text = isObj ? ""
                           : "OFF\n" + std::to_string(surface->GetNumberOfPoints()) + ' ' +
      std::to_string(surface->GetNumberOfPolys()) + " 0\n";
  char line[96];
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double x[3];
    surface->GetPoint(i, x);
    std::snprintf(line, sizeof(line), "%.17g %.17g %.17g\n", x[0], x[1], x[2]);
    text += (isObj ? "v " : "") + std::string(line);
  }
  ForEachPolygon(surface,
    [&](vtkIdType size, const vtkIdType* ids)
    {
      text += isObj ? "f" : std::to_string(size);
      for (vtkIdType i = 0; i < size; ++i)
      {
        text += ' ' + std::to_string(ids[i] + (isObj ? 1 : 0));
      }
      text += '\n';
    });
  return text;
}

void WriteVtk(vtkPolyData* surface, const std::string& path, Messages* messages)
{
  vtkNew<vtkPolyDataWriter> writer; // which finds out when it cannot write
  writer->SetInputData(surface);
  writer->SetFileName(path.c_str());
  writer->SetFileTypeToBinary();
  writer->Update();
  messages->ThrowIfError("VTK says");
  if (writer->GetErrorCode() != 0)
  {
    throw Failure(vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode()));
  }
}

std::string StlBytesOrWarning(vtkPolyData* surface, const std::string& path, Messages* messages)
{
  if (const vtkIdType turned = CountTurned(surface))
  {
    messages->DisplayWarningText(
      (path + " has single precision, in which " + std::to_string(turned) +
        " triangles turn by more than 5 degrees: .vtp, .vtk, .ply, .obj and "
        ".off keep double precision")
        .c_str());
  }
  return StlBytes(surface);
}
} // namespace

void WriteSurface(vtkPolyData* surface, const std::string& path, const std::string& temporary,
  Messages* messages, ProgressBar* progress)
{
  const std::string extension = LowerCaseExtension(path);
  if (extension == ".vtp")
  {
    WriteVtp(surface, temporary, progress);
  }
  else if (extension == ".vtk")
  {
    WriteVtk(surface, temporary, messages);
  }
  else if (extension == ".mesh" || extension == ".meshb")
  {
    const vtkIdType rows = surface->GetNumberOfPoints() + surface->GetNumberOfPolys();
    WriteBytes(temporary, MeshBytes(surface, MeshFormatFor(extension, rows)));
  }
  else
  {
    WriteBytes(temporary,
      extension == ".ply"     ? PlyBytes(surface, CountTurned(surface) > 0)
        : extension == ".stl" ? StlBytesOrWarning(surface, path, messages)
                              : PolygonText(surface, extension == ".obj"));
  }
  if (WithoutGz(path) != path)
  {
    CompressFile(temporary);
  }
}

std::string TableText(vtkTable* table)
{
  // vtkDelimitedTextWriter has six digits.
  std::string text;
  const vtkIdType columns = table->GetNumberOfColumns();
  for (vtkIdType column = 0; column < columns; ++column)
  {
    text += (column > 0 ? "," : "") + std::string(table->GetColumnName(column));
  }
  text += '\n';
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    for (vtkIdType column = 0; column < columns; ++column)
    {
      char number[32];
      std::snprintf(number, sizeof(number), "%.17g", table->GetValue(row, column).ToDouble());
      text += (column > 0 ? "," : "") + std::string(number);
    }
    text += '\n';
  }
  return text;
}
