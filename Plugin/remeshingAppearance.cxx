#include "remeshingAppearance.h"

#include "vtkSMSettings.h"

namespace
{
// Keys are those of ParaView's settings files. More colours than a surface without handles needs.
const char* const Appearance = R"({
  "representations": {
    "RemeshingMeshRepresentation": { "Interpolation": 0 },
    "RemeshingEdgesRepresentation": { "LineWidth": 2.0 }
  },
  "array_lookup_tables": {
    "CellColor": { "PVLookupTable": {
      "AutomaticRescaleRangeMode": -1,
      "IndexedLookup": 1,
      "Annotations": ["0", "", "1", "", "2", "", "3", "", "4", "", "5", "",
                      "6", "", "7", "", "8", "", "9", "", "10", "", "11", ""],
      "IndexedColors": [0.45, 0.62, 0.80,  0.95, 0.75, 0.45,  0.58, 0.76, 0.54,
                        0.86, 0.56, 0.56,  0.76, 0.70, 0.85,  0.93, 0.89, 0.62,
                        0.50, 0.78, 0.76,  0.74, 0.62, 0.52,  0.92, 0.72, 0.80,
                        0.72, 0.82, 0.42,  0.62, 0.62, 0.62,  0.85, 0.85, 0.85]
    } },
    "EdgeType": { "PVLookupTable": {
      "AutomaticRescaleRangeMode": -1,
      "IndexedLookup": 1,
      "Annotations": ["0", "Between cells", "1", "Feature", "2", "Border", "3", "Non-manifold"],
      "IndexedColors": [0.10, 0.10, 0.12,  0.90, 0.35, 0.05,  0.75, 0.10, 0.45,  0.95, 0.05, 0.05]
    } }
  }
})";

// Below the settings of the user and the site, which ParaView gives whole numbers from 1 on.
constexpr double Priority = 0.5;
}

//------------------------------------------------------------------------------
void addRemeshingAppearance()
{
  static bool added = false;
  if (!added)
  {
    added = vtkSMSettings::GetInstance()->AddCollectionFromString(Appearance, Priority);
  }
}
