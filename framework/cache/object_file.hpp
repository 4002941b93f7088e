#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "stope/codec.hpp"
#include "stope/digest.hpp"

namespace stope {

/// What a stored object is called by and how large it is.
struct StoredObject {
  Digest digest;           ///< of the bytes as they were written
  std::uint64_t size = 0;  ///< of these bytes, before compression
};

/// Writes an object into a folder under a name of its own that nobody else has: compressed as it
/// comes, digested on the way. Until commit() nothing is seen of it; dropped before, it leaves no
/// trace. Throws Error with a sentence that names the folder, such as of a full disk.
class ObjectWriter final : public ByteSink {
 public:
  explicit ObjectWriter(const std::filesystem::path& folder);
  ~ObjectWriter() override;
  ObjectWriter(const ObjectWriter&) = delete;
  ObjectWriter& operator=(const ObjectWriter&) = delete;

  void write(const void* data, std::size_t size) override;
  /// Writes what is left and closes the file. Nothing may be written after it.
  StoredObject finish();
  /// Takes the final name, in place of a file that has it.
  void commit(const std::filesystem::path& file);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Reads an object back. What it reads is only known to be right when it was read to the end and
/// `whole()` says so.
class ObjectReader final : public ByteSource {
 public:
  /// Throws Error if there is no such file or it is none of ours.
  explicit ObjectReader(const std::filesystem::path& file);
  ~ObjectReader() override;
  ObjectReader(const ObjectReader&) = delete;
  ObjectReader& operator=(const ObjectReader&) = delete;

  /// Throws Error if the file is damaged or ends too early.
  void read(void* data, std::size_t size) override;
  std::size_t remaining() const override;
  /// Whether all bytes were read and have this digest.
  bool whole(const Digest& digest) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace stope
