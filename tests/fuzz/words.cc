// Prints a dictionary for libFuzzer, from what the program knows:
//   mjforge_fuzz_words TARGET

#include <iostream>
#include <set>
#include <string>
#include <string_view>

#include "mjforge/expr/expr.h"
#include "mjforge/manifest/manifest.h"
#include "mjforge/spec/distributions.h"
#include "mjforge/spec/spec.h"

namespace mjforge::fuzz {
namespace {

using Dictionary = std::set<std::string, std::less<>>;

void AddWords(std::string_view text, Dictionary& words) {
  for (const std::string_view word : expr::WordsOf(text)) words.emplace(word);
}

void AddElement(const spec::ElementInfo& element, Dictionary& words) {
  words.emplace(element.name);
  for (const spec::FieldInfo& field : element.fields) {
    words.emplace(field.key);
    AddWords(field.words, words);
  }
  for (const spec::ElementInfo& child : element.children) AddElement(child, words);
}

void AddExpressions(Dictionary& words) {
  for (const expr::BuiltinInfo& function : expr::Builtins()) words.emplace(function.name);
  for (const expr::Unit& unit : expr::Units()) words.emplace("1" + std::string(unit.name));
  AddWords("== != <= >= < > + - * / % ** ^ ( ) [ ] , ? : ' \" and or not if else true false 1e308",
           words);
  AddWords("r size.x size.y size.z flag word index 0x1F 0o17 1e-3", words);
}

void AddMjcf(Dictionary& words) {
  for (const spec::SectionInfo& section : spec::Sections()) {
    words.emplace(section.name);
    for (const spec::ElementInfo& element : section.elements) AddElement(element, words);
  }
  AddElement(spec::kPartElement, words);
  AddElement(spec::kSiteElement, words);
  AddElement(spec::kJointElement, words);
  AddElement(spec::kMaterialElement, words);
  AddElement(spec::kTextureElement, words);
}

void AddSpec(Dictionary& words) {
  AddMjcf(words);
  AddExpressions(words);
  for (const spec::ElementInfo* element : spec::AllElements()) AddElement(*element, words);
  for (const spec::DistributionInfo& draw : spec::Distributions()) {
    words.emplace(draw.key);
    words.emplace(draw.option);
    words.emplace(draw.flag);
  }
  for (const std::string_view name : spec::BodyPropertyNames()) words.emplace(name);
  AddWords("${ } .. ~ | > & * ! #set= !!str <<:", words);
}

void AddXml(Dictionary& words) {
  AddMjcf(words);
  AddWords("<mujoco> </mujoco> <worldbody> <body <geom <joint <default <compiler <include <!-- -->",
           words);
  AddWords("<asset> <mesh <texture <composite <replicate <freejoint/> /> <![CDATA[ ]]> &lt; &#0;",
           words);
  AddWords("<frame count= offset= sep= fromto= euler= axisangle= xyaxes= zaxis= quat= eulerseq",
           words);
  AddWords("meshdir texturedir strippath fusestatic balanceinertia boundmass coordinate global",
           words);
  AddWords("childclass class file= name= seed= index= set: %20 sha256=", words);
}

// Every text of a JSON Schema: keys and words of what it describes.
void AddSchema(std::string_view schema, Dictionary& words) {
  while (true) {
    const std::size_t begin = schema.find('"');
    const std::size_t end = begin == schema.npos ? schema.npos : schema.find('"', begin + 1);
    if (end == schema.npos) return;
    const std::string_view text = schema.substr(begin + 1, end - begin - 1);
    if (expr::IsName(text)) words.emplace(text);
    schema.remove_prefix(end + 1);
  }
}

void AddBatch(Dictionary& words) {
  AddSchema(manifest::ManifestSchema(), words);
  AddWords(
      "mjforge_seal name output per_archive first count shard shards records manifest archives",
      words);
  AddWords("file bytes xxh128 assets mjforge-journal closed made made-asset asset at", words);
  AddWords(
      "@own@ @part:@ @manifest:@ @archive:@ @archivepart:@ 18446744073709551615 -1 null true "
      "1e999",
      words);
}

void AddMesh(Dictionary& words) {
  AddWords("solid facet normal outer loop vertex endloop endfacet endsolid", words);
  AddWords("v vn vt f o g s l p mtllib usemtl 1/1/1 1//1 -1 nan inf 1e40", words);
}

Dictionary WordsFor(std::string_view target) {
  Dictionary words;
  if (target == "expression") AddExpressions(words);
  if (target == "spec") AddSpec(words);
  if (target == "mjcf" || target == "xml") AddXml(words);
  if (target == "manifest" || target == "resume" || target == "seal") AddBatch(words);
  if (target == "mesh") AddMesh(words);
  if (target == "archive") AddWords("ustar x_000000.xml path= size= 11 GNU.sparse.map=", words);
  words.erase("");
  return words;
}

}  // namespace
}  // namespace mjforge::fuzz

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  for (const std::string& word : mjforge::fuzz::WordsFor(argv[1])) {
    std::cout << '"';
    for (const char c : word) {
      if (c == '"' || c == '\\') std::cout << '\\';
      std::cout << c;
    }
    std::cout << "\"\n";
  }
  return 0;
}
