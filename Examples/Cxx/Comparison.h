/**
 * How good a mesh is and how far it is from a surface, for a person to read.
 */
#ifndef Comparison_h
#define Comparison_h

#include <string>

class vtkTable;

/**
 * The summary of vtkSurfaceMeshComparison as text: what both have in two columns, then distances,
 * angles and shapes.
 */
std::string ComparisonText(
  vtkTable* summary, const std::string& mesh, const std::string& reference);

#endif
