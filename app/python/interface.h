#pragma once

// What the Python package calls: functions and plain structs, without exceptions. It works with
// every Python, because it knows none. The package has the same structs in _library.py.
//
// Texts are UTF-8. Those that go in end with a zero byte; those that come out have a size and live
// until the next call with the same maker. Different makers may be used by different threads at the
// same time; one maker, by one thread.

#include <cstddef>
#include <cstdint>

extern "C" {

struct MjforgeText {
  const char* data;
  std::size_t size;
};

/// Which family: a spec with settings, and how its variants are made. Words are those of the
/// command's options.
struct MjforgeRequest {
  const char* spec;             // a file or a name in the search path; null: `text` is the spec
  const char* text;             // YAML
  const char* text_name;        // of `text`, in findings
  const char* catalogue;        // folder of the bundled specs, the last of the search path
  const char* const* settings;  // name, value, name, value, ...
  std::size_t setting_count;    // pairs
  const char* const* parameter_files;
  std::size_t parameter_file_count;
  const char* name;  // of the object; empty: the spec's
  const char* target;
  const char* assets;
  const char* sampler;
  const char* on_invalid;
  const char* validate;
  std::uint64_t seed;
  std::uint64_t batch;  // 0: not known
};

/// One variant.
struct MjforgeVariant {
  MjforgeText xml;       // empty unless it was made
  MjforgeText record;    // JSON, as a line of a manifest
  MjforgeText findings;  // JSON, as MjforgeFindings; empty: none
  MjforgeText files;     // JSON, [[name in the XML, path, size], ...]; empty: none
  MjforgeText contents;  // of those without a path, one after the other, so many bytes of each
};

struct MjforgeMaker;

/// Loads a spec. Null only if there is too little memory.
MjforgeMaker* MjforgeOpen(const MjforgeRequest* request);
void MjforgeClose(MjforgeMaker* maker);
/// What went wrong in the last call and has no place in a spec: an unknown word in a request, too
/// little memory. Empty: nothing.
MjforgeText MjforgeFailure(MjforgeMaker* maker);
/// Of the loading: JSON, [[finding as the command's --findings json, its text], ...]. With an
/// error among them nothing can be made.
MjforgeText MjforgeFindings(MjforgeMaker* maker);
/// Of a spec without errors: JSON, {"name", "description", "parameters": [{"name", "unit",
/// "doc"}]}.
MjforgeText MjforgeDescription(MjforgeMaker* maker);
/// Replaces `variant`. 0: it was made; 1: its findings say why it was not; 2: MjforgeFailure does.
int MjforgeMake(MjforgeMaker* maker, std::uint64_t index, MjforgeVariant* variant);

/// Names of the specs in a folder: JSON, a list; lives until the thread's next call.
MjforgeText MjforgeCatalogue(const char* folder);
/// "0.1.0"
const char* MjforgeVersion();

}  // extern "C"
