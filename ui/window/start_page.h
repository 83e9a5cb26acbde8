#pragma once

#include <QWidget>

#include <map>

class QFrame;
class QGridLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace pbffd::ui {

class Actions;
class DropArea;
class RecentFiles;
class SampleCard;
class SamplePictures;
class Theme;

/// What is seen while nothing is open: open buttons, recent files, a place to drop a file on, the samples,
/// three steps.
class StartPage : public QWidget {
  Q_OBJECT

 public:
  StartPage(const Actions& actions, RecentFiles& recent, const Theme& theme, QWidget* parent = nullptr);

  /// Whether every sample has its picture.
  bool isPictured() const { return pending_ == 0; }

  /// How wide the column at the left with the title and the buttons is on a page of this width.
  static int sideWidthOf(int pageWidth);

  /// How the drop area looks while a file is dragged over the window. A reason says why it is refused.
  void showDrag(bool isOver, const QString& reason);

 Q_SIGNALS:
  void openAsked(const QString& path);
  /// The last picture is there.
  void pictured();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* makeSide(const Actions& actions);
  QWidget* makeMain();
  QLayout* makeTitle();
  QLayout* makeSteps();
  void addSamples(QGridLayout& grid);
  void showRecent();

  RecentFiles& recent_;
  const Theme& theme_;
  QFrame* side_ = nullptr;
  QVBoxLayout* main_ = nullptr;
  QPushButton* openMesh_ = nullptr;
  QWidget* recentBlock_ = nullptr;
  QVBoxLayout* recentRows_ = nullptr;
  DropArea* drop_ = nullptr;
  SamplePictures* pictures_;
  std::map<QString, SampleCard*> cards_;
  std::size_t pending_ = 0;  ///< samples without a picture yet
};

}  // namespace pbffd::ui
