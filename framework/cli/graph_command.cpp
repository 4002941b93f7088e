#include "framework/cli/arguments.hpp"
namespace stope {
int graph_command(const Arguments&) { return 1; }
int schema_command(const Arguments&) { return 1; }
}
