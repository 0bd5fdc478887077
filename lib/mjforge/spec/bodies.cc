// Reader of `bodies:`: contents and joints of bodies, properties that expressions can use, and
// checks of names and parents.

#include <algorithm>
#include <array>
#include <list>
#include <map>

#include <fmt/format.h>

#include "mjforge/spec/entry_reader.h"

namespace mjforge::spec {
namespace {

using diag::Code;

// Keys that give the content of a body. A body has at most one of these keys.
constexpr std::array<std::string_view, 3> kContents = {"parts", "spec", "mjcf"};

// Keys of a body that must not occur together with `chain:`.
constexpr std::array<std::string_view, 3> kNotInChains = {"place", "fewer", "regions"};

class BodyEntryReader {
 public:
  explicit BodyEntryReader(Context& context) : context_(context), entries_(context) {}

  void Read(const YamlNode& text) {
    auto meant = CheckKeys(kBodyElement, text, context_);
    const YamlNode& map = meant ? corrected_.emplace_back(*std::move(meant)) : text;
    BodyEntry body;
    body.head = entries_.Begin(kBodyElement, map, map, EntryReader::Naming::kRequired);
    CheckContents(map);
    body.parts = ReadEntries(kPartElement, map.Find("parts"), context_);
    if (const YamlNode* spec = map.Find("spec")) entries_.ReadNested(map, *spec, body.head);
    // Declares the properties of the body before reading its fields, sites, views and joints, whose
    // expressions can use the properties.
    DeclareProperties(body);
    body.head.fields = ReadFields(kBodyElement, map, context_);
    body.sites = ReadEntries(kSiteElement, map.Find("sites"), context_);
    body.regions = ReadRegions(map.Find("regions"), context_);
    body.views = ReadViews(map, context_);
    if (const YamlNode* joints = map.Find("joints")) BeginJoints(*joints, body);
    body.place = ReadPlace(map, context_);
    if (ReadChild(kChainElement, map, body.head, context_) != nullptr)
      RejectBeside("chain", kNotInChains, map, "the links are the chain's", context_);
    context_.spec.has_place |= body.place.has_value();
    if (!lists_.empty() && lists_.back().body == context_.spec.bodies.size())
      lists_.back().variables = VariablesOf(body.head);
    entries_.End(body.head);
    context_.spec.bodies.push_back(std::move(body));
  }

  /// Returns the lists of joints that ReadJoints() will read.
  std::vector<const YamlNode*> joint_lists() const {
    return diag::Mapped<const YamlNode*>(lists_, &JointList::joints);
  }

  /// Reads the lists of joints. Call ReadJoints() after all bodies are read, because the
  /// expressions of joints can use the properties of all bodies.
  void ReadJoints() {
    for (const JointList& list : lists_) {
      BodyEntry& body = context_.spec.bodies[list.body];
      for (const auto& variable : list.variables) context_.spec.names.Restore(variable);
      body.joints = ReadEntries(kJointElement, list.joints, context_);
      entries_.End(body.head);
    }
  }

 private:
  void CheckContents(const YamlNode& map) {
    const YamlNode::Pair* first = nullptr;
    for (const YamlNode::Pair& pair : map.pairs) {
      if (std::ranges::find(kContents, pair.key) == kContents.end()) continue;
      if (first == nullptr) {
        first = &pair;
        continue;
      }
      context_.findings
          .Add(Code::kSpecConflict, pair.mark,
               fmt::format("'{}' together with '{}': a body has only one of the two", pair.key,
                           first->key))
          .notes.push_back({first->mark, "first here"});
    }
    if (const YamlNode::Pair* regions = map.FindPair("regions"); regions && map.Find("spec")) {
      context_.findings.Add(Code::kSpecConflict, regions->mark,
                            "'regions' together with 'spec': that spec has its own",
                            "write them into that spec");
    }
    CheckNeeds("params", "spec", map, context_);
    CheckNeeds("materials", "spec", map, context_);
    CheckNeeds("body", "mjcf", map, context_);
  }

  // Declares NAME.top and the other properties of the body and, if the body has `spec:`,
  // NAME.PARAMETER for each parameter of that spec.
  void DeclareProperties(BodyEntry& body) {
    const auto name = LiteralText(body.head.name);
    if (!name || !expr::IsName(*name)) return;
    expr::SymbolTable& names = context_.spec.names;
    const std::string prefix = std::string(*name) + ".";
    if (names.Find(prefix + "top") != nullptr) return;  // declared for another body of this name
    body.first_property = DeclareBodyProperties(prefix, names);
    if (body.head.nested == nullptr) return;
    for (const Parameter& parameter : body.head.nested->parameters) {
      const bool hidden =
          std::ranges::find(BodyPropertyNames(), parameter.name) != BodyPropertyNames().end();
      // A parameter has no slot if it is a list, or if a property of bodies has the same name.
      body.parameter_slots.push_back(
          hidden || parameter.value.is_list
              ? -1
              : Declare(names, prefix + parameter.name, parameter.value).slot);
    }
  }

  // Reads `joints: free`, or stores the list of joints until ReadJoints() is called.
  void BeginJoints(const YamlNode& joints, BodyEntry& body) {
    body.has_joints = true;
    if (joints.kind == YamlNode::Kind::kScalar) {
      body.is_free = IsFreeWord(joints, context_) == true;
      return;
    }
    lists_.push_back({&joints, context_.spec.bodies.size(), {}});
  }

  // Returns the variables of an entry's loops and its local values.
  std::vector<expr::SymbolTable::Variable> VariablesOf(const Entry& entry) const {
    std::vector<expr::SymbolTable::Variable> variables;
    const auto add = [&](std::string_view name) {
      if (const auto* variable = context_.spec.names.Find(name)) variables.push_back(*variable);
    };
    for (const Loop& loop : entry.loops) add(loop.variable);
    for (const Local& local : entry.locals) add(local.name);
    return variables;
  }

  // A list of joints that is not read yet, the index of its body, and the loop variables and local
  // values of the body's entry.
  struct JointList {
    const YamlNode* joints;
    std::size_t body;
    std::vector<expr::SymbolTable::Variable> variables;
  };

  Context& context_;
  EntryReader entries_;
  std::vector<JointList> lists_;
  std::list<YamlNode> corrected_;  // mappings with misspelt keys, as they were probably meant
};

// Checks `parent:` of bodies if the parent's name is a literal. Computed names are known only after
// drawing.
class ParentChecker {
 public:
  explicit ParentChecker(Context& context) : context_(context), bodies_(context.spec.bodies) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const auto name = LiteralText(bodies_[i].head.name);
      if (!name) first_computed_name_ = std::min(first_computed_name_, i);
      if (name && !name->empty()) by_name_[*name].push_back(i);
    }
  }

  void Check() {
    for (const auto& [name, entries] : by_name_) CheckName(name, entries);
    for (std::size_t i = 0; i < bodies_.size(); ++i) CheckParent(i);
  }

 private:
  void CheckName(std::string_view name, const std::vector<std::size_t>& entries) {
    const diag::SourceMark mark = bodies_[entries[0]].head.name.mark;
    if (name == context_.spec.name) {
      context_.findings.Add(
          Code::kSpecDuplicateName, mark,
          fmt::format("body '{}' has the name of the object, which its root body already has",
                      name),
          "an object has one root; give the body another name");
    }
    const Entry* sure = nullptr;
    for (const std::size_t i : entries) {
      const Entry& entry = bodies_[i].head;
      if (entry.condition || !entry.loops.empty()) continue;
      if (sure != nullptr) {
        context_.findings
            .Add(Code::kSpecDuplicateName, entry.name.mark,
                 fmt::format("two bodies are named '{}'", name))
            .notes.push_back({sure->name.mark, "the other one"});
        return;
      }
      sure = &entry;
    }
  }

  std::optional<std::string_view> ParentOf(std::size_t i) const {
    const Field* parent = bodies_[i].head.Find(Key::kParent);
    return parent == nullptr ? std::nullopt : LiteralText(parent->value);
  }

  void CheckParent(std::size_t i) {
    const auto parent = ParentOf(i);
    if (!parent || *parent == context_.spec.name) return;
    const diag::SourceMark mark = bodies_[i].head.Find(Key::kParent)->value.mark;
    const auto found = by_name_.find(*parent);
    if (found == by_name_.end()) {
      if (!MayComeLater(*parent, i)) ReportUnknown(*parent, mark);
      return;
    }
    if (found->second.front() < i) return;
    if (found->second.front() == i) {
      context_.findings.Add(Code::kSpecBadParent, mark,
                            fmt::format("body '{}' is its own parent", *parent));
      return;
    }
    ReportForward(i, found->second.front(), mark);
  }

  // Returns true if an entry before entry `i` may create a body named `parent`: an entry whose name
  // is computed, or an entry NAME if `parent` has the form NAME_..., because the spec or file of
  // NAME may contain such a body.
  bool MayComeLater(std::string_view parent, std::size_t i) const {
    if (first_computed_name_ < i) return true;
    for (std::size_t k = 0; k < i; ++k) {
      const auto name = LiteralText(bodies_[k].head.name);
      if (name && parent.starts_with(*name) && parent.substr(name->size()).starts_with("_")) {
        return true;  // checked after assembly, when bodies inside a spec or file are known
      }
    }
    return false;
  }

  void ReportUnknown(std::string_view parent, diag::SourceMark mark) {
    std::vector<std::string_view> names = {context_.spec.name};
    for (const auto& [name, entries] : by_name_) names.push_back(name);
    context_.findings.Add(Code::kSpecBadParent, mark, fmt::format("no body '{}'", parent),
                          diag::DidYouMean(parent, names));
  }

  // Reports that the parent of entry `i`, the entry with index `parent`, comes after its child, or
  // that bodies are parents of each other.
  void ReportForward(std::size_t i, std::size_t parent, diag::SourceMark mark) {
    const std::string name(LiteralText(bodies_[i].head.name).value_or("?"));
    std::string circle = name;
    std::size_t at = parent;
    for (std::size_t steps = 0; steps <= bodies_.size(); ++steps) {
      const auto next = ParentOf(at);
      circle += fmt::format(" -> {}", LiteralText(bodies_[at].head.name).value_or("?"));
      if (at == i) {
        context_.findings
            .Add(Code::kSpecBadParent, mark,
                 fmt::format("the parents of bodies form a circle: {}", circle))
            .notes.push_back({bodies_[parent].head.name.mark, "the other one"});
        return;
      }
      const auto found = next ? by_name_.find(*next) : by_name_.end();
      if (found == by_name_.end()) break;
      at = found->second.front();
    }
    context_.findings
        .Add(Code::kSpecBadParent, mark,
             fmt::format("body '{}' comes after its child '{}'",
                         LiteralText(bodies_[parent].head.name).value_or("?"), name),
             "put parents before children")
        .notes.push_back({bodies_[parent].head.name.mark, "it is here"});
  }

  Context& context_;
  const std::vector<BodyEntry>& bodies_;
  std::map<std::string_view, std::vector<std::size_t>> by_name_;
  // Index of the first entry with a computed name; the largest number if there is none.
  std::size_t first_computed_name_ = static_cast<std::size_t>(-1);
};

}  // namespace

std::span<const std::string_view> BodyPropertyNames() {
  static constexpr std::array<std::string_view, 7> kNames = {"top",    "bottom", "radius", "half_x",
                                                             "half_y", "half_z", "mass"};
  return kNames;
}

int DeclareBodyProperties(const std::string& prefix, expr::SymbolTable& names) {
  int first = -1;
  for (const std::string_view property : BodyPropertyNames()) {
    const Key key = property == "mass" ? Key::kMass : Key::kPos;
    const auto unit = DimensionsOf(kBodyElement.Find(key)->unit);
    const int slot =
        names.Declare(prefix + std::string(property), expr::Type::kNumber, 1, *unit).slot;
    if (first < 0) first = slot;
  }
  return first;
}

void ReadBodiesAndJoints(const YamlNode* bodies, const YamlNode* joints, Context& context) {
  BodyEntryReader reader(context);
  if (bodies != nullptr && IsList(*bodies, "bodies", context)) {
    for (const YamlNode& item : bodies->items) {
      if (IsMap(item, "a body's keys", context)) reader.Read(item);
    }
  }
  std::vector<const YamlNode*> lists = reader.joint_lists();
  if (joints != nullptr) lists.push_back(joints);
  DeclareWholeProperties(lists, context);
  if (joints != nullptr) ReadJoints(*joints, context);
  reader.ReadJoints();
  if (bodies != nullptr) ParentChecker(context).Check();
}

}  // namespace mjforge::spec
