#pragma once

#include <QFrame>

#include <vector>

class QButtonGroup;

namespace pbffd::ui {

class Theme;

/// A row of joined buttons of which one is on: edit levels, number of levels.
class Segments : public QFrame {
  Q_OBJECT

 public:
  struct Segment {
    QString text;
    QString count;  ///< drawn quietly after the text
    QString accessibleName;
  };

  Segments(const Theme& theme, QWidget* parent = nullptr);

  void setSegments(const std::vector<Segment>& segments);
  int count() const;
  void setCurrent(int index);
  int current() const;

 Q_SIGNALS:
  /// By the user.
  void chosen(int index);

 private:
  const Theme& theme_;
  QButtonGroup* group_;
};

}  // namespace pbffd::ui
