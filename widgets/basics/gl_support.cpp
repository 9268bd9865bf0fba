#include "widgets/basics/gl_support.h"

#include <QVTKOpenGLNativeWidget.h>

#include <QCoreApplication>
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QSurfaceFormat>

namespace remount::widgets {
namespace {
struct GlText {
  Q_DECLARE_TR_FUNCTIONS(remount::widgets::gl_support)
};
}  // namespace

void prepare_gl() {
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
  QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
}

QString missing_gl_reason() {
  const QString platform = QGuiApplication::platformName();
  if (platform == QLatin1String("offscreen") || platform == QLatin1String("minimal"))
    return GlText::tr("the display platform \"%1\" has no OpenGL").arg(platform);
  QOpenGLContext context;
  if (!context.create())
    return GlText::tr("no OpenGL context could be made; over a remote connection, allow GLX or use a local display");
  QOffscreenSurface surface;
  surface.setFormat(context.format());
  surface.create();
  if (!surface.isValid() || !context.makeCurrent(&surface)) return GlText::tr("the OpenGL context cannot be used");
  const QSurfaceFormat format = context.format();
  context.doneCurrent();
  if (format.version() < qMakePair(3, 2))
    return GlText::tr("OpenGL 3.2 is needed, this display offers %1.%2")
        .arg(format.majorVersion())
        .arg(format.minorVersion());
  return {};
}

}  // namespace remount::widgets
