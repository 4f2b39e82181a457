// As much of the PDF format as Qt writes: its objects, their streams, what a page draws and says.
#pragma once

#include <QByteArray>
#include <QMap>
#include <QRegularExpression>
#include <QString>
#include <QTransform>
#include <QtEndian>
#include <algorithm>
#include <limits>
#include <vector>

namespace tessera::ui {

class PdfReader {
public:
  explicit PdfReader(const QByteArray& file) {
    // Latin-1, so that a place in the text is a place in the bytes.
    const QString text = QString::fromLatin1(file);
    static const QRegularExpression object{QStringLiteral("(?:^|\n)(\\d+) 0 obj\\s")};
    for (auto hits = object.globalMatch(text); hits.hasNext();) {
      const auto hit = hits.next();
      const qsizetype from = hit.capturedEnd();
      const qsizetype end = text.indexOf(QStringLiteral("endobj"), from);
      const qsizetype stream = text.indexOf(QStringLiteral("stream\n"), from);
      const int number = hit.captured(1).toInt();
      const bool has = stream >= 0 && stream < end;
      heads_[number] = text.mid(from, (has ? stream : end) - from);
      if (!has) continue;
      const qsizetype begin = stream + 7;
      const QByteArray raw = file.mid(begin, file.indexOf("endstream", begin) - begin);
      streams_[number] = heads_[number].contains(QStringLiteral("FlateDecode")) ? inflated(raw) : raw;
    }
  }

  /// What stands before the stream of each object that says this of itself.
  [[nodiscard]] QStringList headsWith(const char* words) const {
    QStringList found;
    for (const QString& head : heads_)
      if (head.contains(QLatin1String{words})) found << head;
    return found;
  }
  [[nodiscard]] QSizeF page() const {
    static const QRegularExpression box{QStringLiteral("/MediaBox \\[0 0 ([\\d.]+) ([\\d.]+)\\]")};
    for (const QString& head : heads_)
      if (const auto hit = box.match(head); hit.hasMatch())
        return {hit.captured(1).toDouble(), hit.captured(2).toDouble()};
    return {};
  }
  /// All that is drawn as lines and areas, in points, but for what covers the whole page.
  [[nodiscard]] QRectF drawn() const {
    QRectF all;
    const auto add = [&](const QRectF& shape) {
      if (!shape.isNull() && shape.width() < 0.97 * page().width()) all |= shape;
    };
    QTransform at;
    std::vector<QTransform> kept;
    std::vector<double> numbers;
    QPolygonF path;
    for (const QByteArray& word : content().simplified().split(' ')) {
      bool isNumber = false;
      const double number = word.toDouble(&isNumber);
      if (isNumber) {
        numbers.push_back(number);
        continue;
      }
      const std::size_t n = numbers.size();
      if (word == "q") kept.push_back(at);
      if (word == "Q" && !kept.empty()) {
        at = kept.back();
        kept.pop_back();
      }
      if (word == "cm" && n >= 6)
        at =
            QTransform{numbers[n - 6], numbers[n - 5], numbers[n - 4], numbers[n - 3], numbers[n - 2], numbers[n - 1]} *
            at;
      if ((word == "m" || word == "l" || word == "c") && n >= 2)
        path << at.map(QPointF{numbers[n - 2], numbers[n - 1]});
      if (word == "re" && n >= 4)
        path += QPolygonF{at.mapRect(QRectF{numbers[n - 4], numbers[n - 3], numbers[n - 2], numbers[n - 1]})};
      if (word.size() <= 2 && (word.startsWith('f') || word.startsWith('S') || word.startsWith('B')))
        add(path.boundingRect());
      if (word.size() <= 2 && QByteArray{"fSBnW"}.contains(word.front()) && word != "W") path.clear();
      numbers.clear();
    }
    return all;
  }
  /// All that is said, by the tables that tell a reader which letters the fonts' signs are.
  [[nodiscard]] QString text() const {
    QString said;
    QMap<int, QChar> letters;
    static const QRegularExpression words{QStringLiteral("/F(\\d+)\\s|<([0-9a-fA-F]+)> Tj|\\bET\\b")};
    const QString page = QString::fromLatin1(content());
    for (auto hits = words.globalMatch(page); hits.hasNext();) {
      const auto hit = hits.next();
      if (hit.hasCaptured(1)) {
        letters = lettersOf(hit.captured(1).toInt());
      } else if (hit.hasCaptured(2)) {
        for (qsizetype n = 0; n + 4 <= hit.captured(2).size(); n += 4)
          said += letters.value(hit.captured(2).mid(n, 4).toInt(nullptr, 16), QLatin1Char('?'));
      } else {
        said += QLatin1Char('\n');
      }
    }
    // Where a font has one sign for both, Qt calls it by the first of them.
    return said.replace(QLatin1Char('\t'), QLatin1Char(' '));
  }

private:
  static QByteArray inflated(const QByteArray& raw) {
    QByteArray sized(4, '\0');
    qToBigEndian<quint32>(static_cast<quint32>(std::max<qsizetype>(64, 4 * raw.size())), sized.data());
    return qUncompress(sized + raw);
  }
  [[nodiscard]] int referred(int object, const char* name) const {
    const QRegularExpression to{QLatin1Char('/') + QLatin1String{name} + QStringLiteral("\\s+\\[?\\s*(\\d+) 0 R")};
    return to.match(heads_.value(object)).captured(1).toInt();
  }
  [[nodiscard]] QByteArray content() const {
    for (auto it = heads_.begin(); it != heads_.end(); ++it)
      if (it.value().contains(QStringLiteral("/Type /Page\n"))) return streams_.value(referred(it.key(), "Contents"));
    return {};
  }
  [[nodiscard]] QMap<int, QChar> lettersOf(int font) const {
    QMap<int, QChar> letters;
    static const QRegularExpression range{QStringLiteral("<(\\w{4})> <(\\w{4})> (?:<(\\w{4})>|\\[([^\\]]*)\\])")};
    const QString map = QString::fromLatin1(streams_.value(referred(font, "ToUnicode")));
    for (auto hits = range.globalMatch(map); hits.hasNext();) {
      const auto hit = hits.next();
      const int first = hit.captured(1).toInt(nullptr, 16);
      const int last = hit.captured(2).toInt(nullptr, 16);
      const QString list = QString{hit.captured(4)}.remove(QLatin1Char('<')).remove(QLatin1Char('>')).simplified();
      const QStringList each = list.split(QLatin1Char(' '));
      for (int n = first; n <= last; ++n)
        letters[n] =
            QChar{static_cast<char16_t>(hit.captured(4).isEmpty() ? hit.captured(3).toInt(nullptr, 16) + n - first
                                                                  : each.value(n - first).toInt(nullptr, 16))};
    }
    return letters;
  }

  QMap<int, QString> heads_;
  QMap<int, QByteArray> streams_;
};

}  // namespace tessera::ui
