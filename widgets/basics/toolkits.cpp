#include "widgets/basics/toolkits.h"

#include <vtkVersion.h>

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>

#include "widgets/basics/gl_support.h"

namespace remount::widgets {

QString toolkit_versions() {
  return QStringLiteral("Qt %1, VTK %2").arg(QLatin1String(qVersion()), QLatin1String(vtkVersion::GetVTKVersion()));
}

QString opengl_name() {
  if (!missing_gl_reason().isEmpty()) return {};
  QOpenGLContext context;
  QOffscreenSurface surface;
  if (!context.create()) return {};
  surface.setFormat(context.format());
  surface.create();
  if (!context.makeCurrent(&surface)) return {};
  const auto* renderer = reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER));
  QString name =
      QStringLiteral("OpenGL %1.%2").arg(context.format().majorVersion()).arg(context.format().minorVersion());
  if (renderer != nullptr) name += QStringLiteral(", %1").arg(QString::fromUtf8(renderer));
  context.doneCurrent();
  return name;
}

}  // namespace remount::widgets
