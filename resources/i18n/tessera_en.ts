<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
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
    <name>tessera::ui::SummaryPage</name>
    <message numerus="yes">
        <source>%n step(s) were left out. Open this wizard for the vehicle again to make up for it.</source>
        <translation>
            <numerusform>%n step was left out. Open this wizard for the vehicle again to make up for it.</numerusform>
            <numerusform>%n steps were left out. Open this wizard for the vehicle again to make up for it.</numerusform>
        </translation>
    </message>
</context>
</TS>
