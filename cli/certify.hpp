// graze certify: a kernel against the exact oracles.
#pragma once

namespace CLI {
class App;
}

namespace graze::cli {

void add_certify(CLI::App& program, int& status);

}  // namespace graze::cli
