#pragma once

#include "ui/document/theme.h"

#include <QSize>
#include <QString>
#include <QStringList>

#include <stdexcept>

namespace pbffd::workbench {

/// What the command line asks for.
struct Options {
  QString file;
  ui::Theme::Choice theme = ui::Theme::Choice::system;
  bool hasTheme = false;
  QString screenshot;  ///< empty: none
  QSize size{1600, 1000};
  bool hasSize = false;
  bool wantsHelp = false;
  bool wantsVersion = false;
};

/// The command line makes no sense; the message says why.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Without the program's name. Throws UsageError.
Options parseOptions(const QStringList& arguments);

QString usage();

}  // namespace pbffd::workbench
