#include "common/io/record_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstring>
#include <random>
#include <string_view>
#include <system_error>
#include <utility>

#include "common/errors.hpp"

namespace pennon {
namespace {

static_assert(std::endian::native == std::endian::little, "records are little-endian");

using Word = std::uint64_t;  // all of a file is made of words

constexpr std::string_view ending = ".rows", mark = "pennon records 1";
constexpr std::size_t digits = 16;
constexpr Word words_of_header = 4, words_about_record = 2;

// Each word is a bijection of the checksum before it: where one word differs, so does all that
// follows.
Word checksum_with(Word checksum, Word word) {
  constexpr Word odd = 0x9E3779B97F4A7C15U;
  constexpr int turn = 29;
  return std::rotl((checksum ^ word) * odd, turn);
}

std::array<Word, words_of_header> header_of(Word file) {
  static_assert(mark.size() == 2 * sizeof(Word));
  std::array<Word, words_of_header> header{};
  std::memcpy(header.data(), mark.data(), mark.size());
  header[2] = file;
  for (std::size_t k = 0; k < 3; ++k) header[3] = checksum_with(header[3], header[k]);
  return header;
}

Word about_record(std::uint32_t kind, std::size_t count) {
  return Word{kind} | static_cast<Word>(count) << 32;
}

// An open file, closed at the end.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  operator int() const { return number_; }

 private:
  int number_;
};

// Its bytes; none where it is no regular file.
Word size_of(int descriptor) {
  struct stat found {};
  return fstat(descriptor, &found) == 0 && S_ISREG(found.st_mode) ? static_cast<Word>(found.st_size)
                                                                  : 0;
}

[[noreturn]] void cannot_write(const std::filesystem::path& path, int error) {
  throw FileError(fmt::format("{} cannot be written: {}", path.string(),
                              std::generic_category().message(error == 0 ? ENOSPC : error)));
}

void write_at(const std::filesystem::path& path, int descriptor, std::span<const Word> words,
              Word place) {
  const char* from = reinterpret_cast<const char*>(words.data());
  for (std::size_t left = words.size_bytes(); left > 0;) {
    errno = 0;
    const ssize_t count = pwrite(descriptor, from, left, static_cast<off_t>(place));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) cannot_write(path, errno);
    from += count;
    left -= static_cast<std::size_t>(count);
    place += static_cast<Word>(count);
  }
}

class RecordReader {
 public:
  RecordReader(const std::filesystem::path& path, const RecordsEnd& end)
      : path_(path),
        // A pipe must not keep us waiting.
        file_(::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC)),
        left_(end.bytes / sizeof(Word)) {
    if (end.bytes % sizeof(Word) != 0) damaged();
    if (file_ < 0)
      fail(errno == ENOENT
               ? "there is no such file; it lies beside the checkpoint that was written with it"
               : "cannot be read: " + std::generic_category().message(errno));
    if (const Word size = size_of(file_); size < end.bytes)
      fail(fmt::format("has {} bytes, {} belong to the checkpoint; it was cut", size, end.bytes));
    const auto expected = header_of(end.file);
    std::array<Word, words_of_header> header{};
    take(header);
    if (header != expected) fail("is another file than the checkpoint was written with");
    checksum_ = header.back();
  }

  // False at the end. The values stay until the next call.
  bool next(std::uint32_t& kind, std::span<const double>& values) {
    if (left_ == 0) return false;
    Word about = 0;
    take({&about, 1});
    kind = static_cast<std::uint32_t>(about);
    const Word count = about >> 32;
    if (left_ == 0 || count > left_ - 1) damaged();
    words_.resize(count);
    take(words_);
    Word expected = 0;
    take({&expected, 1});
    checksum_ = checksum_with(checksum_, about);
    for (const Word word : words_) checksum_ = checksum_with(checksum_, word);
    if (checksum_ != expected) damaged();
    values_.resize(count);
    if (count > 0) std::memcpy(values_.data(), words_.data(), count * sizeof(Word));
    values = values_;
    return true;
  }

  void expect(Word checksum) const {
    if (checksum_ != checksum) damaged();
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw InputError(path_.string(), what); }
  [[noreturn]] void damaged() const {
    fail("is damaged, or was written on by another run than the checkpoint's");
  }

  void take(std::span<Word> words) {
    if (words.size() > left_) damaged();
    char* to = reinterpret_cast<char*>(words.data());
    for (std::size_t missing = words.size_bytes(); missing > 0;) {
      const ssize_t count = ::read(file_, to, missing);
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) fail("cannot be read to its end");
      to += count;
      missing -= static_cast<std::size_t>(count);
    }
    left_ -= words.size();
  }

  const std::filesystem::path& path_;
  Descriptor file_;
  Word left_, checksum_ = 0;
  std::vector<Word> words_;
  std::vector<double> values_;
};

// Whether "<stem>_<digits>.rows".
bool is_name(const std::string& name, const std::string& stem) {
  if (name.size() != stem.size() + 1 + digits + ending.size()) return false;
  return name.starts_with(stem + "_") && name.ends_with(ending) &&
         std::all_of(name.begin() + static_cast<std::ptrdiff_t>(stem.size()) + 1,
                     name.end() - static_cast<std::ptrdiff_t>(ending.size()),
                     [](unsigned char c) { return std::isxdigit(c) != 0; });
}

}  // namespace

std::filesystem::path records_name(const std::string& stem, std::uint64_t file) {
  return fmt::format("{}_{:0{}x}{}", stem, file, digits, ending);
}

RecordFile::RecordFile(std::filesystem::path folder, std::string stem)
    : folder_(std::move(folder)), stem_(std::move(stem)) {
  std::random_device source;
  const Word number = static_cast<Word>(source()) << 32 | source();
  const auto header = header_of(number);
  end_ = {number, 0, 0};
  checksum_ = header.back();
  added_.assign(header.begin(), header.end());
}

RecordFile::RecordFile(std::filesystem::path folder, std::string stem, const RecordsEnd& end)
    : folder_(std::move(folder)), stem_(std::move(stem)), end_(end), checksum_(end.checksum) {}

void RecordFile::add(std::uint32_t kind, std::span<const double> values) {
  const auto put = [this](Word word) {
    added_.push_back(word);
    checksum_ = checksum_with(checksum_, word);
  };
  put(about_record(kind, values.size()));
  for (const double value : values) put(std::bit_cast<Word>(value));
  added_.push_back(checksum_);
}

RecordsEnd RecordFile::flush() {
  const std::filesystem::path path = folder_ / records_name(stem_, end_.file);
  constexpr int flags = O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;
  const bool is_new = end_.bytes == 0;
  const Descriptor file(::open(path.c_str(), is_new ? flags | O_CREAT : flags, 0666));
  if (file < 0) cannot_write(path, errno);
  if (size_of(file) < end_.bytes)
    throw FileError(path.string() + " was cut while the run wrote to it");
  if (ftruncate(file, static_cast<off_t>(end_.bytes)) != 0) cannot_write(path, errno);
  write_at(path, file, added_, end_.bytes);
  if (fsync(file) != 0) cannot_write(path, errno);
  end_.bytes += added_.size() * sizeof(Word);
  end_.checksum = checksum_;
  added_.clear();
  return end_;
}

void RecordFile::remove_others() const {
  std::error_code ignored;
  const std::string own = records_name(stem_, end_.file);
  std::vector<std::filesystem::path> others;
  for (const auto& entry : std::filesystem::directory_iterator(folder_, ignored)) {
    const std::string name = entry.path().filename();
    if (name != own && is_name(name, stem_)) others.push_back(entry.path());
  }
  for (const std::filesystem::path& other : others) std::filesystem::remove(other, ignored);
}

void read_records(const std::filesystem::path& path, const RecordsEnd& end,
                  const std::function<void(std::uint32_t kind, std::span<const double>)>& use) {
  RecordReader reader(path, end);
  std::uint32_t kind = 0;
  std::span<const double> values;
  while (reader.next(kind, values)) use(kind, values);
  reader.expect(end.checksum);
}

}  // namespace pennon
