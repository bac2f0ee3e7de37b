/**
 * Surfaces in, the format given by the file's extension in any case, or by what standard input
 * starts with.
 *
 * Coordinates have the precision of the file. VTK's readers are used for VTK's own formats and for
 * glTF; why not for the others is told where their readers are.
 */
#ifndef SurfaceFiles_h
#define SurfaceFiles_h

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class Messages;
class ProgressBar;
class vtkPolyData;

/**
 * The .sol or .solb that a .mesh or .meshb is read with, that of its own kind first; "": there is
 * none beside it.
 */
std::string SolutionFileOf(const std::string& path);

/**
 * The warning where a mesh written there would be read with a .sol or .solb that does not belong to
 * it; "": there is none.
 *
 * @param written the .sol or .solb that is written with the mesh; "": none.
 */
std::string ForeignSolutionWarning(const std::string& path, const std::string& written);

/**
 * "must end in .a, .b or .c", with ".gz" allowed behind, unless the name does; else empty. "-" has
 * no extension to check.
 */
std::string ExtensionFault(const std::string& path, const std::vector<std::string>& known);

/**
 * Throws Failure for what cannot be read as it should be; every point id is valid. What had to be
 * left out is a warning among the messages. `format`, if there is one, gets the extension of the
 * format, ".ply".
 */
vtkSmartPointer<vtkPolyData> ReadSurface(const std::string& path, Messages* messages,
  ProgressBar* progress, std::string* format = nullptr);

/**
 * The same for sites. STL has the points of each triangle apart: those with equal coordinates are
 * one site, at the place of the first; what comes back then has points alone.
 */
vtkSmartPointer<vtkPolyData> ReadSites(
  const std::string& path, Messages* messages, ProgressBar* progress);

#endif
