#pragma once

namespace stope {

/// What the command returns to the shell.
enum ExitCode : int {
  kDone = 0,
  kRunFailed = 1,       ///< the run failed or was cancelled
  kWrongArguments = 2,  ///< the pipeline or the arguments are wrong
  kPluginUnusable = 3,  ///< a plugin that is needed could not be used
};

}  // namespace stope
