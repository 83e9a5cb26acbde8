#include "app/apply_mpi/ranks.h"

#include <vtkCommunicator.h>
#include <vtkMPIController.h>
#include <vtkNew.h>

namespace pbffd::mpi {

class Ranks::Controller {
 public:
  Controller(int& argc, char**& argv) {
    vtk->Initialize(&argc, &argv);
    vtkMultiProcessController::SetGlobalController(vtk);
  }
  ~Controller() {
    vtkMultiProcessController::SetGlobalController(nullptr);
    vtk->Finalize();
  }
  Controller(const Controller&) = delete;
  Controller& operator=(const Controller&) = delete;

  const vtkNew<vtkMPIController> vtk;
};

Ranks::Ranks(int& argc, char**& argv) : controller_(std::make_unique<Controller>(argc, argv)) {}
Ranks::~Ranks() = default;

int Ranks::rank() const {
  return controller_->vtk->GetLocalProcessId();
}

int Ranks::count() const {
  return controller_->vtk->GetNumberOfProcesses();
}

std::string Ranks::from(int rank, std::string text) const {
  auto size = static_cast<vtkIdType>(text.size());
  controller_->vtk->Broadcast(&size, 1, rank);
  text.resize(static_cast<std::size_t>(size));
  controller_->vtk->Broadcast(text.data(), size, rank);
  return text;
}

std::vector<double> Ranks::fromFirst(std::vector<double> numbers) const {
  auto size = static_cast<vtkIdType>(numbers.size());
  controller_->vtk->Broadcast(&size, 1, 0);
  numbers.resize(static_cast<std::size_t>(size));
  controller_->vtk->Broadcast(numbers.data(), size, 0);
  return numbers;
}

bool Ranks::any(bool mine) const {
  return sum(mine ? 1 : 0) > 0;
}

int Ranks::lowest(bool mine) const {
  const int said = mine ? rank() : count();
  int least = 0;
  controller_->vtk->AllReduce(&said, &least, 1, vtkCommunicator::MIN_OP);
  return least < count() ? least : -1;
}

long long Ranks::sum(long long mine) const {
  long long all = 0;
  controller_->vtk->AllReduce(&mine, &all, 1, vtkCommunicator::SUM_OP);
  return all;
}

std::vector<long long> Ranks::gathered(long long mine) const {
  std::vector<long long> all(static_cast<std::size_t>(count()));
  controller_->vtk->AllGather(&mine, all.data(), 1);
  return all;
}

}  // namespace pbffd::mpi
