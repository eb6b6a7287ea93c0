// `graze merge`: the reports of shards made one.
#pragma once

namespace CLI {
class App;
}

namespace graze::cli {

/// Adds the command; it sets `status`.
void add_merge(CLI::App& program, int& status);

}  // namespace graze::cli
