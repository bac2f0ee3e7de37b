#include "pqRemeshingHelp.h"

#include <pqApplicationCore.h>

void pqRemeshingHelp::startup()
{
  pqApplicationCore::instance()->registerDocumentation(
    ":/AnisotropicRemeshing/AnisotropicRemeshing.qch");
}
