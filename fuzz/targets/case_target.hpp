// What the targets of cases share; each names its queries in a file of its own.
#pragma once

#include "fuzz/case_bytes.hpp"

namespace graze::fuzz {

/// Which queries the target's bytes are.
extern const QueryGroup target_group;

}  // namespace graze::fuzz
