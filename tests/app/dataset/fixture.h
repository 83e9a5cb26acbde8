#pragma once

#include "core/project/project.h"

#include <vtkPointSet.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>

class vtkPointSet;
class vtkPolyData;
class vtkUnstructuredGrid;

namespace pbffd::test {

/// A sphere of radius 1 about the origin with control points around it, some of them moved and turned.
Project bentProject(Reach reach = Reach::all);

/// The same at rest.
Project restingProject();

/// n^3 hexahedra over [-1, 1]^3, with the point arrays "velocity", "Normals" (the active normals) and "id", and
/// the cell arrays "flux" (three a row) and "pressure".
vtkSmartPointer<vtkUnstructuredGrid> hexahedra(int n, bool isDouble);

/// The surface of a sphere as polygons, in single precision, with the point array "velocity".
vtkSmartPointer<vtkPolyData> polygons();

enum class XmlMode { raw, rawBigEndian, rawCompressed, base64, ascii, binary };

/// Writes a .vtu, .vtp or .vts by VTK.
void writeXml(const std::filesystem::path& path, vtkPointSet& data, XmlMode mode);

/// Writes a legacy file; version 42 or 51.
void writeLegacy(const std::filesystem::path& path, vtkPointSet& data, bool isBinary, int version);

/// Reads any of these by VTK; fails the program where that does not work.
vtkSmartPointer<vtkPointSet> readBack(const std::filesystem::path& path);

Points pointsOf(vtkPointSet& data);

/// A point array of three numbers a row.
Points pointArray(vtkPointSet& data, const std::string& name);
Points cellArray(vtkPointSet& data, const std::string& name);

/// The names in a folder, hidden ones included, in alphabetical order.
std::vector<std::string> namesIn(const std::filesystem::path& folder);

/// What `work` throws, as text; empty where it throws nothing.
template <class Work>
std::string messageOf(const Work& work) {
  try {
    work();
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

}  // namespace pbffd::test
