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
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMViewProxy.h"

#include <QHBoxLayout>
#include <QPushButton>

#include <utility>

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
    this->BottomTitle = hint->GetAttributeOrEmpty("bottom");
    this->LeftTitle = hint->GetAttributeOrEmpty("left");
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
pqView* pqOutputViewWidget::createView() const
{
  auto& active = pqActiveObjects::instance();
  auto layout = active.activeLayout();
  const int location = active.activeLayoutLocation();
  pqView* created = pqApplicationCore::instance()->getObjectBuilder()->createView(
    QString::fromStdString(this->ViewType), this->port()->getServer());
  vtkSMViewProxy* viewProxy = created->getViewProxy();
  for (const auto& [name, title] :
    { std::pair{ "BottomAxisTitle", this->BottomTitle }, { "LeftAxisTitle", this->LeftTitle } })
  {
    vtkSMPropertyHelper(viewProxy, name, /*quiet=*/true).Set(title.c_str());
  }
  viewProxy->UpdateVTKObjects();
  vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
  controller->AssignViewToLayout(viewProxy, layout, location);
  return created;
}

//------------------------------------------------------------------------------
void pqOutputViewWidget::showOutput()
{
  auto& active = pqActiveObjects::instance();
  pqView* before = active.activeView();
  pqOutputPort* shown = this->port();

  BEGIN_UNDO_SET(this->Button->text());
  pqView* target = this->existingView();
  if (!target)
  {
    target = this->createView();
  }
  vtkNew<vtkSMParaViewPipelineControllerWithRendering> controller;
  controller->Show(shown->getSourceProxy(), shown->getPortNumber(), target->getViewProxy());
  END_UNDO_SET();
  target->resetDisplay();
  target->render();
  if (before)
  {
    active.setActiveView(before);
  }
}
