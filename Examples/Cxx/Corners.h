/**
 * Polygons whose corners have texture coordinates and normals of their own, as OBJ and PLY files
 * have them, as vtkPolyData, whose points have one of each.
 */
#ifndef Corners_h
#define Corners_h

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <vector>

class vtkPolyData;

struct Corner
{
  vtkIdType Point = 0;
  vtkIdType Texture = -1; // -1: none
  vtkIdType Normal = -1;
};

struct CornerMesh
{
  std::vector<double> Points;             // three numbers each
  std::vector<double> Textures;           // two numbers each
  std::vector<double> Normals;            // three numbers each
  std::vector<Corner> Corners;            // of all polygons, one after the other
  std::vector<vtkIdType> Offsets = { 0 }; // polygon i: from Offsets[i] to Offsets[i + 1]
};

/**
 * The polygons on all points, used or not, in their order. A point of which corners have different
 * texture coordinates or normals is there once for each, the further ones behind all others. Point
 * arrays TCoords and Normals (both active) only where all corners have some.
 */
vtkSmartPointer<vtkPolyData> MakeSurface(const CornerMesh& mesh);

#endif
