<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>LayEdits</name>
    <message numerus="yes">
        <source>Move %n tile(s)</source>
        <translation>
            <numerusform>Move %n tile</numerusform>
            <numerusform>Move %n tiles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Turn %n tile(s)</source>
        <translation>
            <numerusform>Turn %n tile</numerusform>
            <numerusform>Turn %n tiles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Align %n tile(s)</source>
        <translation>
            <numerusform>Align %n tile</numerusform>
            <numerusform>Align %n tiles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Delete %n tile(s)</source>
        <translation>
            <numerusform>Delete %n tile</numerusform>
            <numerusform>Delete %n tiles</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tessera::desktop::SiteFiles</name>
    <message numerus="yes">
        <source>%1 And %n more.</source>
        <translation>
            <numerusform>%1 And one more.</numerusform>
            <numerusform>%1 And %n more.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tessera::desktop::StepLog</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tessera::ui::CalibratePanel</name>
    <message numerus="yes">
        <source>%n read(s) fit nothing and hardly count.</source>
        <translation>
            <numerusform>%n read fits nothing and hardly counts.</numerusform>
            <numerusform>%n reads fit nothing and hardly count.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tessera::ui::ChangesDialog</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln changes: %1. They are made all together, as one step that can be undone.</source>
        <translation>
            <numerusform>%Ln change: %1. It is made as one step that can be undone.</numerusform>
            <numerusform>%Ln changes: %1. They are made all together, as one step that can be undone.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln new</source>
        <translation>
            <numerusform>%Ln new</numerusform>
            <numerusform>%Ln new</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln changed</source>
        <translation>
            <numerusform>%Ln changed</numerusform>
            <numerusform>%Ln changed</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln moved</source>
        <translation>
            <numerusform>%Ln moved</numerusform>
            <numerusform>%Ln moved</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln removed</source>
        <translation>
            <numerusform>%Ln removed</numerusform>
            <numerusform>%Ln removed</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tessera::ui::EventPanel</name>
    <message numerus="yes">
        <source>The last %n events of this day are listed. Choose a severity or a vehicle to see the earlier ones.</source>
        <translation>
            <numerusform>The last event of this day is listed. Choose a severity or a vehicle to see the earlier ones.</numerusform>
            <numerusform>The last %n events of this day are listed. Choose a severity or a vehicle to see the earlier ones.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tessera::ui::FaultPanel</name>
    <message numerus="yes">
        <source>%n error(s)</source>
        <translation>
            <numerusform>%n error</numerusform>
            <numerusform>%n errors</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warning(s)</source>
        <translation>
            <numerusform>%n warning</numerusform>
            <numerusform>%n warnings</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tessera::ui::KeyPage</name>
    <message numerus="yes">
        <source>A key has 32 hexadecimal digits (0–9, A–F); here are %n.</source>
        <translation>
            <numerusform>A key has 32 hexadecimal digits (0–9, A–F); here is %n.</numerusform>
            <numerusform>A key has 32 hexadecimal digits (0–9, A–F); here are %n.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tessera::ui::LayTool</name>
    <message numerus="yes">
        <source>Lay %n tile(s)</source>
        <translation>
            <numerusform>Lay %n tile</numerusform>
            <numerusform>Lay %n tiles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n tile(s)</source>
        <translation>
            <numerusform>Duplicate %n tile</numerusform>
            <numerusform>Duplicate %n tiles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Paste %n tile(s)</source>
        <translation>
            <numerusform>Paste %n tile</numerusform>
            <numerusform>Paste %n tiles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n tile(s)</source>
        <translation>
            <numerusform>%n tile</numerusform>
            <numerusform>%n tiles</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tessera::ui::LocatingPanel</name>
    <message numerus="yes">
        <source>%1, %n guess(es) shown</source>
        <translation>
            <numerusform>%1, %n guess shown</numerusform>
            <numerusform>%1, %n guesses shown</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>now %1 cm, mean %2 cm, 95 % below %3 cm; NEES %4 (2 is honest), %n sample(s)</source>
        <translation>
            <numerusform>now %1 cm, mean %2 cm, 95 % below %3 cm; NEES %4 (2 is honest), %n sample</numerusform>
            <numerusform>now %1 cm, mean %2 cm, 95 % below %3 cm; NEES %4 (2 is honest), %n samples</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tessera::ui::MagneticLayer</name>
    <message numerus="yes">
        <source>Iron turns the compass %1° to the right (± %2°, %n visit(s))</source>
        <translation>
            <numerusform>Iron turns the compass %1° to the right (± %2°, %n visit)</numerusform>
            <numerusform>Iron turns the compass %1° to the right (± %2°, %n visits)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Iron turns the compass %1° to the left (± %2°, %n visit(s))</source>
        <translation>
            <numerusform>Iron turns the compass %1° to the left (± %2°, %n visit)</numerusform>
            <numerusform>Iron turns the compass %1° to the left (± %2°, %n visits)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tessera::ui::NewSiteDialog</name>
    <message numerus="yes">
        <source>%1 × %2 m, %n tag(s)</source>
        <translation>
            <numerusform>%1 × %2 m, %n tag</numerusform>
            <numerusform>%1 × %2 m, %n tags</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tessera::ui::RadioDialog</name>
    <message numerus="yes">
        <source>The module did not keep %n parameter(s). Write once more; if that does not help, the module may be of another kind or broken.</source>
        <translation>
            <numerusform>The module did not keep %n parameter. Write once more; if that does not help, the module may be of another kind or broken.</numerusform>
            <numerusform>The module did not keep %n parameters. Write once more; if that does not help, the module may be of another kind or broken.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n parameter(s) differ from the site&apos;s; vehicles will not be heard like this. Press “Write the site&apos;s parameters”.</source>
        <translation>
            <numerusform>%n parameter differs from the site&apos;s; vehicles will not be heard like this. Press “Write the site&apos;s parameters”.</numerusform>
            <numerusform>%n parameters differ from the site&apos;s; vehicles will not be heard like this. Press “Write the site&apos;s parameters”.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tessera::ui::ReadersPage</name>
    <message numerus="yes">
        <source>%n reader(s) still to try.</source>
        <translation>
            <numerusform>%n reader still to try.</numerusform>
            <numerusform>%n readers still to try.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tessera::ui::Registrar</name>
    <message numerus="yes">
        <source>Taken back: %n tag(s)</source>
        <translation>
            <numerusform>Taken back: %n tag</numerusform>
            <numerusform>Taken back: %n tags</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tessera::ui::RevisionModel</name>
    <message numerus="yes">
        <source>%n tile(s) laid</source>
        <translation>
            <numerusform>%n tile laid</numerusform>
            <numerusform>%n tiles laid</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n tile(s) moved</source>
        <translation>
            <numerusform>%n tile moved</numerusform>
            <numerusform>%n tiles moved</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n tile(s) taken up</source>
        <translation>
            <numerusform>%n tile taken up</numerusform>
            <numerusform>%n tiles taken up</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n tag(s)</source>
        <translation>
            <numerusform>%n tag</numerusform>
            <numerusform>%n tags</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n zone(s)</source>
        <translation>
            <numerusform>%n zone</numerusform>
            <numerusform>%n zones</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n route(s)</source>
        <translation>
            <numerusform>%n route</numerusform>
            <numerusform>%n routes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n vehicle(s)</source>
        <translation>
            <numerusform>%n vehicle</numerusform>
            <numerusform>%n vehicles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n other change(s)</source>
        <translation>
            <numerusform>%n other change</numerusform>
            <numerusform>%n other changes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tessera::ui::RevisionPanel</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Since %1: %n difference(s). Click one to go there.</source>
        <translation>
            <numerusform>Since %1: %n difference. Click it to go there.</numerusform>
            <numerusform>Since %1: %n differences. Click one to go there.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tessera::ui::SummaryPage</name>
    <message numerus="yes">
        <source>%n step(s) were left out. Open this wizard for the vehicle again to make up for it.</source>
        <translation>
            <numerusform>%n step was left out. Open this wizard for the vehicle again to make up for it.</numerusform>
            <numerusform>%n steps were left out. Open this wizard for the vehicle again to make up for it.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tessera::ui::TilePanel</name>
    <message numerus="yes">
        <source>%n tile(s) laid, none of them chosen.</source>
        <translation>
            <numerusform>%n tile laid, none of them chosen.</numerusform>
            <numerusform>%n tiles laid, none of them chosen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n tile(s) chosen.</source>
        <translation>
            <numerusform>%n tile chosen.</numerusform>
            <numerusform>%n tiles chosen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n type(s).</source>
        <translation>
            <numerusform>%n type.</numerusform>
            <numerusform>%n types.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n tag(s) registered.</source>
        <translation>
            <numerusform>%n tag registered.</numerusform>
            <numerusform>%n tags registered.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tessera::ui::TileTypesDialog</name>
    <message numerus="yes">
        <source>%n tile(s) are of this type: delete them first.</source>
        <translation>
            <numerusform>%n tile is of this type: delete it first.</numerusform>
            <numerusform>%n tiles are of this type: delete them first.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n registered tag(s) lie where the changed types have none: their numbers would be dropped from the site.</source>
        <translation>
            <numerusform>%n registered tag lies where the changed types have none: its number would be dropped from the site.</numerusform>
            <numerusform>%n registered tags lie where the changed types have none: their numbers would be dropped from the site.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n tile(s) are of this type,</source>
        <translation>
            <numerusform>%n tile is of this type,</numerusform>
            <numerusform>%n tiles are of this type,</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n tag(s) on them are registered.</source>
        <translation>
            <numerusform>%n tag on them is registered.</numerusform>
            <numerusform>%n tags on them are registered.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of their numbers would be dropped.</source>
        <translation>
            <numerusform>%n of their numbers would be dropped.</numerusform>
            <numerusform>%n of their numbers would be dropped.</numerusform>
        </translation>
    </message>
</context>
</TS>
