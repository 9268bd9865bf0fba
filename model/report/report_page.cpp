// The page around what a report says.
#include "algorithms/messages/render.h"
#include "messages/report.h"
#include "model/formats/files/printable_text.h"
#include "model/report/report.h"

namespace remount::report {
namespace {

constexpr const char* kCss =
    "body{font-family:'Noto Sans','Noto Sans CJK SC',sans-serif;color:#222;"
    "max-width:860px;margin:24px auto;padding:0 16px}h1{font-size:22px}img,svg{max-width:100%;height:auto}"
    "h2{font-size:16px;margin-top:26px;border-bottom:1px solid #ccc}table{border-collapse:collapse;font-size:12px}"
    "td,th{padding:2px 8px;border:1px solid #d5d8dd;text-align:right}th{background:#f0f2f5}td{white-space:nowrap}"
    "td.text,th.text{text-align:left}td.text{white-space:normal;overflow-wrap:anywhere}"
    ".weak{color:#777}.warn{color:#9a4a00}pre{font-size:11px;background:#f6f7f9;padding:8px}";

}  // namespace

std::string report_page(const std::string& body, const ReportStyle& style) {
  return "<!DOCTYPE html>\n<html lang=\"" + std::string(style.language == Language::Chinese ? "zh-CN" : "en") +
         "\"><head><meta charset=\"utf-8\"><title>" +
         formats::escape_html(render(say::report_title(), style.language)) + "</title><style>" + kCss +
         "</style></head>\n<body>\n" + body + "</body></html>\n";
}

std::string report_html(const Report& report, const ReportStyle& style) {
  return report_page(report_body(report, style), style);
}

}  // namespace remount::report
