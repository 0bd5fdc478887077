// Public header of the library `xml`: MJCF files as trees of XML elements that know their places in
// the text.
#pragma once

#include "mjforge/xml/asset_files.h"
#include "mjforge/xml/attribute_numbers.h"
#include "mjforge/xml/element.h"
#include "mjforge/xml/element_text.h"
#include "mjforge/xml/elements_json.h"
#include "mjforge/xml/places.h"
#include "mjforge/xml/tree_reader.h"
#include "mjforge/xml/well_formed.h"
