#ifndef MJFORGE_ATTACH_FINITE_H_
#define MJFORGE_ATTACH_FINITE_H_

#include <filesystem>

#include "mjforge/model/model.h"

namespace mjforge::attach {

/// MuJoCo loads NaN and infinity in many places in silence; each is an error.
void CheckFinite(const model::Attachment& attachment, const std::filesystem::path& file,
                 diag::Findings& findings);

}  // namespace mjforge::attach

#endif  // MJFORGE_ATTACH_FINITE_H_
