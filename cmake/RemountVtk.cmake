# Qt 6 and VTK together. Debian 12 builds VTK's Qt module with Qt 5; the same sources compile against Qt 6 unchanged,
# so that module is built here from VTK's own sources, which packaging/setup fetches (see docs/adr/0004-pcl-vtk-qt6.md).
# Where VTK comes with a Qt 6 module of its own, that one is used.
find_package(Qt6 REQUIRED COMPONENTS Widgets OpenGL OpenGLWidgets)
include(RemountMoc)
# Named one by one: a second find_package(VTK) would overwrite VTK_LIBRARIES.
set(REMOUNT_VTK_PARTS CommonCore CommonDataModel CommonTransforms InteractionStyle InteractionWidgets
    RenderingAnnotation RenderingCore RenderingFreeType RenderingOpenGL2 RenderingUI)
find_package(VTK REQUIRED COMPONENTS ${REMOUNT_VTK_PARTS})
set(REMOUNT_VTK_TARGETS ${REMOUNT_VTK_PARTS})
list(TRANSFORM REMOUNT_VTK_TARGETS PREPEND "VTK::")

set(REMOUNT_VTK_QT_SOURCE_DIR "${CMAKE_SOURCE_DIR}/build/vtk-qt-source/GUISupport/Qt" CACHE PATH
    "VTK's GUISupport/Qt sources, for a VTK that was not built with Qt 6")

if(VTK_QT_VERSION EQUAL 6)
  find_package(VTK REQUIRED COMPONENTS GUISupportQt)
  add_library(remount_vtk_qt INTERFACE)
  target_link_libraries(remount_vtk_qt INTERFACE VTK::GUISupportQt)
else()
  if(NOT EXISTS "${REMOUNT_VTK_QT_SOURCE_DIR}/QVTKOpenGLNativeWidget.cxx")
    message(FATAL_ERROR "This VTK has no Qt 6 module and its sources are not in ${REMOUNT_VTK_QT_SOURCE_DIR}. "
      "Run packaging/setup, which fetches them, set REMOUNT_VTK_QT_SOURCE_DIR, or configure with -DREMOUNT_BUILD_GUI=OFF.")
  endif()
  set(vtk_qt_classes QVTKInteractor QVTKInteractorAdapter QVTKOpenGLNativeWidget QVTKRenderWindowAdapter
      vtkEventQtSlotConnect vtkQtConnection)
  # AUTOMOC sees only headers that are listed.
  set(vtk_qt_headers QVTKInteractorInternal.h QVTKInteractor.h QVTKOpenGLNativeWidget.h QVTKRenderWindowAdapter.h
      vtkQtConnection.h)
  list(TRANSFORM vtk_qt_classes APPEND ".cxx")
  set(vtk_qt_files ${vtk_qt_classes} ${vtk_qt_headers})
  list(TRANSFORM vtk_qt_files PREPEND "${REMOUNT_VTK_QT_SOURCE_DIR}/")
  add_library(remount_vtk_qt STATIC ${vtk_qt_files})
  remount_moc(remount_vtk_qt)
  include(GenerateExportHeader)
  # From VTK 9.3 on its classes stand in a namespace that this header of its build names.
  set(vtk_namespace "#if __has_include(<vtkABINamespace.h>)\n#include <vtkABINamespace.h>\n#endif\n")
  generate_export_header(remount_vtk_qt BASE_NAME vtkGUISupportQt CUSTOM_CONTENT_FROM_VARIABLE vtk_namespace
    EXPORT_FILE_NAME ${CMAKE_BINARY_DIR}/generated/vtk_qt/vtkGUISupportQtModule.h)
  target_compile_definitions(remount_vtk_qt PUBLIC VTKGUISUPPORTQT_STATIC_DEFINE PRIVATE QT_NO_KEYWORDS)
  target_compile_options(remount_vtk_qt PRIVATE -w)
  target_include_directories(remount_vtk_qt SYSTEM PUBLIC ${REMOUNT_VTK_QT_SOURCE_DIR} ${CMAKE_BINARY_DIR}/generated/vtk_qt)
  target_link_libraries(remount_vtk_qt PUBLIC Qt6::Widgets Qt6::OpenGL Qt6::OpenGLWidgets ${REMOUNT_VTK_TARGETS})
endif()
