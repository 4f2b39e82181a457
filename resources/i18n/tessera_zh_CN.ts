<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>ChangeMarks</name>
    <message>
        <source>Added</source>
        <translation>新增</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Moved</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>更改</translation>
    </message>
</context>
<context>
    <name>Core</name>
    <message>
        <source>slowing down before the corner</source>
        <translation>转角前减速</translation>
    </message>
    <message>
        <source>slowing down before the end</source>
        <translation>终点前减速</translation>
    </message>
    <message>
        <source>no faster over this slow a radio</source>
        <translation>受无线速率限制</translation>
    </message>
    <message>
        <source>slowly, because its place is not well known</source>
        <translation>位置不够确定，慢速行驶</translation>
    </message>
    <message>
        <source>slowly, until its nose points along the way</source>
        <translation>慢速行驶，直到车头对准行驶方向</translation>
    </message>
    <message>
        <source>as asked for</source>
        <translation>按设定速度</translation>
    </message>
    <message>
        <source>On the way to the route: %1 m/s, %2.</source>
        <translation>正在驶向路径：%1 m/s，%2。</translation>
    </message>
    <message>
        <source>On leg %1 of %2, %3 m to go: %4 m/s, %5.</source>
        <translation>在第 %1 路段（共 %2 段），剩余 %3 m：%4 m/s，%5。</translation>
    </message>
    <message>
        <source>Turning on the spot by %1° to leg %2 of %3.</source>
        <translation>原地转向 %1°，对准第 %2 路段（共 %3 段）。</translation>
    </message>
    <message>
        <source>At the end of the route.</source>
        <translation>已到路径终点。</translation>
    </message>
    <message>
        <source>Standing still, because its place is unknown.</source>
        <translation>位置未知，静止等待。</translation>
    </message>
    <message>
        <source>the address</source>
        <translation>地址</translation>
    </message>
    <message>
        <source>the wheel diameter</source>
        <translation>轮径</translation>
    </message>
    <message>
        <source>the track width</source>
        <translation>轮距</translation>
    </message>
    <message>
        <source>the encoder&apos;s resolution</source>
        <translation>编码器分辨率</translation>
    </message>
    <message>
        <source>%1 counts a turn</source>
        <translation>每转 %1 个计数</translation>
    </message>
    <message>
        <source>the highest speed</source>
        <translation>最高速度</translation>
    </message>
    <message>
        <source>the highest turn rate</source>
        <translation>最高转向速度</translation>
    </message>
    <message>
        <source>the stop distance</source>
        <translation>停车距离</translation>
    </message>
    <message>
        <source>the magnetic declination</source>
        <translation>磁偏角</translation>
    </message>
    <message>
        <source>%1/65536 turn</source>
        <translation>%1/65536 圈</translation>
    </message>
    <message>
        <source>the compass&apos; offset on x</source>
        <translation>罗盘 x 轴偏移</translation>
    </message>
    <message>
        <source>the compass&apos; offset on y</source>
        <translation>罗盘 y 轴偏移</translation>
    </message>
    <message>
        <source>the compass&apos; matrix entry xx</source>
        <translation>罗盘矩阵元素 xx</translation>
    </message>
    <message>
        <source>the compass&apos; matrix entry xy</source>
        <translation>罗盘矩阵元素 xy</translation>
    </message>
    <message>
        <source>the compass&apos; matrix entry yx</source>
        <translation>罗盘矩阵元素 yx</translation>
    </message>
    <message>
        <source>the compass&apos; matrix entry yy</source>
        <translation>罗盘矩阵元素 yy</translation>
    </message>
    <message>
        <source>the compass&apos; mounting angle</source>
        <translation>罗盘安装角</translation>
    </message>
    <message>
        <source>the number of tag readers</source>
        <translation>读卡器数量</translation>
    </message>
    <message>
        <source>the radio&apos;s channel</source>
        <translation>无线信道</translation>
    </message>
    <message>
        <source>the code of the radio&apos;s air rate</source>
        <translation>无线空中速率代码</translation>
    </message>
    <message>
        <source>the code of the radio&apos;s baud rate</source>
        <translation>无线模块波特率代码</translation>
    </message>
    <message>
        <source>the voltage of a low battery</source>
        <translation>低电量电压</translation>
    </message>
    <message>
        <source>the acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>the compass&apos; share in the heading</source>
        <translation>罗盘在航向中的权重</translation>
    </message>
    <message>
        <source>the count of refused frames</source>
        <translation>被拒绝的帧数</translation>
    </message>
    <message>
        <source>the count of damaged frames</source>
        <translation>损坏的帧数</translation>
    </message>
    <message>
        <source>the longest tick</source>
        <translation>最长周期</translation>
    </message>
    <message>
        <source>the stack never used</source>
        <translation>从未使用的栈空间</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 字节</translation>
    </message>
    <message>
        <source>the outcome code of the last compass calibration</source>
        <translation>上次罗盘校准的结果代码</translation>
    </message>
    <message>
        <source>parameter %1</source>
        <translation>参数 %1</translation>
    </message>
    <message>
        <source>calibrating the compass</source>
        <translation>校准罗盘</translation>
    </message>
    <message>
        <source>restarting</source>
        <translation>重启</translation>
    </message>
    <message>
        <source>restoring the factory&apos;s settings</source>
        <translation>恢复出厂设置</translation>
    </message>
    <message>
        <source>action %1</source>
        <translation>操作 %1</translation>
    </message>
    <message>
        <source>reading %1</source>
        <translation>读取%1</translation>
    </message>
    <message>
        <source>setting %1 to %2</source>
        <translation>将%1设为 %2</translation>
    </message>
    <message>
        <source>done</source>
        <translation>已完成</translation>
    </message>
    <message>
        <source>done, the value is %1</source>
        <translation>已完成，值为 %1</translation>
    </message>
    <message>
        <source>started</source>
        <translation>已开始</translation>
    </message>
    <message>
        <source>refused, the vehicle does not know it</source>
        <translation>被拒绝，车辆不支持此项</translation>
    </message>
    <message>
        <source>refused, the value is out of range</source>
        <translation>被拒绝，值超出范围</translation>
    </message>
    <message>
        <source>refused, the vehicle is busy</source>
        <translation>被拒绝，车辆正忙</translation>
    </message>
    <message>
        <source>failed on the vehicle</source>
        <translation>车辆执行失败</translation>
    </message>
    <message>
        <source>answered in an unknown way</source>
        <translation>应答内容无法识别</translation>
    </message>
    <message>
        <source>%1 stopped: a wheel does not turn although it is driven. Free it, then clear.</source>
        <translation>%1 已停车：有车轮受驱动但不转动。请排除卡滞，然后清除故障。</translation>
    </message>
    <message>
        <source>%1 drives its wheels again.</source>
        <translation>%1 的车轮恢复正常驱动。</translation>
    </message>
    <message>
        <source>%1 stopped: a wheel encoder contradicts the drive. Check it, then clear.</source>
        <translation>%1 已停车：车轮编码器与驱动不一致。请检查编码器，然后清除故障。</translation>
    </message>
    <message>
        <source>%1 trusts its wheel encoders again.</source>
        <translation>%1 的车轮编码器恢复正常。</translation>
    </message>
    <message>
        <source>%1 gets no answer from its compass and keeps its heading by the wheels.</source>
        <translation>%1 的罗盘无应答，改由车轮推算航向。</translation>
    </message>
    <message>
        <source>%1 hears its compass again.</source>
        <translation>%1 的罗盘恢复应答。</translation>
    </message>
    <message>
        <source>%1 measures a magnetic field that cannot be right and keeps its heading by the wheels.</source>
        <translation>%1 测得的磁场不正常，改由车轮推算航向。</translation>
    </message>
    <message>
        <source>%1 measures a plausible magnetic field again.</source>
        <translation>%1 测得的磁场恢复正常。</translation>
    </message>
    <message>
        <source>%1 gets no answer from one of its tag readers.</source>
        <translation>%1 有读卡器无应答。</translation>
    </message>
    <message>
        <source>%1 hears all its tag readers again.</source>
        <translation>%1 的所有读卡器恢复应答。</translation>
    </message>
    <message>
        <source>%1 has a low battery.</source>
        <translation>%1 电池电量低。</translation>
    </message>
    <message>
        <source>%1 has enough battery again.</source>
        <translation>%1 电池电量恢复正常。</translation>
    </message>
    <message>
        <source>%1 cannot read or write its settings; what was set is lost at the next start. It stands, even when cleared, if it could not read them.</source>
        <translation>%1 无法读取或写入其设置；已设置的内容在下次启动时会丢失。若无法读取，即使清除故障，车辆仍会停车。</translation>
    </message>
    <message>
        <source>%1 reads and writes its settings again.</source>
        <translation>%1 恢复读写其设置。</translation>
    </message>
    <message>
        <source>%1 was restarted by its watchdog and stands until it is cleared.</source>
        <translation>%1 被看门狗重启，清除故障前保持停车。</translation>
    </message>
    <message>
        <source>%1 was cleared after its watchdog&apos;s restart.</source>
        <translation>%1 的看门狗重启故障已清除。</translation>
    </message>
    <message>
        <source>%1 has a radio module that does not take its parameters.</source>
        <translation>%1 的无线模块不接受参数。</translation>
    </message>
    <message>
        <source>%1 has a radio module that takes its parameters again.</source>
        <translation>%1 的无线模块恢复接受参数。</translation>
    </message>
    <message>
        <source>%1 refused a command that does not bear its key: a changed byte, or somebody else on the channel.</source>
        <translation>%1 拒绝了一条密钥不符的指令：字节被改动，或信道上有其他发射机。</translation>
    </message>
    <message>
        <source>%1 gets no more forged commands.</source>
        <translation>%1 不再收到伪造的指令。</translation>
    </message>
    <message>
        <source>%1 refused a command that it had seen before: somebody repeats old frames.</source>
        <translation>%1 拒绝了一条重复的指令：有人在重放旧的帧。</translation>
    </message>
    <message>
        <source>%1 gets no more replayed commands.</source>
        <translation>%1 不再收到重放的指令。</translation>
    </message>
    <message>
        <source>%1 dropped tag reads because they were not fetched in time.</source>
        <translation>%1 的标签读取记录因未及时取走而丢弃。</translation>
    </message>
    <message>
        <source>%1 has its tag reads fetched in time again.</source>
        <translation>%1 的标签读取记录恢复及时取走。</translation>
    </message>
    <message>
        <source>%1 gets no answer from one of its rangers and does not drive forwards.</source>
        <translation>%1 有测距传感器无应答，车辆不会前进。</translation>
    </message>
    <message>
        <source>%1 hears all its rangers again.</source>
        <translation>%1 的所有测距传感器恢复应答。</translation>
    </message>
    <message>
        <source>%1 did not answer: %2 is not confirmed.</source>
        <translation>%1 未应答：“%2”未得到确认。</translation>
    </message>
    <message>
        <source>%1, %2: %3.</source>
        <translation>%1，%2：%3。</translation>
    </message>
    <message>
        <source>its power was switched on</source>
        <translation>接通电源</translation>
    </message>
    <message>
        <source>its watchdog ended a hang</source>
        <translation>看门狗中止了死机</translation>
    </message>
    <message>
        <source>it was told to</source>
        <translation>按指令重启</translation>
    </message>
    <message>
        <source>the cause is unknown</source>
        <translation>原因未知</translation>
    </message>
    <message>
        <source>The port %1 is open.</source>
        <translation>端口 %1 已打开。</translation>
    </message>
    <message>
        <source>The port %1 is back.</source>
        <translation>端口 %1 已恢复。</translation>
    </message>
    <message>
        <source>The radio&apos;s port is lost: %1.</source>
        <translation>无线模块的端口已断开：%1。</translation>
    </message>
    <message>
        <source>The port %1 is lost: %2.</source>
        <translation>端口 %1 已断开：%2。</translation>
    </message>
    <message>
        <source>%1 Vehicles stop by themselves; it is taken up again as soon as it is there.</source>
        <translation>%1车辆会自行停车；端口恢复后将自动重新连接。</translation>
    </message>
    <message>
        <source>An order is for the vehicle %1, which is not looked after here.</source>
        <translation>有一条指令发给车辆 %1，但该车辆不由此上位机管理。</translation>
    </message>
    <message>
        <source>%1: too many requests are waiting already.</source>
        <translation>%1：等待处理的请求过多。</translation>
    </message>
    <message>
        <source>The site&apos;s vehicles or its radio have changed: supervision must be restarted to take them over.</source>
        <translation>场地的车辆或无线设置已更改：需要重新启动监控才能生效。</translation>
    </message>
    <message>
        <source>Damaged bytes come from the radio and are dropped: noise, two senders at once, or a changed byte.</source>
        <translation>从无线模块收到损坏的字节，已丢弃：可能是噪声、两台发射机同时发送，或字节被改动。</translation>
    </message>
    <message>
        <source>Somebody who does not belong to this site sends on the radio channel; the frames are dropped.</source>
        <translation>无线信道上有不属于本场地的发射机；其帧已丢弃。</translation>
    </message>
    <message>
        <source>No more damaged bytes from the radio; %1 stretches were dropped.</source>
        <translation>不再从无线模块收到损坏的字节；共丢弃 %1 段。</translation>
    </message>
    <message>
        <source>No more strangers on the radio channel; %1 frames were dropped.</source>
        <translation>无线信道上不再有外来发射机；共丢弃 %1 帧。</translation>
    </message>
    <message>
        <source>Vehicle %1</source>
        <translation>车辆 %1</translation>
    </message>
    <message>
        <source>No more forged frames in the name of %1; %2 were dropped.</source>
        <translation>不再收到冒用 %1 名义的伪造帧；共丢弃 %2 帧。</translation>
    </message>
    <message>
        <source>No more replayed frames in the name of %1; %2 were dropped.</source>
        <translation>不再收到冒用 %1 名义的重放帧；共丢弃 %2 帧。</translation>
    </message>
    <message>
        <source>No more senseless frames in the name of %1; %2 were dropped.</source>
        <translation>不再收到以 %1 名义发送的无意义帧；共丢弃 %2 帧。</translation>
    </message>
    <message>
        <source>%1 is no longer driven by hand.</source>
        <translation>%1 的手动驾驶已结束。</translation>
    </message>
    <message>
        <source>%1 has reached the end of the route %2.</source>
        <translation>%1 已到达路径 %2 的终点。</translation>
    </message>
    <message>
        <source>%1 waits: it was told to pause.</source>
        <translation>%1 正在等待：已按指令暂停。</translation>
    </message>
    <message>
        <source>%1 waits: the radio&apos;s port is lost.</source>
        <translation>%1 正在等待：无线模块的端口已断开。</translation>
    </message>
    <message>
        <source>%1 waits: the radio&apos;s port is not open.</source>
        <translation>%1 正在等待：无线模块的端口未打开。</translation>
    </message>
    <message>
        <source>%1 waits: the port %2 is lost.</source>
        <translation>%1 正在等待：端口 %2 已断开。</translation>
    </message>
    <message>
        <source>%1 waits: the port %2 is not open.</source>
        <translation>%1 正在等待：端口 %2 未打开。</translation>
    </message>
    <message>
        <source>%1 waits: it has not answered our call yet.</source>
        <translation>%1 正在等待：尚未应答呼叫。</translation>
    </message>
    <message>
        <source>%1 waits: it cannot be talked to, see the events.</source>
        <translation>%1 正在等待：无法与其通信，请查看事件。</translation>
    </message>
    <message>
        <source>%1 waits: it has not answered for %2 s.</source>
        <translation>%1 正在等待：已有 %2 秒未应答。</translation>
    </message>
    <message>
        <source>%1 waits: its first report has not come yet.</source>
        <translation>%1 正在等待：尚未收到第一份报告。</translation>
    </message>
    <message>
        <source>%1 waits: a fault holds it until it is cleared.</source>
        <translation>%1 正在等待：因故障停车，需要清除故障。</translation>
    </message>
    <message>
        <source>%1 waits: it calibrates its compass.</source>
        <translation>%1 正在等待：正在校准罗盘。</translation>
    </message>
    <message>
        <source>%1 waits: one of its rangers does not answer.</source>
        <translation>%1 正在等待：有测距传感器无应答。</translation>
    </message>
    <message>
        <source>%1 waits: an obstacle stood before it.</source>
        <translation>%1 正在等待：刚才前方有障碍物。</translation>
    </message>
    <message>
        <source>%1 waits: an obstacle stands %2 cm before it.</source>
        <translation>%1 正在等待：前方 %2 cm 处有障碍物。</translation>
    </message>
    <message>
        <source>%1 waits: its place is not known. Put it where it reads tags.</source>
        <translation>%1 正在等待：位置未知。请将其放到能读到标签的地方。</translation>
    </message>
    <message>
        <source>%1 waits: %2</source>
        <translation>%1 正在等待：%2</translation>
    </message>
    <message>
        <source>%1 waits: its last command ran out.</source>
        <translation>%1 正在等待：上一条指令已过期。</translation>
    </message>
    <message>
        <source>Driven by hand.</source>
        <translation>正在手动驾驶。</translation>
    </message>
    <message>
        <source>host build</source>
        <translation>主机版</translation>
    </message>
    <message>
        <source>other hardware</source>
        <translation>其他硬件</translation>
    </message>
    <message>
        <source>%1 answers again.</source>
        <translation>%1 恢复应答。</translation>
    </message>
    <message>
        <source>%1 now bears the site&apos;s key.</source>
        <translation>%1 的密钥现已与场地一致。</translation>
    </message>
    <message>
        <source>%1 now speaks our version of the protocol.</source>
        <translation>%1 的协议版本现已与本程序一致。</translation>
    </message>
    <message>
        <source>%1.%2.%3 on %4</source>
        <translation>%1.%2.%3（%4）</translation>
    </message>
    <message>
        <source>%1 is in touch again after its restart.</source>
        <translation>%1 重启后恢复联系。</translation>
    </message>
    <message>
        <source>%1 has restarted while it was out of touch.</source>
        <translation>%1 在失去联系期间重启过。</translation>
    </message>
    <message>
        <source>%1 is identified: firmware %2, %3 tag readers, %4 rangers.</source>
        <translation>%1 已识别：固件 %2，读卡器 %3 个，测距传感器 %4 个。</translation>
    </message>
    <message>
        <source>%1 has %2 tag readers, the site says %3.</source>
        <translation>%1 有 %2 个读卡器，场地中为 %3 个。</translation>
    </message>
    <message>
        <source>%1 answers with another key than the site&apos;s; it is not commanded. Commission it, or mend the site.</source>
        <translation>%1 应答时使用的密钥与场地不同，不会向其发送指令。请设置该车辆，或更正场地中的密钥。</translation>
    </message>
    <message>
        <source>%1 speaks version %2 of the protocol, this program speaks %3; it is not commanded.</source>
        <translation>%1 使用协议版本 %2，本程序使用版本 %3，不会向其发送指令。</translation>
    </message>
    <message>
        <source>%1 has restarted (%2); it is called again.</source>
        <translation>%1 已重启（%2），正在重新呼叫。</translation>
    </message>
    <message>
        <source>%1 has not answered for %2 s; it stops by itself when its command runs out, and is called until it answers.</source>
        <translation>%1 已有 %2 秒未应答；指令过期后车辆会自行停车，并将持续呼叫直到其应答。</translation>
    </message>
    <message>
        <source>A frame in the name of %1 does not bear its key and was dropped: forged, changed on the way, or of an earlier meeting.</source>
        <translation>以 %1 名义发送的一帧密钥不符，已丢弃：可能是伪造、途中被改动，或属于之前的会话。</translation>
    </message>
    <message>
        <source>A frame of %1 came a second time and was dropped: somebody repeats old frames.</source>
        <translation>%1 的一帧重复到达，已丢弃：有人在重放旧的帧。</translation>
    </message>
    <message>
        <source>A frame in the name of %1 makes no sense and was dropped.</source>
        <translation>以 %1 名义发送的一帧没有意义，已丢弃。</translation>
    </message>
    <message>
        <source>%1 tag reads of %2 were lost.</source>
        <translation>丢失 %1 条 %2 的标签读取记录。</translation>
    </message>
    <message>
        <source>%1 read the tag %2, which the site does not have.</source>
        <translation>%1 读到标签 %2，该标签不在本场地中。</translation>
    </message>
    <message>
        <source>%1 is located.</source>
        <translation>%1 已定位。</translation>
    </message>
    <message>
        <source>%1 has lost its place and stands.</source>
        <translation>%1 失去定位，已停车。</translation>
    </message>
    <message>
        <source>%1 has found its place again.</source>
        <translation>%1 恢复定位。</translation>
    </message>
    <message>
        <source>%1 stands before an obstacle.</source>
        <translation>%1 前方有障碍物，已停车。</translation>
    </message>
    <message>
        <source>%1 stands before an obstacle, %2 cm away.</source>
        <translation>%1 前方 %2 cm 处有障碍物，已停车。</translation>
    </message>
    <message>
        <source>The obstacle before %1 is gone.</source>
        <translation>%1 前方的障碍物已消失。</translation>
    </message>
    <message>
        <source>%1 stopped by itself, because no command reached it in time.</source>
        <translation>%1 已自行停车，因为未及时收到指令。</translation>
    </message>
    <message>
        <source>%1 takes commands again.</source>
        <translation>%1 恢复接收指令。</translation>
    </message>
    <message>
        <source>%1: the site has no route called &quot;%2&quot;.</source>
        <translation>%1：场地中没有名为“%2”的路径。</translation>
    </message>
    <message>
        <source>%1: the speed for the route %2 must be above zero.</source>
        <translation>%1：路径 %2 的速度必须大于零。</translation>
    </message>
    <message>
        <source>%1: the route %2 needs at least two different points.</source>
        <translation>%1：路径 %2 至少需要两个不同的点。</translation>
    </message>
    <message>
        <source>%1 starts on the route %2 at %3 m/s.</source>
        <translation>%1 开始沿路径 %2 行驶，速度 %3 m/s。</translation>
    </message>
    <message>
        <source>%1: it cannot pause, as it runs no route.</source>
        <translation>%1：无法暂停，因为没有在运行路径。</translation>
    </message>
    <message>
        <source>%1 pauses on the route %2.</source>
        <translation>%1 在路径 %2 上暂停。</translation>
    </message>
    <message>
        <source>%1: it cannot go on, as it does not pause.</source>
        <translation>%1：无法继续，因为没有暂停。</translation>
    </message>
    <message>
        <source>%1 goes on along the route %2.</source>
        <translation>%1 沿路径 %2 继续行驶。</translation>
    </message>
    <message>
        <source>%1 gives up the route %2 by order.</source>
        <translation>%1 按指令放弃路径 %2。</translation>
    </message>
    <message>
        <source>%1: a speed to drive at by hand is no number.</source>
        <translation>%1：手动驾驶的速度不是有效数值。</translation>
    </message>
    <message>
        <source>%1: it cannot be driven by hand while it is on the route %2. Stop it first.</source>
        <translation>%1：正在路径 %2 上，无法手动驾驶。请先停止。</translation>
    </message>
    <message>
        <source>%1: it cannot be driven by hand, as it is not in touch.</source>
        <translation>%1：未建立联系，无法手动驾驶。</translation>
    </message>
    <message>
        <source>%1: it was stopped. Let the keys go before you drive it by hand again.</source>
        <translation>%1：已停止。请先松开按键，再重新手动驾驶。</translation>
    </message>
    <message>
        <source>%1 is driven by hand.</source>
        <translation>%1 正在手动驾驶。</translation>
    </message>
    <message>
        <source>%1: it cannot do that while it drives. Stop it first.</source>
        <translation>%1：行驶中无法执行此操作。请先停止。</translation>
    </message>
    <message>
        <source>No vehicle has been heard for %1 s, though some were before: check the vehicles&apos; power, the aerials, the distance, and that the module&apos;s jumpers M0 and M1 are in normal mode (both 0).</source>
        <translation>已有 %1 秒未收到任何车辆的信号，而此前曾收到：请检查车辆电源、天线、距离，以及模块的跳线 M0 和 M1 是否处于正常模式（均为 0）。</translation>
    </message>
    <message>
        <source>Bytes come from the module, but no whole frame: its UART may run at another rate than the site&apos;s %1 baud. Read its parameters.</source>
        <translation>收到模块的字节，但没有完整的帧：模块的 UART 速率可能与场地的 %1 波特不同。请读取模块参数。</translation>
    </message>
    <message>
        <source>Bytes come from the module, but no whole frame: another sender is on the channel, or the vehicles&apos; air rate differs. Switch the other one off, or choose another channel.</source>
        <translation>收到模块的字节，但没有完整的帧：信道上有其他发射机，或车辆的空中速率不同。请关闭其他发射机，或更换信道。</translation>
    </message>
    <message>
        <source>Nothing is heard of any vehicle though the module matches the site: check the vehicles&apos; channel, their power, the aerials.</source>
        <translation>模块与场地一致，但未收到任何车辆的信号：请检查车辆的信道、电源和天线。</translation>
    </message>
    <message>
        <source>Nothing is heard of any vehicle: read the module&apos;s parameters to see whether they match the site, then put its jumpers M0 and M1 back to normal mode (both 0).</source>
        <translation>未收到任何车辆的信号：请读取模块参数，检查是否与场地一致，然后将跳线 M0 和 M1 恢复为正常模式（均为 0）。</translation>
    </message>
    <message>
        <source>The module is on channel %1, the site says %2: write the site&apos;s parameters.</source>
        <translation>模块的信道为 %1，场地为 %2：请写入场地参数。</translation>
    </message>
    <message>
        <source>The module&apos;s air rate is %1 kbit/s, the site says %2: write the site&apos;s parameters.</source>
        <translation>模块的空中速率为 %1 kbit/s，场地为 %2：请写入场地参数。</translation>
    </message>
    <message>
        <source>The module&apos;s UART runs at %1 baud, the site says %2: write the site&apos;s parameters.</source>
        <translation>模块的 UART 速率为 %1 波特，场地为 %2：请写入场地参数。</translation>
    </message>
    <message>
        <source>The module&apos;s UART has a parity bit, vehicles and site have none: write the site&apos;s parameters.</source>
        <translation>模块的 UART 带校验位，车辆和场地均不带：请写入场地参数。</translation>
    </message>
    <message>
        <source>The module has the address %1, those of the vehicles have %2: write the site&apos;s parameters.</source>
        <translation>模块的地址为 %1，车辆模块的地址为 %2：请写入场地参数。</translation>
    </message>
    <message>
        <source>The module takes the first bytes of each packet for an address (fixed transmission), which destroys frames: write the site&apos;s parameters.</source>
        <translation>模块把每个数据包的首字节当作地址（定点传输），会破坏帧：请写入场地参数。</translation>
    </message>
    <message>
        <source>The module&apos;s error correction is off, that of the vehicles is on, so that they do not hear each other: write the site&apos;s parameters.</source>
        <translation>模块的纠错功能已关闭，而车辆的已打开，因此双方无法通信：请写入场地参数。</translation>
    </message>
    <message>
        <source>A vehicle answers with another key than the site&apos;s, so the radio is right: pair it, or enter its key in the site.</source>
        <translation>有车辆使用与场地不同的密钥应答，说明无线设置正确：请进行配对，或在场地中输入它的密钥。</translation>
    </message>
    <message>
        <source>Vehicles are heard that the site does not have, so the radio is right: compare the vehicles&apos; addresses with the site&apos;s, or choose a channel that nobody else uses.</source>
        <translation>收到不属于本场地的车辆的信号，说明无线设置正确：请核对车辆地址与场地是否一致，或换用无人使用的信道。</translation>
    </message>
    <message>
        <source>The port %1 cannot be used: %2.</source>
        <translation>无法使用端口 %1：%2。</translation>
    </message>
    <message>
        <source>The lines RTS and DTR of %1 cannot be switched: set M0 and M1 by jumpers.</source>
        <translation>无法切换 %1 的 RTS 和 DTR 信号线：请用跳线设置 M0 和 M1。</translation>
    </message>
    <message>
        <source> The device server must speak 9600 baud, 8N1, for this.</source>
        <translation>为此，串口服务器必须使用 9600 波特、8N1。</translation>
    </message>
    <message>
        <source>The radio module on %1 does not answer: set M0 and M1 to 1 (on most boards by taking both jumpers off), check its power and that TXD and RXD are crossed, then try again.%2</source>
        <translation>%1 上的无线模块无应答：请将 M0 和 M1 设为 1（多数板上取下两个跳线帽即可），检查电源以及 TXD 与 RXD 是否交叉连接，然后重试。%2</translation>
    </message>
    <message>
        <source>Bytes come from %1, but the radio module does not answer: it seems to be in normal mode. Set M0 and M1 to 1 (on most boards by taking both jumpers off), then try again.%2</source>
        <translation>收到来自 %1 的字节，但无线模块无应答：它似乎处于正常模式。请将 M0 和 M1 设为 1（多数板上取下两个跳线帽即可），然后重试。%2</translation>
    </message>
    <message>
        <source>The radio module on %1 answers, but did not keep what was written: try again; if it stays like that, replace the module.</source>
        <translation>%1 上的无线模块有应答，但未保存写入的内容：请重试；如果仍然如此，请更换模块。</translation>
    </message>
    <message>
        <source>the other end does not read</source>
        <translation>对方没有读取数据</translation>
    </message>
    <message>
        <source>there is no such device</source>
        <translation>没有此设备</translation>
    </message>
    <message>
        <source>it is in use by another program, or you may not open it</source>
        <translation>已被其他程序占用，或没有打开权限</translation>
    </message>
    <message>
        <source>it is open already</source>
        <translation>已经打开</translation>
    </message>
    <message>
        <source>the device or the other end is gone</source>
        <translation>设备或对方已断开</translation>
    </message>
    <message>
        <source>the device server refuses the connection: its port number may be another one, or somebody else holds it</source>
        <translation>串口服务器拒绝连接：端口号可能不同，或已被他人占用</translation>
    </message>
    <message>
        <source>there is no host of this name in the network</source>
        <translation>网络中没有此名称的主机</translation>
    </message>
    <message>
        <source>the device server has closed the connection</source>
        <translation>串口服务器已关闭连接</translation>
    </message>
    <message>
        <source>the device server does not answer: check its power, its address and the network</source>
        <translation>串口服务器无应答：请检查其电源、地址和网络</translation>
    </message>
    <message>
        <source>the network does not reach the device server: check the cable and the address</source>
        <translation>网络无法到达串口服务器：请检查网线和地址</translation>
    </message>
    <message>
        <source>%1 has the new key.</source>
        <translation>%1 已使用新密钥。</translation>
    </message>
    <message>
        <source>%1 did not hear the new key and has the old one still: bring it nearer and try again.</source>
        <translation>%1 未收到新密钥，仍使用旧密钥：请将其移近后重试。</translation>
    </message>
    <message>
        <source>%1 takes no other key while it drives: stop it and try again.</source>
        <translation>%1 行驶中不接受新密钥：请停止车辆后重试。</translation>
    </message>
    <message>
        <source>The new key did not reach %1 whole; it has the old one still: try again.</source>
        <translation>新密钥未完整送达 %1，车辆仍使用旧密钥：请重试。</translation>
    </message>
    <message>
        <source>%1 could not keep the new key, as its memory fails, and may start with either: keep both keys and have its EEPROM looked at.</source>
        <translation>%1 因存储器故障无法保存新密钥，启动后可能使用任一密钥：请保留两个密钥，并检修其 EEPROM。</translation>
    </message>
    <message>
        <source>%1 has not confirmed the new key; it is called with both keys until it answers. Keep both.</source>
        <translation>%1 尚未确认新密钥；将用两个密钥呼叫，直到其应答。请保留两个密钥。</translation>
    </message>
    <message>
        <source>%1: it is being given a key already, or too many requests are waiting.</source>
        <translation>%1：正在更换密钥，或等待处理的请求过多。</translation>
    </message>
    <message>
        <source>%1 can be given another key only while it is connected.</source>
        <translation>%1 只有在已连接时才能更换密钥。</translation>
    </message>
    <message>
        <source>%1 drives; stop it before you give it another key.</source>
        <translation>%1 正在行驶；请先停止，再更换密钥。</translation>
    </message>
    <message>
        <source>Tiles &quot;%1&quot; and &quot;%2&quot; lie upon one another, over %3 × %4 cm.</source>
        <translation>地板砖“%1”与“%2”相互重叠，重叠部分为 %3 × %4 cm。</translation>
    </message>
    <message>
        <source>Take tile &quot;%1&quot; up</source>
        <translation>撤去地板砖“%1”</translation>
    </message>
    <message>
        <source>Tile &quot;%1&quot; lies %2 cm off its neighbour &quot;%3&quot;.</source>
        <translation>地板砖“%1”与相邻地板砖“%3”偏差 %2 cm。</translation>
    </message>
    <message>
        <source>Move tile &quot;%1&quot; up to tile &quot;%2&quot;</source>
        <translation>将地板砖“%1”移到紧贴地板砖“%2”处</translation>
    </message>
    <message>
        <source>Route &quot;%1&quot; has fewer than two different points.</source>
        <translation>路径“%1”的不同点少于两个。</translation>
    </message>
    <message>
        <source>Route &quot;%1&quot; has the same point twice in a row.</source>
        <translation>路径“%1”中有连续重复的点。</translation>
    </message>
    <message>
        <source>Take the repeated points out of route &quot;%1&quot;</source>
        <translation>去掉路径“%1”中的重复点</translation>
    </message>
    <message>
        <source>Route &quot;%1&quot; leads %2 m through the no-go zone &quot;%3&quot;.</source>
        <translation>路径“%1”有 %2 m 穿过禁行区域“%3”。</translation>
    </message>
    <message>
        <source>Route &quot;%1&quot; leads %2 m outside the zones in which vehicles may be.</source>
        <translation>路径“%1”有 %2 m 位于车辆可行驶区域之外。</translation>
    </message>
    <message>
        <source>Route &quot;%1&quot; leads %2 m the wrong way through the one-way zone &quot;%3&quot;.</source>
        <translation>路径“%1”有 %2 m 逆行穿过单行区域“%3”。</translation>
    </message>
    <message>
        <source>Two routes are called &quot;%1&quot;.</source>
        <translation>有两条路径名为“%1”。</translation>
    </message>
    <message>
        <source>Two tile types are called &quot;%1&quot;.</source>
        <translation>有两种地板规格名为“%1”。</translation>
    </message>
    <message>
        <source>Tile &quot;%1&quot; is of type &quot;%2&quot;, which is not known.</source>
        <translation>地板砖“%1”的规格“%2”未知。</translation>
    </message>
    <message>
        <source>Tile &quot;%1&quot; has a place that is no number or farther than 1000 km from the site&apos;s origin.</source>
        <translation>地板砖“%1”的位置不是数字，或距场地原点超过 1000 km。</translation>
    </message>
    <message>
        <source>Tile &quot;%1&quot; is laid, but no such tile is known.</source>
        <translation>已铺设地板砖“%1”，但没有该地板砖的记录。</translation>
    </message>
    <message>
        <source>Tile &quot;%1&quot; is laid twice: at %2 and at %3 m.</source>
        <translation>地板砖“%1”铺设了两次：%2 和 %3 m 处。</translation>
    </message>
    <message>
        <source>Two tiles have the serial number &quot;%1&quot;.</source>
        <translation>有两块地板砖的序列号为“%1”。</translation>
    </message>
    <message>
        <source>Forget the second entry of tile &quot;%1&quot;, which is the same</source>
        <translation>删除地板砖“%1”的重复记录（两条相同）</translation>
    </message>
    <message>
        <source>a loose tag at %1 m</source>
        <translation>位于 %1 m 的单独电子标签</translation>
    </message>
    <message>
        <source>tag %1 of tile &quot;%2&quot;</source>
        <translation>地板砖“%2”的第 %1 个电子标签</translation>
    </message>
    <message>
        <source>Forget the loose tag %1</source>
        <translation>删除单独电子标签 %1</translation>
    </message>
    <message>
        <source>Clear tag %1 of tile &quot;%2&quot;</source>
        <translation>清除地板砖“%2”的第 %1 个电子标签</translation>
    </message>
    <message>
        <source>Tag %1 is registered twice: as %2 and as %3.</source>
        <translation>电子标签 %1 登记了两次：%2 和 %3。</translation>
    </message>
    <message>
        <source>Tile &quot;%1&quot; has %2 UIDs, but its type &quot;%3&quot; has only %4 tags.</source>
        <translation>地板砖“%1”有 %2 个 UID，但其规格“%3”只有 %4 个电子标签。</translation>
    </message>
    <message>
        <source>No tag of tile &quot;%1&quot; is registered.</source>
        <translation>地板砖“%1”的电子标签均未登记。</translation>
    </message>
    <message>
        <source>Tile &quot;%1&quot; has %2 of its %3 tags registered.</source>
        <translation>地板砖“%1”的 %3 个电子标签中只登记了 %2 个。</translation>
    </message>
    <message>
        <source>Give vehicle &quot;%1&quot; the address %2</source>
        <translation>将车辆“%1”的地址改为 %2</translation>
    </message>
    <message>
        <source>Vehicle &quot;%1&quot; has the address %2; addresses run from 1 to 254.</source>
        <translation>车辆“%1”的地址为 %2；地址范围为 1 到 254。</translation>
    </message>
    <message>
        <source>Vehicles &quot;%1&quot; and &quot;%2&quot; have the same address %3.</source>
        <translation>车辆“%1”和“%2”的地址同为 %3。</translation>
    </message>
    <message>
        <source>Two vehicles are called &quot;%1&quot;.</source>
        <translation>有两辆车名为“%1”。</translation>
    </message>
    <message>
        <source>Vehicle &quot;%1&quot; has no key: it has not been paired.</source>
        <translation>车辆“%1”没有密钥：尚未配对。</translation>
    </message>
    <message>
        <source>Vehicles &quot;%1&quot; and &quot;%2&quot; have the same key: each could speak for the other.</source>
        <translation>车辆“%1”和“%2”的密钥相同：可以互相冒充。</translation>
    </message>
    <message>
        <source>Vehicle &quot;%1&quot; has no readers: it cannot see tags.</source>
        <translation>车辆“%1”没有读卡器，读不到电子标签。</translation>
    </message>
    <message>
        <source>The outline of vehicle &quot;%1&quot; has no area.</source>
        <translation>车辆“%1”的外形轮廓没有面积。</translation>
    </message>
    <message>
        <source>Vehicle &quot;%1&quot; starts at %2 m, where no zone lets it be.</source>
        <translation>车辆“%1”的起始位置 %2 m 不在任何可行驶区域内。</translation>
    </message>
    <message>
        <source>The radio has no channel %1; channels run from 0 to 31.</source>
        <translation>无线模块没有信道 %1；信道范围为 0 到 31。</translation>
    </message>
    <message>
        <source>The radio knows no air rate of %1 bit/s.</source>
        <translation>无线模块不支持 %1 bit/s 的空中速率。</translation>
    </message>
    <message>
        <source>The radio module knows no %1 baud.</source>
        <translation>无线模块不支持 %1 波特率。</translation>
    </message>
    <message>
        <source>At %1 bit/s each of the %2 vehicles is commanded about every %3 s only; it would drive slowly and in jerks. Take a higher air rate, or fewer vehicles on one channel.</source>
        <translation>空中速率为 %1 bit/s 时，%2 辆车中每辆约每 %3 s 才收到一次指令，行驶会缓慢且不连贯。请提高空中速率，或减少同一信道上的车辆。</translation>
    </message>
    <message>
        <source>No tile is laid and no loose tag is known: vehicles would not find their way.</source>
        <translation>没有铺设地板砖，也没有单独电子标签：车辆无法定位。</translation>
    </message>
    <message>
        <source>The site has no running zone: routes are not checked against where vehicles may be.</source>
        <translation>场地没有行驶区域：无法检查路径是否位于车辆可行驶的地方。</translation>
    </message>
    <message>
        <source>The outline of zone &quot;%1&quot; has the same point twice in a row; it closes by itself, without its first point at the end.</source>
        <translation>区域“%1”的轮廓中有连续重复的点；轮廓会自动闭合，末尾无需重复起点。</translation>
    </message>
    <message>
        <source>Take the repeated points out of zone &quot;%1&quot;</source>
        <translation>去掉区域“%1”中的重复点</translation>
    </message>
    <message>
        <source>Zone &quot;%1&quot; has no area.</source>
        <translation>区域“%1”没有面积。</translation>
    </message>
    <message>
        <source>The outline of zone &quot;%1&quot; crosses itself: what it encloses twice lies outside.</source>
        <translation>区域“%1”的轮廓自相交：被围两次的部分算作区域之外。</translation>
    </message>
    <message>
        <source>Two zones are called &quot;%1&quot;.</source>
        <translation>有两个区域名为“%1”。</translation>
    </message>
    <message>
        <source>The slow zone &quot;%1&quot; does not say how fast vehicles may go in it.</source>
        <translation>慢行区域“%1”没有给出限速。</translation>
    </message>
    <message>
        <source>The one-way zone &quot;%1&quot; does not say which way.</source>
        <translation>单行区域“%1”没有给出方向。</translation>
    </message>
    <message>
        <source>Zone &quot;%1&quot; lies wholly in the no-go zone &quot;%2&quot;, which wins: it has no effect.</source>
        <translation>区域“%1”完全位于禁行区域“%2”内；禁行优先，该区域不起作用。</translation>
    </message>
    <message>
        <source>%1 m² of zone &quot;%2&quot; lie in the no-go zone &quot;%3&quot;, which wins.</source>
        <translation>区域“%2”有 %1 m² 位于禁行区域“%3”内；禁行优先。</translation>
    </message>
    <message>
        <source>The one-way zones &quot;%1&quot; and &quot;%2&quot; overlap and lead %3° apart.</source>
        <translation>单行区域“%1”与“%2”重叠，方向相差 %3°。</translation>
    </message>
    <message>
        <source>No way leads from a running zone into zone &quot;%1&quot;.</source>
        <translation>从行驶区域无路可通往区域“%1”。</translation>
    </message>
    <message>
        <source>%1 m² of the running zone &quot;%2&quot; at %3 m have no tiles.</source>
        <translation>行驶区域“%2”在 %3 m 处有 %1 m² 没有地板砖。</translation>
    </message>
    <message>
        <source>The site is called &quot;%1&quot; instead of &quot;%2&quot;.</source>
        <translation>场地名称由“%2”改为“%1”。</translation>
    </message>
    <message>
        <source>The site&apos;s y axis points %1° from north instead of %2°.</source>
        <translation>场地 y 轴相对正北的角度由 %2° 改为 %1°。</translation>
    </message>
    <message>
        <source>The radio uses channel %1, %2 bit/s, %3 baud instead of channel %4, %5 bit/s, %6 baud.</source>
        <translation>无线设置改为信道 %1、%2 bit/s、%3 波特（原为信道 %4、%5 bit/s、%6 波特）。</translation>
    </message>
    <message>
        <source>Zone &quot;%1&quot;</source>
        <translation>区域“%1”</translation>
    </message>
    <message>
        <source>kind &quot;%1&quot; instead of &quot;%2&quot;</source>
        <translation>用途由“%2”改为“%1”</translation>
    </message>
    <message>
        <source>another outline</source>
        <translation>轮廓不同</translation>
    </message>
    <message>
        <source>another speed</source>
        <translation>速度不同</translation>
    </message>
    <message>
        <source>another direction</source>
        <translation>方向不同</translation>
    </message>
    <message>
        <source>Route &quot;%1&quot;</source>
        <translation>路径“%1”</translation>
    </message>
    <message>
        <source>another way, %1 m instead of %2 m</source>
        <translation>走向不同，长度由 %2 m 变为 %1 m</translation>
    </message>
    <message>
        <source>another distance of control points</source>
        <translation>控制点间距不同</translation>
    </message>
    <message>
        <source>Vehicle &quot;%1&quot;</source>
        <translation>车辆“%1”</translation>
    </message>
    <message>
        <source>was called &quot;%1&quot;</source>
        <translation>原名“%1”</translation>
    </message>
    <message>
        <source>another key</source>
        <translation>密钥不同</translation>
    </message>
    <message>
        <source>another start</source>
        <translation>起始位置不同</translation>
    </message>
    <message>
        <source>another shape, other readers or other abilities</source>
        <translation>外形、读卡器或性能不同</translation>
    </message>
    <message>
        <source>%1 is new.</source>
        <translation>新增%1。</translation>
    </message>
    <message>
        <source>%1 is gone.</source>
        <translation>删除%1。</translation>
    </message>
    <message>
        <source>%1 moves from %2 to %3 m.</source>
        <translation>%1从 %2 移到 %3 m。</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1：%2。</translation>
    </message>
    <message>
        <source>Tile &quot;%1&quot;</source>
        <translation>地板砖“%1”</translation>
    </message>
    <message>
        <source>its list of tags has another length</source>
        <translation>电子标签列表长度不同</translation>
    </message>
    <message>
        <source>tags registered: %1, cleared: %2, replaced: %3</source>
        <translation>电子标签：登记 %1 个，清除 %2 个，更换 %3 个</translation>
    </message>
    <message>
        <source>Tile type &quot;%1&quot;</source>
        <translation>地板规格“%1”</translation>
    </message>
    <message>
        <source>another size or pattern</source>
        <translation>尺寸或排列不同</translation>
    </message>
    <message>
        <source>type &quot;%1&quot; instead of &quot;%2&quot;</source>
        <translation>规格由“%2”改为“%1”</translation>
    </message>
    <message>
        <source>%1 is laid at %2 m.</source>
        <translation>%1铺设在 %2 m 处。</translation>
    </message>
    <message>
        <source>%1 is taken up from %2 m.</source>
        <translation>从 %2 m 处撤去%1。</translation>
    </message>
    <message>
        <source>%1 is turned from %2° to %3°.</source>
        <translation>%1由 %2° 转到 %3°。</translation>
    </message>
    <message>
        <source>Loose tag %1</source>
        <translation>单独电子标签 %1</translation>
    </message>
    <message>
        <source>More faults of this kind, not listed one by one: %1.</source>
        <translation>未逐一列出的其他同类问题：%1。</translation>
    </message>
    <message>
        <source>The file has several layouts, which are laid upon one another: %1.</source>
        <translation>文件含有多个布局，已叠加在一起：%1。</translation>
    </message>
    <message>
        <source>Nodes and edges whose actions were left out: %1.</source>
        <translation>动作未导入的节点和边：%1。</translation>
    </message>
    <message>
        <source>Curved edges that became straight legs: %1.</source>
        <translation>改为直线段的曲线边：%1。</translation>
    </message>
    <message>
        <source>Edges whose load and height restrictions were left out: %1.</source>
        <translation>载荷和高度限制未导入的边：%1。</translation>
    </message>
    <message>
        <source>Edges to another layout, left out: %1.</source>
        <translation>通往另一布局而未导入的边：%1。</translation>
    </message>
    <message>
        <source>LIF says only where a station is; stations read as zones of 0.6 × 0.6 m: %1.</source>
        <translation>LIF 只给出站点位置；按 0.6 × 0.6 m 的区域导入的站点：%1。</translation>
    </message>
    <message>
        <source>LIF carries no tiles; left out, with their tags: %1.</source>
        <translation>LIF 不包含地板砖；未导出的地板砖（及其电子标签）：%1。</translation>
    </message>
    <message>
        <source>LIF carries no tags; loose ones left out: %1.</source>
        <translation>LIF 不包含电子标签；未导出的单独电子标签：%1。</translation>
    </message>
    <message>
        <source>Of parking, charging and storage zones only the middle is kept, as stations: %1.</source>
        <translation>停车、充电和存放区域只保留中心点，作为站点导出：%1。</translation>
    </message>
    <message>
        <source>Zones of other kinds are left out; slow zones stay as the highest speed of the edges in them: %1.</source>
        <translation>其他用途的区域未导出；慢行区域以其中各边的最高速度体现：%1。</translation>
    </message>
    <message>
        <source>Of vehicles only the highest speeds are kept, as types: %1.</source>
        <translation>车辆只保留最高速度，作为车型导出：%1。</translation>
    </message>
    <message>
        <source>Distances of control points are left out; routes concerned: %1.</source>
        <translation>控制点间距未导出；涉及的路径：%1。</translation>
    </message>
    <message>
        <source>All vehicles were told to stop.</source>
        <translation>已命令所有车辆停车。</translation>
    </message>
    <message>
        <source>The demo floor could not be put into %1: %2.</source>
        <translation>无法将演示地面放入 %1：%2。</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>什么都没有</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>一个对象</translation>
    </message>
    <message>
        <source>an array of %1</source>
        <translation>有 %1 个元素的数组</translation>
    </message>
    <message>
        <source>this key stands twice in one object.</source>
        <translation>同一对象中此键出现了两次。</translation>
    </message>
    <message>
        <source>the document</source>
        <translation>整个文档</translation>
    </message>
    <message>
        <source>expected %1, found %2.</source>
        <translation>应为：%1；实际为：%2。</translation>
    </message>
    <message>
        <source>expected %1, found something else.</source>
        <translation>应为：%1；实际为其他内容。</translation>
    </message>
    <message>
        <source>there is no such key here; expected one of %1.</source>
        <translation>此处没有这样的键；应为以下之一：%1。</translation>
    </message>
    <message>
        <source>expected this key, which is missing.</source>
        <translation>缺少此键。</translation>
    </message>
    <message>
        <source>a number of %1 from %2 to %3</source>
        <translation>以%1为单位、%2 到 %3 之间的数</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation>%1 到 %2 之间的整数</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true 或 false</translation>
    </message>
    <message>
        <source>a text of %1 to %2 characters</source>
        <translation>%1 到 %2 个字符的文本</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>以下之一：%1</translation>
    </message>
    <message>
        <source>an array of %1 to %2 elements</source>
        <translation>有 %1 到 %2 个元素的数组</translation>
    </message>
    <message>
        <source>A floor has 1 to %1 tiles along each side, not %2.</source>
        <translation>地面每边有 1 到 %1 块地板砖，不能是 %2 块。</translation>
    </message>
    <message>
        <source>The tile type %1 has no tags.</source>
        <translation>地板规格 %1 没有标签。</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>没有这个文件或文件夹</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>没有权限</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>磁盘空间已满</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>文件系统为只读</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>读写错误</translation>
    </message>
    <message>
        <source>%1: cannot be read: %2.</source>
        <translation>%1：无法读取：%2。</translation>
    </message>
    <message>
        <source>%1: cannot be read to its end.</source>
        <translation>%1：无法读到末尾。</translation>
    </message>
    <message>
        <source>%1: %2: %3. The file was not changed.</source>
        <translation>%1：%2：%3。文件未被更改。</translation>
    </message>
    <message>
        <source>a temporary file beside it cannot be made</source>
        <translation>无法在其旁边创建临时文件</translation>
    </message>
    <message>
        <source>cannot be written</source>
        <translation>无法写入</translation>
    </message>
    <message>
        <source>cannot be given its rights</source>
        <translation>无法设置其权限</translation>
    </message>
    <message>
        <source>cannot be brought to disk</source>
        <translation>无法写到磁盘上</translation>
    </message>
    <message>
        <source>cannot be replaced</source>
        <translation>无法替换</translation>
    </message>
    <message>
        <source>Tile &quot;%1&quot; is laid twice.</source>
        <translation>地板砖“%1”被铺设了两次。</translation>
    </message>
    <message>
        <source>Two vehicles have the address %1.</source>
        <translation>两辆车的地址都是 %1。</translation>
    </message>
    <message>
        <source>Tag %1 has a place that is no number or farther than 1000 km from the site&apos;s origin.</source>
        <translation>标签 %1 的位置不是数，或距场地原点超过 1000 km。</translation>
    </message>
    <message>
        <source>The site has too many tags.</source>
        <translation>场地的标签太多。</translation>
    </message>
    <message>
        <source>Tag %1 is registered at two places.</source>
        <translation>标签 %1 登记在两个位置。</translation>
    </message>
    <message>
        <source>The UIDs of the site&apos;s tags cannot be told apart quickly.</source>
        <translation>无法快速区分场地中标签的 UID。</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>米</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>度</translation>
    </message>
    <message>
        <source>a tag&apos;s UID of 8, 14 or 20 hexadecimal digits or null</source>
        <translation>8、14 或 20 位十六进制的标签 UID，或 null</translation>
    </message>
    <message>
        <source>a tag&apos;s UID of 8, 14 or 20 hexadecimal digits</source>
        <translation>8、14 或 20 位十六进制的标签 UID</translation>
    </message>
    <message>
        <source>a key of 32 hexadecimal digits</source>
        <translation>32 位十六进制的密钥</translation>
    </message>
    <message>
        <source>a row of &apos;#&apos; and &apos;.&apos;</source>
        <translation>由“#”和“.”组成的一行</translation>
    </message>
    <message>
        <source>no gap at the start of a pattern that is not one-in-two</source>
        <translation>非隔一布置的图案在开头没有空位</translation>
    </message>
    <message>
        <source>the custom pattern&apos;s rows only with &quot;pattern&quot;: &quot;custom&quot;</source>
        <translation>仅在 &quot;pattern&quot;: &quot;custom&quot; 时才有自定义图案的行</translation>
    </message>
    <message>
        <source>the rows of the custom pattern</source>
        <translation>自定义图案的各行</translation>
    </message>
    <message>
        <source>a lattice of columns and rows that lies on the tile</source>
        <translation>位于地板砖之内的行列点阵</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>第 %1 行第 %2 列</translation>
    </message>
    <message>
        <source>%1: %2: expected JSON (RFC 8259), found something else.</source>
        <translation>%1：%2：应为 JSON（RFC 8259），实际为其他内容。</translation>
    </message>
    <message>
        <source>%1: expected JSON (RFC 8259) with numbers of usual size, found a number too large.</source>
        <translation>%1：应为数值大小正常的 JSON（RFC 8259），其中有过大的数。</translation>
    </message>
    <message>
        <source>%1: the folder cannot be made: %2.</source>
        <translation>%1：无法创建文件夹：%2。</translation>
    </message>
    <message>
        <source>%1: cannot be made: %2. Check the folder&apos;s permissions and the space on its disk.</source>
        <translation>%1：无法创建：%2。请检查文件夹的权限和磁盘空间。</translation>
    </message>
    <message>
        <source>Qt&apos;s driver for SQLite is missing: please install the package libqt6sql6-sqlite.</source>
        <translation>缺少 Qt 的 SQLite 驱动：请安装软件包 libqt6sql6-sqlite。</translation>
    </message>
    <message>
        <source>%1: the file is damaged. It was left as it is: keep a copy, then move it away and start anew.</source>
        <translation>%1：文件已损坏，未作改动。请保留一份副本，然后将其移走并重新开始。</translation>
    </message>
    <message>
        <source>%1: another program is writing to this file. Close the other copy of Tessera.</source>
        <translation>%1：另一个程序正在写入此文件。请关闭另一个 Tessera。</translation>
    </message>
    <message>
        <source>%1: cannot be written to. Check the permissions of the file and of its folder.</source>
        <translation>%1：无法写入。请检查文件及其文件夹的权限。</translation>
    </message>
    <message>
        <source>%1: the disk is full. Make room on it.</source>
        <translation>%1：磁盘已满。请腾出空间。</translation>
    </message>
    <message>
        <source>%1: the disk failed to read or write. Check that it is still there and has room.</source>
        <translation>%1：磁盘读写失败。请检查磁盘是否仍在并有空间。</translation>
    </message>
    <message>
        <source>%1: cannot be opened. Check the permissions of the file and of its folder.</source>
        <translation>%1：无法打开。请检查文件及其文件夹的权限。</translation>
    </message>
    <message>
        <source>%1: is no file of Tessera&apos;s. It was left as it is: move it away or choose another place.</source>
        <translation>%1：不是 Tessera 的文件，未作改动。请将其移走或选择其他位置。</translation>
    </message>
    <message>
        <source>%1: a value is too large to be kept.</source>
        <translation>%1：有一个值太大，无法保存。</translation>
    </message>
    <message>
        <source>%1: cannot be used: %2.</source>
        <translation>%1：无法使用：%2。</translation>
    </message>
    <message>
        <source>Entries before this one were lost because the journal could not be written: %1.</source>
        <translation>由于日志无法写入，此条之前的记录已丢失：%1。</translation>
    </message>
    <message>
        <source>%1: is a database of another program. It was left as it is: choose another place.</source>
        <translation>%1：是其他程序的数据库，未作改动。请选择其他位置。</translation>
    </message>
    <message>
        <source>%1: was made by a newer version of Tessera (layout %2, this program knows up to %3). It was left as it is: please install the newer version.</source>
        <translation>%1：由更新版本的 Tessera 创建（布局 %2，本程序最高支持 %3），未作改动。请安装更新的版本。</translation>
    </message>
    <message>
        <source>A name in the site is no valid text (UTF-8), so the site cannot be kept.</source>
        <translation>场地中有名称不是有效文本（UTF-8），因此无法保存该场地。</translation>
    </message>
    <message>
        <source>%1: %2: %3</source>
        <translation>%1：%2：%3</translation>
    </message>
    <message>
        <source>%1: expected %2 of at most 64 MiB, found more.</source>
        <translation>%1：应为%2，最大 64 MiB，但文件更大。</translation>
    </message>
    <message>
        <source>%1: expected %2, found a text that nests deeper than 16 levels.</source>
        <translation>%1：应为%2，但文本嵌套超过 16 层。</translation>
    </message>
    <message>
        <source>%1: expected a file, found a folder.</source>
        <translation>%1：应为文件，但这是文件夹。</translation>
    </message>
    <message>
        <source>%1: the file is there already.</source>
        <translation>%1：文件已存在。</translation>
    </message>
    <message>
        <source>a site</source>
        <translation>场地文件</translation>
    </message>
    <message>
        <source>expected %1 fields as in the first line, found %2.</source>
        <translation>应与首行一样有 %1 个字段，实际为 %2 个。</translation>
    </message>
    <message>
        <source>%1: line %2: %3</source>
        <translation>%1：第 %2 行：%3</translation>
    </message>
    <message>
        <source>expected quotes only around a whole field.</source>
        <translation>引号只能括住整个字段。</translation>
    </message>
    <message>
        <source>expected a closing quote, found the end of the file.</source>
        <translation>缺少右引号，文件已结束。</translation>
    </message>
    <message>
        <source>expected a comma after the closing quote.</source>
        <translation>右引号之后应为逗号。</translation>
    </message>
    <message>
        <source>a table</source>
        <translation>表格</translation>
    </message>
    <message>
        <source>a version 1.x of LIF</source>
        <translation>LIF 1.x 版本</translation>
    </message>
    <message>
        <source>a nodeId that no other node has</source>
        <translation>不重复的 nodeId</translation>
    </message>
    <message>
        <source>the nodeId of a node of this file</source>
        <translation>本文件中某个节点的 nodeId</translation>
    </message>
    <message>
        <source>a LIF layout</source>
        <translation>LIF 布局文件</translation>
    </message>
    <message>
        <source>%1: the site would have more than 10 000 routes, zones or points of a route.</source>
        <translation>%1：场地的路径、区域或某条路径的点数将超过 10 000。</translation>
    </message>
    <message>
        <source>the site has no tile %1.</source>
        <translation>场地没有地板砖 %1。</translation>
    </message>
    <message>
        <source>expected an index from 1 to %1, found %2.</source>
        <translation>序号应为 1 到 %1，实际为 %2。</translation>
    </message>
    <message>
        <source>this tag stands already in line %1.</source>
        <translation>该电子标签已在第 %1 行出现。</translation>
    </message>
    <message>
        <source>expected metres from -100000 to 100000, found %1.</source>
        <translation>应为 -100000 到 100000 之间的米数，实际为 %1。</translation>
    </message>
    <message>
        <source>tag %1 stands already in line %2.</source>
        <translation>电子标签 %1 已在第 %2 行出现。</translation>
    </message>
    <message>
        <source>tag %1 would be registered twice: as %2 and as %3.</source>
        <translation>电子标签 %1 将被登记两次：%2 和 %3。</translation>
    </message>
    <message>
        <source>a loose tag</source>
        <translation>单独电子标签</translation>
    </message>
    <message>
        <source>expected the header %1 or %2.</source>
        <translation>首行应为 %1 或 %2。</translation>
    </message>
    <message>
        <source>The vehicle&apos;s new key could not be kept in %1, so it was not sent: %2.</source>
        <translation>车辆的新密钥无法保存到 %1，因此没有发送：%2。</translation>
    </message>
    <message>
        <source>The reader sends other than lines: check its kind and baud rate.</source>
        <translation>读卡器发来的不是文本行：请检查其类型和波特率。</translation>
    </message>
    <message>
        <source>Tag %1 is registered already, as tag %2 of tile &quot;%3&quot;.</source>
        <translation>电子标签 %1 已登记：地板砖“%3”的第 %2 个标签。</translation>
    </message>
    <message>
        <source>Tag %1 is registered already, as a loose tag at (%2, %3) m.</source>
        <translation>电子标签 %1 已登记为散置标签，位于 (%2, %3) m。</translation>
    </message>
    <message>
        <source>Tag %1 says that it lies at (%2, %3) m, %4 m from here, where no tag is to be registered.</source>
        <translation>电子标签 %1 称自己位于 (%2, %3) m，距此 %4 m，而那里没有要登记的标签。</translation>
    </message>
    <message>
        <source>Tag %1 says that it lies at (%2, %3) m: that is tag %4 of tile &quot;%5&quot;.</source>
        <translation>电子标签 %1 称自己位于 (%2, %3) m：那是地板砖“%5”的第 %4 个标签。</translation>
    </message>
    <message>
        <source>All places are registered or skipped.</source>
        <translation>所有位置都已登记或跳过。</translation>
    </message>
    <message>
        <source>The reader sent %1, which is no UID as a decimal number.</source>
        <translation>读卡器发来 %1，这不是十进制的 UID。</translation>
    </message>
    <message>
        <source>The reader sent %1, which is too long for a UID.</source>
        <translation>读卡器发来 %1，对 UID 来说太长。</translation>
    </message>
    <message>
        <source>The reader sent %1, which is no UID of 4, 7 or 10 bytes.</source>
        <translation>读卡器发来 %1，这不是 4、7 或 10 字节的 UID。</translation>
    </message>
    <message>
        <source>Tag %1 holds %2, which is no place: expected @X,Y in metres.</source>
        <translation>电子标签 %1 存有 %2，这不是位置：应为以米为单位的 @X,Y。</translation>
    </message>
    <message>
        <source>A tile type needs a name.</source>
        <translation>地板规格需要名称。</translation>
    </message>
    <message>
        <source>This name is too long for a tile type.</source>
        <translation>这个名称对地板规格来说太长。</translation>
    </message>
    <message>
        <source>A tile is 1 cm to 100 m long and wide.</source>
        <translation>地板砖的长和宽为 1 cm 至 100 m。</translation>
    </message>
    <message>
        <source>The pitch of a tile is 1 mm to 100 m.</source>
        <translation>地板砖的间距为 1 mm 至 100 m。</translation>
    </message>
    <message>
        <source>A tile has 1 to 100 columns and rows of places.</source>
        <translation>地板砖有 1 至 100 列、1 至 100 行位置。</translation>
    </message>
    <message>
        <source>The places reach beyond the edge of the tile.</source>
        <translation>位置超出了地板砖的边缘。</translation>
    </message>
    <message>
        <source>The pattern does not have as many places as the tile.</source>
        <translation>图案的位置数与地板砖不符。</translation>
    </message>
    <message>
        <source>The reader&apos;s port %1 cannot be used: %2. It is taken up as soon as it is there.</source>
        <translation>读卡器的串口 %1 无法使用：%2。一旦可用会自动恢复。</translation>
    </message>
    <message>
        <source>Tile &quot;%1&quot; lies turned by %2° against the site.</source>
        <translation>与场地相比，地板砖“%1”转了 %2°。</translation>
    </message>
    <message>
        <source>Tiles &quot;%1&quot; and &quot;%2&quot; lie at each other&apos;s places.</source>
        <translation>地板砖“%1”和“%2”的位置对调了。</translation>
    </message>
    <message>
        <source>%1 tiles lie at one another&apos;s places, &quot;%2&quot; at that of &quot;%3&quot;.</source>
        <translation>%1 块地板砖的位置互相错开，“%2”在“%3”的位置上。</translation>
    </message>
    <message>
        <source>The picture would be too large. Choose a smaller scale, such as 1 : 200.</source>
        <translation>图片会太大。请选择更小的比例，例如 1 : 200。</translation>
    </message>
    <message>
        <source>The name of a picture ends with .png, .svg or .pdf.</source>
        <translation>图片的文件名须以 .png、.svg 或 .pdf 结尾。</translation>
    </message>
    <message>
        <source>So many tags make a file that no program opens quickly. Choose PNG, or leave the tags out.</source>
        <translation>标签太多，生成的文件任何程序都难以快速打开。请选择 PNG，或不画标签。</translation>
    </message>
    <message>
        <source>Cannot write %1: %2.</source>
        <translation>无法写入 %1：%2。</translation>
    </message>
    <message>
        <source>a picture&apos;s bytes in base64</source>
        <translation>base64 编码的图片字节</translation>
    </message>
    <message>
        <source>a picture of at most %1 MB</source>
        <translation>最大 %1 MB 的图片</translation>
    </message>
    <message>
        <source>a picture in the format PNG or JPEG</source>
        <translation>PNG 或 JPEG 格式的图片</translation>
    </message>
    <message>
        <source>opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>Floor plan &quot;%1&quot;</source>
        <translation>平面图“%1”</translation>
    </message>
    <message>
        <source>another picture</source>
        <translation>图片不同</translation>
    </message>
    <message>
        <source>another scale or direction</source>
        <translation>比例或方向不同</translation>
    </message>
    <message>
        <source>another opacity</source>
        <translation>不透明度不同</translation>
    </message>
    <message>
        <source>LIF carries no picture of the floor plan; left out.</source>
        <translation>LIF 不含平面图的图片；已略去。</translation>
    </message>
    <message>
        <source>This revision is no longer kept: newer ones took its place.</source>
        <translation>该修订版本已不再保留：较新的版本取代了它。</translation>
    </message>
    <message>
        <source>%1: this revision is damaged and cannot be read. The others and the site are as they were.</source>
        <translation>%1：该修订版本已损坏，无法读取。其他修订版本和场地不受影响。</translation>
    </message>
    <message>
        <source>a speed or null for each leg, one fewer than vertices</source>
        <translation>每一段一个速度或 null，比顶点少一个</translation>
    </message>
    <message>
        <source>Leg %1 of route &quot;%2&quot; may be driven at %3 m/s, but leads through the slow zone &quot;%4&quot; of %5 m/s.</source>
        <translation>路径“%2”的第 %1 段允许 %3 m/s，但它穿过限速 %5 m/s 的慢行区域“%4”。</translation>
    </message>
    <message>
        <source>Slow leg %1 of route &quot;%2&quot; down to %3 m/s</source>
        <translation>将路径“%2”第 %1 段的速度降到 %3 m/s</translation>
    </message>
    <message>
        <source>at most %2 m/s on leg %1</source>
        <translation>第 %1 段最高 %2 m/s</translation>
    </message>
    <message>
        <source>no highest speed on leg %1 any more</source>
        <translation>第 %1 段不再有最高速度</translation>
    </message>
    <message>
        <source>at most %2 m/s instead of %3 m/s on leg %1</source>
        <translation>第 %1 段最高 %2 m/s，原为 %3 m/s</translation>
    </message>
    <message>
        <source>other highest speeds on its legs</source>
        <translation>各段的最高速度不同</translation>
    </message>
    <message>
        <source>Highest speeds of edges that became those of legs: %1.</source>
        <translation>成为路段最高速度的边的最高速度：%1。</translation>
    </message>
    <message>
        <source>no faster on this leg</source>
        <translation>这一段限速</translation>
    </message>
    <message>
        <source>slowing down before a slower leg</source>
        <translation>在较慢的路段前减速</translation>
    </message>
    <message>
        <source>%1 is too large: a picture may have %2 MB. Save it smaller or as JPEG.</source>
        <translation>%1 太大：图片最多 %2 MB。请缩小或另存为 JPEG。</translation>
    </message>
    <message>
        <source>%1 is neither a PNG nor a JPEG picture.</source>
        <translation>%1 既不是 PNG 也不是 JPEG 图片。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>That scale is beyond what a floor plan can have.</source>
        <translation>该比例超出平面图的允许范围。</translation>
    </message>
    <message>
        <source>The two points are one. Click two points that lie apart.</source>
        <translation>两个点重合。请点击两个分开的点。</translation>
    </message>
    <message>
        <source>The picture has %1 × %2 pixels. Save it smaller: up to %3 million pixels can be shown.</source>
        <translation>图片有 %1 × %2 像素。请缩小：最多可显示 %3 百万像素。</translation>
    </message>
    <message>
        <source>The picture is damaged or of a kind that cannot be shown.</source>
        <translation>图片已损坏，或属于无法显示的类型。</translation>
    </message>
    <message>
        <source>The site was edited meanwhile: nothing was changed.</source>
        <translation>场地已被修改：未作任何更改。</translation>
    </message>
    <message>
        <source>Reverse route &quot;%1&quot;</source>
        <translation>将路径“%1”反向</translation>
    </message>
    <message>
        <source>Slow route &quot;%1&quot; down in its bends, to %2 m/s in the tightest</source>
        <translation>降低路径“%1”在弯道中的速度，最急处为 %2 m/s</translation>
    </message>
    <message>
        <source>Move vertex %2 of route &quot;%1&quot; by %3 m, to where there is room</source>
        <translation>将路径“%1”的顶点 %2 移动 %3 m，移到有足够空间之处</translation>
    </message>
    <message>
        <source>Move %2 vertices of route &quot;%1&quot; by up to %3 m, to where there is room</source>
        <translation>将路径“%1”的 %2 个顶点移动最多 %3 m，移到有足够空间之处</translation>
    </message>
    <message>
        <source>no faster in this slow zone</source>
        <translation>在此慢行区域内不能更快</translation>
    </message>
    <message>
        <source>slowing down before a slow zone</source>
        <translation>进入慢行区域前减速</translation>
    </message>
    <message>
        <source>slowing down, as the way ahead is not free</source>
        <translation>前方道路未空出，正在减速</translation>
    </message>
    <message>
        <source>Waiting until the way ahead is free.</source>
        <translation>等待前方道路空出。</translation>
    </message>
    <message>
        <source>%1: the route %2 leads %3 m the wrong way through the one-way zone %4.</source>
        <translation>%1：路径 %2 有 %3 m 逆向穿过单行区域 %4。</translation>
    </message>
    <message>
        <source>%1 waits: the way ahead has just become free.</source>
        <translation>%1 正在等待：前方道路刚刚空出。</translation>
    </message>
    <message>
        <source>%1 waits before the single-vehicle zone %2: %3 is in it.</source>
        <translation>%1 在单车区域 %2 前等待：%3 在其中。</translation>
    </message>
    <message>
        <source>%1 waits before the single-vehicle zone %2: %3 drives through it.</source>
        <translation>%1 在单车区域 %2 前等待：%3 正要驶过。</translation>
    </message>
    <message>
        <source>%1 waits before the single-vehicle zone %2: %3 came first.</source>
        <translation>%1 在单车区域 %2 前等待：%3 先到。</translation>
    </message>
    <message>
        <source>%1 waits at the single-vehicle zone %2: it and %3 stand in each other&apos;s way. Drive one of them out by hand.</source>
        <translation>%1 在单车区域 %2 处等待：它与 %3 互相挡路。请手动将其中一辆驶出。</translation>
    </message>
    <message>
        <source>no faster through this bend</source>
        <translation>此弯道内不能更快</translation>
    </message>
    <message>
        <source>Tag %1 was read %2 times at %3 m, but its tile &quot;%4&quot; is not laid.</source>
        <translation>标签 %1 在 %3 m 处被读到 %2 次，但其地板砖“%4”未铺设。</translation>
    </message>
    <message>
        <source>Tag %1 was read %2 times where tag %3 of tile &quot;%4&quot; is not registered: probably it is that.</source>
        <translation>标签 %1 被读到 %2 次，该处是地板砖“%4”未登记的标签 %3：很可能就是它。</translation>
    </message>
    <message>
        <source>Tag %1, which no tile has, was read %2 times where tag %3 of tile &quot;%4&quot; should be, which was never read: probably the card was exchanged.</source>
        <translation>不属于任何地板砖的标签 %1 被读到 %2 次，该处应为地板砖“%4”的标签 %3，而后者从未被读到：卡片可能被换过。</translation>
    </message>
    <message>
        <source>Tag %1 was read %2 times at %3 m, but no tile has it.</source>
        <translation>标签 %1 在 %3 m 处被读到 %2 次，但不属于任何地板砖。</translation>
    </message>
    <message>
        <source>Tag %1 of tile &quot;%2&quot; was never read in %3 passes over it; others are read in %4 % of passes. By chance that is once in %5.</source>
        <translation>地板砖“%2”的标签 %1 在 %3 次驶过中从未被读到；其他标签在 %4 % 的驶过中被读到。偶然如此的机会是 %5 分之一。</translation>
    </message>
    <message>
        <source>%1 tags of tile &quot;%2&quot; were never read in %3 passes over them; others are read in %4 % of passes. By chance that is once in %5.</source>
        <translation>地板砖“%2”的 %1 个标签在 %3 次驶过中从未被读到；其他标签在 %4 % 的驶过中被读到。偶然如此的机会是 %5 分之一。</translation>
    </message>
    <message>
        <source>Forget the second entry of tile type &quot;%1&quot;, which is the same</source>
        <translation>去掉地板砖类型“%1”的第二个相同条目</translation>
    </message>
    <message>
        <source>Call the second tile &quot;%1&quot; &quot;%2&quot; instead</source>
        <translation>把第二块地板砖“%1”改称为“%2”</translation>
    </message>
    <message>
        <source>Drop the UIDs of tile &quot;%1&quot; beyond its %2 tags</source>
        <translation>去掉地板砖“%1”超出其 %2 个标签的 UID</translation>
    </message>
    <message>
        <source>Tile type &quot;%1&quot; is here already, and another one: it stays as it is.</source>
        <translation>这里已有不同的地板砖类型“%1”：保持不变。</translation>
    </message>
    <message>
        <source>More tile types that stay as they are: %1.</source>
        <translation>另有保持不变的地板砖类型：%1 个。</translation>
    </message>
    <message>
        <source>Tile &quot;%1&quot; is here already, of another type or with other tags: it stays as it is.</source>
        <translation>这里已有地板砖“%1”，但类型或标签不同：保持不变。</translation>
    </message>
    <message>
        <source>More tiles that stay as they are: %1.</source>
        <translation>另有保持不变的地板砖：%1 块。</translation>
    </message>
    <message>
        <source>Tile &quot;%1&quot; is laid here already, at another place: it stays there.</source>
        <translation>地板砖“%1”在这里已铺设于别处：留在原处。</translation>
    </message>
    <message>
        <source>Loose tag %1 is here already, at another place: it stays there.</source>
        <translation>这里已有单独标签 %1，但位置不同：留在原处。</translation>
    </message>
    <message>
        <source>More loose tags that stay as they are: %1.</source>
        <translation>另有保持不变的单独标签：%1 个。</translation>
    </message>
    <message>
        <source>Zone &quot;%1&quot; is here already, and another one: it stays as it is.</source>
        <translation>这里已有不同的区域“%1”：保持不变。</translation>
    </message>
    <message>
        <source>More zones that stay as they are: %1.</source>
        <translation>另有保持不变的区域：%1 个。</translation>
    </message>
    <message>
        <source>Route &quot;%1&quot; is here already, and another one: it stays as it is.</source>
        <translation>这里已有不同的路径“%1”：保持不变。</translation>
    </message>
    <message>
        <source>More routes that stay as they are: %1.</source>
        <translation>另有保持不变的路径：%1 条。</translation>
    </message>
    <message>
        <source>Address %1 is a vehicle&apos;s here already, and another one&apos;s: it stays as it is.</source>
        <translation>地址 %1 在这里已属于另一辆车：该车保持不变。</translation>
    </message>
    <message>
        <source>More vehicles that stay as they are: %1.</source>
        <translation>另有保持不变的车辆：%1 辆。</translation>
    </message>
    <message>
        <source>Tile &quot;%1&quot; is of type &quot;%2&quot;, which is another one in the open site.</source>
        <translation>地板砖“%1”的类型是“%2”，而打开的场地中同名类型与之不同。</translation>
    </message>
    <message>
        <source>the site would have more of a kind than a site file holds.</source>
        <translation>场地中某一类的数量会超过场地文件的上限。</translation>
    </message>
    <message>
        <source>Tiles that come to lie upon tiles that are here already: %1. The panel Faults lists them.</source>
        <translation>将压在已有地板砖上的地板砖：%1 块。“问题”面板会列出它们。</translation>
    </message>
    <message>
        <source>The file&apos;s site lies otherwise to north: its coordinates are taken as they are.</source>
        <translation>文件中场地的北方向不同：坐标按原样采用。</translation>
    </message>
    <message>
        <source>The file&apos;s vehicles were set up for another setting of the radio.</source>
        <translation>文件中的车辆是按另一种无线电设置调试的。</translation>
    </message>
    <message>
        <source>The picture beneath the file&apos;s floor is left out.</source>
        <translation>文件中地面下方的图片未导入。</translation>
    </message>
    <message>
        <source>Places where a tile has a tag (within 1 cm), whose UID they give: %1.</source>
        <translation>与地板砖标签位置相符（1 厘米以内）、给出其 UID 的位置：%1 处。</translation>
    </message>
    <message>
        <source>No tiles are laid: there is nothing to drive over.</source>
        <translation>没有铺设地板砖：无处可驶。</translation>
    </message>
    <message>
        <source>The floor is too small for the figure: it needs 1.4 m by 1.4 m.</source>
        <translation>地面放不下校准图形：需要 1.4 m × 1.4 m。</translation>
    </message>
    <message>
        <source>Only %1 reads can be used; at least %2 are needed.</source>
        <translation>只有 %1 次读数可用；至少需要 %2 次。</translation>
    </message>
    <message>
        <source>Nothing can be told from this drive.</source>
        <translation>从这次行驶中得不出结果。</translation>
    </message>
    <message>
        <source>Tag %1 is registered already, as tag %2 of this tile.</source>
        <translation>标签 %1 已登记为这块地板砖的第 %2 个标签。</translation>
    </message>
    <message>
        <source>In %1 of %2 directions nothing was measured: the vehicle did not turn all around.</source>
        <translation>%2 个方向中有 %1 个没有测到：车辆没有转满一圈。</translation>
    </message>
    <message>
        <source>A horizontal field of %1 µT cannot be the earth&apos;s: iron, magnets or currents are too near, or the compass does not lie level.</source>
        <translation>%1 µT 的水平磁场不可能是地磁场：铁、磁铁或电流太近，或者罗盘没有放平。</translation>
    </message>
    <message>
        <source>The ellipse is %1 times as long as wide: iron sits right beside the compass. Mount it elsewhere.</source>
        <translation>椭圆的长是宽的 %1 倍：罗盘旁边紧挨着铁。请把它装到别处。</translation>
    </message>
    <message>
        <source>The points lie on no ellipse: they are off by %1 % of the field. Something has moved or was switched meanwhile, or steel stands near.</source>
        <translation>这些点不在任何椭圆上：偏离达磁场的 %1 %。其间有物体移动或电流通断，或附近有钢铁。</translation>
    </message>
    <message>
        <source>the field in a direction of the compass&apos; turn</source>
        <translation>罗盘转动中某一方向的磁场</translation>
    </message>
    <message>
        <source>turning on the spot to measure the field</source>
        <translation>原地转动以测量磁场</translation>
    </message>
    <message>
        <source>All vehicles shall stop. They cannot be told while the radio&apos;s port is not open: each stops by itself when its command runs out.</source>
        <translation>所有车辆应停车。无线电端口未打开，无法通知它们；每辆车在其命令过期后会自行停车。</translation>
    </message>
    <message>
        <source>the way along which unequal tyres are learned</source>
        <translation>学习左右轮胎差异所用的行程</translation>
    </message>
    <message>
        <source>These bytes are no magnetic map.</source>
        <translation>这些字节不是磁场图。</translation>
    </message>
    <message>
        <source>The magnetic map was made by another version of Tessera.</source>
        <translation>磁场图由另一版本的 Tessera 生成。</translation>
    </message>
    <message>
        <source>The magnetic map is cut short or too long.</source>
        <translation>磁场图不完整或过长。</translation>
    </message>
    <message>
        <source>The magnetic map is damaged.</source>
        <translation>磁场图已损坏。</translation>
    </message>
    <message>
        <source>The magnetic map has another grid than this version of Tessera.</source>
        <translation>磁场图的网格与此版本的 Tessera 不同。</translation>
    </message>
    <message>
        <source>The magnetic map holds numbers that no map has.</source>
        <translation>磁场图中含有不可能的数值。</translation>
    </message>
    <message>
        <source>a usual vehicle</source>
        <translation>常用车辆</translation>
    </message>
    <message>
        <source>vehicle &quot;%1&quot;</source>
        <translation>车辆“%1”</translation>
    </message>
    <message>
        <source>On route &quot;%1&quot; %2 sees no registered tag for %3 m, from %4 m on; it can bridge %5 m.</source>
        <translation>在路径“%1”上，%2从 %4 m 处起连续 %3 m 读不到已登记的电子标签；最多可跨越 %5 m。</translation>
    </message>
    <message>
        <source>At %2 m route &quot;%1&quot; bends faster than %3 can turn at its full speed: %4 rad/s instead of %5 rad/s.</source>
        <translation>路径“%1”在 %2 m 处转弯过急：%3全速时需要 %4 rad/s，而其上限为 %5 rad/s。</translation>
    </message>
    <message>
        <source>On route &quot;%1&quot; %2 with %5 m of room around it sticks out of the zones in which it may be, over %3 m² about %4 m.</source>
        <translation>在路径“%1”上，%2连同其四周 %5 m 的空间超出允许区域 %3 m²，位于 %4 m 附近。</translation>
    </message>
    <message>
        <source>On route &quot;%1&quot; %2 sticks out of the zones in which it may be, over %3 m² about %4 m.</source>
        <translation>在路径“%1”上，%2的车身会超出可行驶区域，面积 %3 m²，位于 %4 m 附近。</translation>
    </message>
    <message>
        <source>The site has no vehicle: routes are checked for a usual one.</source>
        <translation>场地没有车辆：路径按常用车辆检查。</translation>
    </message>
    <message>
        <source>%1: is no file but a folder, a device or the like, which is not replaced.</source>
        <translation>%1：不是文件，而是文件夹、设备或类似对象，不会被替换。</translation>
    </message>
    <message>
        <source>Loose tags, which belong to no tile, left out: %1.</source>
        <translation>不属于任何地板砖的单独标签未写出：%1 个。</translation>
    </message>
    <message>
        <source>Registered tags of tiles that are not laid and so have no place, left out: %1.</source>
        <translation>未铺设的地板砖没有位置，其已登记的标签未写出：%1 个。</translation>
    </message>
    <message>
        <source>Rounding the corners of route &quot;%1&quot;, %2 drives %3 m through the no-go zone &quot;%4&quot;, first at vertex %5.</source>
        <translation>%2在路径“%1”上走圆角时有 %3 m 穿过禁行区域“%4”，首次在第 %5 个顶点处。</translation>
    </message>
    <message>
        <source>Rounding the corners of route &quot;%1&quot;, %2 drives %3 m outside the zones in which vehicles may be, first at vertex %4.</source>
        <translation>%2在路径“%1”上走圆角时有 %3 m 位于车辆可行驶区域之外，首次在第 %4 个顶点处。</translation>
    </message>
    <message>
        <source>Rounding the corners of route &quot;%1&quot;, %2 drives %3 m the wrong way through the one-way zone &quot;%4&quot;, first at vertex %5.</source>
        <translation>%2在路径“%1”上走圆角时有 %3 m 逆行穿过单行区域“%4”，首次在第 %5 个顶点处。</translation>
    </message>
    <message>
        <source>Leg %1 of route &quot;%2&quot; may be driven at %3 m/s, but rounding its corner %6 comes through the slow zone &quot;%4&quot; of %5 m/s.</source>
        <translation>路径“%2”的第 %1 段允许 %3 m/s，但%6在该段拐角走圆角时穿过限速 %5 m/s 的慢行区域“%4”。</translation>
    </message>
    <message>
        <source>%1 read a tag that lies elsewhere: it goes on slowly until others tell where it is.</source>
        <translation>%1 读到了一个应在别处的标签：它慢速前行，直到其他标签表明它在哪里。</translation>
    </message>
    <message>
        <source>%1 is sure of its place again.</source>
        <translation>%1 又确定了自己的位置。</translation>
    </message>
</context>
<context>
    <name>FloorCanvas</name>
    <message>
        <source>N</source>
        <comment>north, on the map&apos;s compass</comment>
        <translation>北</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 分钟</translation>
    </message>
    <message>
        <source>%1, %2 ago</source>
        <comment>a vehicle&apos;s name, how long ago it was last heard</comment>
        <translation>%1，%2前</translation>
    </message>
    <message>
        <source>%1 m/s</source>
        <translation>%1 m/s</translation>
    </message>
</context>
<context>
    <name>LayEdits</name>
    <message>
        <source>A tile may lie no farther than 100 km from the site&apos;s origin.</source>
        <translation>地板砖距场地原点不得超过 100 km。</translation>
    </message>
    <message>
        <source>Tile “%1” would lie upon tile “%2”.</source>
        <translation>地板砖“%1”会压在地板砖“%2”上。</translation>
    </message>
    <message numerus="yes">
        <source>Move %n tile(s)</source>
        <translation>
            <numerusform>移动 %n 块地板砖</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Turn %n tile(s)</source>
        <translation>
            <numerusform>旋转 %n 块地板砖</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Align %n tile(s)</source>
        <translation>
            <numerusform>对齐 %n 块地板砖</numerusform>
        </translation>
    </message>
    <message>
        <source>Place tile %1</source>
        <translation>放置地板砖 %1</translation>
    </message>
    <message>
        <source>A site holds no more than a million tiles.</source>
        <translation>一个场地最多一百万块地板砖。</translation>
    </message>
    <message>
        <source>This site has a tile type “%1” that is another one.</source>
        <translation>此场地已有名为“%1”的另一种地板规格。</translation>
    </message>
    <message>
        <source>There is no tile type “%1” any more.</source>
        <translation>地板规格“%1”已不存在。</translation>
    </message>
    <message>
        <source>There are tiles already: none may lie upon another.</source>
        <translation>那里已有地板砖：地板砖不能重叠。</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n tile(s)</source>
        <translation>
            <numerusform>删除 %n 块地板砖</numerusform>
        </translation>
    </message>
    <message>
        <source>A tile needs a serial number.</source>
        <translation>地板砖需要序列号。</translation>
    </message>
    <message>
        <source>This serial number is too long.</source>
        <translation>这个序列号太长。</translation>
    </message>
    <message>
        <source>There is a tile “%1” already.</source>
        <translation>已有地板砖“%1”。</translation>
    </message>
    <message>
        <source>Rename tile %1</source>
        <translation>重命名地板砖 %1</translation>
    </message>
</context>
<context>
    <name>MapSheet</name>
    <message>
        <source>Scale 1 : %1</source>
        <translation>比例 1 : %1</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>Place without a registered tag</source>
        <translation>没有登记标签的位置</translation>
    </message>
    <message>
        <source>Route</source>
        <translation>路径</translation>
    </message>
    <message>
        <source>N</source>
        <comment>north</comment>
        <translation>北</translation>
    </message>
    <message>
        <source>Unnamed site</source>
        <translation>未命名场地</translation>
    </message>
    <message>
        <source>Running zone</source>
        <translation>行驶区域</translation>
    </message>
    <message>
        <source>Storage</source>
        <translation>存储区域</translation>
    </message>
    <message>
        <source>Parking</source>
        <translation>停车区域</translation>
    </message>
    <message>
        <source>Charging</source>
        <translation>充电区域</translation>
    </message>
    <message>
        <source>No-go zone</source>
        <translation>禁行区域</translation>
    </message>
    <message>
        <source>Slow zone</source>
        <translation>慢行区域</translation>
    </message>
    <message>
        <source>One-way zone</source>
        <translation>单行区域</translation>
    </message>
    <message>
        <source>Zone for one vehicle at a time</source>
        <translation>单车区域</translation>
    </message>
</context>
<context>
    <name>Readout</name>
    <message>
        <source>%1 m, %2°</source>
        <comment>length and bearing of a leg</comment>
        <translation>%1 m，%2°</translation>
    </message>
    <message>
        <source>x %1 m, y %2 m</source>
        <translation>x %1 m，y %2 m</translation>
    </message>
    <message>
        <source>vertex</source>
        <translation>顶点</translation>
    </message>
    <message>
        <source>tag</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>tile corner</source>
        <translation>地板砖角</translation>
    </message>
    <message>
        <source>tile middle</source>
        <translation>地板砖中心</translation>
    </message>
    <message>
        <source>tile edge</source>
        <translation>地板砖边</translation>
    </message>
    <message>
        <source>45° steps</source>
        <translation>45° 步进</translation>
    </message>
</context>
<context>
    <name>RegisterEdits</name>
    <message>
        <source>There is no tile %1 any more.</source>
        <translation>已没有地板砖 %1。</translation>
    </message>
    <message>
        <source>Register tag %1 of tile %2</source>
        <translation>登记地板砖 %2 的第 %1 个标签</translation>
    </message>
    <message>
        <source>Take back tag %1 of tile %2</source>
        <translation>撤回地板砖 %2 的第 %1 个标签</translation>
    </message>
    <message>
        <source>Clear the registration of tile %1</source>
        <translation>清除地板砖 %1 的登记</translation>
    </message>
    <message>
        <source>Take back the tags of tile %1</source>
        <translation>撤回地板砖 %1 的标签</translation>
    </message>
    <message>
        <source>Exchange tags %1 and %2 of tile %3</source>
        <translation>对调地板砖 %3 的第 %1 个和第 %2 个标签</translation>
    </message>
    <message>
        <source>Read tile %1 anew</source>
        <translation>重新读取地板砖 %1</translation>
    </message>
</context>
<context>
    <name>RouteEdits</name>
    <message>
        <source>Route %1</source>
        <translation>路径 %1</translation>
    </message>
    <message>
        <source>There is no route called “%1” any more.</source>
        <translation>名为“%1”的路径已不存在。</translation>
    </message>
    <message>
        <source>A route needs at least two vertices.</source>
        <translation>路径至少需要两个顶点。</translation>
    </message>
    <message>
        <source>Draw %1</source>
        <translation>绘制 %1</translation>
    </message>
    <message>
        <source>%1 (copy)</source>
        <translation>%1（副本）</translation>
    </message>
    <message>
        <source>%1 (copy %2)</source>
        <translation>%1（副本 %2）</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>复制 %1</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>删除 %1</translation>
    </message>
    <message>
        <source>A route needs a name.</source>
        <translation>路径需要名称。</translation>
    </message>
    <message>
        <source>This name is too long for a route.</source>
        <translation>此名称对路径来说过长。</translation>
    </message>
    <message>
        <source>There is a route called “%1” already.</source>
        <translation>已有名为“%1”的路径。</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>重命名 %1</translation>
    </message>
    <message>
        <source>Reverse %1</source>
        <translation>反向 %1</translation>
    </message>
    <message>
        <source>Space control points of %1</source>
        <translation>设置 %1 的控制点间距</translation>
    </message>
    <message>
        <source>Move vertex %1 of %2</source>
        <translation>移动 %2 的顶点 %1</translation>
    </message>
    <message>
        <source>This route has as many vertices as a route may have.</source>
        <translation>此路径的顶点数已达上限。</translation>
    </message>
    <message>
        <source>Insert vertex into %1</source>
        <translation>在 %1 中插入顶点</translation>
    </message>
    <message>
        <source>A route needs two vertices; to remove it, delete the route.</source>
        <translation>路径需要两个顶点；要去掉它，请删除路径。</translation>
    </message>
    <message>
        <source>Delete vertex %1 of %2</source>
        <translation>删除 %2 的顶点 %1</translation>
    </message>
    <message>
        <source>“%1” and “%2” have no end in common.</source>
        <translation>“%1”和“%2”没有共同的端点。</translation>
    </message>
    <message>
        <source>Together they would have more vertices than a route may have.</source>
        <translation>合在一起的顶点数会超过路径的上限。</translation>
    </message>
    <message>
        <source>Join %1 with %2</source>
        <translation>将%1与%2连接</translation>
    </message>
    <message>
        <source>A route is split at a vertex between two others.</source>
        <translation>路径只能在中间的顶点处拆分。</translation>
    </message>
    <message>
        <source>%1 (part 2)</source>
        <translation>%1（第 2 段）</translation>
    </message>
    <message>
        <source>%1 (part 2, %2)</source>
        <translation>%1（第 2 段，%2）</translation>
    </message>
    <message>
        <source>Split %1</source>
        <translation>拆分%1</translation>
    </message>
    <message>
        <source>Set speed of leg %1 of %2</source>
        <translation>设置 %2 第 %1 段的速度</translation>
    </message>
</context>
<context>
    <name>SaveEvents</name>
    <message>
        <source>The file %1 could not be written. Choose another folder.</source>
        <translation>无法写入文件 %1。请选择其他文件夹。</translation>
    </message>
    <message>
        <source>Save the listed events</source>
        <translation>保存列出的事件</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
</context>
<context>
    <name>Wording</name>
    <message>
        <source>Unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Calling</source>
        <translation>呼叫中</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>已连接</translation>
    </message>
    <message>
        <source>Silent</source>
        <translation>无应答</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>被拒绝</translation>
    </message>
    <message>
        <source>Idle</source>
        <translation>空闲</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>运行中</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>已暂停</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>已完成</translation>
    </message>
    <message>
        <source>Driven by hand</source>
        <translation>手动驾驶</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>已关闭</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>已打开</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>已断开</translation>
    </message>
    <message>
        <source>Sent</source>
        <translation>已发送</translation>
    </message>
    <message>
        <source>Acknowledged</source>
        <translation>已确认</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>已完成</translation>
    </message>
    <message>
        <source>Expired</source>
        <translation>已过期</translation>
    </message>
    <message>
        <source>Info</source>
        <translation>信息</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>Standing</source>
        <translation>静止</translation>
    </message>
    <message>
        <source>Driving</source>
        <translation>行驶中</translation>
    </message>
    <message>
        <source>Turning</source>
        <translation>转向中</translation>
    </message>
    <message>
        <source>Before an obstacle</source>
        <translation>前方有障碍物</translation>
    </message>
    <message>
        <source>Stopped by itself</source>
        <translation>已自行停车</translation>
    </message>
    <message>
        <source>Calibrating</source>
        <translation>校准中</translation>
    </message>
    <message>
        <source>Faulted</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>Motor stalled</source>
        <translation>电机堵转</translation>
    </message>
    <message>
        <source>Wheel encoder</source>
        <translation>车轮编码器</translation>
    </message>
    <message>
        <source>No compass</source>
        <translation>罗盘无应答</translation>
    </message>
    <message>
        <source>Magnetic field</source>
        <translation>磁场异常</translation>
    </message>
    <message>
        <source>Tag reader</source>
        <translation>读卡器</translation>
    </message>
    <message>
        <source>Battery low</source>
        <translation>电池电量低</translation>
    </message>
    <message>
        <source>Settings&apos; memory</source>
        <translation>设置存储器</translation>
    </message>
    <message>
        <source>Restarted by watchdog</source>
        <translation>看门狗重启</translation>
    </message>
    <message>
        <source>Radio module</source>
        <translation>无线模块</translation>
    </message>
    <message>
        <source>Forged command</source>
        <translation>伪造的指令</translation>
    </message>
    <message>
        <source>Replayed command</source>
        <translation>重放的指令</translation>
    </message>
    <message>
        <source>Tag reads dropped</source>
        <translation>标签读取记录丢弃</translation>
    </message>
    <message>
        <source>Ranger</source>
        <translation>测距传感器</translation>
    </message>
</context>
<context>
    <name>ZoneEdits</name>
    <message>
        <source>There is no zone called “%1” any more.</source>
        <translation>已没有名为“%1”的区域。</translation>
    </message>
    <message>
        <source>A zone needs at least three corners.</source>
        <translation>区域至少需要三个角点。</translation>
    </message>
    <message>
        <source>This outline encloses no floor.</source>
        <translation>此轮廓没有围住任何地面。</translation>
    </message>
    <message>
        <source>Draw %1</source>
        <translation>绘制%1</translation>
    </message>
    <message>
        <source>%1 (copy)</source>
        <translation>%1（副本）</translation>
    </message>
    <message>
        <source>%1 (copy %2)</source>
        <translation>%1（副本 %2）</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>复制%1</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>删除%1</translation>
    </message>
    <message>
        <source>A zone needs a name.</source>
        <translation>区域需要名称。</translation>
    </message>
    <message>
        <source>This name is too long for a zone.</source>
        <translation>此名称对区域来说太长。</translation>
    </message>
    <message>
        <source>There is a zone called “%1” already.</source>
        <translation>已有名为“%1”的区域。</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>重命名%1</translation>
    </message>
    <message>
        <source>Make %1 a %2</source>
        <translation>将%1改为%2</translation>
    </message>
    <message>
        <source>Set speed of %1</source>
        <translation>设定%1的速度</translation>
    </message>
    <message>
        <source>Set direction of %1</source>
        <translation>设定%1的方向</translation>
    </message>
    <message>
        <source>Move corner %1 of %2</source>
        <translation>移动%2的角点 %1</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>移动%1</translation>
    </message>
    <message>
        <source>This zone has as many corners as a zone may have.</source>
        <translation>此区域的角点数已达上限。</translation>
    </message>
    <message>
        <source>Insert corner into %1</source>
        <translation>在%1中插入角点</translation>
    </message>
    <message>
        <source>A zone needs three corners; to remove it, delete the zone.</source>
        <translation>区域需要三个角点；要去掉它，请删除区域。</translation>
    </message>
    <message>
        <source>Delete corner %1 of %2</source>
        <translation>删除%2的角点 %1</translation>
    </message>
</context>
<context>
    <name>ZoneShape</name>
    <message>
        <source>%1 m²</source>
        <translation>%1 m²</translation>
    </message>
</context>
<context>
    <name>ZoneWords</name>
    <message>
        <source>Running zone</source>
        <translation>行驶区域</translation>
    </message>
    <message>
        <source>Storage zone</source>
        <translation>存储区域</translation>
    </message>
    <message>
        <source>Parking zone</source>
        <translation>停车区域</translation>
    </message>
    <message>
        <source>Charging zone</source>
        <translation>充电区域</translation>
    </message>
    <message>
        <source>No-go zone</source>
        <translation>禁行区域</translation>
    </message>
    <message>
        <source>Slow zone</source>
        <translation>慢行区域</translation>
    </message>
    <message>
        <source>One-way zone</source>
        <translation>单行区域</translation>
    </message>
    <message>
        <source>Single-vehicle zone</source>
        <translation>单车区域</translation>
    </message>
    <message>
        <source>Vehicles may drive here.</source>
        <translation>车辆可以在此行驶。</translation>
    </message>
    <message>
        <source>Vehicles may be here; goods are put down and taken up.</source>
        <translation>车辆可以在此；货物在此放下和取走。</translation>
    </message>
    <message>
        <source>Vehicles may be here; idle ones wait.</source>
        <translation>车辆可以在此；空闲车辆在此等候。</translation>
    </message>
    <message>
        <source>Vehicles may be here; they charge their batteries.</source>
        <translation>车辆可以在此；在此充电。</translation>
    </message>
    <message>
        <source>No vehicle may be here, whatever other zones say.</source>
        <translation>任何车辆都不得在此，无论其他区域如何规定。</translation>
    </message>
    <message>
        <source>Vehicles drive no faster than the zone&apos;s speed here.</source>
        <translation>车辆在此不快于该区域的速度。</translation>
    </message>
    <message>
        <source>Ways lead within 90° of the zone&apos;s direction here.</source>
        <translation>在此行驶方向与区域方向之差不超过 90°。</translation>
    </message>
    <message>
        <source>Only one vehicle at a time may be here.</source>
        <translation>同一时间只允许一辆车在此。</translation>
    </message>
    <message>
        <source>Zones upon one another:
• No-go wins over every other kind.
• A vehicle may be where a running, storage, parking or charging zone is and no no-go zone; the other kinds restrict what lies under them.
• Of several slow zones the lowest speed holds.
• Of several one-way zones each holds.
• Of several single-vehicle zones each has to be free.</source>
        <translation>区域重叠时：
• 禁行优先于其他任何类型。
• 车辆可以在有行驶、存储、停车或充电区域且没有禁行区域的地方；其他类型限制其下的区域。
• 多个慢行区域中最低速度有效。
• 多个单行区域中每一个都有效。
• 多个单车区域每一个都必须空闲。</translation>
    </message>
</context>
<context>
    <name>tessera::desktop::BackdropDesk</name>
    <message>
        <source>Choose a picture of the floor plan</source>
        <translation>选择平面图图片</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg);;All files (*)</source>
        <translation>图片 (*.png *.jpg *.jpeg);;所有文件 (*)</translation>
    </message>
    <message>
        <source>The picture could not be taken</source>
        <translation>无法使用该图片</translation>
    </message>
</context>
<context>
    <name>tessera::desktop::ExchangeFiles</name>
    <message>
        <source>Import</source>
        <translation>导入</translation>
    </message>
    <message>
        <source>The file could not be imported</source>
        <translation>无法导入该文件</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>导入 %1</translation>
    </message>
    <message>
        <source>Table of the tiles&apos; tags (*%1)</source>
        <translation>地板砖标签表 (*%1)</translation>
    </message>
    <message>
        <source>Layout of routes and stations, VDMA LIF (*%1)</source>
        <translation>路径和站点布局，VDMA LIF (*%1)</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>%1 exists already. Replace it?</source>
        <translation>%1 已存在。要替换它吗？</translation>
    </message>
    <message>
        <source>The file could not be written</source>
        <translation>无法写入该文件</translation>
    </message>
    <message>
        <source>Exported</source>
        <translation>已导出</translation>
    </message>
    <message>
        <source>%1 was written. What the format cannot carry:</source>
        <translation>已写入 %1。该格式无法表达的内容：</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>保存图片</translation>
    </message>
    <message>
        <source>Pictures (*.pdf *.svg *.png)</source>
        <translation>图片 (*.pdf *.svg *.png)</translation>
    </message>
    <message>
        <source>The picture could not be saved</source>
        <translation>无法保存图片</translation>
    </message>
    <message>
        <source>Table of all tags with their places (*%1)</source>
        <translation>全部标签及其位置的表 (*%1)</translation>
    </message>
    <message>
        <source>Tables of tags, layouts and sites (*.csv *.lif *.json);;All files (*)</source>
        <translation>标签表、布局和场地 (*.csv *.lif *.json);;所有文件 (*)</translation>
    </message>
    <message>
        <source>%1 was written.</source>
        <translation>%1 已写出。</translation>
    </message>
</context>
<context>
    <name>tessera::desktop::FleetSession</name>
    <message>
        <source>No vehicle is supervised with a site that contradicts itself: %1 Mend it first, in the panel Faults.</source>
        <translation>场地自相矛盾时不监管任何车辆：%1 请先在“问题”面板中修正。</translation>
    </message>
</context>
<context>
    <name>tessera::desktop::Keeper</name>
    <message>
        <source>The journal cannot be read just now. Try again in a moment.</source>
        <translation>暂时无法读取日志。请稍后再试。</translation>
    </message>
</context>
<context>
    <name>tessera::desktop::MagneticDesk</name>
    <message>
        <source>What was learned of the iron in this floor cannot be read and is begun anew: %1</source>
        <translation>此地面中铁的学习结果无法读取，将重新开始：%1</translation>
    </message>
    <message>
        <source>The storage cannot be asked just now.</source>
        <translation>现在无法查询存储。</translation>
    </message>
</context>
<context>
    <name>tessera::desktop::MainWindow</name>
    <message>
        <source>x %1 m, y %2 m</source>
        <translation>x %1 m，y %2 m</translation>
    </message>
    <message>
        <source>%1[*] – Tessera</source>
        <translation>%1[*] – Tessera</translation>
    </message>
    <message>
        <source>Unnamed site</source>
        <translation>未命名场地</translation>
    </message>
    <message>
        <source>Tessera</source>
        <translation>Tessera</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>未连接</translation>
    </message>
    <message>
        <source>The simulated world is being set up…</source>
        <translation>正在建立演示环境…</translation>
    </message>
    <message>
        <source>The vehicles are being stopped…</source>
        <translation>正在停止车辆…</translation>
    </message>
    <message>
        <source>The simulated world has no radio module until it is connected: choose Connect first.</source>
        <translation>演示环境在连接之前没有无线模块：请先选择“连接”。</translation>
    </message>
    <message>
        <source>The radio module is being set</source>
        <translation>正在设置无线模块</translation>
    </message>
    <message>
        <source>Simulated world: %1</source>
        <translation>仿真环境：%1</translation>
    </message>
    <message>
        <source>Not confirmed that it stands: %1. A vehicle stops by itself when its last command has run out, a few seconds later at most. Go and look.</source>
        <translation>未确认已停下：%1。车辆在最后一条指令过期后会自行停止，最多几秒钟。请到现场查看。</translation>
    </message>
    <message>
        <source>Do all vehicles stand?</source>
        <translation>所有车辆都停下了吗？</translation>
    </message>
    <message>
        <source>Take up a vehicle&apos;s key</source>
        <translation>采用车辆的密钥</translation>
    </message>
    <message>
        <source>What is wrong with the site: click for the list</source>
        <translation>场地有什么问题：点击查看列表</translation>
    </message>
    <message>
        <source>&amp;Tool’s menu here</source>
        <translation>此处的工具菜单(&amp;T)</translation>
    </message>
    <message>
        <source>Connection › Connect… (Ctrl+K) takes the vehicles under supervision.</source>
        <translation>“连接 › 连接…”(Ctrl+K) 开始监控车辆。</translation>
    </message>
    <message>
        <source>Forget the magnetic map</source>
        <translation>清除磁场图</translation>
    </message>
    <message>
        <source>Forget what vehicles have learned of the iron in this floor? This cannot be undone; they learn it anew as they drive.</source>
        <translation>要清除车辆学到的此地面中的铁吗？此操作无法撤销；车辆会在行驶中重新学习。</translation>
    </message>
    <message>
        <source>&amp;Forget</source>
        <translation>清除(&amp;F)</translation>
    </message>
    <message>
        <source>The compass&apos; values are being written into the vehicle; then the window closes.</source>
        <translation>正在把罗盘的数值写入车辆；写完后窗口会关闭。</translation>
    </message>
</context>
<context>
    <name>tessera::desktop::RevisionDesk</name>
    <message>
        <source>It cannot be read just now. Try again in a moment.</source>
        <translation>现在无法读取。请稍后重试。</translation>
    </message>
    <message>
        <source>Save the revision as a file</source>
        <translation>将修订版本另存为文件</translation>
    </message>
    <message>
        <source>Sites (*%1)</source>
        <translation>场地 (*%1)</translation>
    </message>
    <message>
        <source>The revision could not be saved</source>
        <translation>无法保存修订版本</translation>
    </message>
    <message>
        <source>%1 exists already. Choose another name.</source>
        <translation>%1 已存在。请换一个名称。</translation>
    </message>
    <message>
        <source>%1 is the open site&apos;s file. Choose another name.</source>
        <translation>%1 是当前场地的文件。请换一个名称。</translation>
    </message>
    <message>
        <source>Saved by somebody else</source>
        <translation>由他人保存</translation>
    </message>
</context>
<context>
    <name>tessera::desktop::ScanWorkbench</name>
    <message>
        <source>built into this computer</source>
        <translation>本机内置</translation>
    </message>
</context>
<context>
    <name>tessera::desktop::SiteFiles</name>
    <message>
        <source>Open a site</source>
        <translation>打开场地</translation>
    </message>
    <message>
        <source>Sites (*%1);;All files (*)</source>
        <translation>场地 (*%1);;所有文件 (*)</translation>
    </message>
    <message>
        <source>The demo floor is not there</source>
        <translation>找不到演示场地</translation>
    </message>
    <message>
        <source>The site could not be opened</source>
        <translation>无法打开场地</translation>
    </message>
    <message>
        <source>Restore unsaved changes</source>
        <translation>恢复未保存的更改</translation>
    </message>
    <message>
        <source>Unsaved changes were kept</source>
        <translation>存在未保存的更改</translation>
    </message>
    <message>
        <source>When %1 was open last, the program ended before its changes were saved. Take them up again?</source>
        <translation>上次打开 %1 时，程序在保存更改之前结束。要恢复这些更改吗？</translation>
    </message>
    <message>
        <source>&amp;Take them up</source>
        <translation>恢复(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Forget them</source>
        <translation>丢弃(&amp;F)</translation>
    </message>
    <message>
        <source>Save the site</source>
        <translation>保存场地</translation>
    </message>
    <message>
        <source>Sites (*%1)</source>
        <translation>场地 (*%1)</translation>
    </message>
    <message>
        <source>The site could not be saved</source>
        <translation>无法保存场地</translation>
    </message>
    <message>
        <source>Save the changes?</source>
        <translation>是否保存更改？</translation>
    </message>
    <message>
        <source>The site “%1” has changes that are not saved.</source>
        <translation>场地“%1”有未保存的更改。</translation>
    </message>
    <message>
        <source>The site could not be made</source>
        <translation>无法创建场地</translation>
    </message>
    <message>
        <source>Save the vehicle&apos;s key?</source>
        <translation>保存车辆的密钥？</translation>
    </message>
    <message>
        <source>%1 obeys nobody but who has its new key, and no file has it yet. Save the site?</source>
        <translation>%1 只接受持有其新密钥者的指令，而该密钥尚未保存到任何文件中。要保存场地吗？</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>稍后(&amp;L)</translation>
    </message>
    <message>
        <source>An unsaved site was kept</source>
        <translation>保留了一个未保存的场地</translation>
    </message>
    <message>
        <source>The site “%1” was in no file yet when the program ended (%2). Open it again?</source>
        <translation>程序结束时（%2）场地“%1”尚未保存到任何文件。要重新打开吗？</translation>
    </message>
    <message>
        <source>&amp;Open it</source>
        <translation>打开(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Forget it</source>
        <translation>放弃(&amp;F)</translation>
    </message>
    <message>
        <source>%1 exists already. Replace it?</source>
        <translation>%1 已存在。要替换它吗？</translation>
    </message>
    <message>
        <source>This site is open already</source>
        <translation>此场地已经打开</translation>
    </message>
    <message>
        <source>Another window of Tessera (process %1) has %2 open. Changes made in both overwrite one another.</source>
        <translation>另一个 Tessera 窗口（进程 %1）已经打开了 %2。两边的修改会互相覆盖。</translation>
    </message>
    <message>
        <source>&amp;Do not open it</source>
        <translation>不打开(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Open it here as well</source>
        <translation>在这里也打开(&amp;O)</translation>
    </message>
    <message>
        <source>The site contradicts itself</source>
        <translation>场地自相矛盾</translation>
    </message>
    <message>
        <source>%1 It was opened so that it can be mended: the panel Faults lists what is wrong. Until then no vehicle is supervised with it.</source>
        <translation>%1 场地已打开以便修正：“问题”面板列出了问题所在。修正之前不会用它监管任何车辆。</translation>
    </message>
    <message numerus="yes">
        <source>%1 And %n more.</source>
        <translation>
            <numerusform>%1 另有 %n 处。</numerusform>
        </translation>
    </message>
    <message>
        <source>The file was changed</source>
        <translation>文件已被更改</translation>
    </message>
    <message>
        <source>Somebody else has changed %1 since it was opened or saved here (%2). What it holds now is kept as a revision if you overwrite it.</source>
        <translation>自从在此打开或保存以来，%1 已被他人更改（%2）。若覆盖，其当前内容会保留为一个修订版本。</translation>
    </message>
    <message>
        <source>Somebody else has changed %1 since it was opened or saved here (%2). It can be read no more, so that no revision can be kept of it.</source>
        <translation>自从在此打开或保存以来，%1 已被他人更改（%2）。它已无法读取，因此不能保留为修订版本。</translation>
    </message>
    <message>
        <source>Save under &amp;another name…</source>
        <translation>以其他名称保存(&amp;A)…</translation>
    </message>
    <message>
        <source>&amp;Overwrite it</source>
        <translation>覆盖(&amp;O)</translation>
    </message>
</context>
<context>
    <name>tessera::desktop::StepLog</name>
    <message>
        <source>Undo: %1</source>
        <translation>撤销：%1</translation>
    </message>
    <message>
        <source>%1 (%2 times)</source>
        <translation>%1（%2 次）</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>以及其他 %n 项</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tessera::desktop::WindowActions</name>
    <message>
        <source>&amp;Site</source>
        <translation>场地(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>Veh&amp;icle</source>
        <translation>车辆(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Connection</source>
        <translation>连接(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>打开最近的场地(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Shown on the floor</source>
        <translation>地面显示内容(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>面板(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>语言(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>外观(&amp;A)</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>工具栏</translation>
    </message>
    <message>
        <source>&amp;Demo floor</source>
        <translation>演示场地(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;New…</source>
        <translation>新建(&amp;N)…</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>打开(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>放大(&amp;I)</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>缩小(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Whole floor</source>
        <translation>显示全场(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Follow the vehicle</source>
        <translation>跟随车辆(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Tags</source>
        <translation>标签(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Zones</source>
        <translation>区域(&amp;Z)</translation>
    </message>
    <message>
        <source>T&amp;rails</source>
        <translation>轨迹(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Uncertainty</source>
        <translation>不确定度(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>网格(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Look around</source>
        <translation>浏览(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Draw a route</source>
        <translation>绘制路径(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Connect…</source>
        <translation>连接(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Disconnect</source>
        <translation>断开连接(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Radio module of this computer…</source>
        <translation>本机的无线模块(&amp;R)…</translation>
    </message>
    <message>
        <source>&amp;Set up a new vehicle…</source>
        <translation>设置新车辆(&amp;S)…</translation>
    </message>
    <message>
        <source>&amp;Change the chosen vehicle…</source>
        <translation>更改所选车辆(&amp;C)…</translation>
    </message>
    <message>
        <source>Drive by &amp;hand…</source>
        <translation>手动驾驶(&amp;H)…</translation>
    </message>
    <message>
        <source>Stop a&amp;ll (F12)</source>
        <translation>全部停止（F12）(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Help for this view</source>
        <translation>当前视图的帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;About Tessera</source>
        <translation>关于 Tessera(&amp;A)</translation>
    </message>
    <message>
        <source>As the &amp;desktop</source>
        <translation>跟随系统(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>浅色(&amp;L)</translation>
    </message>
    <message>
        <source>D&amp;ark</source>
        <translation>深色(&amp;A)</translation>
    </message>
    <message>
        <source>Stop all vehicles, then close the port</source>
        <translation>停止所有车辆，然后关闭端口</translation>
    </message>
    <message>
        <source>Keep the chosen vehicle in view (%1)</source>
        <translation>使所选车辆始终处于视野内（%1）</translation>
    </message>
    <message>
        <source>Click the route&apos;s vertices on the floor (%1)</source>
        <translation>在地面上依次点击路径的顶点（%1）</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>撤销(&amp;U)：%1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>重做(&amp;R)：%1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Change routes</source>
        <translation>修改路径(&amp;C)</translation>
    </message>
    <message>
        <source>Register &amp;tags…</source>
        <translation>登记标签(&amp;T)…</translation>
    </message>
    <message>
        <source>Lay t&amp;iles</source>
        <translation>铺设地板砖(&amp;I)</translation>
    </message>
    <message>
        <source>Tile t&amp;ypes…</source>
        <translation>地板规格(&amp;Y)…</translation>
    </message>
    <message>
        <source>Lay tiles on the floor, choose and move them (%1)</source>
        <translation>在地面上铺设、选择和移动地板砖（%1）</translation>
    </message>
    <message>
        <source>&amp;Faults</source>
        <translation>问题(&amp;F)</translation>
    </message>
    <message>
        <source>Change &amp;zones</source>
        <translation>修改区域(&amp;Z)</translation>
    </message>
    <message>
        <source>Draw a z&amp;one</source>
        <translation>绘制区域(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Faults of the site</source>
        <translation>场地的问题(&amp;F)</translation>
    </message>
    <message>
        <source>Change zones on the floor and in their panel (%1)</source>
        <translation>在地面上和面板中修改区域（%1）</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>导入(&amp;I)…</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>导出(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;Picture of the map…</source>
        <translation>地图图片(&amp;P)…</translation>
    </message>
    <message>
        <source>&amp;Go to…</source>
        <translation>前往(&amp;G)…</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>测量(&amp;M)</translation>
    </message>
    <message>
        <source>Re&amp;visions</source>
        <translation>修订版本(&amp;V)</translation>
    </message>
    <message>
        <source>Floor &amp;plan</source>
        <translation>平面图(&amp;P)</translation>
    </message>
    <message>
        <source>Floor &amp;plan…</source>
        <translation>平面图(&amp;P)…</translation>
    </message>
    <message>
        <source>Dri&amp;ve-over check…</source>
        <translation>行驶检查(&amp;V)…</translation>
    </message>
    <message>
        <source>Loc&amp;ating of the vehicle…</source>
        <translation>车辆定位(&amp;A)…</translation>
    </message>
    <message>
        <source>Properties of the si&amp;te…</source>
        <translation>场地属性(&amp;T)…</translation>
    </message>
    <message>
        <source>Calibrate readers and &amp;wheels…</source>
        <translation>校准读卡器和车轮(&amp;W)…</translation>
    </message>
    <message>
        <source>Calibrate the co&amp;mpass…</source>
        <translation>校准罗盘(&amp;M)…</translation>
    </message>
    <message>
        <source>&amp;Iron in the floor</source>
        <translation>地面中的铁(&amp;I)</translation>
    </message>
    <message>
        <source>By how much iron turns compasses, as vehicles have learned it</source>
        <translation>车辆学到的铁使指南针偏转的角度</translation>
    </message>
    <message>
        <source>Forget the &amp;magnetic map…</source>
        <translation>清除磁场图(&amp;M)…</translation>
    </message>
</context>
<context>
    <name>tessera::desktop::WindowPanels</name>
    <message>
        <source>Vehicles</source>
        <translation>车辆</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>行驶</translation>
    </message>
    <message>
        <source>Routes</source>
        <translation>路径</translation>
    </message>
    <message>
        <source>Tiles</source>
        <translation>地板砖</translation>
    </message>
    <message>
        <source>Zones</source>
        <translation>区域</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>As it was opened</source>
        <translation>打开时的状态</translation>
    </message>
</context>
<context>
    <name>tessera::ui::AboutDialog</name>
    <message>
        <source>About Tessera</source>
        <translation>关于 Tessera</translation>
    </message>
    <message>
        <source>Tessera</source>
        <translation>Tessera</translation>
    </message>
    <message>
        <source>Version %1</source>
        <translation>版本 %1</translation>
    </message>
    <message>
        <source>Watches and guides automated vehicles that find their way by RFID tags in a tile floor. Free software under the GNU General Public License, version 3 or later; it comes without any warranty.</source>
        <translation>监控并引导依靠地板砖中的 RFID 电子标签定位的自动导引车辆。本软件是自由软件，依据 GNU 通用公共许可证第 3 版或更高版本发布，不提供任何担保。</translation>
    </message>
    <message>
        <source>&amp;Made of</source>
        <translation>组成部分(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Licence</source>
        <translation>许可证(&amp;L)</translation>
    </message>
    <message>
        <source>Software that Tessera is made of</source>
        <translation>Tessera 的软件组成</translation>
    </message>
    <message>
        <source>Text of the licence</source>
        <translation>许可证正文</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>组件</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>版本</translation>
    </message>
    <message>
        <source>Licence</source>
        <translation>许可证</translation>
    </message>
    <message>
        <source>Serves for</source>
        <translation>用途</translation>
    </message>
    <message>
        <source>&amp;Copy versions</source>
        <translation>复制版本信息(&amp;C)</translation>
    </message>
    <message>
        <source>Copy the versions for a report</source>
        <translation>复制版本信息，用于问题报告</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
</context>
<context>
    <name>tessera::ui::AskSeries</name>
    <message>
        <source>No answer came. Check the connection.</source>
        <translation>未收到应答。请检查连接。</translation>
    </message>
    <message>
        <source>Not connected. Connect to the vehicles and try again.</source>
        <translation>未连接。请先连接车辆，然后重试。</translation>
    </message>
</context>
<context>
    <name>tessera::ui::BackdropEdits</name>
    <message>
        <source>Another floor plan: %1</source>
        <translation>更换平面图：%1</translation>
    </message>
    <message>
        <source>Add floor plan %1</source>
        <translation>添加平面图 %1</translation>
    </message>
    <message>
        <source>Remove floor plan</source>
        <translation>去除平面图</translation>
    </message>
    <message>
        <source>Move floor plan</source>
        <translation>移动平面图</translation>
    </message>
    <message>
        <source>Turn floor plan</source>
        <translation>旋转平面图</translation>
    </message>
    <message>
        <source>Scale floor plan</source>
        <translation>缩放平面图</translation>
    </message>
    <message>
        <source>Opacity of floor plan</source>
        <translation>平面图不透明度</translation>
    </message>
</context>
<context>
    <name>tessera::ui::BackdropPanel</name>
    <message>
        <source>%1 × %2 pixels, %3 × %4 m</source>
        <translation>%1 × %2 像素，%3 × %4 m</translation>
    </message>
    <message>
        <source>%1 %</source>
        <comment>opacity</comment>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Click a point of the picture on the floor.</source>
        <translation>在地面上点击图片的一个点。</translation>
    </message>
    <message>
        <source>Click a second point, far from the first.</source>
        <translation>点击离第一个点较远的第二个点。</translation>
    </message>
    <message>
        <source>How far are the two points truly apart?</source>
        <translation>两点实际相距多远？</translation>
    </message>
    <message>
        <source>Floor plan</source>
        <translation>平面图</translation>
    </message>
    <message>
        <source>A picture of the building (PNG or JPEG) can lie beneath the floor, to lay tiles, zones and routes upon.</source>
        <translation>地面下方可以放一张建筑图片（PNG 或 JPEG），在其上铺设地板砖、绘制区域和路径。</translation>
    </message>
    <message>
        <source>Choose a picture…</source>
        <translation>选择图片…</translation>
    </message>
    <message>
        <source>Another…</source>
        <translation>更换…</translation>
    </message>
    <message>
        <source>Another picture in the place of this one</source>
        <translation>用另一张图片代替这一张</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>去除</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>Opacity of the floor plan</source>
        <translation>平面图的不透明度</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>Turned</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>One pixel</source>
        <translation>一个像素</translation>
    </message>
    <message>
        <source>Place of the picture&apos;s lower left corner</source>
        <translation>图片左下角的位置</translation>
    </message>
    <message>
        <source>About its lower left corner, counter-clockwise</source>
        <translation>绕左下角，逆时针</translation>
    </message>
    <message>
        <source>Length of a pixel&apos;s side on the floor</source>
        <translation>一个像素的边在地面上的长度</translation>
    </message>
    <message>
        <source> m</source>
        <comment>after a number</comment>
        <translation> m</translation>
    </message>
    <message>
        <source> mm</source>
        <comment>after a number</comment>
        <translation> mm</translation>
    </message>
    <message>
        <source>Scale by two points…</source>
        <translation>按两点定比例…</translation>
    </message>
    <message>
        <source>Click two points whose distance you know, then type it</source>
        <translation>点击已知距离的两个点，然后输入距离</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>tessera::ui::BackdropTool</name>
    <message>
        <source>Floor plan: choose a picture in its panel.</source>
        <translation>平面图：请在面板中选择图片。</translation>
    </message>
    <message>
        <source>Drag the floor plan or press the arrow keys (Shift: 10 cm). Esc lays the tool down.</source>
        <translation>拖动平面图或按方向键（Shift：10 cm）。Esc 放下工具。</translation>
    </message>
    <message>
        <source>Click the first of two points whose distance you know. Esc cancels.</source>
        <translation>点击已知距离的两点中的第一个。Esc 取消。</translation>
    </message>
    <message>
        <source>Click the second point. Backspace: back. Esc cancels.</source>
        <translation>点击第二个点。Backspace：退回。Esc 取消。</translation>
    </message>
    <message>
        <source>Type the true distance in the panel. Backspace: back. Esc cancels.</source>
        <translation>在面板中输入实际距离。Backspace：退回。Esc 取消。</translation>
    </message>
    <message>
        <source>now %1 m</source>
        <comment>a length</comment>
        <translation>现为 %1 m</translation>
    </message>
</context>
<context>
    <name>tessera::ui::CalibratePanel</name>
    <message>
        <source>The site has no vehicle yet. Set one up: Vehicle › Set up a new vehicle.</source>
        <translation>场地还没有车辆。请设置一台：车辆 › 设置新车辆。</translation>
    </message>
    <message>
        <source>Connect to the vehicles: the calibration is a drive.</source>
        <translation>请连接车辆：校准需要行驶。</translation>
    </message>
    <message>
        <source>Choose the vehicle to calibrate, in the list or on the floor.</source>
        <translation>在列表中或地面上选择要校准的车辆。</translation>
    </message>
    <message>
        <source>Draw the figure, or choose a route that crosses the rows of tags at a slant and turns often. Then press Record and run the vehicle along it, slowly (0.12 m/s).</source>
        <translation>画校准图形，或选择一条斜穿标签行、转弯多的路径。然后按“记录”，让车辆沿它慢速行驶（0.12 m/s）。</translation>
    </message>
    <message>
        <source>Run the vehicle along the route. Each tag that it reads tells a bit more.</source>
        <translation>让车辆沿路径行驶。每读到一个标签，结果就更明确一些。</translation>
    </message>
    <message>
        <source>Drive on until the deviations are small enough, then enter the values into the site.</source>
        <translation>继续行驶，直到标准差足够小，再把结果输入场地。</translation>
    </message>
    <message>
        <source>Compare the values. They are entered into the site as one step that can be undone.</source>
        <translation>请比较数值。输入场地作为一步，可以撤销。</translation>
    </message>
    <message>
        <source>The drive was too short, or turned too little: press Record and go on.</source>
        <translation>行驶太短，或转弯太少：请按“记录”继续。</translation>
    </message>
    <message>
        <source>%1 m driven, %2 half turns, %3 reads.</source>
        <translation>已行驶 %1 m，%2 个半圈，%3 次读数。</translation>
    </message>
    <message numerus="yes">
        <source>%n read(s) fit nothing and hardly count.</source>
        <translation>
            <numerusform>%n 次读数完全不符，几乎不计入。</numerusform>
        </translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>not told</source>
        <translation>未得出</translation>
    </message>
    <message>
        <source>Reader %1, ahead (mm)</source>
        <translation>读卡器 %1，向前（mm）</translation>
    </message>
    <message>
        <source>Reader %1, to the left (mm)</source>
        <translation>读卡器 %1，向左（mm）</translation>
    </message>
    <message>
        <source>Diameter of the wheels (mm)</source>
        <translation>车轮直径（mm）</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>校准</translation>
    </message>
    <message>
        <source>Draw the figure</source>
        <translation>画校准图形</translation>
    </message>
    <message>
        <source>A route for this: a star that crosses the rows of tags at every slant. It can be undone</source>
        <translation>用于校准的路径：以各种斜角穿过标签行的星形。可以撤销</translation>
    </message>
    <message>
        <source>Begin anew</source>
        <translation>重新开始</translation>
    </message>
    <message>
        <source>Forget what was recorded so far</source>
        <translation>清除至今的记录</translation>
    </message>
    <message>
        <source>Enter into the site</source>
        <translation>输入场地</translation>
    </message>
    <message>
        <source>Readers that the drive tells of get the offsets found; it can be undone</source>
        <translation>得出结果的读卡器采用得到的位置；可以撤销</translation>
    </message>
    <message>
        <source>the wheels as well</source>
        <translation>包括车轮</translation>
    </message>
    <message>
        <source>The vehicle learns of its wheels by “Change the chosen vehicle”, page of the settings</source>
        <translation>车辆通过“更改所选车辆”的参数页得知车轮直径</translation>
    </message>
    <message>
        <source>What</source>
        <translation>项目</translation>
    </message>
    <message>
        <source>Entered</source>
        <translation>输入值</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Deviation (1 σ)</source>
        <translation>标准差（1 σ）</translation>
    </message>
    <message>
        <source>What was found, beside what is entered</source>
        <translation>结果与输入值</translation>
    </message>
    <message>
        <source>Not known well enough yet: let it make %1 half turns at least.</source>
        <translation>还不够准确：请至少转过 %1 个半圈。</translation>
    </message>
    <message>
        <source>Not known well enough yet: drive on until the offsets&apos; deviations are below ± %1 mm.</source>
        <translation>还不够准确：请继续行驶，直到位置的标准差低于 ± %1 mm。</translation>
    </message>
    <message>
        <source>Wheels not known well enough yet: drive on until their deviation is below ± %1 mm.</source>
        <translation>车轮还不够准确：请继续行驶，直到其标准差低于 ± %1 mm。</translation>
    </message>
</context>
<context>
    <name>tessera::ui::Calibration</name>
    <message>
        <source>Calibrate readers</source>
        <translation>校准读卡器</translation>
    </message>
    <message>
        <source>Calibration</source>
        <comment>name of a route</comment>
        <translation>校准</translation>
    </message>
    <message>
        <source>Calibration %1</source>
        <comment>name of a route</comment>
        <translation>校准 %1</translation>
    </message>
    <message>
        <source>Draw the calibration figure</source>
        <translation>画校准图形</translation>
    </message>
</context>
<context>
    <name>tessera::ui::ChangesDialog</name>
    <message>
        <source>Import %1</source>
        <translation>导入 %1</translation>
    </message>
    <message>
        <source>The file says what the site has already: nothing would change.</source>
        <translation>文件内容与场地现有内容相同：不会有任何改变。</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>改变</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>另有 %n 处</numerusform>
        </translation>
    </message>
    <message>
        <source>Please note:</source>
        <translation>请注意：</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>导入(&amp;I)</translation>
    </message>
    <message numerus="yes">
        <source>%Ln changes: %1. They are made all together, as one step that can be undone.</source>
        <translation>
            <numerusform>%Ln 处改变：%1。它们作为一步一起完成，可以撤销。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln new</source>
        <translation>
            <numerusform>新增 %Ln</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln changed</source>
        <translation>
            <numerusform>修改 %Ln</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln moved</source>
        <translation>
            <numerusform>移动 %Ln</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln removed</source>
        <translation>
            <numerusform>移除 %Ln</numerusform>
        </translation>
    </message>
    <message>
        <source>, </source>
        <comment>between totals</comment>
        <translation>，</translation>
    </message>
</context>
<context>
    <name>tessera::ui::CommissionWizard</name>
    <message>
        <source>The vehicle has already taken its new key. Without this site it will obey nobody until it is reset. Give it up all the same?</source>
        <translation>车辆已启用新密钥。如果不保存到本场地，在复位之前车辆将不接受任何指令。仍要放弃吗？</translation>
    </message>
    <message>
        <source>Give up</source>
        <translation>放弃</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>继续设置</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Name and address</source>
        <translation>名称和地址</translation>
    </message>
    <message>
        <source>Summary</source>
        <translation>摘要</translation>
    </message>
    <message>
        <source>Set up a vehicle</source>
        <translation>设置车辆</translation>
    </message>
    <message>
        <source>Set up %1 again</source>
        <translation>重新设置 %1</translation>
    </message>
    <message>
        <source>&lt; &amp;Back</source>
        <translation>&lt; 上一步(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Next &gt;</source>
        <translation>下一步(&amp;N) &gt;</translation>
    </message>
    <message>
        <source>&amp;Finish</source>
        <translation>完成(&amp;F)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>步骤</translation>
    </message>
</context>
<context>
    <name>tessera::ui::Commissioning</name>
    <message>
        <source>Add vehicle %1</source>
        <translation>添加车辆 %1</translation>
    </message>
    <message>
        <source>Change vehicle %1</source>
        <translation>更改车辆 %1</translation>
    </message>
    <message>
        <source>Take back vehicle %1</source>
        <translation>撤回车辆 %1</translation>
    </message>
    <message>
        <source>Not connected. Connect to the vehicles to go on here.</source>
        <translation>未连接。请先连接车辆，再继续此步骤。</translation>
    </message>
    <message>
        <source>The port is not open. Check the cable and connect anew.</source>
        <translation>端口未打开。请检查线缆并重新连接。</translation>
    </message>
    <message>
        <source>The supervision does not know %1 yet. Wait a moment, or connect anew.</source>
        <translation>上位机尚未识别 %1。请稍候，或重新连接。</translation>
    </message>
    <message>
        <source>Calling %1: no answer yet. Is it switched on, flashed and set to address %2 and this radio channel?</source>
        <translation>正在呼叫 %1：尚无应答。车辆是否已开机、已烧录固件，并已设为地址 %2 和当前无线信道？</translation>
    </message>
    <message>
        <source>%1 has fallen silent. Is it still switched on and in reach of the radio?</source>
        <translation>%1 已失去联系。车辆是否仍处于开机状态，并在无线覆盖范围内？</translation>
    </message>
    <message>
        <source>%1 answers, but with another key (or another version of the protocol). Go back to the key and pair it, or type the key that it has.</source>
        <translation>%1 有应答，但密钥不同（或协议版本不同）。请返回密钥步骤进行配对，或输入该车辆现有的密钥。</translation>
    </message>
</context>
<context>
    <name>tessera::ui::CompassPage</name>
    <message>
        <source>Calibration stopped; the vehicle keeps its old calibration.</source>
        <translation>校准已停止，车辆保留原有校准。</translation>
    </message>
    <message>
        <source>The vehicle turns on the spot…</source>
        <translation>车辆正在原地转动…</translation>
    </message>
    <message>
        <source>The vehicle drives or calibrates already. Stop it, then try again.</source>
        <translation>车辆正在行驶或校准。请先停止车辆，然后重试。</translation>
    </message>
    <message>
        <source>The vehicle refuses, as it has a fault. Clear the fault, then try again.</source>
        <translation>车辆存在故障，拒绝执行。请清除故障，然后重试。</translation>
    </message>
    <message>
        <source>Calibrated. Now the needle must point to north when the nose does.</source>
        <translation>校准完成。此时车头朝北，指针也应指向北。</translation>
    </message>
    <message>
        <source>The calibration failed: the field was not even enough. Move the vehicle away from steel and cables and try again; it needs room for a full turn.</source>
        <translation>校准失败：磁场不够均匀。请将车辆移到远离钢铁和电缆的地方后重试；车辆需要足够空间转动一整圈。</translation>
    </message>
    <message>
        <source>–</source>
        <comment>no value</comment>
        <translation>–</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>The compass</source>
        <translation>罗盘</translation>
    </message>
    <message>
        <source>Turn the vehicle by hand until its nose points to north: the needle must follow.</source>
        <translation>用手转动车辆，使车头朝北：指针应随之转动。</translation>
    </message>
    <message>
        <source>The needle is &amp;right</source>
        <translation>指针正确(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>停止(&amp;S)</translation>
    </message>
    <message>
        <source>If the needle is off by more than about 10°, calibrate: have the vehicle turn and measure, then write what was found into it.</source>
        <translation>如果指针偏差超过约 10°，请进行校准：让车辆转动并测量，然后把结果写入车辆。</translation>
    </message>
    <message>
        <source>Ca&amp;librate without a chart</source>
        <translation>不用图校准(&amp;L)</translation>
    </message>
    <message>
        <source>The values of the compass are being written into the vehicle. Closed now, it would keep half old and half new ones: wait a few seconds, then close.</source>
        <translation>罗盘的值正在写入车辆。现在关闭，车辆里会一半是旧值、一半是新值：请等几秒钟再关闭。</translation>
    </message>
</context>
<context>
    <name>tessera::ui::CompassPanel</name>
    <message>
        <source>The site has no vehicle yet. Set one up: Vehicle › Set up a new vehicle.</source>
        <translation>场地中还没有车辆。请先设置：车辆 › 设置新车辆。</translation>
    </message>
    <message>
        <source>Connect to the vehicles: the compass is calibrated by turning.</source>
        <translation>请连接车辆：罗盘通过转动校准。</translation>
    </message>
    <message>
        <source>Choose the vehicle to calibrate, in the list or on the floor.</source>
        <translation>在列表中或地面上选择要校准的车辆。</translation>
    </message>
    <message>
        <source>The vehicle does not answer. Is it switched on and in reach?</source>
        <translation>车辆没有应答。它是否已开机并在通信范围内？</translation>
    </message>
    <message>
        <source>The vehicle turns on the spot by itself, a little more than once around and back. Put it on the floor, away from steel and cables, with a metre of free room all around; keep hands and feet away.</source>
        <translation>车辆将自行原地转动一圈多再转回。请将车辆放在地面上，远离钢铁和电缆，四周各留出一米空间，手脚不要靠近。</translation>
    </message>
    <message>
        <source>%1 of %2 directions measured.</source>
        <translation>%2 个方向中已测 %1 个。</translation>
    </message>
    <message>
        <source>Hard iron %1 µT, soft iron %2 : 1, earth&apos;s field %3 µT. Points off the ellipse by %4 % (about %5° of heading); %6 of %7 directions met.</source>
        <translation>硬铁 %1 µT，软铁 %2 : 1，地磁场 %3 µT。各点偏离椭圆 %4 %（约合航向 %5°）；%7 个方向中测到 %6 个。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Turn and measure</source>
        <translation>转动并测量</translation>
    </message>
    <message>
        <source>Compass</source>
        <translation>罗盘</translation>
    </message>
    <message>
        <source>Write into the vehicle</source>
        <translation>写入车辆</translation>
    </message>
    <message>
        <source>Old values back</source>
        <translation>恢复旧值</translation>
    </message>
    <message>
        <source>What stood in the vehicle before something was written into it here</source>
        <translation>在此处写入之前车辆中原来的值</translation>
    </message>
</context>
<context>
    <name>tessera::ui::CompassSurvey</name>
    <message>
        <source>Reading what the vehicle corrects its compass by…</source>
        <translation>正在读取车辆的罗盘修正值…</translation>
    </message>
    <message>
        <source>Stopped. Nothing was changed in the vehicle.</source>
        <translation>已停止。车辆中没有任何改变。</translation>
    </message>
    <message>
        <source>The vehicle has no values to correct its compass by.</source>
        <translation>车辆没有罗盘修正值。</translation>
    </message>
    <message>
        <source>The vehicle did not take the values: read them again by turning anew.</source>
        <translation>车辆没有接受这些值：请重新转动以再次读取。</translation>
    </message>
    <message>
        <source>The vehicle drives or turns already. Stop it, then try again.</source>
        <translation>车辆正在行驶或转动。请先停止车辆，然后重试。</translation>
    </message>
    <message>
        <source>The vehicle refuses: it has a fault, or its compass does not answer. Clear it, then try again.</source>
        <translation>车辆拒绝：它有故障，或罗盘没有应答。请清除故障，然后重试。</translation>
    </message>
    <message>
        <source>The vehicle turns on the spot…</source>
        <translation>车辆正在原地转动…</translation>
    </message>
    <message>
        <source>The vehicle has fallen silent. It stops turning by itself.</source>
        <translation>车辆没有回音了。它会自行停止转动。</translation>
    </message>
    <message>
        <source>Fetching the rest of what was measured…</source>
        <translation>正在取回其余的测量值…</translation>
    </message>
    <message>
        <source>Too little was measured: the vehicle hardly turned, or its compass is silent.</source>
        <translation>测到的太少：车辆几乎没有转动，或罗盘没有应答。</translation>
    </message>
    <message>
        <source>The vehicle keeps its values.</source>
        <translation>车辆保留原有的值。</translation>
    </message>
    <message>
        <source>The values in the vehicle are right: they turn the heading by at most %1°.</source>
        <translation>车辆中的值是对的：它们使航向至多偏转 %1°。</translation>
    </message>
    <message>
        <source>The values in the vehicle turn the heading by up to %1°. Write those found into it.</source>
        <translation>车辆中的值使航向偏转达 %1°。请把得到的值写入车辆。</translation>
    </message>
    <message>
        <source>Writing into the vehicle…</source>
        <translation>正在写入车辆…</translation>
    </message>
    <message>
        <source>The vehicle has other values than were written. Write them again.</source>
        <translation>车辆中的值与写入的不同。请再写一次。</translation>
    </message>
    <message>
        <source>The values are in force, but the vehicle could not keep them: they are lost when it is switched off.</source>
        <translation>这些值已生效，但车辆无法保存：断电后会丢失。</translation>
    </message>
    <message>
        <source>The vehicle has its old values back.</source>
        <translation>车辆已恢复旧值。</translation>
    </message>
    <message>
        <source>Written and read back. Turn once more to see what they do.</source>
        <translation>已写入并读回。再转一次即可看到效果。</translation>
    </message>
    <message>
        <source>The vehicle&apos;s program is too old to tell what its compass measures. It can only calibrate by itself, without a chart: the wizard&apos;s page of the compass has a button for it (Vehicle › Change the chosen vehicle).</source>
        <translation>车辆的程序太旧，不能说出罗盘测到了什么。它只能自行校准，没有图：向导的罗盘页上有相应的按钮（车辆 › 更改所选车辆）。</translation>
    </message>
</context>
<context>
    <name>tessera::ui::Condition</name>
    <message>
        <source>%1 has not answered yet. Check that it is switched on and within reach of the radio.</source>
        <translation>%1 尚未应答。请检查车辆是否已开机并在无线覆盖范围内。</translation>
    </message>
    <message>
        <source>%1 no longer answers. It stops by itself; check its power and the radio.</source>
        <translation>%1 不再应答。车辆会自行停车；请检查其电源和无线链路。</translation>
    </message>
    <message>
        <source>%1 answers, but with another key or protocol version. Set it up again for this site.</source>
        <translation>%1 有应答，但密钥或协议版本不同。请为本场地重新设置该车辆。</translation>
    </message>
    <message>
        <source>%1 stands before an obstacle.</source>
        <translation>%1 前方有障碍物，已停车。</translation>
    </message>
    <message>
        <source>%1 calibrates its compass.</source>
        <translation>%1 正在校准罗盘。</translation>
    </message>
    <message>
        <source>%1 is driven by hand.</source>
        <translation>%1 正在手动驾驶。</translation>
    </message>
    <message>
        <source>%1 pauses. Resume lets it go on from here.</source>
        <translation>%1 已暂停。选择“继续”可从此处继续行驶。</translation>
    </message>
    <message>
        <source>%1 has reached the end of its route.</source>
        <translation>%1 已到达路径终点。</translation>
    </message>
    <message>
        <source>%1 was stopped. Run lets it drive again.</source>
        <translation>%1 已停止。选择“运行”可重新行驶。</translation>
    </message>
    <message>
        <source>%1 is ready. Choose a route and run it.</source>
        <translation>%1 已就绪。请选择路径并运行。</translation>
    </message>
    <message>
        <source>The place of %1 is not known. Put it where it reads tags.</source>
        <translation>%1 的位置未知。请将其放到能读到标签的地方。</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>被拒绝</translation>
    </message>
    <message>
        <source>Silent</source>
        <translation>无应答</translation>
    </message>
    <message>
        <source>Obstacle</source>
        <translation>障碍物</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>未连接</translation>
    </message>
    <message>
        <source>Calling</source>
        <translation>呼叫中</translation>
    </message>
    <message>
        <source>Calibrating</source>
        <translation>校准中</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>已暂停</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>运行中</translation>
    </message>
    <message>
        <source>By hand</source>
        <comment>driven by keys</comment>
        <translation>手动</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>Arrived</source>
        <translation>已到达</translation>
    </message>
    <message>
        <source>There is no connection to the vehicles. Connect first.</source>
        <translation>尚未连接车辆。请先连接。</translation>
    </message>
    <message>
        <source>%1 is held by a fault (%2). Remove the cause, then clear the fault.</source>
        <translation>%1 因故障停车（%2）。请排除原因，然后清除故障。</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between faults</comment>
        <translation>、</translation>
    </message>
    <message>
        <source>%1 drives along the route %2.</source>
        <translation>%1 正沿路径 %2 行驶。</translation>
    </message>
</context>
<context>
    <name>tessera::ui::ConnectDialog</name>
    <message>
        <source>Connect to the vehicles</source>
        <translation>连接车辆</translation>
    </message>
    <message>
        <source>The vehicles are reached by radio, through a module at one of this computer&apos;s ports.</source>
        <translation>上位机通过接在本机端口上的无线模块与车辆通信。</translation>
    </message>
    <message>
        <source>&amp;Demo world</source>
        <translation>演示环境(&amp;D)</translation>
    </message>
    <message>
        <source>The site&apos;s vehicles, floor and radio are simulated on this computer. No hardware is needed.</source>
        <translation>在本机上模拟场地的车辆、地面和无线通信，无需任何硬件。</translation>
    </message>
    <message>
        <source>&amp;Serial port</source>
        <translation>串口(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Network (TCP)</source>
        <translation>网络（TCP）(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Connect</source>
        <translation>连接(&amp;C)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>tessera::ui::ContactPage</name>
    <message>
        <source>–</source>
        <comment>no value</comment>
        <translation>–</translation>
    </message>
    <message>
        <source>%1 of %2 answer</source>
        <translation>%2 个中有 %1 个应答</translation>
    </message>
    <message>
        <source>%1 V</source>
        <translation>%1 V</translation>
    </message>
    <message>
        <source>%1 s ago</source>
        <translation>%1 s 前</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between faults</comment>
        <translation>、</translation>
    </message>
    <message>
        <source>%1 is in contact, but many answers are lost. Check the antennas, the distance, and whether another transmitter uses this channel.</source>
        <translation>%1 已建立通信，但丢失的应答较多。请检查天线和距离，并确认是否有其他发射设备占用此信道。</translation>
    </message>
    <message>
        <source>%1 is in contact and bears the site&apos;s key.</source>
        <translation>%1 已建立通信，并持有本场地的密钥。</translation>
    </message>
    <message>
        <source>Contact over the air</source>
        <translation>无线通信</translation>
    </message>
    <message>
        <source>Switch the vehicle on. It is called every few seconds until it answers.</source>
        <translation>请打开车辆电源。上位机每隔几秒呼叫一次，直到车辆应答。</translation>
    </message>
    <message>
        <source>Firmware:</source>
        <translation>固件：</translation>
    </message>
    <message>
        <source>Readers:</source>
        <translation>读卡器：</translation>
    </message>
    <message>
        <source>Battery:</source>
        <translation>电池：</translation>
    </message>
    <message>
        <source>Last heard:</source>
        <translation>最近通信：</translation>
    </message>
    <message>
        <source>Round trip:</source>
        <translation>往返时间：</translation>
    </message>
    <message>
        <source>Lost answers:</source>
        <translation>丢失的应答：</translation>
    </message>
    <message>
        <source>Faults:</source>
        <translation>故障：</translation>
    </message>
</context>
<context>
    <name>tessera::ui::CornerModel</name>
    <message>
        <source>Length of the edge to the next corner</source>
        <translation>到下一个角点的边长</translation>
    </message>
    <message>
        <source>Place in the site, in centimetres</source>
        <translation>在场地中的位置，单位厘米</translation>
    </message>
    <message>
        <source>x (cm)</source>
        <translation>x (cm)</translation>
    </message>
    <message>
        <source>y (cm)</source>
        <translation>y (cm)</translation>
    </message>
    <message>
        <source>Edge (cm)</source>
        <translation>边长 (cm)</translation>
    </message>
</context>
<context>
    <name>tessera::ui::DayBar</name>
    <message>
        <source>&amp;Day:</source>
        <translation>日期(&amp;D)：</translation>
    </message>
    <message>
        <source>The day before</source>
        <translation>前一天</translation>
    </message>
    <message>
        <source>The day after</source>
        <translation>后一天</translation>
    </message>
    <message>
        <source>Day of the journal</source>
        <translation>日志的日期</translation>
    </message>
    <message>
        <source>&amp;Back to now</source>
        <translation>返回现在(&amp;B)</translation>
    </message>
</context>
<context>
    <name>tessera::ui::DrivePage</name>
    <message>
        <source>The order was not taken: no supervision runs. Connect anew.</source>
        <translation>指令未被接受：上位机监控未运行。请重新连接。</translation>
    </message>
    <message>
        <source>The site has no route yet. Draw one on the floor, and make the first drive from the main window.</source>
        <translation>场地中还没有路径。请在地面上绘制一条路径，然后在主窗口中进行首次行驶。</translation>
    </message>
    <message>
        <source>Its place is not known yet. Drive it by hand over a few tags of the floor (one step back).</source>
        <translation>车辆位置尚不明确。请返回上一步，手动驾驶车辆经过地面上的几个标签。</translation>
    </message>
    <message>
        <source>The route&apos;s end was reached. The vehicle is ready.</source>
        <translation>已到达路径终点。车辆准备就绪。</translation>
    </message>
    <message>
        <source>Stopped before the route&apos;s end. Run it again, or skip this step.</source>
        <translation>车辆在到达路径终点前停止。请再次运行，或跳过此步骤。</translation>
    </message>
    <message>
        <source>First drive</source>
        <translation>首次行驶</translation>
    </message>
    <message>
        <source>A short route, slowly. Stay near the vehicle, with a hand on its emergency stop.</source>
        <translation>低速行驶一条短路径。请留在车辆旁边，并将手放在急停按钮上。</translation>
    </message>
    <message>
        <source>R&amp;oute:</source>
        <translation>路径(&amp;O)：</translation>
    </message>
    <message>
        <source>no routes</source>
        <translation>无路径</translation>
    </message>
    <message>
        <source>Sp&amp;eed:</source>
        <translation>速度(&amp;E)：</translation>
    </message>
    <message>
        <source> m/s</source>
        <translation> m/s</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>运行(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>停止(&amp;S)</translation>
    </message>
    <message>
        <source>Progress along the route</source>
        <translation>路径进度</translation>
    </message>
</context>
<context>
    <name>tessera::ui::EventModel</name>
    <message>
        <source>Vehicle %1</source>
        <translation>车辆 %1</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>date, time of day</comment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Vehicle</source>
        <translation>车辆</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>事件</translation>
    </message>
</context>
<context>
    <name>tessera::ui::EventPanel</name>
    <message>
        <source>Everything</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Warnings and errors</source>
        <translation>警告和错误</translation>
    </message>
    <message>
        <source>Errors only</source>
        <translation>仅错误</translation>
    </message>
    <message>
        <source>How serious an event must be to be listed.</source>
        <translation>列出达到所选严重程度的事件。</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>严重程度</translation>
    </message>
    <message>
        <source>Whose events are listed.</source>
        <translation>列出所选车辆的事件。</translation>
    </message>
    <message>
        <source>Vehicle</source>
        <translation>车辆</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>Go to the newest event and stay there.</source>
        <translation>转到最新事件并保持跟随。</translation>
    </message>
    <message>
        <source>Go to the end</source>
        <translation>转到末尾</translation>
    </message>
    <message>
        <source>Copy the selected events, or all that are listed (%1)</source>
        <translation>复制所选事件，未选择时复制列出的全部事件（%1）</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Empty this list. The journal keeps what happened.</source>
        <translation>清空此列表。事件记录仍会保留。</translation>
    </message>
    <message>
        <source>Empty the list</source>
        <translation>清空列表</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>All vehicles</source>
        <translation>所有车辆</translation>
    </message>
    <message>
        <source>No event matches what is asked for above.</source>
        <translation>没有符合上述条件的事件。</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>全部显示(&amp;A)</translation>
    </message>
    <message>
        <source>Nothing has happened yet. What vehicles do and what goes wrong is told here.</source>
        <translation>尚无事件。车辆的动作和异常情况将显示在这里。</translation>
    </message>
    <message>
        <source>Save all that are listed as a table (CSV)</source>
        <translation>将列出的全部事件保存为表格 (CSV)</translation>
    </message>
    <message>
        <source>Save as a table</source>
        <translation>保存为表格</translation>
    </message>
    <message>
        <source>Show a day of the journal</source>
        <translation>显示某一天的日志</translation>
    </message>
    <message>
        <source>Reading the journal…</source>
        <translation>正在读取日志…</translation>
    </message>
    <message>
        <source>Nothing was written into the journal on this day. Choose another one, or go back to now.</source>
        <translation>这一天的日志中没有记录。请选择其他日期，或返回现在。</translation>
    </message>
    <message numerus="yes">
        <source>The last %n events of this day are listed. Choose a severity or a vehicle to see the earlier ones.</source>
        <translation>
            <numerusform>列出了这一天最后 %n 个事件。请选择严重程度或车辆以查看更早的事件。</numerusform>
        </translation>
    </message>
    <message>
        <source>Go back to &amp;now</source>
        <translation>返回现在(&amp;N)</translation>
    </message>
</context>
<context>
    <name>tessera::ui::FaultModel</name>
    <message>
        <source>%1
Can be mended: %2.</source>
        <translation>%1
可以修正：%2。</translation>
    </message>
    <message>
        <source>Error: %1</source>
        <translation>错误：%1</translation>
    </message>
    <message>
        <source>Warning: %1</source>
        <translation>警告：%1</translation>
    </message>
</context>
<context>
    <name>tessera::ui::FaultPanel</name>
    <message>
        <source>Checking…</source>
        <translation>正在检查…</translation>
    </message>
    <message>
        <source>The site is being checked…</source>
        <translation>正在检查场地…</translation>
    </message>
    <message>
        <source>No faults found.</source>
        <translation>没有发现问题。</translation>
    </message>
    <message>
        <source>Faults of the other kind are hidden.</source>
        <translation>另一类问题已隐藏。</translation>
    </message>
    <message>
        <source>For some faults there is an edit that mends them.</source>
        <translation>有些问题可以通过一次编辑来修正。</translation>
    </message>
    <message>
        <source>The site has changed meanwhile: nothing was mended.</source>
        <translation>场地在此期间已改变：没有修正任何内容。</translation>
    </message>
    <message>
        <source>Faults</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>Faults (%1)</source>
        <translation>问题（%1）</translation>
    </message>
    <message>
        <source>No faults</source>
        <translation>没有问题</translation>
    </message>
    <message numerus="yes">
        <source>%n error(s)</source>
        <translation>
            <numerusform>%n 个错误</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warning(s)</source>
        <translation>
            <numerusform>%n 个警告</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>errors, warnings</comment>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>Errors (%1)</source>
        <translation>错误（%1）</translation>
    </message>
    <message>
        <source>Warnings (%1)</source>
        <translation>警告（%1）</translation>
    </message>
    <message>
        <source>List what keeps the site from being used, or leads vehicles wrongly</source>
        <translation>列出使场地无法使用或会引错车辆的问题</translation>
    </message>
    <message>
        <source>List what somebody should look at</source>
        <translation>列出应有人查看的问题</translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation>显示(&amp;S)</translation>
    </message>
    <message>
        <source>Show the place on the floor (Enter)</source>
        <translation>在地面上显示该处（Enter）</translation>
    </message>
    <message>
        <source>&amp;Mend</source>
        <translation>修正(&amp;M)</translation>
    </message>
    <message>
        <source>Faults of the site</source>
        <translation>场地的问题</translation>
    </message>
    <message>
        <source>No single edit mends this fault.</source>
        <translation>没有一步编辑能够修正此问题。</translation>
    </message>
    <message>
        <source>No single edit mends this fault</source>
        <translation>没有一步编辑能够修正此问题</translation>
    </message>
    <message>
        <source>&amp;Go there</source>
        <translation>转到该处(&amp;G)</translation>
    </message>
    <message>
        <source>Show in &amp;list</source>
        <translation>在列表中显示(&amp;L)</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>On a route a vehicle’s outline, with that much room all around, must not stick out of the zones in which it may be.</source>
        <translation>在路径上，车辆轮廓连同四周这么多的空间，不得超出允许它所在的区域。</translation>
    </message>
    <message>
        <source>Room aro&amp;und vehicles:</source>
        <translation>车辆四周的空间(&amp;U)：</translation>
    </message>
</context>
<context>
    <name>tessera::ui::FieldChart</name>
    <message>
        <source>as measured</source>
        <translation>测量值</translation>
    </message>
    <message>
        <source>corrected</source>
        <translation>修正后</translation>
    </message>
    <message>
        <source>Here the field in every direction is drawn while the vehicle turns.</source>
        <translation>车辆转动时，这里画出各个方向的磁场。</translation>
    </message>
    <message>
        <source>The magnetic field in every direction, measured and corrected</source>
        <translation>各个方向的磁场：测量值和修正后的值</translation>
    </message>
</context>
<context>
    <name>tessera::ui::FindBox</name>
    <message>
        <source>Coordinates</source>
        <translation>坐标</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>Tile</source>
        <translation>地板砖</translation>
    </message>
    <message>
        <source>Zone</source>
        <translation>区域</translation>
    </message>
    <message>
        <source>Route</source>
        <translation>路径</translation>
    </message>
    <message>
        <source>Vehicle&apos;s start</source>
        <translation>车辆起点</translation>
    </message>
    <message>
        <source>Tile, UID, zone, route, or x y in m</source>
        <translation>地板砖、UID、区域、路径，或以米为单位的 x y</translation>
    </message>
    <message>
        <source>Go to</source>
        <translation>前往</translation>
    </message>
    <message>
        <source>Places found</source>
        <translation>找到的位置</translation>
    </message>
    <message>
        <source>Nothing is called so.</source>
        <translation>没有这样的名称。</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <comment>kind and name</comment>
        <translation>%1，%2 {1 ?}</translation>
    </message>
</context>
<context>
    <name>tessera::ui::FlashPage</name>
    <message>
        <source>Firmware onto the vehicle&apos;s board</source>
        <translation>将固件烧录到车辆的电路板</translation>
    </message>
    <message>
        <source>For a board with the microcontroller LM3S6965. Skip this if the vehicle has its firmware.</source>
        <translation>适用于采用 LM3S6965 微控制器的电路板。如果车辆已有固件，请跳过此步骤。</translation>
    </message>
    <message>
        <source>Connect the board&apos;s debug port to this computer by USB, lift the vehicle&apos;s wheels off the floor, and run in the folder of the firmware (tessera-vehicle.elf):</source>
        <translation>用 USB 将电路板的调试接口连接到本机，将车辆抬起使车轮离地，然后在固件（tessera-vehicle.elf）所在的文件夹中运行：</translation>
    </message>
    <message>
        <source>With Open&amp;OCD (boards like the EK-LM3S6965; Debian package openocd):</source>
        <translation>使用 OpenOCD（适用于 EK-LM3S6965 等电路板；Debian 软件包 openocd）(&amp;O)：</translation>
    </message>
    <message>
        <source>With lm&amp;4flash (boards whose debugger is a Stellaris ICDI), first make a plain image:</source>
        <translation>使用 lm4flash（适用于调试器为 Stellaris ICDI 的电路板），先生成二进制镜像(&amp;4)：</translation>
    </message>
    <message>
        <source>and write &amp;it:</source>
        <translation>然后写入镜像(&amp;I)：</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Copy the command</source>
        <translation>复制命令</translation>
    </message>
    <message>
        <source>The firmware is on the board</source>
        <translation>固件已烧录到电路板</translation>
    </message>
    <message>
        <source>No vehicle at hand? Connect to the demo world: it simulates every vehicle of the site with the same firmware, this one too, and needs no flashing.</source>
        <translation>手边没有车辆？请连接演示环境：它使用相同的固件模拟场地中的所有车辆，包括这一辆，无需烧录。</translation>
    </message>
    <message>
        <source>Connect the board&apos;s debug port to this computer by USB, lift the vehicle&apos;s wheels off the floor, and write the firmware that came with this program by one of these commands:</source>
        <translation>用 USB 将电路板的调试接口连接到本机，将车辆抬起使车轮离地，然后用以下任一命令写入随本程序提供的固件：</translation>
    </message>
    <message>
        <source>With lm&amp;4flash (boards whose debugger is a Stellaris ICDI):</source>
        <translation>使用 lm4flash(&amp;4)（适用于调试器为 Stellaris ICDI 的电路板）：</translation>
    </message>
</context>
<context>
    <name>tessera::ui::FloorCanvas</name>
    <message>
        <source>%1
x %2 m, y %3 m, %4 m/s</source>
        <translation>%1
x %2 m，y %3 m，%4 m/s</translation>
    </message>
    <message>
        <source>Tag %1
x %2 m, y %3 m</source>
        <translation>标签 %1
x %2 m，y %3 m</translation>
    </message>
    <message>
        <source>Floor map</source>
        <translation>地面地图</translation>
    </message>
    <message>
        <source>Tiles, tags, zones, routes and vehicles of the site.</source>
        <translation>场地的地板砖、标签、区域、路径和车辆。</translation>
    </message>
    <message>
        <source>This site has no tiles yet.</source>
        <translation>此场地尚无地板砖。</translation>
    </message>
    <message>
        <source>Choose Lay tiles in the tool bar (Ctrl+Shift+T) and drag over the floor. Tags that are known already come in with Site › Import…; Edit › Floor plan… puts a drawing of the building beneath.</source>
        <translation>在工具栏中选择“铺设地板砖”(Ctrl+Shift+T)，然后在地面上拖动。已知的标签可用“场地 › 导入…”读入；“编辑 › 平面图…”可在下方放置建筑图纸。</translation>
    </message>
</context>
<context>
    <name>tessera::ui::HeadingDial</name>
    <message>
        <source>Compass dial</source>
        <translation>罗盘表盘</translation>
    </message>
    <message>
        <source>N</source>
        <translation>北</translation>
    </message>
    <message>
        <source>E</source>
        <translation>东</translation>
    </message>
    <message>
        <source>S</source>
        <translation>南</translation>
    </message>
    <message>
        <source>W</source>
        <translation>西</translation>
    </message>
</context>
<context>
    <name>tessera::ui::HelpPages</name>
    <message>
        <source>en</source>
        <comment>folder of the help pages in this language: en or zh_CN</comment>
        <translation>zh_CN</translation>
    </message>
</context>
<context>
    <name>tessera::ui::HelpWindow</name>
    <message>
        <source>Tessera help</source>
        <translation>Tessera 帮助</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>页面导航</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>action, key</comment>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>后退</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>前进</translation>
    </message>
    <message>
        <source>First page</source>
        <translation>首页</translation>
    </message>
    <message>
        <source>Search the help</source>
        <translation>搜索帮助</translation>
    </message>
    <message>
        <source>No page holds these words.</source>
        <translation>没有包含这些词语的页面。</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>目录</translation>
    </message>
    <message>
        <source>Help page</source>
        <translation>帮助页面</translation>
    </message>
</context>
<context>
    <name>tessera::ui::InnovationChart</name>
    <message>
        <source>Innovations of the reads</source>
        <translation>读数的新息</translation>
    </message>
    <message>
        <source>Each point is a read: how far its tag lay from where it was expected, measured by what was doubted (NIS). The line is the mean of the last %1; it lies in the green band when the doubt is honest.</source>
        <translation>每个点是一次读数：标签与预期位置的差别，以不确定度衡量（NIS）。线是最近 %1 次的平均；不确定度如实时落在绿色带内。</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>读数</translation>
    </message>
    <message>
        <source>Mean of %1</source>
        <translation>%1 次平均</translation>
    </message>
    <message>
        <source>Time (s), 0 is the newest</source>
        <translation>时间（秒），0 为最新</translation>
    </message>
    <message>
        <source>NIS</source>
        <comment>normalised innovation squared</comment>
        <translation>NIS</translation>
    </message>
</context>
<context>
    <name>tessera::ui::JogDialog</name>
    <message>
        <source>No vehicle</source>
        <translation>无车辆</translation>
    </message>
    <message>
        <source>Drive by hand</source>
        <translation>手动驾驶</translation>
    </message>
</context>
<context>
    <name>tessera::ui::JogPad</name>
    <message>
        <source>Not connected. Connect to the vehicles first.</source>
        <translation>未连接。请先连接车辆。</translation>
    </message>
    <message>
        <source>Choose a vehicle first.</source>
        <translation>请先选择车辆。</translation>
    </message>
    <message>
        <source>%1 is not in contact.</source>
        <translation>%1 未建立通信。</translation>
    </message>
    <message>
        <source>%1 has a route. Stop it first, then drive by hand.</source>
        <translation>%1 正在执行路径。请先停止，再手动驾驶。</translation>
    </message>
    <message>
        <source>The order was not taken. Let go and try again.</source>
        <translation>指令未被接受。请松开后重试。</translation>
    </message>
    <message>
        <source>Driving. Let go to stop.</source>
        <translation>正在行驶。松开即停止。</translation>
    </message>
    <message>
        <source>Hold an arrow key or an arrow button to move. Let go to stop.</source>
        <translation>按住方向键或箭头按钮移动车辆，松开即停止。</translation>
    </message>
    <message>
        <source>Hold an arrow button to move, or click here and hold an arrow key. Let go to stop.</source>
        <translation>按住箭头按钮移动车辆，或点击此处后按住方向键。松开即停止。</translation>
    </message>
    <message>
        <source>Drive by hand</source>
        <translation>手动驾驶</translation>
    </message>
    <message>
        <source>Forwards (↑)</source>
        <translation>前进（↑）</translation>
    </message>
    <message>
        <source>Backwards (↓)</source>
        <translation>后退（↓）</translation>
    </message>
    <message>
        <source>Turn left (←)</source>
        <translation>左转（←）</translation>
    </message>
    <message>
        <source>Turn right (→)</source>
        <translation>右转（→）</translation>
    </message>
    <message>
        <source>%1: moves while it is held</source>
        <translation>%1：按住时移动</translation>
    </message>
    <message>
        <source>&amp;Speed: %1 m/s</source>
        <translation>速度(&amp;S)：%1 m/s</translation>
    </message>
    <message>
        <source>Speed by hand</source>
        <translation>手动驾驶速度</translation>
    </message>
</context>
<context>
    <name>tessera::ui::JogPage</name>
    <message>
        <source>Measured by its wheels: %1 m/s</source>
        <translation>车轮实测速度：%1 m/s</translation>
    </message>
    <message>
        <source>Drive by hand</source>
        <translation>手动驾驶</translation>
    </message>
    <message>
        <source>Put the vehicle on the floor with free room around it, and move it a little each way.</source>
        <translation>将车辆放在地面上，四周留出空间，然后向各个方向稍微移动。</translation>
    </message>
    <message>
        <source>If it goes backwards when it should go forwards, a motor is connected the wrong way round; if it turns the wrong way, the motors are swapped.</source>
        <translation>如果应前进时车辆后退，说明有电机接反；如果转动方向相反，说明左右电机接错。</translation>
    </message>
</context>
<context>
    <name>tessera::ui::JumperPicture</name>
    <message>
        <source>Both off: settings</source>
        <translation>均取下：设置</translation>
    </message>
    <message>
        <source>Both on: service</source>
        <translation>均插上：工作</translation>
    </message>
    <message>
        <source>Picture: the jumpers M0 and M1 are taken off</source>
        <translation>图示：跳线 M0 和 M1 已取下</translation>
    </message>
    <message>
        <source>Picture: the jumpers M0 and M1 are in place</source>
        <translation>图示：跳线 M0 和 M1 已插上</translation>
    </message>
</context>
<context>
    <name>tessera::ui::KeyPage</name>
    <message numerus="yes">
        <source>A key has 32 hexadecimal digits (0–9, A–F); here are %n.</source>
        <translation>
            <numerusform>密钥应为 32 位十六进制数字（0–9、A–F），当前为 %n 位。</numerusform>
        </translation>
    </message>
    <message>
        <source>The site now uses this key. Waiting for the vehicle…</source>
        <translation>场地已启用此密钥。正在等待车辆…</translation>
    </message>
    <message>
        <source>Vehicle and site share this key.</source>
        <translation>车辆与场地的密钥一致。</translation>
    </message>
    <message>
        <source>The vehicle&apos;s key</source>
        <translation>车辆密钥</translation>
    </message>
    <message>
        <source>Vehicle and site share a secret key; a vehicle obeys nobody without it.</source>
        <translation>车辆与场地共用一个密钥；没有该密钥，车辆不接受任何指令。</translation>
    </message>
    <message>
        <source>The key stands in the site&apos;s file: keep that as you would a password.</source>
        <translation>密钥保存在场地文件中，请像保管密码一样保管该文件。</translation>
    </message>
    <message>
        <source>&amp;Pair: give the vehicle a new random key over the air</source>
        <translation>配对：通过无线为车辆设置新的随机密钥(&amp;P)</translation>
    </message>
    <message>
        <source>Pair &amp;now</source>
        <translation>立即配对(&amp;N)</translation>
    </message>
    <message>
        <source>The vehicle has a &amp;key that I know</source>
        <translation>车辆已有密钥，且我知道该密钥(&amp;K)</translation>
    </message>
    <message>
        <source>32 hexadecimal digits</source>
        <translation>32 位十六进制数字</translation>
    </message>
    <message>
        <source>&amp;Use this key</source>
        <translation>使用此密钥(&amp;U)</translation>
    </message>
    <message>
        <source>Key of this vehicle in the site:</source>
        <translation>场地中此车辆的密钥：</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>显示(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>The vehicle has its key; nobody else knows it. Waiting for contact…</source>
        <translation>车辆已取得密钥，其他人均不知道该密钥。正在等待通信…</translation>
    </message>
    <message>
        <source>Pairing was given up.</source>
        <translation>已放弃配对。</translation>
    </message>
    <message>
        <source>Give up pairi&amp;ng</source>
        <translation>放弃配对(&amp;N)</translation>
    </message>
    <message>
        <source>The vehicle still has the factory&apos;s key, which everybody knows. Pair it now.</source>
        <translation>车辆仍在使用众所周知的出厂密钥。请立即配对。</translation>
    </message>
    <message>
        <source>A vehicle fresh from the factory (address 254, a key that everybody knows) also takes its address. Switch on only this one. Who listens to the radio during pairing could learn the key: pair where you are alone.</source>
        <translation>刚出厂的车辆（地址 254，密钥众所周知）还会同时取得其地址。请只打开这一辆车的电源。配对期间监听无线通信的人可能获知密钥，请在无他人监听的环境中配对。</translation>
    </message>
    <message>
        <source>The site&apos;s file does not have this key yet. Without it the vehicle obeys nobody: save the site now.</source>
        <translation>场地文件中还没有此密钥。没有该密钥，车辆不接受任何指令：请立即保存场地。</translation>
    </message>
    <message>
        <source>Sa&amp;ve the site</source>
        <translation>保存场地(&amp;V)</translation>
    </message>
</context>
<context>
    <name>tessera::ui::LayTool</name>
    <message numerus="yes">
        <source>Lay %n tile(s)</source>
        <translation>
            <numerusform>铺设 %n 块地板砖</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n tile(s)</source>
        <translation>
            <numerusform>再铺 %n 块地板砖</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no room beside the chosen tiles: copy them and paste them where there is.</source>
        <translation>所选地板砖旁边没有空位：请复制后粘贴到有空位的地方。</translation>
    </message>
    <message>
        <source>There are tiles already: none may lie upon another.</source>
        <translation>那里已有地板砖：地板砖不能重叠。</translation>
    </message>
    <message numerus="yes">
        <source>Paste %n tile(s)</source>
        <translation>
            <numerusform>粘贴 %n 块地板砖</numerusform>
        </translation>
    </message>
    <message>
        <source>Tiles snap to their neighbours. Alt: no snapping. Esc: leave them where they were.</source>
        <translation>地板砖对齐到相邻的砖。Alt：不吸附。Esc：放回原处。</translation>
    </message>
    <message>
        <source>Let go to finish. Esc: as it was.</source>
        <translation>松开即完成。Esc：恢复原样。</translation>
    </message>
    <message>
        <source>Click where the copies are to lie. R: turn them. Alt: no snapping. Esc: leave it.</source>
        <translation>点击副本要放的位置。R：旋转。Alt：不吸附。Esc：放弃。</translation>
    </message>
    <message>
        <source>This site has no tile type yet: make one in the panel Tiles.</source>
        <translation>此场地还没有地板规格：请在“地板砖”面板中创建。</translation>
    </message>
    <message>
        <source>Drag over the floor to lay tiles, with Shift to fill a rectangle. R: turn. C: choose tiles. Esc: stop.</source>
        <translation>在地面上拖动以铺设地板砖，按住 Shift 填满矩形。R：旋转。C：选择地板砖。Esc：停止。</translation>
    </message>
    <message>
        <source>Click a tile or drag around several to choose them. L: lay tiles.</source>
        <translation>单击一块地板砖，或拖出矩形选中多块。L：铺设地板砖。</translation>
    </message>
    <message>
        <source>Drag or arrow keys: move. R: turn. Del: delete. Ctrl+C, Ctrl+V: copy, paste. Ctrl+click: choose more.</source>
        <translation>拖动或方向键：移动。R：旋转。Del：删除。Ctrl+C、Ctrl+V：复制、粘贴。Ctrl+单击：增选。</translation>
    </message>
    <message>
        <source>&amp;Turn</source>
        <translation>旋转(&amp;T)</translation>
    </message>
    <message>
        <source>Turn &amp;each</source>
        <translation>各自旋转(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Align</source>
        <translation>对齐(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Left edges</source>
        <translation>左边缘(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Right edges</source>
        <translation>右边缘(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Upper edges</source>
        <translation>上边缘(&amp;U)</translation>
    </message>
    <message>
        <source>L&amp;ower edges</source>
        <translation>下边缘(&amp;O)</translation>
    </message>
    <message>
        <source>To the &amp;neighbours</source>
        <translation>与相邻的砖(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>粘贴(&amp;P)</translation>
    </message>
    <message>
        <source>D&amp;uplicate</source>
        <translation>再铺一份(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>删除(&amp;D)</translation>
    </message>
    <message>
        <source>Choose a&amp;ll</source>
        <translation>全选(&amp;L)</translation>
    </message>
    <message>
        <source>This site has no tile type yet: make one first.</source>
        <translation>此场地还没有地板规格：请先创建一种。</translation>
    </message>
    <message>
        <source>So many tiles are too many at once: fill a smaller rectangle.</source>
        <translation>一次铺设的地板砖太多：请填较小的矩形。</translation>
    </message>
    <message>
        <source>x %1 cm, y %2 cm</source>
        <translation>x %1 cm，y %2 cm</translation>
    </message>
    <message numerus="yes">
        <source>%n tile(s)</source>
        <translation>
            <numerusform>%n 块地板砖</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 × %2 tiles</source>
        <translation>%1 × %2 块地板砖</translation>
    </message>
</context>
<context>
    <name>tessera::ui::LiveCharts</name>
    <message>
        <source>Choose a vehicle in the list or on the floor to see how it drives.</source>
        <translation>请在列表中或地面上选择车辆，以查看其行驶情况。</translation>
    </message>
    <message>
        <source>Nothing is known of %1 yet. Its charts begin with its first report.</source>
        <translation>尚无 %1 的数据。收到首次上报后开始绘制曲线。</translation>
    </message>
    <message>
        <source>How far back the charts reach.</source>
        <translation>曲线显示的时间长度。</translation>
    </message>
    <message>
        <source>Time shown</source>
        <translation>显示时长</translation>
    </message>
    <message>
        <source>Let the charts go on.</source>
        <translation>继续更新曲线。</translation>
    </message>
    <message>
        <source>Hold the charts still, to drag and zoom them. Recording goes on.</source>
        <translation>暂停曲线更新，以便拖动和缩放。数据记录继续进行。</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Forget what was recorded of this vehicle and begin anew.</source>
        <translation>清除此车辆已记录的数据，重新开始记录。</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清除</translation>
    </message>
    <message>
        <source>Save the charts as a picture (PNG, PDF) or their values (CSV).</source>
        <translation>将曲线保存为图片（PNG、PDF），或将数值保存为 CSV 文件。</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>The picture %1 could not be written. Choose another folder.</source>
        <translation>无法写入图片 %1。请选择其他文件夹。</translation>
    </message>
    <message>
        <source>%1: track, cross-track error and speed</source>
        <translation>%1：轨迹、横向偏差和速度</translation>
    </message>
    <message>
        <source>The file %1 could not be written. Choose another folder.</source>
        <translation>无法写入文件 %1。请选择其他文件夹。</translation>
    </message>
    <message>
        <source>Save the charts</source>
        <translation>保存曲线</translation>
    </message>
    <message>
        <source>Picture (*.png)</source>
        <translation>图片 (*.png)</translation>
    </message>
    <message>
        <source>Document (*.pdf)</source>
        <translation>文档 (*.pdf)</translation>
    </message>
    <message>
        <source>Values (*.csv)</source>
        <translation>数值 (*.csv)</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 分钟</translation>
    </message>
    <message>
        <source>Nothing is known of %1 yet. Connect to the vehicles (Ctrl+K); its charts begin with its first report.</source>
        <translation>尚无 %1 的数据。请连接车辆 (Ctrl+K)；收到首次报告后开始绘制曲线。</translation>
    </message>
    <message>
        <source>The site has no vehicle yet. Set one up: Vehicle › Set up a new vehicle.</source>
        <translation>场地还没有车辆。请设置一台：车辆 › 设置新车辆。</translation>
    </message>
</context>
<context>
    <name>tessera::ui::LocatingOverlay</name>
    <message>
        <source>reader %1, %2 s ago</source>
        <translation>读卡器 %1，%2 秒前</translation>
    </message>
</context>
<context>
    <name>tessera::ui::LocatingPanel</name>
    <message>
        <source>The site has no vehicle yet. Set one up: Vehicle › Set up a new vehicle.</source>
        <translation>场地还没有车辆。请设置一台：车辆 › 设置新车辆。</translation>
    </message>
    <message>
        <source>Connect to the vehicles to see how they are located.</source>
        <translation>连接车辆后可查看其定位情况。</translation>
    </message>
    <message>
        <source>Choose a vehicle in the list or on the floor to see how it is located.</source>
        <translation>在列表中或地面上选择一台车辆，查看其定位情况。</translation>
    </message>
    <message>
        <source>Nothing is heard of %1 yet. Its locating shows with its first report.</source>
        <translation>尚未收到 %1 的消息。收到第一次报告后显示其定位情况。</translation>
    </message>
    <message>
        <source>x %1 m, y %2 m, %3°</source>
        <translation>x %1 m，y %2 m，%3°</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n guess(es) shown</source>
        <translation>
            <numerusform>%1，显示 %n 个猜测</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 cm × %2 cm, %3°</source>
        <translation>%1 cm × %2 cm，%3°</translation>
    </message>
    <message>
        <source>%1 s ago</source>
        <translation>%1 秒前</translation>
    </message>
    <message>
        <source>x %1 m, y %2 m: %3 cm ahead</source>
        <translation>x %1 m，y %2 m：前方 %3 cm</translation>
    </message>
    <message>
        <source>nothing: it follows no route</source>
        <translation>无：未沿路径行驶</translation>
    </message>
    <message>
        <source>reader %1: %2, %3 s ago</source>
        <translation>读卡器 %1：%2，%3 秒前</translation>
    </message>
    <message>
        <source>none in the last %1 s</source>
        <translation>最近 %1 秒内没有</translation>
    </message>
    <message>
        <source>%1 of %2 reads; found anew: %3</source>
        <translation>%2 次读数中 %1 次；重新找到：%3 次</translation>
    </message>
    <message>
        <source>NIS %1 on average of %2 reads, honest from %3 to %4</source>
        <translation>%2 次读数的平均 NIS 为 %1，如实范围 %3 至 %4</translation>
    </message>
    <message>
        <source>no reads yet</source>
        <translation>尚无读数</translation>
    </message>
    <message>
        <source>too few reads yet: %1</source>
        <translation>读数太少：%1 次</translation>
    </message>
    <message>
        <source>as expected. %1</source>
        <translation>符合预期。%1</translation>
    </message>
    <message>
        <source>worse than expected: it is too sure of its place. %1</source>
        <translation>比预期差：定位过于自信。%1</translation>
    </message>
    <message>
        <source>better than expected: it is too cautious. %1</source>
        <translation>比预期好：定位过于谨慎。%1</translation>
    </message>
    <message>
        <source>not told yet</source>
        <translation>尚未得知</translation>
    </message>
    <message numerus="yes">
        <source>now %1 cm, mean %2 cm, 95 % below %3 cm; NEES %4 (2 is honest), %n sample(s)</source>
        <translation>
            <numerusform>当前 %1 cm，平均 %2 cm，95 % 低于 %3 cm；NEES %4（2 为如实），%n 个样本</numerusform>
        </translation>
    </message>
    <message>
        <source>Locating</source>
        <translation>定位</translation>
    </message>
    <message>
        <source>Guesses</source>
        <translation>猜测</translation>
    </message>
    <message>
        <source>Ellipse (95 %)</source>
        <translation>椭圆（95 %）</translation>
    </message>
    <message>
        <source>Guesses and ellipse</source>
        <translation>猜测和椭圆</translation>
    </message>
    <message>
        <source>What is drawn of the doubt</source>
        <translation>不确定度的画法</translation>
    </message>
    <message>
        <source>What is drawn of the doubt upon the floor: places thought possible, or the ellipse that holds the vehicle in 95 of 100 cases.</source>
        <translation>在地面上如何画出不确定度：认为可能的位置，或 100 次中有 95 次包含车辆的椭圆。</translation>
    </message>
    <message>
        <source>Forget the reads and errors so far and count anew</source>
        <translation>清除至今的读数和误差，重新统计</translation>
    </message>
    <message>
        <source>Count anew</source>
        <translation>重新统计</translation>
    </message>
    <message>
        <source>Locator</source>
        <translation>定位器</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Doubt (1 σ)</source>
        <translation>不确定度（1 σ）</translation>
    </message>
    <message>
        <source>Last report</source>
        <translation>最近报告</translation>
    </message>
    <message>
        <source>Predicted</source>
        <translation>预测位置</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>延迟</translation>
    </message>
    <message>
        <source>Looks ahead to</source>
        <translation>前视点</translation>
    </message>
    <message>
        <source>Last reads</source>
        <translation>最近读数</translation>
    </message>
    <message>
        <source>Contradictions</source>
        <translation>矛盾</translation>
    </message>
    <message>
        <source>Fit of the reads</source>
        <translation>读数吻合度</translation>
    </message>
    <message>
        <source>Error (simulation)</source>
        <translation>误差（仿真）</translation>
    </message>
    <message>
        <source>%1 s to the next command, which holds %2 s</source>
        <translation>距下一指令 %1 秒，保持 %2 秒</translation>
    </message>
    <message>
        <source>A tag speaks for another place.</source>
        <translation>有一个标签表明它可能在别处。</translation>
    </message>
</context>
<context>
    <name>tessera::ui::LooseTagModel</name>
    <message>
        <source>UID</source>
        <translation>UID</translation>
    </message>
    <message>
        <source>x (m)</source>
        <translation>x (m)</translation>
    </message>
    <message>
        <source>y (m)</source>
        <translation>y (m)</translation>
    </message>
    <message>
        <source>not registered</source>
        <translation>未登记</translation>
    </message>
</context>
<context>
    <name>tessera::ui::LooseTagPage</name>
    <message>
        <source>Single tags in the floor that belong to no tile, for instance at a station. Their places are those on the floor, x to the right and y upwards.</source>
        <translation>地面上不属于任何地砖的单个标签，例如站点处的标签。位置为其在地面上的坐标：x 向右，y 向上。</translation>
    </message>
    <message>
        <source>&amp;Add a tag</source>
        <translation>添加标签(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Remove the tag</source>
        <translation>删除标签(&amp;R)</translation>
    </message>
</context>
<context>
    <name>tessera::ui::MagneticLayer</name>
    <message>
        <source>Iron in the floor turns compasses by</source>
        <translation>地面中的铁使指南针偏转</translation>
    </message>
    <message>
        <source>Nothing is known of iron in the floor yet: drive over it to learn it.</source>
        <translation>地面中的铁还一无所知：驾驶车辆驶过地面即可学习。</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>left %1</source>
        <translation>左 %1</translation>
    </message>
    <message>
        <source>right %1</source>
        <translation>右 %1</translation>
    </message>
    <message numerus="yes">
        <source>Iron turns the compass %1° to the right (± %2°, %n visit(s))</source>
        <translation>
            <numerusform>铁使指南针右偏 %1°（± %2°，驶过 %n 次）</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Iron turns the compass %1° to the left (± %2°, %n visit(s))</source>
        <translation>
            <numerusform>铁使指南针左偏 %1°（± %2°，驶过 %n 次）</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tessera::ui::MapPictureDialog</name>
    <message>
        <source>Picture of the map</source>
        <translation>地图图片</translation>
    </message>
    <message>
        <source>1 : %1</source>
        <translation>1 : %1</translation>
    </message>
    <message>
        <source>&amp;Tags</source>
        <translation>标签(&amp;T)</translation>
    </message>
    <message>
        <source>Serial &amp;numbers</source>
        <translation>序列号(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Zones</source>
        <translation>区域(&amp;Z)</translation>
    </message>
    <message>
        <source>&amp;Routes</source>
        <translation>路径(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Legend</source>
        <translation>图例(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Scale:</source>
        <translation>比例(&amp;S)：</translation>
    </message>
    <message>
        <source>Paper:</source>
        <translation>纸张：</translation>
    </message>
    <message>
        <source>Sa&amp;ve as…</source>
        <translation>另存为(&amp;V)…</translation>
    </message>
    <message>
        <source>%1 × %2 cm</source>
        <translation>%1 × %2 厘米</translation>
    </message>
    <message>
        <source>Floor &amp;plan</source>
        <translation>平面图(&amp;P)</translation>
    </message>
    <message>
        <source>Serial &amp;numbers (too small at this scale)</source>
        <translation>序列号（此比例下太小）(&amp;N)</translation>
    </message>
</context>
<context>
    <name>tessera::ui::MeasureTool</name>
    <message>
        <source>%1 m</source>
        <comment>a length</comment>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Measure: click where it begins, or drag from end to end.</source>
        <translation>测量：单击起点，或从一端拖到另一端。</translation>
    </message>
    <message>
        <source>Click to measure anew. Esc ends.</source>
        <translation>单击重新测量。Esc 结束。</translation>
    </message>
    <message>
        <source>Click to go on, double-click or Enter to end. Shift: 45° steps. Alt: without snapping. Backspace: back.</source>
        <translation>单击继续，双击或回车结束。Shift：45° 步进。Alt：不吸附。退格：退回一步。</translation>
    </message>
    <message>
        <source>together %1</source>
        <translation>合计 %1</translation>
    </message>
    <message>
        <source>area %1 m²</source>
        <translation>面积 %1 平方米</translation>
    </message>
</context>
<context>
    <name>tessera::ui::NamePage</name>
    <message>
        <source>Vehicles that nobody has set up yet answer at 254. Another address avoids that two answer at once.</source>
        <translation>尚未设置的车辆使用地址 254 应答。改用其他地址可避免两辆车同时应答。</translation>
    </message>
    <message>
        <source>Name and address</source>
        <translation>名称和地址</translation>
    </message>
    <message>
        <source>The name is for people; the address is the vehicle&apos;s number on the radio channel.</source>
        <translation>名称便于人员识别；地址是车辆在无线信道上的编号。</translation>
    </message>
    <message>
        <source>&amp;Name:</source>
        <translation>名称(&amp;N)：</translation>
    </message>
    <message>
        <source>&amp;Address (1 to 254):</source>
        <translation>地址（1 至 254）(&amp;A)：</translation>
    </message>
    <message>
        <source>The lowest free address is proposed. No two vehicles of a channel may have the same one.</source>
        <translation>建议使用最小的空闲地址。同一信道上的车辆地址不得重复。</translation>
    </message>
</context>
<context>
    <name>tessera::ui::NewSiteDialog</name>
    <message>
        <source>My floor</source>
        <translation>我的场地</translation>
    </message>
    <message>
        <source>New site</source>
        <translation>新建场地</translation>
    </message>
    <message>
        <source>&amp;Name:</source>
        <translation>名称(&amp;N)：</translation>
    </message>
    <message>
        <source>&amp;Tiles:</source>
        <translation>地板砖(&amp;T)：</translation>
    </message>
    <message>
        <source>Tiles &amp;across (x):</source>
        <translation>横向砖数（x）(&amp;A)：</translation>
    </message>
    <message>
        <source>Tiles &amp;up (y):</source>
        <translation>纵向砖数（y）(&amp;U)：</translation>
    </message>
    <message>
        <source>Size:</source>
        <translation>尺寸：</translation>
    </message>
    <message>
        <source>every place</source>
        <translation>逐位布置</translation>
    </message>
    <message>
        <source>every second place</source>
        <translation>隔位布置</translation>
    </message>
    <message>
        <source>%1 × %2 cm, a tag each %3 cm, %4</source>
        <translation>%1 × %2 cm，标签间距 %3 cm，%4</translation>
    </message>
    <message>
        <source>&amp;Make the site</source>
        <translation>创建场地(&amp;M)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message numerus="yes">
        <source>%1 × %2 m, %n tag(s)</source>
        <translation>
            <numerusform>%1 × %2 m，%n 个标签</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Empty floor: the tiles are laid by hand afterwards</source>
        <translation>空地面：之后手动铺砖(&amp;E)</translation>
    </message>
    <message>
        <source>no tiles yet</source>
        <translation>还没有地砖</translation>
    </message>
    <message>
        <source>&amp;Practice floor: tags with made-up UIDs, for simulated vehicles</source>
        <translation>练习场地：标签使用虚构的 UID，用于模拟车辆(&amp;P)</translation>
    </message>
    <message>
        <source>Made-up UIDs for all tags, and one vehicle, so that you can try everything in the simulated world. On a real floor leave this off: its tags get their UIDs when they are registered, and made-up ones are in the way.</source>
        <translation>所有标签使用虚构的 UID，并有一辆车，便于在演示环境中试用全部功能。实际场地请勿勾选：标签的 UID 在登记时获得，虚构的 UID 会妨碍登记。</translation>
    </message>
</context>
<context>
    <name>tessera::ui::Orders</name>
    <message>
        <source>Choose a vehicle in the list or on the floor first.</source>
        <translation>请先在列表中或地面上选择车辆。</translation>
    </message>
    <message>
        <source>There is no connection to the vehicles. Connect first.</source>
        <translation>未与车辆建立连接。请先连接。</translation>
    </message>
    <message>
        <source>The supervision does not know %1 yet. Connect again.</source>
        <translation>上位机尚未识别 %1。请重新连接。</translation>
    </message>
    <message>
        <source>The radio&apos;s port is not open. Connect first.</source>
        <translation>无线模块的端口未打开。请先连接。</translation>
    </message>
    <message>
        <source>%1 does not answer now.</source>
        <translation>%1 当前无应答。</translation>
    </message>
    <message>
        <source>A fault holds %1. Remove its cause and clear it first.</source>
        <translation>%1 因故障停止。请先排除原因，再清除故障。</translation>
    </message>
    <message>
        <source>%1 calibrates its compass now.</source>
        <translation>%1 正在校准罗盘。</translation>
    </message>
    <message>
        <source>The site has no route yet. Draw one on the floor first.</source>
        <translation>场地中还没有路径。请先在地面上绘制一条路径。</translation>
    </message>
    <message>
        <source>Choose a route first.</source>
        <translation>请先选择路径。</translation>
    </message>
    <message>
        <source>%1 runs this route already.</source>
        <translation>%1 已在运行此路径。</translation>
    </message>
    <message>
        <source>%1 runs no route.</source>
        <translation>%1 未在运行路径。</translation>
    </message>
    <message>
        <source>%1 does not pause.</source>
        <translation>%1 未处于暂停状态。</translation>
    </message>
    <message>
        <source>%1 reports no fault.</source>
        <translation>%1 没有故障。</translation>
    </message>
</context>
<context>
    <name>tessera::ui::Pairing</name>
    <message>
        <source>No vehicle fresh from the factory has answered. Is it switched on, flashed and in reach? If it was set up before, it has an address and a key already: type its key below.</source>
        <translation>没有刚出厂的车辆应答。车辆是否已开机、已烧录固件，并在无线覆盖范围内？如果以前设置过，车辆已有地址和密钥：请在下方输入其密钥。</translation>
    </message>
    <message>
        <source>The vehicle no longer answers. Switch it off and on again and press “Pair now” once more.</source>
        <translation>车辆不再应答。请关闭车辆电源后重新打开，然后再次按“立即配对”。</translation>
    </message>
    <message>
        <source>The vehicle refuses the address %1. Choose another one.</source>
        <translation>车辆拒绝地址 %1。请选择其他地址。</translation>
    </message>
    <message>
        <source>Calling a vehicle that is fresh from the factory…</source>
        <translation>正在呼叫刚出厂的车辆…</translation>
    </message>
    <message>
        <source>A vehicle answers at the factory&apos;s address, but with another key. Type its key below.</source>
        <translation>有车辆以出厂地址应答，但密钥不同。请在下方输入其密钥。</translation>
    </message>
    <message>
        <source>Giving the vehicle its new key…</source>
        <translation>正在为车辆设置新密钥…</translation>
    </message>
    <message>
        <source>Not connected. Connect to the vehicles and try again.</source>
        <translation>未连接。请先连接车辆，然后重试。</translation>
    </message>
    <message>
        <source>It has its key. Waiting for it under the new key…</source>
        <translation>车辆已取得密钥。正在等待车辆使用新密钥应答…</translation>
    </message>
    <message>
        <source>Giving the vehicle its address %1…</source>
        <translation>正在为车辆设置地址 %1…</translation>
    </message>
    <message>
        <source>It may have taken this key; note it down and try it if the old one is refused: %1</source>
        <translation>车辆可能已启用此密钥；请记下，原密钥被拒绝时再试用：%1</translation>
    </message>
</context>
<context>
    <name>tessera::ui::RadioDialog</name>
    <message>
        <source>Cancelled. What the module now holds is told by Read.</source>
        <translation>已取消。要了解模块当前的参数，请点击“读取”。</translation>
    </message>
    <message>
        <source>Reading the module&apos;s parameters…</source>
        <translation>正在读取模块参数…</translation>
    </message>
    <message>
        <source>Writing the site&apos;s parameters and reading them back…</source>
        <translation>正在写入场地参数并回读核对…</translation>
    </message>
    <message>
        <source>Written and read back. Put both jumpers on again, then connect.</source>
        <translation>参数已写入并读回核对。请重新插上两个跳线，然后连接。</translation>
    </message>
    <message numerus="yes">
        <source>The module did not keep %n parameter(s). Write once more; if that does not help, the module may be of another kind or broken.</source>
        <translation>
            <numerusform>模块未保存 %n 个参数。请再写入一次；如仍无效，模块可能型号不符或已损坏。</numerusform>
        </translation>
    </message>
    <message>
        <source>The module is set as the site asks. Put both jumpers on again, then connect.</source>
        <translation>模块设置与场地要求一致。请重新插上两个跳线，然后连接。</translation>
    </message>
    <message numerus="yes">
        <source>%n parameter(s) differ from the site&apos;s; vehicles will not be heard like this. Press “Write the site&apos;s parameters”.</source>
        <translation>
            <numerusform>有 %n 个参数与场地不一致，这样无法收到车辆的信号。请点击“写入场地参数”。</numerusform>
        </translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>尚未读取</translation>
    </message>
    <message>
        <source>%1 – differs</source>
        <translation>%1 – 不一致</translation>
    </message>
    <message>
        <source>Radio module of this computer</source>
        <translation>本机的无线模块</translation>
    </message>
    <message>
        <source>&lt;p&gt;This computer&apos;s radio module (E32-TTL-100) must be set like those of the vehicles. To read or write its settings:&lt;/p&gt;&lt;ol&gt;&lt;li&gt;Take both jumpers, M0 and M1, off the module&apos;s adapter.&lt;/li&gt;&lt;li&gt;Press “Read the module”. Driving vehicles are stopped first.&lt;/li&gt;&lt;li&gt;Where something differs, press “Write the site&apos;s parameters”.&lt;/li&gt;&lt;li&gt;Put both jumpers back on.&lt;/li&gt;&lt;/ol&gt;</source>
        <translation>&lt;p&gt;本机的无线模块（E32-TTL-100）必须与车辆上的无线模块设置一致。读取或写入其设置的步骤：&lt;/p&gt;&lt;ol&gt;&lt;li&gt;从模块转接板上取下 M0 和 M1 两个跳线。&lt;/li&gt;&lt;li&gt;点击“读取模块”。行驶中的车辆会先停止。&lt;/li&gt;&lt;li&gt;如有不一致，点击“写入场地参数”。&lt;/li&gt;&lt;li&gt;重新插上两个跳线。&lt;/li&gt;&lt;/ol&gt;</translation>
    </message>
    <message>
        <source>Parameters of the module and of the site</source>
        <translation>模块参数与场地参数</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Module</source>
        <translation>模块</translation>
    </message>
    <message>
        <source>Site</source>
        <translation>场地</translation>
    </message>
    <message>
        <source>&amp;Transmit power:</source>
        <translation>发射功率(&amp;T)：</translation>
    </message>
    <message>
        <source>Choose what the rules of your country allow; the vehicles do not mind.</source>
        <translation>请按所在国家的法规选择；对车辆没有影响。</translation>
    </message>
    <message>
        <source>&amp;Read the module</source>
        <translation>读取模块(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Write the site&apos;s parameters</source>
        <translation>写入场地参数(&amp;W)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Work on the radio module</source>
        <translation>无线模块操作进度</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
</context>
<context>
    <name>tessera::ui::RadioRows</name>
    <message>
        <source>%1 dBm (%2 mW)</source>
        <translation>%1 dBm（%2 mW）</translation>
    </message>
    <message>
        <source>%1 bit/s</source>
        <translation>%1 bit/s</translation>
    </message>
    <message>
        <source>%1 (%2 MHz)</source>
        <translation>%1（%2 MHz）</translation>
    </message>
    <message>
        <source>fixed</source>
        <translation>定点</translation>
    </message>
    <message>
        <source>transparent</source>
        <translation>透明</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>信道</translation>
    </message>
    <message>
        <source>Air rate</source>
        <translation>空中速率</translation>
    </message>
    <message>
        <source>Address (hexadecimal)</source>
        <translation>地址（十六进制）</translation>
    </message>
    <message>
        <source>Transmission</source>
        <translation>传输方式</translation>
    </message>
    <message>
        <source>Error correction</source>
        <translation>纠错</translation>
    </message>
    <message>
        <source>Port&apos;s baud rate</source>
        <translation>串口波特率</translation>
    </message>
    <message>
        <source>Transmit power</source>
        <translation>发射功率</translation>
    </message>
    <message>
        <source>push-pull</source>
        <translation>推挽</translation>
    </message>
    <message>
        <source>open collector</source>
        <translation>集电极开路</translation>
    </message>
    <message>
        <source>Port&apos;s format</source>
        <translation>串口格式</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>输出方式</translation>
    </message>
</context>
<context>
    <name>tessera::ui::ReaderTable</name>
    <message>
        <source>Places of the readers</source>
        <translation>读卡器位置</translation>
    </message>
    <message>
        <source>Add a reader</source>
        <translation>添加读卡器</translation>
    </message>
    <message>
        <source>Remove it</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Ahead (m)</source>
        <translation>向前 (m)</translation>
    </message>
    <message>
        <source>Left (m)</source>
        <translation>向左 (m)</translation>
    </message>
    <message>
        <source>How far ahead of the middle between the driven wheels, and how far to its left</source>
        <translation>读卡器相对驱动轮中点向前和向左的距离</translation>
    </message>
</context>
<context>
    <name>tessera::ui::ReadersPage</name>
    <message>
        <source>A reader does not answer the vehicle. Check its cable, its supply and its number on the bus.</source>
        <translation>有读卡器未应答车辆。请检查其接线、供电和总线编号。</translation>
    </message>
    <message>
        <source>Every reader has read a tag.</source>
        <translation>所有读卡器均已读到标签。</translation>
    </message>
    <message numerus="yes">
        <source>%n reader(s) still to try.</source>
        <translation>
            <numerusform>还有 %n 个读卡器待测试。</numerusform>
        </translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>尚无</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>–</source>
        <comment>no value</comment>
        <translation>–</translation>
    </message>
    <message>
        <source>Reader %1</source>
        <translation>读卡器 %1</translation>
    </message>
    <message>
        <source>The readers</source>
        <translation>读卡器</translation>
    </message>
    <message>
        <source>Hold a tag under one reader after the other, counted from the vehicle&apos;s left.</source>
        <translation>从车辆左侧数起，依次在每个读卡器下方放置一张标签。</translation>
    </message>
    <message>
        <source>Under the right reader its light comes on in the drawing. If another one lights up, the readers are connected in another order than the type says.</source>
        <translation>顺序正确时，图中对应的读卡器会亮起。如果亮起的是另一个，说明读卡器的接线顺序与车型设置不同。</translation>
    </message>
    <message>
        <source>Readers and the tags that they read</source>
        <translation>读卡器及其读到的标签</translation>
    </message>
    <message>
        <source>Reader</source>
        <translation>读卡器</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>有应答</translation>
    </message>
    <message>
        <source>Last tag</source>
        <translation>最近的标签</translation>
    </message>
    <message>
        <source>On this floor</source>
        <translation>属于本场地</translation>
    </message>
</context>
<context>
    <name>tessera::ui::RecentList</name>
    <message>
        <source>Unnamed site</source>
        <translation>未命名场地</translation>
    </message>
    <message>
        <source>%1 is no longer there.</source>
        <translation>%1 已不存在。</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>未找到</translation>
    </message>
    <message>
        <source>&amp;Recent sites</source>
        <translation>最近的场地(&amp;R)</translation>
    </message>
    <message>
        <source>Sites that you open will be listed here.</source>
        <translation>打开过的场地会列在这里。</translation>
    </message>
    <message>
        <source>Recent sites</source>
        <translation>最近的场地</translation>
    </message>
    <message>
        <source>Site</source>
        <translation>场地</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Last opened</source>
        <translation>上次打开</translation>
    </message>
    <message>
        <source>Open t&amp;his site</source>
        <translation>打开此场地(&amp;H)</translation>
    </message>
    <message>
        <source>Remove &amp;from list</source>
        <translation>从列表中移除(&amp;F)</translation>
    </message>
    <message>
        <source>Takes the entry off this list (Del). The file stays.</source>
        <translation>从列表中移除该条目 (Del)，文件保留。</translation>
    </message>
</context>
<context>
    <name>tessera::ui::RegisterPanel</name>
    <message>
        <source>Register tags</source>
        <translation>登记标签</translation>
    </message>
</context>
<context>
    <name>tessera::ui::RegisterTool</name>
    <message>
        <source>Choose the reader in the panel and press Start.</source>
        <translation>在面板中选择读卡器，然后按“开始”。</translation>
    </message>
    <message>
        <source>Every place is registered or skipped. Esc: leave.</source>
        <translation>所有位置都已登记或跳过。Esc：离开。</translation>
    </message>
    <message>
        <source>Hold the lit tag to the reader. Backspace: one back. Del: skip it. Double-click a tag: go on there. Esc: leave.</source>
        <translation>读取点亮的标签。Backspace：退回一个。Del：跳过。双击标签：从那里继续。Esc：离开。</translation>
    </message>
</context>
<context>
    <name>tessera::ui::Registrar</name>
    <message>
        <source>Only a part of a UID came: %1 was taken back. Hold the card again.</source>
        <translation>只收到 UID 的一部分：%1 已撤回。请再读一次该卡。</translation>
    </message>
    <message>
        <source>Only a part of a UID came: %1. Hold the card again.</source>
        <translation>只收到 UID 的一部分：%1。请再读一次该卡。</translation>
    </message>
    <message>
        <source>Skipped no longer: tag %1 of tile %2</source>
        <translation>不再跳过：地板砖 %2 的标签 %1</translation>
    </message>
    <message>
        <source>Taken back: %1</source>
        <translation>已撤回：%1</translation>
    </message>
    <message>
        <source>Taken back</source>
        <translation>已撤回</translation>
    </message>
    <message numerus="yes">
        <source>Taken back: %n tag(s)</source>
        <translation>
            <numerusform>已撤回：%n 个标签</numerusform>
        </translation>
    </message>
    <message>
        <source>Skipped: tag %1 of tile %2</source>
        <translation>已跳过：地板砖 %2 的标签 %1</translation>
    </message>
</context>
<context>
    <name>tessera::ui::RevisionModel</name>
    <message numerus="yes">
        <source>%n tile(s) laid</source>
        <translation>
            <numerusform>铺设 %n 块地板砖</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n tile(s) moved</source>
        <translation>
            <numerusform>移动 %n 块地板砖</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n tile(s) taken up</source>
        <translation>
            <numerusform>撤去 %n 块地板砖</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n tag(s)</source>
        <translation>
            <numerusform>%n 个电子标签</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n zone(s)</source>
        <translation>
            <numerusform>%n 个区域</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n route(s)</source>
        <translation>
            <numerusform>%n 条路径</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n vehicle(s)</source>
        <translation>
            <numerusform>%n 辆车</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n other change(s)</source>
        <translation>
            <numerusform>%n 项其他改动</numerusform>
        </translation>
    </message>
    <message>
        <source>only the order of lists</source>
        <translation>仅列表顺序</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>the file as it was opened</source>
        <translation>打开时的文件</translation>
    </message>
    <message>
        <source>saved without a step</source>
        <translation>无步骤保存</translation>
    </message>
    <message>
        <source>the first that is kept</source>
        <translation>保留的第一个</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>%1, %2
%3
%4</source>
        <translation>%1，%2
%3
%4</translation>
    </message>
    <message>
        <source>When</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>保存者</translation>
    </message>
    <message>
        <source>What</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>改动</translation>
    </message>
</context>
<context>
    <name>tessera::ui::RevisionPanel</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>以及其他 %n 项</numerusform>
        </translation>
    </message>
    <message>
        <source>This site is in no file yet. Save it (Ctrl+S): each saving becomes a revision here.</source>
        <translation>该场地还没有文件。请保存（Ctrl+S）：每次保存都会在此成为一个修订版本。</translation>
    </message>
    <message>
        <source>There is no revision yet. Save the site (Ctrl+S): each saving becomes a revision here.</source>
        <translation>还没有修订版本。请保存场地（Ctrl+S）：每次保存都会在此成为一个修订版本。</translation>
    </message>
    <message>
        <source>Choose a revision to see what has changed since then.</source>
        <translation>选择一个修订版本，查看自那时以来的变化。</translation>
    </message>
    <message>
        <source>Comparing…</source>
        <translation>正在比较…</translation>
    </message>
    <message>
        <source>The site is the same as on %1.</source>
        <translation>场地与 %1 时相同。</translation>
    </message>
    <message numerus="yes">
        <source>Since %1: %n difference(s). Click one to go there.</source>
        <translation>
            <numerusform>自 %1 以来：%n 处差异。单击可前往。</numerusform>
        </translation>
    </message>
    <message>
        <source>Since %1</source>
        <translation>自 %1 以来</translation>
    </message>
    <message>
        <source>The site is as it was then: there is nothing to go back to.</source>
        <translation>场地与当时相同，无需回退。</translation>
    </message>
    <message>
        <source>Go back to %1</source>
        <translation>回到 %1</translation>
    </message>
    <message>
        <source>The site is as it was on %1. Undo (Ctrl+Z) takes that back.</source>
        <translation>场地已恢复为 %1 时的样子。撤销（Ctrl+Z）可收回。</translation>
    </message>
    <message>
        <source>The vehicles keep the keys that they have now.</source>
        <translation>车辆保留现在的密钥。</translation>
    </message>
    <message>
        <source>Revisions</source>
        <translation>修订版本</translation>
    </message>
    <message>
        <source>&amp;Go back to this one</source>
        <translation>回到这个版本(&amp;G)</translation>
    </message>
    <message>
        <source>Put the site back as it was then, as one step that can be undone</source>
        <translation>使场地恢复为当时的样子，作为一步完成，可以撤销</translation>
    </message>
    <message>
        <source>Save as a &amp;file…</source>
        <translation>另存为文件(&amp;F)…</translation>
    </message>
    <message>
        <source>Write this revision to a file of its own; the open site stays as it is</source>
        <translation>把该修订版本写入单独的文件；当前场地保持不变</translation>
    </message>
    <message>
        <source>&amp;End comparing</source>
        <translation>结束比较(&amp;E)</translation>
    </message>
    <message>
        <source>Take the differences off the floor (Esc)</source>
        <translation>把差异从地面上取下 (Esc)</translation>
    </message>
    <message>
        <source>You save as:</source>
        <translation>保存者：</translation>
    </message>
    <message>
        <source>The name that stands beside what you save</source>
        <translation>写在您所保存内容旁边的名字</translation>
    </message>
    <message>
        <source>What has changed since</source>
        <translation>自那时以来的变化</translation>
    </message>
</context>
<context>
    <name>tessera::ui::RoutePanel</name>
    <message>
        <source>%1 m, about %2 s</source>
        <translation>%1 m，约 %2 秒</translation>
    </message>
    <message>
        <source>%1 m, about %2 min %3 s</source>
        <translation>%1 m，约 %2 分 %3 秒</translation>
    </message>
    <message>
        <source>This site has no route yet. A route is the way that a vehicle drives: click its vertices on the floor.</source>
        <translation>此场地还没有路径。路径是车辆行驶的路线：在场地上依次点击各顶点即可绘制。</translation>
    </message>
    <message>
        <source>&amp;Draw a route</source>
        <translation>绘制路径(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;New route</source>
        <translation>新建路径(&amp;N)</translation>
    </message>
    <message>
        <source>Draw a new route on the floor</source>
        <translation>在场地上绘制新路径</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>重命名(&amp;N)</translation>
    </message>
    <message>
        <source>Rename the route</source>
        <translation>重命名路径</translation>
    </message>
    <message>
        <source>D&amp;uplicate</source>
        <translation>复制(&amp;U)</translation>
    </message>
    <message>
        <source>Make another route of the same vertices</source>
        <translation>用相同的顶点再建一条路径</translation>
    </message>
    <message>
        <source>&amp;Reverse</source>
        <translation>反向(&amp;R)</translation>
    </message>
    <message>
        <source>Drive the route the other way round</source>
        <translation>按相反方向行驶此路径</translation>
    </message>
    <message>
        <source>&amp;Delete route</source>
        <translation>删除路径(&amp;D)</translation>
    </message>
    <message>
        <source>Delete the route</source>
        <translation>删除路径</translation>
    </message>
    <message>
        <source>&amp;Insert vertex</source>
        <translation>插入顶点(&amp;I)</translation>
    </message>
    <message>
        <source>Insert a vertex after the chosen one</source>
        <translation>在所选顶点之后插入顶点</translation>
    </message>
    <message>
        <source>Delete &amp;vertex</source>
        <translation>删除顶点(&amp;V)</translation>
    </message>
    <message>
        <source>Delete the chosen vertex</source>
        <translation>删除所选顶点</translation>
    </message>
    <message>
        <source>Routes</source>
        <translation>路径</translation>
    </message>
    <message>
        <source>Vertices of the route</source>
        <translation>路径的顶点</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Distance of the points that the vehicle is led to, one after the other</source>
        <translation>引导车辆依次到达的各控制点之间的距离</translation>
    </message>
    <message>
        <source> m/s</source>
        <translation> m/s</translation>
    </message>
    <message>
        <source>For the driving time shown below; each run has a speed of its own</source>
        <translation>用于计算下方的行驶时间；每次运行另设速度</translation>
    </message>
    <message>
        <source>Length and time</source>
        <translation>长度和时间</translation>
    </message>
    <message>
        <source>Control points every</source>
        <translation>控制点间距</translation>
    </message>
    <message>
        <source>Time when driven at</source>
        <translation>按此速度估算时间</translation>
    </message>
    <message>
        <source>&amp;Join</source>
        <translation>连接(&amp;J)</translation>
    </message>
    <message>
        <source>Make one route of this one and another whose end touches</source>
        <translation>与端点相接的另一条路径合为一条</translation>
    </message>
    <message>
        <source>&amp;Split</source>
        <translation>拆分(&amp;S)</translation>
    </message>
    <message>
        <source>Make two routes of this one, at the chosen vertex</source>
        <translation>在所选顶点处把路径分为两条</translation>
    </message>
    <message>
        <source>Length divided by speed, slower on legs that have a lower one. Choose a vehicle for the time with its ramps and turns.</source>
        <translation>长度除以速度，限速更低的路段按其速度计算。选择车辆后，给出含加减速和转向的时间。</translation>
    </message>
    <message>
        <source>As %1 drives it at that speed: with its ramps, its top speed, slow zones and its turns on the spot or arcs at corners.</source>
        <translation>按 %1 以该速度行驶计算：含加减速、最高速度、慢行区域，以及转角处的原地转向或圆弧。</translation>
    </message>
</context>
<context>
    <name>tessera::ui::RouteTool</name>
    <message>
        <source>A route needs at least two vertices.</source>
        <translation>路径至少需要两个顶点。</translation>
    </message>
    <message>
        <source>Shift: in steps of 45°. Alt: no snapping. Esc: leave it where it was.</source>
        <translation>Shift：以 45° 为步进。Alt：不吸附。Esc：放回原处。</translation>
    </message>
    <message>
        <source>Click where the route is to begin. Esc: stop drawing.</source>
        <translation>点击路径的起点。Esc：停止绘制。</translation>
    </message>
    <message>
        <source>Click the next vertex. Double-click or Enter: finish. Backspace: one back. Shift: in steps of 45°. Alt: no snapping.</source>
        <translation>点击下一个顶点。双击或 Enter：完成。Backspace：退回一步。Shift：以 45° 为步进。Alt：不吸附。</translation>
    </message>
    <message>
        <source>Arrow keys move the vertex by 1 cm, with Shift by 10 cm. Del removes it.</source>
        <translation>方向键将顶点移动 1 cm，同时按住 Shift 移动 10 cm。Del 删除顶点。</translation>
    </message>
    <message>
        <source>Drag a vertex to move it, a small circle between two to insert one.</source>
        <translation>拖动顶点可移动它，拖动两顶点之间的小圆可插入顶点。</translation>
    </message>
    <message>
        <source>Click a route to change it, or draw a new one.</source>
        <translation>点击路径进行修改，或绘制新路径。</translation>
    </message>
    <message>
        <source>&amp;Finish route</source>
        <translation>完成路径(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Remove last vertex</source>
        <translation>移除最后一个顶点(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Drop route</source>
        <translation>放弃路径(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Delete vertex</source>
        <translation>删除顶点(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Insert vertex here</source>
        <translation>在此处插入顶点(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Reverse route</source>
        <translation>路径反向(&amp;R)</translation>
    </message>
    <message>
        <source>D&amp;uplicate route</source>
        <translation>复制路径(&amp;U)</translation>
    </message>
    <message>
        <source>De&amp;lete route</source>
        <translation>删除路径(&amp;L)</translation>
    </message>
    <message>
        <source>Draw &amp;new route from here</source>
        <translation>从此处绘制新路径(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Split route here</source>
        <translation>在此拆分路径(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Join with “%1”</source>
        <translation>与“%1”连接(&amp;J)</translation>
    </message>
</context>
<context>
    <name>tessera::ui::RunPanel</name>
    <message>
        <source>%1 of %2 m on the route %3</source>
        <translation>%1 / %2 m，路径 %3</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 分 %2 秒</translation>
    </message>
    <message>
        <source>%1, about %2 left</source>
        <comment>distance travelled, time</comment>
        <translation>%1，剩余约 %2</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>what a button does, its key</comment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>R&amp;esume</source>
        <translation>继续(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>暂停(&amp;P)</translation>
    </message>
    <message>
        <source>Let it drive along the chosen route, at most this fast.</source>
        <translation>让车辆沿所选路径行驶，最高不超过此速度。</translation>
    </message>
    <message>
        <source>Let it go on along its route.</source>
        <translation>让车辆沿路径继续行驶。</translation>
    </message>
    <message>
        <source>Let it stand and keep its route.</source>
        <translation>让车辆停下，保留路径。</translation>
    </message>
    <message>
        <source>Stop it; it gives up its route.</source>
        <translation>停止车辆，并放弃其路径。</translation>
    </message>
    <message>
        <source>Forget faults whose cause is gone.</source>
        <translation>清除原因已消除的故障。</translation>
    </message>
    <message>
        <source>The order was not taken: there is no connection to the vehicles.</source>
        <translation>指令未被接受：未连接到车辆。</translation>
    </message>
    <message>
        <source>This site has no vehicle yet. Set one up: the wizard leads through it.</source>
        <translation>此场地还没有车辆。请按向导设置一辆。</translation>
    </message>
    <message>
        <source>Choose a vehicle in the list or on the floor.</source>
        <translation>请在列表中或场地上选择车辆。</translation>
    </message>
    <message>
        <source>R&amp;oute:</source>
        <translation>路径(&amp;O)：</translation>
    </message>
    <message>
        <source>No route yet</source>
        <translation>还没有路径</translation>
    </message>
    <message>
        <source>Choose a route</source>
        <translation>选择路径</translation>
    </message>
    <message>
        <source>&amp;Draw a route</source>
        <translation>绘制路径(&amp;D)</translation>
    </message>
    <message>
        <source>Draw a route on the floor.</source>
        <translation>在场地上绘制路径。</translation>
    </message>
    <message>
        <source> m/s</source>
        <translation> m/s</translation>
    </message>
    <message>
        <source>The fastest that it shall drive, from %1 to %2 m/s.</source>
        <translation>车辆的最高行驶速度，%1 到 %2 m/s。</translation>
    </message>
    <message>
        <source>Progress on the route</source>
        <translation>路径进度</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>运行(&amp;R)</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>停止(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Clear faults</source>
        <translation>清除故障(&amp;C)</translation>
    </message>
    <message>
        <source>S&amp;peed:</source>
        <translation>速度(&amp;P)：</translation>
    </message>
    <message>
        <source>Set up a vehicle…</source>
        <translation>设置车辆…</translation>
    </message>
</context>
<context>
    <name>tessera::ui::ScanPage</name>
    <message>
        <source>Go on</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>All done</source>
        <translation>全部完成</translation>
    </message>
    <message>
        <source>There is no place for a tag here.</source>
        <translation>这里没有标签的位置。</translation>
    </message>
    <message>
        <source>Every place is registered or skipped.</source>
        <translation>所有位置都已登记或跳过。</translation>
    </message>
    <message>
        <source>Tile %1</source>
        <translation>地板砖 %1</translation>
    </message>
    <message>
        <source>Tag %1 of %2</source>
        <translation>第 %1 个标签，共 %2 个</translation>
    </message>
    <message>
        <source>%1: %2 until another is read</source>
        <translation>%1：目前为 %2，读到别的标签即替换</translation>
    </message>
    <message>
        <source>%1 – paused, reads do not count</source>
        <translation>%1 — 已暂停，读到的不算</translation>
    </message>
    <message>
        <source>%1 of %2 registered</source>
        <translation>已登记 %1 / %2</translation>
    </message>
    <message>
        <source>%1, %2 skipped</source>
        <translation>%1，跳过 %2</translation>
    </message>
    <message>
        <source>Reader: types like a keyboard</source>
        <translation>读卡器：像键盘一样输入</translation>
    </message>
    <message>
        <source>Reader: %1 is being opened…</source>
        <translation>读卡器：正在打开 %1…</translation>
    </message>
    <message>
        <source>Reader: at %1</source>
        <translation>读卡器：位于 %1</translation>
    </message>
    <message>
        <source>Reader: waiting for %1</source>
        <translation>读卡器：等待 %1</translation>
    </message>
    <message>
        <source>Registered: %1</source>
        <translation>已登记：%1</translation>
    </message>
    <message>
        <source>Go on there</source>
        <translation>到那里继续</translation>
    </message>
    <message>
        <source>Show it</source>
        <translation>显示它</translation>
    </message>
    <message>
        <source>One back</source>
        <translation>退回一个</translation>
    </message>
    <message>
        <source>Take the last tag back (Backspace)</source>
        <translation>撤回上一个标签（Backspace）</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>跳过</translation>
    </message>
    <message>
        <source>This tag is dead or missing (Del)</source>
        <translation>此标签损坏或缺失（Del）</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>To go on another time</source>
        <translation>下次再继续</translation>
    </message>
    <message>
        <source>Visit the skipped places</source>
        <translation>处理跳过的位置</translation>
    </message>
    <message>
        <source>Reads do not count meanwhile (Pause)</source>
        <translation>其间读到的不算（Pause）</translation>
    </message>
    <message>
        <source>Previous place</source>
        <translation>上一个位置</translation>
    </message>
    <message>
        <source>Previous place (Page Up)</source>
        <translation>上一个位置（Page Up）</translation>
    </message>
    <message>
        <source>Next place</source>
        <translation>下一个位置</translation>
    </message>
    <message>
        <source>Next place (Page Down)</source>
        <translation>下一个位置（Page Down）</translation>
    </message>
    <message>
        <source>Exchange the two</source>
        <translation>对调这两个标签</translation>
    </message>
    <message>
        <source>%1 Exchange it with the one that is registered here, or read the whole tile anew?</source>
        <translation>%1 与此处登记的标签对调，还是重新读取整块地板砖？</translation>
    </message>
    <message>
        <source>Move it here</source>
        <translation>移到这里</translation>
    </message>
    <message>
        <source>%1 Move it here, or read the whole tile anew?</source>
        <translation>%1 把它移到这里，还是重新读取整块地板砖？</translation>
    </message>
    <message>
        <source>The tile&apos;s tags are read anew, from the lit one on. One step back brings the old ones back.</source>
        <translation>从点亮的标签开始重新读取这块地板砖。后退一步可恢复原来的标签。</translation>
    </message>
    <message>
        <source>Read the whole tile anew</source>
        <translation>重新读取整块地板砖</translation>
    </message>
    <message>
        <source>Its tags are taken off and read from the first one on</source>
        <translation>取下它的标签，从第一个开始读取</translation>
    </message>
    <message>
        <source>Sounds</source>
        <translation>声音</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 分钟</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 小时 %2 分钟</translation>
    </message>
    <message>
        <source>%1 of %2 read anew</source>
        <translation>已重新读取 %1 / %2</translation>
    </message>
    <message>
        <source>%1. %2 a minute, about %3 left</source>
        <translation>%1。每分钟 %2 个，约剩 %3</translation>
    </message>
    <message>
        <source>Another program is in front: what the reader types goes there. Click into this window.</source>
        <translation>当前窗口是其他程序：读卡器输入的内容会进入那里。请点击本窗口。</translation>
    </message>
</context>
<context>
    <name>tessera::ui::SerialBox</name>
    <message>
        <source>Choose the port of the radio module, or type its path.</source>
        <translation>请选择无线模块的串口，或输入其路径。</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <comment>port, description</comment>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>%1 (in use)</source>
        <translation>%1（使用中）</translation>
    </message>
    <message>
        <source>No serial port was found. Plug the radio&apos;s USB adapter in and press Refresh. If it is plugged in but not listed, it has no driver; on Linux, your user must also belong to the group “dialout” to open it: “sudo adduser $USER dialout”, then log in anew.</source>
        <translation>未找到串口。请插入无线模块的 USB 转接器，然后点击“刷新”。如果已插入但未列出，说明缺少驱动程序；在 Linux 上，用户还必须属于“dialout”组才能打开串口：执行“sudo adduser $USER dialout”，然后重新登录。</translation>
    </message>
    <message>
        <source>Another program is using %1. Close it first.</source>
        <translation>另一个程序正在使用 %1，请先关闭该程序。</translation>
    </message>
    <message>
        <source>The site&apos;s radio is set to %1 baud. Choose another rate only if the module on this computer is set to it.</source>
        <translation>场地的无线参数设为 %1 波特。仅当本机的模块设为其他波特率时，才选择其他值。</translation>
    </message>
    <message>
        <source>&amp;Port:</source>
        <translation>串口(&amp;P)：</translation>
    </message>
    <message>
        <source>Serial port</source>
        <translation>串口</translation>
    </message>
    <message>
        <source>e.g. /dev/ttyUSB0</source>
        <translation>例如 /dev/ttyUSB0</translation>
    </message>
    <message>
        <source>The radio module is usually /dev/ttyUSB0 (COM3 on Windows). Any path of a terminal will do.</source>
        <translation>无线模块通常为 /dev/ttyUSB0（Windows 上为 COM3）。任何终端设备的路径均可。</translation>
    </message>
    <message>
        <source>Refresh</source>
        <translation>刷新</translation>
    </message>
    <message>
        <source>Look for ports again</source>
        <translation>重新查找串口</translation>
    </message>
    <message>
        <source>Look for ports again (%1)</source>
        <translation>重新查找串口 (%1)</translation>
    </message>
    <message>
        <source>&amp;Baud rate:</source>
        <translation>波特率(&amp;B)：</translation>
    </message>
    <message>
        <source>%1 bit/s</source>
        <translation>%1 bit/s</translation>
    </message>
</context>
<context>
    <name>tessera::ui::SettingsPage</name>
    <message>
        <source>Writing…</source>
        <translation>正在写入…</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>正在读取…</translation>
    </message>
    <message>
        <source>The vehicle holds the settings of its type.</source>
        <translation>车辆中的设置与其车型一致。</translation>
    </message>
    <message>
        <source>The marked settings differ. Press “Write to the vehicle”; if one stays, it is out of the range that the vehicle accepts, and the type must be corrected.</source>
        <translation>标出的设置不一致。请点击“写入车辆”；如果仍有不一致，说明该值超出车辆允许的范围，必须修改车型设置。</translation>
    </message>
    <message>
        <source>Wheel diameter</source>
        <translation>车轮直径</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Track (wheel to wheel)</source>
        <translation>轮距（两轮之间）</translation>
    </message>
    <message>
        <source>Highest speed</source>
        <translation>最高速度</translation>
    </message>
    <message>
        <source>%1 m/s</source>
        <translation>%1 m/s</translation>
    </message>
    <message>
        <source>Highest turn rate</source>
        <translation>最高转向角速度</translation>
    </message>
    <message>
        <source>%1 rad/s</source>
        <translation>%1 rad/s</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>%1 m/s²</source>
        <translation>%1 m/s²</translation>
    </message>
    <message>
        <source>Number of readers</source>
        <translation>读卡器数量</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>尚未读取</translation>
    </message>
    <message>
        <source>Settings onto the vehicle</source>
        <translation>将设置写入车辆</translation>
    </message>
    <message>
        <source>The vehicle needs the measures of its type to drive the speeds that it is told.</source>
        <translation>车辆需要其车型的尺寸，才能按指令速度行驶。</translation>
    </message>
    <message>
        <source>Settings of the site and of the vehicle</source>
        <translation>场地和车辆中的设置</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Site</source>
        <translation>场地</translation>
    </message>
    <message>
        <source>Vehicle</source>
        <translation>车辆</translation>
    </message>
    <message>
        <source>&amp;Read from the vehicle</source>
        <translation>从车辆读取(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Write to the vehicle</source>
        <translation>写入车辆(&amp;W)</translation>
    </message>
</context>
<context>
    <name>tessera::ui::SetupPage</name>
    <message>
        <source>The site has no tiles yet. Lay them first.</source>
        <translation>场地还没有地板砖，请先铺设。</translation>
    </message>
    <message>
        <source>Choose the reader&apos;s port, or type its path.</source>
        <translation>选择读卡器的串口，或输入其路径。</translation>
    </message>
    <message>
        <source>Type the serial number of the tile.</source>
        <translation>请输入地板砖的序列号。</translation>
    </message>
    <message>
        <source>The site has no tile %1.</source>
        <translation>场地中没有地板砖 %1。</translation>
    </message>
    <message>
        <source>Registering stopped at tag %1 of tile %2.</source>
        <translation>登记停在地板砖 %2 的第 %1 个标签。</translation>
    </message>
    <message>
        <source>No tag of tile %1 is registered any more. Undo brings them back.</source>
        <translation>地板砖 %1 的标签登记已全部清除。撤销可恢复。</translation>
    </message>
    <message>
        <source>Hold the tags of the floor to a reader, one after the other, as the map lights them.</source>
        <translation>按照地图点亮的顺序，用读卡器逐个读取地面的标签。</translation>
    </message>
    <message>
        <source>Reader:</source>
        <translation>读卡器：</translation>
    </message>
    <message>
        <source>Types like a keyboard</source>
        <translation>像键盘一样输入</translation>
    </message>
    <message>
        <source>At a serial port</source>
        <translation>串口</translation>
    </message>
    <message>
        <source>Port:</source>
        <translation>串口：</translation>
    </message>
    <message>
        <source>The reader&apos;s port</source>
        <translation>读卡器的串口</translation>
    </message>
    <message>
        <source>Look for ports again</source>
        <translation>重新查找串口</translation>
    </message>
    <message>
        <source>Baud rate:</source>
        <translation>波特率：</translation>
    </message>
    <message>
        <source>%1 bit/s</source>
        <translation>%1 bit/s</translation>
    </message>
    <message>
        <source>It sends:</source>
        <translation>发送内容：</translation>
    </message>
    <message>
        <source>Hexadecimal lines</source>
        <translation>十六进制行</translation>
    </message>
    <message>
        <source>Decimal lines</source>
        <translation>十进制行</translation>
    </message>
    <message>
        <source>Decimal lines, bytes reversed</source>
        <translation>十进制行，字节倒序</translation>
    </message>
    <message>
        <source>Frames of an MFRC522 module</source>
        <translation>MFRC522 模块的帧</translation>
    </message>
    <message>
        <source>Order:</source>
        <translation>顺序：</translation>
    </message>
    <message>
        <source>Tile by tile along the floor</source>
        <translation>沿地面逐块地板砖</translation>
    </message>
    <message>
        <source>Tile by tile as listed, also not laid ones</source>
        <translation>按列表逐块，包括未铺设的</translation>
    </message>
    <message>
        <source>Row by row of tags</source>
        <translation>逐行标签</translation>
    </message>
    <message>
        <source>One tile alone</source>
        <translation>只登记一块地板砖</translation>
    </message>
    <message>
        <source>serial number</source>
        <translation>序列号</translation>
    </message>
    <message>
        <source>Serial number of the tile</source>
        <translation>地板砖的序列号</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清除</translation>
    </message>
    <message>
        <source>Forget which tags this tile has</source>
        <translation>忘记此地板砖有哪些标签</translation>
    </message>
    <message>
        <source>Also tags that are registered already</source>
        <translation>包括已登记的标签</translation>
    </message>
    <message>
        <source>Sounds</source>
        <translation>声音</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>Go on from there</source>
        <translation>从那里继续</translation>
    </message>
</context>
<context>
    <name>tessera::ui::SiteDialog</name>
    <message>
        <source>Change the site&apos;s properties</source>
        <translation>更改场地属性</translation>
    </message>
    <message>
        <source>Properties of the site</source>
        <translation>场地属性</translation>
    </message>
    <message>
        <source>&amp;General</source>
        <translation>常规(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Tags without a tile</source>
        <translation>无地砖的标签(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Name:</source>
        <translation>名称(&amp;N)：</translation>
    </message>
    <message>
        <source>&amp;Bearing of the y axis:</source>
        <translation>y 轴方位角(&amp;B)：</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Clockwise from north, as a compass shows it when held along the y axis. 0°: y points north.</source>
        <translation>从北方顺时针计，即指南针沿 y 轴放置时的读数。0° 表示 y 轴指向北。</translation>
    </message>
    <message>
        <source>Radio &amp;channel:</source>
        <translation>无线信道(&amp;C)：</translation>
    </message>
    <message>
        <source>&amp;Air rate:</source>
        <translation>空中速率(&amp;A)：</translation>
    </message>
    <message>
        <source>Baud rate of the &amp;module:</source>
        <translation>模块波特率(&amp;M)：</translation>
    </message>
    <message>
        <source>The vehicles and the radio module of this computer must be set to the same. Who is connected takes it over with the next connection.</source>
        <translation>车辆与本机的无线模块必须设置一致。已连接时，下次连接后生效。</translation>
    </message>
    <message>
        <source>%1 bit/s</source>
        <translation>%1 bit/s</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>确定</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source> (%1 MHz)</source>
        <translation>（%1 MHz）</translation>
    </message>
</context>
<context>
    <name>tessera::ui::StartPage</name>
    <message>
        <source>Tessera</source>
        <translation>Tessera</translation>
    </message>
    <message>
        <source>Watch and guide automated vehicles that find their way by RFID tags in a tile floor.</source>
        <translation>监控并引导在地板砖场地上靠 RFID 电子标签定位的自动化车辆。</translation>
    </message>
    <message>
        <source>&amp;Demo floor</source>
        <translation>演示场地(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;New site</source>
        <translation>新建场地(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>打开(&amp;O)…</translation>
    </message>
    <message>
        <source>Lay a floor of so many tiles, then draw routes and set up vehicles.</source>
        <translation>铺设指定块数的地板砖，然后绘制路径、设置车辆。</translation>
    </message>
    <message>
        <source>Open a site that was saved before (*.tessera.json).</source>
        <translation>打开已保存的场地 (*.tessera.json)。</translation>
    </message>
    <message>
        <source>A simulated floor with a vehicle to drive. Nothing to plug in.</source>
        <translation>带有一辆可驾驶车辆的仿真场地，无需连接任何设备。</translation>
    </message>
</context>
<context>
    <name>tessera::ui::StepPage</name>
    <message>
        <source>Co&amp;nnect…</source>
        <translation>连接(&amp;N)…</translation>
    </message>
    <message>
        <source>S&amp;kip this step for now</source>
        <translation>暂时跳过此步骤(&amp;K)</translation>
    </message>
</context>
<context>
    <name>tessera::ui::StopAllButton</name>
    <message>
        <source>Not connected: there is nobody to stop.</source>
        <translation>未连接：没有可停止的车辆。</translation>
    </message>
    <message>
        <source>Stop all</source>
        <translation>全部停止</translation>
    </message>
    <message>
        <source>Stops every vehicle at once. Nothing moves again without a new order.</source>
        <translation>立即停止所有车辆。没有新指令，车辆不会再移动。</translation>
    </message>
    <message>
        <source>Stops every vehicle at once. Nothing moves again without a new order. The key %1 does the same, from any window of the program.</source>
        <translation>立即停止所有车辆。没有新指令，车辆不会再移动。在程序的任何窗口中按 %1 键，效果相同。</translation>
    </message>
</context>
<context>
    <name>tessera::ui::SummaryPage</name>
    <message>
        <source>Firmware</source>
        <translation>固件</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>密钥</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>通信</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Readers</source>
        <translation>读卡器</translation>
    </message>
    <message>
        <source>Compass</source>
        <translation>罗盘</translation>
    </message>
    <message>
        <source>Drive by hand</source>
        <translation>手动驾驶</translation>
    </message>
    <message>
        <source>First drive</source>
        <translation>首次行驶</translation>
    </message>
    <message>
        <source>done</source>
        <translation>已完成</translation>
    </message>
    <message>
        <source>skipped</source>
        <translation>已跳过</translation>
    </message>
    <message>
        <source>not done</source>
        <translation>未完成</translation>
    </message>
    <message>
        <source>Summary</source>
        <translation>汇总</translation>
    </message>
    <message>
        <source>%1 stands in the site under the address %2.</source>
        <translation>%1 已加入场地，地址为 %2。</translation>
    </message>
    <message>
        <source>Save the site to keep the vehicle.</source>
        <translation>请保存场地以保留该车辆。</translation>
    </message>
    <message>
        <source>The vehicle is saved with the site.</source>
        <translation>该车辆已随场地保存。</translation>
    </message>
    <message>
        <source>Everything was tried.</source>
        <translation>所有项目均已测试。</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s) were left out. Open this wizard for the vehicle again to make up for it.</source>
        <translation>
            <numerusform>有 %n 个步骤被跳过。可再次为该车辆打开此向导补做。</numerusform>
        </translation>
    </message>
    <message>
        <source>Where exactly the readers sit and how large the wheels are, a drive along a figure over registered tags tells better than a ruler.</source>
        <translation>读卡器的确切位置和车轮的大小，在已登记的标签上沿图形行驶一次，比用尺子量更准确。</translation>
    </message>
    <message>
        <source>Finish, and calibrate readers and &amp;wheels…</source>
        <translation>完成并校准读卡器和车轮(&amp;W)…</translation>
    </message>
</context>
<context>
    <name>tessera::ui::TcpBox</name>
    <message>
        <source>Type the name or address of the serial device server.</source>
        <translation>请输入串口服务器的名称或地址。</translation>
    </message>
    <message>
        <source>“%1” is no name or address of a computer. Type it alone, such as 192.168.0.7, and the port beside it.</source>
        <translation>“%1”不是计算机的名称或地址。请只输入名称或地址，例如 192.168.0.7，端口填在旁边。</translation>
    </message>
    <message>
        <source>&amp;Host:</source>
        <translation>主机(&amp;H)：</translation>
    </message>
    <message>
        <source>e.g. 192.168.0.7</source>
        <translation>例如 192.168.0.7</translation>
    </message>
    <message>
        <source>P&amp;ort number:</source>
        <translation>端口号(&amp;O)：</translation>
    </message>
    <message>
        <source>For a radio module behind a serial device server that passes raw bytes over TCP. Its baud rate is set there. Such a server encrypts nothing: keep it in a network of its own.</source>
        <translation>用于接在串口服务器之后、通过 TCP 传输原始字节的无线模块。波特率在服务器上设置。此类服务器不加密：请将其置于独立的网络中。</translation>
    </message>
</context>
<context>
    <name>tessera::ui::ThirdParties</name>
    <message>
        <source>%1 (built with %2)</source>
        <translation>%1（编译时使用 %2）</translation>
    </message>
    <message>
        <source>charts</source>
        <translation>图表</translation>
    </message>
    <message>
        <source>public domain</source>
        <translation>公有领域</translation>
    </message>
    <message>
        <source>sites and journal</source>
        <translation>场地和事件</translation>
    </message>
    <message>
        <source>matrices</source>
        <translation>矩阵</translation>
    </message>
    <message>
        <source>site files</source>
        <translation>场地文件</translation>
    </message>
    <message>
        <source>results or errors</source>
        <translation>结果或错误</translation>
    </message>
    <message>
        <source>command lines</source>
        <translation>命令行</translation>
    </message>
    <message>
        <source>window, ports, database access</source>
        <translation>窗口、端口、数据库访问</translation>
    </message>
    <message>
        <source>areas of zones and tiles</source>
        <translation>区域和地砖的面积</translation>
    </message>
</context>
<context>
    <name>tessera::ui::TileCheckPanel</name>
    <message>
        <source>Press Start, then drive a vehicle along the rows of tiles. Each tag that it reads tells whether its tile lies where the site says.</source>
        <translation>按“开始”，然后让车辆沿各排地板砖行驶。读到的每个标签都能说明其地板砖是否与场地一致。</translation>
    </message>
    <message>
        <source>Connect to the vehicles: none is supervised yet.</source>
        <translation>请连接车辆：目前没有受监控的车辆。</translation>
    </message>
    <message>
        <source>Drive a vehicle along the rows of tiles.</source>
        <translation>让车辆沿各排地板砖行驶。</translation>
    </message>
    <message>
        <source>Every tile lies where the site says.</source>
        <translation>所有地板砖都与场地一致。</translation>
    </message>
    <message>
        <source>So far every tile lies where the site says. Drive on along the rows.</source>
        <translation>目前所有地板砖都与场地一致。请继续沿各排行驶。</translation>
    </message>
    <message>
        <source>So far every tile lies where the site says.</source>
        <translation>目前所有地板砖都与场地一致。</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>Confirmed: %1 of %2. Seen: %3. Lies otherwise: %4. Not yet driven over: %5.</source>
        <translation>已确认：%1 / %2。已见：%3。不一致：%4。尚未驶过：%5。</translation>
    </message>
    <message>
        <source>Drive-over check</source>
        <translation>行驶检查</translation>
    </message>
    <message>
        <source>Begin anew</source>
        <translation>重新开始</translation>
    </message>
    <message>
        <source>Forget what was read so far</source>
        <translation>忘记已读的内容</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Correct the site</source>
        <translation>更正场地</translation>
    </message>
    <message>
        <source>The site gets these tiles as they lie on the floor; it can be undone</source>
        <translation>按地面实际情况修改场地；可以撤销</translation>
    </message>
    <message>
        <source>Checked tiles</source>
        <translation>已检查的地板砖</translation>
    </message>
    <message>
        <source>The tag that was read is registered there; it can be undone</source>
        <translation>将读到的标签登记在该处；可以撤销</translation>
    </message>
    <message>
        <source>Have a look at the place: no edit of the site mends this.</source>
        <translation>请查看该处：编辑场地无法修正此问题。</translation>
    </message>
    <message>
        <source>Show the place on the floor (Enter)</source>
        <translation>在地面上显示该处（Enter）</translation>
    </message>
    <message>
        <source>Tiles and tags that are otherwise than the site says</source>
        <translation>与场地不符的地板砖和标签</translation>
    </message>
    <message>
        <source>No tiles are laid yet. Lay them with Lay tiles in the tool bar, and register their tags; a drive over them then checks both.</source>
        <translation>尚未铺设地板砖。请用工具栏中的“铺设地板砖”铺设并登记其标签；随后驾车驶过即可核对两者。</translation>
    </message>
</context>
<context>
    <name>tessera::ui::TilePanel</name>
    <message>
        <source>%1, turned by %2°</source>
        <translation>%1，旋转 %2°</translation>
    </message>
    <message>
        <source>No tile is laid yet: drag over the floor.</source>
        <translation>尚未铺设地板砖：请在地面上拖动。</translation>
    </message>
    <message numerus="yes">
        <source>%n tile(s) laid, none of them chosen.</source>
        <translation>
            <numerusform>已铺设 %n 块地板砖，未选择任何一块。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n tile(s) chosen.</source>
        <translation>
            <numerusform>已选 %n 块地板砖。</numerusform>
        </translation>
    </message>
    <message>
        <source>Type: %1.</source>
        <translation>规格：%1。</translation>
    </message>
    <message numerus="yes">
        <source>%n type(s).</source>
        <translation>
            <numerusform>%n 种规格。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n tag(s) registered.</source>
        <translation>
            <numerusform>已登记 %n 个电子标签。</numerusform>
        </translation>
    </message>
    <message>
        <source>The chosen tile:</source>
        <translation>所选地板砖：</translation>
    </message>
    <message>
        <source>%1 of %2 registered</source>
        <translation>%2 个中已登记 %1 个</translation>
    </message>
    <message>
        <source>Tiles are laid by their type: size, pitch and pattern of the tags. This site has no tile type yet.</source>
        <translation>地板砖按规格铺设：尺寸、标签间距和图案。此场地还没有地板规格。</translation>
    </message>
    <message>
        <source>Make a tile type…</source>
        <translation>创建地板规格…</translation>
    </message>
    <message>
        <source>Lay tiles</source>
        <translation>铺设地板砖</translation>
    </message>
    <message>
        <source>Lay tiles by dragging over the floor (L)</source>
        <translation>在地面上拖动以铺设地板砖（L）</translation>
    </message>
    <message>
        <source>Choose tiles</source>
        <translation>选择地板砖</translation>
    </message>
    <message>
        <source>Choose and move tiles (C)</source>
        <translation>选择和移动地板砖（C）</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Turn what is chosen, else what is laid next (R)</source>
        <translation>旋转所选的砖；未选择时旋转接下来铺设的砖（R）</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>再制一份</translation>
    </message>
    <message>
        <source>Lay the chosen tiles again beside them (Ctrl+D)</source>
        <translation>在旁边再铺一份所选的砖（Ctrl+D）</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Delete the chosen tiles (Del)</source>
        <translation>删除所选地板砖（Del）</translation>
    </message>
    <message>
        <source>Align the chosen tiles</source>
        <translation>对齐所选地板砖</translation>
    </message>
    <message>
        <source>Left edges</source>
        <translation>左边缘</translation>
    </message>
    <message>
        <source>Right edges</source>
        <translation>右边缘</translation>
    </message>
    <message>
        <source>Upper edges</source>
        <translation>上边缘</translation>
    </message>
    <message>
        <source>Lower edges</source>
        <translation>下边缘</translation>
    </message>
    <message>
        <source>To the neighbours</source>
        <translation>与相邻的砖</translation>
    </message>
    <message>
        <source>Tile type</source>
        <translation>地板规格</translation>
    </message>
    <message>
        <source>Tile types…</source>
        <translation>地板规格…</translation>
    </message>
    <message>
        <source>Serials begin with</source>
        <translation>序列号前缀</translation>
    </message>
    <message>
        <source>Digits</source>
        <translation>位数</translation>
    </message>
    <message>
        <source>Numbers from</source>
        <translation>起始号码</translation>
    </message>
    <message>
        <source>Next tile</source>
        <translation>下一块砖</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>序列号</translation>
    </message>
    <message>
        <source>Left edge at x</source>
        <translation>左边缘 x</translation>
    </message>
    <message>
        <source>Lower edge at y</source>
        <translation>下边缘 y</translation>
    </message>
    <message>
        <source> cm</source>
        <translation> cm</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>电子标签</translation>
    </message>
</context>
<context>
    <name>tessera::ui::TileTypesDialog</name>
    <message>
        <source>Change the types</source>
        <translation>修改规格</translation>
    </message>
    <message>
        <source>Go back</source>
        <translation>返回</translation>
    </message>
    <message numerus="yes">
        <source>%n tile(s) are of this type: delete them first.</source>
        <translation>
            <numerusform>有 %n 块地板砖属于此规格：请先删除它们。</numerusform>
        </translation>
    </message>
    <message>
        <source>There are two tile types “%1”.</source>
        <translation>有两种地板规格名为“%1”。</translation>
    </message>
    <message numerus="yes">
        <source>%n registered tag(s) lie where the changed types have none: their numbers would be dropped from the site.</source>
        <translation>
            <numerusform>有 %n 个已登记的电子标签位于修改后的规格没有标签的位置：其号码将从场地中去除。</numerusform>
        </translation>
    </message>
    <message>
        <source>Change tile types</source>
        <translation>修改地板规格</translation>
    </message>
    <message>
        <source>every place</source>
        <translation>每个位置</translation>
    </message>
    <message>
        <source>every second place</source>
        <translation>隔一个位置</translation>
    </message>
    <message>
        <source>%1 × %2 cm, a tag each %3 cm, %4</source>
        <translation>%1 × %2 cm，每 %3 cm 一个标签，%4</translation>
    </message>
    <message>
        <source>Tile types</source>
        <translation>地板规格</translation>
    </message>
    <message>
        <source>Add a tile type</source>
        <translation>添加地板规格</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>再制一份</translation>
    </message>
    <message>
        <source>Make another type of the same numbers</source>
        <translation>按相同数值再建一种规格</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Delete the type</source>
        <translation>删除此规格</translation>
    </message>
    <message>
        <source>There is no tile type yet. Add one with + : the usual sizes are ready made.</source>
        <translation>还没有地板规格。用 + 添加：常用尺寸已备好。</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>确定</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>To the right the places go on evenly, %1 cm over the seam.</source>
        <translation>向右，位置跨接缝间距均匀，为 %1 cm。</translation>
    </message>
    <message>
        <source>To the right they come closer: %1 cm over the seam instead of %2 cm.</source>
        <translation>向右，跨接缝间距变密：%1 cm，而非 %2 cm。</translation>
    </message>
    <message>
        <source>To the right they lie wider: %1 cm over the seam instead of %2 cm.</source>
        <translation>向右，跨接缝间距变疏：%1 cm，而非 %2 cm。</translation>
    </message>
    <message>
        <source>Above they go on evenly, %1 cm over the seam.</source>
        <translation>向上，跨接缝间距均匀，为 %1 cm。</translation>
    </message>
    <message>
        <source>Above they come closer: %1 cm over the seam instead of %2 cm.</source>
        <translation>向上，跨接缝间距变密：%1 cm，而非 %2 cm。</translation>
    </message>
    <message>
        <source>Above they lie wider: %1 cm over the seam instead of %2 cm.</source>
        <translation>向上，跨接缝间距变疏：%1 cm，而非 %2 cm。</translation>
    </message>
    <message>
        <source>Red: tags meet at the seam, %1 cm apart, closer than within the tile.</source>
        <translation>红色：标签在接缝处相遇，相距 %1 cm，比砖内更近。</translation>
    </message>
    <message>
        <source>A new type: no tile is of it yet.</source>
        <translation>新规格：尚无地板砖属于它。</translation>
    </message>
    <message>
        <source>No tile is of this type.</source>
        <translation>没有地板砖属于此规格。</translation>
    </message>
    <message numerus="yes">
        <source>%n tile(s) are of this type,</source>
        <translation>
            <numerusform>有 %n 块地板砖属于此规格，</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n tag(s) on them are registered.</source>
        <translation>
            <numerusform>其上已登记 %n 个电子标签。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of their numbers would be dropped.</source>
        <translation>
            <numerusform>其中 %n 个号码将被去除。</numerusform>
        </translation>
    </message>
    <message>
        <source>All their numbers stay.</source>
        <translation>所有号码保留。</translation>
    </message>
</context>
<context>
    <name>tessera::ui::TileWatch</name>
    <message>
        <source>Correct how %1 lies</source>
        <translation>更正 %1 的铺设</translation>
    </message>
    <message>
        <source>Register tag %1 of tile %2</source>
        <translation>登记地板砖 %2 的标签 %1</translation>
    </message>
</context>
<context>
    <name>tessera::ui::TimeChart</name>
    <message>
        <source>Cross-track error and speed</source>
        <translation>横向偏差和速度</translation>
    </message>
    <message>
        <source>Cross-track error (cm)</source>
        <translation>横向偏差 (cm)</translation>
    </message>
    <message>
        <source>Speed (m/s)</source>
        <translation>速度 (m/s)</translation>
    </message>
    <message>
        <source>Time (min), 0 is the newest</source>
        <translation>时间（分），0 为最新</translation>
    </message>
    <message>
        <source>Time (s), 0 is the newest</source>
        <translation>时间（秒），0 为最新</translation>
    </message>
    <message>
        <source>Commanded</source>
        <translation>指令值</translation>
    </message>
    <message>
        <source>Reported</source>
        <translation>上报值</translation>
    </message>
    <message>
        <source>± %1 cm</source>
        <translation>± %1 cm</translation>
    </message>
    <message>
        <source>%1 s before the newest
Cross-track error %2 cm
Speed %3 m/s, commanded %4 m/s</source>
        <translation>最新数据之前 %1 秒
横向偏差 %2 cm
速度 %3 m/s，指令 %4 m/s</translation>
    </message>
</context>
<context>
    <name>tessera::ui::TrackChart</name>
    <message>
        <source>Track against route</source>
        <translation>实际轨迹与路径对比</translation>
    </message>
    <message>
        <source>x (m)</source>
        <translation>x (m)</translation>
    </message>
    <message>
        <source>y (m)</source>
        <translation>y (m)</translation>
    </message>
    <message>
        <source>Track</source>
        <translation>实际轨迹</translation>
    </message>
    <message>
        <source>No route</source>
        <translation>无路径</translation>
    </message>
    <message>
        <source>Route %1</source>
        <translation>路径 %1</translation>
    </message>
    <message>
        <source>x %1 m, y %2 m</source>
        <translation>x %1 m，y %2 m</translation>
    </message>
</context>
<context>
    <name>tessera::ui::TypeForm</name>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>间距</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>图案</translation>
    </message>
    <message>
        <source>Places in a row</source>
        <translation>每行位置数</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>行数</translation>
    </message>
    <message>
        <source>First place from the left edge</source>
        <translation>首个位置距左边缘</translation>
    </message>
    <message>
        <source>First place from the lower edge</source>
        <translation>首个位置距下边缘</translation>
    </message>
    <message>
        <source> cm</source>
        <translation> cm</translation>
    </message>
    <message>
        <source>From one place to the next, along rows and columns</source>
        <translation>沿行和列，相邻两个位置之间的距离</translation>
    </message>
    <message>
        <source>A tag at every place</source>
        <translation>每个位置一个标签</translation>
    </message>
    <message>
        <source>A tag at every second place</source>
        <translation>隔一个位置一个标签</translation>
    </message>
    <message>
        <source>As clicked in the drawing</source>
        <translation>按图中点击</translation>
    </message>
    <message>
        <source>Starts with a gap</source>
        <translation>以空位开始</translation>
    </message>
    <message>
        <source>The first place at the lower left is without a tag</source>
        <translation>左下角的首个位置没有标签</translation>
    </message>
    <message>
        <source>Fit the places to the tile</source>
        <translation>使位置适合地板砖</translation>
    </message>
    <message>
        <source>As many places as the pitch lets on the tile, in its middle</source>
        <translation>按间距在砖上居中布置尽可能多的位置</translation>
    </message>
</context>
<context>
    <name>tessera::ui::TypePage</name>
    <message>
        <source>A vehicle needs at least one reader.</source>
        <translation>车辆至少需要一个读卡器。</translation>
    </message>
    <message>
        <source>The wheels stand wider than the vehicle. Check track and width.</source>
        <translation>两轮间距大于车宽。请检查轮距和宽度。</translation>
    </message>
    <message>
        <source>The readers must be listed from the vehicle&apos;s left to its right.</source>
        <translation>读卡器必须按从车辆左侧到右侧的顺序列出。</translation>
    </message>
    <message>
        <source>What kind of vehicle is it?</source>
        <translation>车辆属于哪种车型？</translation>
    </message>
    <message>
        <source>Choose the type that comes closest and correct its measures. Lengths count from the middle between the driven wheels.</source>
        <translation>选择最接近的车型，并修正其尺寸。长度从驱动轮中点算起。</translation>
    </message>
    <message>
        <source>&amp;Type:</source>
        <translation>车型(&amp;T)：</translation>
    </message>
    <message>
        <source>as it is</source>
        <translation>保持现状</translation>
    </message>
    <message>
        <source>To the &amp;front:</source>
        <translation>到前端(&amp;F)：</translation>
    </message>
    <message>
        <source>To the &amp;rear:</source>
        <translation>到后端(&amp;R)：</translation>
    </message>
    <message>
        <source>&amp;Width:</source>
        <translation>宽度(&amp;W)：</translation>
    </message>
    <message>
        <source>Tr&amp;ack (wheel to wheel):</source>
        <translation>轮距（两轮之间）(&amp;A)：</translation>
    </message>
    <message>
        <source>Wheel &amp;diameter:</source>
        <translation>车轮直径(&amp;D)：</translation>
    </message>
    <message>
        <source>&amp;Highest speed:</source>
        <translation>最高速度(&amp;H)：</translation>
    </message>
    <message>
        <source>Highest t&amp;urn rate:</source>
        <translation>最高转向角速度(&amp;U)：</translation>
    </message>
    <message>
        <source>Readers see &amp;tags within:</source>
        <translation>读卡器读取标签的范围(&amp;T)：</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source> m/s</source>
        <translation> m/s</translation>
    </message>
    <message>
        <source> rad/s</source>
        <translation> rad/s</translation>
    </message>
    <message>
        <source>Readers, from &amp;left to right:</source>
        <translation>读卡器，从左到右(&amp;L)：</translation>
    </message>
    <message>
        <source>Drawing of the vehicle</source>
        <translation>车辆示意图</translation>
    </message>
    <message>
        <source>The vehicle from above, nose up: outline, wheels, and the discs in which readers see tags</source>
        <translation>车辆俯视图，车头朝上：外形、车轮，以及读卡器能读到标签的圆形范围</translation>
    </message>
    <message>
        <source>Cut c&amp;orners by:</source>
        <translation>切过转角(&amp;O)：</translation>
    </message>
    <message>
        <source>0 m: turns on the spot</source>
        <translation>0 m：原地转向</translation>
    </message>
    <message>
        <source>How far it may leave a route&apos;s vertex to round the corner without stopping. 0: it drives to the vertex and turns on the spot, as it does all the same where the way turns nearly back or there is no room for an arc.</source>
        <translation>为不停车地绕过转角，车辆最多可离开路径顶点多远。0：驶到顶点并原地转向；若路径几乎折返，或没有容纳圆弧的空间，车辆也会原地转向。</translation>
    </message>
</context>
<context>
    <name>tessera::ui::TypePicture</name>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>Drawing of the tile type</source>
        <translation>地板规格的图形</translation>
    </message>
    <message>
        <source>Click a place to put a tag there or to take it away; with the keys: arrows and space bar.</source>
        <translation>单击某个位置可放上或取走标签；用键盘：方向键和空格键。</translation>
    </message>
</context>
<context>
    <name>tessera::ui::VehicleDraft</name>
    <message>
        <source>Small: 0.40 m × 0.36 m, 3 readers</source>
        <translation>小型：0.40 m × 0.36 m，3 个读卡器</translation>
    </message>
    <message>
        <source>Medium: 0.70 m × 0.50 m, 4 readers</source>
        <translation>中型：0.70 m × 0.50 m，4 个读卡器</translation>
    </message>
    <message>
        <source>Large: 1.10 m × 0.80 m, 5 readers</source>
        <translation>大型：1.10 m × 0.80 m，5 个读卡器</translation>
    </message>
    <message>
        <source>Like %1</source>
        <translation>同 %1</translation>
    </message>
    <message>
        <source>AGV %1</source>
        <translation>AGV %1</translation>
    </message>
    <message>
        <source>Give the vehicle a name.</source>
        <translation>请为车辆命名。</translation>
    </message>
    <message>
        <source>An address is a number from 1 to 254.</source>
        <translation>地址为 1 到 254 的数字。</translation>
    </message>
    <message>
        <source>%1 has the address %2 already. Choose another one.</source>
        <translation>%1 已使用地址 %2。请选择其他地址。</translation>
    </message>
    <message>
        <source>There is a vehicle named %1 already. Choose another name.</source>
        <translation>已有名为 %1 的车辆。请选择其他名称。</translation>
    </message>
</context>
<context>
    <name>tessera::ui::VehicleModel</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 m/s</source>
        <translation>%1 m/s</translation>
    </message>
    <message>
        <source>%1 V</source>
        <translation>%1 V</translation>
    </message>
    <message>
        <source>%1 % lost</source>
        <translation>丢失 %1 %</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>± %1 cm</source>
        <translation>± %1 cm</translation>
    </message>
    <message>
        <source>%1, address %2</source>
        <translation>%1，地址 %2</translation>
    </message>
    <message>
        <source>%1, address %2, firmware %3</source>
        <translation>%1，地址 %2，固件 %3</translation>
    </message>
    <message>
        <source>The battery is low. Charge it soon.</source>
        <translation>电池电量低，请尽快充电。</translation>
    </message>
    <message>
        <source>Voltage of the battery.</source>
        <translation>电池电压。</translation>
    </message>
    <message>
        <source>No answer has come yet.</source>
        <translation>尚未收到应答。</translation>
    </message>
    <message>
        <source>%1 % of the last calls stayed without an answer. There and back takes %2 ms. Restarts seen: %3.</source>
        <translation>最近的呼叫中有 %1 % 未得到应答。往返时间为 %2 ms。检测到重启次数：%3。</translation>
    </message>
    <message>
        <source>Time since its last answer.</source>
        <translation>距上次应答的时间。</translation>
    </message>
    <message>
        <source>Its place is not known. Put it where it reads tags.</source>
        <translation>车辆位置未知。请将其放到能读到标签的地方。</translation>
    </message>
    <message>
        <source>Where it is, is known to this much with a probability of 95 %.</source>
        <translation>以 95 % 的概率，车辆位置的误差在此范围内。</translation>
    </message>
    <message>
        <source>It has no route now.</source>
        <translation>车辆当前没有路径。</translation>
    </message>
    <message>
        <source>%1 m of %2 m</source>
        <translation>%1 m / %2 m</translation>
    </message>
    <message>
        <source>Vehicle</source>
        <translation>车辆</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Route</source>
        <translation>路径</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Battery</source>
        <translation>电池</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>链路</translation>
    </message>
    <message>
        <source>Data age</source>
        <translation>数据时效</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>位置</translation>
    </message>
</context>
<context>
    <name>tessera::ui::VehicleTable</name>
    <message>
        <source>The order was not taken: there is no connection to the vehicles.</source>
        <translation>指令未被接受：未连接到车辆。</translation>
    </message>
    <message>
        <source>&amp;Follow on the floor</source>
        <translation>在场地上跟随(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>暂停(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Resume</source>
        <translation>继续(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>停止(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Clear faults</source>
        <translation>清除故障(&amp;C)</translation>
    </message>
    <message>
        <source>Vehicles</source>
        <translation>车辆</translation>
    </message>
    <message>
        <source>This site has no vehicle yet. Set one up: the wizard leads through it.</source>
        <translation>此场地还没有车辆。请按向导设置一辆。</translation>
    </message>
    <message>
        <source>%1 % lost</source>
        <translation>丢失 %1 %</translation>
    </message>
    <message>
        <source>Set &amp;up a vehicle…</source>
        <translation>设置车辆(&amp;U)…</translation>
    </message>
    <message>
        <source>Co&amp;nnect…</source>
        <translation>连接(&amp;N)…</translation>
    </message>
</context>
<context>
    <name>tessera::ui::VertexModel</name>
    <message>
        <source>Length of the leg from the vertex before</source>
        <translation>从上一个顶点起的路段长度</translation>
    </message>
    <message>
        <source>Place in the site, in metres</source>
        <translation>在场地中的位置，单位为 m</translation>
    </message>
    <message>
        <source>x (m)</source>
        <translation>x (m)</translation>
    </message>
    <message>
        <source>y (m)</source>
        <translation>y (m)</translation>
    </message>
    <message>
        <source>Leg (m)</source>
        <translation>路段 (m)</translation>
    </message>
    <message>
        <source>Highest speed on the leg from the vertex before; empty: as ordered</source>
        <translation>从上一顶点到此的路段的最高速度；留空：按下达的速度</translation>
    </message>
    <message>
        <source>Max m/s</source>
        <translation>最高 m/s</translation>
    </message>
</context>
<context>
    <name>tessera::ui::ZonePanel</name>
    <message>
        <source>&amp;New zone</source>
        <translation>新建区域(&amp;N)</translation>
    </message>
    <message>
        <source>Draw another zone of the chosen one&apos;s kind on the floor; the arrow: of another kind</source>
        <translation>在地面上再画一个与所选区域同类的区域；箭头：其他类型</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>重命名(&amp;N)</translation>
    </message>
    <message>
        <source>Rename the zone</source>
        <translation>重命名区域</translation>
    </message>
    <message>
        <source>D&amp;uplicate</source>
        <translation>复制(&amp;U)</translation>
    </message>
    <message>
        <source>Make another zone of the same shape</source>
        <translation>制作一个形状相同的区域</translation>
    </message>
    <message>
        <source>&amp;Delete zone</source>
        <translation>删除区域(&amp;D)</translation>
    </message>
    <message>
        <source>Delete the zone</source>
        <translation>删除区域</translation>
    </message>
    <message>
        <source>&amp;Insert corner</source>
        <translation>插入角点(&amp;I)</translation>
    </message>
    <message>
        <source>Insert a corner after the chosen one</source>
        <translation>在所选角点之后插入角点</translation>
    </message>
    <message>
        <source>Delete &amp;corner</source>
        <translation>删除角点(&amp;C)</translation>
    </message>
    <message>
        <source>Delete the chosen corner</source>
        <translation>删除所选角点</translation>
    </message>
    <message>
        <source>This site has no zone yet. A running zone says where vehicles may drive, other kinds restrict them: drag a rectangle on the floor, or click the corners.</source>
        <translation>此场地还没有区域。行驶区域规定车辆可以在哪里行驶，其他类型对其加以限制：在地面上拖出矩形，或点击各个角点。</translation>
    </message>
    <message>
        <source>Draw a &amp;zone</source>
        <translation>绘制区域(&amp;Z)</translation>
    </message>
    <message>
        <source>Zones</source>
        <translation>区域</translation>
    </message>
    <message>
        <source>Corners of the zone</source>
        <translation>区域的角点</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Highest speed</source>
        <translation>最高速度</translation>
    </message>
    <message>
        <source> m/s</source>
        <translation> m/s</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Counter-clockwise from x: 0° leads to the right, 90° upwards</source>
        <translation>从 x 轴逆时针：0° 向右，90° 向上</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>面积</translation>
    </message>
</context>
<context>
    <name>tessera::ui::ZoneTool</name>
    <message>
        <source>Release where the opposite corner is to be. Alt: no snapping. Esc: drop it.</source>
        <translation>在对角处松开。Alt：不吸附。Esc：放弃。</translation>
    </message>
    <message>
        <source>Shift: in steps of 45°. Alt: no snapping. Esc: leave it where it was.</source>
        <translation>Shift：45° 步进。Alt：不吸附。Esc：保持原位。</translation>
    </message>
    <message>
        <source>Drag a rectangle, or click the zone&apos;s corners one by one. Esc: stop drawing.</source>
        <translation>拖出矩形，或依次点击区域的角点。Esc：停止绘制。</translation>
    </message>
    <message>
        <source>Click the next corner. First corner, double-click or Enter: finish. Backspace: one back. Shift: 45°. Alt: no snapping.</source>
        <translation>点击下一个角点。第一个角点、双击或 Enter：完成。Backspace：退回一个。Shift：45°。Alt：不吸附。</translation>
    </message>
    <message>
        <source>Arrow keys move the corner by 1 cm, with Shift by 10 cm. Del removes it.</source>
        <translation>方向键移动角点 1 cm，加 Shift 为 10 cm。Del 删除。</translation>
    </message>
    <message>
        <source>Drag a corner, a circle on an edge, or the inside. Click again: the zone below. Del removes the zone.</source>
        <translation>拖动角点、边上的圆圈或内部。再次点击：下面的区域。Del 删除区域。</translation>
    </message>
    <message>
        <source>Click a zone to change it, or draw a new one.</source>
        <translation>点击区域进行修改，或绘制新的区域。</translation>
    </message>
    <message>
        <source>&amp;Finish zone</source>
        <translation>完成区域(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Remove last corner</source>
        <translation>去掉最后一个角点(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Drop zone</source>
        <translation>放弃区域(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Kind</source>
        <translation>类型(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Delete corner</source>
        <translation>删除角点(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Insert corner here</source>
        <translation>在此插入角点(&amp;I)</translation>
    </message>
    <message>
        <source>D&amp;uplicate zone</source>
        <translation>复制区域(&amp;U)</translation>
    </message>
    <message>
        <source>De&amp;lete zone</source>
        <translation>删除区域(&amp;L)</translation>
    </message>
    <message>
        <source>Draw &amp;new zone from here</source>
        <translation>从此处绘制新区域(&amp;N)</translation>
    </message>
    <message>
        <source>Click: finish the zone</source>
        <translation>点击：完成区域</translation>
    </message>
    <message>
        <source>%1 × %2 m</source>
        <comment>width and height</comment>
        <translation>%1 × %2 m</translation>
    </message>
</context>
</TS>
