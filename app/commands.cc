// Names, descriptions and examples of the commands.
#include "commands.h"

#include <CLI/CLI.hpp>

#include "options.h"

namespace mjforge::app {
namespace {

struct Command {
  const char* name;
  const char* description;
  Action (*add)(CLI::App& command);
  const char* examples;
};

constexpr Command kCommands[] = {
    {"generate", "Make variants of objects", AddGenerate,
     "  mjforge generate hammer -n 100 --set 'handle_length=28cm .. 30cm' -o out/"},
    {"check", "Find mistakes in specs; writes nothing", AddCheck,
     "  mjforge check mug.yaml\n"
     "  mjforge check specs/*.yaml -n 100 --findings json\n"
     "  mjforge check mug.yaml --physics --set checks.stable=true"},
    {"inspect", "Show parameters and one variant, or a batch", AddInspect,
     "  mjforge inspect hammer\n"
     "  mjforge inspect hammer --index 41 --seed 7 --json\n"
     "  mjforge inspect hammer --contains 0,0,0.05\n"
     "  mjforge inspect robot.xml --sweep\n"
     "  mjforge inspect out/hammer_000041.xml\n"
     "  mjforge inspect out/ --json"},
    {"validate", "Load MJCF files in MuJoCo", AddValidate,
     "  mjforge validate out/*.xml\n"
     "  mjforge validate robot.xml --json\n"
     "  mjforge validate mug.xml --physics --set checks.stable=true"},
    {"preview", "Draw an object, or a sheet of variants", AddPreview,
     "  mjforge preview hammer -n 16 -o hammers.png\n"
     "  mjforge preview hinged_box --joint hinge=45deg\n"
     "  mjforge preview lamp.yaml --watch -o lamp.png\n"
     "  mjforge preview faucet --sweep -o faucet.gif --size 320\n"
     "  mjforge preview robot.xml --layer collision --azimuth 90 --elevation -20"},
    {"customize", "Serve a page to change parameters and see it", AddCustomize,
     "  mjforge customize hammer\n"
     "  mjforge customize lamp.yaml --set height=30cm --seed 7\n"
     "  mjforge customize mug --no-open --port 8080"},
    {"view", "Open an object in MuJoCo's own viewer", AddView,
     "  mjforge view hammer --index 41\n"
     "  mjforge view robot.xml"},
    {"report", "Make an HTML page about a batch", AddReport,
     "  mjforge report out/\n"
     "  mjforge report hammers.tar.zst -o hammers.html\n"
     "  mjforge report out/ --thumbnails 1000\n"
     "  mjforge report out/.manifest.jsonl.part -o - > so_far.html"},
    {"merge", "Join the manifests of all shards of a batch", AddMerge,
     "  mjforge merge out/\n"
     "  mjforge merge 'hammers_%05d.tar.zst'"},
    {"verify", "Read a batch again: is all as it was made?", AddVerify,
     "  mjforge verify out/\n"
     "  mjforge verify hammers.manifest.jsonl.zst\n"
     "  mjforge verify hammers_00003.tar.zst"},
    {"replay", "Regenerate a variant and compare the bytes", AddReplay,
     "  mjforge replay out/manifest.jsonl:42\n"
     "  mjforge replay hammers.manifest.jsonl.zst:7777777\n"
     "  mjforge replay out/hammer_000042.xml --spec old/hammer.yaml"},
    {"new", "Write a spec to start from, or a copy of another one", AddNew,
     "  mjforge new lamp.yaml\n"
     "  mjforge new my_chair.yaml --like furniture/chair"},
    {"catalogue", "List the specs that can be used by name", AddCatalogue,
     "  mjforge catalogue\n"
     "  mjforge catalogue lid hinge\n"
     "  mjforge catalogue --html gallery/\n"
     "  MJFORGE_PATH=~/my-specs mjforge catalogue --json"},
    {"schema", "Print a JSON Schema", AddSchema,
     "  mjforge schema > object.schema.json\n"
     "  mjforge schema manifest"},
};

}  // namespace

std::vector<std::pair<CLI::App*, Action>> AddCommands(CLI::App& app, MessageOptions& report) {
  std::vector<std::pair<CLI::App*, Action>> commands;
  for (const Command& row : kCommands) {
    CLI::App& command = *app.add_subcommand(row.name, row.description);
    commands.emplace_back(&command, row.add(command));
    AddMessageOptions(command, report);
    command.footer(std::string("Examples:\n") + row.examples);
  }
  return commands;
}

}  // namespace mjforge::app
