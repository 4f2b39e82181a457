// Hands that work the wizard as a person does.
#pragma once

#include <QAbstractButton>
#include <QCheckBox>
#include <QLineEdit>
#include <QTest>
#include <QWizard>
#include <stdexcept>
#include <string>

namespace tessera::ui {

class WizardHands {
public:
  explicit WizardHands(QWizard& wizard) : wizard_{wizard} {
    wizard_.show();
    if (!QTest::qWaitForWindowActive(&wizard_)) throw std::runtime_error{"the wizard does not come up"};
  }
  /// Of the page that is shown.
  template <class W>
  W& at(const char* name) {
    auto* found = wizard_.currentPage()->findChild<W*>(QLatin1String{name});
    if (found == nullptr) throw std::runtime_error{std::string{"no "} + name};
    return *found;
  }
  QAbstractButton& button(QWizard::WizardButton which) { return *wizard_.button(which); }
  void click(const char* name) { QTest::mouseClick(&at<QAbstractButton>(name), Qt::LeftButton); }
  void next() {
    const int before = wizard_.currentId();
    QTest::mouseClick(&button(QWizard::NextButton), Qt::LeftButton);
    if (wizard_.currentId() == before) throw std::runtime_error{"the wizard stays on page " + std::to_string(before)};
  }
  void back() { QTest::mouseClick(&button(QWizard::BackButton), Qt::LeftButton); }
  void skip() {
    auto& box = at<QCheckBox>("skipStep");
    if (!box.isChecked()) QTest::mouseClick(&box, Qt::LeftButton, {}, QPoint{8, box.height() / 2});
    next();
  }
  void type(const char* field, const char* text) {
    auto& line = at<QLineEdit>(field);
    line.setFocus();
    line.selectAll();
    QTest::keyClicks(&line, QString::fromUtf8(text));
  }

private:
  QWizard& wizard_;
};

}  // namespace tessera::ui
