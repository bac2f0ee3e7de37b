"""check_plugin.py PREFIX: ParaView has loaded the plugin from PREFIX by itself, and it runs."""
import sys

from paraview import simple

sphere = simple.Sphere(ThetaResolution=40, PhiResolution=40)
remesher = simple.AnisotropicRemesher(Input=sphere, NumberOfPoints=200)
remesher.UpdatePipeline()
points = remesher.GetDataInformation().GetNumberOfPoints()
assert points == 200, points

with open("/proc/self/maps") as maps:
    names = {line.split()[-1] for line in maps if "AnisotropicRemeshing" in line}
assert len(names) == 2, names  # the plugin and its library
for name in names:
    assert name.startswith(sys.argv[1]), name
print("loaded from", sys.argv[1])
