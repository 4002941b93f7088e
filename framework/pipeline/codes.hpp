#pragma once

#include <string_view>

/// The code of every diagnostic of a pipeline file. docs/diagnostics.md explains each.
namespace stope::code {

// The file and its YAML.
inline constexpr const char* kUnreadableFile = "P001";
inline constexpr const char* kHugeFile = "P002";
inline constexpr const char* kNotText = "P003";
inline constexpr const char* kEmptyFile = "P004";
inline constexpr const char* kSyntax = "P005";
inline constexpr const char* kUnclosedQuote = "P006";
inline constexpr const char* kDuplicateKey = "P007";
inline constexpr const char* kMergeKey = "P008";
inline constexpr const char* kTag = "P009";
inline constexpr const char* kSeveralDocuments = "P010";
inline constexpr const char* kTooDeep = "P011";
inline constexpr const char* kAliasExpansion = "P012";
inline constexpr const char* kUnknownAnchor = "P013";
inline constexpr const char* kKeyNotName = "P014";
inline constexpr const char* kUnquotedVariable = "P015";

// What stands where.
inline constexpr const char* kWrongKind = "P020";
inline constexpr const char* kUnknownKey = "P021";
inline constexpr const char* kMissingKey = "P022";
inline constexpr const char* kWrongVersion = "P023";
inline constexpr const char* kNoValue = "P024";
inline constexpr const char* kInvalidName = "P025";
inline constexpr const char* kReservedName = "P026";

// Included files.
inline constexpr const char* kIncludeCycle = "P030";
inline constexpr const char* kIncludeConflict = "P031";

// Variables and --set.
inline constexpr const char* kUndefinedVariable = "P040";
inline constexpr const char* kVariableCycle = "P041";
inline constexpr const char* kMalformedVariable = "P042";
inline constexpr const char* kVariableInText = "P043";
inline constexpr const char* kVariableExpansion = "P044";
inline constexpr const char* kMalformedOverride = "P045";
inline constexpr const char* kOverridesNothing = "P046";

// Stages and the wires between them.
inline constexpr const char* kUnknownStage = "P050";
inline constexpr const char* kWireFromUnknownStage = "P051";
inline constexpr const char* kUnknownOutputPort = "P052";
inline constexpr const char* kUnknownInputPort = "P053";
inline constexpr const char* kMissingInput = "P054";
inline constexpr const char* kAmbiguousInput = "P055";
inline constexpr const char* kAmbiguousOutput = "P056";
inline constexpr const char* kTypeMismatch = "P057";
inline constexpr const char* kLayoutMismatch = "P058";
inline constexpr const char* kStreamIntoValue = "P059";
inline constexpr const char* kCycle = "P060";
inline constexpr const char* kNoInputs = "P061";
inline constexpr const char* kMalformedWire = "P062";

// Parameters.
inline constexpr const char* kUnknownParameter = "P070";
inline constexpr const char* kWrongType = "P071";
inline constexpr const char* kOutOfRange = "P072";
inline constexpr const char* kWrongUnit = "P073";
inline constexpr const char* kNotAChoice = "P074";
inline constexpr const char* kWrongCount = "P075";
inline constexpr const char* kMissingParameter = "P076";
inline constexpr const char* kMissingPath = "P077";
inline constexpr const char* kUnknownMember = "P078";

/// Whether a code says that a parameter is wrong, and the graph is sound for all that.
constexpr bool about_parameters(std::string_view code) { return code.substr(0, 3) == "P07"; }

// Outputs.
inline constexpr const char* kNoExport = "P080";
inline constexpr const char* kExportType = "P081";
inline constexpr const char* kAmbiguousExport = "P082";
inline constexpr const char* kOutputName = "P083";
inline constexpr const char* kNoExtension = "P084";
inline constexpr const char* kOutputCollision = "P085";
inline constexpr const char* kNotAnExport = "P086";

// Warnings.
inline constexpr const char* kUnread = "P090";
inline constexpr const char* kUnusedInput = "P091";

}  // namespace stope::code
