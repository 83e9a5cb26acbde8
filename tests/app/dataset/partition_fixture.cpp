#include "tests/app/dataset/partition_fixture.h"

#include "core/base/file.h"
#include "core/base/text.h"
#include "tests/app/dataset/fixture.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

namespace pbffd::test {

void writePartition(const std::filesystem::path& index, int pieces) {
  constexpr int cells = 6;
  static_assert((cells + 1) * (cells + 1) == sharedPoints);
  const std::string name = index.stem().string();
  std::filesystem::create_directories(index.parent_path() / name);
  std::string text =
      "<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "  <PUnstructuredGrid GhostLevel=\"0\">\n    <!-- made in code -->\n"
      "    <PPoints><PDataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"/></PPoints>\n";
  for (int piece = 0; piece < pieces; ++piece) {
    const auto grid = hexahedra(cells, true);
    // Slab `piece` of the cube, its border at the very same numbers as its neighbour's.
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i) {
      double point[3];
      grid->GetPoint(i, point);
      const auto layer = static_cast<double>(i / sharedPoints + piece * cells);
      point[2] = -1.0 + 2.0 * layer / (cells * pieces);
      grid->GetPoints()->SetPoint(i, point);
    }
    const std::string source = format("{}/{}.vtu", name, piece);
    writeXml(index.parent_path() / source, *grid, piece % 2 == 0 ? XmlMode::raw : XmlMode::binary);
    text += format("    <Piece Source=\"{}\"/>\n", source);
  }
  writeFileAtomically(index, text + "  </PUnstructuredGrid>\n</VTKFile>\n");
}

void writeSurfacePiece(const std::filesystem::path& path) {
  const vtkNew<vtkUnstructuredGrid> grid;
  const vtkNew<vtkPoints> points;
  for (int i = 0; i < 40; ++i) {
    points->InsertNextPoint(0.05 * i - 1.0, 0.3, -0.04 * i);
  }
  grid->SetPoints(points);
  for (vtkIdType i = 0; i + 2 < 40; ++i) {
    const vtkIdType corners[3] = {i, i + 1, i + 2};
    grid->InsertNextCell(VTK_TRIANGLE, 3, corners);
  }
  writeXml(path, *grid, XmlMode::raw);
}

void writeEmptyPiece(const std::filesystem::path& path) {
  const vtkNew<vtkUnstructuredGrid> grid;
  writeXml(path, *grid, XmlMode::raw);
}

}  // namespace pbffd::test
