#include "pqRemeshingHelp.h"

#include <QMetaObject>
#include <QObject>
#include <QVariant>
#include <pqApplicationCore.h>

void pqRemeshingHelp::startup()
{
  pqApplicationCore* application = pqApplicationCore::instance();
  application->helpEngine(); // makes it
  // With Qt 6 its collection is read-only by default, which ParaView 5.13 does not change.
  for (QObject* child : application->children())
  {
    if (child->inherits("QHelpEngine") && child->metaObject()->indexOfProperty("readOnly") >= 0)
    {
      child->setProperty("readOnly", false);
      child->property("currentFilter"); // opens the collection again
    }
  }
  application->registerDocumentation(":/AnisotropicRemeshing/AnisotropicRemeshing.qch");
}
