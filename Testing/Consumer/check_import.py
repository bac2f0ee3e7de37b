"""check_import.py PREFIX: the Python package comes from PREFIX and runs."""
import sys

import anisotropic_remeshing
from anisotropic_remeshing import vtkAnisotropicRemesher
from anisotropic_remeshing.vtkFiltersAnisotropicRemeshing import vtkAnisotropicRemesher as same

assert anisotropic_remeshing.__file__.startswith(sys.argv[1]), anisotropic_remeshing.__file__
assert vtkAnisotropicRemesher is same
assert vtkAnisotropicRemesher().GetNumberOfOutputPorts() == 5
print("imported from", anisotropic_remeshing.__file__)
