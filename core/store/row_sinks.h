// Where the rows of a site go: into a fingerprint, or into their tables.
#pragma once

#include <QByteArray>
#include <QCryptographicHash>
#include <QUtf8StringView>
#include <array>
#include <cstring>
#include <optional>
#include <type_traits>

#include "base/sentence.h"
#include "store/site_rows.h"
#include "store/transaction.h"

namespace tessera::store {

/// 160 bits that change when any value of any row does.
class FingerprintSink {
public:
  template <class... Values>
  void row(Table table, const Values&... values) {
    put(static_cast<int>(table));
    (put(values), ...);
    if (used_ > kBlock) flush();
  }
  [[nodiscard]] QByteArray result() {
    flush();
    return hash_.result();
  }

private:
  // Rows are shorter than the reserve; long texts grow the block.
  static constexpr std::size_t kBlock = std::size_t{1} << 16;

  template <class Number>
  requires(std::is_arithmetic_v<Number>) void put(Number number) { bytes(&number, sizeof number); }
  void put(std::string_view text) {
    put(text.size());
    bytes(text.data(), text.size());
  }
  void put(const floor::TagUid& uid) {
    put(static_cast<std::uint8_t>(uid.bytes().size()));
    bytes(uid.bytes().data(), uid.bytes().size());
  }
  void put(const wire::Key& key) { bytes(key.data(), key.size()); }
  void put(const PictureBytes& picture) {
    put(picture.bytes.size());
    flush();  // not through the buffer, which would grow to its size
    hash_.addData(QByteArrayView{picture.bytes.data(), static_cast<qsizetype>(picture.bytes.size())});
  }
  void put(const std::optional<double>& number) {
    put(number.has_value());
    if (number) put(*number);
  }
  void bytes(const void* from, std::size_t count) {
    if (buffer_.size() < used_ + count) buffer_.resize(2 * (used_ + count) + kBlock);
    std::memcpy(buffer_.data() + used_, from, count);
    used_ += count;
  }
  void flush() {
    hash_.addData(QByteArrayView{buffer_.data(), static_cast<qsizetype>(used_)});
    used_ = 0;
  }

  QCryptographicHash hash_{QCryptographicHash::Blake2b_160};
  std::vector<char> buffer_ = std::vector<char>(2 * kBlock);
  std::size_t used_ = 0;
};

/// A text of the site as it is to be bound. Error: bytes that are no text; Qt would put other characters in their place
/// without a word.
inline QVariant keptText(Transaction& transaction, std::string_view text) {
  if (!QUtf8StringView{text.data(), static_cast<qsizetype>(text.size())}.isValidUtf8())
    transaction.fail(
        {phrase("Core", "A name in the site is no valid text (UTF-8), so the site cannot be kept.").with()});
  // SQLite takes a byte order mark at the beginning away and replaces U+FFFE and U+FFFF: such texts go as bytes.
  if (text.find("\xEF\xBB") != std::string_view::npos || text.find("\xEF\xBF") != std::string_view::npos)
    return QByteArray{text.data(), static_cast<qsizetype>(text.size())};
  return toText(text);
}

/// INSERTs of one site, each prepared once.
class InsertSink {
public:
  InsertSink(Transaction& transaction, qint64 site) : transaction_{transaction}, site_{site} {}

  template <class... Values>
  void row(Table table, const Values&... values) {
    auto& statement = statements_[static_cast<std::size_t>(table)];
    if (!statement) {
      QString sql = QStringLiteral("INSERT INTO ") + toText(kTableNames[static_cast<std::size_t>(table)]) +
                    QStringLiteral(" VALUES(?");
      for (std::size_t i = 0; i < sizeof...(values); ++i) sql += QStringLiteral(",?");
      statement.emplace(transaction_, sql + QStringLiteral(")"));
    }
    statement->run({site_, value(values)...});
  }

private:
  static QVariant value(double number) { return number; }
  static QVariant value(int number) { return number; }
  static QVariant value(bool yes) { return static_cast<int>(yes); }
  static QVariant value(std::size_t number) { return static_cast<qint64>(number); }
  QVariant value(std::string_view text) { return keptText(transaction_, text); }
  static QVariant value(const floor::TagUid& uid) {
    if (uid.empty()) return {};
    return bytes(uid.bytes());
  }
  static QVariant value(const wire::Key& key) { return bytes(key); }
  static QVariant value(const PictureBytes& picture) {
    return QByteArray{picture.bytes.data(), static_cast<qsizetype>(picture.bytes.size())};
  }
  static QVariant value(const std::optional<double>& number) { return number ? QVariant{*number} : QVariant{}; }
  static QVariant bytes(std::span<const std::uint8_t> from) {
    return QByteArray{reinterpret_cast<const char*>(from.data()), static_cast<qsizetype>(from.size())};
  }

  Transaction& transaction_;
  qint64 site_;
  std::array<std::optional<Statement>, kTableNames.size()> statements_;
};

}  // namespace tessera::store
