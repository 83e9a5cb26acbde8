#include "ui/window/view_overlays.h"

#include "ui/controllers/actions.h"
#include "ui/document/document.h"
#include "ui/document/theme.h"
#include "ui/document/view_state.h"
#include "ui/views/viewport.h"
#include "ui/window/labels.h"
#include "ui/window/tool_rail.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QToolButton>

namespace pbffd::ui {
namespace {

constexpr int margin = 12;
constexpr int buttonSize = 28;

QList<QAction*> visibleTools(const Actions& actions) {
  QList<QAction*> tools;
  for (const ActionId id : {ActionId::toolSelect, ActionId::toolMove, ActionId::toolRotate, ActionId::toolScale,
                            ActionId::toolAdd}) {
    if (actions[id]->isVisible()) {
      tools += actions[id];
    }
  }
  return tools;
}

}  // namespace

ViewOverlays::ViewOverlays(Viewport& viewport, const Sources& sources, QObject* parent)
    : QObject(parent),
      sources_(sources),
      viewport_(viewport),
      surface_(*viewport.surface()),
      rail_(new ToolRail(sources.theme, visibleTools(sources.actions), &surface_)),
      viewBar_(makeViewBar(surface_)),
      label_(new QLabel(&surface_)) {
  label_->setAttribute(Qt::WA_TransparentForMouseEvents);
  label_->setTextFormat(Qt::RichText);
  connect(&sources.document, &Document::opened, this, &ViewOverlays::showLabel);
  connect(&sources.document, &Document::changed, this, &ViewOverlays::showLabel);
  connect(&sources.document.selection(), &Selection::levelChanged, this, &ViewOverlays::showLabel);
  connect(&sources.view, &ViewState::changed, this, &ViewOverlays::showLabel);
  connect(&sources.theme, &Theme::changed, this, &ViewOverlays::showLabel);
  surface_.installEventFilter(this);
  showLabel();
  arrange();
}

QFrame* ViewOverlays::makeViewBar(QWidget& surface) {
  auto* bar = new QFrame(&surface);
  bar->setProperty("role", "overlay");
  bar->setAccessibleName(tr("View"));
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(5, 4, 5, 4);
  row->setSpacing(3);
  const auto add = [&](ActionId id) {
    auto* button = new QToolButton;
    button->setDefaultAction(sources_.actions[id]);
    button->setIconSize({18, 18});
    button->setFixedSize(buttonSize, buttonSize);
    button->setAccessibleName(sources_.actions[id]->objectName());
    row->addWidget(button);
  };
  add(ActionId::displayShaded);
  add(ActionId::displayWire);
  add(ActionId::displaySeeThrough);
  row->addSpacing(3);
  row->addWidget(makeSeparator());
  row->addSpacing(3);
  add(ActionId::showGhost);
  add(ActionId::showRegions);
  add(ActionId::showGrid);
  row->addSpacing(3);
  row->addWidget(makeSeparator());
  row->addSpacing(3);
  add(ActionId::orthographic);
  add(ActionId::frameSelection);
  bar->adjustSize();
  return bar;
}

void ViewOverlays::showLabel() {
  const QString projection = sources_.view.isOrthographic() ? tr("Orthographic") : tr("Perspective");
  QString detail;
  if (sources_.document.isOpen() && !sources_.document.shown().controls.finest().empty()) {
    const int level = sources_.document.selection().level();
    const int levels = static_cast<int>(sources_.document.shown().controls.levels.size());
    detail = tr("Level %1").arg(level);
    if (levels > 1 && (level == levels || level == 1)) {
      detail += level == levels ? tr(" (finest)") : tr(" (coarsest)");
    }
  }
  projection_ = QString("<span style='font-weight:600; color:%1'>%2</span>")
                    .arg(sources_.theme.color("text").name(), projection);
  detail_ = QString("&nbsp;&nbsp;<span style='color:%1'>%2</span>")
                .arg(sources_.theme.color("text.2").name(), detail);
  arrange();
}

/// As much of the text as there is room for beside the view bar.
void ViewOverlays::fitLabel() {
  for (const QString& text : {projection_ + detail_, projection_, QString()}) {
    label_->setText(text);
    label_->adjustSize();
    if (label_->geometry().right() + margin <= viewBar_->x()) {
      return;
    }
  }
}

void ViewOverlays::arrange() {
  rail_->move(margin, margin);
  viewBar_->move(surface_.width() - viewBar_->width() - margin, margin);
  viewport_.setCovered(toolsRight(), viewBar_->geometry().bottom() + margin / 2);
  label_->move(rail_->geometry().right() + margin + 1, margin + 7);
  fitLabel();
}

int ViewOverlays::toolsRight() const {
  return rail_->geometry().right() + 1;
}

bool ViewOverlays::eventFilter(QObject* object, QEvent* event) {
  if (event->type() == QEvent::Resize || event->type() == QEvent::Show) {
    arrange();
  }
  return QObject::eventFilter(object, event);
}

}  // namespace pbffd::ui
