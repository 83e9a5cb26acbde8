#pragma once

#include <QWidget>

#include <vector>

namespace pbffd::ui {

class Theme;

/// Bars over a range from 0 to 1, their heights relative to the tallest.
class Histogram : public QWidget {
  Q_OBJECT

 public:
  Histogram(const Theme& theme, QWidget* parent = nullptr);
  void setCounts(std::vector<double> counts);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const Theme& theme_;
  std::vector<double> counts_;
};

}  // namespace pbffd::ui
