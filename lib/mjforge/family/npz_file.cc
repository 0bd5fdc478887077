// Writer of a family's .npz file: converts rows, each with all numbers of one variant, into arrays
// that each have one entry per variant.

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>

#include "mjforge/expr/expr.h"
#include "mjforge/family/family.h"
#include "mjforge/family/final_base.h"

namespace mjforge::family {
namespace {

using output::ArrayType;

// Returns true if one of the `count` flags from the index `first` on is set.
template <typename Flags>
bool IsAnySet(const Flags& flags, std::size_t first, std::size_t count) {
  const auto begin = flags.begin() + static_cast<std::ptrdiff_t>(first);
  return std::any_of(begin, begin + static_cast<std::ptrdiff_t>(count), std::identity());
}

class FamilyFile {
 public:
  /// Requires that the family of `header` is selected in all `files` (RowsFile::Select).
  FamilyFile(std::span<RowsFile> files, const Header& header, const Facts& facts,
             diag::Findings& findings)
      : files_(files),
        header_(header),
        facts_(facts),
        findings_(findings),
        survey_(SurveyOf(files_)) {
    for (const RowsFile& file : files_) {
      for (const bytes::Asset& asset : file.assets()) AddAsset(asset);
    }
  }

  bool Write(output::PartFile& part) {
    const std::optional<FinalBase> base = Complete(header_, assets_, survey_, findings_);
    if (!base) return false;
    base_ = *base;
    Warn();
    output::NpzWriter npz(part, findings_);
    npz_ = &npz;
    WriteBytes(kFirstMember, FactsText());
    WriteBytes("base", base_.text);
    for (const bytes::Asset& asset : assets_) WriteBytes(asset.name, *asset.made);
    std::size_t at = 0;
    for (const ArrayShape& shape : header_.shapes) {
      if (shape.type != ArrayShape::Type::kFlag) WriteArray(shape, at);
      at += shape.size();
    }
    WriteMaterials();
    for (std::size_t i = 0; i < survey_.parameters.size(); ++i) WriteParameter(i);
    return npz.Finish();
  }

 private:
  void AddAsset(const bytes::Asset& asset) {
    const bool is_used = header_.base.find('"' + asset.name + '"') != std::string::npos;
    if (is_used && std::ranges::find(assets_, asset.name, &bytes::Asset::name) == assets_.end())
      assets_.push_back(asset);
  }

  void Warn() {
    for (const std::string& name : survey_.other_textures) {
      findings_.Warn(diag::Code::kFamilyTexture, {},
                     "the texture of material '" + name + "' differs between the variants",
                     "worlds share textures: the base has that of the first variant");
    }
  }

  // Returns the object's name, which is the name of the base's model.
  std::string_view NameOfModel() const {
    std::string_view name = header_.base;
    constexpr std::string_view kStart = "<mujoco model=\"";
    name.remove_prefix(name.find(kStart) + kStart.size());
    return name.substr(0, name.find('"'));
  }

  std::string FactsText() const {
    return diag::JsonObject(nullptr,
                            [&](diag::Json& json) {
                              json.Member("mjforge_family", 1);
                              json.Member("name", NameOfModel());
                              for (const auto& [name, value] : facts_.members) {
                                json.Key(name);
                                json.Raw(value);
                              }
                              json.Member("structure", header_.structure.FamilyKey());
                              json.Member("variants", survey_.count);
                              json.Object("moved", [&] {
                                for (const auto& [array, elements] : base_.moved) {
                                  const ArrayShape& shape = header_.Find(array).first;
                                  json.List(array, elements,
                                            [&](std::size_t i) { json.Value(shape.elements[i]); });
                                }
                              });
                            }) +
           '\n';
  }

  void WriteBytes(std::string_view name, std::string_view bytes) {
    const std::uint64_t shape[] = {bytes.size()};
    npz_->Begin(std::string(name), ArrayType::kByte, shape);
    npz_->Write(bytes);
  }

  void WriteTexts(const std::string& name, const std::vector<std::string>& texts) {
    std::size_t longest = 1;
    for (const std::string& text : texts) longest = std::max(longest, output::CodePoints(text));
    const std::uint64_t shape[] = {texts.size()};
    npz_->Begin(name, ArrayType::kText, shape, longest);
    for (const std::string& text : texts) npz_->Write(output::Utf32Of(text, longest));
  }

  void WriteArray(const ArrayShape& shape, std::size_t at) {
    if (shape.elements.empty()) {
      if (shape.is_always_stored || IsAnySet(survey_.varies, at, shape.size()))
        WriteWhole(shape, at);
      return;
    }
    std::vector<std::size_t> stored;
    const auto moved = base_.moved.find(shape.name);
    for (std::size_t i = 0; i < shape.elements.size(); ++i) {
      const bool is_moved = moved != base_.moved.end() && moved->second.contains(i);
      if (is_moved || IsAnySet(survey_.varies, at + shape.width() * i, shape.width()))
        stored.push_back(i);
    }
    if (std::ranges::any_of(stored, [&](std::size_t i) { return shape.elements[i].empty(); })) {
      // Elements without names are told apart by their order: stores all or none.
      stored.clear();
      for (std::size_t i = 0; i < shape.elements.size(); ++i) stored.push_back(i);
    }
    if (!stored.empty()) WriteElements(shape, at, stored);
  }

  void WriteWhole(const ArrayShape& shape, std::size_t at) {
    std::vector<std::uint64_t> dims = {survey_.count};
    dims.insert(dims.end(), shape.dims.begin(), shape.dims.end());
    const bool is_index = shape.type == ArrayShape::Type::kIndex;
    npz_->Begin(shape.name, is_index ? ArrayType::kUint64 : ArrayType::kFloat64, dims);
    for (RowsFile& file : files_) {
      file.ForEachPart(at, shape.size(),
                       [&](std::span<const double> numbers) { npz_->Write(numbers); });
    }
  }

  // Writes the numbers of the elements `stored` in all variants, then the names of these elements.
  void WriteElements(const ArrayShape& shape, std::size_t at,
                     const std::vector<std::size_t>& stored) {
    std::vector<std::uint64_t> dims = {survey_.count, stored.size()};
    dims.insert(dims.end(), shape.dims.begin() + 1, shape.dims.end());
    if (shape.type == ArrayShape::Type::kMaterial) {
      WriteMaterialIds(shape, at, stored, dims);
    } else {
      npz_->Begin(shape.name, ArrayType::kFloat64, dims);
      const std::size_t width = shape.width();
      const std::size_t first = at + width * stored.front();
      const std::size_t count = width * (stored.back() - stored.front() + 1);
      for (RowsFile& file : files_) {
        file.ForEachPart(first, count, [&](std::span<const double> numbers) {
          for (const std::size_t i : stored)
            npz_->Write(numbers.subspan(width * (i - stored.front()), width));
        });
      }
    }
    WriteTexts(shape.name + ".names",
               diag::Mapped<std::string>(stored, [&](std::size_t i) { return shape.elements[i]; }));
    if (shape.components.empty()) return;
    const std::uint64_t count[] = {stored.size()};
    npz_->Begin(shape.name + ".components", ArrayType::kInt32, count);
    for (const std::size_t i : stored) WriteInteger(static_cast<std::int32_t>(shape.components[i]));
  }

  // Calls `visit` with each variant of all files.
  template <typename Visit>
  void ForEachRow(const Visit& visit) {
    for (RowsFile& file : files_) file.ForEach(visit);
  }

  void WriteInteger(std::int32_t number) {
    npz_->Write(std::string_view(reinterpret_cast<const char*>(&number), sizeof(number)));
  }

  void WriteMaterialIds(const ArrayShape& shape, std::size_t at,
                        const std::vector<std::size_t>& stored,
                        const std::vector<std::uint64_t>& dims) {
    npz_->Begin(shape.name, ArrayType::kInt32, dims);
    ForEachRow([&](const RowView& row) {
      for (const std::size_t i : stored)
        WriteInteger(static_cast<std::int32_t>(survey_.MaterialId(row, row.values[at + i])));
    });
  }

  // Writes the names of all materials, and arrays with the numbers of those materials whose numbers
  // vary between variants. For a variant that lacks a material, writes the numbers of the first
  // variant with that material.
  void WriteMaterials() {
    if (survey_.materials.empty()) return;
    WriteTexts("materials", diag::Mapped<std::string>(survey_.materials, &Material::name));
    std::size_t at = 0;
    for (const auto& [name, width] : kMaterialArrays) {
      WriteLooks(std::string(name), at, width);
      at += width;
    }
  }

  void WriteLooks(const std::string& name, std::size_t at, std::size_t width) {
    std::vector<std::size_t> stored;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < survey_.materials.size(); ++i) {
      if (!IsAnySet(survey_.material_varies[i], at, width)) continue;
      stored.push_back(i);
      names.push_back(survey_.materials[i].name);
    }
    if (stored.empty()) return;
    std::vector<std::uint64_t> dims = {survey_.count, stored.size()};
    if (width > 1) dims.push_back(width);
    npz_->Begin(name, ArrayType::kFloat64, dims);
    ForEachRow([&](const RowView& row) {
      for (const std::size_t i : stored) {
        const Material& material = survey_.materials[i];
        const auto has = std::ranges::find(row.materials, material.name,
                                           [](const Material* m) { return m->name; });
        const auto& numbers =
            has == row.materials.end()
                ? material.numbers
                : row.material_numbers[static_cast<std::size_t>(has - row.materials.begin())];
        npz_->Write(std::span(numbers).subspan(at, width));
      }
    });
    WriteTexts(name + ".names", names);
  }

  void WriteParameter(std::size_t number) {
    const Survey::Parameter& parameter = survey_.parameters[number];
    constexpr ArrayType kTypes[] = {ArrayType::kFloat64, ArrayType::kBool, ArrayType::kText,
                                    ArrayType::kFloat64, ArrayType::kText, ArrayType::kBool};
    constexpr std::size_t kFirstList = 3;
    std::vector<std::uint64_t> dims;
    if (parameter.varies) dims.push_back(survey_.count);
    if (parameter.kind >= kFirstList) dims.push_back(parameter.length);
    npz_->Begin((parameter.varies ? "params/" : "constants/") + parameter.name,
                kTypes[parameter.kind], dims, std::max<std::uint64_t>(parameter.code_points, 1));
    if (!parameter.varies) return WriteValue(parameter.first, parameter);
    ForEachRow([&](const RowView& row) { WriteValue(row.parameters[number], parameter); });
  }

  // Writes the value of a parameter. Fills up a list that is shorter than the parameter's longest
  // list with NaN, empty texts or false.
  void WriteValue(const sample::ParameterValue& value, const Survey::Parameter& parameter) {
    const std::size_t code_points = std::max<std::uint64_t>(parameter.code_points, 1);
    const auto write = [&](const auto& one) {
      using One = std::decay_t<decltype(one)>;
      if constexpr (std::is_same_v<One, double>) npz_->Write(std::span(&one, 1));
      if constexpr (std::is_same_v<One, bool>) npz_->Write(std::string_view(one ? "\1" : "\0", 1));
      if constexpr (std::is_same_v<One, std::string>)
        npz_->Write(output::Utf32Of(one, code_points));
    };
    std::visit(
        [&](const auto& held) {
          using Held = std::decay_t<decltype(held)>;
          if constexpr (requires(Held list) { list.push_back({}); } &&
                        !std::is_same_v<Held, std::string>) {
            using One = typename Held::value_type;
            One filler{};
            if constexpr (std::is_same_v<One, double>)
              filler = std::numeric_limits<double>::quiet_NaN();
            for (std::size_t i = 0; i < parameter.length; ++i)
              write(i < held.size() ? One(held[i]) : filler);
          } else {
            write(held);
          }
        },
        value);
  }

  std::span<RowsFile> files_;
  const Header& header_;
  const Facts& facts_;
  diag::Findings& findings_;
  Survey survey_;
  bytes::Assets assets_;
  FinalBase base_;
  output::NpzWriter* npz_ = nullptr;
};

// Returns the first header of each family in the files, in the order of the files.
std::vector<Header> HeadersOf(std::span<const RowsFile> files) {
  std::vector<Header> headers;
  for (const RowsFile& file : files) {
    for (Header& header : file.Headers()) {
      const auto is_it = [&](const Header& known) { return DifferenceOf(header, known).empty(); };
      if (std::ranges::none_of(headers, is_it)) headers.push_back(std::move(header));
    }
  }
  return headers;
}

using Parts = std::vector<std::unique_ptr<output::PartFile>>;

// Writes the files of all families; returns false after adding a finding.
bool WriteAll(std::span<RowsFile> files, const Facts& facts,
              const std::function<std::filesystem::path(const std::string&)>& place, Parts& parts,
              diag::Findings& findings) {
  const std::vector<Header> headers = HeadersOf(files);
  if (headers.empty()) {
    findings.Add(diag::Code::kBatchMissing, {}, "the family has no valid variant",
                 "the manifest says why");
  }
  std::set<std::filesystem::path> places;
  for (const Header& header : headers) {
    const std::filesystem::path file = place(header.structure.FamilyKey());
    if (!places.insert(file).second) {
      findings.Add(diag::Code::kBatchDiffers, {},
                   "the variants for '" + file.string() +
                       "' are of several families: " + DifferenceOf(header, headers.front()),
                   "set the parameter that decides it with --set");
      return false;
    }
    const auto& part = parts.emplace_back(output::PartFile::Open(file, findings));
    for (RowsFile& rows : files) rows.Select(header);
    if (!part || !part->Truncate(0, findings) ||
        !FamilyFile(files, header, facts, findings).Write(*part))
      return false;
  }
  return !findings.HasErrors();
}

}  // namespace

Parts WriteNpz(std::span<const std::filesystem::path> rows, const Facts& facts,
               const std::function<std::filesystem::path(const std::string&)>& place,
               diag::Findings& findings) {
  const std::filesystem::path* current = rows.data();
  Parts parts;
  bool is_good = false;
  try {
    std::vector<RowsFile> files;
    files.reserve(rows.size());
    for (; current != rows.data() + rows.size(); ++current) files.emplace_back(*current);
    is_good = WriteAll(files, facts, place, parts, findings);
  } catch (const std::runtime_error& error) {
    const std::filesystem::path& file =
        current == rows.data() + rows.size() ? rows.front() : *current;
    findings.Add(diag::Code::kYamlCannotRead, {},
                 "cannot read '" + file.string() + "': " + error.what());
  }
  if (is_good) return parts;
  for (const auto& part : parts) {
    if (part) part->Drop();
  }
  return {};
}

}  // namespace mjforge::family
