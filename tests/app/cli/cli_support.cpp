#include "tests/app/cli/cli_support.h"

#include "tests/support/shapes.h"

#include <QFile>
#include <QJsonDocument>
#include <QProcess>

namespace pbffd::test {
namespace {

constexpr int patience = 120'000;  // milliseconds; sanitizers are slow

}  // namespace

QJsonObject CommandResult::json() const {
  QJsonParseError error;
  const QJsonDocument document = QJsonDocument::fromJson(output, &error);
  return error.error == QJsonParseError::NoError ? document.object() : QJsonObject();
}

QString pbffdProgram() {
  return PBFFD_PROGRAM;
}

CommandResult runPbffd(const QStringList& arguments, const QByteArray& input) {
  QProcess process;
  process.start(pbffdProgram(), arguments);
  process.write(input);
  process.closeWriteChannel();
  CommandResult result;
  if (process.waitForFinished(patience) && process.exitStatus() == QProcess::NormalExit) {
    result.status = process.exitCode();
  }
  result.output = process.readAllStandardOutput();
  result.errors = process.readAllStandardError();
  return result;
}

QString CommandFolder::write(const QString& name, const QByteArray& bytes) const {
  QFile file(path(name));
  if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) {
    qFatal("could not write %s", qPrintable(file.fileName()));
  }
  return file.fileName();
}

QString CommandFolder::writeObj(const QString& name, const Mesh& mesh) const {
  return write(name, objOf(mesh));
}

QString CommandFolder::placedSphere(const QString& name) const {
  const QString mesh = writeObj("sphere.obj", sphere());
  const QString project = path(name);
  const auto placed = runPbffd({"place", mesh, "-o", project, "--points", "30", "--levels", "2"});
  if (placed.status != 0) {
    qFatal("could not place: %s", placed.errors.constData());
  }
  return project;
}

QByteArray CommandFolder::read(const QString& name) const {
  QFile file(path(name));
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(no file)");
}

QByteArray objOf(const Mesh& mesh) {
  QByteArray text("# a comment that stays\n");
  for (const auto& row : mesh.positions.rowwise()) {
    text += "v " + QByteArray::number(row.x(), 'g', 17) + ' ' + QByteArray::number(row.y(), 'g', 17) + ' ' +
            QByteArray::number(row.z(), 'g', 17) + '\n';
  }
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    text += 'f';
    for (const Index vertex : mesh.faces[f]) {
      text += ' ' + QByteArray::number(vertex + 1);
    }
    text += '\n';
  }
  return text;
}

}  // namespace pbffd::test
