#include "ui/window/options_bar.h"

#include "ui/controllers/actions.h"
#include "ui/document/document.h"
#include "ui/document/icons.h"
#include "ui/document/theme.h"
#include "ui/window/labels.h"
#include "ui/window/segments.h"

#include <QHBoxLayout>
#include <QToolButton>

namespace pbffd::ui {
namespace {

constexpr int barHeight = 40;

}  // namespace

OptionsBar::OptionsBar(const Actions& actions, Document& document, const Theme& theme, QWidget* parent)
    : QToolBar(parent),
      document_(document),
      theme_(theme),
      toolIcon_(new QLabel),
      toolName_(makeLabel({}, "tool")),
      optionsRow_(new QHBoxLayout),
      levelLabel_(makeLabel(tr("Edit level"), "label")),
      levels_(new Segments(theme)) {
  setObjectName("optionsBar");
  setWindowTitle(tr("Options"));
  setMovable(false);
  setFloatable(false);
  setFixedHeight(barHeight + 1);
  setContextMenuPolicy(Qt::PreventContextMenu);
  auto* content = new QWidget;
  auto* row = new QHBoxLayout(content);
  row->setContentsMargins(12, 0, 12, 0);
  row->setSpacing(8);
  for (const ActionId id : {ActionId::undo, ActionId::redo}) {
    auto* button = new QToolButton;
    button->setDefaultAction(actions[id]);
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    button->setIconSize({18, 18});
    button->setFixedSize(30, 28);
    row->addWidget(button);
  }
  row->addWidget(makeSeparator());
  row->addWidget(toolIcon_);
  row->addWidget(toolName_);
  row->addSpacing(8);
  row->addLayout(optionsRow_);
  row->addStretch();
  row->addWidget(levelLabel_);
  row->addWidget(levels_);
  addWidget(content);
  levels_->setAccessibleName(tr("Edit level"));
  connect(levels_, &Segments::chosen, this, [this](int index) { document_.selection().setLevel(index + 1); });
  connect(&document, &Document::opened, this, &OptionsBar::showLevels);
  connect(&document, &Document::changed, this, [this](const ProjectChanges& what) {
    if (what.structure) {
      showLevels();
    }
  });
  connect(&document.selection(), &Selection::levelChanged, this,
          [this](int level) { levels_->setCurrent(level - 1); });
  connect(&theme, &Theme::changed, this, [this] { setTool(toolName_->text(), iconName_); });
  showLevels();
}

void OptionsBar::setTool(const QString& name, const QString& icon) {
  iconName_ = icon;
  toolName_->setText(name);
  if (!icon.isEmpty()) {
    toolIcon_->setPixmap(
        makeIcon(theme_, icon, {"accent", "accent"}).pixmap(QSize(18, 18), devicePixelRatioF()));
  }
}

void OptionsBar::setToolOptions(QWidget* options) {
  if (options_ != nullptr) {
    optionsRow_->removeWidget(options_);
    options_->hide();
  }
  options_ = options;
  if (options_ != nullptr) {
    optionsRow_->addWidget(options_);
    options_->show();
  }
}

void OptionsBar::showLevels() {
  std::vector<Segments::Segment> segments;
  if (document_.isOpen()) {
    const auto& levels = document_.shown().controls.levels;
    for (std::size_t l = 0; l < levels.size(); ++l) {
      const QString number = QString::number(l + 1);
      segments.push_back({number, counted(levels[l].size()),
                          tr("Level %1, %2 points").arg(number, counted(levels[l].size()))});
    }
  }
  levels_->setSegments(segments);
  levels_->setCurrent(document_.selection().level() - 1);
  levels_->setVisible(!segments.empty());
  levelLabel_->setVisible(!segments.empty());
}

}  // namespace pbffd::ui
