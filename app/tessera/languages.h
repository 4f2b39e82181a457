// The window's language, switched while it runs. English is the source; Chinese and Qt's own texts are loaded.
#pragma once

#include <QObject>
#include <QString>
#include <QTranslator>
#include <vector>

namespace tessera::desktop {

struct Language {
  QString code;  ///< as in the names of translation files: "en", "zh_CN"
  QString name;  ///< in that language itself
};

class Languages : public QObject {
  Q_OBJECT
public:
  explicit Languages(QObject* parent = nullptr);
  ~Languages() override;

  [[nodiscard]] static const std::vector<Language>& all();
  /// The one of all() that fits this computer best; English where none does.
  [[nodiscard]] static QString ofSystem();
  [[nodiscard]] const QString& current() const { return current_; }
  /// An unknown code counts as English. All widgets get a LanguageChange event.
  void use(const QString& code);

private:
  QTranslator own_;
  QTranslator qt_;
  QString current_;
};

}  // namespace tessera::desktop
