// Tables of records behind the C interface.
#pragma once

#include <string>
#include <vector>

#include "interface.h"
#include "mjforge/manifest/manifest.h"

/// Table of records, with the results of the last calls that point to its data.
struct MjforgeTable {
  explicit MjforgeTable(const std::vector<std::string>& members) : columns(members) {}

  mjforge::manifest::Columns columns;
  std::vector<const mjforge::manifest::Column*> all;  // all columns, each before its inner columns
  std::string layout;
};
