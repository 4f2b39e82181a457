// The first thing that a person sees while no site is open: what the program is, and the ways on from here.
#pragma once

#include <QLabel>
#include <QWidget>
#include <vector>

#include "ui/connect/big_button.h"
#include "ui/connect/recent_list.h"

namespace tessera::ui {

class StartPage : public QWidget {
  Q_OBJECT
public:
  explicit StartPage(QWidget* parent = nullptr);
  /// Newest first.
  void setRecent(std::vector<RecentSite> sites);

Q_SIGNALS:
  void demoRequested();
  void newRequested();
  void openRequested();
  void recentRequested(const QString& path);
  void forgetRequested(const QString& path);

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslate();

  QLabel name_;
  QLabel sentence_;
  BigButton demo_;
  BigButton new_;
  BigButton open_;
  RecentList recent_;
};

}  // namespace tessera::ui
