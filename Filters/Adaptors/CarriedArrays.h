/**
 * @file CarriedArrays.h
 * @brief The input's point and cell arrays on the mesh.
 *
 * Arrays keep name, type, components with their names, information keys, lookup table and their
 * part as active scalars, vectors and so on. Not carried: ghost marks; global ids, which would no
 * longer be unique; arrays whose number of tuples is not that of the points or cells; and arrays
 * of names that are reserved for the mesh's own (ReservedNames.h).
 */
#ifndef remesh_CarriedArrays_h
#define remesh_CarriedArrays_h

#include "Adaptors/DiagramOutput.h"
#include "Adaptors/ReservedNames.h"

#include "vtkSmartPointer.h"

#include <functional>

class vtkAbstractArray;
class vtkDataSetAttributes;

namespace remesh
{
/** Names of arrays that are not carried, and why. */
struct LostArrays
{
  /** Whether the input is such a mesh itself: its own arrays are left out without a word. */
  bool inputIsMesh = false;
  std::vector<std::string> taken; ///< the mesh has, or could have, its own of the name
  std::vector<std::string> unfit; ///< not one tuple for each point or cell

  /** A sentence for the user, or nothing. */
  std::string describe() const;
};

struct CarriedArray
{
  vtkAbstractArray* source;
  vtkSmartPointer<vtkAbstractArray> target; ///< as many tuples as the mesh has points or cells
  std::vector<int> attributes; ///< vtkDataSetAttributes::AttributeTypes that it is active as

  bool is(int attribute) const;
};

/** The mesh's own arrays, which are there already. */
struct OwnArrays
{
  Names names; ///< of all there may be
  /** Of those of the input whose values they stand for: these are left out without a warning. */
  std::vector<std::string> replaced;
};

/** Whether the means of an array's values mean something: measures and colours, but not labels. */
bool hasMeans(vtkAbstractArray* array);

/** An array like another one, with room for so many tuples. */
vtkSmartPointer<vtkAbstractArray> makeLike(vtkAbstractArray* source, Offset tuples);

/**
 * Empty arrays on the mesh for those of the input that are carried.
 *
 * @param inputTuples points or cells of the input.
 * @param lost gets those that are not, but ghost marks, global ids and replaced ones.
 */
std::vector<CarriedArray> makeCarriedArrays(vtkDataSetAttributes* input, Offset inputTuples,
  const OwnArrays& own, Offset tuples, vtkDataSetAttributes* output, LostArrays& lost);

/** A place on the input: three of its points, and how much of each. */
struct InputPlace
{
  std::array<Offset, 3> points;
  std::array<double, 3> weights;
};

/** Where the points of an output are on the input. */
struct PlacedPoints
{
  Offset count;
  std::function<InputPlace(Offset)> placeOf; ///< may be called by several threads
  RunControl control;
};

/**
 * Point arrays at places on the input, one for each point of the output: floating-point arrays are
 * interpolated linearly (the active normals are then made unit vectors again), and so are colours,
 * unsigned char arrays of 3 or 4 components, to the nearest whole number. All others (integers,
 * ids, bits, strings) may be labels: they take the value of the corner with the largest weight, of
 * equal ones that of the lowest id. O(vertices x components), in parallel.
 */
void carryPointArrays(vtkPolyData* input, const OwnArrays& own, const PlacedPoints& points,
  vtkPolyData* output, LostArrays& lost);

/** Those at the vertices of a mesh. */
void carryPointArrays(const DiagramSource& source, const std::vector<SurfaceLocation>& places,
  vtkPolyData* output, LostArrays& lost);

/**
 * Cell arrays: each triangle takes the value that covers most of it (TriangleCover), where cells of
 * equal values count together; of equal shares, that of the lowest cell id. Values are never mixed,
 * so that labels stay labels. O(vertices of the pieces), in parallel, and only where the values
 * around a triangle differ.
 *
 * @param blocks of the triangles: other blocks' cells have no say; empty: there are none.
 */
void carryCellArrays(const DiagramSource& source, const std::vector<int>& blocks,
  vtkPolyData* output, LostArrays& lost);

/** The block that covers most of each triangle; of equal ones, that of the lowest cell id. */
std::vector<int> findTriangleBlocks(const DiagramSource& source);

/**
 * Field data: the arrays themselves, but those named like facts of the mesh, which is to have its
 * own already.
 */
void carryFieldData(vtkPolyData* input, vtkPolyData* output, LostArrays& lost);
}

#endif
