#pragma once

#include "app/dataset/dataset.h"

namespace pbffd {

/// A VTK XML file of the layout that raw_xml_layout.h describes: streamed, so that memory does not grow with
/// the file, and every byte that says nothing about what moved is copied; held in memory as any other where
/// arrays of cells turn. Null for any other file.
std::unique_ptr<Dataset> openRawXmlDataset(const std::filesystem::path& path, const Progress& progress);

}  // namespace pbffd
