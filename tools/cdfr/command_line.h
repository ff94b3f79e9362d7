/// The classes of the library that reads the command line, by name alone: its header takes seconds to
/// compile.
#pragma once

namespace CLI {
class App;
class Option;
}  // namespace CLI
