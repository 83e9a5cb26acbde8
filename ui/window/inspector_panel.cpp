#include "ui/window/inspector_panel.h"

#include "ui/document/document.h"
#include "ui/window/mesh_page.h"
#include "ui/window/point_page.h"

#include <QStackedWidget>
#include <QVBoxLayout>

namespace pbffd::ui {

InspectorPanel::InspectorPanel(Document& document, const Theme& theme, QWidget* parent)
    : QScrollArea(parent),
      document_(document),
      pages_(new QStackedWidget),
      meshPage_(new MeshPage(document, theme)),
      pointPage_(new PointPage(document, theme)) {
  setAccessibleName(tr("Inspector"));
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFocusPolicy(Qt::NoFocus);
  pages_->setProperty("role", "dock");
  pages_->addWidget(meshPage_);
  pages_->addWidget(pointPage_);
  setWidget(pages_);
  connect(&document, &Document::opened, this, &InspectorPanel::refresh);
  connect(&document, &Document::changed, this, &InspectorPanel::refresh);
  connect(&document.selection(), &Selection::changed, this, &InspectorPanel::refresh);
  connect(pointPage_, &PointPage::backToRestAsked, this, &InspectorPanel::backToRestAsked);
  refresh();
}

void InspectorPanel::refresh() {
  const bool hasPoints = document_.isOpen() && !document_.selection().isEmpty();
  if (hasPoints) {
    pointPage_->refresh();
  } else {
    meshPage_->refresh();
  }
  pages_->setCurrentIndex(hasPoints ? 1 : 0);
}

}  // namespace pbffd::ui
