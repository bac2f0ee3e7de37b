/**
 * @class   pqCoordinateArraysWidget
 * @brief   A table of point arrays and their scales, for a repeatable property of such pairs.
 *
 * ParaView's own widget for these has no column titles, and lets numbers and names be typed
 * anywhere. Here the first column offers the input's point arrays, as the array list domain of
 * the property "EmbeddingArray" knows them.
 */
#ifndef pqCoordinateArraysWidget_h
#define pqCoordinateArraysWidget_h

#include "pqPropertyWidget.h"

#include <QList>
#include <QVariant>

class QTableWidget;
class QToolButton;

class pqCoordinateArraysWidget : public pqPropertyWidget
{
  Q_OBJECT
  Q_PROPERTY(QList<QVariant> pairs READ pairs WRITE setPairs NOTIFY pairsChanged)
  typedef pqPropertyWidget Superclass;

public:
  pqCoordinateArraysWidget(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent = nullptr);
  ~pqCoordinateArraysWidget() override;

  /** Name and scale of each row in turn. */
  QList<QVariant> pairs() const;
  void setPairs(const QList<QVariant>& pairs);

Q_SIGNALS:
  void pairsChanged();

private Q_SLOTS:
  /** Adds a row with the first array that has none. */
  void addPair();
  void removeSelected();

private:
  Q_DISABLE_COPY(pqCoordinateArraysWidget)

  void addRow(const QString& name, const QString& scale);
  QStringList pointArrays() const;
  QString nameInRow(int row) const;
  void fitHeight();

  QTableWidget* Table;
  QToolButton* Remove;
};

#endif
