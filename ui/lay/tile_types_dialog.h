// The site's tile types: made, changed and deleted together as one step, drawn while they are edited.
#pragma once

#include <QDialog>
#include <functional>
#include <string>
#include <vector>

#include "ui/base/site_document.h"

class QAction;
class QDialogButtonBox;
class QLabel;
class QListWidget;
class QMenu;
class QPushButton;
class QToolBar;
class QToolButton;

namespace tessera::ui {

class TypeForm;
class TypePicture;

class TileTypesDialog : public QDialog {
  Q_OBJECT
public:
  /// The document must outlive it.
  explicit TileTypesDialog(SiteDocument& document, QWidget* parent = nullptr);

  /// Lets the type of that name be edited.
  void showType(const std::string& type);
  /// Whether the operator agrees that registered UIDs are dropped; asks with a message box unless set.
  void setQuestion(std::function<bool(const QString& sentence)> question) { question_ = std::move(question); }

  void accept() override;

protected:
  void changeEvent(QEvent* event) override;

private:
  struct Draft {
    std::string was;  ///< its name in the site; empty: it is new
    floor::TileType type;
  };

  void build();
  void retranslate();
  void fillAddMenu();
  void add(floor::TileType type);
  void duplicate();
  void remove();
  void showCurrent();
  void showSentences();
  [[nodiscard]] int current() const;
  [[nodiscard]] std::string freeName(const std::string& stem) const;
  [[nodiscard]] QString faultOf(const Draft& draft) const;
  [[nodiscard]] QString seamText(const floor::TileType& type) const;
  [[nodiscard]] QString useText(const Draft& draft) const;
  void applyTo(floor::Site& site) const;

  SiteDocument& document_;
  std::vector<Draft> drafts_;
  std::function<bool(const QString&)> question_;
  QToolBar* bar_ = nullptr;
  QToolButton* add_ = nullptr;
  QMenu* addMenu_ = nullptr;
  QAction* duplicate_ = nullptr;
  QAction* delete_ = nullptr;
  QListWidget* list_ = nullptr;
  QWidget* editor_ = nullptr;
  QLabel* empty_ = nullptr;
  TypeForm* form_ = nullptr;
  TypePicture* picture_ = nullptr;
  QLabel* seams_ = nullptr;
  QLabel* use_ = nullptr;
  QLabel* fault_ = nullptr;
  QDialogButtonBox* buttons_ = nullptr;
  bool filling_ = false;
};

}  // namespace tessera::ui
