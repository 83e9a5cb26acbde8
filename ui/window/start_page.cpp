#include "ui/window/start_page.h"

#include "ui/controllers/actions.h"
#include "ui/document/icons.h"
#include "ui/document/theme.h"
#include "ui/window/labels.h"
#include "ui/window/recent_files.h"
#include "ui/window/samples.h"
#include "ui/window/start_cards.h"

#include <QFileInfo>
#include <QGridLayout>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QSvgRenderer>

namespace pbffd::ui {
namespace {

constexpr int sideWidth = 440;
constexpr QMargins mainMargins(56, 44, 56, 28);
/// Where the window is narrow, so that three samples stand side by side all the same.
constexpr int narrowBelow = 1280;
constexpr int narrowSideWidth = 380;
constexpr QMargins narrowMargins(24, 24, 24, 24);
constexpr int columns = 3;
constexpr std::size_t mostRecent = 6;

QPixmap appPicture(int size, double ratio) {
  QPixmap picture(QSize(size, size) * ratio);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  QSvgRenderer(QString(":/icons/pbffd-workbench.svg")).render(&painter);
  painter.end();
  picture.setDevicePixelRatio(ratio);
  return picture;
}

QString whenText(const QDateTime& time) {
  const qint64 days = time.date().daysTo(QDate::currentDate());
  if (days == 0) {
    return time.toString("HH:mm");
  }
  return days == 1 ? StartPage::tr("yesterday") : QLocale(QLocale::English).toString(time.date(), "d MMMM");
}

/// An icon on a tile beside a heading and a sentence.
QLayout* makeStep(const Theme& theme, const QString& icon, const QString& heading, const QString& text) {
  auto* tile = new QLabel;
  tile->setFixedSize(40, 40);
  tile->setAlignment(Qt::AlignCenter);
  const auto draw = [tile, icon, &theme] {
    tile->setPixmap(
        makeIcon(theme, icon, {"accent", "accent"}).pixmap(QSize(20, 20), tile->devicePixelRatioF()));
    tile->setStyleSheet(QString("background: %1; border-radius: 8px;").arg(theme.color("raised").name()));
  };
  draw();
  QObject::connect(&theme, &Theme::changed, tile, draw);
  auto* words = new QVBoxLayout;
  words->setSpacing(3);
  for (QLabel* line : {makeLabel(heading, "heading"), makeLabel(text, "label")}) {
    line->setWordWrap(true);
    words->addWidget(line);
  }
  words->addStretch();
  auto* row = new QHBoxLayout;
  row->setSpacing(14);
  row->addWidget(tile, 0, Qt::AlignTop);
  row->addLayout(words, 1);
  return row;
}

}  // namespace

StartPage::StartPage(const Actions& actions, RecentFiles& recent, const Theme& theme, QWidget* parent)
    : QWidget(parent), recent_(recent), theme_(theme), pictures_(nullptr) {
  setObjectName("startPage");
  setAttribute(Qt::WA_StyledBackground);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  row->addWidget(makeSide(actions));
  row->addWidget(makeMain(), 1);
  connect(&recent, &RecentFiles::changed, this, &StartPage::showRecent);
  showRecent();
  // First start: the samples are where one begins; later, Open.
  if (recent.entries().empty() && !cards_.empty()) {
    setFocusProxy(cards_.at(findSamples().front().path));
  } else {
    setFocusProxy(openMesh_);
  }
}

QLayout* StartPage::makeTitle() {
  auto* picture = new QLabel;
  picture->setPixmap(appPicture(46, devicePixelRatioF()));
  auto* name = new QLabel(tr("PB-FFD Workbench"));
  name->setStyleSheet("font-size: 22px; font-weight: 600;");
  auto* words = new QVBoxLayout;
  words->setSpacing(0);
  words->addWidget(name);
  words->addWidget(makeLabel(tr("Reshape any mesh with a cloud of points."), "label"));
  auto* row = new QHBoxLayout;
  row->setSpacing(14);
  row->addWidget(picture);
  row->addLayout(words);
  row->addStretch();
  return row;
}

QWidget* StartPage::makeSide(const Actions& actions) {
  openMesh_ = new QPushButton(tr(" Open mesh"));
  openMesh_->setProperty("role", "primary");
  openMesh_->setIcon(makeIcon(theme_, "mesh", {"accent.text", "accent.text"}));
  auto* openProject = new QPushButton(tr(" Open project"));
  openProject->setProperty("role", "large");
  openProject->setIcon(makeIcon(theme_, "folder", {"text", "text"}));
  for (QPushButton* button : {openMesh_, openProject}) {
    button->setFixedHeight(38);
    button->setIconSize({18, 18});
  }
  QLabel* key =
      makeLabel(actions[ActionId::openMesh]->shortcut().toString(QKeySequence::NativeText), "shortcut");
  key->setAttribute(Qt::WA_TransparentForMouseEvents);
  auto* inside = new QHBoxLayout(openMesh_);
  inside->setContentsMargins(0, 0, 16, 0);
  inside->addWidget(key, 0, Qt::AlignRight | Qt::AlignVCenter);
  openMesh_->setToolTip(actions[ActionId::openMesh]->toolTip());
  openProject->setToolTip(actions[ActionId::openProject]->toolTip());
  connect(openMesh_, &QPushButton::clicked, actions[ActionId::openMesh], &QAction::trigger);
  connect(openProject, &QPushButton::clicked, actions[ActionId::openProject], &QAction::trigger);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(10);
  buttons->addWidget(openMesh_, 3);
  buttons->addWidget(openProject, 2);

  auto* clear = new QPushButton(tr("Clear"));
  clear->setProperty("role", "link");
  clear->setAccessibleName(tr("Clear the recent files"));
  connect(clear, &QPushButton::clicked, &recent_, &RecentFiles::clear);
  auto* heading = new QHBoxLayout;
  heading->setContentsMargins(7, 0, 8, 0);
  heading->addWidget(makeLabel(tr("Recent"), "heading"));
  heading->addStretch();
  heading->addWidget(clear);
  recentBlock_ = new QWidget;
  recentRows_ = new QVBoxLayout;
  recentRows_->setSpacing(8);
  auto* block = new QVBoxLayout(recentBlock_);
  block->setContentsMargins(0, 0, 0, 0);
  block->setSpacing(8);
  block->addLayout(heading);
  block->addLayout(recentRows_);

  auto* keys = new QPushButton(tr("Shortcuts"));
  keys->setProperty("role", "link");
  keys->setIcon(makeIcon(theme_, "info", {"accent", "accent"}));
  connect(keys, &QPushButton::clicked, actions[ActionId::shortcuts], &QAction::trigger);
  keys->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  auto* foot = new QHBoxLayout;
  foot->setContentsMargins(8, 0, 0, 0);
  foot->addWidget(keys);
  foot->addWidget(makeLabel("F1", "label"));
  foot->addStretch();

  side_ = new QFrame;
  side_->setObjectName("startSide");
  auto* column = new QVBoxLayout(side_);
  column->setContentsMargins(32, 42, 32, 22);
  column->setSpacing(34);
  column->addLayout(makeTitle());
  column->addLayout(buttons);
  column->addWidget(recentBlock_);
  column->addStretch();
  column->addLayout(foot);
  return side_;
}

QWidget* StartPage::makeMain() {
  drop_ = new DropArea(theme_);
  auto* heading = new QHBoxLayout;
  QLabel* name = makeLabel(tr("Start from a sample"), "heading");
  name->setStyleSheet("font-size: 15px; font-weight: 600;");
  heading->addWidget(name);
  heading->addStretch();
  heading->addWidget(makeLabel(tr("Nothing you do to a sample can spoil it"), "label"));
  auto* grid = new QGridLayout;
  grid->setSpacing(18);
  addSamples(*grid);

  auto* content = new QWidget;
  content->setObjectName("startMain");
  main_ = new QVBoxLayout(content);
  main_->setSpacing(14);
  main_->addWidget(drop_, 3);
  main_->addSpacing(22);
  if (!cards_.empty()) {
    main_->addLayout(heading);
    main_->addLayout(grid, 8);
    main_->addSpacing(16);
  } else {
    main_->addStretch();
  }
  auto* rule = new QFrame;
  rule->setProperty("role", "rule");
  rule->setFixedHeight(1);
  main_->addWidget(rule);
  main_->addSpacing(8);
  main_->addLayout(makeSteps());
  auto* area = new QScrollArea;
  area->setObjectName("startMain");
  area->setWidgetResizable(true);
  area->setFocusPolicy(Qt::NoFocus);
  area->setWidget(content);
  return area;
}

QLayout* StartPage::makeSteps() {
  auto* row = new QHBoxLayout;
  row->setSpacing(24);
  row->addLayout(makeStep(theme_, "mesh", tr("1  Open a mesh"),
                          tr("Control points are placed in and around it for you. A slider sets how many.")),
                 1);
  row->addLayout(makeStep(theme_, "move", tr("2  Drag the points"),
                          tr("Pick points and move them; the surface follows at once.")),
                 1);
  row->addLayout(makeStep(theme_, "save", tr("3  Export or go on later"),
                          tr("Export the new mesh, or save a project with every point in it.")),
                 1);
  return row;
}

void StartPage::addSamples(QGridLayout& grid) {
  const std::vector<Sample> samples = findSamples();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    auto* card = new SampleCard(theme_, samples[i].name);
    const QString path = samples[i].path;
    cards_[path] = card;
    connect(card, &SampleCard::clicked, this, [this, path] { Q_EMIT openAsked(path); });
    const int place = static_cast<int>(i);
    grid.addWidget(card, place / columns, place % columns);
  }
  pictures_ = new SamplePictures(recent_.isKept(), this);
  connect(pictures_, &SamplePictures::ready, this,
          [this](const QString& path, const QImage& picture, int triangles) {
            cards_.at(path)->setPicture(picture, triangles);
            if (--pending_ == 0) {
              Q_EMIT pictured();
            }
          });
  pending_ = samples.size();
  pictures_->ask(samples);
}

void StartPage::showRecent() {
  while (QLayoutItem* item = recentRows_->takeAt(0)) {
    item->widget()->deleteLater();
    delete item;
  }
  const auto& entries = recent_.entries();
  for (std::size_t i = 0; i < std::min(entries.size(), mostRecent); ++i) {
    const QString path = entries[i].path;
    const bool isMissing = !QFileInfo::exists(path);
    auto* row = new RecentRow(
        theme_, {recent_.picture(path), path, whenText(entries[i].time), entries[i].points, isMissing});
    connect(row, &RecentRow::clicked, this, [this, path, isMissing] {
      if (isMissing) {
        recent_.remove(path);
      } else {
        Q_EMIT openAsked(path);
      }
    });
    if (isMissing) {
      row->setToolTip(tr("%1\nA click takes it off the list.").arg(path));
    }
    recentRows_->addWidget(row);
  }
  recentBlock_->setVisible(!entries.empty());
}

void StartPage::resizeEvent(QResizeEvent* event) {
  const bool isNarrow = width() < narrowBelow;
  side_->setFixedWidth(sideWidthOf(width()));
  main_->setContentsMargins(isNarrow ? narrowMargins : mainMargins);
  QWidget::resizeEvent(event);
}

int StartPage::sideWidthOf(int pageWidth) {
  return pageWidth < narrowBelow ? narrowSideWidth : sideWidth;
}

void StartPage::showDrag(bool isOver, const QString& reason) {
  drop_->showDrag(isOver, reason);
}

}  // namespace pbffd::ui
