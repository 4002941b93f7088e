#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>

namespace stope::topology {

/// Place of a cell in a PaddedGrid. Grids with more cells are refused (see FreeSpace).
using CellIndex = std::int32_t;

/// A row-major grid with a margin of one cell all around, so that neighbours are reached without
/// asking whether they exist. Cells start without a value.
template <class T>
class PaddedGrid {
 public:
  PaddedGrid(std::int32_t width, std::int32_t height)
      : width_(width), height_(height), cells_(allocate(size())) {}

  std::int32_t width() const { return width_; }    ///< without the margin
  std::int32_t height() const { return height_; }  ///< without the margin
  CellIndex stride() const { return width_ + 2; }
  std::size_t size() const {
    return (static_cast<std::size_t>(width_) + 2) * (static_cast<std::size_t>(height_) + 2);
  }
  /// Place of a cell by column and row; the margin is column or row -1, width, height.
  CellIndex index(std::int32_t column, std::int32_t row) const {
    return (row + 1) * stride() + column + 1;
  }
  std::int32_t column(CellIndex index) const { return index % stride() - 1; }
  std::int32_t row(CellIndex index) const { return index / stride() - 1; }

  T& operator[](CellIndex index) { return cells_[static_cast<std::size_t>(index)]; }
  const T& operator[](CellIndex index) const { return cells_[static_cast<std::size_t>(index)]; }
  T* data() { return cells_.get(); }
  const T* data() const { return cells_.get(); }
  /// The row with its margin: element 0 is column -1.
  T* padded_row(std::int32_t row) { return cells_.get() + offset(row); }
  const T* padded_row(std::int32_t row) const { return cells_.get() + offset(row); }

 private:
  struct Free {
    void operator()(T* cells) const { std::free(cells); }
  };
  static std::unique_ptr<T[], Free> allocate(std::size_t count) {
    constexpr std::size_t kHugePage = std::size_t{1} << 21, kCacheLine = 64;
    const std::size_t unit = count * sizeof(T) < kHugePage ? kCacheLine : kHugePage;
    const std::size_t bytes = (count * sizeof(T) + unit - 1) / unit * unit;
    void* memory = std::aligned_alloc(unit, bytes);
    if (!memory) throw std::bad_alloc();
    // First touches of many small pages cost as much as the work on them; a refusal is harmless.
    if (unit == kHugePage) ::madvise(memory, bytes, MADV_HUGEPAGE);
    return std::unique_ptr<T[], Free>(static_cast<T*>(memory));
  }
  std::size_t offset(std::int32_t row) const {
    return static_cast<std::size_t>(row + 1) * static_cast<std::size_t>(stride());
  }

  std::int32_t width_, height_;
  std::unique_ptr<T[], Free> cells_;
};

}  // namespace stope::topology
