#include "framework/cache/object_store.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <ctime>
#include <fstream>
#include <string>

#include "framework/cache/item_journal.hpp"
#include "framework/cache/kept_stage.hpp"
#include "framework/cache/store_contents.hpp"
#include "stope/error.hpp"
#include "stope/random.hpp"
#include "stope/testing/memory_context.hpp"

namespace stope {
namespace {

namespace fs = std::filesystem;

/// Bytes that do not shrink, different for each seed.
std::string noise(std::size_t size, std::uint64_t seed) {
  Random random(seed);
  std::string bytes(size, ' ');
  for (char& byte : bytes) byte = static_cast<char>(random.bits());
  return bytes;
}

class ObjectStoreTest : public ::testing::Test {
 protected:
  StoredObject put(const std::string& bytes) {
    return store_.put([&](ByteSink& sink) { sink.write(bytes.data(), bytes.size()); });
  }
  /// The object's bytes; "gone" if the store cannot give it.
  std::string get(const Digest& digest) {
    std::string bytes;
    const bool there = store_.get(digest, [&](ByteSource& source) {
      bytes.resize(source.remaining());
      source.read(bytes.data(), bytes.size());
    });
    return there ? bytes : "gone";
  }
  std::size_t files_being_written() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(store_.root() / "new"), fs::directory_iterator()));
  }

  testing::MemoryContext context_;
  ObjectStore store_{context_.temporary_folder() / "store"};
};

TEST_F(ObjectStoreTest, GivesBackWhatItKeeps) {
  for (const std::size_t size : {0, 1, 100, 1 << 20}) {
    const std::string bytes = noise(size, size);
    const StoredObject object = put(bytes);
    EXPECT_EQ(object.size, size);
    EXPECT_EQ(get(object.digest), bytes);
  }
  EXPECT_EQ(get({1, 2}), "gone");
}

TEST_F(ObjectStoreTest, KeepsEqualBytesOnce) {
  const std::string bytes = noise(1000, 1);
  EXPECT_EQ(put(bytes).digest, put(bytes).digest);
  EXPECT_EQ(usage_of(store_).objects, 1U);
}

TEST_F(ObjectStoreTest, ShrinksWhatRepeats) {
  put(std::string(1 << 20, 'x'));
  EXPECT_LT(usage_of(store_).bytes, 1U << 14);
}

TEST_F(ObjectStoreTest, NoticesFlippedBits) {
  const std::string bytes = noise(60, 5);
  const Digest digest = put(bytes).digest;
  const fs::path file = store_.file_of(digest), sound = store_.root() / "sound";
  fs::copy_file(file, sound);
  int unharmed = 0;
  for (std::uintmax_t bit = 0; bit < 8 * fs::file_size(sound); bit += 5) {
    fs::copy_file(sound, file, fs::copy_options::overwrite_existing);
    std::fstream damage(file, std::ios::in | std::ios::out | std::ios::binary);
    damage.seekg(static_cast<std::streamoff>(bit / 8));
    const char byte = static_cast<char>(damage.get() ^ (1 << bit % 8));
    damage.seekp(static_cast<std::streamoff>(bit / 8));
    damage.put(byte);
    damage.close();
    const std::string back = get(digest);
    if (back == bytes) {
      ++unharmed;  // a bit of the compressor's own checksum or frame that carries nothing
      continue;
    }
    EXPECT_EQ(back, "gone") << "bit " << bit;
    EXPECT_FALSE(store_.contains(digest));
  }
  EXPECT_LE(unharmed, 13);
}

TEST_F(ObjectStoreTest, NoticesWhatWasCutOff) {
  const Digest digest = put(noise(5000, 5)).digest;
  for (const std::uintmax_t size : {3000U, 20U, 7U, 0U}) {
    put(noise(5000, 5));
    fs::resize_file(store_.file_of(digest), size);
    EXPECT_EQ(get(digest), "gone");
  }
}

TEST_F(ObjectStoreTest, LeavesNothingOfAWriterThatFails) {
  EXPECT_THROW(store_.put([](ByteSink& sink) {
    sink.write("half", 4);
    throw Error("the payload could not be encoded");
  }),
               Error);
  EXPECT_EQ(files_being_written(), 0U);
  EXPECT_EQ(usage_of(store_).objects, 0U);
}

TEST_F(ObjectStoreTest, AReadersOwnErrorIsNotTheObjectsFault) {
  const Digest digest = put("sound").digest;
  EXPECT_THROW(store_.get(digest, [](ByteSource&) { throw Error("of another type"); }), Error);
  EXPECT_EQ(get(digest), "sound");
}

TEST_F(ObjectStoreTest, RemovesWhatWasLongestNotUsed) {
  const Digest old = put(noise(1000, 1)).digest, used = put(noise(1000, 2)).digest;
  const Digest recent = put(noise(1000, 3)).digest;
  const auto now = fs::file_time_type::clock::now();
  fs::last_write_time(store_.file_of(old), now - std::chrono::hours(3));
  fs::last_write_time(store_.file_of(used), now - std::chrono::hours(4));
  fs::last_write_time(store_.file_of(recent), now - std::chrono::hours(1));
  EXPECT_NE(get(used), "gone");
  const StoreUsage left = collect_garbage(store_, 2500);
  EXPECT_EQ(left.objects, 2U);
  EXPECT_EQ(left.bytes, usage_of(store_).bytes);
  EXPECT_FALSE(store_.contains(old));
  EXPECT_TRUE(store_.contains(used));
  EXPECT_TRUE(store_.contains(recent));
}

TEST_F(ObjectStoreTest, JournalsThatNobodyGoesOnWithAreRemoved) {
  const ItemJournal journal(store_.root());
  ItemJournal(store_.root()).add({1, 2}, "grid", {10, 0, {3, 4}, 5});
  ItemJournal(store_.root()).add({6, 7}, "grid", {10, 0, {3, 4}, 5});
  for (const auto& file : fs::directory_iterator(store_.root() / "partial"))
    if (file.path().filename().string().starts_with(Digest{1, 2}.text()))
      fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(24 * 31));
    else
      fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(24 * 29));
  collect_garbage(store_, 1 << 20);
  EXPECT_TRUE(journal.items({1, 2}, "grid").empty());
  EXPECT_EQ(journal.items({6, 7}, "grid").size(), 1U);
}

TEST_F(ObjectStoreTest, VerifyFindsDamageAndStrangers) {
  const Digest damaged = put(noise(1000, 1)).digest;
  put(noise(1000, 2));
  fs::resize_file(store_.file_of(damaged), 500);
  std::ofstream(store_.root() / "objects" / "stranger") << "?";
  EXPECT_EQ(verify(store_), 2U);
  EXPECT_EQ(verify(store_), 0U);
  EXPECT_EQ(usage_of(store_).objects, 1U);
}

TEST_F(ObjectStoreTest, VerifyFindsDamagedRecords) {
  KeptStages stages(store_.root());
  const StoredObject object = put(noise(1000, 1));
  for (const Digest& key : {Digest{1, 2}, Digest{3, 4}, Digest{5, 6}, Digest{7, 8}}) {
    KeptStage kept;
    kept.name = "roads";
    kept.outputs = {{"roads", "toy", 0, false, {{0, 0, object.digest, object.size}}}};
    stages.save(key, kept);
  }
  const auto file_of = [&](const Digest& key) {
    return store_.root() / "stages" / key.text().substr(0, 2) / key.text().substr(2);
  };
  EXPECT_EQ(verify_records(store_), 0U);
  std::ofstream(file_of({1, 2})) << "garbage";
  fs::resize_file(file_of({3, 4}), fs::file_size(file_of({3, 4})) - 1);
  std::fstream flipped(file_of({5, 6}), std::ios::in | std::ios::out | std::ios::binary);
  flipped.seekp(20);
  flipped.put('\x7f');
  flipped.close();
  std::ofstream(store_.root() / "stages" / "stranger") << "?";
  // Another process is just writing that one.
  std::ofstream(file_of({7, 8}).string() + ".4711") << "half";
  std::ofstream(store_.root() / "digests") << "garbage";
  EXPECT_EQ(verify_records(store_), 5U);
  EXPECT_EQ(verify_records(store_), 0U);
  EXPECT_TRUE(fs::exists(file_of({7, 8}).string() + ".4711"));
  EXPECT_FALSE(stages.find({1, 2}));
  EXPECT_TRUE(stages.find({7, 8}));
  EXPECT_EQ(contents_of(store_).size(), 1U);
}

TEST_F(ObjectStoreTest, AResultThatIsGoneHasTheTimeOfItsRecord) {
  KeptStage kept;
  kept.name = "roads";
  const StoredObject object = put(noise(1000, 1));
  kept.outputs = {{"roads", "toy", 0, false, {{0, 0, object.digest, object.size}}}};
  KeptStages(store_.root()).save({1, 2}, kept);
  fs::remove(store_.file_of(object.digest));
  const std::vector<StoredRecord> records = contents_of(store_);
  ASSERT_EQ(records.size(), 1U);
  EXPECT_EQ(records[0].missing, 1U);
  const std::time_t now = std::time(nullptr);
  EXPECT_LE(records[0].used, now + 2);
  EXPECT_GE(records[0].used, now - 60);
}

TEST_F(ObjectStoreTest, SeveralProcessesShareIt) {
  constexpr int kProcesses = 4, kRounds = 60;
  std::vector<pid_t> children;
  for (int process = 0; process < kProcesses; ++process) {
    const pid_t child = ::fork();
    if (child == 0) {
      bool right = true;
      for (int round = 0; round < kRounds; ++round) {
        // All write the same few objects, read them back, and one of them clears up meanwhile.
        const std::string bytes = noise(2000, static_cast<std::uint64_t>(round % 7));
        const Digest digest = put(bytes).digest;
        const std::string back = get(digest);
        right = right && (back == bytes || back == "gone");
        if (process == 0) collect_garbage(store_, 6000);
      }
      ::_exit(right ? 0 : 1);
    }
    children.push_back(child);
  }
  for (const pid_t child : children) {
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(verify(store_), 0U);
  EXPECT_EQ(files_being_written(), 0U);
}

TEST(ObjectStore, SaysWhyItCannotBeMade) {
  try {
    ObjectStore store("/proc/nowhere");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("cannot make the store /proc/nowhere"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace stope
