/**
 * Surfaces in and out, the format chosen by the file's extension: .vtp, .vtk, .ply, .stl, .obj
 * (in any case).
 *
 * VTK's readers give STL and OBJ coordinates in single precision. Written are VTP (binary,
 * compressed) and VTK (binary) with all arrays in their own precision, PLY and STL (binary, single
 * precision) and OBJ with the geometry alone.
 */
#ifndef SurfaceFiles_h
#define SurfaceFiles_h

#include <vtkSmartPointer.h>

#include <string>

class Messages;
class ProgressBar;
class vtkPolyData;
class vtkTable;

/** Throws Failure unless the extension is one that can be read and written. */
void CheckSurfaceName(const std::string& path);

/** Throws Failure unless the extension is one that keeps arrays: .vtp or .vtk. */
void CheckArrayFileName(const std::string& path);

/** Throws Failure for what cannot be read as it should be; every point id is valid. */
vtkSmartPointer<vtkPolyData> ReadSurface(
  const std::string& path, Messages* messages, ProgressBar* progress);

/**
 * The same for sites. STL has the points of each triangle apart: those with equal coordinates are
 * one site, at the place of the first; what comes back then has points alone.
 */
vtkSmartPointer<vtkPolyData> ReadSites(
  const std::string& path, Messages* messages, ProgressBar* progress);

/**
 * Writes `surface` to the file `temporary` in the format that `path` asks for. Throws Failure if
 * the file is not complete.
 */
void WriteSurface(vtkPolyData* surface, const std::string& path, const std::string& temporary,
  Messages* messages, ProgressBar* progress);

/** The table as comma-separated values, a line of names first, doubles with 17 digits. */
std::string TableText(vtkTable* table);

#endif
