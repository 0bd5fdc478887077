// C interface: snapshots of specs.
#include "snapshots.h"

#include <memory>
#include <system_error>

#include "mjforge/forge/forge.h"
#include "no_throw.h"
#include "text_view.h"

using namespace mjforge;
using python::View;

namespace {

spec::Snapshot NewSnapshot(const char* reference, const char* text, const char* catalogue) {
  diag::Findings none;
  if (reference != nullptr && reference != bytes::kStandardInput) {
    if (std::optional<spec::Snapshot> kept = spec::OpenSnapshot(reference, none))
      return *std::move(kept);
  }
  spec::Snapshot snapshot;
  snapshot.spec = reference != nullptr ? reference : bytes::kStandardInput;
  std::error_code error;
  snapshot.folder = std::filesystem::current_path(error);
  for (const std::filesystem::path& folder : forge::SearchPath(catalogue))
    snapshot.search_path.push_back(snapshot.folder / folder);
  if (reference == nullptr) {
    snapshot.text_name = "<spec>";
    snapshot.texts[bytes::kStandardInput] = text;
  }
  return snapshot;
}

}  // namespace

MjforgeSnapshot* MjforgeNewSnapshot(const char* reference, const char* text,
                                    const char* catalogue) {
  return python::NoThrow<MjforgeSnapshot*>(nullptr, [&] {
    auto made = std::make_unique<MjforgeSnapshot>();
    made->snapshot = NewSnapshot(reference, text, catalogue);
    return made.release();
  });
}

MjforgeSnapshot* MjforgeReadSnapshot(const char* text, std::size_t size) {
  return python::NoThrow<MjforgeSnapshot*>(nullptr, [&]() -> MjforgeSnapshot* {
    auto made = std::make_unique<MjforgeSnapshot>();
    std::optional<spec::Snapshot> read = spec::ReadSnapshot({text, size});
    if (!read) return nullptr;
    made->snapshot = *std::move(read);
    return made.release();
  });
}

void MjforgeCloseSnapshot(MjforgeSnapshot* snapshot) { delete snapshot; }

MjforgeText MjforgeSnapshotText(MjforgeSnapshot* snapshot) {
  thread_local std::string text;
  text = python::NoThrow(std::string(), [&] {
    const std::scoped_lock lock(snapshot->mutex);
    return spec::SnapshotText(snapshot->snapshot);
  });
  return View(text);
}
