#pragma once

#include "ui/window/section.h"

#include <QTimer>

class QLabel;

namespace pbffd::ui {

class Document;
class Histogram;

/// The inspector's section of what the selection reaches: vertices on the finest level, points on coarser
/// ones. Computed at most once per turn of the event loop, and not during a drag, which does not change it.
class InfluenceSection : public Section {
  Q_OBJECT

 public:
  InfluenceSection(Document& document, const Theme& theme, QWidget* parent = nullptr);
  void refreshLater();

 private:
  QLabel* addRow(QLabel* name);
  void refresh();

  Document& document_;
  Histogram* histogram_;
  QLabel* reachedName_;
  QLabel* reached_;
  QLabel* strongest_;
  QTimer timer_;
};

}  // namespace pbffd::ui
