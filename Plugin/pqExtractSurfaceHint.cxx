#include "pqExtractSurfaceHint.h"

#include "vtkSMDataTypeDomain.h"
#include "vtkSMProperty.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSessionProxyManager.h"

#include <QCoreApplication>
#include <QStatusTipEvent>

//------------------------------------------------------------------------------
void pqExtractSurfaceHint::startup()
{
  qApp->installEventFilter(this);
}

//------------------------------------------------------------------------------
void pqExtractSurfaceHint::shutdown()
{
  if (qApp)
  {
    qApp->removeEventFilter(this);
  }
}

//------------------------------------------------------------------------------
QString pqExtractSurfaceHint::domainDescription()
{
  auto manager = vtkSMProxyManager::GetProxyManager();
  auto session = manager ? manager->GetActiveSessionProxyManager() : nullptr;
  vtkSMProxy* filter =
    session ? session->GetPrototypeProxy("filters", "AnisotropicRemesher") : nullptr;
  vtkSMProperty* input = filter ? filter->GetProperty("Input") : nullptr;
  auto domain = input ? input->FindDomain<vtkSMDataTypeDomain>() : nullptr;
  return domain ? QString::fromStdString(domain->GetDomainDescription()) : QString();
}

//------------------------------------------------------------------------------
bool pqExtractSurfaceHint::eventFilter(QObject* receiver, QEvent* event)
{
  if (event->type() == QEvent::StatusTip)
  {
    const QString tip = static_cast<QStatusTipEvent*>(event)->tip();
    if (!tip.isEmpty() && tip == domainDescription())
    {
      QStatusTipEvent helpful(tr("Needs a surface: apply Extract Surface first."));
      QCoreApplication::sendEvent(receiver, &helpful);
      return true;
    }
  }
  return this->Superclass::eventFilter(receiver, event);
}
