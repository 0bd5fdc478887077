// Loading of MJCF text and files as subjects: models that can be drawn.

#include <exception>
#include <new>

#include "mjforge/backport/backport.h"
#include "mjforge/picture/subject.h"

namespace mjforge::picture {
namespace {

// Size of MuJoCo's stack, in mjtNum: enough for mj_tendon(), in which the Jacobian of a tendon
// takes three numbers for each degree of freedom.
constexpr double kStackSize = 1e6;

std::unique_ptr<Subject> Make(engine::Loaded loaded, std::string& why_not) {
  if (!loaded.model) {
    why_not = loaded.error;
    return nullptr;
  }
  auto state = std::make_unique<Subject::State>();
  state->model = std::move(loaded.model);
  // Allocates no buffers for contacts and constraints. A picture does not need these buffers, which
  // would take most of the memory of a large scene.
  engine::SetBufferSizes(*state->model, {.contacts = 0, .rows = 0, .numbers = kStackSize});
  std::unique_ptr<Subject> subject;
  const std::optional<std::string> failure = engine::FailureOf([&] {
    state->data = compiled::MakeData(*state->model);
    subject = std::make_unique<Subject>(std::move(state));
  });
  if (failure) why_not = *failure;
  return subject;
}

}  // namespace

struct Loader::State {
  engine::Engine engine;
};

Loader::Loader() : state_(std::make_unique<State>()) {}
Loader::~Loader() = default;

std::unique_ptr<Subject> Loader::LoadText(const std::string& mjcf, const bytes::Assets& assets,
                                          std::string& why_not) {
  if (const auto problem = state_->engine.SetAssets(assets)) {
    why_not = problem->message;
    return nullptr;
  }
  // Rejects pipes, devices and damaged meshes, because the text may come from an archive of
  // somebody else.
  if (const auto fault = engine::FindFileFault(mjcf, {})) {
    why_not = fault->message;
    return nullptr;
  }
  return Make(state_->engine.LoadText(mjcf), why_not);
}

std::unique_ptr<Subject> Loader::LoadFile(const std::filesystem::path& file, std::string& why_not) {
  return Make(backport::LoadFile(state_->engine, file), why_not);
}

}  // namespace mjforge::picture
