#include "tests/app/cli/cli_support.h"
#include "tests/support/test_main.h"

#include <QFile>
#include <QtTest>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <vector>

namespace pbffd {
namespace {

/// A .vtu of points alone, raw, along a curve through the unit sphere.
void writePoints(const QString& path, std::int64_t count) {
  QFile file(path);
  QVERIFY(file.open(QIODevice::WriteOnly));
  const std::uint64_t bytes = 24 * static_cast<std::uint64_t>(count);
  file.write(
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\"><UnstructuredGrid>");
  file.write(QString("<Piece NumberOfPoints=\"%1\" NumberOfCells=\"0\">").arg(count).toLatin1());
  file.write(
      "<Points><DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"appended\" "
      "offset=\"0\"/></Points><Cells>");
  int offset = 0;
  for (const char* array : {"Int64\" Name=\"connectivity", "Int64\" Name=\"offsets", "UInt8\" Name=\"types"}) {
    file.write(QString("<DataArray type=\"%1\" format=\"appended\" offset=\"%2\"/>")
                   .arg(array)
                   .arg(bytes + 8 + 8 * static_cast<unsigned>(offset++))
                   .toLatin1());
  }
  file.write("</Cells></Piece></UnstructuredGrid><AppendedData encoding=\"raw\">_");
  file.write(reinterpret_cast<const char*>(&bytes), sizeof bytes);
  std::vector<double> line(3 * 4096);
  for (std::int64_t first = 0; first < count; first += 4096) {
    const std::int64_t rows = std::min<std::int64_t>(4096, count - first);
    for (std::int64_t i = 0; i < rows; ++i) {
      const double share = static_cast<double>(first + i) / static_cast<double>(count);
      double* row = &line[static_cast<std::size_t>(3 * i)];
      row[0] = std::cos(40.0 * share);
      row[1] = std::sin(40.0 * share);
      row[2] = 2.0 * share - 1.0;
    }
    file.write(reinterpret_cast<const char*>(line.data()), 24 * rows);
  }
  const std::uint64_t nothing = 0;
  for (int array = 0; array < 3; ++array) {
    file.write(reinterpret_cast<const char*>(&nothing), sizeof nothing);
  }
  file.write("</AppendedData></VTKFile>\n");
}

/// The most memory in KiB that the program had; -1 where it did not succeed.
long peakOf(const QStringList& arguments) {
  QByteArrayList words{test::pbffdProgram().toLocal8Bit()};
  for (const QString& argument : arguments) {
    words += argument.toLocal8Bit();
  }
  std::vector<char*> pointers;
  for (QByteArray& word : words) {
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);
  const pid_t child = ::fork();
  if (child == 0) {
    ::execv(pointers[0], pointers.data());
    ::_exit(127);
  }
  int status = -1;
  rusage usage{};
  return ::wait4(child, &status, 0, &usage) == child && status == 0 ? usage.ru_maxrss : -1;
}

}  // namespace

class ApplyMemoryTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void memoryDoesNotGrowWithAStreamedFile() {
    const test::CommandFolder folder;
    const QString rest = folder.placedSphere("rest.pbffd");
    const QString moved = folder.path("moved.pbffd");
    const auto edited =
        test::runPbffd({"edit", rest, "--edits", "-", "-o", moved},
                       R"([{"move": {"level": 2, "points": [1, 2, 3], "by": [0.25, 0, 0.125]}}])");
    QVERIFY2(edited.status == 0, edited.errors);
    std::vector<long> peaks;
    for (const std::int64_t count : {500'000, 5'000'000}) {
      writePoints(folder.path("a.vtu"), count);
      peaks.push_back(peakOf({"apply", moved, folder.path("a.vtu"), "-o", folder.path("b.vtu")}));
      QVERIFY(peaks.back() > 0);
      QCOMPARE(QFileInfo(folder.path("b.vtu")).size(), QFileInfo(folder.path("a.vtu")).size());
    }
    const auto bytes = static_cast<long>(QFileInfo(folder.path("a.vtu")).size() / 1024);
    QVERIFY2(peaks[1] - peaks[0] < bytes / 8,
             qPrintable(QString("%1 and %2 KiB, the file has %3").arg(peaks[0]).arg(peaks[1]).arg(bytes)));
  }
};

const test::Registration<ApplyMemoryTest> registration;

}  // namespace pbffd

#include "apply_memory_test.moc"
