#include "app/dataset/vtk_files.h"

#include "app/dataset/dataset.h"
#include "app/dataset/vtk_watch.h"
#include "core/base/error.h"
#include "core/base/text.h"

#include <unistd.h>
#include <vtkDataWriter.h>
#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkPolyDataWriter.h>
#include <vtkStructuredGrid.h>
#include <vtkStructuredGridReader.h>
#include <vtkStructuredGridWriter.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>
#include <vtkUnstructuredGridWriter.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLStructuredGridReader.h>
#include <vtkXMLStructuredGridWriter.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <cerrno>
#include <stdexcept>
#include <system_error>

namespace pbffd {
namespace {

void requireReadable(const std::filesystem::path& path) {
  if (std::error_code ignored; std::filesystem::is_directory(path, ignored)) {
    throw IoError(format("Could not read {}: it is a folder. Name a file.", path.string()));
  }
  if (::access(path.c_str(), R_OK) != 0) {
    throw IoError(format("Could not read {}: {}. Check the name and the permissions.", path.string(),
                         std::generic_category().message(errno)));
  }
}

/// Readers believe what a header says of its arrays.
template <class Reader>
void update(Reader& reader, const std::filesystem::path& path) {
  try {
    reader.Update();
  } catch (const std::length_error&) {
    throw InvalidInput(
        format("Could not read {}: an array in it has more numbers than any memory holds, or fewer "
               "than none. The file is damaged; write it anew.",
               path.string()));
  }
}

/// Runs a reader whose output is what it reads.
template <class Reader>
VtkFile read(Reader& reader, const std::filesystem::path& path, const Progress& progress) {
  const VtkWatch watch(reader, "Reading " + path.filename().string(), progress);
  reader.SetFileName(path.c_str());
  update(reader, path);
  watch.throwIfCancelled();
  if (const std::string errors = watch.errors(); !errors.empty() || reader.GetErrorCode() != 0) {
    throw InvalidInput(
        format("Could not read {}: {}. The file may be cut short or damaged; write it anew, or open it in the "
               "program that made it.",
               path.string(),
               errors.empty() ? vtkErrorCode::GetStringFromErrorCode(reader.GetErrorCode()) : errors.c_str()));
  }
  VtkFile file;
  file.data = reader.GetOutput();
  file.warnings = watch.warnings();
  return file;
}

template <class Reader>
VtkFile readXml(const std::filesystem::path& path, const Progress& progress) {
  const XmlSettings settings = xmlSettingsOf(path);
  // VTK 9.1 believes it, and crashes.
  if (!settings.badCount.empty()) {
    throw InvalidInput(format("Could not read {}: its first piece says {}. The file is damaged; write it anew.",
                              path.string(), settings.badCount));
  }
  const vtkNew<Reader> reader;
  VtkFile file = read(*reader, path, progress);
  file.xml = settings;
  return file;
}

template <class Reader>
VtkFile readLegacy(const std::filesystem::path& path, const LegacyHeader& header, const Progress& progress) {
  const vtkNew<Reader> reader;
  // By default only the first array of each kind is read.
  reader->ReadAllScalarsOn();
  reader->ReadAllVectorsOn();
  reader->ReadAllNormalsOn();
  reader->ReadAllTensorsOn();
  reader->ReadAllColorScalarsOn();
  reader->ReadAllTCoordsOn();
  reader->ReadAllFieldsOn();
  VtkFile file = read(*reader, path, progress);
  file.legacy = header;
  file.legacyType = reader->GetFileType();
  file.title = reader->GetHeader() == nullptr ? "" : reader->GetHeader();
  return file;
}

VtkFile readAnyLegacy(const std::filesystem::path& path, const Progress& progress) {
  const LegacyHeader header = legacyHeaderOf(path);
  if (header.dataset == "UNSTRUCTURED_GRID") {
    return readLegacy<vtkUnstructuredGridReader>(path, header, progress);
  }
  if (header.dataset == "POLYDATA") {
    return readLegacy<vtkPolyDataReader>(path, header, progress);
  }
  if (header.dataset == "STRUCTURED_GRID") {
    return readLegacy<vtkStructuredGridReader>(path, header, progress);
  }
  throw InvalidInput(
      header.dataset.empty()
          ? format(
                "Could not read {}: no line 'DATASET ...' stands in its header, so it is no legacy VTK file.",
                path.string())
          : format("Could not apply the project to {}: a data set of the kind {} has no points of its own that "
                   "could move. Convert it to an unstructured grid (.vtu) first.",
                   path.string(), header.dataset));
}

/// VTK 9.1, where the disk is full while it writes arrays in their place, frees what it made for appended ones
/// alone.
template <class Writer>
class InPlaceSafe : public Writer {
 public:
  static InPlaceSafe* New() {
    auto* made = new InPlaceSafe;
    made->InitializeObjectBase();
    return made;
  }

 protected:
  void DeletePositionArrays() override {
    if (this->GetDataMode() == vtkXMLWriter::Appended) {
      Writer::DeletePositionArrays();
    }
  }
};

/// Why a file could not be written: VTK hands on what the system said, or knows of a full disk.
std::string reasonOf(unsigned long code, const std::string& errors) {
  if (code == vtkErrorCode::OutOfDiskSpaceError) {
    return "there is no space left on the disk";
  }
  if (code == ENOENT) {
    // Of something else: the file was there, or it would not have been begun.
    return "it could not be written to its end, perhaps since there is no space left on the disk";
  }
  const bool isOfSystem = code > 0 && code < vtkErrorCode::FirstVTKErrorCode;
  return isOfSystem || errors.empty() ? std::string(vtkErrorCode::GetStringFromErrorCode(code)) : errors;
}

template <class Writer>
void run(Writer& writer, const std::filesystem::path& path, const std::filesystem::path& name,
         const Progress& progress) {
  const VtkWatch watch(writer, "Writing " + name.filename().string(), progress);
  writer.SetFileName(path.c_str());
  const int isWritten = writer.Write();
  watch.throwIfCancelled();
  if (isWritten == 0 || writer.GetErrorCode() != 0 || !watch.errors().empty()) {
    throw IoError(format("Could not write {}: {}. Make room, or choose another place.", name.string(),
                         reasonOf(writer.GetErrorCode(), watch.errors())));
  }
}

template <class Writer>
void writeXml(const VtkFile& file, const std::filesystem::path& path, const std::filesystem::path& name,
              const Progress& progress) {
  const vtkNew<InPlaceSafe<Writer>> writer;
  writer->SetInputData(file.data);
  if (file.xml.byteOrder == "BigEndian") {
    writer->SetByteOrderToBigEndian();
  } else if (file.xml.byteOrder == "LittleEndian") {
    writer->SetByteOrderToLittleEndian();
  }
  writer->SetHeaderType(file.xml.headerType == "UInt64" ? vtkXMLWriter::UInt64 : vtkXMLWriter::UInt32);
  writer->SetCompressorType(file.xml.compressor == "vtkZLibDataCompressor"   ? vtkXMLWriter::ZLIB
                            : file.xml.compressor == "vtkLZ4DataCompressor"  ? vtkXMLWriter::LZ4
                            : file.xml.compressor == "vtkLZMADataCompressor" ? vtkXMLWriter::LZMA
                                                                             : vtkXMLWriter::NONE);
  writer->SetDataMode(file.xml.format == "ascii"    ? vtkXMLWriter::Ascii
                      : file.xml.format == "binary" ? vtkXMLWriter::Binary
                                                    : vtkXMLWriter::Appended);
  writer->SetEncodeAppendedData(file.xml.encoding == "base64" ? 1 : 0);
  run(*writer, path, name, progress);
}

template <class Writer>
void writeLegacy(const VtkFile& file, const std::filesystem::path& path, const std::filesystem::path& name,
                 const Progress& progress) {
  const vtkNew<Writer> writer;
  writer->SetInputData(file.data);
  // As text VTK writes six to eleven digits of each number, which would change every array.
  writer->SetFileType(VTK_BINARY);
  writer->SetHeader(file.title.c_str());
  writer->SetFileVersion(file.legacy.version < 50 ? vtkDataWriter::VTK_LEGACY_READER_VERSION_4_2
                                                  : vtkDataWriter::VTK_LEGACY_READER_VERSION_5_1);
  run(*writer, path, name, progress);
}

}  // namespace

VtkFile readVtkFile(const std::filesystem::path& path, const Progress& progress) {
  requireReadable(path);
  const std::string ending = endingOf(path);
  if (ending == ".vtu") {
    return readXml<vtkXMLUnstructuredGridReader>(path, progress);
  }
  if (ending == ".vtp") {
    return readXml<vtkXMLPolyDataReader>(path, progress);
  }
  if (ending == ".vts") {
    return readXml<vtkXMLStructuredGridReader>(path, progress);
  }
  return readAnyLegacy(path, progress);
}

void writeVtkFile(const VtkFile& file, const std::filesystem::path& path, const std::filesystem::path& name,
                  const Progress& progress) {
  const bool isLegacy = !file.legacy.dataset.empty();
  if (vtkUnstructuredGrid::SafeDownCast(file.data) != nullptr) {
    isLegacy ? writeLegacy<vtkUnstructuredGridWriter>(file, path, name, progress)
             : writeXml<vtkXMLUnstructuredGridWriter>(file, path, name, progress);
  } else if (vtkPolyData::SafeDownCast(file.data) != nullptr) {
    isLegacy ? writeLegacy<vtkPolyDataWriter>(file, path, name, progress)
             : writeXml<vtkXMLPolyDataWriter>(file, path, name, progress);
  } else {
    isLegacy ? writeLegacy<vtkStructuredGridWriter>(file, path, name, progress)
             : writeXml<vtkXMLStructuredGridWriter>(file, path, name, progress);
  }
}

}  // namespace pbffd
