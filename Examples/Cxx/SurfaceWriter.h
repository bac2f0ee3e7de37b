/**
 * Surfaces out, the format given by the file's extension: VTP (binary, compressed) and VTK (binary)
 * with all arrays in their own precision; PLY and STL (binary), OBJ and OFF with the geometry
 * alone; .mesh (text) and .meshb (binary) with the cell array Reference.
 */
#ifndef SurfaceWriter_h
#define SurfaceWriter_h

#include <string>
#include <vector>

class Messages;
class ProgressBar;
class vtkPolyData;
class vtkTable;

/** The extensions that can be written, and those of them that keep arrays. */
extern const std::vector<std::string> writableExtensions;
extern const std::vector<std::string> arrayExtensions;

/**
 * Writes `surface` to the file `temporary` in the format that `path` asks for, compressed if it
 * ends in ".gz". PLY is written in double precision where single precision would lose the mesh, as
 * with the coordinates of a map; STL cannot be, of which a warning tells. Throws Failure if the
 * file is not complete.
 */
void WriteSurface(vtkPolyData* surface, const std::string& path, const std::string& temporary,
  Messages* messages, ProgressBar* progress);

/** The table as comma-separated values, a line of names first, doubles with 17 digits. */
std::string TableText(vtkTable* table);

#endif
