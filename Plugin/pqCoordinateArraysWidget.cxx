#include "pqCoordinateArraysWidget.h"

#include "vtkSMArrayListDomain.h"
#include "vtkSMProperty.h"
#include "vtkSMProxy.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>

//------------------------------------------------------------------------------
pqCoordinateArraysWidget::pqCoordinateArraysWidget(
  vtkSMProxy* smproxy, vtkSMProperty* smproperty, QWidget* parentWidget)
  : Superclass(smproxy, parentWidget)
  , Table(new QTableWidget(0, 2, this))
  , Remove(new QToolButton(this))
{
  this->setProperty(smproperty);
  this->Table->setObjectName("Table");
  this->Table->setHorizontalHeaderLabels({ tr("Array"), tr("Scale") });
  this->Table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  this->Table->verticalHeader()->hide();
  this->Table->setSelectionBehavior(QAbstractItemView::SelectRows);

  auto add = new QToolButton(this);
  add->setObjectName("Add");
  add->setText("+");
  add->setToolTip(tr("Append a point array to the embedding."));
  this->Remove->setObjectName("Remove");
  this->Remove->setText(QString(QChar(0x2212))); // minus sign
  this->Remove->setToolTip(tr("Remove the selected arrays."));
  auto buttons = new QVBoxLayout;
  buttons->addWidget(add);
  buttons->addWidget(this->Remove);
  buttons->addStretch();
  auto row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(this->Table);
  row->addLayout(buttons);

  this->connect(add, SIGNAL(clicked()), SLOT(addPair()));
  this->connect(this->Remove, SIGNAL(clicked()), SLOT(removeSelected()));
  this->connect(this->Table, SIGNAL(cellChanged(int, int)), SIGNAL(pairsChanged()));
  this->addPropertyLink(this, "pairs", SIGNAL(pairsChanged()), smproperty);
  this->fitHeight();
}

//------------------------------------------------------------------------------
pqCoordinateArraysWidget::~pqCoordinateArraysWidget() = default;

//------------------------------------------------------------------------------
QList<QVariant> pqCoordinateArraysWidget::pairs() const
{
  QList<QVariant> result;
  for (int row = 0; row < this->Table->rowCount(); ++row)
  {
    result << this->nameInRow(row) << this->Table->item(row, 1)->text();
  }
  return result;
}

//------------------------------------------------------------------------------
void pqCoordinateArraysWidget::setPairs(const QList<QVariant>& pairs)
{
  if (pairs == this->pairs())
  {
    return;
  }
  const bool blocked = this->blockSignals(true);
  this->Table->setRowCount(0);
  for (int i = 0; i + 1 < pairs.size(); i += 2)
  {
    this->addRow(pairs[i].toString(), pairs[i + 1].toString());
  }
  this->fitHeight();
  this->blockSignals(blocked);
  Q_EMIT this->pairsChanged();
}

//------------------------------------------------------------------------------
void pqCoordinateArraysWidget::addPair()
{
  QStringList unused = this->pointArrays();
  for (int row = 0; row < this->Table->rowCount(); ++row)
  {
    unused.removeAll(this->nameInRow(row));
  }
  this->addRow(unused.value(0), "1");
  this->fitHeight();
  Q_EMIT this->pairsChanged();
}

//------------------------------------------------------------------------------
void pqCoordinateArraysWidget::removeSelected()
{
  for (int row = this->Table->rowCount() - 1; row >= 0; --row)
  {
    if (this->Table->selectionModel()->rowIntersectsSelection(row, QModelIndex()))
    {
      this->Table->removeRow(row);
    }
  }
  this->fitHeight();
  Q_EMIT this->pairsChanged();
}

//------------------------------------------------------------------------------
void pqCoordinateArraysWidget::addRow(const QString& name, const QString& scale)
{
  const bool blocked = this->Table->blockSignals(true);
  const int row = this->Table->rowCount();
  this->Table->insertRow(row);
  auto names = new QComboBox(this->Table);
  names->setEditable(true); // the input may have got other arrays meanwhile
  names->addItems(this->pointArrays());
  names->setCurrentText(name);
  this->connect(names, SIGNAL(currentTextChanged(const QString&)), SIGNAL(pairsChanged()));
  this->Table->setCellWidget(row, 0, names);
  this->Table->setItem(row, 1, new QTableWidgetItem(scale));
  this->Table->blockSignals(blocked);
}

//------------------------------------------------------------------------------
QStringList pqCoordinateArraysWidget::pointArrays() const
{
  QStringList names;
  vtkSMProperty* other = this->proxy()->GetProperty("EmbeddingArray");
  if (auto domain = other ? other->FindDomain<vtkSMArrayListDomain>() : nullptr)
  {
    for (unsigned int i = 0; i < domain->GetNumberOfStrings(); ++i)
    {
      const QString name = domain->GetString(i);
      if (name != domain->GetNoneString())
      {
        names << name;
      }
    }
  }
  return names;
}

//------------------------------------------------------------------------------
QString pqCoordinateArraysWidget::nameInRow(int row) const
{
  return qobject_cast<QComboBox*>(this->Table->cellWidget(row, 0))->currentText();
}

//------------------------------------------------------------------------------
void pqCoordinateArraysWidget::fitHeight()
{
  const int rows = qBound(2, this->Table->rowCount(), 6);
  this->Table->setFixedHeight(this->Table->horizontalHeader()->sizeHint().height() +
    rows * this->Table->verticalHeader()->defaultSectionSize() + 2 * this->Table->frameWidth());
  this->Remove->setEnabled(this->Table->rowCount() > 0);
}
