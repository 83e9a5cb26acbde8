#include "app/dataset/vtk_watch.h"

#include "core/base/error.h"

#include <vtkCommand.h>
#include <vtkXMLReader.h>
#include <vtkXMLWriter.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace pbffd {
namespace {

/// "ERROR: In file.cxx, line 7\nvtkReader (0x1234): what is wrong\n\n" as "what is wrong".
std::string essence(std::string_view text) {
  if (const std::size_t at = text.find("): "); at != std::string_view::npos) {
    text.remove_prefix(at + 3);
  }
  std::string line(text);
  std::replace(line.begin(), line.end(), '\n', ' ');
  line.erase(line.find_last_not_of(" .") + 1);
  return line;
}

}  // namespace

class VtkWatch::Observer : public vtkCommand {
 public:
  static Observer* New() { return new Observer; }

  void Execute(vtkObject*, unsigned long event, void* data) override {
    if (event == vtkCommand::ErrorEvent) {
      watch->errors_.push_back(essence(data == nullptr ? "" : static_cast<const char*>(data)));
    } else if (event == vtkCommand::ProgressEvent) {
      watch->progress_.report(watch->stage_, data == nullptr ? -1.0 : *static_cast<const double*>(data));
      if (watch->progress_.isCancelled()) {
        watch->stop();
      }
    }
  }

  VtkWatch* watch = nullptr;
};

VtkWatch::VtkWatch(vtkAlgorithm& algorithm, std::string stage, const Progress& progress)
    : algorithm_(algorithm), stage_(std::move(stage)), progress_(progress), observer_(Observer::New()) {
  observer_->watch = this;
  for (const unsigned long event :
       {vtkCommand::ErrorEvent, vtkCommand::WarningEvent, vtkCommand::ProgressEvent}) {
    algorithm.AddObserver(event, observer_);
  }
  if (vtkXMLReader* reader = vtkXMLReader::SafeDownCast(&algorithm)) {
    reader->SetReaderErrorObserver(observer_);
    reader->SetParserErrorObserver(observer_);
  }
}

VtkWatch::~VtkWatch() {
  algorithm_.RemoveObserver(observer_);
  if (vtkXMLReader* reader = vtkXMLReader::SafeDownCast(&algorithm_)) {
    reader->SetReaderErrorObserver(nullptr);
    reader->SetParserErrorObserver(nullptr);
  }
  observer_->Delete();
}

void VtkWatch::stop() {
  algorithm_.SetAbortExecute(1);
  // A reader looks at that often; a writer never does.
  if (vtkXMLWriter::SafeDownCast(&algorithm_) != nullptr) {
    throw Cancelled();
  }
}

std::string VtkWatch::errors() const {
  constexpr std::size_t shown = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(shown, errors_.size()); ++i) {
    text += (text.empty() ? "" : "; ") + errors_[i];
  }
  return text + (errors_.size() > shown ? "; and more" : "");
}

}  // namespace pbffd
