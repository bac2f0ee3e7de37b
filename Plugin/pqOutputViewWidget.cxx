#include "pqOutputViewWidget.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqObjectBuilder.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqServerManagerModel.h"
#include "pqUndoStack.h"
#include "pqView.h"
#include "vtkNew.h"
#include "vtkPVXMLElement.h"
#include "vtkSMParaViewPipelineControllerWithRendering.h"
#include "vtkSMProperty.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMViewProxy.h"

#include <QHBoxLayout>
#include <QPushButton>

//------------------------------------------------------------------------------
pqOutputViewWidget::pqOutputViewWidget(
  vtkSMProxy* smproxy, vtkSMProperty* smproperty, QWidget* parentWidget)
  : Superclass(smproxy, parentWidget)
  , Button(new QPushButton(smproperty->GetXMLLabel(), this))
{
  this->setProperty(smproperty);
  this->setShowLabel(false);
  vtkPVXMLElement* hints = smproperty->GetHints();
  if (vtkPVXMLElement* hint = hints ? hints->FindNestedElementByName("OutputView") : nullptr)
  {
    hint->GetScalarAttribute("port", &this->Port);
    this->ViewType = hint->GetAttributeOrEmpty("view");
  }
  this->Button->setObjectName("Button");
  this->Button->setToolTip(pqPropertyWidget::getTooltip(smproperty));
  auto row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(this->Button);

  this->connect(this->Button, SIGNAL(clicked()), SLOT(showOutput()));
  if (pqOutputPort* shown = this->port())
  {
    this->connect(
      shown->getSource(), SIGNAL(modifiedStateChanged(pqServerManagerModelItem*)), SLOT(enable()));
  }
  this->enable();
}

//------------------------------------------------------------------------------
pqOutputViewWidget::~pqOutputViewWidget() = default;

//------------------------------------------------------------------------------
pqOutputPort* pqOutputViewWidget::port() const
{
  auto model = pqApplicationCore::instance()->getServerManagerModel();
  auto source = model->findItem<pqPipelineSource*>(this->proxy());
  return source ? source->getOutputPort(this->Port) : nullptr;
}

//------------------------------------------------------------------------------
void pqOutputViewWidget::enable()
{
  pqOutputPort* shown = this->port();
  this->Button->setEnabled(shown && shown->getSource()->modifiedState() != pqProxy::UNINITIALIZED);
}

//------------------------------------------------------------------------------
pqView* pqOutputViewWidget::existingView() const
{
  const QList<pqView*> views = this->port()->getViews();
  for (pqView* candidate : views)
  {
    if (candidate->getViewType() == QString::fromStdString(this->ViewType))
    {
      return candidate;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
void pqOutputViewWidget::showOutput()
{
  auto& active = pqActiveObjects::instance();
  pqView* before = active.activeView();
  pqOutputPort* shown = this->port();
  vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;

  BEGIN_UNDO_SET(this->Button->text());
  pqView* target = this->existingView();
  if (!target)
  {
    auto layout = active.activeLayout();
    const int location = active.activeLayoutLocation();
    target = pqApplicationCore::instance()->getObjectBuilder()->createView(
      QString::fromStdString(this->ViewType), shown->getServer());
    controller->AssignViewToLayout(target->getViewProxy(), layout, location);
  }
  controller->Show(shown->getSourceProxy(), shown->getPortNumber(), target->getViewProxy());
  END_UNDO_SET();
  target->resetDisplay();
  target->render();
  if (before)
  {
    active.setActiveView(before);
  }
}
