// The pages of the help: which there are, in which order, and what stands in them, in the language of the window.
#pragma once

#include <QCoreApplication>
#include <QString>
#include <QUrl>
#include <vector>

namespace tessera::ui {

struct HelpPage {
  QString topic;
  QString title;  ///< the page's own heading
  QString text;   ///< Markdown
};

class HelpPages {
  Q_DECLARE_TR_FUNCTIONS(tessera::ui::HelpPages)
public:
  /// Reads the pages of the window's language; where one is missing, the English one.
  HelpPages();

  [[nodiscard]] const std::vector<HelpPage>& all() const { return pages_; }
  /// The start page when there is no such topic.
  [[nodiscard]] const HelpPage& page(const QString& topic) const;
  [[nodiscard]] QUrl url(const QString& topic) const;
  /// Pages in which all the words stand, titles first.
  [[nodiscard]] std::vector<const HelpPage*> search(const QString& words) const;
  /// In the order of the contents.
  [[nodiscard]] static const std::vector<QString>& topics();

private:
  QString folder_;
  std::vector<HelpPage> pages_;
};

}  // namespace tessera::ui
