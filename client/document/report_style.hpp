// The style sheet of reports.
#pragma once

namespace cd {

/// Contains no angle brackets, since it stands in a document that is XML, too.
inline constexpr const char* report_style = R"(
@page { size: A4; margin: 14mm }
body { font: 10pt/1.4 sans-serif; color: #111; max-width: 190mm; margin: 0 auto; padding: 4mm;
  print-color-adjust: exact; -webkit-print-color-adjust: exact }
h1 { font-size: 17pt; margin: 0 } h2 { font-size: 13pt; margin: 8mm 0 2mm; break-after: avoid }
table { border-collapse: collapse; margin: 2mm 0; font-size: 9pt }
th, td { border: 1px solid #bbb; padding: 1px 5px; text-align: left; vertical-align: top }
td { overflow-wrap: anywhere } th { background: #eee } tr { break-inside: avoid }
.numbers td { text-align: right } .numbers td:first-child { text-align: left }
.verdict { font-size: 13pt; margin: 3mm 0 } .bad { color: #a01010 } .good { color: #206020 }
.cards { display: grid; grid-template-columns: 1fr 1fr; gap: 4mm }
figure { margin: 0; break-inside: avoid } figure img { width: 100%; border: 1px solid #ccc }
figcaption { font-size: 9pt; overflow-wrap: anywhere }
svg { width: 100%; break-inside: avoid } svg text { font: 11px sans-serif }
.warning { background: #fff3c4; padding: 1mm 2mm; overflow-wrap: anywhere }
.h1 { background: #fde0dd } .h2 { background: #fcb9b2 } .h3 { background: #f58a80 }
.h4 { background: #e0554a; color: #fff }
.viewer { break-inside: avoid }
#page { box-sizing: border-box; width: min(96vw, 1280px); padding: 4mm;
  margin-left: calc(50% - min(48vw, 640px)) }
#page p { max-width: 190mm; margin: 0 auto } .viewer details { font-size: 9pt; color: #555 }
@media print { .viewer { display: none } }
pre { white-space: pre-wrap; overflow-wrap: anywhere; font-size: 8pt; background: #f6f6f6;
  padding: 2mm }
)";

} // namespace cd
