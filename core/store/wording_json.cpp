#include "store/wording_json.h"

#include <QJsonArray>
#include <QJsonDocument>

#include "store/transaction.h"

namespace tessera::store {
namespace {

QJsonArray arrayOf(const Sentence& sentence) {
  QJsonArray all;
  for (const Sentence& argument : sentence.arguments()) {
    if (argument.pattern() == nullptr) {
      all.append(toText(argument.english()));
      continue;
    }
    QJsonArray nested = arrayOf(argument);
    nested.prepend(toText(argument.pattern()->english()));
    all.append(nested);
  }
  return all;
}

std::vector<Wording> wordingsOf(const QJsonArray& all) {
  std::vector<Wording> wordings;
  for (const auto& value : all) {
    Wording one{value.toString().toStdString(), value.isArray(), {}};
    if (value.isArray()) {
      QJsonArray nested = value.toArray();
      if (nested.isEmpty()) continue;
      one.text = nested.takeAt(0).toString().toStdString();
      one.arguments = wordingsOf(nested);
    }
    wordings.push_back(std::move(one));
  }
  return wordings;
}

}  // namespace

QString argumentsToJson(const Sentence& sentence) {
  return QString::fromUtf8(QJsonDocument{arrayOf(sentence)}.toJson(QJsonDocument::Compact));
}

std::vector<Wording> argumentsFromJson(const QByteArray& json) {
  return wordingsOf(QJsonDocument::fromJson(json).array());
}

}  // namespace tessera::store
