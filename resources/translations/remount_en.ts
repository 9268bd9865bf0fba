<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>remount::gui::PairsFeature</name>
    <message numerus="yes">
        <source>%n pairs a second</source>
        <translation>
            <numerusform>%n pair a second</numerusform>
            <numerusform>%n pairs a second</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>remount::gui::ProjectFeature</name>
    <message numerus="yes">
        <source>%n decision(s) about pairs</source>
        <translation>
            <numerusform>%n decision about pairs</numerusform>
            <numerusform>%n decisions about pairs</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>remount::gui::ProjectKeeper</name>
    <message numerus="yes">
        <source>a calibration with %n pair(s)</source>
        <translation>
            <numerusform>a calibration with %n pair</numerusform>
            <numerusform>a calibration with %n pairs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n decision(s) of yours</source>
        <translation>
            <numerusform>%n decision of yours</numerusform>
            <numerusform>%n decisions of yours</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>remount::gui::ask_to_replace</name>
    <message numerus="yes">
        <source>%n file(s) exist already. Replace?</source>
        <translation>
            <numerusform>%n file exists already. Replace it?</numerusform>
            <numerusform>%n files exist already. Replace them?</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>remount::gui::recovery</name>
    <message numerus="yes">
        <source>%n minute(s) ago</source>
        <translation>
            <numerusform>%n minute ago</numerusform>
            <numerusform>%n minutes ago</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hour(s) ago</source>
        <translation>
            <numerusform>%n hour ago</numerusform>
            <numerusform>%n hours ago</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>remount::gui::steps</name>
    <message numerus="yes">
        <source>%n pairs</source>
        <translation>
            <numerusform>%n pair</numerusform>
            <numerusform>%n pairs</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>remount::widgets::DrivePanel</name>
    <message numerus="yes">
        <source>%n gaps, the longest %1 s</source>
        <translation>
            <numerusform>%n gap, the longest %1 s</numerusform>
            <numerusform>%n gaps, the longest %1 s</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>remount::widgets::PairsPanel</name>
    <message numerus="yes">
        <source>%n pairs</source>
        <translation>
            <numerusform>%n pair</numerusform>
            <numerusform>%n pairs</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>remount::widgets::ResidualsPanel</name>
    <message numerus="yes">
        <source>Reject %n marked</source>
        <translation>
            <numerusform>Reject %n marked</numerusform>
            <numerusform>Reject %n marked</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n outside: double click</source>
        <translation>
            <numerusform>%n outside: double click</numerusform>
            <numerusform>%n outside: double click</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n without a value</source>
        <translation>
            <numerusform>%n without a value</numerusform>
            <numerusform>%n without a value</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>remount::widgets::ResultPanel</name>
    <message numerus="yes">
        <source>%n pairs: %1 accepted, %2 rejected</source>
        <translation>
            <numerusform>%n pair: %1 accepted, %2 rejected</numerusform>
            <numerusform>%n pairs: %1 accepted, %2 rejected</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>remount::widgets::SessionListModel</name>
    <message numerus="yes">
        <source>%n scans in %1</source>
        <translation>
            <numerusform>%n scan in %1</numerusform>
            <numerusform>%n scans in %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>remount::widgets::SessionsBelowDialog</name>
    <message numerus="yes">
        <source>%1 is no session itself, but %n session(s) lie in it. Open together those of one vehicle between which the LiDAR was not moved.</source>
        <translation>
            <numerusform>%1 is no session itself, but one session lies in it. Open it?</numerusform>
            <numerusform>%1 is no session itself, but %n sessions lie in it. Open together those of one vehicle between which the LiDAR was not moved.</numerusform>
        </translation>
    </message>
</context>
</TS>
