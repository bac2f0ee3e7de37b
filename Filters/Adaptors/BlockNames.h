/**
 * @file BlockNames.h
 * @brief Names of arrays that tell the blocks of a whole surface apart; no output has them.
 *
 * A surface of several blocks is one vtkPolyData in between. What belongs to which block is told by
 * arrays with these names, on that and on what a filter makes of it. Arrays that only some blocks
 * have, or have as another type, are there under a name of their own, a partial one.
 */
#ifndef remesh_BlockNames_h
#define remesh_BlockNames_h

#include <string>

namespace remesh
{
/** Cell array, and point array where points are in one block: number of the block; vtkIntArray. */
inline constexpr const char* blockName = "vtkWholeSurfaceBlock";

/** Cell array: the cell's id in its block; vtkIdTypeArray. Absent: cells have the ids they have. */
inline constexpr const char* blockCellName = "vtkWholeSurfaceCellId";

/**
 * Cell array: number of the region; vtkIntArray. Regions are what features part: blocks, but
 * the partitions of one data set are one region. Absent: each block is a region.
 */
inline constexpr const char* regionName = "vtkWholeSurfaceRegion";

inline bool isHidden(const std::string& name)
{
  return name == blockName || name == blockCellName || name == regionName;
}

/** Parts an array's name from what makes it one of several. */
inline constexpr char partialMark = '\x1f';

inline std::string partialName(const std::string& name, int variant)
{
  return name + partialMark + std::to_string(variant);
}
inline bool isPartial(const std::string& name)
{
  return name.find(partialMark) != std::string::npos;
}
/** The name that the user knows. */
inline std::string plainName(const std::string& name)
{
  return name.substr(0, name.find(partialMark));
}
}

#endif
