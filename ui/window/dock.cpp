#include "ui/window/dock.h"

#include "ui/document/icons.h"
#include "ui/document/theme.h"
#include "ui/window/labels.h"

#include <QHBoxLayout>
#include <QMenu>
#include <QPainter>
#include <QToolButton>

namespace pbffd::ui {
namespace {

constexpr int titleHeight = 32;

class TitleBar : public QWidget {
 public:
  explicit TitleBar(const Theme& theme) : theme_(theme) { setFixedHeight(titleHeight); }
  /// A dock lays its content out below what is hinted here, whatever the height is.
  QSize sizeHint() const override { return {QWidget::sizeHint().width(), titleHeight}; }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.fillRect(rect(), theme_.color("panel"));
    painter.fillRect(0, height() - 1, width(), 1, theme_.color("line"));
  }

 private:
  const Theme& theme_;
};

}  // namespace

QToolButton* makeIconButton(const Theme& theme, const QString& icon, const QString& toolTip, int size) {
  auto* button = new QToolButton;
  button->setIcon(makeIcon(theme, icon, {"text.2", "accent"}));
  button->setIconSize({14, 14});
  button->setFixedSize(size, size);
  button->setToolTip(toolTip);
  button->setAccessibleName(toolTip);
  return button;
}

Dock::Dock(const Theme& theme, const Look& look, QWidget* content)
    : QDockWidget(look.title), title_(look.title) {
  setObjectName(look.name);
  setTitleBarWidget(makeTitleBar(theme, look));
  content->setProperty("role", "dock");
  setWidget(content);
}

QWidget* Dock::makeTitleBar(const Theme& theme, const Look& look) {
  auto* bar = new TitleBar(theme);
  titleLabel_ = makeLabel(look.title, "strong");
  note_ = makeLabel({}, "quiet");
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(12, 0, 6, 0);
  row->setSpacing(2);
  row->addWidget(titleLabel_);
  row->addStretch();
  row->addWidget(note_);
  if (look.menu != nullptr) {
    QToolButton* more = makeIconButton(theme, "more", tr("More for %1").arg(look.title));
    more->setMenu(look.menu);
    more->setPopupMode(QToolButton::InstantPopup);
    row->addSpacing(4);
    row->addWidget(more);
  }
  if (look.hasButtons) {
    QToolButton* pop = makeIconButton(theme, "float", tr("Float %1").arg(look.title));
    connect(pop, &QToolButton::clicked, this, [this] { setFloating(!isFloating()); });
    QToolButton* shut = makeIconButton(theme, "close", tr("Close %1").arg(look.title));
    connect(shut, &QToolButton::clicked, this, &QDockWidget::close);
    row->addWidget(pop);
    row->addWidget(shut);
  }
  return bar;
}

void Dock::setNote(const QString& note) {
  note_->setText(note);
}

void Dock::setBadge(int number) {
  titleLabel_->setText(number > 0 ? QString("%1  (%2)").arg(title_).arg(number) : title_);
  setWindowTitle(titleLabel_->text());
}

}  // namespace pbffd::ui
