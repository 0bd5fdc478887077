// C interface of the library that the Python package loads with ctypes, for every version of
// Python.
//
// No function throws. The package declares the same structs in _library.py. Texts are UTF-8. Input
// texts end with a zero byte. Output texts have a size and are valid until the next call with the
// same maker, table, archive or manifest. Such an object is for one thread at a time; different
// objects are independent.
#pragma once

#include <cstddef>
#include <cstdint>

extern "C" {

struct MjforgeText {
  const char* data;
  std::size_t size;
};

/// A spec and the texts of its files, which are added as files are read. Threads may share it.
struct MjforgeSnapshot;

/// A spec with settings, and the options for its variants. `target`, `assets`, `sampler`,
/// `on_invalid` and `validate` have the values of these options of `mjforge generate`.
struct MjforgeRequest {
  MjforgeSnapshot* snapshot;
  const char* const* settings;  // name, value, name, value, ...
  std::size_t setting_count;    // number of pairs
  const char* const* parameter_files;
  std::size_t parameter_file_count;
  const char* name;  // name of the object; empty: the spec's name
  const char* target;
  const char* assets;
  const char* sampler;
  const char* on_invalid;
  const char* validate;
  std::uint64_t seed;
  std::uint64_t batch;              // number of variants; 0: unknown, an error if draws need it
  const std::uint64_t* place_seed;  // seed of the places alone; null: they follow from `seed`
};

struct MjforgeVariant {
  MjforgeText xml;       // empty if the variant failed
  MjforgeText record;    // JSON: the line of a manifest
  MjforgeText findings;  // JSON, see MjforgeFindings; empty: none
  MjforgeText files;     // JSON: [[name in the XML, path, size], ...]; empty: none
  MjforgeText contents;  // concatenated contents, with these sizes, of the files without a path
  MjforgeText
      inputs;     // JSON: [[path, SHA-256], ...] of files that are new to this maker; empty: none
  double box[6];  // `aabb` of the record: min x, y, z, max x, y, z
};

/// Makes a snapshot of a spec: `reference`, a file or a name in the search path, whose last folder
/// is `catalogue`; or, if `reference` is null, the YAML text `text`. Reads no file, unless
/// `reference` is a snapshot's file. Returns null if there is not enough memory.
MjforgeSnapshot* MjforgeNewSnapshot(const char* reference, const char* text, const char* catalogue);
/// Makes a snapshot from a text of MjforgeSnapshotText. Returns null if the text is damaged.
MjforgeSnapshot* MjforgeReadSnapshot(const char* text, std::size_t size);
void MjforgeCloseSnapshot(MjforgeSnapshot* snapshot);
/// Returns the snapshot as JSON, valid until the next call in this thread. At least one spec must
/// have been loaded without errors.
MjforgeText MjforgeSnapshotText(MjforgeSnapshot* snapshot);
/// Returns the words of each option as JSON: {"target": ["mujoco", ...], ...}.
MjforgeText MjforgeWords();

struct MjforgeMaker;

/// Loads a spec. Returns null only if there is not enough memory.
MjforgeMaker* MjforgeOpen(const MjforgeRequest* request);
void MjforgeClose(MjforgeMaker* maker);
/// Returns the last error that has no place in a spec: an unknown word in a request, or not enough
/// memory. Empty if there was none.
MjforgeText MjforgeFailure(MjforgeMaker* maker);
/// Returns the findings of loading the spec as JSON: [[finding as with --findings json, its text],
/// ...]. If any finding is an error, no variant can be made.
MjforgeText MjforgeFindings(MjforgeMaker* maker);
/// Describes a spec without errors as JSON: {"name", "description", "sha256", "path" (null for a
/// text), "view" (see ViewJson), "parameters" (see WriteParameters)}.
MjforgeText MjforgeDescription(MjforgeMaker* maker);
/// Makes a variant and replaces `variant`. Returns 0 on success, 1 if the variant failed for the
/// reason in its findings, 2 if the reason is MjforgeFailure.
int MjforgeMake(MjforgeMaker* maker, std::uint64_t index, MjforgeVariant* variant);

struct MjforgeTable;

/// Opens a table of members of records. Returns null only if there is not enough memory.
MjforgeTable* MjforgeOpenTable(const char* const* members, std::size_t count);
void MjforgeCloseTable(MjforgeTable* table);
/// Makes at most `count` variants with the indices index, index + step, ... and stops at the first
/// variant that fails. Adds the records of the variants before the failure to a table, and returns
/// the number of these records. Sets `inputs` like MjforgeVariant::inputs.
std::size_t MjforgeMakeRows(MjforgeMaker* maker, std::uint64_t index, std::uint64_t step,
                            std::size_t count, MjforgeTable* table, MjforgeText* inputs);
/// Adds a record, a line of a manifest. Returns 0 on success, 1 if it is not a JSON object, 2 if
/// there is not enough memory.
int MjforgeAddRecord(MjforgeTable* table, const char* record, std::size_t size);
/// Returns [number of rows, texts, columns] as JSON; empty if there is not enough memory. A column
/// is [key, kinds, inner columns], with the kinds of manifest::Column. Columns are numbered from 0,
/// each before its inner columns.
MjforgeText MjforgeLayout(MjforgeTable* table);
/// Returns the kinds or the values of column number `column` in the last MjforgeLayout, one for
/// each row.
const char* MjforgeKinds(MjforgeTable* table, std::size_t column);
const std::uint64_t* MjforgeValues(MjforgeTable* table, std::size_t column);

struct MjforgeArchive;

/// Opens an archive of a batch, to read its members one after the other. Returns null only if there
/// is not enough memory.
MjforgeArchive* MjforgeOpenArchive(const char* file);
void MjforgeCloseArchive(MjforgeArchive* archive);
/// Reads the next member. Returns 0 on success, 1 at the end, 2 if reading fails; `content` is then
/// the reason.
int MjforgeNextMember(MjforgeArchive* archive, MjforgeText* name, MjforgeText* content);

struct MjforgeLines;

/// Opens a manifest, plain or compressed, to read its lines. Returns null only if there is not
/// enough memory.
MjforgeLines* MjforgeOpenLines(const char* file);
void MjforgeCloseLines(MjforgeLines* lines);
/// Reads the next line, without its end. Returns 0 on success, 1 at the end, 2 if reading fails;
/// `line` is then the reason. Returns 3 at the end of a file that was cut off within a line or a
/// frame.
int MjforgeNextLine(MjforgeLines* lines, MjforgeText* line);

/// Returns the elements of an MJCF text as JSON: [tag, {attribute: value}, [child, ...]].
/// Attributes that consist of numbers become numbers or lists of numbers. Empty if the text is not
/// XML. Valid until the next call in this thread.
MjforgeText MjforgeElements(const char* mjcf, std::size_t size);
/// Returns the specs in the search path, whose last folder is `catalogue`, as JSON: [[name, path],
/// ...]. The text is valid until the next call in this thread.
MjforgeText MjforgeCatalogue(const char* catalogue);
/// Returns the path of the manifest of a shard (0 of 1: of the whole batch) that the command writes
/// with `-o output`; empty if it writes none. The text is valid until the next call in this thread.
MjforgeText MjforgeManifest(const char* output, std::uint64_t shard, std::uint64_t shards);
/// Returns the version of mjforge, such as "0.1.0".
const char* MjforgeVersion();

}  // extern "C"
