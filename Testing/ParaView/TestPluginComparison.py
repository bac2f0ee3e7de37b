"""TestPluginComparison.py PLUGIN OUTPUT_FOLDER (pvbatch): Surface Mesh Comparison in the plugin.

The XML agrees with the class, both inputs and all four outputs work, with and without a reference.
"""
import sys

from paraview import servermanager
from paraview.simple import *

PLUGIN, OUTPUT_FOLDER = sys.argv[1:3]
LoadPlugin(PLUGIN, remote=False, ns=globals())

PORTS = ["Mesh", "Reference", "Summary", "Histograms"]
ALONE = {"Quality", "MinimumAngle", "RadiusRatio", "EdgeRatio"}
PARAMETERS = {"NumberOfSamples", "BoundMaximumDistance", "NumberOfBins", "NumberOfThreads",
              "SMPBackend", "DistributeOutputs"}


def fetch(source, port=0):
    return servermanager.Fetch(source, idx=port)


def names(attributes):
    return {attributes.GetArrayName(i) for i in range(attributes.GetNumberOfArrays())}


def value(source, column):
    return fetch(source, 2).GetValueByName(0, column).ToDouble()


def check_against_class(source):
    """Defaults are the class's; no Set method lacks a property."""
    try:
        import anisotropic_remeshing
    except ImportError:
        print("not wrapped: the defaults are not compared")
        return
    from vtkmodules.vtkCommonExecutionModel import vtkPolyDataAlgorithm
    cls = anisotropic_remeshing.vtkSurfaceMeshComparison
    fresh = cls()
    found = {m[3:] for m in set(dir(cls)) - set(dir(vtkPolyDataAlgorithm))
             if m.startswith("Set") and hasattr(cls, "Get" + m[3:])}
    assert found == PARAMETERS, found
    for parameter in sorted(PARAMETERS):
        prop = source.SMProxy.GetProperty(parameter)
        assert prop, f"no property for Set{parameter}"
        assert prop.GetElement(0) == getattr(fresh, "Get" + parameter)(), parameter


mesh = Sphere(Radius=1.0, ThetaResolution=40, PhiResolution=40)
reference = Sphere(Radius=1.1, ThetaResolution=40, PhiResolution=40)
comparison = SurfaceMeshComparison(Input=mesh, Reference=reference)
check_against_class(comparison)
ports = comparison.SMProxy
assert [ports.GetOutputPortName(i) for i in range(ports.GetNumberOfOutputPorts())] == PORTS

# Points are single precision.
assert abs(value(comparison, "MaximumDistance") - 0.1) < 1e-6
assert 0.1 - 1e-6 < value(comparison, "MaximumDistanceBound") < 0.1011
assert value(comparison, "NumberOfFlippedTriangles") == 0
assert value(comparison, "EulerCharacteristic") == value(comparison, "ReferenceEulerCharacteristic") == 2
judged = fetch(comparison)
assert ALONE | {"NormalDeviation", "Flipped"} <= names(judged.GetCellData())
assert {"Distance", "SignedDistance", "Normals"} <= names(judged.GetPointData())
assert judged.GetPointData().GetArray("SignedDistance").GetRange()[1] < 0
assert fetch(comparison, 1).GetPointData().GetArray("SignedDistance").GetRange()[0] > 0
comparison.NumberOfBins = 7
histograms = fetch(comparison, 3)
assert histograms.GetNumberOfRows() == 7
assert {"Quality", "QualityTriangles", "MinimumAngle", "NormalDeviation"} <= names(histograms.GetRowData())

# Other parameters reach the filter; threads change nothing.
comparison.BoundMaximumDistance = 0
assert "MaximumDistanceBound" not in names(fetch(comparison, 2).GetRowData())
before = value(comparison, "RMSDistance")
comparison.SMPBackend = "Sequential"
assert value(comparison, "RMSDistance") == before
comparison.NumberOfSamples = 100
assert abs(value(comparison, "RMSDistance") - before) < 0.01

# Without a reference the mesh is measured alone.
alone = SurfaceMeshComparison(Input=mesh)
assert names(fetch(alone).GetCellData()) == ALONE, names(fetch(alone).GetCellData())
assert fetch(alone, 1).GetNumberOfPoints() == 0
assert "RMSDistance" not in names(fetch(alone, 2).GetRowData())
assert value(alone, "NumberOfBoundaryEdges") == 0

# After the remesher, against what it was given.
remesher = AnisotropicRemesher(Input=mesh, NumberOfPoints=200)
against = SurfaceMeshComparison(Input=remesher, Reference=mesh)
assert value(against, "NumberOfPoints") == 200
assert 0 < value(against, "RelativeRMSDistance") < 0.02
print("passed")
