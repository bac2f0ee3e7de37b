#include "pqRemeshingSizeWidget.h"

#include "pqDoubleLineEdit.h"
#include "pqLineEdit.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyGroup.h"

#include <QComboBox>
#include <QGridLayout>
#include <QIntValidator>
#include <QLabel>
#include <QRadioButton>

namespace
{
const char* const UsualTolerance = "0.001";
}

//------------------------------------------------------------------------------
pqRemeshingSizeWidget::pqRemeshingSizeWidget(
  vtkSMProxy* smproxy, vtkSMPropertyGroup* group, QWidget* parentWidget)
  : Superclass(smproxy, group, parentWidget)
  , LastTolerance(UsualTolerance)
{
  this->setChangeAvailableAsChangeFinished(false);
  auto grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setColumnStretch(1, 1);
  this->addNumberOfPoints(grid);
  this->addDistanceTolerance(grid);
  this->addMaximumNumberOfPoints(grid);
  this->showChosen();
}

//------------------------------------------------------------------------------
pqRemeshingSizeWidget::~pqRemeshingSizeWidget() = default;

//------------------------------------------------------------------------------
void pqRemeshingSizeWidget::addNumberOfPoints(QGridLayout* grid)
{
  this->ChooseNumber = new QRadioButton(tr("Number of points"), this);
  this->ChooseNumber->setObjectName("ChooseNumberOfPoints");
  this->ChooseNumber->setChecked(true);
  this->Number = new pqLineEdit(this);
  this->Number->setObjectName("NumberOfPoints");
  this->Number->setValidator(new QIntValidator(this->Number));
  this->setToolTipOf(this->ChooseNumber, "NumberOfPoints");
  this->setToolTipOf(this->Number, "NumberOfPoints");
  grid->addWidget(this->ChooseNumber, 0, 0);
  grid->addWidget(this->Number, 0, 1);

  this->addPropertyLink(this->Number, "text2", SIGNAL(textChanged(const QString&)),
    this->propertyGroup()->GetProperty("NumberOfPoints"));
  this->connect(
    this->Number, SIGNAL(textChangedAndEditingFinished()), this, SIGNAL(changeFinished()));
}

//------------------------------------------------------------------------------
void pqRemeshingSizeWidget::addDistanceTolerance(QGridLayout* grid)
{
  this->ChooseTolerance = new QRadioButton(tr("Distance tolerance"), this);
  this->ChooseTolerance->setObjectName("ChooseDistanceTolerance");
  this->Tolerance = new pqDoubleLineEdit(this);
  this->Tolerance->setObjectName("DistanceTolerance");
  this->Tolerance->setTextAndResetCursor(this->LastTolerance);
  this->Unit = new QComboBox(this);
  this->Unit->setObjectName("DistanceToleranceIsAbsolute");
  this->Unit->addItem(tr("of diagonal"));
  this->Unit->addItem(tr("as a length"));
  this->setToolTipOf(this->ChooseTolerance, "DistanceTolerance");
  this->setToolTipOf(this->Tolerance, "DistanceTolerance");
  this->setToolTipOf(this->Unit, "DistanceToleranceIsAbsolute");
  grid->addWidget(this->ChooseTolerance, 1, 0);
  grid->addWidget(this->Tolerance, 1, 1);
  grid->addWidget(this->Unit, 2, 1);

  this->addPropertyLink(this, "distanceTolerance", SIGNAL(distanceToleranceChanged()),
    this->propertyGroup()->GetProperty("DistanceTolerance"));
  this->addPropertyLink(this->Unit, "currentIndex", SIGNAL(currentIndexChanged(int)),
    this->propertyGroup()->GetProperty("DistanceToleranceIsAbsolute"));
  this->connect(this->ChooseTolerance, SIGNAL(toggled(bool)), SLOT(showChosen()));
  this->connect(this->ChooseTolerance, SIGNAL(toggled(bool)), SIGNAL(distanceToleranceChanged()));
  this->connect(this->ChooseTolerance, SIGNAL(toggled(bool)), SIGNAL(changeFinished()));
  this->connect(
    this->Tolerance, SIGNAL(textChanged(const QString&)), SIGNAL(distanceToleranceChanged()));
  this->connect(this->Tolerance, SIGNAL(editingFinished()), SLOT(restoreTolerance()));
  this->connect(this->Tolerance, SIGNAL(textChangedAndEditingFinished()), SIGNAL(changeFinished()));
  this->connect(this->Unit, SIGNAL(activated(int)), SIGNAL(changeFinished()));
}

//------------------------------------------------------------------------------
void pqRemeshingSizeWidget::addMaximumNumberOfPoints(QGridLayout* grid)
{
  this->MaximumLabel = new QLabel(tr("Most points"), this);
  this->Maximum = new pqLineEdit(this);
  this->Maximum->setObjectName("MaximumNumberOfPoints");
  this->Maximum->setValidator(new QIntValidator(this->Maximum));
  this->setToolTipOf(this->MaximumLabel, "MaximumNumberOfPoints");
  this->setToolTipOf(this->Maximum, "MaximumNumberOfPoints");
  grid->addWidget(this->MaximumLabel, 3, 0);
  grid->addWidget(this->Maximum, 3, 1);

  this->addPropertyLink(this->Maximum, "text2", SIGNAL(textChanged(const QString&)),
    this->propertyGroup()->GetProperty("MaximumNumberOfPoints"));
  this->connect(
    this->Maximum, SIGNAL(textChangedAndEditingFinished()), this, SIGNAL(changeFinished()));
}

//------------------------------------------------------------------------------
void pqRemeshingSizeWidget::setToolTipOf(QWidget* widget, const char* function)
{
  widget->setToolTip(pqPropertyWidget::getTooltip(this->propertyGroup()->GetProperty(function)));
}

//------------------------------------------------------------------------------
void pqRemeshingSizeWidget::updateWidget(bool showingAdvancedProperties)
{
  this->ShowingAdvanced = showingAdvancedProperties;
  this->showChosen();
}

//------------------------------------------------------------------------------
QString pqRemeshingSizeWidget::distanceTolerance() const
{
  return this->ChooseTolerance->isChecked() ? this->Tolerance->text() : QString("0");
}

//------------------------------------------------------------------------------
void pqRemeshingSizeWidget::setDistanceTolerance(const QString& tolerance)
{
  const bool chosen = tolerance.toDouble() > 0.0;
  if (chosen)
  {
    this->LastTolerance = tolerance;
    this->Tolerance->setTextAndResetCursor(tolerance);
  }
  (chosen ? this->ChooseTolerance : this->ChooseNumber)->setChecked(true);
}

//------------------------------------------------------------------------------
void pqRemeshingSizeWidget::showChosen()
{
  const bool tolerance = this->ChooseTolerance->isChecked();
  this->Number->setVisible(!tolerance);
  this->Tolerance->setVisible(tolerance);
  this->Unit->setVisible(tolerance);
  this->MaximumLabel->setVisible(tolerance && this->ShowingAdvanced);
  this->Maximum->setVisible(tolerance && this->ShowingAdvanced);
}

//------------------------------------------------------------------------------
void pqRemeshingSizeWidget::restoreTolerance()
{
  if (this->Tolerance->text().toDouble() > 0.0)
  {
    this->LastTolerance = this->Tolerance->text();
  }
  else
  {
    this->Tolerance->setTextAndResetCursor(this->LastTolerance);
  }
}
