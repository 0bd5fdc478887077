// Chooses the bodies and elements of an attachment, and makes their names valid and unique.
#include "mjforge/attach/name_scope.h"

#include <fmt/format.h>

#include "mjforge/expr/expr.h"

namespace mjforge::attach {

std::string MakeName(std::string_view name) {
  std::string made(name);
  for (char& c : made) {
    if (!expr::IsNameCharacter(c)) c = '_';
  }
  if (!made.empty() && !expr::IsName(made)) made.insert(made.begin(), 'x');
  return made;
}

NameScope::NameScope(const CompiledFile& file, int root, diag::Findings& findings)
    : file_(file), findings_(findings) {
  const mjModel& m = file.model();
  for (int body = root; body < m.nbody; ++body) {
    if (body != root && !positions_.contains(m.body_parentid[body])) continue;
    positions_[body] = static_cast<int>(bodies_.size());
    bodies_.push_back(body);
    if (file.NameOf(mjOBJ_BODY, body).empty()) {
      unnamed_.push_back({mjOBJ_BODY, body, body, body - 1});
    } else {
      Add(mjOBJ_BODY, body);
    }
  }
  AddAll(mjOBJ_JOINT, m.njnt, m.jnt_bodyid);
  AddAll(mjOBJ_GEOM, m.ngeom, m.geom_bodyid);
  AddAll(mjOBJ_SITE, m.nsite, m.site_bodyid);
  AddAll(mjOBJ_CAMERA, m.ncam, m.cam_bodyid);
  AddAll(mjOBJ_LIGHT, m.nlight, m.light_bodyid);
  NameUnnamed();
}

void NameScope::AddAll(mjtObj kind, int count, const int* bodies) {
  std::map<int, int> numbers;
  for (int id = 0; id < count; ++id) {
    const int body = bodies[id];
    const int number = numbers[body]++;
    if (!positions_.contains(body)) continue;
    if (file_.NameOf(kind, id).empty()) {
      unnamed_.push_back({kind, id, body, number});
    } else {
      Add(kind, id);
    }
  }
}

void NameScope::Add(mjtObj kind, int id) {
  const auto [place, is_new] = names_.try_emplace({kind, id}, MakeName(file_.NameOf(kind, id)));
  const std::string& name = place->second;
  if (!is_new || name.empty()) return;
  const auto [first, is_first] = used_.try_emplace({kind, name}, id);
  if (is_first) return;
  diag::Finding& finding =
      AddError(findings_, diag::Code::kModelDuplicateName, file_.MarkOf(kind, id),
               fmt::format("{} and {} of '{}' both get the name '{}'",
                           file_.Description(kind, first->second), file_.Description(kind, id),
                           file_.file().string(), name),
               "names are made of letters, digits and _; rename one of them");
  finding.notes.push_back({file_.MarkOf(kind, first->second), "and here"});
}

void NameScope::Drop(mjtObj kind, int id) {
  names_.erase({kind, id});
  dropped_.insert({kind, id});
}

void NameScope::NameUnnamed() {
  // Names bodies first, because the generated name of another element begins with the name of its
  // body.
  for (const Unnamed& element : unnamed_) {
    const std::string start =
        element.kind == mjOBJ_BODY
            ? "body"
            : fmt::format("{}_{}", Name(mjOBJ_BODY, element.body), KindName(element.kind));
    int number = element.number;
    std::string name;
    do {
      name = fmt::format("{}{}", start, number++);
    } while (!used_.try_emplace({element.kind, name}, element.id).second);
    names_[{element.kind, element.id}] = name;
  }
}

}  // namespace mjforge::attach
