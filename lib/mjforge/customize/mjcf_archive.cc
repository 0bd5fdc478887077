// Writer of a tar archive with an MJCF file and the files to which the MJCF file refers.

#include "mjforge/customize/mjcf_archive.h"

#include <optional>

#include "mjforge/output/output.h"

namespace mjforge::customize {

bool ArchiveMjcf(const std::string& name, const mjcf::MjcfDocument& document, std::string& archive,
                 diag::Findings& findings) {
  output::Segment segment(output::ArchiveFormat::kTar);
  bool is_done = segment.Add(name + "/" + name + ".xml", document.text, findings);
  for (const bytes::Asset& asset : document.assets) {
    const std::optional<std::string> content =
        asset.made != nullptr ? *asset.made : output::ReadAsset(asset.file, {}, findings);
    is_done = is_done && content && segment.Add(name + "/" + asset.name, *content, findings);
  }
  archive = std::string(segment.Bytes()) + output::ArchiveEnd(output::ArchiveFormat::kTar);
  return is_done;
}

}  // namespace mjforge::customize
