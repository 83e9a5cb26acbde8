#include "app/workbench/options.h"

#include <QRegularExpression>

namespace pbffd::workbench {
namespace {

[[noreturn]] void refuse(const QString& message) {
  throw UsageError(message.toStdString());
}

ui::Theme::Choice themeOf(const QString& name) {
  if (name == "dark") {
    return ui::Theme::Choice::dark;
  }
  if (name == "light") {
    return ui::Theme::Choice::light;
  }
  if (name != "system") {
    refuse(QString("--theme takes dark, light or system, not \"%1\".").arg(name));
  }
  return ui::Theme::Choice::system;
}

QSize sizeOf(const QString& text) {
  static const QRegularExpression form("^(\\d{3,4})x(\\d{3,4})$");
  const auto match = form.match(text);
  if (!match.hasMatch()) {
    refuse(QString("--size takes a width and a height in pixels, as in 1600x1000, not \"%1\".").arg(text));
  }
  return {match.captured(1).toInt(), match.captured(2).toInt()};
}

}  // namespace

Options parseOptions(const QStringList& arguments) {
  Options options;
  qsizetype at = 0;
  // Both "--size 800x600" and "--size=800x600".
  const auto valueOf = [&](const QString& name) {
    const QString argument = arguments[at];
    if (argument.startsWith(name + "=")) {
      return argument.mid(name.size() + 1);
    }
    if (++at == arguments.size()) {
      refuse(QString("%1 needs a value.").arg(name));
    }
    return arguments[at];
  };
  const auto is = [&](const QString& name) {
    return arguments[at] == name || arguments[at].startsWith(name + "=");
  };
  for (; at < arguments.size(); ++at) {
    if (arguments[at] == "--help" || arguments[at] == "-h") {
      options.wantsHelp = true;
    } else if (arguments[at] == "--version") {
      options.wantsVersion = true;
    } else if (is("--theme")) {
      options.theme = themeOf(valueOf("--theme"));
      options.hasTheme = true;
    } else if (is("--screenshot")) {
      options.screenshot = valueOf("--screenshot");
    } else if (is("--size")) {
      options.size = sizeOf(valueOf("--size"));
      options.hasSize = true;
    } else if (arguments[at].startsWith(u'-') && arguments[at] != "-") {
      refuse(QString("There is no option %1.").arg(arguments[at]));
    } else if (!options.file.isEmpty()) {
      refuse("One file at a time.");
    } else {
      options.file = arguments[at];
    }
  }
  return options;
}

QString usage() {
  return "Usage: pbffd-workbench [FILE] [--theme dark|light|system] [--screenshot OUT.png] [--size WxH]\n"
         "\n"
         "Opens FILE, a mesh (OBJ, OFF, PLY, STL) or a project (PBFFD), or the start page.\n"
         "\n"
         "  --theme dark|light|system  colours of the window; without it those chosen last\n"
         "  --screenshot OUT.png       draws the window with FILE open and its points placed, writes the\n"
         "                             picture and leaves\n"
         "  --size WxH                 of the window in pixels\n"
         "  --version                  prints the version\n"
         "  --help                     prints this\n";
}

}  // namespace pbffd::workbench
