# Qt's headers read once for all targets of the window, and with GoogleTest's once for all their tests, in a tree whose files are compiled in
# one go. Only what is outside of the project stands in them, so that each file still includes what it uses of it, which `build/lint` tries
# without them (docs/decisions/0011-build-time.md).
set(TESSERA_STANDARD_HEADERS <algorithm> <array> <chrono> <cmath> <cstdint> <functional> <map> <memory> <optional> <span> <string> <variant> <vector>)
set(TESSERA_COMMON_HEADERS ${TESSERA_STANDARD_HEADERS}
  <QAction> <QApplication> <QCheckBox> <QComboBox> <QDateTime> <QDialog> <QDialogButtonBox> <QDir> <QDockWidget> <QDoubleSpinBox> <QFile>
  <QFileDialog> <QFormLayout> <QHBoxLayout> <QHeaderView> <QImage> <QKeyEvent> <QLabel> <QLineEdit> <QListWidget> <QLocale> <QMenu>
  <QMessageBox> <QPainter> <QPushButton> <QSpinBox> <QStackedWidget> <QTableWidget> <QTimer> <QToolBar> <QToolButton> <QVBoxLayout>)
# Not QTest, which looks at the folder that each test stands in.
set(TESSERA_TEST_HEADERS <gtest/gtest.h> <gmock/gmock.h> <QMainWindow> <QTemporaryDir>)

# Not in a release, where GCC 12 then sees through more of std::string and warns of what cannot be (its bug 105651).
set(precompiling OFF)
if(CMAKE_UNITY_BUILD AND NOT CMAKE_BUILD_TYPE STREQUAL Release)
  set(precompiling ON)
endif()

# tessera_precompiled(NAME HEADERS ... [LIBS ...] [OPTIONS ...]): makes the set called NAME. A target that uses it has all of LIBS, whose
# definitions the compiler compares, and the same OPTIONS.
function(tessera_precompiled NAME)
  cmake_parse_arguments(ARG "" "" "HEADERS;LIBS;OPTIONS" ${ARGN})
  if(precompiling)
    file(CONFIGURE OUTPUT precompiled_${NAME}.cpp CONTENT "// Nothing: its headers are what counts.\n")
    add_library(tessera_precompiled_${NAME} OBJECT "${CMAKE_CURRENT_BINARY_DIR}/precompiled_${NAME}.cpp")
    target_link_libraries(tessera_precompiled_${NAME} PRIVATE ${ARG_LIBS} tessera_options)
    target_compile_options(tessera_precompiled_${NAME} PRIVATE ${ARG_OPTIONS})
    target_precompile_headers(tessera_precompiled_${NAME} PRIVATE ${ARG_HEADERS})
  endif()
endfunction()

# tessera_use_precompiled(NAME TARGET...)
function(tessera_use_precompiled NAME)
  if(precompiling)
    foreach(target IN LISTS ARGN)
      target_precompile_headers(${target} REUSE_FROM tessera_precompiled_${NAME})
    endforeach()
  endif()
endfunction()
