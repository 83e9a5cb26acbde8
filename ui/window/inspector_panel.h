#pragma once

#include "core/project/project.h"

#include <QScrollArea>

class QStackedWidget;

namespace pbffd::ui {

class Document;
class MeshPage;
class PointPage;
class Theme;

/// The inspector dock's content: the page of the selected points, or of the mesh when none is selected.
class InspectorPanel : public QScrollArea {
  Q_OBJECT

 public:
  InspectorPanel(Document& document, const Theme& theme, QWidget* parent = nullptr);
 Q_SIGNALS:
  void backToRestAsked();

 private:
  void refresh();

  Document& document_;
  QStackedWidget* pages_;
  MeshPage* meshPage_;
  PointPage* pointPage_;
};

}  // namespace pbffd::ui
