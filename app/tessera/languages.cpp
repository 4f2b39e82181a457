#include "app/tessera/languages.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <algorithm>

namespace tessera::desktop {

const std::vector<Language>& Languages::all() {
  static const std::vector<Language> list{{QStringLiteral("en"), QStringLiteral("English")},
                                          {QStringLiteral("zh_CN"), QStringLiteral("简体中文")}};
  return list;
}

QString Languages::ofSystem() {
  return QLocale::system().language() == QLocale::Chinese ? QStringLiteral("zh_CN") : QStringLiteral("en");
}

Languages::Languages(QObject* parent) : QObject{parent} {}

Languages::~Languages() {
  QCoreApplication::removeTranslator(&own_);
  QCoreApplication::removeTranslator(&qt_);
}

void Languages::use(const QString& code) {
  const auto known = std::any_of(all().begin(), all().end(), [&](const Language& l) { return l.code == code; });
  current_ = known ? code : QStringLiteral("en");
  // Before the translators, whose events make widgets ask for numbers in the new form.
  QLocale::setDefault(QLocale{current_});
  QCoreApplication::removeTranslator(&own_);
  QCoreApplication::removeTranslator(&qt_);
  // English is loaded as well: it holds the plurals.
  if (own_.load(QStringLiteral(":/i18n/tessera_") + current_)) QCoreApplication::installTranslator(&own_);
  // The relocatable package carries Qt's translations where its qt.conf says.
  if (qt_.load(QStringLiteral("qtbase_") + current_, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
    QCoreApplication::installTranslator(&qt_);
}

}  // namespace tessera::desktop
