"""TestProcesses.py PLUGIN OUTPUT_FOLDER [MPIEXEC PVBATCH] (python3): any number of processes.

Runs itself by pvbatch on one, three and four processes, and on two with --symmetric, and compares
the bytes of all outputs, but times and the ids of the input's cells, which are those of the pieces
one after the other. Surfaces: a sphere whose source makes pieces, a file that one process reads, a
contour of an image in pieces, and blocks of both.
"""
import hashlib
import os
import subprocess
import sys

PLUGIN, OUTPUT_FOLDER = sys.argv[1:3]
SKIPPED = {"InputCellId", "Seconds"}
PLY = os.path.join(OUTPUT_FOLDER, "processes.ply")


def bytes_of(data, spread):
    """A digest of all arrays; of spread outputs those of the cells, and the places of corners."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    digest = hashlib.sha256()

    def add(array):
        digest.update(vtk_to_numpy(array).tobytes())

    if data.IsA("vtkCompositeDataSet"):
        iterator = data.NewIterator()
        iterator.InitTraversal()
        parts = []
        while not iterator.IsDoneWithTraversal():
            parts.append(bytes_of(iterator.GetCurrentDataObject(), spread))
            iterator.GoToNextItem()
        return f"{len(parts)} blocks " + " ".join(parts)
    count = data.GetNumberOfElements(1)
    if data.IsA("vtkPolyData"):
        for cells in (data.GetVerts(), data.GetLines(), data.GetPolys()):
            ids = cells.GetConnectivityArray()
            if spread and ids.GetNumberOfTuples():
                points = vtk_to_numpy(data.GetPoints().GetData())
                digest.update(points[vtk_to_numpy(ids)].tobytes())
            elif not spread:
                add(ids)
        if not spread and data.GetNumberOfPoints():
            add(data.GetPoints().GetData())
    for kind in (1, 2, 6) if spread else (0, 1, 2, 6):  # points, cells, fields, rows
        fields = data.GetAttributesAsFieldData(kind)
        found = [fields.GetArray(k) for k in range(fields.GetNumberOfArrays() if fields else 0)]
        arrays = {array.GetName(): array for array in found if array}
        for name in sorted(set(arrays) - SKIPPED):  # on the way here they change their order
            digest.update(name.encode())
            add(arrays[name])
    return f"{count} cells {digest.hexdigest()[:16]}"


def run_inside():
    """One process of pvbatch: the last argument is the file for what the first process finds."""
    import anisotropic_remeshing  # noqa: F401, for the methods of the filters
    from paraview import servermanager, simple
    from vtkmodules.vtkParallelCore import vtkMultiProcessController
    simple.LoadPlugin(PLUGIN, remote=False, ns=vars(simple))
    lines = []

    def show(name, source):
        for spread in (False, True):
            remesher = simple.AnisotropicRemesher(Input=source, NumberOfPoints=200,
                                                  Normals=["POINTS", "None"])
            remesher.GetClientSideObject().SetDistributeOutputs(spread)
            remesher.UpdatePipeline()
            for port in range(5):
                data = servermanager.Fetch(remesher, idx=port)
                if spread and (port == 3 or data.IsA("vtkCompositeDataSet")):
                    continue
                lines.append(f"{name} {spread} {port} {bytes_of(data, True)} "
                             f"{'' if spread else bytes_of(data, False)}")

    sphere = simple.Sphere(ThetaResolution=32, PhiResolution=24)
    contour = simple.Contour(Input=simple.Wavelet(), ContourBy=["POINTS", "RTData"],
                             Isosurfaces=[157.09])
    show("sphere", sphere)
    show("contour", contour)
    show("file", simple.PLYReader(FileNames=[PLY]))
    show("blocks", simple.GroupDatasets(Input=[sphere, contour]))
    if vtkMultiProcessController.GetGlobalController().GetLocalProcessId() == 0:
        with open(sys.argv[3], "w") as file:
            file.write("\n".join(lines) + "\n")


def write_ply():
    """A closed box with creases, in another order than along any curve."""
    points = [(x, y, z) for x in (0, 2) for y in (0, 1) for z in (0, 1)]
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    with open(PLY, "w") as file:
        file.write("ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\n"
                   "property float z\nelement face 6\nproperty list uchar int vertex_indices\n"
                   "end_header\n")
        file.writelines("%g %g %g\n" % point for point in points)
        file.writelines("4 %d %d %d %d\n" % quad for quad in quads)


def run_outside(mpiexec, pvbatch):
    write_ply()
    environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    results = {}
    for processes, options in ((1, []), (3, []), (4, []), (2, ["--symmetric"])):
        found = os.path.join(OUTPUT_FOLDER, f"processes{processes}{''.join(options)}.txt")
        if os.path.exists(found):
            os.remove(found)
        subprocess.run([mpiexec, "--oversubscribe", "-n", str(processes), pvbatch, *options,
                        __file__, PLUGIN, OUTPUT_FOLDER, found],
                       env=environment, check=True, timeout=120)
        with open(found) as file:
            results[(processes, *options)] = file.read().splitlines()
    expected = results[(1,)]
    assert len(expected) == 4 * 5 + 3 * 4, expected
    for line in expected:
        print(line)
        parts = line.split()
        assert parts[2] == "3" or int(parts[3]) > 0, line  # Convergence is a table
    whole = {tuple(line.split()[0:1] + line.split()[2:3]): line.split()[3:6] for line in expected
             if line.split()[1] == "False"}
    for run, lines in results.items():
        assert lines == expected, (run, [pair for pair in zip(lines, expected)
                                         if pair[0] != pair[1]])
    for line in expected:  # spread, the same cells in the same order
        parts = line.split()
        if parts[1] == "True":
            assert whole[(parts[0], parts[2])] == parts[3:6], line


if len(sys.argv) == 5:
    run_outside(*sys.argv[3:])
else:
    run_inside()
