#include "ui/window/scene_panel.h"

#include "ui/document/document.h"
#include "ui/document/icons.h"
#include "ui/document/theme.h"
#include "ui/models/scene_model.h"
#include "ui/window/scene_tree.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QPainter>
#include <QVBoxLayout>

#include <set>

namespace pbffd::ui {
namespace {

/// Which glyph means which kind, of the kinds that there are.
class Legend : public QWidget {
 public:
  Legend(const Document& document, const Theme& theme, QWidget* parent)
      : QWidget(parent), document_(document), theme_(theme) {
    setFixedHeight(46);
    setAccessibleName(tr("Kinds of control points"));
    connect(&theme, &Theme::changed, this, qOverload<>(&QWidget::update));
    connect(&document, &Document::opened, this, qOverload<>(&QWidget::update));
    connect(&document, &Document::changed, this, [this](const ProjectChanges& what) {
      if (what.structure) {
        update();
      }
    });
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(Theme::font(11));
    painter.setPen(theme_.color("line"));
    painter.drawLine(0, 0, width(), 0);
    int x = 12;
    int y = 8;
    for (const PointKind kind : kinds()) {
      const QString name = kindTitle(kind);
      const int step = 20 + painter.fontMetrics().horizontalAdvance(name) + 12;
      if (x + step > width()) {
        x = 12;
        y += 17;
      }
      drawIcon(painter, QRectF(x, y + 1, 13, 13), kindIcon(kind), theme_.color(kindToken(kind)));
      painter.setPen(theme_.color("text.2"));
      painter.drawText(QRect(x + 19, y, step, 16), Qt::AlignVCenter, name);
      x += step;
    }
  }

 private:
  std::set<PointKind> kinds() const {
    std::set<PointKind> kinds;
    if (document_.isOpen()) {
      for (const Level& level : document_.shown().controls.levels) {
        for (const ControlPoint& point : level) {
          kinds.insert(point.kind);
        }
      }
    }
    return kinds;
  }

  const Document& document_;
  const Theme& theme_;
};

}  // namespace

ScenePanel::ScenePanel(Document& document, ViewState& view, const Theme& theme, QWidget* parent)
    : QWidget(parent),
      model_(new SceneModel(document, view, this)),
      filter_(new QLineEdit),
      tree_(new SceneTree(*model_, document, theme)) {
  filter_->setPlaceholderText(tr("Filter by name, kind or id"));
  filter_->setAccessibleName(tr("Filter of the scene"));
  filter_->setToolTip(tr("A name or a number, or one of:\nkind:exterior   moved   disabled   locked"));
  filter_->setClearButtonEnabled(true);
  filter_->addAction(makeIcon(theme, "search", {"text.3", "text.3"}), QLineEdit::LeadingPosition);
  filter_->installEventFilter(this);
  connect(filter_, &QLineEdit::textChanged, model_, &SceneModel::setFilter);
  auto* top = new QVBoxLayout;
  top->setContentsMargins(8, 8, 8, 4);
  top->addWidget(filter_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addLayout(top);
  column->addWidget(tree_, 1);
  column->addWidget(new Legend(document, theme, this));
}

void ScenePanel::startFilter() {
  filter_->setFocus();
  filter_->selectAll();
}

/// Escape empties the filter, then gives the focus to the tree; Down goes to the tree.
bool ScenePanel::eventFilter(QObject* object, QEvent* event) {
  if (object == filter_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Escape && !filter_->text().isEmpty()) {
      filter_->clear();
      return true;
    }
    if (key == Qt::Key_Escape || key == Qt::Key_Down) {
      tree_->setFocus();
      return true;
    }
  }
  return QWidget::eventFilter(object, event);
}

}  // namespace pbffd::ui
