#include "app/dataset/vtk_watch.h"

#include "core/base/error.h"
#include "core/base/text.h"

#include <vtkCommand.h>
#include <vtkLogger.h>
#include <vtkXMLReader.h>
#include <vtkXMLWriter.h>

#include <algorithm>
#include <mutex>
#include <string_view>
#include <thread>
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
    if (event == vtkCommand::ProgressEvent) {
      watch->progress_.report(watch->stage_, data == nullptr ? -1.0 : *static_cast<const double*>(data));
      if (watch->progress_.isCancelled()) {
        watch->stop();
      }
    } else {
      watch->hear(event == vtkCommand::ErrorEvent, data == nullptr ? "" : static_cast<const char*>(data));
    }
  }

  VtkWatch* watch = nullptr;
};

/// What VTK's log says on this thread: parts of a reader that nobody can observe speak there, and would be
/// heard on standard error alone.
class VtkWatch::LogListener {
 public:
  explicit LogListener(VtkWatch& watch)
      : watch_(watch), name_(format("pbffd {}", static_cast<const void*>(this))) {
    const std::lock_guard lock(silence().mutex);
    if (silence().listeners++ == 0) {
      silence().before = vtkLogger::GetCurrentVerbosityCutoff();
      vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
    }
    vtkLogger::AddCallback(name_.c_str(), &LogListener::hear, this, vtkLogger::VERBOSITY_WARNING);
  }
  ~LogListener() {
    const std::lock_guard lock(silence().mutex);
    vtkLogger::RemoveCallback(name_.c_str());
    if (--silence().listeners == 0) {
      vtkLogger::SetStderrVerbosity(silence().before);
    }
  }
  LogListener(const LogListener&) = delete;
  LogListener& operator=(const LogListener&) = delete;

 private:
  /// What is shared by all: standard error is silent while any listens.
  struct Silence {
    std::mutex mutex;
    int listeners = 0;
    vtkLogger::Verbosity before = vtkLogger::VERBOSITY_INFO;
  };
  static Silence& silence() {
    static Silence shared;
    return shared;
  }
  static void hear(void* listener, const vtkLogger::Message& message) {
    const auto* self = static_cast<const LogListener*>(listener);
    if (std::this_thread::get_id() == self->thread_) {
      self->watch_.hear(message.verbosity <= vtkLogger::VERBOSITY_ERROR, message.message);
    }
  }

  VtkWatch& watch_;
  std::string name_;
  std::thread::id thread_ = std::this_thread::get_id();
};

VtkWatch::VtkWatch(vtkAlgorithm& algorithm, std::string stage, const Progress& progress)
    : algorithm_(algorithm),
      stage_(std::move(stage)),
      progress_(progress),
      observer_(Observer::New()),
      log_(std::make_unique<LogListener>(*this)) {
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

void VtkWatch::hear(bool isError, std::string_view text) {
  // VTK warns of some of its errors only. The pipeline repeats what its parts said, at length.
  if (isError || text.find("rror ") != std::string_view::npos) {
    const bool isEcho = text.find("returned failure for request") != std::string_view::npos;
    if (!isEcho || errors_.empty()) {
      errors_.push_back(isEcho ? "VTK could not do it" : essence(text));
    }
  } else {
    warnings_.push_back(essence(text));
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
