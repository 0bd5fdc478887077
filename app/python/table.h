// Tables of records behind the C interface.
#pragma once

#include <string>
#include <vector>

#include "interface.h"
#include "mjforge/manifest/manifest.h"

/// Columns of records, and the columns and texts that the last calls returned.
struct MjforgeTable {
  explicit MjforgeTable(const std::vector<std::string>& members) : columns(members) {}

  mjforge::manifest::Columns columns;
  std::vector<const mjforge::manifest::Column*> all;  // all columns, each before its inner columns
  std::string layout;
};
